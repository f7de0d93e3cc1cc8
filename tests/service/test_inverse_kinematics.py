"""POST /inverse-kinematics over HTTP."""

import asyncio
import math
from typing import Any

import httpx
import numpy as np
import pytest

from kinematics.catalogue import robot, robot_ids
from kinematics.cells import AngleUnit, bind_parameters
from kinematics.forward import end_pose
from kinematics.table import JointType
from service.wire.kinematics import inverse_solutions
from service.work.workers import Lane, Workers
from tests.conftest import EXPLORE
from tests.examples import PUMA_560
from tests.service.asking import answered

URL = "/api/v1/inverse-kinematics"
SEVEN_JOINTS = ("gen3", "iiwa14", "ssrms")
"""Half a second each; what is asked of the panda is the same."""
ROBOTS = [name for name in robot_ids() if EXPLORE or name not in SEVEN_JOINTS]


def asked(client: httpx.Client, **body: Any) -> Any:
    return answered(client, URL, body)


def forward(client: httpx.Client, **body: Any) -> np.ndarray:
    return np.array(answered(client, "/api/v1/forward-kinematics", body)["transform"])


def test_puma_over_http(client: httpx.Client) -> None:
    joints = [20, -40, 70, 30, 50, -80]
    target = forward(client, table=PUMA_560, joints=joints)
    answer = asked(client, table=PUMA_560, target=target.tolist())
    assert answer["status"] == "solved"
    assert answer["complete"] is True
    assert answer["method"] == "closed_form"
    assert answer["angle_unit"] == "deg"
    assert len(answer["solutions"]) == 8
    assert "nearest" not in answer
    for solution in answer["solutions"]:
        assert solution["residual"] <= 1e-9
        assert np.abs(forward(client, table=PUMA_560, joints=solution["joints"]) - target).max() <= 1e-9
    assert min(np.abs(np.array(s["joints"]) - joints).max() for s in answer["solutions"]) < 1e-6


@pytest.mark.parametrize("robot_id", ROBOTS)
def test_every_robot_of_the_catalogue(client: httpx.Client, robot_id: str) -> None:
    entry = robot(robot_id)
    table = bind_parameters(entry.table, entry.parameters)
    q = [0.1 if j is JointType.PRISMATIC else 0.3 + 0.2 * i for i, j in enumerate(table.joint_types)]
    target = end_pose(table, q)
    answer = asked(client, robot=robot_id, target=target.tolist())
    assert answer["status"] == "solved"
    assert answer["complete"] is (table.n_joints <= 6)
    for solution in answer["solutions"]:
        reached = forward(client, robot=robot_id, joints=solution["joints"])
        assert np.abs(reached - target).max() <= 1e-8 * max(1.0, np.abs(target).max())


def test_limits_in_the_units_of_the_table(client: httpx.Client) -> None:
    joints = [20, -40, 70, 30, 50, -80]
    target = forward(client, table=PUMA_560, joints=joints).tolist()
    limits = [[0, 90], [-90, None], None, [None, 90], [0, 180], [-90, 0]]
    answer = asked(client, table=PUMA_560, target=target, limits=limits)
    assert len(answer["solutions"]) == 1
    assert np.allclose(answer["solutions"][0]["joints"], joints, atol=1e-6)
    assert answer["outside_limits"] == 7
    tight = asked(client, table=PUMA_560, target=target, limits=[[21, 22], *[None] * 5])
    assert tight["status"] == "unreachable"
    assert tight["reason"] == "joint_limits"
    assert 21 <= tight["nearest"]["joints"][0] <= 22


