"""Orientations and chains of frames: what a wrong answer earns, and where it is shown to be wrong."""

import math
from typing import Any

import numpy as np
import pytest

from exercises.answers import RawAnswer, parse
from exercises.grading import Finding
from exercises.instance import Instance, generate
from exercises.parts.context import Context
from exercises.parts.registry import part_type
from exercises.parts.report import PartReport
from exercises.parts.rotations.frame_chain import FrameChainCells
from exercises.parts.rotations.orientation import OrientationPart
from exercises.parts.rotations.orientation_cells import OrientationCells
from kinematics.rotations.sequences import Combination, euler_solutions
from kinematics.se3 import triple
from tests.exercises.answering import codes, judged, part
from tests.exercises.packaged import exercise

LOCKED, FREE = "puma560-gimbal-lock", "rx90-orientation"
RELATION = {"middle": 0, "combination": Combination.SUM, "value": 17}


def solutions(instance: Instance) -> Any:
    """The triples of the task, and the relation of those at gimbal lock."""
    asked = instance.exercise.part("orientation")
    assert isinstance(asked, OrientationPart)
    return euler_solutions(asked.sequence.matrix(instance.drawn["orientation"]), asked.asked_sequence)


def share(exercise_id: str, **cells: Any) -> float:
    """What the angles earn of their points, with everything else that is asked right."""
    found = part(judged(exercise_id, orientation=OrientationCells(**cells)), "orientation")
    return float(found.score)


def degrees(*angles: float) -> tuple[float, float, float]:
    return triple(math.degrees(angle) for angle in angles)


def relation() -> dict[str, Any]:
    family = solutions(generate(exercise(LOCKED), None)).family
    middle, value, _ = degrees(family.middle, family.value, 0)
    return {"middle": middle, "combination": family.combination, "value": value}


def member() -> tuple[float, float, float]:
    family = solutions(generate(exercise(LOCKED), None)).family
    return degrees(0.4, family.middle, family.last(0.4))


def test_at_gimbal_lock_a_slip_in_triples_or_in_their_relation_leaves_half() -> None:
    right, wrong = member(), (11, 52, 13)
    value = {**relation(), "value": relation()["value"] + 30}
    whole = share(LOCKED, angles=(right,), **relation())
    assert share(LOCKED, **relation()) == whole
    for cells in (
        {"angles": (right,)},
        {"angles": (right,), **value},
        {"angles": (wrong,), **relation()},
        {"angles": (right, wrong), **relation()},
    ):
        assert share(LOCKED, **cells) == pytest.approx(whole / 2)
    assert share(LOCKED, angles=(wrong,), **value) == share(LOCKED, **value) == 0.0


def test_a_relation_where_there_is_none_halves_what_triples_earn() -> None:
    first, second = (degrees(*angles) for angles in solutions(generate(exercise(FREE), None)).triples)
    whole = share(FREE, angles=(first, second))
    assert whole > 0
    assert share(FREE, angles=(first, second), **RELATION) == pytest.approx(whole / 2)
    assert share(FREE, angles=(first,), **RELATION) == pytest.approx(whole / 4)
    assert share(FREE, **RELATION) == 0.0


def chain(*changes: tuple[int, int, float]) -> PartReport:
    """The pose of the task with some entries changed."""
    instance = generate(exercise("stanford-frame-chain"), None)
    asked = instance.exercise.part("frame_chain")
    assert asked is not None
    nothing = parse(instance, RawAnswer(frame_chain=FrameChainCells(pose=np.eye(4).tolist())))
    context = Context(instance=instance, answer=nothing, verdict=None)
    right: Any = part_type("frame_chain").right(asked, context).pose
    pose = np.array(right, dtype=np.float64)
    for r, c, value in changes:
        pose[r, c] = value
    answer = FrameChainCells(pose=pose.tolist())
    return part(judged("stanford-frame-chain", frame_chain=answer), "frame_chain")


@pytest.mark.parametrize("at", [(0, 1), (2, 3), (3, 0), (3, 3)])
def test_only_the_entries_that_are_wrong_are_marked(at: tuple[int, int]) -> None:
    found = chain((*at, 7.0))
    wrong = [fact.where for fact in found.facts if fact.finding is not Finding.OK]
    assert wrong == [("pose", *at)]
    assert len(found.facts) == 16
    assert ("chain_not_rigid" in codes(found)) == (at != (2, 3))
