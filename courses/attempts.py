"""Attempts: taken if the policy allows one, stored before they are answered, and never changed.

A submission that arrives again with its idempotency key is the attempt that it was. The counted score and the
message to the gradebook change in the transaction that stores the attempt.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from datetime import datetime, timedelta
from typing import Any

import sqlalchemy as sa

from courses import records
from courses.gradebook import regrade_person
from courses.model import Attempt, CourseSession, Draft
from courses.policies import disclosed, refusal
from courses.refusals import AttemptError, unknown_record
from courses.storage import Store

_TABLE = records.attempt
MOST_FINDINGS = 64


def check_open(session: CourseSession, now: datetime) -> None:
    """Make sure that another attempt is taken.

    Raises:
        AttemptError: the policy takes none.
    """
    fault = refusal(session.link.settings.policy, session.made, session.allowance, now)
    if fault:
        raise AttemptError(fault)


def store_attempt(
    store: Store, session: CourseSession, attempt: Attempt, now: datetime, analysis: Mapping[str, Any]
) -> Attempt:
    """Store a judged submission; return it with its number, or the one that has its key.

    Args:
        store: the database.
        session: who hands it in, and for what.
        attempt: the submission with what its student may be told.
        now: the time.
        analysis: the report at the highest level of help; its codes feed the statistics.

    Raises:
        AttemptError: the policy takes no more: another one came in between.
    """
    own = {"link_id": session.link.id, "person_id": session.person.id}
    with store.writing() as connection:
        made = _take_turn(connection, own)
        known = _by_key(connection, own, attempt.key)
        if known is not None:
            return known
        session = replace(session, made=made)
        check_open(session, now)
        number = made + 1
        shown = shown_now(session, number, now)
        stored = replace(attempt, number=number, shown=shown.value)
        stored = replace(stored, id=_insert(connection, stored))
        insert_findings(connection, stored.id, stored.link_id, analysis)
        here = _own(records.participation, own)
        connection.execute(sa.update(records.participation).where(here).values(made=number))
        regrade_person(connection, session, now)
    return stored


def shown_now(session: CourseSession, made: int, now: datetime) -> Any:
    """How much of a student's judgements may be shown now."""
    return disclosed(
        session.link.settings.policy,
        made,
        now,
        released=session.link.released_at is not None,
        longest=timedelta(seconds=session.longest),
    )


def _take_turn(connection: sa.Connection, own: Mapping[str, int]) -> int:
    """Lock the student's row of the link, so that their submissions come one after another."""
    table = records.participation
    row = connection.execute(sa.select(table.c.made).where(_own(table, own)).with_for_update()).first()
    if row is None:
        raise unknown_record("participation")
    return int(row.made)


def _by_key(connection: sa.Connection, own: Mapping[str, int], key: str) -> Attempt | None:
    row = connection.execute(sa.select(_TABLE).where(_own(_TABLE, own), _TABLE.c.key == key)).first()
    return None if row is None else attempt_of(row)


def by_key(store: Store, session: CourseSession, key: str) -> Attempt | None:
    """The attempt that was stored with an idempotency key, or None."""
    own = {"link_id": session.link.id, "person_id": session.person.id}
    with store.reading() as connection:
        return _by_key(connection, own, key)


def _insert(connection: sa.Connection, attempt: Attempt) -> int:
    names = [column.name for column in _TABLE.columns if column.name != "id"]
    values = {name: getattr(attempt, name) for name in names}
    inserted = connection.execute(sa.insert(_TABLE).values(values).returning(_TABLE.c.id))
    return int(inserted.scalar_one())


def insert_findings(
    connection: sa.Connection, attempt_id: int, link_id: int, report: Mapping[str, Any]
) -> None:
    """Write the codes of a report beside its attempt, for statistics."""
    rows = [
        {"attempt_id": attempt_id, "position": i, "link_id": link_id, "kind": kind, "code": code, "row": row}
        for i, (kind, code, row) in enumerate(path_of_codes(report))
    ]
    if rows:
        connection.execute(sa.insert(records.finding), rows[:MOST_FINDINGS])


def path_of_codes(report: Mapping[str, Any]) -> Iterator[tuple[str, str, int | None]]:
    """Kind, code and row of everything that a stored report tells: its path of stable codes.

    Kinds: `feedback` of the table, `repair` for the edits of the most plausible repair, `wrong` for the facts
    of rows that do not fit, and `part:<kind>` for what is said of the other parts.
    """
    verdict = report.get("verdict") or {}
    for entry in verdict.get("feedback", ()):
        yield "feedback", str(entry["code"]), entry.get("row")
    for repair in list(verdict.get("repairs", ()))[:1]:
        for edit in repair.get("edits", ()):
            yield "repair", str(edit["code"]), edit.get("row")
    for link in verdict.get("links", ()):
        for fact in ("length", "twist", "offset", "joint"):
            if link.get(fact) in ("wrong", "missing"):
                yield "wrong", fact, link.get("row")
    for part in report.get("parts", ()):
        for entry in part.get("feedback", ()):
            yield f"part:{part['kind']}", str(entry["code"]), entry.get("row")


def attempts_of(store: Store, link_id: int, person_id: int) -> list[Attempt]:
    """A student's attempts at a link, oldest first."""
    wanted = sa.select(_TABLE).where(_own(_TABLE, {"link_id": link_id, "person_id": person_id}))
    with store.reading() as connection:
        return [attempt_of(row) for row in connection.execute(wanted.order_by(_TABLE.c.number))]


def attempt_numbered(store: Store, link_id: int, person_id: int, number: int) -> Attempt:
    """One attempt.

    Raises:
        UnknownRecordError: there is no such attempt.
    """
    own = _own(_TABLE, {"link_id": link_id, "person_id": person_id})
    with store.reading() as connection:
        row = connection.execute(sa.select(_TABLE).where(own, _TABLE.c.number == number)).first()
    if row is None:
        raise unknown_record("attempt")
    return attempt_of(row)


def attempt_of(row: Any) -> Attempt:
    """A row of the relation as a record."""
    return Attempt(**{name: getattr(row, name) for name in _NAMES})


_NAMES = tuple(column.name for column in _TABLE.columns)


def keep_draft(store: Store, session: CourseSession, state: Mapping[str, Any] | None, now: datetime) -> None:
    """Keep what somebody has typed; None forgets it."""
    own = _own(records.participation, {"link_id": session.link.id, "person_id": session.person.id})
    with store.writing() as connection:
        values = {"draft": None if state is None else dict(state), "draft_at": now}
        connection.execute(sa.update(records.participation).where(own).values(values))


def draft_of(store: Store, session: CourseSession) -> Draft | None:
    """What somebody had typed, on whatever device."""
    table = records.participation
    own = _own(table, {"link_id": session.link.id, "person_id": session.person.id})
    with store.reading() as connection:
        row = connection.execute(sa.select(table.c.draft, table.c.draft_at).where(own)).first()
    return None if row is None or row.draft is None else Draft(state=row.draft, at=row.draft_at)


def _own(table: sa.Table, own: Mapping[str, int]) -> sa.ColumnElement[bool]:
    return sa.and_(*(table.c[name] == value for name, value in own.items()))
