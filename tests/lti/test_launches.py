"""From a link in a course to a mark in its gradebook, against a platform in its own process."""

import json
from collections.abc import Callable
from dataclasses import replace

import pytest

from courses.model import PlatformStatus
from courses.people.platforms import add_platform, invite, platforms, set_status
from courses.storage.database import Store, open_store
from service.course_resources import CourseResources, now
from service.lti.memberships import members
from service.settings import Settings
from tests.lti.classes import ADMINISTRATOR, TEACHER, Browser, Lms, eventually, hint
from tests.web.driving import PUMA

CUSTOM = {"exercise": "puma560", "settings": json.dumps({"points": 10, "attempts": 3, "parts": ["table"]})}
RIGHT = {"table": {"convention": "modified", "angle_unit": "deg", "length_unit": "m", "rows": PUMA["rows"]}}


def test_a_mark_arrives_in_the_gradebook(browser: Browser, lms: Lms) -> None:
    answer = browser.launch("ann", hint(custom=CUSTOM, resource="mark"))
    assert answer.status_code == 303
    assert browser.landed.endswith("/exercises/puma560")
    session = browser.api("GET", "session").json()
    assert (session["exercise"], session["points"], session["attempts_allowed"]) == ("puma560", 10, 3)
    graded = browser.api("POST", "session/attempts", RIGHT, **{"Idempotency-Key": "one"}).json()
    assert (graded["attempt"], graded["correct"]) == (1, True)
    assert eventually(lambda: lms.result("ann", "mark")) == pytest.approx(graded["total"]["score"])
    assert lms.state()["refused"] == []


def test_a_launch_ends_what_a_link_has_left_behind(browser: Browser) -> None:
    """The cookie of a link to another exercise refused the page that the launch leads to."""
    link = browser.api("POST", "exercises/scara/links", {"off": ["playground"]}).json()["context"]
    browser.cookies["framewise_context"] = link
    answer = browser.launch("ann", hint(custom=CUSTOM, resource="left"))
    assert answer.status_code == 303
    (forgotten,) = (field for field in answer.headers.get_list("set-cookie") if "framewise_context=" in field)
    assert forgotten.startswith("framewise_context=;")
    assert "Max-Age=0" in forgotten


WRONG = {"table": {**RIGHT["table"], "rows": [{**row, "alpha": "0"} for row in PUMA["rows"]]}}


def test_a_teacher_chooses_the_exercise_of_a_course_link_at_the_first_launch(
    browser: Browser, lms: Lms, another_browser: Callable[[], Browser]
) -> None:
    link = hint(resource="plain", context="course-2")
    early = browser.launch("ann", link)
    assert (early.status_code, early.json()["code"]) == (404, "link_without_exercise")
    teacher = another_browser()
    teacher.launch("tina", hint([ADMINISTRATOR], resource="plain", context="course-2"))
    assert teacher.landed.endswith("/course")
    found = teacher.api("GET", "course").json()
    path = f"course/links/{found['link']}"
    refused = teacher.api("PUT", f"{path}/settings", {"exercise": "puma560", "attempts": 0})
    assert refused.json()["code"] == "setting_invalid"
    slips = {"exercise": "puma560", "help": "hints", "parts": "table", "penalti": 0.1}
    told = teacher.api("PUT", f"{path}/settings", slips)
    assert [fault["pointer"] for fault in told.json()["errors"]] == ["/parts", "/help", "/penalti"]
    chosen = {"exercise": "puma560", "points": 5, "parts": ["table"], "counting": "last"}
    assert found["links"][0]["exercise_title"] is None
    assert teacher.api("PUT", f"{path}/settings", chosen).status_code == 200
    assert teacher.api("GET", "course").json()["links"][0]["exercise_title"] == "PUMA 560"
    assert browser.launch("ann", link).status_code == 303
    browser.api("POST", "session/attempts", RIGHT)
    browser.api("POST", "session/attempts", WRONG)
    wrong = browser.api("GET", "session").json()["attempts"][1]["score"]
    assert wrong < 1
    assert eventually(lambda: lms.result("ann", "plain") == pytest.approx(wrong))
    numbers = teacher.api("GET", f"{path}/statistics").json()
    assert (numbers["attempts"], numbers["first_attempt_rate"]) == (2, 1.0)
    assert numbers["misconceptions"] or numbers["unexplained"]
    csv = teacher.api("GET", f"{path}/export.csv").text
    assert len(csv.splitlines()) == 3
    opened = teacher.api("GET", f"{path}/attempts").json()["attempts"][0]["id"]
    assert teacher.api("GET", f"course/attempts/{opened}").json()["answer"] == WRONG
    student = browser.api("GET", "course")
    assert (student.status_code, student.json()["code"]) == (403, "staff_only")


