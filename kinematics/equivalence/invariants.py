"""Facts of a chain that no choice of frames changes, measured of many tables at once.

Between neighbouring axes the angle and the distance (sliders between them disregarded); along a run of
parallel axes the distance between the common normals before and after; about a slider the angle between its
neighbours. Their sizes are necessary for equivalence, not sufficient; with their signs, and each axis turned
round as it suits best (`exercises.grading.facts`), hardly anything wrong is left.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.chain import Axis, Chain
from kinematics.equivalence.batches import AxisBatch, axis_batch
from kinematics.equivalence.groups import outside
from kinematics.equivalence.policy import BaseRule, Policy, ToolRule
from kinematics.equivalence.reference import Reference
from kinematics.se3 import ORIGIN, Z_AXIS, Vector, cross, norm, position, unit, z_axis

# A sine, and below: the arithmetic leaves 1e-16, and what is nearer to parallel has its normal hundreds of
# thousands of robots away.
PARALLEL = 1e-7
# In units of the tolerance of the end frame: the rounded entries of six joints may all add up in one
# invariant.
SLACK = 6.0
# A share of the robot, and [rad]: the arithmetic leaves 1e-9 of it where axes are steep enough to be
# measured at all.
FLOOR = 1e-7
# A sine: between flatter axes, offsets are levered up by more than fifty and say nothing.
STEEPEST = 0.02
# Directions that span space leave no distance.
DIMENSIONS = 3


class Measure(StrEnum):
    """What an invariant measures."""

    ANGLE = "angle"
    DISTANCE = "distance"
    OFFSET = "offset"
    TURN = "turn"


Floats = NDArray[np.float64]


class Shape(NamedTuple):
    """What an invariant measures, and between which axes.

    Attributes:
        measure: what.
        axes: the numbers of the axes among those of `axes_of`: of an angle both; of a distance both, and
            those whose directions are disregarded; of an offset the axis before, the first and the last of
            the run, and the axis after; of a turn the axis before, the slider, and the axis after.
    """

    measure: Measure
    axes: tuple[int, ...]

    @property
    def reverses(self) -> bool:
        """Whether the value has a sign, or the angle a supplement, that goes with the axes' directions."""
        if self.measure is Measure.DISTANCE:
            return set(self.axes[2:]) == set(self.axes[:2])
        return self.measure is not Measure.TURN

    @property
    def is_angle(self) -> bool:
        """Whether it is an angle [rad], and no length."""
        return self.measure in (Measure.ANGLE, Measure.TURN)


@dataclass(frozen=True, eq=False)
class Invariants:
    """The invariants of a reference.

    Attributes:
        shapes: what they are.
        values: (q, 1) what they are in the reference, as its axes point.
        slacks: (q, 1) how far a submission's may be off.
    """

    shapes: tuple[Shape, ...]
    values: Floats
    slacks: Floats

    @property
    def spans(self) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        """(q, 1) each: the first and the last axis that an invariant concerns."""
        gauge = _gauge(self.shapes)
        return gauge.first, gauge.last

    def measured(self, axes: AxisBatch) -> Floats:
        """(q, k) what they are in submissions, as their axes point."""
        return measured(self.shapes, axes)

    def reversed(self, found: Floats) -> Floats:
        """(q, k) what the measured values would be if one of the axes were turned round."""
        gauge = _gauge(self.shapes)
        return np.where(gauge.reverses, np.where(gauge.twists, math.pi, 0.0) - found, found)

    def sizes(self, found: Floats) -> Floats:
        """(q, k) the measured values whichever way axes point: angles up to π/2, lengths without signs."""
        gauge = _gauge(self.shapes)
        return np.where(gauge.twists, np.minimum(found, math.pi - found), np.abs(found))

    def strains(self, found: Floats) -> Floats:
        """(q, k) how far the sizes of the measured values are off, in units of what they may be."""
        return np.asarray(np.abs(self.sizes(found) - self.sizes(self.values)) / self.slacks)

    def fits(self, found: Floats) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """(q, k) which of the measured values fit; and which would if one of their axes were turned round."""
        return (
            np.abs(found - self.values) <= self.slacks,
            np.abs(self.reversed(found) - self.values) <= self.slacks,
        )

    def some(self, which: Sequence[int]) -> Invariants:
        """Some of them."""
        return Invariants(tuple(self.shapes[i] for i in which), self.values[which], self.slacks[which])

    def held_to(self, slacks: Floats) -> Invariants:
        """The same with other slacks, (q, 1), where these are smaller."""
        return replace(self, slacks=np.minimum(self.slacks, slacks))


