"""µEd 0.1.0: a platform's evaluation request as one of our answers, and our judgement as its feedback."""

from collections.abc import Mapping
from contextlib import suppress
from typing import Any

from exercises.grading import HelpLevel
from exercises.library import Library
from kinematics.errors import Fault
from service.adapters.judging import (
    JudgedAnswer,
    NotGraded,
    exercise_named,
    judge,
    told_fault,
    with_joint_types,
)
from service.http.decoding import decode_json
from service.http.negotiation import preferred_language
from service.http.problems import ServiceError
from service.messages import DEFAULT_LANGUAGE, languages, sentence
from service.schemas.exercises.evaluation import EvaluateRequest, SubmissionType

VERSION = "0.1.0"
TABLE_FORMAT = "dh_table"
ANSWER_FORMAT = "exercise_answer"
_NAMES_EXERCISE = "exercise"  # Member that may name the exercise, of the task's metadata and of the content.
EVALUATED = (SubmissionType.MODEL, SubmissionType.OTHER)
_DETAIL = {"BRIEF": HelpLevel.ROW, "MEDIUM": HelpLevel.KIND, "DETAILED": HelpLevel.REPAIR}

_FACTS = {
    "twist_wrong": "twist",
    "length_wrong": "length",
    "offset_wrong": "offset",
    "joint_type_wrong": "joint",
}
"""The facts of a row that feedback speaks of, by its code."""


class NotEvaluatedError(Exception):
    """A request that µEd answers with 400: the code, and what would be right."""

    def __init__(self, fault: Fault) -> None:
        super().__init__(str(fault))
        self.fault = fault


def language_wanted(request: EvaluateRequest, accept_language: str | None) -> str:
    """Return the language of the feedback: the learner's, or else the caller's, or else English."""
    wanted = (request.user.language if request.user else None) or accept_language
    return preferred_language(wanted, languages()) if wanted else DEFAULT_LANGUAGE


def evaluate(request: EvaluateRequest, language: str, library: Library) -> list[dict[str, Any]]:
    """Evaluate a submission.

    Raises:
        NotEvaluatedError: it names no exercise, or is nothing that is evaluated here.
        UnknownExerciseError: there is no such exercise.
    """
    answer = judged(request, language, library)
    if is_check(request):
        return checked(answer, language)
    return feedback_of(answer, request.submission.type, language)


def judged(request: EvaluateRequest, language: str, library: Library) -> JudgedAnswer | NotGraded:
    """Judge a submission; a check before it is final is judged without being explained.

    Raises:
        NotEvaluatedError: it names no exercise, or is nothing that is evaluated here.
        UnknownExerciseError: there is no such exercise.
    """
    submission = request.submission
    if submission.type not in EVALUATED:
        known = tuple(kind.value for kind in EVALUATED)
        raise NotEvaluatedError(Fault.at("artefact_unknown", type=submission.type.value, known=known))
    content = _model(submission.content)
    exercise_id = _exercise(request, content, library)
    answer = _answer(content)
    if isinstance(answer.get("table"), Mapping):
        answer["table"] = with_joint_types(exercise_id, answer["table"], library)
    seed = (request.task.metadata or {}).get("seed") if request.task else None
    if seed is not None:
        answer["seed"] = str(seed)
    detail = request.user.detail if request.user else None
    if detail in _DETAIL:
        answer["help"] = _DETAIL[detail].value
    if is_check(request):
        answer["help"] = HelpLevel.VERDICT.value
    return judge(exercise_id, answer, language, library)


def is_check(request: EvaluateRequest) -> bool:
    """Return whether only a check is asked for, before the submission is final."""
    return bool(request.pre_submission_feedback and request.pre_submission_feedback.enabled)


