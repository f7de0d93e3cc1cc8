"""Equations of motion as cells: those of books for three arms, written in other ways, and spoilt.

Nothing of the package derives them; `of_energies` does so once more, from poses by products of matrices.
"""

import random
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import cache

import numpy as np
import sympy
from numpy.typing import NDArray

from exercises.instance import Instance
from exercises.parts.joint_draws import key_numbers
from exercises.parts.motion.equations_of_motion import MotionPart
from exercises.parts.motion.motion_cells import MotionAsk, MotionCells
from tests.exercises.meaning.answers_known import KnownAnswer, known
from tests.exercises.meaning.own_tables import TINY, plain
from tests.exercises.meaning.posed_answers import asking, student
from tests.kinematics.answers.dynamics_rows import other_coriolis, rewritten, spoilt

KIND = "equations_of_motion"
Floats = NDArray[np.float64]
Terms = tuple[sympy.Matrix, sympy.Matrix, sympy.Matrix]
"""M, C q̇ and g."""

q1, q2, q3, dq1, dq2, dq3 = sympy.symbols("q1:4 dq1:4")
m1, m2, m3, m4, I1, I2, I4, g = sympy.symbols("m1:5 I1 I2 I4 g")
L1, L2, L3, a2, a3, r1, r2 = sympy.symbols("L1:4 a2 a3 r1 r2")
c1, c2, c3, c12, c23 = (sympy.cos(angle) for angle in (q1, q2, q3, q1 + q2, q2 + q3))
s2, s3, s23 = (sympy.sin(angle) for angle in (q2, q3, q2 + q3))


def two_links() -> Terms:
    """A planar arm in a vertical plane."""
    pull = m2 * L1 * r2
    coupled = I2 + m2 * r2**2 + pull * c2
    whole = I1 + I2 + m1 * r1**2 + m2 * (L1**2 + r2**2) + 2 * pull * c2
    return (
        sympy.Matrix([[whole, coupled], [coupled, I2 + m2 * r2**2]]),
        sympy.Matrix([-pull * s2 * (2 * dq1 * dq2 + dq2**2), pull * s2 * dq1**2]),
        sympy.Matrix([(m1 * r1 + m2 * L1) * g * c1 + m2 * r2 * g * c12, m2 * r2 * g * c12]),
    )


def scara() -> Terms:
    """Two arms in a horizontal plane, a spindle that slides and turns."""
    tool = m3 + m4
    pull = (m2 / 2 + tool) * a2 * a3
    outer = I2 + I4 + m2 * a3**2 / 4 + tool * a3**2
    whole = I1 + m1 * a2**2 / 4 + (m2 + tool) * a2**2 + outer + 2 * pull * c2
    coupled = outer + pull * c2
    return (
        sympy.Matrix([[whole, coupled, 0, I4], [coupled, outer, 0, I4], [0, 0, tool, 0], [I4, I4, 0, I4]]),
        sympy.Matrix([-pull * s2 * (2 * dq1 * dq2 + dq2**2), pull * s2 * dq1**2, 0, 0]),
        sympy.Matrix([0, 0, tool * g, 0]),
    )


def upright() -> Terms:
    """A column that turns, and two links with point masses that move in a vertical plane."""
    near, far = L1 + L2 * c2, L1 + L2 * c2 + L3 * c23
    lowered = m2 * near * L2 * s2 + m3 * far * (L2 * s2 + L3 * s23)
    bent, pull = m3 * far * L3 * s23, m3 * L2 * L3
    coupled = m3 * L3**2 + pull * c3
    inner = (m2 + m3) * L2**2 + m3 * L3**2 + 2 * pull * c3
    return (
        sympy.Matrix(
            [[I1 + m2 * near**2 + m3 * far**2, 0, 0], [0, inner, coupled], [0, coupled, m3 * L3**2]]
        ),
        sympy.Matrix(
            [
                -2 * dq1 * (dq2 * lowered + dq3 * bent),
                dq1**2 * lowered - pull * s3 * (2 * dq2 * dq3 + dq3**2),
                dq1**2 * bent + pull * s3 * dq2**2,
            ]
        ),
        sympy.Matrix([0, (m2 + m3) * L2 * g * c2 + m3 * g * L3 * c23, m3 * g * L3 * c23]),
    )


BOOKS: Mapping[str, Callable[[], Terms]] = {
    "twolink-dynamics": cache(two_links),
    "scara-dynamics": cache(scara),
    "uw-dynamics": cache(upright),
}
TURNING = {"twolink-dynamics": 2, "scara-dynamics": 2, "uw-dynamics": 3}
"""Joints, the first ones, of which sines may be taken."""


