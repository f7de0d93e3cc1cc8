"""A URDF chain to a DH table: its joint axes at zero, and frames assigned to them."""

from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np

from kinematics.angles import cos_sin
from kinematics.chain import Axis, Chain
from kinematics.frames.assignment import assign_frames
from kinematics.frames.axes import MAX_AXES, JointAxis
from kinematics.frames.parallels import NearParallel
from kinematics.se3 import (
    IDENTITY,
    Motion,
    Transform,
    Vector,
    compose,
    from_matrix,
    inverse,
    norm,
    position,
    rotate,
    rotation_about,
    scale,
    to_matrix,
    translation,
    unit,
)
from kinematics.table import Convention, JointType, NumericTable
from kinematics.urdf.document import Bounds, UrdfJoint, read_document, refused
from kinematics.urdf.serial import MOVING, ChainStep, serial_chain


@dataclass(frozen=True, kw_only=True, slots=True)
class UrdfChain:
    """A chain of a URDF description as its joint axes, in the coordinates of its base link.

    Attributes:
        name: the robot's name in the description.
        chain: the axes and the home pose of the tip link; the links of the description are carried along.
        joints: names of joint 1 … n.
        links: names of the links that these carry.
        limits: (lowest, highest) of joint 1 … n [rad, or m]; None where there is none.
        base_link: name of the first link.
        tip_link: name of the last link.
    """

    name: str
    chain: Chain
    joints: tuple[str, ...]
    links: tuple[str, ...]
    limits: tuple[Bounds | None, ...]
    base_link: str
    tip_link: str


@dataclass(frozen=True, kw_only=True, slots=True)
class UrdfRobot(UrdfChain):
    """A chain of a URDF description as a DH table, too: base · table · tool is its tip link in its base link.

    Attributes:
        table: the table [rad, m]; its joint variables are those of the description.
        base: (4, 4) pose of frame 0 in the base link.
        tool: (4, 4) pose of the tip link in frame N.
    """

    table: NumericTable
    base: Transform
    tool: Transform


def table_from_urdf(
    text: str, convention: Convention, *, base_link: str | None = None, tip_link: str | None = None
) -> UrdfRobot:
    """Return a DH table of one serial chain of a URDF description.

    Fixed joints go into the axes behind them. Axes that are parallel but for a tilt of 1e-10 to 5e-3 rad are
    joined by a fixed dummy row, so the table reproduces the chain for every q: to rounding,
    except that an angle within 1e-10 of a multiple of 15° becomes that multiple.

    Args:
        base_link: name of the first link; the root if left out.
        tip_link: name of the last link; may be left out if only one link carries no other.

    Raises:
        DescriptionError: the text cannot be read, or the chain is none that a DH table can hold.
    """
    described = chain_from_urdf(text, base_link=base_link, tip_link=tip_link)
    axes = [
        JointAxis(
            joint=JointType.PRISMATIC if axis.prismatic else JointType.REVOLUTE,
            direction=axis.direction,
            point=axis.point,
        )
        for axis in described.chain.axes
    ]
    assigned = assign_frames(
        axes,
        convention,
        base=np.eye(4),
        tool=to_matrix(described.chain.end),
        near_parallel=NearParallel.DUMMY_ROW,
    )
    known = {entry.name: getattr(described, entry.name) for entry in fields(described)}
    return UrdfRobot(**known, table=assigned.table, base=assigned.base, tool=assigned.tool)


def chain_from_urdf(text: str, *, base_link: str | None = None, tip_link: str | None = None) -> UrdfChain:
    """Return one serial chain of a URDF description.

    Args and raises as in `table_from_urdf`.
    """
    document = read_document(text)
    steps = serial_chain(document, base_link, tip_link)
    movements = [step for step in steps if step.moves]
    moving = [step.joint for step in movements]
    if len(moving) > MAX_AXES:
        raise refused("urdf_too_many_joints", count=len(moving), limit=MAX_AXES)
    first, last = steps[0], steps[-1]
    return UrdfChain(
        name=document.name,
        chain=_chain(steps),
        joints=tuple(joint.name for joint in moving),
        links=tuple(step.joint.parent if step.upwards else step.joint.child for step in movements),
        limits=tuple(joint.limits() for joint in moving),
        base_link=first.joint.child if first.upwards else first.joint.parent,
        tip_link=last.joint.parent if last.upwards else last.joint.child,
    )


def _chain(steps: Sequence[ChainStep]) -> Chain:
    """Return the axes of the moving joints and the pose of the tip, at zero, in the base link.

    Passed upwards, a joint is its inverse: it turns the other way, and its origin comes behind it.
    """
    here = IDENTITY
    axes: list[Axis] = []
    links = [(0, here)]
    extent = 0.0
    for joint, upwards, value in steps:
        origin = from_matrix(joint.origin())
        here = here if upwards else compose(here, origin)
        if joint.kind in MOVING:
            axis = unit(rotate(here, joint.axis()))
            if value is None:
                direction = scale(axis, -1.0) if upwards else axis
                axes.append(Axis(joint.kind == "prismatic", direction, position(here)))
            else:
                here = _standing(joint, here, axis, -value if upwards else value)
        here = compose(here, inverse(origin)) if upwards else here
        links.append((len(axes), here))
        extent += norm(position(origin))
    return Chain(tuple(axes), here, extent, tuple(links))


def _standing(joint: UrdfJoint, here: Motion, axis: Vector, by: float) -> Motion:
    """Return the pose behind a joint that stands still by so much about, or along, its axis [rad, or m]."""
    if joint.kind == "prismatic":
        return compose(translation(scale(axis, by)), here)
    return compose(rotation_about(position(here), axis, *cos_sin(by)), here)
