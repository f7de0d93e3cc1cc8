"""Platforms on a page for the administrator; names in the class, and previews, for lecturers."""

import json
from collections.abc import Iterator
from dataclasses import replace
from datetime import timedelta

import httpx
import pytest

from courses.model import Course, PlatformStatus
from courses.people.administration import invite_administrator
from courses.people.platforms import add_platform, platforms
from courses.storage.database import Store
from service.course_resources import CourseResources, now
from service.settings import Settings
from tests.lti.classes import LEARNER, TEACHER, TEST_USER, Browser, Lms, hint
from tests.lti.test_launches import RIGHT, WRONG

ADDRESSES = {
    "issuer": "https://lms.example.edu",
    "client_id": "framewise",
    "authorization_endpoint": "https://lms.example.edu/auth",
    "token_endpoint": "https://lms.example.edu/token",
    "jwks_uri": "https://lms.example.edu/jwks",
}


@pytest.fixture
def administrator(service: str, store: Store) -> Iterator[httpx.Client]:
    with httpx.Client(base_url=f"{service}/api/v1/administration/", timeout=120, trust_env=False) as client:
        code = invite_administrator(store, now())
        client.headers["Authorization"] = f"Bearer {client.post('open', json={'code': code}).json()['token']}"
        again = client.post("open", json={"code": code})
        assert (again.status_code, again.json()["code"]) == (401, "code_used")
        yield client


def test_only_the_administrator_sees_and_changes_platforms(
    administrator: httpx.Client, browser: Browser, store: Store
) -> None:
    browser.launch("tina", hint([TEACHER], resource="admin"))
    for token in ("none", "made-up", browser.token, invite_administrator(store, now() - timedelta(hours=3))):
        headers = {"Authorization": f"Bearer {token}"}
        for method, path in (
            ("GET", "platforms"),
            ("POST", "platforms"),
            ("PUT", "platforms/1"),
            ("DELETE", "platforms/1"),
            ("POST", "invitations"),
        ):
            body = None if method in ("GET", "DELETE") else {**ADDRESSES, "status": "disabled"}
            answer = administrator.request(method, path, json=body, headers=headers)
            assert (answer.status_code, answer.json()["code"]) == (401, "administrator_unknown")
    assert platforms(store)[0].status is PlatformStatus.ACTIVE


def test_a_platform_is_registered_by_hand_and_switched_off(administrator: httpx.Client) -> None:
    made = administrator.post("platforms", json={**ADDRESSES, "deployment": "1", "name": "Ours"})
    assert made.status_code == 201
    number = made.json()["id"]

    def found() -> dict[str, object]:
        told = administrator.get("platforms").json()["platforms"]
        return next(each for each in told if each["id"] == number)

    assert (found()["status"], found()["deployments"], found()["names_shared"]) == ("active", ["1"], False)
    assert administrator.put(f"platforms/{number}", json={"status": "disabled"}).status_code == 204
    assert administrator.put(f"platforms/{number}", json={"deployment": "2"}).status_code == 204
    assert (found()["status"], found()["deployments"]) == ("disabled", ["1", "2"])
    slips = (
        {"jwks_uri": "javascript:alert(1)"},
        {"jwks_uri": "https://a;b/"},
        {"issuer": "x"},
        {"client_id": 5},
    )
    for wrong in slips:
        answer = administrator.post("platforms", json={**ADDRESSES, **wrong})
        assert (answer.status_code, answer.json()["code"]) == (422, "setting_invalid")
    assert administrator.put(f"platforms/{number}", json={"status": "mad"}).status_code == 422
    assert administrator.delete(f"platforms/{number}").status_code == 204
    assert administrator.delete(f"platforms/{number}").status_code == 404
    assert administrator.put(f"platforms/{number}", json={"deployment": "2"}).status_code == 404


