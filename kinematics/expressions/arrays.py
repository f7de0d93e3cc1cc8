"""What an expression is worth at many points at once."""

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinematics.expressions.trees import (
    Call,
    Expression,
    Function,
    JointVariable,
    Number,
    Parameter,
    Power,
    Product,
    Sum,
)

_FUNCTIONS: dict[Function, Callable[..., Any]] = {
    Function.SQRT: np.sqrt,
    Function.SIN: np.sin,
    Function.COS: np.cos,
    Function.TAN: np.tan,
    Function.ASIN: np.arcsin,
    Function.ACOS: np.arccos,
    Function.ATAN: np.arctan,
    Function.ATAN2: np.arctan2,
    Function.ABS: np.abs,
}


def values_at(
    expression: Expression, parameters: Mapping[str, Any], joints: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return the values of an expression at k points, (k,); NaN or infinite where it has none.

    Args:
        parameters: the value of each parameter, one number or (k,) [m or rad].
        joints: (n, k) joint variables [rad or m].

    Raises:
        KeyError: a parameter has no value.
    """
    if type(expression) is Number:  # what most cells of a matrix hold
        return np.full(joints.shape[1:], _value(expression, parameters, joints), dtype=np.float64)
    with np.errstate(all="ignore"):
        value = _value(expression, parameters, joints)
    if type(value) is np.ndarray and value.shape == joints.shape[1:]:
        return value
    return np.full(joints.shape[1:], value, dtype=np.float64)


def matrices_at(
    entries: Sequence[Sequence[Expression]], parameters: Mapping[str, Any], joints: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return the values of a matrix at k points, (k, rows, columns); NaN or infinite where an entry has none.

    Args:
        parameters: the value of each parameter, one number or (k,) [m or rad].
        joints: (n, k) joint variables [rad or m].

    Raises:
        KeyError: a parameter has no value.
    """
    found = np.empty((joints.shape[1], len(entries), len(entries[0])))
    with np.errstate(all="ignore"):
        for r, row in enumerate(entries):
            for c, entry in enumerate(row):
                found[:, r, c] = _value(entry, parameters, joints)
    return found


def _value(node: Expression, parameters: Mapping[str, Any], joints: NDArray[np.float64]) -> Any:
    # comparing types is faster than a match, and there are many nodes
    if type(node) is Product:
        factors = node.factors
        value = _value(factors[0], parameters, joints)
        for factor in factors[1:]:
            value = value * _value(factor, parameters, joints)
        return value
    if type(node) is Call:
        function, arguments = node.function, node.arguments
        return _FUNCTIONS[function](*[_value(argument, parameters, joints) for argument in arguments])
    if type(node) is JointVariable:
        return joints[node.index - 1]
    if type(node) is Number:
        return node.value.numerator / node.value.denominator
    if type(node) is Parameter:
        return parameters[node.name]
    if type(node) is Sum:
        terms = node.terms
        value = _value(terms[0], parameters, joints)
        for term in terms[1:]:
            value = value + _value(term, parameters, joints)
        return value
    if type(node) is Power:
        raised = np.asarray(_value(node.base, parameters, joints), dtype=np.float64)
        exponent = node.exponent
        if exponent == 2:
            return raised * raised
        return raised ** (exponent.numerator / exponent.denominator)
    return math.pi
