"""The first lesson: what is drawn can be moved, and shows what the text says."""

import pytest
from playwright.sync_api import Page, expect

from tests.web.axe import EVERYTHING
from tests.web.conftest import LANGUAGES, OpenPage

TIP = """async (scene) => {
  const path = `${document.documentElement.dataset.assets}/js/scene/model.js`;
  const { poses } = await import(new URL(path, location.href).href);
  return poses(scene.model, scene.joints).at(-1).slice(0, 2).map((row) => Number(row[3].toFixed(9)) + 0);
}"""


def tips(page: Page) -> list[list[float]]:
    scenes = page.locator("#two-zeros robot-scene")
    return [scenes.nth(i).evaluate(TIP) for i in range(2)]


def test_the_same_arm_has_its_zero_where_the_table_puts_it(open_page: OpenPage) -> None:
    """θ2 stretches the arm at 0, θ2 + 90 bends it; at −90° the second one stands as the first did at 0."""
    page = open_page("/lesson")
    expect(page.locator("#two-zeros robot-scene")).to_have_count(2)
    assert tips(page) == [[2, 0], [1, 1]]
    page.get_by_role("slider", name="θ₂").fill("-90")
    assert tips(page) == [[1, -1], [2, 0]]


def test_the_motion_under_way_is_marked_in_both_orders(open_page: OpenPage) -> None:
    page = open_page("/lesson")
    lit = page.locator("#four-numbers .lesson-order .lit")
    expect(lit).to_have_text(["α", "d"])
    page.get_by_label("Motion").fill("0.5")
    expect(lit).to_have_text(["θ", "α"])
    page.get_by_label("Motion").fill("0")
    expect(lit).to_have_count(0)


@pytest.mark.parametrize("language", LANGUAGES if EVERYTHING else ("en", "es", "uk"))
def test_books_and_their_numberings_are_named_also_on_a_phone(open_page: OpenPage, language: str) -> None:
    page = open_page("/lesson", lang=language, width=360)
    books = page.locator("#books tbody tr")
    for author in ("Craig", "Spong", "Siciliano", "Khalil"):
        expect(books.filter(has_text=author)).to_contain_text("₂" if author == "Khalil" else "₁")
    assert "lesson-" not in page.locator("main").inner_text()
    table = page.locator("#books .scroller")
    assert table.evaluate("box => box.scrollWidth <= box.clientWidth")
