"""Definitions are read strictly: every fault at once, each with file and key."""

import re
from pathlib import Path
from typing import Any

import pytest

from exercises import library, loader
from exercises.definition import Exercise
from exercises.errors import DefinitionError, UnknownExerciseError
from exercises.grading import BaseRule, HelpLevel, ToolRule
from exercises.library import Library
from exercises.loader import exercise_of_files, load_exercise
from exercises.parts.forward.pose import PosePart
from exercises.parts.forward.workspace import WorkspacePart
from kinematics.errors import Fault
from tests.exercises.folders import TWO_LINKS, changed, folder, with_part
from tests.exercises.packaged import exercise


def faults(made: Path) -> dict[str, str]:
    """Codes by place."""
    with pytest.raises(DefinitionError) as refused:
        load_exercise(made)
    return {".".join(map(str, fault.where)): fault.code for fault in refused.value.faults}


def test_a_definition_is_read(tmp_path: Path) -> None:
    found = load_exercise(folder(tmp_path))
    assert (found.id, found.version, found.titles["fr"]) == ("two", 1, "Deux")
    assert [parameter.name for parameter in found.parameters] == ["L1", "L2"]
    assert found.parameters[0].draw is not None
    assert found.parameters[1].draw is None
    assert (found.policy.tool, found.policy.base, found.help) == (
        ToolRule.AXIS,
        BaseRule.FREE,
        HelpLevel.REPAIR,
    )


def test_files_of_an_editor_on_windows_are_read(tmp_path: Path) -> None:
    """They begin with a mark, and their lines end with two characters."""
    made = folder(tmp_path)
    for file in made.iterdir():
        file.write_bytes(b"\xef\xbb\xbf" + file.read_bytes().replace(b"\n", b"\r\n"))
    (tmp_path / "plain").mkdir()
    plain = load_exercise(folder(tmp_path / "plain"))
    marked = load_exercise(made)
    assert (marked.titles, marked.statements) == (plain.titles, plain.statements)


def test_a_version_beyond_what_json_holds_is_refused(tmp_path: Path) -> None:
    """One such folder ended the list of all exercises with error 500."""
    made = folder(tmp_path, changed("version = 1", f"version = {10**15 + 1}"))
    assert faults(made) == {"two.exercise.toml.version": "exercise_value_type"}
    assert load_exercise(folder(tmp_path, changed("version = 1", f"version = {10**15}"))).version == 10**15


def test_an_unknown_exercise_names_those_that_exist() -> None:
    with pytest.raises(UnknownExerciseError) as refused:
        exercise("puma")
    assert refused.value.code == "exercise_unknown"
    assert "puma560" in str(refused.value)


def test_every_fault_is_reported_at_once(tmp_path: Path) -> None:
    text = changed("version = 1", 'version = "one"\ncolour = "red"')
    text = changed('kind = "table"', 'kind = "tables"', text)
    text = changed("points = 10", "points = 0", text)
    text = changed("L2.value = 0.3", "L3.value = 0.3", text)
    made = folder(tmp_path, text)
    (made / "statement.uk.md").write_text("", encoding="utf-8")
    assert faults(made) == {
        "two.statement.uk.md": "statement_missing",
        "two.exercise.toml.version": "exercise_value_type",
        "two.exercise.toml.colour": "exercise_key_unknown",
        "two.exercise.toml.parts.0.kind": "exercise_value_unknown",
        "two.exercise.toml.parts.0.points": "points_not_positive",
        "two.exercise.toml.parameters.L3": "parameter_unused",
        "two.exercise.toml.parameters.L2": "parameter_missing",
    }


