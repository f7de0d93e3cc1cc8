"""Inverse kinematics in symbols against numbers: every branch reaches, and every solution is a branch."""

import math

import numpy as np
import pytest

from kinematics.catalogue import robots
from kinematics.cells import AngleUnit, RawRow, RawTable, bind_parameters, parameter_values, read_table
from kinematics.errors import TableError
from kinematics.forward import end_pose
from kinematics.inverse import ArmReach, solver_of
from kinematics.inverse_forms import ConditionKind, InverseReach, inverse_form, joint_values
from kinematics.inverse_forms.outer_frames import inverse_form_in_world
from kinematics.table import Convention, JointType
from tests.conftest import EXPLORE
from tests.kinematics.inverse.models import MODELS

POSES = 50 if EXPLORE else 10
NO_FORM = {"gen3", "iiwa14", "panda", "ssrms"}
"""Seven joints, and arms whose axes are not taken apart so."""


def apart(numbers, q, others):
    turning = np.array([kind is JointType.REVOLUTE for kind in numbers.joint_types])
    difference = np.asarray(others, dtype=float).reshape(-1, len(q)) - q
    turned = (difference + math.pi) % math.tau - math.pi
    return np.abs(np.where(turning, turned, difference)).max(axis=1)


def drawn(rng, numbers):
    size = max(np.abs([(row.a, row.d) for row in numbers.rows]).max(), 1.0)
    kinds = numbers.joint_types
    return [
        rng.uniform(-3, 3) if kind is JointType.REVOLUTE else size * rng.uniform(-1, 1) for kind in kinds
    ], size


def branches_reach(symbols, numbers, values, seed=1):
    """Every branch's residual is rounding, its own configuration is one, and it has all the solver's."""
    form = inverse_form_in_world(symbols)
    rng = np.random.default_rng(seed)
    reach = ArmReach.POSE if form.reach is InverseReach.POSE else ArmReach.POSITION
    solver = solver_of(numbers, reach=reach)
    for _ in range(POSES):
        q, size = drawn(rng, numbers)
        target = end_pose(numbers, q)
        found = [joints for _, joints in joint_values(form, target, values)]
        for joints in found:
            off = end_pose(numbers, joints) - target
            off[:3, 3] /= size
            assert np.abs(off if reach is ArmReach.POSE else off[:3, 3]).max() < 1e-12
        assert apart(numbers, q, found).min() < 1e-6
        answer = solver.solve(target)
        if answer.complete:
            assert len(found) == len(answer.solutions)
            for solution in answer.solutions:
                assert apart(numbers, solution.joints, found).min() < 1e-6
    return form


@pytest.mark.parametrize("robot", [r for r in robots() if r.id not in NO_FORM], ids=lambda r: r.id)
def test_catalogue(robot):
    values = parameter_values(robot.table.parameters, robot.table.angle_unit, robot.parameters)
    form = branches_reach(robot.table.table, MODELS[f"catalogue {robot.id}"], values)
    assert len(form.branches) <= 3
    assert {step.joint for step in form.steps} - {0} == set(range(1, robot.table.table.n_joints + 1))


@pytest.mark.parametrize("robot_id", sorted(NO_FORM))
def test_arms_without_such_a_form_are_refused(robot_id):
    (robot,) = (r for r in robots() if r.id == robot_id)
    with pytest.raises(TableError) as refused:
        inverse_form(robot.table.table)
    assert refused.value.faults[0].code == "inverse_form_unknown"


def table_of(convention, *rows):
    return read_table(
        RawTable(
            convention=convention,
            angle_unit=AngleUnit.DEG,
            rows=tuple(RawRow(theta=theta, d=d, a=a, alpha=alpha) for alpha, a, d, theta in rows),
        )
    )


