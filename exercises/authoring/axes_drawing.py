"""A robot drawn by its joint axes: where each lies, in numbers, named lengths, or by the axes before it.

A point is [x, y, z], or {on, at}: that far along an earlier axis, or {from, by}: displaced from an earlier
axis's point. A direction is [x, y, z], or {parallel}, {opposite}: that of an earlier axis, or
{perpendicular, towards}: across one earlier axis, as nearly towards a vector as may be, or across two, or
{through}: to a further point. Every coordinate and distance is a number or an expression in the drawing's
lengths.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from exercises.reading import Reader
from kinematics.errors import KinematicsError
from kinematics.expressions import Expression, Number, Parameter, add, evaluate, multiply, parameters_in
from kinematics.frames.assignment import assign_frames
from kinematics.frames.axes import JointAxis
from kinematics.se3 import triple
from kinematics.table import LENGTHS, Convention, JointType, NumericTable

MOST_AXES = 16
MOST_LENGTHS = 32
"""Twice the axes of the longest arm in the documents, as of a draft; an offset and a length for each."""
PARALLEL = 1e-9  # Sine of the least angle between two axes across which there is a direction.
STEP = 1 / 64
"""Share by which a length is changed to see which entries hold it: small enough to leave the structure."""
_NEAR = 1e-7
"""What is left of an entry, relative to the robot, once the lengths that it holds are taken away."""

Vector3 = NDArray[np.float64]
Values = Mapping[str, float]
_Point = Callable[[Values, "list[_DrawnAxis]"], Vector3]


class _DrawnAxis(NamedTuple):
    point: Vector3
    direction: Vector3


@dataclass(frozen=True, kw_only=True, slots=True)
class AxesDrawing:
    """Joint axes as they were drawn.

    Attributes:
        points: for each axis what computes a point on it, from the lengths and the axes before.
        directions: for each axis what computes its direction, from the same and its point.
        lengths: value of each named length [the drawing's unit].
    """

    joints: tuple[JointType, ...]
    points: tuple[_Point, ...]
    directions: tuple[Callable[[Values, list[_DrawnAxis], Vector3], Vector3], ...]
    lengths: Values

    def axes(self, lengths: Values | None = None) -> tuple[JointAxis, ...]:
        """Return the axes at values of the lengths; those of the drawing if none are given."""
        values = self.lengths if lengths is None else lengths
        placed: list[_DrawnAxis] = []
        for point, direction in zip(self.points, self.directions, strict=True):
            at = point(values, placed)
            along = direction(values, placed, at)
            size = float(np.linalg.norm(along))
            placed.append(_DrawnAxis(at, along / size if size > 0 else along))
        return tuple(
            JointAxis(joint=joint, point=triple(at.tolist()), direction=triple(along.tolist()))
            for joint, (at, along) in zip(self.joints, placed, strict=True)
        )

    def table(self, lengths: Values | None = None) -> NumericTable:
        """Return the modified DH table of the axes.

        Frame 0 is the frame in which they were drawn where the convention can hold it: then the height of
        the base is in the table, too.

        Raises:
            DescriptionError: an axis has no direction.
        """
        axes = self.axes(lengths)
        assigned = assign_frames(axes, Convention.MODIFIED, base=np.eye(4))
        return (
            assigned.table
            if np.allclose(assigned.base, np.eye(4))
            else assign_frames(axes, Convention.MODIFIED).table
        )


def read_drawing(reader: Reader) -> AxesDrawing:
    """Return the drawing that a document describes; faults go to the reader."""
    lengths = reader.table("lengths").named_numbers()
    entries = list(reader.entries("axes"))
    if not entries:
        reader.missing("axes")
    if len(entries) > MOST_AXES:
        reader.fault("drawing_too_many_axes", "axes", count=len(entries), limit=MOST_AXES)
    if len(lengths) > MOST_LENGTHS:
        reader.fault("drawing_too_many_lengths", "lengths", count=len(lengths), limit=MOST_LENGTHS)
    joints, points, directions = [], [], []
    for i, entry in enumerate(entries[:MOST_AXES]):
        joints.append(entry.choice("joint", JointType))
        points.append(_point(entry, "point", i, lengths))
        directions.append(_direction(entry, i, lengths))
        entry.finish()
    return AxesDrawing(
        joints=tuple(joints), points=tuple(points), directions=tuple(directions), lengths=lengths
    )


def _point(reader: Reader, key: str, before: int, lengths: Values) -> _Point:
    if isinstance(reader.values.get(key), dict):
        inner = reader.table(key)
        if inner.given("on"):
            on, at = _earlier(inner, "on", before), _known(inner, "at", inner.length("at", 0), lengths)
            inner.finish()
            return lambda values, axes: axes[on].point + evaluate(at, values) * axes[on].direction
        start = _earlier(inner, "from", before)
        by = _coordinates(inner, "by", lengths)
        inner.finish()
        return lambda values, axes: axes[start].point + by(values)
    found = _coordinates(reader, key, lengths)
    return lambda values, axes: found(values)


def _direction(
    reader: Reader, before: int, lengths: Values
) -> Callable[[Values, list[_DrawnAxis], Vector3], Vector3]:
    if not isinstance(reader.values.get("direction"), dict):
        fixed = _coordinates(reader, "direction", lengths)
        return lambda values, axes, point: fixed(values)
    inner = reader.table("direction")
    if inner.given("through"):
        end = _point(inner, "through", before, lengths)
        inner.finish()
        return lambda values, axes, point: end(values, axes) - point
    for key, sign in (("parallel", 1.0), ("opposite", -1.0)):
        if inner.given(key):
            of = _earlier(inner, key, before)
            inner.finish()
            return lambda values, axes, point, of=of, sign=sign: sign * axes[of].direction  # type: ignore[misc]
    first = _earlier(inner, "perpendicular", before)
    if inner.given("and"):
        second = _earlier(inner, "and", before)
        inner.finish()
        return lambda values, axes, point: _across(axes[first].direction, axes[second].direction)
    towards = _coordinates(inner, "towards", lengths)
    inner.finish()
    return lambda values, axes, point: _rejected(towards(values), axes[first].direction)


def _earlier(reader: Reader, key: str, before: int) -> int:
    """Return the place of an axis that is drawn before this one; axes are numbered from 1."""
    number = reader.integer(key)
    if 1 <= number <= before:
        return number - 1
    reader.fault("axis_not_before", key, axis=number, before=before)
    return 0


def _coordinates(reader: Reader, key: str, lengths: Values) -> Callable[[Values], Vector3]:
    cells = [_known(reader, key, cell, lengths) for cell in reader.lengths(key)]
    return lambda values: np.array([evaluate(cell, values) for cell in cells])


def _known(reader: Reader, key: str, cell: Expression, lengths: Values) -> Expression:
    """Return a coordinate, all of whose names are lengths of the drawing."""
    for name in sorted(parameters_in(cell)):
        if name not in lengths:
            reader.fault("length_unknown", key, name=name, known=", ".join(lengths))
            return Number(Fraction(0))
    return cell


def _across(first: Vector3, second: Vector3) -> Vector3:
    found = np.cross(first, second)
    return found if np.linalg.norm(found) > PARALLEL else np.zeros(3)


def _rejected(vector: Vector3, axis: Vector3) -> Vector3:
    found = vector - np.dot(vector, axis) * axis
    return found if np.linalg.norm(found) > PARALLEL * np.linalg.norm(vector) else np.zeros(3)


def in_named_lengths(drawing: AxesDrawing) -> dict[tuple[int, str], Expression]:
    """Return the entries of the drawing's table that are sums of its lengths, by row and cell.

    Each entry is a function of the lengths. Where it is linear with whole (or half) coefficients, as
    between axes at right angles, these are found by changing one length at a time, and confirmed with all
    of them changed at once.
    """
    names = tuple(drawing.lengths)
    usual = _lengths_in(drawing.table())
    scale = max((abs(value) for value in drawing.lengths.values()), default=1.0) or 1.0
    together = {name: value * (1 + STEP * (k + 2)) for k, (name, value) in enumerate(drawing.lengths.items())}
    steps = [_with(drawing.lengths, name)[name] - value for name, value in drawing.lengths.items()]
    try:
        changed = [_lengths_in(drawing.table(_with(drawing.lengths, name))) for name in names]
        all_changed = _lengths_in(drawing.table(together))
    except KinematicsError:
        return {}
    if any(table.keys() != usual.keys() for table in (*changed, all_changed)):
        return {}
    found: dict[tuple[int, str], Expression] = {}
    for place, value in usual.items():
        coefficients = [
            _nice((table[place] - value) / step) for step, table in zip(steps, changed, strict=True)
        ]
        rest = value - sum(
            float(c) * drawing.lengths[name] for c, name in zip(coefficients, names, strict=True)
        )
        after = rest + sum(float(c) * together[name] for c, name in zip(coefficients, names, strict=True))
        exact = Fraction(repr(round(rest, 6)))
        if not any(coefficients) or abs(after - all_changed[place]) > _NEAR * scale:
            continue
        terms = [
            multiply((Number(c), Parameter(name))) for c, name in zip(coefficients, names, strict=True) if c
        ]
        found[place] = add([*terms, Number(exact)] if abs(rest) > _NEAR * scale else terms)
    return found


def _with(lengths: Values, name: str) -> dict[str, float]:
    changed = lengths[name] * (1 + STEP)
    return {**lengths, name: changed if changed != lengths[name] else STEP}


def _nice(coefficient: float) -> Fraction:
    nearest = Fraction(round(2 * coefficient), 2)
    return nearest if abs(coefficient - float(nearest)) < 1e-6 else Fraction(0)


def _lengths_in(table: NumericTable) -> dict[tuple[int, str], float]:
    cells: Sequence[str] = LENGTHS
    return {(i, cell): getattr(row, cell) for i, row in enumerate(table.rows) for cell in cells}
