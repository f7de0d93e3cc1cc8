"""The closed form of a level arm with a wrist at right angles, for many targets away from singularities.

What `wrist_scalars` does for one target is done here for a block of them, with one array for each quantity:
heads (the sign of p_x, then that of θ_3) along the first axis, targets along the second. Each head and its
wrist are judged by the recorded forward kinematics at the cosines and sines of the angles that are returned;
the wrist's other way, θ_4 + π, -θ_5, θ_6 + π, makes the same rotation.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Array
from kinematics.inverse.components import lost_value, merging_value
from kinematics.inverse.goals import LEAST_TOLERANCE
from kinematics.inverse.wrist_scalars import APART, EXACT, FLIPPED, FOLD, ClearWrist
from kinematics.inverse.wrist_tapes import centre_error_tape, left_over_tape, run_on_arrays, wrist_error_tape

SOLUTIONS = 8
"""Of a target that is clear here: fewer heads than four are left to others."""

_SIGNS = np.array(((1.0,), (1.0,), (-1.0,), (-1.0,)))
_BENDS = np.array(((1.0,), (-1.0,), (1.0,), (-1.0,)))


class ClearSolutions(NamedTuple):
    """All solutions of targets, as far as they are clear.

    Attributes:
        joints: (m, 8, 6), turns in (-π, π].
        position_error: (m, 8) distance from the target [m], at most.
        orientation_error: (m, 8) angle from the target [rad].
        clear: (m,) of which targets these are all solutions, verified; what stands at others means nothing.
    """

    joints: Array
    position_error: Array
    orientation_error: Array
    clear: NDArray[np.bool_]


def clear_solutions(clear: ClearWrist, targets: Array) -> ClearSolutions:
    """All solutions of those targets that have eight and are away from singularities.

    Args:
        clear: the arm.
        targets: (m, 4, 4) rigid motions.
    """
    with np.errstate(all="ignore"):
        return _solutions(clear, targets)


def _solutions(clear: ClearWrist, targets: Array) -> ClearSolutions:
    w, m = clear.wrist, len(targets)
    a1, ca1, sa1, d2, a2, ca2, _, rho, zeta = w.head
    n = clear.seen @ targets.reshape(m, 16).T
    x, y, z = n[9:] / w.size
    lost = clear.least_volume * lost_value(LEAST_TOLERANCE)
    least = clear.least_volume * merging_value(LEAST_TOLERANCE)
    f3 = d2 + ca2 * zeta
    g2 = (z - ca1 * f3) / sa1
    py = ca1 * g2 - sa1 * f3
    argument = x * x + y * y - py * py
    root, length = np.sqrt(argument), 2.0 * a2 * rho
    px = _SIGNS[::2] * root
    g1 = px - a1
    k = g1 * g1 + (g2 * g2 - a2 * a2 - rho * rho)
    bent = np.sqrt((length - k) * (length + k))
    t1 = np.arctan2(y * px - x * py, x * px + y * py)
    half = np.arccos(k / length)
    t3 = _BENDS * _twice(half)
    (c1, s1), (c3, s3) = (tuple(map(_twice, _cos_sin(t1))), _cos_sin(t3))
    g1, bent = _twice(g1), _twice(bent)
    f1, f2 = a2 + rho * c3, (ca2 * rho) * s3
    t2 = np.arctan2(f1 * g2 - f2 * g1, f1 * g1 + f2 * g2)
    c2, s2 = _cos_sin(t2)
    heads = [c1, s1, c2, s2, c3, s3]
    N = run_on_arrays(left_over_tape(w), [*heads, *n[:9]])
    away = w.size * np.sqrt(run_on_arrays(centre_error_tape(w.head), [*heads, x, y, z])[0])
    t4, t5, t6, sine = _right_wrists(w.wrist[1], w.wrist[3], N)
    turned = [part for angle in (t4, t5, t6) for part in _cos_sin(angle)]
    angle = np.sqrt(0.5 * run_on_arrays(wrist_error_tape(w.wrist), [*turned, *N])[0])
    volume = (0.5 * abs(sa1)) * (root * bent)
    alone = (root > APART * np.hypot(root, py)) & (bent > APART * abs(length)) & (sine > APART)
    # Comparisons with NaN are false: a target without four heads is not clear.
    good = (volume * sine > np.where(alone, lost, least)) & (volume > lost)
    good &= (angle <= EXACT) & (away <= EXACT * w.size)
    joints = np.empty((6, 4, 2, m))
    for i, (values, zero) in enumerate(zip((_twice(t1), t2, t3), w.zeros, strict=False)):
        np.subtract(values[:, None], zero, out=joints[i])
    for i, (values, shift) in enumerate(((t4, np.pi), (t5, 0.0), (t6, np.pi)), 3):
        np.subtract(values, w.zeros[i], out=joints[i, :, 0])
        np.subtract(-values if i == 4 else values + shift, w.zeros[i], out=joints[i, :, 1])
    joints -= (2.0 * np.pi) * np.ceil((joints - np.pi) / (2.0 * np.pi))
    errors = np.empty((2, 4, 2, m))
    errors[1, :, 0], errors[1, :, 1] = angle, angle + FLIPPED
    np.add(away[:, None], clear.lever * errors[1], out=errors[0])
    return ClearSolutions(
        np.ascontiguousarray(joints.reshape(6, SOLUTIONS, m).T),
        np.ascontiguousarray(errors[0].reshape(SOLUTIONS, m).T),
        np.ascontiguousarray(errors[1].reshape(SOLUTIONS, m).T),
        good.all(axis=0) & (argument > FOLD * LEAST_TOLERANCE * clear.spread),
    )


def _twice(values: Array) -> Array:
    """(2, m) as (4, m), each row for two heads."""
    return np.repeat(values, 2, axis=0)


def _cos_sin(angle: Array) -> tuple[Array, Array]:
    """Cosines and sines by one tangent: numpy computes it with vector instructions, and those without."""
    t = np.tan(0.5 * angle)
    scale = 2.0 / (1.0 + t * t)
    return scale - 1.0, t * scale


def _right_wrists(sa4: float, sa5: float, N: Sequence[Array]) -> tuple[Array, Array, Array, Array]:
    """θ_4, θ_5, θ_6 with sin θ_5 > 0, and this sine; sa4 and sa5 are ±1."""
    n11, _, x, n21, _, y, n31, _, z = N
    s5 = np.hypot(x, y)
    c5 = -(sa4 * sa5) * z
    c4, s4 = x * (sa5 / s5), y * (sa5 / s5)
    t6 = np.arctan2(-(sa4 * sa5) * (c4 * n21 - s4 * n11), c5 * (c4 * n11 + s4 * n21) + s5 * (sa4 * n31))
    return np.arctan2(s4, c4), np.arctan2(s5, c5), t6, s5
