"""What is told of two frames apart, by turning and moving one of them by hand."""

import math

import pytest

from exercises.grading import Policy, ToolRule, grade
from exercises.grading.judging.frames import _apart, _Noticed
from kinematics.se3 import Motion, compose, rotation_about, translation
from tests.exercises.grading.test_grade import KEY, PUMA, PUMA_CRAIG, Rows, with_cells
from tests.exercises.grading.told import codes
from tests.exercises.grading.written import Cell, read

NOTICED = _Noticed(angle=0.01, length=0.5)
X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
ORIGIN = (0.0, 0.0, 0.0)


def about(axis: tuple[float, float, float], degrees: float) -> Motion:
    angle = math.radians(degrees)
    return rotation_about(ORIGIN, axis, math.cos(angle), math.sin(angle))


STAYS = translation(ORIGIN)


@pytest.mark.parametrize(
    ("motion", "told"),
    [
        (STAYS, []),
        # 0.01 rad is 0.573 degrees
        (about(X, 0.5), []),
        (about(X, 0.65), ["frame_elsewhere"]),
        (about(Y, 0.5), []),
        (about(Y, -0.65), ["frame_elsewhere"]),
        (about(X, 180.0), ["axis_reversed"]),
        (about(Y, 180.0), ["axis_reversed", "x_turned"]),
        (about(Z, 0.5), []),
        (about(Z, -0.65), ["x_turned"]),
        (translation((0.3, 0.39, 0.0)), []),
        (translation((0.3, -0.41, 0.0)), ["axis_moved"]),
        (translation((0.0, 0.0, 0.49)), []),
        (translation((0.0, 0.0, -0.51)), ["origin_slid"]),
        # the axis elsewhere: how far along it then means nothing
        (translation((0.6, 0.0, 0.6)), ["axis_moved"]),
        (compose(translation((0.0, 0.6, 0.0)), about(Z, 90.0)), ["x_turned", "axis_moved"]),
    ],
)
def test_what_is_told_of_frames_apart(motion: Motion, told: list[str]) -> None:
    assert [said.code for said in _apart(motion, 3, 2, NOTICED)] == told


def test_a_reversed_axis_of_no_joint_is_an_end() -> None:
    (said,) = _apart(about(X, 180.0), 3, None, NOTICED)
    assert (said.code, said.row, said.params) == ("end_axis_reversed", 3, {"frame": 3})
    (said,) = _apart(about(X, 180.0), 0, 1, NOTICED)
    assert (said.code, said.row, said.params) == ("axis_reversed", None, {"frame": 0, "joint": 1})


@pytest.mark.parametrize(
    ("turned", "degrees"), [(90.0, 90), (-90.0, 90), (30.04, 30), (30.06, 30.1), (30.26, 30.3), (29.97, 30)]
)
def test_a_turn_is_told_in_whole_degrees_or_tenths(turned: float, degrees: float) -> None:
    (said,) = _apart(about(Z, turned), 3, 2, NOTICED)
    assert (said.code, said.params) == ("x_turned", {"frame": 3, "degrees": degrees})


def test_whole_degrees_are_a_whole_number() -> None:
    (said,) = _apart(about(Z, 90.04), 3, 2, NOTICED)
    assert repr(said.params["degrees"]) == "90"


def test_an_end_that_is_hardly_turned_is_not_reversed() -> None:
    assert not list(_apart(about(X, 0.5), 3, None, NOTICED))


REVERSED: list[tuple[int, int, Cell]] = [(2, 0, "-pi/2"), (4, 0, "pi/2"), (3, 2, "-d3")]
OTHER = ("other_convention", None, {"convention": "modified"})


