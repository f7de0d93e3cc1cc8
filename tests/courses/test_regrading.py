"""Judging again what was handed in, and what files of attempts say then, on both databases."""

import csv
import json
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from datetime import datetime

import pytest
import sqlalchemy as sa

from courses.attempts.report_codes import path_of_codes
from courses.grades.outbox import delivered, lease_scores
from courses.model import Attempt, LinkSettings, Role
from courses.people.privacy import erase_person, export_person
from courses.policies import AttemptPolicy
from courses.refusals import OutdatedError, StorageUnavailableError, UnknownRecordError
from courses.storage import records
from courses.storage.database import Store
from courses.teaching import regrading, settling
from courses.teaching.attempt_export import ExportedAttempt, exported_attempts
from courses.teaching.attempts_behind import AttemptFilter, attempts_behind
from courses.teaching.link_changes import change_settings
from courses.teaching.regrading import Rejudged, Scope, apply, begin, changes, rejudge, unread
from courses.teaching.settling import settle, unsettled
from courses.teaching.statistics import class_overview, link_statistics, misconceptions, unexplained
from service.wire.courses.course_views import attempt_record, csv_of, json_of
from tests.courses.classroom import NOW, joined, submitted
from tests.courses.test_attempts import WRONG, minutes

MENDED = (("repair", "alpha_sign", 2), ("wrong", "pose", None))


def test_an_export_holds_what_counts(store: Store) -> None:
    """Ann's first attempt was regraded; the second costs a penalty; a teacher's tries are left out."""
    policy = AttemptPolicy(penalty=0.25)
    ann = joined(store, "ann")
    change_settings(store, ann.link.id, LinkSettings(points=8.0, policy=policy), NOW)
    submitted(store, joined(store, "ann"), 0.5, key="1", report=WRONG)
    submitted(store, joined(store, "ann"), 0.75, key="2", minutes=1)
    submitted(store, joined(store, "tina", role=Role.STAFF), 1.0, key="1")
    run = begin(store, ann.link.id, Scope.ALL, "2", NOW)
    rejudge(
        store,
        run,
        lambda batch: [
            Rejudged(attempt_id=each.id, score=score, correct=False, path=path)
            for each, (score, path) in zip(batch, ((0.875, MENDED), (0.75, ()), (1.0, ())), strict=True)
        ],
    )
    link = joined(store, "ann").link
    before = [(each.attempt.score, each.path, each.counted) for each in exported_attempts(store, link)]
    assert before == [(0.5, tuple(path_of_codes(WRONG)), True), (0.75, (), False)]
    apply(store, link.id, run, "2", NOW)
    first, second = (attempt_record(each) for each in exported_attempts(store, link))
    kept = ("attempt", "score", "points", "max_points", "counted", "correct", "codes", "report")
    codes = ["repair:alpha_sign@2", "wrong:pose"]
    assert [first[name] for name in kept] == [1, 0.875, 7.0, 8.0, True, False, codes, WRONG]
    assert [second[name] for name in kept[:7]] == [2, 0.75, 4.0, 8.0, False, False, []]
    rows = list(csv.DictReader(b"".join(csv_of(exported_attempts(store, link))).decode().splitlines()))
    assert [(row["counted"], row["codes"]) for row in rows] == [("1", " ".join(codes)), ("0", "")]
    told = json.loads(b"".join(json_of(exported_attempts(store, link))))
    assert told == {"attempts": [first, second]}
    own = export_person(store, ann.person.key)
    assert [each["score"] for each in own["regraded"]] == [0.875, 0.75]
    assert [each["code"] for each in own["finding"]] == ["alpha_sign", "pose"]
    assert json.loads(b"".join(json_of([]))) == {"attempts": []}


@pytest.mark.parametrize("written", [csv_of, json_of])
def test_a_file_begins_before_all_of_it_is_read(
    store: Store, written: Callable[..., Iterator[bytes]]
) -> None:
    """The attempts of a large class took more memory than a container has."""
    ann = joined(store, "ann")
    submitted(store, ann, 0.5, report=WRONG)
    (one,) = exported_attempts(store, ann.link)
    read = 0

    def many() -> Iterator[ExportedAttempt]:
        nonlocal read
        for read in range(1, 10_001):  # noqa: B007
            yield one

    blocks = written(many())
    assert len(next(blocks)) >= 65_536
    assert read < 10_000
    list(blocks)
    assert read == 10_000


