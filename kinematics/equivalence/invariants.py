"""Facts of a chain that no choice of frames changes, measured of many tables at once.

Between neighbouring axes the angle and the distance (prismatic joints between them disregarded); along a run
of parallel axes the distance between the common normals before and after, or, where prismatic joints move the
axis there in a plane, the points in which that plane meets the run, or the sum of what lies beyond the plane
on both sides; about a prismatic joint the angle between its neighbours.
Their sizes are necessary for equivalence, not sufficient; with their signs, and each axis turned round as it
suits best (`exercises.grading.facts`), hardly anything wrong is left.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.caching import USUAL_ROWS, cached_by_size
from kinematics.chain import Axis, Chain
from kinematics.equivalence.batches import AxisBatch, axis_batch
from kinematics.equivalence.groups import outside
from kinematics.equivalence.measures import (
    PARALLEL,
    InvariantArrays,
    Measure,
    Shape,
    invariant_arrays,
    measured,
)
from kinematics.equivalence.policy import BaseRule, Policy, ToolRule
from kinematics.equivalence.reference import Reference
from kinematics.se3 import ORIGIN, Z_AXIS, Floats, Vector, cross, dot, norm, position, unit, z_axis

SLACK = 6.0
"""In units of the tolerance of the end frame: the rounded entries of six joints may all add up in one
invariant."""
FLOOR = 1e-7
"""A share of the robot, and [rad]: the arithmetic leaves 1e-9 of it where axes are steep enough to be
measured at all."""
STEEPEST = 0.005
"""A sine: between flatter axes, offsets are levered up by more than two hundred. From fifty on they say
nothing of a pose within the tolerance, but exact numbers are still the key's or not."""
DIMENSIONS = 3  # Directions that span space leave no distance.


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

    @cached_property
    def arrays(self) -> InvariantArrays:
        """What they are measured between, as arrays."""
        return invariant_arrays(self.shapes)

    @cached_property
    def own_sizes(self) -> Floats:
        """(q, 1) the sizes of the reference's own."""
        return self.sizes(self.values)

    @property
    def spans(self) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        """(q, 1) each: the first and the last axis that an invariant concerns."""
        return self.arrays.first, self.arrays.last

    @property
    def angular(self) -> NDArray[np.bool_]:
        """(q, 1) which are angles, and so do not depend on lengths."""
        return self.arrays.angular

    def measured(self, axes: AxisBatch) -> Floats:
        """Return their (q, k) values in submissions, as the axes point."""
        return measured(self.shapes, axes)

    def reversed(self, found: Floats) -> Floats:
        """Return the (q, k) values that there would be if one of the axes were turned round."""
        return self.arrays.half_turns + self.arrays.ways * found

    def sizes(self, found: Floats) -> Floats:
        """Return the (q, k) values whichever way axes point: angles up to π/2, lengths without signs."""
        return np.minimum(np.abs(found), np.abs(self.arrays.half_turns - found))

    def strains(self, found: Floats) -> Floats:
        """Return (q, k) errors of the sizes, in units of what is allowed."""
        return np.asarray(np.abs(self.sizes(found) - self.own_sizes) / self.slacks)

    def fits(self, found: Floats) -> NDArray[np.bool_]:
        """Return (2, q, k): which values fit, and which would if one of their axes were turned round."""
        return np.abs(np.array((found, self.reversed(found))) - self.values) <= self.slacks

    def some(self, which: Sequence[int]) -> "Invariants":
        """Return some of them."""
        return Invariants(tuple(self.shapes[i] for i in which), self.values[which], self.slacks[which])

    def beside(self, others: "Invariants") -> "Invariants":
        """Return these, and others after them."""
        if not others.shapes:
            return self
        return Invariants(
            (*self.shapes, *others.shapes),
            np.concatenate((self.values, others.values)),
            np.concatenate((self.slacks, others.slacks)),
        )

    def held_to(self, slacks: Floats) -> "Invariants":
        """Return the same with other slacks, (q, 1), where these are smaller."""
        return replace(self, slacks=np.minimum(self.slacks, slacks))


