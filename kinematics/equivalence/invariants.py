"""Facts of a chain that no choice of frames changes: cheap, and enough to see that an edit cannot help.

Between neighbouring axes the angle and the distance (sliders between them disregarded); along a run of
parallel axes the distance between the common normals before and after; about a slider the angle between its
neighbours. All are taken without their signs, so they are necessary for equivalence, not sufficient.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import lru_cache

from kinematics.chain import Axis, Chain
from kinematics.equivalence.groups import outside
from kinematics.equivalence.policy import BaseRule, Policy, ToolRule
from kinematics.equivalence.reference import Reference
from kinematics.se3 import (
    ORIGIN,
    Z_AXIS,
    Vector,
    angle_between,
    cross,
    dot,
    norm,
    plus,
    position,
    rejection,
    scale,
    subtract,
    unit,
    z_axis,
)

# A sine, and below: the arithmetic leaves 1e-16, and what is nearer to parallel has its normal hundreds of
# thousands of robots away.
PARALLEL = 1e-7
# In units of the tolerance of the end frame: the rounded entries of six joints may all add up in one
# invariant.
SLACK = 6.0
# A share of the robot, and [rad]: the arithmetic leaves 1e-9 of it where axes are steep enough to be
# measured at all.
FLOOR = 1e-7
# A sine: between flatter axes, offsets are levered up by more than fifty and say nothing.
STEEPEST = 0.02
# Directions that span space leave no distance.
DIMENSIONS = 3


class Measure(StrEnum):
    """What an invariant measures."""

    ANGLE = "angle"
    DISTANCE = "distance"
    OFFSET = "offset"
    TURN = "turn"


@dataclass(frozen=True, slots=True)
class Invariant:
    """One invariant of the reference.

    Attributes:
        measure: what it measures.
        axes: the axes it is measured between; see `axes_of` for how the ends are counted.
        value: the reference's value.
        slack: how far a submission's may be off.
    """

    measure: Measure
    axes: tuple[int, ...]
    value: float
    slack: float

    def measured(self, axes: Sequence[Axis]) -> float:
        """The submission's value."""
        return _MEASURES[self.measure](axes, self.axes)

    def signed(self, axes: Sequence[Axis]) -> float:
        """A function of the submission that is smooth where `measured` has a kink.

        The square of a length; of an angle the cosine, with the sign that the axes happen to have.
        """
        if self.measure is Measure.ANGLE:
            return dot(axes[self.axes[0]].direction, axes[self.axes[1]].direction)
        return self.measured(axes) ** 2

    def oriented(self, axes: Sequence[Axis]) -> tuple[float, float]:
        """The submission's value with its sign, and what it would be if one of its axes were reversed.

        Lengths about sliders, and angles about them, have no sign here.
        """
        i, j = self.axes[:2]
        if self.measure is Measure.ANGLE:
            angle = angle_between(axes[i].direction, axes[j].direction)
            return angle, math.pi - angle
        value = self.measured(axes)
        if self.measure is Measure.OFFSET:
            before, first, final, after = (axes[k] for k in self.axes)
            value = dot(first.direction, subtract(_foot(final, after), _foot(first, before)))
            return value, -value
        if self.measure is Measure.DISTANCE and set(self.axes[2:]) == {i, j}:
            normal = cross(axes[i].direction, axes[j].direction)
            if dot(normal, subtract(axes[j].point, axes[i].point)) < 0.0:
                value = -value
            return value, -value
        return value, value

    def strain(self, axes: Sequence[Axis]) -> float:
        """How far the submission's value is off, in units of what it may be off."""
        return abs(self.measured(axes) - self.value) / self.slack

    def fits(self, axes: Sequence[Axis]) -> bool:
        """Whether the submission's value is near enough."""
        return self.strain(axes) <= 1.0


def axes_of(chain: Chain, policy: Policy) -> list[Axis]:
    """The joint axes, with what the policy fixes at the ends as further axes.

    A fixed origin or tool point stands for itself as an axis along the neighbouring joint's; frames and lines
    stand as their z axis. Index 0 is always the base's place, whether it is fixed or not.
    """
    if not chain.axes:
        return []
    first, last = chain.axes[0], chain.axes[-1]
    base = Axis(False, Z_AXIS if policy.base is BaseRule.FRAME else first.direction, ORIGIN)
    direction = z_axis(chain.end) if policy.tool is ToolRule.FRAME else last.direction
    return [base, *chain.axes, Axis(False, direction, position(chain.end))]


@lru_cache(maxsize=4096)
def invariants_of(reference: Reference, policy: Policy) -> tuple[Invariant, ...]:
    """The invariants of a reference, and of the frames that a policy fixes."""
    axes = axes_of(reference.chain, policy)
    found: list[Invariant] = []
    fixed_base = policy.base in (BaseRule.ORIGIN, BaseRule.FRAME)
    fixed_tool = policy.tool in (ToolRule.POINT, ToolRule.FRAME)
    first = 0 if fixed_base else 1
    last = len(axes) - 1 if fixed_tool else len(axes) - 2
    for i in range(first, last):
        found += _between(axes, i, last, reference.size, policy)
    for i in range(first if fixed_base else first + 1, last):
        found += _along(axes, i, last, reference.size, policy)
    return tuple(found)


