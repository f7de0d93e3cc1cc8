"""A question about a robot at given joint values: all JSON, or joints as npy and the rest in the query."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray
from pydantic import TypeAdapter, ValidationError
from starlette.responses import Response

from kinematics.errors import Fault
from service.http.decoding import decode_json
from service.http.npy import read_npy
from service.http.problems import BodyError, RequestError, RequestPart
from service.http.routing import NPY, ApiRequest, BytesResponse
from service.http.validation import faults_of, validated
from service.schemas.kinematics.robot_question import Configurations, RobotQuestion
from service.wire.kinematics.joint_values import PIECE, plain_configuration, read_array, read_joints
from service.wire.kinematics.prepared_robots import PreparedRobot, RobotCache
from service.work.batches import BatchResponse
from service.work.limiters import WorkKind

_SMALL = 64  # Configurations that the event loop reads itself; more are read by a thread.
_PLAIN = {"table", "robot", "parameters", "joints"}


_CONFIGURATIONS: TypeAdapter[Configurations] = TypeAdapter(Configurations)

Question = TypeVar("Question", bound=RobotQuestion)


@dataclass(frozen=True, kw_only=True, slots=True)
class ReadQuestion(Generic[Question]):
    """A validated question.

    Attributes:
        wire: what was asked, apart from the joints; None of a plain request, which says nothing else.
        joints: q_1 … q_n, or (m, n) of them, in [rad] and in the table's length unit.
    """

    wire: Question | None
    robot: PreparedRobot
    joints: list[float] | NDArray[np.float64]


class QuestionReader(Generic[Question]):
    """Reads the questions of one call."""

    def __init__(self, question: type[Question], request: type[Question]) -> None:
        self._question, self._request = question, request

    async def read(self, request: ApiRequest) -> ReadQuestion[Question]:
        """Return the question of a request, in either form.

        Raises:
            ServiceError: the request cannot be read, or is not of the call's shape.
            KinematicsError: what it says cannot be meant.
        """
        request.expect_batch()
        robots = request.resources.robots
        if request.brings_npy:
            return await self._from_npy(request, robots)
        body = await request.json(NPY)
        known = _recalled(body, robots)
        if known is not None:
            return known
        return await request.in_turn(partial(self._from_json, body, request, robots))

    def _from_json(self, body: Any, request: ApiRequest, robots: RobotCache) -> ReadQuestion[Question]:
        given = body.get("joints") if type(body) is dict else None
        if type(given) is list and len(given) > PIECE and type(given[0]) is list:
            wire = validated(self._request, {**body, "joints": given[:PIECE]})
            for start in range(PIECE, len(given), PIECE):
                _validate_configurations(given[start : start + PIECE], start)
        else:
            wire = validated(self._request, body)
            given = vars(wire)["joints"]
        robot = robots.prepare(wire, body)
        joints = read_joints(given, robot, request.settings.batch_limit)
        return ReadQuestion(wire=wire, robot=robot, joints=joints)

    async def _from_npy(self, request: ApiRequest, robots: RobotCache) -> ReadQuestion[Question]:
        request.media_type()
        body = _in_query(request)
        wire = validated(self._question, body)
        robot = robots.prepare(wire, body)
        joints = read_array(read_npy(await request.body()), robot, request.settings.batch_limit)
        return ReadQuestion(wire=wire, robot=robot, joints=joints)


def _validate_configurations(some: list[Any], start: int) -> None:
    """Make sure that a part of a batch, from an index on, is lists of numbers.

    Raises:
        RequestError: it is not; the first wrong value at its place in the batch.
    """
    try:
        _CONFIGURATIONS.validate_python(some)
    except ValidationError as error:
        found = error.errors(include_url=False, include_input=False)
        for each in found:
            first, *rest = each["loc"]
            each["loc"] = ("joints", start + int(first), *rest)
        raise RequestError(faults_of(found)) from None


def _recalled(body: Any, robots: RobotCache) -> ReadQuestion[Any] | None:
    """The question of a plain body about a robot that was prepared before: nothing is left to validate."""
    if type(body) is not dict or not _PLAIN.issuperset(body):
        return None
    robot = robots.recall(body)
    joints = None if robot is None else plain_configuration(body.get("joints"), robot)
    return None if robot is None or joints is None else ReadQuestion(wire=None, robot=robot, joints=joints)


def _in_query(request: ApiRequest) -> Mapping[str, Any]:
    given = request.query_params
    if set(given) == {"robot"}:
        return {"robot": given["robot"]}
    if set(given) != {"request"}:
        raise RequestError(Fault.at("query_missing", "request"), part=RequestPart.QUERY)
    try:
        body: Mapping[str, Any] = decode_json(given["request"].encode())
    except BodyError as error:
        raise BodyError(error.faults, part=RequestPart.QUERY) from None
    return body


async def batch_response(
    question: ReadQuestion[Any],
    request: ApiRequest,
    media_type: str,
    *,
    blocks: Callable[[], Iterator[bytes | memoryview]],
    check: Callable[[], None],
    length: int | None = None,
) -> Response:
    """Return the answer to a batch.

    A small one at once, a large one in a thread and sent while it is computed.

    The check, made before anything is sent, ensures that the answer exists.
    """
    if len(question.joints) <= _SMALL:
        check()
        return BytesResponse(b"".join(blocks()), media_type)
    slot = await request.resources.limiters[WorkKind.BATCH].acquire()
    try:
        await slot.run(check)
    except BaseException:
        slot.release()
        raise
    headers = None if length is None else {"Content-Length": str(length)}
    return BatchResponse(blocks(), slot, media_type, headers)
