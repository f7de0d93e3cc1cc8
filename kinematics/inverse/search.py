"""Damped least squares from many starts at once.

Every start descends ‖e(q)‖² by its own Levenberg–Marquardt steps, all of them in the same array operations:
(JᵀJ + λ) δ = Jᵀe, λ down after a step that helps and up after one that does not. Starts are points of a
low-discrepancy sequence, so a search is the same every time.

Source: T. Sugihara, Solvability-unconcerned inverse kinematics by the Levenberg–Marquardt method, IEEE Trans.
Robotics 27 (2011) 984, for the use of damping; K. Madsen, H. B. Nielsen, O. Tingleff, Methods for non-linear
least squares problems (2004) §3.2.
"""

from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cached_property

import numpy as np

from kinematics.inverse.arm import Arm, Array, low_discrepancy
from kinematics.inverse.distinct import distinct
from kinematics.inverse.newton import evened, farthest_off, polish
from kinematics.inverse.residuals import are_solutions, errors_at, errors_of
from kinematics.inverse.valleys import along_valleys, least_error

CONVERGED = 1e-11  # Size of the error vector at which a start has arrived.

ARRIVED = 1e-5  # Size of the error vector at which Newton steps take over.

TOLERANCE = 5e-9  # Largest distance [m] and angle [rad] of a solution found by search.

MOST_ISOLATED = 16
"""No arm of six joints has more isolated solutions; with more found, there is a continuum of them.

Source: E. J. F. Primrose, On the input–output equation of the general 7R-mechanism,
Mech. Mach. Theory 21 (1986) 509.
"""

FIRST_ROUND = 32  # Starts of the first round: for most arms they find every solution several times.
REDUNDANT_STARTS = 128
"""Starts for arms with redundant joints: each of their families, sixteen at most of seven joints, draws
many."""

ENOUGH_STARTS = 512  # Starts after which a search may end.
MOST_STARTS = 2048  # Starts after which it must.
BY_OWN_SIZE = 256
"""Starts that descend by the arm's own size to what is nearest, where another was taken for the search."""

MOST_VALLEYS = 64
"""Configurations from which valleys are followed, the nearest to their target: all of them take 0.2 s."""

_DAMPING = (1e-9, 1e4)
"""Bounds of the damping of a descent: below the least a step is Gauss-Newton, above the greatest none."""


class Bounds(StrEnum):
    """Whether a search keeps the joint limits."""

    KEPT = "kept"
    IGNORED = "ignored"


@dataclass(frozen=True)
class Box:
    """Bounds of the joint variables; infinite where there are none."""

    low: Array
    high: Array

    @cached_property
    def limited(self) -> bool:
        """Whether there is any bound."""
        return bool(np.isfinite(self.low).any() or np.isfinite(self.high).any())


def one_turn(low: Array, high: Array) -> tuple[Array, Array]:
    """Return the ranges, those of angles that are wider than a turn cut to the turn nearest to zero."""
    with np.errstate(over="ignore"):
        wide = high - low >= 2.0 * np.pi
    start = np.maximum(np.minimum(-np.pi, high - 2.0 * np.pi), low)
    return np.where(wide, start, low), np.where(wide, start + 2.0 * np.pi, high)


def unbounded(n_joints: int) -> Box:
    """Return a box without limits."""
    return Box(np.full(n_joints, -np.inf), np.full(n_joints, np.inf))


@dataclass(frozen=True, slots=True)
class Descent:
    """Where the starts ended.

    Attributes:
        joints: (m, n).
        errors: (m,) size of the error vector there.
    """

    joints: Array
    errors: Array


@dataclass(frozen=True, slots=True)
class SearchResult:
    """What a search found.

    Attributes:
        solutions: (k, n) distinct solutions, turns not brought into any range.
        nearest: (n,) the configuration nearest to the target.
    """

    solutions: Array
    nearest: Array


def descend(
    arm: Arm, target: Array, starts: Array, box: Box, iterations: int = 60, least_gain: float = 1e-4
) -> Descent:
    """Descend from every start.

    Args:
        arm: the arm.
        target: (4, 4).
        starts: (m, n), inside the box.
        box: bounds that are kept at every step: a joint at its bound that wants to leave is held there.
        iterations: the most that any start takes.
        least_gain: part of the cost that a step must take off; a start that fails to eight times in a row
            is at a local minimum.
    """
    q = starts.copy()
    ended = np.empty(len(q))
    alive = np.arange(len(q))
    frames = arm.frames(q)
    e = errors_of(arm, frames[-1], target)
    cost = (e * e).sum(axis=1)
    ended[:] = cost
    damping = np.full(len(q), 1e-2)
    stalled = np.zeros(len(q), dtype=int)
    at = q.copy()
    for _ in range(iterations):
        step = _steps(arm, arm.jacobians(frames), e, damping + cost * 1e-3, at, box if box.limited else None)
        tried = at + step
        if box.limited:
            np.clip(tried, box.low, box.high, out=tried)
        new_frames = arm.frames(tried)
        new_e = errors_of(arm, new_frames[-1], target)
        new_cost = (new_e * new_e).sum(axis=1)
        better = new_cost < cost
        gained = (cost - new_cost) > least_gain * cost
        stalled = np.where(better & gained, 0, stalled + 1)
        damping = np.clip(np.where(better, damping * 0.1, damping * 5.0), *_DAMPING)
        at = np.where(better[:, None], tried, at)
        frames = np.where(better[None, :, None, None], new_frames, frames)
        e = np.where(better[:, None], new_e, e)
        cost = np.where(better, new_cost, cost)
        q[alive], ended[alive] = at, cost
        going = (cost > CONVERGED**2) & (stalled < 8)
        if not going.all():
            alive, at, e, cost = alive[going], at[going], e[going], cost[going]
            frames, damping, stalled = frames[:, going], damping[going], stalled[going]
            if not len(alive):
                break
    return Descent(q, np.sqrt(ended))


