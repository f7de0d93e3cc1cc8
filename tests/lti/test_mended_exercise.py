"""An exercise is mended under its students: what they did stays what it was, and they are told."""

import shutil
from datetime import timedelta
from pathlib import Path
from typing import Any

import httpx
import pytest
from playwright.sync_api import Browser as Chromium
from playwright.sync_api import expect

from courses.model import Role
from courses.people.enrolment import arrive
from courses.people.secrets import issue_code
from courses.storage.database import open_store
from service.course_resources import now
from service.settings import Settings
from service.work.regrading_processes import FEW
from tests.courses.classroom import arrival
from tests.exercises.folders import TWO_LINKS, changed, folder, with_part
from tests.live_service import running
from tests.lti.test_in_a_browser import PATIENCE, chromium  # noqa: F401
from tests.lti.test_session_grading import WRONG
from tests.web.profiles import new_context

MENDED = changed("L1.value = 0.5", "L1.value = 0.6")


@pytest.fixture
def settings(tmp_path: Path) -> Settings:
    return Settings(storage="on", data_folder=tmp_path / "data", exercise_folders=(tmp_path / "own",))


def token(settings: Settings) -> str:
    """Of a student who has just come."""
    store = open_store("", settings.data_folder)
    found, _ = arrive(store, arrival(store, exercise_id="two"), now())
    store.close()
    return found


class Student:
    """Calls of a page."""

    def __init__(self, origin: str, settings: Settings) -> None:
        self.root, self.headers = f"{origin}/api/v1", {"Authorization": f"Bearer {token(settings)}"}

    def get(self, path: str) -> Any:
        return httpx.get(f"{self.root}/{path}", headers=self.headers, timeout=120, trust_env=False).json()

    def submit(self, body: dict[str, Any], key: str) -> httpx.Response:
        headers = {**self.headers, "Idempotency-Key": key}
        address = f"{self.root}/session/attempts"
        return httpx.post(address, json=body, headers=headers, timeout=120, trust_env=False)


def test_an_attempt_keeps_the_version_that_it_was_made_with(tmp_path: Path, settings: Settings) -> None:
    folder(tmp_path / "own", TWO_LINKS)
    with running(settings) as origin:
        student = Student(origin, settings)
        before = student.get("session")["version"]
        seen = student.submit({**WRONG, "version": before}, "one").json()
        assert seen["attempt"] == 1
    folder(tmp_path / "own", MENDED)
    with running(settings) as origin:
        student = Student(origin, settings)
        session = student.get("session")
        assert session["version"] != before == session["attempts"][0]["version"]
        late = student.submit({**WRONG, "version": before}, "two")
        assert (late.status_code, late.json()["code"]) == (409, "exercise_changed")
        repeated = student.submit({**WRONG, "version": before}, "one").json()
        assert repeated == seen
        assert student.get("session")["attempts_made"] == 1
        again = student.get("session/attempts/1")
        assert {**again["report"], "attempt": 1, "shown": again["shown"]} == seen
        values = [student.get(f"exercises/{name}")["parameters"]["L1"] for name in (again["version"], "two")]
        assert values == [0.5, 0.6]
        assert student.submit({**WRONG, "version": session["version"]}, "three").json()["attempt"] == 2


RENAMED = TWO_LINKS.replace("L1", "A1")
"""The same arm, whose first length has another name."""


class Teacher(Student):
    """Calls of the lecturers' page."""

    def __init__(self, origin: str, settings: Settings) -> None:
        super().__init__(origin, settings)
        store = open_store("", settings.data_folder)
        found, self.link = arrive(store, arrival(store, "tina", role=Role.STAFF), now())
        self.headers = {"Authorization": f"Bearer {found}"}
        store.close()

    def regraded(self) -> httpx.Response:
        """What regrading all attempts of the link would change."""
        path = f"{self.root}/course/links/{self.link}/regradings"
        return httpx.post(path, json={"scope": "all"}, headers=self.headers, timeout=120, trust_env=False)


