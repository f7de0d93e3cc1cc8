"""Solutions as components: which are the same, which stand alone, and which families there are."""

from collections.abc import Iterator, Sequence
from typing import TypeAlias

import numpy as np

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.self_motions.crossings import branches, is_beside, tangents
from kinematics.inverse.self_motions.families import (
    FamilyPath,
    Follower,
    null_space,
    pivots_of,
)
from kinematics.inverse.self_motions.gaps import nearest_places, way_through_gaps
from kinematics.inverse.self_motions.isolation import LONG, fold_length, lost_value, told_apart
from kinematics.inverse.self_motions.membership import Component, Membership
from kinematics.inverse.self_motions.paths import path_through
from kinematics.inverse.self_motions.weights import follower_at, weighed_otherwise

_Start: TypeAlias = tuple[Array, Array]
"""A configuration from which a path is to be followed, in units, and the direction."""

GAP = 4.0 / LONG
"""Tolerances by which the pose may be off in a gap between pieces of a family: an error that grows from zero
to one tolerance over LONG / 2 or more is a wave of 2 / LONG tolerances at most; twice as much is allowed."""

MOST_MEMBERS = 64
"""Solutions that are looked at of an arm with two or more redundant joints: each of some ten families, four
in general, has several."""

BESIDE_A_CROSSING = 0.3
"""Step from a crossing [rad, or parts of the size] after which one of the families is alone."""

BESIDE_A_BRANCH = 0.25
"""What is nearer than this part of a step to a path, a step from where it crosses another, is on it."""

MOST_FOLLOWED = 16
MOST_FOLLOWED_IF_REDUNDANT = 8
"""Families that are followed for one target, of arms with redundant joints fewer: each takes longer. What is
left over is returned as members of continua."""


def components_of(arm: Arm, target: Array, joints: Array, tolerance: float) -> list[Component]:
    """Return the components that solutions belong to, each once."""
    alone, delicate = told_apart(arm, target, joints, tolerance)
    found = [Component(joints[i]) for i in alone]
    if delicate:
        follower = follower_at(arm, target, tolerance, joints[delicate[0]])
        found += _Sorter(arm, follower).sorted(joints[delicate])
    return found


def belongs(arm: Arm, target: Array, component: Component, q: Array, tolerance: float) -> bool:
    """Return whether a solution belongs to a component."""
    return Membership(arm, Follower(arm, target, tolerance), tolerance).within(component, q)


