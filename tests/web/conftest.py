"""A running service and a real Chromium for every test of the web form.

Where Chromium is missing, tests that need it are skipped with the reason; in CI that is a failure.
"""

import os
import re
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest
from playwright.sync_api import Browser, BrowserContext, ConsoleMessage, Page, expect, sync_playwright

from service.settings import Settings
from tests.live_service import running

ROOT = Path(__file__).resolve().parent.parent.parent
BROWSERS = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome")
"""Best first: the headless shell opens a page for less than half of the processor time."""
CHROMIUM = next(filter(None, map(shutil.which, BROWSERS)), None)
ARGUMENTS = [
    "--no-sandbox",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--process-per-site",
    "--in-process-gpu",
    "--force-prefers-reduced-motion",
]
PATIENCE = 60_000
"""Milliseconds until what should happen counts as not happening; much, because machines may be busy."""

expect.set_options(timeout=PATIENCE)

WITHOUT_WEBGL = """
const real = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
  return kind.startsWith("webgl") ? null : real.call(this, kind, ...more);
};
"""
"""Has scenes drawn as SVG, whose shapes can be counted."""

WITHOUT_FRAGMENT = re.compile("^[^#]*$")
"""An address that a page has when it has taken away what was handed over behind its `#`."""

LANGUAGES = ("en", "ro", "pt", "fr", "uk", "es")


@pytest.fixture(scope="session")
def web() -> Iterator[str]:
    """Origin of a running service that may be shown in any frame.

    It gives slow machines time: how long an answer may take is not the form's business.
    """
    with running(Settings(frame_ancestors=("*",), symbolic_seconds=60.0)) as origin:
        yield origin


@pytest.fixture(scope="module")
def client(web: str) -> Iterator[httpx.Client]:
    with httpx.Client(base_url=web, timeout=120) as connected:
        yield connected


@pytest.fixture(scope="package")
def browser() -> Iterator[Browser]:
    """Chromium, ended with the folder: while it runs, so does its event loop, and no other may start."""
    if CHROMIUM is None:
        reason = "Chromium is not installed (`make browser` installs it)"
        if os.environ.get("CI"):
            pytest.fail(reason)
        pytest.skip(reason)
    with sync_playwright() as playwright:
        started = playwright.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
        yield started
        started.close()


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


class Visits:
    """One browser profile for the tests of the folder: what a page loads is fetched and compiled once.

    A page that stays open keeps the process in which the others are drawn. Those that were used are left
    empty for a while: with a page that is closed goes what the process has in memory, seventy scripts and
    styles. Every test finds the profile without cookies, permissions and stored data, as if nobody had been
    there before.
    """

    def __init__(self, browser: Browser, origin: str) -> None:
        self.context = new_context(browser, webgl=True)
        self.origins = {origin}
        """Where somebody has been."""
        self._first_page = self.context.new_page()
        self._first_page.goto(f"{origin}/version")
        self._protocol = self.context.new_cdp_session(self._first_page)

    def forget(self) -> None:
        """Empty all pages and leave nothing of them but what the browser caches."""
        used = [page for page in self.context.pages if page is not self._first_page]
        for page in used:
            if page.url != "about:blank":
                page.goto("about:blank")
        if len(used) > LEFT_OPEN:
            for page in used:
                page.close()
        self.context.unroute_all()
        self.context.clear_cookies()
        self.context.clear_permissions()
        stored = "local_storage,indexeddb,cache_storage,service_workers,file_systems,shared_storage"
        for origin in self.origins:
            self._protocol.send("Storage.clearDataForOrigin", {"origin": origin, "storageTypes": stored})


@pytest.fixture(scope="package")
def visits(browser: Browser, web: str) -> Iterator[Visits]:
    made = Visits(browser, web)
    yield made
    made.context.close()


class Watch:
    """What a page said that a page should not say: errors, warnings of the console, refused loads."""

    def __init__(self) -> None:
        self.problems: list[str] = []
        self._allowed: list[str] = []

    def allow(self, part: str) -> None:
        """Expect problems that hold this text."""
        self._allowed.append(part)

    def follow(self, page: Page) -> None:
        page.on("console", self._console)
        page.on("pageerror", lambda error: self.problems.append(f"error: {error}"))

    def unexpected(self) -> list[str]:
        return [text for text in self.problems if not any(part in text for part in self._allowed)]

    def _console(self, message: ConsoleMessage) -> None:
        """Note errors and warnings; a load that was refused is one of them, with its status and address."""
        # SwiftShader remarks on reading pixels back when a picture is taken.
        if message.type in ("error", "warning") and "GL Driver Message" not in message.text:
            self.problems.append(f"{message.type}: {message.text} {message.location['url']}")


OpenPage = Callable[..., Page]


@pytest.fixture
def watch() -> Watch:
    """Collects what pages say; the `open_page` fixture fails a test whose pages complained."""
    return Watch()


