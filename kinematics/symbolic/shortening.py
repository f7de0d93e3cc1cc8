"""Entries in the shortest of three forms: as they are, multiplied out, and in their normal form.

Differentiating and multiplying matrices leaves sums such as c1²·c2² + s1² + c1²·s2², which is 1. Multiplied
out, with s² = 1 − c² for each angle, they become short again; the normal form also adds angles up.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

from kinematics.errors import FormSizeError
from kinematics.expressions import (
    Call,
    Expression,
    Function,
    Number,
    Parameter,
    add,
    call,
    joint_variables_in,
    multiply,
    power,
    walk,
)
from kinematics.symbolic.canonical import canonical
from kinematics.symbolic.nested import Arena
from kinematics.symbolic.polynomials import FIELD, Polynomial, PolynomialReader, Symbol
from kinematics.symbolic.size import count_operations
from kinematics.symbolic.writing import Matrix

_LIMIT = 3_000  # Products of terms that may be formed for the normal form of one entry.
_MANY = 24  # A polynomial of more terms than this is left: its normal form is longer.
_CIRCULAR = (Function.COS, Function.SIN)


def shortened(matrix: Matrix) -> Matrix:
    """Return a matrix of the same functions with each entry in the shortest form that is found."""
    angles = sorted(
        {
            node.arguments[0]
            for row in matrix
            for entry in row
            for node in walk(entry)
            if isinstance(node, Call) and node.function in _CIRCULAR
        },
        key=lambda angle: (sorted(joint_variables_in(angle)), repr(angle)),
    )
    arena, reader = Arena(), PolynomialReader()
    wholes: dict[Symbol, Expression] = {Parameter(f"{i}"): angle for i, angle in enumerate(angles)}
    for name, angle in wholes.items():
        reader.take(angle, name)
        for function in _CIRCULAR:
            arena.read(call(function, angle))

    def written(entry: Expression) -> Expression:
        forms = [
            arena.expression(arena.gathered(arena.read(form)))
            for form in _forms(entry, reader.copy(), wholes)
        ]
        return min(forms, key=lambda form: count_operations([form]))

    return tuple(tuple(map(written, row)) for row in matrix)


def _forms(
    entry: Expression, reader: PolynomialReader, wholes: Mapping[Symbol, Expression]
) -> Iterator[Expression]:
    yield entry
    polynomial = reader.read(entry)
    if polynomial is not None:
        factors = reader.factors(wholes)
        yield _nested(
            polynomial, [(f, place) for f, place in factors.items() if isinstance(f, Call)], factors
        )
        if len(polynomial) > _MANY:
            return
    try:
        yield canonical(entry, limit=_LIMIT).expression()
    except (FormSizeError, ZeroDivisionError):
        return


def _nested(
    polynomial: Polynomial, circles: Sequence[tuple[Expression, int]], factors: Mapping[Expression, int]
) -> Expression:
    """A polynomial by its first cosine or sine: this times all that it stands with, and the rest."""
    if len(polynomial) < 2 or not circles:
        return add(
            multiply(
                (Number(Fraction(weight)), *(power(f, key >> place & FIELD) for f, place in factors.items()))
            )
            for key, weight in polynomial.items()
        )
    (circle, place), *others = circles
    within = {key - (1 << place): weight for key, weight in polynomial.items() if key >> place & FIELD}
    rest = {key: weight for key, weight in polynomial.items() if not key >> place & FIELD}
    return add((multiply((circle, _nested(within, circles, factors))), _nested(rest, others, factors)))