def axes_of(chain: Chain, policy: Policy) -> list[Axis]:
    """Return the joint axes, with what the policy fixes at the ends as further axes.

    A fixed origin or tool point stands for itself as an axis along the neighbouring joint's; frames and lines
    stand as their z axis. Index 0 is always the base's place, whether it is fixed or not.
    """
    if not chain.axes:
        return []
    first, last = chain.axes[0], chain.axes[-1]
    base = Axis(False, Z_AXIS if policy.base is BaseRule.FRAME else first.direction, ORIGIN)
    direction = z_axis(chain.end) if policy.tool is ToolRule.FRAME else last.direction
    return [base, *chain.axes, Axis(False, direction, position(chain.end))]


@cached_by_size(lambda reference, policy: len(reference.table.rows), longest=USUAL_ROWS, most=1024, few=32)
def invariants_of(reference: Reference, policy: Policy) -> Invariants:
    """Return the invariants of a reference, and of the frames that a policy fixes."""
    axes = axes_of(reference.chain, policy)
    if not axes:
        return Invariants((), np.empty((0, 1)), np.empty((0, 1)))
    found: list[tuple[Shape, float]] = []
    fixed_base = policy.base in (BaseRule.ORIGIN, BaseRule.FRAME)
    fixed_tool = policy.tool in (ToolRule.POINT, ToolRule.FRAME)
    first = 0 if fixed_base else 1
    last = len(axes) - 1 if fixed_tool else len(axes) - 2
    for i in range(first, last):
        found += _between(axes, i, last, reference.size, policy)
    for i in range(first if fixed_base else first + 1, last):
        found += _along(axes, i, last, reference.size, policy)
    for i in range(first, last):
        found += _across(axes, i, last, reference.size, policy)
    shapes = tuple(shape for shape, _ in found)
    slacks = np.array([slack for _, slack in found], dtype=np.float64)[:, None]
    return Invariants(shapes, measured(shapes, axis_batch([axes])), slacks)


def _between(
    axes: Sequence[Axis], i: int, last: int, size: float, policy: Policy
) -> list[tuple[Shape, float]]:
    """Between an axis and the next, and the next that is no prismatic joint; each with its slack."""
    found = [(Shape(Measure.ANGLE, (i, i + 1)), SLACK * policy.tolerance.angle + FLOOR)]
    k = i + 1
    while k < last and axes[k].prismatic:
        k += 1
    if axes[i].prismatic or axes[k].prismatic:
        return found
    spanning, steepness = spanning_axes(axes, (i, *range(k, i, -1)))
    if len(spanning) < DIMENSIONS:
        slack = (SLACK * policy.tolerance.length + FLOOR) * size / steepness
        found.append((Shape(Measure.DISTANCE, (i, k, *spanning)), slack))
    return found


def spanning_axes(axes: Sequence[Axis], candidates: Sequence[int]) -> tuple[tuple[int, ...], float]:
    """Return which of some axes span the directions of all, and how steep the flattest of these is."""
    chosen: list[int] = []
    basis: list[Vector] = []
    steepness: list[float] = []
    for k in candidates:
        rest = outside(axes[k].direction, tuple(basis))
        if norm(rest) > PARALLEL:
            chosen.append(k)
            steepness.append(norm(rest))
            basis.append(unit(rest))
    return tuple(chosen), max(min(steepness), STEEPEST)


def _along(axes: Sequence[Axis], i: int, last: int, size: float, policy: Policy) -> list[tuple[Shape, float]]:
    """Along the run of parallel axes that begins with axis i, or about the prismatic joint i.

    A point that the policy fixes is its own foot at its end of the run.
    """
    here = axes[i]
    if i and norm(cross(axes[i - 1].direction, here.direction)) < STEEPEST:
        return []
    if here.prismatic:
        return _about(axes, i, last, policy) if i else []
    j = i
    while j < last and not axes[j + 1].prismatic and _parallel(axes[j + 1], here):
        j += 1
    if j == last and last != len(axes) - 1:
        return []
    first = 0 if policy.base in (BaseRule.ORIGIN, BaseRule.FRAME) else 1
    start = _end_of_run(axes, i, range(i - 1, first - 1, -1))
    end = _end_of_run(axes, j, range(j + 1, last + 1))
    if start is None or end is None:
        return []
    slides = start.slider != i or end.slider != j
    shape = (start.axis, i, j, end.axis, *((start.slider, end.slider) if slides else ()))
    slack = (SLACK * policy.tolerance.length + FLOOR) * size / min(start.steepness, end.steepness)
    return [(Shape(Measure.OFFSET, shape), slack)]


