"""POST /trees: arms that branch, by Khalil and Kleinfinger's parameters."""

import math
from typing import Any

import httpx
import numpy as np
import pytest

from tests.service.asking import answered
from tests.service.oracle import shift, turn

URL = "/api/v1/trees"
ROWS: list[dict[str, Any]] = [
    {"after": 0, "alpha": 0, "a": 0, "d": "h", "theta": "q1"},
    {"after": 1, "alpha": 90, "a": "w", "d": 0, "theta": "q2"},
    {"after": 2, "alpha": -90, "a": "L", "d": "q3 + 0.1", "theta": 20},
    {"after": 1, "gamma": 180, "b": 0.1, "alpha": 90, "a": "w", "d": 0, "theta": "q4 - 30"},
    {"after": 4, "alpha": 0, "a": "L", "d": 0, "theta": 0, "joint": "fixed"},
    {"after": 4, "gamma": 15, "b": "-w", "alpha": 40, "a": 0.05, "d": 0.2, "theta": "q5"},
]
VALUES = {"h": 0.5, "w": 0.2, "L": 0.3}
JOINTS = [10, 30, 0.4, -25, 50]
BODY = {"tree": {"angle_unit": "deg", "rows": ROWS}, "parameters": VALUES, "joints": JOINTS}


def asked(client: httpx.Client, **changes: Any) -> Any:
    return answered(client, URL, BODY | changes)


def by_hand(joints: list[float]) -> list[np.ndarray]:
    """Every frame as the product of six elementary motions, parameters written out."""
    q1, q2, q3, q4, q5 = joints
    rows = [  # after, γ, b, α, a, θ, d
        (0, 0, 0, 0, 0, q1, 0.5),
        (1, 0, 0, 90, 0.2, q2, 0),
        (2, 0, 0, -90, 0.3, 20, q3 + 0.1),
        (1, 180, 0.1, 90, 0.2, q4 - 30, 0),
        (4, 0, 0, 0, 0.3, 0, 0),
        (4, 15, -0.2, 40, 0.05, q5, 0.2),
    ]
    frames = [np.eye(4)]
    for after, gamma, b, alpha, a, theta, d in rows:
        frames.append(
            frames[after]
            @ turn("z", math.radians(gamma))
            @ shift("z", b)
            @ turn("x", math.radians(alpha))
            @ shift("x", a)
            @ turn("z", math.radians(theta))
            @ shift("z", d)
        )
    return frames[1:]


def test_frames_are_the_products_of_their_motions(client: httpx.Client) -> None:
    answer = asked(client)
    for frame, expected in zip(answer["frames"], by_hand(JOINTS), strict=True):
        assert np.allclose(frame, expected, atol=1e-14)
    assert [(end["frame"], end["joints"]) for end in answer["ends"]] == [
        (3, [1, 2, 3]),
        (5, [1, 4]),
        (6, [1, 4, 5]),
    ]


def test_jacobians_are_the_derivatives_of_the_tips(client: httpx.Client) -> None:
    step = 1e-6
    for end in asked(client, ends=[1, 3, 5, 6])["ends"]:
        k = end["frame"] - 1
        J = np.array(end["J0"])
        assert J.shape == (6, 5)
        for i in range(5):
            unit = 1.0 if i == 2 else math.degrees(1.0)
            ahead, behind = (
                [q + sign * step * unit * (n == i) for n, q in enumerate(JOINTS)] for sign in (1, -1)
            )
            change = (by_hand(ahead)[k] - by_hand(behind)[k]) / (2 * step)
            spin = change[:3, :3] @ by_hand(JOINTS)[k][:3, :3].T
            expected = [*change[:3, 3], spin[2, 1], spin[0, 2], spin[1, 0]]
            assert np.allclose(J[:, i], expected, atol=1e-8)
            assert i + 1 in end["joints"] or not J[:, i].any()


def test_the_table_of_a_tip_is_a_robot_for_every_other_call(client: httpx.Client) -> None:
    for end in asked(client)["ends"]:
        joints = [JOINTS[k - 1] for k in end["joints"]]
        names = str(end["table"]["rows"])
        body = {
            "table": end["table"],
            "parameters": {name: value for name, value in VALUES.items() if name in names},
            "joints": joints,
        }
        again = client.post("/api/v1/forward-kinematics", json=body)
        assert again.status_code == 200, again.text
        assert np.allclose(again.json()["transform"], end["transform"], atol=1e-14)


