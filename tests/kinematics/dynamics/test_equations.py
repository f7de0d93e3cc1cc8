"""Closed forms: as books print them, as SymPy derives them, and worth what the recursion computes."""

import os
import subprocess
import sys

import numpy as np
import pytest
import sympy

from kinematics import catalogue
from kinematics.dynamics import Derivation, MovingRobot, RigidBody, bind_links, rate_name
from kinematics.errors import FormSizeError
from kinematics.expressions import (
    ZERO,
    Expression,
    Function,
    Parameter,
    call,
    evaluate,
    multiply,
    number,
    pi_times,
)
from kinematics.symbolic import Matrix, to_sympy
from kinematics.table import Convention, DHRow, DHTable, JointType, SymbolicTable, bind, table_parameters
from tests.kinematics.dynamics.planar import DOWN, planar, written
from tests.kinematics.dynamics.weights import exact, link, puma_links

P = Parameter


def test_two_links_as_books_print_them() -> None:
    """Siciliano et al., Robotics (2009), eq. 7.82 and what follows, without motors."""
    found = Derivation(*planar(2), DOWN)
    assert written(found.mass, 2) == [
        ["m1*r1^2 + m2*L1^2 + m2*r2^2 + I1 + I2 + 2*m2*L1*r2*c2", "m2*r2^2 + I2 + m2*L1*r2*c2"],
        ["m2*r2^2 + I2 + m2*L1*r2*c2", "m2*r2^2 + I2"],
    ]
    assert written(found.coriolis, 2) == [
        ["-m2*L1*r2*dq2*s2", "-m2*L1*r2*dq1*s2 - m2*L1*r2*dq2*s2"],
        ["m2*L1*r2*dq1*s2", "0"],
    ]
    assert written(found.velocity, 2) == [
        ["-2*m2*L1*r2*dq1*dq2*s2 - m2*L1*r2*dq2^2*s2"],
        ["m2*L1*r2*dq1^2*s2"],
    ]
    assert written(found.gravity, 2) == [["g*c1*(m1*r1 + m2*L1) + m2*r2*g*c12"], ["m2*r2*g*c12"]]


@pytest.mark.parametrize("joints", [2, 3])
def test_lagranges_equations_by_sympy(joints: int) -> None:
    """Positions in the plane, differentiated by SymPy; nothing of DH is in it."""
    t = sympy.Symbol("t")
    q = [sympy.Function(f"f{i}")(t) for i in range(joints)]
    m, length, r, inertia = (sympy.symbols(f"{word}1:{joints + 1}") for word in "mLrI")
    g = sympy.Symbol("g")
    angle, x, y, lagrangian = sympy.Integer(0), sympy.Integer(0), sympy.Integer(0), sympy.Integer(0)
    for i in range(joints):
        angle += q[i]
        cx, cy = x + r[i] * sympy.cos(angle), y + r[i] * sympy.sin(angle)
        speed = cx.diff(t) ** 2 + cy.diff(t) ** 2
        lagrangian += m[i] * speed / 2 + inertia[i] * angle.diff(t) ** 2 / 2 - m[i] * g * cy
        x, y = x + length[i] * sympy.cos(angle), y + length[i] * sympy.sin(angle)
    found = Derivation(*planar(joints), DOWN)
    names = sympy.symbols(f"q1:{joints + 1}")
    rates = sympy.symbols(f"dq1:{joints + 1}")
    second = sympy.symbols(f"ddq1:{joints + 1}")
    M, C, held = (
        sympy.Matrix([[to_sympy(entry) for entry in row] for row in part])
        for part in (found.mass, found.coriolis, found.gravity)
    )
    ours = M * sympy.Matrix(second) + C * sympy.Matrix(rates) + held
    named: dict[sympy.Basic, sympy.Basic] = dict(zip(q, names, strict=True))
    for j in range(joints):
        named |= {q[j].diff(t): rates[j], q[j].diff(t, 2): second[j]}
    rng = np.random.default_rng(5)
    for i in range(joints):
        theirs = lagrangian.diff(q[i].diff(t)).diff(t) - lagrangian.diff(q[i])
        difference = theirs.xreplace(named) - ours[i]
        if joints == 2:  # in exponentials an identity of sines and cosines is one of polynomials
            assert difference.rewrite(sympy.exp).expand() == 0
        symbols = sorted(difference.free_symbols, key=str)
        for _ in range(2):
            values = dict(zip(symbols, rng.uniform(-2, 2, len(symbols)), strict=True))
            assert abs(difference.subs(values).evalf()) < 1e-12


