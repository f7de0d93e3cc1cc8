"""Is a matrix that depends on the joint variables the ⁰T_N of the robot, whatever frames it was written in?

T(q) of a serial chain is sinusoidal in every angle and linear in every slide, so its derivatives at q = 0
are exact differences, and they are the joint screws: S_i = ∂T/∂q_i · T⁻¹. The chain with these screws is
compared with T itself, then with the robot as any table's would be (`kinematics.equivalence`).
"""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial, reduce

import numpy as np

from exercises.parts.cells.comparison import agreeing, is_doubled, is_rigid
from exercises.parts.cells.exactness import EITHER_WAY
from exercises.parts.cells.matrix_cells import CellMatrix, read_matrix
from exercises.parts.cells.mixed_lengths import other_lengths
from exercises.parts.cells.symbolic_matrix import SymbolicMatrix
from exercises.parts.context import Context, twice_as_long
from exercises.parts.samples import Samples
from kinematics.chain import Axis, Chain, chain_of_axes
from kinematics.equivalence import Tolerance
from kinematics.equivalence.decision import is_certified
from kinematics.equivalence.reference import prepared
from kinematics.errors import ParameterError
from kinematics.se3 import ORIGIN, Floats, cross_arrays, from_matrix, inverse_transform, scale, triple
from kinematics.table import JointType, NumericTable, bind

PosesOf = Callable[[Floats], Floats]  # (k, 4, 4) ⁰T_N of (k, n) configurations.
PosesAt = Callable[[Mapping[str, float], Floats], Floats]
"""The same for values of the names [rad, the student's unit]."""


@np.errstate(all="ignore")
def is_robot(context: Context, matrices: Sequence[SymbolicMatrix]) -> bool:
    """Return whether a product of matrices is a ⁰T_N that describes the robot and keeps the policy.

    It does at the exercise's values and, if it and the key name all lengths, or it names some and none that
    stands in numbers, at others, too: what is named wrong is wrong, whatever a student was given.

    Args:
        context: the key, the policy, the units.
        matrices: from the base to the end, with lengths in the student's unit.
    """
    names = frozenset[str]().union(*(matrix.names() for matrix in matrices))

    def poses_at(values: Mapping[str, float], joints: Floats) -> Floats:
        samples = Samples(((values, joints),))
        return reduce(np.matmul, [matrix.at_points(samples) for matrix in matrices])

    if context.joint_types != context.reference.table.joint_types:
        return False
    values = context.values(names)
    if not _is_robot_at(context, partial(poses_at, values), context.reference_numbers):
        return False
    if not names & set(context.parameters):
        return True
    if not _names_lengths(context, poses_at, values):
        mixed = other_lengths(context, matrices, values)
        key = None if mixed is None else _key_at(context, mixed[0])
        if mixed is None or key is None:
            return True
        tolerance = replace(context.policy.tolerance, length=mixed[1])
        return _is_robot_at(context, partial(poses_at, mixed[0]), key, tolerance)
    for other in context.draws(names):
        key = _key_at(context, other)
        if key is not None:
            usual = context.policy.tolerance
            samples = Samples(((other, context.configurations(context.joint_types)),))
            typed = sum(matrix.typed_share(samples, context.size) for matrix in matrices)
            tolerance = replace(usual, length=min(usual.length, EITHER_WAY * typed))
            return _is_robot_at(context, partial(poses_at, other), key, tolerance)
    return True


def reads_as_robot(context: Context, matrices: Sequence[CellMatrix]) -> bool:
    """Return whether matrices, as they are typed, are a ⁰T_N of the robot; see `is_robot`.

    Raises:
        CellError: they cannot be read.
    """
    return is_robot(
        context, [read_matrix(cells, context.joint_types, context.angle_unit, ()) for cells in matrices]
    )


def _key_at(context: Context, values: Mapping[str, float]) -> NumericTable | None:
    """The key with other values [rad, the student's unit], in the exercise's unit; None if one has none."""
    try:
        return bind(context.reference.table, context.scaled(values, 1.0 / context.unit_ratio))
    except ParameterError:
        return None