def test_two_lecturers_regrade_at_once(store: Store) -> None:
    ann = joined(store, "ann")
    submitted(store, ann, 0.5, report=WRONG)

    def judge(batch: Sequence[Attempt]) -> list[Rejudged]:
        return [Rejudged(attempt_id=each.id, score=1.0, correct=True, path=()) for each in batch]

    def judge_beside_another(batch: Sequence[Attempt]) -> list[Rejudged]:
        assert rejudge(store, begin(store, ann.link.id, Scope.ALL, "2", NOW), judge) == 1
        return judge(batch)

    run = begin(store, ann.link.id, Scope.ALL, "2", NOW)
    rejudge(store, run, judge_beside_another)
    assert [(found["before"], found["after"]) for found in changes(store, run)] == [(0.5, 1.0)]


@pytest.mark.parametrize("left", ["bob", None])
def test_a_person_is_erased_while_answers_are_judged_again(store: Store, left: str | None) -> None:
    """What was judged of them has no attempt to stand beside any more."""
    ann = joined(store, "ann")
    submitted(store, ann, 0.5, report=WRONG)
    if left:
        submitted(store, joined(store, left), 0.5, report=WRONG)

    def judge(batch: Sequence[Attempt]) -> list[Rejudged]:
        erase_person(store, ann.person.key)
        return [Rejudged(attempt_id=each.id, score=1.0, correct=True, path=()) for each in batch]

    run = begin(store, ann.link.id, Scope.ALL, "2", NOW)
    rejudge(store, run, judge)
    assert [found["after"] for found in changes(store, run)] == ([1.0] if left else [])
    apply(store, ann.link.id, run, "2", NOW)


def test_numbers_follow_the_judgement_that_counts(store: Store) -> None:
    ann = joined(store, "ann")
    submitted(store, ann, 0.5, key="1", report=WRONG)
    run = begin(store, ann.link.id, Scope.ALL, "2", NOW)
    rejudge(
        store,
        run,
        lambda batch: [Rejudged(attempt_id=a.id, score=1.0, correct=True, path=()) for a in batch],
    )
    assert link_statistics(store, ann.link.id)["solved"] == 0
    apply(store, ann.link.id, run, "2", NOW)
    assert link_statistics(store, ann.link.id)["solved"] == 1
    assert (misconceptions(store, ann.link.id), unexplained(store, ann.link.id)) == ([], [])
    assert class_overview(store, ann.course.id)["links"][0]["solved"] == 1
    assert [row["score"] for row in attempts_behind(store, ann.link.id, AttemptFilter())] == [1.0]


def test_a_regrading_is_looked_at_then_applied_and_resumed(store: Store) -> None:
    ann, bob = joined(store, "ann"), joined(store, "bob")
    for session in (ann, bob):
        submitted(store, session, 0.5, key="1", report=WRONG)
    for item in lease_scores(store, NOW):
        delivered(store, item, NOW)
    run = begin(store, ann.link.id, Scope.COUNTED, "2", NOW)

    class Interrupted(Exception):
        pass

    def judge(batch):
        return [
            Rejudged(attempt_id=a.id, score=1.0, correct=True, path=())
            for a in batch
            if a.person_id == ann.person.id
        ] or (_ for _ in ()).throw(Interrupted)

    with pytest.raises(Interrupted):
        rejudge(store, run, judge)
    assert begin(store, ann.link.id, Scope.COUNTED, "2", NOW) == run
    same = lambda batch: [  # noqa: E731
        Rejudged(attempt_id=a.id, score=a.score, correct=False, path=tuple(path_of_codes(WRONG)))
        for a in batch
    ]
    assert rejudge(store, run, same) == 1
    assert [(row["key"], row["before"], row["after"]) for row in changes(store, run)] == [
        (ann.person.key, 0.5, 1.0)
    ]
    assert lease_scores(store, NOW + minutes(99)) == []
    apply(store, ann.link.id, run, "2", NOW)
    assert [item.score for item in lease_scores(store, NOW)] == [1.0]
    assert misconceptions(store, ann.link.id)[0]["students"] == 1
    with pytest.raises(UnknownRecordError):
        apply(store, ann.link.id, run, "2", NOW)