def test_the_rate_of_m_less_twice_c_is_skew_identically() -> None:
    found = Derivation(*planar(3), DOWN)
    q, rates = sympy.symbols("q1:4"), sympy.symbols("dq1:4")
    M, C = (
        sympy.Matrix([[to_sympy(entry) for entry in row] for row in part])
        for part in (found.mass, found.coriolis)
    )
    rate = sum((M.diff(q[k]) * rates[k] for k in range(3)), sympy.zeros(3))
    skew = rate - 2 * C
    assert (skew + skew.T).applyfunc(sympy.expand).applyfunc(sympy.simplify) == sympy.zeros(3)


def values(matrix: Matrix, parameters: dict[str, float], q: np.ndarray) -> np.ndarray:
    return np.array([[evaluate(entry, parameters, q.tolist()) for entry in row] for row in matrix])


@pytest.mark.parametrize(
    "name", ["twolink", "scara", "stanford", "puma560", "rx90", "uw", "scorbot", "scara-scm", "onelink"]
)
def test_closed_forms_are_worth_what_the_recursion_computes(name: str) -> None:
    robot = catalogue.robot(name)
    table = robot.table.table
    weights = (*puma_links(), link(0.4, (0.1, -0.2, 0.05), (0.02, 0.03, 0.04)))
    links = tuple(weights[1 + i % 6] for i in range(len(table.rows)))
    fall = (number("0.7"), number("-1.3"), number("-9.81"))
    found = Derivation(table, exact(links), fall)
    moving = MovingRobot(bind(table, robot.parameters), links, [evaluate(entry) for entry in fall])
    rng = np.random.default_rng(3)
    for _ in range(3):
        q, rates = rng.uniform(-2, 2, (2, table.n_joints))
        known = {**robot.parameters, **{rate_name(i): v for i, v in enumerate(rates.tolist(), 1)}}
        for ours, theirs in (
            (found.mass, moving.mass_matrix(q)),
            (found.coriolis, moving.coriolis_matrix(q, rates)),
            (found.velocity, moving.velocity_torque(q, rates)[:, None]),
            (found.gravity, moving.gravity_torque(q)[:, None]),
        ):
            np.testing.assert_allclose(values(ours, known, q), theirs, atol=1e-11)


def test_general_angles_named_twists_and_reversed_variables() -> None:
    """cos(alpha1), 37°, arctangents and 15° stay exact."""
    angles: tuple[Expression, ...] = (
        P("alpha1"),
        pi_times(number("37/180").value),
        pi_times(number("1/12").value),
        call(Function.ATAN2, P("L1"), P("L2")),
    )
    rows = tuple(
        DHRow(
            joint=JointType.PRISMATIC if i == 1 else JointType.REVOLUTE,
            theta=angles[3 - i],
            d=P("L1"),
            a=P("L2"),
            alpha=angle,
            sign=-1 if i in (1, 2) else 1,
        )
        for i, angle in enumerate(angles[:3])
    )
    known = {"alpha1": 0.7, "L1": 0.4, "L2": 0.3}
    for convention in Convention:
        table: SymbolicTable = DHTable(convention=convention, rows=rows)
        links = exact((link(0.4, (0.1, -0.2, 0.05), (0.02, 0.03, 0.04)),) * 3)
        found = Derivation(table, links, (ZERO, ZERO, number("-9.81")))
        moving = MovingRobot(bind(table, known), bind_links(links, {}))
        q, rates = np.random.default_rng(3).uniform(-2, 2, (2, 3))
        given = {**known, **{rate_name(i): v for i, v in enumerate(rates.tolist(), 1)}}
        np.testing.assert_allclose(values(found.mass, given, q), moving.mass_matrix(q), atol=1e-12)
        C = moving.coriolis_matrix(q, rates)
        np.testing.assert_allclose(values(found.coriolis, given, q), C, atol=1e-12)
        held = moving.gravity_torque(q)[:, None]
        np.testing.assert_allclose(values(found.gravity, given, q), held, atol=1e-12)


