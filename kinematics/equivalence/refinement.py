"""Gauss–Newton on δ, B and E with σ held fixed.

Entries rounded to a few decimals are wrong by a little each, and an alignment, made joint by joint, may lever
that up (axes that are nearly parallel, long chains). The certificate that fits all sampled configurations
best is what such an answer deserves to be judged by. What the policy fixes stays fixed: only motions that
keep it are used.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from kinematics.chain import Chain, joint_motions
from kinematics.equivalence.certificates import CertificateCandidate
from kinematics.equivalence.meter import PER_DESCENT, PER_ROUND, Meter
from kinematics.equivalence.policy import Tolerance
from kinematics.equivalence.reference import Reference
from kinematics.equivalence.verification import Residual, joint_values, largest
from kinematics.equivalence.worst_case import worst_case
from kinematics.se3 import (
    IDENTITY,
    ORIGIN,
    Floats,
    Motion,
    Vector,
    compose,
    cross_arrays,
    norm,
    rotation_about,
    scale,
    to_matrix,
    translation,
    turns_between,
)

ROUNDS = 10  # A bound of the work: Gauss–Newton settles in a few rounds or not at all.
ITERATIONS = 12  # A bound of the work: mostly the bounds from above and below meet within CLOSE before.
STALLED = 0.9  # A round that takes less than a tenth off the largest error has settled.
SHORTENED = 0.5
"""Of the way to the best certificate at the samples; the whole would only exchange one worst for another."""
DIVERGED = 4.0  # An error that grows so much comes from a bad start.
NARROW = 0.97  # In units of the tolerance: the three per cent that docs/checker.md leaves undecided.
CLOSE = 1.03  # The least largest error is known to three per cent, as NARROW asks.
DAMPING = 1e-6
"""A share of the largest curvature: directions that change the errors a thousand times less follow the
rounding."""
EXACT_DAMPING = 1e-13
"""Where nothing was rounded: axes that are parallel but for 1e-4 change the errors ten thousand times
less."""
UNROUNDED = 1e-7
"""[rad], and a share of the robot: tolerances below it are asked of tables that nobody rounded."""
LONGEST_STEP = 0.5  # [rad], and a share of the robot: beyond it the errors are no linear function.

FREE_TWISTS: Floats = np.eye(6)
LINE_TWISTS: Floats = np.eye(6)[:, [2, 5]]
DIRECTION_TWISTS: Floats = np.eye(6)[:, [2, 3, 4, 5]]
POINT_TWISTS: Floats = np.eye(6)[:, [0, 1, 2]]
NO_TWISTS: Floats = np.eye(6)[:, []]


def refine(
    reference: Reference,
    submission: Chain,
    candidate: CertificateCandidate,
    tolerance: Tolerance,
    *,
    base_twists: Floats,
    tool_twists: Floats,
    offsets_free: bool,
    meter: Meter | None = None,
) -> tuple[CertificateCandidate, Residual] | None:
    """Return the certificate near a given one that stands, and its residual; None if none was found.

    Least squares comes first. Once it has settled, the largest error is brought down, unless it is seen that
    no certificate nearby keeps every sample within the tolerance. One that stands at the samples, but not
    everywhere, was made to fit these; so the configurations at which it does worst join them.

    Args:
        candidate: where to begin.
        tolerance: what a certificate must keep to stand.
        base_twists: (6, k) twists (rotation, translation) by which B may change from the left, in frame 0.
        tool_twists: (6, k) twists by which E may change from the right, in frame N.
        offsets_free: δ may change.
        meter: counts the work, if it is bounded.
    """
    lengths_too = np.repeat((1.0, reference.size), 3)[:, None]
    problem = RefinementProblem(
        reference,
        submission,
        tolerance,
        lengths_too * base_twists,
        lengths_too * tool_twists,
        offsets_free,
        meter,
        EXACT_DAMPING if max(tolerance.length, tolerance.angle) < UNROUNDED else DAMPING,
    )
    settled = _settled(problem, candidate)
    return None if settled is None else _brought_down(problem, settled)


def _brought_down(
    problem: "RefinementProblem", candidate: CertificateCandidate
) -> tuple[CertificateCandidate, Residual] | None:
    """A certificate near a given one that stands everywhere, and its residual; None if none is found soon.

    Half the way is gone from the best certificate so far to the one that is best at the samples, as these
    grow: the whole way would only exchange one worst configuration for another.
    """
    best, lowest = candidate, math.inf
    for _ in range(ROUNDS):
        if problem.meter is not None:
            problem.meter.charge(PER_DESCENT)
        worst = worst_case(problem.reference, problem.submission, candidate)
        excess = worst.residual.excess(problem.tolerance)
        if excess <= 1.0:
            return candidate, worst.residual
        if excess < lowest:
            best, lowest = candidate, excess
        problem = replace(problem, reference=problem.reference.sampled_at(worst.joints))
        model = problem.linearised(best)
        step, least = model.least_largest()
        if least > NARROW + model.curvature(problem.tolerance):
            return None
        candidate = problem.moved(best, SHORTENED * step)
    return None


def _settled(problem: "RefinementProblem", candidate: CertificateCandidate) -> CertificateCandidate | None:
    """The certificate near a given one with the least sum of squares; None if none nearby can stand."""
    previous = math.inf
    for _ in range(ROUNDS):
        model = problem.linearised(candidate)
        excess = model.found.excess(problem.tolerance)
        if excess > DIVERGED * previous or not model.jacobian.shape[1]:
            return None
        if excess <= 1.0 or excess > STALLED * previous:
            return candidate
        previous = min(previous, excess)
        step = model.least_squares()
        if math.sqrt(model.mean_square(step)) > 1.0 + model.curvature(problem.tolerance):
            return None
        candidate = problem.moved(candidate, step)
    return candidate


@dataclass(frozen=True, slots=True)
class Model:
    """The errors at the sampled configurations, in units of the tolerance, as a linear function of a step.

    Attributes:
        errors: (samples·2, 3) rotation and displacement that are still to be made up for.
        jacobian: (samples·6, m) how much of that a step makes up for.
        found: the largest errors.
        damping: a share of the largest curvature: directions below it are not followed.
    """

    errors: Floats
    jacobian: Floats
    found: Residual
    damping: float

    def curvature(self, tolerance: Tolerance) -> float:
        """Return how far the linear function may be off, in units of the tolerance."""
        return max(self.found) ** 2 / tolerance.angle

    def after(self, step: Floats) -> Floats:
        """Return (samples·2,) sizes of the errors after a step."""
        rest = self.errors - (self.jacobian @ step).reshape(self.errors.shape)
        return np.asarray(np.sqrt(np.einsum("ij,ij->i", rest, rest)), dtype=np.float64)

    def mean_square(self, step: Floats | None = None) -> float:
        """Return the mean square of the errors, now or after a step."""
        sizes = self.after(np.zeros(self.jacobian.shape[1]) if step is None else step)
        return float(np.mean(sizes**2))

    def least_squares(self, weights: Floats | None = None) -> Floats:
        """Return the step that leaves the least sum of weighted squares.

        What hardly changes the errors (frames may be turned together; lines that are nearly parallel) is
        damped: it would only follow the rounding.
        """
        a, b = self.jacobian, self.errors.ravel()
        if weights is not None:
            root = np.repeat(np.sqrt(weights), 3)
            a, b = a * root[:, None], b * root
        normal = a.T @ a
        damping = self.damping * (normal.diagonal().max() + 1e-300)
        step = np.linalg.solve(normal + damping * np.eye(normal.shape[0]), a.T @ b)
        return np.asarray(step / max(1.0, np.abs(step).max() / LONGEST_STEP), dtype=np.float64)

    def least_largest(self) -> tuple[Floats, float]:
        """Return a step that leaves nearly the smallest largest error, and how large that is at least.

        Lawson's iteration: weighted least squares, the weights multiplied by the squares of the errors every
        time. A weighted mean of squares is never more than the largest, so every iteration bounds from below
        what any step can do.
        """
        weights = np.full(len(self.errors), 1.0 / len(self.errors))
        best, largest_error, bound = np.zeros(self.jacobian.shape[1]), math.inf, 0.0
        for _ in range(ITERATIONS):
            step = self.least_squares(weights)
            squares = self.after(step) ** 2
            if squares.max() < largest_error:
                best, largest_error = step, float(squares.max())
            mean = float(weights @ squares)
            bound = max(bound, mean)
            if largest_error < CLOSE**2 * bound:
                break
            weights = weights * squares / mean
        return best, math.sqrt(bound)


@dataclass(frozen=True, slots=True)
class RefinementProblem:
    """What a certificate is refined for: two chains, and by what it may change."""

    reference: Reference
    submission: Chain
    tolerance: Tolerance
    base_twists: Floats
    tool_twists: Floats
    offsets_free: bool
    meter: Meter | None = None
    damping: float = DAMPING

    @property
    def joint_scales(self) -> Floats:
        """What one unit of a step means in each joint's offset: a radian, or the robot's size.

        Where B is free, it does all that the first offset could; with both free, frame 0 would wander about
        the first axis.
        """
        size = self.reference.size
        scales = np.array([size if axis.prismatic else 1.0 for axis in self.submission.axes])
        if self.base_twists.shape[1] == FREE_TWISTS.shape[1]:
            scales[:1] = 0.0
        return scales

    def linearised(self, candidate: CertificateCandidate) -> Model:
        """Return the errors at a certificate, and how they change with it."""
        if self.meter is not None:
            self.meter.charge(PER_ROUND)
        size = self.reference.size
        left, by_joint = _left_side(self.submission, joint_values(self.reference, candidate))
        right = to_matrix(candidate.base) @ self.reference.poses @ to_matrix(candidate.tool)
        columns = [by_joint * self.joint_scales] if self.offsets_free else []
        columns += [-_twists_of_base(right) @ self.base_twists, -_twists_of_tool(right) @ self.tool_twists]
        jacobian = np.concatenate(columns, axis=2) / self._units[:, None]
        errors = _mismatch(left, right) / self._units
        return Model(
            errors=errors.reshape(2 * len(errors), 3),
            jacobian=jacobian.reshape(jacobian.shape[0] * jacobian.shape[1], jacobian.shape[2]),
            found=largest(left - right, size),
            damping=self.damping,
        )

    def with_columns(self, model: Model, columns: Sequence[Floats]) -> Model:
        """Return a model in which more may change: (samples, 6) how frame N turns and moves with each."""
        more = [(column / self._units).ravel()[:, None] for column in columns]
        return replace(model, jacobian=np.concatenate([model.jacobian, *more], axis=1))

    @property
    def _units(self) -> Floats:
        """(6,) the tolerance of a rotation and of a displacement."""
        return np.repeat((self.tolerance.angle, self.tolerance.length * self.reference.size), 3)

    def moved(self, candidate: CertificateCandidate, step: Floats) -> CertificateCandidate:
        """Return the certificate after a step."""
        n = len(candidate.offsets) if self.offsets_free else 0
        k = self.base_twists.shape[1]
        offsets = candidate.offsets
        if self.offsets_free:
            changes = (step[:n] * self.joint_scales).tolist()
            offsets = tuple(value + change for value, change in zip(offsets, changes, strict=True))
        m = self.tool_twists.shape[1]
        base = compose(_small(self.base_twists @ step[n : n + k]), candidate.base)
        tool = compose(candidate.tool, _small(self.tool_twists @ step[n + k : n + k + m]))
        return CertificateCandidate(signs=candidate.signs, offsets=offsets, base=base, tool=tool)


def _left_side(submission: Chain, joints: Floats) -> tuple[Floats, Floats]:
    """F_s (samples, 4, 4), and how frame N turns and moves with each joint (samples, 6, n)."""
    n, samples = joints.shape
    motions = joint_motions(submission, joints)
    prefix = np.broadcast_to(np.eye(4), (samples, 4, 4))
    directions = np.empty((n, samples, 3))
    points = np.empty((n, samples, 3))
    for i, axis in enumerate(submission.axes):
        directions[i] = prefix[:, :3, :3] @ np.array(axis.direction)
        points[i] = prefix[:, :3, :3] @ np.array(axis.point) + prefix[:, :3, 3]
        prefix = prefix @ motions[i]
    left = prefix @ to_matrix(submission.end)
    jacobian = np.zeros((samples, 6, n))
    slides = [axis.prismatic for axis in submission.axes]
    turns = [not axis.prismatic for axis in submission.axes]
    jacobian[:, 3:, slides] = directions[slides].transpose(1, 2, 0)
    jacobian[:, :3, turns] = directions[turns].transpose(1, 2, 0)
    arms = cross_arrays(directions[turns], left[:, :3, 3] - points[turns])
    jacobian[:, 3:, turns] = arms.transpose(1, 2, 0)
    return left, jacobian


def _twists_of_base(right: Floats) -> Floats:
    """How B·F_r·E moves when B changes from the left: (samples, 6, 6)."""
    twists = np.zeros((right.shape[0], 6, 6))
    twists[:, :3, :3] = np.eye(3)
    twists[:, 3:, 3:] = np.eye(3)
    x, y, z = right[:, 0, 3], right[:, 1, 3], right[:, 2, 3]
    twists[:, 3, 1], twists[:, 3, 2] = z, -y
    twists[:, 4, 0], twists[:, 4, 2] = -z, x
    twists[:, 5, 0], twists[:, 5, 1] = y, -x
    return twists


def _twists_of_tool(right: Floats) -> Floats:
    """How B·F_r·E moves when E changes from the right: (samples, 6, 6)."""
    twists = np.zeros((right.shape[0], 6, 6))
    twists[:, :3, :3] = right[:, :3, :3]
    twists[:, 3:, 3:] = right[:, :3, :3]
    return twists


def _mismatch(left: Floats, right: Floats) -> Floats:
    """The rotation and displacement that take the left side to the right: (samples, 6)."""
    turn = turns_between(left, right)
    return np.concatenate([turn, right[:, :3, 3] - left[:, :3, 3]], axis=1)


def _small(twist: Floats) -> Motion:
    """Rotation by the first three components, then translation by the others."""
    a, b, c, x, y, z = twist.tolist()
    turn: Vector = (a, b, c)
    angle = norm(turn)
    if angle < 1e-300:
        return translation((x, y, z)) if (x or y or z) else IDENTITY
    r = rotation_about(ORIGIN, scale(turn, 1.0 / angle), math.cos(angle), math.sin(angle))
    return compose(translation((x, y, z)), r)
