"""Which facts of a robot an answer has: types, twists, lengths and offsets that no choice of frames changes.

Every axis may point either way: the directions are chosen so that as little as possible is wrong. Joints too
many or too few are taken to be where that leaves the most facts right.
"""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from exercises.grading.alignments import NOT_THERE, alignments, shifts_between
from exercises.grading.axis_directions import least_cost
from kinematics.chain import Axis
from kinematics.equivalence.batches import axis_batch
from kinematics.equivalence.groups import outside
from kinematics.equivalence.invariants import Invariants
from kinematics.equivalence.measures import Measure, Shape
from kinematics.se3 import IDENTITY, Floats, Vector, compose, cross, dot, move, norm, rotate, unit

NEARLY = 0.01
"""Axes less than this apart [rad] count as parallel: rounded entries turn them by less, mistakes by more."""


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
        earned: (q,) what each of these is worth, and nothing of the others.
        joint: the share of what an answer has of these that it loses by a joint too many or too few.
        type: the share that it loses by a joint of another type.
    """

    axes: Sequence[Axis]
    invariants: Invariants
    fixed: tuple[int, ...]
    worth: Floats
    sign: float
    to_earn: float = 0.0
    earned: Floats = field(default_factory=lambda: np.zeros(1))
    joint: float = 0.0
    type: float = 0.0
    _of_other_type: dict[int, Floats] = field(default_factory=dict, repr=False)

    def wrong(self, axes: Sequence[Axis], found: Floats | None = None) -> float:
        """Return the weight of the facts that an answer does not have, and of what its joints take with them.

        A table of zeros has the right joints for nothing, so they can only be lost: each that is wrong takes
        a share of what is right beside it.

        Args:
            axes: its joint axes between base and tool, as those of the key.
            found: (q, 1) its invariants, if they are known; of an answer with one joint more or less than the
                key (q, 2), its links as many places behind the key's as `alignments` says, the fewest first.
        """
        compared = self._compared(axes, found)
        return float(self._least(compared).min())

    def at_least_wrong(self, found: Floats, types: Sequence[Sequence[bool]]) -> Floats:
        """Return (k,) the least that `wrong` can be of answers with the key's number of joints.

        Args:
            found: (q, k) their invariants.
            types: of each which of its axes are prismatic.
        """
        fits = self.invariants.fits(found)
        ours = [axis.prismatic for axis in self.axes]
        other = [tuple(i for i, one in enumerate(theirs) if one is not ours[i]) for theirs in types]
        seen = {joints: self._seen_but_for(joints) for joints in set(other)}
        kept, unseen = zip(*(seen[joints] for joints in other), strict=True)
        return self._least(_Compared(np.array(kept), fits, np.logical_or(*fits), np.hstack(unseen)))

    def _least(self, compared: "_Compared") -> Floats:
        """Return (k,) the least weight over the directions of all axes, with what the joints take."""
        kept, fits, has, unseen = compared
        worth = np.where(has, self.sign, 1.0) * self.worth[:, None]
        costs = np.where(fits & has, 0.0, worth)
        if unseen is not None:
            costs = np.where(unseen, self.earned[:, None], costs)
        least = least_cost(self.invariants.shapes, len(self.axes), costs, self.fixed)
        return np.asarray(least + np.maximum(self.to_earn - least, 0.0) * (1.0 - kept), dtype=np.float64)

    def shared(self, axes: Sequence[Axis], found: Floats | None = None) -> NDArray[np.bool_]:
        """Return (q,) which invariants an answer has, but for signs.

        Args:
            axes: as for `wrong`.
            found: likewise.
        """
        return np.asarray(self._compared(axes, found).has.any(axis=1), dtype=np.bool_)

    def _compared(self, axes: Sequence[Axis], found: Floats | None) -> "_Compared":
        """An answer compared with the key, its links beside the key's in k ways."""
        shift = len(self.axes) - len(axes)
        ours, theirs = (tuple(axis.prismatic for axis in some) for some in (self.axes, axes))
        ways = alignments(ours, theirs)
        if not shift:
            return self._compared_one_by_one(axes, found, ways.others[0])
        shifts = range(min(shift, 0), max(shift, 0) + 1)
        besides = [
            [axes[i - by] if 0 <= i - by < len(axes) else own for i, own in enumerate(self.axes)]
            for by in shifts
        ]
        fits = self.invariants.fits(self.invariants.measured(axis_batch(besides)) if found is None else found)
        either = np.logical_or(fits[0], fits[1])
        for q, k in np.argwhere(either).tolist():
            either[q, k] = self._means(self.invariants.shapes[q], besides[k])
        spans = zip(*(ends[:, 0].tolist() for ends in self.invariants.spans), strict=True)
        there = shifts_between(ours, theirs, tuple(spans))
        beside = np.arange(len(there))[:, None], np.minimum(there - shifts[0], len(shifts) - 1)
        others = np.array([len(joints) for joints in ways.others])
        return _Compared(
            np.asarray((1.0 - self.joint) ** abs(shift) * (1.0 - self.type) ** others, dtype=np.float64),
            fits[:, *beside],
            either[beside] & (there != NOT_THERE),
        )

    def _compared_one_by_one(
        self, axes: Sequence[Axis], found: Floats | None, others: Sequence[int]
    ) -> "_Compared":
        """An answer with the key's number of joints, of which some are of another type.

        Such a joint is read as one of the key's type, on the line on which it was drawn. What its variable
        changes then cannot be seen: it stood where the key has a constant.
        """
        if found is None:
            found = self.invariants.measured(axis_batch([axes]))
        fits = self.invariants.fits(found)
        has = np.logical_or(fits[0], fits[1])
        if others:
            has &= self._has(self.invariants.measured(axis_batch([_moved(axes, others)])))
        if others or not has[self.invariants.arrays.twists[:, 0]].all():
            for q in np.flatnonzero(has[:, 0]).tolist():
                has[q] = self._is_defined(self.invariants.shapes[q], axes)
        if not others:
            return _Compared(np.ones(1), fits, has)
        kept, unseen = self._seen_but_for(others)
        return _Compared(np.array([kept]), fits, has & ~unseen, unseen)

    def _seen_but_for(self, others: Sequence[int]) -> tuple[float, NDArray[np.bool_]]:
        """What joints of another type leave of what is right, and (q, 1) which invariants nobody can see."""
        kept, unseen = 1.0, np.zeros((len(self.invariants.shapes), 1), dtype=np.bool_)
        for joint in others:
            changed = self._changed_by_type(joint)
            hidden = float((self.earned * changed[:, 0]).sum())
            if hidden < self.to_earn:
                kept *= min((1.0 - self.type) * self.to_earn / (self.to_earn - hidden), 1.0)
            unseen |= changed
        return kept, unseen

    def _changed_by_type(self, joint: int) -> NDArray[np.bool_]:
        """(q, 1) which invariants of the key change as a joint moves, if it is of the other type."""
        if joint not in self._of_other_type:
            other = list(self.axes)
            other[joint] = other[joint]._replace(prismatic=not other[joint].prismatic)
            self._of_other_type[joint] = self.invariants.measured(axis_batch([_moved(other, (joint,))]))
        return ~self._has(self._of_other_type[joint])

    def _has(self, found: Floats) -> NDArray[np.bool_]:
        """(q, 1) which measured invariants have the key's values, but for signs."""
        return np.asarray(self.invariants.fits(found).any(axis=0), dtype=np.bool_)

    def _means(self, shape: Shape, axes: Sequence[Axis]) -> bool:
        """Whether an invariant means in an answer with other joints what it means in the key."""
        if shape.measure is Measure.ANGLE:
            return True
        alike = all(self.axes[i].prismatic is axes[i].prismatic for i in shape.axes)
        return alike and self._is_defined(shape, axes)

    def _is_defined(self, shape: Shape, axes: Sequence[Axis]) -> bool:
        """Whether a length means in the answer what it means in the key, whatever frames were chosen.

        An offset runs along parallel axes between axes that are not; a turn is about parallel prismatic
        joints; a distance beside prismatic joints disregards the directions of all axes in between.
        """
        span = range(min(shape.axes), max(shape.axes) + 1)
        if shape.measure is Measure.TURN:
            return all(self._is_as_parallel(axes, i, i + 1) for i in range(shape.axes[1], shape.axes[2] - 1))
        if shape.measure is Measure.OFFSET:
            pairs = {(i, i + 1) for i in span[:-1]} | {(shape.axes[2], shape.axes[3])}
            return all(self._is_as_parallel(axes, i, j) for i, j in pairs)
        if shape.measure is Measure.SUM:
            return all(self._is_as_parallel(axes, i, i + 1) for i in span[:-1]) and _are_level(axes, shape)
        if shape.measure is Measure.DISTANCE:
            spanning = shape.axes[2:]
            others = [i for i in span if i not in spanning]
            basis: tuple[Vector, ...] = ()
            for i in spanning if others else ():
                rest = outside(axes[i].direction, basis)
                basis = (*basis, unit(rest)) if norm(rest) > NEARLY else basis
            return all(norm(outside(axes[i].direction, basis)) <= NEARLY for i in others)
        return True

    def _is_as_parallel(self, axes: Sequence[Axis], i: int, j: int) -> bool:
        return _are_parallel(axes[i], axes[j]) is _are_parallel(self.axes[i], self.axes[j])


