"""The SCM calls over HTTP: numbers, closed forms, units, refusals."""

import math
from typing import Any

import httpx
import numpy as np
import pytest

API = "/api/v1/scm"
PLANAR: dict[str, Any] = {"joints": [{"a": "q1"}, {"x": "L1", "a": "q2"}], "final": {"x": "L2"}}
LENGTHS = {"L1": 1.0, "L2": 0.5}


def ask(client: httpx.Client, call: str, **question: Any) -> Any:
    answer = client.post(f"{API}/{call}", json=question)
    assert answer.status_code == 200, answer.text
    return answer.json()


def refusal(client: httpx.Client, call: str, **question: Any) -> list[tuple[str, str]]:
    answer = client.post(f"{API}/{call}", json=question)
    assert answer.status_code == 422, answer.text
    assert answer.headers["content-type"] == "application/problem+json"
    return [(fault["code"], fault["pointer"]) for fault in answer.json()["errors"]]


def test_forward_kinematics_in_numbers(client: httpx.Client) -> None:
    found = ask(client, "forward-kinematics", chain=PLANAR, parameters=LENGTHS, joints=[0.3, 0.4])
    expected = [math.cos(0.3) + 0.5 * math.cos(0.7), math.sin(0.3) + 0.5 * math.sin(0.7), 0]
    np.testing.assert_allclose(np.array(found["transform"])[:3, 3], expected, atol=1e-15)
    assert np.shape(found["links"]) == np.shape(found["frames"]) == (2, 4, 4)
    assert (found["angle_unit"], found["length_unit"]) == ("rad", "m")
    np.testing.assert_allclose(found["orientation"]["xyzabc"], [*expected, 0.7, 0, 0], atol=1e-15)


def test_units_govern_the_whole_exchange(client: httpx.Client) -> None:
    chain = {**PLANAR, "angle_unit": "deg", "length_unit": "mm"}
    found = ask(
        client, "forward-kinematics", chain=chain, parameters={"L1": 1000, "L2": 500}, joints=[30, 60]
    )
    assert (found["angle_unit"], found["length_unit"]) == ("deg", "mm")
    np.testing.assert_allclose(found["orientation"]["rpy"], [0, 0, 90], atol=1e-12)
    np.testing.assert_allclose(
        found["orientation"]["xyzabc"][:2], [1000 * math.cos(math.pi / 6), 1000], atol=1e-9
    )
    back = ask(
        client,
        "inverse-kinematics",
        chain=chain,
        parameters={"L1": 1000, "L2": 500},
        target=found["orientation"]["xyzabc"],
    )
    assert back["status"] == "solved"
    np.testing.assert_allclose(back["solutions"][0]["joints"], [30, 60], atol=1e-9)


def test_a_row_may_be_a_list_as_the_document_prints_it(client: httpx.Client) -> None:
    chain = {"joints": [[0, 0, 0, "a1", 0, 0], ["L1", 0, 0, "a2", 0, 0]], "final": ["L2", 0, 0, 0, 0, 0]}
    listed = ask(client, "forward-kinematics", chain=chain, parameters=LENGTHS, joints=[0.3, 0.4])
    named = ask(client, "forward-kinematics", chain=PLANAR, parameters=LENGTHS, joints=[0.3, 0.4])
    assert listed == named


def test_forward_kinematics_in_closed_form(client: httpx.Client) -> None:
    found = ask(client, "forward-kinematics", chain=PLANAR, formats=["text", "python"])
    assert found["variables"] == ["q1", "q2"]
    assert found["transform"]["text"][0] == ["c12", "-s12", "0", "L1*c1 + L2*c12"]
    assert found["symbols"]["c12"] == "cos(q1 + q2)"
    assert len(found["links"]) == 2
    assert "def " in found["transform"]["python"]
    full = ask(client, "forward-kinematics", chain=PLANAR, formats=["text"], notation="full")
    assert full["transform"]["text"][0][0] == "cos(q1 + q2)"
    assert "latex" in ask(client, "forward-kinematics", chain=PLANAR)["transform"]


def test_inverse_transform(client: httpx.Client) -> None:
    there = ask(client, "forward-kinematics", robot="uw", joints=[10, 20, 30])["transform"]
    back = ask(client, "inverse-transform", robot="uw", joints=[10, 20, 30])["transform"]
    np.testing.assert_allclose(np.array(back) @ np.array(there), np.eye(4), atol=1e-15)
    closed = ask(client, "inverse-transform", chain=PLANAR, formats=["text"])
    assert closed["transform"]["text"][0][3] == "-L1*c2 - L2"


