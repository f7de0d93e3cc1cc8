"""What a student learns from an answer: verdicts, repairs, both robots, the history; and nothing before."""

import json
import re
from typing import Any

import pytest
from playwright.sync_api import Locator, Page, Request, Route, expect

from tests.web.conftest import OpenPage, Watch
from tests.web.driving import (
    PUMA,
    RX90,
    SCARA,
    Held,
    all_right,
    cell,
    joint,
    open_part,
    points,
    put_table,
    submit,
    wrong,
)

TIP_AND_POINT = """async (scene) => {
  const base = document.documentElement.dataset.assets;
  const { poses, position } = await import(new URL(`${base}/js/scene/model.js`, location.href).href);
  const found = poses(scene.model, scene.joints);
  const point = scene.model.items.find((item) => item.kind === "ball");
  return [found.at(-1).slice(0, 3).map((row) => row[3]), position(found, point.at)];
}"""


LABELS_OUTSIDE = """(scene) => {
  const view = scene.viewport.getBoundingClientRect();
  const isOutside = ({ width, left, right, top, bottom }) =>
    width > 0 && (left < view.left || right > view.right || top < view.top || bottom > view.bottom);
  return [...scene.querySelectorAll(".scene-labels > *")]
    .filter((label) => isOutside(label.getBoundingClientRect()))
    .map((label) => label.textContent);
}"""


def test_a_wrong_answer_is_repaired_from_its_feedback(open_page: OpenPage) -> None:
    page = open_page("/exercises/puma560")
    put_table(page, wrong(dict(PUMA), 2, a="d3", d="a2"))
    verdict = submit(page)
    expect(verdict).to_contain_text("Your table is not right yet.")
    assert not all_right(page)
    expect(verdict.locator(".badge.bad").first).to_be_visible()
    repair = verdict.locator(".repairs li:has(a)").first
    repair.get_by_role("link").click()
    expect(page.locator("dh-table-editor tbody tr:nth-child(3) input:focus")).to_have_count(1)
    cell(page, 2, "a").fill("a2")
    expect(verdict).to_contain_text("You have changed your answer since.")
    cell(page, 2, "d").fill("d3")
    submit(page)
    assert all_right(page)
    expect(page.locator("#history li")).to_have_count(2)
    page.locator("#history li").first.get_by_role("button").click()
    expect(verdict.locator(".outdated-note")).to_have_count(0)
    page.locator("#history li").last.get_by_role("button").click()
    expect(verdict).to_contain_text("You have changed your answer since.")


