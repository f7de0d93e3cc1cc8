"""POST /dynamics: numbers, closed forms, units, refusals."""

import math
from typing import Any

import httpx
import numpy as np
import pytest

from tests.service.asking import answered
from tests.service.test_bad_input import check_problem

PATH = "/api/v1/dynamics"


def bar(i: int) -> dict[str, Any]:
    inertia = [[0, 0, 0], [0, 0, 0], [0, 0, f"I{i}"]]
    return {"mass": f"m{i}", "centre": [f"r{i} - L{i}", 0, 0], "inertia": inertia}


def table(unit: str = "m", angle: str = "rad") -> dict[str, Any]:
    rows = [{"theta": f"q{i}", "d": 0, "a": f"L{i}", "alpha": 0} for i in (1, 2)]
    return {"convention": "standard", "length_unit": unit, "angle_unit": angle, "rows": rows}


VALUES = {"L1": 0.4, "L2": 0.3, "r1": 0.2, "r2": 0.15, "m1": 2, "m2": 1, "I1": 0.03, "I2": 0.01}
ARM: dict[str, Any] = {
    "table": table(),
    "parameters": VALUES,
    "links": [bar(1), bar(2)],
    "gravity": [0, -9.81, 0],
    "joints": [0.3, 0.6],
}


def test_two_links_by_hand(client: httpx.Client) -> None:
    """h1 = −m2 L1 r2 sin q2 (2 q̇1 q̇2 + q̇2²), g2 = m2 r2 g cos(q1 + q2)."""
    found = answered(client, PATH, {**ARM, "rates": [1, -2], "accelerations": [0.5, 0.25]})
    coupling = 0.0225 + 0.01 + 0.4 * 0.15 * math.cos(0.6)
    assert found["M"][0][1] == found["M"][1][0] == pytest.approx(coupling)
    h1 = -0.4 * 0.15 * math.sin(0.6) * (2 * -2 + 4)
    assert found["h"][0] == pytest.approx(h1, abs=1e-12)
    assert found["g"][1] == pytest.approx(0.15 * 9.81 * math.cos(0.9))
    M, C = np.array(found["M"]), np.array(found["C"])
    torque = M @ [0.5, 0.25] + C @ [1, -2] + found["g"]
    np.testing.assert_allclose(found["torque"], torque, atol=1e-12)
    np.testing.assert_allclose(C @ [1, -2], found["h"], atol=1e-12)
    back = answered(client, PATH, {**ARM, "rates": [1, -2], "torque": found["torque"]})
    np.testing.assert_allclose(back["accelerations"], [0.5, 0.25], atol=1e-10)


def test_units_of_the_table_change_nothing_that_comes_back(client: httpx.Client) -> None:
    metres = answered(client, PATH, {**ARM, "rates": [1, -2]})
    lengths = {name: VALUES[name] * 1000 for name in ("L1", "L2", "r1", "r2")}
    other = {
        **ARM,
        "table": table("mm", "deg"),
        "parameters": {**VALUES, **lengths},
        "joints": [math.degrees(0.3), math.degrees(0.6)],
        "rates": [math.degrees(1), math.degrees(-2)],
    }
    found = answered(client, PATH, other)
    for name in ("M", "C", "h", "g", "kinetic_energy", "potential_energy"):
        np.testing.assert_allclose(found[name], metres[name], atol=1e-12)
    assert found["length_unit"] == "mm"


def test_a_slider_in_millimetres(client: httpx.Client) -> None:
    """A weight of 2 kg on a vertical slider: M = 2 kg, g = 19.62 N, at 500 mm 9.81 J."""
    body = {
        "table": {
            "convention": "modified",
            "length_unit": "mm",
            "rows": [{"joint": "prismatic", "alpha": 0, "a": 0, "d": "q1", "theta": 0}],
        },
        "links": [{"mass": 2}],
        "joints": [500],
        "rates": [1000],
        "accelerations": [1000],
    }
    found = answered(client, PATH, body)
    assert found["M"] == [[2.0]]
    assert found["g"] == [pytest.approx(19.62)]
    assert found["torque"] == [pytest.approx(21.62)]
    assert found["kinetic_energy"] == pytest.approx(1.0)
    assert found["potential_energy"] == pytest.approx(9.81)


