"""Where the form has to work: phones, foreign frames, prefixes, no WebGL, no storage, keyboard alone."""

import contextlib
import re
import threading
from collections.abc import Callable, Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest
from playwright.sync_api import Page, ViewportSize, expect

from service.settings import Settings
from tests.live_service import running
from tests.web.axe import EVERYTHING
from tests.web.conftest import LANGUAGES, UNHURRIED, WITHOUT_FRAGMENT, OpenPage, Watch, wait_ready
from tests.web.driving import (
    PUMA,
    SCARA,
    all_right,
    cell,
    editor,
    fill_table,
    joint,
    put_table,
    submit,
    switch_language,
)
from tests.web.test_playground import column, shown_robot

TWO_FRAMES = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
"""After them is drawn what there was to draw."""
SMALL_TARGETS = """() => [...document.querySelectorAll("a, button, input, select, textarea, summary")]
  .filter((node) => node.checkVisibility() && !node.closest("p, li .prose") && !node.matches(".skip"))
  .map((node) => (node.matches("[type=radio], [type=checkbox]") ? (node.closest("label") ?? node) : node))
  .map((node) => ({ html: node.outerHTML.slice(0, 100), box: node.getBoundingClientRect() }))
  .filter(({ box }) => box.width > 0 && (box.width < 24 || box.height < 24))
  .map(({ html, box }) => `${html} ${box.width}x${box.height}`)"""
STORAGE_BLOCKED = """Object.defineProperty(window, "localStorage", {
  get() { throw new DOMException("no", "SecurityError"); },
});"""
NOTHING_LASTS = "The browser stores nothing for this page: what you type is lost when you close or reload it."
SCENE_IN_WORDS = (
    "The frames of your table with their axes x, y and z. "
    "Joints: q1: revolute, q2: revolute, q3: prismatic, q4: revolute. "
    "Arrow keys turn the view, Shift with arrow keys moves it, + and − zoom, 0 shows everything."
)


def overflow(page: Page) -> list[str]:
    """Elements that stick out of the page to the right, apart from what scrolls by itself."""
    return page.evaluate(
        """() => {
          const width = document.documentElement.clientWidth;
          const clips = (node) => getComputedStyle(node).overflowX !== "visible";
          const scrolls = (node) => node && (clips(node) || scrolls(node.parentElement));
          if (document.documentElement.scrollWidth <= width) return [];
          return [...document.body.querySelectorAll("*")]
            .filter((node) => node.getBoundingClientRect().right > width + 1 && !scrolls(node.parentElement))
            .map((node) => node.outerHTML.slice(0, 120));
        }"""
    )


def the_bar_is_one_line_from_large_phones_on(page: Page, _language: str) -> None:
    for width in (440, 520, 550, 610, 680, 900):
        page.set_viewport_size({"width": width, "height": 600})
        nav, choice = page.locator(".bar-nav").bounding_box(), page.locator(".bar-language").bounding_box()
        assert nav
        assert choice
        assert choice["y"] < nav["y"] + nav["height"] / 2, width


def the_types_of_joints_are_not_cut(page: Page, _language: str) -> None:
    page.set_viewport_size(DESKTOP)
    needed, given = joint(page, 0).evaluate(
        """(select) => {
          const free = select.cloneNode(true);
          Object.assign(free.style, { width: "max-content", position: "absolute" });
          select.after(free);
          const widths = [free.offsetWidth, select.offsetWidth];
          free.remove();
          return widths;
        }"""
    )
    assert needed <= given


def it_starts_with_a_robot_and_reads_a_decimal_comma_where_the_language_writes_one(
    page: Page, language: str
) -> None:
    page.set_viewport_size(DESKTOP)
    shown_robot(page)
    text = page.locator("main").inner_text()
    assert "playground-" not in text
    assert "form-" not in text
    assert len(column(page, "a")) == 6
    if language == "en":
        return
    field = page.locator("dh-table-editor tbody tr:nth-child(2) input[id$='-a']")
    field.fill("1,25")
    expect(field.locator("xpath=ancestor::td")).to_contain_text("54")  # 5/4
    expect(field).not_to_have_attribute("aria-invalid", "true")
    assert column(page, "a")[1] == "1.25"
    number = page.locator("joint-sliders .joint-number input").first
    number.fill("22,5")
    number.blur()
    expect(number).to_have_value("22.5")


