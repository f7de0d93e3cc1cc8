"""What a policy means for a robot: how many of the ways in which textbooks would write its table it accepts.

Textbooks differ in five things: the convention, where frame 0 is put, where the last frame is put, where
the joint variables are zero, and which way they count. Each is taken as the key has it and as another book
would, in every combination; those that differ are judged by the checker itself. Where x points between the
axes, and where the common normal of parallel axes is drawn, is free under every policy, and is not counted.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import product

from exercises.definition import Exercise
from exercises.grading import is_accepted
from exercises.selftest.variants import some_lengths, table_in
from kinematics.cells import ReadTable
from kinematics.chain import chain_of_table, size_of
from kinematics.expressions import ZERO, Expression, add, pi_times
from kinematics.table import Convention, DHTable, JointType, SymbolicRow, SymbolicTable, bind

Rows = tuple[SymbolicRow, ...]
Choice = Callable[[Rows, Expression], Rows]
QUARTER = pi_times(Fraction(1, 2))


@dataclass(frozen=True, kw_only=True, slots=True)
class PolicyAdmission:
    """How much a policy leaves free, for one robot.

    Attributes:
        choices: how many different tables textbooks would write.
        admitted: how many of them the policy accepts.
        free: what the policy leaves free: convention, base, tool, zero, direction.
        fixed: what it fixes.
    """

    choices: int
    admitted: int
    free: tuple[str, ...]
    fixed: tuple[str, ...]


def policy_admission(exercise: Exercise, values: Mapping[str, float]) -> PolicyAdmission:
    """Count the textbook choices that the exercise's policy accepts.

    Args:
        values: of its parameters; angles in [rad].
    """
    table = exercise.reference.table
    usual = size_of(chain_of_table(bind(table, values))) / 4
    by = some_lengths(table, usual)[-2]
    admitted: dict[SymbolicTable, tuple[tuple[bool, ...], bool]] = {}
    for changed, other in textbook_choices(table, by):
        if other not in admitted:
            read: ReadTable = replace(exercise.reference, table=other)
            accepted = is_accepted(exercise.reference, read, exercise.policy)
            admitted[other] = (changed, accepted)
    verdicts = dict(admitted.values())
    right = {changed for changed, ok in verdicts.items() if ok}
    free = tuple(
        name for k, name in enumerate(CHOICES) if any(_otherwise(k, changed) in right for changed in right)
    )
    fixed = tuple(
        name
        for k, name in enumerate(CHOICES)
        if name not in free and any(_otherwise(k, changed) in verdicts for changed in verdicts)
    )
    count = sum(accepted for _, accepted in admitted.values())
    return PolicyAdmission(choices=len(admitted), admitted=count, free=free, fixed=fixed)


def textbook_choices(
    table: SymbolicTable, by: Expression
) -> Iterator[tuple[tuple[bool, ...], SymbolicTable]]:
    """Yield what is done otherwise than in the key, and the table that it leads to."""
    for changed in product((False, True), repeat=len(CHOICES)):
        rows = table_in(table, Convention.MODIFIED).rows
        for choice, applies in zip(CHOICES.values(), changed, strict=True):
            rows = choice(rows, by) if applies else rows
        found: SymbolicTable = DHTable(convention=Convention.MODIFIED, rows=rows)
        standard = changed[0] is not (table.convention is Convention.STANDARD)
        yield changed, table_in(found, Convention.STANDARD if standard else Convention.MODIFIED)


def _otherwise(k: int, changed: tuple[bool, ...]) -> tuple[bool, ...]:
    return tuple(entry is not (i == k) for i, entry in enumerate(changed))


def _unchanged(rows: Rows, by: Expression) -> Rows:
    """Keep the rows: the convention is another way of writing them."""
    return rows


def _other_base(rows: Rows, by: Expression) -> Rows:
    """Put frame 0 on frame 1, as in Craig; where it is there already, at the foot of the axis."""
    first = rows[0]
    if first.joint is JointType.FIXED:
        return (replace(first, d=add((first.d, by))), *rows[1:])
    slides = first.joint is JointType.PRISMATIC
    moved = replace(first, alpha=ZERO, a=ZERO, d=first.d if slides else ZERO)
    if moved != first:
        return (moved, *rows[1:])
    return (replace(first, a=by) if slides else replace(first, d=by), *rows[1:])


def _other_end(rows: Rows, by: Expression) -> Rows:
    """Move the last frame along the last axis; without the tool, where a row leads to one."""
    *before, last = rows
    if last.joint is JointType.FIXED and before:
        return tuple(before)
    return (*before, replace(last, d=add((last.d, by)))) if last.joint is JointType.REVOLUTE else rows


def _other_zero(rows: Rows, by: Expression) -> Rows:
    """Shift the zero of joint 2 by a quarter turn, or a length."""
    i = _inner_joint(rows)
    row = rows[i]
    turns = row.joint is JointType.REVOLUTE
    moved = replace(row, theta=add((row.theta, QUARTER))) if turns else replace(row, d=add((row.d, by)))
    return (*rows[:i], moved, *rows[i + 1 :])


def _other_direction(rows: Rows, by: Expression) -> Rows:
    """Reverse the sense of joint 2."""
    i = _inner_joint(rows)
    return (*rows[:i], replace(rows[i], sign=-rows[i].sign), *rows[i + 1 :])


def _inner_joint(rows: Rows) -> int:
    """Return the row of joint 2, or of the only one: what joint 1 does, a free frame 0 could undo."""
    moving = [i for i, row in enumerate(rows) if row.joint is not JointType.FIXED]
    return moving[min(1, len(moving) - 1)]


CHOICES: dict[str, Choice] = {
    "convention": _unchanged,
    "base": _other_base,
    "tool": _other_end,
    "zero": _other_zero,
    "direction": _other_direction,
}
"""In what textbooks differ, and how."""
