"""Closed forms: right in value against the numeric core and SymPy, and in the form a lecturer writes."""

import os
import random
import subprocess
import sys
from fractions import Fraction

import numpy as np
import pytest
import sympy

from kinematics.catalogue import robots
from kinematics.expressions import (
    Function,
    Parameter,
    add,
    call,
    evaluate,
    multiply,
    number,
    pi_times,
    power,
)
from kinematics.forward import forward_kinematics
from kinematics.jacobian import JacobianFrame
from kinematics.jacobian import jacobian as numeric_jacobian
from kinematics.printing import Format, MatrixPrinter, Notation, Purpose
from kinematics.se3 import inverse_transform
from kinematics.symbolic import Matrix, canonical, closed_form, count_operations, inverse, jacobian
from kinematics.symbolic.exact_poses import exact_pose
from kinematics.table import Convention, JointType, SymbolicRow, SymbolicTable, bind, table_parameters
from tests.kinematics.symbolic.tables import (
    general_table,
    puma,
    random_length,
    random_table,
    row,
    sympy_poses,
    table,
)

TABLES = int(os.environ.get("FRAMEWISE_TABLES", "12"))
CONFIGURATIONS = 100
RIGHT, LEFT = pi_times(Fraction(1, 2)), pi_times(Fraction(-1, 2))
L1, L2, L3 = map(Parameter, ("L1", "L2", "L3"))
TWIST = Parameter("alpha1")


def standard(*rows: SymbolicRow) -> SymbolicTable:
    return table(Convention.STANDARD, *rows)


def text(matrix: Matrix, notation: Notation = Notation.SHORT) -> list[list[str]]:
    printer = MatrixPrinter(n_joints=6, parameters=(), notation=notation)
    written = printer.write(matrix, (Format.TEXT,), Purpose(name="f", meaning="."))
    rows: list[list[str]] = written["text"]
    return rows


def numbers(matrix: Matrix, parameters: dict[str, float], joints: list[float]) -> np.ndarray:  # type: ignore[type-arg]
    return np.array([[evaluate(entry, parameters, joints) for entry in line] for line in matrix])


def random_pose(rng: random.Random) -> Matrix:
    """A pose as it comes over the wire: sometimes of quarter turns, sometimes of any angles."""
    angles = [rng.choice([0, np.pi / 2, -np.pi / 2, np.pi / 4, rng.uniform(-3, 3)]) for _ in range(3)]
    cosines, sines = np.cos(angles), np.sin(angles)
    z = np.array([[cosines[0], -sines[0], 0], [sines[0], cosines[0], 0], [0, 0, 1]])
    x = np.array([[1, 0, 0], [0, cosines[1], -sines[1]], [0, sines[1], cosines[1]]])
    pose = np.eye(4)
    pose[:3, :3] = z @ x
    pose[:3, 3] = [rng.uniform(-1, 1), 0.25, 0]
    return exact_pose(pose.tolist())


@pytest.mark.parametrize("seed", range(120))
def test_every_matrix_agrees_with_the_numeric_core(seed: int) -> None:
    rng = random.Random(seed)
    symbolic = random_table(rng, rng.randrange(1, 7), fixed=rng.randrange(4))
    base = random_pose(rng) if rng.random() < 0.4 else None
    tool = random_pose(rng) if rng.random() < 0.4 else None
    parameters = {name: rng.uniform(-2, 2) for name in table_parameters(symbolic)}
    joints = [rng.uniform(-3, 3) for _ in range(symbolic.n_joints)]
    numeric = bind(symbolic, parameters)
    poses = {
        "base": None if base is None else numbers(base, {}, []),
        "tool": None if tool is None else numbers(tool, {}, []),
    }
    forward = forward_kinematics(numeric, joints, **poses)
    form = closed_form(symbolic, base=base, tool=tool)

    def agrees(matrix: Matrix, expected: np.ndarray) -> None:  # type: ignore[type-arg]
        np.testing.assert_allclose(numbers(matrix, parameters, joints), expected, rtol=0, atol=1e-12)

    agrees(form.transform, forward.transform)
    for i in range(len(symbolic.rows)):
        agrees(form.links[i], forward.links[i])
        agrees(form.frames[i], forward.frames[i])
    agrees(inverse(symbolic, base=base, tool=tool), inverse_transform(forward.transform))
    for frame in JacobianFrame:
        agrees(
            jacobian(symbolic, frame, base=base, tool=tool), numeric_jacobian(numeric, joints, frame, **poses)
        )


