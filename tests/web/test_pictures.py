"""The picture with the table: it grows row by row, stays in sight, plays a row, and lights its cells."""

import base64
import json
import re
from typing import Any

import pytest
from playwright.sync_api import Page, Request, Route, expect

from tests.web.conftest import OpenPage, Watch, wait_ready
from tests.web.driving import PUMA, SCARA, cell, editor, put_table


def until_drawn(page: Page, frames: int) -> None:
    """Wait until so many frames are drawn in the student's scene, frame 0 included."""
    drawn = "document.querySelector('#own robot-scene')?.model?.frames?.length"
    page.wait_for_function(f"() => {drawn} === {frames}")


def test_the_robot_grows_row_by_row(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara", webgl=True)
    order = ("theta", "d", "a", "alpha")
    until_drawn(page, 1)
    for i, row in enumerate(
        [{"alpha": "0", "a": "a2", "d": "0"}, {"alpha": "0", "a": "a3", "d": "0"}, {"alpha": "0", "a": "0"}]
    ):
        for name in order:
            if name in row:
                cell(page, i, name).fill(row[name])
        if i < 2:
            until_drawn(page, i + 2)
    cell(page, 0, "a").fill("(")
    until_drawn(page, 1)


def test_a_drawing_that_did_not_come_is_asked_for_again(open_page: OpenPage, watch: Watch) -> None:
    """A browser shows a picture that was refused once as broken until its page is loaded again."""
    watch.allow("503")
    answers = iter([503, 503])

    def busy(route: Route) -> None:
        if next(answers, None):
            route.fulfill(status=503)
        else:
            route.continue_()

    page = open_page("/exercises/puma560", before=lambda page: page.route("**/figures/*.svg*", busy))
    page.wait_for_function("() => document.querySelector('#figure-drawing').naturalWidth > 0")
    assert next(answers, None) is None


ANSWERED = """
const ask = window.fetch;
window.answered = 0;
window.fetch = async (...given) => {
  const answer = await ask(...given);
  if (answer.url.includes("/figures/")) window.answered += 1;
  return answer;
};
"""
"""Counts the drawings that the page's script was answered about."""


def test_a_drawing_that_is_refused_for_good_is_not_asked_for_again(open_page: OpenPage, watch: Watch) -> None:
    """Nor sooner than the service asks for, where it is busy."""
    watch.allow("404")
    watch.allow("429")
    answers = [(404, {}), (429, {"Retry-After": "60"}), (404, {})]
    asked: list[int] = []

    def refuse(route: Route) -> None:
        status, headers = answers[min(len(asked), 2)]
        asked.append(status)
        route.fulfill(status=status, headers=headers)

    def before(page: Page) -> None:
        page.clock.install(time=0)
        page.clock.pause_at(1000)  # it would go on by itself, and a busy machine would wait for too long
        page.add_init_script(ANSWERED)
        page.route("**/figures/*.svg*", refuse)

    page = open_page("/exercises/puma560", before=before, fresh=True)

    def after(seconds: int, times: int) -> None:
        page.clock.run_for(1000 * seconds)
        page.evaluate("fetch(document.location)")
        while page.evaluate("window.answered") < times - 1:  # the first was the browser's own
            page.wait_for_timeout(20)
        assert len(asked) == times

    after(5, 2)
    after(50, 2)
    after(60, 3)
    for _ in range(3):
        after(600, 3)


def test_a_keystroke_costs_one_call(open_page: OpenPage) -> None:
    calls: list[str] = []
    page = open_page("/exercises/puma560")
    put_table(page, PUMA)
    expect(page.locator("#own")).to_contain_text("Drawn from your table")

    def note(request: Request) -> None:
        if "/api/" in request.url:
            calls.append(request.url.rsplit("/", 1)[1])

    page.on("request", note)
    cell(page, 2, "a").fill("0.5")
    page.wait_for_function(
        "() => document.querySelector('#own robot-scene').model.nodes[3].constant[0][3] === 0.5"
    )
    assert calls == ["understand"]


SIGHT = """() => {
  const seen = (element) => {
    const { x, y, width, height } = element.getBoundingClientRect();
    const inside = x >= -1 && y >= -1 && x + width <= innerWidth + 1 && y + height <= innerHeight + 1;
    const top = document.elementFromPoint(x + width / 2, y + height / 2);
    const shown = top !== null && (element.contains(top) || top.contains(element));
    return inside && shown && width > 40 && height > 20;
  };
  return {
    figure: seen(document.querySelector("#figure-drawing")),
    cell: seen(document.activeElement),
    robot: seen(document.querySelector("#own .scene-view")),
  };
}"""


@pytest.mark.parametrize(("width", "height"), [(1280, 800), (390, 844), (768, 1024)])
def test_figure_row_and_robot_are_in_sight_while_typing(open_page: OpenPage, width: int, height: int) -> None:
    page = open_page("/exercises/puma560", width=width, height=height)
    put_table(page, PUMA)
    expect(page.locator("#own")).to_contain_text("Drawn from your table")
    for row in (0, 3, 5):
        cell(page, row, "a").click()
        cell(page, row, "a").press("End")
        page.wait_for_function(f"() => Object.values(({SIGHT})()).every(Boolean)")
    page.evaluate("document.activeElement.blur()")
    expect(page.locator("html.typing")).to_have_count(0)


def test_a_cell_and_what_it_is_drawn_as_light_each_other(open_page: OpenPage) -> None:
    page = open_page("/exercises/puma560")
    put_table(page, PUMA)
    told = page.locator("#own .own-told")
    expect(told).to_contain_text("Drawn from your table")
    watch = "told => new MutationObserver(() => (told.changed = true)).observe(told, { childList: true })"
    told.evaluate(watch)
    # What is announced stands there a frame later.
    page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    page.evaluate("document.getElementById('announcer').textContent = ''")
    cell(page, 2, "a").focus()
    expect(cell(page, 2, "a")).to_have_class("lit")
    expect(page.locator(".film-text")).to_have_text("Row 3, 2 of 4: move along x₂ by a = 0.4318 m.")
    others = page.locator("#own [role=status]:not(.own-told)").filter(has_text=re.compile("."))
    expect(others).to_have_count(0)
    assert not told.evaluate("told => told.changed")
    expect(page.locator("#announcer")).to_be_empty()
    items = "document.querySelector('#own robot-scene').overlay.items"
    assert page.evaluate(f"{items}.filter((item) => item.tone === 'lit').length") > 0
    page.evaluate(
        """() => document.querySelector("#own robot-scene")
          .dispatchEvent(new CustomEvent("scene-pick", { detail: { id: "3/d" }, bubbles: true }))"""
    )
    expect(cell(page, 3, "d")).to_be_focused()


def test_a_row_is_gone_through_step_by_step_and_back(open_page: OpenPage) -> None:
    """Without motion the film goes on in stills; its last one is where the service has the frame."""
    page = open_page("/exercises/scara", webgl=True)
    put_table(page, SCARA)
    expect(page.locator("#own")).to_contain_text("Drawn from your table")
    page.get_by_role("button", name="Play row 2 in the picture").click()
    text = page.locator(".film-text")
    expect(text).to_contain_text("Row 2, 1 of 4: turn about x₁ by α = 0°.")
    for wanted in ("2 of 4: move along x₁ by a = 0.4 m.", "3 of 4: turn about z₂", "4 of 4: move along z₂"):
        page.get_by_role("button", name="One step forward").click()
        expect(text).to_contain_text(wanted)
        expect(page.locator("#announcer")).to_contain_text(wanted)
    ends = page.evaluate(
        """async () => {
          const base = new URL(document.documentElement.dataset.assets, location.href).href;
          const { poses } = await import(`${base}/js/scene/model.js`);
          const scene = document.querySelector("#own robot-scene");
          return [scene.overlay.nodes[0].constant, poses(scene.model, scene.joints)[scene.model.frames[2]]];
        }"""
    )
    for one, other in zip(ends[0], ends[1], strict=True):
        assert one == pytest.approx(other, abs=1e-12)
    page.get_by_role("button", name="One step back").click()
    expect(text).to_contain_text("3 of 4")


def test_a_film_of_no_row_is_said_not_to_be_there(open_page: OpenPage) -> None:
    """Its buttons threw an error where not even the first row has numbers."""
    page = open_page("/exercises/scara")
    until_drawn(page, 1)
    page.locator(".film").get_by_role("button", name="Play").click()
    expect(page.locator("#announcer")).to_contain_text("Row 1")
    page.get_by_role("button", name="One step forward").click()
    put_table(page, SCARA)
    expect(page.locator("#own")).to_contain_text("Drawn from your table")
    page.locator(".film").get_by_role("button", name="Play").click()
    expect(page.locator(".film-text")).to_contain_text("Row 1")


def test_rows_stay_the_same_elements(open_page: OpenPage) -> None:
    page = open_page("/exercises/puma560")
    put_table(page, PUMA)
    cell(page, 3, "a").focus()
    page.evaluate("document.activeElement.dataset.mark = 'mine'")
    page.keyboard.press("Alt+ArrowUp")
    expect(cell(page, 2, "a")).to_be_focused()
    assert cell(page, 2, "a").get_attribute("data-mark") == "mine"
    editor(page).locator(".add-row").click()
    assert cell(page, 2, "a").get_attribute("data-mark") == "mine"


def test_a_scene_is_kept_as_a_picture_and_fills_the_screen(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara", webgl=True)
    put_table(page, SCARA)
    expect(page.locator("#own")).to_contain_text("Drawn from your table")
    data: str = page.evaluate(
        """async () => {
          const blob = await document.querySelector("#own robot-scene").picture();
          const bytes = new Uint8Array(await blob.arrayBuffer());
          return btoa(String.fromCharCode(...bytes));
        }"""
    )
    png = base64.b64decode(data)
    assert png.startswith(b"\x89PNG")
    assert len(png) > 3000
    page.locator("#own .scene-enlarge").click()
    expect(page.locator("#own robot-scene")).to_have_class("enlarged")
    box: dict[str, Any] = page.locator("#own robot-scene").bounding_box() or {}
    assert json.dumps([box["width"], box["height"]]) == json.dumps([1280, 900])
    page.keyboard.press("Escape")
    expect(page.locator("#own robot-scene.enlarged")).to_have_count(0)


@pytest.mark.parametrize("language", ["en", "uk"])
def test_the_lesson_moves_its_frames_and_is_reached_from_the_terms(
    open_page: OpenPage, language: str
) -> None:
    page = open_page("/exercises/twolink", lang=language, webgl=language == "en")
    for place in ("theta", "d", "a", "alpha", "variable", "conventions"):
        assert page.locator(f'a[href*="/lesson?lang={language}#{place}"]').count() > 0, place
    page.locator('a.term[href$="#alpha"]').click()
    page.wait_for_url("**/lesson?**")
    wait_ready(page)
    expect(page.locator("#four-numbers robot-scene")).to_have_count(2)
    scenes = "[...document.querySelectorAll('#four-numbers robot-scene')]"
    pose = f"{scenes}.map((scene) => scene.overlay.nodes[0].constant)"
    before = page.evaluate(pose)
    page.locator("#four-numbers input[type=range]").nth(2).fill("0")
    after = page.evaluate(pose)
    assert before[0] != after[0]
    assert before[1] != after[1]
    assert "lesson-" not in page.locator("main").inner_text()


def test_the_lesson_is_accessible(open_page: OpenPage, assert_accessible_at_both_sizes: Any) -> None:
    page = open_page("/lesson")
    expect(page.locator("#two-axes robot-scene")).to_be_visible()
    assert_accessible_at_both_sizes(page)
