"""What lies between axes that are no neighbours, where an exercise says at which values the joints stand.

A rule that fixes the zeros of the variables fixes the whole configuration that the figure shows: beside what
no choice of frames changes, the angles and distances of all its axes, wherever the joints between them are,
and the lengths along parallel axes past the prismatic joints among them.
"""

from collections.abc import Sequence

import numpy as np

from kinematics.caching import USUAL_ROWS, cached_by_size
from kinematics.chain import Axis
from kinematics.equivalence.batches import axis_batch
from kinematics.equivalence.invariants import FLOOR, SLACK, STEEPEST, Invariants, axes_of, spanning_axes
from kinematics.equivalence.measures import PARALLEL, Measure, Shape, measured
from kinematics.equivalence.policy import BaseRule, Policy, ToolRule, ZeroRule
from kinematics.equivalence.reference import Reference
from kinematics.se3 import cross, norm

FARTHEST = 4  # Three parallel axes between two others: what lies before them shows behind them.
UPRIGHT = 1.0 - 1e-12  # A sine: at right angles, but for the errors of the arithmetic.


@cached_by_size(lambda reference, policy: len(reference.table.rows), longest=USUAL_ROWS, most=1024, few=32)
def home_invariants_of(reference: Reference, policy: Policy) -> Invariants:
    """Return the angles, distances and offsets between axes that are no neighbours, all variables zero.

    None where the policy leaves the zeros of the variables free. Their slacks are what the tolerance of the
    end frame allows.
    """
    axes = axes_of(reference.chain, policy)
    found: list[tuple[Shape, float]] = []
    if policy.zero is ZeroRule.FIGURE and axes:
        first = 0 if policy.base in (BaseRule.ORIGIN, BaseRule.FRAME) else 1
        last = len(axes) - (1 if policy.tool in (ToolRule.POINT, ToolRule.FRAME) else 2)
        for i in range(first, last - 1):
            for j in range(i + 2, min(i + FARTHEST, last) + 1):
                found += _between(axes, i, j, reference.size, policy)
        found += _past_sliders(axes, first, last, reference.size, policy)
    shapes = tuple(shape for shape, _ in found)
    slacks = np.array([slack for _, slack in found], dtype=np.float64)[:, None]
    return Invariants(shapes, measured(shapes, axis_batch([axes])) if shapes else np.empty((0, 1)), slacks)


def _between(axes: Sequence[Axis], i: int, j: int, size: float, policy: Policy) -> list[tuple[Shape, float]]:
    found = [(Shape(Measure.ANGLE, (i, j)), SLACK * policy.tolerance.angle + FLOOR)]
    spanning, steepness = spanning_axes(axes, (i, j))
    if steepness > STEEPEST and not (axes[i].prismatic or axes[j].prismatic):
        slack = (SLACK * policy.tolerance.length + FLOOR) * size / steepness
        found.append((Shape(Measure.DISTANCE, (i, j, *spanning)), slack))
    return found


def _past_sliders(
    axes: Sequence[Axis], first: int, last: int, size: float, policy: Policy
) -> list[tuple[Shape, float]]:
    """Along each run of parallel axes with a prismatic joint among them: the distance between its two ends.

    An end is the foot of the common normal with the next axis outside the run that is no prismatic joint; at
    an end of the chain, a point that the policy fixes. The line of a prismatic joint may be drawn anywhere:
    it has such a foot only where that axis is at right angles to it.
    """
    found: list[tuple[Shape, float]] = []
    i = first
    while i <= last:
        j = i
        while j < last and norm(cross(axes[i].direction, axes[j + 1].direction)) < PARALLEL:
            j += 1
        is_fixed = (i > first or first == 0) and (j < last or last == len(axes) - 1)
        before = i if i == first else _next_turning(axes, range(i - 1, first - 1, -1))
        after = j if j == last else _next_turning(axes, range(j + 1, last + 1))
        if is_fixed and before is not None and after is not None:
            slides = any(axis.prismatic for axis in axes[before : after + 1])
            sines = [
                norm(cross(axes[k].direction, axes[i].direction)) for k in (before, after) if not i <= k <= j
            ]
            flattest = min(sines, default=1.0)
            is_seen = all(
                not axes[end].prismatic or norm(cross(axes[k].direction, axes[i].direction)) > UPRIGHT
                for end, k in ((i, before), (j, after))
            )
            if slides and is_seen and flattest > STEEPEST:
                slack = (SLACK * policy.tolerance.length + FLOOR) * size / flattest
                found.append((Shape(Measure.OFFSET, (before, i, j, after)), slack))
        i = j + 1
    return found


def _next_turning(axes: Sequence[Axis], beyond: Sequence[int]) -> int | None:
    return next((k for k in beyond if not axes[k].prismatic), None)
