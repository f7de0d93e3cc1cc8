"""URDF over HTTP: tables written, chains read."""

import re
from typing import Any

import httpx
import numpy as np
import pytest

from kinematics import catalogue
from tests.examples import CYLINDRICAL, PUMA_560, TURNING_ARM
from tests.kinematics.urdf.foreign import foreign_poses
from tests.service.asking import answered
from tests.service.test_bad_input import check_problem

PATH = "/api/v1/convert"
FK = "/api/v1/forward-kinematics"
BOMB = '<!DOCTYPE r [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]><robot name="&b;"><link name="x"/></robot>'

SLIDE: dict[str, Any] = {
    "convention": "modified",
    "length_unit": "mm",
    "rows": [{"alpha": 0, "a": 0, "d": "q1", "theta": 0}],
}
FAR: dict[str, Any] = {**SLIDE, "rows": [*SLIDE["rows"], {"alpha": 0, "a": 1e13, "d": 0, "theta": "q2"}]}

FAR_END = {"convention": "standard", "rows": [{"alpha": 0, "a": 1e13, "d": 0, "theta": "q1"}]}


@pytest.mark.parametrize("robot_id", catalogue.robot_ids())
@pytest.mark.parametrize("to", ["standard", "modified"])
def test_there_and_back(client: httpx.Client, robot_id: str, to: str) -> None:
    written = answered(client, PATH, {"robot": robot_id, "to": "urdf"})
    assert (written["length_unit"], written["angle_unit"]) == ("m", "rad")
    back = answered(client, PATH, {"urdf": written["urdf"], "to": to})
    n = len(back["joint_names"])
    joints = np.random.default_rng(2).uniform(-2, 2, (3, n))
    body = {"table": back["table"], "joints": joints.tolist(), "base": back["base"], "tool": back["tool"]}
    poses = np.array(answered(client, FK, body)["transform"])
    foreign = foreign_poses(written["urdf"], joints, written["base_link"], written["tip_link"])
    size = max(1.0, float(np.abs(foreign[:, :3, 3]).max()))
    np.testing.assert_allclose(poses, foreign, atol=1e-12 * size, rtol=0)


def test_right_angles_stay_exact(client: httpx.Client) -> None:
    written = answered(client, PATH, {"table": PUMA_560, "to": "urdf", "name": "my puma"})
    assert '<robot name="my puma">' in written["urdf"]
    back = answered(client, PATH, {"urdf": written["urdf"], "to": "standard"})
    assert [row["alpha"] for row in back["table"]["rows"]] == ["pi/2", 0, "-pi/2", "pi/2", "-pi/2", 0]
    assert [row["a"] for row in back["table"]["rows"]] == [0, 0.4318, 0.0203, 0, 0, 0]
    assert back["base"] == np.eye(4).tolist()
    assert back["tool"] == np.eye(4).tolist()


def test_limits(client: httpx.Client) -> None:
    body = {"table": CYLINDRICAL, "parameters": {"L1": 400, "L2": 120, "L3": 75}, "to": "urdf"}
    assert answered(client, PATH, body)["assumed_limits"] == [2]
    found = answered(client, PATH, {**body, "limits": [[-90, 90], [0, 250]]})
    assert found["assumed_limits"] == []
    assert 'lower="0" upper="0.25"' in found["urdf"]
    back = answered(client, PATH, {"urdf": found["urdf"], "to": "modified"})
    assert back["limits"][0] == pytest.approx([-np.pi / 2, np.pi / 2])
    known = answered(client, PATH, {"robot": "scara", "to": "urdf"})
    assert known["assumed_limits"] == []
    assert 'type="revolute"' in known["urdf"]


@pytest.mark.parametrize("to", ["poe", "urdf", "standard", "modified"])
def test_a_chain_to_every_form(client: httpx.Client, to: str) -> None:
    body = {"urdf": TURNING_ARM, "base_link": "floor", "tip_link": "hand", "to": to}
    found = answered(client, PATH, body)
    if to == "urdf":
        assert '<robot name="turning_arm">' in found["urdf"]
    elif to == "poe":
        assert [screw["joint"] for screw in found["screws"]] == ["revolute", "revolute"]
        assert found["home"][0][3] == pytest.approx(0.6)
    else:
        assert found["joint_names"] == ["turn", "lift"]
        assert found["limits"] == [None, [-1.5, 1.5]]


