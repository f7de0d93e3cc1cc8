"""MathML that browsers draw and screen readers speak.

Each matrix is presentation markup (what is drawn and, in today's browsers and screen readers, spoken) with
the same matrix as content markup in an annotation. Minus signs are U+2212; products and function applications
carry the invisible operators U+2062 and U+2061, so that a reader says "c 1 times" and "cosine of" and not a
run of letters. The content markup never abbreviates: where c23 is drawn it says cos(q2 + q3).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple
from xml.sax.saxutils import escape

from kinematics.expressions import (
    Call,
    Expression,
    Function,
    JointVariable,
    Number,
    Parameter,
    Pi,
    Power,
    Product,
    Sum,
)
from kinematics.printing.content import ContentWriter
from kinematics.printing.infix import Binding
from kinematics.printing.notation import Names
from kinematics.printing.numbers import decimal_text
from kinematics.printing.products import sorted_factors
from kinematics.printing.symbols import split_name
from kinematics.symbolic.size import bottom_up

_TIMES = "<mo>\u2062</mo>"
_APPLY = "<mo>\u2061</mo>"
_MINUS = "<mo>−</mo>"
_PLUS = "<mo>+</mo>"
_NAMESPACE = "http://www.w3.org/1998/Math/MathML"
_FUNCTIONS = {
    Function.SIN: "sin",
    Function.COS: "cos",
    Function.TAN: "tan",
    Function.ASIN: "arcsin",
    Function.ACOS: "arccos",
    Function.ATAN: "arctan",
    Function.ATAN2: "atan2",
}


class Markup(NamedTuple):
    """Presentation markup of an expression without its sign, and whether that is a minus."""

    body: str
    binding: Binding
    negative: bool = False

    @property
    def signed(self) -> str:
        """The markup with its sign."""
        return f"<mrow>{_MINUS}{self.body}</mrow>" if self.negative else self.body

    def within(self, binding: Binding) -> str:
        """The markup with its sign, in parentheses unless it binds at least so strongly."""
        if self.negative or self.binding < binding:
            return f"<mrow><mo>(</mo>{self.signed}<mo>)</mo></mrow>"
        return self.body


class MathmlWriter:
    """Writes expressions in MathML; what has been written once is remembered."""

    def __init__(self, names: Names) -> None:
        self._names = names
        self._content = ContentWriter()
        self._written: dict[int, Markup] = {}
        self._kept: list[Expression] = []

    def matrix(self, matrix: Sequence[Sequence[Expression]]) -> str:
        """A matrix in square brackets, as one `math` element."""
        rows = "".join(
            f"<mtr>{''.join(f'<mtd>{self.presentation(entry)}</mtd>' for entry in row)}</mtr>"
            for row in matrix
        )
        drawn = f"<mrow><mo>[</mo><mtable>{rows}</mtable><mo>]</mo></mrow>"
        meant = self._content.matrix(matrix)
        return (
            f'<math xmlns="{_NAMESPACE}" display="block"><semantics>{drawn}'
            f'<annotation-xml encoding="MathML-Content">{meant}</annotation-xml></semantics></math>'
        )

    def presentation(self, expression: Expression) -> str:
        """Presentation markup of one expression."""
        known = self._written.get(id(expression))
        if known is None:
            self._kept.append(expression)
            for node in bottom_up((expression,), self._written):
                self._written[id(node)] = self._node(node)
            known = self._written[id(expression)]
        return known.signed

    def _node(self, node: Expression) -> Markup:
        short = self._names.short(node)
        if short is not None:
            index = short.index
            script = f"<mn>{index}</mn>" if index.isdigit() else f"<mtext>{index}</mtext>"
            return Markup(f"<msub><mi>{short.letter}</mi>{script}</msub>", Binding.ATOM)
        match node:
            case Product(factors):
                return self._product(factors)
            case Sum(terms):
                return self._sum(terms)
            case Call(function, arguments):
                return self._call(function, [self._written[id(argument)] for argument in arguments])
            case Number(value):
                return _fraction(value)
            case Parameter(name):
                return Markup(_parameter(name), Binding.ATOM)
            case JointVariable(joint):
                return Markup(f"<msub><mi>q</mi><mn>{joint}</mn></msub>", Binding.ATOM)
            case Pi():
                return Markup("<mi>π</mi>", Binding.ATOM)
            case Power(base, exponent):
                if exponent < 0:
                    return _fraction(Fraction(1), below=[self._raised(base, -exponent)])
                return self._raised(base, exponent)

    def _call(self, function: Function, arguments: Sequence[Markup]) -> Markup:
        inner = "<mo>,</mo>".join(argument.signed for argument in arguments)
        if function is Function.SQRT:
            return Markup(f"<msqrt>{inner}</msqrt>", Binding.ATOM)
        if function is Function.ABS:
            return Markup(f"<mrow><mo>|</mo>{inner}<mo>|</mo></mrow>", Binding.ATOM)
        name = f"<mi>{_FUNCTIONS[function]}</mi>"
        return Markup(f"<mrow>{name}{_APPLY}<mrow><mo>(</mo>{inner}<mo>)</mo></mrow></mrow>", Binding.ATOM)

    def _raised(self, base: Expression, exponent: Fraction) -> Markup:
        written = self._written[id(base)]
        if exponent == 1:
            return written
        if exponent == Fraction(1, 2):
            return Markup(f"<msqrt>{written.signed}</msqrt>", Binding.ATOM)
        power = _fraction(exponent).signed
        return Markup(f"<msup>{written.within(Binding.ATOM)}{power}</msup>", Binding.POWER)

    def _sum(self, terms: Sequence[Expression]) -> Markup:
        parts: list[str] = []
        for term in terms:
            written = self._written[id(term)]
            if written.negative:
                parts.append(_MINUS)
            elif parts:
                parts.append(_PLUS)
            parts.append(written.body)
        return Markup(f"<mrow>{''.join(parts)}</mrow>", Binding.SUM)

    def _product(self, factors: Sequence[Expression]) -> Markup:
        parts = sorted_factors(factors)
        return _fraction(
            parts.weight,
            [self._written[id(factor)] for factor in parts.constants],
            [self._written[id(factor)] for factor in parts.above],
            [self._raised(base, exponent) for base, exponent in parts.below],
        )


def _parameter(name: str) -> str:
    word, script, greek = split_name(name)
    letter = f"<mi>{escape(greek or word)}</mi>"
    if not script:
        return letter
    kind = "mn" if script.isdigit() else "mi"
    return f"<msub>{letter}<{kind}>{escape(script)}</{kind}></msub>"


def _fraction(
    weight: Fraction,
    constants: Sequence[Markup] = (),
    above: Sequence[Markup] = (),
    below: Sequence[Markup] = (),
) -> Markup:
    """A product with its numbers and roots in one fraction: (√3/2) c1."""
    size, negative = abs(weight), weight < 0
    decimal = decimal_text(size)
    divided = decimal is None and size.denominator != 1
    weakest = Binding.SUM if len(below) == 1 and not divided else Binding.PRODUCT
    denominator = [factor.within(weakest) for factor in below]
    if divided:
        denominator.insert(0, f"<mn>{size.denominator}</mn>")
    head = [f"<mn>{decimal or size.numerator}</mn>"] if decimal or size.numerator != 1 else []
    head += [factor.within(Binding.PRODUCT) for factor in constants]
    tail = [factor.within(Binding.PRODUCT) for factor in above]
    if below or (denominator and not head and len(tail) == 1 and above[0].binding >= Binding.POWER):
        head, tail = head + tail, []
    if denominator:
        head = [f"<mfrac>{_multiplied(head)}{_multiplied(denominator)}</mfrac>"]
    if len(head) + len(tail) != 1:
        return Markup(_multiplied(head + tail), Binding.PRODUCT if head or tail else Binding.ATOM, negative)
    if denominator:
        return Markup(head[0], Binding.PRODUCT, negative)
    alone = (*constants, *above)
    return Markup((head + tail)[0], alone[0].binding if alone else Binding.ATOM, negative)


def _multiplied(factors: Sequence[str]) -> str:
    if not factors:
        return "<mn>1</mn>"
    return factors[0] if len(factors) == 1 else f"<mrow>{_TIMES.join(factors)}</mrow>"
