"""Misconceptions about the table as a whole."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import combinations

from exercises.grading.substitution import substituted
from exercises.grading.work import Change, Extent, Work
from kinematics.cells import AngleUnit
from kinematics.errors import ParameterError
from kinematics.expressions import Parameter
from kinematics.table import Convention, DHTable, JointType, NumericRow, bind

LENGTH_RATIOS = (1000.0, 0.001, 100.0, 0.01, 10.0, 0.1)
SMALLEST_EXTENT, LARGEST_EXTENT = 0.05, 300.0
# [rad] Nobody types more than a turn in radians.
CLEARLY_DEGREES = 2 * math.pi


def _every_row(
    work: Work, code: str, edit: Callable[[NumericRow], Mapping[str, float]], **params: str
) -> Change:
    """The cells of every row as functions of what stands in the row."""
    return _throughout(code, [edit(row) for row in work.table.rows], **params)


def _throughout(code: str, rows: Sequence[Mapping[str, float]], **params: str) -> Change:
    cells = tuple((i, cell, value) for i, row in enumerate(rows) for cell, value in row.items())
    touched = tuple((i, cell) for i, cell, _ in cells if cell != "theta")
    return Change(code, Extent.TABLE, cells=cells, touched=touched, params=tuple(params.items()))


def other_convention(work: Work) -> Iterator[Change]:
    """The other convention declared."""
    other = {Convention.STANDARD: Convention.MODIFIED, Convention.MODIFIED: Convention.STANDARD}
    declared = work.table.convention
    table = DHTable(convention=other[declared], rows=work.table.rows)
    params = (("declared", declared.value), ("meant", other[declared].value))
    yield Change("convention", Extent.TABLE, table=table, params=params)


def all_in_degrees(work: Work) -> Iterator[Change]:
    """All angles, or all that can't be anything else, were meant in degrees."""
    if work.answer.angle_unit is not AngleUnit.RAD:
        return

    def large(angle: float) -> float:
        return math.radians(angle) if abs(angle) > CLEARLY_DEGREES else angle

    for unit in (math.radians, large):
        yield _every_row(work, "angles_in_degrees", _angles(unit))


def all_in_radians(work: Work) -> Iterator[Change]:
    """All angles, or all small enough to be so, were meant in radians."""
    if work.answer.angle_unit is not AngleUnit.DEG:
        return

    def small(angle: float) -> float:
        return math.degrees(angle) if abs(angle) <= math.radians(CLEARLY_DEGREES) + 1e-9 else angle

    for unit in (math.degrees, small):
        yield _every_row(work, "angles_in_radians", _angles(unit))


def _angles(unit: Callable[[float], float]) -> Callable[[NumericRow], Mapping[str, float]]:
    return lambda row: {"alpha": unit(row.alpha), "theta": unit(row.theta)}


def all_in_other_length_unit(work: Work) -> Iterator[Change]:
    """All lengths in millimetres where metres are declared, and the like."""

    def scaled(ratio: float) -> Callable[[NumericRow], Mapping[str, float]]:
        return lambda row: {"a": row.a * ratio, "d": row.d * ratio}

    extent = sum(abs(row.a) + abs(row.d) for row in work.table.rows)
    for ratio in LENGTH_RATIOS:
        if not SMALLEST_EXTENT < extent * ratio / work.reference.size < LARGEST_EXTENT:
            continue
        yield _every_row(work, "length_unit", scaled(ratio))


def all_twists_turned_round(work: Work) -> Iterator[Change]:
    """Every α with the other sign."""
    turned = sum(abs(math.sin(row.alpha)) > work.policy.tolerance.angle for row in work.table.rows)
    if turned > 1:
        yield _every_row(work, "twists_all_reversed", lambda row: {"alpha": -row.alpha})


def columns_a_row_late(work: Work) -> Iterator[Change]:
    """A and α moved up by a row."""
    yield _throughout("columns_late", [*map(_along_x, work.table.rows[1:]), NOTHING_ALONG_X])


def columns_a_row_early(work: Work) -> Iterator[Change]:
    """A and α moved down by a row."""
    yield _throughout("columns_early", [NOTHING_ALONG_X, *map(_along_x, work.table.rows[:-1])])


NOTHING_ALONG_X = {"alpha": 0.0, "a": 0.0}


def _along_x(row: NumericRow) -> Mapping[str, float]:
    return {"alpha": row.alpha, "a": row.a}


EXCHANGES = (("a", "alpha"), ("a", "d"), ("alpha", "d"))
SYMBOLS = {"alpha": "α", "a": "a", "d": "d"}


def columns_exchanged(work: Work) -> Iterator[Change]:
    """Two columns exchanged throughout: the table in another order of columns.

    A number keeps what was typed: 90 under a, in a table in degrees, was a right angle.
    """
    unit = 180.0 / math.pi if work.answer.angle_unit is AngleUnit.DEG else 1.0

    def exchanged(one: str, other: str) -> Callable[[NumericRow], Mapping[str, float]]:
        def edit(row: NumericRow) -> Mapping[str, float]:
            if row.joint is JointType.PRISMATIC and "d" in (one, other):
                return {}
            typed = {cell: getattr(row, cell) * (unit if cell == "alpha" else 1.0) for cell in (one, other)}
            changed = {one: typed[other], other: typed[one]}
            if "alpha" in changed:
                changed["alpha"] /= unit
            return changed

        return edit

    for one, other in EXCHANGES:
        params = {"one": SYMBOLS[one], "other": SYMBOLS[other]}
        yield _every_row(work, "columns_exchanged", exchanged(one, other), **params)


def parameter_misnamed(work: Work) -> Iterator[Change]:
    """A name that the key doesn't know replaced by one of the key's that is not used."""
    kinds = work.key.parameters
    unknown = [name for name in work.answer.parameters if name not in kinds]
    unused = [name for name in kinds if name not in work.answer.parameters] or list(kinds)
    for name in unknown:
        for other in unused:
            if kinds[other] is work.answer.parameters[name]:
                yield from _renamed(work, "parameter_misnamed", {name: other}, name)


def parameters_swapped(work: Work) -> Iterator[Change]:
    """Two names of the key used for one another."""
    used = [name for name in work.answer.parameters if name in work.key.parameters]
    for one, other in combinations(used, 2):
        if work.key.parameters[one] is work.key.parameters[other]:
            yield from _renamed(work, "parameters_swapped", {one: other, other: one}, one, other=other)


def _renamed(work: Work, code: str, names: dict[str, str], name: str, **params: str) -> Iterator[Change]:
    exact = work.comparison.meant_table
    table = substituted(exact, lambda found: Parameter(names[found]) if found in names else None)
    touched = tuple(
        (i, cell)
        for i, (old, new) in enumerate(zip(exact.rows, table.rows, strict=True))
        for cell in ("alpha", "a", "d")
        if getattr(old, cell) != getattr(new, cell)
    )
    with suppress(ParameterError):
        numbers = bind(table, work.comparison.draws[work.draw])
        extent = Extent.CELL if code == "parameter_misnamed" else Extent.ROW
        shown = (("name", name), *params.items())
        yield Change(code, extent, table=numbers, touched=touched, params=shown)