def test_singular_and_unreachable_are_results(client: httpx.Client) -> None:
    target = forward(client, table=PUMA_560, joints=[20, -40, 70, 30, 0, -80]).tolist()
    answer = asked(client, table=PUMA_560, target=target)
    assert answer["status"] == "singular"
    assert answer["complete"] is False
    assert {"isolated", "continuum"} == {solution["isolation"] for solution in answer["solutions"]}
    target[0][3] = 5.0
    answer = asked(client, table=PUMA_560, target=target)
    assert answer["status"] == "unreachable"
    assert answer["reason"] == "out_of_reach"
    assert answer["solutions"] == []
    nearest = answer["nearest"]
    assert nearest["size"] == pytest.approx(0.4318 + np.hypot(0.0203, 0.15005) + 0.4318)
    reached = forward(client, table=PUMA_560, joints=nearest["joints"])
    assert np.allclose(reached, nearest["transform"], atol=1e-9)
    assert nearest["position_error"] == pytest.approx(
        np.linalg.norm(reached[:3, 3] - np.array(target)[:3, 3])
    )


def test_base_tool_and_parameters(client: httpx.Client) -> None:
    table = {
        "convention": "modified",
        "length_unit": "mm",
        "rows": [
            {"alpha": 0, "a": 0, "d": "H", "theta": "q1"},
            {"alpha": 0, "a": "A", "d": 0, "theta": "q2"},
            {"alpha": 0, "a": "B", "d": "q3", "theta": 0, "joint": "prismatic"},
            {"alpha": 0, "a": 0, "d": 0, "theta": "q4"},
        ],
    }
    question = {
        "table": table,
        "parameters": {"H": 300, "A": 400, "B": 250},
        "base": [[0, -1, 0, 10], [1, 0, 0, 20], [0, 0, 1, 30], [0, 0, 0, 1]],
        "tool": [[1, 0, 0, 0], [0, -1, 0, 0], [0, 0, -1, 50], [0, 0, 0, 1]],
    }
    target = forward(client, **question, joints=[0.3, 0.9, -60.0, 0.4])
    answer = asked(client, **question, target=target.tolist())
    assert answer["complete"] is True
    assert len(answer["solutions"]) == 2
    assert answer["length_unit"] == "mm"
    for solution in answer["solutions"]:
        assert np.abs(forward(client, **question, joints=solution["joints"]) - target).max() < 1e-9


