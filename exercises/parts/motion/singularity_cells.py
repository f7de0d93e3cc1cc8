"""The conditions for a singularity as they are typed, with a motion that is lost, and what they mean."""

from dataclasses import dataclass, field, replace
from typing import Annotated

from exercises.parts.cells.number_cells import read_numbers_of
from exercises.parts.motion.conditions import read_conditions
from exercises.parts.protocol import Length, Reading
from kinematics.answers.left_open import Rounded
from kinematics.cells import Cell
from kinematics.cells.meaning import Position
from kinematics.errors import Fault
from kinematics.expressions import Expression

MOST = 16  # Conditions in one answer; the arms of the documents have five families.
ConditionRow = Annotated[tuple[Cell, ...], Length(least=1, most=1)]
Conditions = Annotated[tuple[ConditionRow, ...], Length(most=MOST)]
Motion = Annotated[tuple[Cell, ...], Length(least=3, most=6)]


@dataclass(frozen=True, kw_only=True, slots=True)
class SingularityCells:
    """Conditions for a singularity, and a motion that is lost.

    Attributes:
        conditions: rows of one cell: a function that vanishes (sin(q3)), or an equation (q3 = 0, π).
        lost: what every velocity of the end has no component along: three numbers for v, or six for (v, ω).
    """

    conditions: Conditions | None = None
    lost: Motion | None = None


@dataclass(frozen=True, kw_only=True, slots=True)
class SingularityAnswer:
    """Conditions and a lost motion as read: for each row the functions that vanish where its conditions hold.

    `rounded` holds what functions with decimals are with one of these moved.
    """

    conditions: tuple[tuple[Expression, ...], ...] | None
    lost: tuple[float, ...] | None
    rounded: Rounded = field(default_factory=dict)


def read_singularities(raw: SingularityCells, reading: Reading, count: int) -> SingularityAnswer | None:
    """Return the functions that vanish, row by row, and the motion; faults are kept in the reading."""
    exercise = reading.instance.exercise
    types = exercise.reference.table.joint_types
    names = {*exercise.reference.parameters, *exercise.aliases}
    again = replace(reading, faults=[])
    rows: list[tuple[Expression, ...]] = []
    rounded: dict[Expression, tuple[Expression, ...]] = {}
    for i, (cell,) in enumerate(raw.conditions or ()):
        where = ("conditions", i, 0)
        found = read_conditions(cell, types, exercise.angle_unit, where, names)
        read = [entry for entry in found if not isinstance(entry, Fault)]
        reading.faults.extend(entry for entry in found if isinstance(entry, Fault))
        own = [reading.own_names(entry.expression, where, idle=entry.idle) for entry in read]
        rows.append(tuple(function for function in own if function is not None))
        for entry, function in zip(read, own, strict=True):
            near = [again.own_names(other, where) for other in entry.rounded]
            if function is not None and near:
                rounded[function] = tuple(other for other in near if other is not None)
    lost = None
    if raw.lost is not None and reading.is_row_of(count, raw.lost, "lost", code="vector_length"):
        lost = read_numbers_of(raw.lost, Position.LENGTH, reading, "lost")
    if raw.conditions is None and raw.lost is None:
        reading.fault("conditions_empty")
    if reading.faults:
        return None
    conditions = tuple(rows) if raw.conditions is not None else None
    return SingularityAnswer(conditions=conditions, lost=lost, rounded=rounded)
