"""Frames in the figure: every valid assignment is right, and the rule that a frame breaks is named."""

import random
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest

from exercises.answers import RawAnswer, parse
from exercises.definition import Exercise, Part
from exercises.errors import AnswerError
from exercises.grader import grade
from exercises.grading import Finding, HelpLevel, ToolRule
from exercises.instance import generate
from exercises.parts.forward.figure_frames import figure_axes
from exercises.parts.forward.frames import PART, FrameCells, FramesCells
from exercises.parts.report import PartReport
from exercises.selftest.answers import context_of
from exercises.selftest.checks import check
from kinematics.frames.assignment import assign_frames
from kinematics.frames.axes import read_axes, robot_size
from kinematics.frames.wrong_frames import right_handed
from kinematics.table import Convention
from tests.exercises.packaged import exercise, exercise_ids
from tests.exercises.parts.frame_assignments import (
    broken_rules,
    campaign,
    rounded,
    valid,
    with_one_broken_rule,
)

ASKED = Part(kind="frames", points=Fraction(10))


def with_frames(exercise_id: str, **changes: Any) -> Exercise:
    return replace(exercise(exercise_id), parts=(ASKED,), **changes)


def told(found: Exercise, raw: FramesCells, level: HelpLevel | None = None) -> PartReport:
    instance = generate(found, "5")
    return grade(instance, parse(instance, RawAnswer(frames=raw)), level).parts[0]


def key_frames(found: Exercise) -> FramesCells:
    return PART.right(ASKED, context_of(generate(found, "5"), found.reference))


def test_random_valid_assignments_are_accepted_and_broken_rules_named() -> None:
    assert campaign(150) == (0, 0)


def test_assignments_rounded_on_paper_are_accepted_and_broken_ones_are_not() -> None:
    rng = random.Random(7)
    for _ in range(100):
        made = valid(rng)
        if robot_size(read_axes(made.axes), None, None) > 0.3:  # four digits of less say too little
            assert not broken_rules(rounded(made, 4), rounding=0.005)
        wrong = rounded(with_one_broken_rule(rng), 4)
        assert wrong.broken is not None
        assert wrong.broken[1] <= broken_rules(wrong, rounding=0.005)[wrong.broken[0]]


@pytest.mark.parametrize("exercise_id", exercise_ids)
def test_the_frames_of_every_key_are_right(exercise_id: str) -> None:
    report = told(with_frames(exercise_id), key_frames(with_frames(exercise_id)))
    assert (report.correct, report.score) == (True, 1.0), report


@pytest.mark.parametrize("convention", list(Convention))
@pytest.mark.parametrize("exercise_id", ["puma560", "stanford", "kr125"])
def test_the_procedure_in_either_convention_is_right(exercise_id: str, convention: Convention) -> None:
    found = with_frames(exercise_id)
    found = replace(found, policy=replace(found.policy, tool=ToolRule.FREE))
    from exercises.parts.forward.frames import _cells

    assigned = assign_frames(figure_axes(generate(found, "5")), convention)
    raw = FramesCells(
        convention=convention, frames=tuple(_cells(right_handed(f.origin, f.x, f.z)) for f in assigned.frames)
    )
    assert told(found, raw).correct


def test_frames_that_obey_the_rules_and_not_the_exercise() -> None:
    found = with_frames("puma560")
    found = replace(found, policy=replace(found.policy, tool=ToolRule.POINT))
    right = key_frames(found)
    last = right.frames[-1]
    assert last is not None
    assert told(found, right).correct
    moved = tuple(o + 0.3 * z for o, z in zip(last.origin, last.z, strict=True))
    report = told(found, replace(right, frames=(*right.frames[:-1], replace(last, origin=moved))))
    assert [entry.code for entry in report.feedback] == ["frames_not_as_asked"]
    assert 0.8 < report.score < 1.0


@pytest.mark.parametrize("exercise_id", ["scara", "puma560", "stanford"])
def test_frames_that_nobody_has_moved_earn_nothing(exercise_id: str) -> None:
    found = with_frames(exercise_id)
    right = key_frames(found)
    untouched = FrameCells(origin=(0, 0, 0), x=(1, 0, 0), z=(0, 0, 1))
    report = told(found, replace(right, frames=(untouched,) * len(right.frames)))
    assert (report.correct, report.score) == (False, 0.0)


@pytest.mark.parametrize(("name", "value"), [("x", (0, 1, 0)), ("z", (0, 1, 0)), ("origin", (0.01, 0, 0))])
def test_one_wrong_entry_leaves_marks_where_most_is_right_for_nothing(
    name: str, value: tuple[float, ...]
) -> None:
    found = with_frames("twolink")
    right = key_frames(found)
    assert told(found, right).correct
    frame = right.frames[1]
    assert frame is not None
    changed = replace(frame, **{name: value})
    report = told(found, replace(right, frames=(right.frames[0], changed, *right.frames[2:])))
    assert not report.correct
    assert 0.1 < report.score < 1.0