@pytest.mark.parametrize("mended", [RENAMED, TWO_LINKS.replace('kind = "table"', 'kind = "transform"'), None])
def test_what_the_exercise_cannot_read_any_more_is_told_and_stays(
    tmp_path: Path, settings: Settings, mended: str | None
) -> None:
    """A dimension has another name, a part is not asked any more, or the exercise is gone."""
    folder(tmp_path / "own", TWO_LINKS)
    named = {"table": {**WRONG["table"], "rows": [{**WRONG["table"]["rows"][0], "a": "L1"}]}}
    with running(settings) as origin:
        student = Student(origin, settings)
        student.submit(named, "one")
    if mended is None:
        shutil.rmtree(tmp_path / "own" / "two")
    else:
        folder(tmp_path / "own", mended, statement="*L2*")
    with running(settings) as origin:
        teacher = Teacher(origin, settings)
        if mended is None:
            chosen = {"exercise": "scara"}
            path = f"{teacher.root}/course/links/{teacher.link}/settings"
            httpx.put(path, json=chosen, headers=teacher.headers, timeout=120, trust_env=False)
        told = teacher.regraded()
        assert told.status_code == 200
        assert (told.json()["changes"], len(told.json()["unread"])) == ([], 1)


def test_a_part_that_is_not_asked_any_more_is_left_out(tmp_path: Path, settings: Settings) -> None:
    both = with_part('kind = "transform"\npoints = 10')
    folder(tmp_path / "own", both)
    rows = [{"theta": f"q{i}", "d": "0", "a": f"L{i}", "alpha": "0"} for i in (1, 2)]
    with running(settings) as origin:
        right = {"table": {**WRONG["table"], "rows": rows}, "transform": [["1"] * 4] * 4}
        Student(origin, settings).submit(right, "one")
    folder(tmp_path / "own", TWO_LINKS)
    with running(settings) as origin:
        told = Teacher(origin, settings).regraded().json()
        assert [(entry["before"], entry["after"]) for entry in told["changes"]] == [(0.5, 1.0)]
        assert told["unread"] == []


def test_many_answers_are_judged_again_by_the_exercise_as_the_service_read_it(
    tmp_path: Path, settings: Settings
) -> None:
    """Processes read it anew: a folder that was changed under a running service judged half of a class."""
    folder(tmp_path / "own", TWO_LINKS)
    with running(settings) as origin:
        student = Student(origin, settings)
        for i in range(FEW + 1):
            row = {"theta": "q1", "d": str(i), "a": "L1", "alpha": "0"}
            given = {"table": {**WRONG["table"], "rows": [row, {**row, "theta": "q2", "a": "L2", "d": "0"}]}}
            assert student.submit(given, str(i)).json()["correct"]
        folder(tmp_path / "own", changed('a = "L1", alpha = 0', 'a = "L1", alpha = 90'))
        told = Teacher(origin, settings).regraded().json()
        assert (told["changes"], told["unread"]) == ([], [])


def test_the_page_says_so(tmp_path: Path, settings: Settings, chromium: Chromium) -> None:  # noqa: F811
    folder(tmp_path / "own", TWO_LINKS)
    with running(settings) as origin:
        form = {"table": {**WRONG["table"], "angleUnit": "deg", "lengthUnit": "m"}, "parts": {}}
        Student(origin, settings).submit({**WRONG, "form": form}, "one")
    folder(tmp_path / "own", MENDED)
    context = new_context(chromium, viewport={"width": 1280, "height": 1000}, locale="en")
    context.set_default_timeout(PATIENCE)
    page = context.new_page()
    with running(settings) as origin:
        store = open_store("", settings.data_folder)
        code = issue_code(store, "session", {"token": token(settings)}, now(), timedelta(minutes=5))
        page.goto(f"{origin}/exercises/two#session={code}")
        page.wait_for_selector("html[data-ready=true]")
        expect(page.locator(".session-banner")).to_contain_text("changed since an earlier attempt")
        page.locator("#history button").first.click()
        expect(page.locator("#verdict")).to_contain_text("the exercise as it was then")
        with context.expect_page() as opened:
            page.get_by_role("link", name="See the exercise as it was").click()
        expect(opened.value.locator("#givens")).to_contain_text("0.5")
        folder(tmp_path / "own", TWO_LINKS)
        store.close()
    context.close()
