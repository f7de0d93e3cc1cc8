"""The attempts of a link's students as they count: what a lecturer takes away as a file."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import sqlalchemy as sa

from courses.attempts.report_codes import Code, path_of_codes
from courses.attempts.stored_attempts import attempt_of
from courses.grades.judged import judged, of_students
from courses.model import Attempt, Link
from courses.policies import worth
from courses.storage import records
from courses.storage.database import Store
from courses.storage.statements import of_student
from courses.teaching.settling import stored_path


@dataclass(frozen=True, kw_only=True, slots=True)
class ExportedAttempt:
    """An attempt with the judgement that counts: that of the last regrading that was applied, else its own.

    Attributes:
        attempt: what was handed in, with the score of this judgement and the report that its student saw.
        path: the codes of this judgement.
        person: pseudonym of the student.
        points: what the attempt is worth in the gradebook, after the penalty for attempts before it.
        max_points: what a full score is worth there.
        counted: it makes the student's grade.
    """

    attempt: Attempt
    path: tuple[Code, ...]
    person: str
    points: float
    max_points: float
    counted: bool


def exported_attempts(store: Store, link: Link) -> Iterator[ExportedAttempt]:
    """Yield every attempt of a link's students, oldest first; those of staff and of previews are left out."""
    table, again, grade = records.attempt, records.regraded, records.grade
    own = judged((link.id,))
    wanted = (
        sa.select(
            table,
            own.c.score.label("judged_score"),
            own.c.correct.label("judged_correct"),
            again.c.report.label("judgement"),
            grade.c.number.label("counted_number"),
            records.person.c.key.label("person_key"),
        )
        .join(own, own.c.id == table.c.id)
        .join(records.person, records.person.c.id == table.c.person_id)
        .outerjoin(again, sa.and_(again.c.regrading_id == own.c.run, again.c.attempt_id == table.c.id))
        .outerjoin(grade, of_student(grade, table.c.link_id, table.c.person_id))
        .where(of_students(own))
        .order_by(table.c.id)
        .execution_options(yield_per=200)
    )
    points, policy = link.settings.points, link.settings.policy
    with store.reading() as connection:
        for row in connection.execute(wanted):
            attempt = replace(attempt_of(row), score=row.judged_score, correct=bool(row.judged_correct))
            path = path_of_codes(row.report) if row.judgement is None else stored_path(row.judgement)
            yield ExportedAttempt(
                attempt=attempt,
                path=tuple(path),
                person=row.person_key,
                points=worth(policy, attempt.outcome) * points,
                max_points=points,
                counted=attempt.number == row.counted_number,
            )