@pytest.mark.parametrize("seed", range(TABLES))
def test_random_tables_of_seven_general_rows_agree_with_sympy(seed: int) -> None:
    rng = random.Random(seed)
    symbolic = general_table(rng)
    printer = MatrixPrinter(n_joints=7, parameters=())
    purpose = Purpose(name="pose", meaning="The pose.")
    scope: dict[str, object] = {}
    exec(printer.write(closed_form(symbolic).transform, (Format.NUMPY,), purpose)["numpy"], scope)
    joints = np.random.default_rng(seed).uniform(-np.pi, np.pi, (CONFIGURATIONS, 7))
    ours = scope["pose"](joints)  # type: ignore[operator]
    np.testing.assert_allclose(ours, sympy_poses(symbolic, joints), rtol=0, atol=1e-12)


CRAIG = [
    "c1*(c23*(c4*c5*c6 - s4*s6) - s23*s5*c6) + s1*(s4*c5*c6 + c4*s6)",
    "c1*(s23*s5*s6 - c23*(c4*c5*s6 + s4*c6)) + s1*(c4*c6 - s4*c5*s6)",
    "-c1*(c23*c4*s5 + s23*c5) - s1*s4*s5",
    "c1*(a2*c2 + a3*c23 - d4*s23) - d3*s1",
    "s1*(c23*(c4*c5*c6 - s4*s6) - s23*s5*c6) - c1*(s4*c5*c6 + c4*s6)",
    "s1*(s23*s5*s6 - c23*(c4*c5*s6 + s4*c6)) - c1*(c4*c6 - s4*c5*s6)",
    "c1*s4*s5 - s1*(c23*c4*s5 + s23*c5)",
    "s1*(a2*c2 + a3*c23 - d4*s23) + d3*c1",
    "-s23*(c4*c5*c6 - s4*s6) - c23*s5*c6",
    "s23*(c4*c5*s6 + s4*c6) + c23*s5*s6",
    "s23*c4*s5 - c23*c5",
    "-a2*s2 - a3*s23 - d4*c23",
]
"""Entries of ⁰T_6 of the PUMA 560, row by row: J. J. Craig, Introduction to Robotics, 3rd ed., eq. 3.14."""


def test_puma_is_what_craig_prints() -> None:
    entries = text(closed_form(puma(Convention.MODIFIED)).transform)
    assert [entry for line in entries[:3] for entry in line] == CRAIG


@pytest.mark.parametrize("convention", list(Convention))
def test_puma_has_few_operations_as_sympy_counts_them(convention: Convention) -> None:
    transform = closed_form(puma(convention)).transform
    written = [sympy.sympify(entry) for line in text(transform, Notation.FULL)[:3] for entry in line]
    counted = sum(map(sympy.count_ops, written))
    assert counted <= 265
    assert abs(counted - count_operations(entry for line in transform for entry in line)) <= 2


