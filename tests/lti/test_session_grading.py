"""What a session's attempts are told, and how many there are, where the exercise says so."""

import asyncio
import threading
from collections.abc import Iterator, Sequence
from datetime import datetime
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
import sqlalchemy as sa

from courses.attempts.report_codes import path_of_codes
from courses.attempts.stored_attempts import Typed, keep_drafts, standing_of
from courses.attempts.submissions import JudgedSubmission
from courses.links.publications import MOST, publish
from courses.model import Attempt, CourseSession, LinkSettings
from courses.policies import AttemptPolicy
from courses.refusals import AttemptError, PublicationError, SessionError
from courses.storage import records
from courses.storage.database import Store, open_store
from courses.teaching.link_changes import change_settings
from exercises.grading import HelpLevel
from exercises.instance import cached_instance, generate
from exercises.library import Library
from kinematics.cells import DEFAULT
from service.course_resources import _DRAFTS_PAUSE, _LONGEST_PAUSE, _SESSIONS_PAUSE, CourseResources, now
from service.schemas.exercises.exercises import ExerciseAnswer
from service.settings import Settings
from service.work.session_grading import Grader, judged_submission, with_exercise_rules
from tests.courses.classroom import attempts_of, handed_in, joined
from tests.exercises.folders import TWO_LINKS, changed, draft_of, folder

RULES = """
[access]
attempts = 4

[help]
ladder = ["verdict", "row", "repair"]
"""
ROW = {"theta": "q1", "d": "0", "a": "9", "alpha": "0"}
WRONG = {"table": {"convention": "standard", "angle_unit": "deg", "rows": [ROW, {**ROW, "theta": "q2"}]}}


@pytest.fixture
def store(tmp_path: Path) -> Iterator[Store]:
    opened = open_store("", tmp_path / "data")
    yield opened
    opened.close()


@pytest.fixture
def grader(tmp_path: Path) -> Grader:
    folder(tmp_path, TWO_LINKS + RULES)
    return Grader(library=Library((tmp_path,)), limits=DEFAULT)


def come(store: Store, grader: Grader, **settings: Any) -> CourseSession:
    """A session of the ladder's exercise, by the rules of a link."""
    link = joined(store, at=now(), exercise_id="two").link
    change_settings(store, link.id, LinkSettings(exercise_id="two", **settings), now())
    return with_exercise_rules(grader.library, joined(store, at=now(), exercise_id="two"))


def wrong(store: Store, grader: Grader, session: CourseSession, **more: Any) -> HelpLevel:
    """How much a wrong answer was told."""
    typed = {**WRONG, **more}
    wire = ExerciseAnswer.model_validate(typed)
    judged, found = judged_submission(grader, session, wire, typed, None, "en", now())
    handed_in(store, judged, now())
    assert not found.correct
    return found.help_level


def test_each_attempt_is_told_what_the_ladder_says(store: Store, grader: Grader) -> None:
    told = [wrong(store, grader, come(store, grader)) for _ in range(4)]
    assert told == [HelpLevel.VERDICT, HelpLevel.ROW, HelpLevel.REPAIR, HelpLevel.REPAIR]


def test_the_number_that_an_answer_claims_counts_for_nothing(store: Store, grader: Grader) -> None:
    assert wrong(store, grader, come(store, grader), attempt=3) is HelpLevel.VERDICT


def test_the_link_holds_help_back_and_never_gives_more(store: Store, grader: Grader) -> None:
    told = [wrong(store, grader, come(store, grader, help="row")) for _ in range(3)]
    assert told == [HelpLevel.VERDICT, HelpLevel.ROW, HelpLevel.ROW]


def test_judging_again_finds_the_codes_that_were_stored(store: Store, grader: Grader) -> None:
    """However much each attempt was told."""
    for _ in range(3):
        wrong(store, grader, come(store, grader))
    session = come(store, grader)
    attempts = attempts_of(store, session)
    again = grader.rejudge(attempts, session.link.settings)
    assert [(item.attempt_id, item.score, item.correct) for item in again] == [
        (attempt.id, attempt.score, attempt.correct) for attempt in attempts
    ]
    with store.reading() as connection:
        found = connection.execute(sa.select(records.finding).order_by(records.finding.c.position)).all()
    for item in again:
        assert any(kind == "repair" for kind, _, _ in item.path)
        assert [(row.kind, row.code, row.row) for row in found if row.attempt_id == item.attempt_id] == list(
            item.path
        )


