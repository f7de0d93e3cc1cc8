"""What an expression is worth at many points at once."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
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
    Pi,
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
        expression: what to evaluate.
        parameters: the value of each parameter, one number or (k,) [m or rad].
        joints: (n, k) joint variables [rad or m].

    Raises:
        KeyError: a parameter has no value.
    """
    with np.errstate(all="ignore"):
        value = _value(expression, parameters, joints)
    return np.broadcast_to(np.asarray(value, dtype=np.float64), joints.shape[1:])


def _value(node: Expression, parameters: Mapping[str, Any], joints: NDArray[np.float64]) -> Any:
    match node:
        case Number(value):
            return value.numerator / value.denominator
        case Pi():
            return math.pi
        case Parameter(name):
            return parameters[name]
        case JointVariable(index):
            return joints[index - 1]
        case Sum(terms):
            return sum(_value(term, parameters, joints) for term in terms)
        case Product(factors):
            return math.prod(_value(factor, parameters, joints) for factor in factors)
        case Power(base, exponent):
            raised = np.asarray(_value(base, parameters, joints), dtype=np.float64)
            return raised ** (exponent.numerator / exponent.denominator)
        case Call(function, arguments):
            return _FUNCTIONS[function](*(_value(argument, parameters, joints) for argument in arguments))
