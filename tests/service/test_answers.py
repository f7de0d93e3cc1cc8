"""Calls that judge by meaning, over HTTP."""

import math
from typing import Any

import httpx
import numpy as np
import pytest

from kinematics.inverse.goals import rounding_of

ONE_LINK = {"convention": "standard", "rows": [{"theta": "q1", "d": 0, "a": 0.5, "alpha": 0}]}
TARGET = [[0, 0, 1, 0.5], [0, -1, 0, 0.2], [1, 0, 0, 0.3], [0, 0, 0, 1]]


def post(client: httpx.Client, path: str, body: Any, language: str = "en") -> Any:
    answer = client.post(f"/api/v1/{path}", json=body, headers={"Accept-Language": language})
    assert answer.status_code == 200, answer.text
    return answer.json()


@pytest.mark.parametrize(
    ("diagonal", "why"),
    [((1, 1, 2), "a column is not of length 1"), ((1, 1, -1), "it is a reflection, with determinant −1")],
)
def test_an_expected_matrix_that_is_no_rotation_is_told_why(
    client: httpx.Client, diagonal: tuple[int, int, int], why: str
) -> None:
    body = {"expected": {"matrix": np.diag(diagonal).tolist()}, "answer": {"angles": [0, 0, 0]}}
    answer = client.post("/api/v1/check-rotation", json=body).json()
    assert answer["detail"] == f"The expected matrix is not a rotation: {why}."


def test_all_notations_of_an_orientation_are_accepted_as_answers(client: httpx.Client) -> None:
    given = {"angles": [30, 45, -60], "axes": "XYZ", "turning": "fixed"}
    found = post(client, "rotations", {"orientation": given, "angle_unit": "deg"})
    assert found["is_rotation"]
    assert len(found["sequences"]) == 24
    answers = [
        {"matrix": found["matrix"]},
        {"quaternion": [-value for value in found["quaternion"]]},
        {"axis": [-value for value in found["axis"]], "angle": 360 - found["angle"]},
        *(
            {"triples": entry["triples"], "axes": entry["axes"], "turning": entry["turning"]}
            for entry in found["sequences"]
        ),
    ]
    for answer in answers:
        body = {"expected": given, "answer": answer, "angle_unit": "deg", "every": True}
        assert post(client, "check-rotation", body) == {"correct": True, "score": 1, "mistakes": []}


def test_gimbal_lock_is_told_with_its_family(client: httpx.Client) -> None:
    given = {"angles": [20, 90, 10]}
    found = post(client, "rotations", {"orientation": given, "angle_unit": "deg"})
    entry = next(e for e in found["sequences"] if (e["axes"], e["turning"]) == ("ZYX", "current"))
    assert entry["family"] == {"middle": 90, "combination": "difference", "value": pytest.approx(10)}
    for answer, right in ((entry["family"], True), ({**entry["family"], "value": 20}, False)):
        body = {"expected": given, "answer": {"family": answer}, "angle_unit": "deg", "every": True}
        assert post(client, "check-rotation", body)["correct"] is right


