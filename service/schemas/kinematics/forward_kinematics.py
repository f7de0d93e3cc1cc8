"""POST /forward-kinematics on the wire."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated, TypeAlias

from pydantic import Field

from service.schemas.base import LONGEST_LIST, WHOLE, Matrix4, OneOf, Real, Vector3, Wire
from service.schemas.kinematics.joints import Joints
from service.schemas.kinematics.pose_input import PoseInput
from service.schemas.kinematics.robot_question import RobotQuestion
from service.schemas.tables import Units


class PoseQuantity(StrEnum):
    """A part of the answer that may be asked for."""

    TRANSFORM = "transform"
    LINKS = "links"
    FRAMES = "frames"
    POSITION = "position"
    ORIENTATION = "orientation"
    INVERSE = "inverse"


STANDARD_PARTS = (
    PoseQuantity.TRANSFORM,
    PoseQuantity.LINKS,
    PoseQuantity.FRAMES,
    PoseQuantity.POSITION,
    PoseQuantity.ORIENTATION,
)


MOST_MAPPED = 64
"""Points of links in a request, as many as a table may have rows."""


class LinkPoint(Wire):
    """A point of a link."""

    frame: Annotated[int, Field(ge=1), WHOLE] = Field(
        description="number of the link's frame: its row, from 1"
    )
    at: Vector3 = Field(description="its coordinates in that frame")


class ForwardKinematicsQuestion(RobotQuestion):
    """What is asked of a robot, without the joint values."""

    base: PoseInput | None = Field(None, description="pose of frame 0 in the world; the identity if left out")
    tool: PoseInput | None = Field(None, description="pose of the tool in frame N; the identity if left out")
    inverse: bool = Field(False, description="whether the inverse of the transform is wanted as well")
    parts: list[OneOf[PoseQuantity]] | None = Field(
        None,
        max_length=LONGEST_LIST,
        min_length=1,
        description="the parts of the answer that are wanted; all but the inverse if left out",
    )

    points: list[LinkPoint] | None = Field(
        None, min_length=1, max_length=MOST_MAPPED, description="points of links whose places are wanted"
    )

    def wanted(self) -> tuple[PoseQuantity, ...]:
        """Return the parts of the answer, in the order of the enumeration."""
        if self.parts is None and not self.inverse:
            return STANDARD_PARTS
        chosen = set(self.parts if self.parts is not None else STANDARD_PARTS)
        if self.inverse:
            chosen.add(PoseQuantity.INVERSE)
        return tuple(part for part in PoseQuantity if part in chosen)


class ForwardKinematicsRequest(ForwardKinematicsQuestion):
    """A robot, and one configuration or a batch of them."""

    joints: Joints


class AxisAngleModel(Wire):
    """A rotation by an angle about a unit vector."""

    axis: Vector3 | list[Vector3] = Field(description="unit vector")
    angle: Real | list[Real] = Field(description="0 … π, in the answer's angle unit")


Quaternion: TypeAlias = Annotated[list[Real], Field(min_length=4, max_length=4)]
SixNumbers: TypeAlias = Annotated[list[Real], Field(min_length=6, max_length=6)]


class Orientation(Wire):
    """The orientation of the end frame, in four notations."""

    quaternion: Quaternion | list[Quaternion] = Field(description="unit quaternion [w, x, y, z], w ≥ 0")
    rpy: Vector3 | list[Vector3] = Field(
        description="[roll, pitch, yaw]: R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll)"
    )
    axis_angle: AxisAngleModel
    xyzabc: SixNumbers | list[SixNumbers] = Field(
        description="[X, Y, Z, A, B, C]: T = Trans(X, Y, Z) Rot_z(A) Rot_y(B) Rot_x(C)"
    )


class MappedPoint(Wire):
    """Where a point of link i is."""

    previous: Vector3 | list[Vector3] = Field(description="its coordinates in frame i-1")
    world: Vector3 | list[Vector3] = Field(description="its coordinates in the world, base included")


class ForwardKinematicsAnswer(Units):
    """Poses. Of a batch, every part has one more axis in front, the configuration."""

    transform: Matrix4 | list[Matrix4] | None = Field(None, description="⁰T_N, base and tool included")
    links: list[Matrix4] | list[list[Matrix4]] | None = Field(
        None, description="for each row the pose of frame i in frame i-1"
    )
    frames: list[Matrix4] | list[list[Matrix4]] | None = Field(
        None, description="for each row the pose of frame i in the world, base included"
    )
    position: Vector3 | list[Vector3] | None = Field(None, description="origin of the end frame")
    orientation: Orientation | None = None
    inverse: Matrix4 | list[Matrix4] | None = Field(None, description="the inverse of the transform")
    points: list[MappedPoint] | None = Field(None, description="the points that were asked for, in order")
