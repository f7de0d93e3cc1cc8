"""Misconceptions about whole rows."""

import math
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import combinations

from exercises.grading.edits.cell_edits import RIGHT_ANGLES
from exercises.grading.edits.changes import ROW_CELLS, Change, Extent, with_row, with_rows
from exercises.grading.edits.fitting import fitted_table
from exercises.grading.edits.last_row import last_row
from exercises.grading.edits.own_table import is_length_of
from exercises.grading.edits.work import Work
from exercises.grading.facts import NEARLY
from exercises.grading.judging.typed import Place
from kinematics.equivalence import ToolRule, ZeroRule
from kinematics.equivalence.batches import CellChange
from kinematics.se3 import cross, norm
from kinematics.table import CELLS, VARIABLE_CELLS, Convention, DHRow, JointType, NumericRow, NumericTable

# In longer tables only neighbouring rows are exchanged.
MOST_ROWS_FOR_ALL_PAIRS = 8
OTHER_TYPE = {JointType.REVOLUTE: JointType.PRISMATIC, JointType.PRISMATIC: JointType.REVOLUTE}
ALONG_X = ("alpha", "a")
UNSOLVED = {
    JointType.REVOLUTE: ("alpha", "a", "d"),
    JointType.PRISMATIC: ("alpha", "theta", "a"),
    JointType.FIXED: ("a", "d"),
}


def cells_swapped(work: Work) -> Iterator[Change]:
    """Exchange `a` and `d` of a row."""
    for i, row in work.rows_of_lengths:
        if row.a != row.d and row.joint is not JointType.PRISMATIC:
            cells = ((i, "a", row.d), (i, "d", row.a))
            yield Change("a_d_swapped", Extent.ROW, i, cells=cells, touched=((i, "a"), (i, "d")))


def twists_swapped(work: Work) -> Iterator[Change]:
    """Exchange α of neighbouring rows where neither alone may mend all, unless that exchanges the rows."""
    for i in range(len(work.table.rows) - 1):
        if work.is_near(i, i + 1) and not (work.is_near(i) or work.is_near(i + 1)):
            yield from twists_of(work, i)


def twists_of(work: Work, i: int) -> Iterator[Change]:
    """Exchange α of a row, from 0, and the next, unless they are alike or all else is."""
    one, other = work.table.rows[i : i + 2]
    apart = abs(math.remainder(one.alpha - other.alpha, math.pi)) > work.policy.tolerance.angle
    same = (one.joint, one.a, one.d, one.theta) == (other.joint, other.a, other.d, other.theta)
    if apart and not same:
        cells = ((i, "alpha", other.alpha), (i + 1, "alpha", one.alpha))
        params = (("other", i + 2),)
        touched = ((i, "alpha"), (i + 1, "alpha"))
        yield Change("twists_swapped", Extent.ROW, i, cells=cells, touched=touched, params=params)


def joint_of_other_type(work: Work) -> Iterator[Change]:
    """Make a revolute joint prismatic, or the reverse; any of them, if their count is not the key's."""
    wanted, given = work.reference.table.joint_types, work.table.joint_types
    for joint, index in enumerate(work.table.joint_rows):
        if len(wanted) != len(given) or wanted[joint] is not given[joint]:
            yield _of_type(work, "joint_type", index, OTHER_TYPE[given[joint]])


def joint_left_out(work: Work) -> Iterator[Change]:
    """Give a variable to a row without one, or the reverse."""
    before = 0
    for i, row in enumerate(work.table.rows if work.excess else ()):
        before += row.joint is not JointType.FIXED
        if row.joint is JointType.FIXED and work.excess < 0 and work.scope.is_place(before + 1):
            for joint in sorted(set(work.reference.table.joint_types)):
                yield _of_type(work, "joint_fixed", i, joint)
        elif row.joint is not JointType.FIXED and work.excess > 0 and work.scope.is_place(before):
            yield _of_type(work, "joint_moving", i, JointType.FIXED)


def _of_type(work: Work, code: str, index: int, joint: JointType) -> Change:
    """The row with another type of joint; where the variable stood, a constant is solved for."""
    row = work.table.rows[index]
    freed = VARIABLE_CELLS.get(row.joint)
    return Change(
        code,
        Extent.ROW,
        index,
        "joint",
        table=with_row(work.table, index, replace(row, joint=joint)),
        params=(("joint_type", joint.value),),
        unsolved=(freed,) if freed else (),
    )


