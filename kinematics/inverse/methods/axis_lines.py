"""Axes as directions and points: where they meet, their common normals, and turns about them."""

import math

import numpy as np

from kinematics.inverse.arm import Array
from kinematics.se3 import cross_arrays

SAME_POINT = 1e-9
"""Axes whose distances from their common point are below this part of the arm's size pass through it."""

ALMOST = 1e-7
"""Offsets (in parts of the size) and sines of twists below this are zero in the elimination: dividing by less
would cost more digits than Newton steps need to bring back what was neglected."""

RIGHT = 1e-15  # What rounding leaves of the cosine or the sine of a multiple of 90° between unit vectors.


def angle_about(z: Array, u: Array, v: Array) -> float:
    """Return the angle about an axis from u to v."""
    u, v = u - (u @ z) * z, v - (v @ z) * z
    return math.atan2(float(z @ cross_arrays(u, v)), float(u @ v))


def common_point(z: Array, p: Array) -> Array | None:
    """Return the point through which all axes pass (lengths in units of the arm's size), or None."""
    if all(float(np.linalg.norm(cross_arrays(z[i], z[i + 1]))) <= ALMOST for i in range(len(z) - 1)):
        return None
    across = np.eye(3) - z[:, :, None] * z[:, None, :]
    centre = np.linalg.lstsq(across.reshape(-1, 3), np.einsum("kij,kj->ki", across, p).ravel(), rcond=None)[0]
    off = np.linalg.norm(np.einsum("kij,kj->ki", across, centre - p), axis=1)
    return np.asarray(centre) if float(off.max()) <= SAME_POINT else None


def common_normal(
    z1: Array, p1: Array, z2: Array, p2: Array, near: Array | None = None
) -> tuple[Array, Array, Array]:
    """Return the feet of the common normal and its direction; of parallel axes the one near a point."""
    normal = cross_arrays(z1, z2)
    sine = float(np.linalg.norm(normal))
    if sine <= ALMOST:
        start = p1 if near is None else near
        foot1 = p1 + ((start - p1) @ z1) * z1
        foot2 = p2 + ((foot1 - p2) @ z2) * z2
        way = foot2 - foot1
        length = float(np.linalg.norm(way))
        return foot1, foot2, way / length if length > ALMOST else np.linalg.svd(z1[None])[2][1]
    x = normal / sine
    d = p2 - p1
    foot1 = p1 + (float(cross_arrays(d, z2) @ normal) / sine**2) * z1
    foot2 = p2 + (float(cross_arrays(d, z1) @ normal) / sine**2) * z2
    return foot1, foot2, x


def twist_between(z1: Array, z2: Array, x: Array) -> tuple[float, float]:
    """Return cosine and sine of the twist between axes about x, right angles without rounding."""
    cosine, sine = float(z1 @ z2), float(cross_arrays(z1, z2) @ x)
    if abs(cosine) < RIGHT:
        return 0.0, math.copysign(1.0, sine)
    if abs(sine) < RIGHT:
        return math.copysign(1.0, cosine), 0.0
    return cosine, sine


def rotation_of(x: Array, z: Array) -> Array:
    """Return the rotation whose x and z are these."""
    return np.column_stack((x, cross_arrays(z, x), z))
