"""MathML that browsers draw and screen readers speak.

Each matrix is presentation markup (what is drawn and, in today's browsers and screen readers, spoken) with
the same matrix as content markup in an annotation. Minus signs are U+2212; products and function applications
carry the invisible operators U+2062 and U+2061, so that a reader says "c 1 times" and "cosine of" and not a
run of letters. The content markup never abbreviates: where c23 is drawn it says cos(q2 + q3).
"""

from collections.abc import Sequence
from fractions import Fraction
from xml.sax.saxutils import escape

from kinematics.expressions import Function
from kinematics.printing.content import ContentWriter
from kinematics.printing.ledger import Entered, Ledger
from kinematics.printing.notation import Names, ShortName
from kinematics.printing.symbols import split_name
from kinematics.printing.writer import Typesetter, WrittenTerm

_TIMES = "<mo>\u2062</mo>"
_DOT = "<mo>⋅</mo>"
_WITH_DIGITS = ("<mn>", "<msup><mn>")
_APPLY = "<mo>\u2061</mo>"
_MINUS = "<mo>−</mo>"
_NAMESPACE = "http://www.w3.org/1998/Math/MathML"
_FUNCTIONS = {
    Function.SIN: "<mi>sin</mi>",
    Function.COS: "<mi>cos</mi>",
    Function.TAN: "<mi>tan</mi>",
    Function.ASIN: "<mi>arcsin</mi>",
    Function.ACOS: "<mi>arccos</mi>",
    Function.ATAN: "<mi>arctan</mi>",
    Function.ATAN2: "<mi>atan2</mi>",
}


class MathmlWriter(Typesetter):
    """Writes expressions in MathML."""

    plus, minus, sign, comma = "<mo>+</mo>", _MINUS, _MINUS, "<mo>,</mo>"
    pi, digits = "<mi>π</mi>", "<mn>{}</mn>"
    over, root, power = "<mfrac>{}{}</mfrac>", "<msqrt>{}</msqrt>", "<msup>{}{}</msup>"
    absolute = "<mrow><mo>|</mo>{}<mo>|</mo></mrow>"
    functions = _FUNCTIONS

    def __init__(self, names: Names, ledger: Ledger | None = None) -> None:
        super().__init__(names, ledger)
        self._content = ContentWriter(names, self.ledger)

    def table(self, matrix: Entered) -> str:
        """Return a matrix in square brackets, as one `math` element."""
        lines = ("".join(f"<mtd>{cell}</mtd>" for cell in row) for row in self.lines(matrix))
        rows = "".join(f"<mtr>{line}</mtr>" for line in lines)
        drawn = f"<mrow><mo>[</mo><mtable>{rows}</mtable><mo>]</mo></mrow>"
        meant = self._content.table(matrix)
        return (
            f'<math xmlns="{_NAMESPACE}" display="block"><semantics>{drawn}'
            f'<annotation-xml encoding="MathML-Content">{meant}</annotation-xml></semantics></math>'
        )

    def _short(self, short: ShortName) -> str:
        index = short.index
        script = f"<mn>{index}</mn>" if index.isdigit() else f"<mtext>{index}</mtext>"
        return f"<msub><mi>{short.letter}</mi>{script}</msub>"

    def _applied(self, function: Function, inner: str) -> str:
        return f"<mrow>{self.functions[function]}{_APPLY}{self._bracketed(inner)}</mrow>"

    def _exponent(self, exponent: Fraction) -> str:
        whole = f"<mn>{exponent.numerator}</mn>"
        if exponent.denominator == 1:
            return whole
        return f"<mfrac>{whole}<mn>{exponent.denominator}</mn></mfrac>"

    def _joined(self, parts: Sequence[str]) -> str:
        return f"<mrow>{''.join(parts)}</mrow>"

    def _signed(self, written: WrittenTerm) -> str:
        return f"<mrow>{_MINUS}{written.body}</mrow>" if written.negative else written.body

    def _bracketed(self, text: str) -> str:
        return f"<mrow><mo>(</mo>{text}<mo>)</mo></mrow>"

    def _parameter(self, name: str) -> str:
        word, script, greek, dotted = split_name(name)
        letter = f"<mi>{escape(greek or word)}</mi>"
        if dotted:
            letter = f"<mover>{letter}<mo>˙</mo></mover>"
        if not script:
            return letter
        kind = "mn" if script.isdigit() else "mi"
        return f"<msub>{letter}<{kind}>{escape(script)}</{kind}></msub>"

    def _times(self, factors: Sequence[str]) -> str:
        if len(factors) == 1:
            return factors[0]
        parts = [factors[0]]
        for factor in factors[1:]:
            parts += (_DOT if factor.startswith(_WITH_DIGITS) else _TIMES, factor)
        return f"<mrow>{''.join(parts)}</mrow>"
