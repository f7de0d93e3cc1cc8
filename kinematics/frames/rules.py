"""The rules for a student's frames, one by one.

A frame obeys a convention if three things hold: its z lies along the axis that the convention gives it, its
origin stands on that axis, and its x crosses the neighbouring axis at right angles. What else the lecture
documents ask for makes the table simpler, not truer: see `advice`.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from kinematics.frames.axes import AxisLine, PartialPose
from kinematics.frames.normals import Relation, common_normal
from kinematics.se3 import Vector, along, cross, dot, foot, norm, subtract
from kinematics.table import Convention

ANGLE_TOLERANCE = 1e-6  # A student's direction is right if it is this near [rad].

LENGTH_TOLERANCE = 1e-6  # A student's point is right if it is this near, as a part of the robot's size.


class FramePart(StrEnum):
    """The part of a frame that a rule speaks of."""

    Z = "z"
    ORIGIN = "origin"
    X = "x"


class Severity(StrEnum):
    """BROKEN: the convention cannot hold the frame. ADVICE: it can, and a simpler table is to be had."""

    BROKEN = "broken"
    ADVICE = "advice"


class RuleCode(StrEnum):
    """The rules by name; from Z_REVERSED on they are advice."""

    Z_NOT_ALONG_AXIS = "z_not_along_axis"
    ORIGIN_NOT_ON_AXIS = "origin_not_on_axis"
    ORIGIN_NOT_ON_COMMON_NORMAL = "origin_not_on_common_normal"
    ORIGIN_NOT_AT_INTERSECTION = "origin_not_at_intersection"
    X_NOT_ACROSS_Z = "x_not_across_z"
    X_NOT_ALONG_COMMON_NORMAL = "x_not_along_common_normal"
    X_NOT_ACROSS_BOTH_AXES = "x_not_across_both_axes"
    FIRST_X_MISSES_AXIS = "first_x_misses_axis"
    LAST_X_MISSES_AXIS = "last_x_misses_axis"
    Z_REVERSED = "z_reversed"
    X_REVERSED = "x_reversed"
    OFFSET_COULD_VANISH = "offset_could_vanish"
    ANGLE_COULD_VANISH = "angle_could_vanish"
    FIRST_NOT_SIMPLEST = "first_not_simplest"
    LAST_NOT_SIMPLEST = "last_not_simplest"


BINDING = tuple(RuleCode)[: tuple(RuleCode).index(RuleCode.Z_REVERSED)]
"""The rules that are no advice: a frame that breaks one is wrong."""


@dataclass(frozen=True, kw_only=True, slots=True)
class FrameFinding:
    """One rule that a frame breaks, or one piece of advice.

    Attributes:
        part: the part of the frame.
        severity: whether the convention is broken.
        params: the numbers, counted from 1, of the axes or the joint that the rule speaks of.
    """

    rule: RuleCode
    part: FramePart
    severity: Severity
    params: Mapping[str, int] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True, slots=True)
class FramePlace:
    """What a frame is judged by.

    Attributes:
        index: number of the frame, 0 … N.
        own: number of the axis along which z lies, counted from 1; None where z is free.
        own_line: that axis.
        partner: number of the axis that x crosses; None where there is none.
        partner_direction: direction of that axis.
        partner_line: that axis; None while the line of a prismatic joint has not been drawn.
        size: the robot's size.
    """

    index: int
    convention: Convention
    own: int | None
    own_line: AxisLine | None
    partner: int | None
    partner_direction: Vector | None
    partner_line: AxisLine | None
    size: float

    @property
    def pair(self) -> dict[str, int]:
        """The two axes that x belongs to, the earlier first."""
        numbers = sorted(number for number in (self.own, self.partner) if number is not None)
        return {"first": numbers[0], "second": numbers[-1]}


def broken_rules(frame: PartialPose, place: FramePlace) -> list[FrameFinding]:
    """Return the rules of the convention that a frame breaks, as far as it has been chosen.

    Source: seed 000 §3.2.4; seed 002 steps 2 to 7; seed 003 rules 2 and 3; seed 004 cases 1 to 3.
    """
    findings: list[FrameFinding] = []
    own = place.own_line
    if own is not None and place.own is not None:
        if frame.z is not None and not parallel(frame.z, own.direction):
            findings.append(broken(RuleCode.Z_NOT_ALONG_AXIS, FramePart.Z, axis=place.own))
        if frame.origin is not None and not _on(frame.origin, own, place.size):
            findings.append(broken(RuleCode.ORIGIN_NOT_ON_AXIS, FramePart.ORIGIN, axis=place.own))
    if frame.x is not None:
        if frame.z is not None and abs(dot(frame.x, frame.z)) > ANGLE_TOLERANCE:
            findings.append(broken(RuleCode.X_NOT_ACROSS_Z, FramePart.X))
        findings.extend(_crossing_rules(frame.x, frame.origin, place))
    return findings


def _crossing_rules(x: Vector, origin: Vector | None, place: FramePlace) -> list[FrameFinding]:
    """Whether x crosses the neighbouring axis at right angles."""
    if place.partner is None or place.partner_direction is None:
        return []
    across = abs(dot(x, place.partner_direction)) <= ANGLE_TOLERANCE
    partner = place.partner_line
    if across and (partner is None or origin is None or _meets(origin, x, partner, place.size)):
        return []
    if place.own_line is None:
        code = RuleCode.FIRST_X_MISSES_AXIS if place.index == 0 else RuleCode.LAST_X_MISSES_AXIS
        return [broken(code, FramePart.X, axis=place.partner)]
    if partner is None:
        return [broken(RuleCode.X_NOT_ACROSS_BOTH_AXES, FramePart.X, **place.pair)]
    relation = common_normal(place.own_line, partner, place.size).relation
    if relation is Relation.INTERSECTING:
        if across:
            return [broken(RuleCode.ORIGIN_NOT_AT_INTERSECTION, FramePart.ORIGIN, **place.pair)]
        return [broken(RuleCode.X_NOT_ACROSS_BOTH_AXES, FramePart.X, **place.pair)]
    if across and not relation.slides:
        return [broken(RuleCode.ORIGIN_NOT_ON_COMMON_NORMAL, FramePart.ORIGIN, **place.pair)]
    return [broken(RuleCode.X_NOT_ALONG_COMMON_NORMAL, FramePart.X, **place.pair)]


def parallel(u: Vector, v: Vector) -> bool:
    """Return whether two unit directions are the same or opposite, as far as a student can tell."""
    return norm(cross(u, v)) <= ANGLE_TOLERANCE


def broken(rule: RuleCode, part: FramePart, **params: int) -> FrameFinding:
    """Return a finding that breaks the convention."""
    return FrameFinding(rule=rule, part=part, severity=Severity.BROKEN, params=params)


def _on(point: Vector, line: AxisLine, size: float) -> bool:
    return norm(subtract(point, foot(point, line.point, line.direction))) <= LENGTH_TOLERANCE * size


def _meets(origin: Vector, x: Vector, line: AxisLine, size: float) -> bool:
    point = foot(origin, line.point, line.direction)
    on_x = along(origin, dot(subtract(point, origin), x), x)
    return norm(subtract(point, on_x)) <= LENGTH_TOLERANCE * size
