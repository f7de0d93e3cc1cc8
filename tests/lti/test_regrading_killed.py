"""`kill -9` in the middle of a regrading: the same request goes on where it was.

On PostgreSQL; `make kill-campaign` has it on SQLite, too.
"""

import os
import signal
import threading
from dataclasses import replace
from pathlib import Path

import httpx
import pytest
import sqlalchemy as sa

from courses.model import LinkSettings, Role
from courses.people.enrolment import arrive
from courses.storage import records
from courses.storage.database import Store, open_store
from exercises.library import packaged
from kinematics.cells import DEFAULT
from service.course_resources import now
from service.work.session_grading import Grader
from tests.courses.classroom import arrival
from tests.lti.classes import PATIENT_SERVICE, eventually
from tests.lti.measuring import filled
from tests.lti.test_killed import killed

DATABASES = ["postgresql", *(["sqlite"] if os.environ.get("KILLS") else [])]
STUDENTS, ATTEMPTS = 12, 4
BATCH = 8
"""Attempts of one transaction, fewer than usual, so that a small class has several."""
HALFWAY = f"""
import itertools, time
from courses.storage import engines
from courses.teaching import regrading
from service.__main__ import main

look, looks = regrading._waiting, itertools.count()

def waiting(*told):
    if next(looks) * {BATCH} >= {STUDENTS * ATTEMPTS // 2}:
        time.sleep(600)
    return look(*told)

engines.CONNECT_SECONDS = 120
regrading.BATCH, regrading._waiting = {BATCH}, waiting
main()
"""
"""A service that does not get beyond half of the class, however late it is killed."""


def teacher(store: Store) -> str:
    """Token of a teacher of the course."""
    told = replace(arrival(store, "tina"), role=Role.STAFF, context="c", resource="r")
    return arrive(store, told, now())[0]


def judged_so_far(store: Store) -> int:
    with store.reading() as connection:
        return connection.scalar(sa.select(sa.func.count()).select_from(records.regraded)) or 0


def regraded(origin: str, link: int, token: str) -> httpx.Response:
    path = f"{origin}/api/v1/course/links/{link}/regradings"
    headers = {"Authorization": f"Bearer {token}"}
    return httpx.post(path, json={"scope": "all"}, headers=headers, timeout=300, trust_env=False)


@pytest.mark.parametrize("database", DATABASES, indirect=True)
def test_a_regrading_that_was_killed_goes_on(database: str, tmp_path: Path) -> None:
    store = open_store(database, tmp_path)
    grader = Grader(library=packaged(), limits=DEFAULT)
    link = filled(store, grader, STUDENTS, ATTEMPTS, different=True).link
    with store.reading() as connection:
        count = connection.scalar(sa.select(sa.func.count()).select_from(records.attempt)) or 0
    token = teacher(store)

    def ask(origin: str) -> None:
        with pytest.raises(httpx.HTTPError):
            regraded(origin, link.id, token)

    with killed(database, tmp_path, program=("-c", HALFWAY)) as (origin, process):
        asking = threading.Thread(target=ask, args=(origin,))
        asking.start()
        assert eventually(lambda: judged_so_far(store) >= BATCH, timeout=240)
        process.send_signal(signal.SIGKILL)
        asking.join()
    before = judged_so_far(store)
    assert BATCH <= before < count
    with killed(database, tmp_path, program=PATIENT_SERVICE) as (origin, _):
        found = regraded(origin, link.id, token).json()
        assert judged_so_far(store) == count
        applied = httpx.post(
            f"{origin}/api/v1/course/links/{link.id}/regradings/{found['run']}/apply",
            json={},
            headers={"Authorization": f"Bearer {token}"},
            timeout=300,
            trust_env=False,
        )
        assert applied.status_code == 204
    with store.reading() as connection:
        runs = connection.scalar(sa.select(sa.func.count()).select_from(records.regrading))
        twice = sa.select(records.regraded.c.attempt_id).group_by(records.regraded.c.attempt_id)
        assert connection.execute(twice.having(sa.func.count() > 1)).all() == []
        scores = dict(
            connection.execute(sa.select(records.regraded.c.attempt_id, records.regraded.c.score)).all()
        )
        attempts = {row.id: row for row in connection.execute(sa.select(records.attempt))}
    store.close()
    assert runs == 1
    changed = {entry["id"]: entry["after"] for entry in found["changes"]}
    assert changed == {number: score for number, score in scores.items() if score != attempts[number].score}
    own = LinkSettings(exercise_id="puma560")
    for number in list(scores)[:: len(scores) // 12]:
        assert grader.judge(own, None, _wire(attempts[number].answer), 1).score == scores[number]


def _wire(answer: object) -> object:
    from service.schemas.exercises.exercises import ExerciseAnswer

    return ExerciseAnswer.model_validate(answer)
