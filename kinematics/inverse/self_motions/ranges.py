"""Families of solutions within joint limits: which parts of a path fit, and how they are told."""

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.distinct import differences
from kinematics.inverse.limits import ON_LIMIT, within_limits
from kinematics.inverse.residuals import are_solutions, errors_at
from kinematics.inverse.results import Family, FamilyParameter
from kinematics.inverse.search import Box
from kinematics.inverse.self_motions.families import FamilyPath, Follower
from kinematics.inverse.self_motions.membership import Component

MEMBERS = 13  # Members of a family that are returned: every 30° of a full turn.

FINE = 0.05
"""Distance between the points of a path at which limits are looked at [rad, or parts of the size]."""

STRAIGHT = 1e-6
"""A path that is off a straight line by no more than this [rad, or parts of the size] may be one."""

ON_LINE = 3.0
"""It is one if the target is missed by no more tolerances all along it. A wrist that is off its line by one
tolerance at a member, and reaches the target there, misses it by two on the other side."""


def families_within(
    arm: Arm, follower: Follower, component: Component, box: Box
) -> list[tuple[Array, Family]]:
    """Return the parts of a family within the limits, each with a member."""
    q = component.joints
    wrapped, fits = within_limits(q[None], arm.revolute, box, arm.size)
    if not component.paths:
        return [(wrapped[0], Family(dimension=component.dimension))] if fits[0] else []
    if component.dimension > 1 or len(component.paths) > 1:
        if not fits[0]:
            return []
        pivots = component.pivots or (None,) * len(component.paths)
        parameters = [
            told[1].parameters[0]
            for path, pivot in zip(component.paths, pivots, strict=True)
            for told in [_part_with(arm, follower, path, box, wrapped[0], pivot)]
            if told is not None
        ]
        return [(wrapped[0], Family(dimension=component.dimension, parameters=tuple(parameters)))]
    path = component.paths[0]
    if not box.limited:
        return [(wrapped[0], _told_freely(arm, follower, path, box, wrapped[0]))]
    # A member beyond the limits was put on them, where it misses the target; each part has one of its own.
    return [
        _with_member(arm, follower, box, points, closed, wrapped[0] if fits[0] else points[len(points) // 2])
        for points, closed in _parts_within(arm, follower, path, box)
    ]


def _part_with(
    arm: Arm, follower: Follower, path: FamilyPath, box: Box, q: Array, pivot: int | None
) -> tuple[Array, Family] | None:
    """The part of a path within the limits that holds a configuration."""
    if not box.limited:
        return q, _told_freely(arm, follower, path, box, q, pivot)
    within = _parts_within(arm, follower, path, box)
    parts = [_with_member(arm, follower, box, points, closed, q, pivot) for points, closed in within]
    return min(parts, key=lambda part: float(np.abs(part[0] - q).sum()), default=None)


def _with_member(
    arm: Arm, follower: Follower, box: Box, points: Array, closed: bool, q: Array, pivot: int | None = None
) -> tuple[Array, Family]:
    """A part told, with the given member if it is on it, else its middle one."""
    apart = np.abs(differences(points, q, arm)).max(axis=1)
    nearest = points[int(apart.argmin())]
    member = points[len(points) // 2]
    if float(apart.min()) <= FINE:
        member = np.clip(_turned_to(nearest, q, arm), box.low, box.high)
    if not closed:
        return member, _told(arm, follower, points, closed, member, pivot)
    (member,), _ = within_limits(member[None], arm.revolute, box, arm.size)
    path = FamilyPath(points, closed, np.empty(0))
    return member, _told_freely(arm, follower, path, box, member, pivot)


def _told(
    arm: Arm, follower: Follower, points: Array, closed: bool, q: Array, pivot: int | None = None
) -> Family:
    """A path as a family: its parameter is the first joint that moves farthest without turning back.

    Of a surface it is the joint that rests along the other paths, if it does not turn back.
    """
    moved = np.diff(points, axis=0) / arm.units
    last = differences(points[0], points[-1], arm) if closed else np.zeros(points.shape[1])
    moved = np.vstack((moved, last))
    way = np.abs(moved).sum(axis=0)
    one_way = np.abs(moved.sum(axis=0)) >= way - 1e-6
    joint = int(np.where(one_way, way + 1e3 * (way > 0.1 * way.max()), way).round(6).argmax())
    if pivot is not None and one_way[pivot] and way[pivot] > 0.1 * way.max():
        joint = pivot
    winds = closed and abs(float(moved[:, joint].sum())) > math.pi
    least, greatest = float(points[:, joint].min()), float(points[:, joint].max())
    turns = 2.0 * math.pi * round((q[joint] - _nearest(points[:, joint], q[joint])) / (2.0 * math.pi))
    if winds:
        least, greatest = -math.pi, math.pi
    elif arm.revolute[joint]:
        least, greatest = least + turns, greatest + turns
    direction = _direction(points / arm.units, joint)
    if direction is not None:
        direction = direction * arm.units / arm.units[joint]
        line = q + (np.linspace(least, greatest, MEMBERS) - q[joint])[:, None] * direction
        errors = errors_at(arm, line, follower.target)
        if not are_solutions(errors, arm, ON_LINE * follower.tolerance).all():
            direction = None
    chosen = points[np.linspace(0, len(points) - 1, min(MEMBERS, len(points))).round().astype(int)]
    return Family(
        dimension=1,
        parameters=(FamilyParameter(joint=joint + 1, least=least, greatest=greatest, full_turn=winds),),
        direction=None if direction is None else tuple(direction.tolist()),
        members=tuple(map(tuple, chosen.tolist())),
    )


def _told_freely(
    arm: Arm, follower: Follower, path: FamilyPath, box: Box, q: Array, pivot: int | None = None
) -> Family:
    """A path that no limit cuts as a family, each member by turns within the limits, the nearest to zero."""
    family = _told(arm, follower, path.points, path.closed, q, pivot)
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


def _parts_within(arm: Arm, follower: Follower, path: FamilyPath, box: Box) -> list[tuple[Array, bool]]:
    """The parts of a path within the limits, turns brought into them.

    A joint that may turn right round cuts nothing, unless a part takes it farther than its range is wide.
    """
    points = _finer(arm, follower, path)
    freely = _Limits(arm, box, arm.revolute & (box.high - box.low >= 2.0 * np.pi))
    parts = _parts(follower, path, points, freely)
    moved = [(points if closed else freely.moved_into(points), closed) for points, closed in parts]
    found = [(points, closed) for points, closed in moved if points is not None]
    if len(found) == len(parts):
        return found
    return _parts(follower, path, points, _Limits(arm, box, np.zeros(arm.n_joints, dtype=bool)))


class _Limits:
    """Joint limits, some of which leave room for a whole turn and are not kept on the way."""

    def __init__(self, arm: Arm, box: Box, whole: NDArray[np.bool_]) -> None:
        self.arm, self._box, self._whole = arm, box, whole
        self.kept = Box(np.where(whole, -np.inf, box.low), np.where(whole, np.inf, box.high))

    def within(self, points: Array) -> tuple[Array, NDArray[np.bool_]]:
        """Return (m, n) points of a path by turns within the limits that are kept, and (m,) which fit.

        One follows the other without a turn between as long as the limits let it.
        """
        wrapped, fits = within_limits(points, self.arm.revolute, self.kept, self.arm.size)
        wrapped[:, self._whole] = points[:, self._whole]
        for k in np.flatnonzero(np.isfinite(self.kept.high - self.kept.low) & self.arm.revolute).tolist():
            low, high = self.kept.low[k], self.kept.high[k]
            for i in range(1, len(points) if high - low >= 2.0 * np.pi else 0):
                onward = wrapped[i - 1, k] + points[i, k] - points[i - 1, k]
                wrapped[i, k] = onward if low <= onward <= high else wrapped[i, k]
        return wrapped, fits

    def moved_into(self, points: Array) -> Array | None:
        """Return a part moved into all limits, each joint by turns; None if a joint goes too far."""
        least, greatest = points.min(axis=0), points.max(axis=0)
        first = np.ceil((self._box.low - least) / (2.0 * np.pi) - ON_LIMIT)
        last = np.floor((self._box.high - greatest) / (2.0 * np.pi) + ON_LIMIT)
        turns = np.where(
            self._whole, np.clip(np.round(-0.5 * (least + greatest) / (2.0 * np.pi)), first, last), 0.0
        )
        if (self._whole & (first > last)).any():
            return None
        return np.asarray(np.clip(points + 2.0 * np.pi * turns, self._box.low, self._box.high))


def _parts(follower: Follower, path: FamilyPath, points: Array, limits: _Limits) -> list[tuple[Array, bool]]:
    """The parts of a path within the limits that are kept."""
    wrapped, fits = limits.within(points)
    breaks = _breaks(limits.arm, points, wrapped, fits)
    if not breaks:
        return [(wrapped, path.closed)] if fits.all() else []
    if path.closed:
        off = [k for k in breaks if not (fits[k - 1] and fits[k])]
        points = _opened(points, min(off or breaks))
        wrapped, fits = limits.within(points)
        ends = [1, *(k for k in _breaks(limits.arm, points, wrapped, fits) if 1 < k < len(points) - 1)]
        ends.append(len(points) - 1)
    else:
        ends = [0, *breaks, len(points)]
    parts: list[tuple[Array, bool]] = []
    for start, end in pairwise(ends):
        if fits[start]:
            run = [*wrapped[start:end]]
            first = last = None
            if start > 0:
                first = _end(follower, limits, points[start], points[start - 1], wrapped[start])
                if first is None and parts and fits[start - 1]:
                    first = _turned_to(wrapped[start], parts[-1][0][-1], limits.arm)
            if end < len(points):
                last = _end(follower, limits, points[end - 1], points[end], wrapped[end - 1])
            parts.append((np.array([one for one in (first, *run, last) if one is not None]), False))
    return parts


def _turned_to(near: Array, q: Array, arm: Arm) -> Array:
    """A configuration by the turns that bring it nearest to another."""
    turns = 2.0 * np.pi * np.round((near - q) / (2.0 * np.pi))
    return np.asarray(q + np.where(arm.revolute, turns, 0.0))


def _breaks(arm: Arm, points: Array, wrapped: Array, fits: NDArray[np.bool_]) -> list[int]:
    """The points that are not reached from the one before without leaving the limits."""
    jump = np.abs((np.diff(wrapped, axis=0) - np.diff(points, axis=0)) / arm.units).max(axis=1) > 1e-3
    found: list[int] = (np.flatnonzero(jump | ~fits[:-1] | ~fits[1:]) + 1).tolist()
    return found


def _opened(points: Array, k: int) -> Array:
    """A closed path, whose last point is its first one some turns on, from before point k to behind it."""
    turns = points[-1] - points[0]
    return np.vstack((points[k - 1 : -1], points[:k] + turns, points[k] + turns))


def _end(follower: Follower, limits: _Limits, inside: Array, outside: Array, wrapped: Array) -> Array | None:
    """The last point within the limits on the way from one inside to one outside; None if none is between.

    The joint that reaches its limit first is held there, and the others are corrected.

    Args:
        follower: of the path's target.
        limits: the limits.
        inside: a point of the path within them.
        outside: the next one, which is not, or is so by another turn.
        wrapped: the first one by turns within the limits.
    """
    units, way = limits.arm.units, outside - inside
    bound = np.where(way > 0.0, limits.kept.high, limits.kept.low)
    with np.errstate(divide="ignore", invalid="ignore"):
        parts = np.where(way == 0.0, np.inf, (bound - wrapped) / way)
    joint = int(parts.argmin())
    if parts[joint] > 1.0:
        return None
    best = wrapped + max(float(parts[joint]), 0.0) * way
    best[joint] = bound[joint]
    corrected, e, _ = follower.corrected(best / units, np.eye(len(units))[joint][None])
    end = corrected * units
    slack = ON_LIMIT * units
    fits = (limits.kept.low - slack <= end) & (end <= limits.kept.high + slack)
    is_near = float(np.abs((end - wrapped) / units).max()) <= 2.0 * FINE
    return np.asarray(end if fits.all() and is_near and follower.reached(e) else wrapped)


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
