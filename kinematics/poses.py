"""Poses of rigid bodies: 4×4 transforms and the notations that people write them in.

A transform T_a_b is the pose of frame b in frame a, and maps coordinates in b to coordinates in a.
Orientation is written as

- a unit quaternion (w, x, y, z), scalar first, w ≥ 0, and the first of x, y, z that is not zero (within
  1e-14) positive where w = 0;
- roll, pitch, yaw: R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll), with roll and yaw in (−π, π] and pitch in [−π/2,
  π/2];
- an axis (a unit vector) and an angle in [0, π];
- X Y Z A B C of seed 001: T = Trans(x, y, z) Rot_z(a) Rot_y(b) Rot_x(c), so a is the yaw, b the pitch, c the
  roll.

Where a notation is ambiguous the choice is stated at the function that makes it. Everything here takes one
pose and computes on plain floats; `kinematics.pose_batches` does the same for arrays of poses.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from kinematics.angles import cos_sin
from kinematics.errors import Fault, PoseError
from kinematics.se3 import Transform

GIMBAL_LOCK = 1e-12
"""Cosine of the pitch below which roll and yaw are not told apart: yaw comes from entries of that size, which
carry roundings of 1e-16 each, and would be right to four digits at best."""
NOISE = 1e-15  # What a few roundings leave of a component of a unit quaternion that is zero.
SIGN_NOISE = 1e-14
"""A component of a half turn below this does not decide on the sign: a product of some fifty rotations
leaves as much of a zero, and the same pose would get either sign."""

Vector3 = tuple[float, float, float]


class Quaternion(NamedTuple):
    """Unit quaternion w + x·i + y·j + z·k, scalar first."""

    w: float
    x: float
    y: float
    z: float


class RollPitchYaw(NamedTuple):
    """Angles of R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll) [rad]."""

    roll: float
    pitch: float
    yaw: float


class AxisAngle(NamedTuple):
    """Rotation by `angle` [rad, 0 … π] about the unit vector `axis`."""

    axis: Vector3
    angle: float


class XYZABC(NamedTuple):
    """T = Trans(x, y, z) Rot_z(a) Rot_y(b) Rot_x(c); lengths, then angles [rad]. Seed 001 eq. 2.5."""

    x: float
    y: float
    z: float
    a: float
    b: float
    c: float


class PoseNotations(NamedTuple):
    """One pose in every notation."""

    position: Vector3
    quaternion: Quaternion
    rpy: RollPitchYaw
    axis_angle: AxisAngle
    xyzabc: XYZABC


def pose_notations(transform: Transform) -> PoseNotations:
    """Return the position and orientation of a pose in every notation at once.

    Args:
        transform: (4, 4) rigid transform; it is not checked (see `se3.check_transform`).
    """
    r0, r1, r2, _ = transform.tolist()
    position = (r0[3], r1[3], r2[3])
    quaternion = _quaternion(r0, r1, r2)
    rpy = _roll_pitch_yaw(r0, r1, r2)
    xyzabc = XYZABC(r0[3], r1[3], r2[3], rpy.yaw, rpy.pitch, rpy.roll)
    return PoseNotations(position, quaternion, rpy, axis_angle_from_quaternion(quaternion), xyzabc)


def quaternion_from_transform(transform: Transform) -> Quaternion:
    """Return the unit quaternion of a pose's orientation, w ≥ 0.

    The largest of the four components is found first and the others are divided by it, so no digits are lost
    near half turns. Within 1e-15 of a half turn w counts as 0 and the first of x, y, z
    above 1e-14 in size is positive.

    Source: S. W. Shepperd, Quaternion from rotation matrix, J. Guidance and Control 1 (1978) 223.
    """
    r0, r1, r2, _ = transform.tolist()
    return _quaternion(r0, r1, r2)


def rpy_from_transform(transform: Transform) -> RollPitchYaw:
    """Return the roll, pitch and yaw of a pose's orientation.

    At pitch ±π/2 (within 1e-12) only roll ∓ yaw is determined: yaw is then 0 and roll takes the whole angle.
    Nearby, roll is computed from the rotation that remains after yaw, so the three reproduce the matrix.
    """
    r0, r1, r2, _ = transform.tolist()
    return _roll_pitch_yaw(r0, r1, r2)


def axis_angle_from_transform(transform: Transform) -> AxisAngle:
    """Return the axis and angle of a pose's orientation; see `axis_angle_from_quaternion`."""
    return axis_angle_from_quaternion(quaternion_from_transform(transform))


