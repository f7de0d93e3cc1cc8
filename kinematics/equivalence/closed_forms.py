"""Closed forms guessed from numbers: what a certificate's entries are, seen at several parameter draws.

A guess is all it is; the proof that follows shows whether it was right.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from itertools import combinations, islice, product

import numpy as np
from numpy.typing import NDArray

from kinematics.angles import nearest_twelfth
from kinematics.expressions import (
    ONE,
    ZERO,
    Expression,
    Function,
    Number,
    Pi,
    Product,
    add,
    call,
    evaluate,
    multiply,
    number,
    pi_fraction,
    pi_times,
    terms_of,
)
from kinematics.se3 import Floats
from kinematics.table import SymbolicTable

CLOSE = 1e-8
"""A share of the tables' lengths, or of 1: what the arithmetic leaves of a certificate's entry is some 1e-12,
and the closed forms that are tried lie much farther apart than this."""
DIGITS = 9  # Decimals of a number, at the size of 1: one more than CLOSE tells apart.
MOST_SUMS = 6_000
"""16 atoms have 5 024 sums and differences of one to three: with more atoms fewer terms are tried, so that
the work, and the memory, of a request do not grow with the cube of its names."""
MOST_TERMS = 3  # A coordinate of a frame is a sum of at most as many lengths.
MOST_ANGLE_SUMS = 300  # Every one of them is evaluated at every draw, for every revolute joint.


def length_atoms(tables: Iterable[SymbolicTable]) -> list[Expression]:
    """Return what the lengths of the tables are sums of, numbers and rational factors apart."""
    return _atoms(entry for table in tables for row in table.rows for entry in (row.a, row.d))


def angle_atoms(tables: Iterable[SymbolicTable]) -> list[Expression]:
    """Return what the angles of the tables are sums of, multiples of π and rational factors apart."""
    entries = [
        entry
        for table in tables
        for row in table.rows
        for entry in (row.theta, row.alpha)
        if pi_fraction(entry) is None
    ]
    constants = {abs(term.value) for entry in entries for term in terms_of(entry) if isinstance(term, Number)}
    return _atoms(entries) + [Number(value) for value in sorted(constants) if value]


def _atoms(entries: Iterable[Expression]) -> list[Expression]:
    found: dict[Expression, None] = {}
    for entry in entries:
        for term in terms_of(entry):
            rest = _unweighted(term)
            if not isinstance(rest, (Number, Pi)):
                found[rest] = None
    return list(found)


def _unweighted(term: Expression) -> Expression:
    if isinstance(term, Product) and isinstance(term.factors[0], Number):
        return multiply(term.factors[1:])
    return term


@lru_cache(maxsize=1)
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
    """Return the exact form of a small rational number, or of two cosines of multiples of π/12 multiplied."""
    key = round(value / CLOSE)
    known = _known_numbers()
    return known.get(key) or known.get(key - 1) or known.get(key + 1)


class LengthForms:
    """Closed forms of lengths, from their values at some draws of the parameters."""

    def __init__(
        self, atoms: Sequence[Expression], draws: Sequence[Mapping[str, float]], size: float
    ) -> None:
        """Prepare.

        Args:
            atoms: what the lengths may be sums of.
            draws: values of the parameters.
            size: the longest of the tables' lengths; 0 if they have none.
        """
        self._atoms = atoms[: MOST_SUMS // 2]
        values = [[evaluate(atom, draw) for draw in draws] for atom in self._atoms]
        self._values = np.array(values).reshape(len(self._atoms), len(draws))
        self._near = CLOSE * (size or 1.0)
        self._digits = DIGITS - math.ceil(math.log10(size or 1.0))
        which, signs = _sums(len(self._atoms))
        self._sums = np.einsum("sk,skd->sd", signs, self._values[which])

    def form(self, values: Sequence[float]) -> Expression | None:
        """Return the combination of atoms and of a decimal number that takes these values at the draws.

        A sum or difference of at most three atoms and a number is told by a few draws. If there are more
        draws than atoms, any linear combination with known coefficients is tried after that.
        """
        most = max(map(abs, values))
        if most < self._near:
            return ZERO
        near = max(self._near, CLOSE * most)
        several = len(values) > 1
        if (several or not self._atoms) and max(values) - min(values) < near:
            return self._decimal(values[0])
        rest = np.array(values) - self._sums
        (exact,) = np.nonzero(np.abs(rest).max(axis=1) < near)
        if exact.size:
            return self._sum(exact[0])
        (constant,) = np.nonzero(np.ptp(rest, axis=1) < near) if several else (exact,)
        if constant.size:
            return add((self._sum(constant[0]), self._decimal(rest[constant[0], 0])))
        return self._combination(np.array(values))

    def _sum(self, choice: int) -> Expression:
        which, signs = (table[choice].tolist() for table in _sums(len(self._atoms)))
        return add(
            multiply((number(int(sign)), self._atoms[atom]))
            for atom, sign in zip(which, signs, strict=True)
            if sign
        )

    def _combination(self, goal: Floats) -> Expression | None:
        basis = np.column_stack([self._values.T, np.ones(len(goal))])
        if basis.shape[0] < basis.shape[1]:
            return None
        weights, _, rank, _ = np.linalg.lstsq(basis, goal)
        near = max(self._near, CLOSE * float(np.abs(goal).max()))
        if rank < basis.shape[1] or np.abs(basis @ weights - goal).max() > near:
            return None
        *known, constant = weights.tolist()
        exact = [known_number(weight) for weight in known]
        if None in exact:
            return None
        parts = [
            multiply((weight, atom))
            for weight, atom in zip(exact, self._atoms, strict=True)
            if weight is not None
        ]
        return add([*parts, self._decimal(constant)])

    def _decimal(self, value: float) -> Expression:
        """The number with as many decimals as are more than the arithmetic's errors."""
        return Number(Fraction(repr(round(float(value), self._digits))))


