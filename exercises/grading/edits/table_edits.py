"""Misconceptions about the table as a whole."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import lru_cache
from itertools import combinations
from operator import neg

from exercises.grading.edits.changes import Change, Extent, with_rows
from exercises.grading.edits.row_edits import ALONG_X, ends_in_a_foreign_row, is_foreign
from exercises.grading.edits.work import Work
from exercises.grading.judging.typed import SAME, Place, meant_in_radians
from kinematics.cells import AngleUnit
from kinematics.equivalence import DirectionRule
from kinematics.errors import ParameterError
from kinematics.expressions import Expression, evaluate
from kinematics.table import ANGLES, LENGTHS, Convention, DHTable, JointType, NumericRow

LATE, EARLY = {"columns_late", "twists_late"}, {"columns_early", "twists_early"}
LENGTH_RATIOS = (1000.0, 0.001, 100.0, 0.01, 10.0, 0.1)
"""Metres, decimetres, centimetres and millimetres for one another, the likeliest first."""
SMALLEST_EXTENT, LARGEST_EXTENT = 0.05, 300.0
"""Parts of the robot's size, a sieve: what all lengths of a table come to, if it may be this robot at all."""
CLEARLY_DEGREES = math.tau  # [rad] Nobody types more than a turn in radians.


def _every_cell(
    work: Work, code: str, names: tuple[str, ...], edit: Callable[[float], float], **params: str
) -> Iterator[Change]:
    """Some cells of every row as a function of what stands in them; of nothing it makes nothing."""
    touching = tuple(name for name in names if name != "theta")
    if not work.leaves(touching):
        return iter(())
    rows = work.table.rows
    every = tuple(range(len(rows)))

    def becomes(row: int, name: str) -> float:
        here: float = getattr(rows[row], name)
        return edit(here) if here else here

    return _throughout(work, code, _places(every, names), becomes, _places(every, touching), **params)


def _throughout(
    work: Work,
    code: str,
    places: tuple[Place, ...],
    becomes: Callable[[int, str], float],
    touched: tuple[Place, ...],
    **params: str,
) -> Iterator[Change]:
    """One change of some columns; none if no cell is other than it was, or it is seen not to mend all."""
    if work.scope.is_left_wrong(places, becomes):
        return
    rows = work.table.rows
    cells = tuple((i, name, now) for i, name in places if (now := becomes(i, name)) != getattr(rows[i], name))
    if cells:
        yield Change(code, Extent.TABLE, cells=cells, touched=touched, params=tuple(params.items()))


@lru_cache(maxsize=256)
def _places(rows: tuple[int, ...], names: tuple[str, ...]) -> tuple[Place, ...]:
    """The places in some rows and columns; the same in all tables of an exercise."""
    return tuple((i, name) for i in rows for name in names)


def other_convention(work: Work) -> Iterator[Change]:
    """Declare the other convention."""
    other = {Convention.STANDARD: Convention.MODIFIED, Convention.MODIFIED: Convention.STANDARD}
    declared = work.table.convention
    table = DHTable(convention=other[declared], rows=work.table.rows)
    params = (("declared", declared.value), ("meant", other[declared].value))
    yield Change("convention", Extent.TABLE, table=table, params=params)


def all_in_degrees(work: Work) -> Iterator[Change]:
    """Read all angles, or all that can't be anything else, as degrees."""
    if work.answer.angle_unit is not AngleUnit.RAD:
        return

    def large(angle: float) -> float:
        return math.radians(angle) if abs(angle) > CLEARLY_DEGREES else angle

    for unit in (math.radians, large):
        yield from _every_cell(work, "angles_in_degrees", ANGLES, unit)


def all_in_radians(work: Work) -> Iterator[Change]:
    """Read all angles, or all that are small enough, as radians."""
    if work.answer.angle_unit is not AngleUnit.DEG:
        return

    def small(angle: float) -> float:
        return meant_in_radians(angle) if abs(angle) <= math.radians(CLEARLY_DEGREES) + SAME else angle

    for unit in (meant_in_radians, small):
        yield from _every_cell(work, "angles_in_radians", ANGLES, unit)