def the_trainer_speaks_it(page: Page, _language: str) -> None:
    expect(page.locator("fieldset.choices")).to_have_count(1)
    page.locator("fieldset.choices input").last.check()
    text = page.locator("main").inner_text()
    assert not re.search(r"\b(trainer|form|rule)-[a-z]", text)


DESKTOP: ViewportSize = {"width": 1280, "height": 900}
PAGES: dict[str, Callable[[Page, str], None]] = {
    "/": the_bar_is_one_line_from_large_phones_on,
    "/exercises/puma560": the_types_of_joints_are_not_cut,
    "/playground": it_starts_with_a_robot_and_reads_a_decimal_comma_where_the_language_writes_one,
    "/trainer/puma560": the_trainer_speaks_it,
}
"""What else holds of a page in every language."""
SPOKEN = {
    "/": ("en", "fr", "uk"),
    "/exercises/puma560": ("en", "es", "uk"),
    "/playground": ("en", "pt", "uk"),
    "/trainer/puma560": ("en", "ro", "uk"),
}
"""Ukrainian, whose words are longest on average, everywhere, and each other language somewhere."""
if EVERYTHING:
    SPOKEN = dict.fromkeys(PAGES, LANGUAGES)


@pytest.mark.parametrize("path", PAGES)
def test_a_page_in_any_language_fits_a_small_phone(open_page: OpenPage, path: str) -> None:
    """320 × 600 is also what 1280 × 2400 is at 400 % zoom. WCAG 2.5.8: 24 px, apart from links in text."""
    page = open_page(path, lang="en", width=320, height=600)
    english = page.locator("h1").inner_text()
    for language in SPOKEN[path]:
        if language != "en":
            page.evaluate("localStorage.clear()")
            page.set_viewport_size({"width": 320, "height": 600})
            page.goto(
                page.url.replace(f"lang={page.locator('html').get_attribute('lang')}", f"lang={language}")
            )
            wait_ready(page)
        assert page.locator("html").get_attribute("lang") == language
        assert overflow(page) == []
        assert page.evaluate(SMALL_TARGETS) == []
        visible = page.locator("body").inner_text()
        assert page.locator("h1").inner_text() != english or language == "en" or path.startswith("/exercises")
        assert not re.search(r"\b(form|playground|trainer)-[a-z]|undefined|\[object|NaN", visible)
        PAGES[path](page, language)


@pytest.mark.parametrize("language", ["fr", "uk"] if EVERYTHING else ["uk"])
def test_what_is_open_refused_and_judged_fits_a_small_phone(open_page: OpenPage, language: str) -> None:
    page = open_page("/exercises/puma560", lang=language, width=320, height=600)
    put_table(page, {**PUMA, "rows": [{**row, "a": "a2*(", "d": ""} for row in PUMA["rows"]]})
    page.locator("button[type=submit].primary").click()
    expect(page.locator(".editor-summary")).to_be_focused()
    assert overflow(page) == []
    put_table(page, {**PUMA, "rows": [{**row, "alpha": "45"} for row in PUMA["rows"]]})
    page.evaluate("for (const each of document.querySelectorAll('main details')) each.open = true")
    expect(page.locator("#part-schematic select").first).to_be_visible()
    assert overflow(page) == []
    submit(page)
    expect(page.locator(".links-table")).to_be_visible()
    assert overflow(page) == []


def test_the_table_has_room_at_400_percent(open_page: OpenPage) -> None:
    """Of 256 px, which 1024 px are at this zoom, pictures and progress left only the row of a cell."""
    page = open_page("/exercises/scara", width=320, height=256)
    typed = cell(page, 1, "d")
    typed.click()
    below = """cell => {
      cell.scrollIntoView({ block: "center" });
      const { left, bottom } = cell.getBoundingClientRect();
      return Boolean(document.elementFromPoint(left + 20, bottom + 40)?.closest("dh-table-editor"));
    }"""
    page.wait_for_function(below, arg=typed.element_handle())


