"""In Chromium: the tool in a frame of another site whose third-party cookies are blocked."""

import json
import os
import re
from collections.abc import Callable, Iterator
from datetime import UTC, datetime, timedelta
from urllib.parse import urlencode, urljoin, urlsplit

import pytest
from playwright.sync_api import Browser as Chromium
from playwright.sync_api import Frame, Locator, Page, Route, expect, sync_playwright

from courses.people.platforms import invite
from courses.storage.database import Store
from service.course_resources import now
from service.resources import Resources
from tests.lti.classes import TEACHER, Browser, Lms, eventually, hint
from tests.lti.test_launches import CUSTOM, RIGHT
from tests.web.conftest import ARGUMENTS, CHROMIUM, wait_ready
from tests.web.driving import PUMA, cell
from tests.web.profiles import new_context

BLOCKED = "--test-third-party-cookie-phaseout"
PATIENCE = 120_000


@pytest.fixture(scope="module")
def chromium() -> Iterator[Chromium]:
    """Chromium without third-party cookies."""
    if CHROMIUM is None:
        if os.environ.get("CI"):
            pytest.fail("Chromium is not installed")
        pytest.skip("Chromium is not installed (`make browser` installs it)")
    with sync_playwright() as playwright:
        started = playwright.chromium.launch(
            executable_path=CHROMIUM, args=[*ARGUMENTS, BLOCKED], timeout=PATIENCE
        )
        yield started
        started.close()


@pytest.fixture
def page(chromium: Chromium) -> Iterator[Page]:
    """A page whose complaints fail the test."""
    context = new_context(chromium, viewport={"width": 1280, "height": 1000}, locale="en", timezone_id="UTC")
    context.set_default_timeout(PATIENCE)
    opened = context.new_page()
    said: list[str] = []
    opened.on("console", lambda message: said.append(message.text) if message.type == "error" else None)
    opened.on("pageerror", lambda error: said.append(str(error)))
    yield opened
    context.close()
    assert [text for text in said if "GL Driver" not in text] == []


def framed(page: Page, lms: Lms, user: str, link: str) -> Frame:
    """The tool's page in a frame of the platform's."""
    page.goto(f"{lms.elsewhere}/course?{urlencode({'user': user, 'hint': link})}")
    frame = page.wait_for_event("framenavigated", predicate=_is_ready) if not _ready(page) else _ready(page)
    assert frame is not None
    frame.wait_for_selector("html[data-ready=true]", timeout=PATIENCE)
    return frame


def _is_ready(frame: Frame) -> bool:
    path = urlsplit(frame.url).path
    return "/exercises/" in path or path.endswith(("/course", "/lti/choose"))


def _ready(page: Page) -> Frame | None:
    return next((frame for frame in page.frames[1:] if _is_ready(frame)), None)


@pytest.mark.parametrize("address", ["sqlite"], indirect=True)
def test_launch_submit_verdict_score_in_a_frame(page: Page, lms: Lms, service: str) -> None:
    frame = framed(page, lms, "frida", hint(resource="framed", custom=CUSTOM))
    expect(frame.locator(".session-banner")).to_contain_text("Robotics 1")
    frame.wait_for_url(lambda address: "session" not in address)
    state = {"table": {**PUMA, "angleUnit": "deg", "lengthUnit": "m"}, "parts": {}}
    frame.evaluate("(state) => { document.querySelector('dh-table-editor').state = state.table }", state)
    frame.locator("form button[type=submit]").first.click()
    expect(frame.locator("#verdict")).to_be_visible()
    assert eventually(lambda: lms.result("frida", "framed")) == 1.0
    banner = frame.locator(".session-banner")
    expect(banner).to_contain_text("35 of 35 points")
    expect(banner).to_contain_text("For the gradebook: 100 %")
    expect(frame.locator("#history-card")).to_contain_text("Kept in your course.")
    expect(frame.locator("#history-card").get_by_role("button", name="Clear history")).to_have_count(0)
    page.reload()


