"""The ranges of the joints, and configurations spread evenly over them."""

from __future__ import annotations

import math

import numpy as np

from kinematics.errors import Fault, JointValueError
from kinematics.inverse.limits import JointLimits, read_limits
from kinematics.table import JointType, NumericTable
from kinematics.workspace.goals import Array

TURN = 2.0 * math.pi


def joint_spans(table: NumericTable, limits: JointLimits | None) -> Array:
    """(n, 2) lowest and highest value of every joint; a full turn where a revolute joint has no limits.

    Raises:
        JointValueError: limits of the wrong number or reversed, or a sliding joint without both of them, at
            ("limits", i).
    """
    box = read_limits(limits, table.n_joints)
    spans = np.column_stack((box.low, box.high))
    faults = []
    for i, joint in enumerate(table.joint_types):
        low, high = spans[i].tolist()
        if joint is JointType.REVOLUTE:
            spans[i] = _turn(low, high)
        elif not (math.isfinite(low) and math.isfinite(high)):
            faults.append(
                Fault(
                    code="slide_without_limits",
                    where=("limits", i),
                    message=f"joint {i + 1} slides: without a least and a greatest value it has no end",
                    params={"joint": i + 1},
                )
            )
    if faults:
        raise JointValueError(faults)
    return spans


def _turn(low: float, high: float) -> tuple[float, float]:
    """The range, or one full turn of it."""
    if high - low < TURN:
        return low, high
    if math.isinf(low):
        low = -math.pi if math.isinf(high) else high - TURN
    return low, low + TURN


def spread(spans: Array, count: int) -> Array:
    """(count, n) configurations that fill the ranges evenly, always the same ones.

    Source: M. Roberts, The unreasonable effectiveness of quasirandom sequences (2018): the additive sequence
    of the generalised golden ratio.
    """
    n = len(spans)
    ratio = 1.5
    for _ in range(64):
        ratio = (1.0 + ratio) ** (1.0 / (n + 1))
    steps = ratio ** -np.arange(1.0, n + 1)
    part = (0.5 + np.arange(1, count + 1)[:, None] * steps) % 1.0
    return np.asarray(spans[:, 0] + part * (spans[:, 1] - spans[:, 0]))
