"""POST /inverse-kinematics with "form": "symbolic" over HTTP."""

import itertools
import math
from typing import Any

import httpx
import numpy as np
import pytest

from service.schemas.kinematics.inverse_forms import SymbolicInverseRequest
from service.settings import Settings
from service.wire.kinematics.inverse_forms import inverse_form_task
from tests.service.asking import answered

URL = "/api/v1/inverse-kinematics"


def asked(client: httpx.Client, **body: Any) -> Any:
    return answered(client, URL, {"form": "symbolic", **body})


def test_scara_as_books_print_it(client: httpx.Client) -> None:
    answer = asked(client, robot="scara", notation="short", formats=["text", "latex", "json"])
    names = [equation["name"] for equation in answer["equations"]]
    assert {"q1", "q2", "q3", "q4"} <= set(names)
    assert answer["branches"] == ["sigma1"]
    assert answer["target"]["reach"] == "pose"
    (branching,) = [one for one in answer["equations"] if "branch" in one]
    assert branching["joint"] == 2
    assert branching["latex"].startswith(r"q_{2}=\operatorname{atan2}")
    assert branching["json"]["type"] == "call"
    assert {condition["kind"] for condition in branching["conditions"]} == {"reachable", "determined"}
    assert answer["symbols"]["c2"] == "cos(q2)"
    assert "code" not in answer


def test_code_with_base_and_tool_reaches_the_target(client: httpx.Client) -> None:
    base = [[0, -1, 0, 0.1], [1, 0, 0, -0.2], [0, 0, 1, 0.3], [0, 0, 0, 1]]
    tool = [[1, 0, 0, 0], [0, 0, -1, 0.05], [0, 1, 0, 0.12], [0, 0, 0, 1]]
    forward = client.post(
        "/api/v1/forward-kinematics",
        json={"robot": "puma560", "joints": [20, -40, 70, 30, 50, -80], "base": base, "tool": tool},
    ).json()
    target = np.array(forward["transform"])
    answer = asked(client, robot="puma560", base=base, tool=tool, formats=["python"])
    space: dict[str, Any] = {}
    exec(answer["code"]["python"], space)
    parameters = client.get("/api/v1/robots/puma560").json()["parameters"]
    entries = {
        n: target[i, j] for i, row in enumerate(answer["target"]["rotation"]) for j, n in enumerate(row)
    }
    entries |= dict(zip(answer["target"]["position"], target[:3, 3], strict=True))
    known = entries | parameters
    solutions = set()
    for signs in itertools.product((1.0, -1.0), repeat=len(answer["branches"])):
        values = known | dict(zip(answer["branches"], signs, strict=True))
        q = space["inverse_kinematics"](*(values[name] for name in answer["arguments"]))
        solutions.add(tuple(round(math.remainder(x, math.tau), 9) for x in q))
        reached = client.post(
            "/api/v1/forward-kinematics",
            json={"robot": "puma560", "joints": np.degrees(q).tolist(), "base": base, "tool": tool},
        ).json()
        assert np.abs(np.array(reached["transform"]) - target).max() < 1e-12
    assert len(solutions) == 8


@pytest.mark.parametrize("robot", ["onelink", "scara", "twolink", "uw"])
def test_every_branch_brings_the_tool_to_the_target(client: httpx.Client, robot: str) -> None:
    """Arms of few joints: with a base, a tool beside the last axis, and code for what must be zero."""
    placed = {"base": [0.1, -0.2, 0.3, 20, 0, 0], "tool": [0.1, 0.05, -0.02, 30, 40, 50]}
    forward = {"robot": robot, "joints": [20, -40, 0.1 if robot == "scara" else 30, 30], **placed}
    forward["joints"] = forward["joints"][: {"onelink": 1, "twolink": 2, "uw": 3}.get(robot, 4)]
    target = np.array(client.post("/api/v1/forward-kinematics", json=forward).json()["transform"])
    answer = asked(client, robot=robot, formats=["python"], **placed)
    space: dict[str, Any] = {"inverse_kinematics_misfit": lambda *_: [0.0]}
    for code in ("code", "misfit_code"):
        exec(answer.get(code, {}).get("python", ""), space)
    known = dict(client.get(f"/api/v1/robots/{robot}").json()["parameters"])
    for i, row in enumerate(answer["target"]["rotation"]):
        known |= {name: target[i, j] for j, name in enumerate(row)}
    known |= dict(zip(answer["target"]["position"], target[:3, 3], strict=True))
    for signs in itertools.product((1.0, -1.0), repeat=len(answer["branches"])):
        values = known | dict(zip(answer["branches"], signs, strict=True))
        arguments = [values[name] for name in answer["arguments"]]
        try:
            q = np.degrees(space["inverse_kinematics"](*arguments)).tolist()
        except ValueError:  # this branch does not exist
            assert robot == "uw"
            continue
        assert np.abs(space["inverse_kinematics_misfit"](*arguments)).max() < 1e-12
        if robot == "scara":
            q[2] = math.radians(q[2])
        pose = client.post("/api/v1/forward-kinematics", json={**forward, "joints": q}).json()["transform"]
        off = np.abs(np.array(pose) - target)
        assert (off[:3, 3] if answer["target"]["reach"] == "position" else off).max() < 1e-12


