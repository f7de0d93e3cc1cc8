"""What a person does on the exercise page, as functions."""

import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from playwright.sync_api import Frame, Locator, Page, Request, Route, expect

ORDER = {"modified": ("alpha", "a", "d", "theta"), "standard": ("theta", "d", "a", "alpha")}

Table = Mapping[str, Any]


def editor(page: Page | Frame) -> Locator:
    return page.locator("dh-table-editor")


def cell(page: Page | Frame, row: int, name: str) -> Locator:
    """The field of a cell; rows from 0."""
    return editor(page).locator(f"tbody tr:nth-child({row + 1}) input[id$='-{name}']")


def joint(page: Page, row: int) -> Locator:
    return editor(page).locator(f"tbody tr:nth-child({row + 1}) select")


def choose(page: Page, name: str, value: str) -> None:
    """One of the radio buttons above the table: convention, angle-unit."""
    editor(page).locator(f"input[name$='-{name}'][value={value}]").check()


def fill_table(page: Page, table: Table) -> None:
    """Type a table: its convention, its joint types, its cells in the convention's order."""
    choose(page, "convention", table["convention"])
    choose(page, "angle-unit", table.get("angle_unit", "deg"))
    rows: Sequence[Mapping[str, str]] = table["rows"]
    present = editor(page).locator("tbody tr").count()
    for _ in range(len(rows) - present):
        editor(page).locator(".add-row").click()
    for i, row in enumerate(rows):
        joint(page, i).select_option(row.get("joint", "revolute"))
        for name in ORDER[table["convention"]]:
            cell(page, i, name).fill(row[name])


def put_table(page: Page | Frame, table: Table, editor: str = "dh-table-editor") -> None:
    """Put a whole table into the editor at once, where a test is not about typing."""
    wire = {"angle_unit": "deg", "length_unit": "m", **table}
    page.locator(editor).first.evaluate("(editor, table) => (editor.table = table)", wire)


def switch_language(page: Page | Frame, language: str) -> None:
    page.evaluate("scrollTo(0, 0)")
    page.locator("#language summary").click()
    page.locator(f"#language a[hreflang={language}]").click()


def open_part(page: Page, kind: str) -> Locator:
    part = page.locator(f"#part-{kind}")
    if part.get_attribute("open") is None:
        part.locator("> summary").click()
    return part


def write(fields: Locator, texts: Sequence[str]) -> None:
    """Type into the first of the fields at once, with the events of typing and none of the waiting.

    Raises what the page says of a field that is missing, hidden or cannot be typed into.
    """
    fields.evaluate_all(
        """(fields, texts) => texts.forEach((text, i) => {
          const field = fields[i];
          if (!field?.checkVisibility() || field.disabled || field.readOnly)
            throw new Error(`Field ${i} is not there to be typed into: ${field?.outerHTML}`);
          field.focus();
          field.select();
          document.execCommand(text ? "insertText" : "delete", false, text);
        })""",
        list(texts),
    )


def fill_matrix(fields: Locator, matrix: Sequence[Sequence[str]]) -> None:
    """Type the first three rows of a 4×4; the last one stands there already."""
    fields.locator("input").first.fill(matrix[0][0])
    write(fields.locator("input"), [text for row in matrix[:3] for text in row])


def _until(page: Page, condition: Callable[[], bool], complaint: str) -> None:
    """Let the page go on until something holds, for two minutes at most."""
    for _ in range(6000):
        if condition():
            return
        page.wait_for_timeout(20)
    raise AssertionError(complaint)


class Held:
    """Requests that are held back, to be let go in the order that a test wants: a race made certain.

    The service answers a request only after it was let go. One that the page has given up meanwhile is gone
    like an answer that nobody waits for.
    """

    def __init__(self, page: Page, address: str | re.Pattern[str]) -> None:
        self.page = page
        self.address = address
        self.waiting: list[Route] = []
        self.holding = True
        self.ended: list[Request] = []
        for event in ("requestfinished", "requestfailed"):
            page.on(event, lambda request: self.ended.append(request))
        page.route(address, self._hold)

    def _hold(self, route: Route) -> None:
        if self.holding:
            self.waiting.append(route)
        else:
            route.continue_()

    def until(self, count: int) -> None:
        """Wait until so many are held."""
        _until(self.page, lambda: len(self.waiting) >= count, f"fewer than {count} came")

    def let_go(self, index: int = 0) -> None:
        """Let one go; the page has its answer when this returns, if it still wants it."""
        request = self.waiting[index].request
        self.waiting.pop(index).continue_()
        _until(self.page, lambda: request in self.ended, f"no answer to {request.url}")

    def stop(self) -> None:
        """Hold no more, and let go what is held."""
        self.holding = False
        while self.waiting:
            self.let_go()


def submit(page: Page) -> Locator:
    """Hand in, and wait for the verdict."""
    verdict = page.locator("#verdict-card")
    shown = int(verdict.get_attribute("data-shown") or 0)
    with page.expect_response(lambda response: response.url.endswith("/grade")) as caught:
        page.locator("button[type=submit].primary").click()
    assert caught.value.ok, caught.value.text()
    expect(verdict).to_have_attribute("data-shown", str(shown + 1))
    return verdict


def points(page: Page) -> str:
    """What the ring says, such as "17.5 of 100 points"."""
    return page.locator("#verdict .score-ring").get_attribute("aria-label") or ""


def all_right(page: Page) -> bool:
    """Whether everything that was handed in is right: the ring is as green as its words."""
    return "good" in (page.locator("#verdict .verdict-head").get_attribute("class") or "").split()


def rows(convention: str, text: str) -> list[dict[str, str]]:
    """Rows from lines of four cells in the convention's order; `P` or `F` before other than revolute ones."""
    found = []
    for line in text.strip().splitlines():
        cells = line.split()
        kind = {"P": "prismatic", "F": "fixed"}.get(cells[0])
        values = dict(zip(ORDER[convention], cells[1:] if kind else cells, strict=True))
        found.append({**values, "joint": kind or "revolute"})
    return found


PUMA: Table = {
    "convention": "modified",
    "rows": rows(
        "modified",
        """
          0   0   0   θ1
        -90   0   0   θ2
          0  a2  d3   θ3
        -90  a3  d4   θ4
         90   0   0   θ5
        -90   0   0   θ6
        """,
    ),
}
SCARA: Table = {
    "convention": "modified",
    "rows": rows(
        "modified",
        """
          0   0   0   θ1
          0  a2   0   θ2
        P 0  a3  d3   0
          0   0   0   θ4
        """,
    ),
}
RX90: Table = {
    "convention": "modified",
    "rows": rows(
        "modified",
        """
          0   0    0   θ1
         90   0    0   θ2
          0  D3    0   θ3
        -90   0  RL4   θ4
         90   0    0   θ5
        -90   0    0   θ6
        """,
    ),
}


def wrong(table: Table, row: int, **cells: str) -> dict[str, Any]:
    """A table with some cells of a row changed; rows from 0."""
    cells_of = [dict(entry) for entry in table["rows"]]
    cells_of[row].update(cells)
    return {**table, "rows": cells_of}
