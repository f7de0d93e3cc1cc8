"""What cannot be graded is refused with every fault at its place; a level of help is never exceeded."""

from dataclasses import replace
from fractions import Fraction
from importlib import import_module
from typing import Any

import pytest

from exercises.access import ExerciseAccess
from exercises.answers import RawAnswer, parse
from exercises.definition import Part
from exercises.errors import AnswerError
from exercises.grader import Report, allowed_help, grade
from exercises.grading import HelpLevel
from exercises.grading.facts import Weights
from exercises.instance import generate
from exercises.parts.following import as_it_follows
from exercises.parts.forward.schematic import AxisRelation, Schematic
from exercises.parts.forward.workspace import RadiiCells
from exercises.parts.inverse.joint_cells import JointAnswerCells
from exercises.parts.mistakes.find_mistake import FoundMistakeCells
from exercises.parts.mistakes.frame_mistake import FoundFrameMistakeCells
from exercises.parts.mistakes.matrix_mistake import FoundMatrixMistakeCells
from exercises.parts.motion.jacobian_cells import JacobianCells
from exercises.parts.motion.motion_cells import MotionCells
from exercises.parts.motion.singularity_cells import SingularityCells
from exercises.parts.report import Credit
from exercises.parts.report import judged as judged_part
from exercises.parts.rotations.orientation_cells import OrientationCells
from kinematics.answers.joint_verdicts import JointClaim
from kinematics.table import JointType
from tests.exercises.answering import SCARA, SCARA_MATRICES, SCARA_TRANSFORM, edited, judged, table
from tests.exercises.packaged import exercise

EYE3 = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
EYE = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]


def refused(exercise_id: str = "scara", **parts: Any) -> dict[str, str]:
    with pytest.raises(AnswerError) as error:
        parse(generate(exercise(exercise_id)), RawAnswer(**parts))
    return {".".join(map(str, fault.where)): fault.code for fault in error.value.faults}


@pytest.mark.parametrize(
    ("parts", "faults"),
    [
        ({}, {"": "answer_empty"}),
        ({"table": table("standard")}, {"table.rows": "table_empty"}),
        ({"table": SCARA, "link_matrices": SCARA_MATRICES[:3]}, {"link_matrices": "link_matrices_count"}),
        ({"link_matrices": [*SCARA_MATRICES[:3], None]}, {"link_matrices": "link_matrices_need_table"}),
        ({"pose": EYE}, {"pose": "pose_needs_table"}),
        ({"transform": EYE[:3]}, {"transform": "matrix_not_4x4"}),
        ({"transform": edited(EYE, 0, 1, "c3")}, {"transform.0.1": "short_form_unknown"}),
        ({"transform": edited(EYE, 2, 3, "q5")}, {"transform.2.3": "joint_variable_unknown"}),
        ({"transform": edited(EYE, 0, 0, "cos(")}, {"transform.0.0": "cell_incomplete"}),
        ({"transform": edited(EYE, 0, 0, True)}, {"transform.0.0": "cell_not_a_value"}),
        (
            {"table": SCARA, "link_matrices": [None, None, edited(EYE, 1, 2, ""), None]},
            {"link_matrices.2.1.2": "cell_empty"},
        ),
        ({"table": SCARA, "pose": edited(EYE, 0, 3, "q1")}, {"pose.0.3": "joint_variable_in_number"}),
        ({"table": SCARA, "pose": edited(EYE, 0, 0, "c1")}, {"pose.0.0": "joint_variable_in_number"}),
        ({"table": SCARA, "pose": edited(EYE, 0, 3, "a9")}, {"pose.0.3": "name_unknown"}),
        ({"table": SCARA, "pose": edited(EYE, 0, 3, "sqrt(a3-a2)")}, {"pose.0.3": "value_not_real"}),
        ({"workspace": RadiiCells(inner=-1, outer=2)}, {"workspace.inner": "radius_negative"}),
        (
            {"workspace": RadiiCells(inner="x(", outer="a9")},
            {"workspace.inner": "function_unknown", "workspace.outer": "name_unknown"},
        ),
        (
            {"schematic": Schematic(joints=(JointType.FIXED, JointType.REVOLUTE), relations=())},
            {
                "schematic.joints.0": "schematic_fixed_joint",
                "schematic.relations": "schematic_relations_count",
            },
        ),
    ],
)
def test_what_cannot_be_graded_is_refused(parts: dict[str, Any], faults: dict[str, str]) -> None:
    found = refused(**parts)
    assert {place: found.get(place) for place in faults} == faults
    assert len(found) == len(faults)


