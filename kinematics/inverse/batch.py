"""Many targets at once.

Of a level arm with a wrist at right angles the targets away from singularities are solved in the same array
operations (`clear_blocks`); the few others are then solved one by one, as every target of other arms is.
"""

from dataclasses import dataclass
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinematics.errors import Fault, PoseError
from kinematics.inverse.arm import Array
from kinematics.inverse.goals import Goal, read_goal, tolerances_of_exact
from kinematics.inverse.lengths import LARGEST_LENGTH
from kinematics.inverse.limits import within_limits
from kinematics.inverse.methods.clear_blocks import SOLUTIONS, clear_solutions
from kinematics.inverse.methods.wrist_scalars import ClearWrist
from kinematics.inverse.results import IKStatus, InverseKinematics
from kinematics.inverse.solver import Solver
from kinematics.se3 import cross_arrays

Indices = NDArray[np.intp]

_FREED_ONCE = 8 * 1024 * 1024  # Several times what a batch needs at a time [byte].

AT_ONCE = 1000  # How many targets are solved in the same array operations: more would not fit into the cache.


@dataclass(frozen=True, kw_only=True, slots=True)
class InverseKinematicsBatch:
    """The answers for many targets, in order of the targets.

    Attributes:
        joints: (k, n) all solutions of all targets.
        target: (k,) which target each belongs to, ascending.
        position_error: (k,) distance from the target [m].
        orientation_error: (k,) angle from the target [rad].
        status: (m,) of each target.
        complete: (m,) whether all of a target's solutions are there.
    """

    joints: Array
    target: Indices
    position_error: Array
    orientation_error: Array
    status: tuple[IKStatus, ...]
    complete: NDArray[np.bool_]

    @property
    def residual(self) -> Array:
        """(k,) √(position_error² + orientation_error²)."""
        return np.hypot(self.position_error, self.orientation_error)


def solve_many(solver: Solver, targets: ArrayLike) -> InverseKinematicsBatch:
    """Return the solutions for many targets: for each those that `Solver.solve` returns, in another order.

    Args:
        solver: the arm.
        targets: (m, 4, 4).

    Raises:
        PoseError: not (m, 4, 4), or a target is not a rigid motion, at ("target", i, …).
    """
    _let_memory_be_used_again()
    poses, tolerances = _checked(targets)
    n = solver.arm.n_joints
    parts: list[_Part] = []
    done = np.zeros(len(poses), dtype=bool)
    if solver.clear is not None:
        for start in range(0, len(poses), AT_ONCE):
            block = slice(start, start + AT_ONCE)
            part, done[block] = _at_once(solver, solver.clear, poses[block], tolerances[block])
            parts.append(part._replace(target=part.target + start))
    status = [IKStatus.SOLVED] * len(poses)
    complete = done.copy()
    for i in np.flatnonzero(~done).tolist():
        answer = solver.solve_goal(Goal(poses[i], float(tolerances[i])))
        status[i], complete[i] = answer.status, answer.complete
        parts.append(_part(answer, i, n))
    joints, owner, position, angle = _joined(parts, n)
    if not np.all(owner[:-1] <= owner[1:]):
        order = np.argsort(owner, kind="stable")
        joints, owner, position, angle = joints[order], owner[order], position[order], angle[order]
    return InverseKinematicsBatch(
        joints=joints,
        target=owner,
        position_error=position,
        orientation_error=angle,
        status=tuple(status),
        complete=complete,
    )


@cache
def _let_memory_be_used_again() -> None:
    """Free a large array once: the C library then keeps smaller ones instead of giving them back.

    It may otherwise give each batch's memory back and ask for it again, which costs half as much as the
    solutions.
    """
    np.empty(_FREED_ONCE, dtype=np.uint8)


class _Part(NamedTuple):
    """Solutions of some targets: joints, whose they are, distances and angles."""

    joints: Array
    target: Indices
    position_error: Array
    orientation_error: Array


def _joined(parts: list[_Part], n_joints: int) -> _Part:
    """All parts in one; a single one is not copied."""
    if not parts:
        return _Part(np.empty((0, n_joints)), np.empty(0, dtype=np.intp), np.empty(0), np.empty(0))
    if len(parts) == 1:
        return parts[0]
    return _Part(*(np.concatenate(column) for column in zip(*parts, strict=True)))


def _part(answer: InverseKinematics, i: int, n_joints: int) -> _Part:
    solutions = answer.solutions
    return _Part(
        np.array([solution.joints for solution in solutions]).reshape(-1, n_joints),
        np.full(len(solutions), i),
        np.array([solution.position_error for solution in solutions]),
        np.array([solution.orientation_error for solution in solutions]),
    )


def _checked(targets: ArrayLike) -> tuple[Array, Array]:
    """The targets, made sure to be rigid motions, and their tolerances."""
    poses = np.asarray(targets, dtype=np.float64)
    if poses.ndim != 3 or poses.shape[1:] != (4, 4):
        raise PoseError(Fault.at("targets_wrong_shape", "target"))
    if not len(poses):
        return poses, np.empty(0)
    R = poses[:, :3, :3]
    with np.errstate(all="ignore"):
        off = _off_orthonormal(R)
        handed = (cross_arrays(R[:, :, 0], R[:, :, 1]) * R[:, :, 2]).sum(axis=1)
        bottom = poses[:, 3] - (0.0, 0.0, 0.0, 1.0)
    far = np.abs(poses[:, :3, 3])
    if off.max() <= 1e-14 and handed.min() > 0.0 and not bottom.any() and far.max() < LARGEST_LENGTH:
        return poses, tolerances_of_exact(poses)
    suspects = ~(off.max(axis=1) <= 1e-14) | ~(handed > 0.0) | (bottom != 0.0).any(axis=1)
    suspects |= ~(far.max(axis=1) < LARGEST_LENGTH)
    rigid, tolerances = poses.copy(), np.empty(len(poses))
    tolerances[~suspects] = tolerances_of_exact(poses[~suspects])
    for i in np.flatnonzero(suspects).tolist():
        goal = read_goal(poses[i], None, where=("target", i))
        rigid[i], tolerances[i] = goal.pose, goal.tolerance
    return rigid, tolerances


def _off_orthonormal(R: Array) -> Array:
    """(m, 6): how far the entries of RᵀR on and above the diagonal are from those of the identity."""
    columns = np.ascontiguousarray(R.transpose(2, 1, 0))
    off = np.empty((6, len(R)))
    for row, (i, j) in enumerate(((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))):
        np.einsum("km,km->m", columns[i], columns[j], out=off[row])
    off[:3] -= 1.0
    return np.abs(off, out=off).T


def _at_once(
    solver: Solver, clear: ClearWrist, poses: Array, tolerances: Array
) -> tuple[_Part, NDArray[np.bool_]]:
    """Solutions of the targets that are away from singularities, and which targets those are."""
    joints, position, angle, done = clear_solutions(clear, poses, tolerances)
    targets = np.arange(len(poses))
    if not done.all():
        joints, position, angle, targets = joints[done], position[done], angle[done], targets[done]
    found = _Part(joints.reshape(-1, 6), np.repeat(targets, SOLUTIONS), position.ravel(), angle.ravel())
    if not solver.box.limited:
        return found, done
    inside, fits = within_limits(found.joints, solver.arm.revolute, solver.box, solver.arm.size)
    done &= np.bincount(found.target[fits], minlength=len(poses)) > 0
    return _Part(inside[fits], found.target[fits], position.ravel()[fits], angle.ravel()[fits]), done
