"""Rigid motions and vectors in plain floats.

One decision moves a handful of lines a handful of times; at that size tuples are several times faster than
arrays. A motion is the tuple (r00, r01, r02, r10, …, r22, x, y, z) of its rotation matrix by rows and its
translation.
"""

from __future__ import annotations

import math
from typing import TypeAlias

import numpy as np

from kinematics.links import Transform

Vector: TypeAlias = tuple[float, float, float]
Motion: TypeAlias = tuple[
    float, float, float, float, float, float, float, float, float, float, float, float
]  # fmt: skip

IDENTITY: Motion = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)
ORIGIN: Vector = (0.0, 0.0, 0.0)
Z_AXIS: Vector = (0.0, 0.0, 1.0)


def dot(a: Vector, b: Vector) -> float:
    """Inner product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    """Vector product."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def subtract(a: Vector, b: Vector) -> Vector:
    """A - b."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def plus(a: Vector, b: Vector) -> Vector:
    """A + b."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def scale(a: Vector, factor: float) -> Vector:
    """Factor · a."""
    return (a[0] * factor, a[1] * factor, a[2] * factor)


def norm(a: Vector) -> float:
    """Euclidean length."""
    return math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2])


def normalised(a: Vector) -> Vector:
    """The unit vector along a non-zero vector."""
    return scale(a, 1.0 / norm(a))


def across(a: Vector, direction: Vector) -> Vector:
    """The part of a that is perpendicular to a unit direction."""
    along = dot(a, direction)
    return (a[0] - along * direction[0], a[1] - along * direction[1], a[2] - along * direction[2])


def perpendicular_to(direction: Vector) -> Vector:
    """Some unit vector perpendicular to a unit direction."""
    x, y, z = (abs(component) for component in direction)
    other = (1.0, 0.0, 0.0) if x <= y and x <= z else (0.0, 1.0, 0.0) if y <= z else Z_AXIS
    return normalised(cross(direction, other))


def angle_between(a: Vector, b: Vector) -> float:
    """Angle between two unit vectors [rad], in [0, π]; accurate near 0 and near π."""
    return math.atan2(norm(cross(a, b)), dot(a, b))


def rotate(g: Motion, v: Vector) -> Vector:
    """The direction v, turned by g."""
    x, y, z = v
    return (g[0] * x + g[1] * y + g[2] * z, g[3] * x + g[4] * y + g[5] * z, g[6] * x + g[7] * y + g[8] * z)


def move(g: Motion, p: Vector) -> Vector:
    """The point p, moved by g."""
    x, y, z = p
    return (
        g[0] * x + g[1] * y + g[2] * z + g[9],
        g[3] * x + g[4] * y + g[5] * z + g[10],
        g[6] * x + g[7] * y + g[8] * z + g[11],
    )


def compose(g: Motion, h: Motion) -> Motion:
    """G · h: first h, then g."""
    a, b, c, d, e, f, k, l, m, x, y, z = g  # noqa: E741
    p, q, r, s, t, u, v, w, o, i, j, n = h
    return (
        a * p + b * s + c * v,
        a * q + b * t + c * w,
        a * r + b * u + c * o,
        d * p + e * s + f * v,
        d * q + e * t + f * w,
        d * r + e * u + f * o,
        k * p + l * s + m * v,
        k * q + l * t + m * w,
        k * r + l * u + m * o,
        a * i + b * j + c * n + x,
        d * i + e * j + f * n + y,
        k * i + l * j + m * n + z,
    )


def inverse(g: Motion) -> Motion:
    """The motion that undoes g."""
    a, b, c, d, e, f, k, l, m, x, y, z = g  # noqa: E741
    return (
        a, d, k, b, e, l, c, f, m,
        -(a * x + d * y + k * z),
        -(b * x + e * y + l * z),
        -(c * x + f * y + m * z),
    )  # fmt: skip


def translation(v: Vector) -> Motion:
    """Translation by v."""
    return (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, v[0], v[1], v[2])


def rotation_about(point: Vector, axis: Vector, cosine: float, sine: float) -> Motion:
    """Rotation about the line through a point along a unit axis, by an angle of this cosine and sine."""
    x, y, z = axis
    t = 1.0 - cosine
    tx, ty = t * x, t * y
    xy, xz, yz = tx * y, tx * z, ty * z
    sx, sy, sz = sine * x, sine * y, sine * z
    r00, r01, r02 = cosine + tx * x, xy - sz, xz + sy
    r10, r11, r12 = xy + sz, cosine + ty * y, yz - sx
    r20, r21, r22 = xz - sy, yz + sx, cosine + t * z * z
    px, py, pz = point
    return (
        r00, r01, r02, r10, r11, r12, r20, r21, r22,
        px - (r00 * px + r01 * py + r02 * pz),
        py - (r10 * px + r11 * py + r12 * pz),
        pz - (r20 * px + r21 * py + r22 * pz),
    )  # fmt: skip


def turn_onto(point: Vector, source: Vector, target: Vector) -> Motion:
    """The smallest rotation about a point that takes one unit direction to another."""
    axis = cross(source, target)
    sine, cosine = norm(axis), dot(source, target)
    if sine > 1e-12:
        return rotation_about(point, scale(axis, 1.0 / sine), cosine, sine)
    if cosine > 0.0:
        return IDENTITY
    return rotation_about(point, perpendicular_to(source), -1.0, 0.0)


def angle_about(g: Motion, axis: Vector) -> float:
    """The angle of the rotation about a unit axis that is nearest to that of g [rad], in (-π, π]."""
    x, y, z = axis
    sine = x * (g[7] - g[5]) + y * (g[2] - g[6]) + z * (g[3] - g[1])
    trace = g[0] + g[4] + g[8]
    along = dot(axis, rotate(g, axis))
    return math.atan2(sine, trace - along)


def rotation_angle(g: Motion) -> float:
    """The angle of the rotation of g [rad], in [0, π]."""
    sine = math.sqrt((g[7] - g[5]) ** 2 + (g[2] - g[6]) ** 2 + (g[3] - g[1]) ** 2)
    return math.atan2(sine, g[0] + g[4] + g[8] - 1.0)


def position(g: Motion) -> Vector:
    """The translation of g."""
    return (g[9], g[10], g[11])


def x_axis(g: Motion) -> Vector:
    """The first column of the rotation of g."""
    return (g[0], g[3], g[6])


def z_axis(g: Motion) -> Vector:
    """The third column of the rotation of g."""
    return (g[2], g[5], g[8])


def from_matrix(matrix: Transform) -> Motion:
    """The motion of a 4x4 homogeneous transform."""
    (a, b, c, x), (d, e, f, y), (k, l, m, z), _ = matrix.tolist()  # noqa: E741
    return (a, b, c, d, e, f, k, l, m, x, y, z)


def to_matrix(g: Motion) -> Transform:
    """The 4x4 homogeneous transform of a motion."""
    a, b, c, d, e, f, k, l, m, x, y, z = g  # noqa: E741
    return np.array([[a, b, c, x], [d, e, f, y], [k, l, m, z], [0.0, 0.0, 0.0, 1.0]])
