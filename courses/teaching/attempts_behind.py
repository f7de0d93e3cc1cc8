"""The attempts behind a number that staff sees: with a code, of a student, a day, a step or a state."""

from dataclasses import dataclass
from datetime import UTC, date, datetime, time
from enum import StrEnum
from typing import Any

import sqlalchemy as sa

from courses.grades.judged import judged
from courses.storage import records
from courses.storage.database import Store
from courses.storage.statements import record_of

STUCK_AFTER = 3  # So many wrong attempts and no right one: a student is stuck.
LISTED = 200  # Attempts that a page lists.


class Outcome(StrEnum):
    """What an attempt was on its student's way."""

    REACHED = "reached"
    SOLVED = "solved"
    LEFT = "left"


class Progress(StrEnum):
    """How far a student has come with a link."""

    BEGUN = "begun"
    STUCK = "stuck"
    SOLVED = "solved"


@dataclass(frozen=True, kw_only=True, slots=True)
class AttemptFilter:
    """Which attempts at a link stand behind a number; all of its students', if nothing is named.

    Attributes:
        kind: of the code; `repair` if none is named.
        code: wrong attempts in which it was found.
        ids: these attempts.
        person: of one student, by their pseudonym.
        day: those of a day (UTC).
        number: everybody's first, second, …
        correct: right ones, or wrong ones.
        outcome: attempts up to the first right one; first right ones; last ones of those who had none right.
        progress: the attempt that tells how far a student is: the first right one, else the last.
    """

    kind: str | None = None
    code: str | None = None
    ids: tuple[int, ...] = ()
    person: str | None = None
    day: date | None = None
    number: int | None = None
    correct: bool | None = None
    outcome: Outcome | None = None
    progress: Progress | None = None


def attempts_behind(store: Store, link_id: int, asked: AttemptFilter) -> list[dict[str, Any]]:
    """Return the attempts behind a number of a link, newest first."""
    own = judged((link_id,))
    whole = sa.select(
        own,
        sa.func.min(sa.case((own.c.correct, own.c.number)))
        .over(partition_by=own.c.person_id)
        .label("success"),
        sa.func.max(own.c.number).over(partition_by=own.c.person_id).label("last"),
    ).subquery()
    person = records.person
    wanted = (
        sa.select(
            whole.c.id,
            whole.c.number,
            whole.c.at,
            whole.c.score,
            whole.c.correct,
            person.c.key,
            person.c.name,
        )
        .join(person, person.c.id == whole.c.person_id)
        .where(*_conditions(whole, link_id, asked))
        .order_by(whole.c.id.desc())
        .limit(LISTED)
    )
    with store.reading() as connection:
        return [
            {**record_of(row), "at": row.at.isoformat(), "correct": bool(row.correct)}
            for row in connection.execute(wanted)
        ]


def _conditions(whole: sa.Subquery, link_id: int, asked: AttemptFilter) -> list[sa.ColumnElement[bool]]:
    columns, finding = whole.c, records.finding
    found: list[sa.ColumnElement[bool]] = []
    if asked.code is not None:
        kind = asked.kind or "repair"
        named = sa.select(finding.c.attempt_id).where(
            finding.c.link_id == link_id, finding.c.kind == kind, finding.c.code == asked.code
        )
        found += [columns.id.in_(named), columns.correct.is_(False)]
    if asked.ids:
        found.append(columns.id.in_(asked.ids))
    found.append(columns.role == "learner" if asked.person is None else records.person.c.key == asked.person)
    if asked.day is not None:
        first, last = (datetime.combine(asked.day, each, UTC) for each in (time.min, time.max))
        found.append(columns.at.between(first, last))
    if asked.number is not None:
        found.append(columns.number == asked.number)
    if asked.correct is not None:
        found.append(columns.correct.is_(asked.correct))
    if asked.outcome is not None:
        found.append(_outcome(columns, asked.outcome))
    if asked.progress is not None:
        found += _progress(columns, asked.progress)
    return found


def _outcome(columns: Any, outcome: Outcome) -> sa.ColumnElement[bool]:
    if outcome is Outcome.REACHED:
        return sa.or_(columns.success.is_(None), columns.number <= columns.success)
    if outcome is Outcome.SOLVED:
        return sa.and_(columns.number == columns.success)
    return sa.and_(columns.success.is_(None), columns.number == columns.last)


def _progress(columns: Any, progress: Progress) -> list[sa.ColumnElement[bool]]:
    if progress is Progress.SOLVED:
        return [_outcome(columns, Outcome.SOLVED)]
    many = columns.last >= STUCK_AFTER
    return [_outcome(columns, Outcome.LEFT), many if progress is Progress.STUCK else sa.not_(many)]
