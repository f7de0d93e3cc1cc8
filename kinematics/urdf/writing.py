"""A DH table to URDF.

A modified row is one joint: Rot_x(α) Trans_x(a) Rot_z(θ) Trans_z(d) is its origin, and it moves about or
along its own z, so its link is frame i. In a standard row the joint moves about z_{i-1} and what follows is
constant: that constant becomes the origin of the next joint, so the link of joint i moves with the arm but
stands where frame i-1 stood. A reversed variable is an axis 0 0 -1. A fixed row is a fixed joint.
"""

import html
import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kinematics.dh import around_joint
from kinematics.errors import DescriptionError, Fault
from kinematics.inverse.limits import JointLimits, read_limits
from kinematics.poses import rpy_from_transform
from kinematics.se3 import Transform, check_transform
from kinematics.table import JointType, NumericTable
from kinematics.urdf.document import MAX_NUMBER

BASE_LINK = "base_link"
TIP_LINK = "tool0"
UNLIMITED = 1e16
"""A limit that stands for none [rad, or m]: URDF knows no prismatic joint without two of them."""
STILL = 1e-12  # What the arithmetic leaves of frames that are one: entries of a pose.

_NOTE = "Kinematics alone: no masses, no shapes. Effort and velocity of every limit are placeholders."
_UNKNOWN = "A limit of 1e+16 stands for none."
_FIXED = re.compile(r"fixed_(base|tool|row_\d+)", re.ASCII)


@dataclass(frozen=True, kw_only=True, slots=True)
class WrittenUrdf:
    """A URDF description of a table.

    Attributes:
        text: the description, XML; lengths in [m].
        base_link: name of its first link.
        tip_link: name of its last link: the end frame, the tool included.
        assumed_limits: numbers, from 1, of joints of which a limit of ±1e16 stands for none.
    """

    text: str
    base_link: str
    tip_link: str
    assumed_limits: tuple[int, ...]


def urdf_from_table(
    table: NumericTable,
    *,
    name: str = "robot",
    base: ArrayLike | None = None,
    tool: ArrayLike | None = None,
    limits: JointLimits | None = None,
    joint_names: Sequence[str] | None = None,
    link_names: Sequence[str] | None = None,
    base_link: str = BASE_LINK,
    tip_link: str = TIP_LINK,
    metres_per_unit: float = 1.0,
) -> WrittenUrdf:
    """Return a URDF that has the pose base · A_1 ⋯ A_N · tool between its first and its last link.

    Args:
        base: (4, 4) pose of frame 0 in the first link; the identity if left out.
        tool: (4, 4) pose of the last link in frame N; the identity if left out.
        limits: (lowest, highest) of joint 1 … n [rad, or the table's length unit], None where there is none.
        joint_names: names of joint 1 … n; joint_1 … joint_n if left out.
        link_names: names of the links that joint 1 … n carry; link_1 … link_n if left out. The last of them
            may be `tip_link`, where the origin of the last link is on the axis of the last joint.
        tip_link: name of the last link. A link between them that would be called like one of the two, or
            like another one, has an underscore more in its name.
        metres_per_unit: length of the table's unit [m].

    Raises:
        DescriptionError: a name that is empty or holds control characters, at ("name",), ("base_link",),
            ("tip_link",), ("joint_names", i) or ("link_names", i); names of the wrong number, or one of them
            twice, at ("joint_names",) or ("link_names",); both ends of one name, at ("tip_link",); a length
            that no reader takes, at ("rows", i), ("base",) or ("tool",); or a limit that readers take for
            none, at ("limits", i).
        JointValueError: limits of the wrong number, or reversed.
        TableError: an entry of the table is NaN or infinite.
        PoseError: base or tool is not a rigid transform.
    """
    names = joint_names or [f"joint_{i}" for i in range(1, table.n_joints + 1)]
    for text, where in ((name, "name"), (base_link, "base_link"), (tip_link, "tip_link")):
        _check_name(text, (where,))
    if base_link == tip_link:
        raise DescriptionError(Fault.at("urdf_links_alike", "tip_link", link=tip_link))
    check_joint_names(names, table.n_joints)
    links = link_names or [f"link_{i}" for i in range(1, table.n_joints + 1)]
    check_link_names(links, table.n_joints)
    box = read_limits(limits, [joint is JointType.REVOLUTE for joint in table.joint_types])
    writer = _UrdfWriter(metres_per_unit, names, links, (base_link, tip_link))
    before = np.eye(4) if base is None else check_transform(base, where=("base",))
    if not np.array_equal(before, np.eye(4)):
        writer.fixed("base", before)
    _write_rows(writer, table, list(zip(box.low.tolist(), box.high.tolist(), strict=True)))
    end = np.eye(4) if tool is None else check_transform(tool, where=("tool",))
    if tool is not None and not np.array_equal(
        end, np.eye(4)
    ):  # what stands behind the last joint is its row's
        writer.where = ("tool",)
    writer.last(end)
    lines = [
        '<?xml version="1.0"?>',
        f'<robot name="{html.escape(name)}">',
        f"  <!-- {_NOTE} -->",
        *writer.written(),
        "</robot>",
        "",
    ]
    return WrittenUrdf(
        text="\n".join(lines), base_link=base_link, tip_link=tip_link, assumed_limits=tuple(writer.assumed)
    )


