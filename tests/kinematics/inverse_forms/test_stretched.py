"""Targets that stretch or fold an arm, or put it at right angles: rounding must not cost a branch."""

import math
import shutil
import subprocess
from itertools import product

import numpy as np
import pytest

from kinematics.catalogue import robot, robot_ids
from kinematics.cells import bind_parameters, parameter_values
from kinematics.errors import TableError
from kinematics.expressions import JointVariable
from kinematics.forward import end_pose
from kinematics.inverse_forms import InverseReach, inverse_form, joint_values
from kinematics.printing.equation_lists import NamedValue, source_of
from kinematics.printing.formats import EquationFormat

RIGHT_ANGLES = [0.0, math.pi / 2, math.pi, -math.pi / 2]


def has_a_form(robot_id):
    try:
        inverse_form(robot(robot_id).table.table)
    except TableError:
        return False
    return True


ROBOTS = [robot_id for robot_id in robot_ids() if has_a_form(robot_id)]


class StretchedArm:
    """A robot with its equations, and poses at right angles or with one joint at a right angle."""

    def __init__(self, robot_id):
        given = robot(robot_id)
        self.form = inverse_form(given.table.table)
        self.values = parameter_values(given.table.parameters, given.table.angle_unit, given.parameters)
        self.table = bind_parameters(given.table, given.parameters)
        rng = np.random.default_rng(11)
        n = self.table.n_joints
        self.poses = []
        for number in range(32):
            q = rng.choice(RIGHT_ANGLES, n)
            if number % 2:
                q = rng.uniform(-3.0, 3.0, n)
                q[rng.integers(n)] = rng.choice(RIGHT_ANGLES)
            if robot_id in ("ur5", "ur10"):
                q[4] = 1.0  # at a right angle or straight, the other joints may be chosen, within their reach
            self.poses.append(end_pose(self.table, q))

    def calls(self, pose):
        """The arguments of the generated function, for every choice of signs."""
        signs = product((1.0, -1.0), repeat=len(self.form.branches))
        return [(*pose[:3, :3].flat, *pose[:3, 3], *chosen, *self.values.values()) for chosen in signs]

    def source(self, chosen):
        """The generated function."""
        entries = [*(name for row in self.form.rotation for name in row), *self.form.position]
        equations = [NamedValue(step.name, step.joint, step.value) for step in self.form.steps]
        joints = [JointVariable(joint) for joint in range(1, self.table.n_joints + 1)]
        return source_of(equations, [*entries, *self.form.branches, *self.values], joints, chosen)

    def miss(self, joints, pose):
        """By how much joint values miss a pose; infinite where a branch does not exist."""
        if np.isnan(joints).any():
            return math.inf
        off = end_pose(self.table, joints) - pose
        return np.abs(off[:3, 3] if self.form.reach is InverseReach.POSITION else off).max()


@pytest.fixture(params=ROBOTS, scope="module")
def arm(request):
    return StretchedArm(request.param)


def test_the_equations_reach_every_pose(arm):
    for pose in arm.poses:
        found = [arm.miss(np.array(joints), pose) for _, joints in joint_values(arm.form, pose, arm.values)]
        assert min(found) < 1e-7


def test_python_and_numpy_reach_every_pose(arm):
    plain, arrays = {}, {}
    exec(arm.source(EquationFormat.PYTHON), plain)
    exec(arm.source(EquationFormat.NUMPY), arrays)
    for pose in arm.poses:
        calls = arm.calls(pose)
        with np.errstate(invalid="ignore"):
            found = arrays["inverse_kinematics"](*np.array(calls).T)
        found = np.broadcast_to(found, (len(calls), arm.table.n_joints))
        misses = [arm.miss(joints, pose) for joints in found]
        assert min(misses) < 1e-7
        best = calls[int(np.argmin(misses))]
        assert arm.miss(np.array(plain["inverse_kinematics"](*best)), pose) < 1e-7


def test_c_reaches_every_pose(arm, tmp_path):
    compiler = shutil.which("cc")
    if compiler is None:
        pytest.skip("no C compiler")
    n = arm.table.n_joints
    calls = [call for pose in arm.poses for call in arm.calls(pose)]
    lines = ["#include <stdio.h>", arm.source(EquationFormat.C)]
    lines.append(f"static const double A[{len(calls)}][{len(calls[0])}] = {{")
    lines += [f"{{{', '.join(repr(float(value)) for value in call)}}}," for call in calls]
    given = ", ".join(f"A[k][{i}]" for i in range(len(calls[0])))
    lines += ["};", f"int main(void) {{ double q[{n}]; for (int k = 0; k < {len(calls)}; k++) {{"]
    lines += [
        f"inverse_kinematics({given}, q);",
        f'for (int i = 0; i < {n}; i++) printf("%.17g ", q[i]); puts("");',
    ]
    (tmp_path / "all.c").write_text("\n".join([*lines, "} return 0; }"]))
    program = str(tmp_path / "all")
    subprocess.run([compiler, "-std=c99", "-o", program, str(tmp_path / "all.c"), "-lm"], check=True)
    printed = subprocess.run([program], check=True, capture_output=True, text=True).stdout
    found = np.array([list(map(float, line.split())) for line in printed.splitlines()])
    for pose, branches in zip(arm.poses, found.reshape(len(arm.poses), -1, n), strict=True):
        assert min(arm.miss(joints, pose) for joints in branches) < 1e-7


@pytest.mark.parametrize("beyond", [1e-6, 0.1])
def test_a_branch_that_does_not_exist_has_no_values(beyond):
    arm = StretchedArm("twolink")
    pose = np.eye(4)
    pose[0, 3] = sum(arm.values.values()) * (1.0 + beyond)
    plain, arrays = {}, {}
    exec(arm.source(EquationFormat.PYTHON), plain)
    exec(arm.source(EquationFormat.NUMPY), arrays)
    for call in arm.calls(pose):
        with pytest.raises(ValueError, match="math domain error"):
            plain["inverse_kinematics"](*call)
        with np.errstate(invalid="ignore"):
            assert np.isnan(arrays["inverse_kinematics"](*call)).any()
    assert not list(joint_values(arm.form, pose, arm.values))


def test_a_parameter_called_max_is_renamed():
    """The generated functions of Python, MATLAB and Julia call max and min."""
    arm = StretchedArm("twolink")
    equations = [NamedValue(step.name, step.joint, step.value) for step in arm.form.steps]
    arguments = ["p_x", "p_y", "sigma1", "L1", "L2", "max", "min"]
    for chosen in (EquationFormat.PYTHON, EquationFormat.MATLAB, EquationFormat.JULIA):
        source = source_of(equations, arguments, [JointVariable(2)], chosen)
        assert "L2, max_, min_)" in source
