"""What a cell means: from its syntax tree to an exact expression in radians.

A cell stands in a *position*: an angle (theta, alpha, the argument of a sine), a length (d, a), or a ratio
(the argument of atan2 or of a root). In a table in degrees an angle is made of angles (π, the half turn;
values marked °; angle parameters; inverse functions) and of plain numbers, which are degrees: `pi/2 + 90` is
a half turn. A number times an angle is an angle; a product of two angles is refused. In a table in radians π
is a number.
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from fractions import Fraction

from kinematics.cells.exact import absolute, inverse_trigonometric, raised, reciprocal, snapped, trigonometric
from kinematics.cells.limits import RESULT_BITS, Limits
from kinematics.cells.refusals import CellRefusal, size_refusal
from kinematics.cells.syntax import (
    Addition,
    Application,
    Degrees,
    HalfTurn,
    Literal,
    Multiplication,
    Name,
    Negation,
    Node,
    Parenthesized,
    Raised,
    Reciprocal,
)
from kinematics.cells.units import AngleUnit, ParameterKind
from kinematics.errors import ParameterError
from kinematics.expressions import (
    PI,
    Expression,
    Function,
    Number,
    Parameter,
    Product,
    add,
    call,
    evaluate,
    joint_variables_in,
    multiply,
    negate,
    parameters_in,
    pi_times,
    rational_value,
    walk,
)

VariableOf = Callable[[str], Expression | None]
"""What a name stands for if it is a joint variable, else None."""

_HIGHEST_DIGITS, _HIGHEST_BITS = 300, 2 * RESULT_BITS
"""No power is formed that is larger than this, whatever the limits."""
_RESULT_DIGITS = int(RESULT_BITS * math.log10(2))

_INVERSE = {Function.ASIN, Function.ACOS, Function.ATAN, Function.ATAN2}
_TRIGONOMETRIC = {Function.SIN, Function.COS, Function.TAN}


class Position(StrEnum):
    """Where a value stands."""

    LENGTH = "length"
    ANGLE = "angle"
    RATIO = "ratio"


@dataclass(frozen=True, kw_only=True, slots=True)
class CellMeaning:
    """What a cell means.

    Attributes:
        expression: its exact value; an angle in [rad].
        kinds: the parameters in it, from left to right, and what each of them measures.
    """

    expression: Expression
    kinds: Mapping[str, ParameterKind]

    @property
    def idle(self) -> frozenset[str]:
        """The names in it that make no difference, as in 0*x."""
        return frozenset(self.kinds.keys() - parameters_in(self.expression))


def interpret(
    node: Node, position: Position, angle_unit: AngleUnit, limits: Limits, variable_of: VariableOf
) -> CellMeaning:
    """Return the exact expression that a cell means.

    Raises:
        CellRefusal: the cell has no meaning here, or no finite value.
    """
    interpreter = _Interpreter(angle_unit=angle_unit, limits=limits, variable_of=variable_of)
    value = interpreter.value(node, position)
    _refuse_out_of_range(value.expression, node, limits, 180 if interpreter.in_degrees else 1)
    expression = interpreter.angle(value) if position is Position.ANGLE else value.expression
    if not parameters_in(expression) and not joint_variables_in(expression):
        try:
            evaluate(expression)
        except ParameterError:
            raise CellRefusal("value_not_real") from None
    return CellMeaning(expression=expression, kinds=interpreter.kinds)


@dataclass(frozen=True, slots=True)
class _Value:
    expression: Expression
    is_angle: bool = False


@dataclass(slots=True)
class _Interpreter:
    angle_unit: AngleUnit
    limits: Limits
    variable_of: VariableOf
    kinds: dict[str, ParameterKind] = field(default_factory=dict)

    @property
    def in_degrees(self) -> bool:
        return self.angle_unit is AngleUnit.DEG

    def angle(self, value: _Value) -> Expression:
        """Return the value in radians: a plain number of a table in degrees is converted."""
        return _from_degrees(value.expression) if self.in_degrees and not value.is_angle else value.expression

    def value(self, node: Node, position: Position) -> _Value:
        match node:
            case Literal(value=number):
                return _Value(self._literal(number, node, position))
            case HalfTurn():
                return _Value(PI, is_angle=self.in_degrees and position is Position.ANGLE)
            case Name():
                return self._name(node, position)
            case Parenthesized(operand=operand):
                return self.value(operand, position)
            case Negation(operand=operand):
                inner = self.value(operand, position)
                return _Value(negate(inner.expression), inner.is_angle)
            case Degrees(operand=operand):
                return self._degrees(operand, position)
            case Addition(terms=terms):
                return self._sum([self.value(term, position) for term in terms])
            case Multiplication(factors=factors):
                return self._product(factors, position)
            case Reciprocal(operand=operand):
                return self._reciprocal(node, operand, position)
            case Raised(operand=base, exponent=exponent):
                return self._power(base, exponent, position)
            case Application(function=function, arguments=arguments):
                return self._application(node, function, arguments, position)
        raise AssertionError(node)

    def _literal(self, number: Fraction, node: Node, position: Position) -> Expression:
        _refuse_size(number, node, self.limits)
        if position is Position.ANGLE and not self.in_degrees:
            return snapped(number)
        return Number(number)

    def _name(self, node: Name, position: Position) -> _Value:
        variable = self.variable_of(node.name)
        if variable is not None:
            return _Value(variable, is_angle=position is Position.ANGLE)
        kind = ParameterKind.ANGLE if position is Position.ANGLE else ParameterKind.LENGTH
        known = self.kinds.setdefault(node.name, kind)
        if known is not kind:
            raise CellRefusal(
                "parameter_two_kinds", column=node.column, name=node.name, kind=kind, other=known
            )
        return _Value(Parameter(node.name), is_angle=position is Position.ANGLE)

    def _degrees(self, operand: Node, position: Position) -> _Value:
        if position is not Position.ANGLE:
            raise CellRefusal("degree_in_length", column=operand.column)
        inner = _Interpreter(AngleUnit.DEG, self.limits, self.variable_of, self.kinds).value(
            operand, position
        )
        if inner.is_angle:
            raise CellRefusal("degree_of_angle", column=operand.column)
        return _Value(_from_degrees(inner.expression), is_angle=self.in_degrees)

    def _sum(self, terms: list[_Value]) -> _Value:
        if any(term.is_angle for term in terms):
            return _Value(add(self.angle(term) for term in terms), is_angle=True)
        return _Value(add(term.expression for term in terms))

    def _product(self, factors: tuple[Node, ...], position: Position) -> _Value:
        values = [self.value(factor, position) for factor in factors]
        angles = [factor for factor, value in zip(factors, values, strict=True) if value.is_angle]
        if len(angles) > 1:
            raise CellRefusal("angle_product", column=angles[1].column)
        product = multiply(value.expression for value in values)
        weight = product.factors[0] if isinstance(product, Product) else product
        if isinstance(weight, Number):  # numbers further down were made, and looked at, before
            _refuse_size(weight.value, factors[0], self.limits)
        return _Value(product, is_angle=bool(angles))

    def _reciprocal(self, node: Node, operand: Node, position: Position) -> _Value:
        inner = self.value(operand, position)
        if inner.is_angle:
            raise CellRefusal("angle_in_denominator", column=operand.column)
        try:
            return _Value(reciprocal(inner.expression))
        except ZeroDivisionError:
            raise CellRefusal("division_by_zero", column=node.column) from None

    def _power(self, base: Node, exponent: Node, position: Position) -> _Value:
        inner = self.value(base, position)
        if inner.is_angle:
            raise CellRefusal("angle_power", column=base.column)
        degree = self._exponent(exponent)
        try:
            _refuse_power(inner.expression, degree, base, self.limits)
            value = raised(inner.expression, degree)
        except ZeroDivisionError:
            raise CellRefusal("division_by_zero", column=base.column) from None
        _refuse_out_of_range(value, base, self.limits)
        return _Value(value)

    def _exponent(self, node: Node) -> Fraction:
        degree = rational_value(self.value(node, Position.RATIO).expression)
        if degree is None:
            raise CellRefusal("exponent_not_constant", column=node.column)
        limit = self.limits.exponent
        if abs(degree) > limit or degree.denominator > limit:
            raise CellRefusal("exponent_out_of_range", column=node.column, limit=limit)
        return degree

    def _application(
        self, node: Node, function: Function, arguments: tuple[Node, ...], position: Position
    ) -> _Value:
        if function is Function.ABS:
            inner = self.value(arguments[0], position)
            return _Value(absolute(inner.expression), inner.is_angle)
        if function in _TRIGONOMETRIC:
            angle = self.angle(self.value(arguments[0], Position.ANGLE))
            try:
                return _Value(trigonometric(function, angle))
            except ZeroDivisionError:
                raise CellRefusal("division_by_zero", column=node.column) from None
        inside = Position.RATIO if position is Position.ANGLE else position
        values = [self.value(argument, inside).expression for argument in arguments]
        if function not in _INVERSE:
            return _Value(call(function, *values))
        if self.in_degrees and position is not Position.ANGLE:
            raise CellRefusal("angle_in_length", column=node.column, name=function.value)
        return _Value(inverse_trigonometric(function, *values), is_angle=self.in_degrees)


def _from_degrees(expression: Expression) -> Expression:
    value = rational_value(expression)
    if value is not None:
        return pi_times(value / 180)
    return multiply((Number(Fraction(1, 180)), PI, expression))


def _refuse_size(value: Fraction, node: Node, limits: Limits) -> None:
    if not limits.admits(value):
        raise size_refusal(value, node.column, limits)
    if max(value.numerator.bit_length(), value.denominator.bit_length()) > RESULT_BITS:
        raise CellRefusal("number_too_long", column=node.column, limit=_RESULT_DIGITS)


def _refuse_out_of_range(expression: Expression, node: Node, limits: Limits, per_half_turn: int = 1) -> None:
    for part in walk(expression):
        if isinstance(part, Number):
            small = abs(part.value) < 1  # a part of π, where degrees have been converted
            _refuse_size(part.value * per_half_turn if small else part.value, node, limits)


def _refuse_power(base: Expression, degree: Fraction, node: Node, limits: Limits) -> None:
    value = rational_value(base)
    if not value:
        return
    bits = max(value.numerator.bit_length(), value.denominator.bit_length())
    digits = math.log10(abs(value)) * degree
    if abs(digits) > _HIGHEST_DIGITS:
        raise size_refusal(Fraction(10) ** (1 if digits > 0 else -1), node.column, limits)
    if bits * abs(degree) > _HIGHEST_BITS:
        raise CellRefusal("number_too_long", column=node.column, limit=_RESULT_DIGITS)
