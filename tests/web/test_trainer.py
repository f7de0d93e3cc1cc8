"""The frame trainer in a real browser: the walk of the lecture, walks of habit, and each step by itself."""

import re
from collections.abc import Callable
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from tests.conftest import EXPLORE
from tests.exercises.packaged import table_ids
from tests.web.conftest import OpenPage
from tests.web.driving import Held
from tests.web.walking import (
    assigned,
    at_random,
    by_lecture,
    drawn,
    first,
    frame_button,
    go_to,
    last,
    offered,
    ready,
    walk,
)

EXERCISES = sorted(set(table_ids) - {"scara-own-inverse"})
"""All with a table but the one whose frames 0 and N are given: it has no trainer."""

KINDS = ("dmra", "onelink", "scara")
"""A slide, a wrist, parallel axes, a fixed row, with and without a marked point, either convention; `make
explore` walks all."""
WALKED = EXERCISES if EXPLORE else KINDS
WALKED_BY_HABIT = EXERCISES if EXPLORE else ["scara-scm", "uw"]


def exercise_of(page: Page, web: str, name: str) -> dict[str, Any]:
    return page.request.get(f"{web}/api/v1/exercises/{name}").json()  # type: ignore[no-any-return]


def option(page: Page, text: str) -> None:
    """Choose by what an option says; on its way a pointer would have arrows drawn, slowly if busy."""
    found = page.locator("fieldset.choices label.choice", has_text=re.compile(rf"^{text}\(")).first
    found.locator("input").evaluate("input => input.click()")


@pytest.mark.parametrize("name", WALKED)
def test_the_walk_of_the_lecture_makes_a_right_table(open_page: OpenPage, web: str, name: str) -> None:
    """What the trainer calls complete the exercise calls right, in its own convention, names and units."""
    page = open_page(f"/trainer/{name}")
    ready(page)
    exercise = exercise_of(page, web, name)
    assert walk(page, len(exercise["joints"]) + 1, by_lecture(assigned(page, web, exercise)))
    assert not re.search(r"\d\.\d{7}", page.locator("#table").inner_text())
    page.locator("#frame button.primary").click()
    expect(page.locator("#own")).to_contain_text("Drawn from your table")
    table = page.evaluate("document.querySelector('dh-table-editor').table")
    assert table["convention"] == exercise["conventions"][0]
    verdict = page.request.post(f"{web}/api/v1/exercises/{name}/grade", data={"table": table}).json()
    assert verdict["parts"]["table"]["correct"], verdict["feedback"]


def test_habits_lead_nowhere(open_page: OpenPage, web: str) -> None:
    """Always the first option, always the last, any: at most one walk in twenty reaches the table."""
    page = open_page("/trainer/onelink")
    done = 0
    walks = 0
    for name in WALKED_BY_HABIT:
        joints = len(exercise_of(page, web, name)["joints"])
        for pick in (first, last, at_random(len(name))):
            page.evaluate("localStorage.clear()")
            page.goto(f"{web}/trainer/{name}?lang=en")
            ready(page)
            done += walk(page, joints + 1, pick)
            walks += 1
    assert done <= 0.05 * walks


def test_a_broken_rule_is_named_at_the_end_of_the_step_and_not_before(open_page: OpenPage) -> None:
    page = open_page("/trainer/twolink")
    ready(page)
    for frame, text in enumerate(("along X of the figure’s coordinates", "along axis 1", "along axis 2")):
        go_to(page, frame)
        option(page, text)
        expect(frame_button(page, frame)).to_have_class(re.compile("step-whole"))
    expect(page.locator(".notice-problem")).to_have_count(0)
    page.locator("#frame button.primary").click()
    expect(page.locator("fieldset.choices .notice-problem")).to_have_text(
        "z must lie along axis 1, because joint 1 turns about this z or slides along it."
    )
    expect(page.get_by_role("button", name="Frame 0: breaks a rule")).to_be_visible()
    option(page, "along axis 1")
    expect(page.locator(".notice-problem")).to_have_count(0)
    page.locator("#frame button.primary").click()
    expect(page.locator("#steps [aria-current]")).to_have_text("Common normals")


