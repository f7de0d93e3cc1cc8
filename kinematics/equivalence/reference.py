"""A reference table, prepared once for all the submissions that are compared with it."""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from kinematics.caching import USUAL_ROWS, cached_by_size
from kinematics.chain import NO_LENGTH, Chain, chain_of_table, size_of
from kinematics.equivalence.groups import Nearness
from kinematics.equivalence.plan import Plan, plans_for
from kinematics.equivalence.policy import BaseRule, Tolerance, ToolRule, ZeroRule
from kinematics.table import NumericTable

if TYPE_CHECKING:
    from kinematics.equivalence.tools import ToolChoice

SAMPLES = 64  # Configurations: three times the six equations of a pose make up for twelve joints, B and E.
EXACTLY = 1e-9
"""[rad], and a share of the robot: what the arithmetic leaves of axes that are parallel or meet."""
LOOSELY = 2.0  # In units of the tolerance: two axes of a key may each be off by one.
SLIDING = (0.0, 0.4, LOOSELY)
"""In units of the tolerance: displacements that may slide an axis; none, a small one, and that of two
axes."""

_PRIMES = [p for p in range(2, 400) if all(p % k for k in range(2, int(p**0.5) + 1))]


def sample_joints(n: int) -> NDArray[np.float64]:
    """Return the configurations that fill the joint space evenly and lie on no grid.

    A Kronecker sequence in √2, √3, √5, …

    Returns:
        (n, SAMPLES) values in [-1, 1).
    """
    steps = np.sqrt(np.array(_PRIMES[:n], dtype=np.float64))[:, None]
    return np.asarray(2.0 * ((0.5 + steps * np.arange(1, SAMPLES + 1)) % 1.0) - 1.0, dtype=np.float64)


@dataclass(frozen=True, eq=False)
class Reference:
    """A reference table, prepared.

    Attributes:
        chain: its joint axes.
        size: the length that relative lengths refer to; never zero.
        scaleless: all lengths of the table are zero; `size` is 1, or that of the submission beside it.
        samples: (n, samples) configurations, and (samples, 4, 4) the reference's end frame there; None: the
            usual ones, computed when they are asked for. Most references of a wrong answer are never.
        ends: what `tool_choices` has found, with the plan whose identity it stands under.
    """

    table: NumericTable
    chain: Chain
    size: float
    scaleless: bool
    samples: tuple[NDArray[np.float64], NDArray[np.float64]] | None = None
    _plans: dict[tuple[BaseRule, ZeroRule, Nearness], tuple[Plan, ...]] = field(default_factory=dict)
    _nearnesses: dict[Tolerance, tuple[Nearness, ...]] = field(default_factory=dict)
    _levels: dict[tuple[BaseRule, ZeroRule, Tolerance], tuple[int, ...]] = field(default_factory=dict)
    ends: "dict[tuple[int, ToolRule, Nearness], tuple[Plan, tuple[ToolChoice, ...]]]" = field(
        default_factory=dict
    )

    @property
    def joints(self) -> NDArray[np.float64]:
        """(n, samples) sampled configurations."""
        return self._sampled[0]

    @property
    def poses(self) -> NDArray[np.float64]:
        """(samples, 4, 4) the reference's end frame there."""
        return self._sampled[1]

    @cached_property
    def _sampled(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        if self.samples is not None:
            return self.samples
        joints = sample_joints(len(self.chain.axes))
        for i, axis in enumerate(self.chain.axes):
            joints[i] *= self.size if axis.prismatic else np.pi
        return joints, self.chain.poses(joints.T)

    def beside(self, submission: Chain) -> "Reference":
        """Return the reference at the size of a submission, if it has none of its own."""
        if not self.scaleless:
            return self
        size = submission.extent if submission.extent > NO_LENGTH else 1.0
        return Reference(table=self.table, chain=self.chain, size=size, scaleless=True)

    def sampled_at(self, joints: NDArray[np.float64]) -> "Reference":
        """Return the reference with more configurations, (n, k), among the samples."""
        more = np.concatenate([self.joints, joints], axis=1)
        poses = np.concatenate([self.poses, self.chain.poses(joints.T)])
        return replace(self, samples=(more, poses))

    def plans(self, base: BaseRule, zero: ZeroRule, near: Nearness) -> tuple[Plan, ...]:
        """Return the chains of groups, as `plans_for` makes them."""
        key = (base, zero, near)
        found = self._plans.get(key)
        if found is None:
            found = self._plans[key] = plans_for(self.chain, base, zero, near, self.size)
        return found

    def nearnesses(self, tolerance: Tolerance) -> tuple[Nearness, ...]:
        """Return which axes count as parallel or meeting: those that do exactly; those within the tolerance.

        And, for what may slide along them, those so nearly parallel that a displacement within the tolerance,
        or a smaller one, slides it by about the robot's size.
        """
        found = self._nearnesses.get(tolerance)
        if found is None:
            angle, length = LOOSELY * tolerance.angle, LOOSELY * tolerance.length * self.size
            found = self._nearnesses[tolerance] = (
                Nearness(EXACTLY, EXACTLY * self.size, EXACTLY),
                *(Nearness(angle, length, max(angle, share * tolerance.length)) for share in SLIDING),
            )
        return found

    def levels(self, base: BaseRule, zero: ZeroRule, tolerance: Tolerance) -> Iterator[int]:
        """Return the indices in `nearnesses` of the notions that make different chains of groups.

        Only the first of them is needed for most tables, and the others are found when they are asked for.
        """
        yield 0
        yield from self.further_levels(base, zero, tolerance)

    def further_levels(self, base: BaseRule, zero: ZeroRule, tolerance: Tolerance) -> tuple[int, ...]:
        """Return those of the levels that come after the first.

        Where the strictest notion and the loosest make one chain, so do those between them.
        """
        key = (base, zero, tolerance)
        found = self._levels.get(key)
        if found is None:
            shapes: list[list[tuple[object, ...]]] = []
            nearnesses = self.nearnesses(tolerance)
            if self._shapes(base, zero, nearnesses[0]) != self._shapes(base, zero, nearnesses[-1]):
                shapes = [self._shapes(base, zero, near) for near in nearnesses]
            found = self._levels[key] = tuple(
                level for level, shape in enumerate(shapes) if shape not in shapes[:level]
            )[1:]
        return found

    def _shapes(self, base: BaseRule, zero: ZeroRule, near: Nearness) -> list[tuple[object, ...]]:
        return [plan.shape for plan in self.plans(base, zero, near)]


@cached_by_size(lambda table: len(table.rows), longest=USUAL_ROWS, most=1024, few=32)
def prepared(table: NumericTable) -> Reference:
    """Return the reference of a table; cached, for the same one is asked for again and again."""
    chain = chain_of_table(table)
    size = size_of(chain)
    return Reference(table=table, chain=chain, size=size or 1.0, scaleless=size == 0.0)


def prepared_for(key: NumericTable, answer: NumericTable) -> Reference:
    """Return the reference of a key, at the size of an answer if it has none of its own."""
    reference = prepared(key)
    return reference.beside(chain_of_table(answer)) if reference.scaleless else reference
