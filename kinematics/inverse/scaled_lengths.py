"""Arms, targets and answers in another unit of length: in which a distance counts as much as an angle."""

from dataclasses import replace

import numpy as np

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.goals import Goal
from kinematics.inverse.results import Family, IKSolution, InverseKinematics, NearestPose
from kinematics.inverse.search import Box
from kinematics.se3 import Transform


def goal_in_unit(goal: Goal) -> Goal:
    """Return a goal with its lengths in its own unit."""
    return Goal(pose_in_unit(goal.pose, goal.unit), goal.tolerance / goal.unit)


def pose_in_unit(pose: Transform, unit: float) -> Transform:
    """Return a pose with its position divided by a unit."""
    scaled = pose.copy()
    scaled[..., :3, 3] /= unit
    return scaled


def arm_in_unit(arm: Arm, unit: float) -> Arm:
    """Return an arm with its lengths divided by a unit."""
    constants = pose_in_unit(arm.constants, unit)
    return replace(
        arm,
        constants=constants,
        size=arm.size / unit,
        sliding=arm.sliding / unit,
        rounding=arm.rounding / unit,
    )


def box_in_unit(box: Box, arm: Arm, unit: float) -> Box:
    """Return limits with those of slides divided by a unit."""
    factors = _factors(arm, unit)
    return Box(box.low / factors, box.high / factors)


def answer_from_unit(answer: InverseKinematics, arm: Arm, goal: Goal) -> InverseKinematics:
    """Return an answer that was found in the unit of a goal with its lengths multiplied by it."""
    factors, unit = _factors(arm, goal.unit), goal.unit
    return answer._replace(
        solutions=tuple(_solution(one, factors, unit) for one in answer.solutions),
        nearest=None if answer.nearest is None else _nearest(answer.nearest, factors, unit),
        tolerance=goal.tolerance,
    )


def _factors(arm: Arm, unit: float) -> Array:
    return np.where(arm.revolute, 1.0, unit)


def _scaled(values: tuple[float, ...], factors: Array) -> tuple[float, ...]:
    return tuple((np.array(values) * factors).tolist())


def _solution(solution: IKSolution, factors: Array, unit: float) -> IKSolution:
    return solution._replace(
        joints=_scaled(solution.joints, factors),
        position_error=solution.position_error * unit,
        family=None if solution.family is None else _family(solution.family, factors),
    )


def _family(family: Family, factors: Array) -> Family:
    each = [float(factors[one.joint - 1]) for one in family.parameters]
    return replace(
        family,
        parameters=tuple(
            replace(one, least=one.least * factor, greatest=one.greatest * factor)
            for one, factor in zip(family.parameters, each, strict=True)
        ),
        direction=None if family.direction is None else _scaled(family.direction, factors / each[0]),
        members=tuple(_scaled(member, factors) for member in family.members),
    )


def _nearest(nearest: NearestPose, factors: Array, unit: float) -> NearestPose:
    return replace(
        nearest,
        joints=_scaled(nearest.joints, factors),
        transform=pose_in_unit(nearest.transform, 1.0 / unit),
        position_error=nearest.position_error * unit,
        size=nearest.size * unit,
    )
