"""The key as other people would have written it.

Every rule below is an identity between products of elementary motions, so it holds for all joint values and
all dimensions. The rules are written for modified tables, Rot_x(α) Trans_x(a) Rot_z(θ) Trans_z(d) row by
row; a standard table is the same product read from another place in the row. Nothing here uses the grader.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction
from random import Random
from typing import Any

from exercises.grading import BaseRule, ConventionRule, DirectionRule, Policy, ToolRule, ZeroRule
from kinematics.cells import ReadTable
from kinematics.conversion import convert, fixed_row
from kinematics.expressions import ZERO, Expression, Number, Sum, add, multiply, negate, pi_fraction, pi_times
from kinematics.table import Convention, DHRow, DHTable, JointType, SymbolicRow, SymbolicTable

Rows = list[SymbolicRow]
Rule = Callable[[Rows, tuple[Expression, ...], Random], Rows]
HALF = pi_times(1)
EMPTY: SymbolicRow = DHRow(joint=JointType.FIXED, theta=ZERO, d=ZERO, a=ZERO, alpha=ZERO)


def variant(
    table: SymbolicTable, policy: Policy, lengths: tuple[Expression, ...], rng: Random
) -> SymbolicTable:
    """Return another right table for the same robot.

    Args:
        table: a right table.
        policy: what the table is held to; only what it leaves free is changed.
        lengths: lengths by which origins may be moved.
    """
    rows = list(table_in(table, Convention.MODIFIED).rows)
    for _ in range(rng.randint(2, 6)):
        rule = rng.choice(_rules(policy))
        rows = rule(rows, lengths, rng)
    return _as_written(table_in(_modified(rows), rng.choice(_conventions(policy))))


def small_changes(
    table: SymbolicTable, policy: Policy, lengths: tuple[Expression, ...], rng: Random
) -> Iterator[SymbolicTable]:
    """Yield right tables that differ from a right one in a single choice, in its own convention.

    See `variant`.
    """
    for rule in _rules(policy):
        if rule is _insert_row:
            continue  # a row that no joint needs teaches nothing
        rows = rule(list(table_in(table, Convention.MODIFIED).rows), lengths, rng)
        found = table_in(_modified(rows), table.convention)
        if found.convention is Convention.STANDARD and found.rows[-1] == EMPTY:
            found = replace(found, rows=found.rows[:-1])
        yield _as_written(found)


def _as_written(table: SymbolicTable) -> SymbolicTable:
    """Return the table without whole turns in its angles, which nobody would write: 540° is 180°."""
    rows = [
        replace(row, theta=_within_a_turn(row.theta), alpha=_within_a_turn(row.alpha)) for row in table.rows
    ]
    return replace(table, rows=tuple(rows))


def _within_a_turn(angle: Expression) -> Expression:
    """Return an angle whose multiple of π lies above -π and up to π."""
    terms = angle.terms if isinstance(angle, Sum) else (angle,)
    turns = [pi_fraction(term) for term in terms]
    rest = [term for term, turn in zip(terms, turns, strict=True) if turn is None]
    total = sum((turn for turn in turns if turn is not None), Fraction(0))
    return add((*rest, pi_times(1 - (1 - total) % 2)))


def key_as_asked(key: ReadTable, policy: Policy) -> ReadTable:
    """Return the key in a convention that the policy accepts: itself, or the other form of it."""
    if key.table.convention in _conventions(policy):
        return key
    return replace(key, table=table_in(key.table, _conventions(policy)[0]))


def table_in(table: SymbolicTable, convention: Convention) -> SymbolicTable:
    """Return the table with the same ⁰T_N in a convention; what a conversion leaves over is a fixed row."""
    found = convert(table, convention)
    before = [] if found.base is None else [fixed_row(found.base)]
    after = [] if found.tool is None else [fixed_row(found.tool)]
    return DHTable(convention=convention, rows=(*before, *found.table.rows, *after))


def _modified(rows: Rows) -> SymbolicTable:
    return DHTable(convention=Convention.MODIFIED, rows=tuple(rows))


def _conventions(policy: Policy) -> list[Convention]:
    if policy.convention is ConventionRule.ANY:
        return list(Convention)
    return [Convention(policy.convention.value)]


def _rules(policy: Policy) -> list[Rule]:
    rules: list[Rule] = [_turn_x, _turn_z, _slide_origin, _move_slide, _insert_row]
    if policy.zero is ZeroRule.FREE:
        rules.append(_other_zero)
    if policy.direction is DirectionRule.FREE:
        rules.append(_other_sense)
    if policy.base is BaseRule.FREE:
        rules.append(_other_base)
    if policy.tool in (ToolRule.FREE, ToolRule.AXIS):
        rules.append(_other_end)
    return rules


def _turn_x(rows: Rows, lengths: tuple[Expression, ...], rng: Random) -> Rows:
    """Reverse x_i: Rot_z(π) Rot_x(α) Trans_x(a) = Rot_x(-α) Trans_x(-a) Rot_z(π)."""
    if len(rows) < 2:
        return rows
    i = rng.randrange(len(rows) - 1)
    after = rows[i + 1]
    turned = replace(_more(after, theta=HALF), alpha=negate(after.alpha), a=negate(after.a))
    return _put(rows, i, _more(rows[i], theta=HALF), turned)


def _turn_z(rows: Rows, lengths: tuple[Expression, ...], rng: Random) -> Rows:
    """Reverse z_i: Rot_z(θ) Trans_z(d) Rot_x(π) = Rot_x(π) Rot_z(-θ) Trans_z(-d)."""
    if len(rows) < 2:
        return rows
    i = rng.randrange(len(rows) - 1)
    row = rows[i]
    turned = replace(_more(row, alpha=HALF), theta=negate(row.theta), d=negate(row.d), sign=-row.sign)
    return _put(rows, i, turned, _more(rows[i + 1], alpha=negate(HALF)))


def _slide_origin(rows: Rows, lengths: tuple[Expression, ...], rng: Random) -> Rows:
    """Slide origin i along parallel axes: Trans_z(c) passes Rot_x(0), and Rot_x(π) with the other sign."""
    places = [i for i, row in enumerate(rows[1:]) if _is_parallel(row.alpha)]
    if not places:
        return rows
    i, by = rng.choice(places), rng.choice(lengths)
    turned = pi_fraction(rows[i + 1].alpha) or Fraction(0)
    return _put(rows, i, _more(rows[i], d=by), _more(rows[i + 1], d=negate(by) if turned % 2 == 0 else by))


def _move_slide(rows: Rows, lengths: tuple[Expression, ...], rng: Random) -> Rows:
    """Move the axis of a prismatic joint: with θ = 0, Trans_x passes the slide."""
    slides = [i for i, row in enumerate(rows[:-1]) if row.joint is JointType.PRISMATIC]
    places = [i for i in slides if pi_fraction(rows[i].theta) == 0]
    if not places:
        return rows
    i, by = rng.choice(places), rng.choice(lengths)
    return _put(rows, i, _more(rows[i], a=by), _more(rows[i + 1], a=negate(by)))


def _insert_row(rows: Rows, lengths: tuple[Expression, ...], rng: Random) -> Rows:
    """Insert a row for a frame that no joint needs, which takes over part of the offset before it."""
    i, by = rng.randrange(len(rows)), rng.choice((ZERO, *lengths))
    return [*rows[:i], _more(rows[i], d=negate(by)), replace(EMPTY, d=by), *rows[i + 1 :]]


def _other_zero(rows: Rows, lengths: tuple[Expression, ...], rng: Random) -> Rows:
    """Shift the zero of a joint variable."""
    moving = [i for i, row in enumerate(rows) if row.joint is not JointType.FIXED]
    if not moving:
        return rows
    i = rng.choice(moving)
    if rows[i].joint is not JointType.REVOLUTE:
        return _put(rows, i, _more(rows[i], d=rng.choice(lengths)))
    turn = pi_times(Fraction(rng.choice((-6, -4, -3, -2, 2, 3, 4, 6, 12)), 12))
    return _put(rows, i, _more(rows[i], theta=turn))


def _other_sense(rows: Rows, lengths: tuple[Expression, ...], rng: Random) -> Rows:
    """Reverse the sense of a joint variable."""
    moving = [i for i, row in enumerate(rows) if row.joint is not JointType.FIXED]
    if not moving:
        return rows
    i = rng.choice(moving)
    return _put(rows, i, replace(rows[i], sign=-rows[i].sign))


def _other_base(rows: Rows, lengths: tuple[Expression, ...], rng: Random) -> Rows:
    """Move frame 0."""
    first, by = rows[0], rng.choice(lengths)
    if first.joint is JointType.FIXED:
        return _put(rows, 0, _more(first, d=by))
    twist = pi_times(Fraction(rng.choice((-6, 0, 6, 12)), 12))
    return _put(rows, 0, replace(first, alpha=twist, a=by if rng.random() < 0.5 else first.a))


def _other_end(rows: Rows, lengths: tuple[Expression, ...], rng: Random) -> Rows:
    """Move frame N along the axis of the last joint, if that is the last row."""
    if rows[-1].joint is not JointType.REVOLUTE:
        return rows
    return [*rows[:-1], _more(rows[-1], d=rng.choice(lengths))]


def _put(rows: Rows, i: int, *new: SymbolicRow) -> Rows:
    """Return the rows with those from row i on replaced."""
    return [*rows[:i], *new, *rows[i + len(new) :]]


def _more(row: SymbolicRow, **by: Expression) -> SymbolicRow:
    cells: dict[str, Any] = {cell: add((getattr(row, cell), more)) for cell, more in by.items()}
    return replace(row, **cells)


def _is_parallel(alpha: Expression) -> bool:
    turns = pi_fraction(alpha)
    return turns is not None and turns.denominator == 1


def some_lengths(table: SymbolicTable, usual: float) -> tuple[Expression, ...]:
    """Return lengths of about the robot's size: its own dimensions, and a round number."""
    own = {entry for row in table.rows for entry in (row.a, row.d) if entry != ZERO}
    step = Number(Fraction(round(usual * 10) or 1, 10) if usual >= 0.1 else Fraction(repr(round(usual, 4))))
    return (*sorted(own, key=repr), step, multiply((Number(Fraction(-1, 2)), step)))
