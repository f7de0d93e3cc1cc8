"""POST /scm/products: seed 001 eq. 2.10 to 2.12, and the toolbox's HRX … HTZ, GEO, SCZIP, S2D and H2J."""

import math
from typing import Any

import httpx
import numpy as np
import pytest

from kinematics.expressions import evaluate
from tests.kinematics.printing.tree_reader import from_tree
from tests.service.asking import answered

URL = "/api/v1/scm/products"
SHIFTS = {"c": "x", "b": "y", "a": "z"}
"""Along which axis a frame shifts and about which the same axis turns."""


def asked(client: httpx.Client, **body: Any) -> Any:
    return answered(client, URL, body)


@pytest.mark.parametrize("turn", "abc")
@pytest.mark.parametrize("shift", "xyz")
def test_a_shift_and_a_turn_commute_about_one_axis_only(client: httpx.Client, turn: str, shift: str) -> None:
    """Eq. 2.10 to 2.12."""
    one, other = {shift: "L"}, {turn: "w"}
    equal = asked(client, products=[[one, other], [other, one]])["equal_to_first"]
    assert equal == ["proved", "proved" if SHIFTS[turn] == shift else "refuted"]


def test_the_orders_of_000_and_002_are_one_link(client: httpx.Client) -> None:
    """000 eq. 3.1 and 002: shifts and turns about one axis change places."""
    turned_first = [{"c": "alpha"}, {"x": "a"}, {"a": "theta1"}, {"z": "d"}]
    shifted_first = [{"x": "a"}, {"c": "alpha"}, {"z": "d"}, {"a": "theta1"}]
    assert asked(client, products=[turned_first, shifted_first])["equal_to_first"] == ["proved", "proved"]


def test_the_elementary_motions(client: httpx.Client) -> None:
    """HRX(c) … HTZ(z), eq. 2.1 to 2.3, at 30° and 2."""
    products = [[{name: name.upper()}] for name in "xyzabc"]
    values = dict.fromkeys("XYZ", 2.0) | dict.fromkeys("ABC", 30.0)
    answer = asked(client, products=products, parameters=values, angle_unit="deg")
    c, s = math.cos(math.pi / 6), 0.5
    turns = {
        "A": [[c, -s, 0], [s, c, 0], [0, 0, 1]],
        "B": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
        "C": [[1, 0, 0], [0, c, -s], [0, s, c]],
    }
    for i, product in enumerate(answer["products"]):
        expected = np.eye(4)
        if i < 3:
            expected[i, 3] = 2.0
        else:
            expected[:3, :3] = turns["ABC"[i - 3]]
        assert np.allclose(product["numbers"], expected, atol=1e-15)
        six = [0.0] * 6
        six[i] = 2.0 if i < 3 else 30.0
        assert np.allclose(product["xyzabc"], six, atol=1e-12)


def test_geo_of_two_frames_and_of_a_transform(client: httpx.Client) -> None:
    A, B = [0.1, 0, 0.3, 90, 0, 0], [0, 0.2, 0, 0, 30, 0]
    first = asked(client, products=[[A, B]], angle_unit="deg")["products"][0]
    assert np.allclose(first["xyzabc"], [-0.1, 0, 0.3, 90, 30, 0])
    again = asked(client, products=[[first["numbers"]]], angle_unit="deg")["products"][0]
    assert np.allclose(again["xyzabc"], first["xyzabc"])


OWN: list[list[Any]] = [
    ["cos(q1)", "-sin(q1)", 0, "L1*cos(q1)"],
    ["sin(q1)", "cos(q1)", 0, "L1*sin(q1)"],
    [0, 0, 1, 0],
    [0, 0, 0, 1],
]


MISTYPED = [["2*cos(q1)", *OWN[0][1:]], *OWN[1:]]
MIRRORED = [*OWN[:2], [0, 0, -1, 0], OWN[3]]
ROUNDED = [[0.707107, -0.707107, 0, 1], [0.707107, 0.707107, 0, 0], *OWN[2:]]
UNKNOWN = [["r11", "r12", 0, 0], ["r21", "r22", 0, 0], *OWN[2:]]


