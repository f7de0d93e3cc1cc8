"""The closed form of an arm with a wrist for one target that is well away from singularities.

Most industrial arms have parallel axes 2 and 3, axis 4 across them, and a wrist at right angles. Then each
equation has two roots,

    p_x = ±√(x² + y² - p_y²),   θ_3 = ±acos k/(2 a_2 ρ),   and θ_4, θ_5, θ_6 or θ_4 + π, -θ_5, θ_6 + π,

and all turns but those of axes 1 and 5 are in the plane of the links or about axis 4: each is a product of
complex numbers, which costs Python as little as one of floats. All is done on floats: some two hundred
operations cost less than a few of numpy's calls.

Solutions are well away from singularities if no way on which the target stays reached leads to another root
or farther than `STILL`. On such a way the wrist's centre moves by δ at most, and

    p_x² by 2 (√(x² + y²) + |p_y cot α_1|) δ,   k by 2 |g_1| times what p_x moves by, and 2 |g_2| δ/|sin α_1|.

As long as these keep p_x and sin θ_3 from zero, joint 1 turns by t = δ/|p_x sin α_1| at most, the links in
their plane by (a_2 + ρ)/(a_2 ρ |sin θ_3|) times δ and what the turn of joint 1 makes of it; what the wrist
has to make up for is the sum of these and the tolerance, and joints 4 and 6 turn by 1/|sin θ_5| of it.

Each solution is judged by forward kinematics in the same normal form: of the wrist's centre, and of the
rotation that the wrist has to make. That the form is the chain itself is checked once, when it is made.
"""

from cmath import phase, rect
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from math import acos, atan2, cos, hypot, pi, sin, sqrt, tau

import numpy as np

from kinematics.evaluation.straight_line import function_of_floats
from kinematics.evaluation.tape import Tape
from kinematics.inverse.arm import Arm, Array, low_discrepancy
from kinematics.inverse.methods.axis_lines import ALMOST
from kinematics.inverse.methods.wrist import WristArm
from kinematics.inverse.methods.wrist_tapes import plane_tape, seen_tape
from kinematics.inverse.results import IKSolution, Isolation
from kinematics.inverse.self_motions.isolation import LONG
from kinematics.se3 import inverse_transform

THE_SAME = 1e-13
"""Largest entry by which the normal form may be off the chain, lengths in units of the size: rounding."""

EXACT = 1e-12  # What is off by more than this [rad, and parts of the size] is left to Newton's steps.

STILL = LONG / 2.0  # What moves by no more than this [rad] is no family.

MARGIN = 4.0
"""Roots this many times farther from zero than what the tolerance can make of them stay what they are."""

FLIPPED = 1e-15  # What adding π to two angles leaves of rounding [rad].

UNSEEN = 2.0**-52
"""Up to here [rad] an angle less π is -π to a double, which is out of range, and the angle plus π is π."""

CLEARLY = 1e-6  # Part of its terms by which a square root's argument is below zero where there is no root.

_LOOKS = 5  # Configurations at which a closed form is tried before it is believed.

_solution: Callable[[tuple[object, ...]], IKSolution] = partial(tuple.__new__, IKSolution)
"""As the class itself would, in a third of the time."""


