"""What does not fit, fact by fact: force the best alignment at an axis that cannot be aligned, and go on."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from kinematics.chain import Axis, Chain
from kinematics.equivalence.alignment import Alignment, align
from kinematics.equivalence.batches import axis_batch
from kinematics.equivalence.groups import Group, Rotations, departure
from kinematics.equivalence.invariants import Invariants, axes_of
from kinematics.equivalence.measures import Measure
from kinematics.equivalence.plan import Plan, Step
from kinematics.equivalence.policy import BaseRule, Policy, ToolRule, ZeroRule
from kinematics.equivalence.reference import Reference
from kinematics.equivalence.results import Kind, Mismatch
from kinematics.equivalence.tools import placements, tool_choices
from kinematics.se3 import (
    Motion,
    Vector,
    angle_between,
    compose,
    cross,
    dot,
    inverse,
    move,
    norm,
    position,
    rejection,
    rotate,
    rotation_angle,
    scale,
    subtract,
    translation,
    turn_onto,
    z_axis,
)
from kinematics.table import Convention, NumericTable

WIDTH = 8  # Signs that are followed side by side: of three axes in a row, all of them.
NOTICEABLE = 2.0  # In units of the tolerance: a fact off by less may be the rounding of its neighbours.


class Trail(NamedTuple):
    """The facts found on the way down the chain, with one choice of signs.

    Attributes:
        cost: number of wrong facts, and a little for what is left of the right ones.
        here: the motion of the submission so far.
        signs: the signs taken.
    """

    cost: float
    here: Motion
    mismatches: tuple[Mismatch, ...]
    signs: tuple[int, ...]


def diagnose(
    reference: Reference, table: NumericTable, submission: Chain, policy: Policy
) -> tuple[Mismatch, ...]:
    """Return the smallest set of wrong facts that explains a submission with as many joints as the reference.

    If every fact is right by itself, but not all together, their precision is what is wrong.

    Base and tool are judged by the policy; zeros and directions are left free.
    """
    near = reference.nearnesses(policy.tolerance)[0]
    best: Trail | None = None
    for plan in reference.plans(policy.base, ZeroRule.FREE, near):
        for trail in _trails(plan, reference, submission, policy):
            trail = _end(trail, plan, reference, submission, policy)
            if best is None or trail.cost < best.cost:
                best = trail
    assert best is not None
    mismatches = best.mismatches or (Mismatch(kind=Kind.PRECISION),)
    return tuple(_placed(mismatch, table) for mismatch in mismatches)


_KIND_OF_MEASURE = {
    Measure.ANGLE: Kind.TWIST,
    Measure.DISTANCE: Kind.LENGTH,
    Measure.OFFSET: Kind.OFFSET,
    Measure.TURN: Kind.OFFSET,
    Measure.SUM: Kind.OFFSET,
}


def mismatches_of(
    invariants: Invariants, reference: Reference, table: NumericTable, submission: Chain, policy: Policy
) -> tuple[Mismatch, ...]:
    """Return the invariants that a submission does not share with the reference, as what does not fit."""
    sizes = invariants.sizes(invariants.measured(axis_batch([axes_of(submission, policy)])))
    off = np.abs(sizes - invariants.sizes(invariants.values))[:, 0].tolist()
    last = len(reference.chain.axes)
    found = []
    for shape, apart in zip(invariants.shapes, off, strict=True):
        joint, kind = shape.axes[2 if shape.measure is Measure.SUM else 1], _KIND_OF_MEASURE[shape.measure]
        angle, length = (apart, 0.0) if shape.is_angle else (0.0, apart)
        if joint > last:
            found.append(_placed(Mismatch(kind=Kind.TOOL, joint=last, angle=angle, length=length), table))
        elif shape.axes[0] == 0 and (kind is not Kind.OFFSET or shape.axes[2] == 0):
            joint, kind = max(joint, 1), Kind.BASE
        elif joint == 0:  # along z_0, which is parallel to the first joint's axis
            joint = 1
        found.append(_placed(Mismatch(kind=kind, joint=joint, angle=angle, length=length), table))
    return tuple(found)


def likely_signs(reference: Reference, submission: Chain, policy: Policy) -> list[tuple[int, ...]]:
    """Return the choices of signs with which a submission fits best, the best first."""
    near = reference.nearnesses(policy.tolerance)[0]
    plan = reference.plans(BaseRule.FREE, ZeroRule.FREE, near)[0]
    return [trail.signs for trail in _trails(plan, reference, submission, policy)]


def _trails(plan: Plan, reference: Reference, submission: Chain, policy: Policy) -> list[Trail]:
    """The best few ways down the chain."""
    size = reference.size
    judge = _Judge(
        reference.chain.axes, NOTICEABLE * policy.tolerance.angle, NOTICEABLE * policy.tolerance.length * size
    )
    trails = [Trail(0.0, start, (), ()) for start in plan.starts]
    groups = [*(step.group for step in plan.steps), plan.last]
    for step, axis, following in zip(plan.steps, submission.axes, groups[1:], strict=True):
        longer = [_onward(trail, step, axis, sign, judge) for trail in trails for sign in (1, -1)]
        longer.sort(key=lambda trail: trail.cost)
        trails = []
        for trail in longer:
            if not any(_same(following, trail.here, other.here, size) for other in trails):
                trails.append(trail)
            if len(trails) == WIDTH:
                break
    return trails


def _same(group: Group, here: Motion, other: Motion, size: float) -> bool:
    angle, length = departure(group, compose(here, inverse(other)))
    return angle < 1e-6 and length < 1e-6 * size


def _onward(trail: Trail, step: Step, axis: Axis, sign: int, judge: "_Judge") -> Trail:
    """The trail one joint longer; what cannot be aligned is forced, so that the next joints can be judged."""
    target = step.axis
    found, wrong, strain = _least_wrong(trail, step, axis, sign, judge)
    here = compose(found.motion, trail.here)
    here = compose(turn_onto(target.point, found.direction, target.direction), here)
    if not target.prismatic:
        gap = subtract(target.point, move(here, axis.point))
        gap = subtract(gap, scale(target.direction, dot(gap, target.direction)))
        if any(mismatch.kind is Kind.OFFSET and mismatch.length for mismatch in wrong):
            gap = _along_previous(step, gap)
        here = compose(translation(gap), here)
    small_change = 1e-3 * (1.0 - 1.0 / (1.0 + strain)) + (1e-6 if sign < 0 else 0.0)
    mismatches = (*trail.mismatches, *wrong)
    return Trail(trail.cost + len(wrong) + small_change, here, mismatches, (*trail.signs, sign))


def _along_previous(step: Step, gap: Vector) -> Vector:
    """A displacement onto an axis, so that what of it is no length is made along the axis before it.

    There an offset is measured: across the axis alone, the next one would find its part along it missing.
    """
    axis, direction = step.group.axis, step.axis.direction
    lean = rejection(axis, direction)
    along = dot(gap, lean) / dot(lean, lean) * dot(axis, direction)
    return (gap[0] + along * direction[0], gap[1] + along * direction[1], gap[2] + along * direction[2])


def _least_wrong(
    trail: Trail, step: Step, axis: Axis, sign: int, judge: "_Judge"
) -> tuple[Alignment, list[Mismatch], float]:
    """The alignment with the fewest wrong facts, these, and the largest misfit of it.

    A rotation that weighs directions against places turns an axis out of the right direction where a length
    is wrong; by directions alone the length is all that is left.
    """
    direction, point = rotate(trail.here, axis.direction), move(trail.here, axis.point)
    joint = len(trail.signs) + 1
    found = align(step, direction, point, sign)
    wrong, strain = judge.of(step, axis, found, joint)
    if wrong and step.by_direction and step.by_moment:
        turned = align(replace(step, by_moment=0.0), direction, point, sign)
        fewer, other = judge.of(step, axis, turned, joint)
        if len(fewer) < len(wrong):
            return turned, fewer, other
    return found, wrong, strain


@dataclass(frozen=True, slots=True)
class _Judge:
    """Says which of the misfits of an alignment are wrong facts.

    Attributes:
        axes: the reference's joint axes.
        angle: the largest angle that is none [rad].
        length: the largest distance that is none.
    """

    axes: tuple[Axis, ...]
    angle: float
    length: float

    def of(self, step: Step, axis: Axis, found: Alignment, joint: int) -> tuple[list[Mismatch], float]:
        """Return the wrong facts at a joint, and the largest misfit in units of what is none."""
        target = step.axis
        wrong: list[Mismatch] = []
        strain = _excess(found.angle, self.angle)
        if axis.prismatic is not target.prismatic:
            wrong.append(Mismatch(kind=Kind.JOINT_TYPE, joint=joint))
        if found.angle > self.angle:
            previous = self.axes[joint - 2] if joint > 1 else None
            wrong += _angles(step, previous, found, joint, self.angle)
        if not axis.prismatic and not target.prismatic:
            strain = max(strain, _excess(found.distance, self.length))
            if found.distance > self.length:
                wrong += _lengths(step, found.gap, joint, self.length)
        return wrong, strain


def _angles(step: Step, previous: Axis | None, found: Alignment, joint: int, limit: float) -> list[Mismatch]:
    """An angle that is left: between two axes (twist), or about the earlier one (θ of a prismatic joint)."""
    if previous is None:
        return [Mismatch(kind=Kind.BASE, joint=1, angle=found.angle)]
    if step.group.rotations is not Rotations.NONE:
        return [Mismatch(kind=Kind.TWIST, joint=joint, angle=found.angle)]
    axis, goal = previous.direction, step.axis.direction
    twist = abs(angle_between(found.direction, axis) - angle_between(goal, axis))
    one, two = rejection(found.direction, axis), rejection(goal, axis)
    turn = math.atan2(norm(cross(one, two)), dot(one, two))
    mismatches = []
    if twist > limit:
        mismatches.append(Mismatch(kind=Kind.TWIST, joint=joint, angle=twist))
    if turn * min(norm(one), norm(two)) > limit or not mismatches:
        mismatches.append(Mismatch(kind=Kind.OFFSET, joint=joint - 1, angle=turn))
    return mismatches


def _lengths(step: Step, gap: Vector, joint: int, limit: float) -> list[Mismatch]:
    """A displacement that is left: along the common normal (length) or the last joint's axis (offset)."""
    size = norm(gap)
    if joint == 1:
        return [Mismatch(kind=Kind.BASE, joint=1, length=size)]
    if not step.by_direction or step.group.translations:
        return [Mismatch(kind=Kind.LENGTH, joint=joint, length=size)]
    direction = step.axis.direction
    normal = cross(step.group.axis, direction)
    sine = norm(normal)
    normal = scale(normal, 1.0 / sine)
    length = abs(dot(gap, normal))
    offset = abs(dot(gap, cross(normal, direction)))
    found = []
    if length > limit:
        found.append(Mismatch(kind=Kind.LENGTH, joint=joint, length=length))
    if offset > limit or not found:
        found.append(Mismatch(kind=Kind.OFFSET, joint=joint - 1, length=offset / sine))
    return found


