"""axe-core finds nothing, on any page, in any state."""

from collections.abc import Callable
from typing import Literal

import pytest
from playwright.sync_api import Page, expect

from tests.web.axe import EVERYTHING
from tests.web.conftest import OpenPage, Watch
from tests.web.driving import PUMA, SCARA, cell, put_table, submit

State = Callable[[Page], None]
Check = Callable[[Page], None]


def as_it_opens(page: Page) -> None:
    return


HIDE_WHAT_IS_COVERED = """(menu) => {
  const { left, right, top, bottom } = menu.getBoundingClientRect();
  for (const link of document.querySelectorAll("main a")) {
    const box = link.getBoundingClientRect();
    const isCovered = box.left < right && box.right > left && box.top < bottom && box.bottom > top;
    if (isCovered) link.style.visibility = "hidden";
  }
}"""


def languages_open(page: Page) -> None:
    """Without the links that the menu covers, which depends on the font; closed, it covers none."""
    page.locator("#language summary").click()
    page.locator("#language summary + *").evaluate(HIDE_WHAT_IS_COVERED)


def table_typed(page: Page) -> None:
    put_table(page, PUMA)
    page.evaluate("document.querySelectorAll('main details').forEach((details) => (details.open = true))")
    expect(page.locator("#own")).to_contain_text("Drawn from your table")
    page.get_by_text("3-D", exact=True).click()
    expect(page.locator("#figure-body robot-scene")).to_be_visible()


def symbols_shown(page: Page) -> None:
    put_table(page, SCARA)
    # Until then what is above the summary grows, and a click may miss it.
    expect(page.locator("#own")).to_contain_text("Drawn from your table")
    page.locator("#own details > summary").last.click()
    page.locator("matrix-panel input[value=symbols]").check()
    page.locator("matrix-panel .katex").first.wait_for()
    # At the end of the page the bar of what is left lies under the answer, not over a cell of it.
    page.evaluate("scrollTo(0, document.body.scrollHeight)")


def cells_at_fault(page: Page) -> None:
    cell(page, 0, "alpha").fill("(")
    cell(page, 1, "a").fill("2 L 1 ,")
    expect(page.locator(".fault:visible").first).to_be_visible()
    page.locator("button[type=submit].primary").click()
    expect(page.locator(".editor-summary")).to_be_focused()


def wrong_answer(page: Page) -> None:
    put_table(page, {**SCARA, "rows": [{**row, "alpha": "90"} for row in SCARA["rows"]]})
    submit(page)


def right_answer(page: Page) -> None:
    put_table(page, SCARA)
    submit(page)
    expect(page.locator("#verdict robot-scene")).to_be_visible()


def table_pasted(page: Page) -> None:
    page.get_by_role("button", name="Paste a table").click()
    page.get_by_role("dialog").locator("textarea").fill("0 0 0 θ1\n90 0 0 θ2")


STATES: dict[str, tuple[State, ...]] = {
    "/": (as_it_opens, languages_open),
    "/exercises/puma560": (as_it_opens, table_typed),
    "/exercises/scara-own-inverse": (symbols_shown,),
    "/exercises/scara": (cells_at_fault, wrong_answer, right_answer, table_pasted),
    "/exercises/nowhere": (as_it_opens,),
}
"""What somebody does on a page, one after the other."""
if not EVERYTHING:  # as they open they are looked at on a phone, below
    STATES |= {"/": (languages_open,), "/exercises/puma560": (table_typed,)}


@pytest.mark.parametrize("path", STATES)
def test_no_violation_in_any_state(
    open_page: OpenPage, watch: Watch, assert_accessible: Check, path: str
) -> None:
    if path.endswith("nowhere"):
        watch.allow("404")
    page = open_page(path, webgl=True)
    for bring_about in STATES[path]:
        bring_about(page)
        assert_accessible(page)


@pytest.mark.parametrize("language", ["ro", "uk"] if EVERYTHING else ["uk"])
def test_no_violation_in_another_language_on_a_phone(
    open_page: OpenPage, assert_accessible: Check, language: str
) -> None:
    page = open_page("/exercises/scara", lang=language, width=320, height=600)
    put_table(page, SCARA)
    submit(page)
    assert_accessible(page)


