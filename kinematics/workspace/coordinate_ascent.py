"""The maximum of an objective within the joint limits, by coordinate ascent.

While the other joints stand still, a point moves on a circle or a line, and the objective is
a + b cos q + c sin q + d cos 2q + e sin 2q, or a parabola. So the best value of one joint is found in closed
form. Sweeps through the joints from the tip to the base, from many starts, lead to the maximum; Newton's
steps in all joints at once make the last digits right.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from kinematics.chain import chain_of_table
from kinematics.forward import end_poses
from kinematics.se3 import Floats, Transform, cross_arrays
from kinematics.table import JointType, NumericTable
from kinematics.workspace.objectives import Objective, Objectives, stacked
from kinematics.workspace.spans import spread

LOOKS = 768  # Samples among which the starts are chosen.
STARTS = 32  # Configurations from which an ascent starts.
BEST_CORNERS = 8  # Of the starts so many are corners of the ranges, where there are as many.
MOST_CORNERS = 9  # Joints whose limits make corners: of more there would be thousands.
FULL_TURN = 1e-9  # Ranges shorter than a turn by less than this [rad] are a turn.
MOST_SWEEPS = 120
FEWEST_SWEEPS = 6
NEWTON_STEPS = 40
"""Sweeps through the joints in an ascent, and Newton's steps at its end: both stop once nothing is gained."""

_GRID = 65
_SMALL_GAIN = 1e-9
"""Values of a joint tried in a round, and the gain, as a share of the size, that ends the rounds."""
_CANDIDATES = 4
"""Two ends and two local maxima: of nearly equal ones the grid does not tell which is greatest."""


@dataclass(frozen=True, slots=True)
class Maximum:
    """The maximum of an objective.

    Attributes:
        joints: (n,) configuration.
        place: (3,) place in frame 0.
    """

    value: float
    joints: Floats
    place: Floats


def maxima(
    table: NumericTable, objectives: Sequence[Objective], spans: Floats, tool: Transform | None = None
) -> list[Maximum]:
    """Return for each objective the greatest value that the origin of the tool can have.

    Args:
        objectives: what is to be great, in frame 0.
        spans: (n, 2) ranges of the joints.
        tool: (4, 4) pose of the tool in frame N.
    """
    joints = _starts(table, objectives, spans, tool).reshape(len(objectives), STARTS, -1)
    values = np.full((len(objectives), STARTS), -np.inf)
    rising = np.arange(len(objectives))
    for sweep in range(MOST_SWEEPS):
        ascents = stacked([objectives[k] for k in rising.tolist()], STARTS)
        swept = _swept(table, ascents, np.concatenate(joints[rising]), spans, tool)
        before = values[rising].max(axis=1)
        joints[rising] = swept.reshape(len(rising), STARTS, -1)
        values[rising] = ascents.values(_places(table, swept, tool)).reshape(len(rising), STARTS)
        if sweep >= FEWEST_SWEEPS:
            gain = values[rising].max(axis=1) - before
            rising = rising[gain > _SMALL_GAIN * (1.0 + np.abs(values).max())]
        if not len(rising):
            break
    return [
        _polished(table, objective, q[int(value.argmax())], spans, tool)
        for objective, q, value in zip(objectives, joints, values, strict=True)
    ]


