r"""LaTeX: c_{1}\left(a_{2}c_{2}+a_{3}c_{23}\right)-d_{3}s_{1}."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from fractions import Fraction

from kinematics.cells.characters import GREEK
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
from kinematics.printing.infix import Binding, Written
from kinematics.printing.notation import Names
from kinematics.printing.numbers import decimal_text
from kinematics.printing.products import sorted_factors
from kinematics.printing.symbols import split_name
from kinematics.symbolic.size import bottom_up

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


class LatexWriter:
    """Writes expressions in LaTeX; what has been written once is remembered."""

    def __init__(self, names: Names) -> None:
        self._names = names
        self._written: dict[int, Written] = {}
        self._kept: list[Expression] = []

    def text(self, expression: Expression) -> str:
        """The expression in LaTeX, without dollar signs."""
        known = self._written.get(id(expression))
        if known is None:
            self._kept.append(expression)
            for node in bottom_up((expression,), self._written):
                self._written[id(node)] = self._node(node)
            known = self._written[id(expression)]
        return known.text

    def matrix(self, matrix: Sequence[Sequence[Expression]]) -> str:
        """A matrix in square brackets."""
        rows = [" & ".join(map(self.text, row)) for row in matrix]
        return "\\begin{bmatrix}\n" + " \\\\\n".join(rows) + "\n\\end{bmatrix}"

    def _node(self, node: Expression) -> Written:
        short = self._names.short(node)
        if short is not None:
            return Written(f"{short.letter}_{{{short.index.replace('−', '-')}}}", Binding.ATOM)
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
                return Written(parameter(name), Binding.ATOM)
            case JointVariable(index):
                return Written(f"q_{{{index}}}", Binding.ATOM)
            case Pi():
                return Written(r"\pi", Binding.ATOM)
            case Power(base, exponent):
                if exponent < 0:
                    return _fraction(Fraction(1), below=[self._raised(base, -exponent)])
                return self._raised(base, exponent)

    def _call(self, function: Function, arguments: Sequence[Written]) -> Written:
        first = arguments[0]
        if function is Function.SQRT:
            return Written(rf"\sqrt{{{first.text}}}", Binding.ATOM)
        if function is Function.ABS:
            return Written(rf"\left|{first.text}\right|", Binding.ATOM)
        inner = ", ".join(argument.text for argument in arguments)
        tall = r"\frac" in inner or r"\sqrt" in inner or r"\left" in inner
        opening, closing = (r"\left(", r"\right)") if tall else ("(", ")")
        return Written(f"{_FUNCTIONS[function]}{opening}{inner}{closing}", Binding.ATOM)

    def _raised(self, base: Expression, exponent: Fraction) -> Written:
        written = self._written[id(base)]
        if exponent == 1:
            return written
        if exponent == Fraction(1, 2):
            return Written(rf"\sqrt{{{written.text}}}", Binding.ATOM)
        if isinstance(base, Call) and base.function in _FUNCTIONS and self._names.short(base) is None:
            name = _FUNCTIONS[base.function]
            return Written(f"{name}^{{{exponent}}}{written.text.removeprefix(name)}", Binding.POWER)
        return Written(f"{_bracketed(written, Binding.ATOM)}^{{{exponent}}}", Binding.POWER)

    def _sum(self, terms: Iterable[Expression]) -> Written:
        text = ""
        for term in terms:
            written = self._written[id(term)].text
            text += written if not text or written.startswith("-") else f"+{written}"
        return Written(text, Binding.SUM)

    def _product(self, factors: Iterable[Expression]) -> Written:
        parts = sorted_factors(factors)
        return _fraction(
            parts.weight,
            [self._written[id(factor)] for factor in parts.constants],
            [self._written[id(factor)] for factor in parts.above],
            [self._raised(base, exponent) for base, exponent in parts.below],
        )


def parameter(name: str) -> str:
    r"""A parameter's name: L_{1}, \alpha_{2}, \mathrm{reach}_{x}."""
    word, index, greek = split_name(name)
    if greek and word in _COMMANDS:
        head = rf"\{word}"
    else:
        head = word if len(word) == 1 else rf"\mathrm{{{_escaped(word)}}}"
    return f"{head}_{{{_escaped(index)}}}" if index else head


def _escaped(text: str) -> str:
    return _SPECIAL.sub(lambda found: rf"\{found.group()}" if found.group() in "_#$%&{}" else "", text)


def _bracketed(written: Written, binding: Binding) -> str:
    return written.text if written.binding >= binding else rf"\left({written.text}\right)"


def _fraction(
    weight: Fraction,
    constants: Sequence[Written] = (),
    above: Sequence[Written] = (),
    below: Sequence[Written] = (),
) -> Written:
    r"""A product with its numbers and roots in one fraction: \frac{\sqrt{3}}{2}c_{1}."""
    sign, size = "-" if weight < 0 else "", abs(weight)
    decimal = decimal_text(size)
    divided = decimal is None and size.denominator != 1
    weakest = Binding.SUM if len(below) == 1 and not divided else Binding.POWER
    denominator = [_bracketed(factor, weakest) for factor in below]
    if divided:
        denominator.insert(0, str(size.denominator))
    head = [decimal] if decimal else [str(size.numerator)] if size.numerator != 1 else []
    head += [_bracketed(factor, Binding.PRODUCT) for factor in constants]
    tail = [_bracketed(factor, Binding.PRODUCT) for factor in above]
    if below or (denominator and not head and len(tail) == 1 and above[0].binding >= Binding.POWER):
        head, tail = head + tail, []
    if denominator:
        head = [rf"\frac{{{_juxtaposed(head) or '1'}}}{{{_juxtaposed(denominator)}}}"]
    text = _juxtaposed(head + tail) or "1"
    if sign:
        return Written(sign + text, Binding.SIGN)
    if len(head) + len(tail) == 1 and not denominator and (constants or above):
        return Written(text, (*constants, *above)[0].binding)
    return Written(text, Binding.PRODUCT if len(head) + len(tail) > 1 or denominator else Binding.ATOM)


def _juxtaposed(factors: Sequence[str]) -> str:
    text = ""
    for factor in factors:
        if text and factor[0].isdigit():
            text += rf" \cdot {factor}"
        elif text and text[-1].isalpha() and factor[0].isalpha():
            text += f" {factor}"
        else:
            text += factor
    return text
