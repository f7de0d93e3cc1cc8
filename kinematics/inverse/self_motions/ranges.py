"""Families of solutions within joint limits: which parts of a path fit, and how they are told."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.distinct import differences
from kinematics.inverse.limits import within_limits
from kinematics.inverse.results import Family, FamilyParameter
from kinematics.inverse.search import Box
from kinematics.inverse.self_motions.families import FamilyPath, Follower
from kinematics.inverse.self_motions.membership import Component

MEMBERS = 13
"""Members of a family that are returned: every 30° of a full turn."""

FINE = 0.05
"""Distance between the points of a path at which limits are looked at [rad, or parts of the size]."""

STRAIGHT = 1e-6
"""A path that is off a straight line by no more than this [rad, or parts of the size] is one."""

HALVINGS = 30
"""Halvings between a point within the limits and one outside: FINE / 2³⁰ is what is left of the interval's
end."""


def families_within(
    arm: Arm, follower: Follower, component: Component, box: Box
) -> list[tuple[Array, Family]]:
    """Return the parts of a family within the limits, each with a member.

    Args:
        arm: the arm.
        follower: of the family's target.
        component: the family.
        box: joint limits.
    """
    q = component.joints
    wrapped, fits = within_limits(q[None], arm.revolute, box, arm.size)
    if not component.paths:
        return [(wrapped[0], Family(dimension=component.dimension))] if fits[0] else []
    if component.dimension > 1 or len(component.paths) > 1:
        if not fits[0]:
            return []
        parameters = [
            told[1].parameters[0]
            for path in component.paths
            for told in [_part_with(arm, follower, path, box, wrapped[0])]
            if told is not None
        ]
        return [(wrapped[0], Family(dimension=component.dimension, parameters=tuple(parameters)))]
    path = component.paths[0]
    if not box.limited:
        return [(wrapped[0], _told_freely(arm, path, box, wrapped[0]))]
    parts = _parts(arm, follower, path, box)
    return [_with_member(arm, points, closed, wrapped[0]) for points, closed in parts]


def _part_with(
    arm: Arm, follower: Follower, path: FamilyPath, box: Box, q: Array
) -> tuple[Array, Family] | None:
    """The part of a path within the limits that holds a configuration."""
    if not box.limited:
        return q, _told_freely(arm, path, box, q)
    parts = [_with_member(arm, points, closed, q) for points, closed in _parts(arm, follower, path, box)]
    return min(parts, key=lambda part: float(np.abs(part[0] - q).sum()), default=None)


def _with_member(arm: Arm, points: Array, closed: bool, q: Array) -> tuple[Array, Family]:
    """A part told, with the given member if it is on it, else its middle one."""
    apart = np.abs((points - q) / arm.units).max(axis=1)
    member = q if float(apart.min()) <= FINE else points[len(points) // 2]
    return member, _told(arm, points, closed, member)


def _told(arm: Arm, points: Array, closed: bool, q: Array) -> Family:
    """A path as a family: its parameter is the first joint that moves farthest without turning back."""
    moved = np.diff(points, axis=0) / arm.units
    last = differences(points[0], points[-1], arm) if closed else np.zeros(points.shape[1])
    moved = np.vstack((moved, last))
    way = np.abs(moved).sum(axis=0)
    one_way = np.abs(moved.sum(axis=0)) >= way - 1e-6
    joint = int(np.where(one_way, way + 1e3 * (way > 0.1 * way.max()), way).round(6).argmax())
    winds = closed and abs(float(moved[:, joint].sum())) > math.pi
    least, greatest = float(points[:, joint].min()), float(points[:, joint].max())
    turns = 2.0 * math.pi * round((q[joint] - _nearest(points[:, joint], q[joint])) / (2.0 * math.pi))
    if winds:
        least, greatest = -math.pi, math.pi
    elif arm.revolute[joint]:
        least, greatest = least + turns, greatest + turns
    direction = _direction(points / arm.units, joint)
    chosen = points[np.linspace(0, len(points) - 1, min(MEMBERS, len(points))).round().astype(int)]
    return Family(
        dimension=1,
        parameters=(FamilyParameter(joint=joint + 1, least=least, greatest=greatest, full_turn=winds),),
        direction=None if direction is None else tuple((direction * arm.units / arm.units[joint]).tolist()),
        members=tuple(map(tuple, chosen.tolist())),
    )


def _told_freely(arm: Arm, path: FamilyPath, box: Box, q: Array) -> Family:
    """A path without limits as a family, its members by turns in (-π, π]."""
    family = _told(arm, path.points, path.closed, q)
    members, _ = within_limits(np.array(family.members), arm.revolute, box, arm.size)
    return replace(family, members=tuple(map(tuple, members.tolist())))


def _nearest(values: Array, value: float) -> float:
    """Of values the one that is nearest to another, turns not counted."""
    off = np.abs((values - value + math.pi) % (2.0 * math.pi) - math.pi)
    return float(values[int(off.argmin())])


def _direction(x: Array, joint: int) -> Array | None:
    """Of a straight path its direction, the parameter's part being 1; else None."""
    way = x[-1] - x[0]
    if abs(float(way[joint])) < 1e-6:
        return None
    direction = way / way[joint]
    off = x - x[0] - (x[:, joint] - x[0, joint])[:, None] * direction
    if float(np.abs(off).max()) > STRAIGHT:
        return None
    small = np.abs(direction) < STRAIGHT
    return np.asarray(
        np.where(
            small, 0.0, np.where(np.abs(np.abs(direction) - 1.0) < STRAIGHT, np.sign(direction), direction)
        )
    )


