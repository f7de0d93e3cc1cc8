"""Inverse kinematics between the wire and the domain."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from anyio.to_thread import run_sync

from kinematics.inverse import IKSolution, InverseKinematics, NearestPose, inverse_kinematics, solver_of
from kinematics.inverse.results import Family
from kinematics.table import NumericTable
from service.schemas.inverse_kinematics import (
    FamilyParameter,
    InverseKinematicsAnswer,
    InverseKinematicsRequest,
    Nearest,
    Solution,
    SolutionFamily,
)
from service.schemas.joint_limits import DomainLimits, domain_limits
from service.wire.fault_pointers import traced
from service.wire.prepared_robots import Robot
from service.work.workers import Lane, Workers

Matrix: TypeAlias = list[list[float]]


async def solved(
    request: InverseKinematicsRequest, robot: Robot, workers: Workers
) -> InverseKinematicsAnswer:
    """The joint values that reach a target: by a closed form at once, else by a search in a worker process.

    Raises:
        KinematicsError: malformed limits or poses, or a table that inverse kinematics does not take.
        ServiceError: no place for a search, or it took too long.
    """
    ranges = domain_limits(request.limits, robot.joint_units)
    question = (robot.table, request.target, request.base, request.tool, ranges, request.tolerance)
    with traced(request):
        answer = await run_sync(_directly, *question)
    if answer is None:
        answer = await workers.run(Lane.SLOW, _search, *question)
    return _answer(answer, robot)


def _directly(
    table: NumericTable,
    target: Matrix,
    base: Matrix | None,
    tool: Matrix | None,
    ranges: DomainLimits | None,
    tolerance: float | None,
) -> InverseKinematics | None:
    """What the closed form alone says, in a thread; every refusal is made here, none in a worker."""
    return solver_of(table, base=base, tool=tool, limits=ranges).solve_directly(target, tolerance)


def _search(
    table: NumericTable,
    target: Matrix,
    base: Matrix | None,
    tool: Matrix | None,
    ranges: DomainLimits | None,
    tolerance: float | None,
) -> InverseKinematics:
    """What a worker process does."""
    return inverse_kinematics(table, target, base=base, tool=tool, limits=ranges, tolerance=tolerance)


def _answer(answer: InverseKinematics, robot: Robot) -> InverseKinematicsAnswer:
    nearest = answer.nearest
    return InverseKinematicsAnswer(
        angle_unit=robot.read.angle_unit.value,
        length_unit=robot.read.length_unit.value,
        status=answer.status,
        complete=answer.complete,
        method=answer.method,
        solutions=[
            Solution(
                **_reached(solution, robot),
                isolation=solution.isolation,
                family=None if solution.family is None else _family(solution.family, robot),
            )
            for solution in answer.solutions
        ],
        nearest=None if nearest is None else _nearest(nearest, robot),
        reason=answer.reason,
        outside_limits=answer.outside_limits,
        tolerance=answer.tolerance,
    )


def _family(family: Family, robot: Robot) -> SolutionFamily:
    units = robot.joint_units
    parameter = family.parameters[0].joint - 1 if family.parameters else 0
    return SolutionFamily(
        dimension=family.dimension,
        parameters=[
            FamilyParameter(
                joint=one.joint,
                interval=[one.least / units[one.joint - 1], one.greatest / units[one.joint - 1]],
                full_turn=one.full_turn,
            )
            for one in family.parameters
        ],
        direction=None
        if family.direction is None
        else [way * units[parameter] / unit + 0.0 for way, unit in zip(family.direction, units, strict=True)],
        members=[_in_units(member, robot) for member in family.members],
    )


def _nearest(nearest: NearestPose, robot: Robot) -> Nearest:
    return Nearest(**_reached(nearest, robot), transform=(nearest.transform + 0.0).tolist())


def _reached(found: IKSolution | NearestPose, robot: Robot) -> dict[str, Any]:
    return {
        "joints": _in_units(found.joints, robot),
        "residual": float(np.hypot(found.position_error, found.orientation_error)),
        "position_error": found.position_error,
        "orientation_error": found.orientation_error / robot.angle,
    }


def _in_units(joints: Sequence[float], robot: Robot) -> list[float]:
    return [value / unit + 0.0 for value, unit in zip(joints, robot.joint_units, strict=True)]
