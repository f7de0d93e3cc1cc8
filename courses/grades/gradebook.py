"""The counted score of each student; what the platform has to hear of it is put into the outbox."""

from collections import defaultdict
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime, timedelta
from typing import Any

import sqlalchemy as sa

from courses.grades.judged import judged
from courses.model import Link
from courses.policies import Allowance, AttemptOutcome, Counted, counted, score_due
from courses.storage import records
from courses.storage.statements import of_student, upsert_all

_GRADE, _OUTBOX = records.grade, records.score_to_send
NAMED = 200  # So many people are named in a query; of more, all of the link are read.


@dataclass(frozen=True, kw_only=True, slots=True)
class GradeChange:
    """A student's grade as it was and as it is now.

    Attributes:
        sends: the platform knows who the student is, so that scores can be sent.
        longest: longest extra time of any student of the link.
        is_queued: the outbox has a row of the student and link.
        submitted: when the attempt that counts was handed in; None: it stands in the database.
    """

    link: Link
    person_id: int
    sends: bool
    longest: timedelta
    before: Counted | None
    grade: Counted
    is_queued: bool
    submitted: datetime | None

    @property
    def is_due(self) -> bool:
        """Whether the gradebook has to hear of it."""
        heard = self.is_queued and self.before is not None and self.before.worth == self.grade.worth
        return self.sends and bool(self.link.line_item or self.link.line_items) and not heard


def store_changes(connection: sa.Connection, changes: Sequence[GradeChange], now: datetime) -> None:
    """Write grades down and queue what the gradebook has to hear, in the transaction that changed them."""
    new = [change for change in changes if change.grade != change.before]
    if new:
        rows = [
            {
                "link_id": change.link.id,
                "person_id": change.person_id,
                "score": change.grade.worth,
                "number": change.grade.number,
            }
            for change in new
        ]
        upsert_all(connection, _GRADE, ("link_id", "person_id"), rows)
    due = [change for change in changes if change.is_due]
    if due:
        _queue(connection, due, now)


def regrade(
    connection: sa.Connection,
    link: Link,
    allowances: Mapping[int, Allowance],
    unsent: Collection[int],
    now: datetime,
) -> None:
    """Derive the grades of students anew from all their attempts, and queue those that changed.

    It belongs to the transaction that changed a rule or a score, with the students' rows locked.
    """
    longest = longest_extra(connection, link.id)
    people = list(allowances)
    outcomes = _outcomes(connection, link.id, people)
    before, queued = _grades(connection, link.id, people), _queued(connection, link.id, people)
    changes, gone = [], list[int]()
    for person_id, allowance in allowances.items():
        made = outcomes.get(person_id, [])
        grade = counted(link.settings.policy, made, allowance)
        if grade is None:
            gone.append(person_id)
            continue
        change = GradeChange(
            link=link,
            person_id=person_id,
            sends=person_id not in unsent,
            longest=longest,
            before=before.get(person_id),
            grade=grade,
            is_queued=person_id in queued,
            submitted=next(outcome.at for outcome in made if outcome.number == grade.number),
        )
        changes.append(change)
    store_changes(connection, changes, now)
    if gone := [person_id for person_id in gone if person_id in before]:
        _withdraw(connection, link.id, gone)


def _withdraw(connection: sa.Connection, link_id: int, people: Collection[int]) -> None:
    """Remove grades that no attempt makes any more, and send nothing of them; what was sent stays there."""
    connection.execute(sa.delete(_GRADE).where(_GRADE.c.link_id == link_id, _GRADE.c.person_id.in_(people)))
    own = _OUTBOX.c.link_id == link_id, _OUTBOX.c.person_id.in_(people), _OUTBOX.c.lease.is_(None)
    nothing_new = {"revision": _OUTBOX.c.sent_revision, "due": None, "dead": False, "problem": None}
    connection.execute(sa.update(_OUTBOX).where(*own).values(nothing_new))


def longest_extra(connection: sa.Connection, link_id: int) -> timedelta:
    """Return the longest extra time of any student of a link."""
    table = records.participation
    found = sa.select(sa.func.max(table.c.extra_seconds)).where(table.c.link_id == link_id)
    return timedelta(seconds=connection.scalar(found) or 0)


def _grades(connection: sa.Connection, link_id: int, people: Collection[int]) -> dict[int, Counted]:
    wanted = sa.select(_GRADE.c.person_id, _GRADE.c.number, _GRADE.c.score).where(_GRADE.c.link_id == link_id)
    rows = connection.execute(wanted.where(*_among(_GRADE, people)))
    return {person: Counted(number=number, worth=worth) for person, number, worth in rows}


def _queued(connection: sa.Connection, link_id: int, people: Collection[int]) -> frozenset[int]:
    wanted = sa.select(_OUTBOX.c.person_id).where(_OUTBOX.c.link_id == link_id)
    return frozenset(connection.scalars(wanted.where(*_among(_OUTBOX, people))))


def _among(table: sa.FromClause, people: Collection[int]) -> list[sa.ColumnElement[bool]]:
    """Return the condition that a row belongs to some people; none where they are many."""
    return [table.c.person_id.in_(people)] if len(people) <= NAMED else []


def _outcomes(
    connection: sa.Connection, link_id: int, people: Collection[int]
) -> dict[int, list[AttemptOutcome]]:
    """Return students' outcomes by person, each with the score that counts."""
    own = judged((link_id,), *_among(records.attempt, people))
    wanted = sa.select(own.c.person_id, own.c.number, own.c.at, own.c.score).order_by(own.c.number)
    found: dict[int, list[AttemptOutcome]] = defaultdict(list)
    for person_id, number, at, score in connection.execute(wanted):
        found[person_id].append(AttemptOutcome(number=number, at=at, score=score))
    return found


def _queue(connection: sa.Connection, changes: Sequence[GradeChange], now: datetime) -> None:
    """Put scores into the outbox, replacing earlier ones of the same students; leases are kept."""
    rows = []
    for change in changes:
        released = change.link.released_at is not None
        rows.append(
            {
                "link_id": change.link.id,
                "person_id": change.person_id,
                "score": change.grade.worth,
                "submitted_at": change.submitted or _handed_in(connection, change),
                "due": score_due(change.link.settings.policy, now, released=released, longest=change.longest),
                "tries": 0,
                "dead": False,
                "problem": None,
                "revision": 1,
            }
        )
    upsert_all(connection, _OUTBOX, ("link_id", "person_id"), rows, _queued_again)


def schedule_scores(connection: sa.Connection, link: Link, now: datetime) -> None:
    """Give scores of a link that wait to be sent the time that its rules now give them."""
    longest = longest_extra(connection, link.id)
    due = score_due(link.settings.policy, now, released=link.released_at is not None, longest=longest)
    waits = sa.and_(
        _OUTBOX.c.link_id == link.id,
        _OUTBOX.c.revision > _OUTBOX.c.sent_revision,
        _OUTBOX.c.dead.is_(False),
        _OUTBOX.c.lease.is_(None),
    )
    connection.execute(sa.update(_OUTBOX).where(waits).values(due=due))


def _queued_again(new: Any) -> Mapping[str, Any]:
    return {
        "due": sa.case((_OUTBOX.c.lease.is_(None), new.due), else_=_OUTBOX.c.due),
        "revision": _OUTBOX.c.revision + 1,
    }


def _handed_in(connection: sa.Connection, change: GradeChange) -> datetime | None:
    table = records.attempt
    own = of_student(table, change.link.id, change.person_id)
    return connection.scalar(sa.select(table.c.at).where(own, table.c.number == change.grade.number))
