"""Random configurations of a chain: the toolbox's QRAND."""

import math
import sys
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from kinematics.errors import Fault, JointValueError
from kinematics.expressions import evaluate, parameters_in
from kinematics.scm.chain import Entry, ScmChain
from kinematics.table import JointType

Limit = tuple[float, float]


def default_limits(chain: ScmChain, parameters: Mapping[str, float]) -> tuple[Limit, ...]:
    """Return a full turn, -π to π, for revolute joints.

    For prismatic ones 0 to the sum of the chain's lengths.

    The document states no strokes: the sum of all lengths (1 if there are none) keeps a prismatic joint in
    proportion.
    """
    total = 0.0
    for placement in (*(row.constant for row in chain.rows), chain.final, chain.tool):
        for entry in (Entry.X, Entry.Y, Entry.Z):
            length = placement.entry(entry)
            if parameters_in(length) <= parameters.keys():
                total += abs(evaluate(length, parameters))
    turn, stroke = (-math.pi, math.pi), (0.0, min(total, sys.float_info.max) or 1.0)
    return tuple(turn if row.joint is JointType.REVOLUTE else stroke for row in chain.rows)


def random_configurations(
    limits: Sequence[Limit], count: int = 1, seed: int | None = None
) -> NDArray[np.float64]:
    """Return the joint values drawn evenly within limits.

    Args:
        limits: (low, high) of every joint [rad, or m of a prismatic joint].
        seed: the same seed gives the same values; None draws anew each time.

    Returns:
        (count, n).

    Raises:
        JointValueError: a limit is not finite, or the lower is above the upper, at ("limits", i).
    """
    faults = [
        Fault.at("scm_limits_reversed", "limits", i, joint=i + 1)
        for i, (low, high) in enumerate(limits)
        if not (math.isfinite(low) and math.isfinite(high) and low <= high)
    ]
    if faults:
        raise JointValueError(faults)
    low, high = np.array(limits, dtype=np.float64).reshape(-1, 2).T
    part = np.random.default_rng(seed).random((count, len(limits)))
    with np.errstate(over="ignore", invalid="ignore"):
        width = high - low
        drawn = low + width * part
    return np.where(np.isfinite(width), drawn, low * (1.0 - part) + high * part)
