"""What is measured of many chains at once: angles and lengths between their axes."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.caching import USUAL_INVARIANTS, cached_by_size
from kinematics.equivalence.batches import AxisBatch
from kinematics.se3 import Floats

Places = NDArray[np.intp]

# A sine, and below: the arithmetic leaves 1e-16, and what is nearer to parallel has its normal hundreds of
# thousands of robots away.
PARALLEL = 1e-7
PLAIN_OFFSET = 4  # Of how many axes an offset is without prismatic joints.

_NEXT, _LAST = np.array((1, 2, 0)), np.array((2, 0, 1))


class Measure(StrEnum):
    """What an invariant measures."""

    __hash__ = str.__hash__  # an Enum's own hash is a Python function, and shapes are looked up everywhere

    ANGLE = "angle"
    DISTANCE = "distance"
    OFFSET = "offset"
    TURN = "turn"
    SUM = "sum"


class Shape(NamedTuple):
    """What an invariant measures, and between which axes.

    Attributes:
        measure: what.
        axes: the numbers of the axes among those of `axes_of`: of an angle both; of a distance both, and
            those whose directions are disregarded; of an offset the axis before, the first and the last of
            the run, and the axis after; then, if prismatic joints between move the axis before or after in a
            plane, one of them at either end, or the axis of the run where there is none; of a turn the axis
            before, the prismatic joint, and the axis after; of a sum of offsets two prismatic joints side by
            side that span a plane, then the last and the first of the run before them, the axis before that
            and the prismatic joint between or the first again, then in the same way the first and the last of
            the run behind them, the axis after and the prismatic joint between.
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
    def runs(self) -> tuple[int, ...]:
        """The axes, first and last of each run, along which it measures an offset."""
        if self.measure is Measure.SUM:
            return (self.axes[3], self.axes[2], self.axes[6], self.axes[7])
        return self.axes[1:3] if self.measure is Measure.OFFSET else ()

    @property
    def is_angle(self) -> bool:
        """Whether it is an angle [rad], and no length."""
        return self.measure in (Measure.ANGLE, Measure.TURN)


@dataclass(frozen=True, eq=False, slots=True)
class InvariantArrays:
    """Invariants as arrays: their places in the list, and what they are measured between.

    Attributes:
        ways: (q, 1) -1 for those with a sign, or a supplement, else 1.
        half_turns: (q, 1) π for angles between two axes, else 0.
        twists: (q, 1) which are angles between two axes.
        angular: (q, 1) which are angles, and so do not depend on lengths.
        first: (q, 1) the first axis that each concerns.
        last: (q, 1) the last.
        pairs: (2, p) pairs of axes of which it takes the common normal.
        angles: places of the angles, and numbers of their pairs.
        normals: places of the distances along common normals, and numbers of their pairs.
        offsets: places of the offsets, and numbers of the pairs (first, before) and (last, after).
        others: of the rest its places, and (axes, how many) the axes' numbers, by measure and how
            many axes each has.
    """

    ways: Floats
    half_turns: Floats
    twists: NDArray[np.bool_]
    angular: NDArray[np.bool_]
    first: NDArray[np.intp]
    last: NDArray[np.intp]
    pairs: NDArray[np.intp]
    angles: tuple[Places, ...]
    normals: tuple[Places, ...]
    offsets: tuple[Places, ...]
    others: dict[tuple[Measure, int], tuple[list[int], Places]]