def test_both_methods_give_the_same_jacobians(client: httpx.Client) -> None:
    question = {"robot": "stanford", "joints": [30, 60, 0.5, 10, 45, 90]}
    inspected = ask(client, "jacobian", **question)
    derived = ask(client, "jacobian", **question, method="differentiation")
    for frame in ("J0", "Jn"):
        assert np.shape(inspected[frame]) == (6, 6)
        np.testing.assert_allclose(inspected[frame], derived[frame], atol=1e-12)
    assert inspected["joint_unit"] == "rad"
    closed = ask(client, "jacobian", chain=PLANAR, formats=["text"])
    assert closed["J0"]["text"][0] == ["-L1*s1 - L2*s12", "-L2*s12"]
    assert "J0" in ask(client, "jacobian", chain=PLANAR, formats=["text"], method="differentiation")


def test_the_unit_vectors_of_the_document(client: httpx.Client) -> None:
    """Eq. 3.21 of document 001, and -a2 of its UW arm; joint values do not change them."""
    stanford = {"robot": "stanford", "joints": [30, 60, 0.5, 10, 45, 90]}
    z, y = [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]
    for method in ("inspection", "differentiation"):
        assert ask(client, "jacobian", **stanford, method=method)["unit_vectors"] == [z, y, z, z, y, z]
    assert ask(client, "jacobian", robot="uw", joints=[0, 10, 20])["unit_vectors"] == [
        z,
        [0, -1, 0],
        [0, -1, 0],
    ]
    assert "unit_vectors" not in ask(client, "jacobian", chain=PLANAR)


def test_inverse_kinematics(client: httpx.Client) -> None:
    joints = [20, 40, -30, 10, 50, -60]
    target = ask(client, "forward-kinematics", robot="puma560", joints=joints)["transform"]
    found = ask(client, "inverse-kinematics", robot="puma560", target=target, start=joints)
    assert (found["status"], found["complete"], len(found["solutions"])) == ("solved", True, 8)
    np.testing.assert_allclose(found["solutions"][0]["joints"], joints, atol=1e-7)
    for solution in found["solutions"]:
        reached = ask(client, "forward-kinematics", robot="puma560", joints=solution["joints"])["transform"]
        np.testing.assert_allclose(reached, target, atol=1e-8)
    limited = ask(
        client,
        "inverse-kinematics",
        robot="puma560",
        target=target,
        limits=[[0, 90], None, None, None, None, [None, 0]],
    )
    assert 0 < len(limited["solutions"]) < 8
    assert all(0 <= solution["joints"][0] <= 90 for solution in limited["solutions"])


def test_out_of_reach_is_a_result(client: httpx.Client) -> None:
    found = ask(client, "inverse-kinematics", chain=PLANAR, parameters=LENGTHS, target=[9, 0, 0, 0, 0, 0])
    assert (found["status"], found["solutions"]) == ("unreachable", [])
    np.testing.assert_allclose(np.array(found["nearest"]["transform"])[:2, 3], [1.5, 0], atol=1e-5)


def test_random_configurations(client: httpx.Client) -> None:
    question = {"robot": "stanford", "count": 5, "seed": 3}
    found = ask(client, "random-configuration", **question)
    assert found == ask(client, "random-configuration", **question)
    assert np.shape(found["configurations"]) == (5, 6)
    assert found["joints"] == found["configurations"][0]
    low, high = np.array(found["limits"]).T
    assert ((low <= found["configurations"]) & (np.array(found["configurations"]) <= high)).all()
    assert found["limits"][0] == [-180.0, 180.0]
    ask(client, "forward-kinematics", robot="stanford", joints=found["joints"])


NOT_STRICT = {"joints": [{"a": "q1 + pi/2"}, {"x": "L1", "y": "d2", "b": "pi"}]}


def test_verify_data_refuses_with_every_reason(client: httpx.Client) -> None:
    assert refusal(client, "forward-kinematics", chain=NOT_STRICT, parameters={"L1": 1}, joints=[0, 0]) == [
        ("scm_revolute_offset", "/chain/joints/0/a"),
        ("scm_prismatic_second_length", "/chain/joints/1/x"),
        ("scm_prismatic_turns", "/chain/joints/1/b"),
    ]