def test_parts_that_are_not_asked_are_refused() -> None:
    assert refused("stanford", schematic=Schematic(joints=(JointType.REVOLUTE,), relations=())) == {
        "schematic": "part_not_asked"
    }


@pytest.mark.parametrize(
    ("exercise_id", "empty"),
    [
        ("puma560-find-mistake", FoundMistakeCells()),
        ("puma560-find-mistake", FoundMistakeCells(row="", name="", mended=("", "", "", ""))),
        ("puma560-matrix-mistake", FoundMatrixMistakeCells()),
        ("puma560-matrix-mistake", FoundMatrixMistakeCells(mended_matrix=(("",) * 4,) * 4)),
        ("puma560-frame-mistake", FoundFrameMistakeCells()),
        ("puma560-frame-mistake", FoundFrameMistakeCells(wrong_frame="", mended_x=("", "", ""))),
    ],
)
def test_a_part_about_a_mistake_that_says_nothing_is_refused(exercise_id: str, empty: Any) -> None:
    """It was graded with 0 and cost an attempt."""
    (part,) = exercise(exercise_id).parts
    assert refused(exercise_id, **{part.kind: empty}) == {part.kind: "mistake_empty"}


def test_faults_of_all_parts_come_at_once() -> None:
    found = refused(
        table=table("standard", (0, "a2", 0, "2*q1")),
        transform=edited(EYE, 0, 0, "#"),
        workspace=RadiiCells(inner=1, outer="?"),
    )
    assert set(found) == {"table.rows.0.theta", "transform.0.0", "workspace.outer"}


def test_a_column_is_that_of_the_cell_as_typed() -> None:
    with pytest.raises(AnswerError) as error:
        parse(generate(exercise("scara")), RawAnswer(transform=edited(EYE, 0, 0, "c(q1) + c(q2) + ?")))
    assert error.value.faults[0].params["column"] == 17


def test_points_are_those_that_are_shown() -> None:
    """In floating point 35 times 0.89 is 31.150000000000002."""
    found = judged_part(Part(kind="table", points=Fraction(35)), 0.89, Credit.KEY)
    assert found.points == 31.15
    assert as_it_follows(replace(found, points=31.15), 0.7).points == 21.805


def test_all_points_add_up() -> None:
    relations = (AxisRelation.PARALLEL, AxisRelation.PARALLEL, AxisRelation.COINCIDENT)
    types = (JointType.REVOLUTE, JointType.REVOLUTE, JointType.PRISMATIC, JointType.REVOLUTE)
    report = judged(
        "scara",
        table=SCARA,
        link_matrices=SCARA_MATRICES,
        transform=SCARA_TRANSFORM,
        pose=[
            ["sqrt(2)/2", "sqrt(2)/2", 0, 0.3464],
            ["sqrt(2)/2", "-sqrt(2)/2", 0, 0.5],
            [0, 0, -1, -0.1],
            [0, 0, 0, 1],
        ],
        schematic=Schematic(joints=types, relations=relations),
        workspace=RadiiCells(inner=0.1, outer=0.7),
    )
    assert (report.points, report.max_points, report.score, report.correct) == (100, 100, 1.0, True)
    assert report.missing == ()
    assert judged("scara", table=SCARA).missing == tuple(
        part.kind for part in exercise("scara").parts if part.kind != "table"
    )


@pytest.mark.parametrize("asked", [None, *HelpLevel])
@pytest.mark.parametrize("allowed", list(HelpLevel))
def test_help_is_never_more_than_the_exercise_allows(asked: HelpLevel | None, allowed: HelpLevel) -> None:
    order = list(HelpLevel)
    given = allowed_help(replace(exercise("scara"), access=ExerciseAccess(ladder=(allowed,))), asked)
    assert order.index(given) == min(order.index(asked or HelpLevel.REPAIR), order.index(allowed))


@pytest.mark.parametrize("turned", ["sqrt(a3-a2)", "acos(3*a2/a3)"])
def test_a_table_without_a_value_for_this_student_is_no_attempt(turned: str) -> None:
    """Other lengths, with which there is a value, are not those of the question."""
    rows = [(0, "a2", 0, f"q1 + {turned}"), (180, "a3", 0, "q2"), (0, 0, "q3", 0), (0, 0, 0, "q4")]
    assert refused(table=table("standard", *rows)) == {"table.rows.0.theta": "value_undefined"}
    rows[0] = (0, "a2", 0, "q1 + sqrt(a2-a3)")
    assert judged("scara", table=table("standard", *rows)).verdict.correct


