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
from playwright.sync_api import (
    Browser,
    BrowserContext,
    ConsoleMessage,
    Page,
    WebError,
    expect,
    sync_playwright,
)

from service.settings import Settings
from tests.live_service import running
from tests.web.axe import Axe
from tests.web.profiles import PATIENCE, WITHOUT_WEBGL, Visits, new_context

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
expect.set_options(timeout=PATIENCE)

WITHOUT_FRAGMENT = re.compile("^[^#]*$")
"""An address that a page has when it has taken away what was handed over behind its `#`."""

LANGUAGES = ("en", "ro", "pt", "fr", "uk", "es")

UNHURRIED: dict[str, Any] = {"symbolic_seconds": 60.0, "queue_seconds": 300.0}
"""Settings of a service that refuses nothing because a machine is busy: pages would be told of it."""


@pytest.fixture(scope="session")
def web() -> Iterator[str]:
    """Origin of a running service that may be shown in any frame.

    It gives slow machines time: how long an answer may take is not the form's business.
    """
    with running(Settings(frame_ancestors=("*",), **UNHURRIED)) as origin:
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
        started = playwright.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS, timeout=PATIENCE)
        yield started
        started.close()


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

    def follow(self, context: BrowserContext) -> None:
        """Listen to the pages of a profile."""
        context.on("console", self._console)
        context.on("weberror", self._error)

    def leave(self, context: BrowserContext) -> None:
        context.remove_listener("console", self._console)
        context.remove_listener("weberror", self._error)

    def unexpected(self) -> list[str]:
        return [text for text in self.problems if not any(part in text for part in self._allowed)]

    def _error(self, thrown: WebError) -> None:
        self.problems.append(f"error: {thrown.error}")

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
            watch.follow(context)
            page = context.new_page()
            if not webgl:
                page.add_init_script(WITHOUT_WEBGL)
        else:
            visited = True
            visits.origins |= {origin or web}
            watch.follow(visits.context)
            page = visits.page(webgl=webgl)
            page.set_viewport_size({"width": width, "height": height})
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
        watch.leave(visits.context)
    assert watch.unexpected() == []


def wait_ready(page: Any) -> None:
    """Wait until the page's script has done its first work."""
    page.locator("html[data-ready=true]").wait_for(state="attached")


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