def _excess(misfit: float, allowed: float) -> float:
    """Return a misfit in units of what is allowed, which may be nothing: a share of no size at all."""
    if allowed:
        return misfit / allowed
    return math.inf if misfit else 0.0


def _end(trail: Trail, plan: Plan, reference: Reference, submission: Chain, policy: Policy) -> Trail:
    """Judge where frame N lies."""
    if policy.tool is ToolRule.FREE:
        return trail
    here = compose(trail.here, submission.end)
    near = reference.nearnesses(policy.tolerance)[0]
    allowed = policy.tolerance.length * reference.size
    errors = []
    for choice in tool_choices(reference, plan, policy.tool, near):
        for motion in placements(choice, here):
            placed = compose(motion, here)
            angle, length = _tool_error(choice.rule, placed, choice.target, choice.step)
            worst = max(_excess(angle, policy.tolerance.angle), _excess(length, allowed))
            errors.append((worst, angle, length, placed, choice.target))
    worst, angle, length, placed, target = min(errors, key=lambda error: error[:3])
    if worst <= NOTICEABLE:
        return trail
    missed = Mismatch(kind=Kind.TOOL, joint=len(trail.signs) or None, angle=angle, length=length)
    facts = _last_link(reference, placed, target, policy)
    return trail._replace(cost=trail.cost + 1.0, mismatches=(*trail.mismatches, missed, *facts))


