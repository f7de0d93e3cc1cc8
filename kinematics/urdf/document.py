"""XML text to the links and joints of a URDF description.

The text comes from strangers: entities, document types and external files are refused by the parser
(defusedxml), and length, nesting and the number of elements are bounded. Only what decides about poses is
read; inertias, meshes, transmissions and the rest are passed over.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import Any
from xml.etree.ElementTree import Element, ParseError, TreeBuilder

import numpy as np
from defusedxml import DefusedXmlException
from defusedxml.ElementTree import DefusedXMLParser

from kinematics.errors import DescriptionError, Fault, ParamValue
from kinematics.poses import transform_from_rpy
from kinematics.se3 import Transform

MAX_CHARACTERS = 1_000_000
MAX_DEPTH = 64
MAX_ELEMENTS = 50_000
MAX_NUMBER = 1e9

_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
_ORIGIN = (0.0, 0.0, 0.0)


@dataclass(frozen=True, kw_only=True, slots=True)
class UrdfJoint:
    """A joint as it is written; its numbers are read when the joint turns out to matter.

    Attributes:
        name: its name.
        kind: its type, as written.
        parent: name of the link that it stands on.
        child: name of the link that it carries.
        element: its XML element.
    """

    name: str
    kind: str
    parent: str
    child: str
    element: Element

    def origin(self) -> Transform:
        """(4, 4) pose of the joint's frame in that of its parent link [m]; the identity if left out.

        Raises:
            DescriptionError: not three numbers where three belong.
        """
        origin = self.element.find("origin")
        if origin is None:
            return np.eye(4)
        rpy = self._three(origin, "origin", "rpy", _ORIGIN)
        return transform_from_rpy(rpy, self._three(origin, "origin", "xyz", _ORIGIN))

    def axis(self) -> tuple[float, float, float]:
        """Direction of the joint's axis in its frame, of any length but zero; x if left out.

        Raises:
            DescriptionError: not three numbers, or all of them zero.
        """
        axis = self.element.find("axis")
        direction = (1.0, 0.0, 0.0) if axis is None else self._three(axis, "axis", "xyz", (1.0, 0.0, 0.0))
        if not any(direction):
            raise refused("urdf_axis_zero", joint=self.name)
        return direction

    def limits(self) -> tuple[float, float] | None:
        """Lowest and highest value [rad, or m]; a bound that is left out is 0, as the format has it.

        None of a continuous joint, or if there is no limit element.

        Raises:
            DescriptionError: a bound is no number, or the lower one lies above the upper one.
        """
        limit = self.element.find("limit")
        if limit is None or self.kind == "continuous":
            return None
        low, high = (self._number(limit, name) for name in ("lower", "upper"))
        if low > high:
            raise refused("urdf_limits_reversed", joint=self.name)
        return low, high

    def _three(
        self, element: Element, tag: str, name: str, otherwise: tuple[float, float, float]
    ) -> tuple[float, float, float]:
        text = element.get(name)
        if text is None:
            return otherwise
        words = text.split()
        if len(words) != 3:
            raise self._malformed(tag, name)
        x, y, z = (self._value(word, tag, name) for word in words)
        return x, y, z

    def _number(self, limit: Element, name: str) -> float:
        return self._value(limit.get(name, "0").strip(), "limit", name, count=1)

    def _value(self, word: str, tag: str, name: str, count: int = 3) -> float:
        value = float(word) if len(word) < 400 and _NUMBER.fullmatch(word) else math.nan
        if not abs(value) <= MAX_NUMBER:
            raise self._malformed(tag, name, count)
        return value

    def _malformed(self, tag: str, name: str, count: int = 3) -> DescriptionError:
        return refused(
            "urdf_numbers_malformed",
            joint=self.name,
            element=tag,
            attribute=name,
            count=count,
            limit=f"{MAX_NUMBER:g}",
        )


@dataclass(frozen=True, kw_only=True, slots=True)
class UrdfDocument:
    """A description: a tree of links, if it is sound.

    Attributes:
        name: the robot's name; empty if it has none.
        links: names of the links.
        joints: the joints.
    """

    name: str
    links: tuple[str, ...]
    joints: tuple[UrdfJoint, ...]


def refused(code: str, **params: ParamValue) -> DescriptionError:
    """The refusal of a description: it has no place but the joint or link that its parameters name."""
    return DescriptionError(Fault(code=code, params=params))


def read_document(text: str) -> UrdfDocument:
    """The links and joints of a URDF text.

    Raises:
        DescriptionError: not well-formed, unsafe, too large, no URDF, or joints and links that do not fit.
    """
    root = _parse(text)
    if root.tag != "robot":
        raise refused("urdf_no_robot", found=_short(root.tag))
    if any("xacro" in str(element.tag) for element in root.iter()):
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
    parser: Any = DefusedXMLParser(
        target=_BoundedBuilder(), forbid_dtd=True, forbid_entities=True, forbid_external=True
    )
    try:
        parser.feed(text)
        root: Element = parser.close()
    except DefusedXmlException:
        raise refused("urdf_unsafe") from None
    except ParseError as error:
        line, column = error.position
        f"the text is not well-formed XML: line {line}, column {column + 1}"
        raise refused("urdf_not_xml", line=line, column=column + 1) from None
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


def _short(text: str) -> str:
    return text if len(text) <= 200 else text[:199] + "…"
