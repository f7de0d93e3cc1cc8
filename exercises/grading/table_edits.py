"""Misconceptions about the table as a whole."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from itertools import combinations

from exercises.grading.substitution import substituted
from exercises.grading.work import Apply, Change, Extent, Work, change, with_rows
from kinematics.cells import AngleUnit
from kinematics.errors import ParameterError
from kinematics.expressions import Parameter
from kinematics.table import Convention, DHTable, JointType, NumericRow, NumericTable, bind

LENGTH_RATIOS = (1000.0, 0.001, 100.0, 0.01, 10.0, 0.1)
SMALLEST_EXTENT, LARGEST_EXTENT = 0.05, 300.0
# [rad] Nobody types more than a turn in radians.
CLEARLY_DEGREES = 2 * math.pi


def _every_row(edit: Callable[[NumericRow], NumericRow]) -> Apply:
    def apply(table: NumericTable, draw: int) -> Iterable[NumericTable]:
        return (with_rows(table, map(edit, table.rows)),)

    return apply


def _whole(work: Work, code: str, apply: Apply, cells: tuple[str, ...], **params: str) -> Change:
    touched = tuple((i, cell) for i in range(len(work.tables[0].rows)) for cell in cells)
    return change(code, apply, extent=Extent.TABLE, touched=touched, params=params)


def other_convention(work: Work) -> Iterator[Change]:
    """The other convention declared."""
    other = {Convention.STANDARD: Convention.MODIFIED, Convention.MODIFIED: Convention.STANDARD}
    declared = work.tables[0].convention

    def apply(table: NumericTable, draw: int) -> Iterable[NumericTable]:
        return (DHTable(convention=other[table.convention], rows=table.rows),)

    params = {"declared": declared.value, "meant": other[declared].value}
    yield change("convention", apply, extent=Extent.TABLE, params=params)


def all_in_degrees(work: Work) -> Iterator[Change]:
    """All angles, or all that can't be anything else, were meant in degrees."""
    if work.answer.angle_unit is not AngleUnit.RAD:
        return

    def large(angle: float) -> float:
        return math.radians(angle) if abs(angle) > CLEARLY_DEGREES else angle

    for unit in (math.radians, large):
        yield _whole(work, "angles_in_degrees", _every_row(_angles(unit)), ("alpha",))


def all_in_radians(work: Work) -> Iterator[Change]:
    """All angles, or all small enough to be so, were meant in radians."""
    if work.answer.angle_unit is not AngleUnit.DEG:
        return

    def small(angle: float) -> float:
        return math.degrees(angle) if abs(angle) <= math.radians(CLEARLY_DEGREES) + 1e-9 else angle

    for unit in (math.degrees, small):
        yield _whole(work, "angles_in_radians", _every_row(_angles(unit)), ("alpha",))


def _angles(unit: Callable[[float], float]) -> Callable[[NumericRow], NumericRow]:
    return lambda row: replace(row, alpha=unit(row.alpha), theta=unit(row.theta))


def all_in_other_length_unit(work: Work) -> Iterator[Change]:
    """All lengths in millimetres where metres are declared, and the like."""

    def scaled(ratio: float) -> Callable[[NumericRow], NumericRow]:
        return lambda row: replace(row, a=row.a * ratio, d=row.d * ratio)

    extent = sum(abs(row.a) + abs(row.d) for row in work.tables[0].rows)
    for ratio in LENGTH_RATIOS:
        if not SMALLEST_EXTENT < extent * ratio / work.references[0].size < LARGEST_EXTENT:
            continue
        yield _whole(work, "length_unit", _every_row(scaled(ratio)), ("a", "d"))


def all_twists_turned_round(work: Work) -> Iterator[Change]:
    """Every α with the other sign."""
    turned = sum(abs(math.sin(row.alpha)) > work.policy.tolerance.angle for row in work.tables[0].rows)
    if turned > 1:
        edit = _every_row(lambda row: replace(row, alpha=-row.alpha))
        yield _whole(work, "twists_all_reversed", edit, ("alpha",))


