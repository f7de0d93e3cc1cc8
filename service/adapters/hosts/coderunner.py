"""Moodle's CodeRunner: the answer on standard input, a template grader's JSON on standard output."""

import json
import sys
from html import escape
from pathlib import Path
from typing import Any

from service.adapters.hosts.assignment import Assignment
from service.adapters.judging import JudgedAnswer, NotGraded


def run(assignment: Assignment, source: Path | None = None) -> None:
    """Grade what stands on standard input (JSON, or a table with a header row), and print the outcome."""
    text = sys.stdin.buffer.read() if source is None else source.read_bytes()
    outcome = outcome_of(assignment.grade_text(text), assignment)
    sys.stdout.write(json.dumps(outcome, ensure_ascii=False) + "\n")


def outcome_of(judged: JudgedAnswer | NotGraded, assignment: Assignment) -> dict[str, Any]:
    """Return a combinator template grader's outcome: the fraction, and what the student sees."""
    if isinstance(judged, NotGraded):
        text = "".join(f"<p>{escape(line)}</p>" for line in judged.sentences(assignment.language))
        return {"fraction": 0, "prologuehtml": text, "graderstate": ""}
    head = ["iscorrect", "Part", "Points", "Of"]
    rows = [
        [int(part["correct"]), kind, part["points"], part["max_points"]]
        for kind, part in judged.body["parts"].items()
    ]
    told = "".join(f"<p>{escape(line)}</p>" for line in judged.sentences())
    return {"fraction": judged.score, "testresults": [head, *rows], "epiloguehtml": told}
