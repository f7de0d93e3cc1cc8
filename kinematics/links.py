"""The link transform: the two DH products, written once."""

from __future__ import annotations

import math
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from kinematics.table import Convention, JointType, NumericRow

Transform: TypeAlias = NDArray[np.float64]


def link_transform(row: NumericRow, convention: Convention, q: float = 0.0) -> Transform:
    """Pose of frame i in frame i-1, from one row of a DH table.

    standard:  Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha)
    modified:  Rot_x(alpha) Trans_x(a) Rot_z(theta) Trans_z(d)

    Args:
        row: theta joint angle [rad], d link offset [m], a link length [m], alpha link twist [rad];
            in a modified table a and alpha belong to link i-1.
        convention: which of the two products to form.
        q: the joint variable [rad], or [m] of a prismatic row; a fixed row ignores it.

    Returns:
        (4, 4) homogeneous transform, translation in [m].

    Source: seed 000 eq. 3.2 (modified); seed 003 eq. 2 (standard).
    """
    theta = row.theta + row.sign * q if row.joint is JointType.REVOLUTE else row.theta
    d = row.d + row.sign * q if row.joint is JointType.PRISMATIC else row.d
    a, ca, sa = row.a, math.cos(row.alpha), math.sin(row.alpha)
    ct, st = math.cos(theta), math.sin(theta)
    if convention is Convention.STANDARD:
        return np.array(
            [
                [ct, -st * ca, st * sa, a * ct],
                [st, ct * ca, -ct * sa, a * st],
                [0.0, sa, ca, d],
                [0.0, 0.0, 0.0, 1.0],
            ]
        )
    return np.array(
        [
            [ct, -st, 0.0, a],
            [st * ca, ct * ca, -sa, -sa * d],
            [st * sa, ct * sa, ca, ca * d],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )
