"""A class graded from its files, and the protocols of other systems' autograders."""

import csv
import io
import json
import re
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from exercises.errors import UnknownExerciseError
from exercises.library import Library
from framewise import check
from service.adapters.class_grading import ClassSettings, grade_class, misconceptions
from service.adapters.gradebook import GradebookEntry, GradebookFormat, write_gradebook
from service.adapters.hand_ins import hand_ins
from service.adapters.hosts import HOSTS
from service.adapters.hosts.assignment import Assignment
from service.adapters.judging import JudgedAnswer, with_joint_types
from service.adapters.table_files import TableSettings
from tests.exercises import folders

RIGHT = "theta,d,a,alpha\nq1,0,L1,0\nq2,0,L2,0\n"
NUMBERS = "theta,d,a,alpha\n0,0,L1,0\n0,0,L2,0\n"
WRONG = "theta,d,a,alpha\nq1,0,L1,90\nq2,0,L2,0\n"
BROKEN = "theta,d,a,alpha\nq1,0,L1,(\nq2,0,L2,0\n"
TWO_LINKS = Assignment(exercise="twolink", tables=TableSettings(angle_unit="deg"))


def table(text: str) -> dict[str, Any]:
    rows = list(csv.DictReader(io.StringIO(text)))
    return {"convention": "standard", "angle_unit": "deg", "rows": rows}


@pytest.fixture
def class_folder(tmp_path: Path) -> Path:
    folder = tmp_path / "class"
    folder.mkdir()
    for i, text in enumerate((RIGHT, WRONG, BROKEN, NUMBERS) * 9):
        (folder / f"student{i:02}.csv").write_text(text)
    (folder / "student36.json").write_text(json.dumps({"Two-Link": table(RIGHT)}))
    return folder


def graded(folder: Path, jobs: int) -> list[GradebookEntry]:
    settings = ClassSettings(exercise="twolink", language="fr")
    return list(grade_class(hand_ins(folder, TableSettings(angle_unit="deg")), settings, jobs=jobs))


def test_a_class_is_graded_in_the_order_of_its_files_by_any_number_of_processes(class_folder: Path) -> None:
    entries = graded(class_folder, jobs=1)
    assert [entry.student for entry in entries] == sorted(entry.student for entry in entries)
    assert [entry.correct for entry in entries] == [True, False, False, True] * 9 + [True]
    assert [entry.points is None for entry in entries] == [False, False, True, False] * 9 + [False]
    assert all(entry.score == 1 for entry in entries if entry.correct)
    assert all(entry.score is not None and entry.score < 1 for entry in entries[1::4])
    assert misconceptions(entries)["not_equivalent"] == 9
    assert graded(class_folder, jobs=2) == entries


def test_the_same_table_of_many_students_is_judged_once(tmp_path: Path) -> None:
    """More than are in flight at once, and among them what only one hands in."""
    for i in range(300):
        text = {7: WRONG, 290: NUMBERS}.get(i, RIGHT)
        (tmp_path / f"student{i:03}.csv").write_text(text)
    for jobs in (1, 2):
        entries = graded(tmp_path, jobs)
        assert [entry.student for entry in entries] == [f"student{i:03}" for i in range(300)]
        assert [entry.source for entry in entries] == [f"student{i:03}.csv" for i in range(300)]
        assert [i for i, entry in enumerate(entries) if not entry.correct] == [7]


def test_values_of_ones_own_are_judged_for_each_student(tmp_path: Path) -> None:
    for name in ("ann", "bob"):
        (tmp_path / f"{name}.csv").write_text(NUMBERS)
    settings = ClassSettings(exercise="twolink", per_student=True)
    alone = {}
    for name in ("ann", "bob"):
        (alone[name],) = grade_class(hand_ins(tmp_path / f"{name}.csv", TableSettings()), settings, jobs=1)
    both = list(grade_class(hand_ins(tmp_path, TableSettings()), settings, jobs=1))
    assert both == list(alone.values())


