"""Geometric Jacobians: from joint rates to the velocity of the tool; rank, singularity, manipulability."""

from dataclasses import dataclass
from enum import StrEnum
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinematics.dh import MotionKind
from kinematics.evaluation.plan import EvaluationPlan, Quantity, plan_of
from kinematics.evaluation.recurrences import LinkMotions
from kinematics.joint_values import configurations
from kinematics.se3 import Floats
from kinematics.table import JointType, NumericTable

RANK_TOLERANCE = 1e-9
"""Singular values below this part of the largest are zero: no joint is known better than to 1e-9 rad."""


class JacobianFrame(StrEnum):
    """The axes in which the tool's velocity is written.

    BASE: J0, the axes of the world (of frame 0 if there is no base).
    END: Jn, the axes of the tool (of frame N if there is no tool).
    """

    BASE = "base"
    END = "end"


_QUANTITY = {JacobianFrame.BASE: Quantity.BASE_JACOBIAN, JacobianFrame.END: Quantity.END_JACOBIAN}
_SAMPLED: WeakKeyDictionary[EvaluationPlan, Floats] = WeakKeyDictionary()


def jacobian(
    table: NumericTable,
    joints: ArrayLike,
    frame: JacobianFrame = JacobianFrame.BASE,
    *,
    base: ArrayLike | None = None,
    tool: ArrayLike | None = None,
) -> Floats:
    """Return the geometric Jacobian: (v, ω) = J(q) dq/dt.

    v is the velocity of the tool's origin, ω the angular velocity of the tool. A revolute joint about z_i
    through p_i contributes the column (z_i × (p − p_i), z_i), a prismatic one along z_i the column (z_i, 0);
    a reversed variable changes the sign of its column.

    Args:
        joints: (n,) joint variables [rad, or m for a prismatic joint], or (m, n) for a batch.
        frame: the axes in which v and ω are written; J0 = diag(R, R) Jn with R the tool's orientation.
        base: (4, 4) pose of frame 0 in the world; the identity if left out.
        tool: (4, 4) pose of the tool in frame N; the identity if left out.

    Returns:
        (6, n), or (m, 6, n) for a batch: linear rows on top [m/rad, or 1 for a prismatic joint], angular rows
        below [1, or 0].

    Raises:
        JointValueError: not n finite values, or lengths so large that the result overflows.
        PoseError: base or tool is not a rigid transform.
        TableError: an entry of the table is NaN or infinite.

    Source: D. E. Whitney, Resolved motion rate control, IEEE Trans. MMS 10 (1969) 47; seed 001 eq. 3.22
    (H2J).
    """
    plan = plan_of(table, base, tool)
    computation = plan.of(_QUANTITY[frame])
    values = configurations(joints, plan.n_joints)
    return computation.once(values) if isinstance(values, list) else computation.many(values)


@dataclass(frozen=True, kw_only=True, slots=True)
class Mobility:
    """How well the tool can move, or one aspect of it; for a batch of m every value has a leading axis m.

    Attributes:
        singular_values: of the dimensionless Jacobian, largest first.
        rank: how many of them exceed the tolerance times the largest: in how many independent directions the
            tool can move.
        generic_rank: the rank in almost every configuration of this arm.
        singular: whether the rank is below the generic one.
        condition: largest over generic_rank-th singular value; infinite in a singular configuration.
        manipulability: product of the generic_rank largest singular values of the Jacobian as it is:
            Yoshikawa's √det(J Jᵀ) in the directions that the arm has. It depends on the unit of length.
    """

    singular_values: Floats
    rank: NDArray[np.int64]
    generic_rank: int
    singular: NDArray[np.bool_]
    condition: Floats
    manipulability: Floats


@dataclass(frozen=True, kw_only=True, slots=True)
class Dexterity:
    """What the Jacobian says about a configuration.

    Attributes:
        twist: of the whole velocity (v, ω) of the tool.
        translation: of v alone, which is what one asks of an arm that only positions its tip.
        rotation: of ω alone.
        length: what lengths were divided by [m].
        tolerance: singular values below this fraction of the largest counted as zero.
    """

    twist: Mobility
    translation: Mobility
    rotation: Mobility
    length: float
    tolerance: float


_WHOLE, _LINEAR, _ANGULAR = slice(0, 6), slice(0, 3), slice(3, 6)


