"""Infix text that the cell grammar reads back: a2*c2 + a3*c23."""

from collections.abc import Sequence
from fractions import Fraction

from kinematics.expressions import Call, Function
from kinematics.printing.ledger import Quotient
from kinematics.printing.writer import Binding, LineWriter, WrittenTerm


class TextWriter(LineWriter):
    """Writes infix text.

    In full notation every entry is an expression of the cell grammar. In short notation c23 stands for
    cos(q2 + q3); the difference of two joints has no unambiguous short name on one line and is written out.
    """

    plus, minus = " + ", " - "

    def _call(self, node: Call, arguments: Sequence[WrittenTerm]) -> WrittenTerm:
        short = self._names.short(node)
        if short is not None and short.is_sum:
            return WrittenTerm(short.word, Binding.ATOM)
        inner = ", ".join(map(self._signed, arguments))
        return WrittenTerm(f"{node.function.value}({inner})", Binding.ATOM)

    def _raised(self, base: int, exponent: Fraction) -> WrittenTerm:
        written = self._written[base]
        if exponent == 1:
            return written
        if exponent == Fraction(1, 2):
            return WrittenTerm(f"{Function.SQRT.value}({self._signed(written)})", Binding.ATOM)
        power = str(exponent) if exponent.denominator == 1 else f"({exponent})"
        return WrittenTerm(f"{self._within(written, Binding.ATOM)}^{power}", Binding.POWER)

    def _quotient(self, quotient: Quotient) -> WrittenTerm:
        weight = quotient.weight
        above = [self._written[factor] for factor in quotient.typed]
        numerator = [self._within(factor, Binding.PRODUCT) for factor in above]
        if weight.digits:
            numerator.insert(0, weight.decimal or weight.digits)
        denominator = [weight.denominator] if weight.denominator else []
        if quotient.below:
            below = [self._raised(base, exponent) for base, exponent in quotient.below]
            denominator += [self._within(divisor, Binding.POWER) for divisor in below]
        text = "*".join(numerator) or "1"
        if denominator:
            under = denominator[0] if len(denominator) == 1 else f"({'*'.join(denominator)})"
            return WrittenTerm(f"{text}/{under}", Binding.PRODUCT, weight.negative)
        if len(numerator) > 1:
            return WrittenTerm(text, Binding.PRODUCT, weight.negative)
        return WrittenTerm(text, above[0].binding if above else Binding.ATOM, weight.negative)

    def _parameter(self, name: str) -> str:
        return name
