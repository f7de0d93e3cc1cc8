"""nbgrader: a number on standard output, which is the points of an autograded cell.

In a notebook, the last expression of a test cell is what nbgrader records as partial credit; there,
`framewise.check(table, exercise).points_of(5)` says the same without a file.
"""

import sys
from pathlib import Path

from service.adapters.hosts.assignment import Assignment
from service.adapters.judging import NotGraded


def run(assignment: Assignment, source: Path | None = None) -> None:
    """Print the points that the table in a file earns, and on standard error why."""
    judged = assignment.grade_path(source or Path())
    if isinstance(judged, NotGraded):
        sys.stderr.write("\n".join(judged.sentences(assignment.language)) + "\n")
        sys.stdout.write("0\n")
        return
    sys.stderr.write("\n".join(judged.sentences()) + "\n")
    sys.stdout.write(f"{assignment.worth(judged)[0]:.6g}\n")