@pytest.mark.parametrize(
    ("convention", "cells", "told"),
    [
        ("standard", [(1, 2, 0.3)], [("origin_slid", None, {"frame": 0})]),
        (
            "standard",
            [(1, 3, "q1 + pi/2")],
            [("same_frames", None, {}), ("variable_offset", 1, {"joint": 1, "offset": "-pi/2"})],
        ),
        (
            "standard",
            [(2, 3, "pi/6 - q2"), (3, 3, "-q3")],
            [
                ("same_frames", None, {}),
                *(("variable_reversed", k, {"joint": k}) for k in (2, 3)),
                ("variable_offset", 2, {"joint": 2, "offset": "pi/6"}),
            ],
        ),
        (
            "standard",
            [(1, 2, 0.3), (1, 3, "q1 + 0.5"), (3, 3, "q3 + pi/2")],
            [("origin_slid", None, {"frame": 0}), ("variable_offset", 3, {"joint": 3, "offset": "-pi/2"})],
        ),
        (
            "standard",
            [(4, 0, "-pi/2"), (5, 0, "pi/2")],
            [("x_turned", 4, {"frame": 4, "degrees": 180}), ("x_turned", 5, {"frame": 5, "degrees": 180})],
        ),
        (
            "standard",
            [(6, 2, 0.1), (6, 0, "pi")],
            [("end_axis_reversed", 6, {"frame": 6}), ("origin_slid", 6, {"frame": 6})],
        ),
        ("standard", [(6, 0, "pi/3")], [("frame_elsewhere", 6, {"frame": 6})]),
        ("standard", [(6, 1, 0.3)], [("axis_moved", 6, {"frame": 6})]),
        (
            "modified",
            [(5, 0, "-pi/2"), (6, 0, "pi/2")],
            [OTHER, *(("variable_offset", k, {"joint": k, "offset": "pi"}) for k in (4, 6))],
        ),
        ("modified", [(4, 3, "-q4")], [OTHER, ("variable_reversed", 4, {"joint": 4})]),
        ("modified", REVERSED, [OTHER, *(("axis_reversed", k, {"frame": k, "joint": k}) for k in (2, 3))]),
        (
            "modified",
            [(1, 2, 0.3), (2, 3, "q2 + pi/2")],
            [
                OTHER,
                ("variable_offset", 2, {"joint": 2, "offset": "-pi/2"}),
                ("origin_slid", None, {"frame": 0}),
            ],
        ),
        ("modified", [(6, 2, 0.2)], [OTHER, ("origin_slid", 6, {"frame": 6})]),
    ],
)
def test_what_is_told_of_the_frames_of_a_right_answer(
    convention: str, cells: list[tuple[int, int, Cell]], told: list[tuple[str, int | None, dict[str, object]]]
) -> None:
    rows = PUMA if convention == "standard" else PUMA_CRAIG
    verdict = grade(KEY, read(convention, with_cells(rows, *cells)), Policy(tool=ToolRule.FREE))
    assert verdict.correct
    assert [(entry.code, entry.row, dict(entry.params)) for entry in verdict.feedback] == told


@pytest.mark.parametrize(("rows", "row"), [(PUMA, 2), (PUMA_CRAIG, 2)])
def test_an_origin_between_the_ends_is_told_beside_a_row_that_no_joint_needs(rows: Rows, row: int) -> None:
    convention = "standard" if rows is PUMA else "modified"
    before, after = rows[row - 1][2], rows[row][2]
    slid = with_cells(rows, (row, 2, f"{before} + 0.2"), (row + 1, 2, f"{after} - 0.2"))
    verdict = grade(read(convention, rows), read(convention, [*slid, (0, 0, 0, 0)]), Policy())
    assert verdict.correct
    assert [(said.code, said.params) for said in verdict.feedback] == [("origin_slid", {"frame": row})]
    key_with_row = read(convention, [*rows, (0, 0, 0, 0)])
    assert codes(grade(key_with_row, read(convention, slid), Policy())) == ["origin_slid"]


def test_frames_between_joints_move_with_the_joint_before_them() -> None:
    """Another zero of the second variable moves the last frame, and none that a fixed row makes before it."""
    rows: list[tuple[Cell, Cell, Cell, Cell]] = [
        ("pi/2", 0.1, 0, "q1"),
        (0.4, 0.2, 0.1, 0.2),
        (0.3, 0.2, 0, "q2"),
    ]
    answer = read("standard", with_cells(rows, (3, 3, "q2 + pi/2")))
    verdict = grade(read("standard", rows), answer, Policy(tool=ToolRule.FRAME))
    assert codes(verdict) == ["same_frames", "variable_offset"]
