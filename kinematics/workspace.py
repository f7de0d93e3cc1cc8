"""The workspace of an arm: how near and how far the tool's origin comes, and the box that holds it.

Reach is sampled all over the joint ranges; then every extreme is climbed to from the best samples by Newton
steps, with exact first and second derivatives. What comes out are local extremes to rounding, each with the
configuration at which it is taken, so that anyone can check them. That none is better is made likely by the
samples and not proved.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinematics.errors import Fault, JointValueError, TableError
from kinematics.forward import end_poses
from kinematics.inverse.arm import Arm, Array, arm_of
from kinematics.inverse.limits import JointLimits, read_limits
from kinematics.inverse.search import Box, low_discrepancy
from kinematics.table import NumericTable
from kinematics.transforms import check_transform

SAMPLES = 20_000
"""Configurations that are sampled before climbing."""

BEST, ANYWHERE = 16, 12
"""Climbs for each extreme: from the best samples, and from samples anywhere."""

_ITERATIONS = 120
_STILL, _QUIET = 1e-9, 4
"""Where no start moves by more than this [rad, or parts of the size] so many times, all are there."""

_ZERO = 1e-9


@dataclass(frozen=True, kw_only=True, slots=True)
class Extreme:
    """The least or greatest value of a distance or coordinate.

    Attributes:
        value: the value [m].
        joints: q_1 … q_n at which it is taken [rad, or m].
    """

    value: float
    joints: tuple[float, ...]


@dataclass(frozen=True, kw_only=True, slots=True)
class Radii:
    """How near and how far the tool's origin comes.

    Attributes:
        inner: the least distance.
        outer: the greatest distance.
    """

    inner: Extreme
    outer: Extreme


@dataclass(frozen=True, kw_only=True, slots=True)
class Workspace:
    """Where the tool's origin can be.

    Attributes:
        from_axis: distances from the axis of the first joint.
        from_origin: distances from the origin of the world (of frame 0, if there is no base).
        least: least x, y and z.
        greatest: greatest x, y and z.
        points: (k, 3) sampled positions [m].
    """

    from_axis: Radii
    from_origin: Radii
    least: tuple[Extreme, Extreme, Extreme]
    greatest: tuple[Extreme, Extreme, Extreme]
    points: Array


@dataclass(frozen=True, slots=True)
class _Objective:
    """sign · (p - centre)ᵀ M (p - centre) + g·p, to be made least; M is 0 or a projection."""

    sign: float
    form: Array
    centre: Array
    linear: Array

    def values(self, p: Array) -> Array:
        v = p - self.centre
        return np.asarray(self.sign * np.einsum("ki,ij,kj->k", v, self.form, v) + p @ self.linear)


def workspace(
    table: NumericTable,
    *,
    base: ArrayLike | None = None,
    tool: ArrayLike | None = None,
    limits: JointLimits | None = None,
    points: int = 0,
) -> Workspace:
    """The workspace of an arm.

    Args:
        table: the DH table, with at least one joint.
        base: (4, 4) pose of frame 0 in the world; the identity if left out.
        tool: (4, 4) pose of the tool in frame N; the identity if left out.
        limits: (least, greatest) of each joint [rad, or m]. A joint that turns may have none, and takes a
            full turn; one that slides must have both.
        points: how many sampled positions are wanted.

    Raises:
        TableError: no joint.
        JointValueError: malformed limits, or none for a joint that slides, at ("limits", i).
        PoseError: base or tool is not a rigid motion.

    Source: seed 003, the working radii of the DMRA.
    """
    if not table.n_joints:
        raise TableError(
            Fault(code="workspace_without_joints", where=("rows",), message="without a joint nothing moves")
        )
    T_w_0 = None if base is None else check_transform(base, where=("base",))
    T_n_t = None if tool is None else check_transform(tool, where=("tool",))
    arm = arm_of(table, T_w_0, T_n_t)
    box = _ranges(arm, read_limits(limits, arm.n_joints))
    q = box.low + (box.high - box.low) * low_discrepancy(max(SAMPLES, points), arm.n_joints)
    p = end_poses(table, q, base=T_w_0, tool=T_n_t)[:, :3, 3]
    axis, point = arm.screws[0][0], arm.screws[1][0]
    across = np.eye(3) - np.outer(axis, axis)
    extremes = [_extreme(arm, box, q, p, _coordinate(i, sign)) for sign in (1.0, -1.0) for i in range(3)]
    return Workspace(
        from_axis=_radii(arm, box, q, p, across, point),
        from_origin=_radii(arm, box, q, p, np.eye(3), np.zeros(3)),
        least=(extremes[0], extremes[1], extremes[2]),
        greatest=(extremes[3], extremes[4], extremes[5]),
        points=p[:points].copy(),
    )


def _ranges(arm: Arm, box: Box) -> Box:
    """Finite ranges: a full turn where a joint that turns has no limit."""
    faults = [
        Fault(
            code="limits_required",
            where=("limits", i),
            message=f"joint {i + 1} slides: without a least and a greatest value its workspace has no end",
            params={"joint": i + 1},
        )
        for i in range(arm.n_joints)
        if not arm.revolute[i] and not (np.isfinite(box.low[i]) and np.isfinite(box.high[i]))
    ]
    if faults:
        raise JointValueError(faults)
    from_above = np.where(np.isfinite(box.high), box.high - math.tau, -math.pi)
    low = np.where(np.isfinite(box.low), box.low, from_above)
    high = np.where(np.isfinite(box.high), box.high, low + math.tau)
    return Box(low, np.minimum(high, np.where(arm.revolute, low + math.tau, high)))


def _coordinate(i: int, sign: float) -> _Objective:
    return _Objective(0.0, np.zeros((3, 3)), np.zeros(3), sign * np.eye(3)[i])


def _radii(arm: Arm, box: Box, q: Array, p: Array, form: Array, centre: Array) -> Radii:
    inner, outer = (
        _extreme(arm, box, q, p, _Objective(sign, form, centre, np.zeros(3))) for sign in (1.0, -1.0)
    )
    return Radii(inner=inner, outer=outer)


def _extreme(arm: Arm, box: Box, q: Array, p: Array, objective: _Objective) -> Extreme:
    """The least value of an objective, in terms of the distance or coordinate that it stands for."""
    order = np.argsort(objective.values(p), kind="stable")
    starts = np.concatenate((q[order[:BEST]], q[:ANYWHERE]))
    joints = _climb(arm, box, starts, objective)
    values = objective.values(arm.frames(joints)[-1, :, :3, 3])
    best = int(np.argmin(values))
    value = float(values[best])
    if objective.sign:
        value = math.sqrt(max(objective.sign * value, 0.0))
        value = 0.0 if value <= _ZERO * arm.size else value
    else:
        value *= float(objective.linear.sum())
    return Extreme(value=value + 0.0, joints=tuple(joints[best].tolist()))


def _climb(arm: Arm, box: Box, starts: Array, objective: _Objective) -> Array:
    """Damped Newton steps from every start; a joint at its bound that wants to leave is held there."""
    q = starts
    value, gradient, hessian = _derivatives(arm, q, objective)
    scale = np.where(arm.revolute, 1.0, arm.size)
    damping = np.full(len(q), 1e-3)
    quiet = 0
    for _ in range(_ITERATIONS):
        held = ((q <= box.low) & (gradient > 0)) | ((q >= box.high) & (gradient < 0))
        step = _newton(gradient * scale, hessian * scale * scale[:, None], damping, held) * scale
        tried = np.clip(q + step, box.low, box.high)
        new_value, new_gradient, new_hessian = _derivatives(arm, tried, objective)
        better = new_value < value
        moved = float(np.where(better, np.abs((tried - q) / scale).max(axis=1), 0.0).max())
        quiet = quiet + 1 if moved < _STILL else 0
        if quiet == _QUIET:
            break
        damping = np.clip(np.where(better, damping * 0.2, damping * 6.0), 1e-12, 1e8)
        q = np.where(better[:, None], tried, q)
        value = np.where(better, new_value, value)
        gradient = np.where(better[:, None], new_gradient, gradient)
        hessian = np.where(better[:, None, None], new_hessian, hessian)
    return q


def _newton(gradient: Array, hessian: Array, damping: Array, held: NDArray[np.bool_]) -> Array:
    """-(|H| + λ‖H‖)⁻¹ g without the held joints; |H| has the absolute eigenvalues, so it goes downhill."""
    g = np.where(held, 0.0, gradient)
    H = np.where(held[:, :, None] | held[:, None, :], 0.0, hessian)
    values, vectors = np.linalg.eigh(H)
    size = np.maximum(np.abs(values).max(axis=1, keepdims=True), 1e-12)
    inverse = 1.0 / (np.abs(values) + (damping[:, None] + 1e-14) * size)
    return np.asarray(-np.einsum("kij,kj,klj,kl->ki", vectors, inverse, vectors, g))


def _derivatives(arm: Arm, q: Array, objective: _Objective) -> tuple[Array, Array, Array]:
    """Value, gradient and Hessian of an objective.

    For i ≤ j, ∂²p/∂q_i∂q_j = z_i × ∂p/∂q_j if joint i turns, and 0 if it slides.
    """
    frames = arm.frames(q)
    p = frames[-1, :, :3, 3]
    J = arm.jacobians(frames)[:, :3] * arm.size
    axes = np.where(arm.revolute[:, None, None], frames[:-1, :, :3, 2], 0.0).transpose(1, 0, 2)
    columns = J.transpose(0, 2, 1)
    v = p - objective.centre
    weight = 2.0 * objective.sign * (v @ objective.form) + objective.linear
    gradient = np.einsum("ki,kij->kj", weight, J)
    turned = np.cross(axes[:, :, None], columns[:, None])
    curvature = np.einsum("ki,kabi->kab", weight, turned)
    upper = np.triu(curvature)
    hessian = upper + np.triu(curvature, 1).transpose(0, 2, 1)
    hessian += 2.0 * objective.sign * np.einsum("kia,ij,kjb->kab", J, objective.form, J)
    return objective.values(p), gradient, hessian