def test_joint_variables_keep_the_names_typed(client: httpx.Client) -> None:
    rows: list[dict[str, Any]] = [{"z": "L0", "a": "a1"}, {"y": "L1", "b": "a2"}, {"z": "d3"}]
    asking = {"chain": {"joints": rows}, "formats": ["text"], "notation": "full", "verify": "off"}
    answer = ask(client, "forward-kinematics", **asking)
    assert answer["variables"] == ["a1", "a2", "d3"]
    assert answer["transform"]["text"][0][3] == "d3*cos(a1)*sin(a2) - L1*sin(a1)"
    assert "d3*" in str(ask(client, "jacobian", **asking)["J0"]["text"])
    rows[0]["x"] = "d3"
    assert ask(client, "forward-kinematics", **asking)["variables"] == ["a1", "a2", "q3"]


def test_verify_data_may_be_switched_off(client: httpx.Client) -> None:
    question = {"chain": NOT_STRICT, "verify": "off"}
    found = ask(client, "forward-kinematics", **question, parameters={"L1": 1}, joints=[0, 0])
    np.testing.assert_allclose(np.array(found["transform"])[:3, 3], [0, 1, 0], atol=1e-15)
    assert ask(client, "forward-kinematics", **question)["variables"] == ["q1", "d2"]


@pytest.mark.parametrize(
    ("call", "question", "expected"),
    [
        ("forward-kinematics", {"joints": [0]}, ("chain_or_robot", "")),
        ("forward-kinematics", {"robot": "uw", "chain": PLANAR}, ("chain_or_robot", "")),
        ("forward-kinematics", {"robot": "nobody", "joints": [0]}, ("robot_unknown", "/robot")),
        ("forward-kinematics", {"robot": "uw", "joints": [0, 0]}, ("joints_wrong_length", "/joints")),
        ("forward-kinematics", {"robot": "uw", "joints": [0, 0, True]}, ("number_expected", "/joints/2")),
        ("forward-kinematics", {"robot": "uw", "parameters": {"L9": 1}, "joints": [0, 0, 0]},
         ("parameter_unused", "/parameters/L9")),
        ("forward-kinematics", {"chain": PLANAR, "joints": [0, 0]}, ("parameter_missing", "/parameters/L1")),
        ("forward-kinematics", {"chain": {"joints": []}}, ("list_too_short", "/chain/joints")),
        ("forward-kinematics", {"chain": {"joints": [{"a": "q1+"}]}},
         ("cell_incomplete", "/chain/joints/0/a")),
        ("forward-kinematics", {"chain": {"joints": [{"a": "q1", "w": 1}]}},
         ("field_unknown", "/chain/joints/0/w")),
        ("forward-kinematics", {"chain": {"joints": [{}]}}, ("scm_no_variable", "/chain/joints/0")),
        ("forward-kinematics", {"chain": {"joints": [{"a": "q1", "x": None}]}},
         ("cell_not_a_value", "/chain/joints/0/x")),
        ("inverse-kinematics", {"robot": "uw", "target": [1, 2]}, ("list_too_short", "/target")),
        ("inverse-kinematics", {"robot": "uw", "target": [0] * 6, "limits": [None]},
         ("limits_wrong_length", "/limits")),
        ("inverse-kinematics", {"robot": "uw", "target": [0] * 6, "start": [0]},
         ("joints_wrong_length", "/start")),
        ("inverse-kinematics", {"robot": "uw", "target": [[0] * 4] * 4}, ("pose_bottom_row", "/target/3")),
        ("random-configuration", {"robot": "uw", "count": 0}, ("number_too_small", "/count")),
        ("random-configuration", {"robot": "uw", "limits": [[1, 0], [0, 1], [0, 1]]},
         ("scm_limits_reversed", "/limits/0")),
        ("random-configuration", {"robot": "uw", "limits": [[0, 1]]}, ("limits_wrong_length", "/limits")),
        ("jacobian", {"robot": "uw", "method": "guessing"}, ("value_not_allowed", "/method")),
    ],
)  # fmt: skip
def test_refusals(
    client: httpx.Client, call: str, question: dict[str, Any], expected: tuple[str, str]
) -> None:
    assert expected in refusal(client, call, **question)


