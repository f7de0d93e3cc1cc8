"""A matrix of expressions, its values, and by how much the decimals in it leave them open."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from exercises.parts.samples import Samples
from kinematics.answers.left_open import EXACT, Rounded, left_open
from kinematics.errors import ParameterError
from kinematics.expressions import Expression, evaluate, parameters_in
from kinematics.expressions.arrays import matrices_at

ALMOST = 1e-6  # A share of a robot's size: what the comparison of an exact product with a chain leaves.


@dataclass(frozen=True)
class SymbolicMatrix:
    """A matrix of expressions.

    Attributes:
        entries: row by row; angles in [rad], lengths in the unit of the answer.
        idle: by row and column the names in a cell that make no difference.
        decimal: rows and columns of the cells that hold numbers which may have been rounded.
        rounded: of entries with names and decimals.
    """

    entries: tuple[tuple[Expression, ...], ...]
    idle: Mapping[tuple[int, int], frozenset[str]] = field(default_factory=dict, compare=False)
    decimal: frozenset[tuple[int, int]] = field(default=frozenset(), compare=False)
    rounded: Rounded = field(default_factory=dict, compare=False)

    def as_typed(self, samples: Samples, size: float) -> NDArray[np.float64]:
        """Return by how much entries may be off for their decimals, (k, 4, 4); infinite if not known."""
        limit = np.full((samples.joints.shape[1], 4, 4), np.inf)
        parameters = samples.parameters(self.names())
        for r, c in self.decimal:
            entry = self.entries[r][c]
            if entry in self.rounded:
                limit[:, r, c] = EXACT * size + left_open(entry, self.rounded, parameters, samples.joints)
        return limit

    def names(self) -> frozenset[str]:
        """Return the parameters in it."""
        return self._names

    @cached_property
    def _names(self) -> frozenset[str]:
        return frozenset().union(*(parameters_in(entry) for row in self.entries for entry in row))

    def typed_share(self, samples: Samples, size: float) -> float:
        """Return by which share of a size lengths may be off for all that is typed in decimals."""
        if not self.decimal:
            return ALMOST
        if any(self.entries[r][c] not in self.rounded for r, c in self.decimal):
            return 1.0
        typed = self.as_typed(samples, size)
        return max(ALMOST, float(typed.max(where=np.isfinite(typed), initial=0.0)) / size)

    def at(self, parameters: Mapping[str, float], joints: Sequence[float]) -> NDArray[np.float64]:
        """Return its values; an entry that has none there (a division by zero) is NaN."""
        return np.array([[_value(entry, parameters, joints) for entry in row] for row in self.entries])

    def at_points(self, samples: Samples) -> NDArray[np.float64]:
        """Return its values at all the points, (k, 4, 4); NaN or infinite where an entry has none."""
        return matrices_at(self.entries, samples.parameters(self.names()), samples.joints)


def _value(entry: Expression, parameters: Mapping[str, float], joints: Sequence[float]) -> float:
    try:
        return evaluate(entry, parameters, joints)
    except ParameterError as error:
        if error.code == "parameter_missing":
            raise
        return float("nan")