def all_in_other_length_unit(work: Work) -> Iterator[Change]:
    """Read all lengths in millimetres where metres are declared, and the like."""
    if work.scope.angular:
        return
    extent = sum(abs(row.a) + abs(row.d) for row in work.table.rows)
    for ratio in LENGTH_RATIOS:
        if SMALLEST_EXTENT < extent * ratio / work.reference.size < LARGEST_EXTENT:
            yield from _every_cell(work, "length_unit", LENGTHS, ratio.__mul__)


def all_twists_turned_round(work: Work) -> Iterator[Change]:
    """Flip the sign of every α."""
    turned = sum(abs(math.sin(row.alpha)) > work.policy.tolerance.angle for row in work.table.rows)
    if turned > 1:
        yield from _every_cell(work, "twists_all_reversed", ("alpha",), neg)


def all_turns_turned_round(work: Work) -> Iterator[Change]:
    """Count every joint angle the other way, if the figure says which way they count."""
    turning = sum(row.joint is JointType.REVOLUTE for row in work.table.rows)
    if work.policy.direction is DirectionRule.FIGURE and turning > 1:
        rows = [
            replace(row, sign=-row.sign) if row.joint is JointType.REVOLUTE else row
            for row in work.table.rows
        ]
        yield Change("turns_all_reversed", Extent.TABLE, table=with_rows(work.table, rows))


def columns_a_row_late(work: Work) -> Iterator[Change]:
    """Move `a` and α up by a row."""
    rows = work.table.rows
    return _along_x_of(work, "columns_late", [*rows[1:], None])


def columns_a_row_early(work: Work) -> Iterator[Change]:
    """Move `a` and α down by a row."""
    rows = work.table.rows
    return _along_x_of(work, "columns_early", [None, *rows[:-1]])


def twists_a_row_late(work: Work) -> Iterator[Change]:
    """Move α alone up by a row."""
    return _along_x_of(work, "twists_late", [*work.table.rows[1:], None], ("alpha",))


def twists_a_row_early(work: Work) -> Iterator[Change]:
    """Move α alone down by a row."""
    return _along_x_of(work, "twists_early", [None, *work.table.rows[:-1]], ("alpha",))


def _along_x_of(
    work: Work, code: str, others: Sequence[NumericRow | None], columns: tuple[str, ...] = ALONG_X
) -> Iterator[Change]:
    """A and α of every row, or one of them, as they stand in another, or zero."""
    if not work.leaves(columns):
        return iter(())
    # what stood in the row in which nothing stands now is lost, and may have to be put there again
    touched = _places(tuple(i for i, other in enumerate(others) if other is not None), columns)

    def becomes(row: int, name: str) -> float:
        other = others[row]
        return 0.0 if other is None else getattr(other, name)

    return _throughout(work, code, _places(tuple(range(len(others))), columns), becomes, touched)


def hides_an_entry(work: Work, change: Change) -> bool:
    """Return whether an entry that no key has is as good as none with a change of rows or of the whole table.

    A wrong twist or length is before the first joint and behind the last one, where an exchange of rows may
    put it, or the other convention, or columns a row early or late; and a small twist is that is read in
    degrees instead of radians.
    """
    if change.code == "rows_swapped":
        return change.table is None and ends_in_a_foreign_row(work, change)
    if change.code == "angles_in_degrees":
        least = work.policy.tolerance.angle
        return any(
            cell == "alpha" and abs(value) <= least < abs(work.table.rows[row].alpha)
            for row, cell, value in change.cells
        )
    late = change.code in LATE | ({"convention"} if work.table.convention is Convention.STANDARD else set())
    if not late and change.code not in EARLY | {"convention"}:
        return False
    row, cells = (0 if late else -1), ("alpha",) if change.code.startswith("twists") else ALONG_X
    return any(is_foreign(work, table.rows[row], cells) for table in (work.table, change.of(work.table)))


EXCHANGES = (("a", "alpha"), ("a", "d"), ("alpha", "d"))
TURNED_ROUND = ({"alpha": "a", "a": "d", "d": "alpha"}, {"alpha": "d", "d": "a", "a": "alpha"})
"""The other two orders of three columns: which one what stands under each of them belongs under."""
SYMBOLS = {"alpha": "α", "a": "a", "d": "d"}


