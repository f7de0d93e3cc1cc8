"""Velocities, their rate of change, and forces: what else a Jacobian says about one configuration.

    (v, ω) = J(q) q̇        (v̇, ω̇) = J(q) q̈ + J̇(q, q̇) q̇        τ = J(q)ᵀ (f, m)

All vectors are in the axes of the base, v and f at the origin of the end frame.
"""

import numpy as np
from numpy.typing import ArrayLike

from kinematics.chain import Chain
from kinematics.joint_values import one_configuration
from kinematics.poses import GIMBAL_LOCK
from kinematics.rotations.matrices import matrix3, rotation_about_axis
from kinematics.rotations.sequences import AXES, EulerSequence, Turning, euler_solutions
from kinematics.se3 import Floats, cross_arrays

ROLL_PITCH_YAW = EulerSequence(axes="XYZ", turning=Turning.FIXED)  # R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll).


def jacobian_rate(chain: Chain, joints: ArrayLike, rates: ArrayLike) -> Floats:
    """Return J̇ = dJ0/dt at one configuration, (6, n).

    An axis moves with the link that carries it: ż_i = ω_i × z_i and ṗ_i = the velocity of its point, both
    from the joints before i.

    Args:
        joints: (n,) joint variables [rad, or m for a prismatic joint].
        rates: (n,) their rates q̇ [rad/s, or m/s].

    Raises:
        JointValueError: not n finite values, or not n finite rates.
    """
    n = chain.n_joints
    q, speeds = (np.array(one_configuration(values, n)) for values in (joints, rates))
    z, p = chain.axes_at(q)
    tip = chain.poses(q)[:3, 3]
    slides = np.array([axis.prismatic for axis in chain.axes], dtype=bool)
    turning = np.where(slides, 0.0, speeds)[:, None] * z
    omega = np.vstack((np.zeros(3), np.cumsum(turning, axis=0)))[:-1]
    before = np.tril(np.ones((n, n)), -1)
    points_moved = _velocities(z, p, p, slides, speeds * before)
    tip_moved = _velocities(z, p, np.broadcast_to(tip, (n, 3)), slides, np.broadcast_to(speeds, (n, n)))
    z_rate = cross_arrays(omega, z)
    linear = cross_arrays(z_rate, tip - p) + cross_arrays(z, tip_moved - points_moved)
    columns = np.hstack((np.where(slides[:, None], z_rate, linear), np.where(slides[:, None], 0.0, z_rate)))
    return np.asarray(columns.T + 0.0)


def _velocities(z: Floats, p: Floats, of: Floats, slides: Floats, weights: Floats) -> Floats:
    """Return for each point i of (n, 3) its velocity, joint j moving at the speed weights[i, j]."""
    arms = of[:, None, :] - p[None, :, :]
    unit = np.where(slides[None, :, None], z[None], cross_arrays(np.broadcast_to(z[None], arms.shape), arms))
    return np.asarray(np.einsum("ij,ijk->ik", weights, unit))


def analytic_jacobian(
    chain: Chain, joints: ArrayLike, angles: EulerSequence = ROLL_PITCH_YAW
) -> Floats | None:
    """Return the Jacobian of (x, y, z) and three angles in the order of their sequence, (6, n).

    With ω = B(α, β, γ) (α, β, γ)˙ the angular rows are B⁻¹ J_ω. Of the two triples that make the rotation it
    is that of `euler_solutions`' first; for the other one the row of the middle angle has the other sign.

    Args:
        joints: (n,) joint variables [rad, or m for a prismatic joint].
        angles: the sequence; roll, pitch, yaw if left out.

    Returns:
        (6, n); None where the first and the last angle turn about one line (pitch ±π/2).

    Raises:
        JointValueError: not n finite values.

    Source: B. Siciliano, L. Sciavicco, L. Villani, G. Oriolo, Robotics (2009), section 3.6.
    """
    q = np.array(one_configuration(joints, chain.n_joints))
    B = angle_rates(chain.poses(q)[:3, :3], angles)
    if B is None:
        return None
    J = chain.jacobian(q)
    return np.vstack((J[:3], np.linalg.solve(B, J[3:]))) + 0.0


def angle_rates(rotation: Floats, angles: EulerSequence) -> Floats | None:
    """Return B with ω = B (α, β, γ)˙, (3, 3): its columns are the axes about which the angles turn.

    Args:
        rotation: (3, 3) a rotation.

    Returns:
        B; None where first and last axis count as one (`GIMBAL_LOCK`).
    """
    found = euler_solutions(matrix3(rotation.tolist()), angles, GIMBAL_LOCK)
    if found.family is not None:
        return None
    turned, columns = np.eye(3), {}
    order = range(3) if angles.turning is Turning.CURRENT else range(2, -1, -1)
    for k in order:
        axis = AXES.index(angles.axes[k])
        columns[k] = turned[:, axis]
        turned = turned @ np.array(rotation_about_axis(axis, found.triples[0][k]))
    return np.column_stack([columns[k] for k in range(3)])


def joint_forces(chain: Chain, joints: ArrayLike, wrench: ArrayLike) -> Floats:
    """Return τ = J0ᵀ (f, m): the joint torques and forces with which the end frame exerts a wrench, (n,).

    Args:
        joints: (n,) joint variables [rad, or m for a prismatic joint].
        wrench: (6,) force f [N] at the origin of the end frame, and moment m [N m], in the axes of the base:
            those that the arm exerts; those that it bears have the other sign.

    Raises:
        JointValueError: not n finite values.

    Source: B. Siciliano et al., Robotics (2009), eq. 3.111.
    """
    q = np.array(one_configuration(joints, chain.n_joints))
    return np.asarray(chain.jacobian(q).T @ np.asarray(wrench, dtype=np.float64)) + 0.0
