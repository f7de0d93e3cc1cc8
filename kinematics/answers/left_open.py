"""By how much decimals may move an entry: what was rounded is known no better than it was typed."""

from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np

from kinematics.expressions import Expression
from kinematics.expressions.arrays import values_at
from kinematics.expressions.values import holds_decimals
from kinematics.se3 import Floats

Rounded: TypeAlias = Mapping[Expression, tuple[Expression, ...]]
"""Of entries with names and decimals, what each is with one of its decimals moved by half a unit of its last
place: no such entry is off by more."""
TOGETHER = 1.01  # Times what decimals do one by one is at most what they do together, in products of them.
EXACT = 1e-9  # A share of an entry's size: what the arithmetic leaves where nothing was rounded.


def left_open(entry: Expression, rounded: Rounded, parameters: Mapping[str, Any], joints: Floats) -> Floats:
    """Return by how much rounding may move an entry, (k,); infinite where it is not known.

    Args:
        rounded: what it is with its decimals moved.
        parameters: values of the names, (k,) each.
        joints: (n, k) configurations.
    """
    if not holds_decimals(entry):
        return np.zeros(joints.shape[1])
    if entry not in rounded:
        return np.full(joints.shape[1], np.inf)
    return moved_by(entry, rounded[entry], parameters, joints)


def moved_by(
    entry: Expression, near: Sequence[Expression], parameters: Mapping[str, Any], joints: Floats
) -> Floats:
    """Return by how much an entry differs at most from what it is with its decimals moved, (k,)."""
    here = values_at(entry, parameters, joints)
    off = np.zeros(joints.shape[1])
    for moved in near:
        off = off + np.abs(values_at(moved, parameters, joints) - here)
    return TOGETHER * off
