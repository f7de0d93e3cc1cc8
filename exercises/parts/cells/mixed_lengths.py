"""Matrices in which lengths stand by name here and in numbers there: right for other lengths, too.

At the student's own values L2 + 0.1 may be L1. So the names that are used are given other values, except
those for whose value a number may stand. A matrix in which a length is a number alone says nothing of other
values.
"""

import math
from collections.abc import Iterator, Mapping, Sequence

from exercises.parts.cells.exactness import EITHER_WAY, EXACT, left_open
from exercises.parts.cells.symbolic_matrix import SymbolicMatrix
from exercises.parts.context import Context
from kinematics.cells import ParameterKind
from kinematics.errors import ParameterError
from kinematics.expressions import Expression, Number, Power, Product, Sum, evaluate, parameters_in, walk
from kinematics.table import JointType

STEP = 0.049
"""A share of the robot's size: the values of names differ from the student's each by another multiple."""


def other_lengths(
    context: Context, matrices: Sequence[SymbolicMatrix], values: Mapping[str, float]
) -> tuple[dict[str, float], float] | None:
    """Return lengths at which an answer must hold as well, and how nearly; None if it need not.

    Args:
        context: what the answer is judged by.
        values: of all names [the student's unit].

    Returns:
        Values of all names, and the share of the robot's size by which lengths may be off: as the decimals
        in the answer leave open, and no more than the policy allows.
    """
    lengths = [row[3] for matrix in matrices for row in matrix.entries[:3]]
    if any(_is_number(length, context.joint_types) for length in lengths):
        return None
    kinds = context.reference.parameters
    numbers = [abs(number) for length in lengths for number in _lengths_in(length)]
    near = context.policy.tolerance.length * context.size
    used = sorted(
        name
        for name in frozenset[str]().union(*map(parameters_in, lengths))
        if kinds.get(name) is ParameterKind.LENGTH
        and not any(abs(number - abs(values[name])) <= near for number in numbers)
    )
    if not used:
        return None
    others = {name: values[name] + (k + 2) * STEP * context.size for k, name in enumerate(used)}
    return {**values, **others}, min(context.policy.tolerance.length, _exactness(matrices, context.size))


def _is_number(length: Expression, joint_types: Sequence[JointType]) -> bool:
    """Whether a length holds no name and is there without any slide, too."""
    if parameters_in(length):
        return False
    joints = [0.0 if type_ is JointType.PRISMATIC else 0.3 + 0.7 * i for i, type_ in enumerate(joint_types)]
    try:
        return abs(evaluate(length, {}, joints)) > EXACT
    except ParameterError:
        return True


def _lengths_in(expression: Expression) -> Iterator[float]:
    """The numbers in an expression, but for the factors of names and for angles."""
    match expression:
        case Number(value) if value:
            yield float(value)
        case Sum(terms):
            for term in terms:
                yield from _lengths_in(term)
        case Product(factors):
            named = bool(parameters_in(expression))
            for factor in factors:
                if not (named and isinstance(factor, Number)):
                    yield from _lengths_in(factor)
        case Power(base):
            yield from _lengths_in(base)


def _exactness(matrices: Sequence[SymbolicMatrix], size: float) -> float:
    """By which share of the robot's size lengths may be off, for the decimals in an answer."""
    entries = [
        (entry, k == 3) for matrix in matrices for row in matrix.entries for k, entry in enumerate(row)
    ]
    off = 0.0
    for entry, is_length in entries:
        lengths = list(_lengths_in(entry)) if is_length else []
        off += sum(_step(length) / size for length in lengths)
        others = [abs(float(node.value)) for node in walk(entry) if isinstance(node, Number)]
        for length in lengths:
            if abs(length) in others:
                others.remove(abs(length))
        off += sum(map(_step, others))
    return max(EXACT, EITHER_WAY * off)


def _step(value: float) -> float:
    """By how much a number may be off for its decimals."""
    text = f"{abs(value):.12f}".rstrip("0")
    decimals = len(text) - text.index(".") - 1
    return left_open(abs(value), decimals) if 0 < decimals < 12 and math.isfinite(value) else 0.0
