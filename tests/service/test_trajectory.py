"""POST /trajectory, and the ellipsoids of /rates: units, refusals, agreement with the calls beside them."""

from typing import Any

import httpx
import numpy as np
import pytest

from tests.service.test_bad_input import check_problem

PATH = "/api/v1/trajectory"
PUMA: dict[str, Any] = {
    "robot": "puma560",
    "start": [0, 45, -180, 0, 45, 0],
    "end": [90, 90, -90, 0, 0, 10],
    "duration": 2,
    "samples": 9,
}


def test_in_degrees_with_the_path_of_the_end_frame(client: httpx.Client) -> None:
    found = client.post(PATH, json=PUMA).json()
    assert found["angle_unit"] == "deg"
    np.testing.assert_allclose(found["positions"][4], [45, 67.5, -135, 0, 22.5, 5], atol=1e-9)
    np.testing.assert_allclose(np.max(found["velocities"], axis=0)[0], 90 / 2 * 15 / 8)
    poses = client.post(
        "/api/v1/forward-kinematics",
        json={"robot": "puma560", "joints": found["positions"], "parts": ["position"]},
    ).json()
    np.testing.assert_allclose(found["path"], poses["position"], atol=1e-12)


@pytest.mark.parametrize(
    ("change", "code", "pointer"),
    [
        ({"end": [0, 0]}, "joints_wrong_length", "/end"),
        ({"start": [0, 0, 0, 0, 0, 1e300]}, "result_not_finite", "/start/5"),
        ({"duration": 0}, None, "/duration"),
        ({"samples": 1}, None, "/samples"),
        ({"scaling": "linear"}, None, "/scaling"),
    ],
)
def test_refusals(client: httpx.Client, change: dict[str, Any], code: str | None, pointer: str) -> None:
    response = client.post(PATH, json={**PUMA, **change})
    assert response.status_code == 422
    problem = response.json()
    check_problem(response, 422, problem["code"])
    assert problem["errors"][0]["pointer"] == pointer
    assert code in (None, problem["code"])


def test_the_ellipsoid_of_a_wrist_singularity(client: httpx.Client) -> None:
    body = {"robot": "puma560", "joints": [0, 45, -180, 0, 0, 0]}
    found = client.post("/api/v1/rates", json=body).json()
    ellipsoids = found["ellipsoids"]
    assert len(ellipsoids["blocked"]) == 1
    twist = np.array(found["J0"]) / np.array([ellipsoids["characteristic_length"]] * 3 + [1] * 3)[:, None]
    np.testing.assert_allclose(np.array(ellipsoids["blocked"]) @ twist, 0, atol=1e-9)


def test_joint_values_beyond_all_lengths_are_refused(client: httpx.Client) -> None:
    response = client.post("/api/v1/rates", json={"robot": "scara", "joints": [0, 0, 1e300, 0]})
    assert response.status_code == 422
    assert response.json()["code"] == "result_not_finite"
