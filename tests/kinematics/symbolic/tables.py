"""Random exact tables, and rewritings that leave the robot what it is."""

import random
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np

from kinematics.expressions import (
    ZERO,
    Expression,
    Function,
    Parameter,
    add,
    call,
    evaluate,
    multiply,
    negate,
    number,
    pi_times,
)
from kinematics.table import Convention, DHRow, DHTable, JointType, SymbolicRow, SymbolicTable

HALF = Fraction(1, 2)
TWISTS = [pi_times(Fraction(k, 2)) for k in (-1, 0, 1, 2)]
TWELFTHS = [pi_times(Fraction(k, 12)) for k in range(-11, 13)]
GENERAL = [number("0.3"), number("-1.2345"), pi_times(Fraction(37, 180)), pi_times(Fraction(-2, 5))]
ANGLES = [Parameter("alpha"), Parameter("beta")]
PUMA_LENGTHS = ("a2", "a3", "d3", "d4")


def row(
    joint: JointType = JointType.REVOLUTE,
    *,
    theta: Expression = ZERO,
    d: Expression = ZERO,
    a: Expression = ZERO,
    alpha: Expression = ZERO,
    sign: int = 1,
) -> SymbolicRow:
    """A row with zeros where nothing is said."""
    return DHRow(joint=joint, theta=theta, d=d, a=a, alpha=alpha, sign=sign)


def table(convention: Convention, *rows: SymbolicRow) -> SymbolicTable:
    """A table."""
    return DHTable(convention=convention, rows=rows)


def puma(convention: Convention) -> SymbolicTable:
    """PUMA 560 with symbolic lengths: standard as in DESIGN, modified as in Craig's book (eq. 3.9 ff.)."""
    a2, a3, d3, d4 = map(Parameter, PUMA_LENGTHS)
    right, left = pi_times(HALF), pi_times(-HALF)
    if convention is Convention.STANDARD:
        cells = [(right, ZERO, ZERO), (ZERO, a2, ZERO), (left, a3, d3), (right, ZERO, d4), (left, ZERO, ZERO)]
        cells.append((ZERO, ZERO, ZERO))
    else:
        cells = [(ZERO, ZERO, ZERO), (left, ZERO, ZERO), (ZERO, a2, d3), (left, a3, d4), (right, ZERO, ZERO)]
        cells.append((left, ZERO, ZERO))
    return table(convention, *(row(alpha=alpha, a=a, d=d) for alpha, a, d in cells))


def random_length(rng: random.Random) -> Expression:
    """Zero, a decimal, a parameter, or something composed."""
    choice = rng.randrange(8)
    if choice < 3:
        return ZERO
    if choice < 5:
        return number(Fraction(rng.randrange(-999, 1000), 1000))
    name = Parameter(rng.choice(["L1", "L2", "a3", "d4"]))
    if choice == 6:
        return add((name, number(rng.randrange(-3, 4))))
    if choice == 7:
        return multiply((call(Function.SQRT, number(rng.choice([2, 3, 5, 6, 37]))), name))
    return name


def random_angle(rng: random.Random) -> Expression:
    """Mostly quarter turns; sometimes a twelfth, a general angle or a parameter."""
    pool = rng.choice([TWISTS, TWISTS, TWISTS, TWELFTHS, GENERAL, ANGLES])
    return rng.choice(pool)


def random_table(rng: random.Random, joints: int, *, fixed: int = 0) -> SymbolicTable:
    """A table with the given numbers of joints and fixed rows, in either convention."""
    kinds = [rng.choice([JointType.REVOLUTE] * 3 + [JointType.PRISMATIC]) for _ in range(joints)]
    kinds += [JointType.FIXED] * fixed
    rng.shuffle(kinds)
    rows = [
        row(
            kind,
            theta=random_angle(rng) if rng.random() < 0.5 else ZERO,
            d=random_length(rng),
            a=random_length(rng),
            alpha=random_angle(rng),
            sign=rng.choice([1, 1, -1]),
        )
        for kind in kinds
    ]
    return table(rng.choice(list(Convention)), *rows)


