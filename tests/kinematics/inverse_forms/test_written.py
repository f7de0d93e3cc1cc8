"""The equations as source code: functions agree with the equations, branch by branch."""

import json
import shutil
import subprocess
from itertools import product

import numpy as np
import pytest

from kinematics.catalogue import robot
from kinematics.cells import RawRow, RawTable, bind_parameters, parameter_values, read_table
from kinematics.expressions import JointVariable, Parameter, negate, power
from kinematics.forward import end_pose
from kinematics.inverse_forms import InverseReach, inverse_form, joint_values
from kinematics.printing import Notation
from kinematics.printing.equation_lists import (
    MISFIT,
    VALUES,
    EquationPrinter,
    NamedValue,
    source_of,
)
from kinematics.printing.formats import EquationFormat
from kinematics.printing.notation import Names
from kinematics.table import Convention

ROBOTS = ["puma560", "stanford", "ur5", "scara", "twolink", "scorbot"]


def asked(robot_id):
    """The function's arguments and values for one pose, and its source in a language."""
    given = robot(robot_id)
    table = given.table.table
    values = parameter_values(given.table.parameters, given.table.angle_unit, given.parameters)
    form = inverse_form(table)
    numbers = bind_parameters(given.table, given.parameters)
    target = end_pose(numbers, np.random.default_rng(5).uniform(0.2, 1.0, numbers.n_joints))
    entries = {name: target[i, j] for i, row in enumerate(form.rotation) for j, name in enumerate(row)}
    entries |= dict(zip(form.position, target[:3, 3], strict=True))
    equations = [NamedValue(step.name, step.joint, step.value) for step in form.steps]
    arguments = [*entries, *form.branches, *values]
    expected = dict(joint_values(form, target, values))
    calls = [
        [*map(float, entries.values()), *map(float, signs), *map(float, values.values())]
        for signs in expected
    ]
    return equations, arguments, calls, np.array(list(expected.values())), numbers.n_joints


def joints_of(n):
    return [JointVariable(joint) for joint in range(1, n + 1)]


@pytest.mark.parametrize("robot_id", ROBOTS)
def test_python_and_numpy(robot_id):
    equations, arguments, calls, expected, n = asked(robot_id)
    spaces = [{}, {}]
    for space, chosen in zip(spaces, (EquationFormat.PYTHON, EquationFormat.NUMPY), strict=True):
        exec(source_of(equations, arguments, joints_of(n), chosen), space)
    found = np.array([spaces[0]["inverse_kinematics"](*call) for call in calls])
    assert np.allclose(found, expected, atol=1e-12)
    assert np.allclose(spaces[1]["inverse_kinematics"](*np.array(calls).T), expected, atol=1e-12)


@pytest.mark.parametrize("robot_id", ROBOTS)
def test_c(robot_id, tmp_path):
    compiler = shutil.which("cc")
    if compiler is None:
        pytest.skip("no C compiler")
    equations, arguments, calls, expected, n = asked(robot_id)
    source = source_of(equations, arguments, joints_of(n), EquationFormat.C)
    lines = ["#include <stdio.h>", source, f"int main(void) {{ double q[{n}];"]
    for call in calls:
        lines.append(f"inverse_kinematics({', '.join(map(repr, call))}, q);")
        lines += [f'for (int i = 0; i < {n}; i++) printf("%.17g ", q[i]);', 'puts("");']
    (tmp_path / "all.c").write_text("\n".join([*lines, "return 0; }"]))
    program = str(tmp_path / "all")
    flags = ["-std=c99", "-Wall", "-Wextra", "-Werror"]
    subprocess.run([compiler, *flags, "-o", program, str(tmp_path / "all.c"), "-lm"], check=True)
    printed = subprocess.run([program], check=True, capture_output=True, text=True).stdout
    assert np.allclose(
        [list(map(float, line.split())) for line in printed.splitlines()], expected, atol=1e-12
    )


@pytest.mark.parametrize("chosen", [chosen for chosen in EquationFormat if chosen.is_source])
def test_a_length_that_is_a_word_of_the_language_is_renamed_and_a_comment_says_so(chosen):
    rows = (RawRow(theta="q1", d=0, a="class", alpha=0), RawRow(theta="q2", d=0, a="end", alpha=0))
    form = inverse_form(read_table(RawTable(convention=Convention.STANDARD, rows=rows)).table)
    equations = [NamedValue(step.name, step.joint, step.value) for step in form.steps]
    names = [*form.position, *form.branches, "class", "end"]
    source = source_of(equations, names, joints_of(2), chosen)
    renamed = {word for word in ("class", "end") if f"{word}_" in source}
    said = [line for line in source.splitlines() if "Renamed: " in line]
    assert renamed
    assert len(said) == 1
    assert all(f"{word}_ is {word}" in said[0] for word in renamed)