def test_a_finger_that_scrolls_over_the_robot_leaves_it_as_it_stood(open_page: OpenPage) -> None:
    """It turned by what the finger had moved before the browser took it for scrolling."""
    page = open_page("/exercises/scara", width=390, height=700, has_touch=True, is_mobile=True)
    page.locator("#figure-mode").get_by_text("3-D").tap()
    scene = page.locator("#figure-card robot-scene")
    scene.evaluate("scene => scene.scrollIntoView({ block: 'center' })")
    expect(scene).to_have_attribute("data-drawn", re.compile(r"\d"))
    page.evaluate(TWO_FRAMES)
    drawn, box, start = (
        scene.locator("svg").first.inner_html(),
        scene.bounding_box(),
        page.evaluate("scrollY"),
    )
    assert box
    touch = page.context.new_cdp_session(page)
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def touched(kind: str, *points: float) -> None:
        touch.send(
            "Input.dispatchTouchEvent", {"type": kind, "touchPoints": [{"x": x, "y": at} for at in points]}
        )

    touched("touchStart", y)
    for step in range(1, 9):
        touched("touchMove", y - 12 * step)
    touched("touchEnd")
    page.wait_for_function("start => scrollY > start", arg=start)
    page.evaluate(TWO_FRAMES)
    assert scene.locator("svg").first.inner_html() == drawn


def test_a_phone_grades_an_exercise_by_touch(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara", width=390, height=700, has_touch=True, is_mobile=True, webgl=True)
    expect(page.locator(".keys")).to_have_count(2)
    expect(page.locator(".keys:visible")).to_have_count(0)
    page.locator("#figure-mode label").nth(1).tap()
    expect(page.locator("#figure-body robot-scene")).to_be_visible()
    fill_table(page, SCARA)
    own = page.locator("#own robot-scene")
    own.scroll_into_view_if_needed()
    expect(own).to_have_attribute("data-renderer", "webgl")
    submit(page)
    assert all_right(page)
    assert overflow(page) == []


@contextlib.contextmanager
def other_origin(folder: Path) -> Iterator[str]:
    """A site of somebody else."""

    class Quiet(SimpleHTTPRequestHandler):
        def log_message(self, *_: object) -> None:
            return

    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=str(folder)))
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        yield f"http://localhost:{server.server_port}"
    finally:
        server.shutdown()
        server.server_close()
        thread.join()


SANDBOXES = {
    "free": "",
    "same origin": 'sandbox="allow-scripts allow-forms allow-same-origin"',
    "no origin": 'sandbox="allow-scripts allow-forms"',
    "scripts only": 'sandbox="allow-scripts"',
}
"""From the least strict to the strictest; `make accessibility` tries those between, too."""


@pytest.mark.parametrize("sandbox", SANDBOXES if EVERYTHING else ("free", "scripts only"))
def test_an_exercise_is_graded_inside_a_frame_of_another_origin(
    open_page: OpenPage, web: str, tmp_path: Path, sandbox: str
) -> None:
    (tmp_path / "course.html").write_text(
        '<!doctype html><link rel=icon href="data:,"><title>Course</title>'
        f'<iframe title="Exercise" width="600" height="600" {SANDBOXES[sandbox]} '
        f'src="{web}/exercises/scara?lang=en"></iframe>'
    )
    with other_origin(tmp_path) as origin:
        page = open_page("/course.html", origin=origin, lang=None, ready=False, webgl=True)
        frame = page.frame_locator("iframe")
        frame.locator("html[data-ready=true].embedded").wait_for(state="attached")
        inner = page.frames[1]
        put_table(inner, SCARA)
        inner.locator("button[type=submit].primary").click()
        expect(inner.locator("#verdict")).to_contain_text("Your table describes this robot.")
        inner.locator("#own robot-scene").scroll_into_view_if_needed()
        expect(inner.locator("#own robot-scene")).to_have_attribute("data-renderer", "webgl")
        expect(inner.locator(".meaning math").first).to_be_visible()
        if sandbox in ("no origin", "scripts only"):  # elsewhere it is the browser's business
            expect(inner.locator(".notice-warn")).to_have_text(re.compile(NOTHING_LASTS))
        assert page.context.cookies() == []


