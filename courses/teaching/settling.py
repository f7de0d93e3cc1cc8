"""What follows from a regrading that counts: grades, messages to the gradebook, codes for the statistics.

A large class has so many attempts that nobody could hand in meanwhile if it were one transaction. So a few
students are settled at a time; a run notes from which one on it is unsettled, and whoever comes next goes on
there: the same request sent again, or a process that looks for runs whose request has ended before its time.
"""

from collections.abc import Iterable, Mapping, Sequence
from datetime import datetime
from typing import Any

import sqlalchemy as sa

from courses.attempts.report_codes import Code, finding_rows, path_of_codes
from courses.storage import records
from courses.storage.database import Store
from courses.teaching.link_changes import regrade_people

_RUN, _DONE, _ATTEMPT = records.regrading, records.regraded, records.attempt
_FINDING, _PART = records.finding, records.participation
BATCH = 400
"""Attempts of one transaction, or all of one student: who hands in meanwhile waits for no more than these."""
STUDENTS = 100  # Students of one transaction.


def settle(store: Store, run: int, now: datetime) -> None:
    """Settle the students whom an applied run has left, a few in each transaction."""
    while _settle_some(store, run, now):
        pass


def unsettled(store: Store, before: datetime) -> list[int]:
    """Return runs that were applied before a time and have students left."""
    left = sa.select(_RUN.c.id).where(_RUN.c.unsettled_from.is_not(None), _RUN.c.applied < before)
    with store.asking() as connection:
        return list(connection.scalars(left.order_by(_RUN.c.id)))


def _settle_some(store: Store, run: int, now: datetime) -> bool:
    """Settle the next students; return whether there were any."""
    with store.writing() as connection:
        own = _RUN.c.id == run
        left = sa.and_(own, _RUN.c.unsettled_from.is_not(None))
        found = connection.execute(sa.select(_RUN).where(left).with_for_update()).first()
        if found is None:
            return False
        people = _next_people(connection, found.link_id, found.unsettled_from)
        unsettled_from = people[-1] + 1 if people else None
        connection.execute(sa.update(_RUN).where(own).values(unsettled_from=unsettled_from))
        if people:
            regrade_people(connection, found.link_id, people, now)
            _replace_findings(connection, found.link_id, run, people)
    return bool(people)


def _next_people(connection: sa.Connection, link_id: int, first: int) -> list[int]:
    """Return the next students who have handed in: as many as have made what is settled at a time."""
    wanted = (
        sa.select(_PART.c.person_id, _PART.c.made)
        .where(_PART.c.link_id == link_id, _PART.c.person_id >= first, _PART.c.made > 0)
        .order_by(_PART.c.person_id)
        .limit(STUDENTS)
    )
    people: list[int] = []
    attempts = 0
    for person_id, made in connection.execute(wanted):
        attempts += made
        if people and attempts > BATCH:
            break
        people.append(person_id)
    return people


def _replace_findings(connection: sa.Connection, link_id: int, run: int, people: Sequence[int]) -> None:
    """Put the codes of a run in the place of those that stand beside its attempts, where they differ.

    Codes of a later run that was applied meanwhile stay, and attempts that are erased get none.
    """
    later, other = _DONE.alias(), _RUN.alias()
    replaced = (
        sa.exists()
        .where(later.c.attempt_id == _DONE.c.attempt_id, later.c.regrading_id > run)
        .where(other.c.id == later.c.regrading_id, other.c.applied.is_not(None))
    )
    wanted = (
        sa.select(_DONE.c.attempt_id, _DONE.c.report)
        .join(_ATTEMPT, _ATTEMPT.c.id == _DONE.c.attempt_id)
        .where(_ATTEMPT.c.link_id == link_id, _ATTEMPT.c.person_id.in_(people))
        .where(_DONE.c.regrading_id == run, ~replaced)
        .order_by(_ATTEMPT.c.id)
        .with_for_update(read=True, key_share=True, of=_ATTEMPT)
    )
    now = {
        row.attempt_id: finding_rows(row.attempt_id, link_id, stored_path(row.report))
        for row in connection.execute(wanted)
        if row.report is not None
    }
    stand: dict[int, list[dict[str, Any]]] = {attempt_id: [] for attempt_id in now}
    standing = sa.select(_FINDING).where(_FINDING.c.attempt_id.in_(stand))
    for row in connection.execute(standing.order_by(_FINDING.c.attempt_id, _FINDING.c.position)).mappings():
        stand[row["attempt_id"]].append(dict(row))
    changed = [attempt_id for attempt_id, rows in now.items() if rows != stand[attempt_id]]
    if changed:
        connection.execute(sa.delete(_FINDING).where(_FINDING.c.attempt_id.in_(changed)))
    found = [row for attempt_id in changed for row in now[attempt_id]]
    if found:
        connection.execute(sa.insert(_FINDING), found)


def stored_path(judgement: Mapping[str, Any]) -> Iterable[Code]:
    """Return the codes of a judgement that a run keeps; runs of earlier versions kept the full report."""
    path = judgement.get("path")
    return path_of_codes(judgement["analysis"]) if path is None else map(tuple, path)
