"""A robot as every source describes it and every target takes it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from kinematics.cells import ReadTable
from kinematics.se3 import Transform
from service.wire.written_tables import Spellings, WireCell


def _identity() -> Transform:
    return np.eye(4)


@dataclass(frozen=True, kw_only=True)
class RobotDescription:
    """A robot: base · table · tool.

    Attributes:
        read: the table, exact, with its units.
        parameters: values of the table's parameters, in its units; None if none were given.
        base: what stands before the table.
        tool: what stands behind it.
        spellings: how a person wrote the constant entries.
        variable_cells: how a person wrote the cells with the joint variables, by joint number.
        name: the robot's name, if it has one.
        joint_names: the names of joint 1 … n, if the source has any.
        limits: (lowest, highest) of joint 1 … n [rad, or the table's length unit], if the source has any.
    """

    read: ReadTable
    parameters: Mapping[str, float] | None = None
    base: Transform = field(default_factory=_identity)
    tool: Transform = field(default_factory=_identity)
    spellings: Spellings = field(default_factory=dict)
    variable_cells: Mapping[int, WireCell] = field(default_factory=dict)
    name: str | None = None
    joint_names: tuple[str, ...] | None = None
    limits: tuple[tuple[float, float] | None, ...] | None = None