@pytest.fixture
def varied(tmp_path: Path) -> Grader:
    """Judges an exercise with two sets of values whose first attempt is told a verdict alone."""
    folder(tmp_path, TWO_LINKS + RULES.replace("[help]", "variants = 2\n\n[help]"))
    return Grader(library=Library((tmp_path,)), limits=DEFAULT)


def measured(grader: Grader, seed: str) -> dict[str, Any]:
    """An answer in a student's values, with the length of the second row in centimetres."""
    given = cached_instance(grader.library.exercise("two"), seed).parameters
    rows = [
        {**ROW, "theta": "q1", "a": str(given["L1"])},
        {**ROW, "theta": "q2", "a": str(100 * given["L2"])},
    ]
    return {"table": {"convention": "standard", "angle_unit": "deg", "rows": rows}}


@pytest.mark.parametrize("seed", ["1", "2"])
def test_statistics_and_judging_again_keep_the_values_of_a_variant(varied: Grader, seed: str) -> None:
    """Whoever is given one of two sets of values is judged by these, however much may be told."""
    settings, answer = LinkSettings(exercise_id="two"), measured(varied, seed)
    judged = varied.judge(settings, seed, ExerciseAnswer.model_validate(answer), 1)
    (again,) = varied.rejudge([stored(answer, seed, judged.report)], settings)
    path = tuple(path_of_codes(judged.analysis))
    assert [entry for entry in path if entry[0] == "repair"] == [("repair", "cell_length_unit", 2)]
    assert (again.score, again.correct, again.path) == (judged.score, False, path)


def stored(answer: dict[str, Any], seed: str, report: dict[str, Any]) -> Attempt:
    """An attempt as it comes from the database."""
    return Attempt(
        link_id=1,
        person_id=1,
        key="k",
        at=now(),
        exercise_id="two",
        version="1",
        seed=seed,
        language="en",
        answer=answer,
        report=report,
        score=1.0,
        correct=True,
    )


def test_attempts_are_the_exercises_unless_the_link_says_otherwise(store: Store, grader: Grader) -> None:
    for _ in range(4):
        wrong(store, grader, come(store, grader))
    with pytest.raises(AttemptError, match="attempts_used"):
        wrong(store, grader, come(store, grader))
    wrong(store, grader, come(store, grader, policy=AttemptPolicy(attempts=5)))


def test_a_mended_exercise_is_another_version_and_the_old_one_stays(tmp_path: Path) -> None:
    courses = CourseResources(Settings(storage="on", data_folder=tmp_path / "data"))
    versions = []
    for text in (TWO_LINKS, TWO_LINKS, changed("L1.value = 0.5", "L1.value = 0.6")):
        folder(tmp_path / "own", text)
        library = Library((tmp_path / "own",), courses.published)
        grader = Grader(library=library, limits=DEFAULT, edition=courses.edition)
        courses._editions.clear()  # a new process reads the folder anew
        session = joined(courses.store, at=now(), exercise_id="two")
        typed = {"table": {**WRONG["table"]}}
        judged, _ = judged_submission(
            grader, session, ExerciseAnswer.model_validate(typed), typed, None, "en", now()
        )
        versions.append(handed_in(courses.store, judged, now()).version)
    first, same, mended = versions
    assert first == same != mended
    values = [generate(library.exercise(version), None).parameters["L1"] for version in (first, mended)]
    assert values == [0.5, 0.6]
    courses.close()


