"""Reads expression trees as a caller of the API would."""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

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


def from_tree(tree: Mapping[str, Any]) -> Expression:
    """Return the expression that a tree stands for, by the description of the format in docs/symbolic.md."""
    return _READERS[tree["type"]](tree)


def _all(trees: Sequence[Mapping[str, Any]]) -> tuple[Expression, ...]:
    return tuple(from_tree(tree) for tree in trees)


_READERS: dict[str, Callable[[Mapping[str, Any]], Expression]] = {
    "number": lambda tree: Number(Fraction(tree["value"])),
    "pi": lambda tree: Pi(),
    "parameter": lambda tree: Parameter(tree["name"]),
    "variable": lambda tree: JointVariable(tree["index"]),
    "sum": lambda tree: Sum(_all(tree["terms"])),
    "product": lambda tree: Product(_all(tree["factors"])),
    "power": lambda tree: Power(from_tree(tree["base"]), Fraction(tree["exponent"])),
    "call": lambda tree: Call(Function(tree["function"]), _all(tree["arguments"])),
}
