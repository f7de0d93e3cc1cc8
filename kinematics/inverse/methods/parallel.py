"""Arms of six revolute joints of which three neighbouring ones have parallel axes, in closed form.

The product P of three turns about axes along h is a motion in the planes across h: it leaves h, and heights
along h, as they are. With T' = T T(0)⁻¹ = E_1 ⋯ E_6, the joints before and after obey three equations
without the three parallel ones. With joints 2, 3, 4 parallel (Universal Robots)

    h·E_1⁻¹ T' x = h·E_5 E_6 x   for every x,

of which the direction z_6 and a point of axis 6 give two equations in q_1 and q_5 alone, linear in their
cosines and sines; q_6 follows from the direction that h has in the end-effector, and P is a planar arm of two
links. With joints 1, 2, 3 parallel the direction u = E_6 v that h has before joint 6, v = R'ᵀ h, obeys three
linear equations whose coefficients contain q_5 only; |u| = 1 leaves one equation in q_5.

Source: for the Universal Robots' case, K. P. Hawkins, Analytic inverse kinematics for the Universal Robots
UR-5/UR-10 arms (2013), with arms whose axes 5 and 6 do not meet; here for any axes.
"""

import math
from dataclasses import dataclass

import numpy as np

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.methods.axis_lines import ALMOST, angle_about
from kinematics.inverse.methods.trigonometric import linear_roots, quadratic_roots, rotations, sampled_roots
from kinematics.se3 import cross_arrays, inverse_transform

PARALLEL = 1e-7
"""Sine of the angle between axes that count as parallel; Newton steps bring back what was neglected."""

LEVEL = 1e-3
"""Sine of the angle of axis 6 to the parallel ones up to which q_6 is tried at the planar arm's reach."""

SAME_HEIGHT = 1e-9
"""Coefficients below this, lengths in units of the arm's size, leave an equation without its angle."""


_ANYWHERE = (0.3, 1.4, 2.9, 4.1)
"""Angles at which a trigonometric polynomial of degree 2 is zero if everywhere, or by rare chance."""


