"""The ranges of the joints, and configurations spread evenly over them."""

from __future__ import annotations

import numpy as np

from kinematics.errors import Fault, JointValueError
from kinematics.inverse.limits import JointLimits, read_limits
from kinematics.inverse.search import one_turn
from kinematics.table import JointType, NumericTable
from kinematics.workspace.goals import Array


def joint_spans(table: NumericTable, limits: JointLimits | None) -> Array:
    """(n, 2) lowest and highest value of every joint; of a revolute joint one turn at most.

    Raises:
        JointValueError: limits of the wrong number, reversed or too far from zero, or a sliding joint without
            both of them, at ("limits", i).
    """
    revolute = [joint is JointType.REVOLUTE for joint in table.joint_types]
    box = read_limits(limits, revolute)
    spans = np.column_stack(one_turn(box.low, box.high))
    faults = []
    for i, turns in enumerate(revolute):
        if turns:
            continue
        spans[i] = box.low[i], box.high[i]
        if not np.isfinite(spans[i]).all():
            faults.append(
                Fault(
                    code="slide_without_limits",
                    where=("limits", i),
                    params={"joint": i + 1},
                )
            )
    if faults:
        raise JointValueError(faults)
    return spans


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
