"""POST /convert from every form to every form: the same poses, with base, tool, names and limits."""

import math
from typing import Any

import httpx
import numpy as np
import pytest

from kinematics import catalogue
from tests.conftest import EXPLORE
from tests.examples import CYLINDRICAL, PUMA_560
from tests.service.asking import answered
from tests.service.test_bad_input import check_problem

CONVERT = "/api/v1/convert"
FK = "/api/v1/forward-kinematics"
FORMS = ("standard", "modified", "poe", "scm", "urdf")
BASE = [[0, -1, 0, 0.1], [1, 0, 0, 0.2], [0, 0, 1, 0.3], [0, 0, 0, 1]]
TOOL = [[1, 0, 0, 0.05], [0, 0, -1, 0], [0, 1, 0, 0.1], [0, 0, 0, 1]]


def source(form: str, answer: dict[str, Any]) -> dict[str, Any]:
    """The request's fields that say what an answer says."""
    match form:
        case "standard" | "modified":
            return {"table": answer["table"], "base": answer["base"], "tool": answer["tool"]}
        case "poe":
            given = {name: answer[name] for name in ("screws", "home", "length_unit")}
            return {"poe": given}
        case "scm":
            return {"scm": answer["scm"], "base": answer["base"], "verify": answer["verify"]}
    return {"urdf": answer["urdf"]}


def poses(client: httpx.Client, described: dict[str, Any]) -> tuple[Any, Any]:
    """Poses in [m] at fixed joint values in [rad] and [m], and the table that they were computed by."""
    found = answered(client, CONVERT, {**described, "to": "standard"})
    table = found["table"]
    angle = math.degrees(1.0) if table["angle_unit"] == "deg" else 1.0
    metres = {"m": 1.0, "mm": 0.001, "cm": 0.01, "in": 0.0254}[table["length_unit"]]
    joints = [row for row in table["rows"] if row["joint"] != "fixed"]
    values = [0.3 + 0.2 * i for i in range(len(joints))]
    units = [angle if row["joint"] == "revolute" else 1 / metres for row in joints]
    body = {
        "table": table, "base": found["base"], "tool": found["tool"],
        "joints": [value * unit for value, unit in zip(values, units, strict=True)],
        "parameters": {k: v for k, v in described.get("parameters", {}).items() if k in str(table)},
    }  # fmt: skip
    pose = np.array(answered(client, FK, body)["transform"])
    pose[:3, 3] *= metres
    return pose, table


ROBOTS_AND_FORMS = [
    (robot, FORMS[(number + step) % len(FORMS)])
    for number, robot in enumerate(catalogue.robot_ids())
    for step in range(len(FORMS) if EXPLORE else 2)
]
"""Every robot by two forms, every form by nine robots."""


@pytest.mark.parametrize(("robot", "through"), ROBOTS_AND_FORMS)
def test_every_form_describes_the_same_robot(client: httpx.Client, robot: str, through: str) -> None:
    listed = catalogue.robot(robot)
    values = dict(listed.parameters)
    raw = {"robot": robot, "parameters": values}
    expected, _ = poses(client, raw)
    middle = answered(client, CONVERT, {**raw, "to": through})
    again = source(through, middle)
    if through in ("standard", "modified", "scm"):
        again["parameters"] = {name: value for name, value in values.items() if name in str(again)}
    found, _ = poses(client, again)
    size = max(1.0, float(np.abs(expected[:3, 3]).max()))
    np.testing.assert_allclose(found, expected, atol=1e-9 * size)


@pytest.mark.parametrize("last", FORMS)
@pytest.mark.parametrize("first", FORMS)
def test_every_form_to_every_form_with_base_and_tool(client: httpx.Client, first: str, last: str) -> None:
    start = {"table": PUMA_560, "base": BASE, "tool": TOOL}
    expected, _ = poses(client, start)
    one = answered(client, CONVERT, {**start, "to": first})
    two = answered(client, CONVERT, {**source(first, one), "to": last})
    found, _ = poses(client, source(last, two))
    np.testing.assert_allclose(found, expected, atol=1e-9)