@dataclass(frozen=True, eq=False, kw_only=True)
class ClearWrist:
    """A level arm with a wrist at right angles in normal form; lengths in units of the size.

    Axes 2 and 3 have the same sense, and the wrist turns by Rot_z(θ_4) Rot_x(90°) Rot_z(θ_5) Rot_x(90°)
    Rot_z(θ_6).

    Attributes:
        a1, ca1, sa1: from axis 1 to axis 2: offset, cosine and sine of the twist.
        aside: way from the first common normal along axis 2 to the wrist's centre.
        a2: from axis 2 to axis 3.
        rho: distance of the wrist's centre from axis 3.
        sense3, sense5: 1, or -1 where the arm's joint turns the other way.
        lean: angle in the plane of the links from the way between axis 3 and the wrist's centre to axis 4.
        forearm: e^{-i lean}/ρ.
        zeros: θ - q of the joints; ±θ - q of those that turn the other way.
        size: the arm's size [m].
        lever: distance from the wrist's centre to the tool's origin [m].
        spread: how far the wrist's centre may be off for each unit of tolerance, in the arm's size.
        seen_tape: from the upper twelve entries of a target to first and third column of the rotation and the
            place of the wrist's centre that the normal form sees.
        plane_tape: these seen from the plane of the links.
        seen: `seen_tape` as a function of floats.
    """

    a1: float
    ca1: float
    sa1: float
    aside: float
    a2: float
    rho: float
    sense3: float
    sense5: float
    lean: float
    forearm: complex
    zeros: tuple[float, ...]
    size: float
    lever: float
    spread: float
    seen_tape: Tape
    plane_tape: Tape
    seen: Callable[..., tuple[float, ...]]

    def solutions(self, target: Array, tolerance: float) -> list[IKSolution] | None:
        """Return all solutions, the one with the smallest joint values first.

        None near a singularity, at the edge of the reach, or beyond it.
        """
        ca1, sa1, a2, rho = self.ca1, self.sa1, self.a2, self.rho
        seen = self.seen(*target.ravel().tolist()[:12])
        x, y, z = seen[6:]
        g2 = (z - ca1 * self.aside) / sa1
        py = ca1 * g2 - sa1 * self.aside
        far = sqrt(x * x + y * y)
        argument = (far - py) * (far + py)
        delta = tolerance * self.spread
        squared = 2.0 * delta * (far + abs(py * ca1 / sa1))
        if not argument > MARGIN * squared:
            return None
        root, length = sqrt(argument), 2.0 * a2 * rho
        turn = delta / abs(sa1 * root)
        moved = 2.0 * (a2 + rho) * (delta + turn * far)
        tilt = 2.0 * abs(g2 / sa1) * delta
        found: list[tuple[float, IKSolution]] = []
        for px in (root, -root):
            g1 = px - self.a1
            k = g1 * g1 + g2 * g2 - a2 * a2 - rho * rho
            across = (length - k) * (length + k)
            edge = MARGIN * 2.0 * length * (abs(g1) / root * squared + tilt)
            if across > edge:
                wobble = turn + moved / sqrt(across)
                t1 = phase(complex(x, y) * complex(px, -py))
                least = (wobble + tolerance) / STILL
                if wobble > STILL or not self._in_plane(
                    found, t1, complex(g1, g2), acos(k / length), seen, least
                ):
                    return None
            elif not (across < -edge and across < -CLEARLY * length * length):
                return None
        found.sort()
        return [one for _, one in found] or None

    def _in_plane(
        self,
        found: list[tuple[float, IKSolution]],
        t1: float,
        wanted: complex,
        half: float,
        seen: tuple[float, ...],
        least: float,
    ) -> bool:
        """Find the solutions with the links in one plane, with the sums of their joint values.

        Args:
            found: receives them.
            t1: θ_1.
            wanted: the wrist's centre in the plane.
            half: |θ_3|.
            seen: what the normal form sees of the target.
            least: sin θ_5 at least.

        Returns:
            Whether all are clear.
        """
        x1, y1, z1, x3, y3, z3, x, y, z = seen
        ca1, sa1, a2, rho, size = self.ca1, self.sa1, self.a2, self.rho, self.size
        o1, o2, o3, o4, o5, o6 = self.zeros
        sense5, lever, isolated = self.sense5, self.lever, Isolation.ISOLATED
        back = rect(1.0, -t1)
        turned = complex(x, y) * back
        centre = complex(turned.real - self.a1, ca1 * turned.imag + sa1 * z)
        off_plane = ca1 * z - sa1 * turned.imag - self.aside
        turned = complex(x1, y1) * back
        first_in = complex(turned.real, ca1 * turned.imag + sa1 * z1)
        first_off = ca1 * z1 - sa1 * turned.imag
        turned = complex(x3, y3) * back
        third_in = complex(turned.real, ca1 * turned.imag + sa1 * z3)
        third_off = ca1 * z3 - sa1 * turned.imag
        q1 = _in_range(t1 - o1)
        for t3 in (half, -half):
            bent = rect(rho, -t3)
            t2 = phase(wanted * (a2 + bent))
            back = rect(1.0, -t2)
            off = centre * back - a2 - bent.conjugate()
            away = size * hypot(off.real, off.imag, off_plane)
            back *= bent * self.forearm
            turned = third_in * back
            cosine, aside = turned.real, complex(turned.imag, third_off)
            sine = abs(aside)
            turned = first_in * back
            along = turned.real
            t4, t5 = phase(aside), atan2(sine, -cosine)
            back = rect(1.0, -t4)
            c5, s5 = cos(t5), sin(t5)
            rest = complex(turned.imag, first_off) * back
            u, v = rest.real, rest.imag
            t6 = atan2(-v, c5 * u + s5 * along)
            c6 = cos(t6)
            off = aside * back
            angle = hypot(off.real - s5, off.imag, cosine + c5, u - c5 * c6, v + sin(t6), along - s5 * c6)
            if sine < least or angle > EXACT or away > EXACT * size:
                return False
            t5 *= sense5
            q2, q3, q4 = _in_range(t2 - o2), _in_range(self.sense3 * t3 - o3), _in_range(t4 - o4)
            q5, r5, q6 = _in_range(t5 - o5), _in_range(-t5 - o5), _in_range(t6 - o6)
            head, ends = abs(q1) + abs(q2) + abs(q3), abs(q4) + abs(q6)
            joints = q1, q2, q3, q4, q5, q6
            one = _solution((joints, away + lever * angle, angle, isolated, None))
            found.append((head + ends + abs(q5), one))
            # The wrist's other way makes the same rotation.
            joints = q1, q2, q3, q4 - pi if q4 > UNSEEN else q4 + pi, r5, q6 - pi if q6 > UNSEEN else q6 + pi
            angle += FLIPPED
            one = _solution((joints, away + lever * angle, angle, isolated, None))
            found.append((head + tau - ends + abs(r5), one))
        return True


