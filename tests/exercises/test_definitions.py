"""Every definition of the package, tested by itself; EXERCISE_SEEDS=50 tries more seeds, every mistake."""

import os
import re
from pathlib import Path

import pytest

from exercises.consistency import inconsistencies
from exercises.definition import LANGUAGES
from exercises.errors import DefinitionError
from exercises.grading import ToolRule
from exercises.loader import load_exercise
from exercises.parts.registry import part_type
from exercises.selftest.checks import check
from exercises.statements import names_in
from kinematics import catalogue
from tests.exercises.folders import TWO_LINKS, changed, folder, with_part
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


def of_a_scara(height: str) -> str:
    """A definition in which the third joint slides, and the height of the arm above it has this name."""
    second = 'd = 0, a = "L2", alpha = 0 },'
    slide = '  { joint = "prismatic", theta = 0, d = "q3", a = 0, alpha = 0 },'
    rows = changed(second, f'd = "{height}", a = "L2", alpha = 180 }},\n{slide}')
    return changed("L2.value = 0.3", f"L2.value = 0.3\n{height}.value = 0.06", rows)


@pytest.mark.parametrize(("height", "told"), [("d3", True), ("d2", False), ("h", False)])
def test_a_dimension_named_as_a_slide_is_told_to_the_author(height: str, told: bool, tmp_path: Path) -> None:
    """In other frames it stands beside the variable, q3 + d3: that was called a crash of the grading."""
    found = check(load_exercise(folder(tmp_path, of_a_scara(height))), 3)
    assert found.failures == []
    taken = [one.params for one in found.warnings if one.check == "taken_by_slide"]
    assert taken == [{"name": "d3", "joint": "3"}] * told


@pytest.mark.parametrize(
    ("height", "part", "told"),
    [("c1", "link_matrices", True), ("cs1", "link_matrices", False), ("s23", None, False)],
)
def test_a_dimension_named_as_a_cosine_is_told_to_the_author(
    height: str, part: str | None, told: bool, tmp_path: Path
) -> None:
    """In a matrix it cannot be written: all that was told is that a right answer is rejected."""
    text = of_a_scara(height)
    text = with_part(f'kind = "{part}"\npoints = 5', text) if part else text
    found = check(load_exercise(folder(tmp_path, text)), 1)
    taken = [one.params for one in found.warnings if one.check == "taken_by_short_form"]
    assert taken == [{"name": height}] * told


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


TABLE_ALONE = '\n[[parts]]\nkind = "table"\npoints = 10\n'
ANGLES = 'kind = "orientation"\naxes = "ZYX"\nangles = [30, 20, 10]\n'
CHAIN = 'kind = "frame_chain"\njoints = [30, 45]\nknown = [{ from = 0, to = 1 }, { from = 1, to = 2 }]\n'


def asking_only(part: str, text: str = TWO_LINKS) -> str:
    """A definition that asks for one part and no table."""
    return with_part(f"{part}points = 10", changed(TABLE_ALONE, "", text))


@pytest.mark.parametrize(
    ("part", "told"),
    [
        (f'{ANGLES}given = "matrix"\nask = ["matrix"]\n', True),
        (f'{ANGLES}given = "angles"\nask = ["angles"]\n', True),
        (f'{ANGLES}given = "angles"\nask = ["angles"]\nasked_axes = "ZYZ"\n', False),
        (f'{ANGLES}given = "angles"\nask = ["every_triple"]\n', False),
        (f"{CHAIN}asked = {{ from = 0, to = 1 }}\n", True),
        (f"{CHAIN}asked = {{ from = 1, to = 0 }}\n", False),
    ],
)
def test_an_author_is_warned_of_a_task_that_shows_what_it_asks_for(
    part: str, told: bool, tmp_path: Path
) -> None:
    found = check(load_exercise(folder(tmp_path, asking_only(part))), 1)
    assert found.failures == []
    assert ("asked_as_shown" in {one.check for one in found.warnings}) is told


WEIGHED = 'kind = "equations_of_motion"\nask = ["gravity"]\nlinks = [{ mass = 0 }, { mass = 2 }]\n'
SLIDER = changed(
    '"revolute", theta = "q2", d = 0, a = "L2"',
    '"prismatic", theta = 0, d = "q2", a = 0',
    changed("L2.value = 0.3\n", ""),
)


@pytest.mark.parametrize(
    ("gravity", "upright", "told"),
    [
        ("[0, 0, 0]", "0", False),
        ("[0, 0, -9.81]", "0", False),
        ("[0, 0, 9.81]", "0", True),
        ("[0, -9.81, 0]", "0", True),
        ("[0, -9.81, 0]", "90", False),
        ("[0, -9.81, 0]", "-90", True),
    ],
)
def test_an_author_is_warned_of_gravity_that_does_not_point_down_in_the_figure(
    gravity: str, upright: str, told: bool, tmp_path: Path
) -> None:
    text = asking_only(f"{WEIGHED}gravity = {gravity}\n") + f"[figure]\nupright = {{ roll = {upright} }}\n"
    found = check(load_exercise(folder(tmp_path, text)), 0)
    assert ("gravity_not_down" in {one.check for one in found.warnings}) is told


