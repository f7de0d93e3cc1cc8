"""The lecturers' and the administrator's pages in Chromium: they work, and axe-core finds nothing."""

import json
import re
from collections.abc import Callable, Iterator

import pytest
from playwright.sync_api import Browser as Chromium
from playwright.sync_api import Page, Route, expect

from courses.people.administration import invite_administrator
from courses.storage.database import Store
from service.course_resources import now
from tests.examples import DRAFT
from tests.lti.classes import TEACHER, Browser, Lms, hint
from tests.lti.test_in_a_browser import PATIENCE, chromium, framed  # noqa: F401
from tests.lti.test_launches import CUSTOM, RIGHT, WRONG
from tests.web.conftest import assert_accessible_at_both_sizes, axe, wait_ready  # noqa: F401
from tests.web.profiles import new_context

Check = Callable[[Page], None]
pytestmark = pytest.mark.parametrize("address", ["sqlite"], indirect=True)
NAME = "עדה (Ada) לאבלייס"
PHONE = {"width": 320, "height": 900}
ENDED = {"code": "session_expired", "title": "Not signed in", "detail": "You are no longer signed in."}


@pytest.fixture
def page(chromium: Chromium) -> Iterator[Page]:  # noqa: F811
    """What works on a phone works in a large window."""
    context = new_context(chromium, viewport=PHONE, locale="en")
    context.set_default_timeout(PATIENCE)
    yield context.new_page()
    context.close()


@pytest.fixture
def assert_fits(assert_accessible_at_both_sizes: Check) -> Check:  # noqa: F811
    """Fails with axe-core's findings on a phone and in a large window, and where the page is wider."""

    def check(page: Page) -> None:
        assert_accessible_at_both_sizes(page)
        page.set_viewport_size(PHONE)

    return check


def arrived(page: Page, lms: Lms, user: str, link: str) -> None:
    """Launch in the page itself, as a new window does."""
    page.goto(f"{lms.root}/start?user={user}&hint={link}")
    page.wait_for_url("**/course*")
    wait_ready(page)


def test_attempts_left_open_are_those_of_the_exercise(page: Page, lms: Lms, service: str) -> None:
    """The field said ∞, also of an exercise that allows five."""
    page.goto(f"{lms.root}/start?user=tina&hint={hint([TEACHER], resource='open', deep=True)}")
    page.wait_for_url("**/lti/choose*")
    wait_ready(page)
    field = page.get_by_label("Attempts allowed")
    expect(field).to_have_attribute("placeholder", "as the exercise says")


def test_a_closing_time_in_the_past_is_told_where_it_is_set(page: Page, lms: Lms, service: str) -> None:
    """Exercises stand in the order of their titles; it was that of their ids, which nobody sees."""
    page.goto(f"{lms.root}/start?user=tina&hint={hint([TEACHER], resource='past', deep=True)}")
    page.wait_for_url("**/lti/choose*")
    wait_ready(page)
    titles = page.get_by_label("Exercise", exact=True).locator("option").all_inner_texts()
    assert titles == sorted(titles, key=str.casefold)
    told = page.locator("form").get_by_text("This time has passed")
    closes = page.locator("input[name=closes]")
    for time, is_past in (("2099-01-01T12:00", False), ("2020-01-01T12:00", True), ("", False)):
        closes.fill(time)
        closes.blur()
        expect(told).to_be_visible(visible=is_past)


def test_the_class_its_numbers_and_an_attempt(
    page: Page,
    browser: Browser,
    lms: Lms,
    service: str,
    assert_fits: Check,
) -> None:
    where = {"resource": "pages", "context": "pages", "custom": CUSTOM}
    browser.launch("ann", hint(**where))
    for answer in (WRONG, RIGHT):
        assert browser.api("POST", "session/attempts", answer).status_code in (200, 409)
    arrived(page, lms, "tina", hint([TEACHER], **where))
    expect(page.locator(".page-head")).to_contain_text("Signed in as")
    expect(page.locator("#class table").first).to_be_visible()
    expect(page.locator("#link table").first).to_be_visible()
    expect(page.locator("#link .bars svg[role=img] rect").first).to_be_visible()
    assert page.locator("#link .bars").count() >= 2
    assert all(
        page.locator("#link table").evaluate_all("all => all.map(({ tBodies: [body] }) => body.rows.length)")
    )
    shown = page.locator("#link").inner_text()
    assert not re.search(r"[a-z]_[a-z]|\d{4}-\d\d-\d\d", shown), "codes and machine's dates"
    assert_fits(page)
    page.emulate_media(media="print")
    expect(page.get_by_role("button", name="Preview as a student")).to_be_hidden()
    expect(page.locator("#link table").first).to_be_visible()
    page.emulate_media(media="screen")
    number = page.locator("#class").get_by_role("button", name="solved: 1")
    for opens in (number, page.locator("#link dl button").first):
        expect(opens).not_to_have_css("border-top-color", "rgba(0, 0, 0, 0)")
    number.click()
    expect(page.locator("#link").get_by_role("button", name="Open", exact=True)).to_have_count(1)
    page.locator("#link dl button").first.click()
    opened = page.get_by_role("button", name="Open", exact=True)
    opened.first.click()
    expect(page.locator("#attempt robot-scene").first).to_be_visible()
    page.locator("#link details summary").first.click()
    expect(opened.first).to_be_visible()
    assert_fits(page)  # the list, the attempt and the rules, one below the other
    page.get_by_role("button", name="Preview as a student").click()
    link = page.get_by_role("link", name="Open the preview")
    with page.context.expect_page() as made:
        link.click()
    preview = made.value
    preview.wait_for_selector("html[data-ready=true]", state="attached", timeout=PATIENCE)
    expect(preview.locator(".session-banner")).to_contain_text("of 3")
    preview.close()


