"""What a student does in the trainer, as functions: by the lecture, or by a habit."""

import random
import re
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from playwright.sync_api import Locator, Page, expect

Pick = Callable[[int, str, list[list[float]]], int]
"""From frame, part and the offered vectors to the one that is chosen."""

STEPS = ("z", "normals", "origin", "x", "read")


def ready(page: Page) -> None:
    expect(page.locator("fieldset.choices")).to_have_count(1)


def drawn(page: Page) -> None:
    """Wait until the options stand in the picture, where they will be."""
    page.wait_for_function(
        "() => document.querySelector('robot-scene')?.model.items.some(({ pick }) => pick)"
    )
    page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
    expect(page.locator("robot-scene")).to_have_attribute("data-drawn", re.compile(r"\d"))


def offered(page: Page) -> list[list[float]]:
    """The vectors of the options as they stand in the list."""
    texts = page.locator("fieldset.choices label.choice .hint").all_inner_texts()
    return [[float(value.replace("−", "-")) for value in text.strip("()").split(";")] for text in texts]


def frame_button(page: Page, frame: int) -> Locator:
    return page.locator("#frames button").nth(frame)


def go_to(page: Page, frame: int) -> None:
    frame_button(page, frame).click()
    expect(page.locator("fieldset.choices legend")).to_contain_text(f"frame {frame}")


def walk(page: Page, frames: int, pick: Pick) -> bool:
    """Go through the steps once; whether the table was reached."""
    for step in STEPS[:-1]:
        if page.locator("#steps [aria-current]").get_attribute("data-step") != step:
            return False
        if step != "normals":
            for frame in range(frames):
                go_to(page, frame)
                option = page.locator("fieldset.choices label.choice input").nth(
                    pick(frame, step, offered(page))
                )
                option.evaluate("input => input.click()")
                expect(frame_button(page, frame)).to_have_class("small step step-whole")
        page.locator("#frame button.primary").click()
        expect(page.locator("#frame")).not_to_have_attribute("aria-busy", "true")
    return page.locator("#frame .notice-good").count() == 1


def by_lecture(frames: Sequence[dict[str, list[float]]]) -> Pick:
    """Choose what the assigned frames have."""

    def pick(frame: int, part: str, vectors: list[list[float]]) -> int:
        wanted = np.array(frames[frame][part])
        return int(np.argmin([np.linalg.norm(np.array(vector) - wanted) for vector in vectors]))

    return pick


def first(_frame: int, _part: str, _vectors: list[list[float]]) -> int:
    return 0


def last(_frame: int, _part: str, vectors: list[list[float]]) -> int:
    return len(vectors) - 1


def at_random(seed: int) -> Pick:
    """Any option, as likely as any other."""
    draw = random.Random(seed)
    return lambda _frame, _part, vectors: draw.randrange(len(vectors))


def assigned(page: Page, web: str, exercise: dict[str, Any]) -> list[dict[str, list[float]]]:
    """The frames that the service assigns, the last one at the marked point where the exercise wants it."""
    figure = exercise["figure"]
    axes = [
        {"joint": axis["type"], "point": axis["point"], "direction": axis["direction"]}
        for axis in figure["axes"]
    ]
    body: dict[str, Any] = {"axes": axes, "convention": exercise["conventions"][0]}
    if exercise["policy"]["tool"] == "point":
        body["tool"] = _tool(axes[-1], figure["points"][0]["at"], figure["size"])
    answer = page.request.post(f"{web}/api/v1/assign-frames", data=body)
    assert answer.ok, answer.text()
    return answer.json()["frames"]  # type: ignore[no-any-return]


def _tool(axis: dict[str, Any], point: list[float], size: float) -> list[list[float]]:
    """A frame at the point whose x leads there from the last axis at right angles."""
    z = np.array(axis["direction"]) / np.linalg.norm(axis["direction"])
    away = np.array(point) - axis["point"]
    x = away - z * (away @ z)
    if np.linalg.norm(x) < 1e-9 * size:
        other = np.array([1.0, 0, 0]) if abs(z[0]) < 0.8 else np.array([0, 1.0, 0])
        x = np.cross(other, z)
    x = x / np.linalg.norm(x)
    pose = np.eye(4)
    pose[:3, 0], pose[:3, 1], pose[:3, 2], pose[:3, 3] = x, np.cross(z, x), z, point
    return pose.tolist()  # type: ignore[no-any-return]
