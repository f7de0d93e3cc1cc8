"""Judged submissions are stored, many in one transaction, and become attempts.

What arrives while a transaction is being written makes the next one: its cost (round trips, the flush of the
commit) is shared by all that wait. The counted score and the message to the gradebook change in the same
transaction. A submission that arrives again with its idempotency key is the attempt that it was.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import datetime, timedelta
from typing import Any, TypeAlias

import sqlalchemy as sa

from courses.attempts.report_codes import finding_rows, path_of_codes
from courses.attempts.stored_attempts import attempt_of, check_open, shown_now
from courses.grades.gradebook import GradeChange, store_changes
from courses.links.course_links import allowance_of
from courses.links.link_settings import stored
from courses.model import Attempt, CourseSession
from courses.policies import Counted, advanced
from courses.refusals import AttemptError, unknown_record
from courses.storage import records
from courses.storage.database import Store
from courses.storage.statements import of_student

_ATTEMPT, _PART, _GRADE = records.attempt, records.participation, records.grade
_OUTBOX, _LINK = records.score_to_send, records.link
Student: TypeAlias = tuple[int, int]  # A link and a person.


@dataclass(frozen=True, kw_only=True, slots=True)
class JudgedSubmission:
    """A submission that waits to be stored.

    Attributes:
        session: who hands it in, and for what.
        attempt: the submission with what its student may be told; it has no number yet.
        analysis: the report at the highest level of help; its codes feed the statistics.
    """

    session: CourseSession
    attempt: Attempt
    analysis: Mapping[str, Any]

    @property
    def student(self) -> Student:
        """Who hands it in."""
        return self.session.link.id, self.session.person.id


@dataclass(slots=True)
class _Standing:
    """How far a student is; changes with every submission of the batch."""

    session: CourseSession
    before: Counted | None
    grade: Counted | None
    is_queued: bool
    submitted: datetime | None = None


def store_submissions(
    store: Store, submissions: Sequence[JudgedSubmission], now: datetime
) -> list[Attempt | Exception]:
    """Store submissions in one transaction, in their order.

    Returns:
        For each its attempt with its number, or the one that was stored with its key before; or why the
        policy takes it no more.
    """
    students = sorted({submission.student for submission in submissions})
    with store.writing() as connection:
        _take_turns(connection, students)
        standings, repeated = _standings(connection, submissions, students)
        known = _known(connection, repeated)
        found: list[Attempt | Exception] = []
        analyses: dict[tuple[int, int, int], Mapping[str, Any]] = {}
        for submission in submissions:
            key = (*submission.student, submission.attempt.key)
            if key not in known:
                known[key] = result = _taken(submission, standings.get(submission.student), now)
                if isinstance(result, Attempt):
                    analyses[*submission.student, result.number] = submission.analysis
            found.append(known[key])
        stored = _insert(connection, [known[key] for key in known], analyses)
        _note(connection, standings, now)
    return [
        stored.get((each.link_id, each.person_id, each.number), each) if isinstance(each, Attempt) else each
        for each in found
    ]


_OF_STUDENTS = sa.tuple_(_PART.c.link_id, _PART.c.person_id).in_(sa.bindparam("students", expanding=True))
_TURNS = (
    sa.select(_PART.c.link_id)
    .where(_OF_STUDENTS)
    .order_by(_PART.c.link_id, _PART.c.person_id)
    .with_for_update()
)
_STANDING = (
    sa.select(
        _PART.c.link_id,
        _PART.c.person_id,
        _PART.c.made,
        _PART.c.extra_seconds,
        _PART.c.extra_attempts,
        _GRADE.c.score,
        _GRADE.c.number,
        _OUTBOX.c.revision,
        _LINK.c.exercise_id,
        _LINK.c.settings,
        _LINK.c.line_item,
        _LINK.c.line_items,
        _LINK.c.released_at,
        _ATTEMPT.c.id.label("known"),
    )
    .join(_LINK, _LINK.c.id == _PART.c.link_id)
    .outerjoin(_GRADE, of_student(_GRADE, _PART.c.link_id, _PART.c.person_id))
    .outerjoin(_OUTBOX, of_student(_OUTBOX, _PART.c.link_id, _PART.c.person_id))
    .outerjoin(
        _ATTEMPT,
        of_student(_ATTEMPT, _PART.c.link_id, _PART.c.person_id)
        & _ATTEMPT.c.key.in_(sa.bindparam("keys", expanding=True)),
    )
    .where(_OF_STUDENTS)
)
"""Written once: to write a statement takes longer than to carry it out."""


def _take_turns(connection: sa.Connection, students: Sequence[Student]) -> None:
    """Lock the students' rows, always in the same order: their submissions come one after another.

    On SQLite a transaction that writes is alone.
    """
    if connection.dialect.name == "postgresql":
        connection.execute(_TURNS, {"students": students})


def _standings(
    connection: sa.Connection, submissions: Sequence[JudgedSubmission], students: Sequence[Student]
) -> tuple[dict[Student, _Standing], set[int]]:
    """How far the students are, by the rules that their links have now; and attempts that come again."""
    keys = list({submission.attempt.key for submission in submissions})
    found_rows = connection.execute(_STANDING, {"students": students, "keys": keys}).all()
    rows = {(row.link_id, row.person_id): row for row in found_rows}
    repeated = {row.known for row in found_rows if row.known is not None}
    rules: dict[int, Any] = {}
    found: dict[Student, _Standing] = {}
    for submission in submissions:
        row, session = rows.get(submission.student), submission.session
        if row is None or submission.student in found:
            continue
        if row.link_id not in rules:
            rules[row.link_id] = stored(row.exercise_id, row.settings)
        policy = rules[row.link_id].policy
        attempts = session.link.settings.policy.attempts if policy.attempts is None else policy.attempts
        link = replace(
            session.link,
            settings=replace(rules[row.link_id], policy=replace(policy, attempts=attempts)),
            line_item=row.line_item,
            line_items=row.line_items,
            released_at=row.released_at,
        )
        grade = None if row.number is None else Counted(number=row.number, worth=row.score)
        found[submission.student] = _Standing(
            session=replace(session, link=link, made=row.made, allowance=allowance_of(row)),
            before=grade,
            grade=grade,
            is_queued=row.revision is not None,
        )
    return found, repeated


def _known(connection: sa.Connection, ids: set[int]) -> dict[tuple[int, int, str], Attempt | Exception]:
    """Attempts by their students and keys."""
    if not ids:
        return {}
    rows = connection.execute(sa.select(_ATTEMPT).where(_ATTEMPT.c.id.in_(ids)))
    return {(row.link_id, row.person_id, row.key): attempt_of(row) for row in rows}


def _taken(submission: JudgedSubmission, standing: _Standing | None, now: datetime) -> Attempt | Exception:
    """The attempt that a submission becomes, and what follows for its student's grade."""
    if standing is None:
        return unknown_record("participation")
    session = standing.session
    try:
        check_open(session, submission.attempt.at)
    except AttemptError as error:
        return error
    number = session.made + 1
    attempt = replace(submission.attempt, number=number, shown=shown_now(session, number, now).value)
    standing.session = replace(session, made=number)
    grade = advanced(session.link.settings.policy, standing.grade, attempt.outcome, session.allowance)
    if grade != standing.grade:
        standing.grade, standing.submitted = grade, attempt.at
    return attempt