def test_a_platform_that_is_changed_on_the_page_keeps_its_further_origins(
    administrator: httpx.Client, store: Store
) -> None:
    """The page does not know them; without them the platform's frames stay empty."""
    number = administrator.post("platforms", json=ADDRESSES).json()["id"]
    (made,) = (each for each in platforms(store) if each.id == number)
    add_platform(store, replace(made, origins=("https://canvas.example.edu",)), (), now())
    changed = administrator.post("platforms", json={**ADDRESSES, "names_shared": True}).json()
    assert (changed["id"], changed["names_shared"]) == (number, True)
    assert changed["origins"] == ["https://canvas.example.edu"]
    assert administrator.delete(f"platforms/{number}").status_code == 204


def test_an_invitation_made_on_the_page_registers_a_platform(administrator: httpx.Client, lms: Lms) -> None:
    address = administrator.post("invitations", json={"note": "Moodle of the faculty"}).json()["address"]
    told = administrator.get("platforms").json()["invitations"][0]
    assert (told["note"], told["open"]) == ("Moodle of the faculty", True)
    (own,) = (
        each for each in administrator.get("platforms").json()["platforms"] if each["issuer"] == lms.root
    )
    administrator.put(f"platforms/{own['id']}", json={"status": "pending"})  # else it stays active
    asked = {"openid_configuration": f"{lms.root}/openid", "registration_token": "once"}
    assert 'data-step="close"' in httpx.get(address, params=asked, timeout=120, trust_env=False).text
    state = administrator.get("platforms").json()
    assert state["invitations"][0]["used"]
    (pending,) = (each for each in state["platforms"] if each["issuer"] == lms.root)
    assert pending["status"] == "pending"
    administrator.put(f"platforms/{pending['id']}", json={"status": "active"})


def test_a_lecturer_is_told_what_to_send(service: str) -> None:
    for language in ("en", "uk"):
        page = httpx.get(f"{service}/lti/connect?lang={language}", timeout=120, trust_env=False)
        assert page.status_code == 200
        for path in ("login", "launch", "jwks", "configuration"):
            assert f"{service}/lti/{path}" in page.text


def test_names_come_from_the_platform_where_the_operator_lets_them(
    browser: Browser, lms: Lms, store: Store, service: str
) -> None:
    link = {"resource": "names", "context": "names", "custom": {"exercise": "puma560"}}
    browser.launch("student", hint(**link))
    teacher = Browser(lms, service)
    teacher.launch("tina", hint([TEACHER], **link))
    before = teacher.api("GET", "course").json()
    assert (before["course"]["members"], len(before["students"])) == (False, 1)
    own = next(each for each in platforms(store) if each.issuer == lms.root)
    add_platform(store, replace(own, names_shared=True), (), now())
    try:
        found = teacher.api("GET", "course").json()
        late = next(each["key"] for each in found["students"] if not each["links"])
        allowed = {"person": late, "extra_minutes": 30}
        path = f"course/links/{found['link']}/allowances"
        assert teacher.api("POST", path, allowed).status_code == 204
        assert teacher.api("POST", path, {**allowed, "person": "f" * 32}).status_code == 404
        again = teacher.api("GET", "course").json()
    finally:
        add_platform(store, replace(own, names_shared=False), (), now())
    teacher.client.close()
    (told,) = next(each for each in again["students"] if each["key"] == late)["links"].values()
    assert (told["state"], told["extra_seconds"]) == ("absent", 1800)
    assert found["course"]["members"] is True
    states = sorted(
        next(iter(each["links"].values()), {}).get("state", "absent") for each in found["students"]
    )
    assert states == ["absent", "opened"]
    (counted,) = found["links"]
    assert (counted["absent"], counted["opened"]) == (1, 1)


