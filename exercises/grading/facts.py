"""Which facts of a robot an answer has: types, twists, lengths and offsets that no choice of frames changes.

Every axis may point either way, and with it the signs of twists, lengths and offsets change together. The
directions are chosen so that as little as possible is wrong; since a fact concerns one axis or two
neighbours, the best choice is found exactly, joint by joint. Joints too many or too few are taken to be where
that leaves the most facts right.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import combinations, islice

import numpy as np
from numpy.typing import NDArray

from kinematics.caching import USUAL_ROWS, cached_by_size
from kinematics.chain import Axis
from kinematics.equivalence import BaseRule, Policy, ToolRule
from kinematics.equivalence.batches import axis_batch
from kinematics.equivalence.groups import outside
from kinematics.equivalence.invariants import Invariants
from kinematics.equivalence.measures import Measure, Shape
from kinematics.se3 import Vector, cross, dot, norm, unit

Floats = NDArray[np.float64]

# Axes less than this apart [rad] count as parallel: rounded entries turn them by less, mistakes by more.
NEARLY = 0.01
# In how many ways joints are placed beside the key's at the most: any three of ten that are missing.
MOST_PLACINGS = 120
# Whether one of two axes is turned round and the other is not: by whether the first is, and the second.
_TURNED = np.array(((0, 1), (1, 0)))


@dataclass(frozen=True, kw_only=True, slots=True)
class Weights:
    """What the facts of a robot are worth beside one another.

    Attributes:
        joint: that a joint is there and stands in the right order; that it has the right type, twice as much.
        twist: an angle between neighbouring axes.
        length: a distance of neighbouring axes.
        offset: a distance along an axis, or an angle about the axis of a prismatic joint.
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
        """Return the weight of a fact."""
        if measure is Measure.ANGLE:
            return self.twist
        return self.length if measure is Measure.DISTANCE else self.offset


