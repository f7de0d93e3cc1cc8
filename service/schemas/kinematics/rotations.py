"""POST /rotations and POST /check-rotation on the wire."""

from __future__ import annotations

from typing import Annotated, TypeAlias

from pydantic import AfterValidator, Field
from pydantic_core import PydanticCustomError

from kinematics.cells import AngleUnit
from kinematics.errors import PoseError
from kinematics.rotations.orientation_answers import USUAL_TOLERANCE, ComponentOrder, RotationMistake
from kinematics.rotations.properties import RotationProperty
from kinematics.rotations.sequences import Combination, EulerSequence, Turning
from service.schemas.base import OneOf, Real, Vector3, Wire
from service.schemas.choices import forbidding, not_one_of, together

Matrix3Rows = Annotated[list[Vector3], Field(min_length=3, max_length=3)]
Quaternion4 = Annotated[list[Real], Field(min_length=4, max_length=4)]


def _known(axes: str) -> str:
    try:
        return EulerSequence(axes=axes).axes
    except PoseError as error:
        fault = error.faults[0]
        raise PydanticCustomError(fault.code, "not a sequence of axes", dict(fault.params)) from None


EulerAxes: TypeAlias = Annotated[
    str,
    Field(
        description="three of X, Y, Z in the order of the angles; neighbours differ",
        json_schema_extra={"pattern": "^(XY[XZ]|XZ[XY]|YX[YZ]|YZ[XY]|ZX[YZ]|ZY[XZ])$"},
    ),
    AfterValidator(_known),
]
"""The axes of three angles."""


class RatesOfAngles(Wire):
    """The angles of an analytic Jacobian."""

    axes: EulerAxes
    turning: OneOf[Turning] = Field(
        Turning.CURRENT, description="the angles turn about current or about fixed axes"
    )

    def sequence(self) -> EulerSequence:
        """Return the sequence that they name.

        Raises:
            PoseError: it is none, at ("axes",).
        """
        return EulerSequence(axes=self.axes, turning=self.turning)


NOTATIONS = ("matrix", "quaternion", "axis", "angles")
HALF_AN_AXIS = (together("axis", without=["angle"]), together("angle", without=["axis"]))


class OrientationModel(Wire):
    """An orientation in one notation: a matrix, a quaternion, an axis with an angle, or three angles."""

    model_config = forbidding(*not_one_of(*NOTATIONS), *HALF_AN_AXIS)

    matrix: Matrix3Rows | None = Field(None, description="3×3, row by row")
    quaternion: Quaternion4 | None = Field(None, description="of any length but zero")
    component_order: OneOf[ComponentOrder] = Field(
        ComponentOrder.SCALAR_FIRST, description="where the scalar of the quaternion stands"
    )
    axis: Vector3 | None = Field(None, description="beside an angle; of any length but zero")
    angle: Real | None = Field(None, description="about the axis")
    angles: Vector3 | None = Field(None, description="about the axes, in their order")
    axes: EulerAxes = Field("ZYX", description="of the angles; neighbours differ")
    turning: OneOf[Turning] = Field(
        Turning.CURRENT, description="the angles turn about current or about fixed axes"
    )


class RotationsRequest(Wire):
    """An orientation that is wanted in all notations."""

    orientation: OrientationModel = Field(description="in one notation")
    angle_unit: OneOf[AngleUnit] = Field(AngleUnit.RAD, description="unit of all angles")
    tolerance: Annotated[Real, Field(gt=0, le=0.1)] = Field(
        1e-6, description="how far a matrix may be from a rotation"
    )


class FamilyModel(Wire):
    """All triples of a locked orientation: a middle angle, and what is fixed of the other two."""

    middle: Real
    combination: OneOf[Combination] = Field(description="first + last, or first − last")
    value: Real = Field(description="of it")


class SequenceAngles(Wire):
    """An orientation in the angles of one sequence."""

    axes: str
    turning: Turning
    triples: list[Vector3] = Field(description="both triples; of a locked orientation one of the family")
    family: FamilyModel | None = Field(description="at gimbal lock")


class RotationsAnswer(Wire):
    """One orientation in every notation."""

    angle_unit: AngleUnit
    is_rotation: bool
    failed: list[RotationProperty] = Field(description="the properties of rotations that the matrix lacks")
    matrix: Matrix3Rows
    quaternion: Quaternion4 | None = Field(description="w, x, y, z; the negative of it is the same")
    axis: Vector3 | None
    angle: Real | None = Field(description="0 to half a turn")
    sequences: list[SequenceAngles] = Field(description="all 24; empty if the matrix is no rotation")


class OrientationAnswerModel(OrientationModel):
    """An answer: the orientation in one notation, or several triples, or the family of a locked one."""

    model_config = forbidding(*not_one_of(*NOTATIONS, "triples", "family"), *HALF_AN_AXIS)

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
    tolerance: Annotated[Real, Field(gt=0, le=0.1)] = Field(
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
