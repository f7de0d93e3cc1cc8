"""The [figure] of a definition, from its file."""

import math
from collections.abc import Sequence

from exercises.figures.specification import (
    DimensionMark,
    FigureGripper,
    FigureSpecification,
    Ground,
    JointMark,
    Point,
    PointAlongAxis,
    PointBeside,
    PointBetween,
    PointInFrame,
    View,
)
from exercises.reading import Reader
from kinematics.expressions import ZERO, Parameter
from kinematics.keys import ValueKind
from kinematics.table import JointType

USUAL_VIEW = View(azimuth=math.radians(-60), elevation=math.radians(24))


def read_figure(reader: Reader, joint_types: Sequence[JointType], degrees: bool) -> FigureSpecification:
    """Return what a [figure] says, turns in degrees or in [rad]; faults go to the reader."""
    view = reader.table("view")
    upright = reader.table("upright")
    specification = FigureSpecification(
        posture=_posture(reader, joint_types, degrees),
        view=View(
            azimuth=math.radians(view.number("azimuth", math.degrees(USUAL_VIEW.azimuth))),
            elevation=math.radians(view.number("elevation", math.degrees(USUAL_VIEW.elevation))),
        ),
        upright=(
            math.radians(upright.number("roll", 0)),
            math.radians(upright.number("pitch", 0)),
            math.radians(upright.number("yaw", 0)),
        ),
        lengths={name: reader.table("lengths").number(name) for name in reader.table("lengths").values},
        points={name: _point(inner) for name, inner in reader.tables("points")},
        joints=_joints(reader, len(joint_types)),
        links=_links(reader),
        dimensions=tuple(_dimension(entry) for entry in reader.entries("dimensions")),
        marks=reader.texts("marks", default=()),
        ground=_ground(reader),
        gripper=_gripper(reader),
        width=_width(reader),
    )
    view.finish()
    upright.finish()
    reader.finish()
    return specification


def _posture(reader: Reader, joint_types: Sequence[JointType], degrees: bool) -> tuple[float, ...]:
    n = len(joint_types)
    values = reader.per_joint("posture", n, [0] * n)
    return tuple(
        math.radians(value) if degrees and type_ is JointType.REVOLUTE else float(value)
        for value, type_ in zip(values, joint_types, strict=True)
    )


def _point(reader: Reader) -> Point:
    point = _point_of(reader)
    reader.finish()
    return point


def _point_of(reader: Reader) -> Point:
    if reader.given("frame"):
        return PointInFrame(frame=reader.integer("frame"), at=reader.lengths("at", (0, 0, 0)))
    if reader.given("between"):
        ends = reader.texts("between")
        if len(ends) == 2:
            return PointBetween(start=ends[0], end=ends[1], ratio=reader.number("ratio", 0.5))
        reader.mistyped(ValueKind.POINT_NAMES, "between", count=2)
    elif reader.given("from"):
        if reader.given("joint"):
            return PointAlongAxis(
                origin=reader.text("from"), joint=reader.integer("joint"), distance=reader.length("distance")
            )
        return PointBeside(origin=reader.text("from"), by=reader.lengths("by"))
    else:
        reader.fault("point_without_form")
    return PointInFrame(frame=0, at=(ZERO, ZERO, ZERO))


def _joints(reader: Reader, n: int) -> dict[int, JointMark]:
    marks: dict[int, JointMark] = {}
    for name, inner in reader.tables("joints"):
        if not name.isdecimal() or not 1 <= int(name) <= n:
            inner.fault("unknown_joint", joint=name, last=n)
            continue
        label = inner.text("label", "")
        if label not in ("", "+", "-"):
            inner.fault("exercise_value_unknown", "label", key="label", known="+, -")
        marks[int(name)] = JointMark(
            at=inner.text("at"),
            scale=inner.number("scale", 1),
            reach=inner.number("reach", 1),
            label_end={"+": 1, "-": -1}.get(label, 0),
        )
        inner.finish()
    return marks


def _links(reader: Reader) -> tuple[tuple[str, ...], ...]:
    if not reader.given("links"):
        return ()
    chains = reader.values["links"]
    if not isinstance(chains, list) or not all(
        isinstance(chain, list) and len(chain) > 1 and all(isinstance(name, str) for name in chain)
        for chain in chains
    ):
        reader.mistyped(ValueKind.POINT_CHAINS, "links")
        return ()
    return tuple(tuple(chain) for chain in chains)


def _dimension(reader: Reader) -> DimensionMark:
    name = reader.text("name")
    mark = DimensionMark(
        name=name,
        value=reader.length("value") if reader.given("value") else Parameter(reader.name(name, "name")),
        start=reader.text("from"),
        end=reader.text("to"),
        offset=reader.direction("offset", None),
        distance=reader.number("distance", 1),
    )
    reader.finish()
    return mark


def _ground(reader: Reader) -> Ground | None:
    if not reader.given("ground"):
        return None
    inner = reader.table("ground")
    ground = Ground(at=inner.text("at"), normal=inner.direction("normal", (0.0, 0.0, 1.0)) or (0.0, 0.0, 1.0))
    inner.finish()
    return ground


def _gripper(reader: Reader) -> FigureGripper | None:
    if not reader.given("gripper"):
        return None
    inner = reader.table("gripper")
    gripper = FigureGripper(
        at=inner.text("at"), away_from=inner.text("away_from"), jaws=inner.direction("jaws", None)
    )
    inner.finish()
    return gripper


def _width(reader: Reader) -> float:
    width = reader.number("width", 480)
    if not 320 <= width <= 960:
        reader.fault("width_out_of_range", "width")
    return width
