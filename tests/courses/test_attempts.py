"""Attempts, grades, drafts, sessions and the outbox, on both databases."""

import itertools
import threading
import time
from dataclasses import replace
from datetime import UTC, date, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest
import sqlalchemy as sa

from courses.attempts.stored_attempts import LISTED, attempt_numbered, keep_drafts, standing_of
from courses.grades.outbox import delivered, hasten, lease_scores, postponed, resend, undeliverable
from courses.model import CourseSession, LinkSettings, PlatformStatus, Role
from courses.people import privacy
from courses.people.audit import log_access
from courses.people.enrolment import arrive, preview
from courses.people.platforms import add_platform, remove_platform, set_status
from courses.people.privacy import erase_person, export_person, person_named, purge
from courses.people.secrets import issue_code, pseudonym, redeem_code, remember_nonce
from courses.people.sessions import SESSION, end_session, session_of
from courses.policies import Allowance, AttemptPolicy, Counted, Counting, FeedbackTiming, Mode
from courses.refusals import AttemptError, SessionError, UnknownRecordError
from courses.storage import records
from courses.storage.database import Store, open_store
from courses.teaching.attempts_behind import AttemptFilter, Outcome, Progress, attempts_behind
from courses.teaching.link_changes import allow, change_settings, release_feedback
from courses.teaching.statistics import (
    class_overview,
    link_statistics,
    misconceptions,
    undelivered,
    unexplained,
)
from service.work.retention import Retention
from tests.courses.classroom import NOW, arrival, attempts_of, joined, platform, submitted


def minutes(count: float) -> timedelta:
    return timedelta(minutes=count)


def test_an_attempt_comes_back_as_it_was_typed(store: Store) -> None:
    session = joined(store)
    typed = {"table": {"rows": [{"theta": "θ₁ + ½π", "a": "\u0000", "d": 1e-300}]}, "seed": "𝔰"}
    made = submitted(store, session, 0.25, answer=typed)
    found = attempt_numbered(store, session, 1)
    assert found == made
    assert found.answer == typed
    assert found.at == NOW


def test_a_submission_that_comes_twice_is_one_attempt(store: Store) -> None:
    session = joined(store)
    first = submitted(store, session, 0.5, key="same")
    again = submitted(store, session, 0.9, key="same", minutes=1)
    assert again == first
    assert len(attempts_of(store, session)) == 1