def _model(content: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return what content holds: as it stands, or where µEd puts a model, as an object or text."""
    for member in ("model", "value"):
        held = content.get(member)
        if isinstance(held, str):
            with suppress(ServiceError):
                held = decode_json(held.encode("utf-8", "replace"))
        if isinstance(held, Mapping):
            return {_NAMES_EXERCISE: content.get(_NAMES_EXERCISE), **held}
    return content


def _answer(content: Mapping[str, Any]) -> dict[str, Any]:
    """Return the answer in content: a table alone, or the parts of an exercise."""
    answer = {name: value for name, value in content.items() if name != _NAMES_EXERCISE}
    return {"table": answer} if "rows" in answer else answer


def checked(judged: JudgedAnswer | NotGraded, language: str) -> list[dict[str, Any]]:
    """Return whether an answer could be graded, and nothing of whether it is right."""
    if isinstance(judged, NotGraded):
        return _refusals(judged, language)
    title = sentence(language, "evaluation-readable") or ""
    return [{"feedbackId": "readable", "title": title, "message": title}]


def feedback_of(
    judged: JudgedAnswer | NotGraded, kind: SubmissionType, language: str
) -> list[dict[str, Any]]:
    """Return µEd's feedback: first the outcome with all points, then what is said of rows and cells."""
    if isinstance(judged, NotGraded):
        return _refusals(judged, language)
    title = sentence(language, "evaluation-right" if judged.correct else "evaluation-wrong") or ""
    entries: list[dict[str, Any]] = [
        {
            "feedbackId": "verdict",
            "title": title,
            "message": " ".join(judged.sentences()) or title,
            "awardedPoints": judged.points,
        }
    ]
    for number, entry in enumerate(judged.body["feedback"], 1):
        title = _title("table", entry, language)
        entries.append(_entry(f"feedback-{number}", title, entry, kind))
    repairs = judged.body["repairs"][:1]
    for number, edit in enumerate((edit for repair in repairs for edit in repair["edits"]), 1):
        title = sentence(language, f"option-{edit['code']}") or _title("table", edit, language)
        entries.append({**_entry(f"repair-{number}", title, edit, kind), "suggestedAction": edit["message"]})
    for part, report in judged.body["parts"].items():
        for number, entry in enumerate(report["feedback"], 1):
            entries.append(_entry(f"{part}-{number}", _title(part, entry, language), entry, kind))
    return entries


def _title(part: str, entry: Mapping[str, Any], language: str) -> str:
    """What feedback is about, in few words: the part of the exercise, and in a table the row and the fact."""
    about = sentence(language, f"form-part-{part.replace('_', '-')}") or part
    if entry["row"] is None:
        return about
    fact = _FACTS.get(entry["code"])
    name = sentence(language, f"form-fact-{fact}") if fact else None
    place = sentence(language, "form-row-cell" if name else "form-row", {"row": entry["row"], "name": name})
    return f"{about} · {place}"


def _entry(identifier: str, title: str, entry: Mapping[str, Any], kind: SubmissionType) -> dict[str, Any]:
    told: dict[str, Any] = {"feedbackId": identifier, "title": title, "message": entry["message"]}
    if entry["row"] is not None:
        column = {"column": entry["cell"]} if entry.get("cell") else {}
        locator = {"type": "cell" if column else "row", "row": entry["row"], **column}
        told["target"] = {"artefactType": kind.value, "format": TABLE_FORMAT, "locator": locator}
    return told


def _refusals(judged: NotGraded, language: str) -> list[dict[str, Any]]:
    title = sentence(language, "evaluation-unreadable") or ""
    return [
        {"feedbackId": f"fault-{number}", "title": title, "message": told_fault(fault, language)}
        for number, fault in enumerate(judged.faults, 1)
    ]


def _exercise(request: EvaluateRequest, content: Mapping[str, Any], library: Library) -> str:
    """Return the exercise that a request means; a platform has ids of its own, so any member may name it."""
    task = request.task
    candidates = (
        (task.metadata or {}).get(_NAMES_EXERCISE) if task else None,
        task.task_id if task else None,
        request.submission.task_id,
        content.get(_NAMES_EXERCISE),
    )
    for candidate in candidates:
        if isinstance(candidate, str) and (found := exercise_named(candidate, library)):
            return found
    raise NotEvaluatedError(Fault.at("exercise_not_named"))