@pytest.mark.parametrize("goes_on", ["asked again", "looked after"])
def test_an_application_that_was_interrupted_goes_on(
    store: Store, monkeypatch: pytest.MonkeyPatch, goes_on: str
) -> None:
    """A few students at a time: who hands in meanwhile does not wait for all of the class."""
    monkeypatch.setattr(settling, "BATCH", 2)
    names = ("ann", "bob", "eve")
    for name in names:
        submitted(store, joined(store, name), 0.5, key="1", report=WRONG)
    submitted(store, joined(store, "bob"), 0.25, key="2", report=WRONG)
    link = joined(store, "ann").link
    run = begin(store, link.id, Scope.ALL, "2", NOW)
    rejudge(store, run, lambda batch: [Rejudged(attempt_id=a.id, score=1.0, correct=True) for a in batch])
    settled: list[list[int]] = []
    derived = settling.regrade_people

    def derived_for_one(connection: sa.Connection, link_id: int, people: list[int], now: datetime) -> None:
        if len(settled) == 1:
            raise StorageUnavailableError(is_gone=True)
        settled.append(people)
        derived(connection, link_id, people, now)

    monkeypatch.setattr(settling, "regrade_people", derived_for_one)
    with pytest.raises(StorageUnavailableError):
        apply(store, link.id, run, "2", NOW)
    monkeypatch.setattr(settling, "regrade_people", derived)
    ids = {name: joined(store, name).person.id for name in names}
    assert settled == [[ids["ann"]]]
    submitted(store, joined(store, "ann"), 0.5, key="2", report=WRONG)
    assert unsettled(store, NOW) == []  # it may still be under way
    if goes_on == "asked again":
        apply(store, link.id, run, "3", NOW)
    else:
        (left,) = unsettled(store, NOW + minutes(1))
        settle(store, left, NOW)
    assert unsettled(store, NOW + minutes(1)) == []
    sent = {item.person_id: item.score for item in lease_scores(store, NOW)}
    assert sent == {ids[name]: 1.0 for name in names}
    assert misconceptions(store, link.id)[0]["students"] == 1  # what Ann has handed in since
    with pytest.raises(UnknownRecordError):
        apply(store, link.id, run, "2", NOW)


