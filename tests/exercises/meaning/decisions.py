"""Answers whose truth the kinds' own oracles know, one after the other: screws, sets, functions, repairs."""

import random
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache

import numpy as np

from exercises.answers import RawAnswer, parse
from exercises.grader import grade
from exercises.instance import Instance, generate
from exercises.parts.joint_draws import key_numbers
from exercises.parts.mistakes.compare_tables import ComparisonCells, SameRobot
from exercises.parts.mistakes.find_mistake import PART as FIND_MISTAKE
from exercises.parts.mistakes.matrix_mistake import FoundMatrixMistakeCells
from kinematics.answers.jacobian_forms import judge_jacobian_form
from kinematics.answers.singularity_answers import judge_singularities
from kinematics.cells import read_table
from kinematics.table import Convention, NumericTable
from tests.exercises.meaning.answers_known import KnownAnswer, report_on
from tests.exercises.meaning.own_tables import written
from tests.exercises.meaning.posed_answers import student
from tests.exercises.parts import mended_matrices, planted_tables
from tests.kinematics.answers import jacobian_forms, singular_sets
from tests.kinematics.equivalence.generators import random_valid_table
from tests.kinematics.frames import mended_frames
from tests.kinematics.rotations import orientations

SOME = 20
"""Cases that are drawn from one seed of those that draw a number of them."""


def closed_jacobians(rng: random.Random) -> Iterator[KnownAnswer]:
    """J0 and Jn as functions, from derivatives of products of matrices."""
    for robot, rows, frame, right in jacobian_forms.cases(SOME, rng.randrange(10**9)):
        yield KnownAnswer(
            right,
            lambda robot=robot, rows=rows, frame=frame: judge_jacobian_form(robot, rows, frame, 1e-6).right,
            lambda rows=rows, frame=frame: f"{frame} {rows}",
        )


def singularities(rng: random.Random) -> Iterator[KnownAnswer]:
    """Conditions that say the set of the textbooks' determinants, or another one."""
    for name, arm, texts, right in singular_sets.cases(SOME, rng.randrange(10**9)):
        yield KnownAnswer(
            right,
            lambda name=name, arm=arm, texts=texts: (
                judge_singularities(
                    arm, [found for text in texts for found in singular_sets.read(name, text)]
                ).right
            ),
            lambda name=name, texts=texts: f"{name} {texts}",
        )


def rotations(rng: random.Random) -> Iterator[KnownAnswer]:
    """Orientations in every notation, rounded by chance."""
    for case in orientations.cases(rng):
        yield KnownAnswer(case.right, lambda case=case: case.judge().right, lambda case=case: case.name)


def mended_matrices_of_students(rng: random.Random) -> Iterator[KnownAnswer]:
    """The matrix with a planted mistake, mended by the textbook's formula, or not."""
    for found, rows, right in mended_matrices.cases(SOME, rng.randrange(10**9)):
        raw = FoundMatrixMistakeCells(mended_matrix=tuple(tuple(row) for row in rows))

        def judge(found: mended_matrices.Student = found, raw: FoundMatrixMistakeCells = raw) -> bool:
            facts = found.judged(raw).facts
            return any(fact.where == ("mended_matrix",) and fact.finding == "ok" for fact in facts)

        yield KnownAnswer(right, judge, lambda found=found, raw=raw: f"{found.instance.exercise.id} {raw}")


@cache
def _planted(name: str, seed: int) -> Instance:
    return generate(planted_tables.asked(name), str(seed))


def mended_tables_of_students(rng: random.Random) -> Iterator[KnownAnswer]:
    """The table with a planted mistake, mended by the key's row, or not."""
    instance = _planted(rng.choice(planted_tables.ROBOTS), rng.randrange(40))
    right, raw = planted_tables.answer(instance.drawn[FIND_MISTAKE.kind], instance, rng)

    def judge() -> bool:
        facts = report_on(instance, FIND_MISTAKE.kind, find_mistake=raw).facts
        return any(fact.where == ("mended",) and fact.finding == "ok" for fact in facts)

    yield KnownAnswer(right, judge, lambda: f"{instance.exercise.id} {instance.seed} {raw}")


def mended_figures(rng: random.Random) -> Iterator[KnownAnswer]:
    """A drawn frame, mended or not: whether rows follow from the frames."""
    for said, right in mended_frames.cases(SOME, rng.randrange(10**9)):
        yield KnownAnswer(right, lambda said=said: said, lambda: "frames")


def compared_tables(rng: random.Random) -> Iterator[KnownAnswer]:
    """Two tables of one robot, drawn line by line, or of two whose neighbouring axes lie otherwise."""
    found = student("stanford-compare", rng.randrange(30))
    table = key_numbers(found)
    same, other = rng.random() < 0.5, random_valid_table(table, rng)
    while not same and not _neighbours(other):
        other = random_valid_table(table, rng)
    if not same:
        other = _with_other_neighbours(other, rng)
    second = read_table(written(other, found.exercise.reference.length_unit))
    instance = replace(found, drawn={**found.drawn, "compare_tables": second})
    for verdict in SameRobot:
        raw = ComparisonCells(verdict=verdict)

        def judge(raw: ComparisonCells = raw) -> bool:
            report = grade(instance, parse(instance, RawAnswer(compare_tables=raw)), drawn=False)
            return report.parts[0].score > 0.0

        yield KnownAnswer((verdict is SameRobot.SAME) is same, judge, lambda raw=raw: f"{raw} {other}")


def _neighbours(table: NumericTable) -> list[int]:
    """Joints, from 0, whose next one stands in the next row; fixed rows may stand between all of them."""
    joints = table.joint_rows
    return [k for k in range(len(joints) - 1) if joints[k + 1] == joints[k] + 1]


def _with_other_neighbours(table: NumericTable, rng: random.Random) -> NumericTable:
    """Neighbouring joint axes farther apart, or at another angle: no frames undo that."""
    joints = table.joint_rows
    modified = table.convention is Convention.MODIFIED
    k = rng.choice(_neighbours(table))
    i = joints[k] + modified
    row = table.rows[i]
    alpha = row.alpha
    changed = replace(row, alpha=alpha + (0.4 if abs(np.sin(alpha + 0.4)) > abs(np.sin(alpha)) else -0.4))
    if rng.random() < 0.5 and "prismatic" not in (table.joint_types[k].value, table.joint_types[k + 1].value):
        changed = replace(row, a=row.a + (0.2 if row.a >= 0 else -0.2))
    return replace(table, rows=(*table.rows[:i], changed, *table.rows[i + 1 :]))


Source = Callable[[random.Random], Iterator[KnownAnswer]]