def test_an_overflow_is_refused(client: httpx.Client) -> None:
    chain = {"joints": [{"x": "L1", "a": "q1"}, {"x": "L1", "a": "q2"}]}
    found = refusal(client, "forward-kinematics", chain=chain, parameters={"L1": 1e308}, joints=[0, 0])
    assert found == [("result_not_finite", "/joints")]


@pytest.mark.parametrize("to", ["modified", "standard"])
def test_scm2dh_and_dhconv_over_http(client: httpx.Client, to: str) -> None:
    """A chain to a DH table of either convention: base · table · tool is the chain."""
    robot = client.get("/api/v1/robots/kr100p").json()
    chain, lengths = robot["scm"]["chain"], robot["scm"]["parameters"]
    answer = client.post("/api/v1/convert", json={"scm": chain, "to": to, "parameters": lengths})
    assert answer.status_code == 200, answer.text
    found = answer.json()
    joints = [10, 20, -30, 40, 50, -60]
    question = {
        "table": found["table"],
        "base": found["base"],
        "tool": found["tool"],
        "parameters": lengths,
        "joints": joints,
    }
    by_table = client.post("/api/v1/forward-kinematics", json=question).json()["transform"]
    by_chain = ask(client, "forward-kinematics", chain=chain, parameters=lengths, joints=joints)["transform"]
    np.testing.assert_allclose(by_table, by_chain, atol=1e-12)


def test_scm2dh_keeps_symbols_and_says_where_a_chain_is_wrong(client: httpx.Client) -> None:
    answer = client.post("/api/v1/convert", json={"scm": PLANAR, "to": "modified"}).json()
    assert [row["a"] for row in answer["table"]["rows"]] == [0, "L1", "L2"]
    refused = client.post("/api/v1/convert", json={"scm": NOT_STRICT, "to": "modified"}).json()
    assert [fault["pointer"] for fault in refused["errors"]] == [
        "/scm/joints/0/a",
        "/scm/joints/1/x",
        "/scm/joints/1/b",
    ]


def test_right_angles_are_exact(client: httpx.Client) -> None:
    chain = {"joints": [{"a": "q1"}], "final": {"z": 1, "a": "pi", "b": "pi/2", "c": "-pi/2"}}
    found = ask(client, "forward-kinematics", chain=chain, joints=[math.pi / 2])
    assert found["transform"] == [[0, 0, 1, 0], [0, 1, 0, 0], [-1, 0, 0, 1], [0, 0, 0, 1]]
    for method in ("inspection", "differentiation"):
        J = ask(client, "jacobian", chain=PLANAR, parameters=LENGTHS, joints=[0, math.pi / 2], method=method)
        assert J["J0"][:2] == [[-0.5, -0.5], [1, 0]]


def test_values_of_parameters_enter_the_closed_form(client: httpx.Client) -> None:
    found = ask(client, "forward-kinematics", chain=PLANAR, parameters={"L_1": 0.25})
    assert found["transform"]["text"][0][3] == "c1/4 + L2*c12"
    degrees = {"joints": [{"a": "q1"}], "final": {"a": "beta"}, "angle_unit": "deg"}
    turned = ask(client, "forward-kinematics", chain=degrees, parameters={"beta": 90})
    assert turned["transform"]["text"][0][:2] == ["-s1", "-c1"]
    assert refusal(client, "jacobian", chain=PLANAR, parameters={"L9": 1}) == [
        ("parameter_unused", "/parameters/L9")
    ]


@pytest.mark.parametrize("joints", [None, [0]])
def test_an_entry_without_a_value_is_pointed_at(client: httpx.Client, joints: list[float] | None) -> None:
    chain = {"joints": [{"x": "1/L1", "a": "q1"}], "tool": {"x": "sqrt(L1 - 1)"}}
    question = {"chain": chain, "parameters": {"L1": 0}, "verify": "off", "joints": joints}
    assert refusal(client, "forward-kinematics", **question) == [
        ("value_undefined", "/chain/joints/0/x"),
        ("value_undefined", "/chain/tool/x"),
    ]


@pytest.mark.parametrize("row", [[0, 0, 0, "q1", 0], 7, None, "q1"])
def test_a_row_has_six_entries(client: httpx.Client, row: Any) -> None:
    assert refusal(client, "forward-kinematics", chain={"joints": [row]}, joints=[0]) == [
        ("scm_six_entries", "/chain/joints/0")
    ]


