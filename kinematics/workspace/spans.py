"""The ranges of the joints, and configurations spread evenly over them."""

import numpy as np

from kinematics.errors import Fault, JointValueError
from kinematics.inverse.arm import low_discrepancy
from kinematics.inverse.limits import JointLimits, read_limits
from kinematics.inverse.search import one_turn
from kinematics.se3 import Floats
from kinematics.table import JointType, NumericTable


def joint_spans(table: NumericTable, limits: JointLimits | None) -> Floats:
    """Return (n, 2) lowest and highest value of every joint; of a revolute joint one turn at most.

    Raises:
        JointValueError: limits of the wrong number, reversed or too far from zero, or a prismatic joint
            without both of them, at ("limits", i).
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
            faults.append(Fault.at("slide_without_limits", "limits", i, joint=i + 1))
    if faults:
        raise JointValueError(faults)
    return spans


def spread(spans: Floats, count: int) -> Floats:
    """Return (count, n) low-discrepancy configurations within the ranges, always the same ones."""
    return np.asarray(spans[:, 0] + low_discrepancy(count, len(spans)) * (spans[:, 1] - spans[:, 0]))
