from __future__ import annotations

import math
from typing import Any

import httpx
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.examples import CYLINDRICAL, PUMA_560
from tests.service import oracle
from tests.service.asking import answered
from tests.service.test_bad_input import check_problem
from tests.service.test_forward_kinematics import questions

PATH = "/api/v1/convert"
FK = "/api/v1/forward-kinematics"


def pose(client: httpx.Client, table: Any, joints: list[float], **more: Any) -> np.ndarray:
    return np.array(answered(client, FK, {"table": table, "joints": joints, **more})["transform"])


@given(questions(), st.sampled_from(["standard", "modified"]))
def test_nothing_is_lost_between_conventions(client: httpx.Client, question: dict[str, Any], to: str) -> None:
    table, joints = question["table"], question["joints"]
    found = answered(client, PATH, {"table": table, "to": to})
    assert found["table"]["convention"] == to
    assert len(found["table"]["rows"]) == len(table["rows"])
    moved = pose(client, found["table"], joints, base=found["base"], tool=found["tool"])
    np.testing.assert_allclose(moved, oracle.product(oracle.links(table, joints)), atol=1e-11)


@given(questions())
def test_there_and_back_is_the_same_robot(client: httpx.Client, question: dict[str, Any]) -> None:
    table, joints = question["table"], question["joints"]
    other = {"standard": "modified", "modified": "standard"}[table["convention"]]
    there = answered(client, PATH, {"table": table, "to": other})
    back = answered(client, PATH, {"table": there["table"], "to": table["convention"]})
    middle = pose(client, back["table"], joints, base=back["base"], tool=back["tool"])
    total = np.array(there["base"]) @ middle @ np.array(there["tool"])
    np.testing.assert_allclose(total, oracle.product(oracle.links(table, joints)), atol=1e-11)


def screw_motion(screw: dict[str, Any], q: float) -> np.ndarray:
    """exp([S] q) of a joint's screw, geometrically: a turn about a line, or a shift."""
    v, w = np.array(screw["linear"]), np.array(screw["angular"])
    motion = np.eye(4)
    if not w.any():
        motion[:3, 3] = v * q
        return motion
    point = np.cross(w, v)
    k = np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])
    motion[:3, :3] = np.eye(3) + math.sin(q) * k + (1 - math.cos(q)) * k @ k
    motion[:3, 3] = point - motion[:3, :3] @ point
    return motion


@given(questions())
def test_a_product_of_exponentials_is_the_robot(client: httpx.Client, question: dict[str, Any]) -> None:
    table, joints = question["table"], question["joints"]
    found = answered(client, PATH, {"table": table, "to": "poe"})
    unit = oracle.UNIT[table["angle_unit"]]
    motions = [
        screw_motion(screw, q * (unit if screw["joint"] == "revolute" else 1))
        for screw, q in zip(found["screws"], joints, strict=True)
    ]
    total = oracle.product([*motions, np.array(found["home"])])
    np.testing.assert_allclose(total, oracle.product(oracle.links(table, joints)), atol=1e-9)


def test_entries_keep_the_spelling_of_their_author(client: httpx.Client) -> None:
    found = answered(client, PATH, {"table": CYLINDRICAL, "to": "standard"})
    assert [row["alpha"] for row in found["table"]["rows"]] == ["-90", 90, 0]
    assert [row["a"] for row in found["table"]["rows"]] == [0, "2L3", 0]
    assert [row["d"] for row in found["table"]["rows"]] == ["L1", "d2 + L2", 0]
    assert found["table"]["rows"][0]["theta"] == "θ1"
    assert (found["table"]["angle_unit"], found["table"]["length_unit"]) == ("deg", "mm")


SYMBOLIC = {
    "convention": "standard",
    "rows": [
        {"joint": "revolute", "alpha": "A1", "a": "L1", "d": "L2/3", "theta": "-q1 + pi/7"},
        {"joint": "prismatic", "alpha": "A2", "a": "sqrt(2)*L1", "d": "-q2 + L2", "theta": "A1/2"},
        {"joint": "fixed", "alpha": "1/3", "a": 0.25, "d": 0, "theta": 0},
    ],
}
VALUES = {"A1": 0.4, "A2": -1.3, "L1": 0.7, "L2": 0.2}