@dataclass(frozen=True, eq=False)
class Facts:
    """The facts of a key, and what they are worth.

    Attributes:
        axes: the key's joint axes between what stands for its base and its tool.
        invariants: its lengths and angles, each with the slack within which an answer has it.
        fixed: the axes of which the policy fixes which way they point, by their numbers.
        worth: (q,) what each of these is worth.
        sign: the share of a fact that is lost where only its sign is wrong.
        to_earn: the weight of the facts that a table of zeros does not have.
        joint: the share of what an answer has of these that it loses by a joint too many or too few.
        type: the share that it loses by a joint of another type.
    """

    axes: Sequence[Axis]
    invariants: Invariants
    fixed: tuple[int, ...]
    worth: Floats
    sign: float
    to_earn: float = 0.0
    joint: float = 0.0
    type: float = 0.0

    def wrong(self, axes: Sequence[Axis], found: Floats | None = None) -> float:
        """Return the weight of the facts that an answer does not have, and of what its joints take with them.

        A table of zeros has the right joints for nothing, so they can only be lost: each that is wrong takes
        a share of what is right beside it.

        Args:
            axes: its joint axes between base and tool, as those of the key.
            found: (q, 1) its invariants, if they are known; of an answer with the key's number of joints.
        """
        kept, fits, has = self._compared(axes, found)
        least = self._least(fits, has)
        return float((least + np.maximum(self.to_earn - least, 0.0) * (1.0 - kept)).min())

    def at_least_wrong(self, found: Floats) -> Floats:
        """(k,) the least that facts can weigh which answers do not have, from their invariants (q, k)."""
        fits = np.array(self.invariants.fits(found))
        return self._least(fits, np.logical_or(fits[0], fits[1]))

    def _least(self, fits: NDArray[np.bool_], has: NDArray[np.bool_]) -> Floats:
        costs = np.where(fits & has, 0.0, np.where(has, self.sign, 1.0) * self.worth[:, None])
        return least_cost(self.invariants.shapes, len(self.axes), costs, self.fixed)

    def shared(self, axes: Sequence[Axis], found: Floats | None = None) -> NDArray[np.bool_]:
        """(q,) which invariants an answer has, but for signs.

        Args:
            axes: as for `wrong`.
            found: likewise.
        """
        return np.asarray(self._compared(axes, found)[2].any(axis=1), dtype=np.bool_)

    def _compared(
        self, axes: Sequence[Axis], found: Floats | None
    ) -> tuple[Floats, NDArray[np.bool_], NDArray[np.bool_]]:
        """An answer compared with the key, its joints placed beside the key's in k ways.

        Returns:
            (k,) the share that wrong joints leave of what is right; (2, q, k) which invariants fit as the
            axes point, and with one of them turned round; (q, k) which do either way and mean the same.
        """
        shift = len(axes) - len(self.axes)
        placings = _placings(len(self.axes), len(axes))
        besides = [
            [self.axes[i] if place is None else axes[place] for i, place in enumerate(places)]
            for places in placings
        ]
        kept = np.array([self._kept(*one) for one in zip(besides, placings, strict=True)])
        kept *= (1.0 - self.joint) ** max(shift, 0)
        if found is None:
            found = self.invariants.measured(axis_batch(besides))
        fits = np.array(self.invariants.fits(found))
        has = np.logical_or(fits[0], fits[1])
        if shift or not has[self.invariants.arrays.twists[:, 0]].all() or not self._alike(axes):
            shapes = self.invariants.shapes
            for q, k in zip(*map(np.ndarray.tolist, np.nonzero(has)), strict=True):
                has[q, k] = self._has(shapes[q], besides[k], placings[k])
        return kept, fits, has

    def _alike(self, axes: Sequence[Axis]) -> bool:
        return all(one.prismatic is other.prismatic for one, other in zip(self.axes, axes, strict=True))

    def _kept(self, beside: Sequence[Axis], places: Sequence[int | None]) -> float:
        """The share that joints which are missing or of another type leave of what is right."""
        missing = sum(place is None for place in places[1:-1])
        others = sum(
            place is not None and one.prismatic is not other.prismatic
            for place, one, other in zip(places[1:-1], beside[1:-1], self.axes[1:-1], strict=True)
        )
        return float((1.0 - self.joint) ** missing * (1.0 - self.type) ** others)

    def _has(self, shape: Shape, axes: Sequence[Axis], places: list[int | None]) -> bool:
        """Whether an invariant means in the answer what it means in the key."""
        span = range(min(shape.axes), max(shape.axes) + 1)
        first = places[span[0]]
        if first is None or places[span[0] : span[-1] + 1] != list(range(first, first + len(span))):
            return False
        if shape.measure is Measure.ANGLE:
            return True
        alike = all(self.axes[i].prismatic is axes[i].prismatic for i in shape.axes)
        return alike and self._is_defined(shape, axes, span)

    def _is_defined(self, shape: Shape, axes: Sequence[Axis], span: range) -> bool:
        """Whether a length means in the answer what it means in the key, whatever frames were chosen.

        An offset runs along parallel axes between axes that are not; a turn is about parallel prismatic
        joints; a distance beside prismatic joints disregards the directions of all axes in between.
        """
        if shape.measure is Measure.TURN:
            return all(self._is_as_parallel(axes, i, i + 1) for i in range(shape.axes[1], shape.axes[2] - 1))
        if shape.measure is Measure.OFFSET:
            pairs = {(i, i + 1) for i in span[:-1]} | {(shape.axes[2], shape.axes[3])}
            return all(self._is_as_parallel(axes, i, j) for i, j in pairs)
        if shape.measure is Measure.SUM:
            return all(self._is_as_parallel(axes, i, i + 1) for i in span[:-1]) and _are_level(axes, shape)
        if shape.measure is Measure.DISTANCE:
            if len(span) == len(shape.axes) - 2:
                return True
            basis: tuple[Vector, ...] = ()
            for i in shape.axes[2:]:
                rest = outside(axes[i].direction, basis)
                basis = (*basis, unit(rest)) if norm(rest) > NEARLY else basis
            return all(norm(outside(axes[i].direction, basis)) <= NEARLY for i in span)
        return True

    def _is_as_parallel(self, axes: Sequence[Axis], i: int, j: int) -> bool:
        return _are_parallel(axes[i], axes[j]) is _are_parallel(self.axes[i], self.axes[j])


@lru_cache(maxsize=256)
def _placings(ours: int, theirs: int) -> list[list[int | None]]:
    """For each axis of the key the answer's, in all ways; both ends stay where they are.

    Joints that are missing or superfluous may stand next to each other or apart.
    """
    fewer, more = sorted((ours, theirs))
    placings: list[list[int | None]] = []
    for apart in islice(_apart(fewer - 2, more - fewer), MOST_PLACINGS):
        left_out = {joint + 1 for joint in apart}
        kept = [i for i in range(more) if i not in left_out]
        if ours == fewer:
            placings.append([*kept])
        else:
            beside = dict(zip(kept, range(fewer), strict=True))
            placings.append([beside.get(i) for i in range(more)])
    return placings


