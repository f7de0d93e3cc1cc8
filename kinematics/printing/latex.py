r"""LaTeX: c_{1}\left(a_{2}c_{2}+a_{3}c_{23}\right)-d_{3}s_{1}."""

from __future__ import annotations

import re
from collections.abc import Sequence
from fractions import Fraction

from kinematics.cells.characters import GREEK
from kinematics.expressions import Call, Function
from kinematics.printing.ledger import Entered
from kinematics.printing.symbols import split_name
from kinematics.printing.writer import Binding, Typesetter, WrittenTerm

_FUNCTIONS = {
    Function.SIN: r"\sin",
    Function.COS: r"\cos",
    Function.TAN: r"\tan",
    Function.ASIN: r"\arcsin",
    Function.ACOS: r"\arccos",
    Function.ATAN: r"\arctan",
    Function.ATAN2: r"\operatorname{atan2}",
}
_COMMANDS = frozenset(
    ["Gamma", "Delta", "Theta", "Lambda", "Xi", "Pi", "Sigma", "Upsilon", "Phi", "Psi", "Omega"]
).union(name for name in GREEK.values() if name.islower() and name != "omicron")
"""Greek letters that LaTeX has a command for; the others look like Latin ones."""
_SPECIAL = re.compile(r"[^A-Za-z0-9]")


class LatexWriter(Typesetter):
    """Writes expressions in LaTeX, without dollar signs."""

    def table(self, matrix: Entered) -> str:
        """Return a matrix in square brackets."""
        rows = map(" & ".join, self.lines(matrix))
        return "\\begin{bmatrix}\n" + " \\\\\n".join(rows) + "\n\\end{bmatrix}"

    def _call(self, node: Call, arguments: Sequence[WrittenTerm]) -> WrittenTerm:
        short = self._names.short(node)
        if short is not None:
            return WrittenTerm(f"{short.letter}_{{{short.index.replace('−', '-')}}}", Binding.ATOM)
        inner = ", ".join(map(self._signed, arguments))
        if node.function is Function.SQRT:
            return WrittenTerm(self._root(inner), Binding.ATOM)
        if node.function is Function.ABS:
            return WrittenTerm(rf"\left|{inner}\right|", Binding.ATOM)
        tall = r"\frac" in inner or r"\sqrt" in inner or r"\left" in inner
        opening, closing = (r"\left(", r"\right)") if tall else ("(", ")")
        return WrittenTerm(f"{_FUNCTIONS[node.function]}{opening}{inner}{closing}", Binding.ATOM)

    def _power(self, base: int, exponent: Fraction) -> WrittenTerm:
        written, node = self._written[base], self.ledger.nodes[base]
        if isinstance(node, Call) and node.function in _FUNCTIONS and self._names.short(node) is None:
            name = _FUNCTIONS[node.function]
            return WrittenTerm(f"{name}^{{{exponent}}}{written.body.removeprefix(name)}", Binding.POWER)
        return WrittenTerm(f"{self._within(written, Binding.ATOM)}^{{{exponent}}}", Binding.POWER)

    def _bracketed(self, text: str) -> str:
        return rf"\left({text}\right)"

    def _parameter(self, name: str) -> str:
        return parameter(name)

    def _pi(self) -> str:
        return r"\pi"

    def _digits(self, digits: str) -> str:
        return digits

    def _over(self, numerator: str, denominator: str) -> str:
        return rf"\frac{{{numerator}}}{{{denominator}}}"

    def _root(self, radicand: str) -> str:
        return rf"\sqrt{{{radicand}}}"

    def _times(self, factors: Sequence[str]) -> str:
        text = factors[0]
        for factor in factors[1:]:
            if factor[0].isdigit():
                text += rf" \cdot {factor}"
            elif text[-1].isalpha() and factor[0].isalpha():
                text += f" {factor}"
            else:
                text += factor
        return text


def parameter(name: str) -> str:
    r"""Return a parameter's name: L_{1}, \alpha_{2}, \mathrm{reach}_{x}."""
    word, index, greek, dotted = split_name(name)
    if dotted:
        head = rf"\dot{{{word}}}"
    elif greek and word in _COMMANDS:
        head = rf"\{word}"
    else:
        head = word if len(word) == 1 else rf"\mathrm{{{_escaped(word)}}}"
    return f"{head}_{{{_escaped(index)}}}" if index else head


def _escaped(text: str) -> str:
    return _SPECIAL.sub(lambda found: rf"\{found.group()}" if found.group() in "_#$%&{}" else "", text)
