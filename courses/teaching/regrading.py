"""Judging stored attempts again after an exercise was mended: looked at first, then applied, resumable.

A run writes what it finds beside the attempts and changes nothing until it is applied. A run that was
interrupted goes on with what it has not judged yet. Attempts stay as they are, with the report that their
students saw: the grade takes the score of the last applied run, and the statistics its codes. An answer that
the exercise as it is now cannot read keeps what counts.
"""

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass
from datetime import datetime
from enum import StrEnum
from typing import Any

import sqlalchemy as sa

from courses.attempts.report_codes import Code
from courses.attempts.stored_attempts import attempt_of
from courses.grades.judged import judged
from courses.model import Attempt
from courses.refusals import OutdatedError, unknown_record
from courses.storage import records
from courses.storage.database import Store
from courses.storage.statements import insert_all_once, of_student, record_of
from courses.teaching.settling import settle
from kinematics.errors import Fault

_RUN, _DONE, _ATTEMPT = records.regrading, records.regraded, records.attempt
BATCH = 200  # Attempts of one transaction: nobody who hands in meanwhile waits for more than these.


class Scope(StrEnum):
    """Which attempts are judged again."""

    COUNTED = "counted"
    ALL = "all"


@dataclass(frozen=True, kw_only=True, slots=True)
class Rejudged:
    """What an attempt is worth now.

    Attributes:
        score: None where the exercise as it is now cannot read the answer.
        path: the codes of the full report, for the statistics.
    """

    attempt_id: int
    score: float | None
    correct: bool = False
    path: tuple[Code, ...] = ()


Judge = Callable[[Sequence[Attempt]], Sequence[Rejudged]]  # Judges a batch; may use several processes.


def begin(store: Store, link_id: int, scope: Scope, basis: str, now: datetime) -> int:
    """Return a run; one of this scope and basis that may still be applied is taken up again.

    The basis is what judgements depend on besides the attempts: on another one they are made anew.
    """
    same = sa.and_(
        _RUN.c.link_id == link_id,
        _RUN.c.scope == scope.value,
        _RUN.c.version == basis,
        _RUN.c.applied.is_(None),
        _RUN.c.id > _last_applied(link_id),
    )
    with store.writing() as connection:
        found = connection.execute(sa.select(_RUN.c.id).where(same)).scalar()
        if found is not None:
            return int(found)
        values = {"link_id": link_id, "scope": scope.value, "version": basis, "started": now}
        return int(connection.execute(sa.insert(_RUN).values(values).returning(_RUN.c.id)).scalar_one())


def _last_applied(link_id: int) -> sa.ScalarSelect[int]:
    """Return the query of the newest run of a link whose scores count; 0 if there is none."""
    applied = _RUN.alias()
    return (
        sa.select(sa.func.coalesce(sa.func.max(applied.c.id), 0))
        .where(applied.c.link_id == link_id, applied.c.applied.is_not(None))
        .scalar_subquery()
    )


def rejudge(store: Store, run: int, judge: Judge) -> int:
    """Judge what the run has not judged yet, batch after batch; return how many attempts it judged."""
    count = last = 0
    while (batch := _waiting(store, run, last)) or last:
        if not batch:  # what has begun to count meanwhile may be older
            last = 0
            continue
        found = judge(batch)
        with store.writing() as connection:
            stands = _standing(connection, [item.attempt_id for item in found])
            rows = [
                {
                    "regrading_id": run,
                    "attempt_id": item.attempt_id,
                    "score": item.score,
                    "correct": item.correct,
                    "report": {"path": item.path},
                }
                for item in found
                if item.attempt_id in stands and item.score is not None
            ]
            kept = stands.intersection(item.attempt_id for item in found if item.score is None)
            rows += _as_it_counts(connection, run, kept)
            if rows:
                insert_all_once(connection, _DONE, rows)  # another lecturer may have asked for the same
        count += len(found)
        last = batch[-1].id
    return count


def _standing(connection: sa.Connection, attempts: Sequence[int]) -> set[int]:
    """Return which attempts still stand, and keep them: a person may be erased while they are judged."""
    wanted = sa.select(_ATTEMPT.c.id).where(_ATTEMPT.c.id.in_(attempts)).order_by(_ATTEMPT.c.id)
    return set(connection.scalars(wanted.with_for_update(read=True, key_share=True)))