def rows_swapped(work: Work) -> Iterator[Change]:
    """Exchange two rows; where only types are wrong, neighbours in line or a row with an offset of the key.

    A slider and a joint that turns about a parallel axis make the same motions in either order. An offset of
    the key beside a joint in the other row shows that the whole row has moved.
    """
    rows = work.table.rows
    entries = [(row.alpha, row.a, row.d, row.theta) for row in rows]
    kept = work.kept_rows
    farthest = len(rows) if len(rows) <= MOST_ROWS_FOR_ALL_PAIRS else 1
    for (i, one), (j, other) in combinations(enumerate(rows), 2):
        differ = one.joint is not other.joint or one.sign != other.sign
        if j - i > farthest or i in kept or j in kept or not work.is_near(i, j, moves=differ):
            continue
        if differ and work.has_wrong_types_alone:
            offset = max(one, other, key=lambda row: row.joint is JointType.REVOLUTE).d
            if not (is_length_of(work.reference.table, offset) or _commute(work, i, j)):
                continue
        cells: list[CellChange] = []
        table = None
        if not differ and work.scope.is_left_wrong(_both(i, j), _exchanged(rows, i, j)):
            continue
        if differ:
            order = list(rows)
            order[i], order[j] = other, one
            table = with_rows(work.table, order)
        else:
            for cell, upper, lower in zip(CELLS, entries[i], entries[j], strict=True):
                if upper != lower:
                    cells += (j, cell, upper), (i, cell, lower)
        if cells or table:
            params = (("other", j + 1),)
            yield Change("rows_swapped", Extent.ROW, i, None, tuple(cells), table, _both(i, j), params)


def ends_in_a_foreign_row(work: Work, exchange: Change) -> bool:
    """Return whether an exchange of rows puts what no row of the key has where no fact asks for it.

    Before the first joint is `a` and α of the first row of a modified table, behind the last one that of the
    last row of a standard one.
    """
    rows, exchanged = work.table.rows, {row for row, _ in exchange.places}
    modified = work.table.convention is Convention.MODIFIED
    end = 0 if modified else len(rows) - 1
    return end in exchanged and any(is_foreign(work, rows[row]) for row in exchanged - {end})


def is_foreign(work: Work, row: NumericRow, cells: Sequence[str] = ALONG_X) -> bool:
    """Return whether a row has a twist or a length that is neither nothing nor in any row of the key.

    Who lets an axis point the other way has π - α for a twist α of the key.
    """
    keys, tolerance = work.reference.table.rows, work.policy.tolerance
    twists = [twist for key in (0.0, *(abs(each.alpha) for each in keys)) for twist in (key, math.pi - key)]
    known = {
        "alpha": (tolerance.angle, twists),
        "a": (tolerance.length * work.reference.size, [0.0, *(abs(each.a) for each in keys)]),
    }
    return any(
        all(abs(abs(getattr(row, cell)) - value) > slack for value in values)
        for cell, (slack, values) in known.items()
        if cell in cells
    )


def _exchanged(rows: Sequence[NumericRow], i: int, j: int) -> Callable[[int, str], float]:
    """What the cells of two rows become where these are exchanged."""
    return lambda row, cell: getattr(rows[j if row == i else i], cell)


def _commute(work: Work, i: int, j: int) -> bool:
    """Whether joints of the key in two rows of a table follow each other along parallel axes."""
    first, *between = (joint for joint, row in enumerate(work.table.joint_rows) if i <= row <= j)
    axes = work.reference.chain.axes
    return between == [first + 1] and norm(cross(axes[first].direction, axes[first + 1].direction)) <= NEARLY


def _whole(row: int) -> tuple[Place, ...]:
    """The places of a row."""
    return tuple((row, cell) for cell in ROW_CELLS)


@lru_cache(maxsize=1024)
def _both(i: int, j: int) -> tuple[Place, ...]:
    """The places of two rows."""
    return tuple((k, cell) for k in (i, j) for cell in ROW_CELLS)