@pytest.mark.parametrize("robot_id", ROBOTS)
def test_javascript(robot_id, tmp_path):
    node = shutil.which("node")
    if node is None:
        pytest.skip("no Node.js")
    equations, arguments, calls, expected, n = asked(robot_id)
    source = source_of(equations, arguments, joints_of(n), EquationFormat.JAVASCRIPT)
    made = f"console.log(JSON.stringify({json.dumps(calls)}.map((call) => inverse_kinematics(...call))));"
    (tmp_path / "all.mjs").write_text(f"{source}\n{made}\n")
    printed = subprocess.run(
        [node, str(tmp_path / "all.mjs")], check=True, capture_output=True, text=True
    ).stdout
    assert np.allclose(json.loads(printed), expected, atol=1e-12)


@pytest.mark.parametrize("robot_id", ["scorbot", "scara", "onelink", "twolink"])
def test_a_branch_reaches_the_target_just_where_nothing_is_amiss(robot_id):
    """SCORBOT turned half round has joint values for every pose; few of them reach it."""
    given = robot(robot_id)
    numbers = bind_parameters(given.table, given.parameters)
    values = parameter_values(given.table.parameters, given.table.angle_unit, given.parameters)
    form = inverse_form(given.table.table)
    equations = [NamedValue(step.name, step.joint, step.value) for step in form.steps]
    rng = np.random.default_rng(6)
    space = {}
    for number in range(12):
        target = end_pose(numbers, rng.uniform(-3.1, 3.1, numbers.n_joints))
        if number % 2:
            target[:3, 3] += [0.0, 0.0, 0.01]
            target[:3, :3] @= np.array([[1.0, 0.0, 0.0], [0.0, 0.8, -0.6], [0.0, 0.6, 0.8]])
        entries = {name: target[i, j] for i, row in enumerate(form.rotation) for j, name in enumerate(row)}
        entries |= dict(zip(form.position, target[:3, 3], strict=True))
        names = [*entries, *form.branches, *values]
        exec(source_of(equations, names, joints_of(numbers.n_joints), EquationFormat.NUMPY), space)
        exec(source_of(equations, names, form.zeros, EquationFormat.NUMPY, MISFIT), space)
        right = {signs for signs, _ in joint_values(form, target, values)}
        for signs in product((1, -1), repeat=len(form.branches)):
            call = [*map(float, entries.values()), *map(float, signs), *map(float, values.values())]
            with np.errstate(invalid="ignore"):
                misfit = np.abs(space["inverse_kinematics_misfit"](*call)).max()
                joints = space["inverse_kinematics"](*call)
            if np.isnan(joints).any():
                assert signs not in right
                continue
            reached = end_pose(numbers, joints)
            reaches = np.abs((reached - target)[:3, 3]).max() < 1e-9
            if form.reach is InverseReach.POSE:
                reaches &= np.abs(reached - target).max() < 1e-9
            assert reaches == (misfit < 1e-9) == (signs in right)


@pytest.mark.parametrize("chosen", [EquationFormat.MATLAB, EquationFormat.JULIA])
def test_other_languages_define_before_they_use(chosen):
    equations, arguments, _, _, n = asked("puma560")
    source = source_of(equations, arguments, joints_of(n), chosen)
    defined = [line.split(" = ")[0].strip() for line in source.splitlines() if " = " in line]
    assert len(set(defined)) == len(defined)
    positions = [source.index(f"    q{joint} = ") for joint in (1, 3, 2, 4, 5, 6)]
    assert positions == sorted(positions)


def test_an_equation_reads_like_a_book():
    equations, *_ = asked("twolink")
    printer = EquationPrinter(Names(notation=Notation.SHORT))
    both = (EquationFormat.TEXT, EquationFormat.LATEX)
    written = {one["name"]: one for one in (printer.equation(each, both) for each in equations)}
    assert written["q2"]["text"] == "atan2(sigma1*sqrt(1 - K^2), K)"
    assert written["q1"]["latex"] == (
        r"q_{1}=\operatorname{atan2}(p_{y}, p_{x})-\operatorname{atan2}(k_{y}, k_{x})"
    )


def test_a_minus_sign_of_a_divisor_stands_before_the_fraction():
    equations, *_ = asked("rx90")
    printer = EquationPrinter(Names(notation=Notation.SHORT))
    written = next(printer.equation(each, EquationFormat) for each in equations if each.name == "K")
    assert written["text"] == "-(rho^2 + p_z^2 - D3^2 - RL4^2)/(2*D3*RL4)"
    assert (
        written["latex"]
        == r"K=-\frac{\rho^{2}+p_{z}^{2}-D_{3}^{2}-\mathrm{RL}_{4}^{2}}{2D_{3}\mathrm{RL}_{4}}"
    )


@pytest.mark.parametrize("chosen", [chosen for chosen in EquationFormat if chosen.is_source])
def test_every_language_that_is_offered_writes_equations(chosen):
    square = NamedValue(name="square", joint=0, value=power(Parameter("x"), 2))
    joint = NamedValue(name="", joint=1, value=negate(Parameter("square")))
    source = source_of([square, joint], ["x"], [JointVariable(1)], chosen)
    assert source.index("square = ") < source.index("q1 = ")
    assert VALUES.name in source
    assert VALUES.meaning in source
