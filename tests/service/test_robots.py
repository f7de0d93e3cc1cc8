"""GET /robots: the catalogue over HTTP, its entries usable as they stand."""

import math

import httpx
import numpy as np
import pytest

from kinematics import catalogue
from kinematics.table import JointType
from service.messages import languages

API = "/api/v1"


def test_every_robot_is_listed(client: httpx.Client) -> None:
    listed = client.get(f"{API}/robots")
    assert listed.status_code == 200
    assert [robot["id"] for robot in listed.json()["robots"]] == list(catalogue.robot_ids())


@pytest.mark.parametrize("robot_id", catalogue.robot_ids())
def test_an_entry_can_be_sent_to_the_other_calls(client: httpx.Client, robot_id: str) -> None:
    """Table, parameters and joints of the catalogue; the pose is that of the second derivation."""
    robot = client.get(f"{API}/robots/{robot_id}").json()
    known = catalogue.robot(robot_id)
    assert robot.keys() >= {"id", "name", "source", "table", "parameters", "configurations"}
    assert ("limits" in robot) == (known.limits is not None)
    joints = list(known.reference.joints)
    question = {"table": robot["table"], "parameters": robot["parameters"], "joints": joints}
    answer = client.post(f"{API}/forward-kinematics", json=question).json()
    np.testing.assert_allclose(answer["transform"], known.reference.transform, atol=1e-9)
    by_chain = client.post(f"{API}/scm/forward-kinematics", json={**robot["scm"], "joints": joints}).json()
    np.testing.assert_allclose(by_chain["transform"], answer["transform"], atol=1e-9)
    by_name = client.post(f"{API}/scm/forward-kinematics", json={"robot": robot_id, "joints": joints}).json()
    np.testing.assert_allclose(by_name["transform"], answer["transform"], atol=1e-9)


@pytest.mark.parametrize("robot_id", catalogue.robot_ids())
def test_configurations_are_as_long_as_the_arm_and_within_limits(client: httpx.Client, robot_id: str) -> None:
    robot = client.get(f"{API}/robots/{robot_id}").json()
    movable = [row for row in robot["table"]["rows"] if row["joint"] != JointType.FIXED]
    assert robot["configurations"]
    for configuration in robot["configurations"].values():
        assert len(configuration["joints"]) == len(movable)
        assert configuration["meaning"]
        for q, (low, high) in zip(configuration["joints"], robot.get("limits", []), strict=False):
            assert low <= q <= high
            assert math.isfinite(q)


def test_an_unknown_robot_is_not_there(client: httpx.Client) -> None:
    answer = client.get(f"{API}/robots/puma561", headers={"Accept-Language": "fr"})
    assert answer.status_code == 404
    problem = answer.json()
    assert (problem["code"], problem["errors"][0]["name"]) == ("robot_unknown", "robot_id")
    assert "catalogue" in problem["detail"]
    assert "puma560" in problem["detail"]


@pytest.mark.parametrize("robot_id", catalogue.robot_ids())
def test_names_and_configurations_are_told_in_every_language(client: httpx.Client, robot_id: str) -> None:
    known = catalogue.robot(robot_id)
    told: dict[str, dict[str, str]] = {}
    for language in languages():
        robot = client.get(f"{API}/robots/{robot_id}", headers={"Accept-Language": language})
        assert robot.headers["content-language"] == language
        assert "Accept-Language" in robot.headers["vary"]
        assert robot.content == client.get(f"{API}/robots/{robot_id}", params={"lang": language}).content
        body = robot.json()
        told[language] = {name: found["meaning"] for name, found in body["configurations"].items()}
        if language == "en":
            assert body["name"] == known.name
    assert told["en"] == {name: found.meaning for name, found in known.configurations.items()}
    for name in known.configurations:
        assert len({told[language][name] for language in told}) == len(told)
