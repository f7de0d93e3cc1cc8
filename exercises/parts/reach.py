"""How near to and how far from a place the joints bring a point: the radii of a workspace.

The square of the distance is a sum of sines and cosines of one angle of at most the second order, and a
quadratic function of one slide, while the other joints stand still. So the best value of one joint is found
in closed form, and going round the joints from many starts finds the radii.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.links import link_transform
from kinematics.table import JointType, NumericTable

Array = NDArray[np.float64]
Interval = tuple[float, float]

STARTS = 48
ROUNDS = 200
TURN: Interval = (-math.pi, math.pi)
_GRID = 181


@dataclass(frozen=True, kw_only=True, slots=True)
class Reach:
    """Radii of a workspace, in the table's unit.

    Attributes:
        inner: least distance.
        outer: greatest distance.
    """

    inner: float
    outer: float


def reach(
    table: NumericTable,
    point: Array,
    origin: Array,
    square_to: Array | None,
    limits: Sequence[Interval | None],
) -> Reach:
    """Least and greatest distance of a point of the last link.

    Args:
        table: the robot.
        point: (3,) the point in frame N.
        origin: (3,) in frame 0, from where the distance is measured.
        square_to: (3,) unit direction of an axis through the origin; then the distance is that from the axis.
        limits: per joint, lowest and highest value; None for a joint that turns fully. [rad or length]

    Raises:
        ValueError: a slide has no limits.
    """
    spans = [
        limit or _full_turn(joint_type) for limit, joint_type in zip(limits, table.joint_types, strict=True)
    ]

    def square(p: Array) -> Array:
        r = p - origin
        if square_to is not None:
            r = r - np.outer(r @ square_to, square_to)
        return np.asarray(np.einsum("ij,ij->i", r, r), dtype=np.float64)

    near = _extreme(table, point, spans, lambda p: -square(p))
    far = _extreme(table, point, spans, square)
    return Reach(inner=math.sqrt(max(-near, 0.0)), outer=math.sqrt(max(far, 0.0)))


def _full_turn(joint_type: JointType) -> Interval:
    if joint_type is JointType.PRISMATIC:
        raise ValueError("a slide needs limits")
    return TURN


def _extreme(
    table: NumericTable, point: Array, spans: Sequence[Interval], value: Callable[[Array], Array]
) -> float:
    """The greatest value that the point's place in frame 0 can have."""
    n = table.n_joints
    primes = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)
    ratio = np.array([[(k + 1) * math.sqrt(p) % 1.0 for p in primes[:n]] for k in range(STARTS)])
    low, high = np.array(spans).reshape(n, 2).T
    joints = low + ratio * (high - low)
    best = -math.inf
    for _ in range(ROUNDS):
        for i in range(n):
            joints[:, i] = _best_of_joint(table, point, spans[i], joints, i, value)
        now = float(value(_places(table, point, joints)).max())
        if now <= best + 1e-12 * max(1.0, abs(now)):
            break
        best = now
    return max(best, float(value(_places(table, point, joints)).max()))


def _best_of_joint(
    table: NumericTable,
    point: Array,
    span: Interval,
    joints: Array,
    i: int,
    value: Callable[[Array], Array],
) -> Array:
    """For each start the best value of joint i, the others as they are."""
    turns = table.joint_types[i] is JointType.REVOLUTE
    nodes = np.linspace(*((0.0, 1.6 * math.pi) if turns else span), num=5 if turns else 3)
    samples = []
    for node in nodes:
        trial = joints.copy()
        trial[:, i] = node
        samples.append(value(_places(table, point, trial)))
    grid = np.linspace(span[0], span[1], _GRID)
    curve = _trigonometric(np.array(samples), grid) if turns else _quadratic(np.array(samples), nodes, grid)
    k = curve.argmax(axis=1)
    inside = np.clip(k, 1, _GRID - 2)
    rows = np.arange(len(curve))
    left, mid, right = (curve[rows, inside + d] for d in (-1, 0, 1))
    bend = left - 2 * mid + right
    shift = np.where(bend < -1e-15, 0.5 * (left - right) / np.where(bend == 0, 1.0, bend), 0.0)
    step = grid[1] - grid[0]
    refined = grid[inside] + np.clip(shift, -1, 1) * step
    return np.asarray(np.where(k == inside, refined, grid[k]), dtype=np.float64)


def _trigonometric(samples: Array, grid: Array) -> Array:
    """(starts, grid) values of a + b₁cos + c₁sin + b₂cos 2 + c₂sin 2 through five equidistant samples."""
    spectrum = np.fft.rfft(samples, axis=0) / 5
    waves = [np.ones_like(grid)]
    parts = [spectrum[0].real]
    for order in (1, 2):
        waves += [np.cos(order * grid), np.sin(order * grid)]
        parts += [2 * spectrum[order].real, -2 * spectrum[order].imag]
    return np.asarray(np.array(parts).T @ np.array(waves), dtype=np.float64)


def _quadratic(samples: Array, nodes: Array, grid: Array) -> Array:
    """(starts, grid) values of the parabola through three samples."""
    if nodes[0] == nodes[-1]:
        return np.repeat(samples[0][:, None], len(grid), axis=1)
    parts = np.polynomial.polynomial.polyfit(nodes, samples, 2)
    return np.asarray(np.polynomial.polynomial.polyval(grid, parts), dtype=np.float64)


def _places(table: NumericTable, point: Array, joints: Array) -> Array:
    """(starts, 3) places of the point in frame 0."""
    place = np.broadcast_to(point, (len(joints), 3))
    columns = {row: joint for joint, row in enumerate(table.joint_rows)}
    for i in range(len(table.rows) - 1, -1, -1):
        row = table.rows[i]
        if row.joint is JointType.FIXED:
            pose = link_transform(row, table.convention)
            place = place @ pose[:3, :3].T + pose[:3, 3]
            continue
        place = _moved(table, i, place, joints[:, columns[i]])
    return np.asarray(place, dtype=np.float64)


def _moved(table: NumericTable, i: int, place: Array, q: Array) -> Array:
    """The places seen from frame i-1, joint i at different values.

    A link transform is a + b cos q + c sin q, or a + b q.
    """
    row = table.rows[i]
    if row.joint is JointType.PRISMATIC:
        rest, one = (link_transform(row, table.convention, value) for value in (0.0, 1.0))
        slide = one[:3, 3] - rest[:3, 3]
        return np.asarray(place @ rest[:3, :3].T + rest[:3, 3] + q[:, None] * slide, dtype=np.float64)
    zero, quarter, half = (
        link_transform(row, table.convention, value) for value in (0.0, math.pi / 2, math.pi)
    )
    constant, cosine = (zero + half) / 2, (zero - half) / 2
    sine = quarter - constant
    c, s = np.cos(q)[:, None], np.sin(q)[:, None]
    return np.asarray(
        place @ constant[:3, :3].T
        + constant[:3, 3]
        + c * (place @ cosine[:3, :3].T + cosine[:3, 3])
        + s * (place @ sine[:3, :3].T + sine[:3, 3]),
        dtype=np.float64,
    )
