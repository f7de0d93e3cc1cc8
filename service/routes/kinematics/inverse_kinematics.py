"""Poses to joint values."""

from functools import partial

from service.http.calls import CallRouter
from service.http.routing import ApiRequest, BytesResponse
from service.schemas.kinematics.inverse_forms import (
    InverseQuestion,
    SymbolicInverseAnswer,
    SymbolicInverseRequest,
)
from service.schemas.kinematics.inverse_kinematics import InverseKinematicsAnswer, InverseKinematicsAnswers
from service.wire.fault_pointers import traced
from service.wire.kinematics.inverse_forms import inverse_form_task, written_inverse
from service.wire.kinematics.inverse_solutions import solved, solved_each
from service.wire.kinematics.symbolic_tasks import answered

router = CallRouter("kinematics")


@router.call(
    "/inverse-kinematics",
    "A pose to the joint values that reach it",
    answer=InverseKinematicsAnswer | InverseKinematicsAnswers | SymbolicInverseAnswer,
    exclude_none=True,
)
async def inverse_kinematics(
    body: InverseQuestion, request: ApiRequest
) -> InverseKinematicsAnswer | BytesResponse:
    """Return all distinct solutions if the arm has a closed form, and otherwise those that a search finds.

    There are closed forms for most arms of five and six revolute joints with a wrist or parallel axes, for
    arms of up to four joints of any kind, and for up to three joints of any kind before a wrist. Other arms,
    of up to twelve joints, are searched from many starts. Residuals are computed by forward kinematics.
    Unreachable and singular poses are results, not errors. Several `targets` get `answers`, one for each;
    those that one request has no time for are `unanswered`, and listed in `faults`.

    With `"form": "symbolic"` and no target, the answer is the inverse kinematics in symbols, as in textbooks:
    one joint after another by atan2, with branch signs and conditions, and as source code. It is
    known for arms whose axes are at right angles: planar arms, SCARA, cylindrical arms, arms with a spherical
    wrist such as the PUMA and the Stanford arm, SCORBOT and Universal Robots.
    """
    resources = request.resources
    if isinstance(body, SymbolicInverseRequest):
        task = await request.in_turn(partial(inverse_form_task, body, request.settings))
        with traced(body):
            return await answered(request, task, b"inverse" + await request.body(), written_inverse)
    robot = await request.in_turn(partial(resources.robots.prepare, body))
    if body.targets is not None:
        return await solved_each(body, robot, request)
    return await solved(body, robot, resources.workers)