def test_an_exercise_that_was_mended_is_read_anew(tmp_path: Path) -> None:
    (tmp_path / "ann.csv").write_text(RIGHT)
    settings = ClassSettings(exercise="two", folders=(tmp_path / "own",))
    ann = list(hand_ins(tmp_path / "ann.csv", TableSettings(angle_unit="deg")))
    found = []
    for text in (folders.changed('"L1", alpha = 0', '"L1", alpha = 90'), folders.TWO_LINKS):
        folders.folder(tmp_path / "own", text)
        (entry,) = grade_class(ann, settings, jobs=1)
        found.append(entry.correct)
    assert found == [False, True]


@pytest.mark.parametrize(
    "variable",
    ["q1", "theta[1]", "θ*₁", "{{\\theta }_{1}}", "Subscript[\\[Theta], 1]", "&theta;<sub>1</sub>"],
)
def test_a_table_with_variables_gets_no_joint_types_of_the_exercise(variable: str) -> None:
    """Its rows may be of other types, which is a mistake to be judged and no reason to refuse it."""
    rows = [{"alpha": 0, "a": 0, "d": 0, "theta": cell} for cell in (variable, 0, "90°", "sqrt(2)")]
    variables, numbers = ({"convention": "standard", "rows": some} for some in (rows, [rows[1]] * 4))
    assert with_joint_types("scara", variables) == variables
    assert all("joint" in row for row in with_joint_types("scara", numbers)["rows"])


def test_a_file_nested_without_end_stops_nobody_elses_mark(class_folder: Path) -> None:
    (class_folder / "deep.json").write_text('{"rows": ' + "[" * 900 + "]" * 900 + "}")
    entries = graded(class_folder, jobs=2)
    assert entries[0].source == "deep.json"
    assert entries[0].codes == ("json_too_deep",)
    assert sum(entry.correct for entry in entries) == 19


def test_gradebooks(class_folder: Path) -> None:
    entries = graded(class_folder, jobs=1)[:3]
    written = {}
    for form in GradebookFormat:
        stream = io.StringIO()
        write_gradebook(entries, stream, form)
        written[form] = list(csv.reader(io.StringIO(stream.getvalue())))
    assert written[GradebookFormat.CSV][1][:3] == ["student00", "twolink", "true"]
    assert written[GradebookFormat.MOODLE][1][0] == "student00"
    assert written[GradebookFormat.CANVAS][0][-1] == "twolink"
    assert written[GradebookFormat.CANVAS][1][0].strip() == "Points Possible"
    assert written[GradebookFormat.CANVAS][4][-1] == ""  # not graded is no zero


def test_a_gradebook_has_no_line_for_nobody_and_keeps_what_an_exercise_is_worth() -> None:
    ann = GradebookEntry(
        student="Ann", exercise="x", points=1, max_points=2, correct=False, codes=(), feedback="", source="a"
    )
    forged = replace(ann, student="", exercise="", points=None, max_points=None)
    late = replace(ann, student="Bob", points=None, max_points=None)
    for form in (GradebookFormat.MOODLE, GradebookFormat.CANVAS):
        stream = io.StringIO()
        write_gradebook([forged, ann, late], stream, form)
        found = list(csv.reader(io.StringIO(stream.getvalue())))
        assert all(any(row) for row in found)
        if form is GradebookFormat.CANVAS:
            assert [row[4:] for row in found] == [["x"], ["2"], ["1"], [""]]


def test_a_gradebook_has_the_best_of_a_students_answers() -> None:
    """Notes beside a table, which cannot be graded, took the mark away."""
    best = GradebookEntry(student="Ann", exercise="x", points=2, max_points=2, correct=True, source="b.csv")
    worse = replace(best, points=1, correct=False, source="a.csv")
    notes = replace(best, points=None, max_points=None, correct=False, source="notes.txt")
    namesake = replace(worse, identifier="17")
    for form, column in ((GradebookFormat.MOODLE, 2), (GradebookFormat.CANVAS, 4)):
        stream = io.StringIO()
        write_gradebook([worse, best, notes, namesake], stream, form)
        found = list(csv.reader(io.StringIO(stream.getvalue())))
        assert [row[column] for row in found][-2:] == ["2", "1"]
        assert sum("Ann" in row for row in found) == 2
    stream = io.StringIO()
    write_gradebook([worse, best, notes, namesake], stream, GradebookFormat.CSV)
    assert len(stream.getvalue().splitlines()) == 5


