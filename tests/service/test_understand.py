"""POST /understand with an exercise: the names that it knows, and those that it does not."""

from typing import Any

import httpx
import pytest

from tests.service.test_bad_input import check_problem

PATH = "/api/v1/understand"


def table(**cells: Any) -> dict[str, Any]:
    row = {"joint": "revolute", "alpha": 0, "a": 0, "d": 0, "theta": "q1", **cells}
    return {"convention": "modified", "angle_unit": "deg", "rows": [row]}


def faults(client: httpx.Client, body: dict[str, Any]) -> list[tuple[str, str]]:
    response = client.post(PATH, json=body)
    assert response.status_code == 200, response.text
    answer = response.json()
    assert answer["readable"] == (not answer["faults"])
    return [(fault["code"], fault["pointer"]) for fault in answer["faults"]]


@pytest.mark.parametrize("name", ["a2", "a_2", "2*a3 + a2"])
def test_names_of_the_exercise_are_no_fault(client: httpx.Client, name: str) -> None:
    assert faults(client, {"table": table(a=name), "exercise": "scara"}) == []


def test_a_name_that_it_does_not_know_is_a_fault_of_its_cell(client: httpx.Client) -> None:
    body = {"table": table(a="a9", d="x"), "exercise": "scara"}
    assert faults(client, body) == [
        ("name_unknown", "/table/rows/0/a"),
        ("name_unknown", "/table/rows/0/d"),
    ]
    assert faults(client, {"table": body["table"]}) == []


def test_what_cannot_be_read_is_said_beside_it(client: httpx.Client) -> None:
    body = {"table": table(a="a9", d="2*("), "exercise": "scara"}
    assert {place for _, place in faults(client, body)} == {"/table/rows/0/a", "/table/rows/0/d"}


def test_an_exercise_that_there_is_not(client: httpx.Client) -> None:
    response = client.post(PATH, json={"table": table(), "exercise": "nowhere"})
    check_problem(response, 422, "exercise_unknown", "/exercise")