def test_a_course_with_the_number_of_an_erased_one_has_a_class_of_its_own(
    settings: Settings, store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    """SQLite gives the number of the last course again, and class lists are known for minutes."""
    resources = CourseResources(settings)
    own = platforms(store)[0]
    add_platform(store, replace(own, names_shared=True), (), now())
    monkeypatch.setattr(resources, "_asked_members", lambda _, address: {address: None})
    try:
        found = [
            resources.class_members(Course(id=1, platform_id=own.id, title="", memberships_url=address))
            for address in ("https://lms/1", "https://lms/2")
        ]
    finally:
        add_platform(store, own, (), now())
        resources.close()
    assert found == [{"https://lms/1": None}, {"https://lms/2": None}]


def test_a_test_user_of_the_platform_stands_in_no_number(browser: Browser, lms: Lms, service: str) -> None:
    """Canvas's Test Student counted as one of the class."""
    where = {"resource": "tried", "context": "tried", "custom": {"exercise": "puma560"}}
    browser.launch("ann", hint(**where))
    browser.api("POST", "session/attempts", RIGHT)
    tester, teacher = Browser(lms, service), Browser(lms, service)
    tester.launch("test student", hint([LEARNER, TEST_USER], **where))
    answer = tester.api("POST", "session/attempts", WRONG)
    assert (answer.status_code, answer.json()["attempt"]) == (200, 1)
    assert tester.api("GET", "session").json()["role"] == "learner"
    assert tester.api("GET", "course").json()["code"] == "staff_only"
    teacher.launch("tina", hint([TEACHER], **where))
    found = teacher.api("GET", "course").json()
    numbers = teacher.api("GET", f"course/links/{found['link']}/statistics").json()
    assert len(found["students"]) == 1
    assert (numbers["attempts"], numbers["students"]) == (1, 1)
    tester.client.close()
    teacher.client.close()


def test_a_preview_follows_the_rules_and_counts_for_nothing(browser: Browser, lms: Lms, service: str) -> None:
    rules = {"points": 10, "attempts": 2, "parts": ["table"], "per_student": True, "help": "verdict"}
    custom = {"exercise": "puma560", "settings": json.dumps(rules)}
    where = {"resource": "preview", "context": "preview", "custom": custom}
    browser.launch("ann", hint(**where))
    browser.api("POST", "session/attempts", WRONG)
    teacher = Browser(lms, service)
    teacher.launch("tina", hint([TEACHER], **where))
    link = teacher.api("GET", "course").json()["link"]
    for _ in range(2):
        preview = teacher.api("POST", f"course/links/{link}/preview", {}).json()
        assert preview["exercise"] == "puma560"
        student = Browser(lms, service)
        student.token = student.api("POST", "session/open", {"code": preview["code"]}).json()["token"]
        told = student.api("GET", "session").json()
        assert (told["role"], told["attempts_allowed"], told["attempts_made"]) == ("learner", 2, 0)
        assert told["seed"]
        assert student.api("GET", "course").json()["code"] == "staff_only"
        answers = [student.api("POST", "session/attempts", each) for each in (WRONG, WRONG, RIGHT)]
        assert [answer.status_code for answer in answers] == [200, 200, 409]
        assert answers[0].json()["help"] == "verdict"
        student.client.close()
    numbers = teacher.api("GET", f"course/links/{link}/statistics").json()
    assert (numbers["attempts"], numbers["students"]) == (1, 1)
    assert len(teacher.api("GET", f"course/links/{link}/attempts").json()["attempts"]) == 1
    assert len(teacher.api("GET", "course").json()["students"]) == 1
    (day,) = numbers["days"]
    for asked, count in ((f"day={day['day']}", 1), ("day=2001-01-01", 0), ("number=1", 1), ("number=2", 0)):
        found = teacher.api("GET", f"course/links/{link}/attempts?{asked}").json()["attempts"]
        assert len(found) == count
    assert teacher.api("GET", f"course/links/{link}/attempts?day=today").status_code == 422
    teacher.client.close()
    assert {entry["user"] for entry in lms.state()["scores"] if entry["resource"] == "preview"} <= {"ann"}