def other_convention(old: SymbolicTable) -> SymbolicTable:
    """The same robot in the other convention: each row becomes two, one of them fixed."""
    rows = []
    for r in old.rows:
        about_z = row(r.joint, theta=r.theta, d=r.d, sign=r.sign)
        about_x = row(JointType.FIXED, a=r.a, alpha=r.alpha)
        rows += [about_z, about_x] if old.convention is Convention.STANDARD else [about_x, about_z]
    return table(next(c for c in Convention if c is not old.convention), *rows)


def reparametrised(old: SymbolicTable, signs: list[int], offsets: list[Expression]) -> SymbolicTable:
    """The table G with G(σ∘q + δ) = F(q)."""
    rows, joint = [], 0
    for r in old.rows:
        theta, d, sign = r.theta, r.d, r.sign
        if r.joint is not JointType.FIXED:
            sign = r.sign * signs[joint]
            shift = multiply((number(-sign), offsets[joint]))
            theta = add((theta, shift)) if r.joint is JointType.REVOLUTE else theta
            d = add((d, shift)) if r.joint is JointType.PRISMATIC else d
            joint += 1
        rows.append(row(r.joint, theta=theta, d=d, a=r.a, alpha=r.alpha, sign=sign))
    return table(old.convention, *rows)


def with_axis_turned(old: SymbolicTable, where: int) -> SymbolicTable:
    """The same robot with a half turn about x inserted and taken back around a row of a standard table."""
    assert old.convention is Convention.STANDARD
    r = old.rows[where]
    flip = row(JointType.FIXED, alpha=pi_times(1))
    turned = row(r.joint, theta=negate(r.theta), d=negate(r.d), a=r.a, alpha=r.alpha, sign=-r.sign)
    return table(old.convention, *old.rows[:where], flip, turned, flip, *old.rows[where + 1 :])


def sympy_poses(symbolic: SymbolicTable, configurations: Any) -> Any:
    """⁰T_N at each configuration: SymPy's link matrices, evaluated and multiplied."""
    link = _sympy_link(symbolic.convention)
    cells = [[evaluate(cell) for cell in (r.theta, r.d, r.a, r.alpha)] for r in symbolic.rows]
    poses = []
    for configuration in configurations:
        pose, joint = np.eye(4), 0
        for r, (theta, d, a, alpha) in zip(symbolic.rows, cells, strict=True):
            if r.joint is not JointType.FIXED:
                moved = r.sign * configuration[joint]
                joint += 1
                theta, d = (theta + moved, d) if r.joint is JointType.REVOLUTE else (theta, d + moved)
            pose = pose @ np.array(link(theta, d, a, alpha), dtype=float)
        poses.append(pose)
    return np.array(poses)


@cache
def _sympy_link(convention: Convention) -> Any:
    """A row's matrix as a function of theta, d, a, alpha: elementary matrices, multiplied by SymPy."""
    import sympy

    theta, d, a, alpha = sympy.symbols("theta d a alpha")
    about_z = _sympy_turn(2, theta) * _sympy_slide(2, d)
    about_x = _sympy_slide(0, a) * _sympy_turn(0, alpha)
    product = about_z * about_x if convention is Convention.STANDARD else about_x * about_z
    return sympy.lambdify([theta, d, a, alpha], product.tolist(), "math")


def _sympy_turn(axis: int, angle: Any) -> Any:
    import sympy

    c, s = sympy.cos(angle), sympy.sin(angle)
    if axis == 2:
        return sympy.Matrix([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    return sympy.Matrix([[1, 0, 0, 0], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]])


def _sympy_slide(axis: int, length: Any) -> Any:
    import sympy

    matrix = sympy.eye(4)
    matrix[axis, 3] = length
    return matrix


def general_table(rng: random.Random) -> SymbolicTable:
    """Seven rows with general numeric twists."""

    def length() -> Expression:
        return number(Fraction(rng.randrange(-999, 1000), 1000))

    rows = [
        row(
            rng.choice([JointType.REVOLUTE] * 4 + [JointType.PRISMATIC]),
            theta=rng.choice([ZERO, TWISTS[2], number(Fraction(rng.randrange(-314, 314), 100))]),
            d=length(),
            a=length(),
            alpha=rng.choice([*GENERAL, number(Fraction(rng.randrange(-3141, 3141), 1000))]),
            sign=rng.choice([1, -1]),
        )
        for _ in range(7)
    ]
    return table(rng.choice(list(Convention)), *rows)
