"""Which way the axes of a chain point: so that as little as possible is wrong, but for what a policy fixes.

Every axis may point either way, and with it the signs of twists, lengths and offsets change together. Since a
fact concerns one axis or two neighbours, the best choice is found exactly, joint by joint.
"""

from functools import lru_cache
from itertools import product

import numpy as np
from numpy.typing import NDArray

from kinematics.caching import USUAL_ROWS, cached_by_size
from kinematics.equivalence import BaseRule, Policy, ToolRule
from kinematics.equivalence.measures import Measure, Shape
from kinematics.se3 import Floats

STRETCH = 5
"""So many links are looked at together, the axes turned in all 64 ways: all that an arm of six joints has."""
_WAYS = np.array(list(product((0.0, 1.0), repeat=STRETCH + 1)))


def fixed_ends(axes: int, policy: Policy) -> tuple[int, ...]:
    """Return those of the two end axes, of so many between base and tool, that may not be turned round."""
    fixed = policy.base is BaseRule.FRAME, policy.tool is ToolRule.FRAME
    return tuple(i for i, end in zip((0, axes - 1), fixed, strict=True) if end)


@lru_cache(maxsize=256)
def fixed_signs(shapes: tuple[Shape, ...], fixed: tuple[int, ...]) -> list[int]:
    """Return the places of the invariants that depend only on directions of axes that may not be turned."""
    return [
        q
        for q, shape in enumerate(shapes)
        if set(shape.axes[1:2] if shape.measure is Measure.OFFSET else shape.axes[:2]) <= set(fixed)
    ]


def least_cost(shapes: tuple[Shape, ...], axes: int, costs: Floats, fixed: tuple[int, ...] = ()) -> Floats:
    """Return the least cost of invariants over the directions of all axes: a sweep along the chain.

    Args:
        shapes: the invariants.
        axes: how many axes there are, base and tool among them.
        costs: (2, q, k) what each costs with the axes as they point, and with one of them turned round.
        fixed: the axes that may not be turned round, by their numbers.

    Returns:
        (k,) the sums.
    """
    stretches, free, held = _stretches(shapes, axes, fixed)
    flat = costs.reshape(-1, costs.shape[2])
    best = np.zeros((2, flat.shape[1]))
    for ways, places in stretches:
        sums = (ways @ flat.take(places, axis=0)).reshape(2, -1, 2, flat.shape[1])
        best = (best[:, None] + sums.min(axis=1)).min(axis=0)
    least = best.min(axis=0)
    if free or held:
        least += costs[:, free].min(axis=0).sum(axis=0) + costs[0, held].sum(axis=0)
    return np.asarray(least, dtype=np.float64)


@cached_by_size(lambda shapes, axes, fixed: axes, longest=USUAL_ROWS, most=256, few=32)
def _stretches(
    shapes: tuple[Shape, ...], axes: int, fixed: tuple[int, ...]
) -> tuple[list[tuple[Floats, NDArray[np.intp]]], list[int], list[int]]:
    """The chain in stretches of axes, each from the last one of the stretch before; and what is in none.

    Returns:
        Of every stretch (ways, costs), one where a cost counts with its axes turned so, else zero, and the
        places of these costs among all, those as the axes point first; the places of the invariants that no
        direction changes, or one that is free; and of those between axes that may not be turned round.
    """
    ends: dict[int, tuple[int, ...]] = {}
    free: list[int] = []
    held: list[int] = []
    for q, shape in enumerate(shapes):
        i, j = shape.axes[:2]
        if shape.measure is Measure.OFFSET:
            ends[q] = (j,)
        elif shape.measure is not Measure.TURN and j == i + 1:
            ends[q] = (i, j)
        else:
            (held if {i, j} <= set(fixed) else free).append(q)
    first = min((pair[0] for pair in ends.values()), default=0)
    last = max((pair[-1] for pair in ends.values()), default=0)
    stretches = []
    for start in range(first, max(last, first + 1), STRETCH):
        turns = np.array([0.0 if start + k in fixed else 1.0 for k in range(STRETCH + 1)])
        own = {
            q: (_WAYS * turns)[:, [axis - start for axis in axes_of]].sum(axis=1) % 2.0
            for q, axes_of in ends.items()
            if start <= axes_of[0] and max(axes_of[-1], first + 1) in range(start + 1, start + STRETCH + 1)
        }
        turned = np.array(list(own.values())).reshape(len(own), len(_WAYS)).T
        places = np.array(list(own), dtype=np.intp)
        stretches.append((np.hstack((1.0 - turned, turned)), np.hstack((places, places + len(shapes)))))
    return stretches, free, held
