"""Arms of six revolute joints whose last three axes pass through one point, in closed form.

The wrist's centre is moved by the first three joints alone (D. L. Pieper, 1968). In frames whose z is an axis
and whose x is the common normal it is at

    A_1 A_2 A_3,   A_i = Rot_z(q_i) Trans_x(a_i) Rot_x(α_i) Trans_z(d_i),   Trans_x(a_3) = (ρ, 0, ζ).

Its distance from the origin and its height along axis 1 do not contain q_1 and are linear in cos q_2
and sin q_2; eliminating q_2 leaves an equation of degree two in cos q_3 and sin q_3, or of degree one
where axes 1 and 2 meet or are parallel. The wrist's turns follow from the rotation that is left.

Source: J. J. Craig, Introduction to robotics, 3rd ed. (2005) §4.6 eq. 4.45 to 4.53; here for any twists,
those of the wrist too.
"""

import math
from dataclasses import dataclass
from typing import NamedTuple, TypeAlias

import numpy as np

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.methods.axis_lines import (
    ALMOST,
    angle_about,
    common_normal,
    common_point,
    rotation_of,
    twist_between,
)
from kinematics.inverse.methods.trigonometric import linear_roots, quadratic_roots
from kinematics.se3 import cross_arrays, inverse_transform

ROUNDED = 0.1
"""Half the distance of two elbows [rad] that a target's decimals may have made none: it has three or more."""

Rows: TypeAlias = list[list[float]]
Turns: TypeAlias = tuple[float, float, float]


class Head(NamedTuple):
    """The first three axes in normal form, and the wrist's centre; lengths in units of the arm's size.

    Attributes:
        a1, ca1, sa1, d2: from axis 1 to axis 2: offset, cosine and sine of the twist, way along axis 2.
        a2, ca2, sa2: from axis 2 to axis 3.
        radius: distance of the wrist's centre from axis 3.
        height: its height along axis 3, from the common normal.
    """

    a1: float
    ca1: float
    sa1: float
    d2: float
    a2: float
    ca2: float
    sa2: float
    radius: float
    height: float


@dataclass(frozen=True, eq=False)
class WristArm:
    """The closed form of an arm with a spherical wrist.

    Attributes:
        before: (4, 4) and
        after: (4, 4) are what turns a target into Rot_z(θ_1) ⋯ Rot_z(θ_6), lengths in units of the size.
        zeros: (6,) θ - q.
        head: the first three axes.
        links: (3, 3, 3) rotations from axis 1 to 2, 2 to 3 and 3 to 4, transposed.
        wrist: cosine and sine of the twists from axis 4 to 5 and from axis 5 to 6.
        size: the arm's size.
    """

    before: Array
    after: Array
    zeros: tuple[float, ...]
    head: Head
    link: Rows
    wrist: tuple[float, float, float, float]
    size: float

    def candidates(self, target: Array) -> Array | None:
        """See `InverseClosedForm`."""
        T = self.before @ target @ self.after
        r0, r1, r2 = T[:3].tolist()
        heads = head_turns(self.head, r0[3] / self.size, r1[3] / self.size, r2[3] / self.size)
        if heads is None:
            return None
        o1, o2, o3, o4, o5, o6 = self.zeros
        found = []
        for q1, q2, q3 in heads:
            for q4, q5, q6 in wrist_turns(self.wrist, self._left_over(q1, q2, q3, r0, r1, r2)):
                found.append((q1 - o1, q2 - o2, q3 - o3, q4 - o4, q5 - o5, q6 - o6))
        return np.array(found).reshape(-1, 6)

    def _left_over(
        self, q1: float, q2: float, q3: float, r0: list[float], r1: list[float], r2: list[float]
    ) -> Rows:
        """The rotation that is left for the wrist: L Rot_z(-θ_3) L_2 Rot_z(-θ_2) L_1 Rot_z(-θ_1) R."""
        h = self.head
        c1, s1, c2, s2 = math.cos(q1), math.sin(q1), math.cos(q2), math.sin(q2)
        c3, s3 = math.cos(q3), math.sin(q3)
        ca1, sa1, ca2, sa2 = h.ca1, h.sa1, h.ca2, h.sa2
        # Rows of Rot_z(-θ_3) Rot_x(-α_2) Rot_z(-θ_2) Rot_x(-α_1) Rot_z(-θ_1).
        x1, y1 = c1 * c2 - s1 * ca1 * s2, s1 * c2 + c1 * ca1 * s2
        z1 = sa1 * s2
        x2, y2, z2 = -c1 * s2 - s1 * ca1 * c2, -s1 * s2 + c1 * ca1 * c2, sa1 * c2
        x3, y3, z3 = s1 * sa1, -c1 * sa1, ca1
        u1, u2, u3 = ca2 * x2 + sa2 * x3, ca2 * y2 + sa2 * y3, ca2 * z2 + sa2 * z3
        w1, w2, w3 = ca2 * x3 - sa2 * x2, ca2 * y3 - sa2 * y2, ca2 * z3 - sa2 * z2
        v1, v2, v3 = c3 * x1 + s3 * u1, c3 * y1 + s3 * u2, c3 * z1 + s3 * u3
        u1, u2, u3 = c3 * u1 - s3 * x1, c3 * u2 - s3 * y1, c3 * u3 - s3 * z1
        rows = []
        for l1, l2, l3 in self.link:
            p, q, r = l1 * v1 + l2 * u1 + l3 * w1, l1 * v2 + l2 * u2 + l3 * w2, l1 * v3 + l2 * u3 + l3 * w3
            rows.append([p * r0[k] + q * r1[k] + r * r2[k] for k in range(3)])
        return rows