def test_an_open_choice_is_pointed_out(open_page: OpenPage) -> None:
    page = open_page("/trainer/twolink")
    ready(page)
    page.locator("#frame button.primary").click()
    expect(page.locator("#announcer")).to_have_text("Frame 0 has no choice yet.")
    expect(page.locator("#frame .notice")).to_have_text("Frame 0 has no choice yet.")
    expect(page.locator("#steps [aria-current]")).to_have_text("z axes")


def test_options_are_not_numbered_and_have_another_order_for_each_frame(
    open_page: OpenPage, web: str
) -> None:
    page = open_page("/trainer/puma560")
    ready(page)
    orders = set()
    for frame in range(3):
        go_to(page, frame)
        texts = page.locator("label.choice").all_inner_texts()
        assert not any(re.match(r"\d", text) for text in texts)
        orders.add(next(i for i, text in enumerate(texts) if "of the figure’s coordinates" in text))
    numbers = page.locator(".scene-label.tone-pick")
    expect(numbers.filter(has_text=re.compile(r"^\d+$"))).to_have_count(0)
    assert len(orders) > 1


def test_an_arrow_can_be_clicked(open_page: OpenPage) -> None:
    page = open_page("/trainer/scara")
    ready(page)
    drawn(page)
    place = page.evaluate(
        """() => {
          const scene = document.querySelector("robot-scene");
          const box = scene.viewport.getBoundingClientRect();
          for (let y = 4; y < box.height; y += 4) for (let x = 4; x < box.width; x += 4) {
            const id = scene.pickedAt(x, y);
            if (id === "2") return [box.x + x, box.y + y];
          }
          return null;
        }"""
    )
    assert place is not None
    page.mouse.click(*place)
    expect(frame_button(page, 0)).to_have_class(re.compile("step-whole"))
    go_to(page, 0)
    expect(page.locator("fieldset.choices input").nth(2)).to_be_checked()


def test_a_choice_is_for_the_frame_whose_list_is_shown(open_page: OpenPage) -> None:
    """While another frame's list is on its way, a choice in the one still there counts for neither."""
    page = open_page("/trainer/scara")
    ready(page)
    held = Held(page, "**/check-frames")
    frame_button(page, 2).click()
    held.until(1)
    page.locator("fieldset.choices label.choice").nth(1).click()
    held.stop()
    expect(page.locator("fieldset.choices legend")).to_contain_text("frame 2")
    expect(page.locator("#frames .step-whole")).to_have_count(0)


def test_the_focus_stays_on_the_option_that_was_chosen(open_page: OpenPage) -> None:
    page = open_page("/trainer/onelink")
    ready(page)
    go_to(page, 1)
    page.keyboard.press("Tab")
    page.locator("fieldset.choices input").first.focus()
    page.keyboard.press("Space")
    expect(frame_button(page, 1)).to_have_class(re.compile("step-whole"))
    expect(page.locator("fieldset.choices input:focus")).to_have_count(1)


def test_choices_survive_a_reload_and_another_convention_starts_again(open_page: OpenPage) -> None:
    page = open_page("/trainer/rx90")
    ready(page)
    go_to(page, 1)
    option(page, "along axis 2")
    expect(frame_button(page, 1)).to_have_class(re.compile("step-whole"))
    page.reload()
    ready(page)
    expect(frame_button(page, 1)).to_have_class(re.compile("step-whole"))
    page.get_by_role("radio", name="modified").check()
    expect(page.locator("#frames .step-whole")).to_have_count(0)


@pytest.mark.parametrize(("webgl", "renderer"), [(True, "webgl"), (False, "svg")])
def test_the_drawing_is_there_with_and_without_webgl(open_page: OpenPage, webgl: bool, renderer: str) -> None:
    page = open_page("/trainer/puma560", webgl=webgl)
    ready(page)
    expect(page.locator("robot-scene")).to_have_attribute("data-renderer", renderer)
    expect(page.locator("robot-scene canvas" if webgl else "robot-scene svg").first).to_be_visible()


