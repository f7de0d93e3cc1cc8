"""What would make a table simpler, of frames that break no rule."""

import math

from kinematics.frames.axes import Pose
from kinematics.frames.normals import CommonNormal, Relation, common_normal
from kinematics.frames.rules import (
    ANGLE_TOLERANCE,
    LENGTH_TOLERANCE,
    FrameFinding,
    FramePart,
    FramePlace,
    RuleCode,
    Severity,
    parallel,
)
from kinematics.se3 import Vector, angle_from_to, dot, norm, subtract
from kinematics.table import Convention


def direction_advice(frame: Pose, place: FramePlace) -> list[FrameFinding]:
    """Return whether z follows the joint's positive direction, and x leads from axis i to axis i+1.

    Source: seed 000 §3.2.1; seed 002 step 4; seed 004 cases 2 and 3.
    """
    findings = []
    if place.own_line is not None and place.own is not None and dot(frame.z, place.own_line.direction) < 0:
        findings.append(_advice(RuleCode.Z_REVERSED, FramePart.Z, axis=place.own))
    normal = _normal(place)
    apart = normal is not None and normal.length > 0
    if apart and normal and normal.direction and dot(normal.direction, frame.x) < 0:
        findings.append(_advice(RuleCode.X_REVERSED, FramePart.X, **place.pair))
    return findings


def vanishing_advice(frame: Pose, before: Pose, place: FramePlace) -> list[FrameFinding]:
    """Return whether d_i = 0 was to be had where the origin slides, or θ_i = 0 where x may be turned.

    Args:
        frame: frame i, i ≥ 2: what frame 1 leaves is frame 0's matter.
        before: frame i-1.
        place: the neighbourhood of frame i.

    Source: seed 002 step 3, second case, and step 4.
    """
    normal = _normal(place)
    if normal is None:
        return []
    findings = []
    axis = _joint_axis(frame, before, place)
    if normal.relation.slides and _offset(frame, before, axis) > LENGTH_TOLERANCE * place.size:
        findings.append(_advice(RuleCode.OFFSET_COULD_VANISH, FramePart.ORIGIN, joint=place.index))
    angle = abs(angle_from_to(before.x, frame.x, axis))
    turned = normal.relation is Relation.COINCIDENT and angle > ANGLE_TOLERANCE
    flipped = normal.relation is Relation.INTERSECTING and angle > math.pi - ANGLE_TOLERANCE
    if turned or flipped:
        findings.append(_advice(RuleCode.ANGLE_COULD_VANISH, FramePart.X, joint=place.index))
    return findings


def first_advice(frame: Pose, after: Pose, place: FramePlace) -> list[FrameFinding]:
    """Return whether frame 0 could be simpler: modified, on frame 1 at zero; standard, d_1 = 0 and θ_1 = 0.

    Source: seed 000 §3.2.2; seed 002 step 6.
    """
    w = subtract(after.origin, frame.origin)
    near = LENGTH_TOLERANCE * place.size
    if place.convention is Convention.MODIFIED:
        placed = norm(w) <= near and parallel(frame.z, after.z) and dot(frame.z, after.z) > 0
    else:
        placed = abs(dot(w, frame.z)) <= near
    turned = parallel(frame.x, after.x) and dot(frame.x, after.x) > 0
    if placed and turned:
        return []
    return [_advice(RuleCode.FIRST_NOT_SIMPLEST, FramePart.X if placed else FramePart.ORIGIN)]


def last_advice(frame: Pose, before: Pose, place: FramePlace) -> list[FrameFinding]:
    """Return whether d_N = 0 and θ_N = 0 were to be had.

    Source: seed 000 §3.2.2; seed 002 step 7.
    """
    axis = _joint_axis(frame, before, place)
    placed = _offset(frame, before, axis) <= LENGTH_TOLERANCE * place.size
    if placed and abs(angle_from_to(before.x, frame.x, axis)) <= ANGLE_TOLERANCE:
        return []
    return [_advice(RuleCode.LAST_NOT_SIMPLEST, FramePart.X if placed else FramePart.ORIGIN)]


def _joint_axis(frame: Pose, before: Pose, place: FramePlace) -> Vector:
    """The z about which joint i turns."""
    return before.z if place.convention is Convention.STANDARD else frame.z


def _offset(frame: Pose, before: Pose, axis: Vector) -> float:
    return abs(dot(subtract(frame.origin, before.origin), axis))


def _normal(place: FramePlace) -> CommonNormal | None:
    if place.own_line is None or place.partner_line is None or place.own is None or place.partner is None:
        return None
    own, partner = place.own_line, place.partner_line
    return common_normal(*((own, partner) if place.own < place.partner else (partner, own)), place.size)


def _advice(rule: RuleCode, part: FramePart, **params: int) -> FrameFinding:
    return FrameFinding(rule=rule, part=part, severity=Severity.ADVICE, params=params)
