"""Gradescope: /autograder/submission/ in, /autograder/results/results.json out."""

import json
from pathlib import Path
from typing import Any

from service.adapters.hosts.assignment import Assignment
from service.adapters.judging import JudgedAnswer, NotGraded

ROOT = Path("/autograder")


def run(assignment: Assignment, source: Path | None = None) -> None:
    """Grade what a student uploaded, and write Gradescope's results file."""
    root = source or ROOT
    results = results_of(assignment.grade_path(root / "submission"), assignment)
    target = root / "results" / "results.json"
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(json.dumps(results, ensure_ascii=False, indent=1), encoding="utf-8")


def results_of(judged: JudgedAnswer | NotGraded, assignment: Assignment) -> dict[str, Any]:
    """Return the results document: a score, and a test for each part."""
    if isinstance(judged, NotGraded):
        return {
            "score": 0,
            "output": "\n".join(judged.sentences(assignment.language)),
            "output_format": "text",
            "visibility": "visible",
        }
    points, most = assignment.worth(judged)
    tests = [
        {
            "name": kind,
            "score": round(most * part["points"] / judged.max_points, 4),
            "max_score": round(most * part["max_points"] / judged.max_points, 4),
            "status": "passed" if part["correct"] else "failed",
            "output": "\n".join(entry["message"] for entry in part["feedback"]),
        }
        for kind, part in judged.body["parts"].items()
    ]
    return {
        "score": round(points, 4),
        "output": "\n".join(judged.sentences()),
        "output_format": "text",
        "visibility": "visible",
        "tests": tests,
    }