def test_accessible_with_a_broken_rule(
    open_page: OpenPage, assert_accessible_at_both_sizes: Callable[[Page], None]
) -> None:
    page = open_page("/trainer/twolink")
    ready(page)
    for frame in range(3):
        go_to(page, frame)
        option(page, "along X of the figure’s coordinates")
    page.locator("#frame button.primary").click()
    expect(page.locator(".notice-problem").first).to_be_visible()
    assert_accessible_at_both_sizes(page)


def tip_of(page: Page, option_index: int) -> list[float]:
    """A place in the window where an arrow or a point alone would be picked."""
    found = page.evaluate(
        """(wanted) => {
          const scene = document.querySelector("robot-scene");
          const box = scene.viewport.getBoundingClientRect();
          const places = [];
          for (let y = 4; y < box.height; y += 4) for (let x = 4; x < box.width; x += 4)
            if (scene.pickedAt(x, y) === String(wanted)) places.push([box.x + x, box.y + y]);
          return places[Math.floor(places.length / 2)] ?? null;
        }""",
        option_index,
    )
    assert found is not None
    return found  # type: ignore[no-any-return]


def test_an_arrow_is_dragged_onto_another_direction(open_page: OpenPage) -> None:
    """What is dragged lights the nearest choice on the way; where it is dropped, it is chosen."""
    page = open_page("/trainer/scara")
    ready(page)
    drawn(page)
    start, end = tip_of(page, 1), tip_of(page, 2)
    page.evaluate(
        """() => document.querySelector("robot-scene").addEventListener("scene-drag",
          (event) => (window.dragged = [...(window.dragged ?? []), event.detail.id]))"""
    )
    page.mouse.move(*start)
    page.mouse.down()
    page.mouse.move(*end, steps=6)
    page.mouse.up()
    dragged = page.evaluate("window.dragged")
    assert dragged[0] == "1"
    assert dragged[-2:] == ["2", None]
    expect(frame_button(page, 0)).to_have_class(re.compile("step-whole"))
    go_to(page, 0)
    expect(page.locator("fieldset.choices input").nth(2)).to_be_checked()


def test_an_option_lights_its_arrow(open_page: OpenPage) -> None:
    page = open_page("/trainer/scara")
    ready(page)
    lit = page.locator("robot-scene svg .stroke-lit")
    expect(lit).to_have_count(0)
    page.locator("label.choice").nth(1).hover()
    expect(lit).not_to_have_count(0)
    page.locator("label.choice input").nth(3).focus()
    page.locator("#trainer h1").hover()
    expect(lit).to_have_count(0)


def test_a_finished_step_says_why_it_is_right(open_page: OpenPage, web: str) -> None:
    page = open_page("/trainer/twolink")
    ready(page)
    frames = assigned(page, web, exercise_of(page, web, "twolink"))
    for frame in range(len(frames)):
        go_to(page, frame)
        chosen = page.locator("fieldset.choices input").nth(by_lecture(frames)(frame, "z", offered(page)))
        chosen.evaluate("input => input.click()")
        expect(frame_button(page, frame)).to_have_class(re.compile("step-whole"))
    page.locator("#frame button.primary").click()
    expect(page.locator("#why")).to_contain_text("z of frame i−1 along axis i, because row i")


def test_a_step_that_is_ended_twice_at_once_ends_once(open_page: OpenPage, web: str) -> None:
    """The second press comes while the next step is on its way, or is there with nothing chosen yet."""
    page = open_page("/trainer/twolink")
    ready(page)
    frames = assigned(page, web, exercise_of(page, web, "twolink"))
    page.evaluate(
        """frames => {
          const [key] = Object.keys(localStorage).filter((name) => name.includes("trainer:2:twolink"));
          const state = { ...JSON.parse(localStorage[key]), step: "origin", frames };
          localStorage[key] = JSON.stringify(state);
        }""",
        [{"z": frame["z"], "origin": frame["origin"]} for frame in frames],
    )
    page.reload()
    ready(page)
    page.locator("#frame button.primary").dblclick()
    expect(page.locator("#steps [aria-current]")).to_have_attribute("data-step", "x")
    expect(page.locator("#frame .notice-problem")).to_have_count(0)
    page.locator("#frame button.primary").press("Enter")
    expect(page.locator("#announcer")).to_have_text("Frame 0 has no choice yet.")
    expect(page.locator("fieldset.choices legend")).to_contain_text("frame 0")


