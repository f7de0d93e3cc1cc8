"""Where an arm loses a motion, in numbers: its families of singularities, and points of them.

Zeros of a function are looked for along lines through the joint space, so that each branch is met several
times.
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from kinematics.answers.form_samples import ValuedRobot
from kinematics.answers.unit_multiples import FamilyProducts
from kinematics.expressions import Expression
from kinematics.expressions.arrays import values_at
from kinematics.se3 import Floats
from kinematics.symbolic.determinants import MotionRows, minor_factors
from kinematics.table import JointType, SymbolicTable

LINES, STEPS, POINTS = 32, 240, 16  # Lines, steps along each, and how many zeros are kept of a function.
HALVINGS = 45  # Halvings of a step: to a double's last digits.
LOST = 1e-6
"""Share of the usual value below which the smallest singular value, or a condition, counts as zero: zeros are
found to 1e-9 and better."""
ROUNDED = 5e-4
"""Share of its usual value below which a condition with numbers rounded to four digits counts as zero; with
fewer digits, what their rounding leaves open."""


@dataclass(frozen=True, kw_only=True, eq=False)
class SingularArm(ValuedRobot):
    """Where an arm is singular.

    Attributes:
        rows: which motion counts.
    """

    rows: MotionRows

    @property
    def whole(self) -> bool:
        """Whether the families are all there is: the arm has one largest minor."""
        return minor_factors(self.table, self.rows)[1]

    @cached_property
    def families(self) -> tuple[Expression, ...]:
        """The irreducible factors that vanish in some configuration, where the arm then is singular."""
        return tuple(factor for factor, _ in self._found)

    @cached_property
    def products(self) -> FamilyProducts:
        """Their products."""
        return FamilyProducts(self.families)

    @cached_property
    def witnesses(self) -> tuple[Floats, ...]:
        """(n, k) configurations of each family."""
        return tuple(points for _, points in self._found)

    @cached_property
    def _found(self) -> list[tuple[Expression, Floats]]:
        found = []
        for factor in minor_factors(self.table, self.rows)[0]:
            points = self.zeros(factor)
            if points.shape[1] and (self.lost(points) <= LOST).all():
                found.append((factor, points))
        return found

    def lost(self, joints: Floats) -> Floats:
        """Return the smallest singular value that is not always zero, relative, of (n, k) configurations."""
        values = self._singular_values(joints.T)
        rank = len(self.usual)
        return np.asarray(values[:, rank - 1] / self.usual[-1]) if rank else np.ones(joints.shape[1])

    @cached_property
    def usual(self) -> Floats:
        """The medians of the singular values that are not always zero."""
        values = np.median(self._singular_values(self.lines[0].T), axis=0)
        return np.asarray(values[values > 1e-9 * values.max(initial=0.0)])

    def _singular_values(self, joints: Floats) -> Floats:
        J = self.chain.jacobian(joints) * self.units
        J[:, :3] /= self.size
        return np.asarray(np.linalg.svd(J if self.rows is MotionRows.TWIST else J[:, :3], compute_uv=False))

    @cached_property
    def units(self) -> Floats:
        """(n,) a radian, or the arm's size for a slide."""
        return np.where(np.array([axis.prismatic for axis in self.chain.axes], dtype=bool), self.size, 1.0)

    @cached_property
    def moving(self) -> NDArray[np.bool_]:
        """(6,) which components of the twist are not always zero."""
        found: NDArray[np.bool_] = (
            np.abs(self.chain.jacobian(self.lines[0].T)).max(axis=(0, 2)) > LOST * self.size
        )
        return found

    @cached_property
    def lines(self) -> tuple[Floats, Floats]:
        """Starting points and directions of lines through the joint space, (n, LINES) each."""
        n = self.table.n_joints
        rng = np.random.default_rng(5)
        slides = np.array([[kind is JointType.PRISMATIC] for kind in self.table.joint_types])
        reach = np.where(slides, self.size, np.pi)
        return rng.uniform(-1.0, 1.0, (n, LINES)) * reach, rng.uniform(-1.0, 1.0, (n, LINES)) * reach

    @cached_property
    def grid(self) -> Floats:
        """(n, LINES·(STEPS + 1)) points along the lines."""
        start, way = self.lines
        along = np.linspace(-2.0, 2.0, STEPS + 1)
        return (start[:, :, None] + way[:, :, None] * along).reshape(len(start), -1)

    def values_of(self, function: Expression, joints: Floats) -> Floats:
        """Return the values of a function at (n, k) configurations."""
        return values_at(function, self.values, joints)

    @np.errstate(all="ignore")
    def zeros(self, function: Expression) -> Floats:
        """Return some configurations where a function vanishes, (n, k): it crosses or touches zero there."""
        start, way = self.lines
        along = np.linspace(-2.0, 2.0, STEPS + 1)
        values = self.values_of(function, self.grid).reshape(LINES, -1)
        scale = typical(values) or 1.0
        crossing = np.argwhere(values[:, :-1] * values[:, 1:] < 0.0)
        low = np.abs(values)
        touching = np.argwhere(
            (low[:, 1:-1] <= low[:, :-2]) & (low[:, 1:-1] < low[:, 2:]) & (low[:, 1:-1] < 0.05 * scale)
        )
        found = [
            self._refined(function, start, way, along, _spread(crossing), crossed=True),
            self._refined(function, start, way, along, _spread(touching), crossed=False),
        ]
        points = np.hstack(found)
        small = np.abs(self.values_of(function, points)) <= 1e-6 * scale
        return points[:, small][:, :POINTS]

    def _refined(
        self,
        function: Expression,
        start: Floats,
        way: Floats,
        along: Floats,
        places: NDArray[np.int64],
        *,
        crossed: bool,
    ) -> Floats:
        lines, steps = places[:, 0], places[:, 1]
        low, high = along[steps], along[steps + (1 if crossed else 2)]

        def at(t: Floats) -> Floats:
            return start[:, lines] + way[:, lines] * t

        def value(t: Floats) -> Floats:
            return self.values_of(function, at(t))

        if not len(places):
            return np.empty((len(start), 0))
        first = value(low)
        for _ in range(HALVINGS):
            middle = 0.5 * (low + high)
            if crossed:
                same = value(middle) * first > 0.0
                low, high = np.where(same, middle, low), np.where(same, high, middle)
            else:
                third = (high - low) / 3.0
                left = np.abs(value(low + third)) < np.abs(value(high - third))
                low, high = np.where(left, low, low + third), np.where(left, high - third, high)
        return at(0.5 * (low + high))

    def other(self) -> "SingularArm":
        """Return the same arm with other lengths, no two of them equal: what was longer stays longer."""
        rng = np.random.default_rng(11)
        names = sorted(self.values, key=self.values.__getitem__)
        lengths = np.sort(self.size * rng.uniform(0.3, 1.2, len(names))).tolist()
        return arm_of(self.table, self.rows, tuple(sorted(zip(names, lengths, strict=True))))


@lru_cache(maxsize=128)
def arm_of(table: SymbolicTable, rows: MotionRows, values: tuple[tuple[str, float], ...]) -> SingularArm:
    """Return an arm; what is known of its singularities is kept."""
    return SingularArm(table=table, rows=rows, values=dict(values))


def typical(values: Floats) -> float:
    """Return the median size of what has a value; 0 if nothing has one."""
    finite = values[np.isfinite(values)]
    return float(np.median(np.abs(finite))) if len(finite) else 0.0


def _spread(places: NDArray[np.int64]) -> NDArray[np.int64]:
    """Return at most so many places as are needed, from all over the lines."""
    if len(places) <= 2 * POINTS:
        return places
    return places[np.linspace(0, len(places) - 1, 2 * POINTS).astype(np.int64)]
