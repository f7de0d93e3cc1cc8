"""POST /check-rotation: an orientation that somebody wrote, in whatever notation."""

from typing import Annotated, ClassVar

from pydantic import Field

from kinematics.cells import AngleUnit
from kinematics.errors import Fault, PoseError
from kinematics.rotations.matrices import Matrix3, matrix3
from kinematics.rotations.orientation_answers import (
    USUAL_TOLERANCE,
    judge_axis_angle,
    judge_family,
    judge_matrix,
    judge_quaternion,
    judge_triples,
)
from kinematics.rotations.orientation_verdicts import Built, OrientationVerdict, RotationMistake
from kinematics.rotations.properties import failed_properties
from kinematics.rotations.sequences import GimbalFamily
from kinematics.se3 import triple
from service.http.calls import CallRouter
from service.http.problems import located
from service.schemas.base import OneOf, Real, Share, Vector3, Wire
from service.schemas.choices import forbidding, not_one_of
from service.schemas.kinematics.orientations import HALF_AN_AXIS, NOTATIONS, FamilyModel, OrientationModel
from service.schemas.spoken import feedback_sentence

router = CallRouter("kinematics")


class OrientationAnswerModel(OrientationModel):
    """An answer: the orientation in one notation, or several triples, or the family of a locked one."""

    notations: ClassVar[tuple[str, ...]] = (*NOTATIONS, "triples", "family")
    model_config = forbidding(*not_one_of(*notations), *HALF_AN_AXIS)

    triples: Annotated[list[Vector3], Field(min_length=1, max_length=8)] | None = Field(
        None, description="several triples of angles, where all are asked"
    )
    family: FamilyModel | None = Field(None, description="where the orientation is locked")


class CheckRotationRequest(Wire):
    """An orientation, and what somebody answered."""

    expected: OrientationModel = Field(description="the orientation that is meant")
    answer: OrientationAnswerModel = Field(description="what is judged")
    every: bool = Field(False, description="all triples are asked, not one")
    angle_unit: OneOf[AngleUnit] = Field(AngleUnit.RAD, description="unit of all angles")
    tolerance: Share = Field(
        USUAL_TOLERANCE, description="largest error of an entry of a matrix, or of the rotation [rad]"
    )


class RotationMistakeModel(Wire):
    """What a wrong answer looks like."""

    code: RotationMistake
    message: str = Field(description="the sentence, in the caller's language")


class CheckRotationAnswer(Wire):
    """Whether an answer means the orientation."""

    correct: bool
    score: Real = Field(ge=0, le=1, description="the share of what is asked that is right")
    mistakes: list[RotationMistakeModel] = Field(description="the usual slips that explain a wrong answer")


@router.call("/check-rotation", "Does an answer mean this orientation?")
def check_rotation(body: CheckRotationRequest, language: str) -> CheckRotationAnswer:
    """Return whether an answer in any notation means the orientation, and what a wrong one looks like.

    q and −q are the same, as are (k, θ) and (−k, −θ), angles that differ by full turns, and both triples of
    angles. With `every`, all triples are asked: both, or the family at gimbal lock.
    """
    with located("expected"):
        expected = body.expected.rotation(body.angle_unit)
        failed = failed_properties(expected, body.tolerance)
        if failed:
            raise PoseError(Fault.at("expected_not_rotation", "matrix", property=failed[0].value))
        built = _built(body.expected, body.angle_unit)
    with located("answer"):
        found = _judged(expected, body, built)
    return CheckRotationAnswer(
        correct=found.right,
        score=found.share,
        mistakes=[
            RotationMistakeModel(
                code=mistake, message=feedback_sentence(f"rotation_{mistake.value}", language)
            )
            for mistake in found.mistakes
        ],
    )


def _judged(expected: Matrix3, body: CheckRotationRequest, built: Built | None) -> OrientationVerdict:
    answer, unit, tolerance = body.answer, body.angle_unit.in_radians, body.tolerance
    name = answer.notation()
    if name == "matrix":
        return judge_matrix(expected, matrix3(answer.matrix or ()), tolerance, built)
    if name == "quaternion":
        return judge_quaternion(expected, answer.quaternion or (), answer.component_order, tolerance, built)
    if name == "axis":
        return judge_axis_angle(expected, answer.axis or (), answer.turn(body.angle_unit), tolerance, built)
    sequence = answer.sequence()
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
    return judge_triples(expected, sequence, triples, every=body.every, tolerance=tolerance)


def _built(given: OrientationModel, unit: AngleUnit) -> Built | None:
    """How the expected orientation was made of angles, if it was."""
    if given.angles is None:
        return None
    return Built(sequence=given.sequence(), angles=triple(map(unit.in_radians, given.angles)))