@pytest.mark.parametrize(
    ("old", "new", "place", "code"),
    [
        ("[reference]", 'robot = "puma560"\n[reference]', "title.robot", "exercise_key_unknown"),
        ("version = 1", 'version = 1\nrobot = "r2d2"', "robot", "exercise_robot_unknown"),
        ("version = 1", 'version = 1\nrobot = "rx90"', "reference", "robot_and_reference"),
        ("[title]", '[title]\nenglish = "Two"', "title.english", "exercise_key_unknown"),
        ("L2.value = 0.3", 'L2.value = 0.3\nL2.aliases = ["L1"]', "parameters.L2.aliases.0", "alias_taken"),
        ("L2.value = 0.3", 'L2.value = 0.3\nL2.aliases = ["q_1"]', "parameters.L2.aliases.0", "alias_taken"),
        ("version = 1", 'version = 1\nneeds = ["L9"]', "needs.0", "need_unknown"),
        ("version = 1", "version = 0", "version", "exercise_value_type"),
        ("version = 1", "version = -1", "version", "exercise_value_type"),
        ('theta = "q1"', 'theta = "2*q1"', "reference.rows.0.theta", "variable_scaled"),
        ('theta = "q1", ', "", "reference.rows.0.theta", "exercise_key_missing"),
        ('convention = "standard"', 'convention = "craig"', "reference.convention", "exercise_value_unknown"),
        ("from = 0.4, to = 0.6", "from = 0.6, to = 0.4", "parameters.L1.draw", "draw_empty"),
        ("step = 0.1", "step = 0", "parameters.L1.draw", "draw_empty"),
        ("step = 0.1", "step = 1e-9", "parameters.L1.draw", "draw_too_large"),
        ("step = 0.1", "step = 0.1, without = [0.4, 0.5, 0.6]", "parameters.L1.draw", "draw_empty"),
        ("[[parts]]", '[policy]\ntool = "tip"\n[[parts]]', "policy.tool", "exercise_value_unknown"),
        (
            "[[parts]]",
            "[policy.tolerance]\nangle = 3\n[[parts]]",
            "policy.tolerance.angle",
            "tolerance_out_of_range",
        ),
        ("[[parts]]", '[help]\nmost = "all"\n[[parts]]', "help.most", "exercise_value_unknown"),
        (
            "[[parts]]",
            '[tests]\nmisconceptions = ["sloth"]\n[[parts]]',
            "tests.misconceptions.0",
            "misconception_unknown",
        ),
        ("[[parts]]", "[figure]\nposture = [0]\n[[parts]]", "figure.posture", "joints_wrong_length"),
        ("[[parts]]", "[figure]\nwidth = 5\n[[parts]]", "figure.width", "width_out_of_range"),
        ("[[parts]]", '[figure]\nlinks = ["O0"]\n[[parts]]', "figure.links", "exercise_value_type"),
        ("[[parts]]", "[figure]\npoints.A = {}\n[[parts]]", "figure.points.A", "point_without_form"),
        ("[[parts]]", '[figure]\njoints.3 = { at = "O0" }\n[[parts]]', "figure.joints.3", "unknown_joint"),
        ("[[parts]]", "[figure]\nlengths = { L9 = 1 }\n[[parts]]", "figure.lengths.L9", "parameter_unused"),
    ],
)
def test_a_fault_names_its_key(tmp_path: Path, old: str, new: str, place: str, code: str) -> None:
    assert faults(folder(tmp_path, changed(old, new)))[f"two.exercise.toml.{place}"] == code


@pytest.mark.parametrize(
    ("old", "new", "place"),
    [
        ("step = 0.1", 'step = "x"', "parameters.L1.draw.step"),
        ("[[parts]]", "[access]\nattempts = 1.5\n[[parts]]", "access.attempts"),
        ("[[parts]]", '[access]\nvariants = "x"\n[[parts]]', "access.variants"),
        ("version = 1", "version = 1.5", "version"),
        ("points = 10", 'points = "x"', "parts.0.points"),
        ("points = 10", "", "parts.0.points"),
        ("[[parts]]", '[figure]\nposture = [0, "x"]\n[[parts]]', "figure.posture.1"),
        ("[[parts]]", "[figure]\nposture = 3\n[[parts]]", "figure.posture"),
    ],
)
def test_what_cannot_be_read_is_told_once(tmp_path: Path, old: str, new: str, place: str) -> None:
    with pytest.raises(DefinitionError) as refused:
        load_exercise(folder(tmp_path, changed(old, new)))
    places = [".".join(map(str, fault.where)) for fault in refused.value.faults]
    assert [found for found in places if found.startswith(f"two.exercise.toml.{place}")] == [
        f"two.exercise.toml.{place}"
    ]
    assert f"two.exercise.toml.{place.rpartition('.')[0]}" not in places


@pytest.mark.parametrize(
    ("figure", "place", "code"),
    [
        ('links = [["O0", "X"]]', "links.0.1", "unknown_point"),
        ('marks = ["P"]', "marks.0", "unknown_point"),
        ('points.P = { from = "Q", by = [0, 0, 1] }\nmarks = ["P"]', "points.P.from", "unknown_point"),
        ('points.P = { frame = 7 }\nmarks = ["P"]', "points.P.frame", "unknown_frame"),
        ('points.P = { frame = 0, at = ["L9", 0, 0] }\nmarks = ["P"]', "points.P.at.0", "parameter_missing"),
        (
            'points.P = { from = "O0", joint = 9, distance = 1 }\nmarks = ["P"]',
            "points.P.joint",
            "unknown_joint",
        ),
        ('joints.1 = { at = "O1" }', "joints.1.at", "joint_off_axis"),
        ('gripper = { at = "O0", away_from = "O0" }', "gripper", "gripper_without_direction"),
        ('gripper = { at = "O1", away_from = "O0", jaws = [1, 0, 0] }', "gripper.jaws", "jaws_along_gripper"),
        ('[[figure.dimensions]]\nname = "L1"\nfrom = "O0"\nto = "O2"', "dimensions.0", "dimension_disagrees"),
        ('[[figure.dimensions]]\nname = "L1"\nfrom = "O0"\nto = "O0"', "dimensions.0", "dimension_disagrees"),
    ],
)
def test_a_figure_cannot_contradict_its_robot(tmp_path: Path, figure: str, place: str, code: str) -> None:
    text = changed("[[parts]]", f"[figure]\n{figure}\n\n[[parts]]")
    assert faults(folder(tmp_path, text))[f"two.exercise.toml.figure.{place}"] == code


