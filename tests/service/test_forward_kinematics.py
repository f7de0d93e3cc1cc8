from __future__ import annotations

import io
import json
import math
import time
import tracemalloc
from typing import Any

import httpx
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kinematics import catalogue
from service.settings import Settings
from service.wire.kinematics.pose_answers import PoseQuestion, json_blocks, one_answer
from service.wire.kinematics.prepared_robots import robot_of
from tests.examples import PUMA_560
from tests.live_service import running
from tests.service import oracle

PATH = "/api/v1/forward-kinematics"
NPY = "application/x-npy"

lengths = st.floats(-2, 2).map(lambda x: round(x, 6))
angles = st.sampled_from([0, 90, -90, 180, 45]) | st.floats(-180, 180).map(lambda x: round(x, 9))


@st.composite
def questions(draw: st.DrawFn) -> dict[str, Any]:
    rows = []
    for _ in range(draw(st.integers(1, 7))):
        joint = draw(st.sampled_from(["revolute", "revolute", "prismatic", "fixed"]))
        rows.append(
            {
                "joint": joint,
                "alpha": draw(angles),
                "a": draw(lengths),
                "d": draw(lengths),
                "theta": draw(angles),
            }
        )
    table = {
        "convention": draw(st.sampled_from(["standard", "modified"])),
        "angle_unit": draw(st.sampled_from(["deg", "rad"])),
        "rows": rows,
    }
    values = {"revolute": st.floats(-400, 400), "prismatic": st.floats(-3, 3)}
    joints = [draw(values[row["joint"]]) for row in rows if row["joint"] != "fixed"]
    return {"table": table, "joints": joints}


def asked(client: httpx.Client, body: dict[str, Any], **headers: str) -> Any:
    response = client.post(PATH, json=body, headers=headers)
    assert response.status_code == 200, response.text
    return response.json()


@given(questions())
def test_every_part_agrees_with_elementary_motions(client: httpx.Client, question: dict[str, Any]) -> None:
    answer = asked(client, {**question, "inverse": True})
    links = oracle.links(question["table"], question["joints"])
    transform = oracle.product(links)
    frames = [oracle.product(links[: i + 1]) for i in range(len(links))]
    np.testing.assert_allclose(answer["transform"], transform, atol=1e-11)
    np.testing.assert_allclose(answer["links"], links, atol=1e-11)
    np.testing.assert_allclose(answer["frames"], frames, atol=1e-11)
    np.testing.assert_allclose(answer["inverse"], np.linalg.inv(transform), atol=1e-10)
    np.testing.assert_allclose(answer["position"], transform[:3, 3], atol=1e-11)
    check_orientation(answer, transform)


def check_orientation(answer: dict[str, Any], transform: np.ndarray) -> None:
    unit = oracle.UNIT[answer["angle_unit"]]
    found = answer["orientation"]
    w, x, y, z = found["quaternion"]
    assert w >= 0
    assert math.isclose(math.hypot(w, x, y, z), 1, abs_tol=1e-12)
    angle = 2 * math.atan2(math.hypot(x, y, z), w)
    assert math.isclose(found["axis_angle"]["angle"] * unit, angle, abs_tol=1e-9)
    roll, pitch, yaw = (value * unit for value in found["rpy"])
    rotation = oracle.turn("z", yaw) @ oracle.turn("y", pitch) @ oracle.turn("x", roll)
    np.testing.assert_allclose(rotation[:3, :3], transform[:3, :3], atol=1e-9)
    *position, a, b, c = found["xyzabc"]
    np.testing.assert_allclose(position, transform[:3, 3], atol=1e-11)
    rotation = oracle.turn("z", a * unit) @ oracle.turn("y", b * unit) @ oracle.turn("x", c * unit)
    np.testing.assert_allclose(rotation[:3, :3], transform[:3, :3], atol=1e-9)


