"""POST /jacobian on the wire."""

from __future__ import annotations

from pydantic import Field

from kinematics.jacobian import JacobianFrame
from service.schemas.base import Matrix6, OneOf, Real, Wire
from service.schemas.kinematics.joints import Joints
from service.schemas.kinematics.pose_input import PoseInput
from service.schemas.kinematics.robot_question import NumericForm, RobotQuestion
from service.schemas.tables import Units


class JacobianQuestion(RobotQuestion):
    """What is asked of a robot, without the joint values."""

    base: PoseInput | None = Field(None, description="pose of frame 0 in the world; the identity if left out")
    tool: PoseInput | None = Field(None, description="pose of the tool in frame N; the identity if left out")
    frame: OneOf[JacobianFrame] | None = Field(
        None, description="base for J0 alone, end for Jn alone; both if left out"
    )
    form: NumericForm = Field("numeric", description="the word symbolic asks for closed forms instead")
    tolerance: Real = Field(
        1e-9, gt=0, lt=1, description="singular values below this fraction of the largest count as zero"
    )


class NumericJacobianRequest(JacobianQuestion):
    """A robot, and one configuration or a batch of them."""

    joints: Joints


class MobilityModel(Wire):
    """How well the tool can move."""

    singular_values: list[Real] | list[list[Real]] = Field(
        description="of the Jacobian with lengths divided by the arm's own, largest first"
    )
    rank: int | list[int] = Field(description="number of independent directions of motion")
    generic_rank: int = Field(description="the rank in almost every configuration of this arm")
    singular: bool | list[bool] = Field(description="whether the rank is below the generic one")
    condition: Real | list[Real | None] | None = Field(
        description="largest over smallest singular value that the arm has; null where it is infinite"
    )
    manipulability: Real | list[Real] = Field(
        description="Yoshikawa's √det(J Jᵀ) in the directions that the arm has; depends on the length unit"
    )


class JacobianAnswer(Units):
    """Jacobians. Of a batch, every part but the generic ranks has one more axis in front."""

    joint_unit: str = Field(
        "rad", description="the Jacobians are per radian of a revolute joint, whatever the table's angle unit"
    )
    J0: Matrix6 | list[Matrix6] | None = Field(None, description="(v, ω) in the axes of the world")
    Jn: Matrix6 | list[Matrix6] | None = Field(None, description="(v, ω) in the axes of the end frame")
    rank: int | list[int] = Field(description="of the whole motion: that of twist")
    singular: bool | list[bool] = Field(description="of the whole motion: that of twist")
    manipulability: Real | list[Real] = Field(description="of the whole motion: that of twist")
    twist: MobilityModel = Field(description="of the whole velocity (v, ω)")
    translation: MobilityModel = Field(description="of v alone")
    rotation: MobilityModel = Field(description="of ω alone")
    characteristic_length: Real = Field(description="what lengths were divided by")
