"""POST /scm/inverse-kinematics and POST /scm/random-configuration: joint values of SCM chains."""

from collections.abc import Sequence
from functools import partial
from typing import Annotated, Any, TypeAlias

from pydantic import Field

from kinematics.errors import Fault, JointValueError
from kinematics.scm import default_limits, random_configurations, table_of_chain
from kinematics.table import bind
from service.http.calls import CallRouter
from service.http.routing import ApiRequest, OneRobotRoute
from service.schemas.base import LONGEST_LIST, WHOLE, Real
from service.schemas.kinematics.inverse_kinematics import InverseKinematicsAnswer
from service.schemas.kinematics.robot_question import PoseInput, domain_limits
from service.schemas.kinematics.scm import ChainQuestion, ScmJoints
from service.schemas.tables import Units, units_of
from service.wire.fault_pointers import traced
from service.wire.kinematics.inverse_solutions import TargetQuestion, answer_to, target_answer
from service.wire.kinematics.joint_values import in_request_units, values_in_radians
from service.wire.kinematics.pose_matrices import pose_matrix
from service.wire.kinematics.prepared_chains import PreparedChain, prepared_chain

router = CallRouter("scm", route_class=OneRobotRoute)

LimitPair: TypeAlias = Annotated[list[Real | None], Field(min_length=2, max_length=2)]


class ScmInverseKinematicsRequest(ChainQuestion):
    """A chain, and a pose to reach."""

    target: PoseInput
    limits: list[LimitPair | None] | None = Field(
        None, max_length=LONGEST_LIST, description="[low, high] of every joint, null where there is none"
    )
    start: ScmJoints | None = Field(
        None, description="joint values; the solution nearest to them comes first"
    )


class RandomConfigurationRequest(ChainQuestion):
    """A chain, and how many configurations are wanted."""

    limits: list[Annotated[list[Real], Field(min_length=2, max_length=2)] | None] | None = Field(
        None,
        max_length=LONGEST_LIST,
        description="[low, high] of every joint; null or left out: a full turn, and 0 to the sum of lengths",
    )
    count: Annotated[int, Field(ge=1, le=10_000), WHOLE] = Field(1, description="how many configurations")
    seed: Annotated[int, Field(ge=0, le=2**53), WHOLE] | None = Field(
        None, description="the same seed gives the same values"
    )


class RandomConfigurationAnswer(Units):
    """Joint values, drawn evenly within the limits."""

    joints: list[Real] = Field(description="the first configuration")
    configurations: list[list[Real]] = Field(description="all of them")
    limits: list[list[Real]] = Field(description="[low, high] of every joint, as used")


@router.call("/scm/inverse-kinematics", "Inverse kinematics of an SCM chain", exclude_none=True)
async def inverse_kinematics(
    body: ScmInverseKinematicsRequest, request: ApiRequest
) -> InverseKinematicsAnswer:
    """Return the joint values at which the tool reaches a pose: scm(manipulator, target, origin) and ik2q.

    All solutions where there is a closed form; joint values in the chain's angle unit.
    """
    prepared = await request.in_turn(partial(prepared_chain, body, request.settings.cell_limits))
    if body.limits is not None:
        _refuse_length(body.limits, prepared)
    start = None if body.start is None else values_in_radians(body.start, prepared.joint_units, "start")
    with traced(body):
        question = TargetQuestion(
            table=bind(table_of_chain(prepared.chain), prepared.values),
            target=pose_matrix(body.target, prepared.angle, "target"),
            limits=domain_limits(body.limits, prepared.joint_units),
            start=start,
        )
        found = await answer_to(question, request.resources.workers)
    return InverseKinematicsAnswer(**units_of(prepared.read), **target_answer(found, prepared))


@router.call("/scm/random-configuration", "Random joint values for an SCM chain")
async def random_configuration(
    body: RandomConfigurationRequest, request: ApiRequest
) -> RandomConfigurationAnswer:
    """Return joint values drawn evenly within limits: qrand of the toolbox."""
    prepared = await request.in_turn(partial(prepared_chain, body, request.settings.cell_limits))
    default = default_limits(prepared.chain, prepared.values)
    low, high = (in_request_units([pair[end] for pair in default], prepared.joint_units) for end in (0, 1))
    given = [None] * len(default) if body.limits is None else body.limits
    _refuse_length(given, prepared)
    limits = [pair or list(ends) for pair, *ends in zip(given, low, high, strict=True)]
    drawn = random_configurations([(low, high) for low, high in limits], count=body.count, seed=body.seed)
    configurations: list[list[float]] = drawn.tolist()
    return RandomConfigurationAnswer(
        **units_of(prepared.read), joints=configurations[0], configurations=configurations, limits=limits
    )


def _refuse_length(limits: Sequence[Any], prepared: PreparedChain) -> None:
    n = prepared.chain.n_joints
    if len(limits) != n:
        raise JointValueError(Fault.at("limits_wrong_length", "limits", expected=n, given=len(limits)))
