"""The closed form of an arm with a spherical wrist for many targets, in array operations.

The same equations as in `wrist`, for arms whose axes 1 and 2 meet or are parallel, or whose axes 2 and 3 are
parallel: then every equation has two roots, and all eight combinations are computed for every target. Those
whose equation has clearly no root are left out; what is doubtful is there, and judged with the rest.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Array
from kinematics.inverse.methods.wrist import ALMOST, Head, WristArm
from kinematics.inverse.methods.wrist_tapes import left_over_tape, run_on_arrays

CLEARLY = 1e-6
"""Part of its terms by which a square root's argument is below zero where there is no root."""


SHORTEST = 1e-100
"""Sines below this are those of a wrist in line: nothing is divided by them."""


class Roots(NamedTuple):
    """Values of an angle, and where they are roots."""

    values: Array
    there: NDArray[np.bool_]


def has_blocks(wrist: WristArm) -> bool:
    """Return whether an arm's equations have two roots each."""
    head = wrist.head
    level = abs(head.sa2) <= ALMOST < abs(head.sa1)
    return level or (abs(head.sa2) > ALMOST and (abs(head.a1) <= ALMOST or abs(head.sa1) <= ALMOST))


def candidates_of_many(wrist: WristArm, targets: Array) -> tuple[Array, NDArray[np.intp]]:
    """Return the candidates for many targets.

    Args:
        wrist: the arm; see `has_blocks`.
        targets: (m, 4, 4).

    Returns:
        (k, 6) in order of the targets, and how many each has, (m,).
    """
    T = wrist.before @ targets @ wrist.after
    q1, q2, q3, there = _heads(wrist.head, *(T[:, :3, 3].T / wrist.size))
    turns = [f(q) for q in (q1, q2, q3) for f in (np.cos, np.sin)]
    R = [np.ascontiguousarray(T[:, i, j])[:, None] for i in range(3) for j in range(3)]
    left = run_on_arrays(left_over_tape(wrist), [*turns, *R])
    q4, q5, q6 = _wrists(wrist.wrist, left)
    joints = np.empty((*q4.shape, 6))
    for k, values in enumerate((q1[..., None], q2[..., None], q3[..., None], q4, q5, q6)):
        joints[..., k] = values - wrist.zeros[k]
    kept = np.broadcast_to(there[..., None], q4.shape).reshape(len(T), -1)
    return joints.reshape(-1, 6)[kept.ravel()], kept.sum(axis=1)


def _linear(c: float, s: float, k: Array) -> Roots:
    """Both roots of c·cos q + s·sin q = k, (m, 2)."""
    length = np.hypot(c, s)
    across = (length - k) * (length + k)
    half = np.arctan2(np.sqrt(np.maximum(across, 0.0)), k)
    middle = np.arctan2(s, c)
    there = across >= -CLEARLY * length * length
    return Roots(np.stack((middle - half, middle + half), axis=1), np.stack((there, there), axis=1))


def _heads(h: Head, x: Array, y: Array, z: Array) -> tuple[Array, Array, Array, NDArray[np.bool_]]:
    """θ_1, θ_2, θ_3, (m, 4) each, and where they are roots."""
    a1, ca1, sa1, d2, a2, ca2, sa2, rho, zeta = h
    if abs(sa2) <= ALMOST:
        return _level_heads(h, x, y, z)
    meet = abs(a1) <= ALMOST
    across = x * x + y * y
    far = across + z * z
    if meet:
        rest = a1 * a1 + a2 * a2 + rho * rho + zeta * zeta + d2 * d2 + 2.0 * d2 * ca2 * zeta
        thirds = _linear(2.0 * a2 * rho, 2.0 * d2 * sa2 * rho, far - rest)
    else:
        thirds = _linear(0.0, ca1 * sa2 * rho, z - ca1 * (d2 + ca2 * zeta))
    x, y, z, across, far = (each[:, None] for each in (x, y, z, across, far))
    c3, s3 = np.cos(thirds.values), np.sin(thirds.values)
    f1, f2 = a2 + rho * c3, ca2 * rho * s3 - sa2 * zeta
    f3 = d2 + sa2 * rho * s3 + ca2 * zeta
    square = f1 * f1 + f2 * f2
    known = (z - ca1 * f3) / sa1 if meet else (far - square - f3 * f3 - a1 * a1) / (2.0 * a1)
    # Beside axis 1 f² - g_2² would be the difference of large numbers.
    argument = across - (ca1 * known - sa1 * f3) ** 2 if meet else square - known * known
    there = thirds.there & (argument >= -CLEARLY * (square + known * known))
    root = np.sqrt(np.maximum(argument, 0.0))
    both = np.concatenate((root, -root), axis=1)
    known, f1, f2, f3 = (np.concatenate((each, each), axis=1) for each in (known, f1, f2, f3))
    g1, g2 = (both, known) if meet else (known, both)
    px, py = a1 + g1, ca1 * g2 - sa1 * f3
    q1 = np.arctan2(y * px - x * py, x * px + y * py)
    q2 = np.arctan2(f1 * g2 - f2 * g1, f1 * g1 + f2 * g2)
    q3 = np.concatenate((thirds.values, thirds.values), axis=1)
    return q1, q2, q3, np.concatenate((there, there), axis=1)