@cached_by_size(lambda shapes: len(shapes), longest=USUAL_INVARIANTS, most=1024, few=32)
def invariant_arrays(shapes: tuple[Shape, ...]) -> InvariantArrays:
    """Return the invariants as arrays; cached, for they are those of a key."""
    numbers: dict[tuple[int, int], int] = {}
    angles: tuple[list[int], list[int]] = [], []
    normals: tuple[list[int], list[int]] = [], []
    offsets: tuple[list[int], list[int], list[int]] = [], [], []
    others: dict[tuple[Measure, int], list[int]] = {}

    def pair(i: int, j: int) -> int:
        return numbers.setdefault((i, j), len(numbers))

    for place, (shape, axes) in enumerate((shape, shape.axes) for shape in shapes):
        if shape.measure is Measure.ANGLE:
            angles[0].append(place)
            angles[1].append(pair(axes[0], axes[1]))
        elif shape.measure is Measure.OFFSET and len(axes) == PLAIN_OFFSET:
            offsets[0].append(place)
            offsets[1].append(pair(axes[1], axes[0]))
            offsets[2].append(pair(axes[2], axes[3]))
        elif shape.reverses and shape.measure is Measure.DISTANCE:
            normals[0].append(place)
            normals[1].append(pair(axes[0], axes[1]))
        else:
            others.setdefault((shape.measure, len(axes)), []).append(place)
    return InvariantArrays(
        ways=np.array([-1.0 if shape.reverses else 1.0 for shape in shapes])[:, None],
        half_turns=np.array([np.pi if shape.measure is Measure.ANGLE else 0.0 for shape in shapes])[:, None],
        twists=np.array([shape.measure is Measure.ANGLE for shape in shapes], dtype=bool)[:, None],
        angular=np.array([shape.is_angle for shape in shapes], dtype=bool)[:, None],
        first=np.array([min(shape.axes) for shape in shapes], dtype=np.intp)[:, None],
        last=np.array([max(shape.axes) for shape in shapes], dtype=np.intp)[:, None],
        pairs=np.array(list(numbers), dtype=np.intp).reshape(-1, 2).T,
        angles=tuple(np.array(angles, dtype=np.intp)),
        normals=tuple(np.array(normals, dtype=np.intp)),
        offsets=tuple(np.array(offsets, dtype=np.intp)),
        others={
            kind: (places, np.array([shapes[place].axes for place in places], dtype=np.intp).T)
            for kind, places in others.items()
        },
    )


def measured(shapes: tuple[Shape, ...], axes: AxisBatch) -> Floats:
    """Return (q, k) invariants of many chains, as their axes point.

    Angles between axes are in [0, π]; lengths between two axes and offsets have signs, other lengths and the
    angles about prismatic joints have none.
    """
    arrays = invariant_arrays(shapes)
    found = np.empty((len(shapes), axes.directions.shape[2]))
    if arrays.pairs.size:
        _along_normals(arrays, axes, found)
    for (measure, _), (places, numbers) in arrays.others.items():
        if measure is Measure.OFFSET:
            found[places] = _offsets_past_prismatic(numbers, axes.directions[numbers], axes.points[numbers])
        elif measure is Measure.SUM:
            found[places] = _sums_of_offsets(numbers, axes.directions[numbers], axes.points[numbers])
        else:
            how = _turns if measure is Measure.TURN else _distances
            found[places] = how(axes.directions[numbers], axes.points[numbers])
    return found


def _along_normals(arrays: InvariantArrays, axes: AxisBatch, found: Floats) -> None:
    """Measure what common normals tell: angles, distances, and offsets between their feet.

    With s = |z_1 × z_2| and the gap g from the first axis to the second, the foot on the first stands
    (g·z_1 - (g·z_2)(z_1·z_2)) / s² from its point; where axes are parallel, any point will do.
    """
    both, ends = axes.directions.take(arrays.pairs, axis=0), axes.points.take(arrays.pairs, axis=0)
    one, other = both
    gap = ends[1] - ends[0]
    normal, cosine = _crosses(one, other), _dots(one, other)
    square = _dots(normal, normal)
    sine = np.sqrt(square)
    steep = sine > PARALLEL
    divisor = np.where(steep, sine, 1.0)
    along, beside = np.einsum("spck,pck->spk", both, gap)
    places, which = arrays.angles
    found[places] = np.arctan2(sine, cosine)[which]
    places, which = arrays.normals
    if places.size:
        across = np.sqrt(np.maximum(_dots(gap, gap) - along * along, 0.0))
        found[places] = np.where(steep, _dots(normal, gap) / divisor, across)[which]
    places, start, end = arrays.offsets
    if places.size:
        feet = np.where(steep, (along - beside * cosine) / (divisor * divisor), 0.0)
        first, last = arrays.pairs[0][start], arrays.pairs[0][end]
        run = axes.points[last] - axes.points[first] + feet[end][:, None] * axes.directions[last]
        found[places] = _dots(axes.directions[first], run) - feet[start]