class _Sorter:
    """Sorts solutions near singularities, or with redundant joints, into components."""

    def __init__(self, arm: Arm, follower: Follower) -> None:
        tolerance = follower.tolerance
        self.arm, self.follower = arm, follower
        self.long = fold_length(tolerance)
        self.lost = lost_value(tolerance)
        self.members = Membership(arm, follower, tolerance)
        self.most = MOST_FOLLOWED_IF_REDUNDANT if arm.redundancy else MOST_FOLLOWED
        self.ways: list[FamilyPath] = []

    def sorted(self, joints: Array) -> list[Component]:
        left = joints if self.arm.redundancy < 2 else joints[:MOST_MEMBERS]
        found: list[Component] = []
        followed = 0
        while len(left):
            q, left = left[0], left[1:]
            J = self.follower.jacobian(q / self.arm.units)
            null = null_space(J, self.lost)
            if followed < self.most and not self.follower.is_spent:
                new = self._components(q, null)
            else:
                new = [Component(q, dimension=self._dimension(q, null))]
            followed += sum(bool(one.paths) for one in new)
            left = self.members.outside(left, new)
            found += new
            if behind := self._behind_gaps(new):
                left = np.concatenate((left, self.members.outside(np.array(behind), found)))
        return self._whole(found)

    def _whole(self, found: list[Component]) -> list[Component]:
        """Components without families that are parts of others."""
        kept = dict(enumerate(found))
        lines = [k for k, one in kept.items() if one.dimension == 1 and one.paths]
        for k in lines:
            if any(i != k and i in kept and self.members.is_part(found[k], found[i]) for i in lines):
                del kept[k]
        return list(kept.values())

    def _behind_gaps(self, components: Sequence[Component]) -> list[Array]:
        """Members of families that lie on the ways of others, behind gaps in which the target is lost."""
        found: list[Array] = []
        for one in components:
            if one.dimension != 1 or self.arm.redundancy or self.follower.is_spent:
                continue
            q = one.joints
            x = q / self.arm.units
            for path in one.paths:
                if path.closed or any(is_beside(self.follower, way, x, self.long) for way in self.ways):
                    continue
                self.ways.append(way_through_gaps(self.follower, q, path, GAP))
                found += nearest_places(self.follower, self.ways[-1])
        return found

    def _dimension(self, q: Array, null: Array) -> int:
        """Of how many dimensions the component of a solution is that is not followed."""
        x = q / self.arm.units
        moving = [] if self.arm.redundancy else [d for d in null if self._moves(x, d)]
        crossed = not self.arm.redundancy and not moving and len(null) > 1
        return self.arm.redundancy or len(moving) if not crossed else 1

    def _components(self, q: Array, null: Array) -> list[Component]:
        """The components through a solution: several where families cross."""
        x = q / self.arm.units
        moving = [d for d in null if self._moves(x, d)]
        if self.arm.redundancy > 1 or not (moving or len(null) > 1):
            return [self._one_family(q, null, moving)]
        if len(moving) > 1 and self._spanned(x, moving):
            return [self._surface(x, moving)]
        surfaces = [] if len(moving) < 2 else self._surfaces_beside(x, moving)
        curves = [
            path for path in self._curves(x, null) if not any(self._holds(one, path) for one in surfaces)
        ]
        curves = self._with_branches(curves, surfaces)
        members = [q, *(path.points[len(path.points) // 4] for path in curves[1:])]
        found = [Component(member, (path,), 1) for member, path in zip(members, curves, strict=False)]
        return [*surfaces, *found] or [self._one_family(q, null, moving=())]

    def _one_family(self, q: Array, null: Array, moving: Sequence[Array]) -> Component:
        """The family of a solution, as a whole; where it is short all round the solution stands alone."""
        redundancy, x = self.arm.redundancy, q / self.arm.units
        if moving or not redundancy:
            return Component(q, dimension=self._freedoms(x, moving) if moving else 0)
        long = self._long_paths(self.follower, q, null)
        weighed = None if long else weighed_otherwise(self.arm, self.follower, q)
        if weighed is not None:
            x = q / weighed.arm.units
            long = self._long_paths(weighed, q, null_space(weighed.jacobian(x), self.lost))
            self.follower.spent += weighed.spent
        return Component(q, tuple(long), redundancy if long else 0)

    def _long_paths(self, follower: Follower, q: Array, null: Array) -> list[FamilyPath]:
        x = q / follower.arm.units
        paths = (path_through(follower, x, d) for d in null)
        return [path for path in paths if self._is_long(path)]

    def _freedoms(self, x: Array, moving: Sequence[Array]) -> int:
        """In how many dimensions a solution can be moved.

        Where the Jacobian has lost rank for this solution alone, as of links folded on a line, its family has
        no more dimensions than those beside it: so many dimensions the null space has there.
        """
        if len(moving) <= self.arm.redundancy:
            return self.arm.redundancy
        beside = [there for d in moving if (there := self._moved(x, d)) is not None]
        return max(len(null_space(self.follower.jacobian(there), self.lost)) for there in beside)

    def _surface(self, x: Array, moving: Sequence[Array]) -> Component:
        """The family of as many dimensions as a solution can be moved in."""
        return self._with_paths(x, moving, tuple(self._paths_of_surface(x, moving)))

    def _with_paths(self, x: Array, moving: Sequence[Array], paths: tuple[FamilyPath, ...]) -> Component:
        return Component(x * self.arm.units, paths, len(moving), tuple(pivots_of(np.array(moving))))

    def _wide_surface(self, x: Array, moving: Sequence[Array]) -> Component | None:
        """The same, if it is more than the width that a tolerance gives to families where they cross."""
        paths: list[FamilyPath] = []
        for path in self._paths_of_surface(x, moving):
            if np.ptp(path.points / self.arm.units, axis=0).max() <= BESIDE_A_CROSSING:
                return None
            paths.append(path)
        return self._with_paths(x, moving, tuple(paths))

    def _on_a_surface(self, x: Array, fewer: int) -> list[Array]:
        """Directions of the surface that a solution is on; none if it has `fewer` dimensions or more."""
        null = null_space(self.follower.jacobian(x), self.lost)
        if not 1 < len(null) < fewer:
            return []
        moving = [d for d in null if self._moves(x, d)]
        return moving if len(moving) > 1 and self._spanned(x, moving) else []

    def _curves(self, x: Array, null: Array) -> list[FamilyPath]:
        """Paths through a solution, each once."""
        found: list[FamilyPath] = []
        for direction in tangents(self.follower, x, null, self.lost):
            moved = self._moved(x, direction)
            near = BESIDE_A_BRANCH * self.long
            if moved is None or any(is_beside(self.follower, one, moved, near) for one in found):
                continue
            path = path_through(self.follower, x, direction)
            if self._is_long(path):
                found.append(path)
        return found

    def _spanned(self, x: Array, moving: Sequence[Array]) -> bool:
        """Whether a solution can be moved along the sums and differences of directions too."""
        return all(
            self._moves(x, (one + sign * other) / np.linalg.norm(one + sign * other))
            for k, one in enumerate(moving)
            for other in moving[:k]
            for sign in (1.0, -1.0)
        )

    def _surfaces_beside(self, x: Array, moving: Sequence[Array]) -> list[Component]:
        """Surfaces that meet where families cross, told from a point beside the crossing."""
        found: list[Component] = []
        for direction in moving:
            for step in (BESIDE_A_CROSSING, -BESIDE_A_CROSSING):
                there = self.follower.moves(x, direction, step)
                if there is None or any(self.members.within(one, there * self.arm.units) for one in found):
                    continue
                directions = self._on_a_surface(there, fewer=len(moving))
                if directions:
                    found.append(self._surface(there, directions))
        return found

    def _holds(self, surface: Component, path: FamilyPath) -> bool:
        """Whether a path lies in a surface, as far as some of its points tell."""
        return all(self.members.within(surface, q) for q in path.points[:: max(len(path.points) // 3, 1)])

    def _with_branches(self, curves: list[FamilyPath], surfaces: list[Component]) -> list[FamilyPath]:
        """Paths, and those that cross them, and those that cross these; surfaces that do are added."""
        found = list(curves)
        for path in found:
            if self.follower.is_spent:
                return found
            starts = self._elsewhere([*branches(self.follower, path, self.long, self.lost)], found, surfaces)
            while starts:
                (x, way), *starts = starts
                directions = self._on_a_surface(x, fewer=self.arm.n_joints)
                surface = self._wide_surface(x, directions) if directions else None
                if surface is not None:
                    surfaces.append(surface)
                    starts = self._elsewhere(starts, (), (surface,))
                    continue
                branch = path_through(self.follower, x, way)
                if self._is_long(branch):
                    found.append(branch)
                    starts = self._elsewhere(starts, (branch,), ())
                if len(found) + len(surfaces) >= self.most:
                    return found
        return found

    def _elsewhere(
        self, starts: list[_Start], paths: Sequence[FamilyPath], surfaces: Sequence[Component]
    ) -> list[_Start]:
        """Those of some starts that are neither beside paths nor on surfaces, all asked together."""
        near = BESIDE_A_BRANCH * self.long
        left = [one for one in starts if not any(is_beside(self.follower, p, one[0], near) for p in paths)]
        for surface in surfaces:
            if left:
                inside = self.members.within_each(surface, np.array([x for x, _ in left]) * self.arm.units)
                left = [one for one, within in zip(left, inside.tolist(), strict=True) if not within]
        return left

    def _is_long(self, path: FamilyPath) -> bool:
        """Whether a path leads farther than across a fold."""
        x = path.points / self.arm.units
        return float(np.abs(x - x[0]).max()) > 0.5 * self.long

    def _moves(self, x: Array, direction: Array) -> bool:
        return self._moved(x, direction) is not None

    def _moved(self, x: Array, direction: Array) -> Array | None:
        both = self.follower.moves_each(x, self.long * np.array((direction, -direction)))
        return next((there for there in both if there is not None), None)

    def _paths_of_surface(self, x: Array, directions: Sequence[Array]) -> Iterator[FamilyPath]:
        """Along each direction, the joints that move most along the others held."""
        held = np.eye(len(x))[pivots_of(np.array(directions))]
        for k, direction in enumerate(directions):
            yield path_through(self.follower, x, direction, np.delete(held, k, axis=0))
