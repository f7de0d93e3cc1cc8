"""axe-core finds nothing, on any page, in any state, light and dark."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import OpenPage, Watch
from tests.web.driving import PUMA, SCARA, cell, put_table, submit

State = Callable[[Page], None]
Check = Callable[[Page], None]


def as_it_opens(page: Page) -> None:
    return


def languages_open(page: Page) -> None:
    page.locator("#language summary").click()


def table_typed(page: Page) -> None:
    put_table(page, PUMA)
    page.evaluate("document.querySelectorAll('main details').forEach((details) => (details.open = true))")
    expect(page.locator("#own")).to_contain_text("Drawn from your table")
    page.get_by_text("3-D", exact=True).click()
    expect(page.locator("#figure-body robot-scene")).to_be_visible()


def symbols_shown(page: Page) -> None:
    put_table(page, SCARA)
    page.locator("#own details > summary").last.click()
    page.locator("matrix-panel input[value=symbols]").check()
    page.locator("matrix-panel .katex").first.wait_for()


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


STATES: list[tuple[str, State]] = [
    ("/", as_it_opens),
    ("/", languages_open),
    ("/exercises/puma560", as_it_opens),
    ("/exercises/puma560", table_typed),
    ("/exercises/scara", symbols_shown),
    ("/exercises/scara", cells_at_fault),
    ("/exercises/scara", wrong_answer),
    ("/exercises/scara", right_answer),
    ("/exercises/scara", table_pasted),
    ("/exercises/nowhere", as_it_opens),
]


@pytest.mark.parametrize("dark", [False, True], ids=["light", "dark"])
@pytest.mark.parametrize(("path", "state"), STATES, ids=[f"{p[1:]}-{s.__name__}" for p, s in STATES])
def test_no_violation(
    open_page: OpenPage, watch: Watch, assert_accessible: Check, path: str, state: State, dark: bool
) -> None:
    if path.endswith("nowhere"):
        watch.allow("404")
    page = open_page(path, dark=dark)
    state(page)
    assert_accessible(page)


@pytest.mark.parametrize("language", ["ro", "uk"])
def test_no_violation_in_another_language_on_a_phone(
    open_page: OpenPage, assert_accessible: Check, language: str
) -> None:
    page = open_page("/exercises/scara", lang=language, width=320, height=600)
    put_table(page, SCARA)
    submit(page)
    assert_accessible(page)
