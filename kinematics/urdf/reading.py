"""A URDF chain to a DH table: its joint axes at zero, and frames assigned to them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from kinematics.frames.assignment import assign_frames
from kinematics.frames.axes import MAX_AXES, JointAxis
from kinematics.frames.parallels import NearParallel
from kinematics.se3 import Transform
from kinematics.table import Convention, JointType, NumericTable
from kinematics.urdf.chain import MOVING, serial_chain
from kinematics.urdf.document import UrdfJoint, read_document, refused


@dataclass(frozen=True, kw_only=True, slots=True)
class UrdfRobot:
    """A chain of a URDF description as a DH table: base · table · tool is its tip link in its base link.

    Attributes:
        name: the robot's name in the description.
        table: the table [rad, m]; its joint variables are those of the description.
        base: (4, 4) pose of frame 0 in the base link.
        tool: (4, 4) pose of the tip link in frame N.
        joints: names of joint 1 … n.
        limits: (lowest, highest) of joint 1 … n [rad, or m]; None where there is none.
        base_link: name of the first link.
        tip_link: name of the last link.
    """

    name: str
    table: NumericTable
    base: Transform
    tool: Transform
    joints: tuple[str, ...]
    limits: tuple[tuple[float, float] | None, ...]
    base_link: str
    tip_link: str


def table_from_urdf(
    text: str, convention: Convention, *, base_link: str | None = None, tip_link: str | None = None
) -> UrdfRobot:
    """A DH table of one serial chain of a URDF description.

    Fixed joints go into the axes behind them. Axes that are parallel but for a tilt of 1e-10 to 5e-3 rad are
    joined by a fixed dummy row, so the table reproduces the chain for every q: to rounding, where angles are
    not within 1e-10 of a multiple of 15° without being it, and to 1e-10 where they are.

    Args:
        text: the description, XML.
        convention: which table to make.
        base_link: name of the first link; the root if left out.
        tip_link: name of the last link; may be left out if only one link carries no other.

    Raises:
        DescriptionError: the text cannot be read, or the chain is none that a DH table can hold.
    """
    document = read_document(text)
    chain = serial_chain(document, base_link, tip_link)
    moving = [joint for joint in chain if joint.kind in MOVING]
    if len(moving) > MAX_AXES:
        f"the chain has {len(moving)} moving joints; a table takes at most {MAX_AXES}"
        raise refused("urdf_too_many_joints", count=len(moving), limit=MAX_AXES)
    axes, home = _axes(chain)
    assigned = assign_frames(
        axes, convention, base=np.eye(4), tool=home, near_parallel=NearParallel.DUMMY_ROW
    )
    return UrdfRobot(
        name=document.name,
        table=assigned.table,
        base=assigned.base,
        tool=assigned.tool,
        joints=tuple(joint.name for joint in moving),
        limits=tuple(joint.limits() for joint in moving),
        base_link=chain[0].parent,
        tip_link=chain[-1].child,
    )


def _axes(chain: Sequence[UrdfJoint]) -> tuple[list[JointAxis], Transform]:
    """The axes of the moving joints and the pose of the tip, at zero, in the base link."""
    pose: Transform = np.eye(4)
    axes = []
    for joint in chain:
        pose = pose @ joint.origin()
        if joint.kind in MOVING:
            kind = JointType.PRISMATIC if joint.kind == "prismatic" else JointType.REVOLUTE
            direction = pose[:3, :3] @ np.array(joint.axis())
            axes.append(JointAxis(joint=kind, direction=direction.tolist(), point=pose[:3, 3].tolist()))
    return axes, pose
