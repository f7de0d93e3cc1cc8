r"""LaTeX: c_{1}\left(a_{2}c_{2}+a_{3}c_{23}\right)-d_{3}s_{1}."""

import re
from collections.abc import Sequence
from fractions import Fraction

from kinematics.cells.characters import GREEK
from kinematics.expressions import Function
from kinematics.printing.ledger import Entered
from kinematics.printing.notation import ShortName
from kinematics.printing.symbols import split_name
from kinematics.printing.writer import Typesetter

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

    pi, comma, digits = r"\pi", ", ", "{}"
    over, root, power = r"\frac{{{}}}{{{}}}", r"\sqrt{{{}}}", "{}^{{{}}}"
    absolute = r"\left|{}\right|"
    functions = _FUNCTIONS

    def table(self, matrix: Entered) -> str:
        """Return a matrix in square brackets."""
        return "\\begin{bmatrix}\n" + " \\\\\n".join(map(" & ".join, self.lines(matrix))) + "\n\\end{bmatrix}"

    def _short(self, short: ShortName) -> str:
        return f"{short.letter}_{{{short.index.replace('−', '-')}}}"

    def _applied(self, function: Function, inner: str) -> str:
        tall = r"\frac" in inner or r"\sqrt" in inner or r"\left" in inner
        opening, closing = (r"\left(", r"\right)") if tall else ("(", ")")
        return f"{self.functions[function]}{opening}{inner}{closing}"

    def _exponent(self, exponent: Fraction) -> str:
        return str(exponent)

    def _bracketed(self, text: str) -> str:
        return rf"\left({text}\right)"

    def _parameter(self, name: str) -> str:
        return parameter(name)

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