def _across(
    axes: Sequence[Axis], b: int, last: int, size: float, policy: Policy
) -> list[tuple[Shape, float]]:
    """Across the plane that the prismatic joints behind axis b span: neither axis beside them lies in it.

    Along each of these the offset may be anything, but not the sum of both.
    """
    c = next((k for k in range(b + 1, last + 1) if not axes[k].prismatic), b)
    if axes[b].prismatic or c < b + 3:
        return []
    sliders = range(b + 1, c)
    plane = next((k for k in sliders[:-1] if not _parallel(axes[k], axes[k + 1])), None)
    if plane is None or len(spanning_axes(axes, sliders)[0]) == DIMENSIONS:
        return []
    normal = cross(axes[plane].direction, axes[plane + 1].direction)
    first = 0 if policy.base in (BaseRule.ORIGIN, BaseRule.FRAME) else 1
    i = next((k + 1 for k in range(b - 1, first - 1, -1) if not _runs_on(axes, k, b)), first)
    j = next((k - 1 for k in range(c + 1, last + 1) if not _runs_on(axes, k, c)), last)
    if (i == first == 1) or (j == last != len(axes) - 1):
        return []
    start = _end_of_run(axes, i, range(i - 1, first - 1, -1))
    end = _end_of_run(axes, j, range(j + 1, last + 1))
    if start is None or end is None:
        return []
    flattest = min(abs(dot(axes[k].direction, unit(normal))) for k in (b, c))
    if flattest < STEEPEST:
        return []
    steepness = min(start.steepness, end.steepness, max(norm(normal), STEEPEST))
    shape = (plane, plane + 1, b, i, start.axis, start.slider, c, j, end.axis, end.slider)
    return [(Shape(Measure.SUM, shape), (SLACK * policy.tolerance.length + FLOOR) * size / steepness)]


def _runs_on(axes: Sequence[Axis], k: int, beside: int) -> bool:
    return not axes[k].prismatic and _parallel(axes[k], axes[beside])


class _End(NamedTuple):
    """What an offset is measured from, at one end of a run of parallel axes.

    Attributes:
        axis: the next axis beyond the end that is no prismatic joint; the one at the end, if there is none.
        slider: the one between that moves the other axis in a plane; the axis at the end, if none does.
        steepness: of the run to that plane, or to the other axis.
    """

    axis: int
    slider: int
    steepness: float


def _end_of_run(axes: Sequence[Axis], k: int, beyond: Sequence[int]) -> _End | None:
    """The end of a run at axis k; None if what lies beyond it leaves no offset."""
    if not beyond:
        return _End(k, k, 1.0)
    next_turning = next((i for i in beyond if not axes[i].prismatic), None)
    if next_turning is None:
        return None
    sliders = range(k, next_turning, 1 if next_turning > k else -1)[1:]
    spanning, _ = spanning_axes(axes, (next_turning, *sliders))
    if len(spanning) == 1:
        slider, steepness = k, norm(cross(axes[next_turning].direction, axes[k].direction))
    else:
        slider = spanning[1]
        normal = cross(axes[next_turning].direction, axes[slider].direction)
        steepness = abs(dot(normal, axes[k].direction))
    if len(spanning) == DIMENSIONS or steepness < STEEPEST:
        return None
    return _End(next_turning, slider, steepness)


def _about(axes: Sequence[Axis], i: int, last: int, policy: Policy) -> list[tuple[Shape, float]]:
    """About the run of parallel prismatic joints that begins with axis i."""
    after = i + 1
    while after < last and axes[after].prismatic and _parallel(axes[after], axes[i]):
        after += 1
    sine, other = (norm(cross(axes[k].direction, axes[i].direction)) for k in (i - 1, after))
    if other < STEEPEST:
        return []
    slack = SLACK * policy.tolerance.angle / (sine * other) + FLOOR
    return [(Shape(Measure.TURN, (i - 1, i, after)), slack)]


def _parallel(one: Axis, other: Axis) -> bool:
    return norm(cross(one.direction, other.direction)) < PARALLEL