@pytest.mark.parametrize(
    ("path", "body", "code", "pointer"),
    [
        ("rotations", {"orientation": {}}, "one_notation", "/orientation"),
        (
            "rotations",
            {"orientation": {"angles": [1, 2, 3], "axes": "XXY"}},
            "euler_axes_unknown",
            "/orientation/axes",
        ),
        (
            "rotations",
            {"orientation": {"quaternion": [0, 0, 0, 0]}},
            "quaternion_length",
            "/orientation/quaternion",
        ),
        ("rotations", {"orientation": {"axis": [0, 0, 1]}}, "axis_and_angle", "/orientation/angle"),
        (
            "check-rotation",
            {"expected": {"matrix": [[1, 0, 0], [0, 1, 0], [0, 0, -1]]}, "answer": {"angles": [0, 0, 0]}},
            "expected_not_rotation",
            "/expected/matrix",
        ),
        (
            "check-inverse-kinematics",
            {"robot": "puma560", "target": TARGET, "solutions": [[1, 2]]},
            "joint_row_length",
            "/solutions/0",
        ),
        ("plant-mistake", {"table": ONE_LINK, "seed": "x" * 201}, "seed_too_long", "/seed"),
        ("plant-matrix-mistake", {"table": ONE_LINK, "seed": "x" * 201}, "seed_too_long", "/seed"),
        (
            "plant-frame-mistake",
            {
                "axes": [{"joint": "revolute", "point": [0, 0, 0], "direction": [0, 0, 1]}],
                "convention": "standard",
                "seed": "x" * 201,
            },
            "seed_too_long",
            "/seed",
        ),
        (
            "check-jacobian",
            {"table": ONE_LINK, "joints": [1e70], "jacobian": [[0]] * 6},
            "result_not_finite",
            "/joints/0",
        ),
    ],
)
def test_what_cannot_be_judged_is_refused_with_its_place(
    client: httpx.Client, path: str, body: Any, code: str, pointer: str
) -> None:
    answer = client.post(f"/api/v1/{path}", json=body)
    assert (answer.status_code, answer.json()["code"], answer.json()["pointer"]) == (422, code, pointer)


def test_the_solutions_of_a_pose_are_all_right_in_any_frames(client: httpx.Client) -> None:
    solved = post(client, "inverse-kinematics", {"robot": "puma560", "target": TARGET})
    rows = [solution["joints"] for solution in solved["solutions"]]
    question = {"robot": "puma560", "target": TARGET}
    found = post(client, "check-inverse-kinematics", {**question, "solutions": rows})
    assert found["correct"], found
    short = post(client, "check-inverse-kinematics", {**question, "solutions": rows[1:]}, "fr")
    assert not short["correct"]
    assert [entry["code"] for entry in short["feedback"]] == ["joints_missing", "branch_wrist"]
    assert "poignet" in short["feedback"][1]["message"]


def test_a_singular_pose_as_printed_has_its_family(client: httpx.Client) -> None:
    """With four decimals the wrist is 0.01° off its line: what nobody can tell from the printed pose."""
    joints = [30, -40, 70, 20, 0, -80]
    pose = post(client, "forward-kinematics", {"robot": "puma560", "joints": joints})["transform"]
    printed = [[round(value, 4) for value in row] for row in pose]
    solved = post(client, "inverse-kinematics", {"robot": "puma560", "target": printed, "tolerance": 3e-4})
    rows = [solution["joints"] for solution in solved["solutions"]]
    question = {"robot": "puma560", "target": printed}
    answer = {"claim": "infinite", "solutions": rows, "combinations": [[0, 0, 0, 1, 0, 1]]}
    for combinations, right in ([[0, 0, 0, 1, 0, 1]], True), ([[0, 0, 0, 1, 0, -1]], False):
        body = {**question, **answer, "combinations": combinations}
        found = post(client, "check-inverse-kinematics", body)
        assert (found["expected"], found["correct"]) == ("infinite", right)
    finite = post(client, "check-inverse-kinematics", {**question, **answer, "claim": "finite"})
    assert not finite["correct"]


@pytest.mark.parametrize("joints", [[0, 90, -90, 0, 0, 0], [90, 0, -90, 0, 0, 90], [0, -90, 90, 0, 0, 90]])
def test_a_position_as_printed_has_its_family_where_the_rotation_is_exact(
    client: httpx.Client, joints: list[int]
) -> None:
    """d3 = 0.15005 is printed as 0.15 or 0.1501, and the wrist is off its line."""
    pose = post(client, "forward-kinematics", {"robot": "puma560", "joints": joints})["transform"]
    printed = [[round(value, 4) for value in row] for row in pose]
    question = {"robot": "puma560", "target": printed, "every": False, "solutions": [joints]}
    found = post(client, "check-inverse-kinematics", {**question, "claim": "infinite"})
    assert (found["expected"], found["correct"]) == ("infinite", True)


