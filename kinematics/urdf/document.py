"""XML text to the links and joints of a URDF description.

The text comes from strangers: entities, document types and external files are refused by the parser
(defusedxml), and length, nesting and the number of elements are bounded. Only what decides about poses is
read; inertias, meshes, transmissions and the rest are passed over. A default namespace (`xmlns` of
<robot>, as Drake's descriptions have it) is that of the format: what is in it is read as if it had none.
"""

import math
import re
from dataclasses import dataclass
from typing import Any, NamedTuple, TypeAlias
from xml.etree.ElementTree import Element, ParseError, TreeBuilder

import numpy as np
from defusedxml import DefusedXmlException
from defusedxml.ElementTree import DefusedXMLParser

from kinematics.errors import DescriptionError, Fault, ParamValue
from kinematics.poses import transform_from_quaternion, transform_from_rpy
from kinematics.se3 import Transform

MAX_CHARACTERS = 1_000_000
MAX_DEPTH = 64
MAX_ELEMENTS = 50_000
"""Bounds far above what the published descriptions have, and far below what costs a second to read."""
MAX_NUMBER = 1e9
"""Lengths beyond this [m] are no robot's, and limits beyond it [rad, or m] are none: programs write ±1e16,
the largest double, or inf."""

_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
_INFINITE = re.compile(r"[+-]?inf(inity)?", re.IGNORECASE | re.ASCII)
_ORIGIN = (0.0, 0.0, 0.0)
_ATTRIBUTES = {
    "origin": ("xyz", "rpy", "quat_xyzw"),
    "axis": ("xyz",),
    "limit": ("lower", "upper", "effort", "velocity", "acceleration", "deceleration", "jerk"),
    "mimic": ("joint", "multiplier", "offset"),
}
"""What the format has in these elements of a joint: another attribute could be one of them, misspelled."""

Bounds: TypeAlias = tuple[float | None, float | None]
"""(lowest, highest) value of a joint [rad, or m]; None on a side without a limit."""

_ONCE = ("parent", "child", "origin", "axis", "limit", "mimic")
"""Elements of a joint of which two that differ contradict each other."""


class Mimic(NamedTuple):
    """How a joint follows another one: its value is multiplier · (the other's value) + offset."""

    joint: str
    multiplier: float
    offset: float