@pytest.mark.parametrize("cell", ["a2", "L1"])
def test_what_a_class_hands_in_again_is_judged_once(cell: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Verdicts are known by their tables: an answer that was made anew each time was never known."""
    found = generate(replace(exercise("scara"), aliases={"L1": "a2"}))
    rows = [(0, cell, 0, "q1"), (180, 0.123, 0, "q2"), (0, 0, "q3", 0), (0, 0, 0, "q4")]

    def handed_in() -> Report:
        return grade(found, parse(found, RawAnswer(table=table("standard", *rows))))

    first = handed_in()
    monkeypatch.setattr(import_module("exercises.grading.grade"), "judged", None)
    assert handed_in().verdict is first.verdict


def test_weights_change_points_and_nothing_else() -> None:
    found = exercise("scara")
    wrong = RawAnswer(
        table=table("standard", (90, "a2", 0, "q1"), (180, "a3", 0, "q2"), (0, 0, "q3", 0), (0, 0, 0, "q4"))
    )
    scores = []
    for twist in (0.5, 1.0, 4.0):
        other = replace(found, weights=Weights(twist=twist))
        verdict = grade(generate(other), parse(generate(other), wrong)).verdict
        assert verdict is not None
        assert not verdict.correct
        scores.append(verdict.score)
    assert scores == sorted(scores, reverse=True)


@pytest.mark.parametrize(("name", "meant"), [("q12", "q1 + q2"), ("θ23", "q2 + q3"), ("q19", ""), ("q5", "")])
def test_a_sum_of_variables_is_written_out(name: str, meant: str) -> None:
    rows = edited(EYE, 0, 3, f"a2*cos({name})")
    with pytest.raises(AnswerError) as error:
        parse(generate(exercise("scara")), RawAnswer(table=SCARA, transform=rows))
    (fault,) = error.value.faults
    assert (fault.code, fault.params["sum"]) == ("joint_variable_unknown", meant)


def test_a_joint_variable_is_no_joint_value() -> None:
    cells = JointAnswerCells(claim=JointClaim.FINITE, solutions=(("q1", 0, 0, 0),))
    assert refused("scara-inverse", inverse_kinematics=cells) == {
        "inverse_kinematics.solutions.0.0": "joint_variable_in_number"
    }


def test_a_vector_has_components_and_no_joints() -> None:
    cells = SingularityCells(conditions=(("sin(q2)",),), lost=(0, 0, 1, 0, 0))
    assert refused("scara-singularities", singularities=cells) == {"singularities.lost": "vector_length"}


@pytest.mark.parametrize(
    ("exercise_id", "cells", "fault"),
    [
        ("rx90-orientation", OrientationCells(matrix=EYE3), {"orientation": "orientation_empty"}),
        ("rx90-orientation", OrientationCells(axis=(0, 0, 1), angle=0), {"orientation": "orientation_empty"}),
        ("kr125-orientation", OrientationCells(angles=((1, 2, 3),)), {"orientation": "orientation_empty"}),
        ("twolink-dynamics", MotionCells(velocity=(0, 0)), None),
        ("scara-dynamics", MotionCells(coriolis=((0, 0, 0, 0),) * 4), None),
        (
            "scorbot-analytic-jacobian",
            JacobianCells(forces=(0,) * 5),
            {"jacobian_form.forces": "part_not_asked"},
        ),
    ],
)
def test_an_answer_to_what_is_not_asked_is_not_graded(
    exercise_id: str, cells: Any, fault: dict[str, str] | None
) -> None:
    """It cost an attempt and was told that everything was missing; C and C q̇ stand for each other."""
    (asked,) = exercise(exercise_id).parts
    if fault is None:
        assert parse(generate(exercise(exercise_id)), RawAnswer(**{asked.kind: cells})).get(asked.kind)
    else:
        assert refused(exercise_id, **{asked.kind: cells}) == fault


def test_a_lost_motion_alone_is_not_graded_where_none_is_asked() -> None:
    asked = exercise("scara-singularities")
    (part,) = asked.parts
    instance = generate(replace(asked, parts=(replace(part, joints=None),)))
    with pytest.raises(AnswerError) as error:
        parse(instance, RawAnswer(singularities=SingularityCells(lost=(0, 0, 1, 0, 0, 0))))
    assert [fault.code for fault in error.value.faults] == ["part_not_asked"]
