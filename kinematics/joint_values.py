"""Joint values as callers give them: one configuration, or a batch of them."""

from __future__ import annotations

import math
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from kinematics.errors import Fault, JointValueError

Floats: TypeAlias = NDArray[np.float64]

_FLOAT64 = np.dtype(np.float64)
_FLOAT = frozenset({float})


def configurations(joints: ArrayLike, n_joints: int) -> list[float] | Floats:
    """One configuration as a list of n finite floats, or many as an (m, n) array of them.

    Raises:
        JointValueError: as of `one_configuration` and `many_configurations`.
    """
    values = _at_once(joints)
    if values is not None and len(values) == n_joints and math.isfinite(sum(values)):
        return values
    array = _floats(joints)
    return many_configurations(array, n_joints) if array.ndim > 1 else one_configuration(array, n_joints)


def one_configuration(joints: ArrayLike, n_joints: int) -> list[float]:
    """q_1 … q_n as finite floats.

    Raises:
        JointValueError: not n_joints numbers, or one of them NaN or infinite, at ("joints", i).
    """
    values = _at_once(joints)
    if values is not None and len(values) == n_joints and math.isfinite(sum(values)):
        return values
    array = _floats(joints)
    if array.shape != (n_joints,):
        raise _wrong_shape(array.shape, n_joints)
    _refuse_non_finite(array)
    checked: list[float] = array.tolist()
    return checked


def many_configurations(joints: ArrayLike, n_joints: int) -> Floats:
    """(m, n) configurations as finite floats.

    Raises:
        JointValueError: not m rows of n_joints numbers, or one of them NaN or infinite, at ("joints", i, j).
    """
    array = _floats(joints)
    if array.ndim != 2 or array.shape[1] != n_joints:
        raise _wrong_shape(array.shape, n_joints)
    with np.errstate(over="ignore", invalid="ignore"):
        total = array.sum()
    if not math.isfinite(total):
        _refuse_non_finite(array)
    return array


def _at_once(joints: ArrayLike) -> list[float] | None:
    """The values of the two most usual kinds of argument, at a fifth of the general cost; else None."""
    if isinstance(joints, np.ndarray):
        return joints.tolist() if joints.dtype is _FLOAT64 and joints.ndim == 1 else None
    return joints.copy() if isinstance(joints, list) and _FLOAT.issuperset(map(type, joints)) else None


def _floats(joints: ArrayLike) -> Floats:
    try:
        array = np.asarray(joints)
    except ValueError:
        array = np.asarray(None)
    if array.dtype.kind not in "fiu" and array.size:
        message = "joint values are numbers: one configuration [q1, …, qn], or a list of equally long ones"
        raise JointValueError(Fault(code="joints_not_numbers", message=message, where=("joints",)))
    return array.astype(np.float64, copy=False)


def _refuse_non_finite(array: Floats) -> None:
    """Point at what is NaN or infinite; a sum may overflow without any of it."""
    faults = [
        Fault(
            code="joint_not_finite",
            message=f"joint value {place[-1] + 1} is not a finite number",
            where=("joints", *place),
            params={"joint": place[-1] + 1},
        )
        for place in np.argwhere(~np.isfinite(array))[:16].tolist()
    ]
    if faults:
        raise JointValueError(faults)


def _wrong_shape(shape: tuple[int, ...], n_joints: int) -> JointValueError:
    given = shape[-1] if shape else 1
    if len(shape) > 2:
        message = "joint values are one configuration [q1, …, qn] or a list of them"
        return JointValueError(Fault(code="joints_not_numbers", message=message, where=("joints",)))
    message = f"the table has {n_joints} joints, but {given} values were given for a configuration"
    return JointValueError(
        Fault(
            code="joints_wrong_length",
            message=message,
            where=("joints",),
            params={"expected": n_joints, "given": given},
        )
    )
