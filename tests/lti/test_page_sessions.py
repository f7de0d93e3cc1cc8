"""In Chromium: who is signed in stays so from page to page, and is told when it ends."""

import json
from urllib.parse import quote, urljoin

import pytest
from playwright.sync_api import Browser as Chromium
from playwright.sync_api import Page, Route, expect

from tests.lti.classes import Browser, hint
from tests.lti.test_in_a_browser import chromium, page
from tests.lti.test_launches import CUSTOM
from tests.web.conftest import WITHOUT_FRAGMENT, wait_ready
from tests.web.driving import cell, switch_language
from tests.web.profiles import new_context
from tests.web.walking import assigned, by_lecture, ready, walk

__all__ = ["chromium", "page"]

NO_STORAGE = """for (const name of ["localStorage", "sessionStorage"])
  Object.defineProperty(window, name, { get() { throw new DOMException("denied", "SecurityError"); } });"""

pytestmark = pytest.mark.parametrize("address", ["sqlite"], indirect=True)


def launched(page: Page, browser: Browser, service: str, user: str, custom: dict[str, str] = CUSTOM) -> None:
    link = hint(resource=f"page-{user}", custom=custom)
    answer = browser.post(browser.authorized(browser.login(user, link)))
    page.goto(urljoin(service, answer.headers["location"]))
    wait_ready(page)
    expect(page.locator(".session-banner")).to_contain_text("Robotics 1")


def test_without_storage_other_pages_know_who_is_signed_in(
    page: Page, browser: Browser, service: str
) -> None:
    """A change of language made the page one where answers count for nothing, and said nothing of it."""
    page.add_init_script(NO_STORAGE)
    launched(page, browser, service, "nora")
    cell(page, 1, "a").fill("0.5")
    switch_language(page, "fr")
    page.locator("html[lang=fr][data-ready=true]").wait_for(state="attached")
    expect(page.locator(".session-banner")).to_contain_text("Robotics 1")
    page.locator(".crumb a").click()
    page.locator("html[data-page=home][data-ready=true]").wait_for(state="attached")
    page.get_by_role("link", name="PUMA 560", exact=True).click()
    page.locator("html[data-page=exercise][data-ready=true]").wait_for(state="attached")
    expect(page.locator(".session-banner")).to_contain_text("Robotics 1")
    expect(cell(page, 1, "a")).to_have_value("0.5")
    expect(page).to_have_url(WITHOUT_FRAGMENT)


def test_without_storage_no_address_that_stays_holds_the_session(
    page: Page, browser: Browser, service: str
) -> None:
    """A link that was followed into another tab kept the token, and handed it on twice at the next click."""
    page.add_init_script(NO_STORAGE)
    page.context.add_init_script(NO_STORAGE)
    launched(page, browser, service, "pia")
    crumb = page.locator(".crumb a")
    with page.context.expect_page() as opened:
        crumb.click(modifiers=["ControlOrMeta"])
    wait_ready(opened.value)
    opened.value.close()
    assert "#" not in str(crumb.get_attribute("href"))
    crumb.click()
    page.locator("html[data-page=home][data-ready=true]").wait_for(state="attached")
    expect(page).to_have_url(WITHOUT_FRAGMENT)
    page.goto(f"{service}/?lang=en#kept=%5B%5B%22session%22")
    page.reload()
    page.locator("html[data-page=home][data-ready=true]").wait_for(state="attached")
    expect(page).to_have_url(WITHOUT_FRAGMENT)


def test_an_address_that_somebody_else_made_signs_nobody_in(
    page: Page, browser: Browser, service: str
) -> None:
    """What its reader then handed in counted for whoever had made it."""
    launched(page, browser, service, "mallory")
    token = page.evaluate("sessionStorage.getItem('framewise:session')")
    taken_along = quote(json.dumps([["session", json.dumps(token)]]))
    page.evaluate("sessionStorage.clear()")
    page.add_init_script(NO_STORAGE)
    exercise = page.url.partition("#")[0]
    page.goto("about:blank")
    page.goto(f"{exercise}#kept={taken_along}")
    wait_ready(page)
    expect(page).to_have_url(WITHOUT_FRAGMENT)
    expect(page.locator(".session-banner")).to_have_count(0)


