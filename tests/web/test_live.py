"""The student's robot while they type and drag: at once, in order, and no more traffic than promised."""

import numpy as np
import pytest
from playwright.sync_api import CDPSession, Page, Route, expect

from tests.web.answers import PUMA_VALUES
from tests.web.conftest import OpenPage, Watch
from tests.web.driving import PUMA, SCARA, cell, put_table, rows

FIRST_LOAD = 350_000
"""Bytes that may travel, compressed, without fonts."""


LATE = """
const real = window.fetch;
window.late = {};
window.fetch = async (address, options) => {
  const waits = window.late[String(address).split("/").pop()];
  const answer = await real(address, options);
  if (waits?.length) await new Promise((resolve) => setTimeout(resolve, waits.shift()));
  return answer;
};
"""
TWO_LINKS = {
    "convention": "standard",
    "rows": rows("standard", "θ1 0 a2 0\nθ2 0 a3 0"),
}
ASKS_FOR_NO_MATRICES = "/exercises/scara-own-inverse"
"""Where a part asks for matrices they are shown when it is right."""


def delay(page: Page, call: str, *milliseconds: int) -> None:
    """Hold back the next answers of a call."""
    page.evaluate("([call, waits]) => (window.late[call] = waits)", [call, list(milliseconds)])


def open_matrices(page: Page) -> None:
    """Once the robot is drawn: until then what is above the matrices grows, and a click may miss them."""
    expect(page.locator("#own .own-status")).to_contain_text("Drawn from your table")
    page.locator("#own details > summary").last.click()
    expect(page.locator("matrix-panel .matrix-block")).not_to_have_count(0)


def first_number(page: Page) -> str:
    """The upper left entry of ⁰T_N as it is shown."""
    return page.locator("matrix-panel .bracketed mn").first.text_content() or ""


def test_the_scene_follows_a_slider_without_the_network(open_page: OpenPage, watch: Watch) -> None:
    watch.allow("ERR_FAILED")
    page = open_page("/exercises/scara", webgl=True)
    put_table(page, SCARA)
    expect(page.locator("#own")).to_contain_text("Drawn from your table: 4 joints.")
    page.wait_for_load_state("networkidle")
    page.route("**/api/**", lambda route: route.abort())
    followed = page.evaluate(
        """async () => {
          const slider = document.querySelector("#own joint-sliders input[type=range]");
          const scene = document.querySelector("#own robot-scene");
          const frame = () => new Promise(requestAnimationFrame);
          const places = [];
          for (const value of [10, 20, 30, 40, 50]) {
            slider.value = value;
            slider.dispatchEvent(new Event("input", { bubbles: true }));
            await frame();
            await frame();
            const labels = [...scene.querySelectorAll(".scene-label")];
            places.push(labels.map((label) => label.style.transform).join());
          }
          return { places: new Set(places).size, joint: scene.joints[0] };
        }"""
    )
    assert followed["places"] == 5
    assert abs(followed["joint"] - 50 * 3.141592653589793 / 180) < 1e-9


def test_the_scene_agrees_with_the_service(open_page: OpenPage, web: str) -> None:
    """The one thing that the browser does by itself, held against the frames that the API returns."""
    page = open_page("/exercises/puma560")
    for convention in ("modified", "standard"):
        typed = [dict(row) for row in PUMA["rows"]]
        typed[1]["theta"], typed[3]["theta"] = "-θ2 + 30", "θ4 - 90"
        put_table(page, {"convention": convention, "rows": typed})
        expect(page.locator("#own robot-scene:not(.stale, [aria-busy])")).to_be_visible()
        joints = [12.0, 33.0, -70.0, 45.0, 101.0, -5.0]
        for i, value in enumerate(joints):
            page.get_by_label(f"q{i + 1} in °").fill(str(value))
        table = page.evaluate("document.querySelector('dh-table-editor').table")
        body = {"table": table, "parameters": PUMA_VALUES, "joints": joints, "parts": ["frames"]}
        answer = page.request.post(f"{web}/api/v1/forward-kinematics", data=body).json()
        drawn = page.evaluate(
            """async () => {
              const base = document.documentElement.dataset.assets;
              const { poses } = await import(new URL(`${base}/js/scene/model.js`, location.href).href);
              const scene = document.querySelector("#own robot-scene");
              const triads = scene.model.items.filter((item) => item.kind === "arrow" && item.tone === "x");
              const found = poses(scene.model, scene.joints);
              return triads.slice(1).map((arrow) => found[arrow.from.node]);
            }"""
        )
        assert len(drawn) == 6
        assert np.array(drawn) == pytest.approx(np.array(answer["frames"]), abs=1e-9)


def test_matrices_shown_are_those_of_the_last_joint_values(open_page: OpenPage) -> None:
    """While a slider is dragged, answers are slow and of different slowness; the last one is what stays."""
    page = open_page(ASKS_FOR_NO_MATRICES, before=lambda page: page.add_init_script(LATE))
    put_table(page, TWO_LINKS)
    open_matrices(page)
    delay(page, "forward-kinematics", 500, 50, 300, 0)
    number = page.get_by_label("q1 in °")
    for value in ("10", "20", "30", "40", "60"):
        number.fill(value)
        page.wait_for_timeout(40)
    expect(page.locator("matrix-panel .bracketed mn").first).to_have_text("0.5")
    page.wait_for_timeout(700)
    assert first_number(page) == "0.5"