def test_a_statement_speaks_of_what_is_there(tmp_path: Path) -> None:
    made = folder(tmp_path, statement="A link *L1*, a link *L7* and *emphasis of several words*.")
    assert faults(made) == {
        f"two.statement.{x}.md": "statement_name_unknown" for x in ("en", "ro", "pt", "fr", "uk", "es")
    }


@pytest.mark.parametrize("content", ["version = ", "version = 1\nversion = 2", "\x00"])
def test_what_is_not_toml_is_said_to_be_none(tmp_path: Path, content: str) -> None:
    assert faults(folder(tmp_path, content)) == {"two.exercise.toml": "exercise_file_not_toml"}


def test_a_folder_without_a_definition(tmp_path: Path) -> None:
    made = folder(tmp_path)
    (made / "exercise.toml").unlink()
    assert faults(made) == {"two.exercise.toml": "exercise_file_missing"}


def test_parts_with_values_are_read(tmp_path: Path) -> None:
    text = with_part('kind = "pose"\npoints = 5\njoints = [30, -45]')
    text = with_part('kind = "workspace"\npoints = 5\npoint = "P"\nlimits = [[0, 90], []]', text)
    text += '\n[figure]\nmarks = ["P"]\npoints.P = { frame = 2 }\n'
    found = load_exercise(folder(tmp_path, text))
    pose, workspace = found.parts[1:]
    assert isinstance(pose, PosePart)
    assert pose.joints.usual == (30, -45)
    assert isinstance(workspace, WorkspacePart)
    assert (workspace.origin, workspace.limits) == (None, ((0, 90), None))


@pytest.mark.parametrize(
    ("part", "place", "code"),
    [
        ('kind = "pose"\npoints = 5\njoints = [30]', "parts.1.joints", "joints_wrong_length"),
        ('kind = "table"\npoints = 5', "parts.1.kind", "part_twice"),
        ('kind = "workspace"\npoints = 5\npoint = "P"', "parts.1.point", "unknown_point"),
        (
            'kind = "workspace"\npoints = 5\npoint = "P"\nlimits = "catalogue"',
            "parts.1.limits",
            "exercise_limits_unknown",
        ),
        (
            'kind = "workspace"\npoints = 5\npoint = "P"\nlimits = [[1, 0], []]',
            "parts.1.limits.0",
            "exercise_limits_reversed",
        ),
        (
            'kind = "workspace"\npoints = 5\npoint = "P"\nlimits = [[0, 1]]',
            "parts.1.limits",
            "joints_wrong_length",
        ),
    ],
)
def test_a_fault_in_a_part_names_its_key(tmp_path: Path, part: str, place: str, code: str) -> None:
    assert faults(folder(tmp_path, with_part(part)))[f"two.exercise.toml.{place}"] == code


def test_own_folders_go_before_the_packaged_ones(tmp_path: Path) -> None:
    folder(tmp_path, name="two")
    folder(tmp_path, name="puma560")
    own = Library([tmp_path])
    own.read_own()
    assert {"two", "puma560", "rx90"} <= set(own.ids)
    assert own.exercise("puma560").titles["en"] == "Two"
    assert exercise("puma560").titles["en"] == "PUMA 560"


