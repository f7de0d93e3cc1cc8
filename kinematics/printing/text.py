"""Infix text that the cell grammar reads back."""

from __future__ import annotations

from collections.abc import Sequence

from kinematics.expressions import Call, Function
from kinematics.printing.infix import InfixWriter, Spelling, infix_power
from kinematics.printing.ledger import Ledger
from kinematics.printing.notation import Names
from kinematics.printing.writer import Binding, WrittenTerm

_SPELLING = Spelling(
    functions={function: function.value for function in Function},
    variable="q{}".format,
    power=infix_power("^"),
)


class TextWriter(InfixWriter):
    """Writes infix text.

    In full notation every entry is an expression of the cell grammar. In short notation c23 stands for
    cos(q2 + q3); the difference of two joints has no unambiguous short name on one line and is written out.
    """

    def __init__(self, names: Names, ledger: Ledger | None = None) -> None:
        super().__init__(_SPELLING, ledger)
        self._names = names

    def _variable(self, index: int) -> str:
        return self._names.variable(index)

    def _call(self, node: Call, arguments: Sequence[WrittenTerm]) -> WrittenTerm:
        short = self._names.short(node)
        if short is not None and short.is_sum:
            return WrittenTerm(short.word, Binding.ATOM)
        return super()._call(node, arguments)


def text_writer(names: Names) -> TextWriter:
    """A writer of infix text."""
    return TextWriter(names)