@dataclass(frozen=True, eq=False)
class ParallelArm:
    """The closed form of an arm with three parallel axes.

    Attributes:
        z: (6, 3) directions and
        p: (6, 3) points of the axes at q = 0, lengths in units of the size.
        first: index of the first parallel axis, 0 or 1.
        end: (4, 4) inverse of the end pose at q = 0.
        size: the arm's size.
    """

    z: Array
    p: Array
    first: int
    end: Array
    size: float

    def candidates(self, target: Array) -> Array | None:
        """See `InverseClosedForm`."""
        moved = target @ self.end
        R, t = moved[:3, :3], moved[:3, 3] / self.size
        ends = self._middle(R, t) if self.first == 1 else self._outside(R, t)
        if ends is None:
            return None
        found = []
        for before, after in ends:
            Q, s = self._left_over(R, t, before, after)
            found += [[*before, *turns, *after] for turns in self._planar(Q, s)]
        return np.array(found).reshape(-1, 6)

    def _middle(self, R: Array, t: Array) -> list[tuple[list[float], list[float]]] | None:
        """q_1 and (q_5, q_6) where joints 2, 3, 4 are parallel."""
        z, p, h = self.z, self.p, self.z[1]
        end = _wave(h, z[4], z[5])
        meets = _foot(z[5], p[5], z[4], p[4])
        level = _wave(h, z[4], meets - p[4])
        level = (level[0], level[1], level[2] + float(h @ p[4]))
        seen_end = _wave_back(h, z[0], R @ z[5])
        seen_level = _wave_back(h, z[0], R @ meets + t - p[0])
        seen_level = (seen_level[0], seen_level[1], seen_level[2] + float(h @ p[0]))
        firsts = _first_turns(seen_end, seen_level, end, level)
        if firsts is None:
            return None
        found = []
        for q1 in firsts:
            v = R.T @ rotations(z[0], q1) @ h
            fifths = _turns_to(h, z[4], z[5], v)
            if fifths is None:  # axes 5 and 6 are parallel, and h is level with them: only the height tells
                height = seen_level[0] * math.cos(q1) + seen_level[1] * math.sin(q1) + seen_level[2]
                fifths = linear_roots(level[0], level[1], height - level[2])
            for q5 in fifths or ():
                before = rotations(z[4], -q5) @ h
                sixths = [angle_about(z[5], v, before)]
                if float(np.linalg.norm(cross_arrays(before, z[5]))) <= LEVEL:
                    sixths += self._at_the_reach(R, t, q1, q5)
                found += [([q1], [q5, q6]) for q6 in sixths]
        return found

    def _at_the_reach(self, R: Array, t: Array, q1: float, q5: float) -> list[float]:
        """q_6 with the planar arm stretched or folded, or as near to it as may be.

        Where axis 6 is parallel to the three, q_6 is free as long as the planar arm reaches.
        """
        squares = [self._goal(*self._left_over(R, t, [q1], [q5, q6])) for q6 in (0.0, math.pi, math.pi / 2)]
        ahead, behind, aside = (float(goal @ goal) for goal in squares)
        middle, c = 0.5 * (ahead + behind), 0.5 * (ahead - behind)
        s = aside - middle
        farthest = math.atan2(s, c)
        upper, fore = (float(np.linalg.norm(link)) for link in self._links())
        limits = (linear_roots(c, s, (upper + sign * fore) ** 2 - middle) for sign in (1.0, -1.0))
        return [farthest, farthest + math.pi, *(q6 for roots in limits for q6 in roots or ())]

    def _outside(self, R: Array, t: Array) -> list[tuple[list[float], list[float]]] | None:
        """q_4, q_5, q_6 where joints 1, 2, 3 are parallel: u = E_6 v obeys rows(q_5) u = k, and |u| = 1."""
        z, p, h = self.z, self.p, self.z[0]
        v = R.T @ h
        k = np.array((z[3] @ h, h @ (p[3] - t) - v @ p[5], v @ z[5]))
        flat = max(abs(float(np.linalg.det(self._rows(q5)))) for q5 in _ANYWHERE) <= SAME_HEIGHT
        if flat:  # all rows are across axis 5: they contradict each other but for some q_5
            fifths = sampled_roots(lambda q5: float(z[4] @ _numerator(self._rows(q5), k)), 2)
        else:
            fifths = sampled_roots(lambda q5: _excess(self._rows(q5), k), 4)
        if fifths is None:
            return None
        found: list[tuple[list[float], list[float]]] = []
        for q5 in fifths:
            u = np.linalg.lstsq(self._rows(q5), k, rcond=1e-6 if flat else 1e-9)[0]
            rise = math.sqrt(max(1.0 - float(u @ u), 0.0)) * z[4] if flat else np.zeros(3)
            for up in (u + rise, u - rise) if flat else (u,):
                q6 = angle_about(z[5], v, up)
                before = rotations(z[4], q5) @ rotations(z[5], q6) @ v
                found.append(([], [angle_about(z[3], before, h), q5, q6]))
        return found

    def _rows(self, q5: float) -> Array:
        """(3, 3): what u is measured with, R_5ᵀ z_4, E_5⁻¹ p_4 - p_6 and z_6."""
        z, p = self.z, self.p
        back = rotations(z[4], -q5)
        return np.array((back @ z[3], back @ (p[3] - p[4]) + p[4] - p[5], z[5]))

    def _left_over(self, R: Array, t: Array, before: list[float], after: list[float]) -> tuple[Array, Array]:
        """The planar motion (E_before)⁻¹ T' (E_after)⁻¹, as rotation and translation."""
        for i, q in reversed(list(enumerate(after, 6 - len(after)))):
            R = R @ rotations(self.z[i], -q)
            # T' E⁻¹ x = R (E x) with E x = Q x + p − Q p; only what moves the origin is left to add.
            t = t + R @ rotations(self.z[i], q) @ self.p[i] - R @ self.p[i]
        for i, q in enumerate(before):
            Q = rotations(self.z[i], -q)
            R, t = Q @ R, Q @ (t - self.p[i]) + self.p[i]
        return R, t

    def _goal(self, Q: Array, s: Array) -> Array:
        """Where a planar motion x ↦ Q x + s leads the third parallel axis, seen from the first."""
        goal = Q @ self.p[self.first + 2] + s - self.p[self.first]
        return self._across(goal)

    def _links(self) -> tuple[Array, Array]:
        """The ways between the parallel axes at q = 0, across them."""
        p1, p2, p3 = self.p[self.first : self.first + 3]
        return self._across(p2 - p1), self._across(p3 - p2)

    def _across(self, way: Array) -> Array:
        h = self.z[self.first]
        return np.asarray(way - (way @ h) * h)

    def _planar(self, Q: Array, s: Array) -> list[list[float]]:
        """Both ways for three parallel joints to make a planar motion x ↦ Q x + s."""
        i = self.first
        h = self.z[i]
        goal = self._goal(Q, s)
        upper, fore = self._links()
        aside = cross_arrays(h, fore)
        middle = linear_roots(
            2.0 * float(upper @ fore),
            2.0 * float(upper @ aside),
            float(goal @ goal - upper @ upper - fore @ fore),
        )
        if middle is None:
            return []
        across = np.linalg.svd(h[None])[2][1]
        whole = angle_about(h, across, Q @ across)
        senses = [1.0 if float(z @ h) > 0.0 else -1.0 for z in self.z[i : i + 3]]
        found = []
        for second in middle:
            reached = upper + math.cos(second) * fore + math.sin(second) * aside
            first = angle_about(h, reached, goal)
            turns = (first, second, whole - first - second)
            found.append([sense * turn for sense, turn in zip(senses, turns, strict=True)])
        return found