def test_in_a_frame_without_an_origin_every_page_works_and_keeps_what_it_can(
    open_page: OpenPage, web: str, tmp_path: Path
) -> None:
    (tmp_path / "course.html").write_text(
        f'<!doctype html><link rel=icon href="data:,"><title>Course</title><iframe title="Framewise" '
        f'width="900" height="800" {SANDBOXES["scripts only"]} src="{web}/exercises/scara?lang=en"></iframe>'
    )
    with other_origin(tmp_path) as origin:
        page = open_page("/course.html", origin=origin, lang=None, ready=False)
        frame = page.frames[1]
        ready = page.frame_locator("iframe").locator("html[data-ready=true]")
        ready.wait_for(state="attached")
        cell(frame, 1, "a").fill("a2 + 0")
        cell(frame, 2, "a").fill("a3 + 0")
        expect(frame.locator(".notice-warn")).to_have_count(1)
        switch_language(frame, "es")
        frame.wait_for_url("**lang=es**")
        ready.wait_for(state="attached")
        expect(cell(frame, 1, "a")).to_have_value("a2 + 0")
        cell(frame, 1, "a").fill("a2")
        frame.locator(".editor-steps button").last.click()
        frame.locator("dialog textarea").fill("0 0 0 θ1\n0 a2 0 θ2")
        frame.locator("dialog button.primary").click()
        expect(editor(frame).locator("tbody tr")).to_have_count(2)
        expect(frame.locator(".notice-warn")).to_have_count(0)
        for path, shown in (
            ("/", ".exercise-card"),
            ("/playground", ".own-status"),
            ("/trainer/puma560", ".choice"),
        ):
            frame.goto(f"{web}{path}?lang=en")
            ready.wait_for(state="attached")
            expect(frame.locator(shown).first).to_be_visible()
        expect(frame.locator("robot-scene")).to_be_visible()


