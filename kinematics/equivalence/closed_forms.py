"""Closed forms guessed from numbers: what a certificate's entries are, seen at several parameter draws.

A guess is all it is; the proof that follows shows whether it was right.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from functools import cache
from itertools import combinations, product
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from kinematics.expressions import (
    ONE,
    ZERO,
    Expression,
    Function,
    Number,
    Pi,
    Product,
    Sum,
    add,
    call,
    evaluate,
    multiply,
    number,
    pi_times,
)
from kinematics.table import SymbolicTable

Matrix: TypeAlias = NDArray[np.float64]

CLOSE = 1e-8
DIGITS = 9
_STEP = math.pi / 12


def length_atoms(tables: Iterable[SymbolicTable]) -> list[Expression]:
    """What the lengths of the tables are sums of, numbers and rational factors apart."""
    return _atoms(entry for table in tables for row in table.rows for entry in (row.a, row.d))


def angle_atoms(tables: Iterable[SymbolicTable]) -> list[Expression]:
    """What the angles of the tables are sums of, multiples of π and rational factors apart."""
    entries = [entry for table in tables for row in table.rows for entry in (row.theta, row.alpha)]
    constants = {abs(term.value) for entry in entries for term in _terms(entry) if isinstance(term, Number)}
    return _atoms(entries) + [Number(value) for value in sorted(constants) if value]


def _terms(entry: Expression) -> tuple[Expression, ...]:
    return entry.terms if isinstance(entry, Sum) else (entry,)


def _atoms(entries: Iterable[Expression]) -> list[Expression]:
    found: dict[Expression, None] = {}
    for entry in entries:
        for term in _terms(entry):
            rest = _unweighted(term)
            if not isinstance(rest, Number | Pi):
                found[rest] = None
    return list(found)


def _unweighted(term: Expression) -> Expression:
    if isinstance(term, Product) and isinstance(term.factors[0], Number):
        return multiply(term.factors[1:])
    return term


@cache
def _known_numbers() -> dict[int, Expression]:
    """Products of two cosines of multiples of π/12, and small rational numbers, by their value."""
    roots: dict[int, Expression] = {1: ONE}
    roots |= {n: call(Function.SQRT, number(n)) for n in (2, 3, 6)}
    known: dict[int, Expression] = {}
    quarters = [Fraction(n, 4) for n in range(-12, 13)]
    eighths = [Fraction(n, 8) for n in range(-8, 9)]

    def keep(expression: Expression) -> None:
        known.setdefault(round(evaluate(expression) / CLOSE), expression)

    for root in roots.values():
        for weight in quarters + eighths:
            keep(multiply((Number(weight), root)))
    for one, other in ((1, 2), (1, 3), (2, 6), (1, 6), (2, 3)):
        for p in eighths:
            for q in eighths:
                keep(add((multiply((Number(p), roots[one])), multiply((Number(q), roots[other])))))
    return known


def known_number(value: float) -> Expression | None:
    """The exact form of a small rational number, or of a product of two cosines of multiples of π/12."""
    key = round(value / CLOSE)
    known = _known_numbers()
    return next((known[k] for k in (key, key - 1, key + 1) if k in known), None)


def length_form(
    values: Sequence[float], atoms: Sequence[Expression], draws: Sequence[Mapping[str, float]]
) -> Expression | None:
    """The combination of atoms, or of atoms and a decimal number, that takes these values at these draws.

    First a sum or difference of at most three atoms is tried, which a few draws suffice to tell; then, if
    there are more draws than atoms, any linear combination with known coefficients.
    """
    if max(map(abs, values)) < CLOSE:
        return ZERO
    matrix = np.array([[evaluate(atom, draw) for atom in atoms] for draw in draws]).reshape(
        len(draws), len(atoms)
    )
    goal = np.array(values)
    for signs in _few(len(atoms)):
        if np.abs(sum(sign * matrix[:, k] for k, sign in signs) - goal).max() < CLOSE * max(
            1.0, *map(abs, values)
        ):
            return add(multiply((number(sign), atoms[k])) for k, sign in signs)
    return _combination(goal, atoms, matrix)


@cache
def _few(n: int) -> tuple[tuple[tuple[int, int], ...], ...]:
    """Choices of one to three of n atoms, with signs."""
    return tuple(
        tuple(zip(chosen, signs, strict=True))
        for k in (1, 2, 3)
        for chosen in combinations(range(n), k)
        for signs in product((1, -1), repeat=k)
    )


def _combination(goal: Matrix, atoms: Sequence[Expression], matrix: Matrix) -> Expression | None:
    basis = np.column_stack([matrix, np.ones(len(goal))])
    if basis.shape[0] < basis.shape[1]:
        return None
    weights, _, rank, _ = np.linalg.lstsq(basis, goal, rcond=1e-10)
    scale = max(1.0, float(np.abs(goal).max()))
    if rank < basis.shape[1] or np.abs(basis @ weights - goal).max() > CLOSE * scale:
        return None
    *known, constant = weights.tolist()
    exact = [known_number(weight) for weight in known]
    decimal = Fraction(str(round(constant, DIGITS)))
    if None in exact or abs(float(decimal) - constant) > CLOSE * scale:
        return None
    parts = [
        multiply((weight, atom)) for weight, atom in zip(exact, atoms, strict=True) if weight is not None
    ]
    return add([*parts, Number(decimal)])


def angle_form(
    values: Sequence[float], atoms: Sequence[Expression], draws: Sequence[Mapping[str, float]]
) -> Expression | None:
    """A multiple of π/12, plus or minus some of the atoms, that takes these values at these draws."""
    for chosen in _choices(atoms):
        rest = [
            value - sum(sign * evaluate(atom, draw) for sign, atom in chosen)
            for value, draw in zip(values, draws, strict=True)
        ]
        steps = {round(value / _STEP) % 24 for value in rest}
        off = max(abs(value - _STEP * round(value / _STEP)) for value in rest)
        if len(steps) == 1 and off < CLOSE:
            turns = Fraction(steps.pop(), 12)
            half_turns = turns - 2 if turns > 1 else turns
            return add([pi_times(half_turns), *(multiply((number(sign), atom)) for sign, atom in chosen)])
    return None


def _choices(atoms: Sequence[Expression]) -> Iterable[tuple[tuple[int, Expression], ...]]:
    yield ()
    for i, one in enumerate(atoms):
        for sign in (1, -1):
            yield ((sign, one),)
            for other in atoms[:i]:
                yield ((sign, one), (1, other))
                yield ((sign, one), (-1, other))
