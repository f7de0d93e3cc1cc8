"""Joint rates to the velocity of the tool."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields
from typing import Any, TypeAlias

import numpy as np
import orjson
from fastapi import Response
from numpy.typing import NDArray

from kinematics.jacobian import RANK_TOLERANCE, Dexterity, JacobianFrame, Mobility, dexterity
from kinematics.jacobian import jacobian as jacobian_of
from service.http.openapi import NPY_QUERY, problems, request_body
from service.http.routing import JSON, ApiRequest, BytesResponse, DirectRoute, api_router
from service.schemas import examples
from service.schemas.kinematics.jacobian_request import JacobianQuestion, NumericJacobianRequest
from service.schemas.kinematics.symbolic_request import SYMBOLIC_JACOBIAN, JacobianBody, JacobianReply
from service.wire.json_chunks import member_chunks, written
from service.wire.kinematics.pose_matrices import base_and_tool
from service.wire.kinematics.robot_questions import QuestionReader, ReadQuestion, batch_response
from service.wire.kinematics.symbolic_tasks import symbolic_body, symbolic_jacobian

router = api_router("kinematics", route_class=DirectRoute)

_READER = QuestionReader(JacobianQuestion, NumericJacobianRequest)
_NAMES = {JacobianFrame.BASE: "J0", JacobianFrame.END: "Jn"}
_BLOCK = 512
"""Configurations whose Jacobians are computed and written at a time: a batch stays flat in memory."""

Values: TypeAlias = list[float] | NDArray[np.float64]
_ARRAY = {"schema": {"type": "string", "format": "binary"}}


@router.post(
    "/jacobian",
    summary="Joint rates to the velocity of the tool",
    response_model=JacobianReply,
    responses=problems(406, 503),
    openapi_extra={
        **request_body(JacobianBody, examples.JACOBIAN | SYMBOLIC_JACOBIAN, x_npy=_ARRAY),
        **NPY_QUERY,
    },
)
async def jacobian(request: ApiRequest) -> Response:
    """Return the geometric Jacobians J0 and Jn of one configuration or of a batch: (v, ω) = J(q) dq/dt.

    With them the rank, the manipulability, and whether the configuration is singular: of the whole motion, of
    the translation and of the rotation. Jacobians are per radian. A batch may come as `application/x-npy`, as
    in `/forward-kinematics`.

    With `"form": "symbolic"` and no joints the Jacobians come in closed form, as in `/symbolic`.
    """
    offer = request.accepts(JSON)
    wanted = await symbolic_body(request)
    if wanted is not None:
        return await symbolic_jacobian(request, wanted)
    asked = await _READER.read(request)
    answer = _Answer(asked)
    if not isinstance(asked.joints, np.ndarray):
        return BytesResponse(answer.one())
    return await batch_response(asked, request, offer, check=answer.prepare, blocks=answer.blocks)


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
            answer[_NAMES[frame]] = self._jacobians(frame, self._asked.joints)
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
            yield f',"{_NAMES[frame]}":['.encode()
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
