"""PrairieLearn's external grader: /grade/data/data.json in, /grade/results/results.json out."""

import json
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

from kinematics.errors import Fault
from service.adapters.hosts.assignment import Assignment
from service.adapters.judging import JudgedAnswer, NotGraded
from service.http.decoding import decode_json
from service.http.problems import ServiceError
from service.messages import languages

ROOT = Path("/grade")


def run(assignment: Assignment, source: Path | None = None) -> None:
    """Grade a submission, and write PrairieLearn's results file.

    The question's `params.framewise` may name exercise, seed and language; the table is the submitted answer
    `table` (as `pl-dh-table` leaves it), or else a file in the student's workspace.
    """
    root = source or ROOT
    data = json.loads((root / "data" / "data.json").read_text(encoding="utf-8"))
    target = root / "results" / "results.json"
    target.parent.mkdir(parents=True, exist_ok=True)
    asked = (data.get("params") or {}).get("framewise") or {}
    assignment = _as_asked(assignment, asked)
    judged = _graded(assignment, data, root, asked.get("seed"))
    target.write_text(json.dumps(results_of(judged, assignment)), encoding="utf-8")


def results_of(judged: JudgedAnswer | NotGraded, assignment: Assignment) -> dict[str, Any]:
    """Return the results document; what cannot be graded costs no attempt."""
    if isinstance(judged, NotGraded):
        return {"gradable": False, "format_errors": list(judged.sentences(assignment.language))}
    tests = [
        {
            "name": kind,
            "points": part["points"],
            "max_points": part["max_points"],
            "message": " ".join(entry["message"] for entry in part["feedback"]),
        }
        for kind, part in judged.body["parts"].items()
    ]
    return {"gradable": True, "score": judged.score, "message": " ".join(judged.sentences()), "tests": tests}


def _as_asked(assignment: Assignment, asked: Mapping[str, Any]) -> Assignment:
    """Return an assignment with the exercise and the language that a question names."""
    language = asked.get("language")
    return replace(
        assignment,
        exercise=assignment.exercise or asked.get("exercise"),
        language=language if language in languages() else assignment.language,
    )


def _graded(
    assignment: Assignment, data: Mapping[str, Any], root: Path, asked_seed: object
) -> JudgedAnswer | NotGraded:
    seed = None if asked_seed is None else str(asked_seed)
    submitted = (data.get("submitted_answers") or {}).get("table")
    typed = submitted.encode("utf-8", "replace") if isinstance(submitted, str) else b""
    with suppress(ServiceError):
        submitted = decode_json(typed)
    if isinstance(submitted, Mapping):
        answer = {"table": submitted} if "rows" in submitted else submitted
        return assignment.grade_table(answer, seed)
    if typed.strip():
        return assignment.grade_text(typed, seed)
    if not (root / "student").is_dir():
        return NotGraded(faults=(Fault.at("file_without_table", file="student"),))
    return assignment.grade_path(root / "student")