@pytest.mark.parametrize("decimals", [4, 5, 6])
def test_a_stretched_arm_is_reached_where_its_position_was_printed(
    client: httpx.Client, decimals: int
) -> None:
    """Rounded outwards the position is out of reach; rounded inwards it has two elbows."""
    rows = [{"theta": f"q{i}", "d": 0, "a": a, "alpha": 0} for i, a in enumerate((1, 0.7), 1)]
    table = {"convention": "standard", "angle_unit": "deg", "rows": rows}
    for turn in range(-170, 180, 35):
        angle = math.radians(turn)
        target = [round(1.7 * value, decimals) for value in (math.cos(angle), math.sin(angle))]
        body = {"table": table, "target": [*target, 0, 0, 0, 0], "position_only": True, "claim": "finite"}
        assert post(client, "check-inverse-kinematics", {**body, "solutions": [[turn, 0]]})["correct"], target
        bent = post(client, "check-inverse-kinematics", {**body, "solutions": [[turn + 5, -10]]})
        assert not bent["correct"]


def test_positions_with_few_digits_are_exact() -> None:
    positions = ((1.5, 0, 0), (0.455, 0.2, 0), (863, 0, 150), (0.1 + 0.2, 0.5**0.5, 0), (0, 0, 0))
    assert [rounding_of(np.array(position)) for position in positions] == [0.0] * 5
    assert rounding_of(np.array([1.4722, 0.85, 0])) == pytest.approx(math.sqrt(3) * 5e-5)
    assert rounding_of(np.array([863.6, -150.1, 0])) < 2e-3


@pytest.mark.parametrize(
    ("combinations", "right"),
    [([], True), ([[0, 1]], True), ([[0, -3]], True), ([[1, 0]], False), ([[1, 1]], False)],
)
def test_a_joint_that_moves_alone_leaves_the_others_where_they_are(
    client: httpx.Client, combinations: list[list[int]], right: bool
) -> None:
    """Two equal links, folded: the tip is on the axis of joint 1 however that joint turns."""
    rows = [{"theta": f"q{i}", "d": 0, "a": 1, "alpha": 0} for i in (1, 2)]
    found = post(
        client,
        "check-inverse-kinematics",
        {
            "table": {"convention": "standard", "angle_unit": "deg", "rows": rows},
            "target": [0, 0, 0, 0, 0, 0],
            "position_only": True,
            "claim": "infinite",
            "solutions": [[10, 180]],
            "combinations": combinations,
        },
    )
    assert found["correct"] is right, found


def test_joint_values_of_ones_own_table_are_carried_over_by_its_certificate(client: httpx.Client) -> None:
    """The same arm in the other convention, with a variable reversed, a zero moved and a raised frame 0."""
    key = {
        "convention": "standard",
        "angle_unit": "deg",
        "rows": [
            {"theta": "q1", "d": 0, "a": 0.5, "alpha": 0},
            {"theta": "q2", "d": 0, "a": 0.3, "alpha": 0},
        ],
    }
    own = {
        "convention": "modified",
        "angle_unit": "deg",
        "rows": [
            {"alpha": 180, "a": 0, "d": -0.2, "theta": "q1"},
            {"alpha": 0, "a": 0.5, "d": 0, "theta": "q2 + 90"},
            {"joint": "fixed", "alpha": 0, "a": 0.3, "d": 0, "theta": 0},
        ],
    }
    pose = post(client, "forward-kinematics", {"table": own, "joints": [-25, -130]})["transform"]
    body = {"table": key, "own": own, "target": pose, "solutions": [[-25, -130]], "every": False}
    found = post(client, "check-inverse-kinematics", body)
    assert found["own_accepted"]
    assert found["correct"], found
    wrong = post(client, "check-inverse-kinematics", {**body, "solutions": [[25, -130]]})
    assert not wrong["correct"]
    stranger = {**own, "rows": [*own["rows"][:1], {**own["rows"][1], "a": 0.4}, own["rows"][2]]}
    found = post(client, "check-inverse-kinematics", {**body, "own": stranger})
    assert (found["own_accepted"], found["correct"]) == (False, False)


