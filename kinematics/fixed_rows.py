"""A constant pose as fixed rows of a table, for programs that take neither base nor tool.

With Z and X for the motions along and about z and x, Z_1 X_1 Z_2 X_2 makes every pose:

    R = Rot_z(θ_1) Rot_x(α_1) Rot_z(θ_2),   p = Rot_z(θ_1) (a_1, -d_2 sin α_1, d_1 + d_2 cos α_1)

d_2 grows without bound where α_1 is small. There Z_1 X_1 Z_2 X_2 Z_3 shifts first and turns then, which needs
a row more and no length beyond that of p.
"""

import math
from typing import NamedTuple

from kinematics.se3 import Transform
from kinematics.table import Convention, DHRow, JointType

STEEP = 0.1  # The sine of a twist from which two rows make a pose without long offsets.

LEVEL = 1e-14
"""The sine of a twist, a turn [rad], or a shift in parts of the way of the pose, that is rounding."""


class _AxisMotion(NamedTuple):
    """A turn [rad] about an axis and a shift along it [m]."""

    turn: float = 0.0
    shift: float = 0.0


def fixed_rows(pose: Transform, convention: Convention) -> tuple[DHRow[float], ...]:
    """Return fixed rows whose product is a pose: three at most, none of the identity.

    Args:
        pose: (4, 4) rigid transform.
    """
    motions = [*_motions(pose), _AxisMotion(), _AxisMotion()]
    if convention is Convention.MODIFIED:  # X_0 Z_1 X_1 Z_2 …
        motions.insert(0, _AxisMotion())
    rows = []
    for one, other in zip(motions[::2], motions[1::2], strict=False):
        z, x = (one, other) if convention is Convention.STANDARD else (other, one)
        if any((*z, *x)):
            rows.append(DHRow(joint=JointType.FIXED, theta=z.turn, d=z.shift, a=x.shift, alpha=x.turn))
    return tuple(rows)


def _motions(pose: Transform) -> list[_AxisMotion]:
    """Z_1 X_1 Z_2 …, whose product the pose is."""
    (r11, r12, r13, x), (r21, r22, r23, y), (r31, r32, r33, z), _ = pose.tolist()
    sine = math.hypot(r13, r23)
    across = math.hypot(x, y)
    if sine <= LEVEL:
        twist = 0.0 if r33 > 0.0 else math.pi
        whole = math.atan2(r21, r11)  # θ_1 + θ_2, or θ_1 - θ_2 behind half a turn
        first = math.atan2(y, x) if across else whole
        second = math.remainder(whole - first if r33 > 0.0 else first - whole, math.tau)
        last = second if abs(second) > LEVEL else 0.0
        return [_AxisMotion(first, z), _AxisMotion(twist, across), _AxisMotion(last)]
    first, twist, last = math.atan2(r13, -r23), math.atan2(sine, r33), math.atan2(r31, r32)
    if sine < STEEP:
        # the small entries say little of θ_1 and θ_2, the others all of θ_1 + θ_2, or θ_1 - θ_2
        if r33 > 0.0:
            last = math.remainder(math.atan2(r21 - r12, r11 + r22) - first, math.tau)
        else:
            last = math.remainder(first - math.atan2(r21 + r12, r11 - r22), math.tau)
        way = math.atan2(y, x)
        return [
            _AxisMotion(way, z),
            _AxisMotion(0.0, across),
            _AxisMotion(first - way),
            _AxisMotion(twist),
            _AxisMotion(last),
        ]
    aside = y * math.cos(first) - x * math.sin(first)
    offset = -aside / sine
    along = x * math.cos(first) + y * math.sin(first)
    rounding = LEVEL * (math.hypot(x, y, z) + abs(offset))
    rise, along, offset = (
        0.0 if abs(shift) <= rounding else shift for shift in (z - offset * r33, along, offset)
    )
    return [_AxisMotion(first, rise), _AxisMotion(twist, along), _AxisMotion(last, offset)]