@pytest.mark.parametrize("address", ["sqlite"], indirect=True)
def test_a_withheld_score_is_not_shown_as_none(page: Page, service: str, browser: Browser) -> None:
    """What was found waits for the lecturer: until then an attempt was handed in, and is not worth 0."""
    told = {"feedback": "on_release", "closes": "2099-01-01T12:00:00Z", "parts": ["table"]}
    custom = {"exercise": "puma560", "settings": json.dumps(told)}
    link = hint(resource="withheld", custom=custom)
    launched = browser.post(browser.authorized(browser.login("wanda", link)))
    page.goto(urljoin(service, launched.headers["location"]))
    page.wait_for_selector("html[data-ready=true]")
    page.evaluate("(table) => (document.querySelector('dh-table-editor').table = table)", RIGHT["table"])
    page.locator("form button[type=submit]").first.click()
    expect(page.locator("#history .badge")).to_have_text("handed in")
    banner = page.locator(".session-banner")
    expect(banner).to_contain_text("Signed in as")
    expect(banner).to_contain_text(re.compile(r"Closes: [12] Jan 2099, .*(UTC|GMT|[A-Z]{3,4})"))
    expect(banner).not_to_contain_text("points")


@pytest.mark.parametrize("address", ["sqlite"], indirect=True)
def test_what_was_typed_last_is_there_whatever_the_browser(
    page: Page, lms: Lms, service: str, another_browser: Callable[[], Browser]
) -> None:
    """At home stood what had been typed there before what was typed elsewhere; practice stood in an exam.

    The clock at home is an hour fast.
    """
    page.clock.install(time=now() + timedelta(hours=1))
    link = {"context": "drafts", "custom": CUSTOM}

    def first_cell(resource: str) -> Locator:
        page.goto(f"{lms.root}/start?user=dan&hint={hint(resource=resource, **link)}")
        page.wait_for_url("**/exercises/**")
        wait_ready(page)
        return cell(page, 0, "alpha")

    with page.expect_response("**/session/draft"):
        first_cell("practice").fill("17")
    elsewhere = another_browser()
    elsewhere.launch("dan", hint(resource="practice", **link))
    typed = elsewhere.api("GET", "session").json()["draft"]["state"]
    assert typed["table"]["rows"][0]["alpha"] == "17"
    typed["table"]["rows"][0]["alpha"] = "90"
    assert elsewhere.api("PUT", "session/draft", typed).status_code == 204
    expect(first_cell("practice")).to_have_value("90")
    expect(first_cell("exam")).to_have_value("")

    page.route("**/session/draft", lambda _: None)  # it does not arrive
    with page.expect_request("**/session/draft"):
        first_cell("practice").fill("45")
    expect(first_cell("practice")).to_have_value("45")
    assert elsewhere.api("PUT", "session/draft", typed).status_code == 204
    expect(first_cell("practice")).to_have_value("90")
    page.get_by_role("button", name="Show the other version").click()
    expect(cell(page, 0, "alpha")).to_have_value("45")


@pytest.mark.usefixtures("service")
@pytest.mark.parametrize("address", ["sqlite"], indirect=True)
def test_what_a_lecturer_changes_while_students_work_is_said(
    chromium: Chromium, lms: Lms, browser: Browser
) -> None:
    """Answers were judged by values that the page did not show; those to the former exercise went nowhere."""
    context = new_context(chromium, locale="en")
    context.set_default_timeout(PATIENCE)
    page = context.new_page()
    where = {"resource": "changing", "context": "changing", "custom": CUSTOM}
    browser.launch("tina", hint([TEACHER], **where))
    path = f"course/links/{browser.api('GET', 'course').json()['link']}/settings"
    page.goto(f"{lms.root}/start?user=ivan&hint={hint(**where)}")
    page.wait_for_url("**/exercises/**")
    wait_ready(page)
    page.evaluate("(table) => (document.querySelector('dh-table-editor').table = table)", RIGHT["table"])
    assert browser.api("PUT", path, {"exercise": "puma560", "per_student": True}).status_code == 200
    with page.expect_response("**/session/attempts") as refused:
        page.locator("form button[type=submit]").first.click()
    assert refused.value.json()["code"] == "exercise_changed"
    page.reload()
    page.wait_for_url("**/exercises/puma560*seed=*")
    expect(page.locator(".session-banner")).to_contain_text("Attempts: 0")

    assert browser.api("PUT", path, {"exercise": "scara"}).status_code == 200
    page.reload()
    wait_ready(page)
    expect(page.locator(".session-banner")).to_have_count(0)
    page.get_by_role("button", name="Open the exercise of the course").click()
    page.wait_for_url("**/exercises/scara*")
    expect(page.locator(".session-banner")).to_contain_text("Attempts: 0")
    context.close()