def _write_rows(writer: "_UrdfWriter", table: NumericTable, bounds: Sequence[tuple[float, float]]) -> None:
    numbers = {row: joint for joint, row in enumerate(table.joint_rows)}
    for i, row in enumerate(table.rows):
        writer.where = ("rows", i)
        before, behind = around_joint(row, table.convention)
        if row.joint is JointType.FIXED:
            writer.fixed(f"row_{i + 1}", before)
            continue
        writer.moving(numbers[i] + 1, row.joint, row.sign, before, bounds[numbers[i]])
        writer.behind = behind


class _Joint(NamedTuple):
    """A joint and the link that it carries; `pose` is in the link of the joint before."""

    name: str
    kind: str
    link: str
    pose: Transform
    details: Sequence[str]


class _UrdfWriter:
    """Collects joints, then writes them as XML.

    `behind` is the constant transform since the last joint, `where` the row being written, for faults.
    """

    def __init__(
        self, metres_per_unit: float, names: Sequence[str], links: Sequence[str], ends: tuple[str, str]
    ) -> None:
        self.where: tuple[str | int, ...] = ("base",)
        self.behind: Transform = np.eye(4)
        self.assumed: list[int] = []
        self._joints: list[_Joint] = []
        self._metres = metres_per_unit
        self._names, self._links = names, links
        self._base, self._tip = ends
        self._last_sign = 1
        self._taken = {*ends, *links}

    def fixed(self, name: str, pose: Transform) -> None:
        """Write a fixed joint and its link."""
        self._note(f"fixed_{name}", "fixed", self._free(name), pose, ())

    def last(self, pose: Transform) -> None:
        """Write the fixed joint to the last link, unless that link is the one of the last joint.

        It is where the last link's frame may be that of the joint: where its origin is on the axis.
        """
        joint = self._joints[-1] if self._joints else None
        end = self.behind @ pose
        within = joint and (joint.kind == "prismatic" or np.abs(end[:2, 3]).max() <= STILL)
        if joint and joint.kind != "fixed" and self._links[-1] == self._tip and within:
            self._joints.pop()
            self.behind = joint.pose
            if np.abs(end - np.eye(4)).max() > STILL:
                _, *details = joint.details
                joint = joint._replace(details=[_axis((self._last_sign * end[2, :3]).tolist()), *details])
                self.behind = joint.pose @ end
            self._note(joint.name, joint.kind, self._tip, np.eye(4), joint.details)
        else:
            self._note("fixed_tool", "fixed", self._tip, pose, ())

    def moving(
        self, number: int, joint: JointType, sign: int, pose: Transform, bounds: tuple[float, float]
    ) -> None:
        """Write a joint that moves about or along z of its frame."""
        self._last_sign = sign
        details = [_axis((0, 0, sign))]
        kind = joint.value
        unit = self._metres if joint is JointType.PRISMATIC else 1.0
        known = [bound * unit for bound in bounds if np.isfinite(bound)]
        if any(abs(bound) > MAX_NUMBER for bound in known):
            raise DescriptionError(Fault.at("urdf_limit_overflow", "limits", number - 1, limit=MAX_NUMBER))
        if not known and joint is JointType.REVOLUTE:
            kind = "continuous"
        else:
            if len(known) < 2:
                details.append(f"<!-- {_UNKNOWN} -->")
                self.assumed.append(number)
            low, high = (
                _text(bound * unit) if np.isfinite(bound) else f"{math.copysign(UNLIMITED, bound):g}"
                for bound in bounds
            )
            details.append(f'<limit lower="{low}" upper="{high}" effort="1" velocity="1"/>')
        link = self._links[number - 1]
        link = self._free(link) if link in (self._base, self._tip) else link
        self._note(self._names[number - 1], kind, link, pose, details)

    def written(self) -> list[str]:
        """Return the lines of all links and joints."""
        lines = [f'  <link name="{html.escape(self._base)}"/>']
        for parent, joint in zip(
            (self._base, *(joint.link for joint in self._joints)), self._joints, strict=False
        ):
            rpy = rpy_from_transform(joint.pose)
            xyz = [value * self._metres for value in joint.pose[:3, 3].tolist()]
            lines += [
                f'  <link name="{html.escape(joint.link)}"/>',
                f'  <joint name="{html.escape(joint.name)}" type="{joint.kind}">',
                f'    <parent link="{html.escape(parent)}"/>',
                f'    <child link="{html.escape(joint.link)}"/>',
                f'    <origin xyz="{" ".join(map(_text, xyz))}" rpy="{" ".join(map(_text, rpy))}"/>',
                *(f"    {detail}" for detail in joint.details),
                "  </joint>",
            ]
        return lines

    def _free(self, link: str) -> str:
        """The name of a link made to differ from those of all others."""
        while link in self._taken:
            link += "_"
        self._taken.add(link)
        return link

    def _note(self, name: str, kind: str, link: str, pose: Transform, details: Sequence[str]) -> None:
        origin = self.behind @ pose
        self.behind = np.eye(4)
        self._check([value * self._metres for value in origin[:3, 3].tolist()], self.where)
        self._joints.append(_Joint(name, kind, link, origin, details))

    def _check(self, lengths: Sequence[float], where: tuple[str | int, ...]) -> None:
        """Make sure that a reader takes these lengths [m]."""
        if not all(abs(length) <= MAX_NUMBER for length in lengths):
            limits = {"limit": MAX_NUMBER / self._metres, "limit_in_metres": MAX_NUMBER}
            raise DescriptionError(Fault.at("urdf_length_overflow", *where, **limits))


