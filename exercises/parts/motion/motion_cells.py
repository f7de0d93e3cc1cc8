"""The equations of motion as they are typed, and the functions that they mean."""

from collections.abc import Collection
from dataclasses import dataclass
from enum import StrEnum
from typing import Annotated, Any

from exercises.parts.cells.matrix_cells import read_row, roundings_in
from exercises.parts.protocol import Length, Reading
from kinematics.answers.dynamics_verdicts import EquationsAnswer
from kinematics.cells import Cell
from kinematics.dynamics import rate_name
from kinematics.expressions import Expression

CellRow = Annotated[tuple[Cell, ...], Length(least=1, most=64)]
CellRows = Annotated[tuple[CellRow, ...], Length(least=1, most=64)]


class MotionAsk(StrEnum):
    """What is asked: M, some C, that Ṁ − 2C is skew-symmetric as well, C q̇ alone, g."""

    MASS = "mass"
    CORIOLIS = "coriolis"
    SKEW = "skew"
    VELOCITY = "velocity"
    GRAVITY = "gravity"


_FIELDS = {
    MotionAsk.MASS: ("mass",),
    MotionAsk.CORIOLIS: ("coriolis", "velocity"),
    MotionAsk.SKEW: ("coriolis",),
    MotionAsk.VELOCITY: ("coriolis", "velocity"),
    MotionAsk.GRAVITY: ("gravity",),
}
"""Fields of an answer that are judged where something is asked: C q̇ follows from C, and stands for it."""


@dataclass(frozen=True, kw_only=True, slots=True)
class MotionCells:
    """The equations of motion: expressions in q1 … qn, the rates dq1 … dqn, and the names that are given.

    Attributes:
        mass: n×n, the mass matrix M.
        coriolis: n×n, C with the right C q̇.
        velocity: n, C q̇, where it is asked instead.
        gravity: n, what gravity asks of the joints.
    """

    mass: CellRows | None = None
    coriolis: CellRows | None = None
    velocity: CellRow | None = None
    gravity: CellRow | None = None


def read_motion(
    raw: MotionCells, ask: Collection[MotionAsk], reading: Reading, weights: Collection[str]
) -> EquationsAnswer | None:
    """Return the functions that were typed; faults are kept in the reading, also where no field is asked."""
    n = len(reading.joint_types)
    rates = {rate_name(i) for i in range(1, n + 1)}
    names = {*weights, *rates}
    found: dict[str, Any] = {}
    cells: list[tuple[Cell, Expression]] = []
    for field in ("mass", "coriolis", "velocity", "gravity"):
        given = getattr(raw, field)
        if given is None:
            continue
        is_matrix = field in ("mass", "coriolis")
        rows = given if is_matrix else (given,)
        if is_matrix and len(rows) != n:
            reading.fault("motion_row_count", field, expected=n, given=len(rows))
            continue
        read = []
        for i, row in enumerate(rows):
            place = (field, i) if is_matrix else (field,)
            if reading.is_row_of(n, row, *place):
                entries = read_row(row, reading, *place, names=names)
                read.append(entries)
                cells += zip(row, entries or (), strict=False)
        found[field] = tuple(read) if is_matrix else read[0] if read else None
    if not reading.faults and not any(field in found for question in ask for field in _FIELDS[question]):
        reading.fault("motion_empty")
    if reading.faults:
        return None
    return EquationsAnswer(**found, rounded=roundings_in(cells, reading, rates, names))
