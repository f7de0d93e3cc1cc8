"""Where a student stands and what helps on: points, parts, steps of help, the ghost of a wrong robot."""

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from tests.web.conftest import OpenPage
from tests.web.driving import PUMA, SCARA, open_part, points, put_table, rows, submit, wrong

FIRST_OFF = """async (scene) => {
  const base = document.documentElement.dataset.assets;
  const { poses, position } = await import(new URL(`${base}/js/scene/model.js`, location.href).href);
  const found = poses(scene.model, scene.joints);
  const balls = scene.model.items.filter((item) => item.kind === "ball" && item.tone === "lit");
  return balls.map((ball) => position(found, ball.at));
}"""


def test_after_a_wrong_answer_the_ghost_leaves_the_robot_at_the_row_that_is_named(
    open_page: OpenPage, assert_accessible: Callable[[Page], None]
) -> None:
    page = open_page("/exercises/puma560")
    put_table(page, wrong(dict(PUMA), 3, a="a2"))
    verdict = submit(page)
    named = verdict.locator(".feedback .row-link").first
    expect(named).to_have_text("Go to row 4")
    expect(verdict.locator(".both")).to_contain_text("the one of row 4, is the first that departs from")
    scene = verdict.locator("robot-scene")
    scene.scroll_into_view_if_needed()
    seen = []
    for phase in ("0", "0.3"):
        verdict.get_by_label("Point of the motion").fill(phase)
        seen.append(scene.evaluate(FIRST_OFF))
    assert [len(balls) for balls in seen] == [1, 1]
    assert seen[0] != seen[1]  # it moves with the robot
    # Frame 4 stands a2 before axis 3 in the picture, instead of a3; the film stands at the same row.
    assert seen[0][0] == pytest.approx([0.0, -0.15005, -0.4318], abs=1e-6)
    expect(page.locator("#own .film-text")).to_contain_text("Row 4")
    assert_accessible(page)


LIST = """async (first) => {
  const base = document.documentElement.dataset.assets;
  const { showHistory } = await import(new URL(`${base}/js/exercise/history.js`, location.href).href);
  const attempt = (number) => ({ number, at: "2026-01-01T12:00:00Z", score: 0.5, correct: false });
  showHistory(document.getElementById("history"), [attempt(first), attempt(first + 1)], 100, () => {}, null);
  document.getElementById("history-card").hidden = false;
}"""
"""The history of a course, with two attempts from a number on."""


def test_of_several_facts_of_which_one_is_wrong_none_is_called_wrong(open_page: OpenPage) -> None:
    """One sign mirrors the arm, and several cells could hold it: all of them were called wrong."""
    page = open_page("/exercises/puma560")
    put_table(page, wrong(dict(PUMA), 3, alpha="90"))
    verdict = submit(page)
    expect(verdict.locator("[data-code=one_of_these]")).to_be_visible()
    found = verdict.locator(".links-table")
    expect(found.get_by_text("perhaps wrong").nth(1)).to_be_visible()
    expect(found.get_by_text("wrong", exact=True)).to_have_count(0)


def test_a_table_that_earns_nothing_says_what_earns_points(open_page: OpenPage) -> None:
    page = open_page("/exercises/puma560")
    zeros = rows("standard", "\n".join(f"q{joint} 0 0 0" for joint in range(1, 7)))
    put_table(page, {"convention": "standard", "rows": zeros})
    verdict = submit(page)
    assert points(page) == "0 of 100 points"
    expect(verdict).to_contain_text("beyond what a table of zeros would")


@pytest.mark.parametrize("level", ["verdict", "row"])
def test_no_ghost_where_the_help_does_not_allow_it(open_page: OpenPage, level: str) -> None:
    page = open_page("/exercises/puma560")
    page.get_by_label("If my answer is wrong, tell me").select_option(level)
    put_table(page, wrong(dict(PUMA), 3, a="a2"))
    expect(submit(page).locator("robot-scene")).to_have_count(0)


