"""POST /assign-frames and POST /check-frames on the wire."""

from __future__ import annotations

from typing import Annotated, Any, Literal, TypeAlias

from pydantic import Discriminator, Field, Tag

from kinematics.cells import AngleUnit, LengthUnit
from kinematics.frames.assignment import Freedom, Rule
from kinematics.frames.axes import Gripper, JointAxis
from kinematics.frames.candidates import CandidateKind
from kinematics.frames.directions import CrossProduct, LengthSigns
from kinematics.frames.parallels import MAX_PARALLEL_TOLERANCE, PARALLEL_TOLERANCE, NearParallel
from kinematics.frames.rules import FramePart, RuleCode, Severity
from kinematics.frames.trainer import ChosenFrame
from kinematics.table import Convention, JointType
from service.http.validation import CHOICE
from service.schemas.base import LONGEST_LIST, Coordinates, Matrix4, OneOf, Real, Vector3, Wire
from service.schemas.kinematics.pose_input import PoseInput
from service.schemas.tables import AnsweredTable, Units


class AxisModel(Wire):
    """The axis of one joint, with the robot at its zero position."""

    joint: Literal["revolute", "prismatic"]
    direction: Coordinates = Field(description="direction of the positive motion; any length but zero")
    point: Coordinates = Field(
        [0.0, 0.0, 0.0], description="a point of the axis; of a prismatic joint only the direction matters"
    )

    def axis(self) -> JointAxis:
        """Return the axis as the domain knows it."""
        return JointAxis(joint=JointType(self.joint), direction=self.direction, point=self.point)


class GripperTool(Wire):
    """A gripper, from which the end frame follows: z towards the object, y across the jaws."""

    point: Coordinates = Field(description="the middle between the jaws")
    approach: Coordinates = Field(description="direction towards the object")
    jaws: Coordinates = Field(description="direction in which the jaws slide")

    def gripper(self) -> Gripper:
        """Return the gripper as the domain knows it."""
        return Gripper(point=self.point, approach=self.approach, jaws=self.jaws)


GRIPPER, POSE = CHOICE + "gripper", CHOICE + "pose"


def _kind_of(tool: Any) -> str:
    if isinstance(tool, dict):
        return POSE if {"position", "quaternion"} & set(tool) else GRIPPER
    return GRIPPER if isinstance(tool, GripperTool) else POSE


Tool: TypeAlias = Annotated[
    Annotated[PoseInput, Tag(POSE)] | Annotated[GripperTool, Tag(GRIPPER)], Discriminator(_kind_of)
]


class AxesQuestion(Wire):
    """A robot by its joint axes, and the convention of the wanted table."""

    axes: list[AxisModel] = Field(min_length=1, max_length=64, description="the joint axes, base first")
    convention: OneOf[Convention]
    base: PoseInput | None = Field(
        None, description="a pose wanted as frame 0, in the coordinates of the axes"
    )
    tool: Tool | None = Field(None, description="the tool's pose at zero, or the gripper")
    angle_unit: OneOf[AngleUnit] = Field(
        AngleUnit.RAD, description="unit of the angles of the table, and of those of base and tool"
    )
    length_unit: OneOf[LengthUnit] = Field(LengthUnit.M, description="unit of all lengths")


class AssignFramesRequest(AxesQuestion):
    """Axes to which frames are to be assigned."""

    parallel_tolerance: Real = Field(
        PARALLEL_TOLERANCE,
        ge=1e-10,
        le=MAX_PARALLEL_TOLERANCE,
        description="tilt [rad] below which two axes are taken as parallel, with a warning",
    )
    near_parallel: OneOf[NearParallel] = Field(
        NearParallel.PARALLEL, description="what becomes of nearly parallel axes"
    )
    lengths: OneOf[LengthSigns] = Field(
        LengthSigns.POSITIVE,
        description="signed: x may point back along a common normal, and the length is negative, where that "
        "spares an offset of a joint, as makers write their tables",
    )
    intersecting: OneOf[CrossProduct] = Field(
        CrossProduct.FEWEST,
        description="where x points if axes z and z' intersect: forward along z × z', backward along z' × z, "
        "or where fewest joint angles are left",
    )


class Frame(Wire):
    """One frame at the zero position, in the coordinates of the axes."""

    origin: Vector3
    x: Vector3
    y: Vector3
    z: Vector3
    rule: Rule = Field(description="the rule by which it was placed")
    free: list[Freedom] = Field(description="what the rules left free there")


class Remark(Wire):
    """Something that a caller should know about a result."""

    code: str
    message: str


class AssignFramesAnswer(Units):
    """base · table · tool reproduces every axis and the tool."""

    table: AnsweredTable
    base: Matrix4 = Field(description="pose of frame 0 in the coordinates of the axes")
    tool: Matrix4 = Field(description="pose of the given tool in frame N; the identity if none was given")
    frames: list[Frame] = Field(description="frame 0 … N")
    warnings: list[Remark]


class Chosen(Wire):
    """A frame as far as it has been chosen; those of /assign-frames are taken as they are."""

    origin: Coordinates | None = None
    x: Coordinates | None = None
    y: Coordinates | None = Field(None, description="follows from z and x: left out, or z × x beside both")
    z: Coordinates | None = None
    rule: OneOf[Rule] | None = Field(
        None, description="as /assign-frames tells it; frames are judged without it"
    )
    free: list[OneOf[Freedom]] | None = Field(None, max_length=LONGEST_LIST, description="likewise")

    def frame(self) -> ChosenFrame:
        """Return the frame as the domain knows it."""
        return ChosenFrame(origin=self.origin, x=self.x, y=self.y, z=self.z)


class CheckFramesRequest(AxesQuestion):
    """Axes, and the frames that a student has attached to them."""

    frames: list[Chosen | None] = Field(
        max_length=65, description="frame 0 … N as far as chosen; null or left out where nothing is"
    )


class Broken(Wire):
    """A rule that a frame breaks, or a piece of advice."""

    rule: RuleCode
    part: FramePart
    severity: Severity
    params: dict[str, int]
    message: str = Field(description="the rule in the caller's language")


class Choice(Wire):
    """A point or a direction to choose."""

    kind: CandidateKind
    vector: Vector3
    params: dict[str, int]


class Choices(Wire):
    """What to choose the parts of a frame from."""

    z: list[Choice]
    origin: list[Choice]
    x: list[Choice]


class JudgedFrameModel(Wire):
    """What is to be said about one frame."""

    index: int
    complete: bool = Field(description="whether origin, x and z have been chosen")
    findings: list[Broken]
    candidates: Choices


class FoundRow(Wire):
    """A row that follows from two frames; its variable's cell holds the variable."""

    joint: JointType
    alpha: Real | str = Field(description="link twist, of the row's own link or of the one before")
    a: Real | str = Field(description="link length, likewise")
    d: Real | str = Field(description="link offset; of a prismatic joint its variable, with the offset")
    theta: Real | str = Field(description="joint angle; of a revolute joint its variable, with the offset")


class CheckFramesAnswer(Units):
    """A student's frames, judged by the rules of the convention."""

    frames: list[JudgedFrameModel] = Field(description="frame 0 … N")
    rows: list[FoundRow | None] = Field(
        description="row 1 … N; null while a frame beside it is missing or breaks a rule"
    )
    table: AnsweredTable | None = Field(description="the table, once every row is there")
    base: Matrix4 | None = None
    tool: Matrix4 | None = None
