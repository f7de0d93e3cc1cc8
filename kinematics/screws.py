"""Screws: a table as a product of exponentials, and exponentials of twists.

With the joint screws at q = 0 and the home pose M,

    T(q) = exp([S_1] q_1) exp([S_2] q_2) ⋯ exp([S_n] q_n) M

in the axes of the world. A screw is written (v, ω), linear part first, in the same order as the rows of a
Jacobian: S = (p × ω, ω) = (−ω × p, ω) of a revolute joint along the unit vector ω through p, (v, 0) of a
prismatic one along the unit vector v. K. M. Lynch and F. C. Park write the angular part first; the numbers
are the same.

Source: R. W. Brockett (1984); R. M. Murray, Z. Li, S. S. Sastry, A Mathematical Introduction to Robotic
Manipulation (1994), section 3.2.
"""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kinematics.errors import DescriptionError, Fault
from kinematics.evaluation.plan import plan_of
from kinematics.evaluation.recurrences import joint_axes
from kinematics.forward import end_pose
from kinematics.frames.assigned_frames import FrameAssignment
from kinematics.frames.assignment import assign_frames
from kinematics.frames.axes import JointAxis
from kinematics.frames.parallels import NearParallel
from kinematics.joint_values import one_configuration
from kinematics.poses import Vector3
from kinematics.se3 import Transform, Vector, check_transform, cross, skew, triple
from kinematics.table import Convention, JointType, NumericTable

UNIT_TOLERANCE = 1e-9
"""Directions written with nine decimals are unit vectors; shorter ones are refused, not guessed at."""
SERIES_BELOW = 1e-4
"""Below, the next term of a series is 1e-16 of the first; above, closed forms keep half their digits."""


class Screw(NamedTuple):
    """A twist (v, ω): linear part [m/rad, or 1 of a prismatic joint], angular part [1]."""

    linear: Vector3
    angular: Vector3


@dataclass(frozen=True, kw_only=True, slots=True)
class ProductOfExponentials:
    """A serial chain without frames on its links.

    Attributes:
        screws: of joint 1 … n at q = 0, in the axes of the world.
        home: (4, 4) pose of the tool at q = 0.
    """

    screws: tuple[Screw, ...]
    home: Transform


def product_of_exponentials(
    table: NumericTable, *, base: ArrayLike | None = None, tool: ArrayLike | None = None
) -> ProductOfExponentials:
    """Return the screws and the home pose of a table.

    Args:
        table: the DH table; fixed rows go into the screws behind them and into the home pose.
        base: (4, 4) pose of frame 0 in the world; the identity if left out.
        tool: (4, 4) pose of the tool in frame N; the identity if left out.

    Raises:
        TableError: an entry of the table is NaN or infinite.
        PoseError: base or tool is not a rigid transform.
    """
    chain = plan_of(table, base, tool).chain
    at_zero = [0.0 if kind is JointType.PRISMATIC else (1.0, 0.0) for kind in table.joint_types]
    screws = tuple(
        Screw(_clean(direction), (0.0, 0.0, 0.0))
        if kind is JointType.PRISMATIC
        else Screw(_clean(cross(point, direction)), _clean(direction))
        for (direction, point), kind in zip(joint_axes(chain, at_zero), table.joint_types, strict=True)
    )
    home = end_pose(table, [0.0] * table.n_joints, base=base, tool=tool)
    return ProductOfExponentials(screws=screws, home=home)


def pose_of_product(product: ProductOfExponentials, joints: ArrayLike) -> Transform:
    """Return the pose of a product of exponentials.

    T(q) = exp([S_1] q_1) ⋯ exp([S_n] q_n) M.

    The rounding of a screw is multiplied by its angle: the error grows as 1e-16·|q|, unlike that of
    `forward_kinematics`.

    Args:
        joints: (n,) joint variables [rad, or m for a prismatic joint].

    Raises:
        JointValueError: not n finite values.
    """
    pose = np.eye(4)
    for screw, q in zip(product.screws, one_configuration(joints, len(product.screws)), strict=True):
        pose = pose @ exponential(screw, q)
    return pose @ product.home