def by_name(answer: dict[str, Any]) -> dict[str, dict[str, Any]]:
    return {equation["name"]: equation for equation in answer["equations"]}


def test_a_ur_arm_says_what_is_free_where_its_wrist_is_straight(client: httpx.Client) -> None:
    answer = asked(client, robot="ur5", notation="short", formats=["text", "latex"])
    assert answer["branches"] == ["sigma1", "sigma2", "sigma3"]
    phi = by_name(answer)["phi"]
    assert (phi["quantity"], phi["meaning"]["text"], phi["branch"]) == (
        "plane_turn",
        "q2 + q3 + q4",
        "sigma2",
    )
    straight, turned_over = phi["singular"]
    assert (straight["joint"], straight["at"]["text"], straight["free"]) == (5, "0", [6])
    assert (turned_over["joint"], turned_over["at"]["text"], turned_over["free"]) == (5, "pi", [6])
    assert straight["combination"]["text"] == "q2 + q3 + q4 + q6"
    assert turned_over["combination"]["text"] == "q2 + q3 + q4 - q6"
    assert straight["value"] == turned_over["value"]
    assert [one["text"] for one in straight["conditions"]] == ["m_x", "m_y", "m_z - 1"]
    assert [(one["name"], one.get("joint")) for one in straight["equations"]] == [("q5", 5), ("phi", None)]
    assert straight["equations"][0]["latex"] == "q_{5}=0"
    assert answer["symbols"]["c234"] == "cos(q2 + q3 + q4)"


def test_cases_are_for_the_tool_in_the_world(client: httpx.Client) -> None:
    """What only a singular case needs of the target is written down, too."""
    base = [[0, -1, 0, 0.1], [1, 0, 0, -0.2], [0, 0, 1, 0.3], [0, 0, 0, 1]]
    answer = asked(client, robot="stanford", base=base, formats=["text"])
    named = by_name(answer)
    cases = [case for equation in answer["equations"] for case in equation["singular"]]
    assert {case.get("joint") for case in cases} == {None, 5}
    for case in cases:
        held = " ".join(one["text"] for one in [*case["conditions"], *case["equations"]])
        assert {f"r{i}{j}" for i in "123" for j in "123" if f"r{i}{j}" in held} <= set(named)
    assert named["r12"]["quantity"] == "target"


def test_only_an_arm_that_cannot_have_every_pose_comes_with_its_misfit(client: httpx.Client) -> None:
    formats = ["c", "python"]
    assert "misfit_code" not in asked(client, robot="puma560", formats=formats)
    assert "misfit_code" not in asked(client, robot="scorbot", formats=["text"])
    answer = asked(client, robot="scorbot", formats=formats)
    assert set(answer["misfit_code"]) == set(answer["code"]) == set(formats)
    space: dict[str, Any] = {}
    exec(answer["misfit_code"]["python"], space)
    known = dict.fromkeys(answer["arguments"], 0.0) | {"p_x": 5.0, "r33": 1.0, "r23": 0.25, "sigma1": 1.0}
    (misfit,) = space["inverse_kinematics_misfit"](*known.values())
    assert abs(misfit + 0.25) < 1e-12


def test_given_lengths_stand_in_the_equations(client: httpx.Client) -> None:
    answer = asked(client, robot="twolink", parameters={"L1": 0.5, "L2": 0.3}, formats=["text"])
    assert answer["parameters"] == []
    assert answer["target"]["reach"] == "position"
    assert "0.34" in str(answer["equations"])


@pytest.mark.parametrize("robot", ["panda", "ssrms", "gen3"])
def test_arms_without_such_a_form_are_refused(client: httpx.Client, robot: str) -> None:
    response = client.post(URL, json={"form": "symbolic", "robot": robot})
    assert response.status_code == 422
    problem = response.json()
    assert (problem["code"], problem["pointer"]) == ("inverse_form_unknown", "/robot")


def test_a_table_without_joints_is_refused_for_that(client: httpx.Client) -> None:
    row = {"alpha": 0, "a": "L", "d": 0, "theta": "phi"}  # a parameter unless the row says that it turns
    rows = {"convention": "standard", "angle_unit": "deg", "rows": [row, row]}
    problem = client.post(URL, json={"form": "symbolic", "table": rows}).json()
    assert (problem["code"], problem["pointer"]) == ("inverse_joint_count", "/table/rows")


