"""The counted score of each student, and the outbox that carries it to the platform's gradebook.

One row per line item and user. A newer score takes the older one's place before it is sent (coalescing).
Timestamps of messages rise strictly, in whole seconds, also over restarts: the next one is written down
before its message leaves. A sender leases a row; nobody else sends it until the lease ends.
"""

from __future__ import annotations

import secrets
from collections import defaultdict
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import datetime, timedelta
from typing import Any

import sqlalchemy as sa

from courses import records
from courses.link_settings import read
from courses.model import Link, ScoreToSend
from courses.policies import Allowance, AttemptOutcome, Counted, counted, score_due
from courses.statements import upsert_all
from courses.storage import Store

_OUTBOX = records.score_to_send
LEASE = timedelta(seconds=60)
"""Longer than sending may take with every time-out."""


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
        table = records.grade
        rows = [
            {
                "link_id": change.link.id,
                "person_id": change.person_id,
                "score": change.grade.worth,
                "number": change.grade.number,
            }
            for change in new
        ]
        upsert_all(connection, table, ("link_id", "person_id"), rows)
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

    Args:
        connection: in the transaction that changed a rule or a score, with the students' rows locked.
        link: with its rules.
        allowances: of each student, by their ids.
        unsent: students whose scores cannot be sent.
        now: the time.
    """
    longest = longest_extra(connection, link.id)
    outcomes = effective_outcomes(connection, link.id, list(allowances))
    before, queued = _grades(connection, link.id), _queued(connection, link.id)
    changes = []
    for person_id, allowance in allowances.items():
        made = outcomes.get(person_id, [])
        grade = counted(link.settings.policy, made, allowance)
        if grade is None:
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


def longest_extra(connection: sa.Connection, link_id: int) -> timedelta:
    """Longest extra time of any student of a link."""
    table = records.participation
    found = sa.select(sa.func.max(table.c.extra_seconds)).where(table.c.link_id == link_id)
    return timedelta(seconds=connection.scalar(found) or 0)


def _grades(connection: sa.Connection, link_id: int) -> dict[int, Counted]:
    table = records.grade
    wanted = sa.select(table.c.person_id, table.c.number, table.c.score).where(table.c.link_id == link_id)
    return {
        person: Counted(number=number, worth=worth) for person, number, worth in connection.execute(wanted)
    }


def _queued(connection: sa.Connection, link_id: int) -> frozenset[int]:
    return frozenset(connection.scalars(sa.select(_OUTBOX.c.person_id).where(_OUTBOX.c.link_id == link_id)))


def effective_outcomes(
    connection: sa.Connection, link_id: int, people: Collection[int]
) -> dict[int, list[AttemptOutcome]]:
    """Outcomes of students' attempts by person, each with the score that its last regrading gave it."""
    attempt, regraded, run = records.attempt, records.regraded, records.regrading
    wanted = (
        sa.select(attempt.c.id, attempt.c.person_id, attempt.c.number, attempt.c.at, attempt.c.score)
        .where(attempt.c.link_id == link_id)
        .order_by(attempt.c.number)
    )
    again = (
        sa.select(regraded.c.attempt_id, regraded.c.score)
        .join(run, run.c.id == regraded.c.regrading_id)
        .where(run.c.link_id == link_id, run.c.applied.is_not(None))
        .order_by(regraded.c.regrading_id)
    )
    if len(people) == 1:
        wanted = wanted.where(attempt.c.person_id.in_(people))
    newest = {row.attempt_id: row.score for row in connection.execute(again)}
    chosen = set(people)
    found: dict[int, list[AttemptOutcome]] = defaultdict(list)
    for attempt_id, person_id, number, at, score in connection.execute(wanted):
        if person_id in chosen:
            effective = newest.get(attempt_id, score)
            found[person_id].append(AttemptOutcome(number=number, at=at, score=effective))
    return found


def _queue(connection: sa.Connection, changes: Sequence[GradeChange], now: datetime) -> None:
    """Put scores into the outbox, in place of what it has of the same students; what is leased stays so."""
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


def _queued_again(new: Any) -> Mapping[str, Any]:
    return {
        "due": sa.case((_OUTBOX.c.lease.is_(None), new.due), else_=_OUTBOX.c.due),
        "revision": _OUTBOX.c.revision + 1,
    }


def _handed_in(connection: sa.Connection, change: GradeChange) -> datetime | None:
    table = records.attempt
    same = (table.c.link_id == change.link.id, table.c.person_id == change.person_id)
    return connection.scalar(sa.select(table.c.at).where(*same, table.c.number == change.grade.number))


def lease_scores(store: Store, now: datetime, limit: int = 10) -> list[ScoreToSend]:
    """Take scores that are due. Their next timestamps are written down before anybody sends them."""
    lease = secrets.token_hex(8)
    chosen = (
        sa.select(_OUTBOX.c.link_id, _OUTBOX.c.person_id, _OUTBOX.c.timestamp)
        .where(_OUTBOX.c.due <= now, _OUTBOX.c.dead.is_(False), _OUTBOX.c.revision > _OUTBOX.c.sent_revision)
        .order_by(_OUTBOX.c.due)
        .limit(limit)
        .with_for_update(skip_locked=True)
    )
    with store.writing() as connection:
        for row in connection.execute(chosen).all():
            own = sa.and_(_OUTBOX.c.link_id == row.link_id, _OUTBOX.c.person_id == row.person_id)
            values = {
                "lease": lease,
                "due": now + LEASE,
                "timestamp": next_timestamp(row.timestamp, now),
                "tries": _OUTBOX.c.tries + 1,
            }
            connection.execute(sa.update(_OUTBOX).where(own).values(values))
        found = connection.execute(_LEASED.where(_OUTBOX.c.lease == lease)).all()
        return [_to_send(row) for row in found]


