"""Screws and home poses as cells: any zero, sense, point, frame, order and length of sliders."""

import random
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from exercises.parts.joint_draws import key_numbers
from exercises.parts.motion.screws import ScrewsCells
from kinematics.answers.screw_answers import ScrewAnswer, ScrewFrame, ScrewOrder
from tests.exercises.meaning.answers_known import KnownAnswer, known, typed_rows
from tests.exercises.meaning.posed_answers import student
from tests.kinematics.answers.screw_rows import motion, spoilt, written

EXERCISES = ("kr125-screws", "scorbot-screws", "scara-screws")


def screws(rng: random.Random) -> Iterator[KnownAnswer]:
    """A product of exponentials, and another robot's; of the tool its point alone is given."""
    instance = student(rng.choice(EXERCISES), rng.randrange(60))
    table = key_numbers(instance)
    answer = written(table, rng, motion(rng, 0.0))
    yield known(True, instance, "screws", screws=_cells(answer, rng))
    yield known(False, instance, "screws", screws=_cells(spoilt(answer, table, rng), rng))
    if answer.frame is ScrewFrame.SPACE:
        moved = answer.home @ motion(rng, 0.0)
        moved[:3, 3] += (0.1 * np.abs(moved[:3, 3]).max() + 0.05) * _across(answer.screws[-1, 3:], rng)
        off = ScrewAnswer(screws=answer.screws, home=moved, frame=answer.frame)
        yield known(False, instance, "screws", screws=_cells(off, rng))


def _across(axis: NDArray[np.float64], rng: random.Random) -> NDArray[np.float64]:
    """A unit vector at a right angle to an axis: along the last one a tool point may be moved freely."""
    side = np.cross(axis, [rng.gauss(0.0, 1.0) for _ in range(3)])
    return side / np.linalg.norm(side)


def _cells(answer: ScrewAnswer, rng: random.Random) -> ScrewsCells:
    order = rng.choice(list(ScrewOrder))
    rows = answer.screws
    if order is ScrewOrder.ANGULAR_FIRST:
        rows = np.hstack([rows[:, 3:], rows[:, :3]])
    return ScrewsCells(
        frame=answer.frame,
        order=order,
        screws=tuple(tuple(row) for row in typed_rows(rows, rng, 6)),  # type: ignore[misc]
        home=typed_rows(answer.home, rng, 6),
    )
