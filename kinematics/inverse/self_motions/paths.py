"""Families followed along their paths: from a member both ways abreast, in steps that keep the target.

A path is as narrow as its tolerance where it ends, and there the step is halved and halved again. All halves
are tried in the same array operations as soon as one step has failed, with those of the other way.

Source: for the predictor and the corrector, E. L. Allgower, K. Georg, Introduction to numerical continuation
methods (2003) ch. 2 and 3.
"""

import math

import numpy as np

from kinematics.inverse.arm import Array
from kinematics.inverse.residuals import are_solutions
from kinematics.inverse.self_motions.corrections import corrected_across
from kinematics.inverse.self_motions.families import FamilyPath, Follower

FIRST_STEP = 0.02
"""First step along a component [rad, or parts of the size]; it is halved where it loses the target, and
doubled while the path stays straight. A path that noise bends is followed by steps longer than the bends."""

LONGEST_STEP = 0.4
"""Straight families (a wrist in line) are followed in steps of this length; bent ones in shorter steps."""

SHORTEST_STEP = 1e-7  # A path ends where not even this step keeps the target.

SOME_HALVES = 4
"""Halves that are tried together first: a bend takes one or two, the end of a path all of them."""

SLIDING = 1e-9
"""Turns below this [rad per unit] in a direction: slides alone move, and steps may be of any length."""

MOST_STEPS = 400  # More steps than the longest closed paths of seven-joint arms were seen to take (some 250).

CLEARANCE = 3.0
"""A path that comes back to its start is beside it by a few roots of the tolerance: so wide is what a
tolerance leaves where the Jacobian loses rank."""

STRAIGHT = 0.03
"""Turn of the direction in one step [rad] below which the next step may be twice as long; with three times
this a step is taken again at half the length."""

NEAR_ONE_END, SAGGING = 0.2, 0.75
"""Of second singular values at both ends of a step: one below this part of the other, or one in the middle
below this part of their mean, may vanish between."""

PARTS, NARROWINGS = 10, 6
"""Parts of a step of which the ends are looked at for a crossing, and how often the two beside the least
second singular value are divided again."""

AGAIN, ASIDE = 0.9, 0.02
"""Cosine above which a path that comes as near as this part of a step to an earlier point goes its way."""

BACK = 0.2  # Part of a step that a path may come back to its start, or one way to the other, beside it.


def path_through(follower: Follower, x: Array, direction: Array, held: Array | None = None) -> FamilyPath:
    """Return the component through a solution along a direction, both ways.

    Args:
        follower: of the solution's target.
        x: (n,) the solution, in units.
        direction: (n,) unit direction that the Jacobian does not see.
        held: (k, n) rows of which held·x stays as it is: the other directions of a family of more than one.
    """
    held = np.empty((0, len(x))) if held is None else held
    ahead, behind = (_OneWay(follower, x, sign * direction, held) for sign in (1.0, -1.0))
    met = False
    while (ahead.goes or (behind.goes and not ahead.closed)) and not met:
        _take_steps(follower, [way for way in (ahead, behind) if way.goes])
        met = ahead.goes and behind.goes and ahead.meets(behind)
    if ahead.closed:
        behind.points.clear()
    follower.spent += ahead.spent + (0 if ahead.closed else behind.spent)
    back = behind.points[::-1]
    if met:  # from the start right round, so the way behind is some turns on
        turns = ahead.x - follower.back_to(ahead.x, back[0]) - back[0]
        points = np.array([x, *ahead.points, *(place + turns for place in back)])
    else:
        points = np.array([*back, x, *ahead.points])
    return FamilyPath(points * follower.arm.units, ahead.closed or met, follower.second(points))


def _take_steps(follower: Follower, ways: "list[_OneWay]") -> None:
    """Take the next step of each way, all that may be in the same array operations."""
    tried = [way.next_steps() for way in ways]
    counts = [len(steps) for steps in tried]
    all_steps = np.concatenate(tried)[:, None]
    aims = np.repeat([way.x for way in ways], counts, axis=0)
    aims += all_steps * np.repeat([way.direction for way in ways], counts, axis=0)
    across = [way.across() for way in ways]
    bends = np.repeat(
        [free @ (way.curvature @ free) for way, free in zip(ways, across, strict=True)], counts, axis=0
    )
    found, e, J = corrected_across(
        follower.arm, follower.target, aims + 0.5 * all_steps**2 * bends, np.repeat(across, counts, axis=0)
    )
    off = np.linalg.norm(found - aims, axis=1)
    kept = are_solutions(e, follower.arm, follower.tolerance) & (off <= all_steps[:, 0])
    ends = np.cumsum(counts)
    for way, steps, end, count in zip(ways, tried, ends.tolist(), counts, strict=True):
        rows = slice(end - count, end)
        way.take(steps, kept[rows].tolist(), found[rows], J[rows])