def dexterity(
    table: NumericTable,
    joints: ArrayLike,
    *,
    base: ArrayLike | None = None,
    tool: ArrayLike | None = None,
    tolerance: float = RANK_TOLERANCE,
) -> Dexterity:
    """Return manipulability, rank, and whether a configuration is singular.

    A Jacobian mixes lengths with angles, so its singular values mean nothing until both have one scale.
    They are those of the dimensionless Jacobian: linear rows divided by a length L, columns of prismatic
    joints multiplied by it. L is the sum of |a| and |d| over the table, or 1 if that is zero. The result
    is therefore the same in metres and in millimetres.

    Singular means that the tool loses a direction of motion that the arm otherwise has: the rank is below the
    generic rank, the largest found in a fixed set of pseudo-random configurations. An arm of four joints is
    thus not called singular for having no rank 6, nor a planar arm of four for having rank 3. A stretched
    two-link arm is singular in its translation, not in its twist: it can still tell its two joints apart by
    the rotation of the tip.

    Args and raises as in `jacobian`; singular values below `tolerance` times the largest count as zero.

    Source: T. Yoshikawa, Manipulability of robotic mechanisms, Int. J. Robotics Research 4 (1985) 3, eq. 8.
    """
    plan = plan_of(table, base, tool)
    plain = jacobian(table, joints, base=base, tool=tool)
    length = characteristic_length(plan.chain)
    scaled, sampled = _dimensionless(plain, plan.chain, length), _sampled_jacobians(plan, length)
    twist, translation, rotation = (
        _mobility(plain[..., rows, :], scaled[..., rows, :], sampled[..., rows, :], tolerance)
        for rows in (_WHOLE, _LINEAR, _ANGULAR)
    )
    return Dexterity(
        twist=twist, translation=translation, rotation=rotation, length=length, tolerance=tolerance
    )


def _mobility(plain: Floats, scaled: Floats, sampled: Floats, tolerance: float) -> Mobility:
    values = _singular_values(scaled)
    generic = int(_rank(_singular_values(sampled), tolerance).max(initial=0))
    rank = _rank(values, tolerance)
    condition = np.full(rank.shape, np.inf if generic else 1.0)
    if generic:
        np.divide(values[..., 0], values[..., generic - 1], out=condition, where=rank >= generic)
    return Mobility(
        singular_values=values,
        rank=rank[()],
        generic_rank=generic,
        singular=(rank < generic)[()],
        condition=condition[()],
        manipulability=np.prod(_singular_values(plain)[..., :generic], axis=-1) * bool(generic),
    )


def characteristic_length(chain: LinkMotions) -> float:
    """Return the sum of |a| and |d| over the rows [m]; 1 where all are zero."""
    shifts = (MotionKind.SHIFT_X, MotionKind.SHIFT_Z)
    constant = [m for link in chain.links for m in link if m.joint is None and m.kind in shifts]
    return sum(abs(motion.first) for motion in constant) or 1.0


def _dimensionless(plain: Floats, chain: LinkMotions, length: float) -> Floats:
    rows = np.array([1 / length] * 3 + [1.0] * 3)[:, None]
    columns = np.array([length if kind is JointType.PRISMATIC else 1.0 for kind in chain.joint_types])
    scaled: Floats = plain * rows * columns
    return scaled


def _singular_values(matrices: Floats) -> Floats:
    return np.asarray(np.linalg.svd(matrices, compute_uv=False), dtype=np.float64)


def _rank(values: Floats, tolerance: float) -> NDArray[np.int64]:
    return np.asarray(np.count_nonzero(values > tolerance * values[..., :1], axis=-1), dtype=np.int64)


def _sampled_jacobians(plan: EvaluationPlan, length: float) -> Floats:
    """Dimensionless Jacobians in sixteen pseudo-random configurations, the same ones each time."""
    found = _SAMPLED.get(plan)
    if found is None:
        types = plan.chain.joint_types
        reach = [length if kind is JointType.PRISMATIC else np.pi for kind in types]
        joints = np.random.default_rng(16).uniform(-1.0, 1.0, (16, len(types))) * reach
        sampled = plan.of(Quantity.BASE_JACOBIAN).many(joints)
        found = _SAMPLED[plan] = _dimensionless(sampled, plan.chain, length)
    return found
