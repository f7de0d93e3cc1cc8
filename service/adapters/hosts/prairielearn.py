"""PrairieLearn's external grader: /grade/data/data.json in, /grade/results/results.json out."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from service.adapters.hosts.assignment import Assignment
from service.adapters.judging import JudgedAnswer, NotGraded

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
    target.write_text(json.dumps(results_of(_graded(assignment, data, root), assignment)), encoding="utf-8")


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


def _graded(assignment: Assignment, data: Mapping[str, Any], root: Path) -> JudgedAnswer | NotGraded:
    params = data.get("params") or {}
    asked = params.get("framewise") or {}
    submitted = (data.get("submitted_answers") or {}).get("table")
    if isinstance(submitted, str):
        submitted = json.loads(submitted)
    if not isinstance(submitted, Mapping):
        return assignment.grade_path(root / "student")
    exercise = assignment.exercise or asked.get("exercise")
    answer = {"table": submitted} if "rows" in submitted else dict(submitted)
    return assignment.grade_table({**answer, "exercise": exercise}, seed=asked.get("seed"))
