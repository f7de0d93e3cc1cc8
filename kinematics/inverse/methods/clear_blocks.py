"""The closed form of a level arm with a wrist at right angles, for many targets away from singularities.

What `wrist_scalars` does for one target, with the same formulas and the same conditions, is done here for a
block of them, with one array for each quantity: heads (the sign of p_x, then that of θ_3) along the first
axes, targets along the last. Each head and its wrist are judged by forward kinematics at the cosines and
sines of the angles that are returned; the other way of the wrist, θ_4 + π, -θ_5, θ_6 + π, makes the same
rotation.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Array
from kinematics.inverse.methods.wrist_scalars import EXACT, FLIPPED, MARGIN, STILL, UNSEEN, ClearWrist
from kinematics.inverse.methods.wrist_tapes import run_on_arrays

SOLUTIONS = 8  # Of a target that is clear here: fewer heads than four are left to others.

_BOTH = np.array(((1.0,), (-1.0,)))


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


def clear_solutions(clear: ClearWrist, targets: Array, tolerances: Array) -> ClearSolutions:
    """Return all solutions of those targets that have eight and are away from singularities.

    Args:
        clear: the arm.
        targets: (m, 4, 4) rigid motions.
        tolerances: (m,) distance [m] and angle [rad] within which each is reached.
    """
    with np.errstate(all="ignore"):
        return _solutions(clear, targets, tolerances)


def _solutions(w: ClearWrist, targets: Array, tolerances: Array) -> ClearSolutions:
    seen = run_on_arrays(w.seen_tape, [*np.ascontiguousarray(targets.reshape(-1, 16)[:, :12].T)])
    planes = _planes(w, tolerances, *seen[6:])
    c3, s3 = _cos_sin(planes.half)
    f1, f2 = w.a2 + w.rho * c3, _both(w.rho * s3)
    g1, g2 = planes.g1, planes.g2
    t2 = np.arctan2(f1[:, None] * g2 - f2 * g1[:, None], (f1 * g1)[:, None] + f2 * g2)
    c2, s2 = _cos_sin(t2)
    turned = run_on_arrays(w.plane_tape, [*_cos_sin(planes.t1), *seen])
    turned = [each[:, None] if each.ndim > 1 else each for each in turned]
    x, y, off_plane = turned[6:]
    off_x, off_y = x * c2 + y * s2 - f1[:, None], y * c2 - x * s2 - f2
    away = w.size * np.sqrt(off_x * off_x + off_y * off_y + off_plane * off_plane)
    # The forearm's turn in the plane of the links, and what it leaves for the wrist.
    cl, sl = np.cos(w.lean), np.sin(w.lean)
    cf, sf = (c3 * cl)[:, None] - _both(s3 * sl), _both(s3 * cl) + (c3 * sl)[:, None]
    c, s = c2 * cf - s2 * sf, s2 * cf + c2 * sf
    x1, y1, z1, x3, y3, z3 = turned[:6]
    t4, t5, t6, sine, angle = _wrists(
        x1 * c + y1 * s, y1 * c - x1 * s, z1, x3 * c + y3 * s, y3 * c - x3 * s, z3
    )
    good = (sine >= planes.least[:, None]) & (angle <= EXACT) & (away <= EXACT * w.size)
    position, orientation = np.empty((2, len(targets), SOLUTIONS))
    away_by, off_by = (errors.T.reshape(2, 2, 2, -1) for errors in (position, orientation))
    for way, off in enumerate((angle, angle + FLIPPED)):
        off_by[:, :, way] = off
        np.add(away, w.lever * off, out=away_by[:, :, way])
    joints = _joints(w, planes.t1, t2, _both(w.sense3 * planes.half), t4, w.sense5 * t5, t6)
    return ClearSolutions(joints, position, orientation, good.all(axis=(0, 1)) & planes.clear)


class _Planes(NamedTuple):
    """The links' planes, one for each sign of p_x.

    Attributes:
        t1: (2, m) θ_1.
        g1: (2, m) place of the wrist's centre in the plane: x, and
        g2: (m,) y.
        half: (2, m) |θ_3|.
        least: (2, m) sin θ_5 at least.
        clear: (m,) whether both are there and clear.
    """

    t1: Array
    g1: Array
    g2: Array
    half: Array
    least: Array
    clear: NDArray[np.bool_]


def _planes(w: ClearWrist, tolerances: Array, x: Array, y: Array, z: Array) -> _Planes:
    delta = w.spread * tolerances
    g2 = (z - w.ca1 * w.aside) / w.sa1
    py = w.ca1 * g2 - w.sa1 * w.aside
    far = np.sqrt(x * x + y * y)
    argument = (far - py) * (far + py)
    squared = (2.0 * delta) * (far + abs(w.ca1 / w.sa1) * np.abs(py))
    root, length = np.sqrt(argument), 2.0 * w.a2 * w.rho
    px = _BOTH * root
    g1 = px - w.a1
    k = g1 * g1 + (g2 * g2 - (w.a2 * w.a2 + w.rho * w.rho))
    across = (length - k) * (length + k)
    edge = (MARGIN * 2.0 * length) * (np.abs(g1) * (squared / root) + np.abs(g2) * (2.0 * delta / abs(w.sa1)))
    turn = delta / (abs(w.sa1) * root)
    wobble = turn + (2.0 * (w.a2 + w.rho)) * (delta + turn * far) / np.sqrt(across)
    # Comparisons with NaN are false: a target without four heads is not clear.
    clear = ((across > edge) & (wobble <= STILL)).all(axis=0) & (argument > MARGIN * squared)
    t1 = np.arctan2(y * px - x * py, x * px + y * py)
    return _Planes(t1, g1, g2, np.arccos(k / length), (wobble + tolerances) / STILL, clear)


def _wrists(
    x1: Array, y1: Array, z1: Array, x3: Array, y3: Array, z3: Array
) -> tuple[Array, Array, Array, Array, Array]:
    """θ_4, θ_5, θ_6 with sin θ_5 > 0, this sine, and the angle by which they are off.

    What the wrist has to make is given by its first and third column, x along axis 4 and y in the plane.
    """
    sine = np.sqrt(y3 * y3 + z3 * z3)
    t4, t5 = np.arctan2(z3, y3), np.arctan2(sine, -x3)
    (c4, s4), (c5, s5) = _cos_sin(t4), _cos_sin(t5)
    u, v = y1 * c4 + z1 * s4, z1 * c4 - y1 * s4
    t6 = np.arctan2(-v, c5 * u + s5 * x1)
    c6, s6 = _cos_sin(t6)
    square_off = np.zeros_like(t6)
    for off in (y3 * c4 + z3 * s4 - s5, z3 * c4 - y3 * s4, x3 + c5, u - c5 * c6, v + s6, x1 - s5 * c6):
        off *= off
        square_off += off
    return t4, t5, t6, sine, np.sqrt(square_off)


def _joints(w: ClearWrist, t1: Array, t2: Array, t3: Array, t4: Array, t5: Array, t6: Array) -> Array:
    """(m, 8, 6) joint values, both ways of the wrist one after the other."""
    found = np.empty((t1.shape[1], SOLUTIONS, 6))
    joints = found.T.reshape(6, 2, 2, 2, -1)
    o1, o2, o3, o4, o5, o6 = w.zeros
    joints[0] = _in_range(t1 - o1)[:, None, None]
    joints[1] = _in_range(t2 - o2)[:, :, None]
    joints[2] = _in_range(t3 - o3)[:, :, None]
    for i, t, zero in ((3, t4, o4), (5, t6, o6)):
        joints[i, :, :, 0] = q = _in_range(t - zero)
        np.add(q, np.copysign(np.pi, UNSEEN - q), out=joints[i, :, :, 1])
    joints[4, :, :, 0], joints[4, :, :, 1] = _in_range(t5 - o5), _in_range(-t5 - o5)
    return found


def _both(values: Array) -> Array:
    """(2, 2, m) from (2, m): each, and its negative."""
    return np.stack((values, -values), axis=1)


def _in_range(angles: Array) -> Array:
    """Angles in (-3π, 3π] as they are in (-π, π]."""
    low, high = angles <= -np.pi, angles > np.pi
    if low.any():
        angles += (2.0 * np.pi) * low
    if high.any():
        angles -= (2.0 * np.pi) * high
    return angles


def _cos_sin(angle: Array) -> tuple[Array, Array]:
    """Cosines and sines by one tangent: numpy computes it with vector instructions, and those without."""
    t = np.tan(0.5 * angle)
    scale = 2.0 / (1.0 + t * t)
    return scale - 1.0, t * scale
