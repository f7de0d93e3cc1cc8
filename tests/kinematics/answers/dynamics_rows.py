"""Equations of motion of planar arms by SymPy's Lagrange, rewritten in many ways, and spoilt.

Nothing of the package derives them; other C with the same C q̇ are made by adding what vanishes on q̇.
"""

import random
import statistics
import sys
import time
from functools import cache

import sympy

from exercises.parts.cells.matrix_cells import read_functions
from kinematics.answers.dynamics_answers import judge_dynamics
from kinematics.answers.dynamics_verdicts import DynamicsQuestion, EquationsAnswer
from kinematics.cells import AngleUnit
from kinematics.expressions import Expression
from kinematics.table import JointType
from tests.kinematics.dynamics.test_equations import DOWN, planar

VALUES = {
    "L1": 0.5, "L2": 0.4, "L3": 0.3, "r1": 0.2, "r2": 0.15, "r3": 0.1, "m1": 3.0, "m2": 2.0, "m3": 1.0,
    "I1": 0.05, "I2": 0.04, "I3": 0.03, "g": 9.81,
}  # fmt: skip
Rows = list[list[sympy.Expr]]


def question(joints: int) -> DynamicsQuestion:
    table, links = planar(joints)
    names = {name: value for name, value in VALUES.items() if not name[1:] or int(name[1:]) <= joints}
    return DynamicsQuestion(table=table, links=links, gravity=DOWN, values=names)


@cache
def lagrange(joints: int) -> tuple[sympy.Matrix, sympy.Matrix, sympy.Matrix]:
    """M, the C of Christoffel symbols, and g, from energies."""
    q, rates = sympy.symbols(f"q1:{joints + 1}"), sympy.symbols(f"dq1:{joints + 1}")
    m, length, r, inertia = (sympy.symbols(f"{word}1:{joints + 1}") for word in "mLrI")
    kinetic, potential, angle, x, y = (sympy.Integer(0) for _ in range(5))

    def rate(entry: sympy.Expr) -> sympy.Expr:
        return sum(entry.diff(q[k]) * rates[k] for k in range(joints))

    for i in range(joints):
        angle += q[i]
        cx, cy = x + r[i] * sympy.cos(angle), y + r[i] * sympy.sin(angle)
        kinetic += m[i] * (rate(cx) ** 2 + rate(cy) ** 2) / 2 + inertia[i] * rate(angle) ** 2 / 2
        potential += m[i] * sympy.Symbol("g") * cy
        x, y = x + length[i] * sympy.cos(angle), y + length[i] * sympy.sin(angle)
    M = sympy.hessian(sympy.expand(kinetic), rates)
    C = sympy.Matrix(
        joints,
        joints,
        lambda i, j: sum(
            (M[i, j].diff(q[k]) + M[i, k].diff(q[j]) - M[j, k].diff(q[i])) * rates[k] / 2
            for k in range(joints)
        ),
    )
    return M, C, sympy.Matrix([potential.diff(entry) for entry in q])


def rewritten(entry: sympy.Expr, rng: random.Random, joints: int) -> sympy.Expr:
    """The same function, written differently."""
    q = sympy.Symbol(f"q{rng.randint(1, joints)}")
    way = rng.randrange(6)
    if way == 0:
        return sympy.expand(entry)
    if way == 1:
        return sympy.expand_trig(entry)
    if way == 2:
        return entry * sympy.Add(sympy.sin(q) ** 2, sympy.cos(q) ** 2, evaluate=False)
    if way == 3:
        return entry + sympy.sin(2 * q) - 2 * sympy.sin(q) * sympy.cos(q)
    if way == 4:
        return sympy.collect(sympy.expand(entry), [sympy.Symbol("m2"), sympy.Symbol("g")])
    return entry.replace(sympy.sin, lambda angle: sympy.cos(angle - sympy.pi / 2, evaluate=False))


def other_coriolis(C: sympy.Matrix, rng: random.Random, joints: int) -> sympy.Matrix:
    """C + K with K q̇ = 0: in a row, dq_b at a and −dq_a at b."""
    changed = C.copy()
    for i in range(joints):
        a, b = rng.sample(range(joints), 2)
        weight = rng.choice([1, sympy.Symbol("m2"), sympy.cos(sympy.Symbol("q2"))])
        changed[i, a] += weight * sympy.Symbol(f"dq{b + 1}")
        changed[i, b] -= weight * sympy.Symbol(f"dq{a + 1}")
    return changed


def spoilt(entry: sympy.Expr, rng: random.Random) -> sympy.Expr | None:
    """A term left out, doubled, or of the other sign, or a name for another; None if that is nothing."""
    terms = list(sympy.Add.make_args(sympy.expand(entry)))
    if terms == [0]:
        return None
    k = rng.randrange(len(terms))
    way = rng.randrange(4)
    if way == 3:
        names = sorted(terms[k].free_symbols & set(map(sympy.Symbol, VALUES)), key=str)
        if not names:
            return None
        name = rng.choice(names)
        like = [s for s in sorted(entry.free_symbols, key=str) if str(s)[0] == str(name)[0] and s != name]
        other = rng.choice(like or [sympy.Integer(0)])
        changed = terms[k].subs(name, other)
    else:
        changed = [sympy.Integer(0), 2 * terms[k], -terms[k]][way]
    if sympy.simplify(changed - terms[k]) == 0:
        return None
    return sympy.Add(*terms[:k], changed, *terms[k + 1 :])


def read(rows: Rows) -> tuple[tuple[Expression, ...], ...]:
    joints = (JointType.REVOLUTE,) * len(rows[0])
    found = [
        read_functions([str(entry).replace("**", "^") for entry in row], joints, AngleUnit.RAD, ())
        for row in rows
    ]
    return tuple(tuple(entry.expression for entry in row) for row in found)  # type: ignore[union-attr]


def campaign(count: int, seed: int = 1) -> tuple[int, int, list[str], tuple[float, float]]:
    """Judge so many answers; right, wrong, which were misjudged, median times [ms]."""
    rng = random.Random(seed)
    right = wrong = 0
    misjudged: list[str] = []
    times: dict[bool, list[float]] = {True: [], False: []}
    for k in range(count):
        joints = 2 if rng.random() < 0.8 else 3
        asked = question(joints)
        M, C, g = lagrange(joints)
        if rng.random() < 0.5:
            C = other_coriolis(C, rng, joints)
        parts: dict[str, Rows] = {"mass": M.tolist(), "coriolis": C.tolist(), "gravity": [list(g)]}
        spoil = rng.random() < 0.5
        name = rng.choice(list(parts))
        kept = {name: [[rewritten(e, rng, joints) for e in row] for row in parts[name]]}
        if spoil:
            i, j = rng.randrange(len(kept[name])), rng.randrange(joints)
            changed = spoilt(parts[name][i][j], rng)
            if changed is None:
                spoil = False
            else:
                kept[name][i][j] = changed
        rows = read(kept[name])
        given = {name: rows[0] if name == "gravity" else rows}
        start = time.process_time()
        found = judge_dynamics(asked, EquationsAnswer(**given))  # type: ignore[arg-type]
        times[found.right].append(1e3 * (time.process_time() - start))
        right += not spoil
        wrong += spoil
        if found.right == spoil:
            misjudged.append(f"{k} {joints} {name}: {kept[name]}")
    return right, wrong, misjudged, (statistics.median(times[True]), statistics.median(times[False]))


if __name__ == "__main__":
    amount = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    print("right, wrong, misjudged, median ms:", campaign(amount))