def check_joint_names(names: Sequence[str], count: int) -> None:
    """Make sure that there is a name for each joint, none of them twice and none that of a fixed joint.

    Raises:
        DescriptionError: names that do not fit, at ("joint_names",) or ("joint_names", i).
    """
    fixed = [name for name in names if _FIXED.fullmatch(name)]
    if len(names) != count or len(set(names)) != count or fixed:
        raise DescriptionError(Fault.at("urdf_joint_names", "joint_names", expected=count, given=len(names)))
    for i, name in enumerate(names):
        _check_name(name, ("joint_names", i))


def check_link_names(names: Sequence[str], count: int) -> None:
    """Make sure that there is a name for the link of each joint, and none of them twice.

    Raises:
        DescriptionError: names that do not fit, at ("link_names",) or ("link_names", i).
    """
    if len(names) != count or len(set(names)) != count:
        raise DescriptionError(Fault.at("urdf_link_names", "link_names", expected=count, given=len(names)))
    for i, name in enumerate(names):
        _check_name(name, ("link_names", i))


def _check_name(name: str, where: tuple[str | int, ...]) -> None:
    if not name.strip() or not name.isprintable():
        raise DescriptionError(Fault.at("urdf_name_invalid", *where))


def _axis(direction: Sequence[float]) -> str:
    return f'<axis xyz="{" ".join(map(_text, direction))}"/>'


def _text(value: float) -> str:
    """The shortest decimal that is this number."""
    return repr(value + 0.0).removesuffix(".0")
