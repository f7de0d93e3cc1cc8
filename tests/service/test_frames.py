"""POST /assign-frames and /check-frames over HTTP."""

import pytest

ELBOW = [
    {"joint": "revolute", "point": [0, 0, 0], "direction": [0, 0, 2]},
    {"joint": "revolute", "point": [0, 0, 0.4], "direction": [0, -1, 0]},
    {"joint": "revolute", "point": [0.5, 0, 0.4], "direction": [0, -1, 0]},
]


def assign(client, **request):
    return client.post("/api/v1/assign-frames", json={"axes": ELBOW, "convention": "standard", **request})


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_a_table_with_the_rule_of_every_frame(client, convention) -> None:
    answer = assign(client, convention=convention, angle_unit="deg")
    assert answer.status_code == 200
    body = answer.json()
    alphas = [row["alpha"] for row in body["table"]["rows"]]
    lengths = [row["a"] for row in body["table"]["rows"]]
    if convention == "standard":
        assert alphas[:2] == [90, 0]
        assert lengths[:2] == [0, 0.5]
    else:
        assert alphas == [0, 90, 0]
        assert lengths == [0, 0, 0.5]
    assert [frame["rule"] for frame in body["frames"]] == ["first", "intersecting", "parallel", "last"]
    assert body["warnings"] == []


def test_the_gripper_is_the_last_frame(client) -> None:
    tool = {"point": [0.9, 0, 0.4], "approach": [1, 0, 0], "jaws": [0, 1, 0]}
    body = assign(client, tool=tool).json()
    table = body["table"]
    pose = client.post(
        "/api/v1/forward-kinematics",
        json={"table": table, "joints": [0, 0, 0], "base": body["base"], "tool": body["tool"]},
    ).json()["transform"]
    assert [round(row[2], 12) for row in pose[:3]] == [1, 0, 0]
    assert [round(row[3], 12) for row in pose[:3]] == [0.9, 0, 0.4]


def test_near_parallel_axes_are_taken_as_parallel_with_a_warning(client) -> None:
    axes = [*ELBOW[:2], {"joint": "revolute", "point": [0.5, 0, 0.4], "direction": [1e-4, -1, 0]}]
    answer = client.post(
        "/api/v1/assign-frames",
        json={"axes": axes, "convention": "modified"},
        headers={"Accept-Language": "es"},
    )
    body = answer.json()
    assert [warning["code"] for warning in body["warnings"]] == ["near_parallel"]
    assert "paralelos" in body["warnings"][0]["message"]
    assert all(abs(frame["origin"][0]) < 10 for frame in body["frames"])


@pytest.mark.parametrize(
    ("change", "code", "pointer"),
    [
        ({"axes": []}, "list_too_short", "/axes"),
        ({"axes": [{**ELBOW[0], "direction": [0, 0, 0]}]}, "direction_zero", "/axes/0/direction"),
        ({"axes": [{**ELBOW[0], "joint": "fixed"}]}, "value_not_allowed", "/axes/0/joint"),
        ({"axes": [{**ELBOW[0], "point": [0, 0]}]}, "list_too_short", "/axes/0/point"),
        ({"parallel_tolerance": 1}, "number_too_large", "/parallel_tolerance"),
        ({"base": [[2, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}, None, "/base"),
        (
            {"tool": {"point": [0, 0, 0], "approach": [1, 0, 0], "jaws": [1, 0, 0]}},
            "gripper_jaws_along_approach",
            "/tool/jaws",
        ),
    ],
)
def test_refusals(client, change, code, pointer) -> None:
    answer = assign(client, **change)
    assert answer.status_code == 422
    body = answer.json()
    assert body["pointer"] == pointer
    assert code is None or body["code"] == code


def test_a_students_frames_are_judged_in_their_language(client) -> None:
    frames = [
        {"origin": [0, 0, 0], "x": [1, 0, 0], "z": [0, 0, 1]},
        {"origin": [0, 0, 1], "x": [1, 0, 0], "z": [0, 1, 0]},
        None,
    ]
    body = client.post(
        "/api/v1/check-frames",
        json={"axes": ELBOW, "convention": "modified", "frames": frames},
        headers={"Accept-Language": "ro"},
    ).json()
    findings = body["frames"][1]["findings"]
    assert {finding["rule"] for finding in findings} == {"z_not_along_axis", "origin_not_at_intersection"}
    assert all(finding["severity"] == "broken" for finding in findings)
    assert any("axei 1" in finding["message"] for finding in findings)
    assert body["rows"] == [None, None, None]
    assert body["table"] is None


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_the_assigned_frames_break_no_rule_and_give_the_same_table(client, convention) -> None:
    assigned = assign(client, convention=convention, angle_unit="deg").json()
    answer = client.post(
        "/api/v1/check-frames",
        json={"axes": ELBOW, "convention": convention, "frames": assigned["frames"], "angle_unit": "deg"},
    )
    assert answer.status_code == 200, answer.text
    body = answer.json()
    assert [frame["findings"] for frame in body["frames"]] == [[], [], [], []]
    assert body["table"] == assigned["table"]


@pytest.mark.parametrize(
    "frame",
    [
        {"x": [1, 0, 0], "y": [0, -1, 0], "z": [0, 0, 1]},
        {"x": [1, 0, 0], "y": [0, 1, 0]},
        {"y": [0, 1, 0], "z": [0, 0, 1]},
    ],
    ids=["left-handed", "without z", "without x"],
)
def test_a_y_that_does_not_follow(client, frame) -> None:
    request = {"axes": ELBOW, "convention": "modified", "frames": [None, frame]}
    answer = client.post("/api/v1/check-frames", json=request)
    assert (answer.status_code, answer.json()["code"]) == (422, "frame_y_not_z_cross_x")
    assert answer.json()["pointer"] == "/frames/1/y"


def test_a_y_is_not_blamed_for_an_x_along_z(client) -> None:
    frame = {"origin": [0, 0, 0], "x": [0, 0, 2], "y": [0, 1, 0], "z": [0, 0, 1]}
    request = {"axes": ELBOW, "convention": "modified", "frames": [frame]}
    body = client.post("/api/v1/check-frames", json=request).json()
    assert body["frames"][0]["findings"][0]["rule"] == "x_not_across_z"


@pytest.mark.parametrize(
    ("tool", "code", "pointer"),
    [
        ({"point": [0, 0, 0], "approach": [1, 0, 0]}, "field_missing", "/tool/jaws"),
        ([[1, 0], [0, 1]], "pose_wrong_shape", "/tool"),
        ("gripper", "list_expected", "/tool"),
    ],
)
def test_a_malformed_tool_is_named_as_the_caller_wrote_it(client, tool, code, pointer) -> None:
    answer = assign(client, tool=tool)
    assert (answer.status_code, answer.json()["code"], answer.json()["pointer"]) == (422, code, pointer)
    assert len(answer.json()["errors"]) == 1


def test_too_many_frames(client) -> None:
    request = {"axes": ELBOW, "convention": "modified", "frames": [None] * 5}
    answer = client.post("/api/v1/check-frames", json=request)
    assert (answer.status_code, answer.json()["code"]) == (422, "frames_too_many")
