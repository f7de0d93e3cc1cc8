"""An orientation as it is handed in: the notations, the cells as typed, and what they mean."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import Annotated

from exercises.parts.protocol import Length
from kinematics.cells import Cell
from kinematics.rotations.matrices import Matrix3, Triple
from kinematics.rotations.orientation_answers import ComponentOrder
from kinematics.rotations.sequences import Combination, GimbalFamily

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
    """The same in numbers; angles in [rad]."""

    matrix: Matrix3 | None = None
    quaternion: tuple[float, ...] | None = None
    component_order: ComponentOrder | None = None
    axis: tuple[float, ...] | None = None
    angle: float | None = None
    angles: tuple[Triple, ...] | None = None
    family: GimbalFamily | None = None
