"""`framewise.Client` and `AsyncClient` reach every call of the API, and get the same answers."""

import asyncio
import inspect
import json
import re
from typing import Any

import numpy as np
import pytest

from framewise import AsyncClient, Client, ProblemError
from tests.document import DOCUMENT

CALLS = {
    name: function
    for name, function in inspect.getmembers(Client, inspect.isfunction)
    if not name.startswith("_") and name not in ("send", "fetch", "stream", "grade_each")
}
ROWS = [{"theta": "q1", "d": 0, "a": "L1", "alpha": 0}, {"theta": "q2", "d": 0, "a": "L2", "alpha": 0}]
TABLE = {"convention": "standard", "rows": ROWS}
LENGTHS = {"L1": 1.0, "L2": 0.5}
AXES = [{"joint": "revolute", "point": [x, 0, 0], "direction": [0, 0, 1]} for x in (0, 1)]


def examples(path: str) -> Any:
    """The first example of a call's body in the API's own description."""
    content = DOCUMENT["paths"][f"/api/v1{path}"]["post"]["requestBody"]["content"]["application/json"]
    return next(iter(content["examples"].values()))["value"]


def arguments(path: str, *positional: str) -> tuple[tuple[Any, ...], dict[str, Any]]:
    """An example's members: those that a call takes by position, and the others."""
    body = dict(examples(path))
    names = [next(name for name in choice.split("|") if name in body) for choice in positional]
    return tuple(body.pop(name) for name in names), body


ROBOT = "table|robot"
CHAIN = "chain|robot"
EVERY: dict[str, tuple[tuple[Any, ...], dict[str, Any]]] = {
    "forward_kinematics": arguments("/forward-kinematics", ROBOT, "joints"),
    "jacobian": ((TABLE, [0.1, 0.2]), {"parameters": LENGTHS, "frame": "end"}),
    "inverse_kinematics": arguments("/inverse-kinematics", ROBOT),
    "symbolic": ((TABLE,), {"formats": ["text"], "parts": ["transform"]}),
    "dynamics": arguments("/dynamics", ROBOT, "joints"),
    "rates": arguments("/rates", ROBOT, "joints"),
    "trajectory": arguments("/trajectory", ROBOT, "start", "end"),
    "workspace": ((TABLE,), {"parameters": LENGTHS, "samples": 200}),
    "understand": ((TABLE,), {}),
    "convert": arguments("/convert", "to"),
    "assign_frames": arguments("/assign-frames", "axes", "convention"),
    "check_frames": arguments("/check-frames", "axes", "convention", "frames"),
    "rotations": arguments("/rotations", "orientation"),
    "check_rotation": arguments("/check-rotation", "expected", "answer"),
    "scm_forward_kinematics": arguments("/scm/forward-kinematics", CHAIN),
    "scm_inverse_transform": arguments("/scm/inverse-transform", CHAIN),
    "scm_jacobian": arguments("/scm/jacobian", CHAIN),
    "scm_inverse_kinematics": arguments("/scm/inverse-kinematics", CHAIN, "target"),
    "scm_random_configuration": arguments("/scm/random-configuration", CHAIN),
    "scm_products": arguments("/scm/products", "products"),
    "robots": ((), {}),
    "robot": (("puma560",), {"language": "es"}),
    "exercises": ((), {"language": "ro"}),
    "exercise": (("twolink",), {"seed": "ada"}),
    "figure": (("twolink",), {"seed": "ada"}),
    "scorm_package": (("twolink",), {"version": "2004", "per_student": True, "passing": 0.5}),
    "grade": ((TABLE, TABLE), {"help": "row"}),
    "grade_all": ((TABLE, [TABLE, {}]), {}),
    "grade_exercise": (("twolink", {"table": TABLE}), {"language": "fr"}),
    "receipt": (("twolink", {"table": TABLE}, "Ada"), {}),
    "verify_receipts": ((["eyJ.x.y"],), {}),
    "receipt_keys": ((), {}),
    "check_inverse_kinematics": arguments("/check-inverse-kinematics", ROBOT, "target"),
    "post": (("understand",), {"table": TABLE}),
    "get": (("exercises/twolink",), {"seed": "ada", "lang": "uk"}),
    "problem": (("cell_incomplete",), {}),
    "check_jacobian": arguments("/check-jacobian", ROBOT, "joints", "jacobian"),
    "check_jacobian_form": arguments("/check-jacobian-form", ROBOT, "jacobian"),
    "check_singularities": arguments("/check-singularities", ROBOT, "conditions"),
    "check_dynamics": arguments("/check-dynamics", ROBOT),
    "check_screws": arguments("/check-screws", ROBOT, "screws", "home"),
    "trees": arguments("/trees", "tree"),
    "compare_tables": arguments("/compare-tables", "first", "second"),
    "other_tables": arguments("/other-tables", "table"),
    "plant_mistake": arguments("/plant-mistake", "table", "seed"),
    "plant_matrix_mistake": arguments("/plant-matrix-mistake", "table", "seed"),
    "plant_frame_mistake": arguments("/plant-frame-mistake", "axes", "convention", "seed"),
    "signed_link": (("twolink",), {"help": "row"}),
    "receipt_page": (("twolink", {"table": TABLE}, "Ada"), {}),
    "author_start": arguments("/author/start", "id", "source"),
    "author_import": arguments("/author/import", "archive"),
    "author_preview": arguments("/author/preview", "draft"),
    "author_check": arguments("/author/check", "draft"),
    "author_right_answers": arguments("/author/right-answers", "draft"),
    "author_mistakes": arguments("/author/mistakes", "draft"),
    "author_grade": arguments("/author/grade", "draft", "answer"),
    "author_folder": arguments("/author/folder.zip", "draft"),
}
CHANGING = {"receipt", "receipt_page", "scm_random_configuration", "signed_link"}
"""Answers that tell the time, or are drawn."""


