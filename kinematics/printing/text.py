"""Infix text that the cell grammar reads back."""

from __future__ import annotations

from fractions import Fraction

from kinematics.expressions import Expression, Function
from kinematics.printing.infix import Binding, InfixWriter, Spelling, Written
from kinematics.printing.notation import Names

_FUNCTIONS = {function: function.value for function in Function}


def text_writer(names: Names) -> InfixWriter:
    """A writer of infix text.

    In full notation every entry is an expression of the cell grammar. In short notation c23 stands for
    cos(q2 + q3); the difference of two joints has no unambiguous short name on one line and is written out.
    """

    def name(node: Expression) -> str | None:
        short = names.short(node)
        return short.word if short is not None and short.is_sum else None

    spelling = Spelling(functions=_FUNCTIONS, variable="q{}".format, parameter=str, power=_power)
    return InfixWriter(spelling, name)


def _power(base: Written, exponent: Fraction) -> Written:
    if exponent == Fraction(1, 2):
        return Written(f"sqrt({base.text})", Binding.ATOM)
    power = str(exponent) if exponent.denominator == 1 else f"({exponent})"
    return Written(f"{base.within(Binding.ATOM)}^{power}", Binding.POWER)
