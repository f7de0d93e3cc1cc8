"""Where equation (1) holds worst: a climb from the worst of the sampled configurations.

In one joint variable at a time, the difference D(q) = F_s(σ∘q + δ) - B · F_r(q) · E of the two sides is
D_0 + D_1 cos q_i + D_2 sin q_i (D_0 + D_1 q_i for a prismatic joint). So ‖D‖² is a trigonometric polynomial
of degree two (a convex parabola), and its maximum over the whole circle (over the prismatic joint's range) is
found directly. Going from joint to joint, forward and backward, until nothing is gained, ends where no single
joint makes it worse.
"""

from typing import NamedTuple

import numpy as np

from kinematics.chain import Chain, screw_bases
from kinematics.equivalence.bounds import upper_bound
from kinematics.equivalence.certificates import CertificateCandidate
from kinematics.equivalence.policy import Tolerance
from kinematics.equivalence.reference import Reference
from kinematics.equivalence.verification import Residual, differences, residual, rotation_from_square
from kinematics.se3 import Floats, to_matrix

ARITHMETIC = 1e-9  # [rad], and a share of the robot: smaller differences are errors of the arithmetic.
STARTS = 16
"""For displacement and for rotation. In 60 disturbed tables climbs from 16 found at least 99.5 % of what 400
climbs from 1024 configurations did."""
MOST_SWEEPS = 8  # A bound of the work: a climb ends where a sweep gains nothing.
GAIN = 1.005  # Less than half a per cent is not worth a sweep.
LONGEST_STEP = 0.2
"""[rad] Half the distance of the sixteen angles, from the best of which a Newton step is taken."""

_CIRCLE = np.linspace(-np.pi, np.pi, 16, endpoint=False)
_NONE, _ONE, _COS, _SIN = np.zeros_like(_CIRCLE), np.ones_like(_CIRCLE), np.cos(_CIRCLE), np.sin(_CIRCLE)


def _products(one: tuple[Floats, Floats, Floats], other: tuple[Floats, Floats, Floats]) -> Floats:
    """(9, 16) products of every entry of one vector with every entry of the other, around the circle."""
    return np.array([a * b for a in one for b in other])


_POINT, _VELOCITY = (_ONE, _COS, _SIN), (_NONE, -_SIN, _COS)
_ACCELERATION = (_NONE, -_COS, -_SIN)
_VALUES = _products(_POINT, _POINT)
_GRADIENTS = 2.0 * _products(_POINT, _VELOCITY)
_CURVATURES = 2.0 * (_products(_VELOCITY, _VELOCITY) + _products(_POINT, _ACCELERATION))


class WorstCase(NamedTuple):
    """The largest differences that were found.

    Attributes:
        residual: how large they are.
        joints: (n, 2·STARTS) the configurations to which the climbs led.
    """

    residual: Residual
    joints: Floats


def judged(
    reference: Reference,
    submission: Chain,
    candidate: CertificateCandidate,
    tolerance: Tolerance,
    *,
    measured: bool,
) -> Residual:
    """Return how far a certificate is from standing: at the samples, or, if it stands at these, at the worst.

    Differences no larger than the errors of the arithmetic are nothing to climb on; nor is anything gained
    by climbing where a bound over all configurations shows that the certificate stands.

    Args:
        tolerance: within what it must stand.
        measured: how far it is at the samples is wanted; else a bound within the tolerance will do.
    """
    if not measured:
        bound = upper_bound(reference, submission, candidate)
        if bound.within(tolerance):
            return bound
    found = residual(reference, submission, candidate)
    if max(found) <= ARITHMETIC or not found.within(tolerance):
        return found
    if upper_bound(reference, submission, candidate).within(tolerance):
        return found
    return worst_case(reference, submission, candidate).residual


def worst_case(reference: Reference, submission: Chain, candidate: CertificateCandidate) -> WorstCase:
    """Return the largest differences between the two sides of equation (1), over all configurations.

    Revolute joints go all the way round, prismatic joints as far as the robot's size either way. Half of the
    climbs go after the largest displacement, half after the largest rotation.
    """
    n = len(candidate.signs)
    difference = differences(reference, submission, candidate)
    shift = np.einsum("si,si->s", difference[:, :3, 3], difference[:, :3, 3])
    turn = np.einsum("sij,sij->s", difference[:, :3, :3], difference[:, :3, :3])
    starts = np.concatenate([np.argsort(shift)[-STARTS:], np.argsort(turn)[-STARTS:]])
    if not n:
        return WorstCase(_residual(shift.max(), turn.max(), reference), reference.joints[:, starts])
    climb = _Climb(reference, submission, candidate, reference.joints[:, starts])
    reached = np.zeros(2)
    for sweep in range(MOST_SWEEPS):
        squares = climb.forward_sweep() if sweep % 2 == 0 else climb.backward_sweep()
        before, reached = reached, squares.reshape(2, STARTS).max(axis=1)
        if (reached <= GAIN * before).all():
            break
    return WorstCase(_residual(reached[0], reached[1], reference), climb.joints)


def _residual(shift: float, turn: float, reference: Reference) -> Residual:
    return Residual(rotation_from_square(turn), float(np.sqrt(shift)) / reference.size)


