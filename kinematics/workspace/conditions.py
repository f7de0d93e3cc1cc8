"""The workspace under conditions: in a plane, or with the tool held as it is.

What is asked is the greatest value of an objective on the set of configurations where the conditions hold,

    max f(q),   c(q) = 0,   low ≤ q ≤ high.

Many configurations are brought onto that set by Gauss–Newton steps, move along it by their projected
gradient and are brought back after every step; the best end with Newton's steps in the set's tangent plane.

Source: D. G. Luenberger, Y. Ye, Linear and nonlinear programming, 3rd ed. (2008) §12.4 (gradient projection)
and §15.5 (Newton's steps for constrained problems).
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from kinematics.errors import Fault, PoseError
from kinematics.inverse.arm import Arm, ArmReach, arm_of
from kinematics.inverse.residuals import errors_of
from kinematics.se3 import Floats, Transform
from kinematics.table import NumericTable
from kinematics.workspace.coordinate_ascent import Maximum
from kinematics.workspace.objectives import Objective, Objectives, stacked
from kinematics.workspace.spans import spread

LOOKS = 1024  # Configurations that are brought onto the set.

STARTS = 16
"""Configurations from which an ascent starts: half of them the best, the others from all over the set."""

STEPS_ONTO = 40
STEPS_BACK = 5
MOST_STEPS = 150
NEWTON_STEPS = 12
"""Steps onto the set, back onto it after a move, of an ascent along it, and of Newton at the end, at most."""

LONGEST_STEP = 0.5
"""Longest step onto the set [rad, or parts of the size]: farther than this tangents tell little."""

HOLDS = 1e-10  # Size of the conditions' errors [rad, and parts of the size] with which they count as met.

_DAMPING = 1e-14
_DIFFERENCE = 1e-6
_SETTLED = 1e-9
"""Damping of singular steps; step of the central differences, of the order of the cube root of the precision;
and the length of a step that ends an ascent."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Conditions:
    """What has to hold of the tool, in frame 0.

    Attributes:
        plane: a point of the plane in which its origin lies, and the unit normal; None if anywhere.
        pose: (4, 4) whose rotation it has; None if any.
        reach: POSE where the whole rotation counts, AXIS where its z axis does.
    """

    plane: tuple[Floats, Floats] | None
    pose: Transform | None
    reach: ArmReach


class _Surface:
    """The set of configurations on which conditions hold; joints in the arm's units."""

    def __init__(self, table: NumericTable, conditions: Conditions, spans: Floats, tool: Transform | None):
        arm = arm_of(table, None, tool)
        self.arm: Arm = replace(arm, reach=conditions.reach)
        self.whole: Arm = replace(arm, reach=ArmReach.POSE)
        self.conditions = conditions
        self.low, self.high = (spans / arm.units[:, None]).T

    def seen(self, x: Floats) -> tuple[Floats, Floats, Floats, Floats]:
        """Return points (m, 3), Jacobians (m, 3, n), the conditions' errors (m, k), theirs (m, k, n)."""
        frames = self.arm.frames(x * self.arm.units)
        J = self.whole.jacobians(frames) * self.arm.units
        place, along = frames[-1, :, :3, 3], J[:, :3] * self.arm.size
        errors, jacobians = [], []
        if self.conditions.plane is not None:
            point, normal = self.conditions.plane
            errors.append(((place - point) @ normal)[:, None] / self.arm.size)
            jacobians.append((normal @ J[:, :3])[:, None])
        if self.conditions.pose is not None:
            turning = J if self.arm.reach is ArmReach.POSE else self.arm.jacobians(frames) * self.arm.units
            errors.append(-errors_of(self.arm, frames[-1], self.conditions.pose)[:, 3:])
            jacobians.append(turning[:, 3:])
        return place, along, np.concatenate(errors, axis=1), np.concatenate(jacobians, axis=1)

    def brought(self, x: Floats, steps: int, held: NDArray[np.bool_] | bool = False) -> tuple[Floats, Floats]:
        """Return configurations after Gauss–Newton steps onto the set, and the size of their errors (m,).

        Joints that are `held`, (m, n), stay where they are.
        """
        for _ in range(steps):
            _, _, c, C = self.seen(x)
            step = _least_step(C, c)
            blocked = held | ((x <= self.low) & (step < 0.0)) | ((x >= self.high) & (step > 0.0))
            if blocked.any():
                step = _least_step(np.where(blocked[:, None], 0.0, C), c)
            longest = np.abs(step).max(axis=1, initial=0.0)[:, None]
            step *= np.minimum(1.0, LONGEST_STEP / np.maximum(longest, LONGEST_STEP))
            x = np.clip(x + step, self.low, self.high)
        return x, np.linalg.norm(self.seen(x)[2], axis=1)


