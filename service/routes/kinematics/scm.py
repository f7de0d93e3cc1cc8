"""The SCM toolbox: direct and inverse kinematics, Jacobians, random configurations."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Annotated, Any

from kinematics.errors import Fault, JointValueError
from kinematics.jacobian import JacobianFrame
from kinematics.poses import pose_notations
from kinematics.scm import (
    ScmKinematics,
    default_limits,
    forward_kinematics_scm,
    jacobian_base_by_inspection,
    jacobian_end_by_inspection,
    jacobian_numbers_by_differentiation,
    random_configurations,
    table_of_chain,
    unit_vectors,
)
from kinematics.se3 import inverse_transform
from kinematics.table import bind
from service.http.openapi import body_with, problems
from service.http.routing import ApiRequest, BytesResponse, OneRobotRoute, api_router
from service.schemas.kinematics import scm as wire
from service.schemas.kinematics import scm_examples as examples
from service.schemas.kinematics.forward_kinematics import AxisAngleModel, Orientation
from service.schemas.kinematics.inverse_kinematics import InverseKinematicsAnswer
from service.schemas.kinematics.joints import domain_limits
from service.schemas.kinematics.scm_products import ScmProductsAnswer, ScmProductsRequest
from service.wire.fault_pointers import traced
from service.wire.json_chunks import plain_lists
from service.wire.kinematics.chain_forms import ChainTask, Wanted, is_quick, written_chain
from service.wire.kinematics.inverse_solutions import TargetQuestion, answer_to, target_answer
from service.wire.kinematics.joint_values import in_request_units, values_in_radians
from service.wire.kinematics.motion_products import products_task, written_products
from service.wire.kinematics.pose_matrices import pose_matrix
from service.wire.kinematics.prepared_chains import PreparedChain, prepared_chain, written_structure
from service.work.workers import Lane

router = api_router("scm", route_class=OneRobotRoute)


@router.post(
    "/scm/forward-kinematics",
    response_model=wire.ScmForwardKinematicsAnswer,
    response_model_exclude_none=True,
    responses=problems(503),
    summary="Direct kinematics of an SCM chain",
)
async def forward_kinematics(
    body: Annotated[wire.ScmForwardKinematicsRequest, body_with(examples.FORWARD_KINEMATICS)],
    request: ApiRequest,
) -> wire.ScmForwardKinematicsAnswer | BytesResponse:
    """Return ⁰H_FT, every H_i and every frame: scm(manipulator, 0) of the toolbox.

    With `joints` in numbers, without them in closed form.
    """
    if body.joints is None:
        return await _closed(body, Wanted.FORWARD_KINEMATICS, request)
    prepared, motion = await _moved(body, body.joints, request)
    return wire.ScmForwardKinematicsAnswer(
        **prepared.units,
        transform=plain_lists(motion.transform),
        links=plain_lists(motion.links),
        frames=plain_lists(motion.frames),
        end=plain_lists(motion.end),
        orientation=_orientation(motion.transform, prepared.angle),
    )


@router.post(
    "/scm/inverse-transform",
    response_model=wire.ScmInverseTransformAnswer,
    response_model_exclude_none=True,
    responses=problems(503),
    summary="Inverse of the direct kinematics of an SCM chain",
)
async def inverse_of_transform(
    body: Annotated[wire.ScmInverseTransformRequest, body_with(examples.INVERSE_TRANSFORM)],
    request: ApiRequest,
) -> wire.ScmInverseTransformAnswer | BytesResponse:
    """Return the pose of frame 0 in the tool: scm(manipulator, -1) of the toolbox.

    With `joints` in numbers, without them in closed form.
    """
    if body.joints is None:
        return await _closed(body, Wanted.INVERSE_TRANSFORM, request)
    prepared, motion = await _moved(body, body.joints, request)
    inverse = inverse_transform(motion.transform)
    return wire.ScmInverseTransformAnswer(**prepared.units, transform=plain_lists(inverse))


@router.post(
    "/scm/jacobian",
    response_model=wire.ScmJacobianAnswer,
    response_model_exclude_none=True,
    responses=problems(503),
    summary="J0 and Jn of an SCM chain",
)
async def jacobian(
    body: Annotated[wire.ScmJacobianRequest, body_with(examples.JACOBIAN)], request: ApiRequest
) -> wire.ScmJacobianAnswer | BytesResponse:
    """Return J0 and Jn, by inspection (scm(manipulator, 1) and 2) or by differentiating the matrix (h2j).

    With `joints` in numbers, without them in closed form.
    """
    inspected = body.method is wire.JacobianMethod.INSPECTION
    wanted = Wanted.INSPECTED_JACOBIANS if inspected else Wanted.DIFFERENTIATED_JACOBIANS
    if body.joints is None:
        return await _closed(body, wanted, request)
    prepared = await _prepared(body, request)
    joints = values_in_radians(body.joints, prepared.joint_units, "joints")
    if inspected:
        base = jacobian_base_by_inspection(prepared.chain, joints, prepared.values)
        end = jacobian_end_by_inspection(prepared.chain, joints, prepared.values)
    else:
        base, end = (
            jacobian_numbers_by_differentiation(prepared.chain, joints, prepared.values, frame)
            for frame in (JacobianFrame.BASE, JacobianFrame.END)
        )
    return wire.ScmJacobianAnswer(
        **prepared.units,
        method=body.method,
        J0=plain_lists(base),
        Jn=plain_lists(end),
        unit_vectors=plain_lists(unit_vectors(prepared.chain, prepared.values)),
    )


@router.post(
    "/scm/inverse-kinematics",
    response_model_exclude_none=True,
    responses=problems(503),
    summary="Inverse kinematics of an SCM chain",
)
async def inverse_kinematics(
    body: Annotated[wire.ScmInverseKinematicsRequest, body_with(examples.INVERSE_KINEMATICS)],
    request: ApiRequest,
) -> InverseKinematicsAnswer:
    """Return the joint values at which the tool reaches a pose: scm(manipulator, target, origin) and ik2q.

    All solutions where there is a closed form; joint values in the chain's angle unit.
    """
    prepared = await _prepared(body, request)
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
    return InverseKinematicsAnswer(**prepared.units, **target_answer(found, prepared))


@router.post(
    "/scm/random-configuration", responses=problems(503), summary="Random joint values for an SCM chain"
)
async def random_configuration(
    body: Annotated[wire.RandomConfigurationRequest, body_with(examples.RANDOM_CONFIGURATION)],
    request: ApiRequest,
) -> wire.RandomConfigurationAnswer:
    """Return joint values drawn evenly within limits: qrand of the toolbox."""
    prepared = await _prepared(body, request)
    default = default_limits(prepared.chain, prepared.values)
    low, high = (in_request_units([pair[end] for pair in default], prepared.joint_units) for end in (0, 1))
    given = [None] * len(default) if body.limits is None else body.limits
    _refuse_length(given, prepared)
    limits = [pair or list(ends) for pair, *ends in zip(given, low, high, strict=True)]
    drawn = random_configurations([(low, high) for low, high in limits], count=body.count, seed=body.seed)
    configurations: list[list[float]] = drawn.tolist()
    return wire.RandomConfigurationAnswer(
        **prepared.units,
        joints=configurations[0],
        configurations=configurations,
        limits=limits,
    )


@router.post(
    "/scm/products",
    response_model=ScmProductsAnswer,
    response_model_exclude_none=True,
    responses=problems(503),
    summary="Products of motions, compared",
)
async def products(
    body: Annotated[ScmProductsRequest, body_with(examples.PRODUCTS)], request: ApiRequest
) -> BytesResponse:
    """Multiply motions and matrices: HRX … HTZ, GEO, SCZIP, S2D and H2J of the toolbox.

    Each product is formed exactly, written, evaluated if everything in it has a value, and
    compared with the first as a function. This shows that translations along an axis and rotations about it
    commute (eq. 2.10 to 2.12), and that other motions do not.
    """
    task = await request.in_turn(partial(products_task, body, request.settings.cell_limits))
    return BytesResponse(await request.resources.workers.run(Lane.SLOW, written_products, task))


async def _closed(body: wire.ClosedFormQuestion, wanted: Wanted, request: ApiRequest) -> BytesResponse:
    """The answer in closed form, from a worker process."""
    read = await request.in_turn(partial(written_structure, body, request.settings.cell_limits))
    task = ChainTask.of(read, wanted, body.formats, body.notation)
    lane = Lane.QUICK if is_quick(read.chain) else Lane.SLOW
    return BytesResponse(await request.resources.workers.run(lane, written_chain, task))


async def _prepared(body: wire.ChainQuestion, request: ApiRequest) -> PreparedChain:
    return await request.in_turn(partial(prepared_chain, body, request.settings.cell_limits))


async def _moved(
    body: wire.ClosedFormQuestion, joints: list[float], request: ApiRequest
) -> tuple[PreparedChain, ScmKinematics]:
    """The chain, and its forward kinematics in numbers."""
    prepared = await _prepared(body, request)
    q = values_in_radians(joints, prepared.joint_units, "joints")
    return prepared, forward_kinematics_scm(prepared.chain, q, prepared.values)


def _orientation(transform: Any, angle: float) -> Orientation:
    position, quaternion, rpy, (axis, turn), _ = pose_notations(transform)
    roll, pitch, yaw = (value / angle for value in rpy)
    return Orientation(
        quaternion=list(quaternion),
        rpy=[roll, pitch, yaw],
        axis_angle=AxisAngleModel(axis=list(axis), angle=turn / angle),
        xyzabc=[*position, yaw, pitch, roll],
    )


def _refuse_length(limits: Sequence[Any], prepared: PreparedChain) -> None:
    n = prepared.chain.n_joints
    if len(limits) != n:
        params = {"expected": n, "given": len(limits)}
        raise JointValueError(Fault.at("limits_wrong_length", "limits", **params))
