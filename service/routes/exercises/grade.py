"""POST /grade: a table, or many, against a key that the caller keeps."""

from collections.abc import Iterator
from functools import partial
from itertools import chain
from types import GenericAlias
from typing import Any

from fastapi import Response
from pydantic import Field, RootModel, create_model

from exercises.grading import HelpLevel, Verdict, accept, grade
from kinematics.cells import Limits, ReadTable
from kinematics.errors import KinematicsError
from service.http.decoding import JsonLimits
from service.http.languages import language_of
from service.http.openapi import problems, request_body
from service.http.problem_documents import problem_of
from service.http.problems import ServiceError, located
from service.http.routing import JSON, ApiRequest, BytesResponse, DirectRoute, api_router
from service.http.validation import validated
from service.schemas.base import ProblemDocument, Wire
from service.schemas.exercises.verdicts import Help, PolicyModel, VerdictModel
from service.schemas.tables import Parameters, Table
from service.wire.exercises.ungraded import answer_refused
from service.wire.exercises.verdicts import encoded, record_body
from service.work.batches import BatchResponse

router = api_router("exercises", route_class=DirectRoute)

MOST_SUBMISSIONS = 1000  # Submissions in one request: a course's.


class KeyQuestion(Wire):
    """A key that the caller keeps, and how it is applied."""

    reference: Table = Field(description="the key")
    policy: PolicyModel = PolicyModel()
    parameters: Parameters = Field(
        default_factory=dict,
        description="values of the key's parameters, in the key's units, so that answers may hold numbers",
    )
    help: Help = HelpLevel.REPAIR


class GradeOneRequest(KeyQuestion):
    """A submission to be judged by a key that the caller keeps."""

    submission: Table = Field(description="the answer; it may be in other units and in the other convention")


class GradeManyRequest(KeyQuestion):
    """Many submissions to be judged by one key."""

    submissions: list[dict[str, Any]] = Field(
        min_length=1,
        max_length=MOST_SUBMISSIONS,
        description="tables; one that cannot be graded has a problem document in the place of its verdict",
    )


class GradeBody(RootModel[GradeOneRequest | GradeManyRequest]):
    """One submission or many, by one key."""


_EITHER: Any = VerdictModel | ProblemDocument
_VERDICTS: dict[str, Any] = {"verdicts": (GenericAlias(list, (_EITHER,)), ...)}
ManyVerdicts = create_model(
    "ManyVerdicts", __base__=Wire, __doc__="Verdicts in the order of the submissions.", **_VERDICTS
)

LONG_CELL = 48  # Characters of a cell that no book prints: sixteen terms at most.

NDJSON = "application/x-ndjson"

MANY_TABLES = JsonLimits(lists=4 * MOST_SUBMISSIONS)
"""Lists of as many tables as one request may hold: each has one, and a few stand beside them."""


@router.post(
    "/grade",
    summary="Judge a DH table by a key of your own",
    response_model=VerdictModel | ManyVerdicts,
    responses=problems(406, 503),
    openapi_extra=request_body(GradeBody),
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
    found = _verdicts(validated(GradeManyRequest, body), request.settings.cell_limits, language_of(request))
    blocks = (verdict + b"\n" for verdict in found) if form == NDJSON else _members(found)
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
    wire = validated(GradeOneRequest, await request.json())
    limits = request.settings.cell_limits
    policy = wire.policy.policy()

    def read() -> tuple[ReadTable, ReadTable, Verdict | None]:
        reference = wire.reference.read(limits, "reference")
        submission = wire.submission.read(limits, "submission")
        return reference, submission, accept(reference, submission, policy, wire.parameters)

    reference, submission, right = await request.in_turn(read, heavy=_has_long_cells(wire))
    if right is not None:
        return right
    work = partial(grade, reference, submission, policy, wire.parameters, wire.help)
    return await request.resources.grading.run(work)


def _verdicts(asked: GradeManyRequest, limits: Limits, language: str) -> Iterator[bytes]:
    """Yield each verdict as JSON; for a submission that cannot be graded, its problem document.

    Raises:
        KinematicsError: the key cannot be read.
    """
    reference = asked.reference.read(limits, "reference")
    policy = asked.policy.policy()
    for i, submitted in enumerate(asked.submissions):
        try:
            with located("submissions", i):
                submission = validated(Table, submitted).read(limits)
            verdict = grade(reference, submission, policy, asked.parameters, asked.help)
            yield encoded(record_body(verdict, language))
        except (KinematicsError, ServiceError) as error:
            yield encoded({**problem_of(error).document(language), "attempt_counted": False})


def _members(found: Iterator[bytes]) -> Iterator[bytes]:
    """Yield verdicts as the pieces of one JSON object."""
    lead = b'{"verdicts":['
    for verdict in found:
        yield lead + verdict
        lead = b","
    yield b"]}"