@pytest.mark.parametrize("matrix", [ROUNDED, UNKNOWN], ids=["rounded", "in parameters alone"])
def test_rotations_that_are_not_exact_have_jacobians(client: httpx.Client, matrix: list[list[Any]]) -> None:
    assert "J0" in asked(client, products=[[matrix, {"a": "q1"}]], jacobian=True)["products"][0]


def test_a_matrix_that_does_not_rotate_is_multiplied_all_the_same(client: httpx.Client) -> None:
    assert "J0" not in asked(client, products=[[MISTYPED]])["products"][0]


def test_sczip_s2d_and_h2j_of_a_matrix_of_ones_own(client: httpx.Client) -> None:
    motions = [{"a": "q1"}, {"x": "L1"}, {"a": "q2"}, {"x": "L2"}]
    body = {"products": [[OWN, *motions[2:]], motions]}
    answer = asked(client, **body, jacobian=True)
    assert answer["equal_to_first"] == ["proved", "proved"]
    assert answer["products"][0]["J0"]["text"][5] == ["1", "1"]
    assert answer["products"][1]["transform"]["text"][0][3] == "L1*c1 + L2*c12"
    assert answer["symbols"]["c12"] == "cos(q1 + q2)"
    assert "numbers" not in answer["products"][0]
    valued = asked(client, **body, parameters={"L1": 0.4, "L2": 0.3}, joints=[30, 45], angle_unit="deg")
    x = 0.4 * math.cos(math.radians(30)) + 0.3 * math.cos(math.radians(75))
    for product in valued["products"]:
        assert product["numbers"][0][3] == pytest.approx(x, abs=1e-12)
        assert product["xyzabc"][3] == pytest.approx(75.0)
    full = asked(client, products=[[OWN]], notation="full", formats=["text"])
    assert full["products"][0]["transform"]["text"][0][0] == "cos(q1)"
    assert "symbols" not in full


def test_the_documents_own_matrix_is_differentiated_by_the_names_that_it_has(client: httpx.Client) -> None:
    """H2J of what SCM printed, h2j(H, [a1 a2 d3]): the same Jacobian as by inspection of the chain."""
    chain = {"joints": [{"z": "L0", "a": "a1"}, {"y": "L1", "b": "a2"}, {"z": "d3"}]}
    values, joints = {"L0": 0.412, "L1": 0.154}, [30, 60, 0.5]
    printed = client.post("/api/v1/scm/forward-kinematics", json={"chain": chain, "notation": "full"}).json()
    own = printed["transform"]["text"]
    answer = asked(
        client,
        products=[[own], chain["joints"]],
        variables=["a_1", "a2", "d3"],
        parameters=values,
        joints=joints,
        angle_unit="deg",
        jacobian=True,
        formats=["json", "text"],
    )
    assert answer["variables"] == ["a1", "a2", "d3"]
    assert answer["parameters"] == []
    assert answer["equal_to_first"] == ["proved", "proved"]
    product = answer["products"][0]
    assert product["transform"]["text"][0][3] == "d3*c1*s2 - 0.154*s1"
    inspected = client.post(
        "/api/v1/scm/jacobian",
        json={"chain": {**chain, "angle_unit": "deg"}, "parameters": values, "joints": joints},
    ).json()
    angles = [math.radians(30), math.radians(60), 0.5]
    for name in ("J0", "Jn"):
        numbers = [[value_of(entry, angles) for entry in row] for row in product[name]["json"]]
        assert np.allclose(numbers, inspected[name], atol=1e-12)
    assert product["numbers"][2][3] == pytest.approx(0.412 + 0.5 * math.cos(math.radians(60)))


def test_variables_keep_their_names_whatever_else_is_called_so(client: httpx.Client) -> None:
    """A variable named like the short name of a cosine; q2 is the second one, too, whatever it is called."""
    answer = asked(
        client,
        products=[[{"a": "c1"}, {"x": "q2"}]],
        variables=["c1", "d_2"],
        jacobian=True,
        formats=["text"],
    )
    assert (answer["variables"], answer["parameters"]) == (["c1", "d2"], [])
    transform, J0 = answer["products"][0]["transform"], answer["products"][0]["J0"]
    assert transform["text"][0] == ["cos(c1)", "-s1", "0", "d2*cos(c1)"]
    assert J0["text"][:2] == [["-d2*s1", "cos(c1)"], ["d2*cos(c1)", "s1"]]
    exchanged = asked(client, products=[[{"a": "q2"}, {"a": "q1"}]], variables=["q2", "q1"], formats=["text"])
    assert exchanged["variables"] == ["q2", "q1"]