@pytest.mark.parametrize(
    ("change", "code", "pointer"),
    [
        ({"target": [[1, 0], [0, 1]]}, "pose_wrong_shape", "/target"),
        (
            {"target": [[2, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]},
            "pose_not_orthonormal",
            "/target",
        ),
        ({"limits": [[0, 1]]}, "limits_wrong_length", "/limits"),
        ({"limits": [[1, 0], *[None] * 5]}, "limits_reversed", "/limits/0"),
        ({"limits": [None] * 9}, "limits_wrong_length", "/limits"),
        ({"limits": [None, [1e300, 1.7e308], *[None] * 4]}, "limits_too_far", "/limits/1"),
        ({"limits": [[0, 1, 2], *[None] * 5]}, "list_too_long", "/limits/0"),
        ({"tool": [[1]]}, "pose_wrong_shape", "/tool"),
        ({"robot": "puma560"}, "table_or_robot", ""),
    ],
)
def test_refusals(client: httpx.Client, change: dict[str, Any], code: str, pointer: str) -> None:
    body = {"table": PUMA_560, "target": np.eye(4).tolist(), **change}
    response = client.post(URL, json=body, headers={"Accept-Language": "ro"})
    assert response.status_code == 422
    problem = response.json()
    assert problem["code"] == code
    assert problem["pointer"] == pointer


TWO_LINKS = {
    "table": {
        "convention": "standard",
        "angle_unit": "deg",
        "rows": [
            {"alpha": 0, "a": 0.5, "d": 0, "theta": "q1"},
            {"alpha": 0, "a": 0.3, "d": 0, "theta": "q2"},
        ],
    }
}


def test_a_position_is_reached_elbow_up_and_elbow_down(client: httpx.Client) -> None:
    place = forward(client, **TWO_LINKS, joints=[20, 50])[:3, 3].tolist()
    answer = asked(client, **TWO_LINKS, position=place)
    assert answer["status"] == "solved"
    assert answer["complete"] is True
    elbows = sorted(solution["joints"][1] for solution in answer["solutions"])
    assert np.allclose(elbows, [-50, 50], atol=1e-9)
    first = asked(client, **TWO_LINKS, position=place, start=[20, 40])["solutions"][0]
    assert np.allclose(first["joints"], [20, 50], atol=1e-9)
    far = asked(client, **TWO_LINKS, position=[1, 0, 0])
    assert far["status"] == "unreachable"
    assert far["nearest"]["position_error"] == pytest.approx(0.2, abs=1e-9)


def test_an_axis_leaves_the_turn_about_itself_free(client: httpx.Client) -> None:
    target = forward(client, table=PUMA_560, joints=[20, -40, 70, 30, 50, -80])
    answer = asked(client, table=PUMA_560, position=target[:3, 3].tolist(), axis=target[:3, 2].tolist())
    assert answer["status"] == "solved"
    for solution in answer["solutions"]:
        reached = forward(client, table=PUMA_560, joints=solution["joints"])
        assert np.allclose(reached[:3, 2:], target[:3, 2:], atol=1e-7)
        assert solution["family"]["dimension"] == 1


def test_a_pose_in_every_notation(client: httpx.Client) -> None:
    joints = [20, -40, 70, 30, 50, -80]
    body = {"table": PUMA_560, "joints": joints, "parts": ["transform", "position", "orientation"]}
    found = client.post("/api/v1/forward-kinematics", json=body).json()
    orientation = found["orientation"]
    known = asked(client, table=PUMA_560, target=found["transform"])["solutions"]
    for target in (
        {"target": orientation["xyzabc"]},
        {"position": found["position"], "quaternion": orientation["quaternion"]},
    ):
        solutions = asked(client, table=PUMA_560, **target)["solutions"]
        assert np.allclose([s["joints"] for s in solutions], [s["joints"] for s in known], atol=1e-6)


def test_a_family_over_http(client: httpx.Client) -> None:
    target = np.round(forward(client, table=PUMA_560, joints=[30, -40, 70, 20, 0, -80]), 5).tolist()
    refused = client.post(URL, json={"table": PUMA_560, "target": target})
    assert refused.status_code == 422
    assert refused.json()["code"] == "pose_not_orthonormal"
    answer = asked(client, table=PUMA_560, target=target, tolerance=1e-5)
    assert answer["tolerance"] == 1e-5
    assert len(answer["solutions"]) == 7
    (family,) = [solution["family"] for solution in answer["solutions"] if "family" in solution]
    (parameter,) = family["parameters"]
    assert parameter["full_turn"] is True
    assert np.allclose(parameter["interval"], [-180, 180])
    for member in family["members"]:
        assert math.remainder(member[3] + member[5] + 60, 360) == pytest.approx(0, abs=0.01)


@pytest.mark.parametrize(
    ("change", "code", "pointer"),
    [
        ({"target": None}, "target_or_position", ""),
        ({"position": [0, 0, 1]}, "target_or_position", ""),
        ({"target": None, "position": [0, 0, 1], "axis": [0, 0, 0]}, "axis_length", "/axis"),
        (
            {"target": None, "position": [0, 0, 1], "quaternion": [0, 0, 0, 0]},
            "quaternion_length",
            "/quaternion",
        ),
        ({"tolerance": 0}, "pose_tolerance_out_of_range", "/tolerance"),
        ({"tolerance": 0.5}, "pose_tolerance_out_of_range", "/tolerance"),
        ({"start": [0, 0]}, "joints_wrong_length", "/start"),
    ],
)
def test_refusals_of_targets(client: httpx.Client, change: dict[str, Any], code: str, pointer: str) -> None:
    body = {"table": PUMA_560, "target": np.eye(4).tolist(), **change}
    body = {key: value for key, value in body.items() if value is not None}
    response = client.post(URL, json=body)
    assert response.status_code == 422
    assert (response.json()["code"], response.json()["pointer"]) == (code, pointer)


def test_poses_in_millimetres_with_one_decimal(client: httpx.Client) -> None:
    lengths = {"q1": 431.8, "q2": 233.4, "q3": 57.9}
    rows = [{"a": a, "alpha": 0, "d": 0, "theta": q} for q, a in lengths.items()]
    table = {"convention": "standard", "angle_unit": "deg", "length_unit": "mm", "rows": rows}
    turn = math.radians(70)
    tip = [431.8 * math.cos(0.5) + 233.4 * math.cos(1.1) + 57.9 * math.cos(turn)]
    tip += [431.8 * math.sin(0.5) + 233.4 * math.sin(1.1) + 57.9 * math.sin(turn)]
    target = [round(tip[0], 1), round(tip[1], 1), 0.1, 70, 0, 0]
    strict = asked(client, table=table, target=target)
    loose = asked(client, table=table, target=target, tolerance=0.2)
    assert strict["status"] == "unreachable"
    assert (len(loose["solutions"]), loose["complete"], loose["tolerance"]) == (2, True, 0.2)
    assert min(abs(s["joints"][0] - math.degrees(0.5)) for s in loose["solutions"]) < 0.1
    many = asked(client, table=table, targets=[target], tolerance=0.2)
    assert many["answers"][0]["solutions"] == loose["solutions"]


def test_too_many_joints(client: httpx.Client) -> None:
    row = {"joint": "revolute", "alpha": 0.3, "a": 0.1, "d": 0, "theta": 0}
    table = {"convention": "standard", "rows": [row] * 13}
    response = client.post(URL, json={"table": table, "target": np.eye(4).tolist()})
    assert response.status_code == 422
    assert response.json()["code"] == "inverse_joint_count"
    assert response.json()["pointer"] == "/table/rows"


def test_a_search_runs_in_a_worker(client: httpx.Client) -> None:
    rows = [
        {"joint": "revolute", "alpha": 1.1 - 0.3 * i, "a": 0.3, "d": 0.1 * i, "theta": 0.2 * i}
        for i in range(8)
    ]
    table = {"convention": "modified", "rows": rows}
    target = forward(client, table=table, joints=[0.1] * 8)
    answer = asked(client, table=table, target=target.tolist(), limits=[[-2, 2]] * 8)
    assert answer["method"] == "search"
    assert answer["complete"] is False
    for solution in answer["solutions"]:
        assert all(-2 <= value <= 2 for value in solution["joints"])
        assert np.abs(forward(client, table=table, joints=solution["joints"]) - target).max() < 1e-8
    assert math.isfinite(answer["solutions"][0]["residual"])


@pytest.mark.parametrize(
    ("parameters", "x", "pointer"),
    [({"L1": 1.0}, 1e308, "/target"), ({"L1": 1e308}, 1.0, "/parameters/L1")],
)
def test_lengths_near_the_end_of_the_doubles(
    client: httpx.Client, parameters: dict[str, float], x: float, pointer: str
) -> None:
    rows = [{"alpha": 0, "a": "L1", "d": 0, "theta": "q1"}, {"alpha": 0, "a": 1, "d": 0, "theta": "q2"}]
    target = np.eye(4)
    target[:2, 3] = x
    body = {"table": {"convention": "standard", "rows": rows}, "parameters": parameters}
    response = client.post(URL, json={**body, "target": target.tolist()})
    assert response.status_code == 422
    assert response.json()["code"] == "result_not_finite"
    assert response.json()["pointer"] == pointer


def test_a_position_too_far_away_is_pointed_at(client: httpx.Client) -> None:
    problem = client.post(URL, json={"robot": "twolink", "position": [1e308, 1e308, 0]}).json()
    assert (problem["code"], problem["pointer"]) == ("result_not_finite", "/position")


def test_what_is_too_long_is_pointed_at_where_it_was_sent(client: httpx.Client) -> None:
    target = np.eye(4).tolist()
    rows = [{"alpha": 0, "a": "1e15*L1", "d": 0, "theta": "q1"}]
    table = {"convention": "standard", "rows": rows}
    for body, pointer in (
        ({"robot": "twolink", "parameters": {"L2": 1e200}}, "/parameters/L2"),
        ({"table": table, "parameters": {"L1": 1e50}}, "/table/rows/0/a"),
    ):
        problem = client.post(URL, json={**body, "target": target}).json()
        assert [(fault["code"], fault["pointer"]) for fault in problem["errors"]] == [
            ("result_not_finite", pointer)
        ]


def test_every_solution_within_wide_limits_reaches_the_target(client: httpx.Client) -> None:
    joints = [20, -40, 70, 30, 50, -80]
    target = forward(client, table=PUMA_560, joints=joints).tolist()
    free = asked(client, table=PUMA_560, target=target)
    for limits in ([[-1e308, 1e308]] * 6, [[0, 1e308]] * 6, [[5e5, 5.1e5]] * 6):
        answer = asked(client, table=PUMA_560, target=target, limits=limits)
        assert len(answer["solutions"]) == len(free["solutions"]) == 8
        assert max(solution["residual"] for solution in answer["solutions"]) <= 1e-9


def test_many_targets_are_answered_as_each_alone(client: httpx.Client) -> None:
    joints = [[20, -40, 70, 30, 50, -80], [10, -40, 70, 30, 0, -80], [0, 0, 0, 0, 30, 0]]
    targets = [forward(client, table=PUMA_560, joints=q).tolist() for q in joints]
    far = [5, 0, 0, 0, 0, 0]
    limits = [[-170, 170]] * 6
    many = asked(client, table=PUMA_560, targets=[*targets, far], limits=limits, start=joints[0])
    assert (many["angle_unit"], many["length_unit"]) == ("deg", "m")
    statuses = [answer["status"] for answer in many["answers"]]
    assert statuses == ["solved", "singular", "solved", "unreachable"]
    for target, answer in zip([*targets, far], many["answers"], strict=True):
        alone = asked(client, table=PUMA_560, target=target, limits=limits, start=joints[0])
        assert {k: alone[k] for k in answer} == answer


def test_of_many_targets_those_that_time_does_not_reach_to_are_told_one_by_one(
    client: httpx.Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Three poses away from singularities, then hundreds with the wrist in line: families are followed."""
    monkeypatch.setattr(inverse_solutions, "ALLOTTED", 0.1)
    joints = [[20, -40, 70, 30, 50, -80], [10, -40, 70, 30, 0, -80]]
    targets = [forward(client, table=PUMA_560, joints=q).tolist() for q in joints]
    many = asked(client, table=PUMA_560, targets=[targets[0]] * 3 + [targets[1]] * 500)
    statuses = [answer["status"] for answer in many["answers"]]
    answered = 503 - statuses.count("unanswered")
    assert 3 <= answered < 503
    assert statuses == ["solved"] * 3 + ["singular"] * (answered - 3) + ["unanswered"] * (503 - answered)
    assert not any(answer["solutions"] or answer["complete"] for answer in many["answers"][answered:])
    assert [fault["pointer"] for fault in many["faults"]] == [f"/targets/{i}" for i in range(answered, 503)]
    assert {fault["code"] for fault in many["faults"]} == {"target_unanswered"}
    assert "method" not in many["answers"][-1]
    assert many["faults"][0]["params"]["answered"] == answered
    assert asked(client, table=PUMA_560, targets=targets[:1])["faults"] == []


def test_many_targets_are_read_and_written_beside_the_event_loop(
    client: httpx.Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A thousand held up everybody for a tenth of a second."""
    in_the_loop: dict[str, list[bool]] = {"pose_matrix": [], "target_answer": []}

    def noting(name: str) -> Any:
        work = getattr(inverse_solutions, name)

        def noted(*given: Any) -> Any:
            in_the_loop[name].append(_in_an_event_loop())
            return work(*given)

        return noted

    for name in in_the_loop:
        monkeypatch.setattr(inverse_solutions, name, noting(name))
    asked(client, table=PUMA_560, targets=[[0.4, 0.2, 0.3, 0, 0, 0]] * 2)
    assert in_the_loop == {"pose_matrix": [False] * 2, "target_answer": [False] * 2}


def _in_an_event_loop() -> bool:
    try:
        asyncio.get_running_loop()
    except RuntimeError:
        return False
    return True


def test_named_lengths_get_their_values_for_all_targets(client: httpx.Client) -> None:
    table = {
        "convention": "standard",
        "angle_unit": "deg",
        "rows": [
            {"alpha": 90, "a": 0, "d": "h", "theta": "q1"},
            {"alpha": 0, "a": "L1", "d": 0, "theta": "q2"},
            {"alpha": 0, "a": "L2", "d": 0, "theta": "q3"},
        ],
    }
    values = {"h": 0.4, "L1": 0.5, "L2": 0.3}
    targets = [[0.7, 0, 0.7, 0, 0, 90], [0, 0.7, 0.7, 90, 0, 90]]
    answers = asked(client, table=table, parameters=values, targets=targets)["answers"]
    elbow = math.degrees(math.atan2(3, 4))
    for turn, answer in zip((0.0, 90.0), answers, strict=True):
        assert answer["complete"] is True
        assert np.allclose(answer["solutions"][0]["joints"], [turn, elbow, -elbow], atol=1e-9)


@pytest.mark.parametrize(
    ("targets", "pointer"),
    [
        ([], "/targets"),
        ([[0] * 6] * 1001, "/targets"),
        ([[0] * 6, [[1, 0, 0, 0]] * 4], "/targets/1/3"),
        ([[0] * 6, [0] * 5], "/targets/1"),
    ],
)
def test_targets_that_are_none_are_refused_at_their_place(
    client: httpx.Client, targets: list[Any], pointer: str
) -> None:
    response = client.post(URL, json={"table": PUMA_560, "targets": targets})
    assert response.status_code == 422
    assert pointer in [error["pointer"].removeprefix("#") for error in response.json()["errors"]]


def test_target_and_targets_exclude_each_other(client: httpx.Client) -> None:
    body = {"table": PUMA_560, "target": [0] * 6, "targets": [[0] * 6]}
    response = client.post(URL, json=body)
    assert response.status_code == 422
    assert response.json()["errors"][0]["code"] == "target_or_position"


@pytest.mark.parametrize(
    ("robot_id", "q", "decimals", "afar"),
    [
        ("puma560", [0.5, -0.7, 1.2, 0.3, 0.9, -1.4], 17, False),
        ("puma560", [0.5, -0.7, 1.2, 0.3, 0.0, -1.4], 9, True),
        ("panda", [0.2, 0.3, 0.5, -0.7, 0.9, 1.0, 1.2], 17, True),
    ],
    ids=["clear", "a family to follow", "a search"],
)
@pytest.mark.parametrize("path", ["/inverse-kinematics", "/check-inverse-kinematics"])
def test_what_may_take_long_is_left_to_a_worker(
    client: httpx.Client,
    monkeypatch: pytest.MonkeyPatch,
    path: str,
    robot_id: str,
    q: list[float],
    decimals: int,
    afar: bool,
) -> None:
    lanes: list[Lane] = []
    run = Workers.run

    async def noted(self: Workers, lane: Lane, function: Any, *arguments: Any) -> Any:
        lanes.append(lane)
        return await run(self, lane, function, *arguments)

    monkeypatch.setattr(Workers, "run", noted)
    entry = robot(robot_id)
    target = end_pose(bind_parameters(entry.table, entry.parameters), q).round(decimals)
    body: dict[str, Any] = {"robot": robot_id, "target": target.tolist()}
    if path.startswith("/check"):
        own = client.post(f"/api/v1{path}", json={**body, "solutions": [_in_units(entry, q)]})
        assert own.json()["rows"][0]["correct"] is True
    else:
        assert asked(client, **body)["solutions"]
    assert lanes == [Lane.SLOW] * afar


def _in_units(entry: Any, q: list[float]) -> list[float]:
    return [math.degrees(value) if entry.table.angle_unit is AngleUnit.DEG else value for value in q]
