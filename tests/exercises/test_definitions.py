"""Every definition of the package, tested by itself; EXERCISE_SEEDS=50 tries more seeds, every mistake."""

from __future__ import annotations

import os
import re
from pathlib import Path

import pytest

from exercises.consistency import inconsistencies
from exercises.definition import LANGUAGES
from exercises.grading import ToolRule
from exercises.loader import load_exercise
from exercises.selftest.checks import check
from exercises.statements import names_in
from kinematics import catalogue
from tests.exercises.folders import TWO_LINKS, changed, folder
from tests.exercises.packaged import exercise, exercise_ids, table_ids

SEEDS = int(os.environ.get("EXERCISE_SEEDS", "0"))
ALL = exercise_ids
ROBOTS = sorted(set(table_ids) & set(catalogue.robot_ids()))


def test_every_robot_of_the_documents_is_an_exercise() -> None:
    others = {"gen3", "iiwa14", "irb140", "lrmate200id", "panda", "ur10", "ur5"}
    assert set(catalogue.robot_ids()) == {*ROBOTS, *others}
    assert len(ROBOTS) == 16


@pytest.mark.parametrize("exercise_id", ALL)
def test_the_pieces_of_a_definition_fit_together(exercise_id: str) -> None:
    assert not list(inconsistencies(exercise(exercise_id)))


@pytest.mark.parametrize("exercise_id", ALL)
def test_a_definition_tests_itself(exercise_id: str) -> None:
    findings = check(exercise(exercise_id), SEEDS or 1, None if SEEDS else 3)
    assert not findings.failures
    if exercise_id not in table_ids:
        return
    assert findings.passed["right"] == findings.passed["certificate"] == 2 * (SEEDS or 1) + 2
    assert findings.passed["invalid"] == 6


@pytest.mark.parametrize(("unit", "angle"), [("deg", "38.5"), ("rad", "0.672")])
def test_angles_with_names_are_tried_rounded_too(tmp_path: Path, unit: str, angle: str) -> None:
    """To four digits of the unit in which they are typed, under each tool rule and the usual one."""
    twisted = changed('q1", d = 0, a = "L1", alpha = 0', 'q1", d = 0, a = "L1", alpha = "beta"')
    text = changed('angle_unit = "deg"', f'angle_unit = "{unit}"', twisted)
    text = changed("L2.value = 0.3", f"L2.value = 0.3\nbeta.value = {angle}", text)
    findings = check(load_exercise(folder(tmp_path, text, statement="Links *L1*, *L2*, twist *beta*.")), 1)
    assert not findings.failures
    assert findings.passed["rounded"] == 2 * (1 + len(ToolRule))


@pytest.mark.parametrize("exercise_id", ROBOTS)
def test_a_definition_asks_for_the_table_the_matrices_and_a_pose(exercise_id: str) -> None:
    found = exercise(exercise_id)
    asked = {part.kind for part in found.parts}
    assert {"table", "link_matrices", "transform", "pose"} <= asked
    assert found.points == 100
    assert len(found.misconceptions) >= 10


@pytest.mark.parametrize("exercise_id", ["puma560", "scara", "rx90"])
def test_the_model_exercises_ask_for_every_part(exercise_id: str) -> None:
    assert {part.kind for part in exercise(exercise_id).parts} == {
        "table",
        "link_matrices",
        "transform",
        "pose",
        "schematic",
        "workspace",
    }


@pytest.mark.parametrize("exercise_id", ALL)
def test_statements_speak_of_the_same_names_in_every_language(exercise_id: str) -> None:
    found = exercise(exercise_id)
    names = {language: names_in(found.statements[language]) for language in LANGUAGES}
    assert set(names) == set(LANGUAGES)
    assert all(found_names == names["en"] for found_names in names.values())
    figure = set(found.figure.marks) | {mark.name for mark in found.figure.dimensions}
    told = names["en"] | figure
    assert {parameter.name for parameter in found.parameters} <= told