def test_the_jacobian_of_a_chain_is_that_of_its_product(client: httpx.Client) -> None:
    """H2J of the matrix, and inspection of the chain it came from: seed 001 eq. 3.22 to 3.24."""
    chain = {"joints": [{"z": "h", "a": "q1"}, {"x": "L", "b": "q2"}, {"z": "q3"}], "final": {"x": "w"}}
    rows = [*chain["joints"], chain["final"]]
    values, joints = {"h": 0.2, "L": 0.4, "w": 0.1}, [0.3, -0.7, 0.5]
    inspected = client.post(
        "/api/v1/scm/jacobian", json={"chain": chain, "parameters": values, "joints": joints, "verify": "off"}
    ).json()
    derived = asked(client, products=[rows], parameters=values, jacobian=True, formats=["json", "text"])
    product = derived["products"][0]
    for name in ("J0", "Jn"):
        numbers = [[value_of(entry, joints) for entry in row] for row in product[name]["json"]]
        assert np.allclose(numbers, inspected[name], atol=1e-12)


def value_of(tree: dict[str, Any], joints: list[float]) -> float:
    return float(evaluate(from_tree(tree), {}, joints))


@pytest.mark.parametrize(
    ("body", "code", "pointer"),
    [
        ({"products": [[{"a": "atan2(q1, 1)"}]], "jacobian": True}, "no_derivative", "/products"),
        (
            {"products": [[OWN], [{"x": 1}, MISTYPED]], "jacobian": True},
            "matrix_not_rotation",
            "/products/1/1",
        ),
        ({"products": [[MIRRORED]], "jacobian": True}, "matrix_not_rotation", "/products/0/0"),
        ({"products": [[[0, "1/0", 0, 0, 0, 0]]]}, None, "/products/0/0/1"),
        ({"products": [[{"x": "L"}, {"a": "L"}]]}, "scm_parameter_two_kinds", "/products/0/1/a"),
        ({"products": [[{"a": "q99"}]]}, "number_too_large", "/products/0/0/a"),
        ({"products": [[{"x": "1/L"}]], "parameters": {"L": 0}}, "value_undefined", "/parameters"),
        ({"products": [[{"x": "L"}]], "parameters": {"M": 0}}, None, "/parameters/M"),
        ({"products": [[{"a": "q1"}]], "joints": [1, 2]}, "joints_wrong_length", "/joints"),
        (
            {"products": [[{"a": "a1"}]], "variables": ["a1", "a_1"]},
            "variable_name_invalid",
            "/variables/1",
        ),
        (
            {"products": [[{"a": "a1"}]], "variables": ["a1 + a2"]},
            "variable_name_invalid",
            "/variables/0",
        ),
        (
            {"products": [[{"a": "a1"}]], "variables": ["a1"], "joints": [1, 2]},
            "joints_wrong_length",
            "/joints",
        ),
        ({"products": [[{"a": "q2"}]], "variables": ["a1"]}, "number_too_large", "/products/0/0/a"),
        ({"products": [[[[1, 2], [3]]]]}, "matrix_not_4x4", "/products/0/0"),
        ({"products": [[[[0] * 4] * 4]]}, "pose_bottom_row", "/products/0/0/3"),
        ({"products": [[[0] * 5]]}, "scm_six_entries", "/products/0/0"),
        ({"products": []}, None, "/products"),
        ({"products": [[]]}, None, "/products/0"),
    ],
)
def test_refusals(client: httpx.Client, body: dict[str, Any], code: str | None, pointer: str) -> None:
    response = client.post(URL, json=body)
    assert response.status_code == 422, response.text
    errors = response.json()["errors"]
    assert pointer in [error["pointer"].removeprefix("#") for error in errors], errors
    assert code is None or code in [error["code"] for error in errors]