def _dots(u: Floats, v: Floats) -> Floats:
    found: Floats = np.einsum("pck,pck->pk", u, v)
    return found


def _crosses(u: Floats, v: Floats) -> Floats:
    found: Floats = u.take(_NEXT, axis=1) * v.take(_LAST, axis=1)
    found -= u.take(_LAST, axis=1) * v.take(_NEXT, axis=1)
    return found


def _norms(v: Floats) -> Floats:
    return np.sqrt(_dots(v, v))


def _distances(directions: Floats, points: Floats) -> Floats:
    """What is left of the displacement from one axis to the other outside the directions that span it.

    Of directions and points of the axes, (axes, invariants, 3, k).
    """
    gap, first = points[1] - points[0], directions[2]
    across = gap - _dots(gap, first)[:, None] * first
    if len(directions) == 3:
        return _norms(across)
    normal = _crosses(first, directions[3])
    sine = _norms(normal)
    return np.divide(np.abs(_dots(normal, gap)), sine, out=_norms(across), where=sine > PARALLEL)


def _offsets_past_prismatic(numbers: Places, directions: Floats, points: Floats) -> Floats:
    """The distance along a run between the planes in which its neighbours are moved by prismatic joints.

    The plane of an axis z through p and a prismatic joint s has the normal n = z × s, and meets the run's
    axis u through o at o + u n·(p - o) / n·u; without a prismatic joint, s is the common normal u × z.
    """
    before, after = (_feet(ends, numbers, directions, points) for ends in ((0, 1, 4), (3, 2, 5)))
    run = points[2] - points[1] + after[:, None] * directions[2]
    return _dots(directions[1], run) - before


def _feet(ends: tuple[int, int, int], numbers: Places, directions: Floats, points: Floats) -> Floats:
    """How far along an axis such a plane meets it; ends: the axis beyond, this one, the prismatic joint."""
    beyond, own, prismatic = ends
    z, run = directions[beyond], directions[own]
    slides = (numbers[prismatic] != numbers[own])[:, None, None]
    normal = _crosses(z, np.where(slides, directions[prismatic], _crosses(run, z)))
    across = _dots(normal, run)
    steep = np.abs(across) > PARALLEL * PARALLEL
    along = _dots(normal, points[beyond] - points[own])
    return np.divide(along, across, out=np.zeros_like(along), where=steep)


def _sums_of_offsets(numbers: Places, directions: Floats, points: Floats) -> Floats:
    """The distance across the plane of two prismatic joints between the axes before and behind them.

    Either axis is taken where its offset is measured from: level with the foot at the other end of its run.
    """
    normal = _crosses(directions[0], directions[1])
    sine = _norms(normal)
    ends = []
    for near, far, beyond, prismatic in ((2, 3, 4, 5), (6, 7, 8, 9)):
        foot = (
            points[far]
            + _feet((beyond, far, prismatic), numbers, directions, points)[:, None] * directions[far]
        )
        along = _dots(directions[near], foot - points[near])
        ends.append(points[near] + along[:, None] * directions[near])
    apart = _dots(normal, ends[1] - ends[0])
    return np.divide(apart, sine, out=np.zeros_like(apart), where=sine > PARALLEL)


def _turns(directions: Floats, _: Floats) -> Floats:
    """The angle about a prismatic joint between the axes before and behind it; the same arrays."""
    before, prismatic, after = directions
    one = before - _dots(before, prismatic)[:, None] * prismatic
    other = after - _dots(after, prismatic)[:, None] * prismatic
    return np.arctan2(_norms(_crosses(one, other)), np.abs(_dots(one, other)))
