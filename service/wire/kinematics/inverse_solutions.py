"""Inverse kinematics between the wire and the domain."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from kinematics.errors import Fault
from kinematics.inverse import ArmReach, IKSolution, InverseKinematics, NearestPose, Solver, solver_of
from kinematics.inverse.results import Family
from kinematics.table import NumericTable
from service.http.languages import language_of
from service.http.routing import ApiRequest, BytesResponse
from service.schemas.kinematics.inverse_kinematics import (
    MOST_TARGETS,
    FamilyParameterModel,
    InverseKinematicsAnswer,
    InverseKinematicsAnswers,
    Nearest,
    NumericInverseKinematicsRequest,
    Solution,
    SolutionFamily,
    TargetAnswer,
)
from service.schemas.kinematics.robot_question import DomainLimits, domain_limits
from service.wire.fault_pointers import fault_entries, traced
from service.wire.json_chunks import plain_lists
from service.wire.kinematics.joint_values import in_request_units, values_in_radians
from service.wire.kinematics.pose_matrices import base_and_tool, placed_matrix, pose_matrix
from service.wire.kinematics.prepared_chains import PreparedChain
from service.wire.kinematics.prepared_robots import PreparedRobot
from service.work.allotted_time import each_in_time
from service.work.threads import in_thread
from service.work.workers import Lane, Workers

Matrix: TypeAlias = Any

InUnits: TypeAlias = PreparedRobot | PreparedChain  # What knows the units of the request that it came with.
ALLOTTED = 0.8
"""Part of a task's processor time in which many targets are answered: what is left is for the kernel's own
time, and for sending."""


async def solved(
    request: NumericInverseKinematicsRequest, robot: PreparedRobot, workers: Workers
) -> InverseKinematicsAnswer:
    """Return the joint values that reach a target.

    Raises:
        KinematicsError: malformed limits or poses, or a table that inverse kinematics does not take.
        ServiceError: as `answer_to`.
    """
    with traced(request):
        answer = await answer_to(_question(request, robot), workers)
    return InverseKinematicsAnswer(**robot.units, **target_answer(answer, robot))


async def solved_each(
    request: NumericInverseKinematicsRequest, robot: PreparedRobot, api: ApiRequest
) -> BytesResponse:
    """Return the joint values that reach each of many targets, all in one worker process.

    Targets that its time does not reach to are unanswered, each with a fault that says so. To read and write
    a thousand takes a tenth of a second: in a thread, so that others are served meanwhile.

    Raises:
        KinematicsError: as `solved`, of a target at its place.
        ServiceError: no place for the task, or not one target was answered in time.
    """
    asked = await api.in_thread(partial(_many_targets, request, robot))
    seconds = api.settings.symbolic_seconds
    answers = await api.resources.workers.run(
        Lane.SLOW, _solve_each, asked.question, asked.targets, ALLOTTED * seconds
    )
    return await api.in_thread(partial(_written, asked, answers, robot, seconds, language_of(api)))


class _ManyTargets(NamedTuple):
    """Many targets for one arm."""

    question: "TargetQuestion"
    solver: Solver
    targets: list[Matrix]


def _many_targets(request: NumericInverseKinematicsRequest, robot: PreparedRobot) -> _ManyTargets:
    with traced(request):
        question = _question(request, robot)
        targets = [
            pose_matrix(pose, robot.angle, "targets", i) for i, pose in enumerate(request.targets or [])
        ]
        solver = question.solver()
        for i, target in enumerate(targets):
            solver.goal(target, question.tolerance, where=("targets", i))
    return _ManyTargets(question, solver, targets)


def _written(
    asked: _ManyTargets,
    answers: Sequence[InverseKinematics],
    robot: PreparedRobot,
    seconds: float,
    language: str,
) -> BytesResponse:
    question, solver, targets = asked
    told = InverseKinematicsAnswers(
        **robot.units,
        answers=[
            *(TargetAnswer(**target_answer(answer, robot)) for answer in answers),
            *(_unanswered(solver, target, question.tolerance) for target in targets[len(answers) :]),
        ],
        faults=fault_entries(
            [
                Fault.at("target_unanswered", "targets", i, answered=len(answers), seconds=round(seconds, 3))
                for i in range(len(answers), len(targets))
            ],
            language,
            MOST_TARGETS,
        ),
    )
    return BytesResponse(told.model_dump_json(by_alias=True, exclude_none=True).encode())


def _unanswered(solver: Solver, target: Matrix, tolerance: float | None) -> TargetAnswer:
    """What stands in the place of an answer that was not reached in time."""
    return TargetAnswer(
        status="unanswered",
        complete=False,
        solutions=[],
        outside_limits=0,
        tolerance=solver.goal(target, tolerance, where=()).tolerance,
    )


@dataclass(frozen=True, kw_only=True, slots=True)
class TargetQuestion:
    """What is asked, in domain units; it can go to another process."""

    table: NumericTable
    target: Matrix
    reach: ArmReach = ArmReach.POSE
    base: Matrix | None = None
    tool: Matrix | None = None
    limits: DomainLimits | None = None
    tolerance: float | None = None
    start: list[float] | None = None

    def solver(self) -> Solver:
        """Return the arm made ready."""
        return solver_of(self.table, base=self.base, tool=self.tool, limits=self.limits, reach=self.reach)


def _question(request: NumericInverseKinematicsRequest, robot: PreparedRobot) -> TargetQuestion:
    base, tool = base_and_tool(request, robot.angle)
    if request.targets is not None:
        target, reach = None, ArmReach.POSE
    elif request.position is None:
        target, reach = pose_matrix(request.target or [], robot.angle, "target"), ArmReach.POSE
    else:
        target = placed_matrix(request.position, request.quaternion, request.axis)
        free = ArmReach.POSITION if request.axis is None else ArmReach.AXIS
        reach = ArmReach.POSE if request.quaternion is not None else free
    return TargetQuestion(
        table=robot.table,
        target=target,
        reach=reach,
        base=base,
        tool=tool,
        limits=domain_limits(request.limits, robot.joint_units),
        tolerance=request.tolerance,
        start=None if request.start is None else values_in_radians(request.start, robot.joint_units, "start"),
    )


async def answer_to(question: TargetQuestion, workers: Workers) -> InverseKinematics:
    """Return the solutions: a closed form gives them at once; a worker process searches, or follows families.

    Those of a question with a start are sorted by their distance from it.

    Raises:
        KinematicsError: malformed limits or poses, or a table that inverse kinematics does not take.
        ServiceError: no place in the lane, or it took too long.
    """
    answer = await in_thread(_directly, question)
    return await workers.run(Lane.SLOW, _solve, question) if answer is None else answer


def _directly(question: TargetQuestion) -> InverseKinematics | None:
    """Solve by the closed form alone; None if a search is needed. Refusals are made here, not in a worker."""
    solver = question.solver()
    answer = solver.solve_directly(question.target, question.tolerance)
    return None if answer is None else solver.nearest_first(answer, question.start)


def _solve(question: TargetQuestion) -> InverseKinematics:
    """Solve for one target; runs in a worker process."""
    solver = question.solver()
    return solver.nearest_first(solver.solve(question.target, question.tolerance), question.start)


def _solve_each(
    question: TargetQuestion, targets: Sequence[Matrix], seconds: float
) -> list[InverseKinematics]:
    """Solve for as many targets as the processor time allows, in order; runs in a worker process."""
    solver = question.solver()
    return each_in_time(
        lambda target: solver.nearest_first(solver.solve(target, question.tolerance), question.start),
        targets,
        seconds,
    )


def target_answer(answer: InverseKinematics, robot: InUnits) -> dict[str, Any]:
    """Return what an answer says of one target, in the units of the request."""
    nearest = answer.nearest
    return {
        "status": answer.status,
        "complete": answer.complete,
        "method": answer.method,
        "solutions": [
            Solution(
                **_reached(solution, robot),
                isolation=solution.isolation,
                family=None if solution.family is None else _family(solution.family, robot),
            )
            for solution in answer.solutions
        ],
        "nearest": None
        if nearest is None
        else Nearest(**_reached(nearest, robot), transform=plain_lists(nearest.transform), size=nearest.size),
        "reason": answer.reason,
        "outside_limits": answer.outside_limits,
        "tolerance": answer.tolerance,
    }


def _family(family: Family, robot: InUnits) -> SolutionFamily:
    units = robot.joint_units
    parameter = family.parameters[0].joint - 1 if family.parameters else 0
    return SolutionFamily(
        dimension=family.dimension,
        parameters=[
            FamilyParameterModel(
                joint=one.joint,
                interval=[one.least / units[one.joint - 1], one.greatest / units[one.joint - 1]],
                full_turn=one.full_turn,
            )
            for one in family.parameters
        ],
        direction=None
        if family.direction is None
        else [way * units[parameter] / unit + 0.0 for way, unit in zip(family.direction, units, strict=True)],
        members=[in_request_units(member, robot.joint_units) for member in family.members],
    )


def _reached(found: IKSolution | NearestPose, robot: InUnits) -> dict[str, Any]:
    return {
        "joints": in_request_units(found.joints, robot.joint_units),
        "residual": float(np.hypot(found.position_error, found.orientation_error)),
        "position_error": found.position_error,
        "orientation_error": found.orientation_error / robot.angle,
    }
