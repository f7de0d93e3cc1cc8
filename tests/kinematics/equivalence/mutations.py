"""Wrong tables: a valid one with a single mistake of a known kind, made without the checker's help."""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from random import Random

from kinematics.table import Convention, DHRow, DHTable, JointType, NumericRow, NumericTable

TURNING = 1e-6


@dataclass(frozen=True)
class Mutation:
    """A mistake: its kind, the table that it leads to, and the rows (counted from 1) that it spoils."""

    kind: str
    table: NumericTable
    rows: tuple[int, ...]


def with_rows(table: NumericTable, rows: list[NumericRow]) -> NumericTable:
    return DHTable(convention=table.convention, rows=tuple(rows))


def _cells(
    kind: str, table: NumericTable, edit: Callable[[NumericRow], NumericRow | None]
) -> Iterator[Mutation]:
    for i, row in enumerate(table.rows):
        changed = edit(row)
        if changed is not None and changed != row:
            rows = [*table.rows[:i], changed, *table.rows[i + 1 :]]
            yield Mutation(kind, with_rows(table, rows), (i + 1,))


def _other_twist(row: NumericRow, rng: Random) -> NumericRow:
    choices = [
        a
        for a in (0.0, math.pi / 2, -math.pi / 2, math.pi)
        if abs(math.sin(a - row.alpha)) > 0.1 or math.cos(a - row.alpha) < 0
    ]
    return replace(row, alpha=rng.choice(choices))


def _type(row: NumericRow) -> NumericRow | None:
    other = {JointType.REVOLUTE: JointType.PRISMATIC, JointType.PRISMATIC: JointType.REVOLUTE}
    return replace(row, joint=other[row.joint]) if row.joint in other else None


def mutations(table: NumericTable, rng: Random) -> list[Mutation]:
    """Every kind of mistake of the catalogue, wherever it can be made."""
    scale = max((abs(x) for row in table.rows for x in (row.a, row.d)), default=0.0) or 1.0
    revolute = JointType.REVOLUTE
    found: list[Mutation] = []
    edits: dict[str, Callable[[NumericRow], NumericRow | None]] = {
        "alpha_sign": lambda r: replace(r, alpha=-r.alpha) if abs(math.sin(r.alpha)) > TURNING else None,
        "alpha_value": lambda r: _other_twist(r, rng),
        "a_sign": lambda r: replace(r, a=-r.a),
        "d_sign": lambda r: replace(r, d=-r.d) if r.joint is revolute else None,
        "a_missing": lambda r: replace(r, a=0.0),
        "d_missing": lambda r: replace(r, d=0.0) if r.joint is revolute else None,
        "a_value": lambda r: replace(r, a=r.a + scale * rng.choice((-1, 1)) * rng.uniform(0.1, 1.0)),
        "d_value": lambda r: (
            replace(r, d=r.d + scale * rng.choice((-1, 1)) * rng.uniform(0.1, 1.0))
            if r.joint is revolute
            else None
        ),
        "a_d_swapped": lambda r: replace(r, a=r.d, d=r.a) if r.joint is revolute else None,
        "cell_length_unit": lambda r: replace(r, a=r.a * rng.choice((1000.0, 0.001))),
        "cell_in_degrees": lambda r: replace(r, alpha=math.degrees(r.alpha)),
        "joint_type": _type,
        "joint_fixed": lambda r: (
            replace(r, joint=JointType.FIXED) if r.joint is not JointType.FIXED else None
        ),
    }
    for kind, edit in edits.items():
        found += _cells(kind, table, edit)
    found += _rows(table, rng, scale)
    found += _whole(table)
    return found


def _rows(table: NumericTable, rng: Random, scale: float) -> Iterator[Mutation]:
    rows = list(table.rows)
    for i in range(len(rows) - 1):
        swapped = [*rows[:i], rows[i + 1], rows[i], *rows[i + 2 :]]
        yield Mutation("rows_swapped", with_rows(table, swapped), (i + 1, i + 2))
    for i in range(len(rows)):
        if len(rows) > 1:
            yield Mutation("row_missing", with_rows(table, [*rows[:i], *rows[i + 1 :]]), (i + 1,))
        extra = DHRow(
            joint=rng.choice((JointType.REVOLUTE, JointType.PRISMATIC)),
            theta=0.0,
            d=scale * rng.uniform(0.1, 1.0),
            a=scale * rng.uniform(0.1, 1.0),
            alpha=rng.choice((math.pi / 2, -math.pi / 2, 0.0)),
        )
        yield Mutation("row_extra", with_rows(table, [*rows[:i], extra, *rows[i:]]), (i + 1,))


def _whole(table: NumericTable) -> Iterator[Mutation]:
    other = {Convention.STANDARD: Convention.MODIFIED, Convention.MODIFIED: Convention.STANDARD}
    rows = list(table.rows)
    yield Mutation("convention", DHTable(convention=other[table.convention], rows=table.rows), ())
    late = [
        replace(r, a=b.a, alpha=b.alpha)
        for r, b in zip(rows, [replace(rows[0], a=0.0, alpha=0.0), *rows], strict=False)
    ]
    early = [
        replace(r, a=b.a, alpha=b.alpha)
        for r, b in zip(rows, [*rows[1:], replace(rows[-1], a=0.0, alpha=0.0)], strict=True)
    ]
    if rows[-1].a == rows[-1].alpha == 0.0:
        yield Mutation("columns_late", with_rows(table, late), ())
    if rows[0].a == rows[0].alpha == 0.0:
        yield Mutation("columns_early", with_rows(table, early), ())
    degrees = [replace(r, alpha=math.degrees(r.alpha), theta=math.degrees(r.theta)) for r in rows]
    yield Mutation("angles_in_degrees", with_rows(table, degrees), ())
    yield Mutation(
        "length_unit", with_rows(table, [replace(r, a=r.a * 1000, d=r.d * 1000) for r in rows]), ()
    )
    if sum(abs(math.sin(r.alpha)) > TURNING for r in rows) > 1:
        yield Mutation(
            "twists_all_reversed", with_rows(table, [replace(r, alpha=-r.alpha) for r in rows]), ()
        )