def _insert(
    connection: sa.Connection,
    attempts: Iterable[Attempt | Exception],
    analyses: Mapping[tuple[int, int, int], Mapping[str, Any]],
) -> dict[tuple[int, int, int], Attempt]:
    """Insert the new attempts with their findings; return them with their ids."""
    new = [each for each in attempts if isinstance(each, Attempt) and not each.id]
    if not new:
        return {}
    rows = [{name: getattr(attempt, name) for name in _COLUMNS} for attempt in new]
    ids = {(row.link_id, row.person_id, row.number): row.id for row in connection.execute(_INSERTING, rows)}
    stored = {}
    findings: list[dict[str, Any]] = []
    for attempt in new:
        own = (attempt.link_id, attempt.person_id, attempt.number)
        stored[own] = replace(attempt, id=ids[own])
        findings += finding_rows(ids[own], attempt.link_id, path_of_codes(analyses[own]))
    if findings:
        connection.execute(_FINDING, findings)
    return stored


_INSERTING = sa.insert(_ATTEMPT).returning(
    _ATTEMPT.c.id, _ATTEMPT.c.link_id, _ATTEMPT.c.person_id, _ATTEMPT.c.number
)
_FINDING = sa.insert(records.finding)
_COUNTING = (
    sa.update(_PART)
    .where(of_student(_PART, sa.bindparam("own_link"), sa.bindparam("own_person")))
    .values(made=sa.bindparam("now_made"))
)
_COLUMNS = tuple(column.name for column in _ATTEMPT.columns if column.name != "id")


def _note(connection: sa.Connection, standings: Mapping[Student, _Standing], now: datetime) -> None:
    """Store how many attempts were made and what they are worth; what changed is sent."""
    if not standings:
        return
    made = [
        {"own_link": link, "own_person": person, "now_made": standing.session.made}
        for (link, person), standing in standings.items()
    ]
    connection.execute(_COUNTING, made)
    changes = [
        GradeChange(
            link=standing.session.link,
            person_id=standing.session.person.id,
            sends=standing.session.person.subject is not None,
            longest=timedelta(seconds=standing.session.longest),
            before=standing.before,
            grade=standing.grade,
            is_queued=standing.is_queued,
            submitted=standing.submitted,
        )
        for standing in standings.values()
        if standing.grade is not None
    ]
    store_changes(connection, changes, now)
