"""Attempts with the judgement that counts: that of the last regrading that was applied, else their own."""

from collections.abc import Collection

import sqlalchemy as sa

from courses.storage import records
from courses.storage.statements import of_student


def judged(link_ids: Collection[int], *among: sa.ColumnElement[bool]) -> sa.CTE:
    """Return the query of links' attempts, or of those `among` them that meet some conditions.

    Its columns are id, link_id, person_id, number, at, score, correct, run, and the role of who made it.
    """
    attempt, done, run = records.attempt, records.regraded, records.regrading
    part = records.participation
    newest = (
        sa.select(done.c.attempt_id, sa.func.max(done.c.regrading_id).label("run"))
        .join(run, run.c.id == done.c.regrading_id)
        .where(run.c.link_id.in_(link_ids), run.c.applied.is_not(None))
        .group_by(done.c.attempt_id)
    )
    if among:
        newest = newest.join(attempt, attempt.c.id == done.c.attempt_id).where(*among)
    last, again = newest.subquery(), done.alias()
    return (
        sa.select(
            attempt.c.id,
            attempt.c.link_id,
            attempt.c.person_id,
            attempt.c.number,
            attempt.c.at,
            sa.func.coalesce(again.c.score, attempt.c.score).label("score"),
            sa.func.coalesce(again.c.correct, attempt.c.correct).label("correct"),
            last.c.run,
            part.c.role,
        )
        .outerjoin(last, last.c.attempt_id == attempt.c.id)
        .outerjoin(again, sa.and_(again.c.attempt_id == attempt.c.id, again.c.regrading_id == last.c.run))
        .outerjoin(part, of_student(part, attempt.c.link_id, attempt.c.person_id))
        .where(attempt.c.link_id.in_(link_ids), *among)
        .cte("judged")
    )


def of_students(attempts: sa.CTE) -> sa.ColumnElement[bool]:
    """Return the condition that an attempt is a student's: staff and previews do not count."""
    return attempts.c.role == "learner"
