"""The command line: list, check, draw, and start exercises from anything."""

import json
from pathlib import Path
from typing import Any

import pytest

from exercises.authoring.archive import archive_of_draft
from exercises.authoring.scaffold import nice_range
from exercises.loader import load_exercise
from service.cli import commands
from tests.exercises.folders import TWO_LINKS, draft_of, folder
from tests.exercises.packaged import exercise_ids

AXES = {
    "axes": [
        {"joint": "revolute", "point": [0, 0, 0], "direction": [0, 0, 1]},
        {"joint": "revolute", "point": [0.1, 0, 0.4], "direction": [0, 1, 0]},
        {"joint": "prismatic", "point": [0.5, 0, 0.4], "direction": [1, 0, 0]},
    ]
}
TABLE = {
    "convention": "standard",
    "angle_unit": "deg",
    "length_unit": "mm",
    "rows": [
        {"theta": "q1", "d": 300, "a": 0, "alpha": 90},
        {"theta": "q2", "d": 0, "a": "L2", "alpha": 0},
        {"theta": 0, "d": "q3", "a": -80, "alpha": "30"},
    ],
    "parameters": {"L2": 450},
}


def main(arguments: list[str]) -> int:
    """Run `framewise exercises`."""
    return commands.main(["exercises", *arguments])


def new(tmp_path: Path, *arguments: str) -> Path:
    assert main(["new", "mine", "--into", str(tmp_path), *arguments]) == 0
    return tmp_path / "mine"


def source(tmp_path: Path, content: dict[str, Any]) -> str:
    file = tmp_path / "source.json"
    file.write_text(json.dumps(content), encoding="utf-8")
    return str(file)


def test_the_list_names_every_exercise(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["list"]) == 0
    assert len(capsys.readouterr().out.splitlines()) == len(exercise_ids)


URDF = """<robot name="arm"><link name="a"/><link name="b"/><link name="c"/>
<joint name="one" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint>
<joint name="two" type="prismatic"><parent link="b"/><child link="c"/>
<origin xyz="0.3 0 0.2"/><axis xyz="1 0 0"/>
<limit lower="0" upper="1" effort="1" velocity="1"/></joint></robot>"""


@pytest.mark.parametrize("how", ["robot", "table", "axes", "urdf"])
def test_a_new_exercise_loads_and_passes_its_own_tests(
    how: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "arm.urdf").write_text(URDF, encoding="utf-8")
    given = {
        "robot": lambda: "stanford",
        "table": lambda: source(tmp_path, TABLE),
        "axes": lambda: source(tmp_path, AXES),
        "urdf": lambda: str(tmp_path / "arm.urdf"),
    }
    made = new(tmp_path, f"--{how}", given[how]())
    assert main(["check", str(made), "--seeds", "1"]) == 0
    capsys.readouterr()
    assert main(["figure", str(made), "--seed", "3", "--output", str(tmp_path / "f.svg")]) == 0
    assert (tmp_path / "f.svg").read_text(encoding="utf-8").startswith("<svg")


@pytest.mark.parametrize(
    ("name", "title"), [("Arm 7 “Ada”", "Arm 7 “Ada”"), ("&lt;b>x", "Robot mine"), (" ", "Robot mine")]
)
def test_an_exercise_from_a_urdf_has_its_name(name: str, title: str, tmp_path: Path) -> None:
    """Unless that is none that a title may have."""
    (tmp_path / "arm.urdf").write_text(URDF.replace('"arm"', f'"{name}"'), encoding="utf-8")
    found = load_exercise(new(tmp_path, "--urdf", str(tmp_path / "arm.urdf")))
    assert set(found.titles.values()) >= {title}


def test_lengths_of_a_table_get_names_and_keep_their_values(tmp_path: Path) -> None:
    found = load_exercise(new(tmp_path, "--table", source(tmp_path, TABLE)))
    assert {p.name: float(p.value) for p in found.parameters} == {"d1": 300, "L2": 450, "a3": 80}
    assert found.length_unit == "mm"
    assert all(p.draw is not None and p.value in p.draw.values for p in found.parameters)


def test_axes_become_nice_angles(tmp_path: Path) -> None:
    text = (new(tmp_path, "--axes", source(tmp_path, AXES)) / "exercise.toml").read_text(encoding="utf-8")
    assert "alpha = -90" in text
    assert "0.0999" not in text


