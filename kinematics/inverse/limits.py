"""Joint limits: what they are, and which turn of a joint lies within them."""

import math
from collections.abc import Sequence
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from kinematics.errors import Fault, JointValueError, ParamValue
from kinematics.inverse.arm import Array
from kinematics.inverse.lengths import is_long, too_long
from kinematics.inverse.search import Box, unbounded

JointLimits: TypeAlias = Sequence[tuple[float | None, float | None] | None]
"""For each joint (least, greatest) [rad, or m]; None where there is no limit."""

ON_LIMIT = 1e-9  # A value beyond its limit by no more than this [rad, or m per unit of size] is put on it.


FARTHEST_TURN = 1e4
"""Angles beyond this [rad] are no joint values: so many turns, and a double no longer tells angles apart."""


def read_limits(limits: JointLimits | None, revolute: Sequence[bool]) -> Box:
    """Return the limits as arrays, infinite where there are none.

    Args:
        limits: (least, greatest) of each joint.
        revolute: which joints turn.

    Raises:
        JointValueError: not one entry per joint, at ("limits",); a bound that is NaN, least above greatest,
            angles that are all beyond `FARTHEST_TURN`, or a slide beyond `LARGEST_LENGTH`, at ("limits", i).
    """
    n_joints = len(revolute)
    if limits is None:
        return unbounded(n_joints)
    if len(limits) != n_joints:
        raise JointValueError(Fault.at("limits_wrong_length", "limits", expected=n_joints, given=len(limits)))
    low, high = np.empty(n_joints), np.empty(n_joints)
    faults = []
    for i, pair in enumerate(limits):
        least, greatest = (None, None) if pair is None else pair
        low[i] = -math.inf if least is None else least
        high[i] = math.inf if greatest is None else greatest
        fault = _fault(i, float(low[i]), float(high[i]), revolute[i])
        if fault is not None:
            faults.append(fault)
    if faults:
        raise JointValueError(faults)
    return Box(low, high)


def _fault(i: int, low: float, high: float, turns: bool) -> Fault | None:
    """What is wrong with the range of joint i + 1."""
    where = ("limits", i)
    params: dict[str, ParamValue] = {"joint": i + 1}
    if not low <= high or low == math.inf or high == -math.inf:
        return Fault.at("limits_reversed", *where, **params)
    if turns and (low > FARTHEST_TURN or high < -FARTHEST_TURN):
        params["limit"] = FARTHEST_TURN
        return Fault.at("limits_too_far", *where, **params)
    if not turns and any(math.isfinite(end) and is_long(end) for end in (low, high)):
        return too_long(where)
    return None


def within_limits(
    q: Array, revolute: NDArray[np.bool_], box: Box, size: float
) -> tuple[Array, NDArray[np.bool_]]:
    """Return the joint variables moved into their ranges by turns of 2π, and which configurations fit.

    Of several turns within the range the one nearest to 0 is taken, so that without limits q is in (-π, π].

    Args:
        q: (m, n).
        revolute: (n,) which joints turn.
        box: the limits.
        size: unit of length for what counts as on a limit [m].

    Returns:
        (m, n) and (m,).
    """
    if not box.limited and revolute.all():
        turned = (q > np.pi) | (q <= -np.pi)
        if turned.any():
            q = np.where(turned, q - 2.0 * np.pi * np.ceil((q - np.pi) / (2.0 * np.pi)), q)
        return q, np.ones(len(q), dtype=bool)
    slack = np.where(revolute, ON_LIMIT, ON_LIMIT * size)
    near_zero = q - 2.0 * np.pi * np.ceil((q - np.pi) / (2.0 * np.pi))
    least = np.ceil((box.low - slack - near_zero) / (2.0 * np.pi))
    greatest = np.floor((box.high + slack - near_zero) / (2.0 * np.pi))
    turns = np.clip(0.0, least, greatest)
    wrapped = np.where(revolute, near_zero + 2.0 * np.pi * np.where(np.isfinite(turns), turns, 0.0), q)
    fits = ((wrapped >= box.low - slack) & (wrapped <= box.high + slack)).all(axis=1)
    return np.clip(wrapped, box.low, box.high), np.asarray(fits)
