"""Families of solutions: configurations joined by a path on which the target stays reached.

A target is known to within a tolerance, so its solutions are the components of
{q : the pose at q is within the tolerance of the target}. Most components are tiny balls around one solution.
Where the Jacobian loses rank they may be long: a whole turn of q_4 against q_6 at a wrist in line, a shorter
interval beside it. Such a component is followed in small steps from one of its members, every step
corrected by Gauss–Newton steps across it, until the pose leaves the tolerance or the path closes (`paths`).
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.distinct import shorter_way
from kinematics.inverse.residuals import are_solutions, errors_and_jacobians
from kinematics.inverse.self_motions.corrections import corrected

FARTHEST = 10.0  # Slides without end are followed for ten times the arm's size and the target's distance.

LOST = 1e-6
"""Second singular values below this, or the root of the tolerance, are as good as zero: within a tolerance ε
families join that are some √ε apart."""

TOGETHER = 1e-12  # Solutions this near [rad, or parts of the size] are one.

AT_REST = 1e-3  # Parts of a direction up to this [rad, or parts of the size] leave a joint at rest.

MOST_CORRECTIONS = 2600
"""Corrections after which a target's families are followed no further; the longest paths take 800 more. A
PUMA with its arm stretched and its wrist in line takes 95, eight families of seven joints up to this many."""

ROWS = 16
"""Configurations that are corrected together in some twice the time of one: so many count as another one."""


@dataclass(frozen=True, slots=True)
class FamilyPath:
    """A component followed from one member.

    Attributes:
        points: (k, n) configurations along it in order, turns not brought into any range; slides in m.
        closed: whether the last point leads back to the first.
        second: (k,) the second least singular value of the Jacobian at each: where it vanishes another family
            crosses.
    """

    points: Array
    closed: bool
    second: Array


def null_space(J: Array, smallest: float) -> Array:
    """Return the (k, n) directions that a Jacobian does not see, singular values up to `smallest`.

    They come in echelon form, which keeps apart what is independent: in a PUMA stretched upwards, the
    turns of joints 1, 4 and 6 against each other from the bending of the elbow.
    """
    _, values, rows = np.linalg.svd(J)
    seen = int((values > smallest).sum())
    basis = rows[seen:].copy()
    pivots: list[int] = []
    for i in range(len(basis)):
        rest = np.abs(basis[i:])
        rest[:, pivots] = 0.0
        row, column = np.unravel_index(int(rest.argmax()), rest.shape)
        swap = [i, i + int(row)]
        basis[swap] = basis[swap[::-1]]
        basis[i] /= basis[i, column]
        others = [k for k in range(len(basis)) if k != i]
        basis[others] -= basis[others, column, None] * basis[i]
        pivots.append(int(column))
    return np.asarray(basis / np.linalg.norm(basis, axis=1, keepdims=True))


def weighing_alike(arm: Arm) -> Arm:
    """Return the arm with its lengths in the unit of a tolerance, of which there are as many as radians."""
    return replace(arm, size=1.0) if arm.size > 1.0 else arm


class Follower:
    """Follows components of one target.

    Joint values are measured in the arm's units here: x = q / units.
    """

    def __init__(self, arm: Arm, target: Array, tolerance: float, as_it_is: bool = False) -> None:
        self.arm = arm if as_it_is else weighing_alike(arm)
        self.target, self.tolerance = target, tolerance
        self.lost = max(LOST, math.sqrt(tolerance))
        self.spent = 0
        self.farthest = FARTHEST * (1.0 + float(np.linalg.norm(target[:3, 3])) / self.arm.sliding)

    def count(self, rows: int) -> None:
        """Count one correction of a number of configurations."""
        self.spent += 1 + rows // ROWS

    @property
    def is_spent(self) -> bool:
        """Whether all corrections that are allowed have been made."""
        return self.spent >= MOST_CORRECTIONS

    def reached(self, e: Array) -> bool:
        """Return whether an error vector is within the tolerance."""
        return bool(are_solutions(e[None], self.arm, self.tolerance)[0])

    def corrected(self, x: Array, held: Array) -> tuple[Array, Array, Array]:
        """Return x, error vector and Jacobian at the nearest pose with the same held·x; held is (k, n)."""
        found, e, J = self.corrected_all(x[None], held[None])
        return found[0], e[0], J[0]

    def corrected_all(self, x: Array, held: Array) -> tuple[Array, Array, Array]:
        """Return the same for many configurations, (m, n), each with its own held rows, (m, k, n)."""
        self.count(len(x))
        return corrected(self.arm, self.target, x, held)

    def moves(self, x: Array, direction: Array, step: float) -> Array | None:
        """Return x after a step along a direction, corrected across it; None if the target is lost."""
        return self.moves_each(x, step * direction[None])[0]

    def moves_each(self, x: Array, ways: Array) -> list[Array | None]:
        """Return x after each of several steps, (m, n), corrected across it; None if the target is lost.

        Of two directions that the Jacobian hardly sees, a correction may lead far off along the other for
        what is a part of the tolerance: then a step is taken as it is.
        """
        if not len(ways):
            return []
        lengths = np.linalg.norm(ways, axis=1)
        moved, e, _ = self.corrected_all(x + ways, (ways / lengths[:, None])[:, None])
        near = np.linalg.norm(moved - x - ways, axis=1) <= lengths
        there = near & are_solutions(e, self.arm, self.tolerance)
        if not there.all():
            straight, _ = errors_and_jacobians(self.arm, x + ways, self.target)
            as_it_is = ~there & are_solutions(straight, self.arm, self.tolerance)
            moved, there = np.where(as_it_is[:, None], x + ways, moved), there | as_it_is
        return [one if ok else None for one, ok in zip(moved, there.tolist(), strict=True)]

    def joined(self, x: Array, other: Array) -> bool:
        """Return whether the straight way between two solutions keeps the target, corrected across or not.

        Where the arm is singular twice, a correction may lead far off along the other direction.
        """
        return bool(self.joined_each(x[None], other[None])[0])

    def joined_each(self, x: Array, others: Array) -> NDArray[np.bool_]:
        """Return the same as `joined` for many pairs, (m, n) and (m, n)."""
        ways = others - x
        lengths = np.linalg.norm(ways, axis=1)
        apart = np.flatnonzero(lengths >= TOGETHER)
        if not len(apart):
            return np.ones(len(x), dtype=bool)
        parts = np.repeat(((0.25,), (0.5,), (0.75,)), len(apart), axis=0)
        asked = np.tile(apart, 3)
        start = x[asked] + parts * ways[asked]
        between, e, _ = self.corrected_all(
            start, (ways / np.maximum(lengths, TOGETHER)[:, None])[asked][:, None]
        )
        near = np.linalg.norm(between - start, axis=1) <= 0.5 * lengths[asked]
        off = ~(near & are_solutions(e, self.arm, self.tolerance))
        if off.any():
            straight, _ = errors_and_jacobians(self.arm, start[off], self.target)
            off[off] = ~are_solutions(straight, self.arm, self.tolerance)
        kept = np.ones(len(x), dtype=bool)
        kept[asked[off]] = False
        return kept

    def jacobian(self, x: Array) -> Array:
        """Return the (6, n) Jacobian in units."""
        return np.asarray(self.jacobians(x[None])[0])

    def jacobians(self, x: Array) -> Array:
        """Return the (m, 6, n) Jacobians in units, at x, (m, n)."""
        return np.asarray(self.arm.jacobians(self.arm.frames(x * self.arm.units)) * self.arm.units)

    def second(self, x: Array) -> Array:
        """Return the second smallest singular value of each Jacobian, (m,); 0 for what no row sees."""
        values = np.linalg.svd(self.jacobians(x), compute_uv=False)
        place = self.arm.n_joints - 2
        return np.asarray(values[:, place] if 0 <= place < values.shape[1] else np.zeros(len(x)))

    def back_to(self, start: Array, x: Array) -> Array:
        """Return the way from x to the start, turns on the circle."""
        return shorter_way(start - x, self.arm.revolute)


def nearest_on(arm: Arm, path: FamilyPath, q: Array) -> tuple[Array, Array]:
    """Return the way from a path's nearest chord to a configuration, and that chord; both in units.

    Of several configurations, (m, n), it returns (m, n) of each.
    """
    points = path.points / arm.units
    way = np.diff(points, axis=0)
    if path.closed:
        way = np.vstack((way, shorter_way(points[0] - points[-1], arm.revolute)))
    start = points[: len(way)] if len(way) else points
    way = way if len(way) else np.zeros_like(points)
    # Each joint by the turn that is nearest to the middle of the chord.
    off = shorter_way((q / arm.units)[..., None, :] - start - 0.5 * way, arm.revolute) + 0.5 * way
    square = np.maximum((way * way).sum(axis=1), 1e-300)
    part = np.clip((off * way).sum(axis=-1) / square, 0.0, 1.0)
    off -= part[..., None] * way
    k = (off * off).sum(axis=-1).argmin(axis=-1)
    return np.take_along_axis(off, k[..., None, None], axis=-2)[..., 0, :], way[k]


def pivots_of(directions: Array) -> Sequence[int]:
    """Return for each direction the joint that moves most along it, those at rest along the others first."""
    moved = np.abs(directions)
    chosen: list[int] = []
    for k, row in enumerate(moved):
        others = np.delete(moved, k, axis=0).max(axis=0, initial=0.0)
        alone = np.where((others <= AT_REST) & (row > AT_REST), 1.0, 0.0)
        order = [int(i) for i in np.argsort(-(row + alone), kind="stable") if int(i) not in chosen]
        chosen.append(order[0])
    return chosen
