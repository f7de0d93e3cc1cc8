"""POST /rotations: an orientation in every notation."""

from pydantic import Field

from kinematics.cells import AngleUnit
from kinematics.poses import axis_angle_from_transform, quaternion_from_transform
from kinematics.rotations.matrices import Matrix3, as_transform
from kinematics.rotations.properties import RotationProperty, failed_properties
from kinematics.rotations.sequences import SEQUENCES, EulerSequence, Turning, euler_solutions
from service.http.calls import CallRouter
from service.http.problems import located
from service.schemas.base import OneOf, Real, Share, Vector3, Wire
from service.schemas.kinematics.orientations import FamilyModel, Matrix3Rows, OrientationModel, Quaternion4

router = CallRouter("kinematics")


class RotationsRequest(Wire):
    """An orientation that is wanted in all notations."""

    orientation: OrientationModel = Field(description="in one notation")
    angle_unit: OneOf[AngleUnit] = Field(AngleUnit.RAD, description="unit of all angles")
    tolerance: Share = Field(1e-6, description="how far a matrix may be from a rotation")


class SequenceAngles(Wire):
    """An orientation in the angles of one sequence."""

    axes: str
    turning: Turning
    triples: list[Vector3] = Field(
        description="both triples, first the one with its middle angle from 0 to π where the first axis is "
        "also the last, otherwise from −π/2 to π/2; of a locked orientation one of the family"
    )
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


@router.call("/rotations", "One orientation in every notation")
def rotations(body: RotationsRequest) -> RotationsAnswer:
    """Return the matrix, quaternion, axis and angle, and both solutions for the angles of all 24 sequences.

    At gimbal lock the whole family is given: the middle angle, and the sum or difference of the others that
    is fixed. For a matrix that is not a rotation, the answer lists the properties that fail.
    """
    unit = body.angle_unit
    with located("orientation"):
        rotation = body.orientation.rotation(unit)
    failed = failed_properties(rotation, body.tolerance)
    if failed:
        return RotationsAnswer(
            angle_unit=unit,
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
    lock = max(body.tolerance, 1e-12)
    return RotationsAnswer(
        angle_unit=unit,
        is_rotation=True,
        failed=[],
        matrix=_rows(rotation),
        quaternion=list(quaternion_from_transform(pose)),
        axis=list(axis),
        angle=unit.from_radians(angle),
        sequences=[_angles(rotation, sequence, lock, unit) for sequence in SEQUENCES],
    )


def _angles(rotation: Matrix3, sequence: EulerSequence, lock: float, unit: AngleUnit) -> SequenceAngles:
    found = euler_solutions(rotation, sequence, lock)
    family, back = found.family, unit.from_radians
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
