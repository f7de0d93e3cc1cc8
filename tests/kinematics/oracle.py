"""Forward kinematics derived anew, by means that the package does not use.

Sines and cosines are power series summed in 50-digit arithmetic; links are products of four elementary 4×4
matrices; Jacobians are central differences of poses. Slow, plain, and not shared with what it judges.
"""

from collections.abc import Sequence

import mpmath
import numpy as np
from numpy.typing import NDArray

from kinematics.table import Convention, JointType, NumericTable

Floats = NDArray[np.float64]
Exact = NDArray[np.object_]
"""A 4×4 matrix of `mpmath.mpf`."""

DIGITS = 50


def elementary(axis: str, angle: object, length: object) -> Exact:
    """Rotation about an axis by `angle` and translation along it by `length`."""
    with mpmath.workdps(DIGITS):
        i, j = {"x": (1, 2), "z": (0, 1)}[axis]
        k = {"x": 0, "z": 2}[axis]
        cosine, sine = _cosine_sine(mpmath.mpf(angle))
        rotation = _identity()
        rotation[i, i] = rotation[j, j] = cosine
        rotation[j, i], rotation[i, j] = sine, -sine
        rotation[k, 3] = mpmath.mpf(length)
        return rotation


def link(row: object, convention: Convention, q: object) -> Exact:
    """The four elementary matrices of a row, multiplied."""
    with mpmath.workdps(DIGITS):
        theta, d = mpmath.mpf(row.theta), mpmath.mpf(row.d)
        if row.joint is JointType.REVOLUTE:
            theta += row.sign * mpmath.mpf(q)
        if row.joint is JointType.PRISMATIC:
            d += row.sign * mpmath.mpf(q)
        turn, slide = elementary("z", theta, 0), elementary("z", 0, d)
        reach, twist = elementary("x", 0, row.a), elementary("x", row.alpha, 0)
        if convention is Convention.STANDARD:
            return turn @ slide @ reach @ twist
        return twist @ reach @ turn @ slide


def links(table: NumericTable, joints: Sequence[float]) -> list[Exact]:
    """Every link transform."""
    values = dict(zip(table.joint_rows, joints, strict=True))
    return [link(row, table.convention, values.get(i, 0.0)) for i, row in enumerate(table.rows)]


def pose(
    table: NumericTable, joints: Sequence[float], base: Floats | None = None, tool: Floats | None = None
) -> Floats:
    """base · A_1 ⋯ A_N · tool."""
    return as_array(_product([_exactly(base), *links(table, joints), _exactly(tool)]))


def frames(table: NumericTable, joints: Sequence[float], base: Floats | None = None) -> Floats:
    """base · A_1 ⋯ A_i for every i."""
    chain = links(table, joints)
    poses = [as_array(_product([_exactly(base), *chain[: i + 1]])) for i in range(len(chain))]
    return np.array(poses).reshape(-1, 4, 4)


def jacobian(
    table: NumericTable, joints: Sequence[float], base: Floats | None = None, tool: Floats | None = None
) -> Floats:
    """J0 by central differences in 50 digits: the error of the differences is 1e-30."""
    with mpmath.workdps(DIGITS):
        step = mpmath.mpf(10) ** -15
        columns = []
        chain = [_exactly(base), *links(table, joints), _exactly(tool)]
        here = _product(chain)
        for row, q in zip(table.joint_rows, joints, strict=True):
            before, after = _product(chain[: row + 1]), _product(chain[row + 2 :])
            plus, minus = (
                before @ link(table.rows[row], table.convention, mpmath.mpf(q) + sign * step) @ after
                for sign in (1, -1)
            )
            rate = (plus - minus) / (2 * step)
            spin = rate[:3, :3] @ here[:3, :3].T
            columns.append([rate[0, 3], rate[1, 3], rate[2, 3], spin[2, 1], spin[0, 2], spin[1, 0]])
        return np.array([[float(x) for x in column] for column in columns]).reshape(-1, 6).T


def as_array(matrix: Exact) -> Floats:
    """Correctly rounded doubles."""
    return np.array([[float(x) for x in row] for row in matrix.tolist()])


def _product(factors: list[Exact]) -> Exact:
    with mpmath.workdps(DIGITS):
        product = _identity()
        for factor in factors:
            product = product @ factor
        return product


def _identity() -> Exact:
    return np.array([[mpmath.mpf(i == j) for j in range(4)] for i in range(4)])


def _exactly(transform: Floats | None) -> Exact:
    given = np.eye(4) if transform is None else np.asarray(transform)
    return np.array([[mpmath.mpf(float(x)) for x in row] for row in given])


def _cosine_sine(angle: mpmath.mpf) -> tuple[mpmath.mpf, mpmath.mpf]:
    """Power series after reduction to a quarter turn."""
    with mpmath.workdps(2 * DIGITS):
        rest = angle - 2 * mpmath.pi * mpmath.nint(angle / (2 * mpmath.pi))
    term, cosine, sine = mpmath.mpf(1), mpmath.mpf(0), mpmath.mpf(0)
    for n in range(80 if rest else 1):
        if n % 2 == 0:
            cosine += term if n % 4 == 0 else -term
        else:
            sine += term if n % 4 == 1 else -term
        term = term * rest / (n + 1)
    return cosine, sine
