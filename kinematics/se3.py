"""Rigid motions in space, and the 3-vectors that they move.

A motion is written in two ways. A `Transform` is the (4, 4) array that callers pass and receive. A
`Motion` is the tuple (r00, r01, r02, r10, …, r22, x, y, z) of its rotation matrix by rows and its
translation: a decision about a chain moves a few lines a few times, and for so few tuples
of floats are several times faster than arrays. Both map coordinates in frame b to coordinates in frame a if
they are the pose of b in a.

Vectors and motions share one file, a little longer than others, so that neither is written twice.
Notations of a pose (roll, pitch, yaw; quaternions; X Y Z A B C) are in `kinematics.poses`, twists and their
exponentials in `kinematics.screws`.
"""

import math
from collections.abc import Iterable
from typing import Any, TypeAlias, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinematics.errors import Fault, PoseError

Floats: TypeAlias = NDArray[np.float64]
Transform: TypeAlias = NDArray[np.float64]  # (4, 4) homogeneous transform, or (…, 4, 4) of them.

Scalar: TypeAlias = Any
"""A number of any kind that knows + - *: a float, an integer, or a symbol of a recorded computation."""
Scalars: TypeAlias = tuple[Scalar, Scalar, Scalar]
_Real = TypeVar("_Real", int, float)
_Entry = TypeVar("_Entry")
Vector: TypeAlias = tuple[float, float, float]
Motion: TypeAlias = tuple[
    float, float, float, float, float, float, float, float, float, float, float, float
]  # fmt: skip
Place: TypeAlias = tuple[str | int, ...]

IDENTITY: Motion = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0)
ORIGIN: Vector = (0.0, 0.0, 0.0)
X_AXIS: Vector = (1.0, 0.0, 0.0)
Y_AXIS: Vector = (0.0, 1.0, 0.0)
Z_AXIS: Vector = (0.0, 0.0, 1.0)

ORTHONORMAL_TOLERANCE = 2e-6
"""A rotation matrix printed with six decimals passes: its entries are off by at most 5e-7, and a product of
two columns by three times that."""

_NO_DIRECTION = 1e-12
"""The sine below which two unit vectors name no common perpendicular: some 4000 roundings of 2e-16."""


def triple(values: Iterable[_Entry]) -> tuple[_Entry, _Entry, _Entry]:
    """Return three values of any kind as a vector.

    Raises:
        ValueError: there are more or fewer.
    """
    x, y, z = values
    return x, y, z


def dot(u: tuple[_Real, _Real, _Real], v: tuple[_Real, _Real, _Real]) -> _Real:
    """Return the scalar product u · v."""
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def opposite(v: tuple[_Real, _Real, _Real]) -> tuple[_Real, _Real, _Real]:
    """Return -v."""
    return -v[0], -v[1], -v[2]


def cross(u: tuple[_Real, _Real, _Real], v: tuple[_Real, _Real, _Real]) -> tuple[_Real, _Real, _Real]:
    """Return the vector product u × v."""
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def cross_arrays(u: Floats, v: Floats) -> Floats:
    """Return the vector products along the last axis of (…, 3) arrays.

    On small arrays several times faster than numpy.cross.
    """
    left: Scalars = (u[..., 0], u[..., 1], u[..., 2])
    right: Scalars = (v[..., 0], v[..., 1], v[..., 2])
    x, y, z = cross(left, right)
    w = np.empty((*x.shape, 3))
    w[..., 0], w[..., 1], w[..., 2] = x, y, z
    return w


def skew(v: Floats) -> Floats:
    """Return [v]×, (3, 3): its product with a vector u is v × u."""
    x, y, z = v.tolist()
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def plus(u: Vector, v: Vector) -> Vector:
    """Return u + v."""
    return u[0] + v[0], u[1] + v[1], u[2] + v[2]


def subtract(u: Vector, v: Vector) -> Vector:
    """Return u - v."""
    return u[0] - v[0], u[1] - v[1], u[2] - v[2]


def scale(v: Vector, factor: float) -> Vector:
    """Return factor · v, without negative zeros."""
    return v[0] * factor + 0.0, v[1] * factor + 0.0, v[2] * factor + 0.0


def along(point: Vector, length: float, direction: Vector) -> Vector:
    """Return point + length · direction."""
    return (
        point[0] + length * direction[0],
        point[1] + length * direction[1],
        point[2] + length * direction[2],
    )


def norm(v: Vector) -> float:
    """Return the length |v|."""
    return math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])