def test_a_later_regrading_counts_before_an_interrupted_one_is_settled(
    store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    ann = joined(store, "ann")
    submitted(store, ann, 0.5, key="1", report=WRONG)
    submitted(store, joined(store, "bob"), 0.5, key="1", report=WRONG)
    settle_at_once = regrading.settle
    runs = []
    for scope, path in ((Scope.ALL, MENDED), (Scope.COUNTED, ())):
        run = begin(store, ann.link.id, scope, "2", NOW)
        found = Rejudged(attempt_id=0, score=0.75, path=path)
        rejudge(store, run, lambda batch, found=found: [replace(found, attempt_id=a.id) for a in batch])
        monkeypatch.setattr(regrading, "settle", (lambda *_: None) if not runs else settle_at_once)
        apply(store, ann.link.id, run, "2", NOW)
        runs.append(run)
    assert misconceptions(store, ann.link.id) == []
    settle(store, runs[0], NOW)
    assert misconceptions(store, ann.link.id) == []


def test_a_mend_that_is_taken_back_brings_the_codes_back(store: Store) -> None:
    """The second run finds what the attempt was told at first, and not what stands in the statistics."""
    ann = joined(store, "ann")
    submitted(store, ann, 0.5, key="1", report=WRONG)
    before = misconceptions(store, ann.link.id)
    for version, score, path in (("2", 1.0, ()), ("3", 0.5, tuple(path_of_codes(WRONG)))):
        run = begin(store, ann.link.id, Scope.ALL, version, NOW)
        found = Rejudged(attempt_id=0, score=score, correct=score == 1.0, path=path)
        rejudge(store, run, lambda batch, found=found: [replace(found, attempt_id=a.id) for a in batch])
        assert [(told["before"], told["after"]) for told in changes(store, run)] == [(1.5 - score, score)]
        apply(store, ann.link.id, run, version, NOW)
        assert misconceptions(store, ann.link.id) == (before if path else [])
        (exported,) = exported_attempts(store, ann.link)
        assert exported.path == path


def test_an_answer_that_cannot_be_read_any_more_keeps_what_counts(store: Store) -> None:
    ann = joined(store, "ann")
    submitted(store, ann, 0.5, key="1", report=WRONG)
    submitted(store, joined(store, "bob"), 0.5, key="1", report=WRONG)
    both = {"ann": Rejudged(attempt_id=0, score=0.75, path=MENDED), "bob": Rejudged(attempt_id=0, score=1.0)}
    now_unread = {**both, "ann": Rejudged(attempt_id=0, score=None)}
    for basis, found in (("2", both), ("3", now_unread)):
        run = begin(store, ann.link.id, Scope.ALL, basis, NOW)
        judge = lambda batch, found=found: [  # noqa: E731
            replace(found["ann" if a.person_id == ann.person.id else "bob"], attempt_id=a.id) for a in batch
        ]
        rejudge(store, run, judge)
        kept = [(told["key"], told["before"]) for told in unread(store, run)]
        assert kept == ([] if basis == "2" else [(ann.person.key, 0.75)])
        assert len(changes(store, run)) == (2 if basis == "2" else 0)
        apply(store, ann.link.id, run, basis, NOW)
        scores = {each.person: (each.attempt.score, each.path) for each in exported_attempts(store, ann.link)}
        assert scores[ann.person.key] == (0.75, MENDED)
        assert [(entry["kind"], entry["code"]) for entry in misconceptions(store, ann.link.id)] == [
            ("repair", "alpha_sign")
        ]


def test_what_was_looked_at_before_something_changed_is_not_applied(store: Store) -> None:
    """Two lecturers: the second corrects the exercise, or applies scores of a run begun later."""
    ann = joined(store, "ann")
    submitted(store, ann, 0.5, report=WRONG)

    def looked_at(scope: Scope, basis: str, score: float) -> int:
        run = begin(store, ann.link.id, scope, basis, NOW)
        rejudge(store, run, lambda batch: [Rejudged(attempt_id=a.id, score=score) for a in batch])
        return run

    first = looked_at(Scope.COUNTED, "2", 1.0)
    with pytest.raises(OutdatedError, match="regrading_outdated"):
        apply(store, ann.link.id, first, "3", NOW)
    later = looked_at(Scope.ALL, "2", 0.75)
    apply(store, ann.link.id, later, "2", NOW)
    with pytest.raises(OutdatedError, match="regrading_outdated"):
        apply(store, ann.link.id, first, "2", NOW)
    again = looked_at(Scope.COUNTED, "2", 0.875)
    assert again not in (first, later)
    apply(store, ann.link.id, again, "2", NOW)
    assert [each.attempt.score for each in exported_attempts(store, ann.link)] == [0.875]


def test_a_run_of_an_earlier_version_is_applied(store: Store) -> None:
    """It kept the whole report, of an attempt that it judged as before none."""
    for name in ("ann", "bob"):
        submitted(store, joined(store, name), 0.5, key="1", report={} if name == "ann" else WRONG)
    link = joined(store, "ann").link
    run = begin(store, link.id, Scope.ALL, "2", NOW)
    rejudge(
        store,
        run,
        lambda batch: [Rejudged(attempt_id=a.id, score=0.5, correct=False, path=()) for a in batch],
    )
    done = records.regraded
    with store.writing() as connection:
        first = sa.select(sa.func.min(records.attempt.c.id)).scalar_subquery()
        kept = {"report": WRONG, "analysis": WRONG}
        connection.execute(sa.update(done).where(done.c.attempt_id == first).values(report=kept))
        connection.execute(sa.update(done).where(done.c.attempt_id != first).values(report=None))
    apply(store, link.id, run, "2", NOW)
    assert misconceptions(store, link.id)[0]["students"] == 2
    assert [each.path for each in exported_attempts(store, link)] == [tuple(path_of_codes(WRONG))] * 2
