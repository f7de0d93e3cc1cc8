"""The frame trainer in a real browser: by clicking, by keyboard, rule by rule, to the finished table."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import LANGUAGES, OpenPage
from tests.web.driving import Held

TWO_LINKS = [
    # twolink, modified: frame 0 and 1 on axis 1, frame 2 on axis 2
    {"z": "along axis 1", "origin": "axis 1", "x": "normal of axes 1 and 2"},
    {"z": "along axis 1", "origin": "axis 1", "x": "normal of axes 1 and 2"},
    {"z": "along axis 2", "origin": "axis 2", "x": "frame 1"},
]


def ready(page: Page) -> None:
    expect(page.locator("fieldset.choices")).to_have_count(3)


def candidate(page: Page, part: int, text: str) -> None:
    option = page.locator("fieldset.choices").nth(part).locator("label.choice", has_text=text).first
    option.locator("input").check()
    expect(option.locator("input")).to_be_checked()


def goto(page: Page, frame: int) -> None:
    page.get_by_role("button", name=re.compile(f"^Frame {frame}:")).click()
    expect(page.locator("fieldset.choices legend").first).to_contain_text(f"frame {frame}")


@pytest.mark.parametrize("language", LANGUAGES)
def test_speaks_every_language(open_page: OpenPage, language: str) -> None:
    page = open_page("/trainer/scara", lang=language)
    ready(page)
    page.locator("fieldset.choices").nth(2).locator("input").last.check()
    text = page.locator("main").inner_text()
    assert not re.search(r"\b(trainer|form|rule)-[a-z]", text)


def test_right_frames_make_the_table(open_page: OpenPage) -> None:
    page = open_page("/trainer/twolink")
    ready(page)
    for frame, parts in enumerate(TWO_LINKS):
        goto(page, frame)
        for part, name in enumerate(("z", "origin", "x")):
            candidate(page, part, parts[name])
    expect(page.locator("#table .notice-good")).to_be_visible()
    rows = page.locator("#table tbody tr")
    expect(rows).to_have_count(2)
    expect(rows.nth(1).locator("td").nth(1)).to_have_text("1")
    page.get_by_role("link", name="Open the table").click()
    expect(page.locator("dh-table-editor tbody tr").nth(1)).to_be_visible()


def test_a_broken_rule_is_named_and_mended(open_page: OpenPage) -> None:
    page = open_page("/trainer/puma560")
    ready(page)
    goto(page, 1)
    candidate(page, 0, "along axis 2")
    broken = page.locator("fieldset.choices").first.locator(".notice-problem")
    expect(broken).to_have_text("z must lie along axis 1.")
    expect(page.get_by_role("button", name="Frame 1: breaks a rule")).to_be_visible()
    candidate(page, 0, "along axis 1")
    expect(broken).to_have_count(0)


def test_the_convention_changes_the_rules_not_the_frames(open_page: OpenPage) -> None:
    page = open_page("/trainer/puma560")
    ready(page)
    goto(page, 1)
    candidate(page, 0, "along axis 1")
    page.get_by_label("standard").check()
    expect(page.locator("fieldset.choices").first.locator(".notice-problem")).to_have_text(
        "z must lie along axis 2."
    )
    expect(page.locator("fieldset.choices").first.locator("input").first).to_be_checked()


def test_an_arrow_can_be_clicked(open_page: OpenPage) -> None:
    page = open_page("/trainer/scara")
    ready(page)
    scene = page.locator("robot-scene")
    expect(scene).to_have_attribute("data-drawn", re.compile(r"\d"))
    label = scene.locator(".scene-label.tone-pick", has_text=re.compile("^3$")).bounding_box()
    assert label is not None
    page.mouse.click(label["x"] + label["width"] / 2, label["y"] + label["height"] / 2)
    expect(page.locator("fieldset.choices").first.locator("input").nth(2)).to_be_checked()


def test_a_choice_goes_on_to_what_is_to_be_chosen_next(open_page: OpenPage) -> None:
    page = open_page("/trainer/scara")
    ready(page)
    groups = page.locator("fieldset.choices")
    for part in range(2):
        expect(groups.nth(part)).to_have_class(re.compile("current"))
        groups.nth(part).locator("label.choice").first.click()
    expect(groups.nth(2)).to_have_class(re.compile("current"))
    expect(groups.nth(1).locator("input").first).to_be_focused()
    groups.nth(0).locator("input").first.focus()
    expect(groups.nth(0)).to_have_class(re.compile("current"))


def test_a_point_can_be_clicked(open_page: OpenPage) -> None:
    page = open_page("/trainer/scara")
    ready(page)
    candidate(page, 0, "along axis 1")
    scene = page.locator("robot-scene")
    label = scene.locator(".scene-label.tone-pick", has_text=re.compile("^2$"))
    expect(label).to_be_visible()
    box = label.bounding_box()
    assert box is not None
    page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    expect(page.locator("fieldset.choices").nth(1).locator("input").nth(1)).to_be_checked()


def test_a_choice_is_for_the_frame_whose_lists_are_shown(open_page: OpenPage) -> None:
    """While another frame's lists are on their way, a choice in those still there counts for neither."""
    page = open_page("/trainer/scara")
    ready(page)
    held = Held(page, "**/check-frames")
    page.get_by_role("button", name=re.compile("^Frame 2:")).click()
    held.until(1)
    page.locator("fieldset.choices").first.locator("label.choice").nth(1).click()
    held.stop()
    expect(page.locator("fieldset.choices legend").first).to_contain_text("frame 2")
    expect(page.locator("fieldset.choices input:checked")).to_have_count(0)
    goto(page, 0)
    expect(page.locator("fieldset.choices input:checked")).to_have_count(0)


