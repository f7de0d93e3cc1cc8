"""The closed form of an arm with a wrist for one target that is well away from singularities.

Most industrial arms have parallel axes 2 and 3 and a wrist at right angles. Then each equation has two roots,

    p_x = ±√(x² + y² - p_y²),   θ_3 = ±acos k/(2 a_2 ρ),   and θ_4, θ_5, θ_6 or θ_4 + π, -θ_5, θ_6 + π,

and |det J| = |sin α_1 p_x a_2 ρ sin θ_3 sin θ_5|, which says at once whether the arm is near a singularity:
only where it is not are there answers here. All is done on floats: some hundred operations cost less than a
few of numpy's calls. What is tedious is recorded in `wrist_tapes`.

Each solution is judged by forward kinematics in the same normal form: of the wrist's centre, and of the
rotation that the wrist has to make. That the form is the chain itself is checked once, when it is made.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from kinematics.evaluation.straight_line import function_of_floats
from kinematics.inverse.arm import Arm, Array, low_discrepancy
from kinematics.inverse.components import LONG, lost_value, merging_value
from kinematics.inverse.wrist import ALMOST, WristArm
from kinematics.inverse.wrist_blocks import CLEARLY
from kinematics.inverse.wrist_tapes import centre_error_tape, left_over_tape, wrist_error_tape
from kinematics.se3 import inverse_transform

THE_SAME = 1e-13
"""Largest entry by which the normal form may be off the chain, lengths in units of the size: rounding."""

EXACT = 1e-12
"""What is off by more than this [rad, and parts of the size] is left to Newton's steps."""

APART = 0.5 * LONG
"""Solutions that differ by twice this in an angle are not joined across a fold: they may be as near to a
singularity as a solution that stands alone may."""

FOLD = 72.0
"""A wrist's centre that is known to within δ has p_x² known to within 2δ, lengths in units of the size: with
36 times as much, p_x is off by a seventieth of itself at most."""

FARTHER = 16.0
"""k = p_x² + g_2² - … moves by at most four times what the wrist's centre and p_x do, and (2 a_2 ρ)² - k² by
4 a_2 ρ times that where it vanishes; twice as much is beyond reach."""

FLIPPED = 1e-15
"""What adding π to two angles leaves of rounding [rad]."""

_LOOKS = 5
"""Configurations at which a closed form recorded for an arm is tried before it is believed."""


class ClearSolution(NamedTuple):
    """A solution, and how far off it is.

    Attributes:
        joints: q_1 … q_6, turns in (-π, π].
        position_error: distance from the target [m], at most.
        orientation_error: angle from the target [rad].
    """

    joints: tuple[float, ...]
    position_error: float
    orientation_error: float


@dataclass(frozen=True, eq=False)
class ClearWrist:
    """A level arm with a wrist at right angles.

    Attributes:
        wrist: its closed form.
        lever: distance from the wrist's centre to the tool's origin [m].
        least_volume: |det J| divided by the least singular value, at most.
        spread: how far the wrist's centre may be off for each unit of tolerance, in the arm's size.
        seen: (12, 16) from a target's entries to the nine of R and the three of p that the normal form sees.
        left_over, wrist_error, centre_error: the recorded computations as functions.
    """

    wrist: WristArm
    lever: float
    least_volume: float
    spread: float
    seen: Array
    left_over: Callable[..., tuple[float, ...]]
    wrist_error: Callable[..., tuple[float, ...]]
    centre_error: Callable[..., tuple[float, ...]]

    def solutions(self, target: Array, tolerance: float) -> list[ClearSolution] | None:
        """All solutions, or None near a singularity, at the edge of the reach, or beyond it.

        Args:
            target: (4, 4).
            tolerance: distance [m] and angle [rad] within which the target is reached.
        """
        w = self.wrist
        a1, ca1, sa1, d2, a2, ca2, _, rho, zeta = w.head
        n1, n2, n3, n4, n5, n6, n7, n8, n9, x, y, z = (self.seen @ target.ravel()).tolist()
        x, y, z = x / w.size, y / w.size, z / w.size
        lost, least = _least_values(tolerance)
        lost, least = self.least_volume * lost, self.least_volume * least
        off_centre = tolerance * self.spread
        sideways = off_centre + math.sqrt(off_centre / FOLD)
        f3 = d2 + ca2 * zeta
        g2 = (z - ca1 * f3) / sa1
        py = ca1 * g2 - sa1 * f3
        argument = x * x + y * y - py * py
        if argument <= FOLD * off_centre:
            return None
        root, length = math.sqrt(argument), 2.0 * a2 * rho
        beyond = length * max(CLEARLY * length, FARTHER * sideways)
        apart = root > APART * math.hypot(root, py)
        found: list[ClearSolution] = []
        for px in (root, -root):
            g1 = px - a1
            k = g1 * g1 + g2 * g2 - a2 * a2 - rho * rho
            across = (length - k) * (length + k)
            if across < -beyond:
                continue
            bent = math.sqrt(max(across, 0.0))
            volume = 0.5 * abs(sa1) * root * bent
            if volume <= lost:
                return None
            t1 = math.atan2(y * px - x * py, x * px + y * py)
            c1, s1 = math.cos(t1), math.sin(t1)
            half = math.acos(k / length)
            for t3 in (half, -half):
                c3, s3 = math.cos(t3), math.sin(t3)
                f1, f2 = a2 + rho * c3, ca2 * rho * s3
                t2 = math.atan2(f1 * g2 - f2 * g1, f1 * g1 + f2 * g2)
                c2, s2 = math.cos(t2), math.sin(t2)
                N = self.left_over(c1, s1, c2, s2, c3, s3, n1, n2, n3, n4, n5, n6, n7, n8, n9)
                away = w.size * math.sqrt(self.centre_error(c1, s1, c2, s2, c3, s3, x, y, z)[0])
                sine = math.hypot(N[2], N[5])
                alone = apart and bent > APART * length and sine > APART
                if volume * sine <= (lost if alone else least):
                    return None
                (t4, t5, t6), flipped = _right_wrist(w.wrist[1], w.wrist[3], N)
                off = self.wrist_error(
                    math.cos(t4), math.sin(t4), math.cos(t5), math.sin(t5), math.cos(t6), math.sin(t6), *N
                )[0]
                angle = math.sqrt(0.5 * off)
                if angle > EXACT or away > EXACT * w.size:
                    return None
                o1, o2, o3, o4, o5, o6 = w.zeros
                q1, q2, q3 = _turned(t1, o1), _turned(t2, o2), _turned(t3, o3)
                joints = q1, q2, q3, _turned(t4, o4), _turned(t5, o5), _turned(t6, o6)
                found.append(ClearSolution(joints, away + self.lever * angle, angle))
                t4, t5, t6 = flipped  # they make the same rotation
                angle += FLIPPED
                joints = q1, q2, q3, _turned(t4, o4), _turned(t5, o5), _turned(t6, o6)
                found.append(ClearSolution(joints, away + self.lever * angle, angle))
        return found or None


