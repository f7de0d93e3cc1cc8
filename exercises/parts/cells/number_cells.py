"""Cells that hold a number: an angle, a length or a ratio, in the exercise's dimensions or without them."""

import math
from collections.abc import Sequence
from functools import partial

import numpy as np

from exercises.instance import Instance
from exercises.names import in_own_names
from exercises.parts.protocol import Reading
from kinematics.cells import DEFAULT, Cell
from kinematics.cells.entries import cell_meaning, plain_number
from kinematics.cells.meaning import Position
from kinematics.cells.refusals import CellRefusal
from kinematics.errors import CellError, Fault, KinematicsError
from kinematics.expressions import evaluate
from kinematics.se3 import Floats

DECIMALS = 4  # Decimals of what is given and of what a student writes, as textbooks print them.


def on_paper(values: Floats, decimals: int = DECIMALS) -> Floats:
    """Return numbers as they are written, none of them −0."""
    rounded: Floats = np.round(values, decimals) + 0.0
    return rounded


def number_of(cell: Cell, position: Position, instance: Instance, where: tuple[str | int, ...]) -> float:
    """Return the value of a cell without joint variables; an angle in [rad], a length in the exercise's unit.

    Raises:
        CellError: it cannot be read, holds an unknown name, or has no finite value.
    """
    exercise = instance.exercise
    unit = exercise.angle_unit
    try:
        plain = plain_number(cell, position, unit, DEFAULT)
        if plain is not None:
            return plain
        meaning = cell_meaning(cell, position, unit, DEFAULT, lambda _: None)
    except CellRefusal as refusal:
        raise CellError(refusal.at(*where)) from None
    expression = in_own_names(meaning.expression, exercise, where, idle=meaning.idle, is_constant=True)
    try:
        value = evaluate(expression, instance.values)
    except KinematicsError:
        value = math.nan
    if not math.isfinite(value):
        raise CellError(Fault.at("value_not_real", *where))
    return value


def read_numbers_of(
    cells: Sequence[Cell], position: Position | Sequence[Position], reading: Reading, *where: str | int
) -> tuple[float, ...] | None:
    """Return the values of some cells, or None; faults are kept in the reading, at `where`.

    The position is what stands in them, or in each of them.
    """
    positions = [position] * len(cells) if isinstance(position, Position) else position
    found = [
        reading.keep(partial(number_of, cell, meant, reading.instance, (*where, k)))
        for k, (cell, meant) in enumerate(zip(cells, positions, strict=True))
    ]
    values = tuple(value for value in found if value is not None)
    return values if len(values) == len(cells) else None