@pytest.mark.parametrize(
    ("symbolic", "x_axis", "origin"),
    [
        pytest.param(
            standard(row(a=L1), row(a=L2), row(a=L3)),
            ["c123", "s123", "0"],
            ["L1*c1 + L2*c12 + L3*c123", "L1*s1 + L2*s12 + L3*s123", "0"],
            id="parallel axes",
        ),
        pytest.param(
            standard(row(a=L1, alpha=pi_times(1)), row(a=L2), row(a=L3, alpha=pi_times(1)), row()),
            ["cos(q1 - q2 - q3 + q4)", "sin(q1 - q2 - q3 + q4)", "0"],
            [
                "L1*c1 + L2*cos(q1 - q2) + L3*cos(q1 - q2 - q3)",
                "L1*s1 + L2*sin(q1 - q2) + L3*sin(q1 - q2 - q3)",
                "0",
            ],
            id="antiparallel axes",
        ),
        pytest.param(
            standard(row(a=L1, sign=-1), row(a=L2)),
            ["cos(q1 - q2)", "-sin(q1 - q2)", "0"],
            ["L1*c1 + L2*cos(q1 - q2)", "-L1*s1 - L2*sin(q1 - q2)", "0"],
            id="a reversed variable",
        ),
        pytest.param(
            standard(row(alpha=RIGHT), row(JointType.PRISMATIC, alpha=LEFT), row(a=L1)),
            ["c13", "s13", "0"],
            ["q2*s1 + L1*c13", "L1*s13 - q2*c1", "0"],
            id="a slider across between parallel axes",
        ),
        pytest.param(
            standard(row(a=L1, alpha=RIGHT), row(JointType.FIXED, d=L2, alpha=LEFT), row(a=L3)),
            ["c12", "s12", "0"],
            ["L1*c1 + L2*s1 + L3*c12", "L1*s1 - L2*c1 + L3*s12", "0"],
            id="a fixed row between parallel axes",
        ),
        pytest.param(
            standard(row(alpha=RIGHT), row(JointType.FIXED, theta=RIGHT, a=L1, alpha=RIGHT), row(a=L3)),
            ["s1*s2", "-c1*s2", "c2"],
            ["L3*s1*s2", "-L3*c1*s2", "L1 + L3*c2"],
            id="a fixed row that turns one axis into another",
        ),
        pytest.param(
            standard(row(theta=pi_times(Fraction(1, 4)), a=L1), row(theta=RIGHT, a=L2)),
            ["-sin(q1 + q2 + pi/4)", "cos(q1 + q2 + pi/4)", "0"],
            [
                "L1*cos(q1 + pi/4) - L2*sin(q1 + q2 + pi/4)",
                "L1*sin(q1 + pi/4) + L2*cos(q1 + q2 + pi/4)",
                "0",
            ],
            id="offsets",
        ),
        pytest.param(
            standard(
                row(theta=pi_times(Fraction(1, 18)), alpha=RIGHT),
                row(JointType.FIXED, theta=pi_times(Fraction(1, 9)), alpha=LEFT),
                row(a=L1),
            ),
            None,
            [
                "L1*(cos(pi/9)*cos(q1 + pi/18)*c2 - sin(q1 + pi/18)*s2)",
                "L1*(cos(q1 + pi/18)*s2 + cos(pi/9)*sin(q1 + pi/18)*c2)",
                "L1*sin(pi/9)*c2",
            ],
            id="an offset keeps its size where a fixed row between right angles is dissolved",
        ),
        pytest.param(
            standard(row(theta=RIGHT, a=L1), row(theta=LEFT, a=L2)),
            ["c12", "s12", "0"],
            ["L2*c12 - L1*s1", "L1*c1 + L2*s12", "0"],
            id="offsets of quarter turns are folded",
        ),
        pytest.param(
            standard(row(alpha=TWIST), row(a=L2)),
            ["c1*c2 - cos(alpha1)*s1*s2", "s1*c2 + cos(alpha1)*c1*s2", "sin(alpha1)*s2"],
            [
                "L2*(c1*c2 - cos(alpha1)*s1*s2)",
                "L2*(s1*c2 + cos(alpha1)*c1*s2)",
                "L2*sin(alpha1)*s2",
            ],
            id="a twist with a name",
        ),
        pytest.param(
            standard(row(alpha=pi_times(Fraction(1, 6))), row(a=number("0.4318"))),
            ["c1*c2 - sqrt(3)*s1*s2/2", "s1*c2 + sqrt(3)*c1*s2/2", "s2/2"],
            [
                "0.4318*c1*c2 - 0.2159*sqrt(3)*s1*s2",
                "0.4318*s1*c2 + 0.2159*sqrt(3)*c1*s2",
                "0.2159*s2",
            ],
            id="a twist of 30° and a decimal",
        ),
        pytest.param(
            standard(row(alpha=pi_times(Fraction(37, 180))), row(alpha=number("0.3")), row()),
            None,
            ["0", "0", "0"],
            id="general twists",
        ),
        pytest.param(
            standard(row(JointType.PRISMATIC, alpha=LEFT), row(JointType.PRISMATIC, theta=LEFT, alpha=LEFT)),
            ["0", "0", "1"],
            ["0", "q2", "q1"],
            id="sliders alone",
        ),
    ],
)
def test_entries_are_what_a_lecturer_writes(
    symbolic: SymbolicTable, x_axis: list[str] | None, origin: list[str]
) -> None:
    written = text(closed_form(symbolic).transform)
    assert [line[3] for line in written[:3]] == origin
    if x_axis is not None:
        assert [line[0] for line in written[:3]] == x_axis