def test_a_student_may_ask_for_less_help(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara")
    choice = page.get_by_label("If my answer is wrong, tell me")
    expect(choice).to_have_value("repair")
    choice.select_option("verdict")
    put_table(page, wrong(dict(SCARA), 1, a="a3"))
    verdict = submit(page)
    expect(verdict).to_contain_text("Your table is not right yet.")
    expect(verdict.locator(".links-table, .repairs")).to_have_count(0)
    page.reload()
    expect(choice).to_have_value("verdict")
    choice.select_option("row")
    verdict = submit(page)
    expect(verdict.locator(".links-table, .feedback .row-link")).not_to_have_count(0)
    expect(verdict.locator(".repairs")).to_have_count(0)
    choice.select_option("repair")
    verdict = submit(page)
    expect(verdict.locator(".repairs")).not_to_have_count(0)


def test_a_right_answer_says_how_its_frames_differ_and_shows_both_robots(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara")
    # z of the third frame points down: joint 3 counts the other way.
    rows = [dict(row) for row in SCARA["rows"]]
    rows[2]["alpha"] = "180"
    put_table(page, {**SCARA, "rows": rows})
    verdict = submit(page)
    expect(verdict).to_contain_text("Your table describes this robot.")
    expect(verdict.locator(".feedback li")).not_to_have_count(0)
    scene = verdict.locator("robot-scene")
    expect(scene).to_be_visible()
    scene.scroll_into_view_if_needed()
    slider = verdict.get_by_label("Point of the motion")
    seen = set()
    for phase in ("0", "0.3", "0.7"):
        slider.fill(phase)
        tip, point = scene.evaluate(TIP_AND_POINT)
        seen.add(tuple(point))
        # The table's last axis is the spindle's: its frame stands above or below the marked point.
        assert tip[:2] == pytest.approx(point[:2], abs=1e-6)
    assert len(seen) == 3
    expect(verdict.get_by_role("button", name="Play")).to_be_visible()


@pytest.mark.parametrize(("table", "width"), [(SCARA, 360), (RX90, 1280)])
def test_a_moving_robot_stays_in_the_picture(open_page: OpenPage, table: Any, width: int) -> None:
    page = open_page("/exercises/scara" if table is SCARA else "/exercises/rx90", width=width)
    put_table(page, wrong(table, 1, alpha="45"))
    verdict = submit(page)
    scene = verdict.locator("robot-scene")
    scene.scroll_into_view_if_needed()
    slider = verdict.get_by_label("Point of the motion")
    for step in range(21):
        drawn = int(scene.get_attribute("data-drawn") or 0)
        slider.fill(str(step / 20))
        expect(scene).not_to_have_attribute("data-drawn", str(drawn))
        assert scene.evaluate(LABELS_OUTSIDE) == []


def test_a_missing_row_has_its_place_and_no_link(open_page: OpenPage) -> None:
    page = open_page("/exercises/puma560", lang="fr", width=360)
    put_table(page, {**PUMA, "rows": PUMA["rows"][:-1]})
    verdict = submit(page)
    table = verdict.locator(".links-table")
    headings = table.locator("tbody th").all_text_contents()
    assert headings == ["1", "2", "3", "4", "après la 4", "5", "après la 5"]
    assert table.locator("a").count() == 5
    assert verdict.locator(".feedback a").count() == 0
    expect(verdict.locator(".total")).to_have_text("27,3 points sur 100")
    assert table.evaluate("({ parentElement: box }) => box.scrollWidth <= box.clientWidth")


def test_long_links_to_fields_wrap_on_phones(open_page: OpenPage) -> None:
    page = open_page("/exercises/twolink-inverse", lang="ro", width=360)
    part = page.locator("#part-inverse_kinematics")
    part.locator("select").select_option("infinite")
    for field in part.locator("input").all():
        field.fill("1")
    expect(submit(page).locator(".part-report .row-link").last).to_be_visible()
    assert page.evaluate("document.documentElement.scrollWidth") == 360
    assert page.locator(".progress ul").evaluate("list => list.scrollWidth <= list.clientWidth")


def test_on_a_phone_the_bar_of_progress_takes_two_lines(open_page: OpenPage) -> None:
    """Parts stood beside the points in half of the width, each as tall as the longest name in three lines."""
    page = open_page("/exercises/puma560", lang="fr", width=360)
    assert page.locator(".progress li").first.evaluate("({ offsetHeight }) => offsetHeight") < 40
    assert page.locator(".progress").evaluate("({ offsetHeight }) => offsetHeight") < 90


def test_parts_beyond_the_edge_of_a_phone_fade_and_the_last_one_does_not(open_page: OpenPage) -> None:
    """The row was cut where an entry happened to end, and nothing told that it goes on."""
    page = open_page("/exercises/rx90", width=360)
    parts = page.locator(".progress ul")
    expect(parts).to_have_css("mask-image", re.compile("linear-gradient"))
    apart = """list => {
        list.scrollLeft = list.scrollWidth;
        const edge = ({ right }) => right;
        return edge(list.getBoundingClientRect()) - edge(list.lastElementChild.getBoundingClientRect());
    }"""
    assert parts.evaluate("list => list.scrollWidth > list.clientWidth")
    assert parts.evaluate(apart) >= 31


def test_motion_starts_by_itself_only_where_it_is_welcome(open_page: OpenPage) -> None:
    page = open_page(
        "/exercises/scara", before=lambda page: page.emulate_media(reduced_motion="no-preference")
    )
    put_table(page, SCARA)
    verdict = submit(page)
    expect(verdict.get_by_role("button", name="Pause")).to_be_visible()
    verdict.get_by_role("button", name="Pause").click()
    expect(verdict.get_by_role("button", name="Play")).to_be_visible()


def test_nothing_hints_at_the_answer_before_it_is_graded(open_page: OpenPage) -> None:
    asked: list[Request] = []
    shown: list[str] = []
    for table in (PUMA, wrong(dict(PUMA), 3, d="a2")):
        page = open_page(
            "/exercises/puma560",
            before=lambda page: page.on("request", lambda request: asked.append(request)),
            fresh=True,
        )
        put_table(page, table)
        expect(page.locator("#own")).to_contain_text("Drawn from your table: 6 joints.")
        shown.append(page.locator("#own .own-status").inner_text())
        expect(page.locator("#verdict-card")).to_be_hidden()
        expect(page.locator(".badge.good, .badge.bad")).to_have_count(0)
    assert shown[0] == shown[1]
    assert not any(request.url.endswith("/grade") for request in asked)
    calls = {
        request.url.rsplit("/api/v1/", 1)[1].split("?")[0] for request in asked if "/api/v1/" in request.url
    }
    drawing = {call for call in calls if re.fullmatch(r"exercises/puma560/figures/[0-9a-f]{40}\.svg", call)}
    assert len(drawing) == 1
    assert calls - drawing == {"exercises/puma560", "understand"}


def test_what_cannot_be_graded_costs_no_attempt(open_page: OpenPage, watch: Watch) -> None:
    watch.allow("status of 422")
    page = open_page("/exercises/scara")
    put_table(page, wrong(dict(SCARA), 1, a="a2*("))
    with page.expect_response(lambda response: response.url.endswith("/grade")) as caught:
        page.locator("button[type=submit].primary").click()
    assert caught.value.status == 422
    expect(page.locator("dh-table-editor .editor-summary")).to_be_focused()
    expect(cell(page, 1, "a")).to_have_attribute("aria-invalid", "true")
    expect(page.locator("#history-card")).to_be_hidden()


UNREAD = "One cell cannot be read yet."


def refused_summary(page: Page) -> Locator:
    """The summary of a refused answer, with the focus on it."""
    summary = page.locator("dh-table-editor .editor-summary")
    expect(summary).to_be_focused()
    expect(summary.get_by_role("link")).to_have_count(1)
    expect(cell(page, 1, "a")).to_have_attribute("aria-invalid", "true")
    return summary


@pytest.mark.parametrize("reading", ["before", "after"])
def test_the_summary_of_faults_keeps_the_focus_whatever_is_answered_first(
    open_page: OpenPage, watch: Watch, reading: str
) -> None:
    """What is said of the table as it stands does not touch what it was refused for, in either order."""
    watch.allow("status of 422")
    page = open_page("/exercises/scara")
    read, graded = Held(page, "**/understand"), Held(page, "**/grade")
    put_table(page, wrong(dict(SCARA), 1, a="a2*("))
    read.until(1)
    page.locator("button[type=submit].primary").click()
    graded.until(1)
    if reading == "before":
        read.let_go()
        expect(page.locator("#own")).to_contain_text(UNREAD)
        graded.let_go()
        refused_summary(page)
        return
    graded.let_go()
    summary = refused_summary(page)
    link = summary.get_by_role("link").element_handle()
    read.let_go()
    expect(page.locator("#own")).to_contain_text(UNREAD)
    refused_summary(page)
    assert link.is_visible(), "the summary's links stay the same elements"


def test_a_fault_leaves_the_summary_when_its_cell_is_typed_into(open_page: OpenPage, watch: Watch) -> None:
    watch.allow("status of 422")
    page = open_page("/exercises/scara")
    put_table(page, wrong(wrong(dict(SCARA), 1, a="a2*("), 2, d="("))
    page.locator("button[type=submit].primary").click()
    summary = page.locator("dh-table-editor .editor-summary")
    expect(summary).to_contain_text("2 cells need your attention")
    summary.get_by_role("link").nth(1).click()
    expect(cell(page, 2, "d")).to_be_focused()
    with page.expect_response("**/understand"):
        cell(page, 2, "d").fill("d3")
    expect(summary).to_contain_text("One cell needs your attention")
    expect(summary.get_by_role("link")).to_have_count(1)
    expect(cell(page, 2, "d")).to_be_focused()
    cell(page, 1, "a").fill("a2")
    expect(summary).to_be_hidden()


def test_a_refusal_that_concerns_no_cell_accuses_none(open_page: OpenPage, watch: Watch) -> None:
    """As when somebody is no longer signed in, or all attempts are used."""
    watch.allow("status of 409")
    page = open_page("/exercises/scara")
    put_table(page, dict(SCARA))
    told = "You have used all attempts."
    fault = {"code": "attempts_used", "pointer": "", "detail": told, "params": {}}
    problem = {"type": "about:blank", "title": "No", "status": 409, **fault, "errors": [fault]}
    page.route("**/grade", lambda route: route.fulfill(status=409, json=problem))
    page.locator("button[type=submit].primary").click()
    summary = page.locator("dh-table-editor .editor-summary")
    expect(summary).to_contain_text(told)
    expect(summary).to_contain_text("That did not work:")
    expect(summary).not_to_contain_text("attention")
    expect(summary).to_be_focused()


def test_a_reading_of_an_older_table_says_nothing_of_the_newer(open_page: OpenPage, watch: Watch) -> None:
    page = open_page("/exercises/scara")
    read = Held(page, "**/understand")
    put_table(page, wrong(dict(SCARA), 1, a="a2*("))
    read.until(1)
    cell(page, 1, "a").fill("a2")
    read.until(2)
    read.let_go(1)
    expect(page.locator("#own")).to_contain_text("Drawn from your table: 4 joints.")
    read.stop()
    expect(cell(page, 1, "a")).not_to_have_attribute("aria-invalid", "true")
    expect(page.locator("#own")).to_contain_text("Drawn from your table: 4 joints.")


def test_a_late_refusal_does_not_take_the_focus_from_who_types_on(open_page: OpenPage, watch: Watch) -> None:
    watch.allow("status of 422")
    page = open_page("/exercises/scara")
    graded = Held(page, "**/grade")
    put_table(page, wrong(wrong(dict(SCARA), 1, a="a2*("), 2, d="("))
    page.locator("button[type=submit].primary").click()
    graded.until(1)
    cell(page, 1, "a").fill("a2")
    graded.let_go()
    summary = page.locator("dh-table-editor .editor-summary")
    expect(summary).to_contain_text("One cell needs your attention")
    expect(page.locator("#announcer")).to_contain_text("One cell needs your attention")
    expect(cell(page, 1, "a")).to_be_focused()
    expect(cell(page, 1, "a")).not_to_have_attribute("aria-invalid", "true")
    page.locator("button[type=submit].primary").click()
    graded.until(1)
    cell(page, 2, "d").fill("d3")
    graded.let_go()
    expect(page.locator("#submit-problem")).not_to_be_empty()
    expect(summary).to_be_hidden()


def test_a_late_verdict_says_that_the_answer_has_changed(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara")
    graded = Held(page, "**/grade")
    put_table(page, wrong(dict(SCARA), 1, a="a3"))
    page.locator("button[type=submit].primary").click()
    graded.until(1)
    cell(page, 1, "a").fill("a2")
    graded.let_go()
    expect(page.locator("#verdict")).to_contain_text("You have changed your answer since.")
    expect(cell(page, 1, "a")).to_be_focused()
    page.get_by_role("button", name="Put back into the form (1)").click()
    expect(cell(page, 1, "a")).to_have_value("a3")


def test_parts_may_be_handed_in_without_the_table(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara")
    part = open_part(page, "workspace")
    part.get_by_label("Inner radius").fill("0.1")
    part.get_by_label("Outer radius").fill("0.7")
    verdict = submit(page)
    assert all_right(page)
    expect(verdict).to_contain_text("Everything that you handed in is right.")
    expect(verdict.locator(".total")).to_have_text("10 of 100 points")
    expect(verdict).to_contain_text("Structure: not handed in")


def test_what_is_not_chosen_is_asked_for_before_anything_is_sent(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara")
    put_table(page, SCARA)
    part = open_part(page, "schematic")
    part.get_by_label("Joint 1", exact=True).select_option("revolute")
    asked: list[Request] = []
    page.on("request", lambda request: asked.append(request) if request.url.endswith("/grade") else None)
    page.locator("button[type=submit].primary").click()
    second = part.get_by_label("Joint 2", exact=True)
    expect(second).to_be_focused()
    expect(second).to_have_accessible_description("Choose one.")
    second.select_option("revolute")
    expect(second).to_have_accessible_description("")
    assert asked == []
    expect(page.locator("#history-card")).to_be_hidden()


def test_a_wrong_part_leads_to_its_fields(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara")
    part = open_part(page, "workspace")
    part.get_by_label("Inner radius").fill("0.1")
    part.get_by_label("Outer radius").fill("0.9")
    verdict = submit(page)
    assert points(page) == "5 of 100 points"
    part.locator("summary").click()
    verdict.get_by_role("link", name="Outer radius").click()
    expect(part.get_by_label("Outer radius")).to_be_focused()


def test_attempts_are_kept_and_can_be_taken_back(open_page: OpenPage) -> None:
    page = open_page("/exercises/scara")
    put_table(page, wrong(dict(SCARA), 1, a="a3"))
    submit(page)
    joint(page, 0).select_option("fixed")
    page.reload()
    expect(page.locator("#history li")).to_have_count(1)
    page.get_by_role("button", name="Put back into the form (1)").click()
    expect(cell(page, 1, "a")).to_have_value("a3")
    expect(joint(page, 0)).to_have_value("revolute")
    page.get_by_role("button", name="Clear history").click()
    expect(page.locator("#history-card")).to_be_hidden()
    expect(page.locator("#answer-heading")).to_be_focused()


def test_a_seed_gives_a_students_own_values(open_page: OpenPage) -> None:
    def given(page: Page) -> str:
        return page.locator("#givens .givens").inner_text()

    plain = given(open_page("/exercises/puma560"))
    one = open_page("/exercises/puma560?seed=student-7")
    assert given(one) != plain
    assert given(open_page("/exercises/puma560?seed=student-7")) == given(one)
    put_table(one, PUMA)
    with one.expect_request(lambda request: request.url.endswith("/grade")) as caught:
        one.locator("button[type=submit].primary").click()
    assert json.loads(caught.value.post_data or "{}")["seed"] == "student-7"
    expect(one.locator("#verdict")).to_contain_text("Your table describes this robot.")


@pytest.mark.parametrize("by_gateway", [False, True])
def test_the_service_may_be_away_for_a_while(open_page: OpenPage, watch: Watch, by_gateway: bool) -> None:
    """Also behind a gateway, whose page says so in no language: “HTTP 502” stood there."""
    watch.allow("ERR_INTERNET_DISCONNECTED")
    watch.allow("502")
    page = open_page("/exercises/scara")

    def fail(route: Route) -> None:
        if by_gateway:
            route.fulfill(status=502, content_type="text/html", body="<h1>Bad Gateway</h1>")
        else:
            route.abort("internetdisconnected")

    page.context.route("**/api/**", fail)
    put_table(page, SCARA)
    expect(page.locator("#own")).to_contain_text("The service cannot be reached.")
    page.locator("button[type=submit].primary").click()
    expect(page.locator("#submit-problem")).to_contain_text("What you typed is kept")
    page.context.unroute("**/api/**")
    expect(page.locator("#own")).not_to_contain_text("The service cannot be reached.")
    submit(page)
    assert all_right(page)