def test_links_named_in_full_are_worth_what_the_recursion_computes() -> None:
    """Ten names for a link, some of them in expressions, beside numbers and names that two links share."""
    known = {"beta": 0.4, "r": 0.3, "m": 1.2, "L2": 0.35}
    table, _ = planar(3)
    table = DHTable(
        convention=Convention.STANDARD,
        rows=tuple(
            DHRow(joint=row.joint, theta=ZERO, d=number("0.2"), a=P("L2"), alpha=alpha)
            for row, alpha in zip(table.rows, (pi_times(number("1/2").value), P("beta"), ZERO), strict=True)
        ),
    )
    links = []
    for i in range(1, 4):
        names = [f"{word}{i}" for word in ("x", "y", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz")]
        known |= dict(zip(names, (0.1, -0.2, 0.5, 0.01, -0.02, 0.6, 0.03, 0.7), strict=True))
        x, y, xx, xy, xz, yy, yz, zz = map(P, names)
        across = multiply((P("r"), call(Function.COS, P("beta"))))
        inertia = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz if i > 1 else number("0.7")))
        links.append(RigidBody(mass=P("m"), centre=(x, y, across), inertia=inertia))
    found = Derivation(table, links, (ZERO, ZERO, number("-9.81")))
    moving = MovingRobot(bind(table, known), bind_links(links, known))
    q, rates = np.random.default_rng(4).uniform(-2, 2, (2, 3))
    given = {**known, **{rate_name(i): v for i, v in enumerate(rates.tolist(), 1)}}
    np.testing.assert_allclose(values(found.mass, given, q), moving.mass_matrix(q), atol=1e-12)
    C = moving.coriolis_matrix(q, rates)
    np.testing.assert_allclose(values(found.coriolis, given, q), C, atol=1e-12)
    held = moving.gravity_torque(q)[:, None]
    np.testing.assert_allclose(values(found.gravity, given, q), held, atol=1e-12)


def test_too_much_is_refused() -> None:
    puma = catalogue.robot("puma560").table.table
    with pytest.raises(FormSizeError):
        Derivation(puma, exact(puma_links()), DOWN, limit=500)


def test_the_order_of_terms_owes_nothing_to_the_process() -> None:
    code = (
        "from tests.kinematics.dynamics.planar import *\n"
        "found = Derivation(*planar(3), DOWN)\n"
        "print(written(found.mass, 3), written(found.coriolis, 3), written(found.gravity, 3))"
    )
    texts = {
        subprocess.run(
            [sys.executable, "-c", code],
            env={**os.environ, "PYTHONHASHSEED": seed},
            capture_output=True,
            check=True,
            text=True,
        ).stdout
        for seed in ("1", "2")
    }
    assert len(texts) == 1
    assert "c23" in texts.pop()


def test_names_of_a_table_come_after_the_masses() -> None:
    table, links = planar(2)
    assert table_parameters(table) == ("L1", "L2")
    assert Derivation(table, links, DOWN).names == ("m1", "m2", "L1", "L2", "r1", "I1", "r2", "I2", "g")
