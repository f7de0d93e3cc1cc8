"""POST /assign-frames and POST /check-frames: from joint axes to frames and a DH table."""

from collections.abc import Mapping
from typing import Any

from pydantic import Field

from kinematics.frames.assigned_frames import Freedom, Rule
from kinematics.frames.assignment import assign_frames
from kinematics.frames.axes import Gripper
from kinematics.frames.candidates import CandidateKind
from kinematics.frames.chosen_frames import ChosenFrame
from kinematics.frames.directions import CrossProduct, LengthSigns
from kinematics.frames.parallels import MAX_PARALLEL_TOLERANCE, PARALLEL_TOLERANCE, NearParallel
from kinematics.frames.rules import FrameFinding, FramePart, RuleCode, Severity
from kinematics.frames.trainer import check_frames
from kinematics.se3 import Transform
from kinematics.table import JointType
from service.http.calls import CallRouter
from service.messages import sentence
from service.schemas.base import LONGEST_LIST, Coordinates, Matrix4, OneOf, Real, Vector3, Wire
from service.schemas.kinematics.joint_axes import AxesQuestion, GripperTool
from service.schemas.tables import AnsweredTable, Units, units_of
from service.wire.kinematics.pose_matrices import pose_matrix
from service.wire.kinematics.written_tables import TableWriter

router = CallRouter("kinematics")


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


@router.call("/assign-frames", "Joint axes in, a DH table out")
def assign(body: AssignFramesRequest, language: str) -> AssignFramesAnswer:
    """Assign frames by the procedure of the lecture documents, each with its rule and its free choices.

    Free choices make as many parameters as possible vanish: d = 0 along parallel runs, frame 0 on frame 1 at
    zero, the last x along the previous one. base · table · tool reproduces every axis and the tool.
    """
    result = assign_frames(
        [axis.axis() for axis in body.axes],
        body.convention,
        **_ends(body),
        parallel_tolerance=body.parallel_tolerance,
        near_parallel=body.near_parallel,
        lengths=body.lengths,
        intersecting=body.intersecting,
    )
    return AssignFramesAnswer(
        **units_of(body),
        table=AnsweredTable.model_validate(TableWriter(units=body).table(result.table)),
        base=result.base.tolist(),
        tool=result.tool.tolist(),
        frames=[Frame.from_record(frame) for frame in result.frames],
        warnings=[
            Remark(code=warning.code, message=_said(f"error-{warning.code}", warning.params, language))
            for warning in result.warnings
        ],
    )


@router.call("/check-frames", "A student's frames, judged rule by rule")
def check(body: CheckFramesRequest, language: str) -> CheckFramesAnswer:
    """Return the rules that the chosen frames break, the choices there are, and the rows that follow."""
    judged = check_frames(
        [axis.axis() for axis in body.axes],
        body.convention,
        [None if chosen is None else chosen.frame() for chosen in body.frames],
        **_ends(body),
    )
    writer = TableWriter(units=body)
    rows = [row and writer.row(row, i) for i, row in enumerate(judged.rows, 1)]
    return CheckFramesAnswer(
        **units_of(body),
        frames=[
            JudgedFrameModel.from_record(
                frame, findings=[_broken(finding, language) for finding in frame.findings]
            )
            for frame in judged.frames
        ],
        rows=[FoundRow.model_validate(row, strict=False) if row else None for row in rows],
        table=AnsweredTable.model_validate(writer.table(judged.table)) if judged.table else None,
        base=_matrix(judged.base),
        tool=_matrix(judged.tool),
    )


def _ends(body: AxesQuestion) -> dict[str, Any]:
    """Base and tool as the domain takes them."""
    angle = body.angle_unit.radians
    base, tool = body.base, body.tool
    held = tool.gripper() if isinstance(tool, GripperTool) else tool
    return {
        "base": base if base is None else pose_matrix(base, angle, "base"),
        "tool": held if held is None or isinstance(held, Gripper) else pose_matrix(held, angle, "tool"),
    }


def _matrix(transform: Transform | None) -> list[list[float]] | None:
    return None if transform is None else transform.tolist()


def _broken(finding: FrameFinding, language: str) -> Broken:
    return Broken.from_record(finding, message=_said(f"rule-{finding.rule.value}", finding.params, language))


def _said(message: str, params: Mapping[str, object], language: str) -> str:
    return sentence(language, message, params) or message