def unit(v: Vector) -> Vector:
    """Return v / |v| of a non-zero vector, safe against overflow and underflow of the squares."""
    largest = max(abs(v[0]), abs(v[1]), abs(v[2]))
    v = (v[0] / largest, v[1] / largest, v[2] / largest)
    length = norm(v)
    return v[0] / length, v[1] / length, v[2] / length


def rejection(v: Vector, direction: Vector) -> Vector:
    """Return the part of v that is perpendicular to a unit direction."""
    return along(v, -dot(v, direction), direction)


def foot(point: Vector, on: Vector, direction: Vector) -> Vector:
    """Return the point nearest to `point` on the line through `on` along a unit direction."""
    return along(on, dot(subtract(point, on), direction), direction)


def perpendicular(direction: Vector) -> Vector:
    """Return a unit vector perpendicular to a unit direction: from the coordinate axis nearest to its plane.

    Ties, to nine decimals, go to x before y before z.
    """
    sizes = [abs(component) for component in direction]
    least = min(range(3), key=lambda i: (round(sizes[i], 9), i))
    return unit(rejection((X_AXIS, Y_AXIS, Z_AXIS)[least], direction))


def angle_between(u: Vector, v: Vector) -> float:
    """Return the angle between two unit vectors [rad], in [0, π]; accurate near 0 and near π."""
    return math.atan2(norm(cross(u, v)), dot(u, v))


def angle_from_to(u: Vector, v: Vector, about: Vector) -> float:
    """Return the angle from u to v about a unit direction perpendicular to both [rad], in (-π, π]."""
    angle = math.atan2(dot(about, cross(u, v)), dot(u, v))
    return math.pi if angle == -math.pi else angle


def rotate(g: Motion, v: Vector) -> Vector:
    """Return the direction v turned by g."""
    x, y, z = v
    return (g[0] * x + g[1] * y + g[2] * z, g[3] * x + g[4] * y + g[5] * z, g[6] * x + g[7] * y + g[8] * z)


def move(g: Motion, p: Vector) -> Vector:
    """Return the point p moved by g."""
    x, y, z = p
    return (
        g[0] * x + g[1] * y + g[2] * z + g[9],
        g[3] * x + g[4] * y + g[5] * z + g[10],
        g[6] * x + g[7] * y + g[8] * z + g[11],
    )


def compose(g: Motion, h: Motion) -> Motion:
    """Return the product g · h: first h, then g."""
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
    """Return the motion that undoes g."""
    a, b, c, d, e, f, k, l, m, x, y, z = g  # noqa: E741
    return (
        a, d, k, b, e, l, c, f, m,
        -(a * x + d * y + k * z),
        -(b * x + e * y + l * z),
        -(c * x + f * y + m * z),
    )  # fmt: skip


def translation(v: Vector) -> Motion:
    """Return the translation by v."""
    return (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, v[0], v[1], v[2])


def rotation_about(point: Vector, axis: Vector, cosine: float, sine: float) -> Motion:
    """Return the rotation about the line through a point along a unit axis, from its angle's cosine and sine.

    Source: O. Rodrigues (1840); R. M. Murray, Z. Li, S. S. Sastry (1994), eq. 2.14.
    """
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
    """Return the smallest rotation about a point that takes one unit direction to another."""
    axis = cross(source, target)
    sine, cosine = norm(axis), dot(source, target)
    if sine > _NO_DIRECTION:
        return rotation_about(point, scale(axis, 1.0 / sine), cosine, sine)
    if cosine > 0.0:
        return IDENTITY
    return rotation_about(point, perpendicular(source), -1.0, 0.0)


def angle_about(g: Motion, axis: Vector) -> float:
    """Return the angle of the rotation about a unit axis that is nearest to that of g [rad], in (-π, π]."""
    x, y, z = axis
    sine = x * (g[7] - g[5]) + y * (g[2] - g[6]) + z * (g[3] - g[1])
    trace = g[0] + g[4] + g[8]
    along = dot(axis, rotate(g, axis))
    return math.atan2(sine, trace - along)


def rotation_angle(g: Motion) -> float:
    """Return the angle of the rotation of g [rad], in [0, π]."""
    sine = math.sqrt((g[7] - g[5]) ** 2 + (g[2] - g[6]) ** 2 + (g[3] - g[1]) ** 2)
    return math.atan2(sine, g[0] + g[4] + g[8] - 1.0)


def position(g: Motion) -> Vector:
    """Return the translation of g."""
    return (g[9], g[10], g[11])