@pytest.mark.parametrize("convention", ["standard", "modified"])
@pytest.mark.parametrize("rounding", ["8.940316365525654e-18", "-8.940316365525654e-18"])
@pytest.mark.parametrize("twist", ["pi/2", "pi/2 + 0.1234567890123456", "L1 + 0.1234567890123456"])
def test_what_rounding_left_in_a_chain_can_be_sent_back(
    client: httpx.Client, twist: str, rounding: str, convention: str
) -> None:
    """The exact sum of two doubles has more digits than a cell may hold."""
    entry, values = ("x", {"L1": 0.2}) if "L1" in twist else ("c", {})
    chain = {"joints": [{"a": "q1", entry: twist}], "final": {entry: rounding}}
    sent = {"scm": chain, "verify": "off"}
    found = answered(client, CONVERT, {**sent, "to": convention})
    sent, back = {**sent, "parameters": values}, {**source(convention, found), "parameters": values}
    np.testing.assert_allclose(poses(client, back)[0], poses(client, sent)[0], atol=1e-15)


def test_a_table_with_symbols_becomes_a_chain_with_symbols(client: httpx.Client) -> None:
    found = answered(client, CONVERT, {"table": CYLINDRICAL, "to": "scm"})
    assert found["verify"] == "off"  # its slide stands in a row that turns
    text = str(found["scm"])
    assert all(name in text for name in ("L1", "q1", "q2"))


def test_names_and_limits_come_back_with_a_table(client: httpx.Client) -> None:
    names, limits = ["waist", *"abcde"], [[-160, 160], None, [None, 90], [-1, 1], [-1, 1], [-1, 1]]
    sent = {"table": {**PUMA_560, "angle_unit": "deg"}, "joint_names": names, "limits": limits}
    written = answered(client, CONVERT, {**sent, "to": "urdf"})
    back = answered(client, CONVERT, {"urdf": written["urdf"], "to": "standard", "angle_unit": "deg"})
    assert back["joint_names"] == names
    assert back["limits"] == limits
    kept = answered(client, CONVERT, {**sent, "to": "modified"})
    assert (kept["joint_names"], kept["limits"]) == (names, limits)
    known = answered(client, CONVERT, {"robot": "scara", "to": "modified"})
    assert known["limits"] == [list(pair) for pair in catalogue.robot("scara").limits or ()]


@pytest.mark.parametrize("angle_unit", ["deg", "rad"])
@pytest.mark.parametrize("convention", ["standard", "modified"])
@pytest.mark.parametrize("robot", ["gen3", "scara-scm", "puma560"])
def test_a_table_alone_is_the_robot_with_base_and_tool(
    client: httpx.Client, robot: str, convention: str, angle_unit: str
) -> None:
    """A description's base and tool are general poses: they are fixed rows before and after the table's."""
    placed = {"robot": robot, "base": [0.1, -0.2, 0.3, 1, 2, 3], "tool": [0.05, 0, 0.1, -2, 1, 0.5]}
    text = answered(client, CONVERT, {**placed, "to": "urdf"})["urdf"]
    found = answered(client, CONVERT, {"urdf": text, "to": convention, "angle_unit": angle_unit})
    rows = [*found["base_rows"], *found["table"]["rows"], *found["tool_rows"]]
    expected, _ = poses(client, {"urdf": text})
    again, _ = poses(client, {"table": {**found["table"], "rows": rows}})
    np.testing.assert_allclose(again, expected, atol=1e-9)


def test_rows_of_a_tool_with_names(client: httpx.Client) -> None:
    table = {"convention": "standard", "rows": [{"alpha": 0.3, "a": "L1", "d": 0, "theta": "q1"}]}
    found = answered(client, CONVERT, {"table": table, "to": "modified"})
    assert found["base_rows"] == []
    assert found["tool_rows"] == [found["tool_row"]]
    moved = answered(client, CONVERT, {"table": table, "tool": [0, 0, 0.1, 0, 0.5, 0], "to": "modified"})
    assert moved["tool_rows"] is None


@pytest.mark.parametrize("last", FORMS)
@pytest.mark.parametrize("first", FORMS)
def test_names_and_limits_pass_through_every_form(client: httpx.Client, first: str, last: str) -> None:
    """Whatever a robot is written as in between, its joints keep their names and limits."""
    rows = [
        {"alpha": 90, "a": 0, "d": 0.3, "theta": "q1"},
        {"alpha": -90, "a": 0, "d": "q2 + 0.2", "theta": 0},
        {"alpha": 0, "a": 0.1, "d": 0, "theta": "q3"},
    ]
    table = {"convention": "standard", "angle_unit": "deg", "rows": rows}
    joints = {"joint_names": ["waist", "boom", "hand"], "limits": [[-150, 60], [0, 0.5], None]}
    one = answered(client, CONVERT, {"table": table, **joints, "to": first})
    sent = {**source(first, one), **{name: one[name] for name in joints if first != "urdf"}}
    if first in ("poe", "urdf"):
        sent["angle_unit"] = "deg"
    two = answered(client, CONVERT, {**sent, "to": last})
    if last == "urdf":
        two = answered(client, CONVERT, {"urdf": two["urdf"], "to": "standard", "angle_unit": "deg"})
    assert {name: two[name] for name in joints} == joints


