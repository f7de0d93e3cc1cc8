"""Whose the rows of a class's file are, and which types of joints they name."""

import csv
import io
import os
from pathlib import Path
from typing import Any

import pytest

from service.adapters.class_grading import ClassSettings, grade_class
from service.adapters.gradebook import GradebookFormat, write_gradebook
from service.adapters.hand_ins import hand_ins
from service.adapters.judging import judge
from service.adapters.table_files import FoundTable, TableSettings, read_tables
from service.http.problems import RequestError
from tests.service.adapters.test_grading_without_a_server import NUMBERS, RIGHT


def read(text: str, name: str = "class.csv") -> tuple[FoundTable, ...]:
    return read_tables(name, text.encode(), TableSettings())


def joints(text: str) -> list[object]:
    (found,) = read(text)
    return [row.get("joint") for row in found.table["rows"]]


def test_an_identifier_tells_namesakes_apart_and_the_name_is_shown() -> None:
    """Both columns meant the student, and the last one won: two students of one name had one table."""
    rows = "Ann,1,q1,0,1,0\n,,q2,0,1,0\nAnn,2,q1,0,2,0\nAnne,2,q2,0,2,0\nBob,,q1,0,3,0\n,7,q1,0,4,0\n"
    for header in ("name,id", "Student,Login", "student,E-mail"):
        found = read(f"{header},theta,d,a,alpha\n{rows}")
        who = [(table.student, table.identifier, len(table.table["rows"])) for table in found]
        assert who == [("Ann", "1", 2), ("Ann", "2", 2), ("Bob", None, 1), ("7", None, 1)]


def test_what_an_lms_calls_a_student_goes_into_its_own_column(tmp_path: Path) -> None:
    file = tmp_path / "class.csv"
    file.write_text(
        "name,username,theta,d,a,alpha\nAnn,ann1,q1,0,L1,0\nAnn,ann1,q2,0,L2,0\nAnn,42,q1,0,L1,0\nAnn,42,q2,0,L2,0\n"
    )
    entries = list(grade_class(hand_ins(file, TableSettings()), ClassSettings(exercise="twolink"), jobs=1))
    assert [(entry.student, entry.identifier, entry.correct) for entry in entries] == [
        ("Ann", "ann1", True),
        ("Ann", "42", True),
    ]
    stream = io.StringIO()
    write_gradebook(entries, stream, GradebookFormat.CANVAS)
    rows = list(csv.reader(io.StringIO(stream.getvalue())))
    assert [row[:3] for row in rows[2:]] == [["Ann", "", "ann1"], ["Ann", "42", ""]]