def test_the_focus_stays_on_the_buttons_that_go_on(open_page: OpenPage) -> None:
    page = open_page("/trainer/twolink")
    ready(page)
    onward = page.get_by_role("button", name="Next frame")
    onward.focus()
    page.keyboard.press("Enter")
    expect(page.locator("fieldset.choices legend").first).to_contain_text("frame 1")
    expect(onward).to_be_focused()
    page.keyboard.press("Enter")
    expect(page.locator("fieldset.choices legend").first).to_contain_text("frame 2")
    expect(page.get_by_role("button", name=re.compile("^Frame 2:"))).to_be_focused()
    expect(onward).to_be_hidden()


def test_everything_by_keyboard(open_page: OpenPage) -> None:
    page = open_page("/trainer/onelink")
    ready(page)
    page.get_by_role("button", name=re.compile("^Frame 1:")).focus()
    page.keyboard.press("Enter")
    expect(page.locator("fieldset.choices legend").first).to_contain_text("frame 1")
    expect(page.get_by_role("button", name=re.compile("^Frame 1:"))).to_be_focused()
    page.keyboard.press("Tab")
    page.keyboard.press("Space")
    expect(page.locator("fieldset.choices").first.locator("input").first).to_be_checked()
    page.keyboard.press("ArrowDown")
    expect(page.locator("fieldset.choices").first.locator("input").nth(1)).to_be_checked()


def test_choices_survive_a_reload(open_page: OpenPage) -> None:
    page = open_page("/trainer/rx90")
    ready(page)
    candidate(page, 0, "along axis 1")
    page.reload()
    ready(page)
    expect(page.locator("fieldset.choices").first.locator("input").first).to_be_checked()


def test_without_webgl_the_drawing_is_there(open_page: OpenPage) -> None:
    page = open_page(
        "/trainer/puma560",
        before=lambda page: page.add_init_script("HTMLCanvasElement.prototype.getContext = () => null"),
    )
    ready(page)
    expect(page.locator("robot-scene")).to_have_attribute("data-renderer", "svg")
    expect(page.locator("robot-scene svg").first).to_be_visible()


@pytest.mark.parametrize(("width", "dark"), [(1280, False), (1280, True), (320, False), (320, True)])
def test_accessible_with_a_broken_rule(
    open_page: OpenPage, assert_accessible: Callable[[Page], None], width: int, dark: bool
) -> None:
    page = open_page("/trainer/puma560", width=width, height=600 if width == 320 else 900, dark=dark)
    ready(page)
    goto(page, 1)
    candidate(page, 0, "along axis 2")
    expect(page.locator(".notice-problem").first).to_be_visible()
    assert_accessible(page)
    assert page.evaluate("document.documentElement.scrollWidth <= window.innerWidth")
