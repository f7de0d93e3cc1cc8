"""Where an angle is not determined: what may be chosen, and what is determined instead."""

import math

import numpy as np
import pytest

from kinematics.catalogue import robot
from kinematics.cells import bind_parameters, parameter_values
from kinematics.errors import TableError
from kinematics.expressions import evaluate, parameters_in
from kinematics.forward import end_pose
from kinematics.inverse import ArmReach, solver_of
from kinematics.inverse_forms import (
    ConditionKind,
    InverseQuantity,
    InverseReach,
    form_of_case,
    inverse_form,
    joint_values,
)
from kinematics.inverse_forms.steps import SingularCase
from kinematics.printing.notation import Names, Notation
from kinematics.printing.text import TextWriter
from tests.kinematics.inverse_forms.test_branches import ARMS, POSES, STANDARD, apart, drawn, table_of

ROLLING = [name for name in ARMS if any(case.joint for case in inverse_form(ARMS[name].table).singular_cases)]
UR = "Universal Robots"


class Arm:
    """An arm with its equations and random lengths."""

    def __init__(self, read, **given):
        rng = np.random.default_rng(7)
        given = {name: float(rng.uniform(0.2, 0.9)) for name in read.parameters} | given
        self.form = inverse_form(read.table)
        self.values = parameter_values(read.parameters, read.angle_unit, given)
        self.table = bind_parameters(read, given)

    def solutions(self, form, target, **chosen):
        return [joints for _, joints in joint_values(form, target, self.values | chosen)]

    def known(self, target):
        """The values of lengths and of the target's entries."""
        known = dict(self.values)
        for row, names in zip(target[:3, :3].tolist(), self.form.rotation, strict=True):
            known |= dict(zip(names, row, strict=True))
        return known | dict(zip(self.form.position, target[:3, 3].tolist(), strict=True))


def turned(angle):
    return (angle + math.pi) % math.tau - math.pi


@pytest.mark.parametrize("name", ROLLING)
def test_with_one_angle_chosen_the_others_reach_and_their_sum_is_what_is_printed(name):
    arm = Arm(ARMS[name])
    cases = [case for case in arm.form.singular_cases if case.joint]
    assert len(cases) == 2
    rng = np.random.default_rng(8)
    for case in cases:
        form = form_of_case(arm.form, case, "chosen")
        for _ in range(POSES):
            q, size = drawn(rng, arm.table)
            q[case.joint - 1] = evaluate(case.at, arm.values, q)
            target = end_pose(arm.table, q)
            found = arm.solutions(form, target, chosen=q[case.free[0] - 1])
            assert apart(arm.table, np.array(q), found).min() < 1e-6
            for joints in found:
                off = end_pose(arm.table, joints) - target
                off[:3, 3] /= size
                assert np.abs(off).max() < 1e-9
                value = evaluate(case.value, arm.known(target), joints)
                assert abs(turned(evaluate(case.combination, {}, joints) - value)) < 1e-9


@pytest.mark.parametrize("name", ROLLING)
def test_every_choice_of_the_free_angle_reaches(name):
    """But for a UR arm, whose parallel joints have their reach."""
    arm = Arm(ARMS[name], **({"a2": 0.9, "a3": 0.8, "d5": 0.1} if name.startswith(UR) else {}))
    rng = np.random.default_rng(9)
    for case in arm.form.singular_cases:
        if not case.joint:
            continue
        form = form_of_case(arm.form, case, "chosen")
        q, _ = drawn(rng, arm.table)
        q[case.joint - 1] = evaluate(case.at, arm.values, q)
        if name.startswith(UR):
            q[1:4] = 0.5, 1.4, -0.6
        target = end_pose(arm.table, q)
        for chosen in np.linspace(-3.0, 3.0, 7):
            found = arm.solutions(form, target, chosen=chosen)
            assert found
            for joints in found:
                assert joints[case.free[0] - 1] == chosen
                assert np.abs(end_pose(arm.table, joints) - target).max() < 1e-9


def test_a_branch_that_is_not_singular_is_none_of_the_case():
    arm = Arm(ARMS["anthropomorphic with an offset, a wrist"])
    q = [0.3, 0.8, -0.7, 0.4, 0.0, 0.9]
    target = end_pose(arm.table, q)
    straight, turned_over = arm.form.singular_cases[-2:]
    assert arm.solutions(form_of_case(arm.form, straight, "chosen"), target, chosen=1.0)
    assert not arm.solutions(form_of_case(arm.form, turned_over, "chosen"), target, chosen=1.0)


