from __future__ import annotations

import io
import math
from typing import Any

import httpx
import numpy as np
import pytest
from hypothesis import given

from tests.examples import PUMA_560, TWO_LINKS
from tests.service import oracle
from tests.service.test_bad_input import check_problem
from tests.service.test_forward_kinematics import questions

PATH = "/api/v1/jacobian"
STEP = 1e-6


def asked(client: httpx.Client, body: dict[str, Any], **options: Any) -> Any:
    response = client.post(PATH, json=body, **options)
    assert response.status_code == 200, response.text
    return response.json()


def differences(table: dict[str, Any], joints: list[float]) -> np.ndarray:
    """J0 by central differences of the oracle's poses, per radian."""
    unit = oracle.UNIT[table.get("angle_unit", "rad")]
    kinds = [row["joint"] for row in table["rows"] if row["joint"] != "fixed"]
    columns = []
    for i, kind in enumerate(kinds):
        size = STEP / unit if kind == "revolute" else STEP
        ahead, behind = (
            oracle.product(oracle.links(table, [q + sign * size * (j == i) for j, q in enumerate(joints)]))
            for sign in (1, -1)
        )
        here = oracle.product(oracle.links(table, joints))
        rate = (ahead - behind) / (2 * STEP)
        turning = rate[:3, :3] @ here[:3, :3].T
        columns.append([*rate[:3, 3], turning[2, 1], turning[0, 2], turning[1, 0]])
    return np.array(columns).reshape(-1, 6).T


@given(questions())
def test_jacobians_are_derivatives_of_the_pose(client: httpx.Client, question: dict[str, Any]) -> None:
    found = asked(client, question)
    expected = differences(question["table"], question["joints"])
    J0, Jn = (np.array(found[name]).reshape(6, -1) for name in ("J0", "Jn"))
    np.testing.assert_allclose(J0, expected, atol=1e-6)
    rotation = oracle.product(oracle.links(question["table"], question["joints"]))[:3, :3]
    np.testing.assert_allclose(J0, np.kron(np.eye(2), rotation) @ Jn, atol=1e-10)


def test_a_wrist_is_singular_when_it_is_stretched(client: httpx.Client) -> None:
    stretched = asked(client, {"table": PUMA_560, "joints": [0, 45, -90, 0, 0, 0]})
    bent = asked(client, {"table": PUMA_560, "joints": [0, 45, -90, 0, 30, 0]})
    assert (stretched["rank"], stretched["singular"]) == (5, True)
    assert stretched["twist"]["condition"] is None
    assert (bent["rank"], bent["singular"]) == (6, False)
    assert math.isclose(bent["manipulability"], abs(np.linalg.det(bent["J0"])), rel_tol=1e-9)


def test_a_stretched_arm_of_two_links_is_singular_in_its_translation(client: httpx.Client) -> None:
    body = {"table": TWO_LINKS, "parameters": {"L1": 0.4, "L2": 0.3}, "joints": [[0.7, 0.0], [0.7, 1.0]]}
    found = asked(client, body)
    assert found["translation"]["singular"] == [True, False]
    assert math.isclose(found["translation"]["manipulability"][1], 0.4 * 0.3 * math.sin(1.0))
    assert found["singular"] == [False, False]


def test_the_verdict_does_not_depend_on_the_unit(client: httpx.Client) -> None:
    rows = [{**row, "a": row["a"] * 1000, "d": row["d"] * 1000} for row in PUMA_560["rows"]]
    millimetres = {**PUMA_560, "length_unit": "mm", "rows": rows}
    joints = [10, 20, 30, 40, 50, 60]
    small, large = (asked(client, {"table": table, "joints": joints}) for table in (PUMA_560, millimetres))
    np.testing.assert_allclose(np.array(large["J0"])[:3], np.array(small["J0"])[:3] * 1000, atol=1e-9)
    np.testing.assert_allclose(np.array(large["J0"])[3:], np.array(small["J0"])[3:], atol=1e-12)
    assert large["rank"] == small["rank"]
    assert math.isclose(large["twist"]["condition"], small["twist"]["condition"], rel_tol=1e-9)
    assert large["length_unit"] == "mm"


def test_a_batch_is_its_configurations_large_or_small(client: httpx.Client) -> None:
    joints = np.random.default_rng(5).uniform(-180, 180, (900, 6)).tolist()
    together = asked(client, {"table": PUMA_560, "joints": joints})
    few = asked(client, {"table": PUMA_560, "joints": joints[:5]})
    for i in (0, 4):
        alone = asked(client, {"table": PUMA_560, "joints": joints[i]})
        for batch in (together, few):
            np.testing.assert_allclose(batch["J0"][i], alone["J0"], atol=1e-12)
            np.testing.assert_allclose(batch["Jn"][i], alone["Jn"], atol=1e-12)
            assert batch["rank"][i] == alone["rank"]
            assert math.isclose(batch["manipulability"][i], alone["manipulability"], rel_tol=1e-9)
            assert math.isclose(batch["twist"]["condition"][i], alone["twist"]["condition"], rel_tol=1e-6)
    assert len(together["J0"]) == len(together["singular"]) == 900


