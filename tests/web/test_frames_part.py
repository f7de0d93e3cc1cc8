"""Frames placed on the figure's robot: by keyboard, on a phone, with every rule that is broken named."""

from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, Page, expect

from tests.web.conftest import OpenPage
from tests.web.driving import all_right, points


def place(page: Page, frame: int, z: str, origin: str, x: str) -> None:
    """Choose a frame's pieces by what they mean in the figure."""
    for k, value in enumerate((z, origin, x)):
        piece(page, frame, k).select_option(label=value)


def piece(page: Page, frame: int, k: int) -> Locator:
    """The choice of z (0), origin (1) or x (2) of a frame."""
    return page.locator(".frames .frame").nth(frame).locator("select").nth(k)


LABELS = "scene => scene.model.items.filter(({ kind }) => kind === 'label').map(({ sub }) => sub)"


@pytest.mark.parametrize(("width", "height"), [(320, 640), (1280, 800)])
def test_frames_are_placed_drawn_and_judged(
    open_page: OpenPage, assert_accessible: Callable[[Page], None], width: int, height: int
) -> None:
    page = open_page("/exercises/twolink-frames", width=width, height=height)
    scene = page.locator(".frames robot-scene")
    expect(page.locator("#own-card")).to_be_hidden()
    place(page, 0, "+Z", "at the body of joint 1", "+X")
    place(page, 1, "+Z", "at the body of joint 2", "+X")
    page.locator("button[type=submit].primary").click()
    expect(page.locator("#verdict")).to_contain_text("Frame 2")
    place(page, 2, "+Z", "at P", "+X")
    drawn = scene.evaluate(LABELS)
    assert {"0", "1", "2"} <= {str(index)[0] for index in drawn if index}
    page.locator("button[type=submit].primary").click()
    verdict = page.locator("#verdict")
    expect(verdict).to_contain_text("x of the last frame must cross axis 2 at right angles")
    assert not all_right(page)
    verdict.get_by_role("link", name="x of frame 2").click()
    field = piece(page, 2, 2)
    expect(field).to_be_focused()
    field.select_option(label="+Y")
    page.locator("button[type=submit].primary").click()
    expect(page.locator("#verdict .total")).to_have_text("100 of 100 points")
    assert all_right(page)
    assert points(page) == "100 of 100 points"
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    assert_accessible(page)
    page.reload()
    expect(piece(page, 2, 2)).to_have_value("2")


def test_a_direction_may_be_typed(open_page: OpenPage) -> None:
    page = open_page("/exercises/twolink-frames", lang="fr")
    fields = page.locator(".frames .frame").nth(0)
    piece(page, 0, 1).select_option("typed")
    for axis, text in (("X", "0,25"), ("Y", "0"), ("Z", "L1")):
        fields.get_by_label(f"origine du repère 0, {axis}").fill(text)
    page.locator("button[type=submit].primary").click()
    expect(piece(page, 0, 0)).to_have_attribute("aria-invalid", "true")
    expect(piece(page, 0, 0)).to_be_focused()
