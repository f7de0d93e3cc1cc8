"""Several services on one PostgreSQL: a launch goes from one to another, and no score is sent twice.

`REPLICAS=4 python -m pytest tests/lti/test_replicas.py` starts so many; the suite starts two.
"""

import contextlib
import json
import os
import threading
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest

from courses.storage.database import open_store
from tests.architecture.serving import reserved_port
from tests.databases import new_database
from tests.lti.classes import PATIENT_SERVICE, Browser, Lms, eventually, hint
from tests.lti.test_killed import killed
from tests.lti.test_launches import RIGHT, WRONG

REPLICAS = int(os.environ.get("REPLICAS", "2"))
STUDENTS = 8
ROUNDS = 3
CUSTOM = {"exercise": "puma560", "settings": json.dumps({"points": 10, "parts": ["table"]})}


@pytest.fixture(scope="module")
def replicas(postgresql: str, lms: Lms, tmp_path_factory: pytest.TempPathFactory) -> Iterator[list[str]]:
    """Services in processes of their own, with nothing in common but the database and the secret."""
    with contextlib.ExitStack() as stack:
        url = stack.enter_context(new_database(postgresql))
        store = open_store(url, Path())
        lms.register(store)
        store.close()
        port = stack.enter_context(reserved_port())
        public = f"http://127.0.0.1:{port}"
        told = {
            "FRAMEWISE_LTI_TRUSTED_ORIGINS": lms.root,
            "FRAMEWISE_PUBLIC_URL": public,
            "FRAMEWISE_QUEUE_SECONDS": "300",
        }
        origins = [
            stack.enter_context(
                killed(url, tmp_path_factory.mktemp("replica"), told, number, PATIENT_SERVICE)
            )[0]
            for number in (port, *[0] * (REPLICAS - 1))
        ]
        lms.control(tool=public)
        yield origins


class Student:
    """A browser behind a proxy that asks another replica each time."""

    def __init__(self, lms: Lms, replicas: list[str], first: int) -> None:
        self._replicas, self._next = replicas, first
        self.browser = Browser(lms, replicas[0])
        self.asked: list[str] = []

    def elsewhere(self) -> None:
        self._next = (self._next + 1) % len(self._replicas)
        self.browser.service = self._replicas[self._next]
        self.asked.append(self.browser.service)

    def login(self, user: str, link: str) -> None:
        """Every step of a launch on another replica."""
        lms = self.browser.lms
        started = lms.client.get(f"{lms.root}/start", params={"user": user, "hint": link})
        self.elsewhere()
        address = started.headers["location"].replace(self._replicas[0], self.browser.service)
        login = self.browser._checked(self.browser.client.get(address))
        form = self.browser.authorized(login)
        self.elsewhere()
        launched = self.browser.post(form)
        assert launched.status_code == 303, launched.text
        code = launched.headers["location"].partition("#session=")[2]
        self.elsewhere()
        self.browser.token = self.browser.api("POST", "session/open", {"code": code}).json()["token"]

    def submit(self, answer: object, key: str) -> dict[str, object]:
        self.elsewhere()
        found = self.browser.api("POST", "session/attempts", answer, **{"Idempotency-Key": key})
        assert found.status_code == 200, found.text
        told: dict[str, object] = found.json()
        return told


def test_a_class_on_several_replicas(replicas: list[str], lms: Lms) -> None:
    begun = time.perf_counter()
    students = [Student(lms, replicas, n) for n in range(STUDENTS)]
    failed: list[BaseException] = []

    def work(n: int, student: Student) -> None:
        try:
            student.login(f"r-{n}", hint(resource="replicas", context="replicas", custom=CUSTOM))
            for number in range(ROUNDS):
                first = student.submit(WRONG if number else RIGHT, f"key-{number}")
                again = student.submit(WRONG if number else RIGHT, f"key-{number}")
                assert first == again
                assert first["attempt"] == number + 1
        except BaseException as error:
            failed.append(error)

    threads = [threading.Thread(target=work, args=(n, student)) for n, student in enumerate(students)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for student in students:
        student.browser.client.close()
    assert failed == []
    assert all(set(student.asked) == set(replicas) for student in students)
    seconds = time.perf_counter() - begun
    print(f"{REPLICAS} replicas: {2 * STUDENTS * ROUNDS / seconds:.0f} submissions/s with launches")
    assert eventually(lambda: all(lms.result(f"r-{n}", "replicas") for n in range(STUDENTS)), timeout=120)
    time.sleep(2.5)  # a sender looks at the outbox every second: what would be sent twice would be by now
    state = lms.state()
    sent = Counter(entry["user"] for entry in state["scores"] if entry["resource"] == "replicas")
    assert sent == Counter({f"r-{n}": 1 for n in range(STUDENTS)})
    assert state["refused"] == []


def test_each_replica_believes_the_others_sessions_and_their_end(replicas: list[str], lms: Lms) -> None:
    student = Student(lms, replicas, 0)
    student.login("leaver", hint(resource="replicas", context="replicas", custom=CUSTOM))
    student.elsewhere()
    assert student.browser.api("POST", "session/close").status_code == 204
    for _ in replicas:
        student.elsewhere()
        assert student.browser.api("GET", "session").status_code == 401
    student.browser.client.close()
