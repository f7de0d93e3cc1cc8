"""Many submissions judged by one key: verdicts one by one, in their order."""

from __future__ import annotations

from collections.abc import Iterator

from pydantic import TypeAdapter

from exercises.grading import grade
from kinematics.cells import Limits, read_table
from kinematics.errors import KinematicsError
from service.http.problems import ServiceError, located, problem_of
from service.http.validation import validated
from service.schemas.exercises.grading import GradeManyRequest
from service.schemas.tables import Table
from service.wire.exercises.verdicts import encoded, record_body

_TABLE: TypeAdapter[Table] = TypeAdapter(Table)


def verdicts(request: GradeManyRequest, limits: Limits, language: str) -> Iterator[bytes]:
    """Yield each verdict as JSON; for a submission that cannot be graded, its problem document.

    Raises:
        KinematicsError: the key cannot be read.
    """
    with located("reference"):
        reference = read_table(request.reference.raw(), limits)
    policy = request.policy.policy()
    for i, submitted in enumerate(request.submissions):
        try:
            with located("submissions", i):
                submission = read_table(validated(_TABLE, submitted).raw(), limits)
            verdict = grade(reference, submission, policy, request.parameters, request.help)
            yield encoded(record_body(verdict, language))
        except (KinematicsError, ServiceError) as error:
            yield encoded({**problem_of(error).document(language), "attempt_counted": False})


def lines(found: Iterator[bytes]) -> Iterator[bytes]:
    """Yield verdicts as NDJSON."""
    for verdict in found:
        yield verdict + b"\n"


def members(found: Iterator[bytes]) -> Iterator[bytes]:
    """Yield verdicts as the pieces of one JSON object."""
    lead = b'{"verdicts":['
    for verdict in found:
        yield lead + verdict
        lead = b","
    yield b"]}"
