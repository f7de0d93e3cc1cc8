"""Which facts say how the axes on both sides of some prismatic joints lie to each other."""

from functools import lru_cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from exercises.grading.facts import Facts
from kinematics.equivalence.measures import Measure, Shape


@lru_cache(maxsize=32)
def across_prismatic(facts: Facts) -> tuple[NDArray[np.bool_], ...]:
    """Return (q,) for each group of prismatic joints: which facts relate the axes on both sides of it.

    Angles between neighbours are facts of their own.
    """
    turning = [i for i, axis in enumerate(facts.axes) if not axis.prismatic]
    return tuple(
        np.array([_is_across(shape, i, k) for shape in facts.invariants.shapes], dtype=np.bool_)
        for i, k in pairwise(turning)
        if k > i + 1
    )


def _is_across(shape: Shape, i: int, k: int) -> bool:
    first, last = min(shape.axes), max(shape.axes)
    if shape.measure is Measure.TURN:
        return i <= first and last <= k
    return shape.measure is not Measure.ANGLE and first <= i and k <= last