def test_submissions_at_the_same_time_are_numbered_and_limited(store: Store) -> None:
    session = joined(store)
    change_settings(store, session.link.id, LinkSettings(policy=AttemptPolicy(attempts=5)), NOW)
    session = joined(store)
    refused: list[AttemptError] = []

    def hand_in(number: int) -> None:
        try:
            submitted(store, session, 0.1, key=f"key-{number}")
        except AttemptError as error:
            refused.append(error)

    threads = [threading.Thread(target=hand_in, args=(n,)) for n in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    numbers = [attempt.number for attempt in attempts_of(store, session)]
    assert numbers == [1, 2, 3, 4, 5]
    assert [error.code for error in refused] == ["attempts_used"] * 3


def test_the_best_score_goes_out_once(store: Store) -> None:
    session = joined(store)
    for score in (0.5, 1.0, 0.2):
        submitted(store, session, score, key=str(score))
    sent = lease_scores(store, NOW)
    assert [item.score for item in sent] == [1.0]
    assert lease_scores(store, NOW) == []
    delivered(store, sent[0], NOW)
    assert lease_scores(store, NOW + minutes(60)) == []


def test_timestamps_rise_whatever_the_clock_says(store: Store) -> None:
    session = joined(store)
    stamps = []
    for number, now in enumerate((NOW, NOW, NOW - minutes(5), NOW + minutes(1))):
        submitted(store, session, 0.1 * (number + 1), key=str(number))
        (sent,) = lease_scores(store, max(now, NOW))
        stamps.append(sent.timestamp)
        delivered(store, sent, now)
    assert all(later - earlier >= timedelta(seconds=1) for earlier, later in itertools.pairwise(stamps))
    assert all(stamp.microsecond == 0 for stamp in stamps)


def test_a_score_that_changes_while_it_is_sent_is_sent_again_later(store: Store) -> None:
    session = joined(store)
    submitted(store, session, 0.2, key="a")
    (sent,) = lease_scores(store, NOW)
    submitted(store, session, 0.8, key="b")
    assert lease_scores(store, NOW + minutes(0.5)) == []
    delivered(store, sent, NOW)
    (newer,) = lease_scores(store, NOW)
    assert (newer.score, newer.timestamp > sent.timestamp) == (0.8, True)


def test_a_sender_that_died_loses_its_lease(store: Store) -> None:
    session = joined(store)
    submitted(store, session, 0.2)
    (sent,) = lease_scores(store, NOW)
    (again,) = lease_scores(store, NOW + minutes(2))
    assert again.timestamp > sent.timestamp
    delivered(store, sent, NOW)  # too late: the lease is another's
    postponed(store, again, "platform_busy", NOW + minutes(9))
    assert lease_scores(store, NOW + minutes(8)) == []
    assert len(lease_scores(store, NOW + minutes(9))) == 1


def test_two_senders_never_hold_the_same_score(store: Store) -> None:
    for number in range(30):
        submitted(store, joined(store, f"student-{number}"), 0.5)
    taken: list[tuple[int, int]] = []

    def send() -> None:
        while items := lease_scores(store, NOW, limit=3):
            taken.extend((item.link_id, item.person_id) for item in items)

    threads = [threading.Thread(target=send) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(taken) == len(set(taken)) == 30


def test_what_cannot_be_delivered_waits_for_the_lecturer(store: Store) -> None:
    session = joined(store)
    submitted(store, session, 0.2)
    (sent,) = lease_scores(store, NOW)
    undeliverable(store, sent, "line_item_gone")
    assert lease_scores(store, NOW + minutes(600)) == []
    (told,) = undelivered(store, session.course.id)
    assert (told["problem"], told["dead"]) == ("line_item_gone", True)
    assert resend(store, session.link.id, NOW) == 1
    assert len(lease_scores(store, NOW)) == 1


@pytest.mark.parametrize(
    ("problem", "lists", "is_looked_for"),
    [("line_item_gone", True, True), ("line_item_gone", False, False), ("http_403", True, False)],
)
def test_a_column_that_is_gone_is_looked_for_again_when_a_score_is_sent_again(
    store: Store, problem: str, lists: bool, is_looked_for: bool
) -> None:
    """Scores went to the column that had been deleted, however often they were sent again."""
    columns = "https://lms.example.edu/items" if lists else None
    session = joined(store, line_items=columns)
    submitted(store, session, 0.2)
    (sent,) = lease_scores(store, NOW)
    undeliverable(store, sent, problem)
    resend(store, session.link.id, NOW)
    (again,) = lease_scores(store, NOW)
    assert (again.line_item is None, again.line_items) == (is_looked_for, columns)


def test_scores_are_held_until_the_release(store: Store) -> None:
    session = joined(store)
    policy = AttemptPolicy(feedback=FeedbackTiming.ON_RELEASE)
    change_settings(store, session.link.id, LinkSettings(policy=policy), NOW)
    submitted(store, joined(store), 0.7)
    assert lease_scores(store, NOW + minutes(10_000)) == []
    release_feedback(store, session.link.id, NOW)
    assert [item.score for item in lease_scores(store, NOW)] == [0.7]


@pytest.mark.parametrize("by", ["extra time", "a later end"])
def test_scores_wait_until_the_last_student_is_done(store: Store, by: str) -> None:
    """They went out at the end that was in force when they were handed in, and told what pages withheld."""
    rules = AttemptPolicy(mode=Mode.EXAM, closes=NOW + minutes(60))
    session = joined(store)
    link = session.link.id
    change_settings(store, link, LinkSettings(policy=rules), NOW)
    submitted(store, joined(store), 0.7)
    if by == "extra time":
        allow(
            store, session.link, joined(store, "another").person.key, Allowance(extra_time=minutes(30)), NOW
        )
    else:
        change_settings(store, link, LinkSettings(policy=replace(rules, closes=NOW + minutes(90))), NOW)
    assert lease_scores(store, NOW + minutes(89)) == []
    assert [item.score for item in lease_scores(store, NOW + minutes(91))] == [0.7]


def test_extra_time_that_is_given_after_the_sign_in_holds_back_what_is_stored_later(store: Store) -> None:
    """The score was due as of the longest extra time that there was when its student signed in."""
    rules = AttemptPolicy(mode=Mode.EXAM, closes=NOW + minutes(60))
    change_settings(store, joined(store).link.id, LinkSettings(policy=rules), NOW)
    session = joined(store)
    another = joined(store, "another").person.key
    allow(store, session.link, another, Allowance(extra_time=minutes(30)), NOW)
    submitted(store, session, 0.7)
    assert lease_scores(store, NOW + minutes(61)) == []
    assert lease_scores(store, NOW + minutes(89)) == []
    assert [item.score for item in lease_scores(store, NOW + minutes(91))] == [0.7]


def test_a_score_whose_sender_died_is_withheld_by_rules_that_were_made_meanwhile(store: Store) -> None:
    """It went out when the lease was over."""
    session = joined(store)
    submitted(store, session, 0.7)
    (held,) = lease_scores(store, NOW)
    rules = AttemptPolicy(feedback=FeedbackTiming.ON_RELEASE)
    change_settings(store, session.link.id, LinkSettings(policy=rules), NOW)
    assert lease_scores(store, NOW + minutes(2)) == []
    assert lease_scores(store, NOW + minutes(9_000)) == []
    release_feedback(store, session.link.id, NOW + minutes(3))
    (sent,) = lease_scores(store, NOW + minutes(3))
    assert (sent.score, sent.tries) == (0.7, held.tries + 1)


def test_a_score_of_a_time_to_which_the_clock_had_run_ahead_does_not_wait_for_it(store: Store) -> None:
    """The mark of an afternoon at which the clock was a year ahead came a year later."""
    year = 365 * 24 * 60
    submitted(store, joined(store, "never tried"), 0.7, minutes=year)
    submitted(store, joined(store, "tried"), 0.6, minutes=year - 1)
    (tried,) = lease_scores(store, NOW + minutes(year - 1))
    postponed(store, tried, "http_503", NOW + minutes(year + 9))
    submitted(store, joined(store, "now"), 0.5)
    assert [item.score for item in lease_scores(store, NOW)] == [0.5]
    hasten(store, NOW)
    assert sorted(item.score for item in lease_scores(store, NOW)) == [0.6, 0.7]


def test_what_is_withheld_or_waits_for_another_try_is_not_hastened(store: Store) -> None:
    rules = AttemptPolicy(mode=Mode.EXAM, closes=NOW + minutes(60))
    change_settings(store, joined(store).link.id, LinkSettings(policy=rules), NOW)
    submitted(store, joined(store), 0.7, minutes=30)
    hasten(store, NOW)
    assert lease_scores(store, NOW) == []
    (sent,) = lease_scores(store, NOW + minutes(61))
    postponed(store, sent, "http_503", NOW + minutes(90))
    hasten(store, NOW + minutes(70))
    assert lease_scores(store, NOW + minutes(89)) == []
    assert len(lease_scores(store, NOW + minutes(90))) == 1


def test_scores_go_out_at_once_where_an_exam_becomes_an_exercise(store: Store) -> None:
    rules = AttemptPolicy(mode=Mode.EXAM, closes=NOW + minutes(60))
    link = joined(store).link.id
    change_settings(store, link, LinkSettings(policy=rules), NOW)
    submitted(store, joined(store), 0.7)
    assert lease_scores(store, NOW + minutes(1)) == []
    change_settings(store, link, LinkSettings(policy=replace(rules, mode=Mode.PRACTICE)), NOW)
    assert [item.score for item in lease_scores(store, NOW + minutes(1))] == [0.7]


def test_extra_time_lets_a_late_attempt_count(store: Store) -> None:
    session = joined(store)
    policy = AttemptPolicy(closes=NOW + minutes(10), counting=Counting.LAST)
    change_settings(store, session.link.id, LinkSettings(policy=policy), NOW)
    session = joined(store)
    submitted(store, session, 0.9, minutes=15)
    state = class_overview(store, session.course.id)["students"][0]["links"][str(session.link.id)]
    assert state["score"] is None
    allow(store, session.link, session.person.key, Allowance(extra_time=minutes(10)), NOW)
    state = class_overview(store, session.course.id)["students"][0]["links"][str(session.link.id)]
    assert (state["score"], state["extra_seconds"]) == (0.9, 600)


@pytest.mark.parametrize("listed", [True, False])
def test_extra_time_is_given_before_a_student_comes(store: Store, listed: bool) -> None:
    """The form was there, and answered that there was no such person."""
    session = joined(store)
    late = pseudonym(store, "https://lms.example.edu", "framewise", "late") if listed else ""
    if not listed:
        late = joined(store, "late", resource="another").person.key
    with pytest.raises(UnknownRecordError):
        allow(store, session.link, "f" * 32, Allowance(), NOW, [late])
    extra = Allowance(extra_time=minutes(30), extra_attempts=2)
    allow(store, session.link, late, extra, NOW, [late])
    overview = class_overview(store, session.course.id)
    told = next(each for each in overview["students"] if each["key"] == late)["links"][str(session.link.id)]
    assert (told["state"], told["extra_seconds"], told["extra_attempts"]) == ("absent", 1800, 2)
    assert next(each for each in overview["links"] if each["id"] == session.link.id)["absent"] == 1
    came = joined(store, "late")
    assert (came.person.key, came.allowance, came.person.subject) == (late, extra, "late")
    submitted(store, came, 0.5)
    overview = class_overview(store, session.course.id)
    told = next(each for each in overview["students"] if each["key"] == late)["links"][str(session.link.id)]
    assert (told["state"], told["extra_seconds"]) == ("begun", 1800)


def test_extra_time_derives_the_grade_of_no_other_student(
    store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The grades of the whole class were derived anew, while nobody could hand in on SQLite."""
    session, other = joined(store), joined(store, "another")
    for each in (session, other):
        submitted(store, each, 0.5)
    derived: list[int] = []
    monkeypatch.setattr(
        "courses.teaching.link_changes.regrade", lambda _, __, people, *___: derived.extend(people)
    )
    allow(store, session.link, session.person.key, Allowance(extra_time=minutes(10)), NOW)
    assert derived == [session.person.id]


def test_a_draft_comes_back_in_another_session(store: Store) -> None:
    keep_drafts(store, [(joined(store), {"table": ["?"]}), (joined(store), {"table": ["θ"]})], NOW)
    draft = standing_of(store, joined(store)).draft
    assert draft is not None
    assert (draft.state, draft.at) == ({"table": ["θ"]}, NOW)


def test_drafts_are_stored_in_the_order_in_which_who_hands_in_is_locked(store: Store) -> None:
    """In any other, two processes would each wait for a row that the other one has."""
    sessions = [joined(store, f"student-{i}") for i in range(3)]
    typed = [(sessions[i], {"table": [i, k]}) for k, i in enumerate((2, 0, 1, 2, 0))]
    stored: list[int] = []

    def note(_connection: Any, _cursor: Any, statement: str, rows: Any, _context: Any, _many: bool) -> None:
        if statement.startswith("UPDATE"):
            stored.extend(row["person"] if isinstance(row, dict) else row[-1] for row in rows)

    sa.event.listen(store.engine, "before_cursor_execute", note)
    assert keep_drafts(store, typed, NOW) == [None] * 5
    sa.event.remove(store.engine, "before_cursor_execute", note)
    assert stored == sorted(each.person.id for each in sessions)
    drafts = [standing_of(store, joined(store, f"student-{i}")).draft for i in range(3)]
    assert [draft and draft.state for draft in drafts] == [
        {"table": [i, k]} for i, k in ((0, 4), (1, 2), (2, 3))
    ]


def test_an_opening_reads_the_latest_attempts_without_their_reports(store: Store) -> None:
    """However many there are: students of a practice link hand in hundreds of times."""
    session = joined(store)
    count = LISTED + 10
    for number in range(count):
        submitted(store, session, 0.5 if number else 1.0, key=str(number), minutes=number)
    session = joined(store)
    asked: list[str] = []
    sa.event.listen(store.engine, "before_cursor_execute", lambda *told: asked.append(told[2]))
    standing = standing_of(store, session)
    assert [attempt.number for attempt in standing.latest] == list(range(count - LISTED + 1, count + 1))
    assert standing.grade == Counted(number=1, worth=1.0)
    assert asked
    assert not [text for text in asked if "report" in text or "answer" in text or "form" in text]


def test_who_signs_in_does_not_read_the_whole_class(tmp_path: Path) -> None:
    """The longest extra time of anybody in it comes from an index, whatever drafts its students keep."""
    store = open_store("", tmp_path)  # PostgreSQL's planner takes an index where a class is large enough
    joined(store)
    asked: list[tuple[str, Any]] = []
    sa.event.listen(store.engine, "before_cursor_execute", lambda *told: asked.append((told[2], told[3])))
    joined(store)
    statement, parameters = next((text, given) for text, given in asked if "max(" in text)
    with store.reading() as connection:
        plan = connection.exec_driver_sql(f"EXPLAIN QUERY PLAN {statement}", parameters).all()
    (class_,) = (row[3] for row in plan if " other " in row[3])
    store.close()
    assert "COVERING INDEX ix_participation_link_id_extra_seconds" in class_


def test_sessions_live_while_they_are_used(store: Store) -> None:
    token, _ = arrive(store, arrival(store), NOW)
    session_of(store, token, NOW + SESSION - minutes(1))
    session = session_of(store, token, NOW + 2 * SESSION - minutes(2))
    with pytest.raises(SessionError):
        session_of(store, token, NOW + 9 * SESSION)
    end_session(store, session.id)
    with pytest.raises(SessionError):
        session_of(store, token, NOW)


def test_sessions_end_a_day_after_the_last_launch(store: Store) -> None:
    """Who was no longer staff in the LMS stayed so here for as long as they used their session."""
    told = arrival(store, role=Role.STAFF)
    token, _ = arrive(store, told, NOW)
    for half in range(1, 24):
        assert session_of(store, token, NOW + half * SESSION / 2).role is Role.STAFF
    with pytest.raises(SessionError) as refused:
        session_of(store, token, NOW + timedelta(days=1))
    assert refused.value.faults[0].code == "session_expired"
    again, _ = arrive(store, told, NOW + timedelta(days=1))
    assert session_of(store, again, NOW + timedelta(days=1)).role is Role.STAFF


@pytest.mark.parametrize("status", [PlatformStatus.DISABLED, PlatformStatus.PENDING])
def test_sessions_end_while_their_platform_is_switched_off(store: Store, status: PlatformStatus) -> None:
    """They lived on for as long as they were used; who is signed in is still asked in one query."""
    told = arrival(store)
    token, _ = arrive(store, told, NOW)
    asked: list[str] = []
    sa.event.listen(store.engine, "before_cursor_execute", lambda *told: asked.append(told[2]))
    session_of(store, token, NOW)
    assert len(asked) == 1
    set_status(store, told.platform.id, status)
    with pytest.raises(SessionError) as refused:
        session_of(store, token, NOW + SESSION - minutes(1))
    assert refused.value.faults[0].code == "lti_platform_inactive"
    set_status(store, told.platform.id, PlatformStatus.ACTIVE)
    assert session_of(store, token, NOW + SESSION - minutes(1)).role is Role.LEARNER
    with pytest.raises(SessionError):
        session_of(store, token, NOW + 3 * SESSION)


def test_codes_and_nonces_work_once(store: Store) -> None:
    code = issue_code(store, "session", {"token": "t"}, NOW, minutes(1))
    with pytest.raises(SessionError):
        redeem_code(store, "other", code, NOW)
    assert redeem_code(store, "session", code, NOW) == {"token": "t"}
    with pytest.raises(SessionError):
        redeem_code(store, "session", code, NOW)
    known = platform(store).id
    assert remember_nonce(store, known, "n", NOW, minutes(10))
    assert not remember_nonce(store, known, "n", NOW, minutes(10))


def test_old_codes_and_nonces_are_deleted(store: Store) -> None:
    known = platform(store).id
    for at in (NOW, NOW + minutes(20)):
        issue_code(store, "session", {"token": "t"}, at, minutes(1))
        remember_nonce(store, known, at.isoformat(), at, minutes(10))
    with store.reading() as connection:
        for table in (records.one_time_code, records.nonce):
            assert len(connection.execute(sa.select(table)).all()) == 1


VERDICT = {
    "feedback": [{"code": "links_differ", "row": None}],
    "links": [{"row": 2, "length": "wrong", "twist": "ok", "offset": "ok", "joint": "ok"}],
    "repairs": [{"edits": [{"code": "sign_of_twist", "row": 2}]}],
}
WRONG = {"verdict": VERDICT, "parts": []}


def test_numbers_of_a_class(store: Store) -> None:
    ann, bob, eve = (joined(store, name) for name in ("ann", "bob", "eve"))
    submitted(store, ann, 0.5, key="1", report=WRONG)
    submitted(store, ann, 1.0, key="2", minutes=1)
    submitted(store, bob, 0.5, key="1", report=WRONG)
    submitted(store, bob, 0.5, key="2", report={"verdict": {**VERDICT, "repairs": []}})
    submitted(store, eve, 1.0, key="1")
    found = link_statistics(store, ann.link.id)
    assert (found["attempts"], found["students"], found["solved"]) == (5, 3, 2)
    assert found["first_attempt_rate"] == pytest.approx(1 / 3)
    assert found["sequence"] == [
        {"attempt": 1, "reached": 3, "solved": 1, "dropped_out": 0},
        {"attempt": 2, "reached": 2, "solved": 1, "dropped_out": 1},
    ]
    (found,) = misconceptions(store, ann.link.id)
    assert (found["code"], found["attempts"], found["students"]) == ("sign_of_twist", 2, 2)
    (cluster,) = unexplained(store, ann.link.id)
    assert cluster["facts"] == ["2:length"]
    assert behind(store, ann, code="sign_of_twist") == [("bob", 1), ("ann", 1)]
    assert behind(store, ann, ids=tuple(cluster["attempts"])) == [("bob", 2)]


RIGHT_TABLE = {"kind": "table", "score": 1.0, "feedback": []}


def test_right_tables_with_missing_parts_are_not_unexplained(store: Store) -> None:
    """Ann stops after a right table; Bob's pose is wrong without a reason, Eve's has a name."""
    told = {"verdict": {"feedback": [{"code": "proved", "row": None}], "links": []}, "missing": ["pose"]}
    wrong = {"kind": "pose", "score": 0.5}
    found = {
        "ann": [RIGHT_TABLE],
        "bob": [RIGHT_TABLE, {**wrong, "feedback": [{"code": "pose_rotation_right"}]}],
        "eve": [RIGHT_TABLE, {**wrong, "feedback": [{"code": "pose_degrees_as_radians"}]}],
        "max": [RIGHT_TABLE, {"kind": "pose", "score": 1.0, "feedback": [{"code": "pose_right"}]}],
    }
    for name, parts in found.items():
        submitted(store, joined(store, name), 0.6, report={**told, "parts": parts})
    session = joined(store, "ann")
    (cluster,) = unexplained(store, session.link.id)
    assert cluster["facts"] == [":pose"]
    assert behind(store, session, ids=tuple(cluster["attempts"])) == [("bob", 1)]
    (named,) = misconceptions(store, session.link.id)
    assert (named["kind"], named["code"]) == ("part:pose", "pose_degrees_as_radians")
    assert behind(store, session, kind=named["kind"], code=named["code"]) == [("eve", 1)]


def behind(store: Store, session: CourseSession, **asked: Any) -> list[tuple[str, int]]:
    """Who made the attempts behind a number, and which they were."""
    names = {pseudonym_of(store, name): name for name in ("ann", "bob", "eve", "max", "zoe")}
    found = attempts_behind(store, session.link.id, AttemptFilter(**asked))
    return [(names[each["key"]], each["number"]) for each in found]


def pseudonym_of(store: Store, name: str) -> str:
    return joined(store, name).person.key


def test_every_number_has_its_attempts(store: Store) -> None:
    """Ann solves it at once and goes on, Bob at the second; Eve gives up after one, Max after three."""
    scores = {"ann": (1.0, 0.0), "bob": (0.5, 1.0), "eve": (0.2,), "max": (0.1, 0.1, 0.3)}
    for name, made in scores.items():
        for number, score in enumerate(made):
            submitted(store, joined(store, name), score, key=str(number), minutes=number)
    session = joined(store, "zoe")
    keep_drafts(store, [(session, {"table": []})], NOW)
    counts = class_overview(store, session.course.id)["links"][0]
    states = {name: counts[name] for name in ("absent", "opened", "begun", "stuck", "solved")}
    assert states == {"absent": 0, "opened": 1, "begun": 1, "stuck": 1, "solved": 2}
    for progress in Progress:
        assert len(behind(store, session, progress=progress)) == counts[progress.value]
    found = link_statistics(store, session.link.id)
    assert len(behind(store, session)) == found["attempts"]
    assert len(behind(store, session, outcome=Outcome.SOLVED)) == found["solved"]
    for step in found["sequence"]:
        for outcome, name in zip(Outcome, ("reached", "solved", "dropped_out"), strict=True):
            assert len(behind(store, session, outcome=outcome, number=step["attempt"])) == step[name]
    (day,) = found["days"]
    assert len(behind(store, session, day=NOW.date(), correct=True)) == day["correct"] == 2
    assert behind(store, session, day=date.max) == []
    assert behind(store, session, number=1, correct=True) == [("ann", 1)]
    assert behind(store, session, progress=Progress.STUCK) == [("max", 3)]


def test_the_beginning_of_a_pseudonym_names_one_person(store: Store) -> None:
    people = {name: joined(store, name).person for name in ("ann", "bob")}
    for name, key in {"ann": "0123456789", "bob": "0123456788"}.items():
        with store.writing() as connection:
            own = sa.update(records.person).where(records.person.c.id == people[name].id)
            connection.execute(own.values(key=key))
    assert person_named(store, "0123456788") == "0123456788"
    with pytest.raises(UnknownRecordError) as refusal:
        person_named(store, "01234567")
    assert refusal.value.faults[0].params["kind"] == "several"


def test_a_person_is_exported_and_erased(store: Store) -> None:
    ann, bob = joined(store, "ann"), joined(store, "bob")
    submitted(store, ann, 0.5)
    submitted(store, bob, 0.5)
    found = export_person(store, ann.person.key)
    assert len(found["attempt"]) == len(found["score_to_send"]) == 1
    assert "token_hash" not in found["session"][0]
    assert erase_person(store, ann.person.key)["attempt"] == 1
    with pytest.raises(UnknownRecordError):
        export_person(store, ann.person.key)
    assert export_person(store, bob.person.key)["attempt"]


@pytest.mark.parametrize("in_one_course", [True, False])
def test_what_staff_has_tried_out_is_theirs(store: Store, in_one_course: bool) -> None:
    """What a teacher had handed in in a preview was in no export, and outlived the teacher's erasure."""
    tina = joined(store, "tina", role=Role.STAFF)
    course = tina.course.id if in_one_course else None
    tried = session_of(store, preview(store, tina, tina.link.id, NOW), NOW)
    submitted(store, tried, 0.5)
    assert len(export_person(store, tina.person.key, course)["attempt"]) == 1
    assert erase_person(store, tina.person.key, course)["attempt"] == 1
    with store.reading() as connection:
        assert connection.execute(sa.select(records.person)).all() == []


def test_a_grade_that_no_attempt_makes_any_more_is_no_grade(store: Store) -> None:
    """It stayed where an earlier deadline left no attempt in time, and its score went to the gradebook."""
    session = joined(store)
    submitted(store, session, 0.5, minutes=10)

    def close(at: datetime | None) -> tuple[Counted | None, list[float]]:
        rules = LinkSettings(exercise_id="puma560", policy=AttemptPolicy(closes=at))
        change_settings(store, session.link.id, rules, NOW)
        return standing_of(store, joined(store)).grade, [each.score for each in lease_scores(store, NOW, 10)]

    assert close(NOW + minutes(5)) == (None, [])
    assert close(NOW + minutes(15)) == (Counted(number=1, worth=0.5), [0.5])


def test_what_is_old_is_purged(store: Store) -> None:
    old = joined(store, "old")
    young = joined(store, "young", at=NOW + timedelta(days=300))
    removed = purge(store, NOW + timedelta(days=400), people=timedelta(days=365), log=timedelta(days=90))
    assert removed["people"] == 1
    assert export_person(store, young.person.key)
    with pytest.raises(UnknownRecordError):
        export_person(store, old.person.key)


def test_a_platform_that_is_removed_leaves_no_pseudonym(store: Store) -> None:
    """Those of its students and staff stayed in the log, as they do of nobody who is erased."""
    ann, tina = joined(store, "ann"), joined(store, "tina", role=Role.STAFF)
    log_access(store, tina, "person", NOW, subject=ann.person.key)
    log_access(store, tina, "overview", NOW)
    elsewhere = replace(tina, person=replace(tina.person, key="f" * 32))
    log_access(store, elsewhere, "overview", NOW)
    remove_platform(store, ann.person.platform_id)
    with store.reading() as connection:
        assert list(connection.scalars(sa.select(records.access.c.actor))) == ["f" * 32]
        assert not connection.scalar(sa.select(sa.func.count()).select_from(records.person))
    with pytest.raises(UnknownRecordError):
        remove_platform(store, ann.person.platform_id)


def test_codes_and_nonces_that_have_ended_are_purged(store: Store) -> None:
    """A launch that nobody went on with said who had wanted to come, until the next code was issued."""
    issue_code(store, "pending", {"launch": {"arrival": {"subject": "ann"}}}, NOW, minutes(2))
    issue_code(store, "session", {}, NOW + timedelta(days=1), minutes(2))
    remember_nonce(store, platform(store).id, "nonce", NOW, minutes(90))
    purge(store, NOW + timedelta(days=1), people=timedelta(days=365), log=timedelta(days=90))
    with store.reading() as connection:
        left = [
            connection.scalar(sa.select(sa.func.count()).select_from(table))
            for table in (records.one_time_code, records.nonce)
        ]
    assert left == [1, 0]


def test_names_are_forgotten_that_may_no_longer_be_stored(store: Store) -> None:
    """They stayed on the page of the class when the operator, or the platform, shared them no longer."""
    told = arrival(store, name="Ann Lee")
    unshared = told.platform
    shared = add_platform(store, replace(unshared, names_shared=True), (), NOW)

    def name_of(name: str | None) -> str | None:
        token, _ = arrive(store, replace(told, platform=shared, name=name), NOW)
        return session_of(store, token, NOW).person.name

    assert [name_of("Ann Lee"), name_of(None), name_of("Ann Lee")] == ["Ann Lee", None, "Ann Lee"]
    add_platform(store, unshared, (), NOW)
    with store.reading() as connection:
        assert connection.scalar(sa.select(records.person.c.name)) is None


def test_who_was_removed_or_came_back_meanwhile_does_not_end_a_purge(
    store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Another process purges, too: what was old when it was looked at may be gone or new."""
    ann, bob, max_ = (joined(store, name).person.key for name in ("ann", "bob", "max"))
    erase, later = privacy._erase, NOW + timedelta(days=400)

    def meanwhile(connection: sa.Connection, person_id: int, key: str, course_id: int | None) -> Any:
        monkeypatch.setattr(privacy, "_erase", erase)
        own = sa.update(records.person).where(records.person.c.key == bob)
        connection.execute(own.values(seen=later))
        connection.execute(sa.delete(records.person).where(records.person.c.key == max_))
        return erase(connection, person_id, key, course_id)

    monkeypatch.setattr(privacy, "_erase", meanwhile)
    assert purge(store, later, people=timedelta(days=365), log=timedelta(days=90))["people"] == 1
    assert [known(store, key) for key in (ann, bob, max_)] == [False, True, False]


def test_what_is_old_is_purged_every_day_without_being_told(store: Store) -> None:
    today = datetime.now(UTC)
    old = joined(store, "old", at=today - timedelta(days=5)).person.key
    young = joined(store, "young", at=today).person.key
    retention = Retention(store, people=timedelta(days=1), log=timedelta(days=1), first=0.01)
    retention.start()
    deadline = time.monotonic() + 300
    while known(store, old) and time.monotonic() < deadline:
        time.sleep(0.02)
    retention.stop()
    assert (known(store, old), known(store, young)) == (False, True)


def known(store: Store, key: str) -> bool:
    try:
        return bool(export_person(store, key))
    except UnknownRecordError:
        return False
