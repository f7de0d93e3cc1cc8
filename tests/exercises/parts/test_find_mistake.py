"""Find the mistake, and two tables: whatever mends is right, every true reason is."""

import re
from dataclasses import replace

import pytest

from exercises.answers import RawAnswer, parse
from exercises.errors import AnswerError
from exercises.grader import grade
from exercises.grading import grade as grade_table
from exercises.instance import generate
from exercises.parts.mistakes.compare_tables import (
    ComparisonCells,
    ComparisonReason,
    SameRobot,
    true_reasons,
)
from exercises.parts.mistakes.find_mistake import PART, FoundMistakeCells
from exercises.parts.mistakes.planting import PLANTABLE, Planted
from exercises.selftest.answers import context_of
from exercises.written_table import written_table
from kinematics.cells import AngleUnit, LengthUnit, RawRow, RawTable, read_table
from kinematics.equivalence.decision import mechanism_only
from kinematics.table import Convention, JointType
from service.messages import sentence
from tests.exercises.answering import codes, part
from tests.exercises.packaged import exercise
from tests.exercises.parts.planted_tables import asked

SAME = (
    ComparisonReason.AXIS_REVERSED,
    ComparisonReason.X_TURNED,
    ComparisonReason.ORIGIN_MOVED,
    ComparisonReason.OTHER_CONVENTION,
)


def judged(found, seed, **raw):
    instance = generate(found, seed)
    return grade(instance, parse(instance, RawAnswer(**raw))).parts[0]


def right(found, seed):
    instance = generate(found, seed)
    return PART.right(found.parts[0], context_of(instance, found.reference))


@pytest.mark.parametrize("name", ["scorbot", "puma560", "kr125"])
def test_place_name_and_repair_earn_a_third_each(name) -> None:
    found = asked(name)
    whole = right(found, "3")
    assert judged(found, "3", find_mistake=whole).score == 1
    assert judged(found, "3", find_mistake=replace(whole, mended=None)).score == pytest.approx(2 / 3)
    assert judged(found, "3", find_mistake=FoundMistakeCells(name=whole.name)).score == pytest.approx(1 / 3)


@pytest.mark.parametrize("seed", [str(seed) for seed in range(8)])
def test_a_name_is_of_the_row_and_of_what_its_repair_changes(seed: str) -> None:
    """Where several single repairs do, the name of one does not go with the place or the row of another."""
    found = asked("puma560")
    planted: Planted = generate(found, seed).drawn["find_mistake"]
    answer = right(found, seed)
    named = {name: judged(found, seed, find_mistake=replace(answer, name=name)).correct for name in PLANTABLE}
    assert named[planted.code]
    about = {cell for cell in planted.code.split("_") if cell in ("alpha", "a", "d")}
    other = [name for name in PLANTABLE if not set(name.split("_")) & about]
    assert not any(named[name] for name in other)


def test_a_mended_row_needs_its_variable() -> None:
    found = exercise("puma560-find-mistake")
    answer = right(found, "7")
    assert judged(found, "7", find_mistake=answer).correct
    cells = tuple(0 if "q" in str(cell) else cell for cell in answer.mended)
    assert not judged(found, "7", find_mistake=replace(answer, mended=cells)).correct


def test_students_get_different_mistakes_and_each_the_same_again() -> None:
    found = asked("puma560")
    drawn: list[Planted] = [generate(found, str(seed)).drawn["find_mistake"] for seed in range(30)]
    assert len({(planted.code, planted.row) for planted in drawn}) > 8
    assert generate(found, "7").drawn["find_mistake"].table == drawn[7].table


@pytest.mark.parametrize(
    ("raw", "code", "where"),
    [
        (FoundMistakeCells(row=9), "row_unknown", ("find_mistake", "row")),
        (FoundMistakeCells(row="x"), "row_unknown", ("find_mistake", "row")),
        (FoundMistakeCells(mended=(0, 0, 0, 0)), "row_unknown", ("find_mistake", "row")),
        (FoundMistakeCells(row="", mended=(0, 0, 0, 0)), "row_unknown", ("find_mistake", "row")),
        (FoundMistakeCells(row=1, name="typo"), "misconception_unknown", ("find_mistake", "name")),
        (FoundMistakeCells(row=1, mended=(0, "zz", 0, "q1")), "name_unknown", ("find_mistake", "mended", 1)),
        (FoundMistakeCells(row=1, mended=(0, 0, "q9", "q1")), "", ("find_mistake", "mended", 2)),
    ],
)
def test_what_cannot_be_read_is_refused_with_its_place(raw, code, where) -> None:
    found = asked("cloos")
    with pytest.raises(AnswerError) as refusal:
        parse(generate(found, "1"), RawAnswer(find_mistake=raw))
    assert refusal.value.faults[0].where == where
    assert code in refusal.value.code