def test_what_strangers_have_published_keeps_no_course_from_its_exercise(tmp_path: Path) -> None:
    """As many as may be: an exercise that nobody had opened before could not be handed in any more."""
    courses = CourseResources(Settings(storage="on", data_folder=tmp_path / "data"))
    folder(tmp_path / "own", TWO_LINKS)
    rows = [{"address": f"x-{i}", "digest": "", "content": "{}", "published": now()} for i in range(MOST)]
    with courses.store.writing() as connection:
        connection.execute(sa.insert(records.publication), rows)
    draft = draft_of(tmp_path / "own" / "two")
    with pytest.raises(PublicationError):
        publish(courses.store, draft, now())
    library = Library((tmp_path / "own",), courses.published)
    grader = Grader(library=library, limits=DEFAULT, edition=courses.edition)
    session = joined(courses.store, at=now(), exercise_id="two")
    judged, _ = judged_submission(
        grader, session, ExerciseAnswer.model_validate(WRONG), WRONG, None, "en", now()
    )
    assert courses.published(handed_in(courses.store, judged, now()).version) is not None
    courses.close()


def test_drafts_that_come_close_together_share_a_transaction(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each transaction keeps those waiting who hand in; nobody waits for a draft to be stored."""
    courses = CourseResources(Settings(storage="on", data_folder=tmp_path / "data"))
    sessions = [joined(courses.store, f"student-{n}", at=now()) for n in range(5)]
    stored: list[Sequence[Typed]] = []
    all_came = threading.Event()

    def keep(store: Store, typed: Sequence[Typed], at: datetime) -> list[None]:
        stored.append(typed)
        return keep_drafts(store, typed, at)

    async def typing() -> None:
        kept = [asyncio.ensure_future(courses.keep_draft((each, {"n": each.person.id}))) for each in sessions]
        await asyncio.sleep(0)
        all_came.set()
        await asyncio.gather(*kept)

    pauses: list[float] = []

    def sleep(seconds: float) -> None:
        pauses.append(seconds)
        assert all_came.wait(60)

    monkeypatch.setattr("service.course_resources.keep_drafts", keep)
    monkeypatch.setattr("service.work.batcher.time", SimpleNamespace(sleep=sleep))
    asyncio.run(typing())
    assert [len(each) for each in stored] == [5]
    assert pauses == [_DRAFTS_PAUSE]
    again = [joined(courses.store, f"student-{n}", at=now()) for n in range(5)]
    drafts = [standing_of(courses.store, each).draft for each in again]
    assert [draft and draft.state for draft in drafts] == [{"n": each.person.id} for each in sessions]
    courses.close()


@pytest.mark.parametrize(("waiting", "pause"), [(0, []), (10, [0.05]), (1000, [_LONGEST_PAUSE])])
def test_the_more_wait_to_be_judged_the_longer_judged_answers_are_gathered(
    tmp_path: Path, grader: Grader, monkeypatch: pytest.MonkeyPatch, waiting: int, pause: list[float]
) -> None:
    """Whoever waits behind many loses nothing by it, and a transaction costs as much as some judgements."""
    settings = Settings(storage="on", data_folder=tmp_path / "data")
    courses = CourseResources(settings, answers_waiting=lambda: waiting)
    session = joined(courses.store, at=now(), exercise_id="two")
    pauses: list[float] = []
    monkeypatch.setattr("service.work.batcher.time", SimpleNamespace(sleep=pauses.append))
    wire = ExerciseAnswer.model_validate(WRONG)
    judged, _ = judged_submission(grader, session, wire, WRONG, None, "en", now())
    assert asyncio.run(keep(courses, judged)).number == 1
    assert pauses == pytest.approx(pause)
    courses.close()


async def keep(courses: CourseResources, judged: JudgedSubmission) -> Attempt:
    return await courses.keep(judged)


@pytest.mark.parametrize(("is_busy", "pause"), [(False, []), (True, [_SESSIONS_PAUSE])])
def test_people_are_looked_up_together_only_while_many_ask(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, is_busy: bool, pause: list[float]
) -> None:
    settings = Settings(storage="on", data_folder=tmp_path / "data")
    courses = CourseResources(settings, is_busy=lambda: is_busy)
    pauses: list[float] = []
    monkeypatch.setattr("service.work.batcher.time", SimpleNamespace(sleep=pauses.append))
    with pytest.raises(SessionError):
        asyncio.run(courses.signed_in("nobody's"))
    assert pauses == pause
    courses.close()
