"""The structure, the numeric pose and the workspace."""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from exercises.grading import Finding, HelpLevel
from exercises.instance import generate
from exercises.loader import load_exercise
from exercises.parts.forward.reach import reach
from exercises.parts.forward.schematic import AxisRelation, Schematic, schematic_of
from exercises.parts.forward.workspace import RadiiCells
from exercises.parts.motion.screws import ScrewsCells
from exercises.parts.report import Credit
from exercises.selftest.checks import check
from kinematics.answers.screw_answers import ScrewFrame, ScrewOrder
from kinematics.cells import bind_parameters
from kinematics.forward import forward_kinematics
from kinematics.table import Convention, DHRow, DHTable, JointType
from tests.exercises.answering import SCARA, codes, judged, part, table
from tests.exercises.folders import changed, folder
from tests.exercises.packaged import exercise
from tests.kinematics.robots import listed_numbers

R, P = JointType.REVOLUTE, JointType.PRISMATIC
ZERO = (0.0, 0.0, 0.0)
A = AxisRelation
PUMA = Schematic(
    joints=(R,) * 6,
    relations=(
        A.INTERSECTING_PERPENDICULAR,
        A.PARALLEL,
        A.SKEW_PERPENDICULAR,
        A.INTERSECTING_PERPENDICULAR,
        A.INTERSECTING_PERPENDICULAR,
    ),
)


# the structure


def test_the_structure_of_the_puma() -> None:
    assert schematic_of(listed_numbers("puma560")) == PUMA


@pytest.mark.parametrize(
    ("alpha", "a", "relation"),
    [
        (0.0, 0.0, A.COINCIDENT),
        (math.pi, 0.4, A.PARALLEL),
        (math.pi / 2, 0.0, A.INTERSECTING_PERPENDICULAR),
        (-math.pi / 2, 0.4, A.SKEW_PERPENDICULAR),
        (1.0, 0.0, A.INTERSECTING_OBLIQUE),
        (1.0, 0.4, A.SKEW_OBLIQUE),
    ],
)
def test_each_relation_of_two_axes(alpha: float, a: float, relation: AxisRelation) -> None:
    rows = (
        DHRow(joint=R, theta=0.0, d=0.3, a=a, alpha=alpha),
        DHRow(joint=R, theta=0.0, d=0.2, a=0.5, alpha=0.0),
    )
    assert schematic_of(DHTable(convention=Convention.STANDARD, rows=rows)).relations == (relation,)


def test_a_right_structure() -> None:
    report = part(judged("puma560", schematic=PUMA), "schematic")
    assert (report.correct, report.points, codes(report)) == (True, 15.0, ["schematic_right"])


def test_each_wrong_fact_costs_its_share() -> None:
    """The six revolute joints are worth no more than the five relations that nobody has for nothing."""
    wrong = Schematic(joints=(P, *PUMA.joints[1:]), relations=(A.PARALLEL, *PUMA.relations[1:]))
    report = part(judged("puma560", schematic=wrong), "schematic")
    assert report.score == pytest.approx(1 - (1 + 5 / 6) / 5)
    assert codes(report) == ["schematic_joint_type", "schematic_relation"]
    assert [fact.where for fact in report.facts if fact.finding is Finding.WRONG] == [
        ("joints", 0),
        ("relations", 0),
    ]


@pytest.mark.parametrize(
    ("given_relation", "code"),
    [
        (A.SKEW_PERPENDICULAR, "schematic_angle_right"),
        (A.INTERSECTING_OBLIQUE, "schematic_meeting_right"),
        (A.PARALLEL, "schematic_relation"),
    ],
)
def test_half_right_relations_are_told_as_such(given_relation: AxisRelation, code: str) -> None:
    wrong = Schematic(joints=PUMA.joints, relations=(given_relation, *PUMA.relations[1:]))
    assert codes(part(judged("puma560", schematic=wrong), "schematic")) == [code]
    at_row = judged("puma560", schematic=wrong, help_level=HelpLevel.ROW)
    assert codes(part(at_row, "schematic")) == ["schematic_relation"]
    at_verdict = part(judged("puma560", schematic=wrong, help_level=HelpLevel.VERDICT), "schematic")
    assert (codes(at_verdict), at_verdict.facts) == (["part_wrong"], ())


def test_a_sliding_axis_has_a_direction_and_no_place() -> None:
    """Whether the SCARA's slider is drawn on the axis of joint 4 or beside it says nothing."""
    for last in (A.COINCIDENT, A.PARALLEL):
        answer = Schematic(joints=(R, R, P, R), relations=(A.PARALLEL, A.COINCIDENT, last))
        assert part(judged("scara", schematic=answer), "schematic").correct
    answer = Schematic(joints=(R, R, P, R), relations=(A.COINCIDENT, A.PARALLEL, A.PARALLEL))
    assert not part(judged("scara", schematic=answer), "schematic").correct