@settings(max_examples=25)
@given(questions(), st.integers(0, 2**32 - 1))
def test_a_batch_is_its_configurations(client: httpx.Client, question: dict[str, Any], seed: int) -> None:
    n = len(question["joints"])
    batch = np.random.default_rng(seed).uniform(-3, 3, (3, n)).tolist() if n else [[], []]
    together = asked(client, {**question, "joints": batch, "inverse": True})
    for i, joints in enumerate(batch):
        alone = asked(client, {**question, "joints": joints, "inverse": True})
        for part in ("transform", "links", "frames", "position", "inverse"):
            np.testing.assert_allclose(together[part][i], alone[part], atol=1e-11)
        transform = oracle.product(oracle.links(question["table"], joints))
        one = {
            "quaternion": together["orientation"]["quaternion"][i],
            "rpy": together["orientation"]["rpy"][i],
            "xyzabc": together["orientation"]["xyzabc"][i],
            "axis_angle": {key: values[i] for key, values in together["orientation"]["axis_angle"].items()},
        }
        check_orientation({**together, "orientation": one}, transform)


def test_base_and_tool_enclose_the_table(client: httpx.Client) -> None:
    base = oracle.shift("x", 2) @ oracle.turn("z", 0.3)
    tool = oracle.turn("y", -1.1) @ oracle.shift("z", 0.2)
    joints = [10, 20, 30, 40, 50, 60]
    plain = asked(client, {"table": PUMA_560, "joints": joints})
    body = {"table": PUMA_560, "joints": joints, "base": base.tolist(), "tool": tool.tolist()}
    answer = asked(client, body)
    np.testing.assert_allclose(answer["transform"], base @ plain["transform"] @ tool, atol=1e-12)
    np.testing.assert_allclose(answer["links"], plain["links"], atol=1e-12)
    np.testing.assert_allclose(answer["frames"], base @ np.array(plain["frames"]), atol=1e-12)


def test_units_are_those_of_the_table(client: httpx.Client) -> None:
    degrees = {"convention": "standard", "angle_unit": "deg", "length_unit": "mm", "rows": [
        {"alpha": 90, "a": "L1", "d": "q1", "theta": "A"}, {"alpha": 0, "a": 0, "d": 0, "theta": "q2 + 30"},
    ]}  # fmt: skip
    answer = asked(client, {"table": degrees, "joints": [120, 60], "parameters": {"L1": 50, "A": 90}})
    assert (answer["angle_unit"], answer["length_unit"]) == ("deg", "mm")
    expected = oracle.shift("z", 120) @ oracle.turn("z", math.pi / 2) @ oracle.shift("x", 50)
    expected = expected @ oracle.turn("x", math.pi / 2) @ oracle.turn("z", math.pi / 2)
    np.testing.assert_allclose(answer["transform"], expected, atol=1e-12)


def test_parts_may_be_chosen(client: httpx.Client) -> None:
    body = {"table": PUMA_560, "joints": [0] * 6, "parts": ["position", "inverse"]}
    assert set(asked(client, body)) == {"angle_unit", "length_unit", "position", "inverse"}
    body["joints"] = [[0] * 6] * 2
    assert set(asked(client, body)) == {"angle_unit", "length_unit", "position", "inverse"}


def test_a_robot_of_the_catalogue_may_be_named(client: httpx.Client) -> None:
    joints = [0, 45, -90, 0, 30, 0]
    named = asked(client, {"robot": "puma560", "joints": joints})
    np.testing.assert_allclose(
        named["transform"], asked(client, {"table": PUMA_560, "joints": joints})["transform"]
    )
    longer = asked(client, {"robot": "puma560", "parameters": {"a2": 1}, "joints": [0] * 6})
    plain = asked(client, {"robot": "puma560", "joints": [0] * 6})
    assert math.isclose(longer["position"][0] - plain["position"][0], 1 - 0.4318)


def test_the_same_table_again_gives_the_same_answer(client: httpx.Client) -> None:
    body = {"table": PUMA_560, "joints": [1, 2.5, 3, 4, 5, 6]}
    first = asked(client, body)
    assert all(asked(client, body) == first for _ in range(20))
    changed = json.loads(json.dumps(body))
    changed["table"]["rows"][1]["a"] = 0.5
    assert asked(client, changed) != first