class _OneWay:
    """A path followed one way.

    Attributes:
        x: (n,) where it has come to, in units.
        direction: (n,) unit direction in which it goes on.
        curvature: (n,) how the direction turned in the last step, per length; corrections start from there.
        points: where it has been since its start.
        goes: whether it goes on.
        closed: whether it has come back to its start.
        spent: steps tried.
    """

    def __init__(self, follower: Follower, start: Array, direction: Array, held: Array) -> None:
        self._follower, self._start, self._held = follower, start, held
        self.x, self.direction = start, direction
        self.points: list[Array] = []
        self.goes, self.closed, self.spent = True, False, 0
        self.curvature = np.zeros(len(start))
        self._directions: list[Array] = []
        self._step, self._last, self._gone = FIRST_STEP, FIRST_STEP, 0.0
        self._steps, self._halved = 0, 0
        self._narrow = False
        self._second, _ = self._seen(follower.jacobian(start), direction)

    def next_steps(self) -> Array:
        """Return (k,) lengths of the steps to be tried, of which the first that may be is taken."""
        count = 1
        if self._halved or self._narrow:
            count = SOME_HALVES if self._halved <= 1 else MOST_STEPS
        halves: Array = self._step * np.exp2(-np.arange(min(count, MOST_STEPS - self._steps), dtype=float))
        return halves[: max(int((halves >= SHORTEST_STEP).sum()), 1)]

    def across(self) -> Array:
        """Return (n, m) directions of corrections: across the path's direction and all that is held."""
        if not len(self._held):
            return np.eye(len(self.x)) - np.outer(self.direction, self.direction)
        rows = np.vstack((self.direction, self._held))
        return np.asarray(np.linalg.svd(rows)[2][len(rows) :].T)

    def take(self, steps: Array, kept: list[bool], found: Array, J: Array) -> None:
        """Take the first step that may be taken, and see whether the path goes on.

        Args:
            steps: (k,) lengths of what was tried.
            kept: (k,) whether the target is reached there, and nearer than a step.
            found: (k, n) where each leads.
            J: (k, 6, n) the Jacobians there.
        """
        taken = False
        for k, step in enumerate(steps.tolist()):
            self.spent += 1
            self._steps += 1
            if kept[k] and self._takes(step, found[k], J[k]):
                taken = True
                break
            self._halved += 1
            self._step = 0.5 * step
        if taken:
            self._narrow, self._halved = self._halved > 0, 0
        self.goes &= self._step >= SHORTEST_STEP and self._steps < MOST_STEPS

    def _takes(self, h: float, new: Array, J: Array) -> bool:
        """Take a step to a configuration where the target is reached; False if it has to be shorter."""
        second, turned = self._seen(J, self.direction)
        bend = float(np.arccos(np.clip(turned @ self.direction, -1.0, 1.0)))
        if bend > 3.0 * STRAIGHT and h > FIRST_STEP:
            return False
        if self._passes_a_crossing(new, second) and (bend > 3.0 * STRAIGHT or not self._crosses_between(new)):
            return False
        self._gone += h
        back = self._follower.back_to(self._start, new)
        along = float(back @ turned)
        beside = float(np.linalg.norm(back - along * turned))
        self._last = h
        if self._gone > 4.0 * h and abs(along) <= h and beside < self._clearance(h):
            self.points.append(new)
            self.closed, self.goes = True, False
            return True
        if self._gone > 2.0 * math.pi and self._was_there(new, turned, h):
            self.goes = False
            return True
        self.curvature = (turned - self.direction) / h if bend <= 3.0 * STRAIGHT else np.zeros(len(new))
        self.x, self.direction, self._second = new, turned, second
        self.points.append(new)
        self._directions.append(turned)
        arm = self._follower.arm
        slides = float(np.abs(turned[arm.revolute]).max(initial=0.0)) < SLIDING
        self._step = min(2.0 * h if bend < STRAIGHT else h, np.inf if slides else LONGEST_STEP)
        slid = float(np.abs(new - self._start)[~arm.revolute].max(initial=0.0))
        self.goes = slid <= self._follower.farthest
        return True

    def meets(self, other: "_OneWay") -> bool:
        """Whether this way and another from one start meet; what the other has come beyond is dropped."""
        for back in (1, 2):
            if len(other.points) < back:
                return False
            way = self._follower.back_to(other.points[-back], self.x)
            along = float(way @ self.direction)
            if along >= 0.0:
                break
        else:
            return False
        step = max(self._last, other._last)
        beside = float(np.linalg.norm(way - along * self.direction))
        if along > step or beside >= self._clearance(step):
            return False
        if -float(self.direction @ other._directions[-back]) < AGAIN:
            return False
        there = self.x + way
        if not self._follower.joined(self.x, there):
            return False
        second, _ = self._seen(self._follower.jacobian(there), self.direction)
        if self._passes_a_crossing(there, second):
            return False
        del other.points[len(other.points) - back + 1 :]
        return True

    def _clearance(self, step: float) -> float:
        return max(BACK * step, CLEARANCE * self._follower.lost)

    def _seen(self, J: Array, before: Array) -> tuple[float, Array]:
        """The second least singular value, and what is neither seen by the Jacobian nor held of a direction.

        The value is infinite where a direction is held or two are spare.
        """
        _, values, rows = np.linalg.svd(np.vstack((J, self._held)))
        n = J.shape[1]
        place = n - 2
        second = math.inf
        if not len(self._held) and self._follower.arm.redundancy <= 1 and 0 <= place < len(values):
            second = float(values[place])
        values = np.concatenate((values, np.zeros(n - len(values))))
        null = rows[values <= max(float(np.sort(values)[0]) * 3.0, 1e-5)]
        t = null.T @ (null @ before)
        length = float(np.linalg.norm(t))
        return second, np.asarray(t / length if length > 0.1 else before)

    def _passes_a_crossing(self, new: Array, there: float) -> bool:
        """Whether a step may lead past a place where two families all but cross, and from one to the other.

        The second singular value, small at such a place, grows from it on both sides, by one for each radian
        at most. Where it is lost the two are one within the tolerance, and a step may lead on.
        """
        here, follower = self._second, self._follower
        least, greatest = min(here, there), max(here, there)
        if least <= follower.lost or here + there >= float(np.linalg.norm(new - self.x)):
            return False
        if least < NEAR_ONE_END * greatest:
            return True
        (middle,) = follower.second(0.5 * (self.x + new)[None])
        return bool(middle < SAGGING * 0.5 * (here + there))

    def _crosses_between(self, new: Array) -> bool:
        """Whether a place on the way of a step reaches the target where the second singular value vanishes.

        Two families cross there. Corrected across both, which all but touch beside it, a place stays between.
        """
        follower, way = self._follower, new - self.x
        plane = np.linalg.svd(follower.jacobian(self.x + 0.5 * way))[2][len(way) - 2 :]
        across = np.eye(len(way)) - plane.T @ plane
        low, high = 0.0, 1.0
        for _ in range(NARROWINGS):
            parts = np.linspace(low, high, PARTS + 1)
            self.spent += 1
            places, e, _ = corrected_across(
                follower.arm, follower.target, self.x + parts[:, None] * way, across
            )
            values = follower.second(places)
            k = int(values.argmin())
            if values[k] <= follower.lost:
                return follower.reached(e[k])
            low, high = float(parts[max(k - 1, 0)]), float(parts[min(k + 1, PARTS)])
        return False

    def _was_there(self, x: Array, t: Array, step: float) -> bool:
        """Whether a path comes back to where it was, as one does that leads round a loop of families."""
        alike = np.flatnonzero(np.abs(np.array(self._directions) @ t) > AGAIN)
        back = self._follower.back_to(np.array(self.points)[alike], x)
        along = back @ t
        aside = np.linalg.norm(back - along[:, None] * t, axis=1)
        near = (np.abs(along) <= step) & (aside < max(ASIDE * step, CLEARANCE * self._follower.lost))
        return bool(near[alike < len(self.points) - 4].any())
