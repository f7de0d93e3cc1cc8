"""POST /scm/forward-kinematics, /scm/inverse-transform and /scm/jacobian: the SCM toolbox."""

from enum import StrEnum
from functools import partial
from typing import Annotated, Any, TypeAlias

from pydantic import Field

from kinematics.jacobian import JacobianFrame
from kinematics.printing import Format, Notation
from kinematics.scm import (
    ScmKinematics,
    forward_kinematics_scm,
    jacobian_by_inspection,
    jacobian_numbers_by_differentiation,
    unit_vectors,
)
from kinematics.se3 import inverse_transform
from service.http.calls import CallRouter
from service.http.routing import ApiRequest, BytesResponse, OneRobotRoute
from service.schemas.base import LONGEST_LIST, Matrix4, OneOf, Real, Vector3
from service.schemas.kinematics.orientations import Orientation
from service.schemas.kinematics.scm import ChainQuestion, ScmJoints
from service.schemas.tables import Units, units_of
from service.wire.json_chunks import plain_lists
from service.wire.kinematics.chain_forms import ChainTask, Wanted, is_quick, written_chain
from service.wire.kinematics.joint_values import values_in_radians
from service.wire.kinematics.pose_answers import orientation_of
from service.wire.kinematics.prepared_chains import PreparedChain, prepared_chain, written_structure
from service.work.workers import Lane

router = CallRouter("scm", route_class=OneRobotRoute)


class JacobianMethod(StrEnum):
    """How a Jacobian is formed: by columns (eq. 3.22, 3.23), or from the derivative of the matrix (3.24)."""

    INSPECTION = "inspection"
    DIFFERENTIATION = "differentiation"


class ClosedFormQuestion(ChainQuestion):
    """Base of the calls that answer in numbers where joints are given, in closed form where not.

    In closed form parameters without a value stay symbols.
    """

    joints: ScmJoints | None = Field(None, description="q_1 … q_n; left out, the answer is in closed form")
    formats: list[OneOf[Format]] | None = Field(
        None,
        max_length=LONGEST_LIST,
        min_length=1,
        description="of the closed form; text and latex if left out",
    )
    notation: OneOf[Notation] = Field(
        Notation.SHORT, description="of the closed form: short writes c23 (SCZIP), full cos(q2 + q3)"
    )


class ScmForwardKinematicsRequest(ClosedFormQuestion):
    """A chain, and joint values."""


class ScmInverseTransformRequest(ClosedFormQuestion):
    """A chain, and joint values."""


class ScmJacobianRequest(ClosedFormQuestion):
    """A chain, and joint values."""

    method: OneOf[JacobianMethod] = Field(
        JacobianMethod.INSPECTION,
        description="inspection (eq. 3.22, 3.23) or differentiation (eq. 3.24, H2J)",
    )


Forms: TypeAlias = Annotated[dict[str, Any], Field(description="one entry for each format, as in /symbolic")]


class ScmForwardKinematicsAnswer(Units):
    """Poses of a chain: in numbers, or in closed form where no joints were given."""

    variables: list[str] | None = Field(None, description="the joint variables of a closed form")
    transform: Matrix4 | Forms = Field(description="⁰H_FT: pose of the tool in frame 0")
    links: list[Forms] | list[Matrix4] = Field(description="H_i: pose of frame i in frame i-1, one a joint")
    frames: list[Forms] | list[Matrix4] = Field(description="pose of frame i in frame 0, one a joint")
    end: Matrix4 | Forms = Field(description="Final Transformation · tool, in the last joint's frame")
    orientation: Orientation | None = None
    symbols: dict[str, str] | None = Field(None, description="what the short names of a closed form mean")


class ScmInverseTransformAnswer(Units):
    """The inverse of direct kinematics."""

    variables: list[str] | None = Field(None, description="the joint variables of a closed form")
    transform: Matrix4 | Forms = Field(description="pose of frame 0 in the tool")
    symbols: dict[str, str] | None = Field(None, description="what the short names of a closed form mean")


class ScmJacobianAnswer(Units):
    """J0 and Jn: velocity of the tool above, its angular velocity below."""

    joint_unit: str = Field(
        "rad", description="per radian of a revolute joint, whatever the chain's angle unit"
    )
    method: JacobianMethod
    variables: list[str] | None = Field(None, description="the joint variables of a closed form")
    J0: list[list[Real]] | Forms = Field(description="6×n, in the axes of frame 0")
    Jn: list[list[Real]] | Forms = Field(description="6×n, in the axes of the tool")
    unit_vectors: list[Vector3] | None = Field(
        None,
        description="in numbers: u_1 … u_n (eq. 3.20, 3.21), along or about which joint i moves, each in the "
        "frame of its own row",
    )
    symbols: dict[str, str] | None = Field(None, description="what the short names of a closed form mean")