def test_a_deep_link_brings_its_exercise_and_rules(browser: Browser, lms: Lms) -> None:
    learner = browser.launch("ann", hint(deep=True))
    assert (learner.status_code, learner.json()["code"]) == (403, "staff_only")
    answer = browser.launch("tina", hint([TEACHER], deep=True))
    choice = answer.headers["location"].partition("#choice=")[2]
    asked = {"choice": choice, "exercise": "puma560", "points": 7, "parts": ["table"], "per_student": True}
    made = browser.api("POST", "deep-links", asked)
    assert browser.api("POST", "deep-links", asked).json()["code"] == "code_used"
    found = made.json()
    assert lms.client.post(found["address"], data={"JWT": found["jwt"]}).status_code == 200
    returned = lms.state()["returned"][-1]
    (item,) = returned["items"]
    assert item["lineItem"]["scoreMaximum"] == 7
    assert item["custom"]["history"] == "$ResourceLink.id.history"
    assert returned["claims"]["https://purl.imsglobal.org/spec/lti-dl/claim/data"]
    browser.launch("ann", hint(resource="deep", custom=item["custom"]))
    session = browser.api("GET", "session").json()
    assert (session["exercise"], session["points"], session["parts"]) == ("puma560", 7, ["table"])
    assert session["seed"] == session["person"]["key"][:16]


def test_a_platform_that_was_switched_off_is_signed_no_choice(browser: Browser, store: Store) -> None:
    """Nor does anybody who was signed in by it see or do anything more."""
    browser.launch("tina", hint([TEACHER], resource="off", custom=CUSTOM))
    answer = browser.launch("tina", hint([TEACHER], deep=True))
    asked = {"choice": answer.headers["location"].partition("#choice=")[2], "exercise": "puma560"}
    (number,) = (each.id for each in platforms(store))
    set_status(store, number, PlatformStatus.DISABLED)
    try:
        choice, course = browser.api("POST", "deep-links", asked), browser.api("GET", "course")
    finally:
        set_status(store, number, PlatformStatus.ACTIVE)
    assert (choice.status_code, choice.json()["code"]) == (400, "lti_platform_inactive")
    assert (course.status_code, course.json()["code"]) == (401, "lti_platform_inactive")
    assert browser.api("GET", "course").status_code == 200


def test_a_copied_course_has_the_rules_of_the_one_it_was_copied_from(browser: Browser) -> None:
    """What a lecturer had changed since the link was made was lost with every term."""
    custom = {**CUSTOM, "history": "$ResourceLink.id.history"}
    browser.launch("tina", hint([TEACHER], resource="last, term", context="last", custom=custom))
    path = f"course/links/{browser.api('GET', 'course').json()['link']}/settings"
    assert browser.api("PUT", path, {"exercise": "scara", "points": 4, "attempts": 2}).status_code == 200
    copied = {"custom": {**CUSTOM, "history": "unseen%00,last%2C%20term"}, "context": "next"}
    browser.launch("ann", hint(resource="copied", **copied))
    session = browser.api("GET", "session").json()
    assert (session["exercise"], session["points"], session["attempts_allowed"]) == ("scara", 4, 2)
    browser.launch("ann", hint(resource="first", context="next", custom={**custom, "history": "unseen"}))
    assert browser.api("GET", "session").json()["exercise"] == "puma560"


def test_a_key_names_one_answer(browser: Browser) -> None:
    """Another answer under the same key was told the first one's verdict, and lost."""
    long = "k" * 120
    browser.launch("keys", hint(resource="keys", custom={"exercise": "puma560"}))
    for key, other in (("one", "two"), (long, f"{long}x")):
        first = browser.api("POST", "session/attempts", RIGHT, **{"Idempotency-Key": key})
        again = browser.api("POST", "session/attempts", RIGHT, **{"Idempotency-Key": key})
        assert "idempotency-replayed" not in first.headers
        assert (again.headers["idempotency-replayed"], again.json()["attempt"]) == (
            "true",
            first.json()["attempt"],
        )
        reused = browser.api("POST", "session/attempts", WRONG, **{"Idempotency-Key": key})
        assert (reused.status_code, reused.json()["code"]) == (422, "idempotency_key_reused")
        stored = browser.api("POST", "session/attempts", WRONG, **{"Idempotency-Key": other}).json()
        assert (stored["attempt"], stored["correct"]) == (first.json()["attempt"] + 1, False)