def test_closed_forms(client: httpx.Client) -> None:
    body = {name: value for name, value in ARM.items() if name not in ("joints", "parameters")}
    body |= {"form": "symbolic", "gravity": [0, "-g", 0], "notation": "short", "parts": ["M", "C", "h", "g"]}
    found = answered(client, PATH, body)
    assert found["M"]["text"][0][1] == "m2*r2^2 + I2 + m2*L1*r2*c2"
    assert found["C"]["text"] == [
        ["-m2*L1*r2*dq2*s2", "-m2*L1*r2*dq1*s2 - m2*L1*r2*dq2*s2"],
        ["m2*L1*r2*dq1*s2", "0"],
    ]
    assert found["h"]["text"][1] == ["m2*L1*r2*dq1^2*s2"]
    assert found["g"]["text"][1] == ["m2*r2*g*c12"]
    assert r"\dot{q}_{1}" in found["C"]["latex"]
    assert found["rates"] == ["dq1", "dq2"]
    assert set(found["parameters"]) == {"L1", "L2", "r1", "m1", "I1", "r2", "m2", "I2", "g"}


def test_closed_forms_as_functions_give_the_numbers(client: httpx.Client) -> None:
    body = {**ARM, "form": "symbolic", "parameters": {}, "formats": ["python"], "parts": ["M", "C", "g"]}
    del body["joints"]
    found = answered(client, PATH, body)
    numbers = answered(client, PATH, {**ARM, "rates": [1, -2]})
    values = [VALUES[name] for name in found["parameters"]]
    for part, name in (("M", "mass_matrix"), ("C", "coriolis_matrix"), ("g", "gravity_torque")):
        space: dict[str, Any] = {}
        exec(found[part]["python"], space)
        computed = np.array(space[name](ARM["joints"], *values, 1, -2))
        expected = np.array(numbers[part])
        np.testing.assert_allclose(computed.reshape(expected.shape), expected, atol=1e-12)


def test_values_are_put_in_exactly_and_lengths_in_metres(client: httpx.Client) -> None:
    body = {**ARM, "form": "symbolic", "table": table("mm"), "formats": ["text"], "parts": ["g"]}
    body["parameters"] = {"m1": 2, "m2": 1, "r1": 200, "L1": 400, "r2": 150}
    del body["joints"]
    assert answered(client, PATH, body)["g"]["text"][1] == ["1.4715*cos(q1 + q2)"]


def test_the_puma_of_the_catalogue_in_closed_form(client: httpx.Client) -> None:
    found = answered(
        client, PATH, {"form": "symbolic", "robot": "puma560", "formats": ["text"], "notation": "short"}
    )
    assert found["parameters"] == ["a2", "a3", "d3", "d4"]
    assert found["M"]["text"][5][5] == "0.00004"
    assert found["g"]["text"][0] == ["0"]


@pytest.mark.parametrize(
    "form",
    [
        {"form": "symbolic", "formats": ["text"]},
        {"form": "symbolic", "formats": ["entries"]},
        {"form": "symbolic", "formats": ["python", "c"]},
        {"joints": []},
        {"joints": [], "torque": []},
        {"joints": [1]},
    ],
)
def test_what_does_not_move_has_no_equations_of_motion(client: httpx.Client, form: dict[str, Any]) -> None:
    still = {"convention": "standard", "rows": [{"joint": "fixed", "alpha": 0, "a": 1, "d": 0, "theta": 0}]}
    body = {**form, "table": still, "links": [{"mass": 1}]}
    check_problem(client.post(PATH, json=body), 422, "dynamics_without_joints", "/table/rows")


def test_columns_are_numbered_by_their_rows_alone(client: httpx.Client) -> None:
    body = {**ARM, "form": "symbolic", "formats": ["entries"], "parts": ["M", "g"]}
    del body["joints"], body["parameters"]
    found = answered(client, PATH, body)
    assert [line["name"] for line in found["g"]["entries"]][-2:] == ["g1", "g2"]
    assert [line["name"] for line in found["M"]["entries"]][-4:] == ["M11", "M12", "M21", "M22"]


WEIGHTLESS = {"links": [{}, {}], "torque": [1, 1], "parameters": {"L1": 1, "L2": 1}}


