"""Gauss–Newton on δ, B and E with σ held fixed.

Entries rounded to a few decimals are wrong by a little each, and an alignment, made joint by joint, may lever
that up (axes that are nearly parallel, long chains). The certificate that fits all sampled configurations
best is what such an answer deserves to be judged by. What the policy fixes stays fixed: only motions that
keep it are used.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from kinematics.equivalence.certificates import Candidate
from kinematics.equivalence.chains import Chain, joint_motions
from kinematics.equivalence.policy import Tolerance
from kinematics.equivalence.reference import Reference
from kinematics.equivalence.rigid import (
    IDENTITY,
    ORIGIN,
    Motion,
    Vector,
    compose,
    norm,
    rotation_about,
    scale,
    to_matrix,
    translation,
)
from kinematics.equivalence.verification import Residual, joint_values, largest, size_for

Matrix = NDArray[np.float64]
ROUNDS = 12

FREE_TWISTS: Matrix = np.eye(6)
LINE_TWISTS: Matrix = np.eye(6)[:, [2, 5]]
DIRECTION_TWISTS: Matrix = np.eye(6)[:, [2, 3, 4, 5]]
POINT_TWISTS: Matrix = np.eye(6)[:, [0, 1, 2]]
NO_TWISTS: Matrix = np.eye(6)[:, []]


def refine(
    reference: Reference,
    submission: Chain,
    candidate: Candidate,
    tolerance: Tolerance,
    *,
    base_twists: Matrix,
    tool_twists: Matrix,
    offsets_free: bool,
) -> tuple[Candidate, Residual]:
    """The certificate near a given one whose residual is smallest, or small enough.

    Args:
        reference: the reference.
        submission: the submission's chain.
        candidate: where to begin.
        tolerance: when to stop.
        base_twists: (6, k) twists (rotation, translation) by which B may change from the left, in frame 0.
        tool_twists: (6, k) twists by which E may change from the right, in frame N.
        offsets_free: δ may change.
    """
    size = size_for(reference, submission)
    ratio = tolerance.angle / (tolerance.length * size)
    weights = np.ones(reference.poses.shape[0])
    best, best_residual = candidate, Residual(math.inf, math.inf)
    for _ in range(ROUNDS):
        left, jacobian = _left_side(submission, joint_values(reference, candidate))
        right = to_matrix(candidate.base) @ reference.poses @ to_matrix(candidate.tool)
        found = largest(left - right, size)
        previous = best_residual.excess(tolerance)
        if found.excess(tolerance) < previous:
            best, best_residual = candidate, found
        if best_residual.within(tolerance) or found.excess(tolerance) > 4.0 * previous:
            break
        if found.excess(tolerance) > 0.9 * previous:
            weights = _lean_on_the_worst(weights, left - right, tolerance, size)
        columns = [jacobian] if offsets_free else [jacobian[:, :, :0]]
        columns += [-_twists_of_base(right) @ base_twists, -_twists_of_tool(right) @ tool_twists]
        step = _least_squares(np.concatenate(columns, axis=2), _mismatch(left, right), weights, ratio)
        candidate = _moved(candidate, step, base_twists, tool_twists, offsets_free=offsets_free)
    return best, best_residual


def _left_side(submission: Chain, joints: Matrix) -> tuple[Matrix, Matrix]:
    """F_s (samples, 4, 4), and how frame N turns and moves with each joint (samples, 6, n)."""
    n, samples = joints.shape
    motions = joint_motions(submission, joints) if n else np.empty((0, samples, 4, 4))
    prefix = np.broadcast_to(np.eye(4), (samples, 4, 4))
    directions = np.empty((n, samples, 3))
    points = np.empty((n, samples, 3))
    for i, axis in enumerate(submission.axes):
        directions[i] = prefix[:, :3, :3] @ np.array(axis.direction)
        points[i] = prefix[:, :3, :3] @ np.array(axis.point) + prefix[:, :3, 3]
        prefix = prefix @ motions[i]
    left = prefix @ to_matrix(submission.end)
    jacobian = np.zeros((samples, 6, n))
    for i, axis in enumerate(submission.axes):
        if axis.prismatic:
            jacobian[:, 3:, i] = directions[i]
        else:
            jacobian[:, :3, i] = directions[i]
            jacobian[:, 3:, i] = np.cross(directions[i], left[:, :3, 3] - points[i])
    return left, jacobian


def _twists_of_base(right: Matrix) -> Matrix:
    """How B·F_r·E moves when B changes from the left: (samples, 6, 6)."""
    twists = np.zeros((right.shape[0], 6, 6))
    twists[:, :3, :3] = np.eye(3)
    twists[:, 3:, 3:] = np.eye(3)
    x, y, z = right[:, 0, 3], right[:, 1, 3], right[:, 2, 3]
    twists[:, 3, 1], twists[:, 3, 2] = z, -y
    twists[:, 4, 0], twists[:, 4, 2] = -z, x
    twists[:, 5, 0], twists[:, 5, 1] = y, -x
    return twists


def _twists_of_tool(right: Matrix) -> Matrix:
    """How B·F_r·E moves when E changes from the right: (samples, 6, 6)."""
    twists = np.zeros((right.shape[0], 6, 6))
    twists[:, :3, :3] = right[:, :3, :3]
    twists[:, 3:, 3:] = right[:, :3, :3]
    return twists


def _mismatch(left: Matrix, right: Matrix) -> Matrix:
    """The rotation and displacement that take the left side to the right: (samples, 6)."""
    turn = 0.5 * np.cross(left[:, :3, :3], right[:, :3, :3], axis=1).sum(axis=2)
    return np.concatenate([turn, right[:, :3, 3] - left[:, :3, 3]], axis=1)


def _lean_on_the_worst(weights: Matrix, difference: Matrix, tolerance: Tolerance, size: float) -> Matrix:
    """Weights that lead least squares towards the smallest largest error (Lawson's iteration)."""
    squares = np.einsum("sij,sij->sj", difference, difference)
    angle = np.sqrt(squares[:, :3].sum(axis=1) / 2.0) / tolerance.angle
    length = np.sqrt(squares[:, 3]) / (tolerance.length * size)
    weights = weights * np.maximum(np.maximum(angle, length), 1e-12)
    return np.asarray(weights / weights.mean(), dtype=np.float64)


def _least_squares(jacobian: Matrix, goal: Matrix, weights: Matrix, ratio: float) -> Matrix:
    root = np.sqrt(weights)[:, None] * np.array([1.0, 1.0, 1.0, ratio, ratio, ratio])
    a = (jacobian * root[:, :, None]).reshape(-1, jacobian.shape[2])
    b = (goal * root).ravel()
    normal = a.T @ a
    damping = 1e-12 * (np.trace(normal) + 1e-300)
    return np.asarray(np.linalg.solve(normal + damping * np.eye(normal.shape[0]), a.T @ b), dtype=np.float64)


def _moved(
    candidate: Candidate, step: Matrix, base_twists: Matrix, tool_twists: Matrix, *, offsets_free: bool
) -> Candidate:
    n = len(candidate.offsets) if offsets_free else 0
    k = base_twists.shape[1]
    offsets = candidate.offsets
    if offsets_free:
        offsets = tuple(value + float(change) for value, change in zip(offsets, step[:n], strict=True))
    base = compose(_small(base_twists @ step[n : n + k]), candidate.base)
    tool = compose(candidate.tool, _small(tool_twists @ step[n + k :]))
    return Candidate(signs=candidate.signs, offsets=offsets, base=base, tool=tool)


def _small(twist: Matrix) -> Motion:
    """Rotation by the first three components, then translation by the others."""
    a, b, c, x, y, z = twist.tolist()
    turn: Vector = (a, b, c)
    angle = norm(turn)
    if angle < 1e-300:
        return translation((x, y, z)) if (x or y or z) else IDENTITY
    r = rotation_about(ORIGIN, scale(turn, 1.0 / angle), math.cos(angle), math.sin(angle))
    return compose(translation((x, y, z)), r)
