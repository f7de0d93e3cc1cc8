"""Velocity ellipsoids: where the tool moves easily, and which motions a configuration does not have."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from kinematics.evaluation.plan import plan_of
from kinematics.jacobian import RANK_TOLERANCE, characteristic_length, jacobian
from kinematics.joint_values import one_configuration
from kinematics.se3 import Floats
from kinematics.table import JointType, NumericTable


@dataclass(frozen=True, kw_only=True, slots=True)
class Ellipsoid:
    """An ellipsoid about the tool's origin.

    Attributes:
        axes: (3, 3), one unit vector a row in the axes of the world, that of the longest radius first.
        radii: (3,) the radii along them, 0 where the tool cannot move that way.
    """

    axes: Floats
    radii: Floats


@dataclass(frozen=True, kw_only=True, slots=True)
class VelocityEllipsoids:
    """What the tool does when the joint rates go through the unit ball.

    Attributes:
        translation: of v [table's unit of length per radian].
        rotation: of ω [1].
        blocked: (k, 6) unit vectors (v / L, ω) at right angles to every motion of the tool, with L the
            characteristic length; they span what it cannot do here.
        length: that L [table's unit].
    """

    translation: Ellipsoid
    rotation: Ellipsoid
    blocked: Floats
    length: float


def velocity_ellipsoids(
    table: NumericTable, joints: ArrayLike, *, base: ArrayLike | None = None, tool: ArrayLike | None = None
) -> VelocityEllipsoids:
    """Return manipulability ellipsoids {J q̇ : |q̇| <= 1} and the motions that are lost.

    With J = U Σ Vᵀ the ellipsoid's principal axes are the columns of U, its radii the singular values. Rates
    of prismatic joints count in characteristic lengths, those of revolute joints in radians, so that the
    shape is the same in metres and in millimetres.

    Args and raises as in `kinematics.forward_kinematics`, for one configuration.

    Source: T. Yoshikawa, Manipulability of robotic mechanisms, Int. J. Robotics Research 4 (1985) 3, sect. 3.
    """
    plan = plan_of(table, base, tool)
    length = characteristic_length(plan.chain)
    units = [length if kind is JointType.PRISMATIC else 1.0 for kind in plan.chain.joint_types]
    values = one_configuration(joints, plan.n_joints)
    J = jacobian(table, values, base=base, tool=tool) * np.array(units)
    translation, rotation = (_ellipsoid(J[rows]) for rows in (slice(0, 3), slice(3, 6)))
    scaled = J / np.array([length] * 3 + [1.0] * 3)[:, None]
    U, sigma, _ = np.linalg.svd(scaled)
    return VelocityEllipsoids(
        translation=translation, rotation=rotation, blocked=_signed(U.T[_rank(sigma) :]), length=length
    )


def _ellipsoid(J: Floats) -> Ellipsoid:
    U, sigma, _ = np.linalg.svd(J)
    radii = np.zeros(3)
    rank = _rank(sigma)
    radii[:rank] = sigma[:rank]
    return Ellipsoid(axes=_signed(U.T), radii=radii)


def _rank(sigma: Floats) -> int:
    return int(np.count_nonzero(sigma > RANK_TOLERANCE * sigma.max(initial=0.0)))


def _signed(rows: Floats) -> Floats:
    """The rows with their largest entry positive: an SVD leaves the sign to chance."""
    if not len(rows):
        return rows
    largest = rows[
        np.arange(len(rows)), np.argmax(np.abs(rows) > 0.999 * np.abs(rows).max(axis=1)[:, None], axis=1)
    ]
    signed: Floats = rows * np.sign(largest)[:, None]
    return signed
