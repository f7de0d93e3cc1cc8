"""Many submissions judged by one key."""

import asyncio
import json
from typing import Any

import httpx
import pytest

from framewise import AsyncClient, Client, ProblemError

KEY = {
    "convention": "standard",
    "angle_unit": "deg",
    "rows": [{"alpha": 0, "a": "L1", "d": 0, "theta": "q1"}],
}
RIGHT = {**KEY, "convention": "modified"}
SECOND = {"alpha": 90, "a": "L1", "d": 0, "theta": "q2"}
WRONG = {**KEY, "rows": [*KEY["rows"], SECOND]}
BROKEN = {**KEY, "rows": [{"alpha": 0, "a": "(", "d": 0, "theta": "q1"}]}
SUBMISSIONS: list[Any] = [KEY, WRONG, BROKEN, {}, RIGHT]


def test_in_their_order_as_one_document(client: httpx.Client) -> None:
    body = {"reference": KEY, "submissions": SUBMISSIONS}
    response = client.post("/api/v1/grade", json=body)
    assert response.status_code == 200, response.text
    found = response.json()["verdicts"]
    assert [entry.get("correct") for entry in found[:2]] == [True, False]
    assert found[2]["pointer"] == "/submissions/2/rows/0/a"
    assert found[2]["attempt_counted"] is False
    assert found[3]["pointer"].startswith("/submissions/3")
    single = client.post("/api/v1/grade", json={"reference": KEY, "submission": WRONG}).json()
    assert found[1] == single


def test_line_by_line(client: httpx.Client) -> None:
    body = {"reference": KEY, "submissions": SUBMISSIONS}
    headers = {"Accept": "application/x-ndjson"}
    with client.stream("POST", "/api/v1/grade", json=body, headers=headers) as response:
        assert response.headers["content-type"].startswith("application/x-ndjson")
        lines = [json.loads(line) for line in response.iter_lines() if line]
    assert lines == client.post("/api/v1/grade", json=body).json()["verdicts"]


@pytest.mark.parametrize(
    ("body", "pointer"),
    [
        ({"reference": KEY, "submissions": []}, "/submissions"),
        ({"reference": KEY, "submissions": [KEY] * 1001}, "/submissions"),
        ({"reference": BROKEN, "submissions": [KEY]}, "/reference/rows/0/a"),
        ({"reference": KEY, "submissions": [KEY], "submission": KEY}, "/submission"),
    ],
)
def test_what_is_wrong_with_the_request_is_refused_as_a_whole(
    client: httpx.Client, body: dict[str, Any], pointer: str
) -> None:
    response = client.post("/api/v1/grade", json=body)
    assert response.status_code == 422
    assert response.json()["pointer"] == pointer


def test_the_client(base_url: str) -> None:
    with Client(base_url, language="fr") as client:
        assert client.grade_all(KEY, [RIGHT])["verdicts"][0]["correct"] is not None
        assert client.grade(KEY, KEY)["correct"]
        assert client.forward_kinematics("puma560", [0] * 6, parts=["transform"])["transform"]
        assert client.jacobian("puma560", [10, 20, 30, 40, 50, 60])
        assert client.symbolic(KEY, formats=["text"], parts=["transform"])
        assert "puma560" in {entry["id"] for entry in client.exercises()["exercises"]}
        assert client.exercise("twolink", seed="s")["seed"] == "s"
        pose = client.forward_kinematics("puma560", [10, 20, 30, 40, 50, 60], parts=["transform"])[
            "transform"
        ]
        assert client.inverse_kinematics("puma560", pose)["solutions"]
        answer = {"table": {**KEY, "rows": [KEY["rows"][0], {**KEY["rows"][0], "a": "L2", "theta": "q2"}]}}
        assert client.grade_exercise("twolink", answer)["parts"]
        assert not client.verify_receipts(["x"])["receipts"][0]["valid"]
        assert client.robots()
        with pytest.raises(ProblemError) as refused:
            client.grade(BROKEN, KEY)
        assert (refused.value.status, refused.value.document["status"]) == (422, 422)


def test_the_client_that_does_not_wait(base_url: str) -> None:
    async def several() -> list[bool]:
        async with AsyncClient(base_url) as client:
            answers = await asyncio.gather(*(client.grade(KEY, KEY) for _ in range(3)))
            return [answer["correct"] for answer in answers]

    assert asyncio.run(several()) == [True] * 3
