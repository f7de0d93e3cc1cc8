"""Judging what a signed-in student hands in: stored before it is answered."""

import secrets
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import datetime
from functools import lru_cache
from typing import Any

import orjson
from pydantic import ValidationError

from courses.attempts.report_codes import path_of_codes
from courses.attempts.stored_attempts import check_open
from courses.attempts.submissions import JudgedSubmission
from courses.model import Attempt, CourseSession, LinkSettings
from courses.refusals import AttemptError, NoExerciseError
from courses.storage.column_types import WrittenJson
from courses.teaching.regrading import Rejudged
from exercises.access import ExerciseAccess, lowest
from exercises.answers import parse
from exercises.definition import Exercise
from exercises.departure import departure_of
from exercises.errors import ExerciseError, UnknownExerciseError
from exercises.grader import Report, grade
from exercises.grading import HelpLevel
from exercises.instance import Instance, cached_instance
from exercises.library import Library
from exercises.parts.protocol import Answer, RawAnswer
from kinematics.cells import Limits
from kinematics.errors import Fault, KinematicsError
from service.revision import revision
from service.schemas.exercises.exercises import AnswerBase, ExerciseAnswer
from service.wire.courses.session_views import seed_of
from service.wire.exercises.verdicts import encoded, restored


@dataclass(frozen=True, kw_only=True, slots=True)
class SessionJudgement:
    """What was found of an answer: told now, as far as its student may be told, and all of it."""

    found: Report
    report: dict[str, Any]
    analysis: dict[str, Any]
    score: float
    correct: bool
    version: str


@dataclass(frozen=True, kw_only=True, slots=True)
class Grader:
    """Judges answers to the exercises of links, for students and for statistics.

    Attributes:
        limits: how large an answer may be.
        edition: tells the address of an exercise's content; None where nothing is kept.
        is_crowded: whether so many answers wait that nobody looks where the robot of a wrong one departs.
    """

    library: Library
    limits: Limits
    edition: Callable[[Library, str], str] | None = None
    is_crowded: Callable[[], bool] = bool

    def version(self, settings: LinkSettings) -> str:
        """Return what the exercise of a link is now: an address made from its content, else its number.

        Raises:
            NoExerciseError: none has been chosen.
        """
        asked = asked_exercise(self.library, settings)
        return self.edition(self.library, asked.id) if self.edition else str(asked.version)

    def basis(self, settings: LinkSettings) -> str:
        """Return what a judgement made now depends on, besides the attempt: content, parts asked, program.

        Raises:
            NoExerciseError: none has been chosen.
        """
        return " ".join((self.version(settings), ",".join(sorted(settings.parts)), revision()[:16]))

    def judge(
        self, settings: LinkSettings, seed: str | None, wire: AnswerBase, attempt: int
    ) -> SessionJudgement:
        """Judge an answer.

        The exercise's help ladder goes by `attempt`, from 1, whatever the answer says of it.

        Raises:
            KinematicsError, ExerciseError: it cannot be graded.
        """
        asked = asked_exercise(self.library, settings)
        instance = cached_instance(asked, seed)
        answer = parse(instance, wire.raw(), self.limits)
        level = wire.help if settings.help is None else HelpLevel(settings.help)
        report = grade(instance, answer, level, attempt, drawn=not self.is_crowded())
        stored = analysis = _as_stored(report)
        if report.help_level is not HelpLevel.REPAIR and not report.correct:
            analysis = _as_stored(grade(cached_instance(_open(asked), seed), answer, drawn=False))
        return SessionJudgement(
            found=report,
            report=stored,
            analysis=analysis,
            score=report.score,
            correct=report.correct and not report.missing,
            version=self.version(settings),
        )

    def with_departure(self, attempt: Attempt, settings: LinkSettings) -> Attempt:
        """Return an attempt that tells where its robot departs, if nobody looked when it was judged."""
        told = restored(attempt.report)
        if told.verdict is None or not tells_departure_later(told):
            return attempt
        question = self.question(attempt, settings)
        if (
            question is None
            or self.version(replace(settings, exercise_id=attempt.exercise_id)) != attempt.version
        ):
            return attempt
        instance = cached_instance(question[0], attempt.seed)
        read = _read_again(instance, attempt.answer, self.limits)
        if read is None or read.table is None:
            return attempt
        departure = departure_of(instance, read.table, told.verdict)
        return replace(attempt, report={**attempt.report, "departure": departure})

    def rejudge(self, attempts: Sequence[Attempt], settings: LinkSettings) -> list[Rejudged]:
        """Judge stored attempts by the exercise as it is now."""
        found = []
        for attempt in attempts:
            question = self.question(attempt, settings)
            judged = UNREAD if question is None else _judged_again(self.limits, *question)
            found.append(replace(judged, attempt_id=attempt.id))
        return found

    def question(self, attempt: Attempt, settings: LinkSettings) -> tuple[Exercise, str | None, bytes] | None:
        """Return all that the judgement of a stored attempt depends on; None if its exercise is gone."""
        try:
            asked = asked_exercise(self.library, replace(settings, exercise_id=attempt.exercise_id))
        except ExerciseError:
            return None
        return asked, attempt.seed, orjson.dumps(attempt.answer)