def test_a_full_storage_is_said_once_and_costs_nothing(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara")
    page.evaluate(
        """() => {
          for (let size = 1 << 22; size >= 1; size >>= 1) {
            const text = "x".repeat(size);
            try { for (let i = 0; ; i += 1) localStorage.setItem(`full-${size}-${i}`, text); } catch {}
          }
        }"""
    )
    notice = page.locator(".notice-warn", has_text=NOTHING_LASTS)
    put_table(page, SCARA)
    expect(notice).to_have_count(1)
    expect(page.locator("#announcer")).to_have_text(NOTHING_LASTS)
    page.locator("main").get_by_role("button", name="Close").click()
    expect(notice).to_have_count(0)
    cell(page, 1, "a").fill("a2 + 0")
    submit(page)
    expect(page.locator("#history li")).to_have_count(1)
    expect(notice).to_have_count(0)


def test_an_exercise_open_in_two_tabs_says_so_and_takes_what_the_other_holds(open_page: OpenPage) -> None:
    first = open_page("/exercises/scara")
    second = first.context.new_page()
    second.goto(first.url)
    wait_ready(second)
    warning = first.locator(".notice-warn", has_text="open in another tab")
    put_table(first, SCARA)
    expect(second.locator(".notice-warn")).to_have_count(1)
    cell(second, 0, "d").fill("L1 + 0")
    cell(second, 0, "d").fill("L1")
    expect(warning).to_have_count(1)
    warning.get_by_role("button", name="Show what was typed there").click()
    expect(warning).to_have_count(0)
    expect(cell(first, 0, "d")).to_have_value("L1")
    expect(cell(first, 1, "a")).to_have_value("")
    expect(cell(second, 0, "d")).to_have_value("L1")


def test_a_page_in_a_frame_is_refused_where_the_settings_name_no_frame(
    open_page: OpenPage, tmp_path: Path, watch: Watch
) -> None:
    watch.allow("frame-ancestors")
    watch.allow("ERR_BLOCKED_BY_RESPONSE")
    with running(Settings()) as service:
        (tmp_path / "course.html").write_text('<link rel=icon href="data:,"><iframe></iframe>')
        with other_origin(tmp_path) as origin:
            page = open_page("/course.html", origin=origin, lang=None, ready=False)
            with page.expect_console_message(lambda said: "frame-ancestors" in said.text):
                page.locator("iframe").evaluate(
                    "(frame, address) => (frame.src = address)", f"{service}/?lang=en"
                )
            assert page.frames[1].locator("html[data-page=home]").count() == 0


def test_without_storage_a_draft_lives_in_the_page_and_through_a_change_of_language(
    open_page: OpenPage,
) -> None:
    page = open_page("/exercises/scara", before=lambda page: page.add_init_script(STORAGE_BLOCKED))
    cell(page, 1, "a").fill("a2 + 0")
    switch_language(page, "es")
    page.wait_for_url("**lang=es**")
    page.locator("html[lang=es][data-ready=true]").wait_for(state="attached")
    expect(cell(page, 1, "a")).to_have_value("a2 + 0")
    expect(page).to_have_url(WITHOUT_FRAGMENT)


def test_without_webgl_the_robots_are_drawn_as_svg(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara")
    put_table(page, SCARA)
    scene = page.locator("#own robot-scene")
    expect(scene).to_have_attribute("data-renderer", "svg")
    expect(scene.locator("svg.scene-svg line").first).to_be_attached()
    before = scene.locator("svg.scene-svg").inner_html()
    page.get_by_label("Joint angle q1").fill("60")
    page.wait_for_function(
        "([scene, before]) => scene.querySelector('svg.scene-svg').innerHTML !== before",
        arg=[scene.element_handle(), before],
    )
    submit(page)
    assert all_right(page)


def test_robots_are_on_paper_what_they_are_on_the_screen(open_page: OpenPage) -> None:
    """What WebGL had drawn was blank in print, beneath labels that stood elsewhere."""
    page = open_page("/exercises/scara", webgl=True)
    put_table(page, SCARA)
    scene = page.locator("#own robot-scene")
    expect(scene).to_have_attribute("data-renderer", "webgl")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    page.emulate_media(media="print")
    expect(scene.locator(".scene-paper > *").first).to_be_visible()
    expect(scene.locator("canvas")).to_be_hidden()
    convention = page.locator(".editor-bar fieldset").first.locator("label")  # without it a table says little
    expect(convention.filter(has=page.locator(":checked"))).to_be_visible()
    expect(convention.filter(has=page.locator(":not(:checked)"))).to_be_hidden()
    page.emulate_media(media="screen")
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    expect(scene.locator(".scene-paper")).to_have_count(0)
    expect(scene.locator("canvas")).to_be_visible()


def test_a_sheet_says_everything_that_is_asked_in_black(open_page: OpenPage) -> None:
    """Folded parts and rules were left out, wide matrices cut, and a dark page was printed in light grey."""
    page = open_page("/exercises/puma560")
    page.emulate_media(media="print", color_scheme="light")
    ink = "getComputedStyle(document.querySelector('#statement')).color"
    black = page.evaluate(ink)
    page.emulate_media(media="print", color_scheme="dark")
    assert page.evaluate(ink) == black
    for folded in ("#givens details li", "#part-link_matrices .hint", "#part-pose .matrix-cells"):
        expect(page.locator(folded).first).to_be_visible()
    expect(page.locator("#sharing")).to_be_hidden()
    assert page.locator(".scroller").first.evaluate("at => getComputedStyle(at).overflowX") == "visible"
    assert page.locator("#figure-drawing").evaluate("({ height }) => height") < 400
    expect(page.locator("#own-card")).to_be_hidden()
    columns = "at => getComputedStyle(at).gridTemplateColumns.split(' ').length"
    assert page.locator(".matrix-list").evaluate(columns) == 2
    page.emulate_media(media="screen")
    page.locator("#part-link_matrices > summary").click()
    page.locator("#part-link_matrices td input").first.fill("cos(q1)*cos(q2)*cos(q3)")
    put_table(page, PUMA)
    expect(page.locator("#own")).to_contain_text("Drawn from your table")
    page.emulate_media(media="print")
    assert page.locator(".matrix-list").evaluate(columns) == 1
    expect(page.locator("#own-card")).to_be_visible()


def test_a_lost_context_falls_back_to_svg(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara", webgl=True)
    put_table(page, SCARA)
    scene = page.locator("#own robot-scene")
    expect(scene).to_have_attribute("data-renderer", "webgl")
    lose = "canvas => canvas.getContext('webgl2').getExtension('WEBGL_lose_context').loseContext()"
    scene.locator("canvas").evaluate(lose)
    expect(scene).to_have_attribute("data-renderer", "svg")
    expect(scene.locator("svg.scene-svg line").first).to_be_attached()


def test_a_scene_that_is_gone_holds_no_context(open_page: OpenPage) -> None:
    """A browser has sixteen: each verdict with a picture took one, in the end the own robot's."""
    page = open_page("/exercises/scara", webgl=True)
    put_table(page, SCARA)
    scene = page.locator("#own robot-scene")
    expect(scene).to_have_attribute("data-renderer", "webgl")
    is_lost = page.evaluate("""async () => {
      const scene = document.querySelector("#own robot-scene"), place = scene.parentElement;
      const context = scene.querySelector("canvas").getContext("webgl2"), found = [];
      const told = async () => { await Promise.resolve(); found.push(context.isContextLost()); };
      scene.remove();
      place.prepend(scene);  // it is only moved
      await told();
      scene.remove();
      await told();
      place.prepend(scene);
      return found;
    }""")
    assert is_lost == [False, True]
    expect(scene).to_have_attribute("data-renderer", "webgl")
    expect(scene.locator("canvas")).to_have_count(1)
    expect(scene.locator("svg.scene-svg")).to_have_count(0)


def test_everything_works_under_a_prefix(open_page: OpenPage) -> None:
    with running(Settings(prefix="/robotics/dh", **UNHURRIED)) as origin:
        page = open_page("/robotics/dh/", origin=origin)
        page.get_by_role("link", name="SCARA", exact=True).click()
        page.wait_for_url("**/robotics/dh/exercises/scara?lang=en")
        wait_ready(page)
        put_table(page, SCARA)
        submit(page)
        assert all_right(page)
        page.get_by_role("link", name="Playground").click()
        page.wait_for_url("**/robotics/dh/playground?lang=en")
        wait_ready(page)
        page.goto("about:blank")


def tab_to(page: Page, description: str, found: str, most: int = 400) -> None:
    """Press Tab until the focus is on what is wanted, as somebody without a mouse does."""
    for _ in range(most):
        page.keyboard.press("Tab")
        if page.evaluate(f"() => {found}"):
            return
    raise AssertionError(f"Tab does not lead to {description}")


def test_puma_is_graded_with_the_keyboard_alone(open_page: OpenPage) -> None:
    page = open_page("/exercises/puma560")
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.className") == "skip"
    page.keyboard.press("Enter")
    tab_to(page, "the choice of convention", "document.activeElement.name?.endsWith('-convention')")
    while page.evaluate("document.activeElement.value") != "modified":
        page.keyboard.press("ArrowRight")
    tab_to(page, "the first cell", "document.activeElement.id?.endsWith('-0-alpha')")
    for place, name in enumerate(("alpha", "a", "d")):
        for i, row in enumerate(PUMA["rows"]):
            page.keyboard.press("Control+a")
            page.keyboard.type(row[name])
            page.keyboard.press("ArrowDown" if i < 5 else "Tab")
        if place < 2:
            for _ in range(5):
                page.keyboard.press("ArrowUp")
    page.keyboard.press("Control+Enter")
    expect(page.locator("#verdict-card")).to_be_focused()
    expect(page.locator("#announcer")).to_contain_text("Your table describes this robot.")


def test_the_scene_is_turned_with_the_keyboard(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara", webgl=True)
    put_table(page, SCARA)
    view = page.locator("#own .scene-view")
    label = page.locator("#own .scene-label").first
    expect(page.locator("#own")).to_contain_text("Drawn from your table")
    expect(page.locator("#own robot-scene")).to_have_attribute("data-renderer", "webgl")
    view.focus()
    view.press("0")
    page.evaluate(TWO_FRAMES)
    places = [label.get_attribute("style")]
    for key in ("ArrowLeft", "ArrowUp", "+", "Shift+ArrowRight", "-"):
        view.press(key)
        page.wait_for_function(
            "([label, before]) => label.getAttribute('style') !== before",
            arg=[label.element_handle(), places[-1]],
        )
        places.append(label.get_attribute("style"))
    view.press("0")
    page.wait_for_function(
        "([label, before]) => label.getAttribute('style') === before", arg=[label.element_handle(), places[0]]
    )
    expect(view).to_have_accessible_description(SCENE_IN_WORDS)
