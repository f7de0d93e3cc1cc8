"""Joint values from the wire: in the request's units, one configuration or a batch, within the limits."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import islice
from typing import Any

import numpy as np

from kinematics.errors import Fault, JointValueError
from kinematics.inverse.lengths import is_long, too_long
from kinematics.joint_values import many_configurations, one_configuration
from kinematics.se3 import Floats
from service.http.problems import BodySizeError, RequestError, moved
from service.wire.kinematics.prepared_robots import PreparedRobot

_NUMBERS = {float, int}
PIECE = 2048
"""Configurations that are validated, or laid out, at a time: no other thread runs until they are."""
MOST_FAULTS = 100
"""Of more configurations than this nobody wants to be told singly that their length is wrong."""


def plain_configuration(joints: Any, robot: PreparedRobot) -> list[float] | None:
    """Return a configuration in [rad] and length units, if the value is a list of just so many numbers."""
    units = robot.joint_units
    if type(joints) is list and len(joints) == len(units) and _NUMBERS.issuperset(map(type, joints)):
        return [value * unit for value, unit in zip(joints, units, strict=True)]
    return None


def read_joints(joints: list[Any], robot: PreparedRobot, batch_limit: int) -> list[float] | Floats:
    """Return validated joint values in [rad] and length units.

    Raises:
        JointValueError: a configuration of the wrong length, at its place.
        BodySizeError: more configurations than the limit.
    """
    if not joints or not isinstance(joints[0], list):
        _refuse_lengths([(len(joints), ("joints",))], robot)
        return [value * unit for value, unit in zip(joints, robot.joint_units, strict=True)]
    refuse_large_batch(len(joints), batch_limit)
    _refuse_lengths(((len(one), ("joints", i)) for i, one in enumerate(joints)), robot)
    batch: Floats = np.empty((len(joints), len(robot.joint_units)))
    for start in range(0, len(joints), PIECE):
        batch[start : start + PIECE] = joints[start : start + PIECE]
    batch *= np.array(robot.joint_units)
    return batch


def values_in_radians(given: Sequence[float], units: Sequence[float], field: str) -> list[float]:
    """Return one value for each joint in [rad] and the table's length unit; faults stand at the field.

    Raises:
        JointValueError: not one finite number for each joint, or one too large to be computed with.
    """
    with moved(lambda fault: replace(fault, where=(field, *fault.where[1:]))):
        values = one_configuration(list(given), len(units))
    far = [too_long((field, i)) for i, value in enumerate(values) if is_long(value)]
    if far:
        raise JointValueError(far)
    return [value * unit for value, unit in zip(values, units, strict=True)]


def in_request_units(joints: Sequence[float], units: Sequence[float]) -> list[float]:
    """Return joint values in the units of the request; no value is -0.0."""
    return [value / unit + 0.0 for value, unit in zip(joints, units, strict=True)]


def read_array(array: Floats, robot: PreparedRobot, batch_limit: int) -> list[float] | Floats:
    """Return an array of joint values in [rad] and length units; one dimension is one configuration.

    Raises:
        JointValueError: configurations of the wrong length, or a value that is NaN or infinite.
        RequestError: neither one nor two dimensions.
        BodySizeError: more configurations than the limit.
    """
    if array.ndim not in (1, 2):
        raise RequestError(Fault.at("joints_wrong_dimensions", "joints", dimensions=array.ndim))
    _refuse_lengths([(array.shape[-1], ("joints",))], robot)
    if array.ndim == 1:
        return [value * unit for value, unit in zip(array.tolist(), robot.joint_units, strict=True)]
    refuse_large_batch(len(array), batch_limit)
    many_configurations(array, len(robot.joint_units))
    return array if set(robot.joint_units) <= {1.0} else array * np.array(robot.joint_units)


def refuse_large_batch(given: int, limit: int) -> None:
    """Make sure that a batch has no more configurations than are computed in one request.

    Raises:
        BodySizeError: it has.
    """
    if given > limit:
        raise BodySizeError(Fault.at("batch_too_large", "joints", given=given, limit=limit))


def _refuse_lengths(found: Iterable[tuple[int, tuple[str | int, ...]]], robot: PreparedRobot) -> None:
    expected = len(robot.joint_units)
    wrong = ((given, where) for given, where in found if given != expected)
    faults = [
        Fault.at("joints_wrong_length", *where, expected=expected, given=given)
        for given, where in islice(wrong, MOST_FAULTS)
    ]
    if faults:
        raise JointValueError(faults)
