"""POST /jacobian: joint rates to the velocity of the tool."""

from collections.abc import Iterator
from dataclasses import fields
from typing import Any, Literal, TypeAlias

import numpy as np
import orjson
from fastapi import Response
from numpy.typing import NDArray
from pydantic import Field, RootModel

from kinematics.jacobian import RANK_TOLERANCE, Dexterity, JacobianFrame, Mobility, dexterity
from kinematics.jacobian import jacobian as jacobian_of
from service.http.openapi import NPY_QUERY, problems, request_body
from service.http.routing import JSON, NPY, ApiRequest, BytesResponse, DirectRoute, api_router
from service.schemas.base import Matrix6, OneOf, Real, Wire
from service.schemas.kinematics.orientations import RatesOfAngles
from service.schemas.kinematics.robot_question import Joints, NumericForm, PlacedRobotQuestion
from service.schemas.kinematics.written_matrices import (
    WritingAnswer,
    WritingQuestion,
    WrittenJacobians,
    WrittenMatrix,
)
from service.schemas.tables import Units
from service.settings import Settings
from service.wire.json_chunks import member_chunks, written
from service.wire.kinematics.exact_values import exact_question
from service.wire.kinematics.pose_matrices import base_and_tool
from service.wire.kinematics.robot_questions import QuestionReader, ReadQuestion, batch_response
from service.wire.kinematics.symbolic_forms import JACOBIANS, FormPart, SymbolicTask, written_jacobians
from service.wire.kinematics.symbolic_tasks import closed_form

router = api_router("kinematics", route_class=DirectRoute)


class JacobianQuestion(PlacedRobotQuestion):
    """What is asked of a robot, without the joint values."""

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


class SymbolicJacobianRequest(WritingQuestion):
    """A robot whose Jacobians are wanted in closed form: no joint values."""

    form: Literal["symbolic"] = Field(description="the word symbolic: closed forms, and no joint values")
    frame: OneOf[JacobianFrame] | None = Field(
        None, description="base for J0 alone, end for Jn alone; both if left out"
    )
    angles: RatesOfAngles | None = Field(
        None, description="whose rates `analytic` has, which is wanted as well; none if left out"
    )


class JacobianBody(RootModel[NumericJacobianRequest | SymbolicJacobianRequest]):
    """A question about Jacobians, in numbers or in closed form."""


class SymbolicJacobianAnswer(WritingAnswer, WrittenJacobians):
    """Jacobians in closed form."""

    analytic: WrittenMatrix | None = Field(
        None,
        description="rates of x, y, z and of `angles`, if these were named; null where the first and the "
        "last turn about one line in every configuration",
    )


class JacobianReply(RootModel[JacobianAnswer | SymbolicJacobianAnswer]):
    """Jacobians in numbers or in closed form."""


_READER = QuestionReader(JacobianQuestion, NumericJacobianRequest)
_BLOCK = 512
"""Configurations whose Jacobians are computed and written at a time: a batch stays flat in memory."""

Values: TypeAlias = list[float] | NDArray[np.float64]
_ARRAY = {"schema": {"type": "string", "format": "binary"}}


@router.post(
    "/jacobian",
    summary="Joint rates to the velocity of the tool",
    response_model=JacobianReply,
    responses=problems(406, 503),
    openapi_extra={**request_body(JacobianBody, x_npy=_ARRAY), **NPY_QUERY},
)
async def jacobian(request: ApiRequest) -> Response:
    """Return the geometric Jacobians J0 and Jn of one configuration or of a batch: (v, ω) = J(q) dq/dt.

    With them the rank, the manipulability, and whether the configuration is singular: of the whole motion, of
    the translation and of the rotation. Jacobians are per radian. A batch may come as `application/x-npy`, as
    in `/forward-kinematics`.

    With `"form": "symbolic"` and no joints the Jacobians come in closed form, as in `/symbolic`.
    """
    offer = request.accepts(JSON)
    if await _is_symbolic(request):
        return await closed_form(request, SymbolicJacobianRequest, _task, written_jacobians)
    asked = await _READER.read(request)
    answer = _Answer(asked)
    if not isinstance(asked.joints, np.ndarray):
        return BytesResponse(answer.one())
    return await batch_response(asked, request, offer, check=answer.prepare, blocks=answer.blocks)


