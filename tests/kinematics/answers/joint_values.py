"""⁰T_N by the product of DH matrices as the seeds print it, and the robots that oracles use."""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from kinematics import catalogue
from kinematics.table import Convention, JointType, NumericTable, bind

Floats = NDArray[np.float64]


def product(table: NumericTable, joints: Sequence[float]) -> Floats:
    """⁰T_N, link by link, by the matrices of the two conventions as they are printed."""
    values = iter(joints)
    pose = np.eye(4)
    for row in table.rows:
        theta, d = row.theta, row.d
        if row.joint is JointType.REVOLUTE:
            theta += row.sign * next(values)
        elif row.joint is JointType.PRISMATIC:
            d += row.sign * next(values)
        ct, st, ca, sa = math.cos(theta), math.sin(theta), math.cos(row.alpha), math.sin(row.alpha)
        if table.convention is Convention.STANDARD:
            link = [[ct, -st * ca, st * sa, row.a * ct], [st, ct * ca, -ct * sa, row.a * st], [0, sa, ca, d]]
        else:
            link = [[ct, -st, 0, row.a], [st * ca, ct * ca, -sa, -d * sa], [st * sa, ct * sa, ca, d * ca]]
        pose = pose @ np.array([*link, [0, 0, 0, 1]])
    return pose


def robot(name: str) -> NumericTable:
    """A robot of the catalogue with its usual values."""
    found = catalogue.robot(name)
    return bind(found.table.table, dict(found.parameters))