def test_every_operation_has_a_call() -> None:
    described = {
        match.groups()
        for function in CALLS.values()
        for match in re.finditer(r"\((GET|POST) (/\S+)\)", function.__doc__ or "")
    }
    offered = {
        (method.upper(), path.removeprefix("/api/v1"))
        for path, operations in DOCUMENT["paths"].items()
        if path.startswith("/api/v1/")
        for method in operations
    }
    assert described == offered


def test_both_clients_have_every_call_typed() -> None:
    assert set(EVERY) == set(CALLS)
    for kind in (Client, AsyncClient):
        for name, function in CALLS.items():
            assert inspect.getdoc(getattr(kind, name)) == inspect.getdoc(function)
    for function in CALLS.values():
        signature = inspect.signature(function)
        assert all(
            parameter.annotation is not inspect.Parameter.empty
            for name, parameter in signature.parameters.items()
            if name != "self"
        )


@pytest.mark.parametrize("name", list(EVERY))
def test_both_clients_get_the_same_answer(base_url: str, name: str) -> None:
    positional, named = EVERY[name]
    with Client(base_url, timeout=120) as client:
        answer = getattr(client, name)(*positional, **named)

    async def ask() -> Any:
        async with AsyncClient(base_url, timeout=120) as later:
            return await getattr(later, name)(*positional, **named)

    again = asyncio.run(ask())
    assert type(answer) is type(again)
    assert answer
    if name not in CHANGING:
        assert answer == again


def test_verdicts_come_one_by_one(base_url: str) -> None:
    with Client(base_url, timeout=120) as client:
        each = list(client.grade_each(TABLE, [TABLE, {}, TABLE]))
        whole = client.grade_all(TABLE, [TABLE, {}, TABLE])["verdicts"]
        assert json.dumps(each) == json.dumps(whole)
        with pytest.raises(ProblemError) as refused:
            list(client.grade_each({}, [TABLE]))
        assert refused.value.status == 422

    async def ask() -> list[Any]:
        async with AsyncClient(base_url, timeout=120) as later:
            return [verdict async for verdict in later.grade_each(TABLE, [TABLE, {}, TABLE])]

    assert asyncio.run(ask()) == each


def test_numbers_may_be_numpys(base_url: str) -> None:
    joints = np.linspace(0.0, 1.0, 2)
    lengths = {name: np.float32(value) for name, value in LENGTHS.items()}
    with Client(base_url, timeout=120) as client:
        plain = client.forward_kinematics(TABLE, joints.tolist(), parameters=LENGTHS)
        assert client.forward_kinematics(TABLE, joints, parameters=lengths) == plain
        pose = np.array(plain["transform"])
        found = client.inverse_kinematics(TABLE, pose, parameters=LENGTHS, start=joints)
        assert np.allclose(found["solutions"][0]["joints"], joints)
        with pytest.raises(TypeError, match="complex"):
            client.forward_kinematics(TABLE, [0, 1j], parameters=LENGTHS)


def test_a_table_is_understood_as_an_exercise_does(base_url: str) -> None:
    with Client(base_url, timeout=120) as client:
        told = client.understand({**TABLE, "rows": [{**ROWS[0], "a": "L9"}]}, exercise="twolink")
    assert "name_unknown" in json.dumps(told)


def test_a_name_is_no_path(base_url: str) -> None:
    with Client(base_url, timeout=120) as client:
        for name in ("../../readyz", "twolink/grade", "twolink?x=1", ""):
            with pytest.raises(ProblemError) as refused:
                client.exercise(name)
            assert refused.value.status in (404, 405)