def test_a_list_that_was_cut_says_so_and_no_score_is_rounded_up(
    page: Page, browser: Browser, lms: Lms, service: str
) -> None:
    """Two hundred of a class's attempts looked like all, and 99.6 % like 100 %; names were read backwards."""
    where = {"resource": "long", "context": "long", "custom": CUSTOM}
    browser.launch("lena", hint(**where))
    assert browser.api("POST", "session/attempts", RIGHT).status_code in (200, 409)

    def many(route: Route) -> None:
        found, *_ = route.fetch().json()["attempts"]
        route.fulfill(json={"attempts": [{**found, "score": 0.996, "name": NAME}] * 200})

    page.route("**/attempts?*", many)
    arrived(page, lms, "tina", hint([TEACHER], **where))
    page.locator("#link dl button").first.click()
    behind = page.locator("#link", has_text="The latest 200 are listed here.")
    expect(behind.get_by_role("cell", name="99.6 %").first).to_be_visible()
    expect(behind.locator("tbody th", has_text="Ada").first).to_contain_text(f"\u2068{NAME}\u2069 (")


def test_what_concerns_every_student_is_asked_before_and_told_after(
    page: Page, browser: Browser, lms: Lms, service: str
) -> None:
    """One press showed a class in an open exam its results, for good; extra time seemed not to be given."""
    settings = {"mode": "exam", "closes": "2099-01-01T12:00:00Z", "parts": ["table"]}
    where = {"resource": f"open-{page.viewport_size}", "context": "open"}
    link = {**where, "custom": {"exercise": "puma560", "settings": json.dumps(settings)}}
    browser.launch("ann", hint(**link))
    assert browser.api("POST", "session/attempts", WRONG).json()["shown"] == "receipt"
    number = browser.api("GET", "session").json()["attempts"][-1]["number"]
    arrived(page, lms, "tina", hint([TEACHER], **link))
    release = page.get_by_role("button", name="Release feedback")
    release.click()
    expect(page.locator("#link")).to_contain_text("This cannot be taken back.")
    assert browser.api("GET", f"session/attempts/{number}").json()["report"] is None
    page.get_by_role("button", name="Release to everyone").click()
    expect(page.locator("#link")).to_contain_text("Students can now see what was found")
    expect(release).to_have_count(0)
    assert browser.api("GET", f"session/attempts/{number}").json()["report"] is not None
    page.locator("#class").get_by_role("button", name=re.compile("begun")).last.click()
    page.get_by_label("Extra time").fill("-5")
    page.get_by_role("button", name="Give").click()
    expect(page.locator("#link .badge.good")).to_have_count(0)
    page.get_by_label("Extra time").fill("15")
    page.get_by_role("button", name="Give").click()
    expect(page.locator("#link .badge.good")).to_have_text("Saved.")


def test_a_wrong_attempt_is_shown_as_it_was_typed_beside_the_figure(
    page: Page, browser: Browser, lms: Lms, service: str
) -> None:
    """The figure took the width of the window, and a modified table had the columns of a standard one."""
    where = {"resource": "wrong", "context": "wrong", "custom": CUSTOM}
    browser.launch("ann", hint(**where))
    assert browser.api("POST", "session/attempts", WRONG).status_code in (200, 409)
    arrived(page, lms, "tina", hint([TEACHER], **where))
    page.locator("#link dl button").first.click()
    page.get_by_role("button", name="Open", exact=True).first.click()
    expect(page.locator("#attempt thead").first).to_contain_text("αᵢ₋₁aᵢ₋₁dᵢθᵢ")
    expect(page.locator("#attempt")).to_contain_text("PUMA 560 (puma560-")
    page.set_viewport_size({**PHONE, "width": 1280})
    figure = page.locator("#attempt .figure-paper")
    figure.scroll_into_view_if_needed()
    assert figure.evaluate("({ offsetWidth }) => offsetWidth") < 600