@pytest.mark.parametrize(
    ("header", "rows", "seeds"),
    [
        ("name,id", ("Ann,1", "Ann,2", "Bob,"), ["1", "2", "Bob"]),
        ("name", ("Ann", "Bob"), ["Ann", "Bob"]),
    ],
)
def test_namesakes_have_values_of_their_own(
    header: str, rows: tuple[str, ...], seeds: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Values were drawn by the name, although a column told two students of one name apart."""
    told: list[object] = []

    def noted(exercise: str, answer: dict[str, object], *more: Any) -> Any:
        told.append(answer["seed"])
        return judge(exercise, answer, *more)

    monkeypatch.setattr("service.adapters.class_grading.judge", noted)
    tables = "".join(f"{row},q1,0,L1,0\n{row},q2,0,L2,0\n" for row in rows)
    (tmp_path / "class.csv").write_text(f"{header},theta,d,a,alpha\n{tables}")
    settings = ClassSettings(exercise="twolink", per_student=True)
    entries = list(grade_class(hand_ins(tmp_path / "class.csv", TableSettings()), settings, jobs=1))
    assert told == seeds
    assert [entry.student for entry in entries] == [row.partition(",")[0] for row in rows]


def test_numbers_of_joints_are_no_types() -> None:
    """Joint 1 of a table that numbers them was prismatic, and a right table wrong."""
    assert joints("joint,theta,d,a,alpha\n1,q1,0,1,0\n2,q2,0,1,0\n") == [None, None]
    assert joints("Joint,type,theta,d,a,alpha\n1,R,q1,0,1,0\n2,P,0,q2,1,0\n") == ["revolute", "prismatic"]
    assert joints("sigma,theta,d,a,alpha\n0,q1,0,1,0\n1,0,q2,1,0\n") == ["revolute", "prismatic"]
    assert joints("joint,theta,d,a,alpha\nelbow,q1,0,1,0\nR,q2,0,1,0\n") == [None, "revolute"]


def test_a_type_that_nobody_knows_is_refused_and_not_passed_over(tmp_path: Path) -> None:
    """The table got the types of the exercise, which were then found right."""
    (tmp_path / "ann.csv").write_text(NUMBERS.replace("theta", "type,theta").replace("\n0", "\nscrew,0"))
    settings = ClassSettings(exercise="twolink")
    (entry,) = grade_class(hand_ins(tmp_path, TableSettings()), settings, jobs=1)
    assert entry.points is None
    assert entry.codes[0] == "value_not_allowed"
    assert "joint" in entry.feedback
    columns = '{"theta": [0, 0], "d": [0, 0], "a": [1, 1], "alpha": [0, 0], "joint_types": ["R", "screw"]}'
    (found,) = read(columns, "ann.json")
    assert [row["joint"] for row in found.table["rows"]] == ["revolute", "screw"]


def test_units_of_titles_count_in_json_too() -> None:
    (found,) = read('{"theta (deg)": [90], "d [mm]": [1], "a_{i-1}": [0], "alpha": [0]}', "ann.json")
    told = {name: value for name, value in found.table.items() if name != "rows"}
    assert told == {"convention": "modified", "angle_unit": "deg", "length_unit": "mm"}


def test_a_unit_of_another_column_says_nothing_of_the_table() -> None:
    (found,) = read("height (in),theta (deg),d,a,alpha\n70,q1,0,1,0\n")
    assert (found.table["angle_unit"], found.table["length_unit"]) == ("deg", "m")


@pytest.mark.parametrize(
    ("name", "text", "code"),
    [
        ("t.csv", "theta (deg),d,a,alpha (rad)\nq1,0,1,0\n", "units_differ"),
        ("t.json", '{"theta": [0], "d [m]": [0], "a (mm)": [0], "alpha": [0]}', "units_differ"),
        ("t.csv", "theta,d,a,alpha\n" + "q1,0,1,0\n" * 100_000, "rows_too_many"),
        (
            "t.json",
            '{"theta": [0], "d": [0], "a": [0], "alpha": [0], "joint_types": []}',
            "columns_differ_in_length",
        ),
    ],
    ids=["angles", "lengths", "rows", "types"],
)
def test_nothing_is_dropped_and_no_unit_chosen_in_silence(name: str, text: str, code: str) -> None:
    with pytest.raises(RequestError) as refused:
        read(text, name)
    assert refused.value.faults[0].code == code


def test_empty_lines_are_no_rows() -> None:
    assert len(read("theta,d,a,alpha\n" + ",,,\n\n" * 60_000 + "q1,0,1,0\n")[0].table["rows"]) == 1


@pytest.mark.skipif(os.name != "posix", reason="names of files are text there")
def test_names_of_files_that_are_no_text_can_be_written(tmp_path: Path) -> None:
    """Umlauts of an archive from Windows ended the grading of a class, behind the last of its files."""
    folder = os.fsencode(tmp_path / "class")
    os.mkdir(folder)
    for name in (b"Zo\xeb.csv", b"Zo\xe9.csv", "Zoe\u0308.csv".encode()):
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(RIGHT)
    settings = ClassSettings(exercise="twolink")
    found = hand_ins(tmp_path / "class", TableSettings(angle_unit="deg"))
    entries = list(grade_class(found, settings, jobs=1))
    with (tmp_path / "grades.csv").open("w", encoding="utf-8") as stream:
        write_gradebook(entries, stream, GradebookFormat.CSV)
    assert len({entry.student for entry in entries}) == 3
    assert "Zo\u00eb" in {entry.student for entry in entries}
