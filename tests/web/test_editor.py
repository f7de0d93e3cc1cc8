"""The table editor: conventions, units, rows, pasting, undo, meanings and faults."""

import re
import unicodedata

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import OpenPage
from tests.web.driving import (
    PUMA,
    SCARA,
    cell,
    choose,
    editor,
    fill_table,
    joint,
    put_table,
    rows,
    switch_language,
)

LATEX = r"""
\begin{tabular}{c|cccc}
 $i$ & $\theta_i$ & $d_i$ & $a_i$ & $\alpha_i$ \\ \hline
 1 & $\theta_1$ & 0 & 0 & $\frac{\pi}{2}$ \\
 2 & $\theta_2$ & $0$ & $a_2$ & $0$ \\
\end{tabular}
"""


def headings(page: Page) -> list[str]:
    return [text.replace("\n", "") for text in editor(page).locator("thead th").all_inner_texts()]


def texts(page: Page, row: int) -> list[str]:
    return [
        field.input_value() for field in editor(page).locator(f"tbody tr:nth-child({row + 1}) input").all()
    ]


def paste(page: Page, row: int, name: str, text: str) -> None:
    """What the browser does when a text is pasted into a cell."""
    cell(page, row, name).evaluate(
        """(field, text) => {
          const data = new DataTransfer();
          data.setData("text/plain", text);
          const how = { clipboardData: data, bubbles: true, cancelable: true };
          if (field.dispatchEvent(new ClipboardEvent("paste", how))) field.setRangeText(text);
        }""",
        text,
    )


def test_the_convention_relabels_the_columns_and_changes_no_entry(open_page: OpenPage) -> None:
    page = open_page("/exercises/puma560")
    choose(page, "convention", "modified")
    assert headings(page)[2:6] == ["αi−1 [°]", "ai−1 [m]", "di [m]", "θi [°]"]
    for name, text in (("alpha", "-90"), ("a", "a2"), ("d", "d3")):
        cell(page, 0, name).fill(text)
    choose(page, "convention", "standard")
    assert headings(page)[2:6] == ["θi [°]", "di [m]", "ai [m]", "αi [°]"]
    assert texts(page, 0) == ["θ1", "d3", "a2", "-90"]
    notice = editor(page).locator(".editor-notice")
    expect(notice).to_contain_text("now read in the standard convention")
    notice.get_by_role("button", name="Undo").click()
    assert texts(page, 0) == ["-90", "a2", "d3", "θ1"]
    expect(editor(page).locator("input[value=modified]")).to_be_checked()


def test_another_unit_of_angles_is_said_and_converts_on_request_only(open_page: OpenPage) -> None:
    page = open_page("/exercises/puma560")
    cell(page, 0, "alpha").fill("-90")
    choose(page, "angle-unit", "rad")
    assert cell(page, 0, "alpha").input_value() == "-90"
    editor(page).get_by_role("button", name="Convert the numbers").click()
    assert cell(page, 0, "alpha").input_value() == "-pi/2"
    choose(page, "angle-unit", "deg")
    editor(page).get_by_role("button", name="Convert the numbers").click()
    assert cell(page, 0, "alpha").input_value() == "-90"