STANDARD, MODIFIED = Convention.STANDARD, Convention.MODIFIED
ARMS = {
    "Universal Robots": table_of(
        STANDARD,
        (90, 0, "d1", "q1"),
        (0, "a2", 0, "q2"),
        (0, "a3", 0, "q3"),
        (90, 0, "d4", "q4"),
        (-90, 0, "d5", "q5"),
        (0, 0, "d6", "q6"),
    ),
    "Universal Robots, modified": table_of(
        MODIFIED,
        (0, 0, "d1", "q1"),
        (90, 0, 0, "q2 + 180"),
        (0, "a2", 0, "q3"),
        (0, "a3", "d4", "q4 - 90"),
        (90, 0, "d5", "-q5"),
        (-90, 0, "d6", "q6 + gamma"),
    ),
    "Stanford": table_of(
        STANDARD,
        (-90, 0, "d1", "q1"),
        (90, 0, "d2", "q2"),
        (0, 0, "q3", -90),
        (-90, 0, 0, "q4"),
        (90, 0, 0, "q5"),
        (0, 0, "d6", "q6"),
    ),
    "anthropomorphic with an offset, a wrist": table_of(
        STANDARD,
        (90, "a1", "d1", "q1"),
        (0, "a2", 0, "q2"),
        (90, "a3", 0, "q3"),
        (-90, 0, "d4", "q4"),
        (90, 0, 0, "q5"),
        (0, 0, "d6", "q6"),
    ),
    "gantry with a wrist": table_of(
        STANDARD,
        (-90, 0, "q1", -90),
        (-90, 0, "q2", -90),
        (0, 0, "q3", 0),
        (-90, 0, 0, "q4"),
        (90, 0, 0, "q5"),
        (0, 0, "d6", "q6"),
    ),
    "two parallel axes, a wrist": table_of(
        STANDARD,
        (0, "a1", "d1", "q1"),
        (0, "a2", 0, "q2"),
        (-90, 0, 0, "q3"),
        (90, 0, 0, "q4"),
        (0, 0, "d5", "q5"),
    ),
    "two parallel axes, an elbow across, a wrist": table_of(
        STANDARD,
        (0, "a1", "d1", "q1"),
        (90, "a2", 0, "q2"),
        (90, "a3", 0, "q3"),
        (-90, 0, "d4", "q4"),
        (90, 0, 0, "q5"),
        (0, 0, "d6", "q6"),
    ),
    "a rail across, a turn, an elbow across, a wrist": table_of(
        STANDARD,
        (-90, 0, "q1", 0),
        (90, "a2", "d2", "q2"),
        (90, "a3", 0, "q3"),
        (-90, 0, "d4", "q4"),
        (90, 0, 0, "q5"),
        (0, 0, "d6", "q6"),
    ),
    "a turn, a slide out, an elbow across, a wrist": table_of(
        STANDARD,
        (-90, 0, "d1", "q1"),
        (0, 0, "q2", 90),
        (-90, 0, "d3", "q3"),
        (90, 0, "d4", "q4"),
        (-90, 0, 0, "q5"),
        (0, 0, "d6", "q6"),
    ),
    "RRP with an offset": table_of(STANDARD, (-90, 0, "d1", "q1"), (90, 0, "d2", "q2"), (0, 0, "q3", 0)),
    "RPR": table_of(STANDARD, (90, 0, 0, "q1"), (-90, 0, "q2", 0), (0, "a3", 0, "q3")),
    "planar 3R": table_of(STANDARD, (0, "l1", 0, "q1"), (0, "l2", 0, "q2"), (0, "l3", 0, "q3")),
    "articulated 3R": table_of(STANDARD, (90, 0, "h", "q1"), (0, "l1", 0, "q2"), (0, "l2", 0, "q3")),
    "cylindrical": table_of(STANDARD, (0, 0, "h", "q1"), (-90, 0, "q2", 0), (0, 0, "q3", 0)),
    "spherical": table_of(STANDARD, (-90, 0, "h", "q1"), (90, 0, "s", "q2"), (0, 0, "q3", 0)),
    "Cartesian": table_of(STANDARD, (-90, 0, "q1", -90), (-90, 0, "q2", -90), (0, 0, "q3", 0)),
    "SCARA, slide first": table_of(
        STANDARD, (0, 0, "q1", 0), (0, "l1", 0, "q2"), (0, "l2", 0, "q3"), (0, 0, 0, "q4")
    ),
    "cylindrical with a wrist": table_of(
        STANDARD,
        (0, 0, "h", "q1"),
        (-90, 0, "q2", 0),
        (0, 0, "q3", 0),
        (-90, 0, 0, "q4"),
        (90, 0, 0, "q5"),
        (0, 0, "l6", "q6"),
    ),
    "roll, pitch, yaw": table_of(
        STANDARD,
        (90, 0, "h", "q1"),
        (0, "l1", 0, "q2"),
        (90, "l2", 0, "q3"),
        (90, 0, "l4", "q4 + 90"),
        (90, 0, 0, "q5 + 90"),
        (0, 0, "l6", "q6"),
    ),
    "palletizer": table_of(
        STANDARD, (90, "a1", "h", "q1"), (0, "l1", 0, "q2"), (0, "l2", 0, "-q3"), (0, "l3", 0, "q4")
    ),
    "offsets of any angle": table_of(
        STANDARD, (0, "l1", 0, "q1 + beta"), (0, "l2", 0, "q2 - 20"), (0, "l3", 0, "-q3 + 10")
    ),
    "PUMA, modified": table_of(
        MODIFIED,
        (0, 0, 0, "q1"),
        (-90, 0, 0, "q2"),
        (0, "a2", "d3", "q3"),
        (-90, "a3", "d4", "q4"),
        (90, 0, 0, "q5"),
        (-90, 0, 0, "q6"),
    ),
    "three joints, a wrist of two": table_of(
        STANDARD,
        (90, 0, "h", "q1"),
        (0, "l1", 0, "q2"),
        (90, 0, 0, "q3"),
        (90, 0, "l4", "q4"),
        (0, "l5", 0, "q5"),
    ),
    "one turn": table_of(STANDARD, (90, "l1", "h", "q1")),
    "one slide": table_of(STANDARD, (90, "l1", "q1", 90)),
    "pan and tilt": table_of(STANDARD, (90, 0, "h", "q1"), (0, "l1", "l2", "q2")),
    "a wrist alone": table_of(STANDARD, (-90, 0, "h", "q1"), (90, 0, 0, "q2"), (0, "l1", "l3", "q3")),
    "a wrist on a slide": table_of(
        STANDARD, (90, 0, "q1", 0), (-90, 0, 0, "q2"), (90, 0, 0, "q3"), (0, 0, "l4", "q4")
    ),
    "planar 3R with a turn across": table_of(
        STANDARD, (0, "l1", "h", "q1"), (0, "l2", 0, "q2"), (90, 0, 0, "q3"), (0, "l4", "h4", "q4")
    ),
    "a slide, and a turn that moves no point": table_of(
        STANDARD, (0, 0, "q1", 0), (180, "l2", "h", "q2"), (180, "l3", 0, "q3"), (0, 0, 0, "q4")
    ),
}
IDLE = {
    "two turns about one axis": table_of(STANDARD, (0, 0, "h", "q1"), (0, 0, 0, "q2"), (0, 0, 0, "q3")),
    "a link, and a turn that moves no point": table_of(STANDARD, (180, "l1", 0, "q1"), (0, 0, "h", "q2")),
}


