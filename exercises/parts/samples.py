"""Points at which functions of the joint variables and of the dimensions are compared."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

Points: TypeAlias = tuple[Mapping[str, float], NDArray[np.float64]]
"""Values of all parameters, and (k, n) joint values beside them."""


@dataclass(frozen=True, eq=False)
class Samples:
    """Sets of values, each with joint values beside it.

    Attributes:
        points: at least one set.
    """

    points: tuple[Points, ...]

    @cached_property
    def counts(self) -> list[int]:
        """How many joint values stand beside each set."""
        return [len(joints) for _, joints in self.points]

    @cached_property
    def joints(self) -> NDArray[np.float64]:
        """(n, k) all joint values."""
        return np.ascontiguousarray(np.concatenate([joints for _, joints in self.points]).T)

    def parameters(self, names: Iterable[str]) -> dict[str, NDArray[np.float64]]:
        """Return the values of some parameters beside these joint values, (k,)."""
        for name in names:
            if name not in self._parameters:
                values = [values[name] for values, _ in self.points]
                self._parameters[name] = np.repeat(values, self.counts)
        return self._parameters

    @cached_property
    def _parameters(self) -> dict[str, NDArray[np.float64]]:
        return {}

    @cached_property
    def first(self) -> "Samples":
        """The first set alone."""
        return Samples(self.points[:1])

    @cached_property
    def but_last(self) -> "Samples":
        """All sets but the last one."""
        return Samples(self.points[:-1])

    @cached_property
    def at_zero(self) -> "Samples":
        """The same sets with joint values of zero."""
        return Samples(tuple((values, np.zeros_like(joints)) for values, joints in self.points))
