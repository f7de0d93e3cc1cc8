"""Random chains of axes, and what they do, computed from screws and not from any table."""

import math

import numpy as np

from kinematics.frames.axes import JointAxis
from kinematics.table import JointType

GRID = [np.array(v, float) for v in ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))]
KINDS = ("general", "related", "axis_aligned")


def rotation(axis, angle):
    K = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + math.sin(angle) * K + (1 - math.cos(angle)) * K @ K


def direction_of(axis):
    u = np.array(axis.direction, float)
    return u / np.linalg.norm(u)


def motion(axis, q):
    """Motion of the joint by q, from its axis alone."""
    T = np.eye(4)
    u = direction_of(axis)
    if axis.joint is JointType.PRISMATIC:
        T[:3, 3] = q * u
        return T
    p = np.array(axis.point, float)
    T[:3, :3] = rotation(u, q)
    T[:3, 3] = p - T[:3, :3] @ p
    return T


def unit(rng):
    v = rng.normal(size=3)
    return v / np.linalg.norm(v)


def random_chain(rng, kind, prismatic=0.2, most=8):
    """Axes that are general, or skew, parallel, antiparallel, coincident, crossing or perpendicular"
    " neighbours."""
    axes = []
    u, p = unit(rng), rng.normal(size=3)
    for k in range(rng.integers(1, most + 1)):
        if kind == "axis_aligned":
            if k == 0 or rng.random() < 0.7:
                u = GRID[rng.integers(6)]
            if rng.random() < 0.8:
                p = rng.integers(-2, 3, size=3) * 0.25
        else:
            u, p = _related(rng, u, p, rng.integers(0, 6) if kind == "related" else 0)
        joint = JointType.PRISMATIC if rng.random() < prismatic else JointType.REVOLUTE
        stretched = u * rng.uniform(0.5, 2.0)
        axes.append(JointAxis(joint=joint, direction=stretched.tolist(), point=p.tolist()))
    return axes


def _related(rng, u, p, relation):
    if relation == 0:
        return unit(rng), rng.normal(size=3)
    if relation == 1:
        return u, rng.normal(size=3)
    if relation == 2:
        return -u, rng.normal(size=3)
    if relation == 3:
        return (u if rng.random() < 0.5 else -u), p + u * rng.normal()
    if relation == 4:
        return unit(rng), p + u * rng.normal()
    v = np.cross(u, unit(rng))
    return v / np.linalg.norm(v), p + u * rng.normal()


def random_end(rng, axis):
    """A frame anywhere, along the axis, or crossing it at right angles."""
    T = np.eye(4)
    u, p = direction_of(axis), np.array(axis.point, float)
    kind = rng.integers(0, 3)
    if kind == 0:
        T[:3, :3], T[:3, 3] = rotation(unit(rng), rng.normal()), rng.normal(size=3)
        return T
    x = np.cross(u, unit(rng))
    x /= np.linalg.norm(x)
    z, origin = u, p + u * rng.normal()
    if kind == 2:
        z = np.cross(x, unit(rng))
        z /= np.linalg.norm(z)
        origin = origin + x * rng.normal()
    T[:3, :3], T[:3, 3] = np.column_stack((x, np.cross(z, x), z)), origin
    return T