def test_facts_are_independent() -> None:
    found = with_frames("puma560")
    right = key_frames(found)
    frame = right.frames[2]
    assert frame is not None
    tilted = replace(frame, z=frame.x, x=frame.z)
    report = told(found, replace(right, frames=(*right.frames[:2], tilted, *right.frames[3:])))
    wrong = {fact.where for fact in report.facts if fact.finding is Finding.WRONG}
    assert ("frames", 2, "z") in wrong
    assert all(where[1] == 2 for where in wrong)
    assert 0.5 < report.score < 1.0
    nothing = replace(right, frames=(None,) * len(right.frames))
    assert told(found, nothing).score == 0.0


@pytest.mark.parametrize(
    ("level", "codes"),
    [
        (HelpLevel.VERDICT, {"part_wrong"}),
        (HelpLevel.ROW, {"frame_wrong"}),
        (HelpLevel.REPAIR, {"frame_origin_not_on_axis"}),
    ],
)
def test_help_tells_the_frame_then_the_rule(level: HelpLevel, codes: set[str]) -> None:
    found = with_frames("scara")
    right = key_frames(found)
    frame = right.frames[0]
    assert frame is not None
    convention = right.convention
    k = 0 if convention is Convention.STANDARD else 1
    frame = right.frames[k]
    assert frame is not None
    away = tuple(float(o) + 0.2 * float(x) for o, x in zip(frame.origin, frame.x, strict=True))
    other = replace(right, frames=(*right.frames[:k], replace(frame, origin=away), *right.frames[k + 1 :]))
    assert codes <= {entry.code for entry in told(found, other, level).feedback}


def test_the_other_convention_is_told() -> None:
    found = with_frames("puma560")
    right = key_frames(found)
    other = Convention.MODIFIED if right.convention is Convention.STANDARD else Convention.STANDARD
    codes = [entry.code for entry in told(found, replace(right, convention=other)).feedback]
    assert codes[0] == "frames_other_convention"


def test_cells_hold_names_and_roots() -> None:
    found = with_frames("onelink")
    right = key_frames(found)
    frame = right.frames[0]
    assert frame is not None
    scaled = replace(frame, x=tuple(f"{c}*sqrt(2)" for c in frame.x))
    assert told(found, replace(right, frames=(scaled, *right.frames[1:]))).correct


@pytest.mark.parametrize(
    ("change", "code", "where"),
    [
        ({"origin": (0, "L9", 0)}, "name_unknown", ("frames", "frames", 1, "origin", 1)),
        ({"z": (0, 0, 0)}, "direction_zero", ("frames", "frames", 1, "z")),
        ({"x": (1e14, 0, 0)}, "vector_malformed", ("frames", "frames", 1, "x")),
        ({"origin": (1e14, 0, 0)}, "vector_malformed", ("frames", "frames", 1, "origin")),
        ({"x": ("1/0", 0, 0)}, "division_by_zero", ("frames", "frames", 1, "x", 0)),
        ({"x": ("(", 0, 0)}, None, ("frames", "frames", 1, "x", 0)),
    ],
)
def test_what_cannot_be_read_costs_no_attempt(
    change: dict[str, Any], code: str | None, where: tuple[str | int, ...]
) -> None:
    found = with_frames("scara")
    right = key_frames(found)
    frame = right.frames[1]
    assert isinstance(frame, FrameCells)
    raw = replace(right, frames=(right.frames[0], replace(frame, **change), *right.frames[2:]))
    with pytest.raises(AnswerError) as error:
        told(found, raw)
    (fault,) = error.value.faults
    assert fault.where == where
    assert code in (None, fault.code)


def test_the_number_of_frames_is_known() -> None:
    right = key_frames(with_frames("scara"))
    with pytest.raises(AnswerError, match="frames_count"):
        told(with_frames("scara"), replace(right, frames=right.frames[:-1]))


@pytest.mark.parametrize("exercise_id", ["scara", "stanford"])
def test_an_exercise_that_asks_for_frames_alone_tests_itself(exercise_id: str) -> None:
    findings = check(with_frames(exercise_id), 1)
    assert not findings.failures
    assert findings.passed["wrong_part"] == 4


def test_no_packaged_exercise_asks_for_a_point_that_its_last_frame_cannot_reach() -> None:
    """Where the key needs a fixed row, the last frame of a joint lies on its axis and not at the tool."""
    for name in exercise_ids:
        found = exercise(name)
        table = found.reference.table
        if found.part("frames") is not None and len(table.rows) > table.n_joints:
            assert found.policy.tool is ToolRule.FREE, name
