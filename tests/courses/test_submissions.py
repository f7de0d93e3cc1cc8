"""Submissions that are stored together become what they would have become one by one."""

from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from types import ModuleType
from typing import Any

import pytest
import sqlalchemy as sa

from courses.attempts import submissions
from courses.attempts.submissions import JudgedSubmission, store_submissions
from courses.links.link_settings import version_of
from courses.model import Attempt, CourseSession, LinkSettings
from courses.people import enrolment
from courses.people.privacy import erase_person
from courses.policies import AttemptPolicy, Counting, FeedbackTiming
from courses.refusals import AttemptError, UnknownRecordError
from courses.storage import records
from courses.storage.database import Store
from courses.teaching.link_changes import change_settings, release_feedback
from tests.courses.classroom import NOW, arrival, joined
from tests.courses.test_attempts import WRONG

HANDED_IN = (
    ("ann", "a", 0.5), ("bob", "a", 0.2), ("ann", "b", 0.9), ("ann", "a", 1.0), ("eve", "a", 1.0),
    ("ann", "c", 0.1), ("bob", "b", 0.2), ("ann", "d", 1.0), ("bob", "b", 0.7), ("ann", "b", 0.3),
)  # fmt: skip
"""Who hands in, with which idempotency key and what score; ann's fourth is one too many."""
SPLITS = ((10,), (1,) * 10, (3, 4, 3), (7, 3))


def judged(session: CourseSession, key: str, score: float) -> JudgedSubmission:
    attempt = Attempt(
        link_id=session.link.id,
        person_id=session.person.id,
        key=key,
        at=NOW,
        exercise_id="puma560",
        version="1",
        seed=None,
        language="en",
        answer={"said": key},
        report=WRONG,
        score=score,
        correct=score == 1.0,
    )
    return JudgedSubmission(session=session, attempt=attempt, analysis=WRONG)


def told(result: Attempt | Exception) -> tuple[Any, ...]:
    return (result.code,) if isinstance(result, AttemptError) else (result.number, result.key, result.score)


def rows(store: Store, link_id: int) -> list[Any]:
    """Everything of a link that a grade or a gradebook depends on, by pseudonyms."""
    found: list[Any] = []
    with store.reading() as connection:
        for table, names in (
            (records.participation, ("made",)),
            (records.attempt, ("number", "key", "score", "shown", "answer")),
            (records.grade, ("score", "number")),
            (records.score_to_send, ("score", "sent_revision")),
            (records.finding.join(records.attempt), ()),
        ):
            if names:
                wanted = sa.select(records.person.c.subject, *(table.c[name] for name in names))
                wanted = wanted.join(records.person, records.person.c.id == table.c.person_id)
                found.append(sorted(map(repr, connection.execute(wanted.where(table.c.link_id == link_id)))))
            else:
                own = records.attempt.c.link_id == link_id
                found.append(connection.scalar(sa.select(sa.func.count()).select_from(table).where(own)))
    return found


@pytest.mark.parametrize("counting", Counting)
def test_a_batch_is_what_its_submissions_are_one_by_one(store: Store, counting: Counting) -> None:
    policy = AttemptPolicy(attempts=3, counting=counting, penalty=0.1)
    outcomes = []
    for number, split in enumerate(SPLITS):
        here = {"resource": f"link-{number}", "line_item": f"https://lms.example.edu/items/{number}"}
        link = joined(store, "teacher", **here).link
        change_settings(store, link.id, LinkSettings(exercise_id="puma560", policy=policy), NOW)
        sessions = {name: joined(store, name, **here) for name in ("ann", "bob", "eve")}
        waiting = [judged(sessions[name], key, score) for name, key, score in HANDED_IN]
        results: list[Attempt | Exception] = []
        for size in split:
            results += store_submissions(store, waiting[:size], NOW)
            waiting = waiting[size:]
        assert all(isinstance(each, AttemptError) or each.id for each in results)
        outcomes.append(([told(each) for each in results], rows(store, link.id)))
    assert outcomes[0][0] == [
        (1, "a", 0.5), (1, "a", 0.2), (2, "b", 0.9), (1, "a", 0.5), (1, "a", 1.0),
        (3, "c", 0.1), (2, "b", 0.2), ("attempts_used",), (2, "b", 0.2), (2, "b", 0.9),
    ]  # fmt: skip
    assert all(outcome == outcomes[0] for outcome in outcomes)


