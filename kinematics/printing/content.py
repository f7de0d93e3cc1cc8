"""Content MathML: what an expression means, whatever it is drawn like."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
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
from kinematics.printing.numbers import decimal_text
from kinematics.symbolic.size import bottom_up

_FUNCTIONS = {
    Function.SQRT: "<root/>",
    Function.SIN: "<sin/>",
    Function.COS: "<cos/>",
    Function.TAN: "<tan/>",
    Function.ASIN: "<arcsin/>",
    Function.ACOS: "<arccos/>",
    Function.ATAN: "<arctan/>",
    Function.ATAN2: "<csymbol>atan2</csymbol>",
    Function.ABS: "<abs/>",
}


class ContentWriter:
    """Writes expressions in content markup; what has been written once is remembered."""

    def __init__(self) -> None:
        self._written: dict[int, str] = {}
        self._kept: list[Expression] = []

    def matrix(self, matrix: Sequence[Sequence[Expression]]) -> str:
        """A matrix."""
        rows = "".join(f"<matrixrow>{''.join(map(self.content, row))}</matrixrow>" for row in matrix)
        return f"<matrix>{rows}</matrix>"

    def content(self, expression: Expression) -> str:
        """Content markup of one expression."""
        if id(expression) not in self._written:
            self._kept.append(expression)
            for node in bottom_up((expression,), self._written):
                self._written[id(node)] = self._node(node)
        return self._written[id(expression)]

    def _node(self, node: Expression) -> str:
        match node:
            case Product(factors):
                return self._product(factors)
            case Sum(terms):
                return f"<apply><plus/>{self._all(terms)}</apply>"
            case Call(function, arguments):
                return f"<apply>{_FUNCTIONS[function]}{self._all(arguments)}</apply>"
            case Number(value):
                return _number(value)
            case Parameter(name):
                return f"<ci>{escape(name)}</ci>"
            case JointVariable(index):
                return f"<ci>q{index}</ci>"
            case Pi():
                return "<pi/>"
            case Power(base, exponent):
                return f"<apply><power/>{self._written[id(base)]}{_number(exponent)}</apply>"

    def _product(self, factors: Sequence[Expression]) -> str:
        first = factors[0]
        if isinstance(first, Number) and first.value < 0:
            positive = [] if first.value == -1 else [_number(-first.value)]
            parts = positive + [self._written[id(factor)] for factor in factors[1:]]
            inner = parts[0] if len(parts) == 1 else f"<apply><times/>{''.join(parts)}</apply>"
            return f"<apply><minus/>{inner}</apply>"
        return f"<apply><times/>{self._all(factors)}</apply>"

    def _all(self, nodes: Sequence[Expression]) -> str:
        return "".join(self._written[id(node)] for node in nodes)


def _number(value: Fraction) -> str:
    if value < 0:
        return f"<apply><minus/>{_number(-value)}</apply>"
    decimal = decimal_text(value)
    if decimal is None and value.denominator != 1:
        return f'<cn type="rational">{value.numerator}<sep/>{value.denominator}</cn>'
    return f"<cn>{decimal or value.numerator}</cn>"