def saved(array: np.ndarray) -> bytes:
    stream = io.BytesIO()
    np.save(stream, array)
    return stream.getvalue()


def loaded(response: httpx.Response) -> np.ndarray:
    assert response.status_code == 200, response.text
    assert response.headers["content-type"] == NPY
    return np.load(io.BytesIO(response.content), allow_pickle=False)


@pytest.mark.parametrize("count", [0, 1, 64, 65, 40_000])
def test_npy_in_and_out(client: httpx.Client, count: int) -> None:
    joints = np.random.default_rng(count).uniform(-180, 180, (count, 6))
    response = client.post(
        PATH,
        content=saved(joints),
        params={"request": json.dumps({"table": PUMA_560})},
        headers={"Content-Type": NPY, "Accept": NPY},
    )
    poses = loaded(response)
    assert poses.shape == (count, 4, 4)
    assert int(response.headers["content-length"]) == len(response.content)
    for i in range(0, count, max(1, count // 7)):
        expected = oracle.product(oracle.links(PUMA_560, joints[i].tolist()))
        np.testing.assert_allclose(poses[i], expected, atol=1e-12)


@pytest.mark.parametrize("part", ["transform", "links", "frames", "position", "inverse"])
@pytest.mark.parametrize("joints", [[10, 20, 30, 40, 50, 60], [[10, 20, 30, 40, 50, 60], [0] * 6]])
def test_json_in_npy_out(client: httpx.Client, part: str, joints: list[Any]) -> None:
    body = {"table": PUMA_560, "joints": joints, "parts": [part]}
    array = loaded(client.post(PATH, json=body, headers={"Accept": NPY}))
    np.testing.assert_allclose(array, asked(client, body)[part], atol=0)


def test_npy_in_json_out(client: httpx.Client) -> None:
    joints = np.array([[10, 20, 30, 40, 50, 60], [0] * 6], dtype=">i2")
    response = client.post(
        PATH,
        content=saved(np.asfortranarray(joints)),
        params={"robot": "puma560"},
        headers={"Content-Type": NPY},
    )
    expected = asked(client, {"robot": "puma560", "joints": joints.tolist()})
    assert response.json() == expected


def test_a_large_batch_of_json_is_one_document(client: httpx.Client) -> None:
    joints = np.random.default_rng(0).uniform(-180, 180, (700, 6)).tolist()
    answer = asked(client, {"table": PUMA_560, "joints": joints})
    assert len(answer["transform"]) == len(answer["frames"]) == len(answer["position"]) == 700
    assert len(answer["orientation"]["axis_angle"]["angle"]) == 700
    expected = oracle.product(oracle.links(PUMA_560, joints[699]))
    np.testing.assert_allclose(answer["transform"][699], expected, atol=1e-12)


def test_batches_that_find_no_place_are_told_to_come_back(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("service.work.batches.PATIENCE", 120.0)
    with (
        running(Settings(batch_threads=1, batch_queue=0)) as url,
        httpx.Client(base_url=url, timeout=120) as client,
    ):
        body = {"table": PUMA_560, "joints": [[0] * 6] * 5000}
        with client.stream("POST", PATH, json=body) as first:
            assert first.status_code == 200
            pieces = first.iter_raw()
            next(pieces)
            with httpx.Client(base_url=url, timeout=120) as other:
                second = other.post(PATH, json=body)
        assert second.status_code == 503
        assert second.json()["code"] == "busy"
        assert int(second.headers["retry-after"]) > 0
        assert client.get("/healthz").status_code == 200
        deadline = time.monotonic() + 120
        while time.monotonic() < deadline:  # the place is left when the first caller has gone
            if client.post(PATH, json=body).status_code == 200:
                return
            time.sleep(0.05)
        raise AssertionError("the place was never left")


def test_points_of_links_are_mapped(client: httpx.Client) -> None:
    """Seed 003 eq. 1 and 8: a point of link i in frame i-1, and in frame 0."""
    points = [{"frame": 2, "at": [10, -5, 3]}, {"frame": 6, "at": [0, 0, 0]}]
    body = {"robot": "dmra", "joints": [20, -60, 30, 10, 40, 0], "points": points}
    answer = client.post("/api/v1/forward-kinematics", json=body).json()
    for point, mapped in zip(points, answer["points"], strict=True):
        at, k = np.array([*point["at"], 1.0]), point["frame"] - 1
        assert np.allclose(mapped["previous"], (np.array(answer["links"][k]) @ at)[:3])
        assert np.allclose(mapped["world"], (np.array(answer["frames"][k]) @ at)[:3])
    assert np.allclose(answer["points"][1]["world"], answer["position"])
    batch = client.post(
        "/api/v1/forward-kinematics",
        json={**body, "joints": [body["joints"], [0] * 6], "parts": ["position"]},
    ).json()
    assert np.allclose(batch["points"][0]["world"][0], answer["points"][0]["world"])
    assert len(batch["points"][0]["previous"]) == 2


def test_points_of_a_batch_are_mapped_block_by_block() -> None:
    """All links and frames of a batch were made at once: gigabytes for the longest one."""
    listed = catalogue.robot("puma560")
    robot = robot_of(listed.table, listed.parameters)
    joints = np.linspace(-1.0, 1.0, 6 * 20_000).reshape(-1, 6)
    points = [(frame, [0.1, -0.2, 0.3]) for frame in (1, 2, 3, 4, 5, 6)]
    tracemalloc.start()
    try:
        pieces = json_blocks(PoseQuestion(robot=robot, joints=joints, parts=(), points=points))
        answer = b"".join(piece for piece in pieces if len(piece) < 100)
        _, most = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert most < 12e6
    assert answer.count(b"previous") == len(points)
    few = PoseQuestion(robot=robot, joints=joints[:3], parts=(), points=points)
    found = json.loads(b"".join(json_blocks(few)))["points"]
    for k, one in enumerate(joints[:3]):
        alone = PoseQuestion(robot=robot, joints=one.tolist(), parts=(), points=points)
        for mapped, told in zip(found, json.loads(one_answer(alone))["points"], strict=True):
            assert np.allclose([mapped["previous"][k], mapped["world"][k]], [told["previous"], told["world"]])


def test_points_of_links_that_are_not_there(client: httpx.Client) -> None:
    body = {"robot": "dmra", "joints": [0] * 6, "points": [{"frame": 7, "at": [0, 0, 0]}]}
    response = client.post("/api/v1/forward-kinematics", json=body)
    assert response.status_code == 422
    assert response.json()["errors"][0]["code"] == "frame_unknown"
    body["points"] = [{"frame": 1, "at": [0, 0, 0]}]
    arrays = client.post("/api/v1/forward-kinematics", json=body, headers={"Accept": "application/x-npy"})
    assert arrays.json()["code"] == "npy_one_part"


def test_points_too_far_out_are_refused(client: httpx.Client) -> None:
    """Their places were null."""
    far = [{"frame": 2, "at": [0, 1.7e308, 1.7e308]}]
    answer = client.post(
        "/api/v1/forward-kinematics", json={"robot": "puma560", "joints": [9, 45, 9, 9, 9, 9], "points": far}
    )
    found = [(error["code"], error["pointer"]) for error in answer.json()["errors"]]
    assert found == [("result_not_finite", "/points/0/at/1"), ("result_not_finite", "/points/0/at/2")]


@pytest.mark.parametrize("place", [0, 2047, 2048, 4999])
@pytest.mark.parametrize("wrong", ["x", None, [1]])
def test_a_wrong_value_in_a_long_batch_is_told_at_its_place(
    client: httpx.Client, place: int, wrong: Any
) -> None:
    joints: list[list[Any]] = [[0.1] * 6 for _ in range(5000)]
    joints[place][place % 6] = wrong
    answer = client.post("/api/v1/forward-kinematics", json={"robot": "puma560", "joints": joints})
    told = [(error["code"], error["pointer"]) for error in answer.json()["errors"]]
    assert told == [("number_expected", f"/joints/{place}/{place % 6}")]