def test_a_wrong_number_of_joints() -> None:
    short = Schematic(joints=PUMA.joints[:5], relations=PUMA.relations[:4])
    report = part(judged("puma560", schematic=short), "schematic")
    assert codes(report) == ["schematic_joint_count"]
    assert report.score == pytest.approx(1 - (1 + 5 / 6) / 5)


@pytest.mark.parametrize(
    ("exercise_id", "n", "relation", "score"),
    [
        ("puma560", 6, A.COINCIDENT, 0.0),
        ("puma560", 6, A.PARALLEL, 1 / 5),
        ("rx90", 6, A.INTERSECTING_PERPENDICULAR, 4 / 5),
        ("scara", 4, A.COINCIDENT, 0.0),
        ("scara", 4, A.PARALLEL, 1 / 2),
    ],
)
def test_revolute_joints_alone_earn_nothing(
    exercise_id: str, n: int, relation: AxisRelation, score: float
) -> None:
    same = Schematic(joints=(R,) * n, relations=(relation,) * (n - 1))
    assert part(judged(exercise_id, schematic=same), "schematic").score == pytest.approx(score)


def test_joints_that_the_robot_does_not_have_only_lose() -> None:
    scores = [
        part(judged("puma560", schematic=longer), "schematic").score
        for k in (0, 1, 2, 6, 57)
        for longer in [
            Schematic(
                joints=PUMA.joints + (R,) * k, relations=PUMA.relations + (A.INTERSECTING_PERPENDICULAR,) * k
            )
        ]
    ]
    assert scores == sorted(scores, reverse=True)
    assert scores[0] == 1.0
    assert scores[1] < 0.8


# the pose

POSE_JOINTS = [math.radians(30), math.radians(60), 0.1, math.radians(45)]


def scara_pose(raw: Any = SCARA) -> np.ndarray:
    from kinematics.cells import read_table

    values = {"a2": 0.4, "a3": 0.3}
    return forward_kinematics(bind_parameters(read_table(raw), values), POSE_JOINTS).transform


def test_a_right_pose_rounded_as_students_round() -> None:
    report = part(judged("scara", table=SCARA, pose=np.round(scara_pose(), 3).tolist()), "pose")
    assert (report.correct, report.points, codes(report)) == (True, 10.0, ["pose_right"])


def test_a_pose_may_hold_expressions_and_names() -> None:
    pose = [
        ["cos(45°)", "sin(45°)", 0, "a2*cos(30) + a3*cos(90)"],
        ["sqrt(2)/2", "-sqrt(2)/2", 0, "a2*sin(30) + a3"],
        [0, 0, -1, -0.1],
        [0, 0, 0, 1],
    ]
    assert part(judged("scara", table=SCARA, pose=pose), "pose").correct


def test_a_pose_that_follows_from_a_wrong_table() -> None:
    wrong = table("standard", (0, "a3", 0, "q1"), (180, "a2", 0, "q2"), (0, 0, "q3", 0), (0, 0, 0, "q4"))
    report = part(judged("scara", table=wrong, pose=scara_pose(wrong).tolist()), "pose")
    assert (report.correct, report.score, report.credit) == (False, 1.0, Credit.OWN_TABLE)
    assert codes(report) == ["pose_follows_table"]


def inverse(pose: np.ndarray) -> np.ndarray:
    return np.linalg.inv(pose)


def transposed(pose: np.ndarray) -> np.ndarray:
    other = pose.copy()
    other[:3, :3] = pose[:3, :3].T
    return other


def in_degrees(pose: np.ndarray) -> np.ndarray:
    from kinematics.cells import read_table

    numbers = bind_parameters(read_table(SCARA), {"a2": 0.4, "a3": 0.3})
    return forward_kinematics(numbers, [30, 60, 0.1, 45]).transform


def displaced(pose: np.ndarray) -> np.ndarray:
    other = pose.copy()
    other[0, 3] += 0.1
    return other


def with_another_last_row(pose: np.ndarray) -> np.ndarray:
    other = pose.copy()
    other[3] = [0, 0, 0, 2]
    return other


