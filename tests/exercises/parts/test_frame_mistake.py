"""Mistakes in figures: planted, found, named and mended."""

import math
from dataclasses import replace

import pytest

from exercises.answers import Answer
from exercises.drawings import figure_drawing, figure_geometry
from exercises.figures.svg import document
from exercises.grading import Finding
from exercises.instance import Instance, generate
from exercises.parts.cells.short_forms import CELL_LIMITS
from exercises.parts.context import Context
from exercises.parts.mistakes.found_mistakes import MistakePart
from exercises.parts.mistakes.frame_mistake import (
    PART,
    FoundFrameMistakeCells,
    frames_shown,
    planted_in,
)
from exercises.parts.protocol import RawAnswer, Reading
from exercises.parts.report import PartReport
from kinematics.errors import Fault
from tests.exercises.packaged import exercise

EXERCISES = ("scara-frame-mistake", "stanford-frame-mistake", "puma560-frame-mistake")


def context(exercise_id: str, seed: int) -> tuple[MistakePart, Context]:
    """A student of an exercise."""
    found = exercise(exercise_id)
    (part,) = found.parts
    assert isinstance(part, MistakePart)
    answer = Answer(parts={}, angle_unit=found.angle_unit, length_unit=found.length_unit)
    return part, Context(instance=generate(found, seed), answer=answer, verdict=None)


def judged(part: MistakePart, known: Context, raw: FoundFrameMistakeCells) -> PartReport:
    """What is said of an answer."""
    reading = Reading(instance=known.instance, raw=RawAnswer(), table=None, limits=CELL_LIMITS)
    answer = PART.read(raw, reading)
    assert answer is not None, reading.faults
    return PART.grade(part, answer, known)


@pytest.mark.parametrize("name", EXERCISES)
def test_place_name_and_repair_earn_a_third_each(name: str) -> None:
    for seed in range(6):
        part, known = context(name, seed)
        planted = planted_in(known.instance)
        for index in range(len(planted.shown)):
            report = judged(part, known, FoundFrameMistakeCells(wrong_frame=str(index)))
            assert report.score == pytest.approx((index == planted.index) / 3)
        assert judged(part, known, FoundFrameMistakeCells(mistake=planted.code)).score == pytest.approx(1 / 3)
        right = PART.right(part, known)
        assert judged(part, known, right).score == 1.0
        untouched = judged(part, known, replace(right, mended_origin=("", "", "")))
        finding = {fact.where: fact.finding for fact in untouched.facts}
        assert finding["mended_origin",] is Finding.MISSING
        assert untouched.score == pytest.approx(2 / 3)


def test_a_frame_with_x_the_other_way_mends_too_and_a_left_handed_one_does_not() -> None:
    part, known = context("stanford-frame-mistake", 1)
    right = PART.right(part, known)
    assert right.mended_x is not None
    assert right.mended_y is not None

    def against(vector: tuple[float | str, ...]) -> tuple[float, ...]:
        return tuple(-float(value) for value in vector)

    other = replace(right, mended_x=against(right.mended_x), mended_y=against(right.mended_y))
    assert judged(part, known, other).score == 1.0
    assert judged(part, known, replace(right, mended_y=against(right.mended_y))).score < 1.0


def test_students_get_different_mistakes_and_each_the_same_again() -> None:
    def drawn(seed: int) -> tuple[int, str]:
        found = planted_in(context("puma560-frame-mistake", seed)[1].instance)
        return found.index, found.code

    assert len({drawn(seed) for seed in range(16)}) > 8
    assert drawn(3) == drawn(3)


def test_the_figure_shows_the_frames_and_no_other_figure_does() -> None:
    def names(instance: Instance) -> str:
        drawing = figure_drawing(instance, frames=frames_shown(instance))
        return document(drawing, title="", description="", language="en")

    instance = generate(exercise("scara-frame-mistake"), 2)
    assert names(instance).count('class="frame-') >= 3 * len(frames_shown(instance))
    assert len(figure_geometry(instance, frames_shown(instance))["frames"]) == 5  # type: ignore[arg-type]
    assert 'class="frame-' not in names(generate(exercise("scara"), 2))


@pytest.mark.parametrize(
    ("raw", "code", "where"),
    [
        (FoundFrameMistakeCells(wrong_frame=5), "frame_unknown", ("wrong_frame",)),
        (FoundFrameMistakeCells(wrong_frame="x"), "frame_unknown", ("wrong_frame",)),
        (FoundFrameMistakeCells(mistake="typo"), "misconception_unknown", ("mistake",)),
        (FoundFrameMistakeCells(mended_x=(0, 0, 0)), "direction_zero", ("mended_x",)),
        (FoundFrameMistakeCells(mended_origin=(0, "zz", 0)), "name_unknown", ("mended_origin", 1)),
        (FoundFrameMistakeCells(mended_origin=(1e14, 0, 0)), "vector_malformed", ("mended_origin",)),
        (FoundFrameMistakeCells(mended_y=(0, 1e14, 0)), "vector_malformed", ("mended_y",)),
    ],
)
def test_what_cannot_be_read_is_refused_with_its_place(
    raw: FoundFrameMistakeCells, code: str, where: tuple[str | int, ...]
) -> None:
    _, known = context("scara-frame-mistake", 1)
    reading = Reading(instance=known.instance, raw=RawAnswer(), table=None, limits=CELL_LIMITS)
    assert PART.read(raw, reading) is None
    found: list[Fault] = reading.faults
    assert [(fault.code, fault.where) for fault in found] == [(code, where)]


def test_mistakes_that_the_robot_cannot_show_are_refused() -> None:
    """Parallel axes have no intersection, and a definition that asks for nothing else gets nothing else."""
    found = exercise("scara-frame-mistake")
    (part,) = found.parts
    assert isinstance(part, MistakePart)
    (fault,) = PART.inconsistencies(replace(part, mistakes=("origin_not_at_intersection",)), found)
    assert (fault.code, fault.where) == ("frame_mistakes_not_shown", ("mistakes",))
    assert "y_left_handed" in str(fault.params["known"])
    some = replace(part, mistakes=("origin_not_at_intersection", "y_left_handed"))
    assert not list(PART.inconsistencies(some, found))


def test_a_frame_that_is_mended_by_another_dimension_is_not() -> None:
    """The axis of joint 2 is a2 away; a multiple of a3 that is as long is right for one student alone."""
    tried = 0
    for seed in range(20):
        part, known = context("scara-frame-mistake", seed)
        right = PART.right(part, known)
        assert right.mended_origin is not None
        x, y, z = (float(value) for value in right.mended_origin)
        if z or abs(math.hypot(x, y) - known.parameters["a2"]) > 1e-5:
            continue
        tried += 1
        for name, mended in (("a2", True), ("a3", False)):
            origin = tuple(f"{value / known.parameters[name]:.6f}*{name}" for value in (x, y))
            report = judged(part, known, replace(right, mended_origin=(*origin, 0)))
            assert (report.score == 1.0) is mended
    assert tried