def xyzabc_from_transform(transform: Transform) -> XYZABC:
    """Return X Y Z A B C of a pose, by the rules of `rpy_from_transform` (at b = ±π/2: a = 0).

    Source: seed 001 eq. 2.4 and 2.5 (its operator GEO).
    """
    rpy = rpy_from_transform(transform)
    x, y, z = transform[:3, 3].tolist()
    return XYZABC(x, y, z, rpy.yaw, rpy.pitch, rpy.roll)


def axis_angle_from_quaternion(quaternion: Quaternion) -> AxisAngle:
    """Return the axis and angle of a unit quaternion with w ≥ 0.

    The angle is 2·atan2(|v|, w), which is accurate at both ends. A rotation below 2e-15 rad has no meaningful
    axis: its angle is 0 and its axis z.
    """
    w, x, y, z = quaternion
    length = math.sqrt(x * x + y * y + z * z)
    if length < NOISE:
        return AxisAngle((0.0, 0.0, 1.0), 0.0)
    return AxisAngle((x / length, y / length, z / length), 2.0 * math.atan2(length, w))


def transform_from_quaternion(
    quaternion: Sequence[float], position: Sequence[float] = (0, 0, 0)
) -> Transform:
    """Return the pose with the orientation of a quaternion (w, x, y, z) of any nonzero length.

    Raises:
        PoseError: not four finite numbers, or all of them zero.
    """
    w, x, y, z = _finite(quaternion, "quaternion", ("w", "x", "y", "z"))
    # by a power of two, which rounds nothing: the length neither overflows nor loses digits among denormals
    _, exponent = math.frexp(max(abs(w), abs(x), abs(y), abs(z)))
    w, x, y, z = (math.ldexp(part, -exponent) for part in (w, x, y, z))
    length = math.hypot(w, x, y, z)
    if length == 0.0:
        raise PoseError(Fault.at("quaternion_length", "quaternion"))
    w, x, y, z = w / length, x / length, y / length, z / length
    return _assemble(
        (1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)),
        (2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)),
        (2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)),
        position,
    )


