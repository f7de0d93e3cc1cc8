"""The chain of groups of a reference: everything about the decision that the reference alone determines.

With the joint screws S_i of the reference, H_0 as the policy on frame 0 says and

    Stab_i = the motions of H_{i-1} that keep S_i,        H_i = exp(S_i ℝ) · Stab_i,

the motions that may still be applied to the submission after joint i form a coset of H_i. Where the policy
fixes the zeros of the variables there is no exp(S_i ℝ), and H_i = Stab_i.
"""

from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from kinematics.chain import Axis, Chain
from kinematics.equivalence.groups import (
    EVERYTHING,
    NOTHING,
    Group,
    Nearness,
    Rotations,
    about_direction,
    about_point,
    cylinder,
    fixing_direction,
    fixing_line,
    with_rotations_about,
    with_translations_along,
)
from kinematics.equivalence.policy import BaseRule, ZeroRule
from kinematics.se3 import (
    IDENTITY,
    ORIGIN,
    Z_AXIS,
    Floats,
    Motion,
    Vector,
    compose,
    cross,
    norm,
    rejection,
    rotation_about,
    subtract,
    translation,
    turn_onto,
)


@dataclass(frozen=True, slots=True)
class Step:
    """One joint of the reference, prepared for aligning the submission's joint with it.

    Attributes:
        axis: the reference's joint axis, the target.
        group: H_{i-1}, the motions that may be used.
        stabiliser: Stab_i, the motions that keep the target.
        by_direction: weight of the direction in finding the angle of a rotation about the group's line (0 or
            1).
        by_moment: weight of the line's moment in that [1/length²]; 0 where it says nothing.
        moment: moment of the target about the group's point.
        slide: 3x3 by rows; takes the displacement still needed to the translation of the group that does most
            of it.
    """

    axis: Axis
    group: Group
    stabiliser: Group
    by_direction: float
    by_moment: float
    moment: Vector
    slide: tuple[float, ...] | None


@dataclass(frozen=True, slots=True)
class Plan:
    """A way to begin, and the groups that follow from it.

    Attributes:
        starts: motions that put the submission's frame 0 where H_0 may take it up.
        steps: one per joint.
        last: H_n.
    """

    starts: tuple[Motion, ...]
    steps: tuple[Step, ...]
    last: Group

    @property
    def shape(self) -> tuple[object, ...]:
        """The kinds of the groups, so that two plans can be told apart."""
        return tuple(
            (s.group.rotations, len(s.group.translations), s.by_direction > 0, s.by_moment > 0)
            for s in self.steps
        )


def plans_for(chain: Chain, base: BaseRule, zero: ZeroRule, near: Nearness, size: float) -> tuple[Plan, ...]:
    """Return the chains of groups of a reference, one per way in which the policy lets frame 0 lie."""
    return tuple(
        _plan(chain, group, starts, zero, near, size) for group, starts in _beginnings(chain, base, near)
    )


def _beginnings(chain: Chain, base: BaseRule, near: Nearness) -> list[tuple[Group, tuple[Motion, ...]]]:
    """H_0, and the motions that bring frame 0 of the submission to where the reference has it."""
    if base is BaseRule.FREE:
        return [(EVERYTHING, (IDENTITY,))]
    if base is BaseRule.FRAME:
        return [(NOTHING, (IDENTITY,))]
    if base is BaseRule.ORIGIN:
        return [(about_point(ORIGIN), (IDENTITY,))]
    upside_down = rotation_about(ORIGIN, (1.0, 0.0, 0.0), -1.0, 0.0)
    found: list[tuple[Group, tuple[Motion, ...]]] = [(cylinder(ORIGIN, Z_AXIS), (IDENTITY, upside_down))]
    if chain.axes:
        first = chain.axes[0]
        onto = compose(translation(first.point), turn_onto(ORIGIN, Z_AXIS, first.direction))
        both = (onto, compose(onto, upside_down))
        if first.prismatic:
            found.insert(0, (about_direction(first.direction), both))
        elif (
            norm(rejection(first.direction, Z_AXIS)) > near.angle
            or norm(rejection(first.point, Z_AXIS)) > near.length
        ):
            found.append((cylinder(first.point, first.direction), both))
    return found


def _plan(
    chain: Chain, group: Group, starts: tuple[Motion, ...], zero: ZeroRule, near: Nearness, size: float
) -> Plan:
    steps: list[Step] = []
    for axis in chain.axes:
        step = prepare(axis, group, near, size)
        steps.append(step)
        group = step.stabiliser
        if zero is ZeroRule.FIGURE:
            continue
        if axis.prismatic:
            group = with_translations_along(group, axis.direction, near)
        else:
            group = with_rotations_about(group, axis.point, axis.direction)
    return Plan(starts, tuple(steps), group)


def prepare(axis: Axis, group: Group, near: Nearness, size: float) -> Step:
    """Return what is needed to align something with an axis by means of a group."""
    direction = axis.direction
    if axis.prismatic:
        stabiliser = fixing_direction(group, direction, near)
    else:
        stabiliser = fixing_line(group, axis.point, direction, near)
    by_direction = by_moment = 0.0
    moment = ORIGIN
    if group.rotations is Rotations.ABOUT_LINE:
        by_direction = 1.0 if norm(rejection(direction, group.axis)) > near.angle else 0.0
        if not axis.prismatic and (
            not group.translations or (not by_direction and len(group.translations) == 1)
        ):
            moment = cross(subtract(axis.point, group.point), direction)
            by_moment = 1.0 / (size * size) if norm(rejection(moment, group.axis)) > near.length else 0.0
    elif group.rotations is Rotations.ABOUT_POINT and not axis.prismatic and not group.translations:
        moment = cross(subtract(axis.point, group.point), direction)
        by_moment = 1.0 / (size * size) if norm(moment) > near.length else 0.0
    slide = None if axis.prismatic else _slide(group.translations, direction, near)
    return Step(
        axis=axis,
        group=group,
        stabiliser=stabiliser,
        by_direction=by_direction,
        by_moment=by_moment,
        moment=moment,
        slide=slide,
    )


def _slide(basis: tuple[Vector, ...], direction: Vector, near: Nearness) -> tuple[float, ...] | None:
    """The least-squares map from a displacement across a line to a translation in a space."""
    if not basis:
        return None
    found = _across(basis, direction)
    kept = found.stretches > near.slide
    if not kept.any():
        return None
    matrix = found.space @ found.right[kept].T @ np.diag(1.0 / found.stretches[kept]) @ found.left[:, kept].T
    return tuple(matrix.ravel().tolist())


class _Across(NamedTuple):
    """A space of translations, (3, k), and the singular values of its part across a line with its vectors."""

    space: Floats
    left: Floats
    stretches: Floats
    right: Floats


@lru_cache(maxsize=1024)
def _across(basis: tuple[Vector, ...], direction: Vector) -> _Across:
    """What translations do across a line; cached, for it is the same however near counts as parallel."""
    space = np.array(basis).T
    d = np.array(direction)
    return _Across(space, *np.linalg.svd(space - np.outer(d, d @ space), full_matrices=False))