def _between(axes: Sequence[Axis], i: int, last: int, size: float, policy: Policy) -> list[Invariant]:
    """Between an axis and the next, and the next that is no slider."""
    angle_slack = SLACK * policy.tolerance.angle + FLOOR
    found = [_invariant(Measure.ANGLE, axes, (i, i + 1), angle_slack)]
    k = i + 1
    while k < last and axes[k].prismatic:
        k += 1
    if axes[i].prismatic or axes[k].prismatic:
        return found
    spanning, steepness = _spanning(axes, (i, *range(k, i, -1)))
    if len(spanning) < DIMENSIONS:
        slack = (SLACK * policy.tolerance.length + FLOOR) * size / steepness
        found.append(_invariant(Measure.DISTANCE, axes, (i, k, *spanning), slack))
    return found


def _spanning(axes: Sequence[Axis], candidates: Sequence[int]) -> tuple[tuple[int, ...], float]:
    """Which of some axes span the directions of all of them, and how steep the flattest of these is."""
    chosen: list[int] = []
    basis: list[Vector] = []
    steepness = 1.0
    for k in candidates:
        rest = outside(axes[k].direction, tuple(basis))
        if norm(rest) > PARALLEL:
            chosen.append(k)
            steepness = min(steepness, norm(rest))
            basis.append(unit(rest))
    return tuple(chosen), max(steepness, STEEPEST)


def _along(axes: Sequence[Axis], i: int, last: int, size: float, policy: Policy) -> list[Invariant]:
    """Along the run of parallel axes that begins with axis i, or about the slider i.

    A point that the policy fixes is its own foot at its end of the run.
    """
    here = axes[i]
    before = max(i - 1, 0)
    sine = norm(cross(axes[before].direction, here.direction)) if i else 1.0
    if sine < STEEPEST:
        return []
    if here.prismatic:
        return _about(axes, i, sine, policy) if i else []
    j = i
    while j < last and not axes[j + 1].prismatic and _parallel(axes[j + 1], here):
        j += 1
    after = min(j + 1, last)
    while after < last and axes[after].prismatic and _parallel(axes[after], axes[after + 1]):
        after += 1
    other = norm(cross(axes[after].direction, here.direction)) if j < last else 1.0
    if other < STEEPEST or axes[after].prismatic or axes[before].prismatic:
        return []
    if j == last and last != len(axes) - 1:
        return []
    slack = (SLACK * policy.tolerance.length + FLOOR) * size / min(sine, other)
    return [_invariant(Measure.OFFSET, axes, (before, i, j, after), slack)]


def _about(axes: Sequence[Axis], i: int, sine: float, policy: Policy) -> list[Invariant]:
    other = norm(cross(axes[i].direction, axes[i + 1].direction))
    if other < STEEPEST:
        return []
    slack = SLACK * policy.tolerance.angle / (sine * other) + FLOOR
    return [_invariant(Measure.TURN, axes, (i - 1, i, i + 1), slack)]


def _parallel(one: Axis, other: Axis) -> bool:
    return norm(cross(one.direction, other.direction)) < PARALLEL


def _invariant(measure: Measure, axes: Sequence[Axis], which: tuple[int, ...], slack: float) -> Invariant:
    return Invariant(measure, which, _MEASURES[measure](axes, which), slack)


def _angle(axes: Sequence[Axis], which: tuple[int, ...]) -> float:
    one, other = axes[which[0]].direction, axes[which[1]].direction
    return math.atan2(norm(cross(one, other)), abs(dot(one, other)))


def _distance(axes: Sequence[Axis], which: tuple[int, ...]) -> float:
    """What is left of the displacement from one axis to the other outside the directions that span it."""
    one, other, *spanning = which
    basis: list[Vector] = []
    for k in spanning:
        rest = outside(axes[k].direction, tuple(basis))
        if norm(rest) > PARALLEL:
            basis.append(unit(rest))
    return norm(outside(subtract(axes[other].point, axes[one].point), tuple(basis)))


def _offset(axes: Sequence[Axis], which: tuple[int, ...]) -> float:
    before, first, final, after = (axes[k] for k in which)
    return abs(dot(first.direction, subtract(_foot(final, after), _foot(first, before))))


def _foot(axis: Axis, other: Axis) -> Vector:
    """Where the common normal with another axis stands on an axis."""
    across_both = cross(axis.direction, other.direction)
    square = dot(across_both, across_both)
    if square < PARALLEL**2:
        return axis.point
    gap = subtract(other.point, axis.point)
    along = dot(cross(gap, other.direction), across_both) / square
    return plus(axis.point, scale(axis.direction, along))


def _turn(axes: Sequence[Axis], which: tuple[int, ...]) -> float:
    before, slider, after = (axes[k].direction for k in which)
    one, other = rejection(before, slider), rejection(after, slider)
    return math.atan2(norm(cross(one, other)), abs(dot(one, other)))


_MEASURES: dict[Measure, Callable[[Sequence[Axis], tuple[int, ...]], float]] = {
    Measure.ANGLE: _angle,
    Measure.DISTANCE: _distance,
    Measure.OFFSET: _offset,
    Measure.TURN: _turn,
}