def columns_a_row_late(work: Work) -> Iterator[Change]:
    """A and α moved up by a row."""

    def apply(table: NumericTable, draw: int) -> Iterable[NumericTable]:
        rows = table.rows
        following = (*rows[1:], replace(rows[-1], a=0.0, alpha=0.0))
        return (
            with_rows(
                table, (replace(r, a=n.a, alpha=n.alpha) for r, n in zip(rows, following, strict=True))
            ),
        )

    yield _whole(work, "columns_late", apply, ("alpha", "a"))


def columns_a_row_early(work: Work) -> Iterator[Change]:
    """A and α moved down by a row."""

    def apply(table: NumericTable, draw: int) -> Iterable[NumericTable]:
        rows = table.rows
        before = (replace(rows[0], a=0.0, alpha=0.0), *rows[:-1])
        return (
            with_rows(table, (replace(r, a=b.a, alpha=b.alpha) for r, b in zip(rows, before, strict=True))),
        )

    yield _whole(work, "columns_early", apply, ("alpha", "a"))


EXCHANGES = (("a", "alpha"), ("a", "d"), ("alpha", "d"))
SYMBOLS = {"alpha": "α", "a": "a", "d": "d"}


def columns_exchanged(work: Work) -> Iterator[Change]:
    """Two columns exchanged throughout: the table in another order of columns.

    A number keeps what was typed: 90 under a, in a table in degrees, was a right angle.
    """
    unit = 180.0 / math.pi if work.answer.angle_unit is AngleUnit.DEG else 1.0

    def exchanged(one: str, other: str) -> Callable[[NumericRow], NumericRow]:
        def edit(row: NumericRow) -> NumericRow:
            if row.joint is JointType.PRISMATIC and "d" in (one, other):
                return row
            typed = {cell: getattr(row, cell) * (unit if cell == "alpha" else 1.0) for cell in (one, other)}
            changed = {one: typed[other], other: typed[one]}
            if "alpha" in changed:
                changed["alpha"] /= unit
            return replace(row, **changed)

        return edit

    for one, other in EXCHANGES:
        params = {"one": SYMBOLS[one], "other": SYMBOLS[other]}
        yield _whole(work, "columns_exchanged", _every_row(exchanged(one, other)), (one, other), **params)


def parameter_misnamed(work: Work) -> Iterator[Change]:
    """A name that the key doesn't know replaced by one of the key's that is not used."""
    kinds = work.key.parameters
    unknown = [name for name in work.answer.parameters if name not in kinds]
    unused = [name for name in kinds if name not in work.answer.parameters] or list(kinds)
    for name in unknown:
        for other in unused:
            if kinds[other] is work.answer.parameters[name]:
                yield _renamed(work, "parameter_misnamed", {name: other}, name)


def parameters_swapped(work: Work) -> Iterator[Change]:
    """Two names of the key used for one another."""
    used = [name for name in work.answer.parameters if name in work.key.parameters]
    for one, other in combinations(used, 2):
        if work.key.parameters[one] is work.key.parameters[other]:
            yield _renamed(work, "parameters_swapped", {one: other, other: one}, one, other=other)


def _renamed(work: Work, code: str, names: dict[str, str], name: str, **params: str) -> Change:
    table = substituted(
        work.comparison.meant_table, lambda found: Parameter(names[found]) if found in names else None
    )
    touched = tuple(
        (i, cell)
        for i, (old, new) in enumerate(zip(work.comparison.meant_table.rows, table.rows, strict=True))
        for cell in ("alpha", "a", "d")
        if getattr(old, cell) != getattr(new, cell)
    )

    def apply(_: NumericTable, draw: int) -> Iterable[NumericTable]:
        try:
            return (bind(table, work.comparison.draws[draw]),)
        except ParameterError:
            return ()

    extent = Extent.CELL if code == "parameter_misnamed" else Extent.ROW
    return change(code, apply, extent=extent, touched=touched, params={"name": name, **params})