@pytest.mark.usefixtures("service")
@pytest.mark.parametrize("address", ["sqlite"], indirect=True)
def test_help_that_rises_starts_anew_for_each_student_at_a_shared_computer(page: Page, lms: Lms) -> None:
    """The second student's first wrong answer was told as much as the first one's second."""
    link = hint(resource="shared", context="shared", custom=CUSTOM)
    for user, twist in (("olga", "17"), ("pavlo", "18")):
        page.goto(f"{lms.root}/start?user={user}&hint={link}")
        page.wait_for_url("**/exercises/**")
        wait_ready(page)
        page.evaluate("(table) => (document.querySelector('dh-table-editor').table = table)", RIGHT["table"])
        cell(page, 1, "alpha").fill(twist)
        page.locator(".help-choice select").select_option("steps")
        with page.expect_request("**/session/attempts") as sent:
            page.locator("form button[type=submit]").first.click()
        assert sent.value.post_data_json["help"] == "row"
        expect(page.locator("#history .badge")).to_be_visible()


@pytest.mark.usefixtures("service")
@pytest.mark.parametrize("address", ["sqlite"], indirect=True)
def test_in_a_crowd_the_picture_of_where_a_robot_departs_is_drawn_when_asked_for(
    page: Page, lms: Lms, monkeypatch: pytest.MonkeyPatch
) -> None:
    page.goto(f"{lms.root}/start?user=petra&hint={hint(resource='crowd', context='crowd', custom=CUSTOM)}")
    page.wait_for_url("**/exercises/**")
    wait_ready(page)
    page.evaluate("(table) => (document.querySelector('dh-table-editor').table = table)", RIGHT["table"])
    cell(page, 1, "alpha").fill("17")
    draw = page.get_by_role("button", name="Draw it now")
    with monkeypatch.context() as crowd:
        crowd.setattr(Resources, "is_crowded", lambda _: True)
        page.locator("form button[type=submit]").first.click()
        expect(page.locator("#verdict .notice", has_text="So many answers")).to_be_visible()
        expect(page.locator("#verdict robot-scene")).to_have_count(0)
        draw.focus()
        page.keyboard.press("Enter")
        expect(page.locator("#verdict robot-scene")).to_be_visible()
        expect(draw).to_have_count(0)
        assert page.evaluate("document.activeElement.querySelector('robot-scene') !== null")
    cell(page, 1, "alpha").fill("18")
    page.locator("form button[type=submit]").first.click()
    expect(page.locator("#verdict-card")).not_to_have_class(re.compile("outdated"))
    expect(page.locator(".session-banner")).to_contain_text(re.compile(r"31\.2 of 35 .*gradebook: 89 %"))
    expect(page.locator("#verdict robot-scene")).to_be_visible()
    expect(draw).to_have_count(0)


@pytest.mark.parametrize("address", ["sqlite"], indirect=True)
def test_a_page_that_stays_open_says_when_attempts_open_and_close(
    page: Page, service: str, browser: Browser
) -> None:
    """Whoever waited read "Opens", and whoever went on writing "Closes", until the next attempt.

    The computer's clock is a day slow.
    """
    at = datetime(2098, 12, 31, 11, tzinfo=UTC)

    def told_then(route: Route) -> None:
        route.fulfill(json={**route.fetch().json(), "now": at.isoformat()})

    page.route("**/api/v1/session", told_then)
    told = {"opens": "2098-12-31T12:00:00Z", "closes": "2099-01-01T12:00:00Z"}
    link = hint(resource="exam", custom={"exercise": "puma560", "settings": json.dumps(told)})
    launched = browser.post(browser.authorized(browser.login("emil", link)))
    page.clock.install(time=at - timedelta(days=1))
    page.goto(urljoin(service, launched.headers["location"]))
    page.wait_for_selector("html[data-ready=true]")
    banner = page.locator(".session-banner")
    expect(banner).to_contain_text("Opens: 31 Dec 2098, 12:00")
    at += timedelta(hours=1, minutes=2)
    page.clock.fast_forward("01:02:00")
    expect(banner).not_to_contain_text("Opens:")
    page.evaluate("document.querySelector('.session-banner .warn')?.remove()")
    at += timedelta(days=1)
    page.clock.fast_forward("24:00:00")
    expect(banner.locator(".badge.warn")).to_be_visible()