def axes_of(chain: Chain, policy: Policy) -> list[Axis]:
    """The joint axes, with what the policy fixes at the ends as further axes.

    A fixed origin or tool point stands for itself as an axis along the neighbouring joint's; frames and lines
    stand as their z axis. Index 0 is always the base's place, whether it is fixed or not.
    """
    if not chain.axes:
        return []
    first, last = chain.axes[0], chain.axes[-1]
    base = Axis(False, Z_AXIS if policy.base is BaseRule.FRAME else first.direction, ORIGIN)
    direction = z_axis(chain.end) if policy.tool is ToolRule.FRAME else last.direction
    return [base, *chain.axes, Axis(False, direction, position(chain.end))]


@lru_cache(maxsize=4096)
def invariants_of(reference: Reference, policy: Policy) -> Invariants:
    """The invariants of a reference, and of the frames that a policy fixes."""
    axes = axes_of(reference.chain, policy)
    found: list[tuple[Shape, float]] = []
    fixed_base = policy.base in (BaseRule.ORIGIN, BaseRule.FRAME)
    fixed_tool = policy.tool in (ToolRule.POINT, ToolRule.FRAME)
    first = 0 if fixed_base else 1
    last = len(axes) - 1 if fixed_tool else len(axes) - 2
    for i in range(first, last):
        found += _between(axes, i, last, reference.size, policy)
    for i in range(first if fixed_base else first + 1, last):
        found += _along(axes, i, last, reference.size, policy)
    shapes = tuple(shape for shape, _ in found)
    slacks = np.array([slack for _, slack in found], dtype=np.float64)[:, None]
    return Invariants(shapes, measured(shapes, axis_batch([axes])), slacks)


def _between(
    axes: Sequence[Axis], i: int, last: int, size: float, policy: Policy
) -> list[tuple[Shape, float]]:
    """Between an axis and the next, and the next that is no slider; each with its slack."""
    found = [(Shape(Measure.ANGLE, (i, i + 1)), SLACK * policy.tolerance.angle + FLOOR)]
    k = i + 1
    while k < last and axes[k].prismatic:
        k += 1
    if axes[i].prismatic or axes[k].prismatic:
        return found
    spanning, steepness = _spanning(axes, (i, *range(k, i, -1)))
    if len(spanning) < DIMENSIONS:
        slack = (SLACK * policy.tolerance.length + FLOOR) * size / steepness
        found.append((Shape(Measure.DISTANCE, (i, k, *spanning)), slack))
    return found


def _spanning(axes: Sequence[Axis], candidates: Sequence[int]) -> tuple[tuple[int, ...], float]:
    """Which of some axes span the directions of all of them, and how steep the flattest of these is."""
    chosen: list[int] = []
    basis: list[Vector] = []
    steepness = 1.0
    for k in candidates:
        rest = outside(axes[k].direction, tuple(basis))
        if norm(rest) > PARALLEL:
            chosen.append(k)
            steepness = min(steepness, norm(rest))
            basis.append(unit(rest))
    return tuple(chosen), max(steepness, STEEPEST)


def _along(axes: Sequence[Axis], i: int, last: int, size: float, policy: Policy) -> list[tuple[Shape, float]]:
    """Along the run of parallel axes that begins with axis i, or about the slider i.

    A point that the policy fixes is its own foot at its end of the run.
    """
    here = axes[i]
    before = max(i - 1, 0)
    sine = norm(cross(axes[before].direction, here.direction)) if i else 1.0
    if sine < STEEPEST:
        return []
    if here.prismatic:
        return _about(axes, i, sine, policy) if i else []
    j = i
    while j < last and not axes[j + 1].prismatic and _parallel(axes[j + 1], here):
        j += 1
    after = min(j + 1, last)
    while after < last and axes[after].prismatic and _parallel(axes[after], axes[after + 1]):
        after += 1
    other = norm(cross(axes[after].direction, here.direction)) if j < last else 1.0
    if other < STEEPEST or axes[after].prismatic or axes[before].prismatic:
        return []
    if j == last and last != len(axes) - 1:
        return []
    slack = (SLACK * policy.tolerance.length + FLOOR) * size / min(sine, other)
    return [(Shape(Measure.OFFSET, (before, i, j, after)), slack)]


def _about(axes: Sequence[Axis], i: int, sine: float, policy: Policy) -> list[tuple[Shape, float]]:
    other = norm(cross(axes[i].direction, axes[i + 1].direction))
    if other < STEEPEST:
        return []
    slack = SLACK * policy.tolerance.angle / (sine * other) + FLOOR
    return [(Shape(Measure.TURN, (i - 1, i, i + 1)), slack)]


def _parallel(one: Axis, other: Axis) -> bool:
    return norm(cross(one.direction, other.direction)) < PARALLEL


@dataclass(frozen=True, eq=False, slots=True)
class _Gauge:
    """Invariants by what they measure: places in the list, and numbers of axes, for arrays of them at once.

    Attributes:
        reverses: (q, 1) which have a sign, or a supplement.
        twists: (q, 1) which are angles between two axes.
        first: (q, 1) the first axis that each concerns.
        last: (q, 1) the last.
        kinds: of each measure, with and without signs, its invariants' places in the list, and the axes'
            numbers, (axes, how many).
    """

    reverses: NDArray[np.bool_]
    twists: NDArray[np.bool_]
    first: NDArray[np.intp]
    last: NDArray[np.intp]
    kinds: dict[tuple[Measure, int, bool], tuple[list[int], NDArray[np.intp]]]