@pytest.mark.parametrize("angle_unit", ["rad", "deg"])
def test_what_is_left_over_is_written_with_its_parameters(client: httpx.Client, angle_unit: str) -> None:
    table = {**SYMBOLIC, "rows": SYMBOLIC["rows"][:2], "angle_unit": angle_unit}
    found = answered(client, PATH, {"table": table, "to": "modified"})
    assert found["tool"][1][1] == "cos(A2)"
    assert found["tool"][1][2] == "-sin(A2)"
    assert found["tool"][0][3] == "sqrt(2)*L1"
    row = {"joint": "fixed", "alpha": "A2", "a": "sqrt(2)*L1", "d": 0, "theta": 0}
    assert found["tool_row"] == row
    whole = {**found["table"], "rows": [*found["table"]["rows"], row]}
    joints = [0.3, 0.1]
    moved = pose(client, whole, joints, parameters=VALUES)
    np.testing.assert_allclose(moved, pose(client, table, joints, parameters=VALUES), atol=1e-12)


@pytest.mark.parametrize("angle_unit", ["rad", "deg"])
@pytest.mark.parametrize("to", ["standard", "modified"])
def test_symbols_survive_with_and_without_values(client: httpx.Client, angle_unit: str, to: str) -> None:
    table = {**SYMBOLIC, "angle_unit": angle_unit}
    joints = [0.3, 0.1]
    old = pose(client, table, joints, parameters=VALUES)
    found = answered(client, PATH, {"table": table, "to": to, "parameters": VALUES})
    moved = pose(client, found["table"], joints, parameters=VALUES, base=found["base"], tool=found["tool"])
    np.testing.assert_allclose(moved, old, atol=1e-12)
    product = answered(client, PATH, {"table": table, "to": "poe", "parameters": VALUES})
    assert [screw["joint"] for screw in product["screws"]] == ["revolute", "prismatic"]


@pytest.mark.parametrize("angle_unit", ["rad", "deg"])
@pytest.mark.parametrize(("to", "end"), [("standard", "base"), ("modified", "tool")])
def test_what_is_left_over_without_a_parameter_needs_no_values(
    client: httpx.Client, angle_unit: str, to: str, end: str
) -> None:
    convention = "modified" if to == "standard" else "standard"
    known = {"joint": "fixed", "alpha": "1/3", "a": 0.25, "d": 0, "theta": 0.5}
    rows = [known, *SYMBOLIC["rows"][:2], known]
    table = {"convention": convention, "angle_unit": angle_unit, "rows": rows}
    found = answered(client, PATH, {"table": table, "to": to})
    assert found[end][0][3] == 0.25
    ends = {"base": found["base"], "tool": found["tool"]}
    moved = pose(client, found["table"], [0.3, 0.1], parameters=VALUES, **ends)
    np.testing.assert_allclose(moved, pose(client, table, [0.3, 0.1], parameters=VALUES), atol=1e-12)


def test_a_robot_of_the_catalogue(client: httpx.Client) -> None:
    found = answered(client, PATH, {"robot": "puma560", "to": "modified"})
    joints = [10.0, -20, 30, 40, -50, 60]
    named = answered(client, FK, {"robot": "puma560", "joints": joints})["transform"]
    parameters = {"a2": 0.4318, "a3": 0.0203, "d3": 0.15005, "d4": 0.4318}
    ends = {"base": found["base"], "tool": found["tool"]}
    moved = pose(client, found["table"], joints, parameters=parameters, **ends)
    np.testing.assert_allclose(moved, named, atol=1e-12)


@pytest.mark.parametrize(
    ("body", "code", "pointer"),
    [
        ({"table": PUMA_560}, "field_missing", "/to"),
        ({"table": PUMA_560, "to": "craig"}, "value_not_allowed", "/to"),
        ({"to": "modified"}, "one_source", ""),
        ({"table": PUMA_560, "robot": "puma560", "to": "poe"}, "one_source", ""),
        ({"robot": "puma561", "to": "poe"}, "robot_unknown", "/robot"),
        ({"table": SYMBOLIC, "to": "poe"}, "parameter_missing", "/parameters/A1"),
        ({"table": PUMA_560, "to": "modified", "parameters": {"x": 1}}, "parameter_unused", "/parameters/x"),
        ({"table": {**PUMA_560, "rows": [{}]}, "to": "modified"}, "field_missing", "/table/rows/0/alpha"),
        ({"table": PUMA_560, "to": "modified", "joints": []}, "field_unknown", "/joints"),
    ],
)
def test_what_cannot_be_converted(client: httpx.Client, body: Any, code: str, pointer: str) -> None:
    check_problem(client.post(PATH, json=body), 422, code, pointer)
