"""Wrong tables with one mistake: is it found, and in the right row?"""

import logging
import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import cache
from random import Random

from exercises.grading import Policy, Repair, ToolRule, grade
from exercises.grading.edits.changes import Extent
from exercises.grading.edits.misconceptions import CATALOGUE
from exercises.grading.explanation import work_on
from exercises.grading.facts import Weights
from exercises.grading.judging.comparison import comparisons
from exercises.grading.standard import standard_of, wrong_of
from kinematics.cells import ReadTable
from kinematics.equivalence.reference import prepared
from kinematics.table import DHRow, DHTable, JointType, NumericTable
from tests.exercises.grading.written import written
from tests.kinematics.equivalence.campaign import TABLES_PER_BLOCK, Outcome, catalogue, references
from tests.kinematics.equivalence.generators import random_valid_table
from tests.kinematics.equivalence.mutations import Mutation, mutations
from tests.kinematics.equivalence.tables import changed

MISTAKES_PER_TABLE = 10
LONGEST = 4.0
ATTEMPTS = 20


class _Kept(logging.Handler):
    """Keeps what is logged."""

    def __init__(self) -> None:
        super().__init__(logging.ERROR)
        self.told: list[str] = []

    def emit(self, record: logging.LogRecord) -> None:
        error = record.exc_info[1] if record.exc_info else None
        self.told.append(f"{record.getMessage()}: {error!r}")


@contextmanager
def lost_explanations() -> Iterator[list[str]]:
    """What failed in explaining answers meanwhile: their verdicts stand, so nothing is raised."""
    handler, log = _Kept(), logging.getLogger("exercises.grading")
    log.addHandler(handler)
    try:
        yield handler.told
    finally:
        log.removeHandler(handler)


def mended_tables(block: int) -> Outcome:
    """One mistake of the catalogue in a valid table: a single edit mends it, in the right row.

    An answer that is right in spite of the mistake (the sign of an α that another sign makes up for) counts
    as accepted. Failures are mistakes for which no single edit was found, or none in the right row.
    """
    rng = Random(f"mended {block}")
    known = references()
    outcome = Outcome()
    while outcome.tables < TABLES_PER_BLOCK:
        name, reference = rng.choice(known)
        key = written(reference)
        table = drawn_by_hand(reference, rng)
        if table is None:
            continue
        made = mutations(table, rng)
        for mutation in rng.sample(made, min(MISTAKES_PER_TABLE, len(made))):
            verdict = grade(key, written(mutation.table), Policy(tool=ToolRule.FREE))
            if verdict.correct:
                outcome.accepted += 1
                continue
            outcome.tables += 1
            outcome.kinds[mutation.kind] += 1
            outcome.mended += any(len(repair.edits) == 1 for repair in verdict.repairs)
            outcome.right_row += is_mended(mutation, verdict.repairs)
            if not is_mended(mutation, verdict.repairs):
                outcome.failures.append(
                    f"{name}, block {block}, {mutation.kind} in {mutation.rows}: {verdict.repairs[:2]}"
                )
    return outcome


def drawn_by_hand(reference: NumericTable, rng: Random) -> NumericTable | None:
    """A valid table as a person might draw it: no length many times the robot's size."""
    for _ in range(ATTEMPTS):
        table = random_valid_table(reference, rng, dummies=0.0, signed_rows=False, textbook_ends=True)
        longest = max(abs(length) for row in table.rows for length in (row.a, row.d))
        if longest <= LONGEST * prepared(reference).size:
            return table
    return None


def redrawn(wrong: NumericTable, key: NumericTable, rng: Random) -> NumericTable | None:
    """A wrong table in other frames; a slider that should turn stays on the line on which it was drawn.

    Elsewhere it would still be that slider, but not a joint of the key with a wrong type.
    """
    types = dict(zip(wrong.joint_rows, key.joint_types, strict=True))
    turning = {i for i, joint in types.items() if joint is JointType.REVOLUTE}
    drawn = drawn_by_hand(_of_types(wrong, dict.fromkeys(turning, JointType.REVOLUTE)), rng)
    if drawn is None:
        return None
    return _of_types(drawn, dict(zip(drawn.joint_rows, wrong.joint_types, strict=True)))