def x_axis(g: Motion) -> Vector:
    """Return the first column of the rotation of g."""
    return (g[0], g[3], g[6])


def z_axis(g: Motion) -> Vector:
    """Return the third column of the rotation of g."""
    return (g[2], g[5], g[8])


def from_matrix(matrix: Transform) -> Motion:
    """Return the motion of a (4, 4) homogeneous transform."""
    (a, b, c, x), (d, e, f, y), (k, l, m, z), _ = matrix.tolist()  # noqa: E741
    return (a, b, c, d, e, f, k, l, m, x, y, z)


def to_matrix(g: Motion) -> Transform:
    """Return the (4, 4) homogeneous transform of a motion."""
    a, b, c, d, e, f, k, l, m, x, y, z = g  # noqa: E741
    return np.array([[a, b, c, x], [d, e, f, y], [k, l, m, z], [0.0, 0.0, 0.0, 1.0]])


def inverse_transform(transform: Transform) -> Transform:
    """Return the inverse (Rᵀ, −Rᵀ p) of a (4, 4) rigid transform, or of (…, 4, 4) of them.

    Source: seed 001 eq. 2.7.
    """
    inverse = np.zeros_like(transform, dtype=np.float64)
    rotation = np.swapaxes(transform[..., :3, :3], -1, -2)
    inverse[..., :3, :3] = rotation
    inverse[..., :3, 3] = -(rotation @ transform[..., :3, 3:])[..., 0]
    inverse[..., 3, 3] = 1.0
    return inverse


def turns_between(left: Transform, right: Transform) -> Floats:
    """Return the rotation vectors from one orientation to the other, to first order, (…, 3) [rad]."""
    columns, meant = (np.swapaxes(poses[..., :3, :3], -1, -2) for poses in (left, right))
    return np.asarray(0.5 * cross_arrays(columns, meant).sum(axis=-2), dtype=np.float64)


def check_transform(
    value: ArrayLike, *, where: Place = (), tolerance: float = ORTHONORMAL_TOLERANCE
) -> Transform:
    """Return a copy of the value as a (4, 4) array, after checking that it is a rigid transform.

    Args:
        where: place of the value, for the faults.
        tolerance: how far an entry of RᵀR may be from the identity's.

    Raises:
        PoseError: not 4×4 numbers, not finite, a bottom row other than (0, 0, 0, 1), a rotation part that is
            not orthonormal, or a left-handed one.
    """
    matrix = _matrix_4x4(value, where)
    r0, r1, r2, bottom = matrix.tolist()
    faults = [
        Fault.at("pose_not_finite", *where, i, j)
        for i, row in enumerate((r0, r1, r2, bottom))
        for j, entry in enumerate(row)
        if not math.isfinite(entry)
    ]
    if faults:
        raise PoseError(faults)
    if bottom != [0.0, 0.0, 0.0, 1.0]:
        faults.append(Fault.at("pose_bottom_row", *where, 3))
    faults.extend(_rotation_faults(r0, r1, r2, where, tolerance))
    if faults:
        raise PoseError(faults)
    return matrix


def _matrix_4x4(value: ArrayLike, where: Place) -> Transform:
    try:
        matrix = np.asarray(value)
    except ValueError:
        matrix = np.asarray(None)
    if matrix.dtype.kind not in "fiu":
        raise PoseError(Fault.at("pose_not_numbers", *where))
    if matrix.shape != (4, 4):
        shape = "x".join(map(str, matrix.shape)) or "1"
        raise PoseError(Fault.at("pose_wrong_shape", *where, shape=shape))
    return np.array(matrix, dtype=np.float64)


def _rotation_faults(
    r0: list[float], r1: list[float], r2: list[float], where: Place, tolerance: float
) -> list[Fault]:
    """Whether the columns are perpendicular unit vectors, and right-handed."""
    x, y, z = ((r0[j], r1[j], r2[j]) for j in range(3))
    products = ((x, x, 1.0), (y, y, 1.0), (z, z, 1.0), (x, y, 0.0), (y, z, 0.0), (z, x, 0.0))
    error = max(abs(dot(u, v) - meant) for u, v, meant in products)
    if error > tolerance:
        return [Fault.at("pose_not_orthonormal", *where, error=f"{error:.2g}", tolerance=f"{tolerance:g}")]
    if dot(x, cross(y, z)) < 0.0:
        return [Fault.at("pose_left_handed", *where)]
    return []