def test_a_step_that_is_ended_before_its_last_choice_is_judged_waits_for_that(open_page: OpenPage) -> None:
    page = open_page("/trainer/twolink")
    ready(page)
    for frame in (1, 2):
        go_to(page, frame)
        option(page, f"along axis {frame}")
        expect(frame_button(page, frame)).to_have_class(re.compile("step-whole"))
    go_to(page, 0)
    held = Held(page, "**/check-frames")
    option(page, "along X of the figure’s coordinates")
    held.until(1)
    page.locator("#frame button.primary").click()
    held.stop()
    expect(page.get_by_role("button", name="Frame 0: breaks a rule")).to_be_visible()
    expect(page.locator("#steps [aria-current]")).to_have_attribute("data-step", "z")


def test_the_focus_goes_on_to_what_the_next_step_asks(open_page: OpenPage, web: str) -> None:
    page = open_page("/trainer/twolink")
    ready(page)
    frames = assigned(page, web, exercise_of(page, web, "twolink"))
    for frame in range(len(frames)):
        go_to(page, frame)
        chosen = page.locator("fieldset.choices input").nth(by_lecture(frames)(frame, "z", offered(page)))
        chosen.evaluate("input => input.click()")
        expect(frame_button(page, frame)).to_have_class(re.compile("step-whole"))
    for step, task in (("normals", "common normal"), ("origin", "origin")):
        page.locator("#frame button.primary").press("Enter")
        expect(page.locator("#steps [aria-current]")).to_have_attribute("data-step", step)
        expect(page.locator("#frame p:focus")).to_contain_text(re.compile(task, re.IGNORECASE))
    page.locator("#steps button").first.press("Enter")
    expect(page.locator("#steps [aria-current]")).to_have_attribute("data-step", "z")
    expect(page.locator("#frame p:focus")).to_have_count(1)


def test_numbers_stand_clear_of_other_joints(open_page: OpenPage, web: str) -> None:
    """In the usual view no joint's number is seen on another joint's body, for any robot."""
    page = open_page("/trainer/onelink")
    for name in EXERCISES:
        figure = exercise_of(page, web, name)["figure"]
        clear = page.evaluate(
            """async (figure) => {
              const scene = `${document.documentElement.dataset.assets}/js/scene/`;
              const at = (path) => new URL(scene + path, location.href);
              const { figureRobot } = await import(at("robots.js"));
              const { project, fitted, VIEWS } = await import(at("camera.js"));
              const { poses, position, direction, drawnPoints } = await import(at("model.js"));
              const model = figureRobot(figure, { dimensions: false });
              const found = poses(model, []);
              const start = { ...VIEWS.corner, scale: 1, target: [0, 0, 0], width: 400, height: 400 };
              const camera = fitted(start, drawnPoints(model, []));
              const seen = (point) => project(camera, point);
              const bodies = model.items.filter(({ tone }) => tone === "joint").map((item, i) => {
                const axis = direction(found, item.at.node, item.axis);
                const middle = position(found, item.at);
                const end = (s) => seen(middle.map((value, k) => value + s * item.length / 2 * axis[k]));
                const wide = (item.radius ?? item.width / 2) * camera.scale;
                return { joint: i + 1, from: end(-1), to: end(1), wide };
              });
              const names = model.items.filter(({ kind, text }) => kind === "label" && /^\\d+$/.test(text));
              const others = ({ text }) => bodies.filter(({ joint }) => String(joint) !== text);
              const room = (name, { from, to, wide }) => {
                const p = seen(position(found, name.at));
                const [dx, dy] = [to.x - from.x, to.y - from.y];
                const along = ((p.x - from.x) * dx + (p.y - from.y) * dy) / (dx * dx + dy * dy || 1);
                const share = Math.max(0, Math.min(1, along));
                return Math.hypot(p.x - from.x - share * dx, p.y - from.y - share * dy) - wide;
              };
              return names.flatMap((name) =>
                others(name).filter((body) => room(name, body) < 0).map(({ joint }) => [name.text, joint])
              );
            }""",
            figure,
        )
        assert clear == [], name
