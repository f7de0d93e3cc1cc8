"""Whatever a definition can hold is set in the page: every key, every kind of part, every dimension."""

import base64
import json
import re
import tomllib
import zlib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Locator, Page, expect

from exercises.authoring.draft import ExerciseDraft, draft_of_files, exercise_of_draft
from exercises.library import packaged
from exercises.parts.registry import part_types
from tests.web.conftest import OpenPage, Watch
from tests.web.driving import Held

PATIENCE = 120_000
GUIDE = (Path(__file__).parents[2] / "docs" / "authoring.md").read_text(encoding="utf-8")
WITH_NEW_KINDS = (
    "puma560-inverse",
    "kr125-orientation",
    "scara-jacobian",
    "puma560-find-mistake",
    "twolink-dynamics",
    "puma560-matrix-mistake",
    "puma560",
)
ELSEWHERE = re.compile(
    r"definition/(reference|robot|title|remarks|tests/misconceptions)(/|$)|statements/|definition/parts/\d+/kind"
)
"""Set by the card of the robot, in the tab of a language, beside the wrong answers, by a tick."""


def crane() -> dict[str, Any]:
    """The definition in full of the page about writing exercises."""
    text = re.search(r"```toml file=crane/exercise.toml\n(.*?)```", GUIDE, re.S)
    assert text
    statement = "A crane turns on a column of height *L0*."
    return {"id": "crane", "definition": tomllib.loads(text[1]), "statements": {"en": statement}}


def opened(open_page: OpenPage, draft: dict[str, Any], before: Callable[[Page], Any] | None = None) -> Page:
    """The page with a draft from its address."""
    packed = zlib.compress(json.dumps({"draft": draft, "source": None}).encode())
    address = f"/author#draft={base64.urlsafe_b64encode(packed).decode().rstrip('=')}"
    return open_page(address, before=before)


def leaves(value: Any, path: str = "definition") -> Iterator[str]:
    inner = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    if not isinstance(value, dict | list):
        yield path
    for key, entry in inner:
        yield from leaves(entry, f"{path}/{key}")


def drafts() -> Iterator[dict[str, Any]]:
    yield crane()
    for name in WITH_NEW_KINDS:
        files = packaged().files(name)
        assert files is not None
        found = draft_of_files(name, files)
        yield {"id": name, "definition": found.definition, "statements": found.statements}


@pytest.mark.parametrize("draft", tuple(drafts()), ids=lambda draft: draft["id"])
def test_every_key_of_a_definition_has_a_field(open_page: OpenPage, draft: dict[str, Any]) -> None:
    page = opened(open_page, draft)
    expect(page.locator("#author-parts [data-part]").first).to_be_attached(timeout=PATIENCE)
    expect(page.locator("#author-problem")).to_be_empty()
    found = page.evaluate(
        "[...document.querySelectorAll('[data-path]')].map((e) => [e.dataset.path, 'whole' in e.dataset])"
    )
    exact = {path for path, _ in found}
    whole = tuple(path for path, is_whole in found if is_whole)
    missing = [
        leaf
        for leaf in leaves(draft["definition"])
        if leaf not in exact
        and not ELSEWHERE.match(leaf)
        and not any(leaf.startswith(f"{path}/") for path in whole)
    ]
    assert missing == []


def definition(page: Page) -> dict[str, Any]:
    """What the browser keeps."""
    kept: dict[str, Any] = page.evaluate(
        "JSON.parse(Object.entries(localStorage).find(([key]) => key.endsWith('author'))[1])"
    )
    return dict(kept.get("draft") or kept["value"]["draft"])


def dimension(page: Page, number: int = 0) -> dict[str, Any]:
    marks = definition(page)["definition"].get("figure", {}).get("dimensions", [{}])
    return dict(marks[number])


def changed(page: Page, before: dict[str, Any]) -> dict[str, Any]:
    """The first dimension, once it is another than before: input events take their time."""
    for _ in range(1200):
        now = dimension(page)
        if now != before:
            return now
        page.wait_for_timeout(100)
    return dimension(page)


