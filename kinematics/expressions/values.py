"""What an expression is worth, and what stands in it."""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction

from kinematics.angles import cos_sin
from kinematics.errors import Fault, ParameterError
from kinematics.expressions.trees import (
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

_FUNCTIONS: dict[Function, Callable[..., float]] = {
    Function.SQRT: math.sqrt,
    Function.SIN: lambda angle: cos_sin(angle)[1],
    Function.COS: lambda angle: cos_sin(angle)[0],
    Function.TAN: math.tan,
    Function.ASIN: math.asin,
    Function.ACOS: math.acos,
    Function.ATAN: math.atan,
    Function.ATAN2: math.atan2,
    Function.ABS: abs,
}


_NOTHING: frozenset[str] = frozenset()

COARSE = 10
"""Denominators from here on are those of decimals, but for those of 24: 1/12 is exact, 0.43 is not."""
OF_TENTHS = 5
"""Denominators that this divides are those of decimals, too: 9.8 is 49/5, and may have been 9.81."""


def evaluate(
    expression: Expression, parameters: Mapping[str, float] | None = None, joints: Sequence[float] = ()
) -> float:
    """Return the numerical value of an expression.

    Args:
        parameters: value of each parameter by name [m or rad].
        joints: q_1 … q_n [rad or m].

    Raises:
        ParameterError: a parameter has no value, or the value does not exist (1/0, sqrt(-1)) or is infinite.
    """
    try:
        if type(expression) is Number:  # what most cells hold
            numerator, denominator = expression.value.as_integer_ratio()
            return numerator / denominator
        value = _value(expression, parameters or {}, joints)
    except KeyError as missing:
        name = str(missing.args[0])
        raise ParameterError(Fault.at("parameter_missing", "parameters", name, name=name)) from None
    except (ValueError, ZeroDivisionError, OverflowError, TypeError):
        value = math.nan
    if isinstance(value, complex) or not math.isfinite(value):
        raise ParameterError(Fault.at("value_undefined"))
    return value


def evaluate_each(
    entries: Iterable[tuple[tuple[str | int, ...], Expression]], parameters: Mapping[str, float] | None
) -> list[float]:
    """Return the values of expressions, each given with its place.

    Raises:
        ParameterError: a parameter has no value, at ("parameters", name), or an expression has none, at its
            place; all faults at once.
    """
    values: list[float] = []
    faults: dict[tuple[str | int, ...], Fault] = {}
    for place, expression in entries:
        try:
            values.append(evaluate(expression, parameters))
        except ParameterError as error:
            for fault in error.faults:
                placed = fault if fault.where else fault.within(*place)
                faults[placed.where] = placed
    if faults:
        raise ParameterError(faults.values())
    return values


def parameters_in(expression: Expression) -> frozenset[str]:
    """Return the names of the parameters that an expression contains."""
    if isinstance(expression, Number):  # what most cells hold
        return _NOTHING
    return frozenset(node.name for node in walk(expression) if isinstance(node, Parameter))


def joint_variables_in(expression: Expression) -> frozenset[int]:
    """Return indices of the joint variables that an expression contains."""
    return frozenset(node.index for node in walk(expression) if isinstance(node, JointVariable))


def walk(expression: Expression) -> Iterator[Expression]:
    """Yield every node of the tree, the root first."""
    stack = [expression]
    while stack:
        node = stack.pop()
        yield node
        # comparing types is faster than a match, and there are many nodes
        if type(node) is Product:
            stack.extend(node.factors)
        elif type(node) is Sum:
            stack.extend(node.terms)
        elif type(node) is Call:
            stack.extend(node.arguments)
        elif type(node) is Power:
            stack.append(node.base)


def holds_decimals(expression: Expression) -> bool:
    """Return whether an expression holds numbers that may have been rounded: 0.43, but not 1/12."""
    found = (node.value.denominator for node in walk(expression) if isinstance(node, Number))
    return any(under % OF_TENTHS == 0 or (under >= COARSE and 24 % under) for under in found)


def _value(node: Expression, parameters: Mapping[str, float], joints: Sequence[float]) -> float:
    # comparing types is faster than a match, and most nodes are of these
    if type(node) is Parameter:
        return parameters[node.name]
    if type(node) is Number:
        numerator, denominator = node.value.as_integer_ratio()
        return numerator / denominator
    if type(node) is Product:
        if len(node.factors) == 2 and type(node.factors[1]) is Pi and type(node.factors[0]) is Number:
            return _times_pi(node.factors[0].value)
        return math.prod(_value(factor, parameters, joints) for factor in node.factors)
    if type(node) is Sum:
        return sum(_value(term, parameters, joints) for term in node.terms)
    if type(node) is Power:
        exponent = node.exponent
        return float(_value(node.base, parameters, joints) ** (exponent.numerator / exponent.denominator))
    if type(node) is Call:
        return _FUNCTIONS[node.function](*(_value(given, parameters, joints) for given in node.arguments))
    return joints[node.index - 1] if isinstance(node, JointVariable) else math.pi


def _times_pi(value: Fraction) -> float:
    numerator, denominator = value.as_integer_ratio()
    try:
        return math.pi * numerator / denominator
    except OverflowError:  # no double is as large as the denominator of the least one
        return math.pi * (numerator / denominator)