def test_the_robot_shown_is_that_of_the_last_table(open_page: OpenPage) -> None:
    """Answers about what was typed before are dropped, in whatever order they arrive."""
    page = open_page(ASKS_FOR_NO_MATRICES, before=lambda page: page.add_init_script(LATE))
    put_table(page, {"convention": "standard", "rows": rows("standard", "θ1 0 1 0\nθ2 0 1 0")})
    open_matrices(page)
    delay(page, "understand", 1000, 0, 0)
    cell(page, 1, "a").fill("2")
    page.wait_for_timeout(400)
    cell(page, 1, "a").fill("3")
    sum_of_lengths = page.locator("matrix-panel .matrix-block").first.locator(".bracketed mn").nth(3)
    expect(sum_of_lengths).to_have_text("4")
    page.wait_for_timeout(1000)
    expect(sum_of_lengths).to_have_text("4")


def test_matrices_in_symbols_and_their_sources(open_page: OpenPage) -> None:
    page = open_page(ASKS_FOR_NO_MATRICES)
    page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    put_table(page, TWO_LINKS)
    open_matrices(page)
    page.locator("matrix-panel input[value=symbols]").check()
    first = page.locator("matrix-panel .matrix-block").first
    expect(first.locator(".formula math")).to_have_count(1)
    expect(first.locator("annotation")).to_contain_text("c_{12}")
    page.locator("matrix-panel input[value=full]").check()
    expect(first.locator("annotation")).to_contain_text(r"\cos(\theta_{1}+\theta_{2})")
    for label, part in (
        ("LaTeX", r"\begin{bmatrix}"),
        ("Python", "def "),
        ("C", "double"),
        ("MATLAB", "function"),
    ):
        first.get_by_role("button", name=label, exact=True).click()
        expect(page.locator("#announcer")).to_have_text(f"Copied as {label}")
        assert part in page.evaluate("navigator.clipboard.readText()")


@pytest.mark.parametrize("status", [None, 429, 503])
def test_matrices_are_asked_again_until_they_come(
    open_page: OpenPage, watch: Watch, status: int | None
) -> None:
    """The service is away or busy, and the robot stays where it was brought to."""
    for passing in ("ERR_FAILED", "429", "503"):
        watch.allow(passing)
    page = open_page(ASKS_FOR_NO_MATRICES)
    put_table(page, TWO_LINKS)
    failed: list[str] = []

    def fail_first(route: Route) -> None:
        failed.append(route.request.url)
        if len(failed) > 1:
            route.continue_()
        elif status is None:
            route.abort()
        else:
            route.fulfill(status=status, json={"title": "Busy", "code": "busy"})

    page.route("**/forward-kinematics", fail_first)
    expect(page.locator("#own .own-status")).to_contain_text("Drawn from your table")
    page.get_by_label("q1 in °").fill("60")
    open_matrices(page)
    expect(page.locator("matrix-panel .bracketed mn").first).to_have_text("0.5")
    expect(page.locator("#own .own-status")).to_contain_text("Drawn from your table")
    expect(page.get_by_label("q1 in °")).to_have_value("60")
    assert len(failed) == 2


def transferred(page: Page, session: CDPSession) -> dict[str, int]:
    addresses: dict[str, str] = {}
    sizes: dict[str, int] = {}
    session.on("Network.responseReceived", lambda e: addresses.update({e["requestId"]: e["response"]["url"]}))
    session.on(
        "Network.loadingFinished",
        lambda e: sizes.update({addresses.get(e["requestId"], "?"): int(e["encodedDataLength"])}),
    )
    return sizes


def test_the_first_load_is_small_and_all_our_own(open_page: OpenPage, web: str) -> None:
    """A wide window, so that both robots are on the screen: everything that is ever loaded is loaded."""
    sizes: dict[str, int] = {}

    def listen(page: Page) -> None:
        nonlocal sizes
        session = page.context.new_cdp_session(page)
        session.send("Network.enable")
        session.send("Network.setExtraHTTPHeaders", {"headers": {"Accept-Encoding": "gzip"}})
        sizes = transferred(page, session)

    for path in ("/", "/exercises/puma560"):
        page = open_page(path, height=2000, before=listen, fresh=True, webgl=True)
        if "exercises" in path:
            put_table(page, PUMA)
            expect(page.locator("#own robot-scene")).to_have_attribute("data-renderer", "webgl")
            expect(page.locator(".meaning math").first).to_be_visible()
        page.wait_for_load_state("networkidle")
        assert all(address.startswith((web, "data:")) for address in sizes)
        loaded = {address: size for address, size in sizes.items() if not address.endswith(".woff2")}
        typed = ("/understand", "/forward-kinematics")
        total = sum(size for address, size in loaded.items() if not address.endswith(typed))
        assert 20_000 < total <= FIRST_LOAD, sorted(loaded.items(), key=lambda item: -item[1])[:8]