@pytest.mark.parametrize(("q2", "told"), [(0, True), (0.2, False)])
def test_an_author_is_warned_of_frames_that_coincide_in_the_figure(
    q2: float, told: bool, tmp_path: Path
) -> None:
    text = asking_only('kind = "frame_mistake"\n', SLIDER) + f"[figure]\nposture = [30, {q2}]\n"
    found = check(load_exercise(folder(tmp_path, text, statement="Link *L1*.")), 0)
    assert ("frames_coincide" in {one.check for one in found.warnings}) is told


WORKSPACE = 'kind = "workspace"\npoint = "P"\nlimits = {limits}\n'
UNDER_RULES = """
[policy]
tool = "point"
direction = "{direction}"

[figure]
posture = [0, {drawn}]
marks = ["P"]
points.P = {{ frame = 2 }}
"""


@pytest.mark.parametrize(
    ("limits", "drawn", "direction", "told"),
    [
        ("[[], [-20, 120]]", 30, "free", True),
        ("[[], [-20, 120]]", 30, "figure", False),
        ("[[], [-20, 80]]", 30, "free", False),
        ("[[], [0, 120]]", 0, "free", False),
        ("[[-20, 120], []]", 30, "free", False),
    ],
)
def test_an_author_is_warned_of_limits_whose_sense_is_free_and_matters(
    limits: str, drawn: int, direction: str, told: bool, tmp_path: Path
) -> None:
    """They may lie about where the joint is drawn, or the arm may be its own mirror image."""
    part = asking_only(WORKSPACE.format(limits=limits))
    text = part + UNDER_RULES.format(drawn=drawn, direction=direction)
    found = check(load_exercise(folder(tmp_path, text)), 1)
    assert found.failures == []
    assert ("limits_ambiguous" in {one.check for one in found.warnings}) is told


def test_no_shipped_exercise_warns_of_its_parts() -> None:
    for name in exercise_ids:
        found = exercise(name)
        assert not [code for part in found.parts for code in part_type(part.kind).warnings(part, found)], name


@pytest.mark.parametrize("kind", ["transform", "link_matrices"])
def test_matrices_may_be_asked_without_a_table(kind: str, tmp_path: Path) -> None:
    """Their own wrong answers were refused, or explained by a table that nobody asks for."""
    assert check(load_exercise(folder(tmp_path, asking_only(f'kind = "{kind}"\n'))), 2).failures == []


GANTRY = """rows = [
  { joint = "prismatic", theta = 0, d = "q1", a = 0, alpha = -90 },
  { joint = "prismatic", theta = -90, d = "q2", a = 0, alpha = 90 },
]
"""
JOINTS_OF = 'kind = "inverse_kinematics"\nreach = "position"\njoints = '


def of_a_gantry(part: str) -> str:
    """A definition that asks for one part about two sliders."""
    start, end = TWO_LINKS.index("rows = ["), TWO_LINKS.index("[[parts]]")
    return asking_only(part, f"{TWO_LINKS[:start]}{GANTRY}\n{TWO_LINKS[end:]}")


@pytest.mark.parametrize("folded", [False, True], ids=["no hinge", "a hinge that may stand anywhere"])
def test_joint_values_are_asked_of_an_arm_whose_first_joint_cannot_be_wrong(
    folded: bool, tmp_path: Path
) -> None:
    """The self-test's answer with the first hinge half a turn off did not exist, or was right."""
    if folded:
        text = asking_only(
            f"{JOINTS_OF}[30, 180]\n", TWO_LINKS.replace('"L2"', '"L1"').replace("L2.value = 0.3", "")
        )
    else:
        text = of_a_gantry(f"{JOINTS_OF}[0.2, 0.3]\n")
    found = check(load_exercise(folder(tmp_path, text, statement="An arm.")), 1)
    assert found.failures == []


@pytest.mark.parametrize(
    ("part", "code"),
    [
        ('kind = "pose"\njoints = [30, 45]\n', "pose_without_table"),
        ('kind = "jacobian"\njoints = [30, 45]\naxes = "ZYZ"\n', "angles_locked"),
    ],
)
def test_a_part_that_no_answer_can_be_right_for_is_refused(part: str, code: str, tmp_path: Path) -> None:
    with pytest.raises(DefinitionError) as refused:
        load_exercise(folder(tmp_path, asking_only(part)))
    assert [fault.code for fault in refused.value.faults] == [code]


def test_an_arm_that_reaches_everything_is_asked_for_no_pose_out_of_reach(tmp_path: Path) -> None:
    """Students who were to find that there is no solution would have found one."""
    out = 'cases = ["reached", "out_of_reach"]\n'
    with pytest.raises(DefinitionError) as refused:
        load_exercise(folder(tmp_path, of_a_gantry(f"{JOINTS_OF}[0.2, 0.3]\n{out}"), statement="An arm."))
    told = [(fault.code, fault.where[-3:]) for fault in refused.value.faults]
    assert told == [("pose_within_reach", ("parts", 0, "cases"))]
    short = folder(tmp_path, asking_only(f"{JOINTS_OF}[30, 45]\n{out}"), name="short")
    assert load_exercise(short).part("inverse_kinematics") is not None