def test_a_violation_is_told_with_its_element(open_page: OpenPage, assert_accessible: Check) -> None:
    page = open_page("/version", lang=None, ready=False)
    page.set_content("<html lang=en><title>Page</title><main><h1>Page</h1><button></button></main>")
    with pytest.raises(AssertionError, match=r"button-name: .*<button></button>"):
        assert_accessible(page)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_a_pale_text_is_told_among_others_of_the_same_colours(
    open_page: OpenPage, assert_accessible: Check, scheme: str
) -> None:
    """Colours are read once: half-transparent ones are blended anew over whatever lies under them."""
    page = open_page("/version", lang=None, ready=False)
    clear, dim = "<p class=veil>on the page</p>", "<div class=under><p class=veil>on black</p></div>"
    page.set_content(f"<html lang=en><title>T</title><main><h1>H</h1>{clear}{dim}{clear}</main>")
    style = f"""body {{ background: #fff }} .veil {{ color: #000c; background: #fff5 }}
      @media (prefers-color-scheme: {scheme}) {{ .under {{ background: #000 }} }}"""
    page.evaluate(
        "style => document.adoptedStyleSheets.push(new CSSStyleSheet()) "
        "&& document.adoptedStyleSheets[0].replaceSync(style)",
        style,
    )
    with pytest.raises(AssertionError, match=r"color-contrast.*>on black</p>") as told:
        assert_accessible(page)
    assert ">on the page</p>" not in str(told.value)


PAGES: tuple[str, ...] = ("/", "/exercises/puma560", "/trainer/puma560", "/lesson")
if EVERYTHING:  # else test_playground.py looks at it, with every tool open and answered
    PAGES = (*PAGES, "/playground")
WIDTHS = (320, 390, 640, 768, 1280, 1920)
"""640 is 1280 at 200 % zoom."""
Forced = dict[int, tuple[Literal["none", "active"], ...]]
FORCED: Forced = {320: ("none",), 1280: ("active",)}
"""Where axe-core looks, with the colours of the page and with those that the system forces on it."""
if EVERYTHING:
    FORCED = dict.fromkeys(WIDTHS, ("none", "active"))


SMALL_TARGETS = """() => {
  const tiny = new CSSStyleSheet();
  tiny.replaceSync("body * { font-size: 1px !important; line-height: 1 !important; }");
  document.adoptedStyleSheets = [tiny];
  const inText = (element) => element.matches("a") && getComputedStyle(element).display === "inline";
  const targets = "main :is(button, select, input, textarea, summary, a[href]), .bar :is(a, summary)";
  return [...document.querySelectorAll(targets)]
    .filter((element) => element.checkVisibility({ visibilityProperty: true }) && !inText(element))
    .map((element) => {
      const box = (element.closest("label") ?? element).getBoundingClientRect();
      return [element.outerHTML.slice(0, 120), Math.round(box.width), Math.round(box.height)];
    })
    .filter(([, width, height]) => width < 24 || height < 24);
}"""


@pytest.mark.parametrize("path", PAGES)
def test_no_violation_at_any_width_in_any_colours_and_no_small_target_in_any_font(
    open_page: OpenPage, assert_accessible: Check, path: str
) -> None:
    page = open_page(path)
    page.evaluate("document.querySelectorAll('main details').forEach((details) => (details.open = true))")
    assert_accessible_at_any_width(page, assert_accessible, FORCED)


def assert_accessible_at_any_width(page: Page, assert_accessible: Check, forced_at: Forced) -> None:
    """Fail where a page is wider than its window, a target is small, or axe-core finds something.

    With glyphs of one pixel, what is left of a target is what the style sheet sees to by itself.
    """
    for width in WIDTHS:
        page.set_viewport_size({"width": width, "height": 844})
        assert page.evaluate("document.documentElement.scrollWidth <= window.innerWidth"), width
        for forced in forced_at.get(width, ()):
            page.emulate_media(forced_colors=forced)
            assert_accessible(page)
    page.emulate_media(forced_colors="none")
    for width in (390, 1280):
        page.set_viewport_size({"width": width, "height": 900})
        assert page.evaluate(SMALL_TARGETS) == [], width


def test_forced_colors_keep_what_colors_say(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara")
    page.emulate_media(forced_colors="active")
    buttons = page.locator("dh-table-editor .dh-actions")
    color = "(button) => getComputedStyle(button).color"
    unable = buttons.locator("[aria-disabled]").first.evaluate(color)
    assert unable != buttons.locator("button:not([aria-disabled])").first.evaluate(color)
    line = "(input) => getComputedStyle(input).borderBottomWidth"
    lit = cell(page, 0, "alpha")
    before = lit.evaluate(line)
    lit.evaluate("(input) => input.classList.add('lit')")
    assert lit.evaluate(line) != before


def test_a_sentence_above_an_exercise_fits_a_narrow_window_and_brackets_are_printed(
    open_page: OpenPage,
) -> None:
    page = open_page("/exercises/scara")
    page.set_viewport_size({"width": 320, "height": 640})
    page.evaluate("""document.querySelector("#exercise").insertAdjacentHTML("afterend",
      `<section class="card session-banner"><p class="row"><span class="badge warn">
        El ejercicio se ha modificado después de un intento anterior</span></p></section>
        <div class="bracketed"></div>`)""")
    assert page.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
    printed = "(brackets) => getComputedStyle(brackets).printColorAdjust"
    assert page.locator("#exercise ~ .bracketed").evaluate(printed) == "exact"
