"""Orientations as callers write them: in one of four notations, and by sequences of angles."""

from typing import Annotated, ClassVar, TypeAlias

from pydantic import AfterValidator, Field
from pydantic_core import PydanticCustomError

from kinematics.cells import AngleUnit
from kinematics.errors import Fault, PoseError
from kinematics.poses import transform_from_axis_angle, transform_from_quaternion
from kinematics.rotations.matrices import Matrix3, matrix3, rotation_part
from kinematics.rotations.orientation_verdicts import ComponentOrder
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

    notations: ClassVar[tuple[str, ...]] = NOTATIONS
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

    def notation(self) -> str:
        """Return the name of the notation that it is given in.

        Raises:
            PoseError: it is given in none, or in more than one.
        """
        found = [name for name in self.notations if getattr(self, name) is not None]
        if len(found) != 1:
            raise PoseError(Fault.at("one_notation", known=self.notations))
        return found[0]

    def rotation(self, unit: AngleUnit) -> Matrix3:
        """Return the rotation that it means, which may be none if it is given as a matrix.

        Raises:
            PoseError: no notation or more than one, or one without a meaning.
        """
        name = self.notation()
        if name == "matrix":
            return matrix3(self.matrix or ())
        if name == "quaternion":
            assert self.quaternion is not None
            w, x, y, z = self.quaternion
            if self.component_order is ComponentOrder.SCALAR_LAST:
                w, x, y, z = z, w, x, y
            return rotation_part(transform_from_quaternion((w, x, y, z)))
        if name == "axis":
            return rotation_part(transform_from_axis_angle(self.axis or (), self.turn(unit)))
        return self.sequence().matrix([unit.in_radians(angle) for angle in self.angles or ()])

    def turn(self, unit: AngleUnit) -> float:
        """Return the angle about the axis [rad].

        Raises:
            PoseError: there is none.
        """
        if self.angle is None:
            raise PoseError(Fault.at("axis_and_angle", "angle"))
        return unit.in_radians(self.angle)

    def sequence(self) -> EulerSequence:
        """Return the sequence of its angles."""
        return EulerSequence(axes=self.axes, turning=self.turning)


class FamilyModel(Wire):
    """All triples of a locked orientation: a middle angle, and what is fixed of the other two."""

    middle: Real
    combination: OneOf[Combination] = Field(description="first + last, or first − last")
    value: Real = Field(description="of it")


class AxisAngleModel(Wire):
    """A rotation by an angle about a unit vector."""

    axis: Vector3 | list[Vector3] = Field(description="unit vector")
    angle: Real | list[Real] = Field(description="0 … π, in the answer's angle unit")


SixNumbers: TypeAlias = Annotated[list[Real], Field(min_length=6, max_length=6)]


class Orientation(Wire):
    """The orientation of the end frame, in four notations."""

    quaternion: Quaternion4 | list[Quaternion4] = Field(description="unit quaternion [w, x, y, z], w ≥ 0")
    rpy: Vector3 | list[Vector3] = Field(
        description="[roll, pitch, yaw]: R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll)"
    )
    axis_angle: AxisAngleModel
    xyzabc: SixNumbers | list[SixNumbers] = Field(
        description="[X, Y, Z, A, B, C]: T = Trans(X, Y, Z) Rot_z(A) Rot_y(B) Rot_x(C)"
    )
