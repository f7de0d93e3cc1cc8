"""A table against a key that the caller keeps."""

from __future__ import annotations

from functools import partial

from fastapi import Response
from pydantic import TypeAdapter

from exercises.grading import Verdict, accept, grade
from kinematics.cells import read_table
from service.http.languages import language_of
from service.http.openapi import problems, request_body
from service.http.problems import located
from service.http.routing import ApiRequest, BytesResponse, DirectRoute, api_router
from service.http.validation import validated
from service.resources import resources_of
from service.schemas import examples_grading as examples
from service.schemas.grading import GradeRequest
from service.schemas.verdicts import VerdictModel
from service.wire.ungraded import answer_refused
from service.wire.verdicts import encoded, verdict_body
from service.work.limiters import WorkKind

router = api_router("exercises", route_class=DirectRoute)

_REQUEST: TypeAdapter[GradeRequest] = TypeAdapter(GradeRequest)


@router.post(
    "/grade",
    summary="Judge a DH table by a key of your own",
    response_model=VerdictModel,
    responses=problems(503),
    openapi_extra=request_body(GradeRequest, examples.GRADE),
)
async def grade_table(request: ApiRequest) -> Response:
    """Whether a submission describes the reference robot, whatever frames it was written in.

    A right answer comes with a certificate: joint signs, joint offsets and two constant motions with which
    both tables give the same pose for every configuration. A wrong one is explained as far as `help`
    allows. A request that cannot be graded costs no attempt.
    """
    with answer_refused():
        verdict = await _verdict(request)
    return BytesResponse(encoded(verdict_body(verdict, language_of(request))))


async def _verdict(request: ApiRequest) -> Verdict:
    wire: GradeRequest = validated(_REQUEST, await request.json())
    limits = request.settings.cell_limits
    with located("reference"):
        reference = read_table(wire.reference.raw(), limits)
    with located("submission"):
        submission = read_table(wire.submission.raw(), limits)
    policy = wire.policy.policy()
    right = accept(reference, submission, policy, wire.parameters)
    if right is not None:
        return right
    work = partial(grade, reference, submission, policy, wire.parameters, wire.help)
    return await resources_of(request).limiters[WorkKind.GRADING].run(work)
