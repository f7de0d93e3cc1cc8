"""Content MathML: what an expression means, whatever it is drawn like."""

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
from kinematics.printing.ledger import Entered
from kinematics.printing.numbers import decimal_text
from kinematics.printing.writer import Writer

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


class ContentWriter(Writer[str]):
    """Writes expressions in content markup."""

    def table(self, matrix: Entered) -> str:
        """Return a matrix in the ledger."""
        rows = "".join(f"<matrixrow>{''.join(row)}</matrixrow>" for row in self.entries(matrix))
        return f"<matrix>{rows}</matrix>"

    def _write(self, number: int) -> str:
        below = [self._written[child] for child in self.ledger.below[number]]
        match self.ledger.nodes[number]:
            case Product(factors):
                return _product(factors[0], below)
            case Sum():
                return f"<apply><plus/>{''.join(below)}</apply>"
            case Call(function, _):
                return f"<apply>{_FUNCTIONS[function]}{''.join(below)}</apply>"
            case Number(value):
                return _number(value)
            case Parameter(name):
                return f"<ci>{escape(name)}</ci>"
            case JointVariable(index):
                return f"<ci>{escape(self._names.variable(index))}</ci>"
            case Pi():
                return "<pi/>"
            case Power(_, exponent):
                return f"<apply><power/>{below[0]}{_number(exponent)}</apply>"


def _product(first: Expression, factors: Sequence[str]) -> str:
    if not isinstance(first, Number) or first.value > 0:
        return f"<apply><times/>{''.join(factors)}</apply>"
    positive = [] if first.value == -1 else [_number(-first.value)]
    parts = [*positive, *factors[1:]]
    inner = parts[0] if len(parts) == 1 else f"<apply><times/>{''.join(parts)}</apply>"
    return f"<apply><minus/>{inner}</apply>"


def _number(value: Fraction) -> str:
    if value < 0:
        return f"<apply><minus/>{_number(-value)}</apply>"
    decimal = decimal_text(value)
    if decimal is None and value.denominator != 1:
        return f'<cn type="rational">{value.numerator}<sep/>{value.denominator}</cn>'
    digits, _, power = str(decimal or value.numerator).partition("e")
    return f'<cn type="e-notation">{digits}<sep/>{power}</cn>' if power else f"<cn>{digits}</cn>"
