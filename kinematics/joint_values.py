"""Joint values as callers give them: one configuration, or a batch of them."""

from math import isfinite

import numpy as np
from numpy import ndarray
from numpy.typing import ArrayLike

from kinematics.errors import Fault, JointValueError
from kinematics.se3 import Floats

MOST_FAULTS = 16  # Places that are named; a batch of NaN has a hundred thousand of them.

_FLOAT64 = np.dtype(np.float64)
_FLOAT = frozenset({float})


def configurations(joints: ArrayLike, n_joints: int) -> list[float] | Floats:
    """Return one configuration as a list of n finite floats, or many as an (m, n) array of them.

    One-dimensional arrays and lists of floats, the usual arguments, are read first, at a fifth of the cost of
    others: reading them takes a tenth of the time of a pose.

    Raises:
        JointValueError: not n numbers, or rows of n numbers; or one of them NaN or infinite, at ("joints", j)
            or ("joints", i, j).
    """
    values: list[float] | None = None
    if isinstance(joints, ndarray):
        if joints.dtype is _FLOAT64 and joints.ndim == 1:
            values = joints.tolist()
    elif isinstance(joints, list) and _FLOAT.issuperset(map(type, joints)):
        values = joints.copy()
    if values is not None and len(values) == n_joints and isfinite(sum(values)):
        return values
    array = _floats(joints)
    if array.shape[-1] != n_joints:
        raise wrong_length(n_joints, array.shape[-1])
    _refuse_non_finite(array)
    return array if array.ndim == 2 else [float(value) for value in array]


def one_configuration(joints: ArrayLike, n_joints: int) -> list[float]:
    """Return q_1 … q_n as finite floats.

    Raises:
        JointValueError: not n_joints numbers, or one of them NaN or infinite, at ("joints", j).
    """
    values = configurations(joints, n_joints)
    if isinstance(values, list):
        return values
    raise _malformed()


def many_configurations(joints: ArrayLike, n_joints: int) -> Floats:
    """Return (m, n) configurations as finite floats.

    Raises:
        JointValueError: not rows of n_joints numbers, or one of them NaN or infinite, at ("joints", i, j).
    """
    array = _floats(joints)
    values = np.empty((0, n_joints)) if array.shape == (0,) else configurations(array, n_joints)
    if isinstance(values, list):
        raise _malformed()
    return values


def _floats(joints: ArrayLike) -> Floats:
    """The values as an array with one or two axes."""
    try:
        array = np.asarray(joints)
    except ValueError:
        raise _malformed() from None
    if array.ndim not in (1, 2) or (array.dtype.kind not in "fiu" and array.size):
        raise _malformed()
    return array.astype(np.float64, copy=False)


def _refuse_non_finite(array: Floats) -> None:
    """Point at what is NaN or infinite; a sum may overflow without any of it."""
    with np.errstate(over="ignore", invalid="ignore"):
        if isfinite(array.sum()):
            return
    faults = [
        Fault.at("joint_not_finite", "joints", *place, joint=place[-1] + 1)
        for place in np.argwhere(~np.isfinite(array))[:MOST_FAULTS].tolist()
    ]
    if faults:
        raise JointValueError(faults)


def wrong_length(expected: int, given: int) -> JointValueError:
    """Return the refusal of joint values that are not as many as there are joints."""
    return JointValueError(Fault.at("joints_wrong_length", "joints", expected=expected, given=given))


def _malformed() -> JointValueError:
    return JointValueError(Fault.at("joints_malformed", "joints"))