def _of_types(table: NumericTable, types: dict[int, JointType]) -> NumericTable:
    rows = (replace(row, joint=types.get(i, row.joint)) for i, row in enumerate(table.rows))
    return replace(table, rows=tuple(rows))


def is_mended(mutation: Mutation, repairs: tuple[Repair, ...]) -> bool:
    """Whether a single edit was found, in the right row."""
    single = [repair.edits[0] for repair in repairs if len(repair.edits) == 1]
    rows = {edit.row for edit in single} | {edit.params.get("other") for edit in single}
    return bool(single) and (not mutation.rows or bool(rows & set(mutation.rows)))


MOST_WRONG = 5
PADDED = 0.2
IN_KEY_FRAMES = 0.3
WITH_A_TYPE = 0.5
PADDING = DHRow(joint=JointType.FIXED, theta=0.0, d=0.0, a=0.0, alpha=0.0)


def score_chains(block: int, tables: int = TABLES_PER_BLOCK) -> Outcome:
    """Tables with one more cell wrong every time, each drawn in other frames: the score never rises.

    The cells are changed in the key's own frames, each once and by a random amount, so that no change undoes
    another; one of them may be the type of a joint. Then the robot that results is drawn as a person would,
    or stays in the key's frames. Failures are scores that rise or that depend on rows of zeros, and tables of
    zeros that earn anything.
    """
    rng = Random(f"chains {block}")
    known = references()
    outcome = Outcome()
    while outcome.tables < tables:
        name, reference = rng.choice(known)
        key, policy = written(reference), Policy(tool=ToolRule.FREE)
        outcome.tables += 1
        zeros = DHTable(
            convention=reference.convention,
            rows=tuple(replace(row, theta=0.0, d=0.0, a=0.0, alpha=0.0) for row in reference.rows),
        )
        verdict = grade(key, written(zeros), policy)
        if not verdict.correct and verdict.score != 0.0:
            outcome.failures.append(f"zeros earn {verdict.score}: {name}")
        before, elsewhere, types = 1.0, rng.random() > IN_KEY_FRAMES, rng.random() < WITH_A_TYPE
        for wrong in spoiled_tables(reference, rng, cells=MOST_WRONG, types=types):
            answer = redrawn(wrong, reference, rng) if elsewhere else wrong
            if answer is None:
                break
            place = f"{name}, block {block}"
            score = with_rows = grade(key, written(answer), policy).score
            if rng.random() < PADDED:
                padded = DHTable(convention=answer.convention, rows=(*answer.rows, PADDING, PADDING))
                with_rows = grade(key, written(padded), policy).score
            if score > before:
                outcome.failures.append(f"rises from {before} to {score}: {place}")
            if score != with_rows:
                outcome.failures.append(f"{score} but {with_rows} with rows of zeros: {place}")
            before = score
            outcome.accepted += score == 1.0
            outcome.kinds[f"{round(score, 1):.1f}"] += 1
    return outcome


def _some_cells(table: NumericTable, rng: Random, *, types: bool) -> list[tuple[int, str]]:
    """Cells of which a robot's facts depend, in random order; perhaps one that makes a joint what it is.

    Of two wrong types it may be that two rows are exchanged, one slip.
    """
    cells = _cells(table)
    joints = [(i, "joint") for i, row in enumerate(table.rows) if row.joint in _OTHER_TYPE]
    chosen = rng.sample(cells, min(MOST_WRONG, len(cells)))
    if types:
        chosen[rng.randrange(len(chosen))] = rng.choice(joints)
    return chosen


def spoiled_tables(key: NumericTable, rng: Random, *, cells: int, types: bool) -> list[NumericTable]:
    """A key with one more cell wrong every time; one of them may be the type of a joint."""
    wrong, found = key, []
    for cell in _some_cells(key, rng, types=types)[:cells]:
        wrong = _spoiled(wrong, cell, rng)
        found.append(wrong)
    return found


_OTHER_TYPE = {JointType.REVOLUTE: JointType.PRISMATIC, JointType.PRISMATIC: JointType.REVOLUTE}