@pytest.mark.parametrize("name", ARMS)
def test_arms_of_the_books(name):
    read = ARMS[name]
    rng = np.random.default_rng(3)
    given = {parameter: float(rng.uniform(0.2, 0.9)) for parameter in read.parameters}
    values = parameter_values(read.parameters, read.angle_unit, given)
    branches_reach(read.table, bind_parameters(read, given), values)


PUMA = [
    (90, 0, 0, "q1"),
    (0, "a2", 0, "q2"),
    (-90, "a3", "d3", "q3"),
    (90, 0, "d4", "q4"),
    (-90, 0, 0, "q5"),
    (0, 0, "d6", "q6"),
]
TURNED = {
    "two links, bent": table_of(STANDARD, (0, 0.4, 0, "q1"), (0, 0.1, 0, 30), (0, 0.3, 0, "q2")),
    "two links, bent the other way round": table_of(
        STANDARD, (180, "l1", "h", "q1 + 10"), (0, "l2", 0.2, 30), (0, 0.1, 0, "beta"), (0, "l3", 0, "-q2")
    ),
    "two links, bent, modified": table_of(
        MODIFIED, (0, 0, 0, "q1"), (0, "l1", 0, 30), (0, "l2", 0, "q2"), (0, "l3", 0, 0)
    ),
    "two links behind a fixed row": table_of(
        STANDARD, (90, 0.1, 0.2, 20), (0, 0.4, 0, "q1"), (0, 0.3, 0, "q2")
    ),
    "PUMA behind a fixed row that turns": table_of(STANDARD, (0, 0.1, 0.2, 20), *PUMA),
    "PUMA behind a fixed row that tilts": table_of(STANDARD, (30, 0.1, 0.2, 0), *PUMA),
    "PUMA with a tilted tool": table_of(STANDARD, *PUMA, (30, 0.1, 0.2, 20)),
    "PUMA on a tilted foot, its tool tilted": table_of(
        STANDARD, (0, "b", 0, 40), ("gamma", 0, 0.1, 0), *PUMA, (0, 0.1, 0, 20), ("gamma", 0, 0, 0)
    ),
    "SCARA, bent, slide between": table_of(
        STANDARD, (0, "l1", 0, "q1"), (0, 0, "q2", 0), (0, "l2", 0, 25), (0, "l3", 0, "q3"), (0, 0, 0, "q4")
    ),
}


