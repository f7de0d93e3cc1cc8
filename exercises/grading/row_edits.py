"""Misconceptions about whole rows."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import combinations

from exercises.grading.cell_edits import RIGHT_ANGLES
from exercises.grading.fitting import fitted_tables, fitting_values
from exercises.grading.work import Apply, Change, Extent, Work, change, with_cell, with_row, with_rows
from kinematics.equivalence import ToolRule
from kinematics.table import DHRow, JointType, NumericRow, NumericTable

# In longer tables only neighbouring rows are exchanged.
MOST_ROWS_FOR_ALL_PAIRS = 8
_VARIABLE_CELLS = {JointType.REVOLUTE: "theta", JointType.PRISMATIC: "d"}
ORDERS = {
    JointType.REVOLUTE: (("alpha", "a", "d"), ("alpha", "d", "a")),
    JointType.PRISMATIC: (("alpha", "theta", "a"), ("theta", "alpha", "a")),
}


def cells_swapped(work: Work) -> Iterator[Change]:
    """A and d of a row exchanged."""

    def swapped_in(i: int) -> Apply:
        def apply(table: NumericTable, draw: int) -> Iterable[NumericTable]:
            row = table.rows[i]
            return (with_row(table, i, replace(row, a=row.d, d=row.a)),)

        return apply

    for i, row in enumerate(work.tables[0].rows):
        if row.a != row.d and row.joint is not JointType.PRISMATIC:
            touched = ((i, "a"), (i, "d"))
            yield change("a_d_swapped", swapped_in(i), extent=Extent.ROW, row=i, touched=touched)


def joint_of_other_type(work: Work) -> Iterator[Change]:
    """A revolute joint made prismatic, or the reverse."""
    wanted = work.references[0].table.joint_types
    given = work.tables[0].joint_types
    if len(wanted) != len(given):
        return
    for joint, index in enumerate(work.tables[0].joint_rows):
        if wanted[joint] is not given[joint]:
            yield _of_type(work, "joint_type", index, wanted[joint])


def joint_left_out(work: Work) -> Iterator[Change]:
    """A row without a variable given one, or the reverse."""
    wanted = work.references[0].table.joint_types
    given = work.tables[0].joint_types
    for i, row in enumerate(work.tables[0].rows):
        if row.joint is JointType.FIXED and len(given) < len(wanted):
            for joint in sorted(set(wanted)):
                yield _of_type(work, "joint_fixed", i, joint)
        elif row.joint is not JointType.FIXED and len(given) > len(wanted):
            yield _of_type(work, "joint_moving", i, JointType.FIXED)


def _of_type(work: Work, code: str, index: int, joint: JointType) -> Change:
    """The row with another type of joint; where the variable stood, a constant is solved for."""

    def apply(table: NumericTable, draw: int) -> Iterable[NumericTable]:
        first = with_row(table, index, replace(table.rows[index], joint=joint))
        freed = _VARIABLE_CELLS.get(table.rows[index].joint)
        yield first
        if freed is not None:
            for value in fitting_values(work, first, draw, index, freed):
                yield with_cell(first, index, freed, value)

    params = {"joint_type": joint.value}
    return change(code, apply, extent=Extent.ROW, row=index, cell="joint", params=params)


def rows_swapped(work: Work) -> Iterator[Change]:
    """Two rows exchanged."""
    rows = work.tables[0].rows

    def swapped(i: int, j: int) -> Apply:
        def apply(table: NumericTable, draw: int) -> Iterable[NumericTable]:
            order = list(table.rows)
            order[i], order[j] = order[j], order[i]
            return (with_rows(table, order),)

        return apply

    for i, j in combinations(range(len(rows)), 2):
        if rows[i] == rows[j] or (j > i + 1 and len(rows) > MOST_ROWS_FOR_ALL_PAIRS):
            continue
        touched = tuple((k, cell) for k in (i, j) for cell in ("alpha", "a", "d", "joint"))
        params = {"other": j + 1}
        yield change("rows_swapped", swapped(i, j), extent=Extent.ROW, row=i, touched=touched, params=params)


def row_too_many(work: Work) -> Iterator[Change]:
    """A row struck out."""

    def without(i: int) -> Apply:
        def apply(table: NumericTable, draw: int) -> Iterable[NumericTable]:
            return (with_rows(table, (*table.rows[:i], *table.rows[i + 1 :])),)

        return apply

    rows = work.tables[0].rows
    excess = work.tables[0].n_joints - work.references[0].table.n_joints
    for i, row in enumerate(rows):
        moves = row.joint is not JointType.FIXED
        if len(rows) > 1 and excess == (1 if moves else 0):
            yield change("row_extra", without(i), extent=Extent.ROW, row=i)


def row_left_out(work: Work) -> Iterator[Change]:
    """A row put in: of the joint that is missing, with a twist and lengths that fit."""
    wanted, given = work.references[0].table.joint_types, work.tables[0].joint_types
    places = len(work.tables[0].rows) + 1
    for place in range(places):
        joint = _missing(wanted, given, sum(index < place for index in work.tables[0].joint_rows))
        if joint is None:
            continue
        touched = tuple((place, cell) for cell in ("alpha", "a", "d", "joint"))
        params = {"place": place + 1, "after": place}
        for alpha in RIGHT_ANGLES:
            apply = _filled(work, place, DHRow(joint=joint, theta=0.0, d=0.0, a=0.0, alpha=alpha))
            yield change("row_missing", apply, extent=Extent.ROW, row=place, touched=touched, params=params)


def fixed_row_left_out(work: Work) -> Iterator[Change]:
    """A last row without a variable put in, which the marked point or the frame of the tool needs."""
    if work.policy.tool not in (ToolRule.POINT, ToolRule.FRAME):
        return
    if work.references[0].table.joint_types != work.tables[0].joint_types:
        return
    place = len(work.tables[0].rows)
    touched = tuple((place, cell) for cell in ("alpha", "a", "d", "joint"))
    params = {"place": place + 1, "after": place}
    for alpha in RIGHT_ANGLES if work.policy.tool is ToolRule.FRAME else RIGHT_ANGLES[:1]:
        blank = DHRow(joint=JointType.FIXED, theta=0.0, d=0.0, a=0.0, alpha=alpha)
        apply = _appended(work, blank)
        yield change("fixed_row_missing", apply, extent=Extent.ROW, row=place, touched=touched, params=params)


def _appended(work: Work, blank: NumericRow) -> Apply:
    def apply(table: NumericTable, draw: int) -> Iterable[NumericTable]:
        first = with_rows(table, (*table.rows, blank))
        for cells in (("a", "d"), ("d", "a")):
            yield from _solved(work, first, draw, len(table.rows), cells)

    return apply


def any_row_left_out(work: Work) -> Iterator[Change]:
    """A row put in as the whole robot asks for, where no single fact of it shows its cells."""
    wanted, given = work.references[0].table.joint_types, work.tables[0].joint_types
    for place in range(len(work.tables[0].rows) + 1):
        joint = _missing(wanted, given, sum(index < place for index in work.tables[0].joint_rows))
        if joint is None:
            continue
        touched = tuple((place, cell) for cell in ("alpha", "a", "d", "joint"))
        params = {"place": place + 1, "after": place}
        apply = _filled_as_a_whole(work, place, joint)
        yield change("row_missing", apply, extent=Extent.ROW, row=place, touched=touched, params=params)


def _filled_as_a_whole(work: Work, place: int, joint: JointType) -> Apply:
    cells = ("alpha", "a", "theta" if joint is JointType.PRISMATIC else "d")

    def apply(table: NumericTable, draw: int) -> Iterable[NumericTable]:
        for alpha in RIGHT_ANGLES:
            blank = DHRow(joint=joint, theta=0.0, d=0.0, a=0.0, alpha=alpha)
            first = with_rows(table, (*table.rows[:place], blank, *table.rows[place:]))
            if not _fits_elsewhere(work, first, draw, place):
                return
            yield from fitted_tables(work, first, draw, [(place, cell) for cell in cells])

    return apply


def _missing(wanted: tuple[JointType, ...], given: tuple[JointType, ...], before: int) -> JointType | None:
    """The type of the joint that is missing after so many, if one put in there makes the types right."""
    if len(wanted) != len(given) + 1 or (*given[:before], wanted[before], *given[before:]) != wanted:
        return None
    return wanted[before]


def _filled(work: Work, place: int, blank: NumericRow) -> Apply:
    """The row put in as it is, and with some of its cells solved for one after the other."""

    def apply(table: NumericTable, draw: int) -> Iterable[NumericTable]:
        first = with_rows(table, (*table.rows[:place], blank, *table.rows[place:]))
        if not _fits_elsewhere(work, first, draw, place):
            return
        for cells in ORDERS[blank.joint]:
            yield from _solved(work, first, draw, place, cells)

    return apply


def _fits_elsewhere(work: Work, table: NumericTable, draw: int, row: int) -> bool:
    """Whether everything fits that has nothing to do with a row's joint and its neighbours."""
    if table.joint_types != work.references[draw].table.joint_types:
        return False
    joint = table.joint_rows.index(row) + 1
    axes = work.axes(table)
    return all(
        max(invariant.axes) >= joint - 1 and min(invariant.axes) <= joint + 1
        for invariant in work.invariants[draw]
        if not invariant.fits(axes)
    )


def _solved(
    work: Work, table: NumericTable, draw: int, row: int, cells: tuple[str, ...]
) -> Iterator[NumericTable]:
    """The table, and those in which some cells, in this order, were given a value that fits."""
    yield table
    for k, cell in enumerate(cells):
        for value in fitting_values(work, table, draw, row, cell):
            yield from _solved(work, with_cell(table, row, cell, value), draw, row, cells[k + 1 :])
