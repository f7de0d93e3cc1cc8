"""The last feature of the chain: where frame N must lie."""

import math
from dataclasses import dataclass

from kinematics.chain import Axis, Chain
from kinematics.equivalence.alignment import align
from kinematics.equivalence.groups import Group, Nearness, Rotations, are_parallel, distance_to_line, outside
from kinematics.equivalence.plan import Plan, Step, prepare
from kinematics.equivalence.policy import ToolRule
from kinematics.equivalence.reference import Reference
from kinematics.equivalence.refinement import (
    DIRECTION_TWISTS,
    FREE_TWISTS,
    LINE_TWISTS,
    NO_TWISTS,
    POINT_TWISTS,
)
from kinematics.se3 import (
    IDENTITY,
    Floats,
    Motion,
    Vector,
    compose,
    cross,
    dot,
    inverse,
    move,
    norm,
    position,
    rejection,
    rotate,
    rotation_about,
    scale,
    subtract,
    translation,
    turn_onto,
    unit,
    x_axis,
    z_axis,
)

NEGLIGIBLE = 1e-12  # A share: what is shorter than this beside what it is compared with is a rounding error.


@dataclass(frozen=True, slots=True)
class ToolChoice:
    """One way in which the policy lets frame N lie.

    Attributes:
        step: the line or direction that z_N must lie on, prepared; None for `free` and `point`.
        group: H_N.
        target: the reference's M.
        off_axis: the reference's O_N is not on what H_N turns about, so that it says how far to turn.
        turns: frame N may move with the last joint, and the rule still holds.
    """

    rule: ToolRule
    step: Step | None
    group: Group
    target: Motion
    off_axis: bool
    turns: bool

    @property
    def twists(self) -> Floats:
        """The twists by which E may change from the right, in the submission's frame N."""
        if self.rule is ToolRule.FREE:
            return FREE_TWISTS
        if self.rule is ToolRule.POINT:
            return POINT_TWISTS
        if self.rule is ToolRule.FRAME or self.step is None:
            return NO_TWISTS
        return DIRECTION_TWISTS if self.step.axis.prismatic else LINE_TWISTS


def tool_choices(reference: Reference, plan: Plan, rule: ToolRule, near: Nearness) -> tuple[ToolChoice, ...]:
    """Return the ways in which a rule lets the submission's frame N lie, for a reference and a plan of it."""
    key = (id(plan), rule, near)
    known = reference.ends.get(key)
    if known is None:
        found = _choices(reference.chain, plan.last, rule, near, reference.size)
        known = reference.ends[key] = plan, found
    return known[1]


def _choices(
    chain: Chain, group: Group, rule: ToolRule, near: Nearness, size: float
) -> tuple[ToolChoice, ...]:
    end = chain.end
    off_axis = _is_off_axis(position(end), group, near)
    if rule is ToolRule.FREE:
        return (ToolChoice(rule, None, group, end, off_axis, turns=True),)
    own = Axis(False, z_axis(end), position(end))
    last = chain.axes[-1] if chain.axes else None
    if rule is ToolRule.POINT:
        turns = last is not None and not last.prismatic and _on(position(end), last, near)
        return (ToolChoice(rule, None, group, end, off_axis, turns=turns),)
    step = prepare(own, group, near, size)
    if rule is ToolRule.FRAME or last is None:
        return (ToolChoice(rule, step, group, end, off_axis, turns=False),)
    along = are_parallel(last.direction, own.direction, near)
    same = along and (last.prismatic or _on(own.point, last, near))
    found = [ToolChoice(rule, prepare(last, group, near, size), group, end, off_axis, turns=True)]
    if not same:
        found.insert(0, ToolChoice(rule, step, group, end, off_axis, turns=along and last.prismatic))
    return tuple(found)


def _is_off_axis(point: Vector, group: Group, near: Nearness) -> bool:
    """Whether a point moves where the group's rotations turn."""
    if group.rotations is Rotations.ABOUT_POINT:
        return norm(subtract(point, group.point)) > near.length
    return distance_to_line(point, group.point, group.axis) > near.length