def test_base_and_tool_of_quarter_turns_leave_no_numbers_behind() -> None:
    base = exact_pose([[6.1e-17, -1, 0, 1], [1, 6.1e-17, 0, 2], [0, 0, 1, 0], [0, 0, 0, 1]])
    written = text(closed_form(standard(row(a=L1), row(a=L2)), base=base).transform)
    assert [line[3] for line in written[:3]] == ["1 - L1*s1 - L2*s12", "L1*c1 + L2*c12 + 2", "0"]


def test_an_angle_that_is_an_arc_of_lengths_stays_one() -> None:
    hypotenuse = call(Function.SQRT, add((power(L1, 2), power(L2, 2))))
    symbolic = standard(row(theta=call(Function.ATAN2, L1, L2), a=hypotenuse), row(a=L3))
    assert text(closed_form(symbolic).transform)[0][3] == (
        "sqrt(L1^2 + L2^2)*cos(q1 + atan2(L1, L2)) + L3*cos(q1 + q2 + atan2(L1, L2))"
    )


def test_the_jacobian_of_a_planar_arm_is_the_textbooks() -> None:
    planar = standard(row(a=L1), row(a=L2))
    assert text(jacobian(planar)) == [
        ["-L1*s1 - L2*s12", "-L2*s12"],
        ["L1*c1 + L2*c12", "L2*c12"],
        ["0", "0"],
        ["0", "0"],
        ["0", "0"],
        ["1", "1"],
    ]
    assert text(jacobian(planar, JacobianFrame.END))[:2] == [["L1*s2", "0"], ["L1*c2 + L2", "L2"]]


def test_the_inverse_leaves_no_sine_squared_beside_a_cosine_squared() -> None:
    planar = standard(row(a=L1), row(a=L2))
    assert [line[3] for line in text(inverse(planar))[:3]] == ["-L1*c2 - L2", "L1*s2", "0"]


@pytest.mark.parametrize("robot", robots(), ids=lambda robot: robot.id)
def test_the_derivative_of_the_position_is_the_linear_jacobian_exactly(robot: object) -> None:
    symbolic = robot.table.table  # type: ignore[attr-defined]
    form, velocity = closed_form(symbolic).transform, jacobian(symbolic)
    q = sympy.symbols(f"q1:{symbolic.n_joints + 1}")
    positions, velocities = text(form, Notation.FULL), text(velocity, Notation.FULL)
    for i in range(3):
        position = sympy.sympify(positions[i][3])
        for k in range(symbolic.n_joints):
            derivative, expected = sympy.diff(position, q[k]), sympy.sympify(velocities[i][k])
            symbols = sorted(derivative.free_symbols | expected.free_symbols, key=str)
            point = {symbol: 0.3 + 0.41 * j for j, symbol in enumerate(symbols)}
            # each by itself: of a difference that is 0 SymPy looks for the digits, up to the hundredth
            assert abs(derivative.evalf(subs=point) - expected.evalf(subs=point)) < 1e-12


@pytest.mark.parametrize("robot", [r for r in robots() if r.table.table.n_joints <= 6], ids=lambda r: r.id)
def test_the_rotation_is_one_identically(robot: object) -> None:
    """RᵀR = 1 for all joint values, proved in the canonical form."""
    transform = closed_form(robot.table.table).transform  # type: ignore[attr-defined]
    columns = [[transform[i][j] for i in range(3)] for j in range(3)]
    for j in (0, 2):
        for k in (0, 2):
            inner = add(multiply((columns[j][i], columns[k][i])) for i in range(3))
            expected = number(1 if j == k else 0)
            assert canonical(inner).terms == canonical(expected).terms


def test_a_table_of_64_general_rows_is_formed_and_counted() -> None:
    rng = random.Random(64)
    rows = [row(alpha=number(f"0.{i + 11}"), a=random_length(rng)) for i in range(64)]
    transform = closed_form(standard(*rows)).transform
    assert count_operations(entry for line in transform for entry in line) > 10**20


def test_sympy_is_not_needed() -> None:
    program = (
        "import sys, kinematics.symbolic, kinematics.printing\n"
        "from tests.kinematics.symbolic.tables import puma\n"
        "from kinematics.table import Convention\n"
        "kinematics.symbolic.closed_form(puma(Convention.STANDARD))\n"
        "sys.exit('sympy' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", program], check=False).returncode == 0