def test_a_tree_without_branches_is_a_modified_table(client: httpx.Client) -> None:
    rows = [{"alpha": 0, "a": 0, "d": 0.3, "theta": "q1"}, {"alpha": "pi/2", "a": 0.2, "d": 0, "theta": "q2"}]
    tree = {"rows": [{"after": i, **row} for i, row in enumerate(rows)]}
    answer = asked(client, tree=tree, parameters={}, joints=[0.4, 1.1])
    body = {"table": {"convention": "modified", "rows": rows}, "joints": [0.4, 1.1]}
    serial = client.post("/api/v1/forward-kinematics", json=body).json()
    assert np.allclose(answer["frames"], serial["frames"], atol=1e-15)
    assert answer["ends"][0]["table"]["rows"] == [{"joint": "revolute", **row} for row in rows]


def turning(*variables: str) -> list[dict[str, Any]]:
    return [{"after": i, "alpha": 0, "a": 0, "d": 0, "theta": q} for i, q in enumerate(variables)]


@pytest.mark.parametrize(
    ("variables", "expected"),
    [
        (["q2"], [(0, "q2", "q1")]),
        (["q2", "q4"], [(0, "q2", "q1"), (1, "q4", "q2")]),
        (["q2", "q1"], [(0, "q2", "q1"), (1, "q1", "q2")]),
        (["q1", "q4"], [(1, "q4", "q2")]),
    ],
)
def test_variables_are_numbered_by_the_joints_of_the_rows(
    client: httpx.Client, variables: list[str], expected: list[tuple[int, str, str]]
) -> None:
    body = {"tree": {"rows": turning(*variables)}, "joints": [0] * len(variables)}
    response = client.post(URL, json=body)
    assert response.status_code == 422, response.text
    found = [(each["pointer"], each["code"], each["params"]) for each in response.json()["errors"]]
    assert [(pointer, params["name"], params["expected"]) for pointer, _, params in found] == [
        (f"/tree/rows/{row}/theta", name, own) for row, name, own in expected
    ]
    assert {code for _, code, _ in found} == {"variable_of_other_row"}


SLIDES = [{"after": i, "alpha": 0, "a": 0, "theta": 0, "d": f"q{i + 1}"} for i in range(2)]


@pytest.mark.parametrize(
    ("rows", "changes", "code", "pointer"),
    [
        ([ROWS[0], {**ROWS[1], "after": 2}], {}, "tree_after_unknown", "/tree/rows/1/after"),
        ([{**ROWS[0], "gamma": "1/0"}], {}, None, "/tree/rows/0/gamma"),
        ([ROWS[0], {**ROWS[1], "b": "w +"}], {}, None, "/tree/rows/1/b"),
        ([ROWS[0], {**ROWS[1], "b": "q2"}], {}, "variable_in_constant_cell", "/tree/rows/1/b"),
        ([{**ROWS[0], "gamma": "q1"}], {}, "variable_in_constant_cell", "/tree/rows/0/gamma"),
        ([ROWS[0], {**ROWS[1], "a": "w*"}], {}, None, "/tree/rows/1/a"),
        (ROWS, {"ends": [7]}, "frame_unknown", "/ends/0"),
        (ROWS, {"joints": [1, 2]}, "joints_wrong_length", "/joints"),
        (ROWS, {"parameters": {"h": 1, "w": 1}}, "parameter_missing", "/parameters/L"),
        (ROWS, {"parameters": {"h": 1, "w": 1, "L": 1e200}}, "result_not_finite", "/tree/rows/2/a"),
        (SLIDES, {"parameters": {}, "joints": [1e308, 1e308]}, "result_not_finite", "/joints/0"),
        ([], {}, None, "/tree/rows"),
    ],
)
def test_refusals_stand_in_the_tree(
    client: httpx.Client, rows: list[Any], changes: dict[str, Any], code: str | None, pointer: str
) -> None:
    body = BODY | {"tree": {"angle_unit": "deg", "rows": rows}} | changes
    response = client.post(URL, json=body)
    assert response.status_code == 422, response.text
    errors = response.json()["errors"]
    assert pointer in [error["pointer"].removeprefix("#") for error in errors], errors
    assert code is None or code in [error["code"] for error in errors]