def next_timestamp(last: datetime | None, now: datetime) -> datetime:
    """A whole second that is later than the last one, and not before now."""
    whole = now.replace(microsecond=0)
    return whole if last is None else max(whole, last + timedelta(seconds=1))


_LEASED = (
    sa.select(
        _OUTBOX,
        records.person.c.platform_id,
        records.person.c.subject,
        records.link.c.line_item,
        records.link.c.line_items,
        records.link.c.resource,
        records.link.c.title,
        records.link.c.exercise_id,
        records.link.c.settings,
    )
    .join(records.person, records.person.c.id == _OUTBOX.c.person_id)
    .join(records.link, records.link.c.id == _OUTBOX.c.link_id)
)


def _to_send(row: Any) -> ScoreToSend:
    return ScoreToSend(
        link_id=row.link_id,
        person_id=row.person_id,
        platform_id=row.platform_id,
        subject=row.subject or "",
        line_item=row.line_item,
        line_items=row.line_items,
        resource=row.resource,
        title=row.title or row.exercise_id or "",
        score=row.score,
        points=read(row.exercise_id, row.settings).points,
        revision=row.revision,
        tries=row.tries,
        timestamp=row.timestamp,
        submitted_at=row.submitted_at,
        lease=row.lease,
    )


def delivered(store: Store, sent: ScoreToSend, now: datetime) -> None:
    """The platform has taken a score; a newer one that came meanwhile is due at once."""
    newer = _OUTBOX.c.revision > sent.revision
    values = {
        "sent_revision": sent.revision,
        "lease": None,
        "tries": 0,
        "problem": None,
        "due": sa.case((newer, now), else_=None),
    }
    _report(store, sent, values)


def postponed(store: Store, sent: ScoreToSend, problem: str, until: datetime) -> None:
    """The platform could not take a score now."""
    _report(store, sent, {"lease": None, "problem": problem, "due": until})


def undeliverable(store: Store, sent: ScoreToSend, problem: str) -> None:
    """The platform will never take a score as things are: it waits for the lecturer."""
    _report(store, sent, {"lease": None, "problem": problem, "dead": True, "due": None})


def bumped(store: Store, sent: ScoreToSend, now: datetime) -> ScoreToSend:
    """The same score with a later timestamp, for a platform that has seen the first one or a later one."""
    later = next_timestamp(sent.timestamp, now)
    _report(store, sent, {"timestamp": later})
    return replace(sent, timestamp=later)


def resend(store: Store, link_id: int, now: datetime) -> int:
    """Send what could not be delivered of a link again; return how many there are."""
    wanted = sa.and_(_OUTBOX.c.link_id == link_id, _OUTBOX.c.dead.is_(True))
    with store.writing() as connection:
        values = {"dead": False, "due": now, "tries": 0}
        return connection.execute(sa.update(_OUTBOX).where(wanted).values(values)).rowcount


def release_scores(connection: sa.Connection, link_id: int, now: datetime) -> None:
    """Let go what was held back until the lecturer's release."""
    held = sa.and_(
        _OUTBOX.c.link_id == link_id,
        _OUTBOX.c.revision > _OUTBOX.c.sent_revision,
        _OUTBOX.c.dead.is_(False),
        sa.or_(_OUTBOX.c.due.is_(None), _OUTBOX.c.due > now),
        _OUTBOX.c.lease.is_(None),
    )
    connection.execute(sa.update(_OUTBOX).where(held).values(due=now))


@dataclass(frozen=True, kw_only=True, slots=True)
class OutboxState:
    """How the outbox is.

    Attributes:
        waiting: scores that are due, or were tried and will be again.
        dead: scores that a platform has refused for good.
        oldest: how long ago the oldest attempt of those that wait was handed in [s].
    """

    waiting: int
    dead: int
    oldest: float


def outbox_state(store: Store, now: datetime) -> OutboxState:
    """How the outbox is, for those who watch it."""
    unsent = sa.and_(
        _OUTBOX.c.revision > _OUTBOX.c.sent_revision,
        _OUTBOX.c.dead.is_(False),
        sa.or_(_OUTBOX.c.due <= now, _OUTBOX.c.tries > 0),
    )
    wanted = sa.select(
        sa.func.count().filter(unsent),
        sa.func.count().filter(_OUTBOX.c.dead.is_(True)),
        sa.func.min(_OUTBOX.c.submitted_at).filter(unsent),
    )
    with store.asking() as connection:
        waiting, dead, first = connection.execute(wanted).one()
    oldest = 0.0 if first is None else max(0.0, (now - first).total_seconds())
    return OutboxState(waiting=waiting, dead=dead, oldest=oldest)


def keep_line_item(store: Store, link_id: int, line_item: str) -> None:
    """Remember the line item that was found, or made, for a link."""
    with store.writing() as connection:
        own = records.link.c.id == link_id
        connection.execute(sa.update(records.link).where(own).values(line_item=line_item))


def _report(store: Store, sent: ScoreToSend, values: dict[str, Any]) -> None:
    own = sa.and_(
        _OUTBOX.c.link_id == sent.link_id,
        _OUTBOX.c.person_id == sent.person_id,
        _OUTBOX.c.lease == sent.lease,
    )
    with store.writing() as connection:
        connection.execute(sa.update(_OUTBOX).where(own).values(values))
