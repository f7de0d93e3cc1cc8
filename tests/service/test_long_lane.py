"""A long lane shortens explanations, and changes nothing else."""

from __future__ import annotations

from pathlib import Path

import httpx
import pytest

from courses.model import Role
from courses.people.enrolment import Arrival, arrive
from courses.storage.database import open_store
from courses.storage.records import finding
from service.course_resources import now
from service.resources import Resources
from service.settings import Settings
from tests.courses.classroom import platform
from tests.live_service import running
from tests.web.driving import PUMA, wrong

RIGHT = {**PUMA, "angle_unit": "deg"}
WRONG = wrong(RIGHT, 3, a="a2")


WAITING = "service.work.fair_queue.FairQueue.waiting"
PATH = "/api/v1/exercises/puma560/grade"


def test_a_wrong_answer_has_the_same_score_and_is_told_its_rows(
    client: httpx.Client, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked, right = {"table": WRONG, "help": "repair"}, {"table": RIGHT}
    full, accepted = (client.post(PATH, json=body).json() for body in (asked, right))
    monkeypatch.setattr(WAITING, 65)
    short = client.post(PATH, json=asked).json()
    assert (full["help"], short["help"]) == ("repair", "row")
    assert full["repairs"]
    assert (short["repairs"], short["departure"]) == ([], None)
    for name in ("correct", "score", "total", "basis", "version"):
        assert short[name] == full[name]
    under_load = client.post(PATH, json=right).json()
    assert under_load["score"] == 1.0
    assert under_load["certificate"] == accepted["certificate"]


def test_statistics_know_the_mistake_all_the_same_and_so_does_the_student_later(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(WAITING, 65)
    store = open_store("", tmp_path)
    told = {"deployment": "1", "context": "c", "resource": "r", "exercise_id": "puma560"}
    token, _ = arrive(store, Arrival(platform=platform(store), subject="s", role=Role.LEARNER, **told), now())
    signed_in = {"Authorization": f"Bearer {token}"}
    with (
        running(Settings(storage="on", data_folder=tmp_path)) as origin,
        httpx.Client(base_url=f"{origin}/api/v1/", headers=signed_in, timeout=120, trust_env=False) as client,
    ):
        answer = client.post("session/attempts", json={"table": WRONG})
        again = client.get("session/attempts/1").json()["report"]
    assert answer.json()["help"] == "row"
    assert again["help"] == "repair"
    assert again["repairs"]
    assert again["score"] == answer.json()["score"]
    with store.reading() as connection:
        kinds = {row.kind for row in connection.execute(finding.select())}
    store.close()
    assert "repair" in kinds


def test_it_depends_on_how_many_wait(monkeypatch: pytest.MonkeyPatch) -> None:
    resources = Resources(Settings(storage="off", explained_queue=3))
    try:
        for waiting, told in ((3, None), (4, "row")):
            monkeypatch.setattr(WAITING, waiting)
            assert resources.help_now(None) == told
    finally:
        resources.close()