def search(
    arm: Arm,
    target: Array,
    box: Box,
    bounds: Bounds,
    tolerance: float = TOLERANCE,
    near: Array | None = None,
) -> SearchResult:
    """Return the solutions from many starts, and the nearest configuration.

    Rounds of starts, each as large as all before it, go on until one brings nothing new (of arms with
    joints to
    spare: until there are solutions at all), or until the budget for this number of joints is used up.

    Args:
        arm: the arm.
        target: (4, 4).
        box: joint limits.
        bounds: whether starts and descent keep them.
        tolerance: distance [m] and angle [rad] of a solution, at least `TOLERANCE`.
        near: (m, n) starts near solutions, where such are known; they come in the first round.
    """
    n = arm.n_joints
    box = box if bounds is Bounds.KEPT else unbounded(n)
    measured = _measured(arm, target)
    farthest = max(ARRIVED, farthest_off(measured, tolerance))
    found = np.empty((0, n))
    ends: list[Array] = []
    done, count = 0, FIRST_ROUND
    while done < min(MOST_STARTS, FIRST_ROUND * 8 ** (n - 1)):
        starts = _starts(arm, target, box, count, done)
        if near is not None and not done:
            starts = np.concatenate((np.clip(near, box.low, box.high), starts))
        descent = descend(measured, target, starts, box)
        ends.append(_best(descent))
        arrived = descent.joints[descent.errors < farthest]
        before = len(found)
        if len(arrived):
            found = distinct(
                arm, target, np.concatenate((found, _exact(measured, target, arrived, box, tolerance)))
            )
        done, count = done + count, done + count
        enough = len(found) == before or len(found) > MOST_ISOLATED or done >= ENOUGH_STARTS
        if len(found) and (done >= REDUNDANT_STARTS if arm.redundancy else enough):
            break
    if len(found):
        return SearchResult(found, found[0])
    if measured is not arm:
        ends.append(_best(descend(arm, target, _starts(arm, target, box, BY_OWN_SIZE, 0), box)))
    settled = descend(arm, target, np.concatenate(ends), box, iterations=300, least_gain=1e-13)
    nearest = settled.joints[int(np.argmin(settled.errors))]
    return SearchResult(found, least_error(arm, target, nearest, box.low, box.high))


def _best(descent: Descent) -> Array:
    """The few ends nearest to the target."""
    return np.asarray(descent.joints[np.argsort(descent.errors, kind="stable")[:4]])


def _measured(arm: Arm, target: Array) -> Arm:
    """The arm, its size what the target asks of its slides: beside their way its offsets may be nothing."""
    far = float(np.linalg.norm(target[:3, 3] - arm.constants[0, :3, 3]))
    return arm if arm.revolute.all() or far <= arm.size else replace(arm, size=far, sliding=far)


def _exact(arm: Arm, target: Array, joints: Array, box: Box, tolerance: float) -> Array:
    """Those configurations that, refined and put back into the box, are solutions; the best first."""
    tolerance = max(tolerance, TOLERANCE)
    q = np.clip(polish(arm, target, joints), box.low, box.high)
    vectors = errors_at(arm, q, target)
    exact = are_solutions(vectors, arm, tolerance)
    if not exact.all():
        off = np.where(exact, np.inf, np.linalg.norm(vectors, axis=1))
        left = np.argsort(off, kind="stable")[: min(int((~exact).sum()), MOST_VALLEYS)]
        settled = evened(arm, target, along_valleys(arm, target, joints[left]), tolerance)
        q[left] = np.clip(settled, box.low, box.high)
        vectors = errors_at(arm, q, target)
        exact = are_solutions(vectors, arm, tolerance)
    return np.asarray(q[exact][np.argsort(np.linalg.norm(vectors[exact], axis=1), kind="stable")])


def _starts(arm: Arm, target: Array, box: Box, count: int, skip: int) -> Array:
    """Starts all over the box: of each angle over one turn at most, a slide as far as the target may need."""
    far = arm.size + float(np.linalg.norm(target[:3, 3]))
    bounded_below, bounded_above = np.isfinite(box.low), np.isfinite(box.high)
    low = np.where(bounded_below, box.low, np.where(bounded_above, box.high - 2.0 * far, -far))
    high = np.where(bounded_above, box.high, low + 2.0 * far)
    turns = one_turn(box.low, box.high)
    low, high = np.where(arm.revolute, turns, (low, high))
    return np.asarray(low + (high - low) * low_discrepancy(count, arm.n_joints, skip))


def _steps(arm: Arm, J: Array, e: Array, damping: Array, q: Array, box: Box | None) -> Array:
    """Solutions δ of (JᵀJ + λ) δ = Jᵀe, slides in units of the size and λ of the mean diagonal of JᵀJ."""
    J = J * arm.units
    gradient = (J.transpose(0, 2, 1) @ e[:, :, None])[:, :, 0]
    if box is not None:
        held = ((q <= box.low) & (gradient < 0)) | ((q >= box.high) & (gradient > 0))
        J = np.where(held[:, None, :], 0.0, J)
        gradient = np.where(held, 0.0, gradient)
    A = J.transpose(0, 2, 1) @ J
    n = A.shape[1]
    diagonal = range(n)
    A[:, diagonal, diagonal] += (damping * np.maximum(A[:, diagonal, diagonal].mean(axis=1), 1e-3))[:, None]
    return np.asarray(np.linalg.solve(A, gradient[:, :, None])[:, :, 0] * arm.units)