def test_a_platform_without_a_coupled_line_item_gets_one(browser: Browser, lms: Lms) -> None:
    link = hint(resource="uncoupled", coupled=False, custom=CUSTOM)
    for user in ("ann", "bob"):
        browser.launch(user, link)
        browser.api("POST", "session/attempts", RIGHT)
    assert eventually(lambda: lms.result("ann", "uncoupled") and lms.result("bob", "uncoupled"))
    assert lms.state()["refused"] == []


def test_a_platform_registers_itself_with_an_invitation(
    browser: Browser, lms: Lms, service: str, settings: Settings
) -> None:
    store = open_store(settings.database_url, settings.data_folder)
    own = next(each for each in platforms(store) if each.issuer == lms.root)
    add_platform(store, replace(own, jwks_uri=f"{own.jwks_uri}-before"), (), now())
    secret = invite(store, "for a test", now())
    asked = {"openid_configuration": f"{lms.root}/openid", "registration_token": "once"}
    stranger = browser.client.get(f"{service}/lti/register/guess", params=asked)
    assert (stranger.status_code, stranger.json()["code"]) == (401, "invitation_used")
    failed = browser.client.get(
        f"{service}/lti/register/{secret}", params={**asked, "registration_token": "wrong"}
    )
    assert (failed.status_code, failed.json()["code"]) == (422, "lti_unreachable")
    answer = browser.client.get(f"{service}/lti/register/{secret}", params=asked)
    assert 'data-step="close"' in answer.text
    again = browser.client.get(f"{service}/lti/register/{secret}", params=asked)
    assert (again.status_code, again.json()["code"]) == (401, "invitation_used")
    told = lms.state()["registered"][-1]
    assert told["https://purl.imsglobal.org/spec/lti-tool-configuration"]["claims"] == ["iss", "sub"]
    platform = next(each for each in platforms(store) if each.issuer == lms.root)
    assert platform.status is PlatformStatus.PENDING
    pending = browser.login()
    assert (pending.status_code, pending.json()["code"]) == (400, "lti_platform_inactive")
    set_status(store, platform.id, PlatformStatus.ACTIVE)
    assert browser.launch().status_code in (303, 404)
    store.close()


def test_an_active_platform_that_registers_itself_again_stays_as_it_is(
    browser: Browser, lms: Lms, service: str, store: Store
) -> None:
    """Its courses were cut off until an administrator came, and it shared names no more."""
    own = next(each for each in platforms(store) if each.issuer == lms.root)
    add_platform(store, replace(own, names_shared=True), (), now())
    address = f"{service}/lti/register/{invite(store, 'again', now())}"
    told = {"openid_configuration": f"{lms.root}/openid", "registration_token": "once"}
    assert "links work as before" in browser.client.get(address, params=told).text
    again = next(each for each in platforms(store) if each.issuer == lms.root)
    assert (again.status, again.names_shared) == (PlatformStatus.ACTIVE, True)
    assert browser.launch().status_code in (303, 404)
    add_platform(store, own, (), now())


def test_names_and_roles_come_from_every_page(lms: Lms, settings: Settings, service: str) -> None:
    courses = CourseResources(settings)
    platform = next(each for each in platforms(courses.store) if each.issuer == lms.root)
    found = members(courses.services, platform, f"{lms.root}/members")
    assert [(member.user, member.is_student) for member in found] == [
        ("teacher", False),
        ("student", True),
        ("late", True),
        ("tried", False),
    ]
    courses.close()


def test_what_a_student_saw_is_what_is_reopened(browser: Browser) -> None:
    browser.launch("eve", hint(resource="reopened", custom=CUSTOM))
    for answer in (WRONG, RIGHT):
        seen = browser.api("POST", "session/attempts", answer, **{"Accept-Language": "uk"}).json()
        number, shown = seen.pop("attempt"), seen.pop("shown")
        again = browser.api("GET", f"session/attempts/{number}", **{"Accept-Language": "uk"}).json()
        assert again["report"] == seen
        assert (again["answer"], again["shown"]) == (answer, shown)


