"""Otter-Grader: results.json of the same shape as Gradescope's, beside the notebook or in a folder.

In a notebook's tests, `framewise.check(table, exercise)` is asked directly, as docs/lms/examples/otter shows.
"""

import json
from pathlib import Path

from service.adapters.hosts.assignment import Assignment
from service.adapters.hosts.gradescope import results_of


def run(assignment: Assignment, source: Path | None = None) -> None:
    """Grade the table in a file or folder, and write results.json beside it."""
    path = source or Path()
    results = results_of(assignment.grade_path(path), assignment)
    folder = path if path.is_dir() else path.parent
    (folder / "results.json").write_text(json.dumps(results, ensure_ascii=False), encoding="utf-8")
