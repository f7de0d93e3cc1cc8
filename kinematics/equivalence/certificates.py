"""From the motions that aligned the axes to the certificate (σ, δ, B, E)."""

from typing import NamedTuple

from kinematics.chain import Chain
from kinematics.equivalence.groups import Rotations, outside
from kinematics.equivalence.plan import Plan, Step
from kinematics.equivalence.policy import ZeroRule
from kinematics.se3 import Motion, Vector, angle_about, compose, dot, inverse, position, subtract


class CertificateCandidate(NamedTuple):
    """A certificate that has yet to be verified.

    Attributes:
        signs: σ_1 … σ_n.
        offsets: δ_1 … δ_n [rad or length].
        base: B.
        tool: E.
    """

    signs: tuple[int, ...]
    offsets: tuple[float, ...]
    base: Motion
    tool: Motion


class CertificatePath(NamedTuple):
    """How the axes were aligned, joint by joint.

    Attributes:
        start: the motion begun with.
        signs: the sign taken at each joint.
        motions: h_i ∈ H_{i-1}, the motion applied at joint i, on top of all earlier ones.
        totals: their products h_i ⋯ h_1 · start.
        last: the motion in H_n that placed the end frame.
    """

    start: Motion
    signs: tuple[int, ...]
    motions: tuple[Motion, ...]
    totals: tuple[Motion, ...]
    last: Motion


def split(step: Step, motion: Motion, zero: ZeroRule) -> tuple[float, Motion]:
    """Write a motion of H_i as exp(S_i ε) · k with k in Stab_i, ε zero wherever it may be."""
    if zero is ZeroRule.FIGURE or _keeps_all_of(step):
        return 0.0, motion
    value = _along(step, motion) if step.axis.prismatic else angle_about(motion, step.axis.direction)
    return value, compose(step.axis.motion(-value), motion)


def _holds(basis: tuple[Vector, ...], direction: Vector) -> bool:
    rest = outside(direction, basis)
    return dot(rest, rest) < 1e-12


def _along(step: Step, motion: Motion) -> float:
    """How far a motion slides along the joint, over and above what the stabiliser does."""
    stabiliser, direction = step.stabiliser, step.axis.direction
    if stabiliser.rotations is Rotations.ABOUT_LINE:
        return dot(direction, position(motion))
    rest = outside(direction, stabiliser.translations)
    return dot(rest, position(motion)) / dot(rest, rest)


def offsets_and_first(plan: Plan, path: CertificatePath, zero: ZeroRule) -> tuple[list[float], list[Motion]]:
    """Return the ε_i with g_i = exp(S_i ε_i) g_{i-1}, and the g_i themselves.

    Every motion is pushed down the chain: its part in exp(S_i ℝ) stays as ε_i, the rest goes on to joint i-1.

    Returns:
        ε_1 … ε_n and g_0 … g_n.
    """
    n = len(plan.steps)
    values = [0.0] * n
    g: list[Motion] = [path.start] * (n + 1)
    rest = path.last
    for i in range(n - 1, -1, -1):
        g[i + 1] = compose(rest, path.totals[i])
        values[i], k = split(plan.steps[i], rest, zero)
        rest = compose(k, path.motions[i])
    g[0] = compose(rest, path.start)
    return values, g


def candidate_from(
    chains: tuple[Chain, Chain], plan: Plan, path: CertificatePath, zero: ZeroRule, *, tool_turns: bool
) -> CertificateCandidate:
    """Return the certificate that a path of alignments amounts to.

    Where a turn of frame 0 about the first joint's axis, or of frame N about the last one's, does the same as
    an offset of that joint, the offset is chosen such that B and E come as near to the identity as they can.

    Where `tool_turns` holds, the policy lets frame N move with the last joint.
    """
    reference, submission = chains
    values, g = offsets_and_first(plan, path, zero)
    first, last = g[0], compose(g[-1], submission.end)
    if values and zero is ZeroRule.FREE:
        if _keeps_all_of(plan.steps[0]):
            value = -_share(plan.steps[0], first, position(first))
            first = compose(plan.steps[0].axis.motion(value), first)
            values[0] -= value
        if tool_turns:
            gap = subtract(position(last), position(reference.end))
            value = -_share(plan.steps[-1], compose(last, inverse(reference.end)), gap)
            last = compose(plan.steps[-1].axis.motion(value), last)
            values[-1] += value
    return CertificateCandidate(
        signs=path.signs,
        offsets=tuple(s * v for s, v in zip(path.signs, values, strict=True)),
        base=inverse(first),
        tool=compose(inverse(reference.end), last),
    )


def _keeps_all_of(step: Step) -> bool:
    """Whether the stabiliser of a joint's screw holds that joint's own motions."""
    if step.axis.prismatic:
        return _holds(step.stabiliser.translations, step.axis.direction)
    return step.stabiliser.rotations is Rotations.ABOUT_LINE


def _share(step: Step, motion: Motion, displacement: Vector) -> float:
    """How much of the joint's own motion there is in a motion that displaces a frame [rad or length]."""
    if step.axis.prismatic:
        return dot(step.axis.direction, displacement)
    return angle_about(motion, step.axis.direction)