def _level_heads(h: Head, x: Array, y: Array, z: Array) -> tuple[Array, Array, Array, NDArray[np.bool_]]:
    """The same where axes 2 and 3 are parallel: the arm moves in a plane at a known distance from axis 1."""
    a1, ca1, sa1, d2, a2, ca2, _, rho, zeta = h
    f3 = d2 + ca2 * zeta
    g2 = ((z - ca1 * f3) / sa1)[:, None]
    py = ca1 * g2 - sa1 * f3
    square = (x * x + y * y)[:, None]
    argument = square - py * py
    there = argument >= -CLEARLY * (square + py * py)
    root = np.sqrt(np.maximum(argument, 0.0))
    px = np.concatenate((root, -root, root, -root), axis=1)
    g1 = px - a1
    length, k = 2.0 * a2 * rho, g1 * g1 + g2 * g2 - a2 * a2 - rho * rho
    across = (length - k) * (length + k)
    there = there & (across >= -CLEARLY * length * length)
    half = np.arctan2(np.sqrt(np.maximum(across, 0.0)), k)
    q3 = half * np.array((1.0, 1.0, -1.0, -1.0))
    f1, f2 = a2 + rho * np.cos(q3), ca2 * rho * np.sin(q3)
    q1 = np.arctan2(y[:, None] * px - x[:, None] * py, x[:, None] * px + y[:, None] * py)
    return q1, np.arctan2(f1 * g2 - f2 * g1, f1 * g1 + f2 * g2), q3, there


def _wrists(twists: tuple[float, float, float, float], N: Sequence[Array]) -> tuple[Array, Array, Array]:
    """θ_4, θ_5, θ_6, (m, 4, 2) each, with N = Rot_z(θ_4) Rot_x(α_4) Rot_z(θ_5) Rot_x(α_5) Rot_z(θ_6)."""
    ca4, sa4, ca5, sa5 = twists
    if ca4 == 0.0 == ca5:
        return _right_wrists(sa4 * sa5, sa4, sa5, N)
    n1, _, x, n2, _, y, n3, _, z = (entry[..., None] for entry in N)
    c5 = np.clip((ca4 * ca5 - z) / (sa4 * sa5), -1.0, 1.0)
    s5 = np.sqrt((1.0 - c5) * (1.0 + c5)) * np.array((1.0, -1.0))
    vx, vy = s5 * sa5, -ca4 * c5 * sa5 - sa4 * ca5
    q4 = np.arctan2(y * vx - x * vy, x * vx + y * vy)
    c4, s4 = np.cos(q4), np.sin(q4)
    m1, across = c4 * n1 + s4 * n2, c4 * n2 - s4 * n1
    m2, m3 = ca4 * across + sa4 * n3, ca4 * n3 - sa4 * across
    q6 = np.arctan2(ca5 * (c5 * m2 - s5 * m1) + sa5 * m3, c5 * m1 + s5 * m2)
    return q4, np.arctan2(s5, np.broadcast_to(c5, s5.shape)), q6


def _right_wrists(both: float, sa4: float, sa5: float, N: Sequence[Array]) -> tuple[Array, Array, Array]:
    """The same for axes at right angles: θ_4, θ_5, θ_6 or θ_4 + π, -θ_5, θ_6 + π."""
    n1, _, x, n2, _, y, n3, _, z = N
    s5, c5 = np.hypot(x, y), -both * z
    q4 = np.arctan2(sa5 * y, sa5 * x)
    divisor = sa5 * np.maximum(s5, SHORTEST)
    c4, s4 = x / divisor, y / divisor
    in_line = s5 < SHORTEST
    if in_line.any():
        c4, s4 = np.where(in_line, np.cos(q4), c4), np.where(in_line, np.sin(q4), s4)
    q5 = np.arctan2(s5, c5)
    q6 = np.arctan2(-both * (c4 * n2 - s4 * n1), c5 * (c4 * n1 + s4 * n2) + s5 * (sa4 * n3))
    return (
        np.stack((q4, q4 + np.pi), axis=-1),
        np.stack((q5, -q5), axis=-1),
        np.stack((q6, q6 + np.pi), axis=-1),
    )