TURNED_FOOT = {"joint": "fixed", "alpha": 0, "a": 0.1, "d": 0.2, "theta": 20}
LINKS = [{"alpha": 0, "a": 0.4, "d": 0, "theta": "q1"}, {"alpha": 0, "a": 0.3, "d": 0, "theta": "q2"}]


def test_fixed_rows_that_turn_ahead_of_the_joints_are_a_base(client: httpx.Client) -> None:
    rows = {"convention": "standard", "angle_unit": "deg", "rows": [TURNED_FOOT, *LINKS]}
    answer = asked(client, table=rows, formats=["python"])
    assert answer["target"]["position"] == ["t_x", "t_y", "t_z"]
    names = [name for name in answer["arguments"] if name.startswith("t")]
    space: dict[str, Any] = {}
    exec(answer["code"]["python"], space)
    joints = [0.3, -0.8]
    foot, elbow, hand = math.radians(20), math.radians(20) + joints[0], math.radians(20) + sum(joints)
    tip = {
        "t_x": 0.1 * math.cos(foot) + 0.4 * math.cos(elbow) + 0.3 * math.cos(hand),
        "t_y": 0.1 * math.sin(foot) + 0.4 * math.sin(elbow) + 0.3 * math.sin(hand),
        "t_z": 0.2,
    }
    found = space["inverse_kinematics"](*(tip[name] for name in names), -1)
    assert found == pytest.approx(joints, abs=1e-12)


def test_a_tilt_between_two_joints_is_pointed_at(client: httpx.Client) -> None:
    tilted = {"joint": "fixed", "alpha": 30, "a": 0.1, "d": 0, "theta": 0}
    rows = {"convention": "standard", "angle_unit": "deg", "rows": [LINKS[0], tilted, LINKS[1]]}
    problem = client.post(URL, json={"form": "symbolic", "table": rows}).json()
    assert (problem["code"], problem["pointer"]) == ("inverse_form_unknown", "/table/rows/1/alpha")


def test_an_unknown_field_is_told_the_fields_of_its_form(client: httpx.Client) -> None:
    for form, field, other in (("symbolic", "target", "formats"), ("numeric", "formats", "target")):
        response = client.post(URL, json={"robot": "puma560", "form": form, field: [0] * 6})
        faults = [each for each in response.json()["errors"] if each["code"] == "field_unknown"]
        ((pointer, allowed),) = [(each["pointer"], each["params"]["allowed"]) for each in faults]
        assert pointer == f"/{field}"
        assert other in allowed
        assert field not in allowed
        assert len(set(allowed)) == len(allowed)


@pytest.mark.parametrize(
    ("body", "code"),
    [
        ({"form": "short"}, "value_not_allowed"),
        ({"form": "symbolic", "target": [[1]]}, "field_unknown"),
        ({"form": "symbolic", "formats": []}, "list_too_short"),
        ({"form": "symbolic", "formats": ["mathml"]}, "value_not_allowed"),
        ({"form": "symbolic", "parameters": {"x": 1}}, "parameter_unused"),
        ({"form": "symbolic", "base": [[1, 0, 0, 0]] * 4}, "pose_bottom_row"),
    ],
)
def test_what_cannot_be_meant_is_refused(client: httpx.Client, body: dict[str, Any], code: str) -> None:
    response = client.post(URL, json={"robot": "scara", **body})
    assert response.status_code == 422
    assert code in [error["code"] for error in response.json()["errors"]]


def test_numeric_is_what_is_answered_without_a_form(client: httpx.Client) -> None:
    target = [[1, 0, 0, 0.5], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    body = {"robot": "twolink", "position": [0.4, 0.3, 0], "form": "numeric"}
    assert client.post(URL, json=body).status_code == 200
    assert client.post(URL, json={"robot": "twolink", "target": target}).status_code == 200


@pytest.mark.parametrize("robot", ["puma560", "ur5", "stanford", "scara", "scorbot", "gen3"])
def test_what_is_small_does_not_stand_behind_what_is_large(robot: str) -> None:
    task = inverse_form_task(SymbolicInverseRequest(form="symbolic", robot=robot), Settings())
    assert task.is_quick() == (task.table.n_joints <= 6)


def test_the_same_question_gets_the_same_bytes(client: httpx.Client) -> None:
    body = {"form": "symbolic", "robot": "puma560", "notation": "short", "formats": ["latex", "python"]}
    first, second = (client.post(URL, json=body) for _ in range(2))
    assert first.content == second.content
    assert "null" not in first.text