def tells_departure_later(report: Report) -> bool:
    """Return whether where the robot of a wrong table departs may be told, and has not been."""
    is_wrong = report.verdict is not None and not report.verdict.correct
    tells = lowest((report.help_level, HelpLevel.KIND)) is HelpLevel.KIND
    return is_wrong and tells and report.departure is None


def _as_stored(report: Report) -> dict[str, Any]:
    text = encoded(report)
    return WrittenJson(orjson.loads(text), text.decode())


UNREAD = Rejudged(attempt_id=0, score=None)
"""What is said of an answer that the exercise as it is now cannot read."""


@lru_cache(maxsize=4096)
def _judged_again(limits: Limits, asked: Exercise, seed: str | None, answer: bytes) -> Rejudged:
    """Many students hand in the same answer: it is judged once, and nothing is drawn or put into words."""
    instance = cached_instance(_open(asked), seed)
    read = _read_again(instance, orjson.loads(answer), limits)
    if read is None:
        return UNREAD
    report = grade(instance, read, drawn=False)
    return Rejudged(
        attempt_id=0,
        score=report.score,
        correct=report.correct and not report.missing,
        path=tuple(path_of_codes(_as_stored(report))),
    )


def _read_again(instance: Instance, answer: Mapping[str, Any], limits: Limits) -> Answer | None:
    """Read a stored answer, without parts that are no longer asked; None where it can't be read any more."""
    try:
        wire: AnswerBase = ExerciseAnswer.model_validate(answer)
        raw = RawAnswer(**{part.kind: wire.raw().get(part.kind) for part in instance.exercise.parts})
        return parse(instance, raw, limits)
    except (ValidationError, KinematicsError, ExerciseError):
        return None


@lru_cache(maxsize=256)
def _open(exercise: Exercise) -> Exercise:
    """Return an exercise that tells everything; its students keep their values."""
    return replace(exercise, access=replace(exercise.access, ladder=ExerciseAccess().ladder))


def asked_exercise(library: Library, settings: LinkSettings) -> Exercise:
    """Return the exercise of a link, with the parts that the link asks.

    Raises:
        NoExerciseError: none has been chosen.
    """
    if settings.exercise_id is None:
        raise NoExerciseError
    return _with_parts(library.exercise(settings.exercise_id), settings.parts)


def with_exercise_rules(library: Library, session: CourseSession) -> CourseSession:
    """Return a session with as many attempts as its link says, else as its exercise says."""
    settings = session.link.settings
    if settings.exercise_id is None or settings.policy.attempts is not None:
        return session
    try:
        attempts = library.exercise(settings.exercise_id).access.attempts
    except UnknownExerciseError:  # removed since the link chose it; whoever asks for it is told
        return session
    if attempts is None:
        return session
    ruled = replace(settings, policy=replace(settings.policy, attempts=attempts))
    return replace(session, link=replace(session.link, settings=ruled))


@lru_cache(maxsize=256)
def _with_parts(found: Exercise, kinds: tuple[str, ...]) -> Exercise:
    chosen = tuple(part for part in found.parts if part.kind in kinds)
    return replace(found, parts=chosen) if chosen else found


def judged_submission(
    grader: Grader,
    session: CourseSession,
    wire: AnswerBase,
    typed: Any,
    key: str | None,
    language: str,
    arrived: datetime,
    form: Any = None,
    seen: str | None = None,
) -> tuple[JudgedSubmission, Report]:
    """Judge an answer, to be stored; an answer that cannot be graded is refused and costs nothing.

    Args:
        typed: the answer as it was sent.
        key: names the submission, however often it is sent.
        arrived: when it came, however long it has waited since.
        form: what the page takes back when the attempt is opened again.
        seen: version of the exercise that the student has before them; None: they did not say.

    Raises:
        AttemptError: the policy takes no attempt now, or exercise or values are others than the student sees.
        KinematicsError, ExerciseError: the answer cannot be graded.
    """
    settings, seed = session.link.settings, seed_of(session)
    check_open(session, arrived)
    others = "seed" in wire.model_fields_set and wire.seed != seed
    if others or (seen is not None and seen != grader.version(settings)):
        raise AttemptError(Fault.at("exercise_changed"))
    judged = grader.judge(settings, seed, wire, session.made + 1)
    attempt = Attempt(
        link_id=session.link.id,
        person_id=session.person.id,
        key=key or secrets.token_hex(16),
        at=arrived,
        exercise_id=settings.exercise_id or "",
        version=judged.version,
        seed=seed,
        language=language,
        answer=typed,
        form=form if isinstance(form, dict) else None,
        report=judged.report,
        score=judged.score,
        correct=judged.correct,
    )
    return JudgedSubmission(session=session, attempt=attempt, analysis=judged.analysis), judged.found
