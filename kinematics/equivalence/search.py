"""Walk down the reference's chain of groups, both signs where both will do, to a verified certificate."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from enum import Enum, auto

from kinematics.chain import Chain
from kinematics.equivalence.alignment import Alignment, align, aligning_motion
from kinematics.equivalence.certificates import CertificateCandidate, CertificatePath, candidate_from
from kinematics.equivalence.groups import Group, Nearness, Rotations, departure
from kinematics.equivalence.meter import PER_ALIGNMENT, Meter, per_certificate
from kinematics.equivalence.plan import Plan
from kinematics.equivalence.policy import BaseRule, DirectionRule, Policy, ZeroRule
from kinematics.equivalence.reference import Reference
from kinematics.equivalence.refinement import (
    DIRECTION_TWISTS,
    FREE_TWISTS,
    LINE_TWISTS,
    NO_TWISTS,
    POINT_TWISTS,
    refine,
)
from kinematics.equivalence.tools import ToolChoice, obeying, placements, tool_choices
from kinematics.equivalence.verification import Residual
from kinematics.equivalence.worst_case import judged
from kinematics.se3 import IDENTITY, Floats, Motion, compose, inverse, move, rotate

# The largest misfit with which an alignment is followed, in units of the tolerance: neighbours may be off as
# well, and short levers make more of it; never more than the last, [rad] and a share of the robot.
LIMIT = 9.0
WIDEST = 0.3
FLOOR = 1e-4
"""[rad], and a share of the robot: what alignments leave of the errors of the arithmetic where several axes
in a row are parallel but for 1e-4, and turns and slides are found from them. Verification decides."""
SAME = 1e-7  # [rad], and a share of the robot: motions that are the same.
FAR_OFF = 0.5  # [rad], and a share of the robot: from farther off refinement does not come back.
MOST_NODES = 4000  # Alignments; a robot of twelve joints needs some forty.
MOST_REFINED = 4  # A bound of the work: refining is what costs most in a decision.
CLEARLY_BETTER = 0.1  # A share of the largest misfit: the other sign need not be looked at.
AS_GOOD = 0.02  # Of misfits, in the same units: differences of the rounding.
PREFERENCE = 0.05  # For every reversed sign, so that of nearly equal certificates the plain one is told.


class Effort(Enum):
    """How hard to try.

    PLAIN: only certificates that stand as they come from the alignments.
    REFINED: the best of those that nearly do are refined as well.
    """

    PLAIN = auto()
    REFINED = auto()


@dataclass(frozen=True, slots=True)
class Found:
    """A verified certificate, for every parameter draw, and how it was come by.

    Attributes:
        candidates: one certificate per draw; all with the same signs.
        residuals: one per draw.
    """

    candidates: tuple[CertificateCandidate, ...]
    residuals: tuple[Residual, ...]


@dataclass(frozen=True, slots=True)
class Way:
    """A path through the groups and a placement of frame N, so that it can be followed at other draws.

    All but the signs are numbers: of a plan, its start, a choice of the tool, a placement of the choice.
    """

    plan: int
    start: int
    signs: tuple[int, ...]
    choice: int
    placement: int


@dataclass(frozen=True, slots=True)
class Unfinished:
    """A certificate that nearly stands at the first draw."""

    excess: float
    way: Way
    candidate: CertificateCandidate


@dataclass(slots=True)
class Search:
    """One search: for one policy and one notion of nearness.

    Attributes:
        references: the reference at every parameter draw.
        submissions: the submission at the same draws.
        policy: what is asked.
        level: index into `Reference.nearnesses`.
        effort: whether to refine.
        meter: counts the work, if it is bounded.
        measured: residuals at the samples are wanted, where a bound shows already that a certificate stands.
    """

    references: Sequence[Reference]
    submissions: Sequence[Chain]
    policy: Policy
    level: int
    effort: Effort = Effort.REFINED
    meter: Meter | None = None
    measured: bool = True
    nodes: int = 0
    seen: dict[tuple[int, int], list[tuple[Motion, float]]] = field(default_factory=dict)
    unfinished: list[Unfinished] = field(default_factory=list)

    def run(self) -> Found | None:
        """Return the first certificate that stands for every draw, signs +1 preferred; None if there is none.

        Only when no certificate stands as it is are the best of them refined.
        """
        plans = self.references[0].plans(self.policy.base, self.policy.zero, self.near(0))
        for index, plan in enumerate(plans):
            for start in range(len(plan.starts)):
                for path in self._descend(index, plan, plan.starts[start], (), (), (), 0.0):
                    found = self._finish(index, plan, start, path)
                    if found is not None:
                        return found
        if self.effort is Effort.PLAIN:
            return None
        self.unfinished.sort(key=_promise)
        for unfinished in self.unfinished[:MOST_REFINED]:
            first = self._refined(0, unfinished.way, unfinished.candidate)
            found = None if first is None else self._everywhere(unfinished.way, first)
            if found is not None:
                return found
        return None

    def near(self, draw: int) -> Nearness:
        """Return the notion of nearness at a draw."""
        return self.references[draw].nearnesses(self.policy.tolerance)[self.level]

    def _descend(
        self,
        index: int,
        plan: Plan,
        start: Motion,
        signs: tuple[int, ...],
        motions: tuple[Motion, ...],
        totals: tuple[Motion, ...],
        misfit: float,
    ) -> Iterator[CertificatePath]:
        here = totals[-1] if totals else start
        depth = len(signs)
        if depth == len(plan.steps):
            yield CertificatePath(start, signs, motions, totals, IDENTITY)
            return
        self.nodes += 1
        self._charge(PER_ALIGNMENT)
        if self.nodes > MOST_NODES or self._been_here(index, plan, depth, here, misfit):
            return
        for sign, alignment, value in self._options(plan, depth, here):
            h = alignment.motion
            total = h if here is IDENTITY else compose(h, here)
            yield from self._descend(
                index, plan, start, (*signs, sign), (*motions, h), (*totals, total), max(misfit, value)
            )

    def _options(self, plan: Plan, depth: int, here: Motion) -> Iterator[tuple[int, Alignment, float]]:
        """The signs with which the next axis can be aligned, and how badly; computed on demand."""
        step = plan.steps[depth]
        axis = self.submissions[0].axes[depth]
        direction, point = axis.direction, axis.point
        if here is not IDENTITY:
            direction, point = rotate(here, direction), move(here, point)
        tolerance, size = self.policy.tolerance, self.references[0].size
        # the direction of a prismatic joint shows in positions alone
        limit = max(tolerance.angle, tolerance.length) if axis.prismatic else tolerance.angle
        most_angle = min(LIMIT * limit + FLOOR, WIDEST)
        most_length = min(LIMIT * tolerance.length + FLOOR, WIDEST) * size
        forward = align(step, direction, point, 1)
        misfit = max(forward.angle / most_angle, forward.distance / most_length)
        if self.policy.direction is DirectionRule.FIGURE:
            if misfit <= 1.0:
                yield 1, forward, misfit
            return
        options = []
        if misfit <= CLEARLY_BETTER:
            yield 1, forward, misfit
        else:
            options.append((misfit, 1, forward))
        backward = align(step, direction, point, -1)
        other = max(backward.angle / most_angle, backward.distance / most_length)
        options.insert(0 if other < misfit else 1, (other, -1, backward))
        for value, sign, alignment in options:
            if value <= 1.0:
                yield sign, alignment, value

    def _been_here(self, index: int, plan: Plan, depth: int, here: Motion, misfit: float) -> bool:
        """Whether a motion of the same coset, come by as well, has been followed from here before."""
        visited = self.seen.setdefault((index, depth), [])
        if visited:
            group = plan.steps[depth].group
            limit_angle = max(self.policy.tolerance.angle, SAME)
            limit_length = max(self.policy.tolerance.length, SAME) * self.references[0].size
            for other, its_misfit in visited:
                if its_misfit > misfit + AS_GOOD:
                    continue
                angle, length = departure(group, compose(here, inverse(other)))
                if angle <= limit_angle and length <= limit_length:
                    return True
        visited.append((here, misfit))
        return False

    def _finish(self, index: int, plan: Plan, start: int, path: CertificatePath) -> Found | None:
        """Place frame N in every way that the policy allows, and verify."""
        reference, submission, tolerance = self.references[0], self.submissions[0], self.policy.tolerance
        here = compose(path.totals[-1] if path.totals else path.start, submission.end)
        choices = tool_choices(reference, plan, self.policy.tool, self.near(0))
        for which, choice in enumerate(choices):
            for placement, last in enumerate(placements(choice, here)):
                self._charge(per_certificate(len(submission.axes)))
                way = Way(index, start, path.signs, which, placement)
                candidate = self._candidate(0, plan, choice, path._replace(last=last))
                found = judged(reference, submission, candidate, tolerance, measured=self.measured)
                if found.within(tolerance):
                    everywhere = self._everywhere(way, (candidate, found))
                    if everywhere is not None:
                        return everywhere
                elif max(found) <= FAR_OFF:
                    self.unfinished.append(Unfinished(found.excess(tolerance), way, candidate))
        return None

    def _everywhere(self, way: Way, first: tuple[CertificateCandidate, Residual]) -> Found | None:
        """The same way at every draw, if it stands at all of them."""
        everywhere = [first]
        for draw in range(1, len(self.references)):
            candidate = self._followed(draw, way)
            if candidate is None:
                return None
            sides, tolerance = (self.references[draw], self.submissions[draw]), self.policy.tolerance
            found = judged(*sides, candidate, tolerance, measured=self.measured)
            if found.within(tolerance):
                everywhere.append((candidate, found))
                continue
            refined = self._refined(draw, way, candidate) if self.effort is Effort.REFINED else None
            if refined is None:
                return None
            everywhere.append(refined)
        return Found(tuple(candidate for candidate, _ in everywhere), tuple(found for _, found in everywhere))

    def _followed(self, draw: int, way: Way) -> CertificateCandidate | None:
        """The certificate to which a way leads at a draw; None if there is no such way there.

        Where lengths are of very different sizes, axes may coincide at one draw and not at another.
        """
        followed = self._plan_and_choice(draw, way)
        if followed is None or way.start >= len(followed[0].starts):
            return None
        plan, choice = followed
        submission = self.submissions[draw]
        path = forced_path(plan, submission, plan.starts[way.start], way.signs)
        here = compose(path.totals[-1] if path.totals else path.start, submission.end)
        last = placements(choice, here)[way.placement]
        return self._candidate(draw, plan, choice, path._replace(last=last))

    def _plan_and_choice(self, draw: int, way: Way) -> tuple[Plan, ToolChoice] | None:
        reference, near = self.references[draw], self.near(draw)
        plans = reference.plans(self.policy.base, self.policy.zero, near)
        if way.plan >= len(plans):
            return None
        plan = plans[way.plan]
        choices = tool_choices(reference, plan, self.policy.tool, near)
        return (plan, choices[way.choice]) if way.choice < len(choices) else None

    def _candidate(
        self, draw: int, plan: Plan, choice: ToolChoice, path: CertificatePath
    ) -> CertificateCandidate:
        chains = self.references[draw].chain, self.submissions[draw]
        candidate = candidate_from(chains, plan, path, self.policy.zero, tool_turns=choice.turns)
        return candidate._replace(tool=obeying(choice, candidate.tool))

    def _refined(
        self, draw: int, way: Way, candidate: CertificateCandidate
    ) -> tuple[CertificateCandidate, Residual] | None:
        """The certificate refined, if equation (1) holds with it then."""
        followed = self._plan_and_choice(draw, way)
        if followed is None:
            return None
        plan, choice = followed
        return refine(
            self.references[draw],
            self.submissions[draw],
            candidate,
            self.policy.tolerance,
            base_twists=base_twists(plan, self.policy.base),
            tool_twists=choice.twists,
            offsets_free=self.policy.zero is ZeroRule.FREE,
            meter=self.meter,
        )

    def _charge(self, units: int) -> None:
        if self.meter is not None:
            self.meter.charge(units)


def _promise(unfinished: Unfinished) -> float:
    """What the best certificates are tried first by: signs +1 are preferred among nearly as good ones."""
    return unfinished.excess * (1.0 + PREFERENCE * unfinished.way.signs.count(-1))


def forced_path(plan: Plan, submission: Chain, start: Motion, signs: Sequence[int]) -> CertificatePath:
    """Return the best alignments with given signs, however good or bad."""
    here = start
    motions: list[Motion] = []
    totals: list[Motion] = []
    for step, axis, sign in zip(plan.steps, submission.axes, signs, strict=True):
        h, _, _ = aligning_motion(step, rotate(here, axis.direction), move(here, axis.point), sign)
        here = compose(h, here)
        motions.append(h)
        totals.append(here)
    return CertificatePath(start, tuple(signs), tuple(motions), tuple(totals), IDENTITY)


def base_twists(plan: Plan, rule: BaseRule) -> Floats:
    """Return the twists by which B may change from the left, in the submission's frame 0."""
    if rule is BaseRule.FREE:
        return FREE_TWISTS
    if rule is BaseRule.ORIGIN:
        return POINT_TWISTS
    if rule is BaseRule.FRAME or not plan.steps:
        return NO_TWISTS
    group: Group = plan.steps[0].group
    assert group.rotations is Rotations.ABOUT_LINE
    return DIRECTION_TWISTS if len(group.translations) == 3 else LINE_TWISTS