def test_one_frame_may_be_chosen_and_a_tool_moves_the_point(client: httpx.Client) -> None:
    tool = oracle.shift("z", 0.5)
    body = {"table": PUMA_560, "joints": [10, 20, 30, 40, 50, 60], "frame": "end", "tool": tool.tolist()}
    found = asked(client, body)
    assert "J0" not in found
    plain = asked(client, {"table": PUMA_560, "joints": body["joints"], "frame": "end"})
    v, w = np.array(plain["Jn"])[:3], np.array(plain["Jn"])[3:]
    moved = v + np.cross(w.T, [0, 0, 0.5]).T
    np.testing.assert_allclose(np.array(found["Jn"])[:3], moved, atol=1e-12)


def test_joints_may_come_as_an_array(client: httpx.Client) -> None:
    joints = np.array([[10.0, 20, 30, 40, 50, 60], [0, 0, 0, 0, 0, 0]])
    stream = io.BytesIO()
    np.save(stream, joints)
    response = client.post(
        PATH,
        content=stream.getvalue(),
        params={"robot": "puma560"},
        headers={"Content-Type": "application/x-npy"},
    )
    assert response.json() == asked(client, {"robot": "puma560", "joints": joints.tolist()})


def test_an_arm_without_joints_has_an_empty_jacobian(client: httpx.Client) -> None:
    table = {"convention": "standard", "rows": [{"joint": "fixed", "alpha": 0, "a": 1, "d": 0, "theta": 0}]}
    found = asked(client, {"table": table, "joints": []})
    assert found["J0"] == [[]] * 6
    assert (found["rank"], found["singular"]) == (0, False)


@pytest.mark.parametrize("form", ["short", None, ["symbolic"]])
def test_both_forms_are_named_when_another_is_asked_for(client: httpx.Client, form: object) -> None:
    body = {"robot": "puma560", "joints": [0.0] * 6, "form": form}
    response = client.post("/api/v1/jacobian", json=body)
    problem = check_problem(response, 422, "value_not_allowed", "/form")
    assert problem["errors"][0]["params"]["expected"] == "'numeric', 'symbolic'"


@pytest.mark.parametrize("media_type", ["application/x-npy", "Application/X-NPY; version=1"])
@pytest.mark.parametrize("call", ["jacobian", "forward-kinematics"])
def test_media_types_have_no_case(client: httpx.Client, call: str, media_type: str) -> None:
    stream = io.BytesIO()
    np.save(stream, np.zeros((2, 6)))
    response = client.post(
        f"/api/v1/{call}?robot=puma560",
        content=stream.getvalue(),
        headers={"Content-Type": media_type},
    )
    assert response.status_code == 200


TWO_LINKS_FORM = [
    ["-L1*s1 - L2*s12", "-L2*s12"],
    ["L1*c1 + L2*c12", "L2*c12"],
    [0, 0],
    [0, 0],
    [0, 0],
    [1, 1],
]


def check_form(client: httpx.Client, **more: Any) -> httpx.Response:
    table = {
        "convention": "standard",
        "rows": [{"theta": f"q{i}", "d": 0, "a": f"L{i}", "alpha": 0} for i in (1, 2)],
    }
    return client.post(
        "/api/v1/check-jacobian-form", json={"table": table, "parameters": {"L1": 0.5, "L2": 0.5}, **more}
    )


def test_jacobians_as_functions_are_proved(client: httpx.Client) -> None:
    answer = check_form(client, jacobian=TWO_LINKS_FORM)
    assert answer.status_code == 200, answer.text
    assert (answer.json()["correct"], answer.json()["proof"]) == (True, "proved")
    halves = [*TWO_LINKS_FORM[3:], *TWO_LINKS_FORM[:3]]
    assert check_form(client, jacobian=halves, order="angular_first").json()["correct"]
    told = check_form(client, jacobian=TWO_LINKS_FORM, frame="end").json()
    assert (told["correct"], [entry["code"] for entry in told["mistakes"]]) == (False, ["other_frame"])
    swapped = [["-L2*s1 - L1*s12", "-L2*s12"], *TWO_LINKS_FORM[1:]]
    assert check_form(client, jacobian=swapped).json()["entries"][0] == [False, True]
    rates = [*TWO_LINKS_FORM[:3], [0, 0], [0, 0], [1, 1]]
    assert check_form(client, jacobian=rates, angles={"axes": "XYZ", "turning": "fixed"}).json()["correct"]
    load = {"wrench": [0, "fy", 0, 0, 0, 0], "joint_forces": ["(L1*c1 + L2*c12)*fy", "L2*c12*fy"]}
    assert check_form(client, **load).json()["correct"]
    other = {**load, "joint_forces": ["(L1*c1 + L2*c12)*F_y", "L2*c12*F_y"]}
    assert "Did you mean fy?" in check_form(client, **other).json()["detail"]


