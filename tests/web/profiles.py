"""Browser profiles for tests: one for each test, or one whose page serves test after test."""

from collections.abc import Callable
from functools import partial
from typing import Any

from playwright.sync_api import Browser, BrowserContext, Error, Page

PATIENCE = 120_000
"""Milliseconds until what should happen counts as not happening; much, because machines may be busy."""

WITHOUT_WEBGL = """
const real = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
  return kind.startsWith("webgl") ? null : real.call(this, kind, ...more);
};
"""
"""Has scenes drawn as SVG, whose shapes can be counted."""


def new_context(browser: Browser, *, webgl: bool = False, **options: Any) -> BrowserContext:
    """A browser profile in which nothing moves by itself and scenes are SVG, unless it is to be otherwise.

    Drawing by WebGL takes a third of what a page costs, where it is done in software; a film far more.
    """
    context = browser.new_context(**{"reduced_motion": "reduce", **options})
    context.set_default_timeout(PATIENCE)
    if not webgl:
        context.add_init_script(WITHOUT_WEBGL)
    return context


LEFT_OPEN = 20
"""Empty pages after which all are closed."""
LASTING = (
    "add_init_script",
    "add_locator_handler",
    "expose_binding",
    "expose_function",
    "on",
    "once",
    "set_default_timeout",
    "set_extra_http_headers",
)
"""What is asked of a page for as long as it is open: another test would meet it there."""


class Visits:
    """One browser profile for the tests of the folder: what a page loads is fetched and compiled once.

    A page that stays open keeps the process in which the others are drawn, and one that was used serves the
    next test, which saves a third of what loading costs, unless something was asked of it that stays with it.
    Such pages are left empty for a while: with a page that is closed goes what the process has in memory,
    seventy scripts and styles. Every test finds the profile without cookies, permissions and stored data, as
    if nobody had been there before. A clock that is set would be the whole profile's: it needs another one.
    """

    def __init__(self, browser: Browser, origin: str) -> None:
        self.context = new_context(browser, webgl=True)
        self.origins = {origin}
        """Where somebody has been."""
        self._first_page = self.context.new_page()
        self._first_page.goto(f"{origin}/version")
        self._protocol = self.context.new_cdp_session(self._first_page)
        self._empty: dict[bool, Page] = {}
        """By whether they have WebGL, the pages that serve again."""
        self._lent: tuple[bool, Page] | None = None

    def page(self, *, webgl: bool) -> Page:
        """Return the page of a test, which has no other of this profile."""
        page = self._empty.pop(webgl, None) or self._new(webgl=webgl)
        self._lent = webgl, page
        return page

    def _new(self, *, webgl: bool) -> Page:
        page = self.context.new_page()
        if not webgl:
            page.add_init_script(WITHOUT_WEBGL)
        for name in LASTING:
            setattr(page, name, partial(self._ask, getattr(page, name)))
        return page

    def _ask(self, lasting: Callable[..., Any], *given: Any, **named: Any) -> Any:
        self._lent = None
        return lasting(*given, **named)

    def forget(self) -> None:
        """Empty all pages and leave nothing of them but what the browser caches."""
        again = self._lent if self._lent and leaves_nothing(self._lent[1]) else None
        used = [page for page in self.context.pages if page is not self._first_page]
        for page in used:
            if page.url != "about:blank":
                page.goto("about:blank")
        if again:
            self._empty[again[0]] = as_if_new(again[1])
        if len(used) > LEFT_OPEN:
            for page in used:
                page.close()
            self._empty.clear()
        self.context.unroute_all()
        self.context.clear_cookies()
        self.context.clear_permissions()
        stored = "local_storage,indexeddb,cache_storage,service_workers,file_systems,shared_storage"
        for origin in self.origins:
            self._protocol.send("Storage.clearDataForOrigin", {"origin": origin, "storageTypes": stored})


def leaves_nothing(page: Page) -> bool:
    """Whether a page can be asked, and says, that it stores nothing for as long as it is open."""
    try:
        return page.url != "about:blank" and page.evaluate("sessionStorage.length") == 0
    except Error:
        return False


def as_if_new(page: Page) -> Page:
    """Take back what leaving an address does not: routes, media, where the pointer is, the way back."""
    page.unroute_all()
    page.emulate_media(
        media="null", color_scheme="light", reduced_motion="reduce", forced_colors="none", contrast="null"
    )
    page.mouse.move(-1, -1)
    session = page.context.new_cdp_session(page)
    session.send("Page.resetNavigationHistory")
    session.detach()
    return page