def test_cells_left_empty_are_no_mended_row() -> None:
    instance = generate(asked("cloos"), "1")
    planted = instance.drawn["find_mistake"]
    cells = FoundMistakeCells(row=planted.row + 1, name=planted.code, mended=("", "", "", ""))
    found = part(grade(instance, parse(instance, RawAnswer(find_mistake=cells))), "find_mistake")
    assert (found.score, codes(found)) == (pytest.approx(2 / 3), ["mistake_missing"])


def test_every_true_reason_is_right_and_no_other() -> None:
    found = exercise("stanford-compare")
    verdicts = set()
    for seed in range(12):
        reports = {
            (same, reason): judged(
                found, str(seed), compare_tables=ComparisonCells(verdict=same, reason=reason)
            )
            for same in SameRobot
            for reason in ComparisonReason
        }
        full = {key for key, report in reports.items() if report.score == 1}
        assert full
        assert len({same for same, _ in full}) == 1
        verdicts |= {same for same, _ in full}
        assert {report.score for report in reports.values()} == {0, 0.5, 1}
    assert verdicts == set(SameRobot)


def test_the_second_table_has_no_whole_turns_in_its_angles() -> None:
    """A table with "q1 + 540" looks like a mistake of its own."""
    found = exercise("stanford-compare")
    for seed in range(40):
        second = written_table(generate(found, str(seed)).drawn["compare_tables"])
        cells = [str(cell) for row in second.rows for cell in (row.theta, row.alpha)]
        turns = [int(number) for cell in cells for number in re.findall(r"(?<!\w)\d+", cell)]
        assert max(turns) <= 180


@pytest.mark.parametrize(
    ("language", "only"),
    [("en", "only"), ("es", "solo"), ("fr", "seul"), ("pt", "só"), ("ro", "doar"), ("uk", "лише")],
)
def test_no_reason_claims_to_be_the_only_difference(language: str, only: str) -> None:
    """All four may be true of two tables."""
    for reason in SAME:
        text = sentence(language, f"option-{reason.value}")
        assert text
        assert only not in text.split()[0]


def test_an_origin_that_lies_elsewhere_is_a_reason_beside_a_row_of_zeros() -> None:
    key = asked("scara").reference
    first, second, third, *others = written_table(key).rows
    slid = (first, replace(second, d="a2"), replace(third, d="q3 - a2"), *others)
    for rows in (slid, (*slid, RawRow(joint=JointType.FIXED, theta=0, d=0, a=0, alpha=0))):
        read = read_table(replace(written_table(key), rows=rows))
        verdict = grade_table(key, read, mechanism_only(asked("scara").policy), {"a2": 0.4, "a3": 0.3})
        assert verdict.correct
        assert true_reasons(verdict) == {ComparisonReason.ORIGIN_MOVED}


def test_reasons_across_conventions_name_reversed_axes_and_moved_ends_too() -> None:
    """Frames do not correspond one by one there, but the axes of joints and the two ends do."""
    found = exercise("stanford-compare")
    fixed, turn, slide = JointType.FIXED, JointType.REVOLUTE, JointType.PRISMATIC
    rows = (
        RawRow(joint=fixed, theta=0, d=0, a=0, alpha=180),
        RawRow(joint=turn, theta="q1", d="L0", a=0, alpha=90),
        RawRow(joint=turn, theta="-q2 + 180", d="-L1", a=0, alpha=-90),
        RawRow(joint=slide, theta=0, d="q3 + L1", a=0, alpha=0),
        RawRow(joint=turn, theta="q4", d="-L1", a=0, alpha=-90),
        RawRow(joint=turn, theta="-q5", d=0, a=0, alpha=90),
        RawRow(joint=turn, theta="q6", d="L2 + L0", a=0, alpha=0),
    )
    second = read_table(
        RawTable(
            convention=Convention.STANDARD, rows=rows, angle_unit=AngleUnit.DEG, length_unit=LengthUnit.M
        )
    )
    verdict = grade_table(
        found.reference, second, mechanism_only(found.policy), {"L0": 0.4, "L1": 0.15, "L2": 0.1}
    )
    assert verdict.correct
    assert true_reasons(verdict) == set(SAME)
