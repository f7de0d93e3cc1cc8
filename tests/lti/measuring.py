"""What storage costs and how long regrading and statistics take, measured; `make measure-courses` runs it.

python -m tests.lti.measuring [--students 2000] [--attempts 20]
"""

import argparse
import random
import resource
import tempfile
import time
from datetime import timedelta
from pathlib import Path
from typing import Any

import sqlalchemy as sa

from courses.model import CourseSession, LinkSettings, Role
from courses.people.enrolment import Arrival, arrive
from courses.people.sessions import session_of
from courses.storage import records
from courses.storage.database import Store, open_store
from courses.teaching.regrading import Scope, apply, begin, changes, rejudge
from courses.teaching.statistics import link_statistics, misconceptions, unexplained
from exercises.library import packaged
from kinematics.cells import DEFAULT
from service.course_resources import now
from service.schemas.exercises.exercises import ExerciseAnswer
from service.settings import Settings
from service.work.regrading_processes import RegradingProcesses
from service.work.session_grading import Grader, judged_submission
from tests.courses.classroom import handed_in, platform
from tests.web.driving import PUMA

ROWS = PUMA["rows"]
MISTAKES: tuple[dict[str, Any], ...] = (
    {},
    {0: {"alpha": "90"}},
    {2: {"a": "a3"}},
    {3: {"d": "-d4"}},
    {1: {"theta": "θ2 + 90"}, 4: {"alpha": "0"}},
)


def answer(mistake: dict[int, dict[str, str]]) -> dict[str, Any]:
    """A table with some cells changed."""
    rows = [{**row, **mistake.get(i, {})} for i, row in enumerate(ROWS)]
    return {"table": {"convention": "modified", "angle_unit": "deg", "length_unit": "m", "rows": rows}}


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--students", type=int, default=2000)
    parser.add_argument("--attempts", type=int, default=20)
    parser.add_argument(
        "--different", action="store_true", help="no two answers alike, every second one wrong"
    )
    chosen = parser.parse_args()
    store = open_store("", Path(tempfile.mkdtemp(prefix="framewise-measuring-", dir="/tmp")))
    grader = Grader(library=packaged(), limits=DEFAULT)
    session = filled(store, grader, chosen.students, chosen.attempts, different=chosen.different)
    link = session.link
    count = chosen.students * chosen.attempts
    spent = timed(lambda: misconceptions(store, link.id))
    print(f"misconceptions of {count} attempts: {spent * 1000:.0f} ms")
    print(f"statistics: {timed(lambda: link_statistics(store, link.id)) * 1000:.0f} ms")
    print(f"unexplained: {timed(lambda: unexplained(store, link.id)) * 1000:.0f} ms")
    settings = LinkSettings(exercise_id="puma560")
    for scope in Scope:
        run = begin(store, link.id, scope, "2", now())
        with RegradingProcesses(grader, settings, Settings()) as judge:
            spent = timed(lambda run=run, judge=judge: rejudge(store, run, judge))
        children = resource.getrusage(resource.RUSAGE_CHILDREN)
        print(f"  processor time of ended processes so far: {children.ru_utime + children.ru_stime:.1f} s")
        found = len(changes(store, run))
        applied = timed(lambda run=run: apply(store, link.id, run, "2", now()))
        print(f"regrading {scope.value}: {spent:.1f} s, {found} changes, applied in {applied:.1f} s")
    store.close()


def timed(work: Any) -> float:
    """Seconds that work takes."""
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def differing(number: int) -> dict[str, Any]:
    """A table that nobody else hands in; every second one has a twist, a length or an offset of its own."""
    chance = random.Random(number)
    cells = [{"theta": f"{row['theta']} + {chance.uniform(1, 170):.4f}"} for row in ROWS]
    mistake: dict[int, dict[str, str]] = {number % len(ROWS): cells[number % len(ROWS)]}
    if number % 2:
        row, name = chance.randrange(len(ROWS)), chance.choice(("alpha", "a", "d"))
        mistake[row] = {**mistake.get(row, {}), name: f"{chance.uniform(0.1, 1.0):.5f}"}
    return answer(mistake)


def filled(
    store: Store, grader: Grader, students: int, attempts: int, *, different: bool = False
) -> CourseSession:
    """A class whose attempts were judged once each and stored for everybody; or whose answers all differ."""
    told = {
        "role": Role.LEARNER,
        "deployment": "1",
        "context": "c",
        "resource": "r",
        "exercise_id": "puma560",
    }
    known = platform(store)
    token, _ = arrive(store, Arrival(platform=known, subject="first", **told), now())
    session = session_of(store, token, now())
    made = []
    for number, mistake in enumerate(MISTAKES):
        typed = answer(mistake)
        wire = ExerciseAnswer.model_validate(typed)
        judged, _ = judged_submission(grader, session, wire, typed, f"k{number}", "en", now())
        made.append(handed_in(store, judged, now()))
    at = now()
    with store.writing() as connection:
        findings = list(connection.execute(sa.select(records.finding)))
        rows = {row.id: dict(row._mapping) for row in connection.execute(sa.select(records.attempt))}
        for n in range(students):
            person = connection.execute(
                sa.insert(records.person)
                .values(platform_id=known.id, key=f"key-{n}", subject=f"s-{n}", created=at, seen=at)
                .returning(records.person.c.id)
            ).scalar_one()
            taken = {"link_id": session.link.id, "person_id": person}
            connection.execute(
                sa.insert(records.participation).values(**taken, role="learner", began=at, made=attempts)
            )
            for number in range(1, attempts + 1):
                source = rows[made[(n + number) % len(made)].id]
                copy = {
                    **source,
                    **taken,
                    **({"answer": differing(n * attempts + number)} if different else {}),
                    "number": number,
                    "key": f"c{number}",
                    "at": at + timedelta(seconds=number),
                }
                copy.pop("id")
                new = connection.execute(
                    sa.insert(records.attempt).values(copy).returning(records.attempt.c.id)
                ).scalar_one()
                own = [
                    {**dict(f._mapping), "attempt_id": new} for f in findings if f.attempt_id == source["id"]
                ]
                if own:
                    connection.execute(sa.insert(records.finding), own)
            connection.execute(sa.insert(records.grade).values(**taken, score=1.0, number=attempts))
    return session


if __name__ == "__main__":
    main()