def test_a_start_checks_ones_own_exercises_and_not_the_packaged_ones(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    checked: list[str] = []
    read: list[str] = []

    def noting(exercise_id: str, files: Any, **options: bool) -> Exercise:
        read.append(exercise_id)
        return exercise_of_files(exercise_id, files, **options)

    def noted(found: Exercise) -> list[Fault]:
        checked.append(found.id)
        return []

    monkeypatch.setattr(loader, "inconsistencies", noted)
    monkeypatch.setattr(library, "exercise_of_files", noting)
    folder(tmp_path, name="two")
    Library([tmp_path]).read_own()
    assert checked == read == ["two"]


def test_a_malformed_exercise_of_ones_own_is_told_at_once(tmp_path: Path) -> None:
    folder(tmp_path, "version = 1", name="bad")
    with pytest.raises(DefinitionError, match=r"bad\.exercise\.toml"):
        Library([tmp_path]).read_own()
    with pytest.raises(DefinitionError, match="folder_missing"):
        Library([tmp_path / "nowhere"])


def test_an_exercise_asks_for_something(tmp_path: Path) -> None:
    text = changed('[[parts]]\nkind = "table"\npoints = 10\n', "")
    assert faults(folder(tmp_path, text)) == {"two.exercise.toml.parts": "nothing_asked"}


def test_any_one_language_is_enough_and_the_rest_falls_back(tmp_path: Path) -> None:
    made = folder(tmp_path, re.sub(r"^(en|ro|pt|fr|es) = .*\n", "", TWO_LINKS, flags=re.MULTILINE))
    for language in ("en", "ro", "pt", "fr", "es"):
        (made / f"statement.{language}.md").unlink()
    found = load_exercise(made)
    assert (found.text_language("fr"), found.title("fr"), found.statement("fr")) == (
        "uk",
        "Два",
        "Links *L1*, *L2*.",
    )
    (made / "statement.uk.md").unlink()
    assert faults(made) == {"two.statement.en.md": "statement_missing"}
    (made / "statement.en.md").write_text("Links.", encoding="utf-8")
    assert faults(made) == {"two.exercise.toml.title": "title_missing"}


def test_needs_that_the_policy_sees_to_are_kept(tmp_path: Path) -> None:
    text = changed("version = 1", 'version = 1\nneeds = ["L1", "L0"]')
    text = changed('theta = "q1", d = 0', 'theta = "q1", d = "L0"', text)
    text = changed("[parameters]", "[parameters]\nL0.value = 0.2", text)
    assert faults(folder(tmp_path, text)) == {"two.exercise.toml.needs.1": "need_unmet"}
    fixed = changed("[[parts]]", '[policy]\nbase = "origin"\ntool = "point"\n[[parts]]', text)
    assert load_exercise(folder(tmp_path, fixed)).needs == ("L1", "L0")


@pytest.mark.parametrize(
    ("policy", "rules"),
    [
        ("", 'base = "origin", tool = "point"'),
        ('base = "frame"', 'tool = "point"'),
        ('tool = "frame"', 'base = "origin"'),
    ],
)
def test_a_need_that_is_not_met_is_told_with_the_rules_that_lack(
    policy: str, rules: str, tmp_path: Path
) -> None:
    """Authors were told to fix the base, the tool or the zeros, whichever they had fixed already."""
    text = changed("version = 1", 'version = 1\nneeds = ["L0"]')
    text = changed('theta = "q1", d = 0', 'theta = "q1", d = "L0"', text)
    text = changed("[parameters]", "[parameters]\nL0.value = 0.2", text)
    text = changed("[[parts]]", f"[policy]\n{policy}\n[[parts]]", text)
    with pytest.raises(DefinitionError) as refused:
        load_exercise(folder(tmp_path, text))
    (fault,) = refused.value.faults
    assert (fault.code, fault.params) == ("need_unmet", {"name": "L0", "rules": rules})


def test_the_zeros_are_named_where_only_they_are_free(tmp_path: Path) -> None:
    text = changed("version = 1", 'version = 1\nneeds = ["L2"]')
    rows = '"prismatic", theta = 0, d = "q2 + L2", a = 0'
    text = changed('"revolute", theta = "q2", d = 0, a = "L2"', rows, text)
    fixed = '[policy]\nbase = "frame"\ntool = "frame"\n[[parts]]'
    with pytest.raises(DefinitionError) as refused:
        load_exercise(folder(tmp_path, changed("[[parts]]", fixed, text)))
    assert [fault.params["rules"] for fault in refused.value.faults] == ['zero = "figure"']


def test_weights_are_the_exercises(tmp_path: Path) -> None:
    found = load_exercise(folder(tmp_path, changed("[[parts]]", "[weights]\njoint = 3\n[[parts]]")))
    assert (found.weights.joint, found.weights.length) == (3.0, 1.0)
    text = changed("[[parts]]", "[weights]\nsign = 2\njoint = -1\ncolour = 1\n[[parts]]")
    assert faults(folder(tmp_path, text)) == {
        "two.exercise.toml.weights.sign": "weight_out_of_range",
        "two.exercise.toml.weights.joint": "weight_out_of_range",
        "two.exercise.toml.weights.colour": "exercise_key_unknown",
    }


def test_a_weight_out_of_range_is_told_its_own_range(tmp_path: Path) -> None:
    text = changed("[[parts]]", "[weights]\nsign = 2\njoint = -1\n[[parts]]")
    with pytest.raises(DefinitionError) as refused:
        load_exercise(folder(tmp_path, text))
    assert {fault.params["name"]: fault.params["most"] for fault in refused.value.faults} == {
        "sign": 1,
        "joint": 100,
    }