def head_turns(h: Head, x: float, y: float, z: float) -> list[Turns] | None:
    """Return the θ_1, θ_2, θ_3 that bring the wrist's centre to (x, y, z) in the frame of axis 1.

    None where they are undetermined.
    """
    thirds = _third_turns(h, x * x + y * y + z * z, z)
    if thirds is None:
        return None
    found: list[Turns] = []
    square_across = x * x + y * y
    square_far = square_across + z * z
    for q3 in thirds:
        c3, s3 = math.cos(q3), math.sin(q3)
        f1, f2 = h.a2 + h.radius * c3, h.ca2 * h.radius * s3 - h.sa2 * h.height
        f3 = h.d2 + h.sa2 * h.radius * s3 + h.ca2 * h.height
        square = f1 * f1 + f2 * f2
        pairs: tuple[tuple[float, float], ...]
        if abs(h.a1) <= ALMOST:
            g2 = (z - h.ca1 * f3) / h.sa1
            py = h.ca1 * g2 - h.sa1 * f3
            # Beside axis 1 f² - g_2² would be the difference of large numbers.
            g1 = math.sqrt(max(square_across - py * py, 0.0))
            pairs = ((g1 - h.a1, g2), (-g1 - h.a1, g2))
        else:
            g1 = (square_far - square - f3 * f3 - h.a1 * h.a1) / (2.0 * h.a1)
            if abs(h.sa1) <= ALMOST:
                g2 = math.sqrt(max(square - g1 * g1, 0.0))
                pairs = ((g1, g2), (g1, -g2))
            else:
                pairs = ((g1, (z - h.ca1 * f3) / h.sa1),)
        for g1, g2 in pairs:
            px, py = h.a1 + g1, h.ca1 * g2 - h.sa1 * f3
            q1 = math.atan2(y * px - x * py, x * px + y * py)
            found.append((q1, math.atan2(f1 * g2 - f2 * g1, f1 * g1 + f2 * g2), q3))
    return found


def _third_turns(h: Head, square_far: float, z: float) -> tuple[float, ...] | list[float] | None:
    """θ_3, from |p|² = |f|² + a_1² + 2 a_1 g_1 and p_z = sin α_1 g_2 + cos α_1 f_3, g = Rot_z(θ_2) f.

    f = (a_2 + ρ c_3, cos α_2 ρ s_3 - sin α_2 ζ, d_2 + sin α_2 ρ s_3 + cos α_2 ζ).
    """
    a1, ca1, sa1, d2, a2, ca2, sa2, rho, zeta = h
    rest = a1 * a1 + a2 * a2 + rho * rho + zeta * zeta + d2 * d2 + 2.0 * d2 * ca2 * zeta
    kc, ks, k0 = 2.0 * a2 * rho, 2.0 * d2 * sa2 * rho, square_far - rest
    if abs(a1) <= ALMOST:
        return linear_roots(kc, ks, k0, ROUNDED)
    h0, hs = z - ca1 * (d2 + ca2 * zeta), -ca1 * sa2 * rho
    if abs(sa1) <= ALMOST:
        return linear_roots(0.0, -hs, h0)
    u0, uc, us = k0 / (2.0 * a1), -kc / (2.0 * a1), -ks / (2.0 * a1)
    v0, vs = h0 / sa1, hs / sa1
    w0, ws = -sa2 * zeta, ca2 * rho
    return quadratic_roots(
        uc * uc - rho * rho,
        2.0 * uc * us,
        us * us + vs * vs - ws * ws,
        2.0 * (u0 * uc - a2 * rho),
        2.0 * (u0 * us + v0 * vs - w0 * ws),
        u0 * u0 + v0 * v0 - a2 * a2 - w0 * w0,
    )