def transform_from_rpy(rpy: Sequence[float], position: Sequence[float] = (0, 0, 0)) -> Transform:
    """Return the pose with orientation Rot_z(yaw) Rot_y(pitch) Rot_x(roll), from (roll, pitch, yaw) [rad].

    Raises:
        PoseError: not three finite numbers.
    """
    roll, pitch, yaw = _finite(rpy, "rpy", ("roll", "pitch", "yaw"))
    (cr, sr), (cp, sp), (cy, sy) = (cos_sin(angle) for angle in (roll, pitch, yaw))
    return _assemble(
        (cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
        (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr),
        (-sp, cp * sr, cp * cr),
        position,
    )


def transform_from_xyzabc(xyzabc: Sequence[float]) -> Transform:
    """Return the pose Trans(x, y, z) Rot_z(a) Rot_y(b) Rot_x(c) from its six numbers.

    Raises:
        PoseError: not six finite numbers.

    Source: seed 001 eq. 2.4 and 2.5 (its operator GEO).
    """
    x, y, z, a, b, c = _finite(xyzabc, "xyzabc", ("x", "y", "z", "a", "b", "c"))
    return transform_from_rpy((c, b, a), (x, y, z))


def transform_from_axis_angle(
    axis: Sequence[float], angle: float, position: Sequence[float] = (0, 0, 0)
) -> Transform:
    """Return the pose turned by an angle [rad] about an axis of any nonzero length.

    Raises:
        PoseError: not finite, or the axis is zero.
    """
    x, y, z = _finite(axis, "axis", ("x", "y", "z"))
    (turn,) = _finite((angle,), "angle", ("angle",))
    length = math.hypot(x, y, z)
    if not 0.0 < length < math.inf:
        raise PoseError(Fault.at("axis_length", "axis"))
    x, y, z = x / length, y / length, z / length
    c, s = cos_sin(turn)
    v = 1.0 - c if c < 0.5 else 2.0 * math.sin(turn / 2) ** 2
    return _assemble(
        (c + v * x * x, v * x * y - s * z, v * x * z + s * y),
        (v * x * y + s * z, c + v * y * y, v * y * z - s * x),
        (v * x * z - s * y, v * y * z + s * x, c + v * z * z),
        position,
    )


def _finite(values: Sequence[float], what: str, names: tuple[str, ...]) -> list[float]:
    """Return the values as floats. Raises PoseError if their number is wrong or one is not finite."""
    try:
        numbers = [float(value) for value in values]
    except (TypeError, ValueError, OverflowError):
        numbers = []
    if len(numbers) != len(names):
        raise PoseError(
            Fault.at("notation_wrong_length", what, what=what, expected=len(names), names=", ".join(names))
        )
    faults = [
        Fault.at("notation_not_finite", what, i, what=what, name=name)
        for i, (name, value) in enumerate(zip(names, numbers, strict=True))
        if not math.isfinite(value)
    ]
    if faults:
        raise PoseError(faults)
    return numbers


def _assemble(r0: Vector3, r1: Vector3, r2: Vector3, position: Sequence[float]) -> Transform:
    x, y, z = _finite(position, "position", ("x", "y", "z"))
    return np.array([[*r0, x], [*r1, y], [*r2, z], [0.0, 0.0, 0.0, 1.0]]) + 0.0  # no -0.0


def _quaternion(r0: list[float], r1: list[float], r2: list[float]) -> Quaternion:
    xx, yy, zz = r0[0], r1[1], r2[2]
    trace = xx + yy + zz
    if trace >= max(xx, yy, zz):
        w, x, y, z = 1.0 + trace, r2[1] - r1[2], r0[2] - r2[0], r1[0] - r0[1]
    elif xx >= max(yy, zz):
        w, x, y, z = r2[1] - r1[2], 1.0 + xx - yy - zz, r0[1] + r1[0], r0[2] + r2[0]
    elif yy >= zz:
        w, x, y, z = r0[2] - r2[0], r0[1] + r1[0], 1.0 - xx + yy - zz, r1[2] + r2[1]
    else:
        w, x, y, z = r1[0] - r0[1], r0[2] + r2[0], r1[2] + r2[1], 1.0 - xx - yy + zz
    scale = 1.0 / math.sqrt(w * w + x * x + y * y + z * z)
    w *= scale
    if abs(w) < NOISE:
        w = 0.0
        first = next((part for part in (x, y, z) if abs(part * scale) > SIGN_NOISE), 1.0)
        scale = math.copysign(scale, first)
    elif w < 0.0:
        w, scale = -w, -scale
    return Quaternion(w, x * scale + 0.0, y * scale + 0.0, z * scale + 0.0)


def _roll_pitch_yaw(r0: list[float], r1: list[float], r2: list[float]) -> RollPitchYaw:
    level = math.hypot(r0[0], r1[0])
    pitch = math.atan2(-r2[0], level) + 0.0
    if level < GIMBAL_LOCK:
        return RollPitchYaw(_direction(-r1[2], r1[1]), pitch, 0.0)
    c, s = r0[0] / level, r1[0] / level
    roll = _direction(s * r0[2] - c * r1[2], c * r1[1] - s * r0[1])
    return RollPitchYaw(roll, pitch, _direction(r1[0], r0[0]))


def _direction(y: float, x: float) -> float:
    """Angle of the direction (x, y) in (−π, π]: π also where y is a negative zero, or as good as that."""
    angle = math.atan2(y, x)
    return angle + 0.0 if angle > -math.pi else math.pi