def maxima_within(
    table: NumericTable,
    objectives: Sequence[Objective],
    spans: Floats,
    conditions: Conditions,
    tool: Transform | None = None,
) -> list[Maximum]:
    """Return for each objective the greatest value that the tool's origin can have under conditions.

    Args:
        objectives: what is to be great, in frame 0.
        spans: (n, 2) ranges of the joints.
        tool: (4, 4) pose of the tool in frame N.

    Raises:
        PoseError: no configuration was found where the conditions hold.
    """
    surface = _Surface(table, conditions, spans, tool)
    on = _on_it(surface, spans, LOOKS)
    if not len(on):
        turned = "axis" if conditions.reach is ArmReach.AXIS else "quaternion"
        where = "plane" if conditions.pose is None else turned
        raise PoseError(Fault.at("workspace_condition_unmet", where))
    place = surface.seen(on)[0]
    fixed = np.linspace(0, len(on) - 1, STARTS // 2).astype(int)
    chosen = []
    for objective in objectives:
        value = stacked([objective], len(on)).values(place)
        chosen += [np.resize(np.argsort(-value, kind="stable"), STARTS - len(fixed)), fixed]
    x = _ascended(surface, stacked(objectives, STARTS), on[np.concatenate(chosen)])
    found = []
    for k, objective in enumerate(objectives):
        own = x[k * STARTS : (k + 1) * STARTS]
        value = stacked([objective], STARTS).values(surface.seen(own)[0])
        found.append(_polished(surface, objective, own[int(value.argmax())]))
    return found


def places_within(
    table: NumericTable, count: int, spans: Floats, conditions: Conditions, tool: Transform | None = None
) -> Floats:
    """Return (m, 3) places of the tool's origin where conditions hold, m ≤ count."""
    surface = _Surface(table, conditions, spans, tool)
    return np.asarray(surface.seen(_on_it(surface, spans, count))[0])


def _on_it(surface: _Surface, spans: Floats, count: int) -> Floats:
    x, off = surface.brought(spread(spans, count) / surface.arm.units, STEPS_ONTO)
    return np.asarray(x[off <= HOLDS])


def _least_step(C: Floats, c: Floats) -> Floats:
    """(m, n) shortest steps with C·step = -c."""
    square = C @ C.transpose(0, 2, 1)
    k = square.shape[1]
    scale = np.maximum(np.einsum("mii->m", square), 1e-300)
    weights = np.linalg.solve(square + (_DAMPING * scale)[:, None, None] * np.eye(k), -c[:, :, None])
    with np.errstate(all="ignore"):  # where all joints are blocked there is no step
        steps = (C.transpose(0, 2, 1) @ weights)[:, :, 0]
    return np.asarray(np.where(np.isfinite(steps), steps, 0.0))


def _gradients(objectives: Objectives, place: Floats, along: Floats) -> Floats:
    lever = 2.0 * np.einsum("mij,mj->mi", objectives.W, place - objectives.origin) + objectives.c
    return np.asarray(np.einsum("mi,mij->mj", lever, along))


def _ascended(surface: _Surface, objectives: Objectives, x: Floats) -> Floats:
    """Configurations after steps along their projected gradients, each as long as it still helps.

    A joint that a step takes to its limit stays there while the others are brought back: else it would come
    off the limit again with every step, and the steps would get shorter and shorter.
    """
    step = np.full(len(x), 0.1)
    value = objectives.values(surface.seen(x)[0])
    for _ in range(MOST_STEPS):
        place, along, _, C = surface.seen(x)
        g = _gradients(objectives, place, along)
        way = g + _least_step(C, np.einsum("mkn,mn->mk", C, g))
        ahead = x + _long(way, step)
        passed = (ahead <= surface.low) | (ahead >= surface.high)
        if passed.any():
            g = np.where(passed, 0.0, g)
            C = np.where(passed[:, None], 0.0, C)
            others = x + _long(g + _least_step(C, np.einsum("mkn,mn->mk", C, g)), step)
            ahead = np.where(passed, ahead, others)
        moved = np.clip(ahead, surface.low, surface.high)
        moved, off = surface.brought(moved, STEPS_BACK, passed)
        there = objectives.values(surface.seen(moved)[0])
        better = (off <= HOLDS) & (there > value)
        x, value = np.where(better[:, None], moved, x), np.where(better, there, value)
        step = np.where(better, 1.6 * step, 0.35 * step)
        if float(step.max()) < _SETTLED:
            break
        step = np.clip(step, 1e-12, 0.5)
    return x


def _long(ways: Floats, lengths: Floats) -> Floats:
    """Ways, (m, n), brought to lengths, (m,)."""
    own = np.maximum(np.linalg.norm(ways, axis=1), 1e-300)
    return np.asarray((lengths / own)[:, None] * ways)


def _polished(surface: _Surface, objective: Objective, x: Floats) -> Maximum:
    """The maximum near a configuration, by Newton's steps along the set."""
    one = stacked([objective], 1)
    value = float(one.values(surface.seen(x[None])[0])[0])
    for _ in range(NEWTON_STEPS):
        place, along, _, C = (part[0] for part in surface.seen(x[None]))
        g = _gradients(one, place[None], along[None])[0]
        pull, *_ = np.linalg.lstsq(C.T, -g, rcond=1e-10)
        rest = g + C.T @ pull
        free = ~(((x <= surface.low) & (rest <= 0.0)) | ((x >= surface.high) & (rest >= 0.0)))
        pull, *_ = np.linalg.lstsq(C[:, free].T, -g[free], rcond=1e-10)
        _, sizes, rows = np.linalg.svd(C[:, free])
        rank = int((sizes > 1e-9).sum())
        Z = rows[rank:].T
        if not Z.shape[1]:
            break
        bent, vectors = np.linalg.eigh(-Z.T @ _bending(surface, one, x, pull, free) @ Z)
        bent = np.maximum(np.abs(bent), 1e-9 * max(float(np.abs(bent).max()), 1e-300))
        step = np.zeros_like(x)
        step[free] = Z @ (vectors @ ((vectors.T @ (Z.T @ g[free])) / bent))
        gained = False
        for part in (1.0, 0.25, 0.05):
            there = np.clip(x + part * step, surface.low, surface.high)
            trial, off = surface.brought(there[None], 2 * STEPS_BACK, ~free)
            reached = float(one.values(surface.seen(trial)[0])[0])
            if off[0] <= HOLDS and reached > value:
                x, value, gained = trial[0], reached, True
                break
        if not gained:
            break
    return Maximum(value, x * surface.arm.units, surface.seen(x[None])[0][0])


def _bending(surface: _Surface, objective: Objectives, x: Floats, pull: Floats, free: Floats) -> Floats:
    """Hessian of f + pull·c in the free joints, by central differences of its gradient."""
    columns = np.flatnonzero(free)
    shifts = _DIFFERENCE * np.eye(len(x))[columns]
    gradients = []
    for sign in (1.0, -1.0):
        place, along, _, C = surface.seen(x + sign * shifts)
        many = Objectives(
            *(np.repeat(part, len(columns), axis=0) for part in (objective.origin, objective.W, objective.c))
        )
        gradients.append((_gradients(many, place, along) + pull @ C)[:, columns])
    H = (gradients[0] - gradients[1]) / (2.0 * _DIFFERENCE)
    return np.asarray(0.5 * (H + H.T))
