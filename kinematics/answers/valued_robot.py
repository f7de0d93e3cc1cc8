"""A robot in symbols, with values of its names."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from kinematics.chain import Chain, chain_of_table, size_of
from kinematics.table import SymbolicTable, bind


@dataclass(frozen=True, kw_only=True, eq=False)
class ValuedRobot:
    """A robot in symbols, and in numbers.

    Attributes:
        table: its table.
        values: of every name in it [the table's length, or rad].
    """

    table: SymbolicTable
    values: Mapping[str, float]

    @cached_property
    def chain(self) -> Chain:
        """The chain at these values."""
        return chain_of_table(bind(self.table, self.values))

    @cached_property
    def size(self) -> float:
        """Typical length of the robot."""
        return size_of(self.chain) or 1.0