def middle(handle: Locator) -> tuple[float, float]:
    box = handle.bounding_box()
    assert box
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def test_a_dimension_is_dragged_by_mouse_by_touch_and_by_keys(open_page: OpenPage) -> None:
    page = opened(open_page, crane())
    handle = page.locator(".dimension-handle").first
    expect(handle).to_be_visible(timeout=PATIENCE)
    page.locator("#author-figure").evaluate("image => image.decode()")
    drawn = page.locator("#author-figure").get_attribute("src")
    before = dimension(page)
    page.locator(".author-paper").scroll_into_view_if_needed()
    x, y = middle(handle)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 70, y + 4, steps=4)
    expect(page.locator("#author-dimension-handles line")).to_have_count(1)
    page.mouse.up()
    by_mouse = changed(page, before)
    assert by_mouse["name"] == before["name"]
    assert by_mouse["offset"] != before["offset"]
    expect(page.locator("#author-figure")).not_to_have_attribute("src", drawn or "", timeout=PATIENCE)
    expect(page.locator("#author-problem")).to_be_empty()
    expect(page.locator("#author-dimension-handles line")).to_have_count(0)
    moved = middle(page.locator(".dimension-handle").first)
    assert abs(moved[0] - x) + abs(moved[1] - y) > 20

    touch = page.context.new_cdp_session(page)
    x, y = moved
    touch.send("Input.dispatchTouchEvent", {"type": "touchStart", "touchPoints": [{"x": x, "y": y}]})
    touch.send("Input.dispatchTouchEvent", {"type": "touchMove", "touchPoints": [{"x": x - 90, "y": y}]})
    touch.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    by_touch = changed(page, by_mouse)
    assert (by_touch["offset"], by_touch["distance"]) != (by_mouse["offset"], by_mouse["distance"])

    handle = page.locator(".dimension-handle").first
    handle.focus()
    page.keyboard.press("ArrowRight")
    by_key = changed(page, by_touch)
    assert by_key["offset"] != by_touch["offset"]
    page.keyboard.press("Backspace")
    assert "offset" not in changed(page, by_key)
    expect(page.locator(".dimension-handle").first).to_be_focused()
    kept = definition(page)
    exercise_of_draft(ExerciseDraft(**kept))


def test_every_kind_of_part_is_made_in_the_page(open_page: OpenPage) -> None:
    draft = started()
    fixed = {"base": "frame", "tool": "frame", "zero": "figure", "direction": "figure"}
    draft["definition"]["policy"] = fixed  # else a pose needs a table whose it is
    page = opened(open_page, draft)
    ticks = page.locator("#author-parts [data-part]")
    expect(ticks).to_have_count(len(part_types()), timeout=PATIENCE)
    last = "table"
    for kind in part_types():
        if kind != last:
            # both at once: on a busy machine the page may ask for a preview of the two parts in between
            page.evaluate(
                "kinds => kinds.forEach(kind => document.querySelector(kind).click())",
                [f"#author-parts [data-part={kind}]" for kind in (last, kind)],
            )
        with page.expect_response("**/author/preview", timeout=PATIENCE) as caught:
            page.locator("[data-path='definition/title/en']").fill(f"Only {kind}")
        assert caught.value.status == 200, (kind, caught.value.text())
        kept = definition(page)
        assert [part["kind"] for part in kept["definition"]["parts"]] == [kind]
        last = kind


def test_a_kind_that_shows_the_answer_to_another_is_not_ticked_beside_it(
    open_page: OpenPage, watch: Watch
) -> None:
    """It was ticked, and then refused by a fault that named neither."""
    watch.allow("author/preview")  # of an exercise that asks nothing, between the two
    page = opened(open_page, started())
    table, tables = (
        page.locator(f"#author-parts [data-part={kind}]") for kind in ("table", "compare_tables")
    )
    expect(tables).to_be_disabled(timeout=PATIENCE)
    expect(tables).to_have_accessible_description(re.compile("DH table"))
    table.uncheck()
    notice = page.locator("#author-problem .notice")
    expect(notice).to_contain_text("add a part", timeout=PATIENCE)
    expect(notice).not_to_have_class(re.compile("notice-problem"))
    tables.check()
    expect(notice).to_have_count(0, timeout=PATIENCE)
    expect(table).to_be_disabled()
    tables.uncheck()
    expect(table).to_be_enabled()


UNCHECKED_ONCE_SHOWN = """() => {
  const name = document.getElementById("author-name");
  const shown = new MutationObserver(() => {
    if (!name.textContent) return;
    shown.disconnect();
    document.querySelector("#author-parts [data-part=table]").click();
  });
  shown.observe(name, { childList: true, characterData: true, subtree: true });
}"""
"""Asks for no table the moment the first preview is there: later the draft before may be tested already."""


