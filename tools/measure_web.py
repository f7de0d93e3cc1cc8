"""How soon a page stands and answers on a slow phone, and what travels until then; JSON on standard output.

    python -m tools.measure_web

Each page is opened several times in fresh contexts (nothing cached) with the processor slowed down four
times; medians count.
"""

import json
import statistics
import sys
from typing import Any

from playwright.sync_api import Browser

from tools.web import chromium, service

PAGES = ("/", "/exercises/puma560", "/playground", "/trainer/puma560", "/lesson", "/author")
TYPED = "/exercises/puma560"
SLOW_DOWN = 4
ROUNDS = 5
SETTLED = 3500
"""Milliseconds after which everything that a page loads by itself has been loaded."""

WATCH = """
new MutationObserver(() => {
  if (document.documentElement.dataset.ready && !window.answersAt) {
    requestAnimationFrame(() => (window.answersAt = performance.now()));
  }
}).observe(document, { attributes: true, subtree: true, attributeFilter: ["data-ready"] });
"""
TIMES = """() => ({
  painted: performance.getEntriesByName("first-contentful-paint")[0].startTime,
  answers: window.answersAt,
})"""


def visit(browser: Browser, address: str) -> dict[str, float]:
    """One visit: first contentful paint [ms], controls answer [ms], bytes without fonts."""
    context = browser.new_context(viewport={"width": 412, "height": 915}, device_scale_factor=2)
    page = context.new_page()
    session = context.new_cdp_session(page)
    session.send("Network.enable")
    session.send("Emulation.setCPUThrottlingRate", {"rate": SLOW_DOWN})
    names: dict[str, str] = {}
    sizes: dict[str, float] = {}

    def named(event: dict[str, Any]) -> None:
        names[event["requestId"]] = event["response"]["url"]

    def sized(event: dict[str, Any]) -> None:
        sizes[names.get(event["requestId"], "")] = event["encodedDataLength"]

    session.on("Network.responseReceived", named)
    session.on("Network.loadingFinished", sized)
    page.add_init_script(WATCH)
    page.goto(address)
    page.locator("html[data-ready=true]").wait_for(state="attached")
    page.wait_for_function("window.answersAt")
    times = page.evaluate(TIMES)
    page.evaluate("scrollTo(0, document.body.scrollHeight)")
    page.wait_for_timeout(SETTLED)
    context.close()
    bytes_ = sum(size for name, size in sizes.items() if not name.endswith(".woff2"))
    return {**times, "bytes": bytes_}


FIRST_LINK = """async () => {
  const scene = document.querySelector("#own robot-scene");
  const frame = () => new Promise((done) => requestAnimationFrame(done));
  const typed = await new Promise((done) =>
    document.addEventListener("input", (event) => event.target.id.endsWith("-d") && done(event.timeStamp)));
  let drawn = scene.dataset.drawn;
  while ((scene.model.frames?.length ?? 0) < 2) {
    drawn = scene.dataset.drawn;
    await frame();
  }
  while (scene.dataset.drawn === drawn) await frame();
  return performance.now() - typed;
}"""


def first_link(browser: Browser, address: str) -> float:
    """From the last character of the first row to the frame that shows its link [ms]."""
    context = browser.new_context(viewport={"width": 1280, "height": 800})
    page = context.new_page()
    page.goto(address)
    page.locator("html[data-ready=true]").wait_for(state="attached")
    page.locator("#own robot-scene[data-renderer]").wait_for(state="attached")
    session = context.new_cdp_session(page)
    session.send("Emulation.setCPUThrottlingRate", {"rate": SLOW_DOWN})
    row = page.locator("dh-table-editor tbody tr").first
    for cell in ("alpha", "a"):
        row.locator(f"input[id$='-{cell}']").press_sequentially("0")
    page.evaluate(f"() => {{ window.firstLink = ({FIRST_LINK})(); }}")
    row.locator("input[id$='-d']").press_sequentially("0")
    found: float = page.evaluate("() => window.firstLink")
    context.close()
    return found


def measure() -> dict[str, dict[str, float]]:
    """Medians by page."""
    with service() as origin, chromium() as browser:
        visit(browser, origin + PAGES[0])
        found = {}
        for path in PAGES:
            visits = [visit(browser, f"{origin}{path}?lang=en") for _ in range(ROUNDS)]
            found[path] = {name: statistics.median(one[name] for one in visits) for name in visits[0]}
        drawn = [first_link(browser, f"{origin}{TYPED}?lang=en") for _ in range(ROUNDS)]
        found[TYPED]["drawn"] = statistics.median(drawn)
        return found


if __name__ == "__main__":
    json.dump(measure(), sys.stdout)
