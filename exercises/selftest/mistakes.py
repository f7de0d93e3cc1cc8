"""What students get wrong, done to a right table; named as in the catalogue of misconceptions."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

from kinematics.cells import AngleUnit, LengthUnit, ReadTable
from kinematics.cells.substitution import substitute
from kinematics.expressions import (
    ZERO,
    Expression,
    Number,
    Parameter,
    add,
    multiply,
    negate,
    parameters_in,
    pi_fraction,
    pi_times,
    rational_value,
)
from kinematics.table import DHTable, JointType, SymbolicRow

QUARTER = pi_times(Fraction(1, 2))
_OTHER = {JointType.REVOLUTE: JointType.PRISMATIC, JointType.PRISMATIC: JointType.REVOLUTE}

Mistake = Callable[[ReadTable], Iterator[ReadTable]]  # Every way to make it in a table.


def _rows(read: ReadTable, rows: tuple[SymbolicRow, ...]) -> ReadTable:
    return replace(read, table=DHTable(convention=read.table.convention, rows=rows))


def _each_row(change: Callable[[SymbolicRow], SymbolicRow | None]) -> Mistake:
    """Return a mistake that is made in one row; None leaves a row as it is."""

    def made(read: ReadTable) -> Iterator[ReadTable]:
        for i, row in enumerate(read.table.rows):
            changed = change(row)
            if changed is not None and changed != row:
                yield _rows(read, (*read.table.rows[:i], changed, *read.table.rows[i + 1 :]))

    return made


def _but_slides(change: Callable[[SymbolicRow], SymbolicRow]) -> Mistake:
    """Return a mistake about d, which says nothing of a prismatic row: its variable stands there."""
    return _each_row(lambda row: None if row.joint is JointType.PRISMATIC else change(row))


def _twist_reversed(row: SymbolicRow) -> SymbolicRow | None:
    turns = pi_fraction(row.alpha)
    return None if turns is None or turns.denominator == 1 else replace(row, alpha=negate(row.alpha))


def _twist_changed(row: SymbolicRow) -> SymbolicRow:
    parallel = (pi_fraction(row.alpha) or Fraction(0)).denominator == 1
    return replace(row, alpha=add((row.alpha, QUARTER)) if parallel else ZERO)


def _turned(row: SymbolicRow) -> SymbolicRow | None:
    if row.joint is JointType.REVOLUTE:
        return None  # where a variable is zero is free more often than not
    return replace(row, theta=add((row.theta, QUARTER)))


def _rows_swapped(read: ReadTable) -> Iterator[ReadTable]:
    rows = read.table.rows
    for i in range(len(rows) - 1):
        if rows[i] != rows[i + 1]:
            yield _rows(read, (*rows[:i], rows[i + 1], rows[i], *rows[i + 2 :]))


def _twists_swapped(read: ReadTable) -> Iterator[ReadTable]:
    """α exchanged with the next row; of fixed rows between joints only what they come to counts."""
    rows = read.table.rows
    moves = all(row.joint is not JointType.FIXED for row in rows)
    for i, (one, other) in enumerate(pairwise(rows) if moves else ()):
        if one.alpha != other.alpha:
            both = replace(one, alpha=other.alpha), replace(other, alpha=one.alpha)
            yield _rows(read, (*rows[:i], *both, *rows[i + 2 :]))


def _turns_all_reversed(read: ReadTable) -> Iterator[ReadTable]:
    rows = read.table.rows
    if sum(row.joint is JointType.REVOLUTE for row in rows) > 1:
        turns = (replace(row, sign=-row.sign) if row.joint is JointType.REVOLUTE else row for row in rows)
        yield _rows(read, tuple(turns))


def _row_missing(read: ReadTable) -> Iterator[ReadTable]:
    rows = read.table.rows
    for i in range(len(rows)):
        if len(rows) > 1:
            yield _rows(read, (*rows[:i], *rows[i + 1 :]))


def _row_extra(read: ReadTable) -> Iterator[ReadTable]:
    rows = read.table.rows
    for i, row in enumerate(rows):
        if row.joint is not JointType.FIXED:
            yield _rows(read, (*rows[: i + 1], row, *rows[i + 1 :]))


def _convention(read: ReadTable) -> Iterator[ReadTable]:
    yield replace(read, table=replace(read.table, convention=read.table.convention.other))


def _twists_all_reversed(read: ReadTable) -> Iterator[ReadTable]:
    rows = tuple(replace(row, alpha=negate(row.alpha)) for row in read.table.rows)
    if rows != read.table.rows:
        yield _rows(read, rows)


def _twists_late(read: ReadTable) -> Iterator[ReadTable]:
    twists = [ZERO, *(row.alpha for row in read.table.rows[:-1])]
    yield _shifted(read, [(twist, row.a) for twist, row in zip(twists, read.table.rows, strict=True)])


def _twists_early(read: ReadTable) -> Iterator[ReadTable]:
    twists = [*(row.alpha for row in read.table.rows[1:]), ZERO]
    yield _shifted(read, [(twist, row.a) for twist, row in zip(twists, read.table.rows, strict=True)])


def _columns_late(read: ReadTable) -> Iterator[ReadTable]:
    yield _shifted(read, [(ZERO, ZERO), *((row.alpha, row.a) for row in read.table.rows[:-1])])


def _columns_early(read: ReadTable) -> Iterator[ReadTable]:
    yield _shifted(read, [*((row.alpha, row.a) for row in read.table.rows[1:]), (ZERO, ZERO)])


def _shifted(read: ReadTable, columns: list[tuple[Expression, Expression]]) -> ReadTable:
    rows = (replace(row, alpha=alpha, a=a) for row, (alpha, a) in zip(read.table.rows, columns, strict=True))
    return _rows(read, tuple(rows))


def _angles_in_degrees(read: ReadTable) -> Iterator[ReadTable]:
    """90 typed where radians are declared."""
    yield replace(_scaled_angles(read, to_degrees=True), angle_unit=AngleUnit.RAD)


def _angles_in_radians(read: ReadTable) -> Iterator[ReadTable]:
    """1.5708 typed where degrees are declared."""
    yield replace(_scaled_angles(read, to_degrees=False), angle_unit=AngleUnit.DEG)


def _scaled_angles(read: ReadTable, *, to_degrees: bool) -> ReadTable:
    def scaled(angle: Expression) -> Expression:
        turns = pi_fraction(angle)
        if turns is None:
            return angle
        if to_degrees:
            return Number(turns * 180)
        return pi_times(Fraction(repr(round(float(turns) * 3.141592653589793, 6))) / 180)

    rows = tuple(replace(row, alpha=scaled(row.alpha), theta=scaled(row.theta)) for row in read.table.rows)
    return _rows(read, rows)


def _length_unit(read: ReadTable) -> Iterator[ReadTable]:
    """Numbers in millimetres in a table in metres."""
    rows = tuple(
        replace(row, a=multiply((Number(Fraction(1000)), row.a)), d=multiply((Number(Fraction(1000)), row.d)))
        for row in read.table.rows
        if not parameters_in(row.a) and not parameters_in(row.d)
    )
    lengths = any(rational_value(entry) for row in rows for entry in (row.a, row.d))
    if len(rows) == len(read.table.rows) and lengths and read.length_unit is LengthUnit.M:
        yield _rows(read, rows)


def _parameters_swapped(read: ReadTable) -> Iterator[ReadTable]:
    for first, second in pairwise(tuple(read.parameters)):
        yield _renamed(read, {first: second, second: first})


def _parameter_misnamed(read: ReadTable) -> Iterator[ReadTable]:
    for name in read.parameters:
        yield _renamed(read, {name: f"{name}9"})


def _renamed(read: ReadTable, names: dict[str, str]) -> ReadTable:
    others = {name: Parameter(other) for name, other in names.items()}
    rows = tuple(
        replace(row, a=substitute(row.a, others), d=substitute(row.d, others)) for row in read.table.rows
    )
    kinds = {names.get(name, name): kind for name, kind in read.parameters.items()}
    return replace(_rows(read, rows), parameters=kinds)


MISTAKES: dict[str, Mistake] = {
    "convention": _convention,
    "angles_in_degrees": _angles_in_degrees,
    "angles_in_radians": _angles_in_radians,
    "length_unit": _length_unit,
    "columns_late": _columns_late,
    "columns_early": _columns_early,
    "twists_late": _twists_late,
    "twists_early": _twists_early,
    "parameter_misnamed": _parameter_misnamed,
    "parameters_swapped": _parameters_swapped,
    "alpha_sign": _each_row(_twist_reversed),
    "alpha_value": _each_row(_twist_changed),
    "twists_all_reversed": _twists_all_reversed,
    "twists_swapped": _twists_swapped,
    "turns_all_reversed": _turns_all_reversed,
    "a_sign": _each_row(lambda row: replace(row, a=negate(row.a))),
    "d_sign": _but_slides(lambda row: replace(row, d=negate(row.d))),
    "a_d_swapped": _but_slides(lambda row: replace(row, a=row.d, d=row.a)),
    "a_value": _each_row(lambda row: replace(row, a=ZERO)),
    "d_value": _but_slides(lambda row: replace(row, d=ZERO)),
    "theta_value": _each_row(_turned),
    "joint_type": _each_row(lambda row: replace(row, joint=_OTHER.get(row.joint, row.joint))),
    "joint_fixed": _each_row(lambda row: replace(row, joint=JointType.FIXED, sign=1)),
    "rows_swapped": _rows_swapped,
    "row_missing": _row_missing,
    "row_extra": _row_extra,
}
"""By the code of the misconception that undoes it."""