@pytest.mark.parametrize("name", [UR, "Stanford"])
def test_all_eight_are_printed_and_are_those_of_the_solver(name):
    arm = Arm(ARMS[name], **({"a2": 0.9, "a3": 0.8, "d4": 0.1, "d5": 0.1, "d6": 0.1} if name == UR else {}))
    rng = np.random.default_rng(10)
    target = end_pose(arm.table, [0.4, 0.5, 1.3, -0.7, 0.9, rng.uniform(-3, 3)])
    found = arm.solutions(arm.form, target)
    answer = solver_of(arm.table, reach=ArmReach.POSE).solve(target)
    assert len(found) == len(answer.solutions) == 8
    assert answer.complete
    for joints in found:
        assert np.abs(end_pose(arm.table, joints) - target).max() < 1e-9
        assert apart(arm.table, np.array(joints), [one.joints for one in answer.solutions]).min() < 1e-6


def test_of_a_ur_arm_q6_is_free_where_axes_4_and_6_are_parallel():
    write = TextWriter(Names(notation=Notation.SHORT)).text
    form = inverse_form(ARMS[UR].table)
    straight, turned_over = (case for case in form.singular_cases if case.joint)
    assert (straight.free, straight.joint, write(straight.at)) == ((6,), 5, "0")
    assert (turned_over.free, turned_over.joint, write(turned_over.at)) == ((6,), 5, "pi")
    assert write(straight.combination) == "q2 + q3 + q4 + q6"
    assert write(turned_over.combination) == "q2 + q3 + q4 - q6"
    assert write(straight.value) == "atan2(-c1*r12 - s1*r22, r32)"
    assert [(step.name, write(step.value)) for step in straight.steps] == [
        ("q5", "0"),
        ("phi", "atan2(-c1*r12 - s1*r22, r32) - q6"),
    ]


def test_of_a_spherical_wrist_either_end_is_free():
    write = TextWriter(Names(notation=Notation.SHORT)).text
    cases = [case for case in inverse_form(ARMS["Stanford"].table).singular_cases if case.joint]
    assert [case.free for case in cases] == [(4, 6), (4, 6)]
    assert [write(case.combination) for case in cases] == ["q4 + q6", "q4 - q6"]


def test_offsets_of_a_wrist_go_to_the_other_side():
    arm = ARMS["Universal Robots, modified"]
    write = TextWriter(Names(notation=Notation.SHORT)).text
    (case, _) = (case for case in inverse_form(arm.table).singular_cases if case.joint)
    assert parameters_in(case.combination) == set()
    assert "gamma" in write(case.value)


@pytest.mark.parametrize(
    ("rows", "given", "place"),
    [
        (
            [(90, 0, "h", "q1"), (0, "l1", 0, "q2"), (0, "l2", 0, "q3")],
            {"h": 0.2, "l1": 0.5, "l2": 0.4},
            (0, 0, 0.4),
        ),
        ([(-90, 0, "h", "q1"), (90, 0, 0, "q2"), (0, 0, "q3", 0)], {"h": 0.2}, (0, 0, 0.7)),
        ([(0, "l1", 0, "q1"), (0, "l2", 0, "q2")], {"l1": 0.5, "l2": 0.5}, (0, 0, 0)),
        ([(0, 0, 0, "q1"), (-90, 0, "q2", 0), (0, 0, "q3", 0)], {}, (0, 0, 0.3)),
    ],
)
def test_on_its_axis_the_first_joint_is_free(rows, given, place):
    arm = Arm(table_of(STANDARD, *rows), **given)
    assert arm.form.reach is InverseReach.POSITION
    target = np.eye(4)
    target[:3, 3] = place
    (case,) = (case for case in arm.form.singular_cases if case.free == (1,))
    assert case.value is None
    form = form_of_case(arm.form, case, "chosen")
    for chosen in (-2.0, 0.0, 1.0):
        found = arm.solutions(form, target, chosen=chosen)
        assert found
        for joints in found:
            assert joints[0] == chosen
            assert np.abs(end_pose(arm.table, joints)[:3, 3] - place).max() < 1e-9
    target[0, 3] += 0.1
    assert not arm.solutions(form, target, chosen=1.0)


def test_an_elbow_that_brings_the_wrist_onto_an_axis_leaves_that_joint_free():
    arm = Arm(
        ARMS["two parallel axes, an elbow across, a wrist"], a1=0.5, a2=0.3, a3=0.2, d1=0.4, d4=0.6, d6=0.1
    )
    (case,) = (case for case in arm.form.singular_cases if case.free == (2,))
    form = form_of_case(arm.form, case, "chosen")
    folded = math.atan2(0.6, 0.2) + math.acos(-0.3 / math.hypot(0.2, 0.6))  # a2 + a3 c3 + d4 s3 = 0
    target = end_pose(arm.table, [0.3, -0.8, folded, 0.5, 0.7, 0.2])
    for chosen in (-2.0, 0.0, 1.0):
        solutions = arm.solutions(form, target, chosen=chosen)
        assert solutions
        for joints in solutions:
            assert joints[1] == chosen
            assert np.abs(end_pose(arm.table, joints) - target).max() < 1e-9