def _last_link(reference: Reference, placed: Motion, target: Motion, policy: Policy) -> Iterator[Mismatch]:
    """The wrong facts of the last link, which leads from the last axis to the tool."""
    axes = reference.chain.axes
    if not axes or axes[-1].prismatic:
        return
    axis, joints = axes[-1], len(axes)
    limit = NOTICEABLE * policy.tolerance.length * reference.size
    ours, its = (subtract(position(pose), axis.point) for pose in (placed, target))
    across = abs(norm(rejection(ours, axis.direction)) - norm(rejection(its, axis.direction)))
    along = abs(dot(subtract(ours, its), axis.direction))
    if across > limit:
        yield Mismatch(kind=Kind.LENGTH, joint=joints + 1, length=across)
    if along > limit and policy.tool is not ToolRule.AXIS:
        yield Mismatch(kind=Kind.OFFSET, joint=joints, length=along)
    if policy.tool is not ToolRule.POINT:
        one, two = (angle_between(z_axis(pose), axis.direction) for pose in (placed, target))
        twist = abs(one - two) if policy.tool is ToolRule.FRAME else abs(math.sin(one) - math.sin(two))
        if twist > NOTICEABLE * policy.tolerance.angle:
            yield Mismatch(kind=Kind.TWIST, joint=joints + 1, angle=twist)


def _tool_error(rule: ToolRule, here: Motion, target: Motion, step: Step | None) -> tuple[float, float]:
    gap = subtract(position(target), position(here))
    if rule is ToolRule.POINT:
        return 0.0, norm(gap)
    if rule is ToolRule.FRAME or step is None:
        return rotation_angle(compose(inverse(here), target)), norm(gap)
    axis = step.axis
    z = z_axis(here)
    angle = math.atan2(norm(cross(z, axis.direction)), abs(dot(z, axis.direction)))
    if axis.prismatic:
        return angle, 0.0
    gap = subtract(axis.point, position(here))
    return angle, norm(subtract(gap, scale(axis.direction, dot(gap, axis.direction))))


def _placed(mismatch: Mismatch, table: NumericTable) -> Mismatch:
    """The mismatch, with the row of the submission in which that fact stands."""
    joint = mismatch.joint
    if joint is None:
        return mismatch
    standard = table.convention is Convention.STANDARD
    if mismatch.kind is Kind.TOOL or joint > table.n_joints:
        row = len(table.rows) - 1
    else:
        before = mismatch.kind in (Kind.LENGTH, Kind.TWIST) and standard
        row = table.joint_rows[max(joint - 1, 1) - 1 if before else joint - 1]
    return replace(mismatch, row=row)
