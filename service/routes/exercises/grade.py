"""A table against a key that the caller keeps."""

from __future__ import annotations

from functools import partial
from itertools import chain
from typing import Any

from fastapi import Response
from pydantic import TypeAdapter

from exercises.grading import Verdict, accept, grade
from kinematics.cells import ReadTable, read_table
from service.http.decoding import JsonLimits
from service.http.languages import language_of
from service.http.openapi import problems, request_body
from service.http.problems import located
from service.http.routing import JSON, ApiRequest, BytesResponse, DirectRoute, api_router
from service.http.validation import validated
from service.schemas.exercises import examples_grading as examples
from service.schemas.exercises.grading import (
    MOST_SUBMISSIONS,
    GradeBody,
    GradeManyRequest,
    GradeOneRequest,
    ManyVerdicts,
)
from service.schemas.exercises.verdicts import VerdictModel
from service.wire.exercises.many_grades import lines, members, verdicts
from service.wire.exercises.ungraded import answer_refused
from service.wire.exercises.verdicts import encoded, record_body
from service.work.batches import BatchResponse

router = api_router("exercises", route_class=DirectRoute)

LONG_CELL = 48
"""Characters of a cell that no book prints: sixteen terms at most."""

_REQUEST: TypeAdapter[GradeOneRequest] = TypeAdapter(GradeOneRequest)
_MANY: TypeAdapter[GradeManyRequest] = TypeAdapter(GradeManyRequest)
NDJSON = "application/x-ndjson"

MANY_TABLES = JsonLimits(lists=4 * MOST_SUBMISSIONS)
"""Lists of as many tables as one request may hold: each has one, and a few stand beside them."""


@router.post(
    "/grade",
    summary="Judge a DH table by a key of your own",
    response_model=VerdictModel | ManyVerdicts,
    responses=problems(406, 503),
    openapi_extra=request_body(GradeBody, examples.GRADE),
)
async def grade_table(request: ApiRequest) -> Response:
    """Return whether a submission describes the reference robot, whatever frames it was written in.

    A right answer comes with a certificate: joint signs, joint offsets and two constant motions with which
    both tables give the same pose for every configuration. A wrong one is explained as far as `help`
    allows. A request that cannot be graded costs no attempt.

    With `submissions` instead of `submission`, many tables are judged by one key: the verdicts come in their
    order, as one JSON object or, where `application/x-ndjson` is accepted, line by line as they are found.
    """
    request.json_limits = MANY_TABLES
    body = await request.json()
    if isinstance(body, dict) and "submissions" in body:
        return await _many(request, body)
    with answer_refused():
        verdict = await _verdict(request)
    request.resources.metrics.graded(correct=verdict.correct, score=verdict.score, kept=False)
    return BytesResponse(encoded(record_body(verdict, language_of(request))))


async def _many(request: ApiRequest, body: dict[str, Any]) -> Response:
    form = request.accepts(JSON, NDJSON)
    wire: GradeManyRequest = validated(_MANY, body)
    found = verdicts(wire, request.settings.cell_limits, language_of(request))
    blocks = lines(found) if form == NDJSON else members(found)
    slot = await request.resources.grading.acquire()
    try:
        first = await slot.run(lambda: next(blocks, b""))  # a key that cannot be read is refused as a whole
    except BaseException:
        slot.release()
        raise
    return BatchResponse(chain((first,), blocks), slot, form)


def _has_long_cells(wire: GradeOneRequest) -> bool:
    """Whether a cell has so many terms that a certificate in closed form takes long."""
    rows = (*wire.reference.rows, *wire.submission.rows)
    return any(
        isinstance(cell, str) and len(cell) > LONG_CELL
        for row in rows
        for cell in (row.alpha, row.a, row.d, row.theta)
    )


async def _verdict(request: ApiRequest) -> Verdict:
    wire: GradeOneRequest = validated(_REQUEST, await request.json())
    limits = request.settings.cell_limits
    policy = wire.policy.policy()

    def read() -> tuple[ReadTable, ReadTable, Verdict | None]:
        with located("reference"):
            reference = read_table(wire.reference.raw(), limits)
        with located("submission"):
            submission = read_table(wire.submission.raw(), limits)
        return reference, submission, accept(reference, submission, policy, wire.parameters)

    reference, submission, right = await request.in_turn(read, heavy=_has_long_cells(wire))
    if right is not None:
        return right
    work = partial(grade, reference, submission, policy, wire.parameters, wire.help)
    return await request.resources.grading.run(work)