def test_degrees_of_a_description_are_exact(client: httpx.Client) -> None:
    rows = [
        {"alpha": 12.5, "a": 0.1, "d": 0.2, "theta": "q1 + 33"},
        {"alpha": 0, "a": 0.3, "d": 0, "theta": "q2"},
    ]
    table = {"convention": "modified", "angle_unit": "deg", "rows": rows}
    written = answered(client, CONVERT, {"table": table, "to": "urdf"})
    back = answered(client, CONVERT, {"urdf": written["urdf"], "to": "modified", "angle_unit": "deg"})
    assert [row["alpha"] for row in back["table"]["rows"]][1] in (0, 12.5)
    for row in back["table"]["rows"]:
        for cell in (row["alpha"], row["theta"]):
            assert "99999" not in str(cell)
            assert "00000" not in str(cell)


@pytest.mark.parametrize(
    ("turn", "offset"),
    [
        (-13.899509698159651, "76.100490301840349"),  # 90 more has seventeen digits
        (1e-300, 90.0),  # 90 more has three hundred
        ("1/7", "631/7"),
        ("123456789012345/987654321012347", 90.12499999887187),  # 90 more has a numerator beyond 1e15
    ],
)
def test_sums_of_offsets_are_cells_that_are_read_back(
    client: httpx.Client, turn: float | str, offset: float | str
) -> None:
    """Two turns about one axis add up; no sum may become a number that a cell refuses."""
    chain = {"joints": [{"a": "q1 + 90"}, {"z": "q2", "a": turn}, {"c": "q3"}], "angle_unit": "deg"}
    found = answered(client, CONVERT, {"scm": chain, "verify": "off", "to": "modified"})
    assert offset in {cell for row in found["table"]["rows"] for cell in row.values()}
    answered(client, CONVERT, {**source("modified", found), "to": "poe"})


@pytest.mark.parametrize(
    ("body", "code", "pointer"),
    [
        (
            {"poe": {"screws": [{"linear": [0, 0, 0], "angular": [0, 0, 2]}], "home": BASE}},
            "screw_not_unit",
            "/poe/screws/0",
        ),
        (
            {"poe": {"screws": [{"linear": [0, 0, 1], "angular": [0, 0, 1]}], "home": BASE}},
            "screw_has_pitch",
            "/poe/screws/0",
        ),
        (
            {
                "poe": {
                    "screws": [{"joint": "revolute", "linear": [0, 0, 1], "angular": [0, 0, 0]}],
                    "home": BASE,
                }
            },
            "screw_of_other_type",
            "/poe/screws/0",
        ),
        (
            {
                "poe": {
                    "screws": [{"linear": [0, 0, 0], "angular": [0, 0, 1]}],
                    "home": [[2, 0, 0, 0], *BASE[1:]],
                }
            },
            "pose_not_orthonormal",
            "/poe/home",
        ),
        ({"table": PUMA_560, "base": [[2, 0, 0, 0], *BASE[1:]]}, "pose_not_orthonormal", "/base"),
        ({"table": PUMA_560, "joint_names": ["a"]}, "urdf_joint_names", "/joint_names"),
        ({"table": PUMA_560, "link_names": [*"abcdee"]}, "urdf_link_names", "/link_names"),
        ({"table": PUMA_560, "link_names": [*"abcde", "\n"]}, "urdf_name_invalid", "/link_names/5"),
        ({"table": PUMA_560, "limits": [None]}, "limits_wrong_length", "/limits"),
        ({"table": PUMA_560, "angle_unit": "deg"}, "option_idle", "/angle_unit"),
        ({"urdf": "<robot/>", "base": BASE}, "option_idle", "/base"),
        ({"table": PUMA_560, "verify": "off"}, "option_idle", "/verify"),
        ({"table": PUMA_560, "name": "rob"}, "option_idle", "/name"),
    ],
)
def test_what_is_refused(client: httpx.Client, body: dict[str, Any], code: str, pointer: str) -> None:
    check_problem(client.post(CONVERT, json={**body, "to": "standard"}), 422, code, pointer)