def test_rules_hold_over_http(browser: Browser) -> None:
    rules = {"attempts": 1, "feedback": "on_release", "parts": ["table"]}
    custom = {"exercise": "puma560", "settings": json.dumps(rules)}
    browser.launch("max", hint(resource="rules", custom=custom))
    malformed = {"table": {**RIGHT["table"], "rows": [{**PUMA["rows"][0], "alpha": "2*+"}]}}
    refused = browser.api("POST", "session/attempts", malformed)
    assert (refused.status_code, refused.json()["attempt_counted"]) == (422, False)
    taken = browser.api("POST", "session/attempts", RIGHT).json()
    assert taken == {"attempt": 1, "shown": "receipt"}
    more = browser.api("POST", "session/attempts", RIGHT)
    assert (more.status_code, more.json()["code"]) == (409, "attempts_used")
    session = browser.api("GET", "session").json()
    assert (session["grade"], session["attempts"][0]["score"]) == (None, None)
    assert browser.api("GET", "session/attempts/1").json()["report"] is None


def test_a_setting_that_a_platform_garbled_keeps_nobody_from_handing_in(browser: Browser) -> None:
    rules = {"attempts": 2, "help": "hints", "parts": 5}
    custom = {"exercise": "puma560", "settings": json.dumps(rules)}
    browser.launch("gil", hint(resource="garbled", custom=custom))
    assert browser.api("POST", "session/attempts", WRONG).json()["attempt"] == 1
    assert browser.api("GET", "session").json()["attempts_allowed"] == 2


def test_a_look_at_a_regrading_does_not_stand_in_the_way_of_another(
    browser: Browser, another_browser: Callable[[], Browser]
) -> None:
    """What was found when other parts were asked was found again, as long as it was not applied."""
    link = hint(resource="asked", context="course-3", custom={"exercise": "puma560"})
    browser.launch("kim", link)
    whole = browser.api("POST", "session/attempts", RIGHT).json()["total"]["score"]
    teacher = another_browser()
    teacher.launch("tina", hint([TEACHER], resource="asked", context="course-3"))
    path = f"course/links/{teacher.api('GET', 'course').json()['link']}"
    assert teacher.api("POST", f"{path}/regradings", {"scope": "all"}).json()["changes"] == []
    chosen = {"exercise": "puma560", "parts": ["table"]}
    assert teacher.api("PUT", f"{path}/settings", chosen).status_code == 200
    (found,) = teacher.api("POST", f"{path}/regradings", {"scope": "all"}).json()["changes"]
    assert (found["before"], found["after"]) == (pytest.approx(whole), 1.0)


def test_rules_that_somebody_else_has_saved_meanwhile_are_not_overwritten(
    browser: Browser, another_browser: Callable[[], Browser]
) -> None:
    link = hint([TEACHER], resource="shared", context="course-5", custom={"exercise": "puma560"})
    browser.launch("tina", link)
    other = another_browser()
    other.launch("tom", link)
    path = f"course/links/{other.api('GET', 'course').json()['link']}/settings"
    seen = [each.api("GET", path).json() for each in (browser, other)]
    saved = browser.api("PUT", path, {**seen[0], "closes": "2027-06-01T12:00:00+00:00"})
    assert saved.status_code == 200
    late = other.api("PUT", path, {**seen[1], "points": 20})
    assert (late.status_code, late.json()["code"]) == (409, "settings_changed")
    assert browser.api("GET", path).json() == saved.json()
    looked = other.api("GET", path).json()
    assert other.api("PUT", path, {**looked, "points": 20}).json()["closes"] == saved.json()["closes"]


def test_a_draft_is_there_after_a_relaunch(browser: Browser, another_browser: Callable[[], Browser]) -> None:
    link = hint(resource="draft", custom=CUSTOM)
    browser.launch("dora", link)
    typed = {"table": {"rows": [{"theta": "θ₁"}]}, "parts": {}}
    assert browser.api("PUT", "session/draft", typed).status_code == 204
    other = another_browser()
    other.launch("dora", link)
    assert other.api("GET", "session").json()["draft"]["state"] == typed


def test_nobody_is_signed_in_without_a_token(browser: Browser) -> None:
    for token in ("", "made-up"):
        browser.token = token
        answer = browser.api("GET", "session")
        assert (answer.status_code, answer.json()["code"]) == (401, "session_expired")
    anonymous = browser.api("POST", "exercises/puma560/grade", RIGHT)
    assert anonymous.json()["correct"]