@pytest.mark.parametrize(
    ("change", "code", "pointer"),
    [
        ({"links": None}, "links_missing", "/links"),
        ({"links": [bar(1)]}, "links_count", "/links"),
        ({"links": [{**bar(1), "mass": "-m1"}, bar(2)]}, "mass_negative", "/links/0/mass"),
        ({"links": [{**bar(1), "mass": "q1"}, bar(2)]}, "body_varies", "/links/0/mass"),
        (
            {"links": [bar(1), {**bar(2), "inertia": [1, 1, 1, 0, 0, 0]}]},
            "inertia_in_one_row",
            "/links/1/inertia",
        ),
        (
            {"links": [bar(1), {**bar(2), "inertia": [[0, "I2", 0], [0, 1, 0], [0, 0, 1]]}]},
            "inertia_not_symmetric",
            "/links/1/inertia",
        ),
        (
            {"links": [bar(1), {**bar(2), "inertia": [["-I2", 0, 0], [0, 1, 0], [0, 0, 1]]}]},
            "inertia_negative",
            "/links/1/inertia",
        ),
        ({"joints": [0]}, "joints_wrong_length", "/joints"),
        ({"rates": [0]}, "joints_wrong_length", "/rates"),
        ({"accelerations": [0, 0, 0]}, "joints_wrong_length", "/accelerations"),
        ({"torque": [1]}, "joints_wrong_length", "/torque"),
        ({"parameters": {**VALUES, "m3": 1}}, "parameter_unused", "/parameters/m3"),
        ({"parameters": {"L1": 1}}, "parameter_missing", "/parameters/L2"),
        (WEIGHTLESS, "mass_matrix_singular", "/links"),
        ({"gravity": [0, "sin(", 0]}, "cell_incomplete", "/gravity/1"),
        ({"parameters": {**VALUES, "m2": 1e308}}, "dynamics_not_finite", "/links"),
    ],
)  # fmt: skip
def test_refusals(client: httpx.Client, change: dict[str, Any], code: str, pointer: str) -> None:
    response = client.post(PATH, json={**ARM, **change}, timeout=120)
    problem = check_problem(response, 422, code)
    assert problem["pointer"] == pointer


def test_closed_forms_take_no_joints(client: httpx.Client) -> None:
    response = client.post(PATH, json={**ARM, "form": "symbolic"}, timeout=120)
    assert check_problem(response, 422, "field_unknown")["pointer"] == "/joints"


def test_a_name_of_a_rate_is_no_parameter(client: httpx.Client) -> None:
    body = {**ARM, "form": "symbolic", "parameters": {}, "links": [{"mass": "dq1"}, {}]}
    del body["joints"]
    check_problem(client.post(PATH, json=body, timeout=120), 422, "name_of_rate")


CHECK = "/api/v1/check-dynamics"
H = "m2*L1*r2*s2"
ASKED: dict[str, Any] = {
    "table": table(),
    "links": [bar(1), bar(2)],
    "parameters": {**VALUES, "g": 9.81},
    "gravity": [0, "-g", 0],
}


def test_equations_are_checked_by_what_they_mean(client: httpx.Client) -> None:
    body = {**ASKED, "C": [[f"-2*{H}*dq2", f"-{H}*dq2"], [f"{H}*dq1", 0]], "h": None}
    found = client.post(CHECK, json=body, timeout=120).json()
    assert (found["correct"], found["proof"], found["skew"]) == (True, "proved", False)
    assert found["M"] is found["g"] is None
    wrong = {**ASKED, "g": ["-(m1*r1 + m2*L1)*g*c1 - m2*r2*g*c12", "-m2*r2*g*c12"]}
    response = client.post(CHECK, json=wrong, headers={"accept-language": "fr"}, timeout=120)
    found = response.json()
    assert found["g"] == [False, False]
    assert found["mistakes"][0]["code"] == "gravity_sign"
    assert "signe opposé" in found["mistakes"][0]["message"]


def test_velocity_terms_beside_a_matrix_are_judged_too(client: httpx.Client) -> None:
    right = {"C": [[f"-2*{H}*dq2", f"-{H}*dq2"], [f"{H}*dq1", 0]]}
    h = [f"-{H}*(2*dq1*dq2 + dq2^2)", f"{H}*dq1^2"]
    for given, rows in ((h, [True, True]), ([h[0], f"-{h[1]}"], [True, False]), ([0, 0], [False, False])):
        found = client.post(CHECK, json={**ASKED, **right, "h": given}, timeout=120).json()
        assert (found["h"], found["correct"]) == (rows, all(rows))


