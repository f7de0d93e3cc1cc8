"""One target: all solutions where there is a closed form, as many as a search finds elsewhere."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from kinematics.inverse.arm import Arm, ArmReach, Array
from kinematics.inverse.degree import signs_cancel
from kinematics.inverse.distinct import differences
from kinematics.inverse.goals import LARGEST_TOLERANCE, ROUNDING, Goal, read_goal
from kinematics.inverse.limits import within_limits
from kinematics.inverse.methods.closed_form import InverseClosedForm, candidates_beside, closed_form_of
from kinematics.inverse.methods.locked import LockedArms, locked_arms_of
from kinematics.inverse.methods.wrist_scalars import ClearWrist
from kinematics.inverse.refinement import refined, settled_on_folds, solutions_of
from kinematics.inverse.results import Family, IKSolution, IKStatus, InverseKinematics, Method
from kinematics.inverse.scaled_lengths import answer_from_unit, arm_in_unit, box_in_unit, goal_in_unit
from kinematics.inverse.search import MOST_ISOLATED, Bounds, Box, SearchResult, search
from kinematics.inverse.search import TOLERANCE as SEARCHED
from kinematics.inverse.self_motions.components import components_of
from kinematics.inverse.self_motions.families import Follower
from kinematics.inverse.self_motions.isolation import told_apart
from kinematics.inverse.self_motions.membership import Component
from kinematics.inverse.self_motions.ranges import families_within
from kinematics.inverse.telling import told_solutions, unreachable
from kinematics.inverse.valleys import in_valleys, low_points
from kinematics.se3 import Transform
from kinematics.table import NumericTable

SMALL = SEARCHED / LARGEST_TOLERANCE
"""Size [m] below which a search's tolerance runs the solutions of an arm into each other: distances are
measured in parts of the size instead."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Solver:
    """An arm made ready for inverse kinematics.

    Attributes:
        table: its table, in the unit of the request whatever the arm is measured in.
        base: (4, 4) pose of frame 0 in the world, or None.
        tool: (4, 4) pose of the tool in frame N, or None.
        arm: its constants and joints.
        closed_form: the method that yields all solutions, if there is one.
        clear: the same in scalars, for targets that are well away from singularities, if there is one.
        locked: closed forms with one joint locked, if the arm has one redundant joint.
        box: joint limits.
    """

    table: NumericTable
    base: Transform | None
    tool: Transform | None
    arm: Arm
    closed_form: InverseClosedForm | None
    clear: ClearWrist | None
    locked: LockedArms | None
    box: Box

    def solve(self, target: ArrayLike, tolerance: float | None = None) -> InverseKinematics:
        """Return the joint variables that reach a target.

        Args:
            target: (4, 4) pose of the tool in the world.
            tolerance: distance [m] and angle [rad] within which it counts as reached, for poses that were
                rounded: with five decimals 1e-5. Left out, what the target itself shows of rounding; see
                `read_goal`.

        Raises:
            PoseError: not a rigid motion, or too far away to be computed with, at ("target", …).
        """
        return self.solve_goal(self.goal(target, tolerance, where=("target",)))

    def nearest_first(self, answer: InverseKinematics, start: Sequence[float] | None) -> InverseKinematics:
        """Return the same answer, its solutions sorted by their distance from a start, if there is one.

        Turns are measured on the circle, and slides in parts of the arm's size: the order is the same in
        every unit of length.

        Args:
            answer: of this arm.
            start: joint values [rad, or the length unit of the arm].
        """
        if start is None or not answer.solutions:
            return answer
        joints = np.array([solution.joints for solution in answer.solutions])
        apart = np.linalg.norm(differences(joints, np.array(start), self.arm), axis=1)
        order = np.argsort(apart, kind="stable").tolist()
        return answer._replace(solutions=tuple(answer.solutions[i] for i in order))

    def goal(self, target: ArrayLike, tolerance: float | None, where: tuple[str | int, ...]) -> Goal:
        """Return a target made ready; arguments and refusals are those of `read_goal`."""
        goal, size = read_goal(target, tolerance, where, self.arm.size), self.arm.size
        if tolerance is None or not self._is_small_beside(goal):
            return self._measured(goal)
        distance = min(max(tolerance, ROUNDING * size), LARGEST_TOLERANCE * size)
        by_position = self.arm.reach is ArmReach.POSITION
        unit = size if by_position else min(distance / goal.tolerance, size / SMALL)
        return goal._replace(tolerance=distance, unit=unit)

    def _measured(self, goal: Goal) -> Goal:
        """The same goal, its tolerance a part of the arm's size where the arm is small beside tolerances."""
        if not self._is_small_beside(goal):
            return goal
        return goal._replace(tolerance=goal.tolerance * self.arm.size, unit=self.arm.size)

    def _is_small_beside(self, goal: Goal) -> bool:
        """Return whether a tolerance would be a distance in which the whole arm has room."""
        return self.arm.size < SMALL and goal.unit == 1.0

    def _in_unit(self, unit: float) -> "Solver":
        """The same arm, its lengths in another unit."""
        arm = arm_in_unit(self.arm, unit)
        return replace(
            self,
            arm=arm,
            closed_form=closed_form_of(arm),
            clear=None,
            locked=locked_arms_of(arm),
            box=box_in_unit(self.box, arm, unit),
        )

    def solve_goal(self, goal: Goal) -> InverseKinematics:
        """Return what `solve` does, of a target that was read already."""
        goal = self._measured(goal)
        if goal.unit != 1.0:
            return answer_from_unit(self._in_unit(goal.unit).solve_goal(goal_in_unit(goal)), self.arm, goal)
        answer = self._directly(goal)
        return self._searched(goal) if answer is None else answer

    def solve_directly(self, target: ArrayLike, tolerance: float | None = None) -> InverseKinematics | None:
        """Return what the closed form alone says, never long; None if it has no solution within the limits.

        None, too, where solutions may be of families, or others at the ends of valleys: both would have to be
        followed; and where one must have been lost.

        Arguments and refusals are those of `solve`.
        """
        goal = self.goal(target, tolerance, where=("target",))
        if goal.unit == 1.0:
            return self._at_once_or_alone(goal)
        answer = self._in_unit(goal.unit)._at_once_or_alone(goal_in_unit(goal))
        return None if answer is None else answer_from_unit(answer, self.arm, goal)

    def _at_once_or_alone(self, goal: Goal) -> InverseKinematics | None:
        """What `solve_directly` returns."""
        answer = self._at_once(goal)
        if answer is not None:
            return answer
        roots = self._roots(goal)
        if roots is None or in_valleys(self.arm, goal.pose, np.concatenate(roots), goal.tolerance).any():
            return None
        found, _ = roots
        alone, delicate = told_apart(self.arm, goal.pose, found, goal.tolerance)
        parts = [Component(found[i]) for i in alone]
        answer = None if delicate else self._answer_of(parts, goal, Method.CLOSED_FORM)
        return answer if answer is not None and answer.complete else None

    def _directly(self, goal: Goal) -> InverseKinematics | None:
        answer = self._at_once(goal)
        if answer is not None:
            return answer
        found = self._by_closed_form(goal)
        return None if found is None else self._answer(found, goal, Method.CLOSED_FORM)

    def _at_once(self, goal: Goal) -> InverseKinematics | None:
        """The result where nothing is near a singularity and a solution is within the limits."""
        found = None if self.clear is None else self.clear.solutions(goal.pose, goal.tolerance)
        if found is None:
            return None
        within = self._within_limits(found) if self.box.limited else found
        if not within:
            return None
        return InverseKinematics(
            status=IKStatus.SOLVED,
            complete=True,
            method=Method.CLOSED_FORM,
            solutions=tuple(within),
            outside_limits=len(found) - len(within),
            tolerance=goal.tolerance,
        )

    def _within_limits(self, solutions: list[IKSolution]) -> list[IKSolution]:
        """Those within the joint limits, the one with the smallest joint values first."""
        joints = np.array([one.joints for one in solutions])
        inside, fits = within_limits(joints, self.arm.revolute, self.box, self.arm.size)
        moved = zip(solutions, inside.tolist(), fits.tolist(), strict=True)
        within = [one._replace(joints=tuple(q)) for one, q, fit in moved if fit]
        return sorted(within, key=lambda one: sum(map(abs, one.joints)))

    def _roots(self, goal: Goal) -> tuple[Array, Array] | None:
        """Solutions by the closed form, if it answers for this target; and what it has tried in vain."""
        candidates = None if self.closed_form is None else self.closed_form.candidates(goal.pose)
        return None if candidates is None else refined(self.arm, candidates, goal.pose, goal.tolerance)

    def _by_closed_form(self, goal: Goal) -> Array | None:
        """Its solutions, with those that rounding has left out at the ends of valleys."""
        roots = self._roots(goal)
        if roots is None or self.arm.redundancy:
            return None if roots is None else roots[0]
        found, _ = roots
        ends = low_points(self.arm, goal.pose, np.concatenate(roots), goal.tolerance)
        return np.concatenate((found, solutions_of(self.arm, ends, goal.pose, goal.tolerance)))

    def _answer(
        self, joints: Array, goal: Goal, method: Method, outside: int = 0
    ) -> InverseKinematics | None:
        """The result for solutions without limits, of which some lie within them; None if none does."""
        parts = components_of(self.arm, goal.pose, joints, goal.tolerance)
        return self._answer_of(parts, goal, method, outside)

    def _answer_of(
        self, parts: list[Component], goal: Goal, method: Method, outside: int = 0
    ) -> InverseKinematics | None:
        """The same for the components that they belong to."""
        arm = self.arm
        alone = [part.joints for part in parts if not part.dimension]
        found: list[tuple[Array, Family | None]] = []
        whole = method is Method.CLOSED_FORM and len(alone) == len(parts) <= MOST_ISOLATED
        if alone:
            joints = np.array(alone)
            jacobians = arm.jacobians(arm.frames(joints)) * arm.units
            whole = whole and signs_cancel(arm, jacobians, goal.tolerance)
            settled = settled_on_folds(arm, goal.pose, joints, jacobians)
            inside, fits = within_limits(settled, arm.revolute, self.box, arm.size)
            found += [(q, None) for q in inside[fits]]
        follower = Follower(arm, goal.pose, goal.tolerance)
        continua = [part for part in parts if part.dimension]
        reached = len(found)
        for part in continua:
            within = families_within(arm, follower, part, self.box)
            reached += bool(within)
            found += within
        if not found:
            return None
        most = max((part.dimension for part in continua), default=0)
        return InverseKinematics(
            status=IKStatus.SINGULAR if most > arm.redundancy else IKStatus.SOLVED,
            complete=whole,
            method=method,
            solutions=told_solutions(arm, found, goal.pose),
            outside_limits=outside + len(parts) - reached,
            tolerance=goal.tolerance,
        )

    def _searched(self, goal: Goal) -> InverseKinematics:
        """The result of a search: solutions within the limits, outside them, or the nearest pose."""
        goal = goal._replace(tolerance=max(goal.tolerance, SEARCHED))
        known = self._by_closed_form(goal)
        method, outside = Method.SEARCH, 0
        if known is not None:
            method = Method.CLOSED_FORM
            parts = components_of(self.arm, goal.pose, known, goal.tolerance)
            answer = self._answer_of(parts, goal, method)
            if answer is not None:  # of a target that was rounded by a little more than it shows
                return answer
            outside = len(parts)
            if outside and not any(part.dimension for part in parts):
                jacobians = self.arm.jacobians(self.arm.frames(np.array([part.joints for part in parts])))
                all_there = signs_cancel(self.arm, jacobians * self.arm.units, goal.tolerance)
                method = method if all_there else Method.SEARCH
        freely = None
        if not outside and not (self.arm.redundancy and self.box.limited):
            freely = self._search(goal, Bounds.IGNORED)
            answer = self._answer(freely.solutions, goal, Method.SEARCH)
            if answer is not None:
                return answer
            outside = len(components_of(self.arm, goal.pose, freely.solutions, goal.tolerance))
            method = Method.SEARCH if outside else method
            if not self.box.limited:
                return unreachable(self.arm, self.box, goal, freely.nearest, 0, method)
        return self._search_within_limits(goal, outside, method)

    def _search(self, goal: Goal, bounds: Bounds) -> SearchResult:
        near = None
        if self.locked is not None:
            near = self.locked.starts(goal.pose)
        elif self.closed_form is not None and self.closed_form.candidates(goal.pose) is None:
            beside = candidates_beside(self.closed_form, self.arm, goal.pose)
            near = solutions_of(self.arm, beside, goal.pose, goal.tolerance)
        if near is not None and bounds is Bounds.KEPT:
            near, _ = within_limits(near, self.arm.revolute, self.box, self.arm.size)
        return search(self.arm, goal.pose, self.box, bounds, goal.tolerance, near)

    def _search_within_limits(self, goal: Goal, outside: int, method: Method) -> InverseKinematics:
        """The result where no solution is known within the limits: look there, or report the nearest pose."""
        found = self._search(goal, Bounds.KEPT)
        answer = self._answer(found.solutions, goal, Method.SEARCH, outside)
        if answer is not None:
            return answer
        if not outside and self.arm.redundancy:
            freely = self._search(goal, Bounds.IGNORED)
            outside = len(components_of(self.arm, goal.pose, freely.solutions, goal.tolerance))
        return unreachable(self.arm, self.box, goal, found.nearest, outside, method)
