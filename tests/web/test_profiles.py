"""The page that serves one test after the other: nobody finds what somebody else left."""

from collections.abc import Callable
from typing import Any

import pytest
from playwright.sync_api import Page

from tests.web.conftest import OpenPage, Watch
from tests.web.profiles import Visits

TRACES = """[
  Number('mine' in localStorage), sessionStorage.length, matchMedia("(prefers-color-scheme: dark)").matches,
  matchMedia("(forced-colors: active)").matches,
  matchMedia("(prefers-reduced-motion: reduce)").matches, document.querySelector(".bar-nav:hover") !== null,
]"""
UNTOUCHED = [0, 0, False, False, True, False]


def test_a_page_serves_again_as_if_nobody_had_been_there(visits: Visits, web: str) -> None:
    page = visits.page(webgl=False)
    page.route("**/robots", lambda route: route.abort())
    page.goto(f"{web}/?lang=en")
    page.evaluate("localStorage.setItem('mine', 'here')")
    page.emulate_media(color_scheme="dark", forced_colors="active", reduced_motion="no-preference")
    page.locator(".bar-nav a").first.hover()
    assert page.evaluate(TRACES) == [1, 0, True, True, False, True]
    page.emulate_media(media="print")
    visits.forget()
    again = visits.page(webgl=False)
    assert again is page
    again.goto(f"{web}/?lang=en")
    assert again.evaluate(TRACES) == UNTOUCHED
    assert again.evaluate("fetch('/api/v1/robots').then(({ ok }) => ok)")
    assert not again.evaluate("matchMedia('print').matches")
    again.go_back()
    assert again.url == "about:blank"
    visits.forget()


LASTING: dict[str, Callable[[Page], Any]] = {
    "a script": lambda page: page.add_init_script("window.mine = true"),
    "a listener": lambda page: page.on("request", lambda request: None),
    "stored in the tab": lambda page: page.evaluate("sessionStorage.setItem('token', 'mine')"),
    "closed": lambda page: page.close(),
}


@pytest.mark.parametrize("what", LASTING)
def test_a_page_of_which_something_lasting_was_asked_serves_nobody_else(
    visits: Visits, web: str, what: str
) -> None:
    page = visits.page(webgl=False)
    page.goto(f"{web}/version")
    LASTING[what](page)
    visits.forget()
    other = visits.page(webgl=False)
    assert other is not page
    other.goto(f"{web}/version")
    assert other.evaluate(TRACES) == UNTOUCHED
    assert not other.evaluate("window.mine")
    visits.forget()


def test_a_page_without_webgl_is_another_than_one_with_it(visits: Visits, web: str) -> None:
    drawn = "document.createElement('canvas').getContext('webgl2') !== null"
    for webgl in (True, False, True):
        page = visits.page(webgl=webgl)
        page.goto(f"{web}/version")
        assert page.evaluate(drawn) is webgl
        visits.forget()


@pytest.mark.parametrize("fresh", [False, True])
def test_what_a_page_complains_of_is_noted(open_page: OpenPage, watch: Watch, fresh: bool) -> None:
    page = open_page("/version", lang=None, ready=False, fresh=fresh)
    page.evaluate("console.warn('pale')")
    with page.context.expect_event("weberror"):
        page.evaluate("setTimeout(() => { throw new Error('broken'); })")
    assert [said.split()[:2] for said in watch.unexpected()] == [["warning:", "pale"], ["error:", "broken"]]
    watch.problems.clear()