def test_rows_are_added_moved_and_removed_by_keyboard(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara")
    choose(page, "convention", "modified")
    cell(page, 0, "a").fill("first")
    cell(page, 0, "a").press("Alt+ArrowDown")
    assert cell(page, 1, "a").input_value() == "first"
    expect(cell(page, 1, "a")).to_be_focused()
    assert cell(page, 1, "theta").input_value() == "θ2"
    cell(page, 1, "a").press("ArrowUp")
    expect(cell(page, 0, "a")).to_be_focused()
    cell(page, 0, "a").press("Enter")
    expect(cell(page, 1, "a")).to_be_focused()
    cell(page, 1, "a").press("Alt+Enter")
    expect(editor(page).locator("tbody tr")).to_have_count(5)
    expect(cell(page, 2, "alpha")).to_be_focused()
    expect(page.locator("#announcer")).to_have_text("Row 3 added")
    cell(page, 2, "alpha").press("Alt+Delete")
    expect(editor(page).locator("tbody tr")).to_have_count(4)
    assert cell(page, 1, "a").input_value() == "first"


def test_rows_are_moved_and_removed_by_buttons(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara")
    cell(page, 2, "d").fill("third")
    editor(page).get_by_role("button", name="Move row 3 up").click()
    assert cell(page, 1, "d").input_value() == "third"
    editor(page).get_by_role("button", name="Remove row 1").click()
    assert cell(page, 0, "d").input_value() == "third"
    assert cell(page, 0, "theta").input_value() == "θ1"


def test_undo_and_redo_bring_back_everything(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara")
    choose(page, "convention", "modified")
    fill_table(page, {**PUMA, "rows": PUMA["rows"][:4]})
    before = [texts(page, i) for i in range(4)]
    editor(page).get_by_role("button", name="Remove row 2").click()
    joint(page, 0).select_option("prismatic")
    page.keyboard.press("Control+z")
    page.keyboard.press("Control+z")
    assert [texts(page, i) for i in range(4)] == before
    page.keyboard.press("Control+y")
    expect(editor(page).locator("tbody tr")).to_have_count(3)
    editor(page).get_by_role("button", name="Undo", exact=True).click()
    assert [texts(page, i) for i in range(4)] == before


def test_degrees_among_radians_are_asked_about_once_before_they_are_handed_in(open_page: OpenPage) -> None:
    """With one more mistake in the table, nine cells were told to be wrong, and the unit was not."""
    page = open_page("/exercises/puma560")
    choose(page, "angle-unit", "rad")
    cell(page, 1, "alpha").fill("-90")
    notice = editor(page).locator(".editor-notice")
    expect(notice).to_be_empty()
    cell(page, 1, "a").focus()
    expect(notice).to_contain_text("90 rad is more than a whole turn")
    page.set_viewport_size({"width": 320, "height": 800})
    assert notice.locator(".grow").evaluate("({ clientWidth }) => clientWidth") > 150
    notice.get_by_role("button", name="Read them as degrees").click()
    expect(notice).to_contain_text("now read as degrees")
    assert page.evaluate("document.querySelector('dh-table-editor').table.angle_unit") == "deg"


def test_a_spreadsheet_is_pasted_into_the_table(open_page: OpenPage) -> None:
    page = open_page("/exercises/puma560")
    choose(page, "convention", "modified")
    paste(
        page,
        0,
        "alpha",
        "0\t0\t0\tθ1\n-90\t0\t0\tθ2\n0\t0,4318\t0,15005\tθ3\n-90\ta3\td4\tθ4\n90\t0\t0\tθ5\n-90\t0\t0\tθ6",
    )
    assert texts(page, 2) == ["0", "0.4318", "0.15005", "θ3"]
    expect(editor(page).locator("tbody tr")).to_have_count(6)
    expect(editor(page).locator(".editor-notice")).to_contain_text("6 rows pasted.")
    expect(page.locator("#own robot-scene")).not_to_have_class("stale")
    links = "r = SerialLink([Revolute('d', 0.5, 'alpha', -pi/2), Revolute('a', 0.4, 'offset', pi)]);"
    paste(page, 0, "alpha", links)  # one line, and no separator of cells
    assert texts(page, 0) == ["θ1", "0.5", "0", "-pi/2"]
    assert texts(page, 1) == ["θ2+pi", "0", "0.4", "0"]


def test_a_latex_table_is_pasted_with_its_convention(open_page: OpenPage) -> None:
    page = open_page("/exercises/twolink")
    choose(page, "convention", "modified")
    page.get_by_role("button", name="Paste a table").click()
    dialog = page.get_by_role("dialog")
    dialog.get_by_label("A table from").fill(LATEX)
    expect(dialog.locator(".paste-preview")).to_contain_text("2 rows found:")
    dialog.get_by_role("button", name="Use this table").click()
    expect(editor(page).locator("input[value=standard]")).to_be_checked()
    assert texts(page, 0) == ["θ_1", "0", "0", "π/2"]
    assert texts(page, 1) == ["θ_2", "0", "a_2", "0"]
    expect(editor(page).locator(".fault:visible", has_not_text="a2 is not a dimension")).to_have_count(0)


def test_a_text_without_a_table_is_not_taken(open_page: OpenPage) -> None:
    page = open_page("/exercises/twolink")
    page.get_by_role("button", name="Paste a table").click()
    dialog = page.get_by_role("dialog")
    dialog.get_by_label("A table from").fill("no table at all")
    expect(dialog).to_contain_text("No table is recognised")
    expect(dialog.get_by_role("button", name="Use this table")).to_be_disabled()
    page.keyboard.press("Escape")
    expect(dialog).to_have_count(0)


def test_each_cell_says_what_it_was_understood_as(open_page: OpenPage) -> None:
    page = open_page("/exercises/twolink")
    choose(page, "convention", "standard")
    cell(page, 0, "alpha").fill("-90")
    cell(page, 0, "a").fill("2L1")
    meaning = editor(page).locator("tbody tr").first.locator("td:has(input[id$=-alpha]) .meaning")
    expect(meaning.locator("math mfrac")).to_have_count(1)
    assert "".join(unicodedata.normalize("NFKC", meaning.inner_text()).split()) == "−π2"
    described = cell(page, 0, "alpha").get_attribute("aria-describedby")
    assert described is not None
    assert meaning.get_attribute("id") in described.split()


def test_faults_stand_at_their_cells(open_page: OpenPage) -> None:
    page = open_page("/exercises/twolink")
    fill_table(page, {"convention": "standard", "rows": rows("standard", "θ1 0 2(L1 0\nθ2 0 L2 0")})
    fault = editor(page).locator("tbody tr").first.locator("td:has(input[id$=-a]) .fault")
    expect(fault).to_contain_text("parenthesis")
    field = cell(page, 0, "a")
    expect(field).to_have_attribute("aria-invalid", "true")
    expect(field).to_have_accessible_description(fault.inner_text())
    expect(cell(page, 1, "a")).not_to_have_attribute("aria-invalid", "true")
    expect(page.locator("#own")).to_contain_text("One cell cannot be read yet")
    field.fill("2(L1)")
    expect(fault).to_be_hidden()
    expect(field).not_to_have_attribute("aria-invalid", "true")


def test_empty_cells_are_pointed_out_and_led_to_when_handed_in(open_page: OpenPage) -> None:
    page = open_page("/exercises/twolink")
    page.locator("button[type=submit].primary").click()
    summary = editor(page).locator(".editor-summary")
    expect(summary).to_be_focused()
    expect(summary).to_contain_text("6 cells need your attention:")
    summary.get_by_role("link").first.click()
    expect(
        cell(page, 0, "alpha" if page.locator("input[value=modified]").is_checked() else "d")
    ).to_be_focused()
    expect(page.locator("#verdict-card")).to_be_hidden()


@pytest.mark.parametrize("width", [320, 1280])
def test_the_button_of_a_row_is_beside_its_joint(open_page: OpenPage, width: int) -> None:
    """Its right half lay below the choice of the joint: where borders are drawn they crossed."""
    page = open_page("/exercises/twolink", width=width)
    play, joint = (
        editor(page).locator(f"tbody tr:first-child {name}").bounding_box() for name in (".dh-play", "select")
    )
    assert play
    assert joint
    assert play["x"] + play["width"] <= joint["x"]


def test_empty_columns_and_rows_have_a_line_each(open_page: OpenPage) -> None:
    """An empty table of six rows had eighteen lines."""
    page = open_page("/exercises/twolink")
    hand_in = page.locator("button[type=submit].primary")
    hand_in.click()
    summary = editor(page).locator(".editor-summary")
    texts = summary.get_by_role("link")
    empty = "Empty: write 0 if it is zero."
    expect(texts).to_have_text([f"column {name}: {empty}" for name in ("dᵢ", "aᵢ", "αᵢ")])
    cell(page, 1, "a").fill("L2")
    expect(texts).to_have_text([f"column dᵢ: {empty}", f"row 1, aᵢ: {empty}", f"column αᵢ: {empty}"])
    cell(page, 1, "d").fill("0")
    cell(page, 1, "alpha").fill("0")
    cell(page, 0, "theta").fill("")
    hand_in.click()
    expect(texts).to_have_text([f"row 1: {empty}"])
    expect(summary).to_contain_text("4 cells need your attention")


def test_empty_cells_and_cells_that_cannot_be_read_are_pointed_out_together(open_page: OpenPage) -> None:
    """In the order in which they stand, so that nobody mends the one and is then told of the other."""
    page = open_page("/exercises/twolink", lang="fr")
    with page.expect_response("**/understand"):
        put_table(
            page,
            {
                "convention": "modified",
                "rows": [
                    {"joint": "revolute", "alpha": "0", "a": "2(", "d": "0", "theta": "q1"},
                    {"joint": "revolute", "alpha": "", "a": "L1", "d": "0 m", "theta": "q2"},
                ],
            },
        )
    expect(page.locator(".fault:visible")).to_have_count(2)
    page.locator("button[type=submit].primary").click()
    links = editor(page).locator(".editor-summary").get_by_role("link")
    expect(links).to_have_count(3)
    expect(links.nth(0)).to_contain_text("ligne 1, aᵢ₋₁\u00a0: ")
    expect(links.nth(1)).to_contain_text("ligne 2, αᵢ₋₁\u00a0: ")
    expect(links.nth(2)).to_contain_text("ligne 2, dᵢ\u00a0: ")


def test_what_was_typed_survives_a_reload_and_a_change_of_language(open_page: OpenPage) -> None:
    page = open_page("/exercises/twolink")
    choose(page, "convention", "standard")
    cell(page, 0, "a").fill("L1 + 0.25")
    page.reload()
    expect(cell(page, 0, "a")).to_have_value("L1 + 0.25")
    switch_language(page, "uk")
    page.wait_for_url("**lang=uk**")
    expect(page.locator("html[lang=uk][data-ready=true]")).to_have_count(1)
    expect(cell(page, 0, "a")).to_have_value("L1 + 0.25")
    expect(editor(page).locator("input[value=standard]")).to_be_checked()


def test_a_name_that_the_figure_does_not_have_is_said_in_its_cell(open_page: OpenPage) -> None:
    """With the names that it has; before anything is handed in."""
    page = open_page("/exercises/scara")
    put_table(page, {**SCARA, "rows": [{**row, "a": row["a"].replace("a2", "a1")} for row in SCARA["rows"]]})
    fault = page.locator(".fault:visible")
    expect(fault).to_have_count(1)
    expect(fault).to_have_attribute("id", re.compile("-1-a-fault$"))
    expect(fault).to_contain_text("a2, a3")
    cell(page, 1, "a").fill("a2")
    expect(page.locator(".fault:visible")).to_have_count(0)


def test_dates_are_those_of_portugal_where_the_texts_are(open_page: OpenPage) -> None:
    """They were "22 de nov. de 2026", as in Brazil."""
    page = open_page("/exercises/twolink", lang="pt", locale="pt-PT")
    module = page.locator("link[href$='/js/i18n.js']").get_attribute("href")
    written = page.evaluate(
        """async (href) => {
            const { dates } = await import(new URL(href, document.baseURI).href);
            return dates({ dateStyle: "medium", timeZone: "UTC" }).format(new Date("2026-11-22T16:00:00Z"));
        }""",
        module,
    )
    assert written == "22/11/2026"


def test_the_score_is_drawn_in_forced_colours(open_page: OpenPage) -> None:
    """The ring was a background, which forced colours take away; the number alone stood there."""
    page = open_page("/exercises/twolink", before=lambda page: page.emulate_media(forced_colors="active"))
    page.evaluate(
        """() => {  // over the page, which goes on with what it does
          const sheet = document.createElement("div");
          Object.assign(sheet.style, { position: "fixed", inset: 0, zIndex: 9999, background: "Canvas" });
          sheet.innerHTML = "<div class=score-ring></div>";
          document.body.append(sheet);
        }"""
    )
    ring = page.locator(".score-ring")
    shots = set()
    for score in ("0%", "50%", "100%"):
        ring.evaluate("(ring, score) => ring.style.setProperty('--score', score)", score)
        shots.add(ring.screenshot())
    assert len(shots) == 3