def _names_lengths(context: Context, poses_at: PosesAt, values: Mapping[str, float]) -> bool:
    """Whether a ⁰T_N and the key name every length: both are twice as large with twice the lengths."""
    slides = [type_ is JointType.PRISMATIC for type_ in context.joint_types]
    joints = context.configurations(context.joint_types)[:1]
    twice = context.scaled(values, 2.0)
    once, larger = poses_at(values, joints), poses_at(twice, np.where(slides, 2.0, 1.0) * joints)
    larger_key = _key_at(context, twice)
    return (
        is_doubled(once, larger, context.size)
        and larger_key is not None
        and twice_as_long(context.reference_numbers, larger_key)
    )


def _is_robot_at(
    context: Context, poses_of: PosesOf, key: NumericTable, tolerance: Tolerance | None = None
) -> bool:
    joint_types, usual = context.joint_types, context.policy.tolerance
    chain = chain_of_poses(poses_of, joint_types, usual, context.size)
    if chain is None:
        return False
    samples = context.configurations(joint_types)
    tolerance = tolerance or usual
    if not agreeing(poses_of(samples), chain.poses(samples), context.size, tolerance).all():
        return False
    in_units = scaled_chain(chain, 1.0 / context.unit_ratio)
    return is_certified([prepared(key)], [in_units], replace(context.policy, tolerance=tolerance))


def chain_of_poses(
    poses_of: PosesOf, joint_types: Sequence[JointType], tolerance: Tolerance, size: float
) -> Chain | None:
    """Return the joint axes of a ⁰T_N at q = 0; None if it is not a serial chain's.

    The size is the robot's, in the unit of the poses; the tolerance, how far derivatives may be from joint
    screws.
    """
    n = len(joint_types)
    steps = np.diag([math.pi / 2 if joint_type is JointType.REVOLUTE else size for joint_type in joint_types])
    poses = poses_of(np.concatenate((np.zeros((1, n)), steps, -steps)))
    end = poses[0]
    if not is_rigid(end, tolerance):
        return None
    axes: list[Axis] = []
    for i, joint_type in enumerate(joint_types):
        step = 1.0 if joint_type is JointType.REVOLUTE else size
        derivative = (poses[1 + i] - poses[1 + n + i]) / (2.0 * step)
        axis = _axis(derivative @ inverse_transform(end), joint_type, tolerance, size)
        if axis is None:
            return None
        axes.append(axis)
    return chain_of_axes(axes, from_matrix(end))


def _axis(screw: Floats, joint_type: JointType, tolerance: Tolerance, size: float) -> Axis | None:
    """The axis of a 4×4 screw matrix, if it is one of a joint."""
    if not np.isfinite(screw).all():
        return None
    limit = 4 * tolerance.angle
    turn, shift = screw[:3, :3], screw[:3, 3]
    direction = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]) / 2
    if np.abs(turn + turn.T).max() > limit:
        return None
    if joint_type is JointType.PRISMATIC:
        length = float(np.linalg.norm(shift))
        if np.linalg.norm(direction) > limit or abs(length - 1.0) > limit:
            return None
        return Axis(True, triple((shift / length).tolist()), ORIGIN)
    length = float(np.linalg.norm(direction))
    if abs(length - 1.0) > limit:
        return None
    direction = direction / length
    if abs(direction @ shift) > 4 * tolerance.length * size:
        return None
    return Axis(False, triple(direction.tolist()), triple(cross_arrays(direction, shift).tolist()))


def scaled_chain(chain: Chain, factor: float) -> Chain:
    """Return a chain with its lengths in another unit."""
    axes = tuple(axis._replace(point=scale(axis.point, factor)) for axis in chain.axes)
    return Chain(axes, (*chain.end[:9], *scale(chain.end[9:], factor)), chain.extent * factor)