def _right_wrist(
    sa4: float, sa5: float, N: tuple[float, ...]
) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
    """Both ways of a wrist whose axes are at right angles; sa4 and sa5 are ±1."""
    n11, _, x, n21, _, y, n31, _, z = N
    s5 = math.hypot(x, y)
    c5 = -z * sa4 * sa5
    c4, s4 = x * sa5 / s5, y * sa5 / s5
    t4, t5 = math.atan2(s4, c4), math.atan2(s5, c5)
    t6 = math.atan2(-sa4 * sa5 * (c4 * n21 - s4 * n11), c5 * (c4 * n11 + s4 * n21) + s5 * sa4 * n31)
    return (t4, t5, t6), (t4 + math.pi, -t5, t6 + math.pi)


@lru_cache(maxsize=256)
def _least_values(tolerance: float) -> tuple[float, float]:
    return lost_value(tolerance), merging_value(tolerance)


def _seen(wrist: WristArm) -> Array:
    """(12, 16): T ↦ before · T · after on the entries of T, the last row left out."""
    both = np.einsum("ik,lj->ijkl", wrist.before, wrist.after).reshape(4, 4, 16)
    return np.concatenate((both[:3, :3].reshape(9, 16), both[:3, 3]))


def _turned(turn: float, zero: float) -> float:
    """The joint variable in (-π, π]."""
    q = turn - zero
    return q if -math.pi < q <= math.pi else q - math.tau * math.ceil((q - math.pi) / math.tau)


def clear_wrist_of(arm: Arm, wrist: WristArm) -> ClearWrist | None:
    """The scalar closed form of an arm, or None if it is not level or its wrist is not at right angles."""
    head = wrist.head
    ca4, _, ca5, _ = wrist.wrist
    if not (head.sa2 == 0.0 == ca4 == ca5 and abs(head.sa1) > ALMOST) or not _is_the_chain(arm, wrist):
        return None
    lever = float(np.linalg.norm(inverse_transform(wrist.after)[:3, 3]))
    return ClearWrist(
        wrist=wrist,
        lever=lever,
        spread=(1.0 + lever) / wrist.size,
        seen=_seen(wrist),
        least_volume=arm.larger_five,
        left_over=function_of_floats(left_over_tape(wrist)),
        wrist_error=function_of_floats(wrist_error_tape(wrist.wrist)),
        centre_error=function_of_floats(centre_error_tape(head)),
    )


def _is_the_chain(arm: Arm, wrist: WristArm) -> bool:
    """Whether the normal form makes the poses of the chain."""
    head, (ca4, sa4, ca5, sa5) = wrist.head, wrist.wrist
    link = np.eye(4)
    link[:3, :3] = np.array(wrist.link).T
    link[:3, 3] = head.radius * wrist.size, 0.0, head.height * wrist.size
    links = [
        _link(head.a1 * wrist.size, head.ca1, head.sa1, head.d2 * wrist.size),
        _link(head.a2 * wrist.size, head.ca2, head.sa2, 0.0),
        link,
        _link(0.0, ca4, sa4, 0.0),
        _link(0.0, ca5, sa5, 0.0),
        np.eye(4),
    ]
    before, after = inverse_transform(wrist.before), inverse_transform(wrist.after)
    for q in 2.0 * np.pi * low_discrepancy(_LOOKS, 6):
        pose = before
        for value, zero, K in zip(q, wrist.zeros, links, strict=True):
            c, s = math.cos(value + zero), math.sin(value + zero)
            turn = np.array(((c, -s, 0, 0), (s, c, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)))
            pose = pose @ turn @ K
        off = pose @ after - arm.frames(q[None])[-1, 0]
        off[:3, 3] /= wrist.size
        if float(np.abs(off).max()) > THE_SAME:
            return False
    return True


def _link(a: float, c: float, s: float, d: float) -> Array:
    """Trans_x(a) Rot_x(α) Trans_z(d)."""
    return np.array(((1, 0, 0, a), (0, c, -s, -s * d), (0, s, c, c * d), (0, 0, 0, 1)), dtype=np.float64)