def test_a_draft_is_tested_once_it_is_known_to_be_good(open_page: OpenPage, watch: Watch) -> None:
    """The tests of the draft before were about to start, and met one that had not been looked at."""
    watch.allow("author/preview")
    held: list[Held] = []
    page = opened(open_page, started(), lambda page: held.append(Held(page, "**/author/preview")))
    previews = held[0]
    checks = Held(page, "**/author/check")
    table = page.locator("#author-parts [data-part=table]")
    previews.until(1)
    page.evaluate(UNCHECKED_ONCE_SHOWN)
    previews.let_go()
    expect(page.locator("#author-name")).not_to_be_empty(timeout=PATIENCE)
    expect(table).not_to_be_checked()
    previews.until(1)
    page.wait_for_timeout(2000)
    assert checks.waiting == []
    previews.let_go()
    expect(page.locator(".author-selftest")).to_have_attribute("data-state", "refused", timeout=PATIENCE)
    table.check()
    previews.until(1)
    previews.let_go()
    checks.until(1)
    previews.stop()
    checks.stop()
    expect(page.locator(".author-selftest")).to_have_attribute("data-state", "passed", timeout=PATIENCE)


def test_a_box_that_brings_fields_keeps_the_focus(open_page: OpenPage) -> None:
    """The card was built anew around whoever ticked a box by keyboard, and the focus was lost."""
    page = opened(open_page, started())
    expect(page.locator("#author-parts [data-part=transform]")).to_be_attached(timeout=PATIENCE)
    for box in (
        page.locator("#author-parts [data-part=transform]"),
        page.locator("#author-values").get_by_label("drawn per student").last,
        page.get_by_label("more with every attempt"),
        page.get_by_label("mark the last origin as P"),
    ):
        box.press("Space")
        expect(box).to_be_checked()
        expect(box).to_be_focused()


def test_weights_needs_rungs_and_samples_are_set_in_the_page(open_page: OpenPage) -> None:
    page = opened(open_page, started())
    expect(page.locator("#author-parts [data-part=table]")).to_be_checked(timeout=PATIENCE)
    page.locator("[data-path='definition/weights/joint']").fill("3")
    page.locator("[data-path='definition/weights/sign']").fill("0,25")
    page.get_by_label("more with every attempt").check()
    page.locator("[data-path='definition/help/ladder/0']").select_option("verdict")
    page.get_by_role("button", name="One more rung").click()
    page.get_by_role("button", name="Add: Sample").click()
    page.locator("[data-path='definition/tests/samples/0/name']").fill("as in the lecture")
    page.locator("[data-path='definition/policy/base']").select_option("frame")
    page.get_by_role("group", name="Needed in every right answer").get_by_label("L1").check()
    expect(page.locator(".author-selftest")).to_have_attribute("data-state", "passed", timeout=PATIENCE)
    found = definition(page)
    exercise = exercise_of_draft(ExerciseDraft(**found))
    assert (exercise.weights.joint, exercise.weights.sign) == (3, 0.25)
    assert [level.value for level in exercise.access.ladder] == ["verdict", "kind", "repair", "repair"]
    assert exercise.needs == ("L1",)
    assert exercise.samples[0].correct is True


def started() -> dict[str, Any]:
    """An arm of three joints, of which a table is asked."""
    rows = [
        {"joint": "revolute", "theta": "q1", "d": 0.4, "a": 0, "alpha": 90},
        {"joint": "revolute", "theta": "q2", "d": 0, "a": "L1", "alpha": 0},
        {"joint": "revolute", "theta": "q3", "d": 0, "a": "L2", "alpha": 0},
    ]
    return {
        "id": "arm",
        "definition": {
            "version": 1,
            "title": {"en": "An arm"},
            "reference": {"convention": "standard", "angle_unit": "deg", "length_unit": "m", "rows": rows},
            "parameters": {"L1": {"value": 0.5}, "L2": {"value": 0.3}},
            "policy": {"tool": "axis"},
            "parts": [{"kind": "table", "points": 10}],
            "tests": {"misconceptions": ["convention", "a_value"]},
        },
        "statements": {"en": "An arm with *L1* and *L2*."},
    }
