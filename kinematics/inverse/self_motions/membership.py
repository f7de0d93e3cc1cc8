"""Which solutions belong to a family: they are on its paths, or ways lead from them to it."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.distinct import SAME, differences, shorter_way
from kinematics.inverse.residuals import are_solutions
from kinematics.inverse.self_motions.families import FamilyPath, Follower, nearest_on
from kinematics.inverse.self_motions.isolation import ACROSS_A_FOLD, fold_length, lost_value
from kinematics.inverse.self_motions.walks import lead_to_one

BESIDE = 1e-3
"""A solution this near to a path [rad, or parts of the size], or within twenty tolerances of it, is on it."""

CHORD = 0.05
"""Distance from the chords of a path within which a solution may be on it: the chords are LONGEST_STEP
long and turn by three times STRAIGHT at most."""

STATIONS = 5
"""Points of each path of a surface that ways are looked for to: a way that leads to one may miss another."""

NEAREST = 6
"""Members of a surface to which ways are looked for from a solution: the nearest of those found last."""


@dataclass(frozen=True, slots=True)
class Component:
    """One answer: a solution that stands alone, or a family.

    Attributes:
        joints: (n,) its most exact member.
        paths: one path for each direction of a family that was followed; empty of an isolated solution.
        dimension: 0 of an isolated solution.
        pivots: of a surface the joints that tell its members apart.
    """

    joints: Array
    paths: tuple[FamilyPath, ...] = ()
    dimension: int = 0
    pivots: tuple[int, ...] = ()


class Membership:
    """Tells of the solutions for one target whether they belong to components."""

    def __init__(self, arm: Arm, follower: Follower, tolerance: float) -> None:
        self._arm, self._follower = arm, follower
        self._long = fold_length(tolerance)
        self._tolerance = tolerance
        self._lost = lost_value(tolerance)
        self._beside = max(BESIDE, 20.0 * tolerance)

    def within(self, component: Component, q: Array) -> bool:
        """Return whether a solution belongs to a component."""
        return bool(self.within_each(component, q[None])[0])

    def is_part(self, family: Component, other: Component) -> bool:
        """Return whether the paths of a family lie on those of another, as far as some of their points tell.

        Both have been followed. One that was followed from one side may have ended where it crosses others;
        the way from another member leads across, and all along it.
        """
        points = [path.points[:: max(len(path.points) // STATIONS, 1)] for path in family.paths]
        ends = [path.points[-1:] for path in family.paths]
        joints = np.concatenate(points + ends)
        return bool(np.any([self._on(path, joints) for path in other.paths], axis=0).all())

    def outside(self, joints: Array, components: Sequence[Component]) -> Array:
        """Return those of (m, n) solutions that belong to none of the components."""
        left = joints
        for one in components:
            inside = self.within_each(one, left) if len(left) else np.empty(0, dtype=bool)
            new, left = left[inside], left[~inside]
            while one.dimension > 1 and len(new) and len(left):
                inside = self._led(left, self._nearest(new, left))
                new, left = left[inside], left[~inside]
        return left

    def _nearest(self, members: Array, joints: Array) -> Array:
        """(k, m, n) the members of a family, in units, that are nearest to each of (m, n) solutions."""
        apart = np.abs(differences(joints[:, None], members[None], self._arm)).sum(axis=2)
        nearest = np.argsort(apart, axis=1, kind="stable")[:, :NEAREST].T
        return np.asarray(members[nearest] / self._arm.units)

    def within_each(self, component: Component, joints: Array) -> NDArray[np.bool_]:
        """Return which of some solutions, (m, n), belong to a component."""
        apart = differences(joints, component.joints, self._arm)
        farthest = np.abs(apart).max(axis=1)
        inside = farthest <= SAME
        for path in component.paths:
            inside[~inside] = self._on(path, joints[~inside])
        x = component.joints / self._arm.units
        near = np.flatnonzero(~inside & (farthest <= self._long))
        if self._arm.redundancy and not component.dimension:
            inside[near] = True
            return np.asarray(inside)
        inside[near] = self._follower.joined_each(np.broadcast_to(x, apart[near].shape), x + apart[near])
        if not component.dimension:
            short = ACROSS_A_FOLD * math.sqrt(self._tolerance)
            beside = np.flatnonzero(~inside & (farthest <= short))
            if len(beside):
                inside[beside] = self._are_singular(np.vstack((component.joints, joints[beside])))[1:]
        inside |= self._on_torus(component, apart)
        outside = np.flatnonzero(~inside)
        if component.dimension > min(self._arm.redundancy, 1) and len(outside):
            inside[outside] = self._led(joints[outside], self._places(component, joints[outside]))
        return np.asarray(inside)

    def _on_torus(self, component: Component, apart: Array) -> NDArray[np.bool_]:
        """Which solutions are on a surface of which every path is a straight line that closes.

        So it is where an arm is stretched, and joints turn against each other.
        """
        if not component.pivots or not all(path.closed for path in component.paths):
            return np.zeros(len(apart), dtype=bool)
        units, revolute = self._arm.units, self._arm.revolute
        on = apart.copy()
        for path, pivot in zip(component.paths, component.pivots, strict=True):
            way = (path.points - path.points[0]) / units
            along = way[-1] / way[-1, pivot]
            if float(np.abs(way - way[:, pivot, None] * along).max()) > self._beside:
                return np.zeros(len(apart), dtype=bool)
            on -= apart[:, pivot, None] * along
        return np.asarray(np.abs(shorter_way(on, revolute)).max(axis=1) <= self._beside)

    def _are_singular(self, joints: Array) -> NDArray[np.bool_]:
        """Which of (m, n) solutions are singular to within the tolerance, if the first one is; else none.

        Of two roots beside a fold, whose curvature is 1/8 or more, that is so only nearer than 16 tolerances:
        what is farther apart is one piece of a family, met twice at the edge of the tolerance.
        """
        values = np.linalg.svd(self._follower.jacobians(joints / self._arm.units), compute_uv=False)[:, -1]
        singular = values <= self._tolerance
        return np.asarray(singular & singular[0])

    def _places(self, component: Component, joints: Array) -> Array:
        """(k, m, n) members of a family, in units, to which ways from (m, n) solutions are looked for."""
        x = joints / self._arm.units
        places = [np.broadcast_to(component.joints / self._arm.units, x.shape)]
        for path in component.paths:
            places.append(x - nearest_on(self._arm, path, joints)[0])
            if component.dimension > 1:
                points = path.points[:: max(len(path.points) // STATIONS, 1)] / self._arm.units
                places += [np.broadcast_to(point, x.shape) for point in points]
        return np.array(places)

    def _led(self, joints: Array, places: Array) -> NDArray[np.bool_]:
        """Which of (m, n) solutions steps in the null space lead from, to one of (k, m, n) places."""
        if self._follower.is_spent:
            return np.zeros(len(joints), dtype=bool)
        return lead_to_one(self._follower, joints / self._arm.units, places, self._lost)

    def _on(self, path: FamilyPath, joints: Array) -> NDArray[np.bool_]:
        """Which of (m, n) solutions are on a path: their nearest chords, corrected, lead to them."""
        off, chord = nearest_on(self._arm, path, joints)
        distance, length = np.linalg.norm(off, axis=1), np.linalg.norm(chord, axis=1)
        on = distance <= self._beside
        near = np.flatnonzero(~on & (length > 0.0) & (distance <= CHORD))
        if not len(near):
            return np.asarray(on)
        x = joints[near] / self._arm.units
        start = x - off[near]
        corrected, e, _ = self._follower.corrected_all(start, (chord / length[:, None])[near][:, None])
        beside = np.linalg.norm(corrected - x, axis=1) <= self._beside
        on[near] = beside & are_solutions(e, self._follower.arm, self._follower.tolerance)
        left = ~on[near]
        if left.any():
            on[near[left]] = self._follower.joined_each(x[left], start[left])
        return np.asarray(on)