@pytest.mark.parametrize("name", TURNED)
def test_fixed_rows_turned_by_any_angle(name):
    read = TURNED[name]
    rng = np.random.default_rng(4)
    given = {parameter: float(rng.uniform(0.2, 0.9)) for parameter in read.parameters}
    values = parameter_values(read.parameters, read.angle_unit, given)
    branches_reach(read.table, bind_parameters(read, given), values)


@pytest.mark.parametrize(
    ("rows", "where"),
    [
        ([(0, 0.4, 0, "q1"), (30, 0.1, 0, 0), (0, 0.3, 0, "q2")], ("rows", 1, "alpha")),
        ([(90, 0.4, 0, "q1"), (0, 0.1, 0, 30), (0, 0.3, 0, "q2")], ("rows", 1, "theta")),
        ([(20, 0.4, 0, 0), (0, 0.1, 0, "q1"), (30, 0, 0, 0), (0, 0.3, 0, "q2")], ("rows", 2, "alpha")),
        ([(30, 0.4, 0, "q1"), (0, 0.3, 0, "q2")], ("rows", 0, "alpha")),
    ],
)
def test_the_cell_that_leaves_axes_oblique_is_named(rows, where):
    with pytest.raises(TableError) as refused:
        inverse_form_in_world(table_of(STANDARD, *rows).table)
    assert [(each.code, each.where) for each in refused.value.faults] == [("inverse_form_unknown", where)]


@pytest.mark.parametrize("right", [math.pi / 2, 1.570796326794896, 1.57079632679490, 1.570796326794898])
@pytest.mark.parametrize("noise", ["-1.3e-33", "6.1e-17", "5e-324"])
@pytest.mark.parametrize("lengths", [("L1", "L2"), ("0.43", "0.5")])
def test_rounding_in_a_computed_table_does_not_tilt_or_part_its_axes(right, noise, lengths):
    a, d = lengths
    rows = [
        (right, noise, "0.3", "q1"),
        (noise, a, noise, "q2 - 1.2e-16"),
        (-right, noise, 0.1, "q3"),
        (right, noise, d, "q4"),
        (-right, 0, noise, "q5"),
        (noise, noise, 0.2, f"q6 + {right}"),
    ]
    raw = [RawRow(theta=theta, d=d, a=a, alpha=alpha) for alpha, a, d, theta in rows]
    read = read_table(RawTable(convention=STANDARD, angle_unit=AngleUnit.RAD, rows=tuple(raw)))
    given = dict.fromkeys(read.parameters, 0.45)
    values = parameter_values(read.parameters, read.angle_unit, given)
    branches_reach(read.table, bind_parameters(read, given), values)


