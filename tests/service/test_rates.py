"""POST /rates: velocities, accelerations, forces."""

import math
from typing import Any

import httpx
import numpy as np
import pytest

from tests.service.asking import answered
from tests.service.test_bad_input import check_problem

PATH = "/api/v1/rates"
ARM: dict[str, Any] = {
    "table": {
        "convention": "standard",
        "angle_unit": "deg",
        "length_unit": "m",
        "rows": [
            {"alpha": 0, "a": 0.4, "d": 0, "theta": "q1"},
            {"alpha": 0, "a": 0.3, "d": 0, "theta": "q2"},
        ],
    },
    "joints": [0, 90],
}


def test_two_links_by_hand(client: httpx.Client) -> None:
    """Tip at (0.4, 0.3); joint 1 turns at 1 rad/s: v = (-0.3, 0.4), centripetal (-0.4, -0.3)."""
    one = math.degrees(1.0)
    found = answered(
        client, PATH, {**ARM, "rates": [one, 0], "accelerations": [0, 0], "wrench": [0, -10, 0, 0, 0, 0]}
    )
    np.testing.assert_allclose(found["velocity"], [-0.3, 0.4, 0, 0, 0, 1], atol=1e-12)
    np.testing.assert_allclose(found["acceleration"], [-0.4, -0.3, 0, 0, 0, 0], atol=1e-12)
    np.testing.assert_allclose(found["joint_forces"], [-4, 0], atol=1e-12)
    np.testing.assert_allclose(found["analytic"][5], [1, 1], atol=1e-12)


def test_the_jacobian_is_that_of_its_own_call(client: httpx.Client) -> None:
    body = {"robot": "puma560", "joints": [10, 20, -30, 40, 50, 60]}
    found = answered(client, PATH, body)
    own = client.post("/api/v1/jacobian", json=body).json()
    np.testing.assert_allclose(found["J0"], own["J0"], atol=1e-12)
    assert found["velocity"] is found["J0_rate"] is found["acceleration"] is found["joint_forces"] is None


@pytest.mark.parametrize("turning", ["current", "fixed"])
@pytest.mark.parametrize("axes", ["ZYZ", "XYZ", "YXZ", "XZX"])
def test_the_analytic_jacobian_of_any_angles_is_the_derivative(
    client: httpx.Client, axes: str, turning: str
) -> None:
    """Three turns, by the angles of the pose and by what they change, make the poses beside it."""
    q, moved, h = [10.0, 20.0, -30.0, 40.0, 50.0, 60.0], [3.0, -1.0, 2.0, 1.0, -2.0, 1.0], 1e-6
    found = answered(
        client, PATH, {"robot": "puma560", "joints": q, "angles": {"axes": axes, "turning": turning}}
    )
    changed = np.array(found["analytic"]) @ np.radians(moved)

    def pose(step: float) -> Any:
        joints = [a + step * b for a, b in zip(q, moved, strict=True)]
        body = {"robot": "puma560", "joints": joints, "parts": ["transform"]}
        return np.array(client.post("/api/v1/forward-kinematics", json=body).json()["transform"])

    here = pose(0.0)
    rotations = client.post(
        "/api/v1/rotations", json={"orientation": {"matrix": here[:3, :3].tolist()}}
    ).json()
    (angles,) = (
        known["triples"][0]
        for known in rotations["sequences"]
        if (known["axes"], known["turning"]) == (axes, turning)
    )

    def turned(values: Any) -> Any:
        turns = [_turn(axis, value) for axis, value in zip(axes, values, strict=True)]
        first, second, third = turns if turning == "current" else turns[::-1]
        return first @ second @ third

    np.testing.assert_allclose(turned(angles), here[:3, :3], atol=1e-12)
    there = turned(angles + h * changed[3:]) - turned(angles - h * changed[3:])
    np.testing.assert_allclose(there, (pose(h) - pose(-h))[:3, :3], atol=1e-11)
    np.testing.assert_allclose(2 * h * changed[:3], (pose(h) - pose(-h))[:3, 3], atol=1e-11)


def _turn(axis: str, angle: float) -> Any:
    k = "XYZ".index(axis)
    i, j = (k + 1) % 3, (k + 2) % 3
    turned = np.eye(3)
    turned[[i, i, j, j], [i, j, i, j]] = (
        math.cos(angle),
        -math.sin(angle),
        math.sin(angle),
        math.cos(angle),
    )
    return turned


def test_at_gimbal_lock_there_is_no_analytic_jacobian(client: httpx.Client) -> None:
    level = {
        "robot": "onelink",
        "joints": [10],
        "tool": [[0, 0, 1, 0], [0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 1]],
    }
    assert answered(client, PATH, level)["analytic"] is None


@pytest.mark.parametrize(
    ("more", "code", "pointer"),
    [
        ({"joints": [0]}, "joints_wrong_length", "/joints"),
        ({"rates": [0]}, "joints_wrong_length", "/rates"),
        ({"accelerations": [0, 0, 0]}, "joints_wrong_length", "/accelerations"),
        ({"angles": {"axes": "ZZX"}}, "euler_axes_unknown", "/angles/axes"),
        ({"tool": [[2, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}, "pose_not_orthonormal", "/tool"),
        ({"tool": [1.5e308, 1.5e308, 0, 0, 0, 0]}, "result_not_finite", "/tool"),
        ({"wrench": [1.7e308] * 6}, "result_not_finite", "/wrench/0"),
    ],
)
def test_what_is_refused(client: httpx.Client, more: dict[str, Any], code: str, pointer: str) -> None:
    check_problem(client.post(PATH, json={**ARM, **more}), 422, code, pointer)


@pytest.mark.parametrize(
    ("language", "said"), [("en", "of one value was"), ("es", "de un valor."), ("ro", "cu o valoare.")]
)
def test_one_value_is_said_in_the_singular(client: httpx.Client, language: str, said: str) -> None:
    response = client.post(PATH, json={**ARM, "joints": [0]}, headers={"Accept-Language": language})
    assert said in response.json()["detail"]