@pytest.mark.parametrize("address", ["sqlite"], indirect=True)
def test_the_time_zone_of_a_form_is_named_in_the_language_of_the_page(
    chromium: Chromium, service: str, browser: Browser
) -> None:
    """It was Chromium's identifier, "Europe/Kiev", in every language."""
    context = new_context(chromium, locale="uk", timezone_id="Europe/Kyiv")
    context.set_default_timeout(PATIENCE)
    page = context.new_page()
    link = hint([TEACHER], resource="zone", context="zone")
    launched = browser.post(browser.authorized(browser.login("tina", link)))
    page.goto(urljoin(service, launched.headers["location"]))
    closes = page.locator("label", has=page.locator("input[name=closes]"))
    expect(closes).to_contain_text("східноєвропейським часом")
    expect(closes).not_to_contain_text("/")
    context.close()


@pytest.mark.parametrize("address", ["sqlite"], indirect=True)
def test_a_lost_answer_costs_no_second_attempt(
    chromium: Chromium, lms: Lms, service: str, browser: Browser
) -> None:
    """The service stores the attempt, its answer never arrives; the next press asks for the same attempt."""
    context = new_context(chromium, viewport={"width": 1280, "height": 1000}, locale="en", timezone_id="UTC")
    context.set_default_timeout(PATIENCE)
    page = context.new_page()
    keys: list[str | None] = []
    tickets: list[str | None] = []
    lost, busy, dear = 2, 4, 6

    def drop(route: Route) -> None:
        keys.append(route.request.headers.get("idempotency-key"))
        tickets.append(route.request.headers.get("framewise-arrival"))
        if len(keys) <= lost:
            assert route.fetch().ok
            route.abort("connectionreset")
        elif len(keys) == busy:
            fields = {"Retry-After": "1", "Framewise-Arrival": "a ticket"}
            route.fulfill(status=503, headers=fields, body="{}")
        elif len(keys) == dear:
            route.fulfill(status=429, headers={"Framewise-Arrival": "another ticket"}, body="{}")
        else:
            route.continue_()

    page.route("**/session/attempts", drop)
    launched = browser.post(browser.authorized(browser.login("lora", hint(resource="lossy", custom=CUSTOM))))
    page.goto(urljoin(service, launched.headers["location"]))
    page.wait_for_selector("html[data-ready=true]")
    page.evaluate("(table) => (document.querySelector('dh-table-editor').table = table)", RIGHT["table"])
    button = page.locator("form button[type=submit]").first
    button.click()
    expect(page.locator("#submit-problem")).to_contain_text("cannot be reached")
    expect(page.locator("#verdict-card")).to_be_hidden()
    page.reload()  # what was sent without an answer survives the page
    page.wait_for_selector("html[data-ready=true]")
    button.click()
    expect(page.locator("#submit-problem")).to_contain_text("cannot be reached")
    button.click()
    expect(page.locator("#verdict")).to_be_visible()
    expect(page.locator("#history li")).to_have_count(1)
    assert keys[0]
    assert keys == [keys[0]] * 3
    button.click()  # a new submission, although nothing was changed
    expect(page.locator("#history li")).to_have_count(2)
    assert keys[3] not in (None, keys[0])
    assert keys[4:] == [keys[3]]  # by itself, and with the ticket of the refusal
    with page.expect_response(lambda response: response.status == 429):
        button.click()
    expect(button).to_be_enabled()
    button.click()
    expect(page.locator("#history li")).to_have_count(3)
    assert keys[6] == keys[5] not in keys[:5]
    assert tickets == [None] * 4 + ["a ticket", None, "another ticket"]
    context.close()