@lru_cache(maxsize=32)
def _sums(n: int) -> tuple[NDArray[np.int16], NDArray[np.int8]]:
    """Sums and differences of one to three of n atoms, or of as many as keep their number bounded.

    Returns:
        (sums, 3) the atoms of each, and (sums, 3) their signs, 0 where there are fewer.
    """
    which: list[list[int]] = []
    signs: list[list[int]] = []
    for k in range(1, MOST_TERMS + 1):
        if len(which) + math.comb(n, k) * 2**k > MOST_SUMS:
            break
        for chosen in combinations(range(n), k):
            for signed in product((1, -1), repeat=k):
                which.append([*chosen, *[0] * (MOST_TERMS - k)])
                signs.append([*signed, *[0] * (MOST_TERMS - k)])
    shape = (len(which), MOST_TERMS)
    return np.array(which, dtype=np.int16).reshape(shape), np.array(signs, dtype=np.int8).reshape(shape)


def angle_form(
    values: Sequence[float], atoms: Sequence[Expression], draws: Sequence[Mapping[str, float]]
) -> Expression | None:
    """Return a multiple of π/12, plus or minus some of the atoms, that takes these values at these draws."""
    known = [[evaluate(atom, draw) for draw in draws] for atom in atoms]
    for chosen in islice(_choices(range(len(atoms))), MOST_ANGLE_SUMS):
        rest = list(values)
        for sign, i in chosen:
            rest = [value - sign * atom for value, atom in zip(rest, known[i], strict=True)]
        steps = {None if k is None else k % 24 for k in (nearest_twelfth(value, CLOSE) for value in rest)}
        step = steps.pop() if len(steps) == 1 else None
        if step is not None:
            turn = _multiple(step)
            return (
                add([turn, *(multiply((number(sign), atoms[i])) for sign, i in chosen)]) if chosen else turn
            )
    return None


@lru_cache(maxsize=24)
def _multiple(steps: int) -> Expression:
    """steps·π/12 in (-π, π], of steps in 0 … 23."""
    half_turns = Fraction(steps, 12)
    return pi_times(half_turns - 2 if half_turns > 1 else half_turns)


def _choices(atoms: Sequence[int]) -> Iterable[tuple[tuple[int, int], ...]]:
    """Sums of at most two atoms, by sign and number."""
    yield ()
    for i, one in enumerate(atoms):
        for sign in (1, -1):
            yield ((sign, one),)
            for other in atoms[:i]:
                yield ((sign, one), (1, other))
                yield ((sign, one), (-1, other))