def _as_it_counts(connection: sa.Connection, run: int, attempts: Collection[int]) -> list[dict[str, Any]]:
    """Return rows of attempts whose answers cannot be read: the score and the codes that count now."""
    if not attempts:
        return []
    own, finding = judged((_link_of(connection, run),)), records.finding
    paths: dict[int, list[Code]] = {attempt_id: [] for attempt_id in attempts}
    codes = sa.select(finding).where(finding.c.attempt_id.in_(attempts)).order_by(finding.c.position)
    for row in connection.execute(codes):
        paths[row.attempt_id].append((row.kind, row.code, row.row))
    wanted = sa.select(own.c.id, own.c.score, own.c.correct).where(own.c.id.in_(attempts))
    return [
        {
            "regrading_id": run,
            "attempt_id": row.id,
            "score": row.score,
            "correct": bool(row.correct),
            "report": {"path": paths[row.id], "unread": True},
        }
        for row in connection.execute(wanted)
    ]


def _waiting(store: Store, run: int, last: int) -> list[Attempt]:
    """Return the next attempts after one: what a run has done is not read again for every batch."""
    with store.reading() as connection:
        own = connection.execute(sa.select(_RUN).where(_RUN.c.id == run)).one()
        done = sa.select(_DONE.c.attempt_id).where(_DONE.c.regrading_id == run)
        later = _ATTEMPT.c.link_id == own.link_id, _ATTEMPT.c.id > last
        wanted = sa.select(_ATTEMPT).where(*later, _ATTEMPT.c.id.not_in(done))
        if own.scope == Scope.COUNTED:
            grade = records.grade
            own_grade = of_student(grade, _ATTEMPT.c.link_id, _ATTEMPT.c.person_id)
            wanted = wanted.join(grade, own_grade & (grade.c.number == _ATTEMPT.c.number))
        return [attempt_of(row) for row in connection.execute(wanted.order_by(_ATTEMPT.c.id).limit(BATCH))]


def changes(store: Store, run: int) -> list[dict[str, Any]]:
    """Return who would change, and by how much: attempts whose score differs, largest change first."""
    with store.reading() as connection:
        own = judged((_link_of(connection, run),))
        listed = _listed(run, own).add_columns(_DONE.c.score.label("after"))
        ordered = listed.order_by(sa.func.abs(_DONE.c.score - own.c.score).desc(), own.c.id)
        return [record_of(row) for row in connection.execute(ordered.where(_DONE.c.score != own.c.score))]


def unread(store: Store, run: int) -> list[dict[str, Any]]:
    """Return attempts that keep what they count for: the exercise as it is now cannot read their answers."""
    with store.reading() as connection:
        own = judged((_link_of(connection, run),))
        listed = _listed(run, own).where(_DONE.c.report["unread"].as_boolean())
        return [record_of(row) for row in connection.execute(listed.order_by(own.c.id))]


def _link_of(connection: sa.Connection, run: int) -> int:
    return int(connection.execute(sa.select(_RUN.c.link_id).where(_RUN.c.id == run)).scalar_one())


def _listed(run: int, own: sa.CTE) -> sa.Select[Any]:
    """Return the query of a run's attempts, with their students and the scores that count."""
    person = records.person
    return (
        sa.select(own.c.id, own.c.number, person.c.key, person.c.name, own.c.score.label("before"))
        .join(_DONE, _DONE.c.attempt_id == own.c.id)
        .join(person, person.c.id == own.c.person_id)
        .where(_DONE.c.regrading_id == run)
    )


def apply(store: Store, link_id: int, run: int, basis: str, now: datetime) -> None:
    """Let the run's scores count; what changed goes to the gradebook again.

    A run whose application was interrupted is settled to its end.

    Raises:
        UnknownRecordError: the link has no such run that waits.
        OutdatedError: its judgements would be others now, or others have been applied since.
    """
    with store.writing() as connection:
        own = sa.and_(_RUN.c.id == run, _RUN.c.link_id == link_id)
        basis_stands = sa.and_(_RUN.c.version == basis, _RUN.c.id > _last_applied(link_id)).label("stands")
        wanted = sa.select(_RUN.c.applied, _RUN.c.unsettled_from, basis_stands)
        found = connection.execute(wanted.where(own).with_for_update()).first()
        if found is None or (found.applied is not None and found.unsettled_from is None):
            raise unknown_record("regrading")
        if found.applied is None:
            if not found.stands:
                raise OutdatedError(Fault.at("regrading_outdated"))
            connection.execute(sa.update(_RUN).where(own).values(applied=now, unsettled_from=0))
    settle(store, run, now)
