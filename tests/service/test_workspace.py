"""POST /workspace."""

from typing import Any

import httpx
import numpy as np
import pytest

from tests.examples import CYLINDRICAL, PUMA_560, TWO_LINKS
from tests.service.asking import answered
from tests.service.test_bad_input import check_problem

PATH = "/api/v1/workspace"
FK = "/api/v1/forward-kinematics"
LENGTHS = {"L1": 400, "L2": 120, "L3": 75}
FAR = [[1, 0, 0, 1e300], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]


def test_degrees_and_units(client: httpx.Client) -> None:
    table = {**TWO_LINKS, "angle_unit": "deg", "length_unit": "mm"}
    found = answered(
        client, PATH, {"table": table, "parameters": {"L1": 400, "L2": 300}, "limits": [[0, 90], [90, 90]]}
    )
    assert (found["angle_unit"], found["length_unit"]) == ("deg", "mm")
    assert found["inner_radius"] == pytest.approx({"axis": 500, "origin": 500})
    assert found["outer_radius"] == pytest.approx({"axis": 500, "origin": 500})
    assert found["box"]["min"] == pytest.approx([-300, 300, 0])
    assert found["box"]["max"] == pytest.approx([400, 500, 0])
    assert found["reached"]["outer_radius"]["axis"][1] == pytest.approx(90)
    assert "points" not in found


def test_the_support_plane_with_the_hand_down(client: httpx.Client) -> None:
    found = answered(client, PATH, {"robot": "dmra", "plane": {}, "axis": [0, 0, -1], "limits": [None] * 6})
    assert found["outer_radius"]["axis"] == pytest.approx(
        45 + np.sqrt((115 + np.hypot(20, 130)) ** 2 - 25**2), abs=1e-7
    )
    joints = found["reached"]["outer_radius"]["axis"]
    pose = np.array(client.post(FK, json={"robot": "dmra", "joints": joints}).json()["transform"])
    assert pose[2, 3] == pytest.approx(0.0, abs=1e-7)
    assert pose[2, 2] == pytest.approx(-1.0, abs=1e-9)
    oriented = answered(client, PATH, {"robot": "puma560", "quaternion": [0, 1, 0, 0], "samples": 10})
    assert 0 < len(oriented["points"]) <= 10


PINNED = [[10, 10.1]] * 6


@pytest.mark.parametrize(
    ("changes", "code", "pointer"),
    [
        ({"plane": {"point": [0, 0, 5000]}}, "workspace_condition_unmet", "/plane"),
        ({"plane": {"normal": [0, 0, 0]}}, "axis_length", "/plane/normal"),
        ({"plane": {"point": [0, 0, 1e300]}}, "result_not_finite", "/plane/point"),
        ({"axis": [0, 0, 0]}, "axis_length", "/axis"),
        ({"axis": [0, 0, 1], "limits": PINNED}, "workspace_condition_unmet", "/axis"),
        ({"quaternion": [1, 0, 0, 0], "limits": PINNED}, "workspace_condition_unmet", "/quaternion"),
        ({"axis": [0, 0, 1], "quaternion": [1, 0, 0, 0]}, "quaternion_or_axis", ""),
    ],
)
def test_conditions_that_cannot_be_met(
    client: httpx.Client, changes: dict[str, Any], code: str, pointer: str
) -> None:
    response = client.post(PATH, json={"robot": "dmra", **changes})
    assert response.status_code == 422, response.text
    error = response.json()["errors"][0]
    assert (error["code"], error["pointer"].removeprefix("#")) == (code, pointer)


def test_ranges_wider_than_a_turn_are_one_turn(client: httpx.Client) -> None:
    body = {"table": TWO_LINKS, "parameters": {"L1": 1, "L2": 1}}
    free = answered(client, PATH, body)
    for limits in ([[-1e308, 1e308], [0, 1e308]], [[-100, 100], [-1e9, 7]]):
        wide = answered(client, PATH, {**body, "limits": limits})
        assert wide["outer_radius"] == pytest.approx(free["outer_radius"])
        assert wide["inner_radius"] == pytest.approx(free["inner_radius"], abs=1e-12)
        assert all(
            low <= q <= high
            for q, (low, high) in zip(wide["reached"]["outer_radius"]["axis"], limits, strict=True)
        )


def test_the_catalogue_knows_its_limits(client: httpx.Client) -> None:
    own = answered(client, PATH, {"robot": "scara", "samples": 20})
    free = answered(client, PATH, {"robot": "scara", "limits": [None, None, [-0.2, 0], None]})
    assert own["inner_radius"]["axis"] > 0.2
    assert free["inner_radius"]["axis"] == pytest.approx(0.1)
    assert len(own["points"]) == 20
    low, high = np.array(own["box"]["min"]), np.array(own["box"]["max"])
    assert all(((low - 1e-12 <= p) & (p <= high + 1e-12)).all() for p in np.array(own["points"]))


def test_a_radius_can_be_checked(client: httpx.Client) -> None:
    found = answered(client, PATH, {"robot": "puma560"})
    joints = found["reached"]["outer_radius"]["origin"]
    there = client.post(FK, json={"robot": "puma560", "joints": joints}).json()["position"]
    assert np.linalg.norm(there) == pytest.approx(found["outer_radius"]["origin"], abs=1e-12)


@pytest.mark.parametrize(
    ("body", "code", "pointer"),
    [
        ({}, "table_or_robot", ""),
        ({"robot": "nobody"}, "robot_unknown", "/robot"),
        ({"table": CYLINDRICAL, "parameters": LENGTHS}, "slide_without_limits", "/limits/1"),
        ({"robot": "stanford"}, "slide_without_limits", "/limits/2"),
        ({"table": PUMA_560, "limits": [None]}, "limits_wrong_length", "/limits"),
        ({"table": PUMA_560, "limits": [[1, -1], *[None] * 5]}, "limits_reversed", "/limits/0"),
        ({"table": PUMA_560, "samples": 0}, "number_too_small", "/samples"),
        ({"table": PUMA_560, "samples": 10**9}, "number_too_large", "/samples"),
        ({"table": PUMA_560, "tool": [[1]]}, "pose_wrong_shape", "/tool"),
        ({"table": TWO_LINKS, "parameters": {"L1": 1e308, "L2": 1}}, "result_not_finite", "/parameters/L1"),
        ({"robot": "twolink", "parameters": {"L2": -1e200}}, "result_not_finite", "/parameters/L2"),
        ({"robot": "twolink", "base": FAR}, "result_not_finite", "/base"),
        ({"robot": "twolink", "tool": FAR}, "result_not_finite", "/tool"),
        ({"robot": "twolink", "limits": [[1e6, 1e7], None]}, "limits_too_far", "/limits/0"),
        (
            {"table": CYLINDRICAL, "parameters": LENGTHS, "limits": [None, [-1e308, 1e308]]},
            "result_not_finite",
            "/limits/1",
        ),
        (
            {"table": {"convention": "standard", "rows": [{"alpha": 0, "a": 1, "d": 0, "theta": 0}]}},
            "workspace_without_joints",
            "/table/rows",
        ),
    ],
)
def test_what_is_refused(client: httpx.Client, body: dict[str, Any], code: str, pointer: str) -> None:
    check_problem(client.post(PATH, json=body), 422, code, pointer)