@pytest.mark.parametrize(
    ("content", "code"),
    [
        ({}, "exercise_key_missing"),
        ({**TABLE, "parameters": {}}, "L2"),
        ({**TABLE, "rows": [{"theta": "2q1", "d": 0, "a": 0, "alpha": 0}]}, "variable_scaled"),
        ({**TABLE, "colour": 1}, "colour"),
    ],
)
def test_a_malformed_table_is_refused(
    content: dict[str, Any], code: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["new", "mine", "--into", str(tmp_path), "--table", source(tmp_path, content)]) == 2
    assert code in capsys.readouterr().err
    assert not (tmp_path / "mine").exists()


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ({"axes": []}, "exercise_key_missing"),
        ({"axes": [{"joint": "revolute", "point": [0, 0], "direction": [0, 0, 1]}]}, "exercise_value_type"),
        (
            {"axes": [{"joint": "screw", "point": [0, 0, 0], "direction": [0, 0, 1]}]},
            "exercise_value_unknown",
        ),
        ({"axes": [{"joint": "revolute", "point": [0, 0, 0], "direction": [0, 0, 0]}]}, "direction"),
    ],
)
def test_malformed_axes_are_refused(
    content: dict[str, Any], words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["new", "mine", "--into", str(tmp_path), "--axes", source(tmp_path, content)]) == 2
    assert words in capsys.readouterr().err


def test_a_malformed_urdf_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for content in ("<robot", "<robot name='x'/>"):
        (tmp_path / "bad.urdf").write_text(content, encoding="utf-8")
        assert main(["new", "mine", "--into", str(tmp_path), "--urdf", str(tmp_path / "bad.urdf")]) == 2
        assert "bad.urdf" in capsys.readouterr().err
    assert main(["new", "mine", "--into", str(tmp_path), "--urdf", str(tmp_path / "nowhere.urdf")]) == 2


def test_files_that_cannot_be_read(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "list.json").write_text("[1]", encoding="utf-8")
    (tmp_path / "bad.json").write_text("{", encoding="utf-8")
    for name in ("nowhere.json", "bad.json", "list.json"):
        assert main(["new", "mine", "--into", str(tmp_path), "--table", str(tmp_path / name)]) == 2
        assert name in capsys.readouterr().err


def test_ids_and_folders_are_guarded(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name in ("../evil", "a/b", "", "a--b"):
        assert main(["new", name, "--into", str(tmp_path), "--robot", "rx90"]) == 2
    new(tmp_path, "--robot", "rx90")
    assert main(["new", "mine", "--into", str(tmp_path), "--robot", "rx90"]) == 2
    assert main(["new", "other", "--into", str(tmp_path), "--robot", "r2d2"]) == 2
    assert "exercise_robot_unknown" in capsys.readouterr().err


def test_check_takes_the_zip_file_of_a_folder(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    archive = tmp_path / "two.zip"
    archive.write_bytes(archive_of_draft(draft_of(folder(tmp_path))))
    assert main(["check", str(archive), "--seeds", "1"]) == 0
    assert capsys.readouterr().out.startswith("two: ")


def test_check_reports_what_fails(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A sample that expects the wrong judgement, and values that change the robot's structure."""
    text = TWO_LINKS.replace("from = 0.4, to = 0.6, step = 0.1", "from = 0, to = 0.6, step = 0.6")
    text += """
[tests]
[[tests.samples]]
name = "the key"
expect = "incorrect"
convention = "standard"
rows = [{ theta = "q1", d = 0, a = "L1", alpha = 0 }, { theta = "q2", d = 0, a = "L2", alpha = 0 }]
[[tests.samples]]
name = "half a cell"
expect = "correct"
convention = "standard"
rows = [{ theta = "q1", d = 0, a = "(L1", alpha = 0 }]
"""
    text = text.replace('expect = "correct"', 'expect = "invalid"')
    assert main(["check", str(folder(tmp_path, text)), "--seeds", "6"]) == 1
    report = capsys.readouterr().out
    assert "sample: " in report
    assert "the key" in report
    assert "half a cell" not in report
    assert "structure: " in report
    assert "figure: " in report


def test_an_unknown_exercise_is_said_to_be_one(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", "r2d2"]) == 2
    assert "r2d2" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (0.4318, ("0.30", "0.60", "0.05")),
        (7.11, ("5.5", "8.5", "0.5")),
        (115, ("90", "150", "10")),
        (0.02, ("0.017", "0.023", "0.001")),
        (0, ("-0.3", "0.3", "0.1")),
        (5e-324, ("-0.3", "0.3", "0.1")),
    ],
)
def test_ranges_are_round(value: float, expected: tuple[str, str, str]) -> None:
    assert nice_range(value) == expected