@pytest.mark.parametrize(
    ("body", "code", "pointer"),
    [
        ({"urdf": BOMB, "to": "standard"}, "urdf_unsafe", "/urdf"),
        ({"urdf": "<robot", "to": "standard"}, "urdf_not_xml", "/urdf"),
        ({"urdf": TURNING_ARM, "to": "standard"}, "urdf_tip_needed", "/urdf"),
        ({"urdf": TURNING_ARM, "to": "standard", "tip_link": "foot"}, "urdf_link_unknown", "/urdf"),
        ({"urdf": TURNING_ARM, "table": PUMA_560, "to": "standard"}, "one_source", ""),
        ({"table": PUMA_560, "to": "standard", "tip_link": "hand"}, "option_idle", "/tip_link"),
        ({"table": PUMA_560, "to": "poe", "limits": []}, "limits_wrong_length", "/limits"),
        ({"table": PUMA_560, "to": "urdf", "limits": [None]}, "limits_wrong_length", "/limits"),
        ({"table": PUMA_560, "to": "urdf", "name": "\n"}, "urdf_name_invalid", "/name"),
        ({"table": CYLINDRICAL, "to": "urdf"}, "parameter_missing", "/parameters/L1"),
        (
            {"robot": "twolink", "parameters": {"L1": 1e10}, "to": "urdf"},
            "urdf_length_overflow",
            "/parameters/L1",
        ),
        ({"table": FAR, "to": "urdf"}, "urdf_length_overflow", "/table/rows/1"),
        ({"table": FAR_END, "to": "urdf"}, "urdf_length_overflow", "/table/rows/0"),
        ({"table": SLIDE, "to": "urdf", "limits": [[0, 1e13]]}, "urdf_limit_overflow", "/limits/0"),
        (
            {"robot": "twolink", "to": "urdf", "limits": [None, [-1e16, 90]]},
            "urdf_limit_overflow",
            "/limits/1",
        ),
        ({"table": SLIDE, "to": "urdf", "limits": [[0, 1e300]]}, "result_not_finite", "/limits/0"),
        (
            {"robot": "twolink", "parameters": {"L1": 1e308}, "to": "poe"},
            "result_not_finite",
            "/parameters/L1",
        ),
    ],
)
def test_what_is_refused(client: httpx.Client, body: dict[str, Any], code: str, pointer: str) -> None:
    check_problem(client.post(PATH, json=body), 422, code, pointer)


def test_names_survive_the_way_through_a_table(client: httpx.Client) -> None:
    chain = {"urdf": TURNING_ARM, "base_link": "floor", "tip_link": "hand"}
    table = answered(client, PATH, {**chain, "to": "modified"})
    named = {key: table[key] for key in ("name", "base_link", "tip_link", "joint_names", "link_names")}
    assert named == {
        "name": "turning_arm",
        "base_link": "floor",
        "tip_link": "hand",
        "joint_names": ["turn", "lift"],
        "link_names": ["post", "arm"],
    }
    robot = {key: table[key] for key in ("table", "base", "tool", "limits")}
    written = answered(client, PATH, {**robot, **named, "to": "urdf"})
    assert (written["base_link"], written["tip_link"]) == ("floor", "hand")
    again = answered(client, PATH, {"urdf": written["urdf"], "to": "modified"})
    assert {key: again[key] for key in named} == named
    assert answered(client, PATH, {**chain, "to": "urdf"})["tip_link"] == "hand"


def test_links_between_the_ends_get_other_names(client: httpx.Client) -> None:
    body = {"table": PUMA_560, "to": "urdf", "base_link": "link_2", "tip_link": "link_2_"}
    links = re.findall('<link name="([^"]+)"', answered(client, PATH, body)["urdf"])
    assert links == ["link_2", "link_1", "link_2__", "link_3", "link_4", "link_5", "link_6", "link_2_"]
    check_problem(
        client.post(PATH, json={**body, "tip_link": "link_2"}), 422, "urdf_links_alike", "/tip_link"
    )
