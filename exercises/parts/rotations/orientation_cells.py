"""An orientation as it is handed in: the notations, the cells as typed, and what they mean."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import partial
from typing import Annotated

from exercises.instance import Instance
from exercises.parts.cells.number_cells import DECIMALS, number_of, read_numbers_of
from exercises.parts.protocol import Length, Reading
from kinematics.cells import Cell
from kinematics.cells.meaning import Position
from kinematics.poses import axis_angle_from_transform, quaternion_from_transform
from kinematics.rotations.matrices import Matrix3, Triple, as_transform, matrix3
from kinematics.rotations.orientation_verdicts import ComponentOrder
from kinematics.rotations.sequences import Combination, EulerSequence, GimbalFamily, euler_solutions
from kinematics.se3 import triple

CellRow3 = tuple[Cell, Cell, Cell]


class OrientationNotation(StrEnum):
    """A notation in which an orientation is given or asked.

    ANGLES: one triple of angles. EVERY_TRIPLE: both, or the whole family at gimbal lock.
    """

    MATRIX = "matrix"
    QUATERNION = "quaternion"
    AXIS_ANGLE = "axis_angle"
    ANGLES = "angles"
    EVERY_TRIPLE = "every_triple"


@dataclass(frozen=True, kw_only=True, slots=True)
class OrientationCells:
    """An orientation in the notations that are asked.

    Attributes:
        matrix: 3×3, row by row.
        quaternion: a unit quaternion; q and −q are the same.
        component_order: where the scalar stands in it: wxyz or xyzw; needed beside a quaternion.
        axis: of the rotation; any length but zero.
        angle: about the axis.
        angles: triples about the axes that are asked; one, or both where all are asked.
        middle: at gimbal lock, the middle angle of every triple.
        combination: at gimbal lock, what is fixed of the others: the sum, or the difference first − last.
        value: of this sum or difference.
    """

    matrix: tuple[CellRow3, CellRow3, CellRow3] | None = None
    quaternion: tuple[Cell, Cell, Cell, Cell] | None = None
    component_order: ComponentOrder | None = None
    axis: CellRow3 | None = None
    angle: Cell | None = None
    angles: Annotated[tuple[CellRow3, ...], Length(least=1, most=4)] | None = None
    middle: Cell | None = None
    combination: Combination | None = None
    value: Cell | None = None


@dataclass(frozen=True, kw_only=True, slots=True)
class OrientationAnswer:
    """An orientation in the notations that were handed in, in numbers; angles in [rad]."""

    matrix: Matrix3 | None = None
    quaternion: tuple[float, ...] | None = None
    component_order: ComponentOrder | None = None
    axis: tuple[float, ...] | None = None
    angle: float | None = None
    angles: tuple[Triple, ...] | None = None
    family: GimbalFamily | None = None


def read_orientation(
    raw: OrientationCells, ask: Sequence[OrientationNotation], reading: Reading
) -> OrientationAnswer | None:
    """Return the notations in numbers; faults are kept in the reading, also where none is asked."""

    def numbers(
        cells: tuple[Cell, ...] | None, position: Position, *where: str | int
    ) -> tuple[float, ...] | None:
        return None if cells is None else read_numbers_of(cells, position, reading, *where)

    def one(cell: Cell | None, position: Position, name: str) -> float | None:
        if cell is None:
            return None
        return reading.keep(partial(number_of, cell, position, reading.instance, (name,)))

    rows = [numbers(row, Position.RATIO, "matrix", i) for i, row in enumerate(raw.matrix or ())]
    triples = [numbers(row, Position.ANGLE, "angles", i) for i, row in enumerate(raw.angles or ())]
    answer = OrientationAnswer(
        matrix=matrix3([row for row in rows if row]) if rows and all(rows) else None,
        quaternion=numbers(raw.quaternion, Position.RATIO, "quaternion"),
        component_order=raw.component_order,
        axis=numbers(raw.axis, Position.RATIO, "axis"),
        angle=one(raw.angle, Position.ANGLE, "angle"),
        angles=tuple(triple(found) for found in triples if found) or None,
    )
    middle, value = one(raw.middle, Position.ANGLE, "middle"), one(raw.value, Position.ANGLE, "value")
    if middle is not None and value is not None and raw.combination is not None:
        answer = replace(answer, family=GimbalFamily(middle=middle, combination=raw.combination, value=value))
    if raw.quaternion is not None and raw.component_order is None:
        reading.fault("component_order_missing", "component_order")
    if (raw.axis is None) != (raw.angle is None):
        reading.fault("axis_and_angle", "angle" if raw.angle is None else "axis")
    if len({raw.middle is None, raw.value is None, raw.combination is None}) > 1:
        reading.fault("family_incomplete", "combination")
    if not reading.faults and not any(_is_written(notation, answer) for notation in ask):
        reading.fault("orientation_empty")
    return None if reading.faults else answer


def _is_written(notation: OrientationNotation, answer: OrientationAnswer) -> bool:
    match notation:
        case OrientationNotation.AXIS_ANGLE:
            return answer.axis is not None
        case OrientationNotation.EVERY_TRIPLE:
            return answer.angles is not None or answer.family is not None
        case _:
            return getattr(answer, notation.value) is not None


def rounded(values: Sequence[float]) -> tuple[float, ...]:
    """Return numbers as they are written, none of them −0."""
    return tuple(round(float(value), DECIMALS) + 0.0 for value in values)


def written_orientation(
    rotation: Matrix3, ask: Sequence[OrientationNotation], sequence: EulerSequence, instance: Instance
) -> OrientationCells:
    """Return an orientation in the notations that are asked, rounded as on paper."""
    in_unit = instance.exercise.angle_unit.from_radians
    pose = as_transform(rotation)

    def typed(*angles: float) -> list[float]:
        return [round(in_unit(angle), DECIMALS) for angle in angles]

    written = OrientationCells()
    for notation in ask:
        match notation:
            case OrientationNotation.MATRIX:
                written = replace(written, matrix=triple(triple(rounded(row)) for row in rotation))
            case OrientationNotation.QUATERNION:
                w, x, y, z = rounded(quaternion_from_transform(pose))
                order = ComponentOrder.SCALAR_FIRST
                written = replace(written, quaternion=(w, x, y, z), component_order=order)
            case OrientationNotation.AXIS_ANGLE:
                axis, angle = axis_angle_from_transform(pose)
                written = replace(written, axis=triple(rounded(axis)), angle=typed(angle)[0])
            case OrientationNotation.ANGLES | OrientationNotation.EVERY_TRIPLE:
                found = euler_solutions(rotation, sequence)
                every = notation is OrientationNotation.EVERY_TRIPLE
                if every and found.family is not None:
                    middle, value = typed(found.family.middle, found.family.value)
                    way = found.family.combination
                    written = replace(written, middle=middle, value=value, combination=way)
                else:
                    triples = found.triples[: 2 if every else 1]
                    written = replace(written, angles=tuple(triple(typed(*angles)) for angles in triples))
    return written
