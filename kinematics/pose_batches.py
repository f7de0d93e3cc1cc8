"""The notations of `kinematics.poses` for arrays of poses.

Every function takes (…, 4, 4) transforms and keeps their leading axes; conventions, ranges and the choices at
gimbal lock, half turns and the identity are those of the function for one pose.
"""

import numpy as np

from kinematics.poses import GIMBAL_LOCK, NOISE, SIGN_NOISE
from kinematics.se3 import Floats


def quaternions_from_transforms(transforms: Floats) -> Floats:
    """Return the unit quaternions (w, x, y, z), (…, 4)."""
    r = transforms[..., :3, :3]
    xx, yy, zz = r[..., 0, 0], r[..., 1, 1], r[..., 2, 2]
    trace = xx + yy + zz
    a, b, c = r[..., 2, 1] - r[..., 1, 2], r[..., 0, 2] - r[..., 2, 0], r[..., 1, 0] - r[..., 0, 1]
    d, e, f = r[..., 1, 0] + r[..., 0, 1], r[..., 0, 2] + r[..., 2, 0], r[..., 2, 1] + r[..., 1, 2]
    candidates = np.stack(
        [
            np.stack([1.0 + trace, a, b, c], axis=-1),
            np.stack([a, 1.0 + xx - yy - zz, d, e], axis=-1),
            np.stack([b, d, 1.0 - xx + yy - zz, f], axis=-1),
            np.stack([c, e, f, 1.0 - xx - yy + zz], axis=-1),
        ],
        axis=-2,
    )
    largest = np.argmax(np.stack([trace, xx, yy, zz], axis=-1), axis=-1)
    chosen = np.take_along_axis(candidates, largest[..., None, None], axis=-2)[..., 0, :]
    return _canonical(chosen / np.linalg.norm(chosen, axis=-1, keepdims=True))


def rpys_from_transforms(transforms: Floats) -> Floats:
    """Return (roll, pitch, yaw) [rad], (…, 3)."""
    r = transforms
    level = np.hypot(r[..., 0, 0], r[..., 1, 0])
    locked = level < GIMBAL_LOCK
    safe = np.where(locked, 1.0, level)
    c = np.where(locked, 1.0, r[..., 0, 0] / safe)
    s = np.where(locked, 0.0, r[..., 1, 0] / safe)
    roll = _directions(s * r[..., 0, 2] - c * r[..., 1, 2], c * r[..., 1, 1] - s * r[..., 0, 1])
    pitch = np.arctan2(-r[..., 2, 0], level) + 0.0
    return np.stack([roll, pitch, np.where(locked, 0.0, _directions(r[..., 1, 0], r[..., 0, 0]))], axis=-1)


def axis_angles_from_transforms(transforms: Floats) -> tuple[Floats, Floats]:
    """Return the axes (…, 3) and angles (…) [rad, 0 … π]."""
    quaternions = quaternions_from_transforms(transforms)
    vectors = quaternions[..., 1:]
    length = np.linalg.norm(vectors, axis=-1)
    still = length < NOISE
    axes = np.where(still[..., None], [0.0, 0.0, 1.0], vectors / np.where(still, 1.0, length)[..., None])
    return axes, np.where(still, 0.0, 2.0 * np.arctan2(length, quaternions[..., 0]))


def xyzabcs_from_transforms(transforms: Floats) -> Floats:
    """Return (x, y, z, a, b, c), (…, 6)."""
    return np.concatenate([transforms[..., :3, 3], rpys_from_transforms(transforms)[..., ::-1]], axis=-1)


def _directions(y: Floats, x: Floats) -> Floats:
    """Angles of the directions (x, y) in (−π, π]."""
    angles = np.arctan2(y, x)
    return np.where(angles > -np.pi, angles + 0.0, np.pi)


def _canonical(quaternions: Floats) -> Floats:
    """Return the sign with w > 0, or with w = 0 and the first of x, y, z above SIGN_NOISE positive."""
    half_turn = np.abs(quaternions[..., 0]) < NOISE
    first = np.argmax(np.abs(quaternions[..., 1:]) > SIGN_NOISE, axis=-1)
    leading = np.take_along_axis(quaternions[..., 1:], first[..., None], axis=-1)[..., 0]
    negative = np.where(half_turn, leading, quaternions[..., 0]) < 0.0
    signed = np.where(negative[..., None], -quaternions, quaternions)
    signed[..., 0] = np.where(half_turn, 0.0, signed[..., 0])
    return signed + 0.0