def test_singularities_are_judged_as_a_set(client: httpx.Client) -> None:
    puma = {"robot": "puma560", "conditions": ["a3*s3 + d4*c3", "q5 = 0, 180°", "a2*c2 + a3*c23 = d4*s23"]}
    found = post(client, "check-singularities", puma)
    assert (found["correct"], found["proof"], found["whole"]) == (True, "proved", True)
    less = post(client, "check-singularities", {**puma, "conditions": ["q5 = 0", "cos(q1)"]}, "de, fr")
    assert not less["correct"]
    assert sorted(family["found"] for family in less["families"]) == [0, 0, 0, 1]
    assert [entry["status"] for entry in less["conditions"]] == ["singular", "invented"]
    assert "singulier" in less["conditions"][1]["message"]
    assert len(less["conditions"][1]["example"]) == 6
    links = {
        "table": {
            "convention": "standard",
            "rows": [{"theta": f"q{i}", "d": 0, "a": 0.5, "alpha": 0} for i in (1, 2)],
        }
    }
    lost = {**links, "motion": "translation", "joints": [0, 0], "lost": [2, 0, 0]}
    assert post(client, "check-singularities", lost)["lost"] is True
    assert post(client, "check-singularities", {**lost, "lost": [0, 1, 0]})["correct"] is False


@pytest.mark.parametrize(
    ("more", "code", "pointer"),
    [
        ({}, "conditions_empty", ""),
        ({"conditions": ["q1 < 2"]}, "condition_not_equation", "/conditions/0"),
        ({"conditions": [0, "x*sin(q1)"]}, "name_without_value", "/conditions/1"),
        ({"lost": [1, 0, 0]}, "joint_row_length", "/lost"),
        ({"lost": [1, 0, 0, 0, 0, 0], "joints": [1] * 6}, "not_singular", "/joints"),
        ({"robot": "iiwa14", "conditions": ["sin(q4)"]}, "form_too_large", ""),
    ],
)
def test_singularities_that_cannot_be_judged_are_refused(
    client: httpx.Client, more: dict[str, Any], code: str, pointer: str
) -> None:
    answer = client.post("/api/v1/check-singularities", json={"robot": "puma560", **more})
    assert answer.status_code == 422, answer.text
    assert [(error["code"], error.get("pointer", "")) for error in answer.json()["errors"]] == [
        (code, pointer)
    ]


def test_a_mistake_is_planted_in_a_matrix(client: httpx.Client) -> None:
    table = {
        "convention": "standard",
        "rows": [{"theta": f"q{i}", "d": 0, "a": f"L{i}", "alpha": "pi/2"} for i in (1, 2, 3)],
    }
    for matrix in ("link", "transform"):
        body = {"table": table, "matrix": matrix, "seed": 4}
        found = post(client, "plant-matrix-mistake", body, "uk")
        assert post(client, "plant-matrix-mistake", body, "uk") == found
        apart = [
            {"row": r + 1, "column": c + 1}
            for r in range(4)
            for c in range(4)
            if found["matrix"][r][c] != found["mended"][r][c]
        ]
        assert found["wrong_cells"]
        assert all(cell in apart for cell in found["wrong_cells"])
        assert (found["row"] is None) == (matrix == "transform")
        assert found["label"] != found["mistake"]


def test_a_mistake_is_planted_in_frames(client: httpx.Client) -> None:
    axes = [{"joint": "revolute", "point": [0.3 * i, 0, 0], "direction": [0, i % 2, 1]} for i in range(3)]
    for convention in ("standard", "modified"):
        body = {"axes": axes, "convention": convention, "seed": 4}
        found = post(client, "plant-frame-mistake", body, "uk")
        assert post(client, "plant-frame-mistake", body, "uk") == found
        assert found["label"] != found["mistake"]
        frames = found["frames"]
        assert frames[found["frame"]] != found["mended"]
        frames[found["frame"]] = found["mended"]
        judged = post(client, "check-frames", {"axes": axes, "convention": convention, "frames": frames})
        assert judged["table"] is not None