@pytest.fixture
def open_page(browser: Browser, web: str, watch: Watch, visits: Visits) -> Iterator[OpenPage]:
    """Opens pages: `open_page("/exercises/puma560", lang="ro", width=320, **context_options)`.

    Waits until the page is ready; fails the test at its end if a console error, a violation of the content
    security policy or a failed load was seen. Every page has a profile of its own; the first of a test, if
    neither that nor anything else is asked of it, one that has the scripts and styles already.

    Scenes are drawn as SVG, as in a browser without WebGL, unless a test asks for `webgl`.
    """
    contexts: list[BrowserContext] = []
    visited = False

    def open_(
        path: str,
        *,
        lang: str | None = "en",
        width: int = 1280,
        height: int = 900,
        origin: str | None = None,
        ready: bool = True,
        before: Callable[[Page], Any] | None = None,
        fresh: bool = False,
        webgl: bool = False,
        **options: Any,
    ) -> Page:
        nonlocal visited
        if options or fresh or visited:
            context = new_context(browser, webgl=True, viewport={"width": width, "height": height}, **options)
            contexts.append(context)
            page = context.new_page()
        else:
            visited = True
            visits.origins |= {origin or web}
            page = visits.context.new_page()
            page.set_viewport_size({"width": width, "height": height})
        watch.follow(page)
        if not webgl:
            page.add_init_script(WITHOUT_WEBGL)
        if before is not None:
            before(page)
        path, *fragment = path.split("#")
        query = ("&" if "?" in path else "?") + f"lang={lang}" if lang else ""
        page.goto((origin or web) + "#".join([path + query, *fragment]))
        if ready:
            wait_ready(page)
        return page

    yield open_
    for context in contexts:
        context.close()
    if visited:
        visits.forget()
    assert watch.unexpected() == []


def wait_ready(page: Any) -> None:
    """Wait until the page's script has done its first work."""
    page.locator("html[data-ready=true]").wait_for(state="attached")


_RULES = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"]
_OF_COLOURS = ["color-contrast", "link-in-text-block"]
"""The rules that depend on nothing but colours and sizes of text: the others see one page, light or dark."""
_FINDINGS = """async ([rules, switched]) => {
  for (const picture of document.querySelectorAll("svg[role=img]"))
    [...picture.querySelectorAll("circle")].slice(20).forEach((mark) => mark.remove());
  axe.configure({ noHtml: true });
  const { violations } = await axe.run(document, {
    runOnly: rules, rules: switched, resultTypes: ["violations"], elementRef: true, selectors: false,
    preload: false,
  });
  return violations.map(({ id, help, nodes }) => `${id}: ${help}: ` + nodes.slice(0, 4)
    .map(({ element, failureSummary }) => `${element.outerHTML.slice(0, 300)} ${failureSummary}`).join("; "));
}"""
"""Of the four thousand marks of a plot, which are alike, axe-core looks at a few; and elements are written
out only where they are at fault."""
_COLOURS_ARE_READ_ONCE = """(() => {
  const colour = axe.commons.color.Color.prototype, read = colour.parseString, known = new Map();
  colour.parseString = function (text) {
    if (known.has(text)) [this.r, this.g, this.b, this.alpha] = known.get(text);
    else read.call(this, text);
    known.set(text, [this.r, this.g, this.b, this.alpha]);
    return this;
  };
})()"""
"""For each element axe-core reads the colours of all that lie under it: the same dozen texts, thousands of
times, a quarter of what it costs."""
EVERYTHING = bool(os.environ.get("EVERYTHING"))
"""All rules in all colours at every width (`make accessibility`)."""


class Axe:
    """axe-core's findings on a page as it stands now."""

    def __init__(self, source: str) -> None:
        self._source = source

    def assert_accessible(self, page: Page, *, light_colours: bool = True, dark_colours: bool = True) -> None:
        """Fail with what is found in a light page and, by the rules of colours, in a dark one.

        Where the system forces its colours, axe-core takes the dark ones of the style sheet for the text's.
        """
        if page.evaluate("() => !window.axe"):
            page.evaluate(self._source)
            page.evaluate(_COLOURS_ARE_READ_ONCE)
        off = {} if light_colours or EVERYTHING else {rule: {"enabled": False} for rule in _OF_COLOURS}
        assert self._findings(page, _RULES, off) == []
        if page.evaluate("matchMedia('(forced-colors: active)').matches"):
            return
        if not dark_colours and not EVERYTHING:
            return
        page.emulate_media(color_scheme="dark")
        assert (
            self._findings(page, _RULES if EVERYTHING else {"type": "rule", "values": _OF_COLOURS}, {}) == []
        )
        page.emulate_media(color_scheme="light")

    def _findings(self, page: Page, rules: Any, switched: dict[str, Any]) -> list[str]:
        return page.evaluate(_FINDINGS, [rules, switched])  # type: ignore[no-any-return]


@pytest.fixture(scope="session")
def axe() -> Axe:
    """axe-core, from the development packages that `make` installs."""
    source = ROOT / "node_modules" / "axe-core" / "axe.min.js"
    if not source.is_file():
        reason = "axe-core is not installed (`make vendor` installs it)"
        if os.environ.get("CI"):
            pytest.fail(reason)
        pytest.skip(reason)
    return Axe(source.read_text(encoding="utf-8"))


@pytest.fixture
def assert_accessible(axe: Axe) -> Callable[[Page], None]:
    """Fails with axe-core's findings on the page as it stands now, light and dark."""
    return axe.assert_accessible


SIZES = ((320, 600), (1280, 900))
"""A small phone's and a desktop's window."""


@pytest.fixture
def assert_accessible_at_both_sizes(axe: Axe) -> Callable[[Page], None]:
    """Fails with axe-core's findings in a small window and in a large one, and where a page is wider than it.

    Contrasts, which cost two thirds of it, are those of a light page in the small window and of a dark one in
    the large one; `make accessibility` sees both in both.

    A page that is resized is laid out as one that is opened so; opening it again would take longer than this.
    """

    def check(page: Page) -> None:
        for width, height in SIZES:
            page.set_viewport_size({"width": width, "height": height})
            small = width == SIZES[0][0]
            axe.assert_accessible(page, light_colours=small, dark_colours=not small)
            assert page.evaluate("document.documentElement.scrollWidth <= window.innerWidth"), width

    return check