SYMBOLS = {
    "standard": [
        {"alpha": 0.5, "a": "L1", "d": "L0", "theta": "q1"},
        {"alpha": 0, "a": "L2", "d": "q2", "theta": 0.4},
    ],
    "modified": [
        {"alpha": 0.5, "a": "L1", "d": "L0", "theta": "q1"},
        {"alpha": 0, "a": "L2", "d": "q2", "theta": 0.4},
    ],
}


@pytest.mark.parametrize("last", ["standard", "modified", "scm"])
@pytest.mark.parametrize("first", ["standard", "modified"])
def test_base_and_tool_stay_where_lengths_have_no_values(client: httpx.Client, first: str, last: str) -> None:
    start = {"table": {"convention": first, "rows": SYMBOLS[first]}, "base": BASE, "tool": TOOL}
    values = {"L0": 0.3, "L1": 0.5, "L2": -0.2}
    expected, _ = poses(client, {**start, "parameters": values})
    found = source(last, answered(client, CONVERT, {**start, "to": last}))
    assert "L2" in str(found)
    for name in ("base", "tool"):
        if name in found:
            known = [[numeric(cell, values) for cell in row] for row in found[name]]
            found[name] = known
    kept = {name: value for name, value in values.items() if name in str(found)}
    again, _ = poses(client, {**found, "parameters": kept})
    np.testing.assert_allclose(again, expected, atol=1e-12)


def numeric(cell: float | str, values: dict[str, float]) -> float:
    """A number, or what a sum of products of numbers and names is."""
    if not isinstance(cell, str):
        return cell
    total = 0.0
    for term in cell.replace(" - ", " + -").split(" + "):
        value = -1.0 if term.startswith("-") else 1.0
        for factor in term.removeprefix("-").split("*"):
            name, _, divisor = factor.partition("/")
            value *= (values[name] if name in values else float(name)) / float(divisor or 1)
        total += value
    return total


@pytest.mark.parametrize("tilt", [1e-9, 7e-4, 3.3e-3])
@pytest.mark.parametrize("last", FORMS)
def test_nearly_parallel_screws_are_kept(client: httpx.Client, last: str, tilt: float) -> None:
    """A calibrated arm: the tilt stands in a fixed row, as Hayati's β does, and lengths stay the robot's."""
    axis = [math.sin(tilt), 0.0, math.cos(tilt)]
    tilted = {"angular": axis, "linear": np.cross([0.5, 0.2, 0.1], axis).tolist()}
    given = {
        "screws": [{"angular": [0, 0, 1], "linear": [0, 0, 0]}, tilted],
        "home": [0.9, 0.2, 0.3, 0, 0, 0],
    }
    found = answered(client, CONVERT, {"poe": given, "to": last})
    q = (0.3, 0.5)
    motion = np.eye(4)
    for screw, angle in zip(given["screws"], q, strict=True):
        w = np.array(screw["angular"])
        K = np.cross(w, np.eye(3)).T
        turn = np.eye(4)
        turn[:3, :3] = np.eye(3) + math.sin(angle) * K + (1 - math.cos(angle)) * K @ K
        point = np.cross(w, screw["linear"])
        turn[:3, 3] = point - turn[:3, :3] @ point
        motion = motion @ turn
    expected = motion @ [0.9, 0.2, 0.3, 1.0]
    pose, table = poses(client, source(last, found))
    np.testing.assert_allclose(pose[:3, 3], expected[:3], atol=2e-10)
    assert all(abs(row[name]) < 2.0 for row in table["rows"] for name in ("a", "d"))


TWISTED: dict[str, Any] = {
    "convention": "standard", "angle_unit": "deg", "length_unit": "mm",
    "rows": [
        {"joint": "revolute", "alpha": "beta", "a": "L1", "d": "L2", "theta": "q1"},
        {"joint": "prismatic", "alpha": -90, "a": "2*L1", "d": "q2", "theta": "gamma"},
        {"joint": "revolute", "alpha": "beta", "a": "L2", "d": 0, "theta": "90 - q3"},
    ],
}  # fmt: skip
VALUES = {"L1": 120, "L2": 80, "beta": 25, "gamma": -70}


def _sent(answer: dict[str, Any]) -> dict[str, Any]:
    """An answer, sent back as it came, with values of the names in it."""
    fields = {name: answer[name] for name in ("table", "scm", "base", "tool", "verify") if name in answer}
    return {**fields, "parameters": {name: value for name, value in VALUES.items() if name in str(fields)}}


