"""A robot as every source describes it and every target takes it."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from kinematics.cells import ReadTable
from kinematics.inverse.limits import read_limits
from kinematics.se3 import Transform, check_transform
from kinematics.symbolic import Matrix
from kinematics.table import JointType
from kinematics.urdf import check_joint_names, check_link_names
from service.schemas.kinematics.robot_question import domain_limits
from service.wire.kinematics.prepared_robots import joint_units
from service.wire.kinematics.written_tables import Spellings, WireCell

Ranges: TypeAlias = Sequence[Sequence[float | None] | None]


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
        named: "base" and "tool" in expressions, those of the request that hold names.
        spellings: how a person wrote the constant entries.
        variable_cells: how a person wrote the cells with the joint variables, by joint number.
        name: the robot's name, if it has one.
        base_link, tip_link: the names of its first and its last link, if the source has any.
        joint_names: the names of joint 1 … n, if the source has any.
        link_names: the names of the links that these carry, if the source has any.
        limits: [lowest, highest] of joint 1 … n in the units of the table, if the source has any.
    """

    read: ReadTable
    parameters: Mapping[str, float] | None = None
    base: Transform = field(default_factory=_identity)
    tool: Transform = field(default_factory=_identity)
    named: Mapping[str, Matrix] = field(default_factory=dict)
    spellings: Spellings = field(default_factory=dict)
    variable_cells: Mapping[int, WireCell] = field(default_factory=dict)
    name: str | None = None
    base_link: str | None = None
    tip_link: str | None = None
    joint_names: tuple[str, ...] | None = None
    link_names: tuple[str, ...] | None = None
    limits: Ranges | None = None

    @property
    def joint_units(self) -> tuple[float, ...]:
        """For joint 1 … n what one unit of the table is in [rad], or in its length unit."""
        return joint_units(self.read.table.joint_types, self.angle)

    @property
    def angle(self) -> float:
        """What one unit of the table's angles is in [rad]."""
        return self.read.angle_unit.radians

    def between(self, base: ArrayLike | None, tool: ArrayLike | None) -> "RobotDescription":
        """Return the robot with a further base before it and a further tool behind it.

        Raises:
            PoseError: one of them is not a rigid transform.
        """
        before, behind = (
            np.eye(4) if pose is None else check_transform(pose, where=(name,))
            for pose, name in ((base, "base"), (tool, "tool"))
        )
        return replace(self, base=before @ self.base, tool=self.tool @ behind)

    def with_joints(
        self, names: Sequence[str] | None, links: Sequence[str] | None, limits: Ranges | None
    ) -> "RobotDescription":
        """Return the robot with these names and limits of its joints, or its own where they are left out.

        Raises:
            DescriptionError: names that do not fit, at ("joint_names",) or ("link_names",).
            JointValueError: limits of the wrong number, or reversed.
        """
        types = self.read.table.joint_types
        if names is not None:
            check_joint_names(names, len(types))
        if links is not None:
            check_link_names(links, len(types))
        if limits is not None:
            turns = [kind is JointType.REVOLUTE for kind in types]
            read_limits(domain_limits(limits, self.joint_units), turns)
        return replace(
            self,
            joint_names=self.joint_names if names is None else tuple(names),
            link_names=self.link_names if links is None else tuple(links),
            limits=self.limits if limits is None else limits,
        )

    @property
    def names_and_limits(self) -> dict[str, Any]:
        """The names, and the limits of the joints, as every answer that is not a URDF gives them."""
        limits = self.limits
        return {
            "name": self.name,
            "base_link": self.base_link,
            "tip_link": self.tip_link,
            "joint_names": None if self.joint_names is None else list(self.joint_names),
            "link_names": None if self.link_names is None else list(self.link_names),
            "limits": None if limits is None else [None if pair is None else list(pair) for pair in limits],
        }