def test_a_session_that_has_ended_is_not_taken_for_nobody(
    chromium: Chromium, browser: Browser, service: str
) -> None:
    """The service says so while somebody types, and after a reload the page is no practice page unawares."""
    page = new_context(chromium, locale="en").new_page()
    launched(page, browser, service, "olga")
    warning = page.locator(".notice-warn")

    def ended(route: Route) -> None:
        route.continue_(headers={**route.request.headers, "authorization": "Bearer ended"})

    page.route("**/api/v1/session**", ended)
    page.route("**/api/v1/session/**", ended)
    cell(page, 1, "a").fill("0.5")
    expect(warning).to_contain_text("You are no longer signed in. What you typed is still here")
    for _ in range(2):
        page.reload()
        wait_ready(page)
        expect(warning).to_contain_text("answers that you give here do not count")
        expect(page.locator(".session-banner")).to_have_count(0)
    page.unroute_all()
    page.goto("about:blank")
    launched(page, browser, service, "olga")
    expect(cell(page, 1, "a")).to_have_value("0.5")
    page.context.close()


def test_a_table_from_the_trainer_arrives_in_the_course(page: Page, browser: Browser, service: str) -> None:
    """It was kept where the exercise looks for it only if nobody is signed in."""
    launched(page, browser, service, "tom", {"exercise": "twolink"})
    page.goto(f"{service}/trainer/twolink?lang=en")
    wait_ready(page)
    ready(page)
    exercise = page.request.get(f"{service}/api/v1/exercises/twolink").json()
    assert walk(page, 3, by_lecture(assigned(page, service, exercise)))
    page.get_by_role("button", name="Take the table into the exercise").click()
    page.locator("html[data-page=exercise][data-ready=true]").wait_for(state="attached")
    expect(page.locator(".session-banner")).to_contain_text("Robotics 1")
    expect(cell(page, 0, "a")).to_have_value("L1")
    page.reload()
    wait_ready(page)
    expect(cell(page, 0, "a")).to_have_value("L1")


def test_an_address_that_was_used_leads_nowhere_unawares(
    chromium: Chromium, browser: Browser, service: str
) -> None:
    """`Try again` opened the page where answers count for nothing, and so did a reload."""
    answer = browser.post(browser.authorized(browser.login("uma", hint(resource="page-uma", custom=CUSTOM))))
    address = urljoin(service, answer.headers["location"])
    for _ in range(2):
        page = new_context(chromium, locale="en").new_page()
        page.goto(address)
        wait_ready(page)
    expect(page.locator("#answer")).to_contain_text("Open the exercise from your course again.")
    expect(page.get_by_role("button", name="Try again")).to_have_count(0)
    page.reload()
    wait_ready(page)
    expect(page.locator(".notice-warn")).to_contain_text("answers that you give here do not count")
    page.context.close()


def test_a_launch_whose_first_call_is_lost_can_be_tried_again(
    chromium: Chromium, browser: Browser, service: str
) -> None:
    """The code had left the address before the service was asked."""
    page = new_context(chromium, locale="en").new_page()
    page.route("**/session/open", lambda route: route.abort())
    link = hint(resource="page-vera", custom=CUSTOM)
    answer = browser.post(browser.authorized(browser.login("vera", link)))
    page.goto(urljoin(service, answer.headers["location"]))
    again = page.get_by_role("button", name="Try again")
    expect(again).to_be_visible()
    page.unroute_all()
    again.click()
    expect(page.locator(".session-banner")).to_contain_text("Robotics 1")
    expect(page).to_have_url(WITHOUT_FRAGMENT)
    page.context.close()
