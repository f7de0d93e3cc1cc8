"""The [[parts]] of a definition, from its file."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from exercises.definition import Draw, Part, PartKind, PosePart, ReachFrom, WorkspacePart
from exercises.reading import Reader
from kinematics.table import JointType

Limits = Sequence[tuple[float, float]]

USUAL_TURNS = Draw(start=Fraction(-120), stop=Fraction(120), step=Fraction(15), without=(Fraction(0),))
"""From where the angles of a numeric pose are drawn, in degrees."""

MOST_VALUES = 10_000


def read_parts(
    reader: Reader, joint_types: Sequence[JointType], degrees: bool, limits: Limits | None
) -> tuple[Part, ...]:
    """What is asked; faults go to the reader.

    Args:
        reader: of the definition.
        joint_types: types of the robot's joints.
        degrees: the exercise gives angles in degrees.
        limits: of the catalogue robot's joints, if they are known.
    """
    parts: list[Part] = []
    for entry in reader.entries("parts"):
        kind = entry.choice("kind", PartKind)
        points = entry.exact("points")
        if points <= 0:
            entry.fault("points_not_positive", "points")
        if any(part.kind is kind for part in parts):
            entry.fault("part_twice", "kind", kind=kind.value)
        parts.append(_part(entry, kind, points, joint_types, degrees, limits))
        entry.finish()
    if not any(part.kind is PartKind.TABLE for part in parts):
        reader.fault("table_not_asked", "parts")
    return tuple(parts)


def read_draw(reader: Reader, key: str) -> Draw | None:
    """From where values are drawn; None if the key is missing."""
    if not reader.given(key):
        return None
    inner = reader.table(key)
    draw = Draw(
        start=inner.exact("from"),
        stop=inner.exact("to"),
        step=inner.exact("step"),
        without=inner.exacts("without", ()),
    )
    inner.finish()
    if draw.step <= 0 or draw.stop < draw.start:
        inner.fault("draw_empty")
        return None
    if (draw.stop - draw.start) / draw.step > MOST_VALUES:
        inner.fault("draw_too_large", limit=MOST_VALUES)
        return None
    if not draw.values():
        inner.fault("draw_empty")
        return None
    return draw


def _part(
    reader: Reader,
    kind: PartKind,
    points: Fraction,
    joint_types: Sequence[JointType],
    degrees: bool,
    limits: Limits | None,
) -> Part:
    if kind is PartKind.POSE:
        return _pose(reader, points, joint_types, degrees)
    if kind is PartKind.WORKSPACE:
        return _workspace(reader, points, len(joint_types), limits)
    return Part(kind=kind, points=points)


def _pose(reader: Reader, points: Fraction, joint_types: Sequence[JointType], degrees: bool) -> PosePart:
    joints = reader.exacts("joints")
    if len(joints) != len(joint_types):
        n = len(joint_types)
        reader.fault("joints_wrong_length", "joints", expected=n)
        joints = (Fraction(0),) * n
    slides = read_draw(reader, "slides")
    turns = read_draw(reader, "turns")
    if turns is None and degrees:
        turns = USUAL_TURNS
    tolerance = reader.number("tolerance", 0.005)
    draws = tuple(slides if type_ is JointType.PRISMATIC else turns for type_ in joint_types)
    return PosePart(kind=PartKind.POSE, points=points, joints=joints, draws=draws, tolerance=tolerance)


def _workspace(reader: Reader, points: Fraction, n: int, known: Limits | None) -> WorkspacePart:
    origin = reader.text("from", ReachFrom.AXIS.value)
    return WorkspacePart(
        kind=PartKind.WORKSPACE,
        points=points,
        point=reader.text("point"),
        reach_from=ReachFrom.AXIS if origin == ReachFrom.AXIS.value else ReachFrom.POINT,
        origin=None if origin == ReachFrom.AXIS.value else origin,
        limits=_limits(reader, n, known),
        tolerance=reader.number("tolerance", 0.01),
    )


def _limits(reader: Reader, n: int, known: Limits | None) -> tuple[tuple[Fraction, Fraction] | None, ...]:
    """Limits of the joints: "catalogue", a list with one entry per joint ([] for none), or none at all."""
    free: tuple[tuple[Fraction, Fraction] | None, ...] = (None,) * n
    if not reader.given("limits"):
        return free
    value = reader.values["limits"]
    if value == "catalogue":
        if known is None:
            reader.fault("exercise_limits_unknown", "limits")
            return free
        return tuple((Fraction(repr(low)), Fraction(repr(high))) for low, high in known)
    if not isinstance(value, list) or len(value) != n:
        reader.fault("joints_wrong_length", "limits", expected=n)
        return free
    limits: list[tuple[Fraction, Fraction] | None] = []
    for i, entry in enumerate(value):
        if entry == []:
            limits.append(None)
            continue
        inner = Reader({"pair": entry}, (*reader.where, "limits", i), reader.faults)
        pair = inner.exacts("pair")
        if len(pair) != 2 or pair[0] > pair[1]:
            inner.fault("exercise_limits_reversed", joint=i + 1)
            pair = (Fraction(0), Fraction(0))
        limits.append((pair[0], pair[1]))
    return tuple(limits)
