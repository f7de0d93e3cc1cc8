"""Three joints, turning or sliding, that bring points to their places: E_1(q_1) E_2(q_2) E_3(q_3) w_j = p_j.

Pieper's elimination, for any three joints and any number of points. Joint 1 is eliminated by what it cannot
change: turning about an axis it keeps a point's height along the axis and its distance from a point of the
axis, sliding it keeps both coordinates across. What remains is linear in joint 2, in its cosine and sine
or in its displacement, so joint 2 is eliminated next; the equation in q_3 alone is a polynomial of known
degree, in e^{iq} or in q, and is found by sampling.

Source: D. L. Pieper, The kinematics of manipulators under computer control (1968) §III.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Array
from kinematics.se3 import cross_arrays

_NOTHING = 1e-11  # A quantity this small beside its terms is zero for every q.

_NEARLY_REAL = 0.1
"""Roots this near to the real line (or to the unit circle) are tried: a target with three decimals moves a
double root by some √1e-3, and what is tried in vain costs little."""

_NEARLY_ZERO = 1e-6
"""An equation without unknowns is contradictory if it is off by more than this, in units of the size."""

_ON_AXIS = 1e-7  # Points as near to an axis as this, in units of the size, do not tell the angle about it.

_TURN_SAMPLES = 16
_TURN_DEGREE = 4
_SLIDE_SAMPLES = 12
_SLIDE_DEGREE = 6
"""Degrees of the eliminant in e^{iq} and in a slide, and samples that it is interpolated from: more than its
coefficients, which averages their rounding."""


class DegenerateError(Exception):
    """The equations leave a joint undetermined for this target."""


@dataclass(frozen=True, slots=True)
class Joint:
    """One joint at q = 0, in the world.

    Attributes:
        turns: whether it turns.
        axis: (3,) unit direction.
        point: (3,) a point of the axis.
    """

    revolute: bool
    axis: Array
    point: Array

    def moved(self, points: Array, q: float) -> Array:
        """Return the (k, 3) points moved by q."""
        if not self.revolute:
            return points + q * self.axis
        v = points - self.point
        along = (v @ self.axis)[:, None] * self.axis
        across = v - along
        turned = np.cos(q) * across + np.sin(q) * cross_arrays(self.axis, across)
        return np.asarray(self.point + along + turned)

    def lever(self, points: Array) -> float:
        """Return the largest distance of (k, 3) points from the axis; infinite of a joint that slides."""
        if not self.revolute:
            return np.inf
        v = points - self.point
        return float(np.linalg.norm(v - (v @ self.axis)[:, None] * self.axis, axis=1).max())

    def to(self, points: Array, places: Array) -> float:
        """Return the q that brings (k, 3) points to their places, as nearly as may be; 0 if every q does."""
        if not self.revolute:
            return float(((places - points) @ self.axis).mean())
        u, v = points - self.point, places - self.point
        u = u - (u @ self.axis)[:, None] * self.axis
        v = v - (v @ self.axis)[:, None] * self.axis
        sine, cosine = float((cross_arrays(u, v) @ self.axis).sum()), float((u * v).sum())
        return float(np.arctan2(sine, cosine)) if sine or cosine else 0.0


def place_points(joints: Sequence[Joint], points: Array, places: Array, size: float) -> list[list[float]]:
    """Return candidates for q_1 … q_n, n ≤ 3, that bring points to their places: near every solution is one.

    Args:
        joints: at most three joints, base first.
        points: (k, 3) the points at q = 0.
        places: (k, 3) where they are to go.
        size: the arm's size.

    Raises:
        DegenerateError: the equations do not determine the joints.
    """
    if not joints:
        return [[]]
    if len(joints) == 1:
        return [[_first(joints[0], points, places, size)]]
    second = _Second(joints[0], joints[1], places, size)
    thirds: list[float | None] = [None]
    if len(joints) == 3:
        thirds = list(_roots(second, joints[2], points, size + float(np.abs(places).max())))
    found = []
    for q3 in thirds:
        y = points if q3 is None else joints[2].moved(points, q3)
        for q2 in second.values(second.system(y)):
            q1 = _first(joints[0], joints[1].moved(y, q2), places, size)
            found.append([q1, q2] if q3 is None else [q1, q2, q3])
    return found


def _first(joint: Joint, points: Array, places: Array, size: float) -> float:
    """q_1, unless all points lie on its axis."""
    if joint.lever(points) <= _ON_AXIS * size:
        raise DegenerateError
    return joint.to(points, places)


@dataclass(frozen=True, slots=True)
class _System:
    """A u = b for joint 2, u = (cos q_2, sin q_2) or (q_2); with it c² + s² = 1, or q_2² + β q_2 + γ = 0.

    Attributes:
        A: (rows, 2) or (rows, 1).
        b: (rows,).
        closing: (β, γ) of a joint that slides after one that turns, else None.
    """

    A: Array
    b: Array
    closing: tuple[float, float] | None


class _Second:
    """The equations for joint 2, once joint 1 is eliminated; lengths in units of the size."""

    def __init__(self, first: Joint, second: Joint, places: Array, size: float) -> None:
        self.first, self.second, self.size = first, second, size
        self.centre = first.point
        if first.revolute:
            self.functionals = first.axis[None]
            w = places - self.centre
            self.distances: Array | None = (w * w).sum(axis=1) / size**2
        else:
            self.functionals = np.linalg.svd(first.axis[None])[2][1:]
            self.distances = None
        self.heights = places @ self.functionals.T / size

    def system(self, y: Array) -> _System:
        """Return the equations for given y = E_3(q_3) w, (k, 3)."""
        return self._revolute_second(y) if self.second.revolute else self._prismatic_second(y)

    def _revolute_second(self, y: Array) -> _System:
        """g·E_2 y = k and |E_2 y - o|² = |y - c|² + |c - o|² + 2 (c - o)·(E_2 y - c) = ρ²."""
        h, c, g, size = self.second.axis, self.second.point, self.functionals, self.size
        v = y - c
        along = (v @ h)[:, None] * h
        across = v - along
        aside = cross_arrays(h, across)
        A = [np.stack((across @ g.T, aside @ g.T), axis=-1).reshape(-1, 2) / size]
        b = [(self.heights - (along + c) @ g.T / size).ravel()]
        if self.distances is not None:
            o = 2.0 * (c - self.centre)
            A.append(np.column_stack((across @ o, aside @ o)) / size**2)
            b.append(self.distances - ((v * v).sum(axis=1) + along @ o + o @ o / 4.0) / size**2)
        return _System(np.concatenate(A), np.concatenate(b), None)

    def _prismatic_second(self, y: Array) -> _System:
        """g·(y + q h) = k and |y + q h - o|² = ρ²; of the squares only one is kept as such."""
        h, g, size = self.second.axis, self.functionals, self.size
        A = [np.broadcast_to(g @ h, (len(y), len(g))).reshape(-1, 1)]
        b = [(self.heights - y @ g.T / size).ravel()]
        if self.distances is None:
            return _System(np.concatenate(A), np.concatenate(b), None)
        v = y - self.centre
        beta = 2.0 * (v @ h) / size
        gamma = (v * v).sum(axis=1) / size**2 - self.distances
        A.append((beta[1:] - beta[0])[:, None])
        b.append(gamma[0] - gamma[1:])
        return _System(np.concatenate(A), np.concatenate(b), (float(beta[0]), float(gamma[0])))

    def values(self, system: _System) -> Iterator[float]:
        """Yield the candidates for q_2."""
        A, b = system.A, system.b
        left, scales, right = np.linalg.svd(A, full_matrices=False)
        if self.second.revolute:
            if scales[0] <= _NOTHING:
                _refuse_if_solved(b)
                return
            along = (left.T @ b) / np.maximum(scales, 1e-12 * scales[0])
            if scales[1] > 1e-9 * scales[0]:
                c, s = right.T @ along
                yield float(np.arctan2(s, c))
            if scales[1] <= 1e-3 * scales[0]:
                half = float(np.arccos(np.clip(along[0], -1.0, 1.0)))
                middle = float(np.arctan2(right[0, 1], right[0, 0]))
                yield from (middle - half, middle + half)
            return
        if scales[0] > 1e-9:
            yield float(A[:, 0] @ b) / float(A[:, 0] @ A[:, 0]) * self.size
        if scales[0] <= 1e-3:
            if system.closing is None:
                if scales[0] <= 1e-9:
                    _refuse_if_solved(b)
                return
            beta, gamma = system.closing
            root = float(np.sqrt(max(beta * beta - 4.0 * gamma, 0.0)))
            yield from ((-beta - root) / 2.0 * self.size, (-beta + root) / 2.0 * self.size)

    def eliminant(self, systems: Sequence[_System]) -> Array:
        """Return the equation that remains when q_2 is eliminated, at many q_3; zero at solutions."""
        A = np.array([system.A for system in systems])
        b = np.array([system.b for system in systems])
        rows = A.transpose(1, 0, 2).reshape(A.shape[1], -1)
        left, scales, _ = np.linalg.svd(rows)
        rank = int((scales > _NOTHING * max(float(scales[0]), 1.0)).sum())
        without = b @ left[:, rank:]
        # What is the same for every q_3 is how far a target was rounded, and tells nothing of q_3.
        if without.size and float(np.ptp(without, axis=0).max()) > _NOTHING:
            return np.asarray(without @ np.cos(np.arange(1.0, without.shape[1] + 1.0)))
        if rank == 0:
            raise DegenerateError
        A, b = np.einsum("ri,srj->sij", left[:, :rank], A), b @ left[:, :rank]
        if self.second.revolute:
            if rank == 1:
                raise DegenerateError
            determinant = A[:, 0, 0] * A[:, 1, 1] - A[:, 0, 1] * A[:, 1, 0]
            c = A[:, 1, 1] * b[:, 0] - A[:, 0, 1] * b[:, 1]
            s = A[:, 0, 0] * b[:, 1] - A[:, 1, 0] * b[:, 0]
            return np.asarray(c * c + s * s - determinant * determinant)
        if rank > 1:
            crossed = np.asarray(A[:, 0, 0] * b[:, 1] - A[:, 1, 0] * b[:, 0])
            if float(np.abs(crossed).max()) > _NOTHING:
                return crossed
        closings = [system.closing for system in systems if system.closing is not None]
        if not closings:
            raise DegenerateError
        beta, gamma = np.array(closings).T
        return np.asarray(b[:, 0] ** 2 + beta * b[:, 0] * A[:, 0, 0] + gamma * A[:, 0, 0] ** 2)


def _refuse_if_solved(b: Array) -> None:
    """Of equations without q_2: they contradict each other and have no solution, or hold for every q_2.

    Raises:
        DegenerateError: they hold for every q_2.
    """
    if float(np.abs(b).max()) <= _NEARLY_ZERO:
        raise DegenerateError


def _roots(second: _Second, third: Joint, points: Array, reach: float) -> Iterator[float]:
    """Real roots of the eliminant in q_3: of degree 4 at most in e^{iq}, of degree 6 at most in a slide."""

    def values(qs: Array) -> Array:
        return second.eliminant([second.system(third.moved(points, float(q))) for q in qs])

    yield from _turn_roots(values) if third.revolute else _slide_roots(values, reach)


def _turn_roots(values: Callable[[Array], Array]) -> Iterator[float]:
    qs = 2.0 * np.pi * np.arange(_TURN_SAMPLES) / _TURN_SAMPLES
    spectrum = np.fft.fft(values(qs)) / _TURN_SAMPLES
    rising = np.concatenate((spectrum[-_TURN_DEGREE:], spectrum[: _TURN_DEGREE + 1]))
    for root in _polynomial_roots(rising):
        if abs(abs(root) - 1.0) <= _NEARLY_REAL:
            yield float(np.angle(root))


def _slide_roots(values: Callable[[Array], Array], reach: float) -> Iterator[float]:
    nodes = np.cos(np.pi * (np.arange(_SLIDE_SAMPLES) + 0.5) / _SLIDE_SAMPLES)
    series = np.polynomial.chebyshev.chebfit(nodes, values(reach * nodes), _SLIDE_DEGREE)
    for root in _polynomial_roots(np.polynomial.chebyshev.cheb2poly(series)):
        if abs(root.imag) <= _NEARLY_REAL * max(1.0, abs(root)):
            yield float(root.real) * reach


def _polynomial_roots(rising: NDArray[np.inexact[Any]]) -> list[complex]:
    """Roots of a polynomial, lowest power first; coefficients that are rounding do not count."""
    largest = float(np.abs(rising).max())
    if largest == 0.0:
        raise DegenerateError
    kept = np.where(np.abs(rising) > _NOTHING * largest, rising, 0.0)
    return [complex(root) for root in np.roots(kept[::-1])]
