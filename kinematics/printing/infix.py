"""Expressions on one line: a2*c2 + a3*c23, in the spelling of a language."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from kinematics.expressions import Call, Function
from kinematics.printing.ledger import Ledger, Quotient
from kinematics.printing.writer import Binding, LineWriter, WrittenTerm


@dataclass(frozen=True, kw_only=True, slots=True)
class Spelling:
    """How a language writes what expressions are made of.

    Attributes:
        pi: the number π.
        whole: an integer, given its digits.
        functions: names of the functions.
        variable: a joint variable, given its number.
        power: base ** exponent, for an exponent that is neither 1 nor 1/2, given the base as it stands alone
            and as it stands before an operator.
    """

    pi: str = "pi"
    whole: Callable[[str], str] = str
    functions: Mapping[Function, str]
    variable: Callable[[int], str]
    power: Callable[[str, str, Fraction], WrittenTerm]


class InfixWriter(LineWriter):
    """Writes expressions in one spelling."""

    plus, minus = " + ", " - "

    def __init__(self, spelling: Spelling, ledger: Ledger | None = None) -> None:
        super().__init__(ledger)
        self.spelling = spelling

    def _call(self, node: Call, arguments: Sequence[WrittenTerm]) -> WrittenTerm:
        inner = ", ".join(map(self._signed, arguments))
        return WrittenTerm(f"{self.spelling.functions[node.function]}({inner})", Binding.ATOM)

    def _raised(self, base: int, exponent: Fraction) -> WrittenTerm:
        written, spelling = self._written[base], self.spelling
        if exponent == 1:
            return written
        if exponent == Fraction(1, 2):
            return WrittenTerm(f"{spelling.functions[Function.SQRT]}({self._signed(written)})", Binding.ATOM)
        return spelling.power(self._signed(written), self._within(written, Binding.ATOM), exponent)

    def _quotient(self, quotient: Quotient) -> WrittenTerm:
        weight, whole = quotient.weight, self.spelling.whole
        above = [self._written[factor] for factor in quotient.typed]
        numerator = [self._within(factor, Binding.PRODUCT) for factor in above]
        if weight.digits:
            numerator.insert(0, weight.decimal or whole(weight.digits))
        denominator = [whole(weight.denominator)] if weight.denominator else []
        if quotient.below:
            below = [self._raised(base, exponent) for base, exponent in quotient.below]
            denominator += [self._within(divisor, Binding.POWER) for divisor in below]
        text = "*".join(numerator) or whole("1")
        if denominator:
            under = denominator[0] if len(denominator) == 1 else f"({'*'.join(denominator)})"
            return WrittenTerm(f"{text}/{under}", Binding.PRODUCT, weight.negative)
        if len(numerator) > 1:
            return WrittenTerm(text, Binding.PRODUCT, weight.negative)
        return WrittenTerm(text, above[0].binding if above else Binding.ATOM, weight.negative)

    def _parameter(self, name: str) -> str:
        return name

    def _variable(self, index: int) -> str:
        return self.spelling.variable(index)

    def _pi(self) -> str:
        return self.spelling.pi


def infix_power(operator: str) -> Callable[[str, str, Fraction], WrittenTerm]:
    """base^2, base^(1/3)."""

    def power(_: str, base: str, exponent: Fraction) -> WrittenTerm:
        written = str(exponent) if exponent.denominator == 1 else f"({exponent})"
        return WrittenTerm(f"{base}{operator}{written}", Binding.POWER)

    return power
