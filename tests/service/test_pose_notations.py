"""Base and tool as a matrix, as [X, Y, Z, A, B, C] and as a position with a quaternion: one meaning."""

import math

import numpy as np
import pytest

from service.routes.kinematics.workspace import WorkspaceRequest
from service.schemas.kinematics.inverse_forms import SymbolicInverseRequest
from service.wire.kinematics.pose_matrices import base_and_tool

ROBOT = {"robot": "twolink"}
JOINTS = {"joints": [0.3, 0.8]}
CALLS = {
    "/forward-kinematics": ROBOT | JOINTS,
    "/jacobian": ROBOT | JOINTS,
    "/rates": ROBOT | JOINTS,
    "/symbolic": ROBOT,
    "/convert": ROBOT | {"to": "poe"},
    "/inverse-kinematics": {"robot": "puma560", "target": [0.4, 0.3, 0.1, 0.2, 0.4, 0.3]},
}
TABLE = {
    "convention": "standard",
    "angle_unit": "deg",
    "rows": [{"alpha": 0, "a": 1, "d": 0, "theta": "q1"}, {"alpha": 0, "a": 1, "d": 0, "theta": "q2"}],
}
MATRIX = [[0, -1, 0, 0.1], [1, 0, 0, 0.2], [0, 0, 1, 0.0], [0, 0, 0, 1]]
PLACED = {"position": [0.1, 0.2, 0.0], "quaternion": [2.0, 0, 0, 2.0]}


def _six(angle_unit):
    return [0.1, 0.2, 0.0, 90 if angle_unit == "deg" else math.pi / 2, 0, 0]


def _numbers(answer):
    """The numbers of an answer, in its order."""
    if isinstance(answer, dict):
        return [x for value in answer.values() for x in _numbers(value)]
    if isinstance(answer, list):
        return [x for value in answer for x in _numbers(value)]
    return [answer] if isinstance(answer, float | int) else []


@pytest.mark.parametrize("end", ["base", "tool"])
@pytest.mark.parametrize("path", CALLS)
def test_three_notations_of_a_pose_are_one(client, path, end):
    answers = []
    unit = client.get(f"/api/v1/robots/{CALLS[path]['robot']}").json()["table"]["angle_unit"]
    for pose in (MATRIX, _six(unit), PLACED):
        answer = client.post("/api/v1" + path, json=CALLS[path] | {end: pose})
        assert answer.status_code == 200, answer.text
        answers.append(_numbers(answer.json()))
    plain = client.post("/api/v1" + path, json=CALLS[path])
    assert _numbers(plain.json()) != answers[0]
    for other in answers[1:]:
        assert np.allclose(other, answers[0], atol=1e-9)


@pytest.mark.parametrize(
    "question",
    [
        WorkspaceRequest.model_validate(ROBOT),
        SymbolicInverseRequest.model_validate(ROBOT | {"form": "symbolic"}),
    ],
    ids=["workspace", "inverse form"],
)
@pytest.mark.parametrize("end", ["base", "tool"])
def test_calls_of_workers_read_the_same_notations(question, end):
    for pose in (_six("deg"), PLACED):
        asked = type(question).model_validate(question.model_dump(exclude_none=True) | {end: pose})
        base, tool = base_and_tool(asked, math.radians(1.0))
        given, other = (base, tool) if end == "base" else (tool, base)
        assert other is None
        assert np.allclose(given, MATRIX, atol=1e-15)


def test_closed_forms_take_angles_in_the_tables_unit(client):
    answers = [
        client.post("/api/v1/symbolic", json={"table": TABLE, "tool": pose}) for pose in (MATRIX, _six("deg"))
    ]
    assert [answer.status_code for answer in answers] == [200, 200], answers[1].text
    assert answers[0].json() == answers[1].json()


def test_a_quaternion_of_no_length_is_refused(client):
    pose = {"position": [0, 0, 0], "quaternion": [0, 0, 0, 0]}
    answer = client.post("/api/v1/forward-kinematics", json=ROBOT | JOINTS | {"tool": pose})
    assert answer.status_code == 422
    (fault,) = answer.json()["errors"]
    assert (fault["code"], fault["pointer"]) == ("quaternion_length", "/tool/quaternion")


AXES = [{"joint": "revolute", "direction": [0, 0, 1]}, {"joint": "revolute", "direction": [0, 1, 0]}]
FRAMES = {"axes": AXES, "convention": "standard", "angle_unit": "deg"}
SCREWS = [{"linear": [0, 0, 0], "angular": [0, 0, 1]}, {"linear": [0, -1, 0], "angular": [0, 0, 1]}]
ROWS = [[*screw["linear"], *screw["angular"]] for screw in SCREWS]


@pytest.mark.parametrize(
    ("path", "body", "place"),
    [
        ("assign-frames", FRAMES, ("base",)),
        ("assign-frames", FRAMES, ("tool",)),
        ("check-frames", FRAMES | {"frames": []}, ("base",)),
        ("check-frames", FRAMES | {"frames": [None, None, {}]}, ("tool",)),
        ("convert", {"to": "standard", "poe": {"screws": SCREWS}, "angle_unit": "deg"}, ("poe", "home")),
        ("check-screws", {"table": TABLE, "screws": ROWS}, ("home",)),
    ],
)
def test_frames_and_home_poses_are_taken_in_the_same_notations(client, path, body, place):
    answers = []
    for pose in (MATRIX, _six("deg"), PLACED):
        asked = body | {place[0]: body.get(place[0], {}) | {place[-1]: pose} if place[1:] else pose}
        answer = client.post(f"/api/v1/{path}", json=asked)
        assert answer.status_code == 200, answer.text
        answers.append(_numbers(answer.json()))
    assert len(answers[0]) > 1
    for other in answers[1:]:
        assert np.allclose(other, answers[0], atol=1e-9)


@pytest.mark.parametrize("end", ["base", "tool"])
def test_a_matrix_in_one_row_is_told_that_it_needs_four(client, end):
    for path, body in (("forward-kinematics", ROBOT | JOINTS), ("assign-frames", FRAMES)):
        answer = client.post(f"/api/v1/{path}", json=body | {end: [1] * 16})
        assert answer.status_code == 422
        assert (answer.json()["code"], answer.json()["pointer"]) == ("pose_in_one_row", f"/{end}")


def test_a_matrix_with_a_short_row_is_refused_at_its_place(client):
    ragged = [[1, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    for end in ("base", "tool"):
        answer = client.post("/api/v1/forward-kinematics", json=ROBOT | JOINTS | {end: ragged})
        assert answer.status_code == 422
        assert answer.json()["pointer"] == f"/{end}"