@pytest.mark.parametrize("exercise_id", ALL)
def test_every_dimension_stands_in_the_figure(exercise_id: str) -> None:
    found = exercise(exercise_id)
    drawn = {mark.name for mark in found.figure.dimensions}
    assert drawn == {parameter.name for parameter in found.parameters}


@pytest.mark.parametrize("exercise_id", ALL)
def test_statements_are_written_in_their_language(exercise_id: str) -> None:
    """Each language has letters or words that the others lack; none is the copy of another."""
    found = exercise(exercise_id)
    texts = [found.statements[language] for language in LANGUAGES]
    assert len(set(texts)) == len(LANGUAGES)
    assert re.search("[а-яіїє]", found.statements["uk"])
    assert re.search("[ăâîșț]", found.statements["ro"])
    assert re.search(r"\b(eixos?|juntas?|elos?|referenciais)\b", found.statements["pt"])
    assert re.search(r"\b(axe|articulation|segment|repère)s?\b", found.statements["fr"])
    assert re.search(r"\b(eje|articulación|articulaciones|eslabón|sistema)s?\b", found.statements["es"])
    assert not re.search("[ţşŢŞ]", found.statements["ro"])  # the cedilla is not Romanian


@pytest.mark.parametrize("language", LANGUAGES)
def test_titles_call_a_robot_by_one_name(language: str) -> None:
    """What stands before the colon is the robot's name, as in the title of the exercise on its table."""
    names = {robot: exercise(robot).title(language).split(":")[0].strip() for robot in ROBOTS}
    for found in map(exercise, ALL):
        assert found.robot is None or found.title(language).startswith(names[found.robot])


@pytest.mark.parametrize(
    ("drawn", "told"),
    [
        ("0.3, to = 0.3, step = 0.1", True),
        ("0.3, to = 0.303, step = 0.003", True),
        ("0.4, to = 0.6, step = 0.1", False),
    ],
)
def test_lengths_that_may_be_exchanged_unseen_are_told_to_the_author(
    drawn: str, told: bool, tmp_path: Path
) -> None:
    found = load_exercise(folder(tmp_path, changed("0.4, to = 0.6, step = 0.1", drawn)))
    alike = [one.params for one in check(found, 1).warnings if one.check == "alike"]
    assert alike == [{"name": "L1", "other": "L2"}] * told


@pytest.mark.parametrize(
    ("drawn", "told"), [("-0.4, to = 0.6, step = 0.01", True), ("0.4, to = 0.6, step = 0.1", False)]
)
def test_a_value_that_few_students_have_and_that_changes_the_robot_is_a_failure(
    drawn: str, told: bool, tmp_path: Path
) -> None:
    """One length in a hundred is zero, so that the axes coincide."""
    found = load_exercise(folder(tmp_path, changed("0.4, to = 0.6, step = 0.1", drawn)))
    failed = [one.params for one in check(found, 1).failures if one.check == "drawn_structure"]
    assert failed == [{"name": "L1", "value": "0"}] * told


WEIGHTLESS = "\n[weights]\n" + "".join(
    f"{fact} = 0\n" for fact in ("joint", "twist", "length", "offset", "rule")
)
FIXED = TWO_LINKS.replace("revolute", "fixed").replace('"q1"', "0").replace('"q2"', "0")


@pytest.mark.parametrize(
    ("text", "told"),
    [(TWO_LINKS, set()), (TWO_LINKS + WEIGHTLESS, {"nothing_earned"}), (FIXED, {"no_joints"})],
    ids=["usual", "weights of zero", "no joints"],
)
def test_where_no_answer_can_earn_a_part_the_author_is_told(
    text: str, told: set[str], tmp_path: Path
) -> None:
    found = check(load_exercise(folder(tmp_path, text)), 0)
    assert {one.check for one in found.warnings} - {"unneeded", "alike"} == told