def row_too_many(work: Work) -> Iterator[Change]:
    """Remove a row."""
    rows = work.table.rows
    for i, row in enumerate(rows):
        moves = row.joint is not JointType.FIXED
        if len(rows) > 1 and work.excess == (1 if moves else 0) and (not moves or work.is_near(i)):
            yield Change("row_extra", Extent.ROW, i, table=with_rows(work.table, (*rows[:i], *rows[i + 1 :])))


def row_left_out(work: Work) -> Iterator[Change]:
    """Insert the row of a missing joint, with a twist and lengths that fit."""
    for place, joint in _places(work):
        yield from _put_in(work, "row_missing", place, joint, RIGHT_ANGLES)


def fixed_row_left_out(work: Work) -> Iterator[Change]:
    """Insert a last row without a variable, which the marked point or the tool frame needs."""
    rule = work.policy.tool
    if rule not in (ToolRule.POINT, ToolRule.FRAME) or not work.has_the_joints():
        return
    if rule is ToolRule.POINT and _leads_to_a_point(work):
        return
    angles = RIGHT_ANGLES if work.policy.tool is ToolRule.FRAME else RIGHT_ANGLES[:1]
    place = len(work.table.rows)
    if work.policy.tool is ToolRule.FRAME and not work.kept and (row := _forgotten(work)) is not None:
        whole = with_rows(work.table, (*work.table.rows, row))
        params = (("place", place + 1), ("after", place))
        yield Change("fixed_row_missing", Extent.ROW, place, None, (), whole, _whole(place), params)
        return
    for change in _put_in(work, "fixed_row_missing", place, JointType.FIXED, angles):
        for theta in angles:
            yield change._replace(cells=(*change.cells, (place, "theta", theta)))


def _leads_to_a_point(work: Work) -> bool:
    """Whether the last row leads to the marked point, or is meant to: what is wrong then stands in it.

    That is a row without a variable; or a standard one that moves along x, which its joint turns anywhere.
    """
    last = work.table.rows[-1]
    if last.joint is not JointType.REVOLUTE or not last.a:
        return last.joint is JointType.FIXED
    return work.table.convention is Convention.STANDARD and work.policy.zero is ZeroRule.FREE


def _forgotten(work: Work) -> NumericRow | None:
    """Return the row that leads to the tool's frame, if the key has more rows or the other convention."""
    key = work.reference.table
    if key.convention is work.table.convention and len(key.rows) <= len(work.table.rows):
        return None
    return last_row(work)


def _places(work: Work) -> Iterator[tuple[int, JointType]]:
    """Where a row with a joint may have been left out, and the type of the joint."""
    wanted, given = work.reference.table.joint_types, work.table.joint_types
    if len(wanted) != len(given) + 1:
        return
    for place in range(len(work.table.rows) + 1):
        before = sum(index < place for index in work.table.joint_rows)
        if work.scope.is_place(before + 1) and (*given[:before], wanted[before], *given[before:]) == wanted:
            yield place, wanted[before]


def _put_in(
    work: Work, code: str, place: int, joint: JointType, angles: tuple[float, ...]
) -> Iterator[Change]:
    """A row put in with each of some twists; its cells are yet to be solved for."""
    table = _with_blank(work.table, place, joint)
    touched = _whole(place)
    params = (("place", place + 1), ("after", place))
    for alpha in angles:
        cells = ((place, "alpha", alpha),)
        yield Change(code, Extent.ROW, place, None, cells, table, touched, params, UNSOLVED[joint])


def _with_blank(table: NumericTable, place: int, joint: JointType) -> NumericTable:
    blank = DHRow(joint=joint, theta=0.0, d=0.0, a=0.0, alpha=0.0)
    return with_rows(table, (*table.rows[:place], blank, *table.rows[place:]))


def any_row_left_out(work: Work, choice: int, places: Collection[int | None]) -> Iterator[Change]:
    """Insert a row as the whole robot asks for, if no single fact shows its cells.

    Args:
        work: the table.
        choice: see `fitted_table`.
        places: where a row may be put in, counted from 0: what has nothing to do with it fits.
    """
    for place, joint in _places(work):
        if place not in places:
            continue
        for change in _put_in(work, "row_missing", place, joint, RIGHT_ANGLES):
            cells = ("alpha", "a", "theta" if joint is JointType.PRISMATIC else "d")
            table = fitted_table(work, change.of(work.table), [(place, cell) for cell in cells], choice)
            if table is not None:
                yield change._replace(cells=(), table=table, unsolved=())