class _Compared(NamedTuple):
    """An answer compared with a key in k ways.

    Attributes:
        kept: (k,) the share that wrong joints leave of what is right.
        fits: (2, q, k) which invariants fit as the axes point, and with one of them turned round.
        has: (q, k) which do either way and mean the same.
        unseen: (q, k) which nobody can see, whatever they are.
    """

    kept: Floats
    fits: NDArray[np.bool_]
    has: NDArray[np.bool_]
    unseen: NDArray[np.bool_] | None = None


def _moved(axes: Sequence[Axis], joints: Collection[int]) -> list[Axis]:
    """The axes where some joints have other values."""
    far = 1.0 + max(norm(axis.point) for axis in axes)
    carried, found = IDENTITY, []
    for i, axis in enumerate(axes):
        direction, point = rotate(carried, axis.direction), move(carried, axis.point)
        found.append(axis._replace(direction=direction, point=point))
        if i in joints:
            carried = compose(carried, axis.motion(far if axis.prismatic else 1.0))
    return found


def _are_parallel(one: Axis, other: Axis) -> bool:
    return norm(cross(one.direction, other.direction)) <= NEARLY


def _are_level(axes: Sequence[Axis], shape: Shape) -> bool:
    """Whether all prismatic joints between the runs of a sum of offsets lie in one plane."""
    one, other, before, *_, behind = shape.axes[:7]
    normal = unit(cross(axes[one].direction, axes[other].direction))
    return all(abs(dot(axes[i].direction, normal)) <= NEARLY for i in range(before + 1, behind))