def _in_range(angle: float) -> float:
    """An angle in (-3π, 3π] as it is in (-π, π]."""
    if angle > pi:
        return angle - tau
    return angle if angle > -pi else angle + tau


def clear_wrist_of(arm: Arm, wrist: WristArm) -> ClearWrist | None:
    """Return the scalar closed form of an arm.

    None if axes 2 and 3 are not parallel, or axes 3 and 4, 4 and 5 or 5 and 6 not at right angles.
    """
    h = wrist.head
    ca4, sa4, ca5, sa5 = wrist.wrist
    x4, y4, z4 = np.array(wrist.link) * (1.0, h.ca2, h.ca2)
    if not (h.sa2 == 0.0 == ca4 == ca5 and abs(h.sa1) > ALMOST and abs(z4[2]) <= ALMOST):
        return None
    lever = float(np.linalg.norm(inverse_transform(wrist.after)[:3, 3]))
    across = np.array((-z4[1], z4[0], 0.0))
    o1, o2, o3, o4, o5, o6 = wrist.zeros
    opposite, lean = sa4 != sa5, atan2(z4[1], z4[0])
    aside, seen = h.d2 + h.ca2 * h.height, seen_tape(wrist)
    found = ClearWrist(
        a1=h.a1,
        ca1=h.ca1,
        sa1=h.sa1,
        aside=aside,
        a2=h.a2,
        rho=h.radius,
        sense3=h.ca2,
        sense5=-sa5 if opposite else sa5,
        lean=lean,
        forearm=rect(1.0 / h.radius, -lean),
        zeros=(
            o1,
            o2,
            o3,
            o4 - atan2(float(across @ y4), float(across @ x4)),
            o5 - (sa5 * pi if opposite else 0.0),
            o6 - (pi if opposite else 0.0),
        ),
        size=wrist.size,
        lever=lever,
        spread=(1.0 + lever) / wrist.size,
        seen_tape=seen,
        plane_tape=plane_tape(h.a1, h.ca1, h.sa1, aside),
        seen=function_of_floats(seen),
    )
    return found if _is_the_chain(arm, found) else None


def _is_the_chain(arm: Arm, wrist: ClearWrist) -> bool:
    """Whether the normal form makes the poses of the chain, as it sees them."""
    for q in 2.0 * np.pi * low_discrepancy(_LOOKS, 6):
        seen = np.array(wrist.seen(*arm.frames(q[None])[-1, 0].ravel().tolist()[:12]))
        t1, t2, t3, t4, t5, t6 = q + wrist.zeros
        t3, t5 = wrist.sense3 * t3, wrist.sense5 * t5
        link = wrist.a2 * rect(1.0, t2) + wrist.rho * rect(1.0, t2 + t3)
        base = _turn(t1) @ _twist(wrist.ca1, wrist.sa1)
        centre = _turn(t1)[:, 0] * wrist.a1 + base @ (link.real, link.imag, wrist.aside)
        R = base @ _turn(t2 + t3 + wrist.lean) @ _ACROSS @ _turn(t4) @ _twist(0.0, 1.0)
        R = R @ _turn(t5) @ _twist(0.0, 1.0) @ _turn(t6)
        if float(np.abs(seen - np.concatenate((R[:, 0], R[:, 2], centre))).max()) > THE_SAME:
            return False
    return True


_ACROSS = np.array(((0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)))
"""Axis 4 along the links, x across them in their plane."""


def _turn(angle: float) -> Array:
    c, s = cos(angle), sin(angle)
    return np.array(((c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0)))


def _twist(c: float, s: float) -> Array:
    return np.array(((1.0, 0.0, 0.0), (0.0, c, -s), (0.0, s, c)))
