"""A Jacobian with one slip throughout: it is told once, of all the columns that it spoils."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from exercises.answers import RawAnswer, parse
from exercises.grader import grade
from exercises.instance import generate
from exercises.parts.motion.jacobians import PART
from exercises.selftest.answers import context_of
from service.messages import languages, sentence
from tests.exercises.packaged import exercise


def told(columns):
    """The feedback on the right answer to the Stanford's Jacobian with other columns."""
    instance = generate(exercise("stanford-jacobian"), "4")
    right = PART.right(instance.exercise.parts[0], context_of(instance, instance.exercise.reference))
    matrix = columns(np.array(right.jacobian, dtype=float))
    answer = replace(right, jacobian=tuple(map(tuple, matrix.tolist())))
    found = grade(instance, parse(instance, RawAnswer(jacobian=answer))).parts[0]
    return [(said.code, dict(said.params)) for said in found.feedback]


@pytest.mark.parametrize("turning", [(1,), (1, 2), (1, 2, 4, 5)])
def test_one_slip_is_told_once(turning) -> None:
    def point_swapped(matrix):
        matrix[:3, [joint - 1 for joint in turning]] *= -1
        return matrix

    (first, (code, params)) = told(point_swapped)
    assert first == ("jacobian_wrong", {})
    joints = tuple(map(str, turning))
    assert (code, params) == (
        "jacobian_point_swapped",
        {"joint": 1, "joints": joints, "count": len(joints)},
    )
    for language in languages():
        assert f" {', '.join(joints)}" in sentence(language, f"feedback-{code}", params)


def test_the_axes_of_the_next_joints_are_told_once() -> None:
    codes = told(lambda matrix: np.hstack([matrix[:, 1:], matrix[:, -1:]]))
    assert [(code, params.get("joints")) for code, params in codes] == [
        ("jacobian_wrong", None),
        ("jacobian_next_axis", ("1", "2", "4", "5")),
        ("jacobian_prismatic", ("3",)),
    ]


def test_millimetres_are_told_as_such() -> None:
    codes = told(lambda matrix: matrix * np.array([1000] * 3 + [1] * 3)[:, None])
    assert [code for code, _ in codes] == ["jacobian_wrong", "jacobian_other_unit"]