def _apart(kept: int, others: int) -> Iterator[list[int]]:
    """Where other joints may stand among those that are kept, from 0: all together first, then apart."""
    if not others:
        yield []
    for groups in range(1, others + 1):
        for before in combinations(range(kept + 1), groups):
            for cuts in combinations(range(1, others), groups - 1):
                ends = [*cuts, others]
                yield [
                    place + k
                    for place, start, end in zip(before, [0, *cuts], ends, strict=True)
                    for k in range(start, end)
                ]


def fixed_ends(axes: int, policy: Policy) -> tuple[int, ...]:
    """Of so many axes between base and tool, those of these two that may not be turned round."""
    fixed = policy.base is BaseRule.FRAME, policy.tool is ToolRule.FRAME
    return tuple(i for i, end in zip((0, axes - 1), fixed, strict=True) if end)


@lru_cache(maxsize=256)
def fixed_signs(shapes: tuple[Shape, ...], fixed: tuple[int, ...]) -> list[int]:
    """The places of the invariants that depend on the directions of such axes alone as may not be turned."""
    return [
        q
        for q, shape in enumerate(shapes)
        if set(shape.axes[1:2] if shape.measure is Measure.OFFSET else shape.axes[:2]) <= set(fixed)
    ]


def least_cost(shapes: tuple[Shape, ...], axes: int, costs: Floats, fixed: tuple[int, ...] = ()) -> Floats:
    """Return the least cost of invariants over the directions of all axes: a forward sweep along the chain.

    Args:
        shapes: the invariants.
        axes: how many axes there are, base and tool among them.
        costs: (2, q, k) what each costs with the axes as they point, and with one of them turned round.
        fixed: the axes that may not be turned round, by their numbers.

    Returns:
        (k,) the sums.
    """
    alone, pairs, free, held = _links(shapes, axes, fixed)
    steps = (pairs @ costs)[_TURNED] + alone @ costs  # (before, now, axes, k)
    if fixed:
        steps[:, 1, fixed] = np.inf
    best = steps[0, :, 0]
    for step in steps.transpose(2, 0, 1, 3)[1:]:
        turned_or_not = best[:, None] + step
        best = np.minimum(turned_or_not[0], turned_or_not[1])
    least = np.minimum(best[0], best[1])
    if free or held:
        least += costs[:, free].min(axis=0).sum(axis=0) + costs[0, held].sum(axis=0)
    return np.asarray(least, dtype=np.float64)


@cached_by_size(lambda shapes, axes, fixed: axes, longest=USUAL_ROWS, most=256, few=32)
def _links(
    shapes: tuple[Shape, ...], axes: int, fixed: tuple[int, ...]
) -> tuple[Floats, Floats, list[int], list[int]]:
    """Which invariants depend on how one axis points, which on how it and the one before do, and the rest.

    Returns:
        (axes, q) and (axes, q), one where so, else zero; the places of the rest, and of those between axes
        that may not be turned round.
    """
    alone, pairs = np.zeros((axes, len(shapes))), np.zeros((axes, len(shapes)))
    free: list[int] = []
    held: list[int] = []
    for q, shape in enumerate(shapes):
        i, j = shape.axes[:2]
        if shape.measure is Measure.OFFSET:
            alone[j, q] = 1.0
        elif shape.measure is not Measure.TURN and j == i + 1:
            pairs[j, q] = 1.0
        else:
            (held if {i, j} <= set(fixed) else free).append(q)
    return alone, pairs, free, held


def _are_parallel(one: Axis, other: Axis) -> bool:
    return norm(cross(one.direction, other.direction)) <= NEARLY


def _are_level(axes: Sequence[Axis], shape: Shape) -> bool:
    """Whether all prismatic joints between the runs of a sum of offsets lie in one plane."""
    one, other, before, *_, behind = shape.axes[:7]
    normal = unit(cross(axes[one].direction, axes[other].direction))
    return all(abs(dot(axes[i].direction, normal)) <= NEARLY for i in range(before + 1, behind))