@lru_cache(maxsize=1024)
def _gauge(shapes: tuple[Shape, ...]) -> _Gauge:
    kinds: dict[tuple[Measure, int, bool], list[int]] = {}
    for place, shape in enumerate(shapes):
        kinds.setdefault((shape.measure, len(shape.axes), shape.reverses), []).append(place)
    return _Gauge(
        reverses=np.array([shape.reverses for shape in shapes], dtype=bool)[:, None],
        twists=np.array([shape.measure is Measure.ANGLE for shape in shapes], dtype=bool)[:, None],
        first=np.array([min(shape.axes) for shape in shapes], dtype=np.intp)[:, None],
        last=np.array([max(shape.axes) for shape in shapes], dtype=np.intp)[:, None],
        kinds={
            kind: (places, np.array([shapes[place].axes for place in places], dtype=np.intp).T)
            for kind, places in kinds.items()
        },
    )


def measured(shapes: tuple[Shape, ...], axes: AxisBatch) -> Floats:
    """(q, k) invariants of many chains, as their axes point.

    Angles between axes are in [0, π]; lengths between two axes and offsets have signs, other lengths and the
    angles about sliders have none.
    """
    found = np.empty((len(shapes), axes.directions.shape[2]))
    for (measure, _, signed), (places, numbers) in _gauge(shapes).kinds.items():
        how = _signed_distances if signed and measure is Measure.DISTANCE else _MEASURES[measure]
        found[places] = how(axes.directions[:, numbers], axes.points[:, numbers])
    return found


# Every measure takes directions and points of the axes, (3, axes, invariants, k), to values (invariants, k).


def _dots(u: Floats, v: Floats) -> Floats:
    return np.asarray(u[0] * v[0] + u[1] * v[1] + u[2] * v[2], dtype=np.float64)


def _crosses(u: Floats, v: Floats) -> Floats:
    return np.array(cross((u[0], u[1], u[2]), (v[0], v[1], v[2])), dtype=np.float64)


def _norms(v: Floats) -> Floats:
    return np.asarray(np.sqrt(_dots(v, v)), dtype=np.float64)


def _angles(directions: Floats, _: Floats) -> Floats:
    one, other = directions[:, 0], directions[:, 1]
    return np.arctan2(_norms(_crosses(one, other)), _dots(one, other))


def _distances(directions: Floats, points: Floats) -> Floats:
    """What is left of the displacement from one axis to the other outside the directions that span it."""
    gap = points[:, 1] - points[:, 0]
    first = directions[:, 2]
    across = gap - _dots(gap, first) * first
    if directions.shape[1] == 3:
        return _norms(across)
    normal = _crosses(first, directions[:, 3])
    sine = _norms(normal)
    steep = sine > PARALLEL
    beside = np.abs(_dots(normal, gap)) / np.where(steep, sine, 1.0)
    return np.asarray(np.where(steep, beside, _norms(across)), dtype=np.float64)


def _signed_distances(directions: Floats, points: Floats) -> Floats:
    """The same between two axes that are not parallel: from the first to the other, along d_1 × d_2."""
    gap = points[:, 1] - points[:, 0]
    normal = _crosses(directions[:, 0], directions[:, 1])
    return np.asarray(_distances(directions, points) * np.where(_dots(normal, gap) < 0.0, -1.0, 1.0))


def _offsets(directions: Floats, points: Floats) -> Floats:
    """Along a run of parallel axes, from the normal before it to the normal behind it."""
    first = directions[:, 1]
    start = _feet(directions[:, 1], points[:, 1], directions[:, 0], points[:, 0])
    end = _feet(directions[:, 2], points[:, 2], directions[:, 3], points[:, 3])
    return _dots(first, end - start)


def _feet(direction: Floats, point: Floats, other: Floats, through: Floats) -> Floats:
    """Where the common normals with other axes stand on axes; some point where there is no one normal."""
    normal = _crosses(direction, other)
    square = _dots(normal, normal)
    steep = square >= PARALLEL**2
    along = _dots(_crosses(through - point, other), normal) / np.where(steep, square, 1.0)
    return point + np.where(steep, along, 0.0) * direction


def _turns(directions: Floats, _: Floats) -> Floats:
    before, slider, after = directions[:, 0], directions[:, 1], directions[:, 2]
    one = before - _dots(before, slider) * slider
    other = after - _dots(after, slider) * slider
    return np.arctan2(_norms(_crosses(one, other)), np.abs(_dots(one, other)))


_MEASURES = {
    Measure.ANGLE: _angles,
    Measure.DISTANCE: _distances,
    Measure.OFFSET: _offsets,
    Measure.TURN: _turns,
}
