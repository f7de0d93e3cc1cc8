"""The example folders of nbgrader and Otter, each run by its host's own published program: `make runners`.

An assignment is released, a right and a wrong answer are handed in, and the host grades them: a right one
gets all marks, a wrong one some. `test_examples` holds the same folders against their documented contracts.
"""

import csv
import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent.parent.parent
EXAMPLES = ROOT / "docs" / "lms" / "examples"
ANSWERS = {"right": 0, "wrong": 90}
"""The twist α₁ that a student writes."""
MOST = 5.0


def main() -> int:
    """Run both; the status is 1 if one gives other marks than the examples promise."""
    failed = False
    for name, graded in (("nbgrader", nbgrader), ("otter", otter)):
        with tempfile.TemporaryDirectory() as folder:
            marks = graded(Path(folder))
        kept = marks["right"] == MOST and 0 < marks["wrong"] < MOST
        failed |= not kept
        print(f"{name}: {marks} of {MOST}: {'as promised' if kept else 'NOT as promised'}")
    return int(failed)


def nbgrader(folder: Path) -> dict[str, float]:
    """Generate the assignment, hand in, autograde, export: what an instructor's terminal does."""
    example = EXAMPLES / "nbgrader" / "two-link.ipynb"
    (folder / "source" / "links").mkdir(parents=True)
    shutil.copy(example, folder / "source" / "links")
    config = f"c.CourseDirectory.course_id = 'robotics'\nc.CourseDirectory.root = {str(folder)!r}\n"
    (folder / "nbgrader_config.py").write_text(f"c = get_config()\n{config}")
    run(folder, "nbgrader", "generate_assignment", "links")
    released = json.loads((folder / "release" / "links" / example.name).read_text())
    for student, alpha in ANSWERS.items():
        for cell in released["cells"]:
            if cell["metadata"]["nbgrader"]["grade_id"] == "table":
                cell["source"] = solution(alpha)
        submitted = folder / "submitted" / student / "links" / example.name
        submitted.parent.mkdir(parents=True)
        submitted.write_text(json.dumps(released))
    run(folder, "nbgrader", "autograde", "links")
    run(folder, "nbgrader", "export")
    with (folder / "grades.csv").open() as stream:
        return {row["student_id"]: float(row["score"]) for row in csv.DictReader(stream)}


def otter(folder: Path) -> dict[str, float]:
    """Make the autograder's zip file of the tests and run it on each notebook, as its container does."""
    tests = EXAMPLES / "otter" / "tests"
    run(folder, "otter", "generate", "-t", str(tests), "-o", "autograder.zip", "--no-environment")
    marks = {}
    for student, alpha in ANSWERS.items():
        (folder / f"{student}.ipynb").write_text(json.dumps(notebook(solution(alpha))))
        (folder / student).mkdir()
        run(folder, "otter", "run", "-a", "autograder.zip", f"{student}.ipynb", "-o", student)
        results = json.loads((folder / student / "results.json").read_text())
        marks[student] = sum(test.get("score", 0.0) for test in results["tests"])
    return marks


def solution(alpha: int) -> str:
    """Return what a student writes into the answer's cell."""
    rows = [{"theta": f"q{i}", "d": 0, "a": f"L{i}", "alpha": alpha if i == 1 else 0} for i in (1, 2)]
    return f'table = {{"convention": "standard", "angle_unit": "deg", "rows": {rows!r}}}'


def notebook(source: str) -> dict[str, Any]:
    """Return a notebook of one cell."""
    cell = {
        "cell_type": "code", "id": "answer", "metadata": {}, "source": source, "outputs": [],
        "execution_count": None,
    }  # fmt: skip
    kernel = {"name": "python3", "display_name": "Python 3", "language": "python"}
    return {"cells": [cell], "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}


def run(folder: Path, program: str, *arguments: str) -> None:
    """Call a program of this environment in a folder, with the tree's packages to be found."""
    path = Path(sys.executable).parent
    variables = {"PYTHONPATH": str(ROOT), "PATH": f"{path}{os.pathsep}{os.environ['PATH']}"}
    command: Sequence[str] = (str(path / program), *arguments)
    done = subprocess.run(
        command, cwd=folder, env={**os.environ, **variables}, capture_output=True, text=True
    )
    if done.returncode:
        sys.exit(f"{program} {arguments[0]} ended with {done.returncode}:\n{done.stdout}\n{done.stderr}")


if __name__ == "__main__":
    sys.exit(main())