@pytest.mark.parametrize(
    ("change", "told", "score"),
    [
        (displaced, ["pose_wrong", "pose_rotation_right"], 0.5),
        (with_another_last_row, ["pose_wrong", "pose_last_row"], 0.0),
        (in_degrees, ["pose_wrong", "pose_degrees_as_radians"], 0.0),
        (lambda pose: np.eye(4), ["pose_wrong"], 0.0),
    ],
)
def test_a_wrong_pose_is_explained(change: Any, told: list[str], score: float) -> None:
    report = part(judged("scara", table=SCARA, pose=change(scara_pose()).tolist()), "pose")
    assert (report.score, codes(report)) == (score, told)


@pytest.mark.parametrize(
    ("change", "code"), [(inverse, "pose_inverse"), (transposed, "pose_rotation_transposed")]
)
def test_a_pose_turned_round_is_told(change: Any, code: str) -> None:
    two = table("standard", (0, "L1", 0, "q1"), (0, "L2", 0, "q2"))
    q = np.radians([30, 45])
    x, y = np.cos(q[0]) + np.cos(q.sum()), np.sin(q[0]) + np.sin(q.sum())
    c, s = np.cos(q.sum()), np.sin(q.sum())
    pose = np.array([[c, -s, 0, x], [s, c, 0, y], [0, 0, 1, 0], [0, 0, 0, 1]])
    report = part(judged("twolink", table=two, pose=change(pose).tolist()), "pose")
    assert code in codes(report)


def test_a_pose_by_the_students_own_closed_form() -> None:
    from tests.exercises.answering import SCARA_TRANSFORM

    report = judged("scara", transform=SCARA_TRANSFORM, pose=scara_pose().tolist())
    assert part(report, "pose").correct


def test_a_pose_in_millimetres_beside_a_table_in_metres() -> None:
    rows = (
        (-90, "a1", "d1", "q1"),
        (0, "a2", 0, "q2"),
        (-90, "a3", 0, "q3"),
        (90, 0, "d4", "q4"),
        (-90, 0, 0, "q5"),
    )
    dmra = table("standard", *rows, (0, 0, "d6", "q6"), length="m")
    joints = [math.radians(v) for v in (30, -60, 45, 90, -45, 60)]
    pose = forward_kinematics(listed_numbers("dmra"), joints).transform
    assert part(judged("dmra", table=dmra, pose=pose.tolist()), "pose").correct
    pose[:3, 3] /= 1000
    assert part(judged("dmra", table=dmra, pose=pose.tolist()), "pose").correct


def test_a_pose_beside_a_table_with_too_few_joints() -> None:
    short = table("standard", (0, "a2", 0, "q1"), (180, "a3", 0, "q2"))
    report = part(judged("scara", table=short, pose=np.eye(4).tolist()), "pose")
    assert (report.score, codes(report)) == (0.0, ["pose_wrong"])


# the workspace


def puma_radii(a2: float, a3: float, d3: float, d4: float) -> tuple[float, float]:
    """By hand: the wrist centre moves on circles about the elbow and the shoulder, d3 beside the shoulder."""
    forearm = math.hypot(a3, d4)
    return math.hypot(d3, a2 - forearm), math.hypot(d3, a2 + forearm)


def test_right_radii() -> None:
    values = generate(exercise("puma560"), "9").parameters
    inner, outer = puma_radii(values["a2"], values["a3"], values["d3"], values["d4"])
    report = part(
        judged("puma560", seed="9", workspace=RadiiCells(inner=round(inner, 3), outer=round(outer, 3))),
        "workspace",
    )
    assert (report.correct, codes(report)) == (True, ["workspace_right"])


@pytest.mark.parametrize(
    ("inner", "outer", "told", "score"),
    [
        (0.1, 0.7, ["workspace_right"], 1.0),
        ("a2 - a3", "a2 + a3", ["workspace_right"], 1.0),
        (0.2, 0.7, ["workspace_inner_wrong"], 0.5),
        (0.1, 0.8, ["workspace_outer_wrong"], 0.5),
        (0.7, 0.1, ["workspace_swapped", "workspace_inner_wrong", "workspace_outer_wrong"], 0.0),
        (0.2, 1.4, ["workspace_diameters", "workspace_inner_wrong", "workspace_outer_wrong"], 0.0),
    ],
)
def test_radii_of_the_scara(inner: Any, outer: Any, told: list[str], score: float) -> None:
    report = part(judged("scara", workspace=RadiiCells(inner=inner, outer=outer)), "workspace")
    assert (report.score, codes(report)) == (score, told)