@pytest.mark.parametrize(
    ("more", "code", "pointer"),
    [
        ({}, "jacobian_empty", ""),
        ({"jacobian": [["1/0", 0], *TWO_LINKS_FORM[1:]]}, "division_by_zero", "/jacobian/0/0"),
        ({"jacobian": [["x", 0], *TWO_LINKS_FORM[1:]]}, "name_without_value", "/jacobian/0/0"),
        ({"jacobian": [["q3", 0], *TWO_LINKS_FORM[1:]]}, "joint_variable_unknown", "/jacobian/0/0"),
        ({"jacobian": [[0], *TWO_LINKS_FORM[1:]]}, "joint_row_length", "/jacobian/0"),
        ({"jacobian": TWO_LINKS_FORM, "angles": {"axes": "ZYZ"}}, "angles_locked", "/angles"),
        ({"jacobian": TWO_LINKS_FORM, "angles": {"axes": "ZZY"}}, "euler_axes_unknown", "/angles/axes"),
        ({"joint_forces": [0, 0]}, "wrench_missing", "/wrench"),
        ({"joint_forces": [0, 0], "wrench": ["q1", 0, 0, 0, 0, 0]}, "joint_variable_in_number", "/wrench/0"),
    ],
)
def test_functions_that_cannot_be_judged_are_refused_at_their_place(
    client: httpx.Client, more: dict[str, Any], code: str, pointer: str
) -> None:
    answer = check_form(client, **more)
    assert answer.status_code == 422, answer.text
    told = answer.json()
    assert [(error["code"], error.get("pointer", "")) for error in told["errors"]] == [(code, pointer)]


@pytest.mark.parametrize(
    ("factor", "right"), [("1.001", False), ("0.99", False), ("3*0.3333", True), ("1.0", True)]
)
def test_an_entry_with_names_is_as_exact_as_its_decimals(
    client: httpx.Client, factor: str, right: bool
) -> None:
    """A tolerance for rounded numbers is no licence to write another function of the names."""
    scaled = [[f"-L1*s1 - {factor}*L2*s12", "-L2*s12"], *TWO_LINKS_FORM[1:]]
    assert check_form(client, jacobian=scaled).json()["correct"] is right
    load = {"wrench": [0, "fy", 0, 0, 0, 0], "joint_forces": ["(L1*c1 + L2*c12)*fy", f"{factor}*L2*c12*fy"]}
    assert check_form(client, **load).json()["correct"] is right


def test_lengths_as_numbers_keep_the_usual_tolerance(client: httpx.Client) -> None:
    numbers = [["-0.502*s1 - 0.5*s12", "-0.5*s12"], *TWO_LINKS_FORM[1:]]
    assert check_form(client, jacobian=numbers).json()["correct"]
    load = {"wrench": [0, "fy", 0, 0, 0, 0], "joint_forces": ["(0.5*c1 + 0.502*c12)*fy", "0.5*c12*fy"]}
    assert check_form(client, **load).json()["correct"]


def rates_of_zyz(client: httpx.Client, joints: list[float]) -> np.ndarray:
    """The Jacobian of (x, y, z, α, β, γ) by differences, R = Rot_z(α) Rot_y(β) Rot_z(γ)."""

    def coordinates(q: np.ndarray) -> np.ndarray:
        body = {"robot": "puma560", "joints": q.tolist(), "parts": ["transform"]}
        T = np.array(client.post("/api/v1/forward-kinematics", json=body).json()["transform"])
        middle = math.atan2(math.hypot(T[0, 2], T[1, 2]), T[2, 2])
        first, last = math.atan2(T[1, 2], T[0, 2]), math.atan2(T[2, 1], -T[2, 0])
        return np.array([*T[:3, 3], first, middle, last])

    step = 1e-4
    here = np.array(joints)
    columns = []
    for one in np.eye(len(joints)) * step:
        change = coordinates(here + one) - coordinates(here - one)
        change[3:] = [math.remainder(angle, math.tau) for angle in change[3:]]
        columns.append(change / (2 * math.radians(step)))
    return np.array(columns).T


def test_an_analytic_jacobian_in_numbers_is_judged(client: httpx.Client) -> None:
    joints = [30.0, -40.0, 70.0, 20.0, 50.0, -80.0]
    rates = rates_of_zyz(client, joints)
    body = {"robot": "puma560", "joints": joints, "angles": {"axes": "ZYZ"}}

    def judged(matrix: np.ndarray, **more: Any) -> Any:
        return client.post(
            "/api/v1/check-jacobian", json={**body, "jacobian": matrix.tolist(), **more}
        ).json()

    assert judged(rates)["correct"]
    assert judged(np.vstack([rates[3:], rates[:3]]), order="angular_first")["correct"]
    assert judged(rates * np.array([1, 1, 1, 1, -1, 1])[:, None])["correct"], "the other triple"
    wrong = rates.copy()
    wrong[3, 2] += 0.02
    assert not judged(wrong)["correct"]
    geometric = np.array(asked(client, {"robot": "puma560", "joints": joints})["J0"])
    found = judged(geometric)
    assert (found["correct"], found["mistakes"][0]["code"]) == (False, "geometric")
    locked = judged(rates, joints=[0.0] * 6)
    assert (locked["code"], locked["pointer"]) == ("angles_locked", "/joints")
    assert judged(rates, angles={"axes": "ZZY"})["pointer"] == "/angles/axes"
