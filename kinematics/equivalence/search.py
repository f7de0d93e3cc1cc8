"""Walk down the reference's chain of groups, both signs where both will do, to a verified certificate."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from kinematics.equivalence.alignment import Alignment, align
from kinematics.equivalence.certificates import Candidate, Path, candidate_from
from kinematics.equivalence.chains import Chain
from kinematics.equivalence.groups import Group, Nearness, Rotations, departure
from kinematics.equivalence.plan import Plan
from kinematics.equivalence.policy import BaseRule, DirectionRule, Policy, ZeroRule
from kinematics.equivalence.reference import Reference
from kinematics.equivalence.refinement import (
    DIRECTION_TWISTS,
    FREE_TWISTS,
    LINE_TWISTS,
    NO_TWISTS,
    POINT_TWISTS,
    Matrix,
    refine,
)
from kinematics.equivalence.rigid import IDENTITY, Motion, compose, inverse, move, rotate
from kinematics.equivalence.tools import ToolChoice, obeying, placements, tool_choices
from kinematics.equivalence.verification import Residual, residual

GATE = 6.0
WIDEST_GATE = 0.3
FLOOR = 1e-7
WORTH_REFINING = 400.0
MOST_NODES = 4000
MOST_CANDIDATES = 64
CLEARLY_BETTER = 0.5


@dataclass(frozen=True, slots=True)
class Found:
    """A verified certificate, for every parameter draw, and how it was come by.

    Attributes:
        candidates: one certificate per draw; all with the same signs.
        residuals: one per draw.
    """

    candidates: tuple[Candidate, ...]
    residuals: tuple[Residual, ...]


@dataclass(slots=True)
class Search:
    """One search: for one policy and one notion of nearness.

    Attributes:
        references: the reference at every parameter draw.
        submissions: the submission at the same draws.
        policy: what is asked.
        level: index into `Reference.nearnesses`.
    """

    references: Sequence[Reference]
    submissions: Sequence[Chain]
    policy: Policy
    level: int
    nodes: int = 0
    tried: int = 0
    seen: dict[tuple[int, int], list[Motion]] = field(default_factory=dict)

    def run(self) -> Found | None:
        """The first certificate that stands for every draw, signs +1 preferred; None if there is none."""
        reference = self.references[0]
        near = self.near(0)
        for index, plan in enumerate(reference.plans(self.policy.base, self.policy.zero, near)):
            for start in plan.starts:
                for path in self._descend(index, plan, start, (), (), ()):
                    found = self._finish(index, plan, path)
                    if found is not None:
                        return found
                    if self.tried >= MOST_CANDIDATES:
                        return None
        return None

    def near(self, draw: int) -> Nearness:
        """The notion of nearness at a draw."""
        return self.references[draw].nearnesses(self.policy.tolerance)[self.level]

    def _descend(
        self,
        index: int,
        plan: Plan,
        start: Motion,
        signs: tuple[int, ...],
        motions: tuple[Motion, ...],
        totals: tuple[Motion, ...],
    ) -> Iterator[Path]:
        here = totals[-1] if totals else start
        depth = len(signs)
        if depth == len(plan.steps):
            yield Path(start, signs, motions, totals, IDENTITY)
            return
        self.nodes += 1
        if self.nodes > MOST_NODES or self._been_here(index, plan, depth, here):
            return
        for sign, alignment in self._options(plan, depth, here):
            h = alignment.motion
            yield from self._descend(
                index,
                plan,
                start,
                (*signs, sign),
                (*motions, h),
                (*totals, h if here is IDENTITY else compose(h, here)),
            )

    def _options(self, plan: Plan, depth: int, here: Motion) -> Iterator[tuple[int, Alignment]]:
        """The signs with which the next axis can be aligned; computed only as far as they are asked for."""
        step = plan.steps[depth]
        axis = self.submissions[0].axes[depth]
        direction, point = (
            (axis.direction, axis.point)
            if here is IDENTITY
            else (rotate(here, axis.direction), move(here, axis.point))
        )
        tolerance, size = self.policy.tolerance, self.references[0].size
        gate_angle = min(GATE * step.amplification * tolerance.angle + FLOOR, WIDEST_GATE)
        gate_length = min(GATE * step.amplification * tolerance.length + FLOOR, WIDEST_GATE) * size
        forward = align(step, direction, point, 1)
        misfit = max(forward.angle / gate_angle, forward.distance / gate_length)
        if self.policy.direction is DirectionRule.FIGURE:
            if misfit <= 1.0:
                yield 1, forward
            return
        if misfit <= CLEARLY_BETTER / GATE:
            yield 1, forward
            misfit = 2.0
        backward = align(step, direction, point, -1)
        other = max(backward.angle / gate_angle, backward.distance / gate_length)
        options = [(misfit, 1, forward), (other, -1, backward)]
        if other < misfit:
            options.reverse()
        for value, sign, alignment in options:
            if value <= 1.0:
                yield sign, alignment

    def _been_here(self, index: int, plan: Plan, depth: int, here: Motion) -> bool:
        """Whether a motion of the same coset has been followed from this joint on before."""
        visited = self.seen.setdefault((index, depth), [])
        if visited:
            group = plan.steps[depth].group
            limit = max(self.policy.tolerance.angle, FLOOR), max(self.policy.tolerance.length, FLOOR)
            for other in visited:
                angle, length = departure(group, compose(here, inverse(other)))
                if angle <= limit[0] and length <= limit[1] * self.references[0].size:
                    return True
        visited.append(here)
        return False

    def _finish(self, index: int, plan: Plan, path: Path) -> Found | None:
        reference = self.references[0]
        here = compose(path.totals[-1] if path.totals else path.start, self.submissions[0].end)
        choices = tool_choices(reference.chain, plan.last, self.policy.tool, self.near(0), reference.size)
        for which, choice in enumerate(choices):
            for turn, last in enumerate(placements(choice, here)):
                self.tried += 1
                first = self._judge(
                    0, plan, choice, Path(path.start, path.signs, path.motions, path.totals, last)
                )
                if first is None:
                    continue
                start = plan.starts.index(path.start)
                others = [
                    self._follow(draw, index, start, path.signs, which, turn)
                    for draw in range(1, len(self.references))
                ]
                if all(other is not None for other in others):
                    all_found = [first, *(other for other in others if other is not None)]
                    return Found(tuple(f[0] for f in all_found), tuple(f[1] for f in all_found))
        return None

    def _follow(
        self, draw: int, index: int, start: int, signs: tuple[int, ...], which: int, turn: int
    ) -> tuple[Candidate, Residual] | None:
        """The same path at another draw."""
        reference, submission = self.references[draw], self.submissions[draw]
        near = self.near(draw)
        plan = reference.plans(self.policy.base, self.policy.zero, near)[index]
        path = forced_path(plan, submission, plan.starts[start], signs)
        here = compose(path.totals[-1] if path.totals else path.start, submission.end)
        choice = tool_choices(reference.chain, plan.last, self.policy.tool, near, reference.size)[which]
        last = placements(choice, here)[turn]
        return self._judge(draw, plan, choice, Path(path.start, path.signs, path.motions, path.totals, last))

    def _judge(
        self, draw: int, plan: Plan, choice: ToolChoice, path: Path
    ) -> tuple[Candidate, Residual] | None:
        """The certificate of a path, if equation (1) holds with it; refined, if it nearly does."""
        reference, submission, policy = self.references[draw], self.submissions[draw], self.policy
        candidate = candidate_from(
            (reference.chain, submission), plan, path, policy.zero, tool_turns=choice.turns
        )
        candidate = Candidate(
            candidate.signs, candidate.offsets, candidate.base, obeying(choice, candidate.tool)
        )
        found = residual(reference, submission, candidate)
        if found.within(policy.tolerance):
            return candidate, found
        if found.excess(policy.tolerance) > WORTH_REFINING and max(found) > WIDEST_GATE:
            return None
        candidate, found = refine(
            reference,
            submission,
            candidate,
            policy.tolerance,
            base_twists=base_twists(plan, policy.base),
            tool_twists=choice.twists,
            offsets_free=policy.zero is ZeroRule.FREE,
        )
        return (candidate, found) if found.within(policy.tolerance) else None


def forced_path(plan: Plan, submission: Chain, start: Motion, signs: Sequence[int]) -> Path:
    """The best alignments with given signs, however good or bad."""
    here = start
    motions: list[Motion] = []
    totals: list[Motion] = []
    for step, axis, sign in zip(plan.steps, submission.axes, signs, strict=True):
        h = align(step, rotate(here, axis.direction), move(here, axis.point), sign).motion
        here = compose(h, here)
        motions.append(h)
        totals.append(here)
    return Path(start, tuple(signs), tuple(motions), tuple(totals), IDENTITY)


def base_twists(plan: Plan, rule: BaseRule) -> Matrix:
    """The twists by which B may change from the left, in the submission's frame 0."""
    if rule is BaseRule.FREE:
        return FREE_TWISTS
    if rule is BaseRule.ORIGIN:
        return POINT_TWISTS
    if rule is BaseRule.FRAME or not plan.steps:
        return NO_TWISTS
    group: Group = plan.steps[0].group
    assert group.rotations is Rotations.ABOUT_LINE
    return DIRECTION_TWISTS if len(group.translations) == 3 else LINE_TWISTS