def test_inverse_kinematics_points_at_what_was_sent(client: httpx.Client) -> None:
    pose = [0, 0, 0, 0, 0, 0]
    long = {"chain": PLANAR, "parameters": {"L1": 1e200, "L2": 1}, "target": pose}
    assert refusal(client, "inverse-kinematics", **long) == [("result_not_finite", "/parameters/L1")]
    many = {"chain": {"joints": [{"x": 1, "a": f"q{i}"} for i in range(1, 14)]}, "target": pose}
    assert refusal(client, "inverse-kinematics", **many) == [("inverse_joint_count", "/chain/joints")]


def test_joint_values_too_large_to_be_computed_with_are_pointed_at(client: httpx.Client) -> None:
    question = {
        "chain": {"joints": [{"a": "q1"}, {"z": "q2"}, {"x": "q3"}, {"x": "q4"}]},
        "joints": [0.5, 0, 1e308, 1e308],
    }
    assert refusal(client, "jacobian", **question) == [
        ("result_not_finite", "/joints/2"),
        ("result_not_finite", "/joints/3"),
    ]


def test_an_arm_that_is_searched(client: httpx.Client) -> None:
    rows = [{"z": 0.3, "a": f"q{i}"} if i % 2 else {"x": 0.4, "b": f"q{i}"} for i in range(1, 8)]
    target = ask(client, "forward-kinematics", chain={"joints": rows}, joints=[0.1 * i for i in range(7)])
    found = ask(client, "inverse-kinematics", chain={"joints": rows}, target=target["transform"])
    assert found["status"] == "solved"
    assert found["solutions"][0]["residual"] <= 1e-8


def test_limits_of_some_joints(client: httpx.Client) -> None:
    found = ask(client, "random-configuration", robot="twolink", limits=[None, [10, 20]], seed=3)
    assert found["limits"] == [[-180, 180], [10, 20]]
    assert refusal(client, "random-configuration", robot="twolink", limits=[]) == [
        ("limits_wrong_length", "/limits")
    ]


def test_entries_of_a_listed_row_are_pointed_at_by_number(client: httpx.Client) -> None:
    rows = [[0, 0, "1/0", "q1", 0, 0], {"x": "1/0", "a": "q2"}, [0, 0, 0, 0, "q3", "q3"]]
    chain = {"joints": rows, "final": [0, "q1", 0, 0, 0, 0], "tool": {"z": []}}
    expected = [
        ("division_by_zero", "/joints/0/2"),
        ("division_by_zero", "/joints/1/x"),
        ("scm_two_variables", "/joints/2/5"),
        ("scm_variable_outside_joints", "/final/1"),
        ("cell_not_a_value", "/tool/z"),
    ]
    found = refusal(client, "forward-kinematics", chain=chain, joints=[0, 0, 0])
    assert found == [(code, f"/chain{pointer}") for code, pointer in expected]
    converted = client.post("/api/v1/convert", json={"scm": chain, "to": "modified"}).json()
    assert [fault["pointer"] for fault in converted["errors"]] == [f"/scm{at}" for _, at in expected]


def test_a_wrist_in_line_is_a_family_as_of_a_table(client: httpx.Client) -> None:
    joints = [30.0, -40.0, 70.0, 20.0, 0.0, -80.0]
    pose = ask(client, "forward-kinematics", robot="puma560", joints=joints)["transform"]
    answer = ask(client, "inverse-kinematics", robot="puma560", target=pose)
    assert answer["status"] == "singular"
    assert answer["method"] == "closed_form"
    (family,) = [s["family"] for s in answer["solutions"] if s["isolation"] == "continuum"]
    assert family["dimension"] == 1
    assert [round(way) for way in family["direction"]] == [0, 0, 0, 1, 0, -1]


def test_limits_that_leave_no_solution_are_the_reason(client: httpx.Client) -> None:
    limits = [[-1, 1], [-1, 1]]
    answer = ask(client, "inverse-kinematics", robot="twolink", target=[1, 1, 0, 90, 0, 0], limits=limits)
    assert answer["status"] == "unreachable"
    assert answer["reason"] == "joint_limits"
    assert answer["outside_limits"] > 0