def equations_of_motion(rng: random.Random) -> Iterator[KnownAnswer]:
    """M, C or C q̇, and g, in names or in numbers, and the same with one entry spoilt."""
    name = rng.choice(list(BOOKS))
    found = student(name, rng.randrange(30))
    part = found.exercise.part(KIND)
    assert isinstance(part, MotionPart)
    mass, velocity, gravity = BOOKS[name]()
    n, form = mass.shape[0], rng.choice([MotionAsk.VELOCITY, MotionAsk.CORIOLIS, MotionAsk.SKEW])
    instance = asking(found, replace(part, ask=(MotionAsk.MASS, form, MotionAsk.GRAVITY)))
    rows = {"mass": mass.tolist(), "gravity": [list(gravity)], "velocity": [list(velocity)]}
    if form is not MotionAsk.VELOCITY:
        del rows["velocity"]
        matrix = christoffel(name)
        rows["coriolis"] = (matrix if form is MotionAsk.SKEW else other_coriolis(matrix, rng, n)).tolist()
    written = {
        field: [[rewritten(entry, rng, TURNING[name]) for entry in row] for row in entries]
        for field, entries in rows.items()
    }
    right = dict(written)
    if rng.random() < 0.2:
        field = rng.choice(list(rows))
        values = values_of(instance)
        right[field] = [[sympy.N(entry.subs(values), 7) for entry in row] for row in rows[field]]
    yield known(True, instance, KIND, equations_of_motion=_cells(right))
    field = rng.choice(list(rows))
    i, k = rng.randrange(len(rows[field])), rng.randrange(n)
    entry = spoilt(rows[field][i][k], rng)
    if entry is not None:
        written[field] = [
            [entry if (i, k) == (r, c) else old for c, old in enumerate(row)]
            for r, row in enumerate(written[field])
        ]
        yield known(False, instance, KIND, equations_of_motion=_cells(written))


@cache
def christoffel(name: str) -> sympy.Matrix:
    """The C that is made of derivatives of M."""
    M = BOOKS[name]()[0]
    n = M.shape[0]
    q, rates = sympy.symbols(f"q1:{n + 1}"), sympy.symbols(f"dq1:{n + 1}")
    return sympy.Matrix(
        n,
        n,
        lambda i, j: sum(
            (M[i, j].diff(q[k]) + M[i, k].diff(q[j]) - M[j, k].diff(q[i])) * rates[k] / 2 for k in range(n)
        ),
    )


def values_of(instance: Instance) -> dict[str, float]:
    """A student's lengths and weights."""
    weights = {name: float(value) for name, value in instance.drawn[KIND].items()}
    return {**instance.parameters, **weights}


def of_energies(instance: Instance, joints: list[float], rates: list[float]) -> tuple[Floats, Floats, Floats]:
    """M, C q̇ and g in numbers, from how kinetic and potential energy change with the joints."""
    n, step = len(joints), 1e-5
    by_joint = np.zeros((n, n, n))
    for k in range(n):
        sides = [
            _inertia(instance, [q + way * step * (i == k) for i, q in enumerate(joints)]) for way in (1, -1)
        ]
        by_joint[k] = (sides[0][0] - sides[1][0]) / (2 * step)
    mass, gravity = _inertia(instance, joints)
    moved = np.array(rates)
    velocity = (
        np.einsum("kij,k,j->i", by_joint, moved, moved) - np.einsum("ijk,j,k->i", by_joint, moved, moved) / 2
    )
    return mass, velocity, gravity


def _inertia(instance: Instance, joints: list[float]) -> tuple[Floats, Floats]:
    """M and g of what moves with each frame, by derivatives of its pose."""
    part = instance.exercise.part(KIND)
    assert isinstance(part, MotionPart)
    values, table, n = values_of(instance), plain(key_numbers(instance)), len(joints)

    def numbers(cells: tuple[object, ...]) -> Floats:
        return np.array([float(sympy.sympify(str(cell)).subs(values)) for cell in cells])

    here = table.frames(joints)
    moved = [table.frames([q + TINY * 1j * (k == i) for k, q in enumerate(joints)]) for i in range(n)]
    mass, gravity, fall = np.zeros((n, n)), np.zeros(n), numbers(part.gravity)
    for i, body in enumerate(part.links, 1):
        weight, centre = numbers((body.mass,))[0], np.array([*numbers(body.centre), 1.0])
        inertia = np.diag(numbers(tuple(body.inertia[k][k] for k in range(3))))
        turns = here[i][:3, :3].real
        change = [frames[i].imag / TINY for frames in moved]
        shifts = np.array([(rate @ centre)[:3] for rate in change])
        spins = [turns.T @ rate[:3, :3] for rate in change]
        own = np.array([[spin[2, 1], spin[0, 2], spin[1, 0]] for spin in spins])
        mass += weight * shifts @ shifts.T + own @ inertia @ own.T
        gravity -= weight * shifts @ fall
    return mass, gravity


def _cells(rows: Mapping[str, list[list[sympy.Expr]]]) -> MotionCells:
    text = {
        field: tuple(tuple(str(entry).replace("**", "^") for entry in row) for row in entries)
        for field, entries in rows.items()
    }
    lists = {field: text[field][0] for field in ("velocity", "gravity") if field in text}
    return MotionCells(mass=text["mass"], coriolis=text.get("coriolis"), **lists)