def columns_exchanged(work: Work) -> Iterator[Change]:
    """Exchange two columns throughout: the table has another order of columns."""
    for one, other in EXCHANGES:
        params = {"one": SYMBOLS[one], "other": SYMBOLS[other]}
        yield from _in_order(work, "columns_exchanged", {one: other, other: one}, **params)


def columns_reordered(work: Work) -> Iterator[Change]:
    """Reorder three columns, none in its own place; with two of them empty, two are exchanged."""
    rows = work.table.rows
    if sum(any(getattr(row, column) for row in rows) for column in ("alpha", "a", "d")) < 2:
        return
    for belongs in TURNED_ROUND:
        params = {column: SYMBOLS[place] for column, place in belongs.items()}
        yield from _in_order(work, "columns_reordered", belongs, **params)


def _in_order(work: Work, code: str, belongs: dict[str, str], **params: str) -> Iterator[Change]:
    """What stands under some columns put under those where it belongs.

    A number keeps what was typed: 90 under a, in a table in degrees, was a right angle. A name is what it is
    under every column.
    """
    if (work.scope.angular and set(belongs) == set(LENGTHS)) or not work.scope.lacking <= belongs.keys():
        return
    if not work.leaves(tuple(belongs), prismatic="d" not in belongs):
        return
    rows = work.table.rows
    kept = JointType.PRISMATIC if "d" in belongs else None
    moving = tuple(i for i, row in enumerate(rows) if row.joint is not kept)
    units = {"alpha": 180.0 / math.pi if work.answer.angle_unit is AngleUnit.DEG else 1.0, "a": 1.0, "d": 1.0}
    moved = {place: (column, units[column] / units[place]) for column, place in belongs.items()}
    named = {place for place, _, _ in _named_entries(work)}

    def becomes(row: int, place: str) -> float:
        column, ratio = moved[place]
        here: float = getattr(rows[row], column)
        return here * ratio if here and (row, column) not in named else here

    places, touched = (_places(moving, tuple(columns)) for columns in (belongs.values(), belongs))
    yield from _throughout(work, code, places, becomes, touched, **params)


def parameter_misnamed(work: Work) -> Iterator[Change]:
    """Replace a name that the key doesn't know by one of the key's that is not used."""
    kinds = work.key.parameters
    unknown = [name for name in work.answer.parameters if name not in kinds]
    unused = [name for name in kinds if name not in work.answer.parameters] or list(kinds)
    entries = _named_entries(work) if unknown else ()
    for name in unknown:
        for other in unused:
            if kinds[other] is work.answer.parameters[name]:
                yield from _renamed(work, "parameter_misnamed", entries, {name: other}, name)


def parameters_swapped(work: Work) -> Iterator[Change]:
    """Exchange two names of the key."""
    used = [name for name in work.answer.parameters if name in work.key.parameters]
    entries = _named_entries(work) if len(used) > 1 else ()
    for one, other in combinations(used, 2):
        if work.key.parameters[one] is work.key.parameters[other]:
            names = {one: other, other: one}
            yield from _renamed(work, "parameters_swapped", entries, names, one, other=other)


def _named_entries(work: Work) -> Sequence[tuple[Place, Expression, frozenset[str]]]:
    """The entries of the answer itself with names in them; none of a table in which an edit has been made."""
    return work.comparison.named_entries if work.table is work.comparison.meant[work.draw] else ()


def _renamed(
    work: Work,
    code: str,
    entries: Sequence[tuple[Place, Expression, frozenset[str]]],
    names: dict[str, str],
    name: str,
    **params: str,
) -> Iterator[Change]:
    """Names put for one another, in the answer itself: the table in which each has the other's value."""
    values = work.comparison.draws[work.draw]
    values = {**values, **{old: values[new] for old, new in names.items() if new in values}}
    with suppress(ParameterError):
        cells = [
            (i, cell, now)
            for (i, cell), entry, found in entries
            if not found.isdisjoint(names)
            and not math.isclose(
                getattr(work.table.rows[i], cell), now := evaluate(entry, values), rel_tol=SAME
            )
        ]
        if cells:
            extent = Extent.CELL if code == "parameter_misnamed" else Extent.ROW
            touched = tuple((i, cell) for i, cell, _ in cells if cell != "theta")
            shown = (("name", name), *params.items())
            yield Change(code, extent, cells=tuple(cells), touched=touched, params=shown)