@pytest.mark.parametrize(
    ("inner", "outer", "score"), [(0, 0, 0.0), (0, 1e9, 0.0), (50, 341.5, 0.5), (0, 341.5, 1.0)]
)
def test_a_least_distance_of_zero_earns_nothing_by_itself(inner: float, outer: float, score: float) -> None:
    """The desktop arm reaches its first axis: whoever leaves zeros in the cells knows nothing of it."""
    report = part(judged("dmra", workspace=RadiiCells(inner=inner, outer=outer)), "workspace")
    assert report.score == score


def screws(robot_id: str, *rows: tuple[Any, ...]) -> Any:
    """Screws (v, ω) in the fixed frame, with a home pose that turns nothing."""
    home = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))
    cells = ScrewsCells(frame=ScrewFrame.SPACE, order=ScrewOrder.LINEAR_FIRST, screws=rows, home=home)
    return part(judged(f"{robot_id}-screws", screws=cells), "screws")


def test_axes_that_all_lie_on_one_line_earn_nothing() -> None:
    """That of a SCARA's axes all are parallel to z is known before the figure has been looked at."""
    turn, slide = (0, 0, 0, 0, 0, 1), (0, 0, 1, 0, 0, 0)
    assert screws("scara", turn, turn, slide, turn).score == 0.0
    apart = (0, -0.4, 0, 0, 0, 1)
    assert screws("scara", turn, apart, slide, (0, -0.9, 0, 0, 0, 1)).score == 0.25


def test_screws_of_the_right_robot_are_told_the_rule_that_they_break() -> None:
    """The exercise asks for the last origin at P, on the axis of joint 4."""
    turn, slide, apart = (0, 0, 0, 0, 0, 1), (0, 0, 1, 0, 0, 0), (0, -0.4, 0, 0, 0, 1)
    found = screws("scara", turn, apart, slide, (0, -0.7, 0, 0, 0, 1))
    assert codes(found)[:2] == ["screws_right_robot", "tool_point_missed"]
    assert 0 < found.score < 1


def test_strict_screws_pass_their_own_tests(tmp_path: Path) -> None:
    """Screws of the tool's frame called screws of the fixed one describe this arm with another rule."""
    rules = 'base = "frame"\ntool = "frame"\nzero = "figure"\ndirection = "figure"'
    text = changed('kind = "table"', 'kind = "screws"')
    found = load_exercise(folder(tmp_path, changed("[[parts]]", f"[policy]\n{rules}\n[[parts]]", text)))
    assert not check(found, 1).failures


def test_radii_in_another_unit() -> None:
    report = part(judged("scara", table=SCARA, workspace=RadiiCells(inner=100, outer=700)), "workspace")
    assert codes(report)[0] == "workspace_other_length_unit"


def test_the_desktop_arm_reaches_as_far_as_its_document_says() -> None:
    """Seed 003 prints 340 mm: 45 + 115 + hypot(20, 130) + 50 = 341.5 mm from the first axis."""
    found = reach(listed_numbers("dmra"), ZERO, ZERO, (0.0, 0.0, 1.0), (None,) * 6)
    assert found.outer == pytest.approx(45 + 115 + math.hypot(20, 130) + 50, rel=1e-9)
    assert abs(found.outer - 340) < 2


@settings(max_examples=15)
@given(
    seed=st.integers(0, 10_000), robot_id=st.sampled_from(["puma560", "stanford", "scara", "kr100p", "uw"])
)
def test_no_configuration_lies_outside_the_radii(seed: int, robot_id: str) -> None:
    robot = listed_numbers(robot_id)
    rng = np.random.default_rng(seed)
    limits = [None if kind is R and rng.random() < 0.5 else (-0.7, 0.4) for kind in robot.joint_types]
    spans = [limit or (-math.pi, math.pi) for limit in limits]
    point, origin = rng.normal(size=3) * 0.2, rng.normal(size=3) * 0.2
    axis = (0.0, 0.0, 1.0) if rng.random() < 0.5 else None
    found = reach(robot, tuple(point.tolist()), tuple(origin.tolist()), axis, tuple(limits))
    low, high = np.array(spans).T
    for q in low + rng.random((150, len(spans))) * (high - low):
        pose = forward_kinematics(robot, q).transform
        away = pose[:3, :3] @ point + pose[:3, 3] - origin
        if axis is not None:
            away = away - (away @ axis) * np.array(axis)
        distance = np.linalg.norm(away)
        assert found.inner - 1e-6 <= distance <= found.outer + 1e-6


def test_a_slide_without_limits_rests() -> None:
    rests = (*(None,) * 2, (0.0, 0.0), *(None,) * 3)
    free = reach(listed_numbers("stanford"), ZERO, ZERO, None, (None,) * 6)
    assert free == reach(listed_numbers("stanford"), ZERO, ZERO, None, rests)
