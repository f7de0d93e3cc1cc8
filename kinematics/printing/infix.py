"""Expressions on one line: a2*c2 + a3*c23, in the spelling of a language."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from enum import IntEnum
from fractions import Fraction

from kinematics.expressions import (
    MINUS_ONE,
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
from kinematics.printing.products import sorted_factors
from kinematics.symbolic.size import bottom_up

_PLAIN = {Call, Sum, Parameter, JointVariable, Pi}


class Binding(IntEnum):
    """How strongly the outermost operation of a text binds."""

    SUM = 1
    SIGN = 2
    PRODUCT = 3
    POWER = 4
    ATOM = 5


@dataclass(frozen=True, slots=True)
class Written:
    """A text and how strongly it binds."""

    text: str
    binding: Binding

    def within(self, binding: Binding) -> str:
        """The text, in parentheses unless it binds at least so strongly."""
        return self.text if self.binding >= binding else f"({self.text})"


@dataclass(frozen=True, kw_only=True, slots=True)
class Spelling:
    """How a language writes what expressions are made of.

    Attributes:
        pi: the number π.
        whole: an integer.
        functions: names of the functions.
        variable: a joint variable, given its number.
        parameter: a parameter, given its name.
        power: base ** exponent, the base being written already.
    """

    pi: str = "pi"
    whole: Callable[[int], str] = str
    functions: Mapping[Function, str]
    variable: Callable[[int], str]
    parameter: Callable[[str], str]
    power: Callable[[Written, Fraction], Written]


class InfixWriter:
    """Writes expressions in one spelling; what has been written once is remembered."""

    def __init__(self, spelling: Spelling, name: Callable[[Expression], str | None]) -> None:
        self._spelling = spelling
        self._name = name
        self._written: dict[int, Written] = {}
        self._kept: list[Expression] = []

    def text(self, expression: Expression) -> str:
        """The expression on one line."""
        return self.write(expression).text

    def write(self, expression: Expression) -> Written:
        """The expression on one line, and how strongly it binds."""
        known = self._written.get(id(expression))
        if known is None:
            self._kept.append(expression)
            for node in bottom_up((expression,), self._written):
                self._written[id(node)] = self._node(node)
            known = self._written[id(expression)]
        return known

    def write_all(self, nodes: Iterable[Expression]) -> None:
        """Write nodes of which the children come before the parents."""
        for node in nodes:
            self._written[id(node)] = self._node(node)

    def definition(self, expression: Expression) -> str:
        """The expression on one line, even if it has a name."""
        self.write(expression)
        return self._body(expression).text

    def _node(self, node: Expression) -> Written:
        name = self._name(node)
        return self._body(node) if name is None else Written(name, Binding.ATOM)

    def _body(self, node: Expression) -> Written:
        spelling = self._spelling
        match node:
            case Product(factors):
                return self._product(factors)
            case Sum(terms):
                return self._sum(terms)
            case Call(function, arguments):
                inner = ", ".join(self._written[id(argument)].text for argument in arguments)
                return Written(f"{spelling.functions[function]}({inner})", Binding.ATOM)
            case Number(value):
                return self._number(value)
            case Parameter(name):
                return Written(spelling.parameter(name), Binding.ATOM)
            case JointVariable(index):
                return Written(spelling.variable(index), Binding.ATOM)
            case Pi():
                return Written(spelling.pi, Binding.ATOM)
            case Power(base, exponent):
                if exponent < 0:
                    return self._quotient([], [self._raised(base, -exponent)], Fraction(1))
                return self._raised(base, exponent)

    def _raised(self, base: Expression, exponent: Fraction) -> Written:
        return (
            self._written[id(base)]
            if exponent == 1
            else self._spelling.power(self._written[id(base)], exponent)
        )

    def _number(self, value: Fraction) -> Written:
        decimal = decimal_text(value)
        if decimal is not None:
            return Written(decimal, Binding.SIGN if value < 0 else Binding.ATOM)
        if value.denominator == 1:
            sign = "-" if value < 0 else ""
            return Written(
                sign + self._spelling.whole(abs(value.numerator)), Binding.SIGN if sign else Binding.ATOM
            )
        return self._quotient([], [], value)

    def _sum(self, terms: Iterable[Expression]) -> Written:
        parts: list[str] = []
        for term in terms:
            text = self._written[id(term)].text
            if not parts:
                parts.append(text)
            elif text.startswith("-"):
                parts.append(f" - {text[1:]}")
            else:
                parts.append(f" + {text}")
        return Written("".join(parts), Binding.SUM)

    def _product(self, factors: tuple[Expression, ...]) -> Written:
        sign = "-" if factors[0] == MINUS_ONE else ""
        rest = factors[1:] if sign else factors
        if all(type(factor) in _PLAIN for factor in rest):
            texts = [self._written[id(factor)].within(Binding.PRODUCT) for factor in rest]
            return Written(sign + "*".join(texts), Binding.SIGN if sign else Binding.PRODUCT)
        parts = sorted_factors(factors)
        above = [self._written[id(factor)] for factor in (*parts.constants, *parts.above)]
        return self._quotient(above, [self._raised(*divisor) for divisor in parts.below], parts.weight)

    def _quotient(self, above: list[Written], below: list[Written], weight: Fraction) -> Written:
        sign = "-" if weight < 0 else ""
        size = abs(weight)
        decimal = decimal_text(size)
        numbers = (
            [decimal] if decimal else [self._spelling.whole(size.numerator)] if size.numerator != 1 else []
        )
        numerator = numbers + [factor.within(Binding.PRODUCT) for factor in above]
        denominator = [factor.within(Binding.POWER) for factor in below]
        if not decimal and size.denominator != 1:
            denominator.insert(0, self._spelling.whole(size.denominator))
        text = "*".join(numerator) or self._spelling.whole(1)
        if denominator:
            under = denominator[0] if len(denominator) == 1 else f"({'*'.join(denominator)})"
            text = f"{text}/{under}"
        binding = Binding.PRODUCT if denominator or len(numerator) > 1 else Binding.ATOM
        if binding is Binding.ATOM and above:
            binding = above[0].binding
        return Written(sign + text, Binding.SIGN if sign else binding)
