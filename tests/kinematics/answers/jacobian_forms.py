"""Jacobians as functions, and what is wrong about them: made from products of DH matrices by SymPy."""

import random
from collections.abc import Iterator
from functools import cache

import sympy as sp

from kinematics import catalogue
from kinematics.answers.form_samples import FormRobot
from kinematics.cells import ParameterKind
from kinematics.expressions import Expression, evaluate
from kinematics.jacobian import JacobianFrame
from kinematics.symbolic import from_sympy, to_sympy
from kinematics.table import Convention, JointType

ROBOTS = ("twolink", "onelink", "scara", "rx90", "scorbot", "stanford", "cloos")


def robot(name: str) -> FormRobot:
    """Return a robot of the catalogue, its lengths by name."""
    listed = catalogue.robot(name)
    kinds = listed.table.parameters
    lengths = frozenset(name for name, kind in kinds.items() if kind is ParameterKind.LENGTH)
    return FormRobot(table=listed.table.table, values=listed.parameters, lengths=lengths)


@cache
def derivatives(name: str, frame: JacobianFrame) -> sp.Matrix:
    """Return J: derivatives of the last column of the product of DH matrices, and the joints' z axes."""
    table = catalogue.robot(name).table.table
    pose, n, axes = sp.eye(4), 0, []
    for row in table.rows:
        theta, d, a, alpha = (to_sympy(getattr(row, cell)) for cell in ("theta", "d", "a", "alpha"))
        if row.joint is not JointType.FIXED:
            n += 1
            variable = row.sign * sp.Symbol(f"q{n}")
            theta, d = (theta, d + variable) if row.joint is JointType.PRISMATIC else (theta + variable, d)
        z = sp.Matrix(
            [
                [sp.cos(theta), -sp.sin(theta), 0, 0],
                [sp.sin(theta), sp.cos(theta), 0, 0],
                [0, 0, 1, d],
                [0, 0, 0, 1],
            ]
        )
        x = sp.Matrix(
            [
                [1, 0, 0, a],
                [0, sp.cos(alpha), -sp.sin(alpha), 0],
                [0, sp.sin(alpha), sp.cos(alpha), 0],
                [0, 0, 0, 1],
            ]
        )
        before = pose
        pose = pose * (z * x if table.convention is Convention.STANDARD else x * z)
        if row.joint is not JointType.FIXED:
            carrier = before if table.convention is Convention.STANDARD else pose
            turns = 0 if row.joint is JointType.PRISMATIC else row.sign
            axes.append(turns * carrier[:3, 2])
    columns = [[*pose[:3, 3].diff(sp.Symbol(f"q{i}")), *axes[i - 1]] for i in range(1, n + 1)]
    found = sp.Matrix(columns).T.applyfunc(sp.expand)
    if frame is JacobianFrame.END:
        turn = pose[:3, :3].T
        found = sp.Matrix.vstack(turn * found[:3, :], turn * found[3:, :])
    return found


@cache
def entries(name: str, frame: JacobianFrame) -> tuple[tuple[Expression, ...], ...]:
    """Return them as expressions, unsimplified where a student would not have done it either."""
    return tuple(tuple(from_sympy(entry) for entry in row) for row in derivatives(name, frame).tolist())


def rewritten(name: str, entry: sp.Expr, rng: random.Random) -> sp.Expr:
    """Return the same function written otherwise."""
    types = robot(name).table.joint_types
    turning = [i for i, kind in enumerate(types, 1) if kind is JointType.REVOLUTE]
    q = sp.Symbol(f"q{rng.choice(turning)}")
    match rng.randrange(6):
        case 0:
            return sp.expand_trig(entry)
        case 1:
            return sp.Add(entry, sp.sin(q), -sp.sin(q, evaluate=False), evaluate=False)
        case 2:
            return sp.Mul(entry, sp.sin(q) ** 2 + sp.cos(q) ** 2, evaluate=False)
        case 3:
            return entry.subs(q, q + 2 * sp.pi) if rng.random() < 0.5 else sp.expand(entry)
        case 4:
            return sp.Add(entry * 2, -entry, evaluate=False)
    return entry.replace(sp.sin, lambda angle: sp.cos(angle - sp.pi / 2, evaluate=False))


def spoilt(entry: sp.Expr, name: str, rng: random.Random) -> sp.Expr:
    """Return another function: a sign, a sine for a cosine, an angle or a length too much."""
    arm = robot(name)
    n = arm.table.n_joints
    q = sp.Symbol(f"q{rng.randint(1, n)}")
    length = sp.Symbol(rng.choice(sorted(arm.lengths)))
    ways = [entry + sp.sin(q), entry + length * sp.cos(2 * q) / 7, entry - sp.Rational(1, 9)]
    ways += [-entry, entry * sp.cos(q), entry.subs(sp.cos(q), sp.sin(q)), entry.subs(length, 2 * length)]
    rng.shuffle(ways)
    joints = [rng.uniform(-2, 2) for _ in range(n)]
    value = evaluate(from_sympy(entry), arm.values, joints)
    return next(way for way in ways if abs(evaluate(from_sympy(way), arm.values, joints) - value) > 1e-3)


def cases(count: int, seed: int) -> Iterator[tuple[FormRobot, list[list[Expression]], JacobianFrame, bool]]:
    """Yield answers: of whom, what, in which axes, and whether it is right."""
    rng = random.Random(seed)
    for k in range(count):
        name = rng.choice(ROBOTS)
        small = robot(name).table.n_joints < 5
        frame = rng.choice(list(JacobianFrame)) if small else JacobianFrame.BASE
        rows = [list(row) for row in entries(name, frame)]
        symbols = derivatives(name, frame)
        for _ in range(3):
            r, c = rng.randrange(6), rng.randrange(len(rows[0]))
            rows[r][c] = from_sympy(rewritten(name, symbols[r, c], rng))
        if k % 2:
            r, c = rng.randrange(6), rng.randrange(len(rows[0]))
            rows[r][c] = from_sympy(spoilt(symbols[r, c], name, rng))
        yield robot(name), rows, frame, not k % 2