def _parts(arm: Arm, follower: Follower, path: FamilyPath, box: Box) -> list[tuple[Array, bool]]:
    """The parts of a path within the limits, turns brought into them."""
    points = _finer(arm, follower, path)
    wrapped, fits = within_limits(points, arm.revolute, box, arm.size)
    jump = np.abs((np.diff(wrapped, axis=0) - np.diff(points, axis=0)) / arm.units).max(axis=1) > 1e-3
    if fits.all() and not jump.any():
        return [(wrapped, path.closed)]
    parts: list[tuple[Array, bool]] = []
    start = 0
    breaks = [*(np.flatnonzero(jump | ~fits[:-1] | ~fits[1:]) + 1).tolist(), len(points)]
    for end in breaks:
        if fits[start] and end > start:
            run = [*wrapped[start:end]]
            if start > 0:
                run.insert(0, _end(arm, follower, box, points[start], points[start - 1], wrapped[start]))
            if end < len(points):
                run.append(_end(arm, follower, box, points[end - 1], points[end], wrapped[end - 1]))
            parts.append((np.array(run), False))
        start = end
    return _joined_round(path, wrapped, parts)


def _joined_round(
    path: FamilyPath, wrapped: Array, parts: list[tuple[Array, bool]]
) -> list[tuple[Array, bool]]:
    """Of a closed path whose first and last part are one, both put together."""
    if not path.closed or len(parts) < 2:
        return parts
    first, last = parts[0][0], parts[-1][0]
    if np.array_equal(first[0], wrapped[0]) and np.array_equal(last[-1], wrapped[-1]):
        return [*parts[1:-1], (np.vstack((last, first[1:])), False)]
    return parts


def _end(arm: Arm, follower: Follower, box: Box, inside: Array, outside: Array, wrapped: Array) -> Array:
    """The last point within the limits on the way from one inside to one outside."""
    near, far = 0.0, 1.0
    way = outside - inside
    best = wrapped
    for _ in range(HALVINGS):
        middle = 0.5 * (near + far)
        there, fits = within_limits((inside + middle * way)[None], arm.revolute, box, arm.size)
        if fits[0] and float(np.abs((there[0] - wrapped - middle * way) / arm.units).max()) < 1e-3:
            near, best = middle, there[0]
        else:
            far = middle
    unit = way / arm.units
    corrected, e, _ = follower.corrected(best / arm.units, (unit / np.linalg.norm(unit))[None])
    low_enough, fits = within_limits((corrected * arm.units)[None], arm.revolute, box, arm.size)
    return np.asarray(low_enough[0] if fits[0] and follower.reached(e) else best)


def _finer(arm: Arm, follower: Follower, path: FamilyPath) -> Array:
    """The path with points no farther apart than FINE, those between corrected."""
    x = path.points / arm.units
    if path.closed:
        x = np.vstack((x, x[-1] + differences(path.points[0], path.points[-1], arm)))
    ways = np.diff(x, axis=0)
    lengths = np.linalg.norm(ways, axis=1)
    counts = np.ceil(lengths / FINE).astype(int)
    chords = np.repeat(np.arange(len(ways)), np.maximum(counts - 1, 0))
    if not len(chords):
        return np.asarray(x * arm.units)
    parts = np.concatenate([np.arange(1, count) / count for count in counts])[:, None]
    between = x[chords] + parts * ways[chords]
    between, _, _ = follower.corrected_all(between, (ways / lengths[:, None])[chords][:, None])
    return np.asarray(np.insert(x, chords + 1, between, axis=0) * arm.units)
