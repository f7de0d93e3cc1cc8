"""Which facts of a robot an answer has: types, twists, lengths and offsets that no choice of frames changes.

Every axis may point either way, and with it the signs of twists, lengths and offsets change together. The
directions are chosen so that as little as possible is wrong; since a fact concerns one axis or two
neighbours, the best choice is found exactly, joint by joint. A joint too many or too few is taken to be where
that leaves the most facts right.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from kinematics.chain import Axis
from kinematics.equivalence.groups import outside
from kinematics.equivalence.invariants import Invariant, Measure
from kinematics.se3 import Vector, cross, norm, unit

# Axes less than this apart [rad] count as parallel: rounded entries turn them by less, mistakes by more.
NEARLY = 0.01


@dataclass(frozen=True, kw_only=True, slots=True)
class Weights:
    """What the facts of a robot are worth beside one another.

    Attributes:
        joint: that a joint is there, has the right type and stands in the right order.
        twist: an angle between neighbouring axes.
        length: a distance of neighbouring axes.
        offset: a distance along an axis, or an angle about a slider.
        rule: a rule of the exercise that is not kept.
        sign: the share of a fact that is lost where only its sign is wrong.
        row: what a named slip in a row costs at the most, in facts of weight 1; one in a cell costs 1.
        table: what a named slip throughout the table costs at the most.
    """

    joint: float = 1.0
    twist: float = 1.0
    length: float = 1.0
    offset: float = 1.0
    rule: float = 1.0
    sign: float = 0.5
    row: float = 2.0
    table: float = 3.0

    def of(self, measure: Measure) -> float:
        """The weight of a fact."""
        if measure is Measure.ANGLE:
            return self.twist
        return self.length if measure is Measure.DISTANCE else self.offset


@dataclass(frozen=True, eq=False)
class Facts:
    """The facts of a key, and what they are worth.

    Attributes:
        axes: the key's joint axes between what stands for its base and its tool.
        invariants: its lengths and angles, each with the slack within which an answer has it.
        fixed: of base and tool, whether the policy fixes which way z points.
        weights: what the facts are worth.
    """

    axes: Sequence[Axis]
    invariants: Sequence[Invariant]
    fixed: tuple[bool, bool]
    weights: Weights

    @cached_property
    def _own(self) -> list[float]:
        return [invariant.oriented(self.axes)[0] for invariant in self.invariants]

    def wrong(self, axes: Sequence[Axis]) -> float:
        """The weight of the facts that an answer does not have.

        Args:
            axes: its joint axes between base and tool, as those of the key.
        """
        ours, theirs = len(self.axes) - 2, len(axes) - 2
        shift = theirs - ours
        aligned = _Aligned(self, axes, shift)
        splits = range(min(ours, theirs) + 1) if shift else range(1)
        return min(aligned.wrong(split) for split in splits) + self.weights.joint * max(shift, 0)


class _Aligned:
    """An answer's axes beside the key's: joint i is joint i up to the split, and after it joint i + shift."""

    def __init__(self, facts: Facts, axes: Sequence[Axis], shift: int) -> None:
        self._facts, self._axes, self._shift = facts, axes, shift
        self._costs: dict[tuple[int, int], tuple[float, float] | None] = {}

    def wrong(self, split: int) -> float:
        """The weight of the facts that are wrong or lost, for the best directions of the axes."""
        facts, last = self._facts, len(self._facts.axes) - 1
        if not self._shift:
            split = last
        places = [self._place(i, split) for i in range(last + 1)]
        lost = sum(self._type_cost(i, place) for i, place in enumerate(places[1:-1], 1))
        single = [[0.0, 0.0] for _ in places]
        pairs = [[0.0, 0.0] for _ in places]
        for k, invariant in enumerate(facts.invariants):
            cost = self._cost(k, invariant, places)
            i, j = invariant.axes[0], invariant.axes[1]
            if cost is None:
                lost += facts.weights.of(invariant.measure)
            elif invariant.measure is Measure.OFFSET:
                single[j] = [single[j][0] + cost[0], single[j][1] + cost[1]]
            elif j == i + 1 and invariant.measure is not Measure.TURN:
                pairs[j] = [pairs[j][0] + cost[0], pairs[j][1] + cost[1]]
            else:
                lost += min(cost)
        return lost + self._best_directions(single, pairs)

    def _best_directions(self, single: list[list[float]], pairs: list[list[float]]) -> float:
        """The least of the sums of costs, over which way every axis points: a forward sweep."""
        best = [single[0][0], float("inf") if self._facts.fixed[0] else single[0][1]]
        for here, pair in list(zip(single, pairs, strict=True))[1:]:
            ways = [[best[s] + pair[s ^ t] for s in (0, 1)] for t in (0, 1)]
            best = [min(ways[t]) + here[t] for t in (0, 1)]
        return best[0] if self._facts.fixed[1] else min(best)

    def _place(self, i: int, split: int) -> int | None:
        """The answer's axis that stands for the key's axis i; None if it is missing."""
        last = len(self._facts.axes) - 1
        if i == last:
            return len(self._axes) - 1
        if i <= split:
            return i
        return i + self._shift if i + self._shift > split else None

    def _type_cost(self, i: int, place: int | None) -> float:
        if place is not None and self._axes[place].prismatic is self._facts.axes[i].prismatic:
            return 0.0
        return self._facts.weights.joint

    def _cost(self, k: int, invariant: Invariant, places: Sequence[int | None]) -> tuple[float, float] | None:
        """What an invariant costs with the axes as they point, and with one reversed; None if it is lost."""
        span = range(min(invariant.axes), max(invariant.axes) + 1)
        shifts = {None if (place := places[i]) is None else place - i for i in span}
        if len(shifts) > 1 or (shift := shifts.pop()) is None:
            return None
        if (k, shift) not in self._costs:
            self._costs[k, shift] = self._measured(k, invariant, shift)
        return self._costs[k, shift]

    def _measured(self, k: int, invariant: Invariant, shift: int) -> tuple[float, float] | None:
        ours, theirs = self._facts.axes, self._axes
        alike = all(ours[i].prismatic is theirs[i + shift].prismatic for i in invariant.axes)
        if invariant.measure is not Measure.ANGLE and not (alike and self._is_defined(invariant, shift)):
            return None
        weight = self._facts.weights.of(invariant.measure)
        moved = Invariant(
            invariant.measure, tuple(i + shift for i in invariant.axes), invariant.value, invariant.slack
        )
        fits = [abs(value - self._facts._own[k]) <= invariant.slack for value in moved.oriented(theirs)]
        sign = self._facts.weights.sign * weight
        costs = [0.0 if fits[s] else sign if fits[1 - s] else weight for s in (0, 1)]
        return costs[0], costs[1]

    def _is_defined(self, invariant: Invariant, shift: int) -> bool:
        """Whether a length means in the answer what it means in the key, whatever frames were chosen.

        An offset runs along parallel axes between axes that are not; a distance beside sliders disregards the
        directions of all axes in between.
        """
        ours, theirs = self._facts.axes, self._axes
        span = range(min(invariant.axes), max(invariant.axes) + 1)
        if invariant.measure is Measure.OFFSET:
            pairs = {(i, i + 1) for i in span[:-1]} | {(invariant.axes[2], invariant.axes[3])}
            return all(
                _are_parallel(theirs[i + shift], theirs[j + shift]) is _are_parallel(ours[i], ours[j])
                for i, j in pairs
            )
        if invariant.measure is Measure.DISTANCE:
            basis: tuple[Vector, ...] = ()
            for i in invariant.axes[2:]:
                rest = outside(theirs[i + shift].direction, basis)
                basis = (*basis, unit(rest)) if norm(rest) > NEARLY else basis
            return all(norm(outside(theirs[i + shift].direction, basis)) <= NEARLY for i in span)
        return True


def _are_parallel(one: Axis, other: Axis) -> bool:
    return norm(cross(one.direction, other.direction)) <= NEARLY