@pytest.mark.parametrize("before", ["", "x;", "x; ", "x\t", "x\n", " "])
def test_no_cell_of_a_gradebook_is_a_formula(before: str) -> None:
    """Nor one that a spreadsheet makes where a semicolon or a tab ends a cell, as in most of Europe."""
    entry = GradebookEntry(
        student=f"{before}=HYPERLINK(1)", exercise=f"{before}=1+1", points=1, max_points=1, correct=True,
        codes=(), feedback="@x", source="-1",
    )  # fmt: skip
    for form in GradebookFormat:
        stream = io.StringIO()
        write_gradebook([entry], stream, form)
        cells = [cell for row in csv.reader(io.StringIO(stream.getvalue())) for cell in row]
        assert not any(cell.startswith(("=", "@", "-")) for cell in cells)
        split = re.split(r"[;\t\n,]", stream.getvalue().replace('"', ""))
        assert not any(cell.strip().startswith("=") for cell in split)


@pytest.mark.parametrize(("text", "score"), [(RIGHT, 1.0), (WRONG, None), (BROKEN, 0.0)])
def test_gradescope(text: str, score: float | None, tmp_path: Path) -> None:
    (tmp_path / "submission").mkdir()
    (tmp_path / "submission" / "answer.csv").write_text(text)
    assignment = Assignment(exercise="twolink", points=10, tables=TableSettings(angle_unit="deg"))
    HOSTS["gradescope"](assignment, tmp_path)
    results = json.loads((tmp_path / "results" / "results.json").read_text())
    assert results["output"]
    if score is None:
        assert 0 < results["score"] < 10
        assert results["tests"][0]["status"] == "failed"
    else:
        assert results["score"] == 10 * score


@pytest.mark.parametrize("submitted", [table(RIGHT), json.dumps(table(RIGHT)), {"table": table(RIGHT)}])
def test_prairielearn(submitted: Mapping[str, Any] | str, tmp_path: Path) -> None:
    (tmp_path / "data").mkdir()
    data = {"params": {"framewise": {"exercise": "twolink"}}, "submitted_answers": {"table": submitted}}
    (tmp_path / "data" / "data.json").write_text(json.dumps(data))
    HOSTS["prairielearn"](Assignment(), tmp_path)
    results = json.loads((tmp_path / "results" / "results.json").read_text())
    assert results["gradable"]
    assert results["score"] == 1.0


def test_prairielearn_counts_no_attempt_for_what_cannot_be_graded(tmp_path: Path) -> None:
    for folder in ("data", "student"):
        (tmp_path / folder).mkdir()
    (tmp_path / "data" / "data.json").write_text(json.dumps({"params": {}, "submitted_answers": {}}))
    (tmp_path / "student" / "answer.csv").write_text(BROKEN)
    HOSTS["prairielearn"](TWO_LINKS, tmp_path)
    results = json.loads((tmp_path / "results" / "results.json").read_text())
    assert results["gradable"] is False
    assert results["format_errors"]


def prairielearn(folder: Path, assignment: Assignment, submitted: object, **asked: object) -> dict[str, Any]:
    """What the external grader writes for an answer to a question."""
    (folder / "data").mkdir(exist_ok=True)
    data = {"params": {"framewise": asked}, "submitted_answers": {"table": submitted}}
    (folder / "data" / "data.json").write_text(json.dumps(data))
    HOSTS["prairielearn"](assignment, folder)
    results: dict[str, Any] = json.loads((folder / "results" / "results.json").read_text())
    return results


