"""Orientations between the wire and the domain."""

from __future__ import annotations

import math
from collections.abc import Callable

from kinematics.cells import AngleUnit
from kinematics.errors import Fault, PoseError
from kinematics.poses import (
    axis_angle_from_transform,
    quaternion_from_transform,
    transform_from_axis_angle,
    transform_from_quaternion,
)
from kinematics.rotations.matrices import Matrix3, as_transform, matrix3, rotation_part
from kinematics.rotations.orientation_answers import (
    Built,
    OrientationVerdict,
    judge_axis_angle,
    judge_family,
    judge_matrix,
    judge_quaternion,
    judge_triples,
)
from kinematics.rotations.properties import failed_properties
from kinematics.rotations.sequences import SEQUENCES, EulerSequence, GimbalFamily, euler_solutions
from service.http.problems import located
from service.schemas.kinematics.rotations import (
    NOTATIONS,
    CheckRotationAnswer,
    CheckRotationRequest,
    FamilyModel,
    OrientationAnswerModel,
    OrientationModel,
    RotationMistakeModel,
    RotationsAnswer,
    RotationsRequest,
    SequenceAngles,
)

ANSWERS = (*NOTATIONS, "triples", "family")


def all_notations(request: RotationsRequest) -> RotationsAnswer:
    """Return an orientation in every notation.

    Raises:
        PoseError: no notation or more than one, or one without a meaning.
    """
    unit, back = _units(request.angle_unit)
    with located("orientation"):
        rotation = _rotation(request.orientation, unit)
    failed = failed_properties(rotation, request.tolerance)
    if failed:
        return RotationsAnswer(
            angle_unit=request.angle_unit,
            is_rotation=False,
            failed=list(failed),
            matrix=_rows(rotation),
            quaternion=None,
            axis=None,
            angle=None,
            sequences=[],
        )
    pose = as_transform(rotation)
    axis, angle = axis_angle_from_transform(pose)
    lock = max(request.tolerance, 1e-12)
    return RotationsAnswer(
        angle_unit=request.angle_unit,
        is_rotation=True,
        failed=[],
        matrix=_rows(rotation),
        quaternion=list(quaternion_from_transform(pose)),
        axis=list(axis),
        angle=back(angle),
        sequences=[_sequence(rotation, sequence, lock, back) for sequence in SEQUENCES],
    )


def checked_rotation(request: CheckRotationRequest, say: Callable[[str], str]) -> CheckRotationAnswer:
    """Return whether an answer means the expected orientation.

    Raises:
        PoseError: no notation or more than one, one without a meaning, or the expected one is no rotation.
    """
    unit, _ = _units(request.angle_unit)
    with located("expected"):
        expected = _rotation(request.expected, unit)
        failed = failed_properties(expected, request.tolerance)
        if failed:
            params = {"property": failed[0].value}
            raise PoseError(Fault.at("expected_not_rotation", "matrix", **params))
        built = _built(request.expected, unit)
    with located("answer"):
        found = _judged(expected, request, built, unit)
    return CheckRotationAnswer(
        correct=found.right,
        score=found.share,
        mistakes=[
            RotationMistakeModel(code=mistake, message=say(f"feedback-rotation_{mistake.value}"))
            for mistake in found.mistakes
        ],
    )


def _judged(
    expected: Matrix3, request: CheckRotationRequest, built: Built | None, unit: Callable[[float], float]
) -> OrientationVerdict:
    answer, tolerance = request.answer, request.tolerance
    name = _one_of(answer, ANSWERS)
    if name == "matrix":
        return judge_matrix(expected, matrix3(answer.matrix or ()), tolerance, built)
    if name == "quaternion":
        return judge_quaternion(expected, answer.quaternion or (), answer.component_order, tolerance, built)
    if name == "axis":
        return judge_axis_angle(expected, answer.axis or (), unit(_angle(answer)), tolerance, built)
    sequence = _sequence_of(answer)
    if name == "family":
        assert answer.family is not None
        family = GimbalFamily(
            middle=unit(answer.family.middle),
            combination=answer.family.combination,
            value=unit(answer.family.value),
        )
        return judge_family(expected, sequence, family, tolerance)
    given = answer.triples if answer.triples is not None else [answer.angles or []]
    triples = [[unit(value) for value in triple] for triple in given]
    return judge_triples(expected, sequence, triples, every=request.every, tolerance=tolerance)


def _rotation(given: OrientationModel, unit: Callable[[float], float]) -> Matrix3:
    name = _one_of(given, NOTATIONS)
    if name == "matrix":
        return matrix3(given.matrix or ())
    if name == "quaternion":
        assert given.quaternion is not None
        w, x, y, z = given.quaternion
        if given.component_order.value == "xyzw":
            w, x, y, z = z, w, x, y
        return rotation_part(transform_from_quaternion((w, x, y, z)))
    if name == "axis":
        return rotation_part(transform_from_axis_angle(given.axis or (), unit(_angle(given))))
    return _sequence_of(given).matrix([unit(angle) for angle in given.angles or ()])


def _built(given: OrientationModel, unit: Callable[[float], float]) -> Built | None:
    if given.angles is None:
        return None
    first, middle, last = (unit(angle) for angle in given.angles)
    return Built(sequence=_sequence_of(given), angles=(first, middle, last))


def _angle(given: OrientationModel) -> float:
    if given.angle is None:
        raise PoseError(Fault.at("axis_and_angle", "angle"))
    return given.angle


def _sequence_of(given: OrientationModel) -> EulerSequence:
    return EulerSequence(axes=given.axes, turning=given.turning)


def _one_of(given: OrientationModel | OrientationAnswerModel, names: tuple[str, ...]) -> str:
    found = [name for name in names if getattr(given, name) is not None]
    if len(found) != 1:
        raise PoseError(Fault.at("one_notation", known=names))
    return found[0]


def _units(unit: AngleUnit) -> tuple[Callable[[float], float], Callable[[float], float]]:
    """Return what takes an angle to [rad], and back."""
    if unit is AngleUnit.DEG:
        return math.radians, math.degrees
    return float, float


def _sequence(
    rotation: Matrix3, sequence: EulerSequence, lock: float, back: Callable[[float], float]
) -> SequenceAngles:
    found = euler_solutions(rotation, sequence, lock)
    family = found.family
    return SequenceAngles(
        axes=sequence.axes,
        turning=sequence.turning,
        triples=[[back(angle) for angle in triple] for triple in found.triples],
        family=None
        if family is None
        else FamilyModel(
            middle=back(family.middle), combination=family.combination, value=back(family.value)
        ),
    )


def _rows(rotation: Matrix3) -> list[list[float]]:
    return [list(row) for row in rotation]