def _starts(
    table: NumericTable, objectives: Sequence[Objective], spans: Floats, tool: Transform | None
) -> Floats:
    """For each objective the best samples, the best corners, and others from all over the ranges."""
    looked = spread(spans, LOOKS)
    corners = _corners(table, spans)
    fixed = np.arange(0, LOOKS, 2 * LOOKS // STARTS)
    best_corners = min(len(corners), BEST_CORNERS)
    places, corner_places = (_places(table, q, tool) for q in (looked, corners))
    chosen = []
    for objective in objectives:
        value = stacked([objective], LOOKS).values(places)
        at_corners = stacked([objective], len(corners)).values(corner_places)
        best = np.argsort(-value, kind="stable")[: STARTS - len(fixed) - best_corners]
        chosen += [
            looked[np.concatenate((best, fixed))],
            corners[np.argsort(-at_corners, kind="stable")[:best_corners]],
        ]
    return np.concatenate(chosen)


def _corners(table: NumericTable, spans: Floats) -> Floats:
    """Corners of the ranges of the first joints that have limits, the others at the middle of theirs.

    The way up to a greatest value in a corner may begin so near to it that nothing of what is spread evenly
    lies there.
    """
    turning = np.array([kind is JointType.REVOLUTE for kind in table.joint_types])
    limited = np.flatnonzero(~turning | (spans[:, 1] - spans[:, 0] < 2.0 * np.pi - FULL_TURN))[:MOST_CORNERS]
    corners = np.tile(spans.mean(axis=1), (2 ** len(limited), 1))
    ends = np.array([*product((0, 1), repeat=len(limited))], dtype=np.intp)
    corners[:, limited] = spans[limited, ends.reshape(len(corners), -1)]
    return corners


def _places(table: NumericTable, joints: Floats, tool: Transform | None) -> Floats:
    return np.asarray(end_poses(table, joints, tool=tool)[:, :3, 3])


def _axes(table: NumericTable, joints: Floats) -> tuple[Floats, Floats]:
    """(m, n, 3) directions of the joints' positive motions, and points of their axes, in frame 0."""
    return chain_of_table(table).axes_at(joints)


def first_axis(table: NumericTable) -> tuple[Floats, Floats]:
    """Return (3,) point and (3,) direction of the first joint's axis in frame 0."""
    directions, points = _axes(table, np.zeros((1, table.n_joints)))
    return points[0, 0] + 0.0, directions[0, 0] + 0.0


def _swept(
    table: NumericTable, objectives: Objectives, joints: Floats, spans: Floats, tool: Transform | None
) -> Floats:
    """Every joint once at its best, from the tip to the base: what lies before a joint stays where it is."""
    directions, points = _axes(table, joints)
    p = _places(table, joints, tool)
    joints = joints.copy()
    for i in range(table.n_joints - 1, -1, -1):
        u, low, high = directions[:, i], float(spans[i, 0]), float(spans[i, 1])
        if table.joint_types[i] is JointType.PRISMATIC:
            still = p - joints[:, i, None] * u
            joints[:, i] = _best_slide(objectives, still, u, low, high)
            p = still + joints[:, i, None] * u
            continue
        arm = p - points[:, i]
        along = np.einsum("mi,mi->m", arm, u)[:, None] * u
        a, b = arm - along, cross_arrays(u, arm)
        c, s = np.cos(joints[:, i, None]), np.sin(joints[:, i, None])
        a, b = c * a - s * b, s * a + c * b  # at q = 0, and a quarter turn on
        centre = points[:, i] + along
        joints[:, i] = _best_turn(objectives, centre, a, b, low, high)
        p = centre + np.cos(joints[:, i, None]) * a + np.sin(joints[:, i, None]) * b
    return joints


def _best_slide(objectives: Objectives, still: Floats, u: Floats, low: float, high: float) -> Floats:
    Wu = np.einsum("mij,mj->mi", objectives.W, u)
    second = np.einsum("mi,mi->m", Wu, u)
    first = 2.0 * np.einsum("mi,mi->m", Wu, still - objectives.origin) + np.einsum(
        "mi,mi->m", objectives.c, u
    )
    vertex = np.clip(-first / np.where(second < 0.0, 2.0 * second, 1.0), low, high)
    ends = np.where(first * (high - low) + second * (high**2 - low**2) > 0.0, high, low)
    return np.asarray(np.where(second < 0.0, vertex, ends))


def _best_turn(
    objectives: Objectives, centre: Floats, a: Floats, b: Floats, low: float, high: float
) -> Floats:
    """The best angle where the place is centre + a cos q + b sin q."""
    Wa, Wb = np.einsum("mij,mj->mi", objectives.W, a), np.einsum("mij,mj->mi", objectives.W, b)
    lever = 2.0 * np.einsum("mij,mj->mi", objectives.W, centre - objectives.origin) + objectives.c
    c1, s1 = np.einsum("mi,mi->m", lever, a), np.einsum("mi,mi->m", lever, b)
    c2 = (np.einsum("mi,mi->m", a, Wa) - np.einsum("mi,mi->m", b, Wb)) / 2.0
    s2 = np.einsum("mi,mi->m", a, Wb)
    grid = np.linspace(low, high, _GRID)
    waves = np.array([np.cos(grid), np.sin(grid), np.cos(2 * grid), np.sin(2 * grid)])
    curve = np.column_stack((c1, s1, c2, s2)) @ waves
    below = np.zeros(curve.shape, dtype=bool)
    below[:, 1:-1] = (curve[:, 1:-1] < curve[:, :-2]) | (curve[:, 1:-1] < curve[:, 2:])
    start = grid[np.argpartition(np.where(below, np.inf, -curve), _CANDIDATES)[:, :_CANDIDATES]]
    c1, s1, c2, s2 = (each[:, None] for each in (c1, s1, c2, s2))
    q = start
    for _ in range(4):
        c, s, cc, ss = np.cos(q), np.sin(q), np.cos(2 * q), np.sin(2 * q)
        derivative = -c1 * s + s1 * c - 2 * c2 * ss + 2 * s2 * cc
        curvature = -c1 * c - s1 * s - 4 * c2 * cc - 4 * s2 * ss
        step = np.where(curvature < 0.0, -derivative / np.where(curvature < 0.0, curvature, 1.0), 0.0)
        q = np.clip(q + np.clip(step, -0.1, 0.1), low, high)
    tried = np.concatenate((start, q), axis=1)
    values = c1 * np.cos(tried) + s1 * np.sin(tried) + c2 * np.cos(2 * tried) + s2 * np.sin(2 * tried)
    return np.asarray(tried[np.arange(len(tried)), values.argmax(axis=1)])


def _polished(
    table: NumericTable, objective: Objective, joints: Floats, spans: Floats, tool: Transform | None
) -> Maximum:
    """The maximum near a configuration, by Newton's steps within the ranges."""
    one = stacked([objective], 1)
    q, place = joints, _places(table, joints[None], tool)[0]
    value = float(one.values(place[None])[0])
    for _ in range(NEWTON_STEPS):
        gradient, hessian = _derivatives(table, objective, q, place)
        at_low, at_high = q <= spans[:, 0], q >= spans[:, 1]
        free = ~((at_low & (gradient <= 0.0)) | (at_high & (gradient >= 0.0)))
        if not free.any():
            break
        gradient, hessian = gradient[free], hessian[np.ix_(free, free)]
        eigenvalues, vectors = np.linalg.eigh(-hessian)
        scale = float(np.abs(eigenvalues).max()) or 1.0
        gained = False
        for damping in (1e-13, 1e-9, 1e-6, 1e-3, 1.0):
            bent = np.maximum(np.abs(eigenvalues), damping * scale)
            trial = q.copy()
            trial[free] += vectors @ ((vectors.T @ gradient) / bent)
            trial = np.clip(trial, spans[:, 0], spans[:, 1])
            there = _places(table, trial[None], tool)[0]
            reached = float(one.values(there[None])[0])
            if reached > value:
                q, place, value, gained = trial, there, reached, True
                break
        if not gained:
            break
    return Maximum(value, q, place)


def _derivatives(
    table: NumericTable, objective: Objective, q: Floats, place: Floats
) -> tuple[Floats, Floats]:
    """Gradient (n,) and Hessian (n, n) of an objective with respect to the joints.

    ∂p/∂q_i = z_i × (p − p_i), and ∂²p/∂q_i∂q_j = z_i × ∂p/∂q_j for i ≤ j; of a prismatic joint z_i, and 0.
    """
    directions, points = (array[0] for array in _axes(table, q[None]))
    turning = np.array([kind is JointType.REVOLUTE for kind in table.joint_types])
    J = np.where(turning[:, None], cross_arrays(directions, place - points), directions)
    lever = 2.0 * objective.W @ (place - objective.origin) + objective.c
    turned = cross_arrays(directions[:, None], J[None, :]) @ lever
    upper = np.triu(np.where(turning[:, None], turned, 0.0))
    hessian = 2.0 * J @ objective.W @ J.T + upper + np.triu(upper, 1).T
    return J @ lever, hessian