class _Climb:
    """Climbs side by side: left and right side of the equation stacked, one row for each start.

    Attributes:
        joints: (n, k) where they are.
    """

    def __init__(
        self, reference: Reference, submission: Chain, candidate: CertificateCandidate, joints: Floats
    ) -> None:
        n, k = joints.shape
        self.joints = joints.copy()
        self._prismatic = [axis.prismatic for axis in reference.chain.axes]
        self._range = reference.size
        self._terms = _terms(reference, submission, candidate)
        self._before = np.empty((n + 1, 2, k, 4, 4))
        self._after = np.empty_like(self._before)
        self._before[0, 0], self._before[0, 1] = np.eye(4), to_matrix(candidate.base)
        self._after[n, 0] = to_matrix(submission.end)
        self._after[n, 1] = to_matrix(reference.chain.end) @ to_matrix(candidate.tool)
        for i in range(n - 1, -1, -1):
            self._after[i] = self._motion(i, self._weights(i)) @ self._after[i + 1]

    def forward_sweep(self) -> Floats:
        """Maximise over each joint, from the first to the last; return the (k,) squares that are reached."""
        for i in range(len(self.joints)):
            grams, weights = self._bested(i)
            self._before[i + 1] = self._before[i] @ self._motion(i, weights)
        return np.asarray(np.einsum("ki,kij,kj->k", weights, grams, weights), dtype=np.float64)

    def backward_sweep(self) -> Floats:
        """Maximise over each joint, from the last to the first; return the (k,) squares that are reached."""
        for i in range(len(self.joints) - 1, -1, -1):
            grams, weights = self._bested(i)
            self._after[i] = self._motion(i, weights) @ self._after[i + 1]
        return np.asarray(np.einsum("ki,kij,kj->k", weights, grams, weights), dtype=np.float64)

    def _bested(self, i: int) -> tuple[Floats, Floats]:
        """Move joint i to where it does worst, for every start.

        Returns:
            (k, 3, 3) the matrices G of the squares v G vᵀ, and (k, 3) the v of the new values.
        """
        sides = self._before[i][:, :, None] @ self._terms[i][:, None] @ self._after[i + 1][:, :, None]
        difference = sides[0] - sides[1]
        shifts = difference[:STARTS, :, :3, 3]
        turns = difference[STARTS:, :, :3, :3].reshape(STARTS, 3, 9)
        grams = np.concatenate([shifts @ shifts.transpose(0, 2, 1), turns @ turns.transpose(0, 2, 1)])
        if self._prismatic[i]:
            self.joints[i] = np.where(grams[:, 0, 1] >= 0.0, self._range, -self._range)
        else:
            self.joints[i] = _highest(grams.reshape(len(grams), 9))
        return grams, self._weights(i)

    def _weights(self, i: int) -> Floats:
        """(k, 3) what the terms of a joint's motion are multiplied by."""
        q = self.joints[i]
        weights = np.zeros((len(q), 3))
        weights[:, 0] = 1.0
        if self._prismatic[i]:
            weights[:, 1] = q
        else:
            np.cos(q, out=weights[:, 1])
            np.sin(q, out=weights[:, 2])
        return weights

    def _motion(self, i: int, weights: Floats) -> Floats:
        """(2, k, 4, 4) a joint's motion on either side."""
        flat = weights @ self._terms[i].reshape(2, 3, 16)
        return np.asarray(flat.reshape(2, len(weights), 4, 4), dtype=np.float64)


def _terms(reference: Reference, submission: Chain, candidate: CertificateCandidate) -> Floats:
    """Either side's joint motion is t_0 + t_1 cos q + t_2 sin q, or t_0 + t_1 q: the t, (n, 2, 3, 4, 4)."""
    n = len(candidate.signs)
    terms = np.zeros((n, 2, 3, 4, 4))
    ours = screw_bases(submission).reshape(n, 2, 4, 4)
    theirs = screw_bases(reference.chain).reshape(n, 2, 4, 4)
    for i, (sign, offset) in enumerate(zip(candidate.signs, candidate.offsets, strict=True)):
        a, b = ours[i]
        if reference.chain.axes[i].prismatic:
            terms[i, 0, 0], terms[i, 0, 1] = np.eye(4) + offset * a, sign * a
            terms[i, 1, 0], terms[i, 1, 1] = np.eye(4), theirs[i, 0]
            continue
        c, s = np.cos(offset), np.sin(offset)
        terms[i, 0] = np.eye(4) + b, s * a - c * b, sign * (c * a + s * b)
        terms[i, 1] = np.eye(4) + theirs[i, 1], -theirs[i, 1], theirs[i, 0]
    return terms


def _highest(grams: Floats) -> Floats:
    """The angle at which v G vᵀ with v = (1, cos x, sin x) is largest, for each of (k, 9) matrices G by rows.

    The best of 16 angles, and a Newton step from there.
    """
    nearest = (grams @ _VALUES).argmax(axis=1)
    gradient = np.einsum("kj,jk->k", grams, _GRADIENTS[:, nearest])
    curvature = np.einsum("kj,jk->k", grams, _CURVATURES[:, nearest])
    step = np.divide(-gradient, curvature, out=np.zeros_like(gradient), where=curvature < 0.0)
    return np.asarray(_CIRCLE[nearest] + np.clip(step, -LONGEST_STEP, LONGEST_STEP), dtype=np.float64)
