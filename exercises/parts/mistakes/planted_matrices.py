"""Mistakes planted in a matrix of a table in closed form: which there are, and which of them a matrix shows.

The matrix of a row, or ⁰T_N, of a given table is one function of the joint variables, so what is wrong in
it is known entry by entry. A mistake may be called by every name whose doing gives the matrix that is shown.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cached_property, lru_cache, partial

import numpy as np

from kinematics.expressions import (
    ZERO,
    Call,
    Expression,
    Function,
    JointVariable,
    negate,
    parameters_in,
    with_parts,
)
from kinematics.expressions.arrays import values_at
from kinematics.se3 import Floats
from kinematics.symbolic import ClosedForm, Matrix, closed_form
from kinematics.symbolic.angles import angle_of, cosine_and_sine
from kinematics.symbolic.polynomials import PolynomialReader
from kinematics.symbolic.size import refuse_longer_than
from kinematics.table import DHTable, SymbolicTable

SAMPLES = 12
"""Points at which matrices are compared: random ones, at which two functions that differ agree nowhere."""
OPERATIONS = 5_000
"""Operations of ⁰T_N: nobody looks for a mistake in one that is longer, and it is evaluated many times."""
SAME = 1e-9  # Difference of two entries that are the same function, beside numbers of the order of one.
_COFUNCTIONS = {Function.SIN: Function.COS, Function.COS: Function.SIN}


class MatrixKind(StrEnum):
    """Which matrix is shown.

    LINK: that of one row. TRANSFORM: ⁰T_N.
    """

    LINK = "link"
    TRANSFORM = "transform"


@dataclass(frozen=True, kw_only=True, eq=False)
class PlantedMatrix:
    """A matrix with a mistake in it.

    It belongs to a row `link`, from 0, or is ⁰T_N if that is None.
    """

    right: Matrix
    shown: Matrix
    code: str
    link: int | None

    @cached_property
    def wrong_cells(self) -> frozenset[tuple[int, int]]:
        """The entries that are wrong, from 0."""
        return differing(self.shown, self.right)

    def shows(self, code: str, table: SymbolicTable) -> bool:
        """Return whether the mistake may be called by a name: whether doing that gives the matrix."""
        return code == self.code or _shows(self, code, table)


@lru_cache(maxsize=512)
def _shows(planted: PlantedMatrix, code: str, table: SymbolicTable) -> bool:
    ways = _ways_of(code, planted.right, table, planted.link)
    return any(not differing(way, planted.shown) for way in ways)


Way = Callable[[Matrix], Iterator[Matrix]]


def differing(first: Matrix, second: Matrix) -> frozenset[tuple[int, int]]:
    """Return the entries in which two matrices are different functions.

    Polynomials in sines and cosines are equal if their normal forms are; others are compared at points.
    """
    reader = PolynomialReader()
    found: set[tuple[int, int]] = set()
    unread: dict[tuple[int, int], tuple[Expression, Expression]] = {}
    for r, (ours, theirs) in enumerate(zip(first, second, strict=True)):
        for c, (a, b) in enumerate(zip(ours, theirs, strict=True)):
            one, other = reader.read(a), reader.read(b)
            if one is None or other is None:
                unread[r, c] = a, b
            elif one != other:
                found.add((r, c))
    names = frozenset[str]().union(*(parameters_in(entry) for pair in unread.values() for entry in pair))
    parameters, joints = _points(tuple(sorted(names)))
    for place, (a, b) in unread.items():
        gap = values_at(a, parameters, joints) - values_at(b, parameters, joints)
        if not bool((np.abs(gap) <= SAME).all()):
            found.add(place)
    return frozenset(found)


@lru_cache(maxsize=64)
def _points(names: tuple[str, ...]) -> tuple[Mapping[str, Floats], Floats]:
    """Return values of some parameters, (SAMPLES,) each, and of 64 joint variables, (64, SAMPLES)."""
    rng = np.random.default_rng(17)
    parameters = {name: rng.uniform(0.3, 1.3, SAMPLES) for name in names}
    return parameters, rng.uniform(-2.0, 2.0, (64, SAMPLES))


def _entry(change: Callable[[Expression], Expression | None], columns: range) -> Way:
    """Return the ways to change one entry in some columns."""

    def ways(matrix: Matrix) -> Iterator[Matrix]:
        for r in range(3):
            for c in columns:
                changed = change(matrix[r][c])
                if changed is not None:
                    yield (*matrix[:r], (*matrix[r][:c], changed, *matrix[r][c + 1 :]), *matrix[r + 1 :])

    return ways


def _sign(entry: Expression) -> Expression | None:
    return None if entry == ZERO else negate(entry)


def _without(entry: Expression) -> Expression | None:
    return None if entry == ZERO else ZERO


def _sine_for_cosine(entry: Expression) -> Expression | None:
    """Return an entry with sine and cosine exchanged throughout; None of one without them."""
    changed = _exchanged(entry)
    return None if changed == entry else changed


def _exchanged(entry: Expression) -> Expression:
    if isinstance(entry, Call) and entry.function in _COFUNCTIONS:
        return Call(_COFUNCTIONS[entry.function], entry.arguments)
    return with_parts(entry, _exchanged)


def _transposed(matrix: Matrix) -> Iterator[Matrix]:
    yield (*((*(matrix[c][r] for c in range(3)), matrix[r][3]) for r in range(3)), matrix[3])


_ENTRIES: Mapping[str, Way] = {
    "entry_sign": _entry(_sign, range(3)),
    "sine_for_cosine": _entry(_sine_for_cosine, range(3)),
    "position_sign": _entry(_sign, range(3, 4)),
    "position_missing": _entry(_without, range(3, 4)),
    "position_sine_for_cosine": _entry(_sine_for_cosine, range(3, 4)),
    "rotation_transposed": _transposed,
}
"""Mistakes that are made in a matrix itself."""
MATRIX_MISTAKES: Mapping[MatrixKind, tuple[str, ...]] = {
    MatrixKind.LINK: (*_ENTRIES, "matrix_other_convention"),
    MatrixKind.TRANSFORM: (*_ENTRIES, "link_missing"),
}
"""The catalogue of each kind of matrix."""


@lru_cache(maxsize=512)
def plantable_in(table: SymbolicTable, kind: MatrixKind, code: str) -> tuple[PlantedMatrix, ...]:
    """Return the ways to make a mistake in the matrices of a table that change one of them."""
    form = _form(table)
    if kind is MatrixKind.TRANSFORM:
        refuse_longer_than(OPERATIONS, (entry for row in form.transform for entry in row))
    rights: list[tuple[int | None, Matrix]] = [(None, form.transform)]
    if kind is MatrixKind.LINK:
        rights = list(enumerate(form.links))
    return tuple(
        PlantedMatrix(right=right, shown=way, code=code, link=link)
        for link, right in rights
        for way in _ways_of(code, right, table, link)
        if differing(way, right)
    )


def _ways_of(code: str, right: Matrix, table: SymbolicTable, link: int | None) -> Iterator[Matrix]:
    if code in _ENTRIES:
        yield from _ENTRIES[code](right)
    elif code == "matrix_other_convention" and link is not None:
        yield _form(replace(table, convention=table.convention.other)).links[link]
    elif code == "link_missing" and link is None:
        for i, row in enumerate(table.rows):
            # a row that does nothing keeps the numbers of the joints after it
            still = replace(row, theta=ZERO, d=ZERO, a=ZERO, alpha=ZERO)
            rows = (*table.rows[:i], still, *table.rows[i + 1 :])
            yield _still(DHTable(convention=table.convention, rows=rows), table, i)


def _still(emptied: SymbolicTable, table: SymbolicTable, row: int) -> Matrix:
    """Return ⁰T_N of a table with one row left out, the joint variables keeping their numbers."""
    transform = _form(emptied).transform
    if row not in table.joint_rows:
        return transform
    joint = JointVariable(table.joint_rows.index(row) + 1)
    return tuple(tuple(_at_zero(entry, joint) for entry in line) for line in transform)


def _at_zero(entry: Expression, joint: JointVariable) -> Expression:
    """Return an entry with a joint variable set to zero."""
    if entry == joint:
        return ZERO
    if isinstance(entry, Call) and entry.function in _COFUNCTIONS:
        cosine, sine = cosine_and_sine(angle_of(_at_zero(entry.arguments[0], joint)))
        return cosine if entry.function is Function.COS else sine
    return with_parts(entry, partial(_at_zero, joint=joint))


@lru_cache(maxsize=128)
def _form(table: SymbolicTable) -> ClosedForm:
    return closed_form(table)