def test_ring_text_history_and_list_say_the_same_points(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara")
    put_table(page, wrong(dict(SCARA), 2, a="a2"))
    verdict = submit(page)
    expect(verdict).to_contain_text("A wrong table earns points for the twists, lengths and offsets")
    said = points(page)
    assert said == "17.5 of 100 points"
    expect(verdict.locator(".total")).to_have_text(said)
    expect(page.locator(".progress > strong")).to_have_text(said)
    expect(page.locator("#history li .badge")).to_have_text(said)
    page.locator(".bar-nav [data-nav=home]").click()
    expect(page.locator(".exercise-card:has(a[href*='/scara?']) .badge.warn")).to_have_text(f"Best: {said}")


def test_parts_are_checked_one_at_a_time_and_what_is_left_stays_in_sight(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara")
    sent: list[dict[str, object]] = []
    page.on(
        "request", lambda request: sent.append(request.post_data_json) if "/grade" in request.url else None
    )
    progress = page.locator(".progress")
    expect(progress.locator("a")).to_have_count(6)
    expect(progress).to_contain_text("Workspace: not answered yet")
    part = open_part(page, "workspace")
    part.get_by_label("Inner radius").fill("0.1")
    part.get_by_label("Outer radius").fill("0.7")
    expect(progress).to_contain_text("Workspace: not checked yet")
    expect(progress).to_be_in_viewport()
    with page.expect_response(lambda response: response.url.endswith("/grade")):
        part.get_by_role("button", name="Check this part").click()
    expect(progress).to_contain_text("Workspace: 10 of 10 points")
    expect(progress.locator("strong")).to_have_text("10 of 100 points")
    put_table(page, wrong(dict(SCARA), 2, a="a2"))
    expect(progress).to_contain_text("DH table: not checked yet")
    with page.expect_response(lambda response: response.url.endswith("/grade")):
        page.locator("#part-table").get_by_role("button", name="Check this part").click()
    expect(progress.locator("strong")).to_have_text("27.5 of 100 points")
    assert points(page) == "27.5 of 100 points"
    assert [sorted(body) for body in sent] == [["workspace"], ["table", "workspace"]]
    progress.get_by_role("link", name="Structure").click()
    expect(page.locator("#part-schematic")).to_have_attribute("open", "")


def test_a_part_in_which_nothing_stands_is_not_sent(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara")
    part = open_part(page, "workspace")
    part.get_by_role("button", name="Check this part").click()
    expect(part.get_by_label("Inner radius")).to_be_focused()
    expect(page.locator("#history-card")).to_be_hidden()


def test_the_next_step_of_help_needs_a_changed_answer(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara")
    page.get_by_label("If my answer is wrong, tell me").select_option("steps")
    steps = page.locator(".help-steps")

    def seen() -> tuple[bool, bool, bool, bool]:
        text = steps.inner_text()
        return (
            page.locator("#verdict .badge", has_text="wrong").count() > 0,
            "The principle." in text,
            "on another robot" in text,
            "To get the next hint" in text,
        )

    climbed = []
    for a in ("a2", "a2", "0", "2*a2", "2*a2", "3*a2", "4*a2"):
        put_table(page, wrong(dict(SCARA), 2, a=a))
        submit(page)
        climbed.append(seen())
    row, kind = (False, False, False, True), (True, False, False, True)
    principle, worked = (True, True, False, True), (True, True, True, False)
    assert climbed == [row, row, kind, principle, principle, worked, worked]
    expect(steps).to_contain_text("The length a is the distance")
    expect(page.locator("#verdict .repairs")).to_have_count(0)
    put_table(page, SCARA)
    submit(page)
    expect(steps).to_have_count(0)
    put_table(page, wrong(dict(SCARA), 2, a="a2"))
    submit(page)
    assert seen() == row


@pytest.mark.parametrize(("lang", "comma"), [("fr", "0,5 a_2"), ("uk", "0,5*a2"), ("en", "0.5 a2")])
def test_every_cell_of_a_matrix_is_read_while_it_is_typed(open_page: OpenPage, lang: str, comma: str) -> None:
    page = open_page("/exercises/scara", lang=lang)
    put_table(page, SCARA)
    part = open_part(page, "transform")
    part.locator(".matrix-text summary").click()
    rows = (rf"\cos\theta_1 & -s_{{12}} & 0 & {comma}", "s1 & c1 & 0 & a2*(", "0 & 0 & 1 & d3")
    latex = r"\begin{bmatrix} " + r" \\ ".join(rows) + r" \end{bmatrix}"
    part.locator("textarea").fill(latex)
    cells, meanings = part.locator("td input"), part.locator("td .meaning")
    expect(cells.nth(0)).to_have_value("cos(θ_1)")
    expect(meanings.nth(0)).to_contain_text("θ")
    expect(meanings.nth(3)).to_contain_text("a")
    expect(cells.nth(7)).to_have_attribute("aria-invalid", "true")
    expect(cells.nth(15)).to_have_value("1")
    part.locator("textarea").fill("this is prose, not a matrix; it says nothing")
    expect(cells.nth(0)).to_have_value("cos(θ_1)")
    part.locator("button.small").first.click()
    expect(cells.nth(0)).to_have_value("")


def test_of_many_stored_attempts_the_latest_are_listed_and_the_page_says_so(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara")
    for first, said in (
        (1, "Kept in your course."),
        (11, "Kept in your course. The latest 2 are listed here."),
    ):
        page.evaluate(LIST, first)
        expect(page.locator("#history li")).to_have_count(2)
        assert " ".join(page.locator("#history .hint").inner_text().split()) == said