@dataclass(frozen=True, kw_only=True, slots=True)
class UrdfJoint:
    """A joint as it is written; its numbers are read when the joint turns out to matter."""

    name: str
    kind: str
    parent: str
    child: str
    element: Element

    def origin(self) -> Transform:
        """Return the (4, 4) pose of the joint's frame in its parent link [m]; the identity if left out.

        The orientation is `rpy`, or `quat_xyzw` (URDF 1.1 and later), of any length but zero.

        Raises:
            DescriptionError: not the numbers that belong there, two orientations, a quaternion that is zero,
                or an attribute that the format does not have.
        """
        origin = self._found("origin")
        if origin is None:
            return np.eye(4)
        xyz = self._numbers(origin, "origin", "xyz", _ORIGIN)
        if origin.get("quat_xyzw") is None:
            return transform_from_rpy(self._numbers(origin, "origin", "rpy", _ORIGIN), xyz)
        if origin.get("rpy") is not None:
            raise refused("urdf_two_orientations", joint=self.name)
        x, y, z, w = self._numbers(origin, "origin", "quat_xyzw", (0.0, 0.0, 0.0, 1.0))
        if not any((x, y, z, w)):
            raise refused("urdf_quaternion_zero", joint=self.name)
        return transform_from_quaternion((w, x, y, z), xyz)

    def axis(self) -> tuple[float, float, float]:
        """Return the direction of the joint's axis in its frame, of any length but zero; x if left out.

        Raises:
            DescriptionError: not three numbers, all of them zero, or an attribute that the format does not
                have.
        """
        axis = self._found("axis")
        x, y, z = (1.0, 0.0, 0.0) if axis is None else self._numbers(axis, "axis", "xyz", (1.0, 0.0, 0.0))
        if not any((x, y, z)):
            raise refused("urdf_axis_zero", joint=self.name)
        return x, y, z

    def limits(self) -> Bounds | None:
        """Return the lowest and highest value [rad, or m].

        A bound that is left out is 0, as the format has it; one beyond `MAX_NUMBER` is none.
        None of a continuous joint, or if there is no limit at all.

        Raises:
            DescriptionError: a bound is no number, the lower one lies above the upper one, or one is missing
                beside an attribute that the format does not have; programs add such to limits that have both.
        """
        limit = self.element.find("limit")
        if limit is None or self.kind == "continuous":
            return None
        if not {"lower", "upper"} <= limit.attrib.keys():
            self._found("limit")
        low, high = (self._bound(limit, name) for name in ("lower", "upper"))
        if low > high:
            raise refused("urdf_limits_reversed", joint=self.name)
        least, greatest = (None if abs(bound) > MAX_NUMBER else bound for bound in (low, high))
        return None if least is None and greatest is None else (least, greatest)

    def mimics(self) -> Mimic | None:
        """Return which joint this one follows, and how; None if it follows none.

        Raises:
            DescriptionError: the factor or the offset is no number, or there is an attribute that the format
                does not have.
        """
        mimic = self._found("mimic")
        if mimic is None:
            return None
        return Mimic(
            joint=_short(mimic.get("joint", "")),
            multiplier=self._numbers(mimic, "mimic", "multiplier", (1.0,))[0],
            offset=self._numbers(mimic, "mimic", "offset", (0.0,))[0],
        )

    def malformed(self, tag: str, name: str, count: int) -> DescriptionError:
        """Return the refusal of an attribute that has to hold so many numbers."""
        return refused(
            "urdf_numbers_malformed",
            joint=self.name, element=tag, attribute=name, count=count, limit=f"{MAX_NUMBER:g}"
        )  # fmt: skip

    def _found(self, tag: str) -> Element | None:
        """Return the element of this name, if the joint has one, and make sure of its attributes."""
        element = self.element.find(tag)
        for name in () if element is None else element.attrib:
            if name not in _ATTRIBUTES[tag]:
                raise refused(
                    "urdf_attribute_unknown",
                    joint=self.name, element=tag, attribute=_short(name), known=_ATTRIBUTES[tag]
                )  # fmt: skip
        return element

    def _numbers(
        self, element: Element, tag: str, name: str, otherwise: tuple[float, ...]
    ) -> tuple[float, ...]:
        text = element.get(name)
        if text is None:
            return otherwise
        values = [_number(word) for word in text.split()]
        if len(values) != len(otherwise) or not all(abs(value) <= MAX_NUMBER for value in values):
            raise self.malformed(tag, name, len(otherwise))
        return tuple(values)

    def _bound(self, limit: Element, name: str) -> float:
        word = limit.get(name, "0").strip()
        value = float(word) if _INFINITE.fullmatch(word) else _number(word)
        if math.isnan(value):
            raise refused("urdf_limit_malformed", joint=self.name, attribute=name)
        return value


@dataclass(frozen=True, kw_only=True, slots=True)
class UrdfDocument:
    """A description: a tree of links, if it is sound."""

    name: str
    links: tuple[str, ...]
    joints: tuple[UrdfJoint, ...]


def refused(code: str, **params: ParamValue) -> DescriptionError:
    """Return a DescriptionError without a place: its parameters name the joint or link at fault."""
    return DescriptionError(Fault.at(code, **params))