async def _is_symbolic(request: ApiRequest) -> bool:
    """Whether a request says "form": "symbolic"."""
    if request.brings_npy:
        return False
    request.expect_batch()
    body = await request.json(NPY)
    return isinstance(body, dict) and body.get("form") == "symbolic"


def _task(question: SymbolicJacobianRequest, settings: Settings) -> SymbolicTask:
    return SymbolicTask(
        parts=(FormPart.JACOBIAN,),
        frames=(question.frame,) if question.frame else tuple(JacobianFrame),
        angles=None if question.angles is None else question.angles.sequence(),
        **exact_question(question, settings),
    )


class _Answer:
    """The answer to one question."""

    def __init__(self, asked: ReadQuestion[JacobianQuestion]) -> None:
        wire = asked.wire
        self._asked = asked
        base, tool = (None, None) if wire is None else base_and_tool(wire, asked.robot.angle)
        self._poses = {"base": base, "tool": tool}
        self._tolerance = wire.tolerance if wire else RANK_TOLERANCE
        self._frames = (wire.frame,) if wire and wire.frame else tuple(JacobianFrame)
        self._dexterity: dict[str, Any] = {}

    def one(self) -> bytes:
        """Return the answer at one configuration, as JSON."""
        self._measure(self._asked.joints)
        answer = {**self._head(), **self._dexterity}
        for frame in self._frames:
            answer[JACOBIANS[frame]] = self._jacobians(frame, self._asked.joints)
        return orjson.dumps(answer, option=orjson.OPT_SERIALIZE_NUMPY)

    def prepare(self) -> None:
        """Measure a batch, and make sure that its Jacobians exist.

        Raises:
            JointValueError: a result overflows.
        """
        self._measure(self._asked.joints)

    def blocks(self) -> Iterator[bytes]:
        """Yield the answer for a batch, in pieces."""
        yield b"{"
        yield from member_chunks({**self._head(), **self._dexterity})
        for frame in self._frames:
            yield f',"{JACOBIANS[frame]}":['.encode()
            for start in range(0, len(self._asked.joints), _BLOCK):
                block = self._jacobians(frame, self._asked.joints[start : start + _BLOCK])
                yield (b"," if start else b"") + written(block)[1:-1]
            yield b"]"
        yield b"}"

    def _head(self) -> dict[str, Any]:
        return {**self._asked.robot.units, "joint_unit": "rad"}

    def _jacobians(self, frame: JacobianFrame, joints: Values) -> NDArray[np.float64]:
        return jacobian_of(self._asked.robot.table, joints, frame, **self._poses)

    def _measure(self, joints: Values) -> None:
        measured = dexterity(self._asked.robot.table, joints, **self._poses, tolerance=self._tolerance)
        self._dexterity = _measures(measured)


def _measures(measured: Dexterity) -> dict[str, Any]:
    whole = _mobility(measured.twist)
    return {
        "rank": whole["rank"],
        "singular": whole["singular"],
        "manipulability": whole["manipulability"],
        "twist": whole,
        "translation": _mobility(measured.translation),
        "rotation": _mobility(measured.rotation),
        "characteristic_length": measured.length,
    }


def _mobility(mobility: Mobility) -> dict[str, Any]:
    """Each measure by its name: a plain number of one configuration, an array of a batch."""
    values = {field.name: np.asarray(getattr(mobility, field.name)) for field in fields(mobility)}
    return {name: value if value.ndim else value.item() for name, value in values.items()}