@router.call("/scm/forward-kinematics", "Direct kinematics of an SCM chain", exclude_none=True)
async def forward_kinematics(
    body: ScmForwardKinematicsRequest, request: ApiRequest
) -> ScmForwardKinematicsAnswer | BytesResponse:
    """Return ⁰H_FT, every H_i and every frame: scm(manipulator, 0) of the toolbox.

    With `joints` in numbers, without them in closed form.
    """
    if body.joints is None:
        return await _closed(body, Wanted.FORWARD_KINEMATICS, request)
    prepared, motion = await _moved(body, body.joints, request)
    return ScmForwardKinematicsAnswer(
        **units_of(prepared.read),
        transform=plain_lists(motion.transform),
        links=plain_lists(motion.links),
        frames=plain_lists(motion.frames),
        end=plain_lists(motion.end),
        orientation=Orientation.model_validate(orientation_of(motion.transform, prepared.angle)),
    )


@router.call("/scm/inverse-transform", "Inverse of the direct kinematics of an SCM chain", exclude_none=True)
async def inverse_of_transform(
    body: ScmInverseTransformRequest, request: ApiRequest
) -> ScmInverseTransformAnswer | BytesResponse:
    """Return the pose of frame 0 in the tool: scm(manipulator, -1) of the toolbox.

    With `joints` in numbers, without them in closed form.
    """
    if body.joints is None:
        return await _closed(body, Wanted.INVERSE_TRANSFORM, request)
    prepared, motion = await _moved(body, body.joints, request)
    inverse = inverse_transform(motion.transform)
    return ScmInverseTransformAnswer(**units_of(prepared.read), transform=plain_lists(inverse))


@router.call("/scm/jacobian", "J0 and Jn of an SCM chain", exclude_none=True)
async def jacobian(body: ScmJacobianRequest, request: ApiRequest) -> ScmJacobianAnswer | BytesResponse:
    """Return J0 and Jn, by inspection (scm(manipulator, 1) and 2) or by differentiating the matrix (h2j).

    With `joints` in numbers, without them in closed form.
    """
    inspected = body.method is JacobianMethod.INSPECTION
    wanted = Wanted.INSPECTED_JACOBIANS if inspected else Wanted.DIFFERENTIATED_JACOBIANS
    if body.joints is None:
        return await _closed(body, wanted, request)
    prepared = await _prepared(body, request)
    joints = values_in_radians(body.joints, prepared.joint_units, "joints")
    jacobian_in = jacobian_by_inspection if inspected else jacobian_numbers_by_differentiation
    J0, Jn = (
        jacobian_in(prepared.chain, joints, prepared.values, frame)
        for frame in (JacobianFrame.BASE, JacobianFrame.END)
    )
    return ScmJacobianAnswer(
        **units_of(prepared.read),
        method=body.method,
        J0=plain_lists(J0),
        Jn=plain_lists(Jn),
        unit_vectors=plain_lists(unit_vectors(prepared.chain, prepared.values)),
    )


async def _closed(body: ClosedFormQuestion, wanted: Wanted, request: ApiRequest) -> BytesResponse:
    """The answer in closed form, from a worker process."""
    read = await request.in_turn(partial(written_structure, body, request.settings.cell_limits))
    task = ChainTask.of(read, wanted, body.formats, body.notation)
    lane = Lane.QUICK if is_quick(read.chain, wanted) else Lane.SLOW
    return BytesResponse(await request.resources.workers.run(lane, written_chain, task))


async def _prepared(body: ChainQuestion, request: ApiRequest) -> PreparedChain:
    return await request.in_turn(partial(prepared_chain, body, request.settings.cell_limits))


async def _moved(
    body: ClosedFormQuestion, joints: list[float], request: ApiRequest
) -> tuple[PreparedChain, ScmKinematics]:
    """The chain, and its forward kinematics in numbers."""
    prepared = await _prepared(body, request)
    q = values_in_radians(joints, prepared.joint_units, "joints")
    return prepared, forward_kinematics_scm(prepared.chain, q, prepared.values)