@pytest.mark.parametrize("through", ["standard", "modified", "scm"])
@pytest.mark.parametrize("placed", [{}, {"base": BASE, "tool": TOOL}])
@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_base_and_tool_come_back_with_the_names_in_them(
    client: httpx.Client, convention: str, placed: dict[str, Any], through: str
) -> None:
    start = {"table": {**TWISTED, "convention": convention}, **placed}
    if through == "scm" and placed:
        start.pop("tool")  # a second tool has no place among the entries
    first = answered(client, CONVERT, {**start, "to": through})
    ends = str((first["base"], first.get("tool")))
    assert through in (convention, "scm") or any(name in ends for name in VALUES)
    again = _sent(first)
    del again["parameters"]
    second = answered(client, CONVERT, {**again, "to": convention})
    expected, _ = poses(client, {**start, "parameters": VALUES})
    for answer in (first, second):
        found, _ = poses(client, _sent(answer))
        np.testing.assert_allclose(found, expected, atol=1e-12)


@pytest.mark.parametrize(("one", "other"), [("standard", "modified"), ("modified", "standard")])
def test_a_table_with_names_comes_back_as_it_was(client: httpx.Client, one: str, other: str) -> None:
    table = {**TWISTED, "convention": one}
    there = answered(client, CONVERT, {"table": table, "to": other})
    ends = {name: there[name] for name in ("table", "base", "tool")}
    back = answered(client, CONVERT, {**ends, "to": one})
    assert back["table"] == table
    assert back["base"] == back["tool"] == np.eye(4).tolist()


@pytest.mark.parametrize(
    ("place", "cell", "code", "pointer"),
    [
        ((0, 3), "L1 +", "cell_incomplete", "/tool/0/3"),
        ((2, 3), "q1", "scm_variable_outside_joints", "/tool/2/3"),
        ((1, 3), "beta", "scm_parameter_two_kinds", "/tool"),
        ((1, 1), "cos(beta)", "pose_not_orthonormal", "/tool"),
        ((3, 0), "L1", "pose_bottom_row", "/tool/3"),
        ((0, 0), None, "cell_not_a_value", "/tool/0/0"),
    ],
)
def test_what_no_tool_with_names_is(
    client: httpx.Client, place: tuple[int, int], cell: Any, code: str, pointer: str
) -> None:
    tool: list[list[Any]] = [[1, 0, 0, "L1"], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    tool[place[0]][place[1]] = cell
    response = client.post(CONVERT, json={"table": TWISTED, "tool": tool, "to": "modified"})
    assert (response.status_code, response.json()["code"]) == (422, code)
    assert response.json()["pointer"].startswith(pointer)


def test_a_name_in_a_tool_needs_a_value_where_numbers_are_computed(client: httpx.Client) -> None:
    tool = [[1, 0, 0, "L9"], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    asked = {"table": PUMA_560, "tool": tool, "to": "poe"}
    response = client.post(CONVERT, json=asked)
    assert (response.json()["code"], response.json()["pointer"]) == ("parameter_missing", "/parameters/L9")
    found = answered(client, CONVERT, {**asked, "parameters": {"L9": 0.25}})
    expected = answered(client, CONVERT, {**asked, "tool": [0.25, 0, 0, 0, 0, 0]})
    assert found == expected


def test_a_root_in_a_tool_exists_at_the_values_that_are_given(client: httpx.Client) -> None:
    tool = [[1, 0, 0, "sqrt(L1 - L2)"], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    asked = {"table": PUMA_560, "tool": tool, "to": "modified"}
    assert answered(client, CONVERT, asked)["tool"][0][3] == "sqrt(L1 - L2)"
    found = answered(client, CONVERT, {**asked, "parameters": {"L1": 5, "L2": 1}})
    assert found["tool"][0][3] == 2.0
    response = client.post(CONVERT, json={**asked, "parameters": {"L1": 1, "L2": 5}})
    assert (response.json()["code"], response.json()["pointer"]) == ("value_undefined", "/tool/0/3")


def test_a_slide_of_a_product_may_hold_what_a_program_leaves_of_zero(client: httpx.Client) -> None:
    screw = {"joint": "prismatic", "linear": [0, 0, 1], "angular": [6.1e-17, 0, 0]}
    product = {"screws": [screw], "home": [0, 0, 0, 0, 0, 0]}
    found = answered(client, CONVERT, {"poe": product, "to": "standard"})
    assert [row["joint"] for row in found["table"]["rows"]] == ["prismatic"]
