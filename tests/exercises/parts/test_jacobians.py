"""A Jacobian with one slip throughout: it is told once, of all the columns that it spoils."""

import math
from dataclasses import replace

import numpy as np
import pytest

from exercises.answers import RawAnswer, parse
from exercises.grader import grade
from exercises.instance import generate
from exercises.parts.joint_draws import key_numbers
from exercises.parts.motion.jacobian_cells import JacobianTerms
from exercises.parts.motion.jacobians import PART
from exercises.parts.registry import part_type
from exercises.selftest.answers import context_of
from kinematics.cells import AngleUnit, LengthUnit, RawRow, RawTable
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


@pytest.mark.parametrize("per_table", [False, True])
def test_lengths_are_those_of_the_task_or_of_the_table(per_table: bool) -> None:
    """The task asks for metres; a table in millimetres beside it made these wrong."""
    asked = exercise("scorbot-own-jacobian")
    instance = generate(asked, "4")
    own = asked.reference
    in_mm = RawTable(
        convention=own.table.convention,
        rows=tuple(
            RawRow(
                theta=f"q{i}", d=1000 * row.d if row.d else 0, a=1000 * row.a, alpha=math.degrees(row.alpha)
            )
            for i, row in enumerate(key_numbers(instance).rows, 1)
        ),
        angle_unit=AngleUnit.DEG,
        length_unit=LengthUnit.MM,
    )
    kind = "jacobian"
    kept = next(found for found in instance.exercise.parts if found.kind == kind)
    right = PART.right(kept, context_of(instance, own))
    ratio = 1000.0 if per_table else 1.0
    columns = np.array(right.jacobian, dtype=float) * np.array([ratio] * 3 + [1.0] * 3)[:, None]
    forces = None if right.forces is None else tuple(ratio * force for force in right.forces)
    answer = replace(right, jacobian=tuple(map(tuple, columns.tolist())), forces=forces)
    report = grade(instance, parse(instance, RawAnswer(table=in_mm, jacobian=answer)))
    assert all(found.correct for found in report.parts if found.kind in ("table", kind))


@pytest.mark.parametrize("name", ["stanford-jacobian", "twolink-jacobian-form"])
@pytest.mark.parametrize("unit", LengthUnit)
def test_forces_and_moments_have_units(name: str, unit: LengthUnit) -> None:
    """A force of 10 was given without a unit, and joint torques and forces were asked for without one."""
    asked = exercise(name)
    (part,) = (part for part in asked.parts if isinstance(part, JacobianTerms))
    told = part_type(part.kind).task(part, generate(replace(asked, length_unit=unit)))
    moment = f"[N {unit.value}]"
    (load,) = (numbers.labels for numbers in told.numbers if numbers.name == "wrench")
    assert load == ("fx [N]", "fy [N]", "fz [N]", f"mx {moment}", f"my {moment}", f"mz {moment}")
    (held,) = (field.labels for field in told.form if field.name == "forces")
    assert held[:3] == (f"q1 {moment}", f"q2 {moment}", "q3 [N]")[: len(held)]