def test_rules_of_a_published_exercise_keep_it(
    page: Page, browser: Browser, another_browser: Callable[[], Browser], lms: Lms, service: str
) -> None:
    """It stands in no list: the form showed the first of the list, which a new deadline chose."""
    published = browser.api("POST", "author/publish", {"draft": DRAFT}).json()["id"]
    where = {"resource": "own", "context": "own", "custom": {"exercise": published}}
    browser.launch("ann", hint(**where))
    arrived(page, lms, "tina", hint([TEACHER], **where))
    page.locator("#link details summary").first.click()
    expect(page.locator("#link select[name=exercise]")).to_have_value(published)
    page.get_by_label("Points in the gradebook", exact=True).fill("7")
    page.get_by_role("button", name="Save").click()
    expect(page.locator("#link details[open]")).to_have_count(0)
    session = browser.api("GET", "session").json()
    assert (session["exercise"], session["points"]) == (published, 7)

    other = another_browser()
    other.launch("tom", hint([TEACHER], **where))
    path = f"course/links/{session['link']['id']}"
    page.locator("#link details summary").first.click()
    assert other.api("PUT", f"{path}/settings", {"exercise": published, "points": 9}).status_code == 200
    page.get_by_role("button", name="Save").click()
    expect(page.locator("#link .notice-problem")).to_contain_text("somebody else has saved other rules")

    student = {"person": session["person"]["key"], "extra_minutes": 30, "extra_attempts": 2}
    assert other.api("POST", f"{path}/allowances", student).status_code == 204
    page.reload()
    arrived(page, lms, "tina", hint([TEACHER], **where))
    page.locator("#class").get_by_role("button", name="opened, no attempt", exact=True).click()
    expect(page.get_by_label("Extra time [min]")).to_have_value("30")
    name = session["person"]["key"][:8]  # it stood nowhere beside an extra time of somebody without attempts
    expect(page.locator("#link").get_by_role("heading", name=name)).to_be_visible()
    expect(page.get_by_label("Extra attempts")).to_have_value("2")


def test_what_is_refused_is_said(page: Page, browser: Browser, lms: Lms, service: str) -> None:
    """The page stood at "Loading" for ever, and a refusal was saved as a file of attempts."""
    where = {"resource": "refused", "context": "refused", "custom": CUSTOM}
    browser.launch("ann", hint(**where))
    arrived(page, lms, "tina", hint([TEACHER], **where))
    page.route("**/api/v1/course/links/**", lambda route: route.fulfill(status=401, json=ENDED))
    for name in ("Regrade all attempts", "CSV", "JSON"):
        page.get_by_role("button", name=name).click()
        expect(page.locator("#link [role=status] .notice-problem")).to_contain_text("signed in")


def test_the_administrators_page(
    page: Page,
    store: Store,
    service: str,
    assert_fits: Check,
) -> None:
    """An address that was opened where the page had said to open one did nothing."""
    page.goto(f"{service}/platforms")
    wait_ready(page)
    expect(page.locator("#list")).to_contain_text(f"framewise lti administer {service}")
    assert_fits(page)
    code = invite_administrator(store, now())
    page.goto(f"{service}/platforms#code={code}")
    wait_ready(page)
    expect(page.locator("#list table")).to_be_visible()
    page.get_by_label("For whom").fill("Faculty")
    page.get_by_role("button", name="Make an address").click()
    expect(page.locator("#invite code")).to_contain_text("/lti/register/")
    expect(page.locator("#list")).not_to_contain_text("will not call")
    form = page.locator("#add form")
    for name in ("issuer", "authorization_endpoint", "token_endpoint", "jwks_uri"):
        scheme = "http" if name == "jwks_uri" else "https"
        form.locator(f"[name={name}]").fill(f"{scheme}://lms.example.edu/{name}")
    form.locator("[name=client_id]").fill("client")
    form.get_by_role("button", name="Register").click()
    expect(page.locator("#list")).to_contain_text("will not call http://lms.example.edu/jwks_uri")
    expect(page.locator("#list")).not_to_contain_text("will not call https")
    assert_fits(page)
    page.goto(f"{service}/platforms#code={code}")
    expect(page.locator("#platforms-problem")).to_contain_text("used already")
    expect(page.locator("#platforms-problem")).not_to_contain_text("course")
    expect(page.locator("#list")).to_contain_text(f"framewise lti administer {service}")


def test_what_a_lecturer_sends(page: Page, service: str, assert_fits: Check) -> None:
    page.goto(f"{service}/lti/connect")
    wait_ready(page)
    assert_fits(page)
