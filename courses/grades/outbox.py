"""Scores on their way to the platform's gradebook.

One row per line item and user. A newer score takes the older one's place before it is sent (coalescing).
Timestamps of messages rise strictly, in whole seconds, also over restarts: the next one is written down
before its message leaves. A sender leases a row; nobody else sends it until the lease ends.
"""

import secrets
from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import datetime, timedelta
from typing import Any

import sqlalchemy as sa

from courses.grades.gradebook import longest_extra
from courses.links.link_settings import stored
from courses.model import ScoreToSend
from courses.policies import score_due
from courses.storage import records
from courses.storage.database import Store
from courses.storage.statements import filled, of_student

_OUTBOX = records.score_to_send
LEASE = timedelta(seconds=60)  # Longer than sending may take with every time-out.
LINE_ITEM_GONE = "line_item_gone"  # Stable code of a score whose line item the platform has no more.
_LONGEST_PAUSE = timedelta(hours=25)
"""No score waits longer for its next try: what is due later became so while the clock was ahead."""


def lease_scores(store: Store, now: datetime, limit: int = 10) -> list[ScoreToSend]:
    """Take scores that are due. Their next timestamps are stored before anybody sends them.

    What the rules withhold now waits on: they may have changed while another process had the score and died,
    or between a student's sign-in and the storing of what was handed in.
    """
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
            own = of_student(_OUTBOX, row.link_id, row.person_id)
            values = {
                "lease": lease,
                "due": now + LEASE,
                "timestamp": next_timestamp(row.timestamp, now),
                "tries": _OUTBOX.c.tries + 1,
            }
            connection.execute(sa.update(_OUTBOX).where(own).values(values))
        found = connection.execute(_LEASED.where(_OUTBOX.c.lease == lease)).all()
        due = _due_by_link(connection, found, now)
        for row in found:
            if (until := due[row.link_id]) != now:
                waiting = {"lease": None, "due": until, "tries": row.tries - 1}
                own = of_student(_OUTBOX, row.link_id, row.person_id)
                connection.execute(sa.update(_OUTBOX).where(own).values(waiting))
        return [_to_send(row) for row in found if due[row.link_id] == now]


def _due_by_link(connection: sa.Connection, rows: Sequence[Any], now: datetime) -> dict[int, datetime | None]:
    """Return when scores of links may be sent, by the rules that the links have now."""
    due: dict[int, datetime | None] = {}
    for row in rows:
        if row.link_id not in due:
            policy, released = stored(row.exercise_id, row.settings).policy, row.released_at is not None
            waits = policy.closes is not None and not released
            longest = longest_extra(connection, row.link_id) if waits else timedelta()
            due[row.link_id] = score_due(policy, now, released=released, longest=longest)
    return due


def hasten(store: Store, now: datetime) -> None:
    """Let scores be due now that would wait for a time to which the clock had run ahead.

    Those that the rules withhold are given their time again when somebody wants to send them.
    """
    waits = _OUTBOX.c.due > now, _OUTBOX.c.dead.is_(False)
    from_ahead = sa.or_(
        sa.and_(_OUTBOX.c.tries == 0, _OUTBOX.c.submitted_at > now + LEASE),
        sa.and_(_OUTBOX.c.tries > 0, _OUTBOX.c.due > now + _LONGEST_PAUSE),
    )
    with store.writing() as connection:
        connection.execute(sa.update(_OUTBOX).where(*waits, from_ahead).values(due=now))


def next_timestamp(last: datetime | None, now: datetime) -> datetime:
    """Return a whole second that is later than the last one, and not before now."""
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
        records.link.c.released_at,
    )
    .join(records.person, records.person.c.id == _OUTBOX.c.person_id)
    .join(records.link, records.link.c.id == _OUTBOX.c.link_id)
)


def _to_send(row: Any) -> ScoreToSend:
    return filled(
        ScoreToSend,
        row,
        subject=row.subject or "",
        title=row.title or row.exercise_id or "",
        points=stored(row.exercise_id, row.settings).points,
    )


def delivered(store: Store, sent: ScoreToSend, now: datetime) -> None:
    """Note that the platform has taken a score; a newer one that came meanwhile is due at once."""
    values = {
        "sent_revision": sent.revision,
        "lease": None,
        "tries": 0,
        "problem": None,
        "due": sa.case((_OUTBOX.c.revision > sent.revision, now), else_=None),
    }
    _report(store, sent, values)


def postponed(store: Store, sent: ScoreToSend, problem: str, until: datetime) -> None:
    """Note that the platform could not take a score now."""
    _report(store, sent, {"lease": None, "problem": problem, "due": until})


def undeliverable(store: Store, sent: ScoreToSend, problem: str) -> None:
    """Note that the platform will never take a score as things are: it waits for the lecturer."""
    _report(store, sent, {"lease": None, "problem": problem, "dead": True, "due": None})


def bumped(store: Store, sent: ScoreToSend, now: datetime) -> ScoreToSend:
    """Return the same score with a later timestamp.

    It is for a platform that has seen the first one or a later one.
    """
    later = next_timestamp(sent.timestamp, now)
    _report(store, sent, {"timestamp": later})
    return replace(sent, timestamp=later)


def resend(store: Store, link_id: int, now: datetime) -> int:
    """Send what could not be delivered of a link again; return how many there are.

    A line item that is gone is looked for again, and made if there is none, where the platform lists them.
    """
    wanted = sa.and_(_OUTBOX.c.link_id == link_id, _OUTBOX.c.dead.is_(True))
    link = records.link.c
    is_gone = sa.exists().where(wanted, _OUTBOX.c.problem == LINE_ITEM_GONE)
    forgets = link.id == link_id, link.line_items.is_not(None), is_gone
    with store.writing() as connection:
        connection.execute(sa.update(records.link).where(*forgets).values(line_item=None))
        values = {"dead": False, "due": now, "tries": 0}
        return connection.execute(sa.update(_OUTBOX).where(wanted).values(values)).rowcount


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
    """Return how the outbox is, for those who watch it."""
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
    own = of_student(_OUTBOX, sent.link_id, sent.person_id), _OUTBOX.c.lease == sent.lease
    with store.writing() as connection:
        connection.execute(sa.update(_OUTBOX).where(*own).values(values))