@pytest.mark.parametrize("submitted", ["<html>Bad gateway</html>", "{", "5", "", "null", None, 5])
def test_prairielearn_is_told_of_a_text_that_is_no_table(submitted: object, tmp_path: Path) -> None:
    """It was a traceback, and no results."""
    results = prairielearn(tmp_path, TWO_LINKS, submitted)
    assert results["gradable"] is False
    assert results["format_errors"]


def test_prairielearn_grades_a_table_typed_as_text_with_a_seed_and_a_language(tmp_path: Path) -> None:
    assert prairielearn(tmp_path, TWO_LINKS, RIGHT)["score"] == 1.0
    seeded = prairielearn(tmp_path, Assignment(), table(NUMBERS), exercise="twolink", seed=17)
    assert seeded["gradable"]
    french = prairielearn(tmp_path, TWO_LINKS, BROKEN, language="fr")
    assert french != prairielearn(tmp_path, TWO_LINKS, BROKEN, language="xx")


def test_an_autograder_knows_exercises_of_ones_own(tmp_path: Path) -> None:
    folders.folder(tmp_path / "own", folders.TWO_LINKS)
    library = Library((tmp_path / "own",))
    assignment = Assignment(exercise="two", tables=TWO_LINKS.tables, library=library)
    judged = assignment.grade_text(RIGHT.encode())
    assert isinstance(judged, JudgedAnswer)
    assert judged.correct


def test_an_exercise_that_a_student_misnames_cannot_be_graded(tmp_path: Path) -> None:
    """The autograder ended without results; a lecturer's slip is still told to the lecturer."""
    (tmp_path / "submission").mkdir()
    text = RIGHT.replace("theta", "exercise,theta").replace("\nq", "\nr2d2,q")
    (tmp_path / "submission" / "answer.csv").write_text(text)
    HOSTS["gradescope"](Assignment(), tmp_path)
    results = json.loads((tmp_path / "results" / "results.json").read_text())
    assert results["score"] == 0
    assert "r2d2" in results["output"]
    with pytest.raises(UnknownExerciseError):
        HOSTS["gradescope"](Assignment(exercise="r2d2"), tmp_path)


def test_coderunner(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "answer").write_text(json.dumps(table(RIGHT)))
    HOSTS["coderunner"](TWO_LINKS, tmp_path / "answer")
    outcome = json.loads(capsys.readouterr().out)
    assert outcome["fraction"] == 1.0
    assert outcome["testresults"][0][0] == "iscorrect"
    (tmp_path / "answer").write_text("<script>alert(1)</script>")
    HOSTS["coderunner"](TWO_LINKS, tmp_path / "answer")
    outcome = json.loads(capsys.readouterr().out)
    assert outcome["fraction"] == 0
    assert "<script" not in outcome["prologuehtml"]


def test_nbgrader_prints_points(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "answer.csv").write_text(RIGHT)
    assignment = Assignment(exercise="twolink", points=5, tables=TableSettings(angle_unit="deg"))
    HOSTS["nbgrader"](assignment, tmp_path / "answer.csv")
    assert capsys.readouterr().out == "5\n"


def test_otter_writes_results(tmp_path: Path) -> None:
    (tmp_path / "answer.csv").write_text(RIGHT)
    HOSTS["otter"](TWO_LINKS, tmp_path / "answer.csv")
    assert json.loads((tmp_path / "results.json").read_text())["tests"][0]["status"] == "passed"


def test_a_notebook_is_told() -> None:
    right = check(table(NUMBERS), "twolink")
    assert right.correct
    assert right.points_of(5) == 5
    assert "✓" in right._repr_html_()
    wrong = check(table(WRONG), "twolink", language="es")
    assert not wrong.correct
    assert wrong.gradable
    assert wrong.feedback
    broken = check(table(BROKEN), "twolink")
    assert not broken.gradable
    assert broken.points_of(5) == 0