def test_who_was_erased_meanwhile_spoils_nobody_elses_submission(store: Store) -> None:
    ann, bob = joined(store, "ann"), joined(store, "bob")
    erase_person(store, ann.person.key)
    first, second = store_submissions(store, [judged(ann, "a", 1.0), judged(bob, "a", 1.0)], NOW)
    assert isinstance(first, UnknownRecordError)
    assert isinstance(second, Attempt)


@contextmanager
def meanwhile(module: ModuleType, name: str, change: Callable[[], object]) -> Iterator[None]:
    """Begin a change in another thread once a function is about to be called; both must end without an error.

    The function waits for the change a moment only: the change may have to wait for what calls the function.
    """
    with ThreadPoolExecutor(1) as threads, pytest.MonkeyPatch.context() as patch:
        begun: list[Future[object]] = []
        own = getattr(module, name)

        def late(*given: Any) -> Any:
            begun.append(threads.submit(change))
            wait(begun, 0.3)
            return own(*given)

        patch.setattr(module, name, late)
        yield
        (changed,) = begun
        changed.result()


def handed_in_while(store: Store, session: CourseSession, change: Callable[[], object]) -> None:
    """An attempt whose rules have been read when staff changes them, and which is not stored yet."""
    with meanwhile(submissions, "_known", change):
        (attempt,) = store_submissions(store, [judged(session, "meanwhile", 0.5)], NOW)
    assert isinstance(attempt, Attempt)


def test_a_first_attempt_during_a_release_is_sent(store: Store) -> None:
    """It was stored as held back, by a release that did not see it."""
    session = joined(store)
    held = AttemptPolicy(feedback=FeedbackTiming.ON_RELEASE)
    change_settings(store, session.link.id, LinkSettings(exercise_id="puma560", policy=held), NOW)
    handed_in_while(store, session, lambda: release_feedback(store, session.link.id, NOW))
    with store.reading() as connection:
        assert connection.scalar(sa.select(records.score_to_send.c.due)) == NOW


def test_an_attempt_and_a_change_of_rules_do_not_undo_each_other(store: Store) -> None:
    """Each waited for a row that the other one had."""
    session = joined(store)
    store_submissions(store, [judged(session, "first", 0.2)], NOW)
    now, later = session.link.settings, LinkSettings(exercise_id="puma560", points=2.0)

    def change() -> None:
        change_settings(store, session.link.id, later, NOW, version_of(now))

    handed_in_while(store, session, change)
    assert joined(store).link.settings == later
    with store.reading() as connection:
        assert connection.scalar(sa.select(records.grade.c.score)) == 0.5


def test_a_launch_and_an_erasure_do_not_undo_each_other(store: Store) -> None:
    """Each waited for a row that the other one had."""
    session = joined(store)
    with meanwhile(enrolment, "_course", lambda: erase_person(store, session.person.key)):
        enrolment.arrive(store, arrival(store), NOW)
    with store.reading() as connection:
        assert connection.execute(sa.select(records.person)).first() is None


def test_who_is_erased_while_they_hand_in_leaves_nothing(store: Store) -> None:
    """Their attempt stayed, of a person who took part in nothing."""
    session = joined(store)
    handed_in_while(store, session, lambda: erase_person(store, session.person.key))
    with store.reading() as connection:
        for table in (records.attempt, records.grade, records.person):
            assert connection.execute(sa.select(table)).first() is None