def wrist_turns(twists: tuple[float, float, float, float], N: Rows) -> tuple[Turns, Turns]:
    """Return both ways to make N = Rot_z(θ_4) Rot_x(α_4) Rot_z(θ_5) Rot_x(α_5) Rot_z(θ_6), or nearly so.

    Where the wrist is in line and θ_4 is free, θ_4 = 0 and θ_6 makes up for it.
    """
    ca4, sa4, ca5, sa5 = twists
    (n11, _, x), (n21, _, y), (n31, _, z) = N
    c5 = (ca4 * ca5 - z) / (sa4 * sa5)
    if ca4 == 0.0 == ca5:
        s5 = math.hypot(x, y)
        length = math.hypot(s5, c5)
        s5, c5 = s5 / length, c5 / length
    else:
        c5 = max(-1.0, min(1.0, c5))
        s5 = math.sqrt((1.0 - c5) * (1.0 + c5))
    found = []
    for sine in (s5, -s5):
        # The third column of N is Rot_z(θ_4) (vx, vy, ·).
        vx, vy = sine * sa5, -ca4 * c5 * sa5 - sa4 * ca5
        q4 = math.atan2(y * vx - x * vy, x * vx + y * vy)
        c4, s4 = math.cos(q4), math.sin(q4)
        m1, m2 = c4 * n11 + s4 * n21, c4 * n21 - s4 * n11
        m2, m3 = ca4 * m2 + sa4 * n31, ca4 * n31 - sa4 * m2
        q6 = math.atan2(ca5 * (c5 * m2 - sine * m1) + sa5 * m3, c5 * m1 + sine * m2)
        found.append((q4, math.atan2(sine, c5), q6))
    return found[0], found[1]


def wrist_arm_of(arm: Arm) -> WristArm | None:
    """Return the closed form of an arm, or None if its last three axes do not pass through one point."""
    if arm.n_joints != 6 or not arm.revolute.all():
        return None
    z, p, end = arm.screws
    p = p / arm.size
    centre = common_point(z[3:], p[3:])
    if centre is None:
        return None
    sines = [float(np.linalg.norm(cross_arrays(z[i], z[i + 1]))) for i in (3, 4)]
    foot1, foot2, x1 = common_normal(z[0], p[0], z[1], p[1])
    foot2_next, foot3, x2 = common_normal(z[1], p[1], z[2], p[2], foot2)
    across = centre - foot3 - ((centre - foot3) @ z[2]) * z[2]
    radius = float(np.linalg.norm(across))
    a1, a2 = float((foot2 - foot1) @ x1), float((foot3 - foot2_next) @ x2)
    ca1, sa1 = twist_between(z[0], z[1], x1)
    if min(sines) <= ALMOST or radius <= ALMOST or (abs(a1) <= ALMOST and abs(sa1) <= ALMOST):
        return None
    ca2, sa2 = twist_between(z[1], z[2], x2)
    x3 = across / radius
    x4, x5 = cross_arrays(z[3], z[4]) / sines[0], cross_arrays(z[4], z[5]) / sines[1]
    F3, F4 = rotation_of(x3, z[2]), rotation_of(x4, z[3])
    F1, F6 = np.eye(4), np.eye(4)
    F1[:3, :3], F1[:3, 3] = rotation_of(x1, z[0]), foot1 * arm.size
    F6[:3, :3], F6[:3, 3] = rotation_of(x5, z[5]), centre * arm.size
    ca4, sa4 = twist_between(z[3], z[4], x4)
    ca5, sa5 = twist_between(z[4], z[5], x5)
    return WristArm(
        before=inverse_transform(F1),
        after=inverse_transform(end) @ F6,
        zeros=(
            0.0,
            angle_about(z[1], x1, x2),
            angle_about(z[2], x2, x3),
            0.0,
            angle_about(z[4], x4, x5),
            0.0,
        ),
        head=Head(
            a1,
            ca1,
            sa1,
            float((foot2_next - foot2) @ z[1]),
            a2,
            ca2,
            sa2,
            radius,
            float((centre - foot3) @ z[2]),
        ),
        link=(F4.T @ F3).tolist(),
        wrist=(ca4, sa4, ca5, sa5),
        size=arm.size,
    )