def _spoiled(table: NumericTable, cell: tuple[int, str], rng: Random) -> NumericTable:
    row, name = cell
    rows = list(table.rows)
    if name == "joint":
        rows[row] = replace(rows[row], joint=_OTHER_TYPE[rows[row].joint])
        return DHTable(convention=table.convention, rows=tuple(rows))
    scale = 1.0 if name == "alpha" else prepared(table).size
    value = getattr(table.rows[row], name) + scale * rng.choice((-1, 1)) * rng.uniform(0.2, 0.7)
    rows[row] = replace(rows[row], **{name: value})
    return DHTable(convention=table.convention, rows=tuple(rows))


def repeated_entries(block: int, tables: int = TABLES_PER_BLOCK) -> Outcome:
    """Two wrong cells, then others that no fact asks for: these change no mark, whatever stands in them.

    All hold what stands elsewhere in the table, so that rows and columns look exchanged. Failures are marks
    that change; where another slip throughout the table leaves more right, such a cell may show it.
    """
    rng = Random(f"repeated {block}")
    known = catalogue()
    outcome = Outcome()
    while outcome.tables < tables:
        name, reference = rng.choice(known)
        policy = Policy(tool=rng.choice((ToolRule.FREE, ToolRule.AXIS, ToolRule.POINT)))
        free = _cells_not_asked_for(reference, policy)
        asked = [cell for cell in _cells(reference) if cell not in free]
        if len(asked) < 2 or not free:
            continue
        outcome.tables += 1
        key, answers, marks = written(reference), [reference], []
        places = [*rng.sample(asked, 2), *rng.sample(sorted(free), min(2, len(free)))]
        for row, cell in places:
            answers.append(changed(answers[-1], row + 1, **{cell: _from_elsewhere(reference, cell, rng)}))
            marks.append(grade(key, written(answers[-1]), policy).score)
        shown = [(row + 1, cell, getattr(answers[-1].rows[row], cell)) for row, cell in places]
        outcome.kinds[policy.tool.value] += 1
        changes = len(set(marks[1:])) > 1 and 1.0 not in marks
        if changes and not any(_shows_a_slip_throughout(key, answer, policy) for answer in answers[2:]):
            outcome.failures.append(f"{marks[1:]} for {name}, {policy.tool.value}, block {block}: {shown}")
    return outcome


def _cells(table: NumericTable) -> list[tuple[int, str]]:
    """The cells of a table on which a robot's facts may depend."""
    return [
        (i, cell)
        for i, row in enumerate(table.rows)
        for cell in ("alpha", "a", "d")
        if cell != "d" or row.joint is JointType.REVOLUTE
    ]


@cache
def _cells_not_asked_for(key: NumericTable, policy: Policy) -> frozenset[tuple[int, str]]:
    """The cells of a key that may be anything."""
    size = prepared(key).size
    others = {
        (row, cell): changed(key, row + 1, **{cell: getattr(key.rows[row], cell) + 0.4 * scale})
        for row, cell in _cells(key)
        for scale in (1.0 if cell == "alpha" else size,)
    }
    return frozenset(
        place for place, other in others.items() if grade(written(key), written(other), policy).correct
    )


def _from_elsewhere(key: NumericTable, cell: str, rng: Random) -> float:
    """An entry of the column, or a length of the other one; or a zero, a right angle or a half turn."""
    if cell == "alpha":
        return rng.choice([0.0, math.pi / 2, -math.pi / 2, math.pi, *(row.alpha for row in key.rows)])
    return rng.choice([0.0, *(length for row in key.rows for length in (row.a, row.d))])


def _shows_a_slip_throughout(key: ReadTable, wrong: NumericTable, policy: Policy) -> bool:
    """Whether a table has more right with a slip undone that is throughout it, at any mark."""
    answer = written(wrong)
    (way,) = comparisons(key, answer, None)
    work = work_on(way, (key, answer), policy)
    standard = standard_of(work.reference, policy, Weights())
    return any(
        wrong_of(replace(work, table=change.of(wrong)), standard) < wrong_of(work, standard)
        for entry in CATALOGUE
        for change in (entry.changes(work) if entry.beforehand else ())
        if change.extent is Extent.TABLE
    )