def _on(point: Vector, axis: Axis, near: Nearness) -> bool:
    return distance_to_line(point, axis.point, axis.direction) <= near.length


def placements(choice: ToolChoice, here: Motion) -> list[Motion]:
    """Return motions of H_N that place the submission's frame N as nearly as they can as the choice wants.

    `here` is the pose of the submission's frame N after all alignments.
    """
    if choice.rule is ToolRule.FREE:
        return [IDENTITY]
    if choice.rule is ToolRule.POINT:
        return [_point_onto(choice, position(here))]
    assert choice.step is not None
    if choice.rule is ToolRule.FRAME:
        first = align(choice.step, z_axis(here), position(here), 1).motion
        return [compose(_settle(choice.step.stabiliser, compose(first, here), choice.target), first)]
    return [align(choice.step, z_axis(here), position(here), sign).motion for sign in (1, -1)]


def _point_onto(choice: ToolChoice, point: Vector) -> Motion:
    """The motion of H_N that brings a point nearest to the reference's O_N.

    Where that lies on what H_N turns about, no turn brings the point nearer: the direction in which it was
    seen from there would be that of a rounding error.
    """
    group, target, turn = choice.group, position(choice.target), IDENTITY
    if choice.off_axis and not group.translations and group.rotations is Rotations.ABOUT_POINT:
        turn = _turn_point(group.point, point, target)
    elif choice.off_axis and len(group.translations) < 3 and group.rotations is Rotations.ABOUT_LINE:
        turn = _turn_about_line(group, point, target)
    gap = subtract(target, move(turn, point))
    return compose(translation(subtract(gap, outside(gap, group.translations))), turn)


def _turn_point(centre: Vector, point: Vector, target: Vector) -> Motion:
    a, b = subtract(point, centre), subtract(target, centre)
    return IDENTITY if norm(a) < NEGLIGIBLE * norm(b) else turn_onto(centre, unit(a), unit(b))


def _turn_about_line(group: Group, point: Vector, target: Vector) -> Motion:
    a = rejection(subtract(point, group.point), group.axis)
    b = rejection(subtract(target, group.point), group.axis)
    if norm(a) < NEGLIGIBLE * norm(b):
        return IDENTITY
    size = norm(a) * norm(b)
    return rotation_about(group.point, group.axis, dot(a, b) / size, dot(group.axis, cross(a, b)) / size)


def _settle(group: Group, here: Motion, target: Motion) -> Motion:
    """Turn and slide, by what keeps the line of z_N, until x_N and the origin lie as they should."""
    turn = IDENTITY
    if group.rotations is not Rotations.NONE:
        x, goal = x_axis(here), x_axis(target)
        cosine, sine = dot(rejection(x, group.axis), goal), dot(group.axis, cross(x, goal))
        size = math.hypot(cosine, sine)
        if size > NEGLIGIBLE:
            turn = rotation_about(group.point, group.axis, cosine / size, sine / size)
    gap = subtract(position(target), move(turn, position(here)))
    return compose(translation(subtract(gap, outside(gap, group.translations))), turn)


def obeying(choice: ToolChoice, tool: Motion) -> Motion:
    """Return the E nearest to a given one that keeps the rule exactly; the rest goes into the residual."""
    if choice.rule is ToolRule.FREE:
        return tool
    if choice.rule is ToolRule.FRAME:
        return IDENTITY
    if choice.rule is ToolRule.POINT:
        return (*tool[:9], 0.0, 0.0, 0.0)
    assert choice.step is not None
    back = inverse(choice.target)
    axis = choice.step.axis
    direction = rotate(back, axis.direction)
    direction = scale(direction, math.copysign(1.0, dot(direction, z_axis(tool))))
    tool = compose(turn_onto(position(tool), z_axis(tool), direction), tool)
    if axis.prismatic:
        return tool
    gap = rejection(subtract(move(back, axis.point), position(tool)), direction)
    return compose(translation(gap), tool)