def table_of_product(product: ProductOfExponentials, convention: Convention) -> FrameAssignment:
    """Return a DH table of a product of exponentials, by the assignment of frames to its axes.

    Axes that are parallel but for a tilt of 1e-10 to 5e-3 rad are joined by a fixed dummy row, so the table
    is the product for every q and its lengths are the robot's.

    Returns:
        Table, base and tool with base · A_1(q_1) ⋯ A_n(q_n) · tool = T(q) for every q.

    Raises:
        DescriptionError: a screw is neither a rotation about a unit vector nor a translation along one, at
            ("screws", i).
        PoseError: the home pose is not a rigid transform.
    """
    axes = [joint_axis(screw, ("screws", i)) for i, screw in enumerate(product.screws)]
    home = check_transform(product.home, where=("home",))
    return assign_frames(axes, convention, tool=home, near_parallel=NearParallel.DUMMY_ROW)


def turns(screw: Screw) -> bool:
    """Return whether a joint's screw is that of a rotation; an ω that is rounding makes none."""
    return math.hypot(*screw.angular) > UNIT_TOLERANCE


def joint_axis(screw: Screw, where: tuple[str | int, ...] = ()) -> JointAxis:
    """Return the axis of a joint's screw: direction, and of a revolute joint the point nearest to the origin.

    Raises:
        DescriptionError: a number is NaN or infinite, ω is neither zero nor a unit vector (to 1e-9), v is no
            unit vector where ω is zero, or v has a part along ω (a helical joint).
    """
    linear, angular = screw
    if not all(map(math.isfinite, (*linear, *angular))):
        raise DescriptionError(Fault.at("screw_not_finite", *where))
    direction = angular if turns(screw) else linear
    if abs(math.hypot(*direction) - 1.0) > UNIT_TOLERANCE:
        raise DescriptionError(Fault.at("screw_not_unit", *where))
    if not turns(screw):
        return JointAxis(joint=JointType.PRISMATIC, direction=direction)
    pitch = sum(v * w for v, w in zip(linear, angular, strict=True))
    if abs(pitch) > UNIT_TOLERANCE * (1.0 + math.hypot(*linear)):
        raise DescriptionError(Fault.at("screw_has_pitch", *where, pitch=f"{pitch:g}"))
    return JointAxis(joint=JointType.REVOLUTE, direction=direction, point=cross(angular, linear))


def exponential(screw: Screw, q: float) -> Transform:
    """Return exp([S] q): the motion along a screw.

    For any ω, unit or not; as ω q → 0 it tends to the translation v q without loss of digits.

    Args:
        screw: (v, ω).
        q: how far [rad of a unit ω, else m].

    Source: Murray, Li, Sastry, eq. 2.36.
    """
    v, w = np.array(screw.linear) * q, np.array(screw.angular) * q
    first, second, third = _coefficients(math.hypot(*w.tolist()))
    W = skew(w)
    square = W @ W
    pose = np.eye(4)
    pose[:3, :3] += first * W + second * square
    pose[:3, 3] = v + second * (W @ v) + third * (square @ v)
    return pose


def _coefficients(angle: float) -> tuple[float, float, float]:
    """The functions sin x / x, (1 − cos x) / x² and (x − sin x) / x³."""
    if angle < SERIES_BELOW:
        square = angle * angle
        return 1.0 - square / 6, 0.5 - square / 24, 1 / 6 - square / 120
    half = math.sin(angle / 2) / angle
    return math.sin(angle) / angle, 2.0 * half * half, (angle - math.sin(angle)) / angle**3


def _clean(vector: Vector) -> Vector3:
    """The vector as floats without -0.0."""
    return triple(float(part) + 0.0 for part in vector)