def read_document(text: str) -> UrdfDocument:
    """Return the links and joints of a URDF text.

    Raises:
        DescriptionError: not well-formed, unsafe, too large, no URDF, or joints and links that do not fit.
    """
    root = _parse(text)
    space, _, found = root.tag.rpartition("}")
    if found != "robot":
        raise refused("urdf_no_robot", found=_short(found))
    if space:
        for element in root.iter():
            element.tag = str(element.tag).removeprefix(space + "}")
    within = (element for joint in root.findall("joint") for element in joint.iter())
    if any("xacro" in str(element.tag) for element in root.iter()) or any(
        "${" in value for element in within for value in element.attrib.values()
    ):
        raise refused("urdf_is_xacro")
    links = tuple(_named(element, "link") for element in root.findall("link"))
    joints = tuple(_joint(element) for element in root.findall("joint"))
    if not links:
        raise refused("urdf_no_links")
    _check_names("link", links)
    _check_names("joint", tuple(joint.name for joint in joints))
    known = set(links)
    for joint in joints:
        for link in (joint.parent, joint.child):
            if link not in known:
                raise refused("urdf_link_missing", joint=joint.name, link=link)
    return UrdfDocument(name=_short(root.get("name", "")), links=links, joints=joints)


class _BoundedBuilder(TreeBuilder):
    """Builds a tree of bounded depth and size."""

    def __init__(self) -> None:
        super().__init__()
        self._depth = 0
        self._elements = 0

    def start(self, tag: str, attrs: dict[str, str]) -> Element:
        self._depth += 1
        self._elements += 1
        if self._depth > MAX_DEPTH or self._elements > MAX_ELEMENTS:
            raise refused("urdf_too_complex", depth=MAX_DEPTH, elements=MAX_ELEMENTS)
        return super().start(tag, attrs)

    def end(self, tag: str) -> Element:
        self._depth -= 1
        return super().end(tag)


def _parse(text: str) -> Element:
    if len(text) > MAX_CHARACTERS:
        raise refused("urdf_too_long", limit=MAX_CHARACTERS)
    body = text.lstrip()  # what was pasted often begins with a line break, which readers of URDF pass over
    passed = text[: len(text) - len(body)].count("\n")
    parser: Any = DefusedXMLParser(
        target=_BoundedBuilder(), forbid_dtd=True, forbid_entities=True, forbid_external=True
    )
    try:
        parser.feed(body)
        root: Element = parser.close()
    except DefusedXmlException:
        raise refused("urdf_unsafe") from None
    except ParseError as error:
        line, column = error.position
        raise refused("urdf_not_xml", line=passed + line, column=column + 1) from None
    except ValueError:  # a character that no encoding has
        raise refused("urdf_not_xml", line=1, column=1) from None
    return root


def _joint(element: Element) -> UrdfJoint:
    name = _named(element, "joint")
    ends = {}
    for tag in ("parent", "child"):
        end = element.find(tag)
        link = None if end is None else end.get("link")
        if not link:
            raise refused("urdf_joint_incomplete", joint=name, element=tag)
        ends[tag] = _short(link)
    for tag in _ONCE:
        if len({tuple(sorted(one.attrib.items())) for one in element.findall(tag)}) > 1:
            raise refused("urdf_element_twice", joint=name, element=tag)
    kind = element.get("type", "")
    return UrdfJoint(
        name=name, kind=_short(kind), parent=ends["parent"], child=ends["child"], element=element
    )


def _named(element: Element, tag: str) -> str:
    name = element.get("name")
    if not name:
        raise refused("urdf_name_missing", element=tag)
    return _short(name)


def _check_names(tag: str, names: tuple[str, ...]) -> None:
    seen = set()
    for name in names:
        if name in seen:
            raise refused("urdf_name_twice", element=tag, name=name)
        seen.add(name)


def _number(word: str) -> float:
    """Return the number that a word is, NaN if it is none."""
    return float(word) if len(word) < 400 and _NUMBER.fullmatch(word) else math.nan


def _short(text: str) -> str:
    return text if len(text) <= 200 else text[:199] + "…"
