"""MathML that browsers draw and screen readers speak.

Each matrix is presentation markup (what is drawn and, in today's browsers and screen readers, spoken) with
the same matrix as content markup in an annotation. Minus signs are U+2212; products and function applications
carry the invisible operators U+2062 and U+2061, so that a reader says "c 1 times" and "cosine of" and not a
run of letters. The content markup never abbreviates: where c23 is drawn it says cos(q2 + q3).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from xml.sax.saxutils import escape

from kinematics.expressions import Call, Function
from kinematics.printing.content import ContentWriter
from kinematics.printing.ledger import Entered, Ledger
from kinematics.printing.notation import Names
from kinematics.printing.symbols import split_name
from kinematics.printing.writer import Binding, Typesetter, WrittenTerm

_TIMES = "<mo>\u2062</mo>"
_DOT = "<mo>⋅</mo>"
_WITH_DIGITS = ("<mn>", "<msup><mn>")
_APPLY = "<mo>\u2061</mo>"
_MINUS = "<mo>−</mo>"
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


class MathmlWriter(Typesetter):
    """Writes expressions in MathML."""

    plus, minus, sign = "<mo>+</mo>", _MINUS, _MINUS

    def __init__(self, names: Names, ledger: Ledger | None = None) -> None:
        super().__init__(names, ledger)
        self._content = ContentWriter(names, self.ledger)

    def table(self, matrix: Entered) -> str:
        """Return a matrix in square brackets, as one `math` element."""
        rows = "".join(f"<mtr>{_cells(row)}</mtr>" for row in self.lines(matrix))
        drawn = f"<mrow><mo>[</mo><mtable>{rows}</mtable><mo>]</mo></mrow>"
        meant = self._content.table(matrix)
        return (
            f'<math xmlns="{_NAMESPACE}" display="block"><semantics>{drawn}'
            f'<annotation-xml encoding="MathML-Content">{meant}</annotation-xml></semantics></math>'
        )

    def _call(self, node: Call, arguments: Sequence[WrittenTerm]) -> WrittenTerm:
        short = self._names.short(node)
        if short is not None:
            index = short.index
            script = f"<mn>{index}</mn>" if index.isdigit() else f"<mtext>{index}</mtext>"
            return WrittenTerm(f"<msub><mi>{short.letter}</mi>{script}</msub>", Binding.ATOM)
        inner = "<mo>,</mo>".join(map(self._signed, arguments))
        if node.function is Function.SQRT:
            return WrittenTerm(self._root(inner), Binding.ATOM)
        if node.function is Function.ABS:
            return WrittenTerm(f"<mrow><mo>|</mo>{inner}<mo>|</mo></mrow>", Binding.ATOM)
        return WrittenTerm(
            f"<mrow>{_name(node.function)}{_APPLY}{self._bracketed(inner)}</mrow>", Binding.ATOM
        )

    def _power(self, base: int, exponent: Fraction) -> WrittenTerm:
        written, node = self._written[base], self.ledger.nodes[base]
        power = _exponent(exponent)
        if isinstance(node, Call) and node.function in _FUNCTIONS and self._names.short(node) is None:
            name = _name(node.function)
            raised = written.body.replace(name, f"<msup>{name}{power}</msup>", 1)
            return WrittenTerm(raised, Binding.POWER)
        return WrittenTerm(f"<msup>{self._within(written, Binding.ATOM)}{power}</msup>", Binding.POWER)

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

    def _pi(self) -> str:
        return "<mi>π</mi>"

    def _digits(self, digits: str) -> str:
        return f"<mn>{digits}</mn>"

    def _over(self, numerator: str, denominator: str) -> str:
        return f"<mfrac>{numerator}{denominator}</mfrac>"

    def _root(self, radicand: str) -> str:
        return f"<msqrt>{radicand}</msqrt>"

    def _times(self, factors: Sequence[str]) -> str:
        if len(factors) == 1:
            return factors[0]
        parts = [factors[0]]
        for factor in factors[1:]:
            parts += (_DOT if factor.startswith(_WITH_DIGITS) else _TIMES, factor)
        return f"<mrow>{''.join(parts)}</mrow>"


def _cells(row: Sequence[str]) -> str:
    return f"<mtd>{'</mtd><mtd>'.join(row)}</mtd>" if row else ""


def _name(function: Function) -> str:
    return f"<mi>{_FUNCTIONS[function]}</mi>"


def _exponent(exponent: Fraction) -> str:
    whole = f"<mn>{exponent.numerator}</mn>"
    return whole if exponent.denominator == 1 else f"<mfrac>{whole}<mn>{exponent.denominator}</mn></mfrac>"