def test_a_case_of_other_equations_is_none():
    case = SingularCase(free=(1,), conditions=())
    with pytest.raises(ValueError, match="no case"):
        form_of_case(inverse_form(ARMS[UR].table), case, "chosen")


@pytest.mark.parametrize("name", ARMS)
def test_intermediates_are_what_they_are_said_to_be(name):
    arm = Arm(ARMS[name])
    rng = np.random.default_rng(12)
    for _ in range(3):
        q, _ = drawn(rng, arm.table)
        target = end_pose(arm.table, q)
        for signs, joints in joint_values(arm.form, target, arm.values):
            known = arm.known(target) | dict(zip(arm.form.branches, map(float, signs), strict=True))
            for step in arm.form.steps:
                value = evaluate(step.value, known, joints)
                if step.joint:
                    continue
                known[step.name] = value
                assert step.quantity is not None
                if step.meaning is not None:
                    said = evaluate(step.meaning, known, joints)
                    angle = step.quantity is InverseQuantity.PLANE_TURN
                    assert abs(turned(value - said) if angle else value - said) < 1e-9


@pytest.mark.parametrize("name", ARMS)
def test_every_sign_is_named_once_and_every_singularity_has_its_case(name):
    form = inverse_form(ARMS[name].table)
    assert [step.branch for step in form.steps if step.branch] == list(form.branches)
    for step in form.steps:
        kinds = {condition.kind for condition in step.conditions}
        assert (ConditionKind.DETERMINED in kinds) == bool(step.singular)


def test_a_sum_of_squares_is_no_radicand_to_be_asked_about():
    form = inverse_form(ARMS["RRP with an offset"].table)
    write = TextWriter(Names(notation=Notation.SHORT)).text
    assert [(step.name, write(step.value)) for step in form.steps] == [
        ("rho", "sigma1*sqrt(p_x^2 + p_y^2 - d2^2)"),
        ("q1", "atan2(p_y, p_x) - atan2(d2, rho)"),
        ("v", "-p_z + d1"),
        ("q3", "sigma2*sqrt(rho^2 + v^2)"),
        ("q2", "atan2(sigma2*rho, -sigma2*v)"),
    ]
    assert [len(step.conditions) for step in form.steps] == [1, 0, 0, 0, 1]


@pytest.mark.parametrize(
    ("robot_id", "zero"),
    [("twolink", "L1"), ("twolink", "L2"), ("ur5", "a2"), ("ur5", "a3"), ("scara", "a2"), ("irb140", "a2")],
)
def test_where_a_length_is_0_that_is_divided_by_one_of_the_joints_may_be_chosen(robot_id, zero):
    read = robot(robot_id).table
    form = inverse_form(read.table)
    values = dict(robot(robot_id).parameters) | {zero: 0.0}
    table = bind_parameters(read, values)
    without = [
        case
        for step in form.steps
        for case in step.singular
        for condition in step.conditions
        if condition.kind is ConditionKind.DETERMINED
        and parameters_in(condition.value) <= {zero}
        and case.conditions[0].value == condition.value
    ]
    (case,) = without
    q = np.random.default_rng(9).uniform(-2.0, 2.0, table.n_joints)
    target = end_pose(table, q)
    chosen = values | {"chosen": q[case.free[0] - 1]}
    found = [joints for _, joints in joint_values(form_of_case(form, case, "chosen"), target, chosen)]
    assert any(max(abs(turned(a - b)) for a, b in zip(joints, q, strict=True)) < 1e-7 for joints in found)


@pytest.mark.parametrize(("zero", "joint"), [("L1", 2), ("L2", 2)])
def test_an_arm_with_such_a_length_is_refused_for_the_joint_that_does_nothing(zero, joint):
    lengths = {"L1": 0.5, "L2": 0.3} | {zero: 0.0}
    table = table_of(STANDARD, (0, lengths["L1"], 0, "q1"), (0, lengths["L2"], 0, "q2")).table
    with pytest.raises(TableError) as refused:
        inverse_form(table)
    (fault,) = refused.value.faults
    assert (fault.code, fault.params) == ("inverse_form_idle_joint", {"joint": joint})