@pytest.mark.parametrize(
    ("change", "code", "pointer"),
    [
        ({}, "motion_empty", ""),
        ({"M": [[1, 0]]}, "motion_row_count", "/M"),
        ({"M": [[1, 0], [1]]}, "joint_row_length", "/M/1"),
        ({"g": [1]}, "joint_row_length", "/g"),
        ({"h": ["dq3", 0]}, "name_without_value", "/h/0"),
        ({"h": ["sin(", 0]}, "cell_incomplete", "/h/0"),
        ({"g": [0, 0], "parameters": {}}, "parameter_missing", "/parameters/L1"),
        ({"g": [0, 0], "links": None}, "links_missing", "/links"),
    ],
)
def test_equations_that_cannot_be_read(
    client: httpx.Client, change: dict[str, Any], code: str, pointer: str
) -> None:
    response = client.post(CHECK, json={**ASKED, **change}, timeout=120)
    assert check_problem(response, 422, code)["pointer"] == pointer


@pytest.mark.parametrize(("typed", "meant"), [("dq1/dt", "dq1"), ("dθ2", "dq2"), ("q1'", "dq1")])
def test_a_rate_in_marks_of_calculus_is_told_by_its_name(
    client: httpx.Client, typed: str, meant: str
) -> None:
    response = client.post(CHECK, json={**ASKED, "h": [f"m2*L1*{typed}", 0]}, timeout=120)
    problem = check_problem(response, 422, "rate_in_marks")
    assert problem["pointer"] == "/h/0"
    assert problem["detail"] == f"{typed} is not a known name. Did you mean the joint rate {meant}?"


def test_a_student_writes_some_of_the_equations(client: httpx.Client) -> None:
    """In the exercise link i's frame lies at its near end: r and L mean what the figure shows."""
    answer = {
        "mass": [
            ["m1*r1^2 + m2*(L1^2 + r2^2 + 2*L1*r2*c2) + I1 + I2", "m2*r2*(r2 + L1*c2) + I2"],
            ["m2*r2*(r2 + L1*c2) + I2", "I2 + m2*r2^2"],
        ],
        "coriolis": [[f"-2*{H}*dq2", f"-{H}*dq2"], [f"{H}*dq1", 0]],
    }
    body = {"equations_of_motion": answer, "seed": "ada"}
    found = client.post("/api/v1/exercises/twolink-dynamics/grade", json=body, timeout=120).json()
    part = found["parts"]["equations_of_motion"]
    assert part["points"] == 50
    assert [entry["code"] for entry in part["feedback"]] == ["motion_skew_wrong", "motion_missing"]


@pytest.mark.parametrize(
    ("factor", "right"), [("1.005", False), ("1.01", False), ("3*0.333", True), ("1.0", True)]
)
def test_an_entry_with_names_is_as_exact_as_its_decimals(
    client: httpx.Client, factor: str, right: bool
) -> None:
    body = {**ASKED, "g": [f"(m1*r1 + m2*L1)*g*c1 + {factor}*m2*r2*g*c12", "m2*r2*g*c12"]}
    found = client.post(CHECK, json=body, timeout=120).json()
    assert found["g"] == [right, True]
    body = {**ASKED, "C": [[f"-2*{H}*dq2", f"-{factor}*{H}*dq2"], [f"{H}*dq1", 0]]}
    assert client.post(CHECK, json=body, timeout=120).json()["h"] == [right, True]


def test_an_entry_as_long_as_may_be_is_read_whatever_its_decimals(client: httpx.Client) -> None:
    """A decimal that is moved by half a unit has more digits, with which the cell would be too long."""
    entry = "(m1*r1 + m2*L1)*g*c1 + 3*0.333*m2*r2*g*c12"
    entry = entry.replace(" + 3", " " * (2000 - len(entry)) + " + 3")
    assert len(entry) == 2000
    response = client.post(CHECK, json={**ASKED, "g": [entry, "m2*r2*g*c12"]}, timeout=120)
    assert (response.status_code, response.json()["g"]) == (200, [True, True])
