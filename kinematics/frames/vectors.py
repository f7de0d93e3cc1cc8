"""Products of 3-vectors as tuples of floats.

A chain has a few dozen of them, one after the other: plain floats are several times faster here than arrays.
"""

from __future__ import annotations

import math
from typing import TypeAlias

Vector: TypeAlias = tuple[float, float, float]

ORIGIN: Vector = (0.0, 0.0, 0.0)


def dot(u: Vector, v: Vector) -> float:
    """Scalar product u·v."""
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u: Vector, v: Vector) -> Vector:
    """Vector product u×v."""
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def minus(u: Vector, v: Vector) -> Vector:
    """Difference u - v."""
    return (u[0] - v[0], u[1] - v[1], u[2] - v[2])


def along(point: Vector, length: float, direction: Vector) -> Vector:
    """The point + length·direction."""
    return (
        point[0] + length * direction[0],
        point[1] + length * direction[1],
        point[2] + length * direction[2],
    )


def scaled(factor: float, v: Vector) -> Vector:
    """The product factor·v, without negative zeros."""
    return (factor * v[0] + 0.0, factor * v[1] + 0.0, factor * v[2] + 0.0)


def norm(v: Vector) -> float:
    """Length |v|."""
    return math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])


def unit(v: Vector) -> Vector:
    """Direction v/|v|, safe against overflow and underflow of the squares."""
    largest = max(abs(v[0]), abs(v[1]), abs(v[2]))
    v = (v[0] / largest, v[1] / largest, v[2] / largest)
    length = norm(v)
    return (v[0] / length, v[1] / length, v[2] / length)


def rejected(v: Vector, direction: Vector) -> Vector:
    """The part of v perpendicular to a unit direction."""
    return along(v, -dot(v, direction), direction)


def foot(point: Vector, on: Vector, direction: Vector) -> Vector:
    """The point nearest to `point` on the line through `on` along a unit direction."""
    return along(on, dot(minus(point, on), direction), direction)


def turn(u: Vector, v: Vector, about: Vector) -> float:
    """Angle from u to v about a unit direction perpendicular to both, in (-π, π]."""
    angle = math.atan2(dot(about, cross(u, v)), dot(u, v))
    return math.pi if angle == -math.pi else angle


def perpendicular(direction: Vector) -> Vector:
    """Some unit vector perpendicular to a unit direction: the coordinate axis x, y or z nearest to its plane.

    Ties go to x before y before z.
    """
    sizes = [abs(component) for component in direction]
    least = min(range(3), key=lambda i: (round(sizes[i], 9), i))
    axis = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))[least]
    return unit(rejected(axis, direction))