@pytest.mark.parametrize("address", ["sqlite"], indirect=True)
def test_a_lecturer_sees_the_class_and_opens_an_attempt(page: Page, lms: Lms, browser: Browser) -> None:
    link = hint(resource="seen", context="course-9", custom=CUSTOM)
    wrong = {"table": {**RIGHT["table"], "rows": [{**row, "alpha": "0"} for row in PUMA["rows"]]}}
    browser.launch("gus", link)
    browser.api("POST", "session/attempts", wrong)
    browser.api("POST", "session/attempts", RIGHT)
    frame = framed(page, lms, "tina", hint([TEACHER], resource="seen", context="course-9", custom=CUSTOM))
    expect(frame.locator("#class")).to_contain_text("PUMA 560")
    expect(frame.locator("#link-card .bars svg").first).to_be_visible()
    frame.locator("#class table").nth(1).locator("button").first.click()
    frame.locator("#link button", has_text="Open").first.click()
    expect(frame.locator("#attempt-card table").first).to_be_visible()
    expect(frame.locator("#attempt robot-scene, #attempt canvas, #attempt svg").first).to_be_visible()


@pytest.mark.parametrize("address", ["sqlite"], indirect=True)
def test_a_teacher_chooses_in_a_frame(page: Page, lms: Lms, service: str) -> None:
    before = len(lms.state()["returned"])
    frame = framed(page, lms, "tina", hint([TEACHER], deep=True))
    frame.select_option("select[name=exercise]", "scara")
    frame.fill("input[name=points]", "12")
    frame.locator("form button[type=submit]").click()
    returned = eventually(lambda: lms.state()["returned"][before:])
    (item,) = returned[0]["items"]
    assert (item["custom"]["exercise"], item["lineItem"]["scoreMaximum"]) == ("scara", 12)
    assert json.loads(item["custom"]["settings"])["points"] == 12


@pytest.mark.parametrize("address", ["sqlite"], indirect=True)
def test_a_registration_in_a_frame_closes_it(page: Page, lms: Lms, service: str, store: Store) -> None:
    """Moodle shows the page in a frame, of a platform that is not known before and is not active after."""
    asked = {"openid_configuration": f"{lms.root}/openid", "registration_token": "once"}
    source = f"{service}/lti/register/{invite(store, '', now())}?{urlencode(asked)}"
    page.goto(f"{lms.elsewhere}/frame?{urlencode({'source': source})}")
    expect(page).to_have_title("org.imsglobal.lti.close")
    frame = page.frame_locator("iframe")
    expect(frame.get_by_role("heading", level=1)).to_have_text("Registering a learning platform")
    expect(frame.locator("#launch-text")).to_contain_text("Framewise is registered with")
    lms.register(store)


@pytest.mark.parametrize("address", ["sqlite"], indirect=True)
def test_a_refused_launch_says_so_in_a_frame(
    chromium: Chromium, lms: Lms, service: str, store: Store
) -> None:
    """The frame of a platform that is not registered, or not active, was empty."""
    context = new_context(chromium, locale="en")
    page = context.new_page()
    asked = {"iss": "https://nobody.example", "login_hint": "u", "target_link_uri": f"{service}/lti/launch"}
    source = f"{service}/lti/login?{urlencode(asked)}"
    host = lms.elsewhere.replace("localhost", "nobody.localhost")
    page.goto(f"{host}/frame?{urlencode({'source': source})}")
    told = page.frame_locator("iframe").locator("#launch-text")
    expect(told).to_contain_text("No platform https://nobody.example is registered here.")
    context.close()


@pytest.mark.parametrize("address", ["sqlite"], indirect=True)
def test_a_student_reads_the_rules_of_the_link(page: Page, service: str, browser: Browser) -> None:
    """Nothing said what another attempt costs, and the page offered more help than the link gives."""
    told = {"attempts": 3, "penalty": 0.1, "counting": "last", "help": "row", "parts": ["table"]}
    link = hint(resource="ruled", custom={"exercise": "puma560", "settings": json.dumps(told)})
    launched = browser.post(browser.authorized(browser.login("rita", link)))
    page.goto(urljoin(service, launched.headers["location"]))
    page.wait_for_selector("html[data-ready=true]")
    banner = page.locator(".session-banner")
    expect(banner).to_contain_text("The last attempt counts")
    expect(banner).to_contain_text(re.compile(r"Each further attempt costs 10\s% of all points"))
    offered = page.locator(".help-choice option")
    expect(offered).to_have_count(2)
    assert offered.evaluate_all("(all) => all.map(({ value }) => value)") == ["verdict", "row"]
    expect(page.locator("form button[type=submit]").first).to_have_text("Hand in")
    assert "Joints: ." not in page.inner_text("body")