def parallel_arm_of(arm: Arm) -> ParallelArm | None:
    """Return the closed form of an arm, or None if neither joints 1, 2, 3 nor 2, 3, 4 of it are parallel."""
    if arm.n_joints != 6 or not arm.revolute.all():
        return None
    z, p, end = arm.screws
    sines = np.linalg.norm(cross_arrays(z[:-1], z[1:]), axis=1)
    for first in (1, 0):
        if sines[first] <= PARALLEL and sines[first + 1] <= PARALLEL:
            return ParallelArm(z, p / arm.size, first, inverse_transform(end), arm.size)
    return None


def _numerator(rows: Array, k: Array) -> Array:
    """det(rows) times the u with rows·u = k, by Cramer's rule."""
    a, b, c = rows
    return np.asarray(k[0] * cross_arrays(b, c) + k[1] * cross_arrays(c, a) + k[2] * cross_arrays(a, b))


def _excess(rows: Array, k: Array) -> float:
    """|u|² - 1, times det(rows)²."""
    up = _numerator(rows, k)
    return float(up @ up) - float(rows[0] @ cross_arrays(rows[1], rows[2])) ** 2


def _first_turns(
    seen_end: tuple[float, float, float],
    seen_level: tuple[float, float, float],
    end: tuple[float, float, float],
    level: tuple[float, float, float],
) -> list[float] | tuple[float, ...] | None:
    """q_1 with seen_end(q_1) = end(q_5) and seen_level(q_1) = level(q_5), each c·cos + s·sin + k."""
    (a, b, e), (c, d, f) = (end[0], end[1], end[2]), (level[0], level[1], level[2])
    A, B, E = seen_end
    C, D, F = seen_level
    if math.hypot(c, d) <= SAME_HEIGHT:
        return linear_roots(C, D, f - F)
    determinant = a * d - b * c
    if math.hypot(a, b) <= SAME_HEIGHT:
        return linear_roots(A, B, e - E)
    if abs(determinant) <= SAME_HEIGHT * math.hypot(a, b):
        ratio = (a * c + b * d) / (a * a + b * b)  # the level's wave is this many times the end's
        return linear_roots(C - ratio * A, D - ratio * B, f - F - ratio * (e - E))
    # (cos q5, sin q5) = (U, V), both linear in cos q1 and sin q1.
    E, F = E - e, F - f
    uc, us, u0 = ((d * x - b * y) / determinant for x, y in ((A, C), (B, D), (E, F)))
    vc, vs, v0 = ((a * y - c * x) / determinant for x, y in ((A, C), (B, D), (E, F)))
    return quadratic_roots(
        uc * uc + vc * vc,
        2.0 * (uc * us + vc * vs),
        us * us + vs * vs,
        2.0 * (uc * u0 + vc * v0),
        2.0 * (us * u0 + vs * v0),
        u0 * u0 + v0 * v0 - 1.0,
    )


def _wave(h: Array, z: Array, w: Array) -> tuple[float, float, float]:
    """(c, s, k) with h·Rot(z, q) w = c·cos q + s·sin q + k."""
    k = float((z @ w) * (h @ z))
    return float(h @ w) - k, float(h @ cross_arrays(z, w)), k


def _wave_back(h: Array, z: Array, w: Array) -> tuple[float, float, float]:
    """(c, s, k) with h·Rot(z, -q) w = c·cos q + s·sin q + k."""
    c, s, k = _wave(h, z, w)
    return c, -s, k


def _foot(z: Array, p: Array, other: Array, q: Array) -> Array:
    """The point of an axis that is nearest to another; its own where they are parallel."""
    normal = cross_arrays(z, other)
    square = float(normal @ normal)
    if square <= ALMOST**2:
        return p
    return np.asarray(p + (float(cross_arrays(q - p, other) @ normal) / square) * z)


def _turns_to(h: Array, z5: Array, z6: Array, v: Array) -> tuple[float, ...] | None:
    """Return q_5 with h·Rot(z_5, q_5) z_6 = v·z_6, for right angles by v across z_6; None if all do."""
    c, s, k = _wave(h, z5, z6)
    if math.hypot(c, s) <= SAME_HEIGHT:
        return None
    if abs(k) <= ALMOST and abs(math.hypot(c, s) - 1.0) <= ALMOST:
        middle = math.atan2(s, c)
        half = math.atan2(float(np.linalg.norm(cross_arrays(v, z6))), float(v @ z6))
        return middle - half, middle + half
    return linear_roots(c, s, float(v @ z6) - k)