def test_a_twist_that_is_more_than_rounding_is_not_a_right_angle():
    rows = [(90, 0, 0, "q1"), (1e-11, 0.4, 0, "q2"), (0, 0.3, 0, "q3")]
    with pytest.raises(TableError) as refused:
        inverse_form(table_of(STANDARD, *rows).table)
    assert refused.value.faults[0].where == ("rows", 1, "alpha")


@pytest.mark.parametrize("twist", ["999999999999946", "-999999999999957", "9e14*pi + pi/100"])
def test_a_large_angle_is_not_taken_for_a_right_one(twist):
    rows = [RawRow(theta=f"q{i}", d=0, a=0.3, alpha=alpha) for i, alpha in enumerate((0, twist, 0), 1)]
    read = read_table(RawTable(convention=STANDARD, angle_unit=AngleUnit.RAD, rows=tuple(rows)))
    with pytest.raises(TableError) as refused:
        inverse_form(read.table)
    assert refused.value.faults[0].where == ("rows", 1, "alpha")


@pytest.mark.parametrize("name", IDLE)
def test_where_a_joint_does_nothing_there_is_no_form_and_no_division_by_zero(name):
    with pytest.raises(TableError) as refused:
        inverse_form(IDLE[name].table)
    (fault,) = refused.value.faults
    assert (fault.code, fault.params) == ("inverse_form_idle_joint", {"joint": 2})


def test_two_links_are_the_law_of_cosines():
    """J. J. Craig, Introduction to robotics, 3rd ed. (2005) eq. 4.14 and 4.19."""
    l1, l2, x, y = 0.5, 0.3, 0.4, 0.35
    read = table_of(STANDARD, (0, "l1", 0, "q1"), (0, "l2", 0, "q2"))
    form = inverse_form(read.table)
    assert form.reach is InverseReach.POSITION
    target = np.eye(4)
    target[:2, 3] = x, y
    c2 = (x * x + y * y - l1 * l1 - l2 * l2) / (2 * l1 * l2)
    expected = set()
    for s2 in (math.sqrt(1 - c2 * c2), -math.sqrt(1 - c2 * c2)):
        q1 = math.atan2(y, x) - math.atan2(l2 * s2, l1 + l2 * c2)
        expected.add((round(q1, 12), round(math.atan2(s2, c2), 12)))
    found = {
        tuple(round(q, 12) for q in joints) for _, joints in joint_values(form, target, {"l1": l1, "l2": l2})
    }
    assert found == expected


def test_out_of_reach_no_branch_exists_and_the_condition_says_so():
    read = table_of(STANDARD, (0, "l1", 0, "q1"), (0, "l2", 0, "q2"))
    form = inverse_form(read.table)
    target = np.eye(4)
    target[0, 3] = 1.0
    assert not list(joint_values(form, target, {"l1": 0.5, "l2": 0.3}))
    kinds = {condition.kind for step in form.steps for condition in step.conditions}
    assert kinds == {ConditionKind.REACHABLE, ConditionKind.DETERMINED}


def test_a_pose_that_four_joints_cannot_have_is_none():
    read = ARMS["SCARA, slide first"]
    form = inverse_form(read.table)
    target = np.eye(4)
    target[:3, :3] = np.diag([1.0, -1.0, -1.0])
    target[:2, 3] = 0.4, 0.3
    assert not list(joint_values(form, target, {"l1": 0.5, "l2": 0.3}))


def test_lengths_named_like_entries_of_the_target_keep_their_names():
    read = table_of(STANDARD, (0, "p_x", 0, "q1"), (0, "K", 0, "q2"))
    form = inverse_form(read.table)
    names = [*form.position, *(step.name for step in form.steps), *form.branches]
    assert {"p_x", "K"}.isdisjoint(names)
    assert len(set(names)) == len(names)
