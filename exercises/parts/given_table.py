"""The key as a task shows it, where the table is given and something else is asked."""

from __future__ import annotations

from exercises.instance import Instance
from exercises.parts.protocol import GivenNumbers
from exercises.written_table import written_table
from kinematics.cells import AngleUnit, ReadTable
from kinematics.table import CELLS, Convention


def given_table(instance: Instance, read: ReadTable | None = None, name: str = "table") -> GivenNumbers:
    """Return a DH table for a page to show: the key, if no other is handed in.

    Args:
        instance: the exercise with the student's values.
        read: the table.
        name: what it is; message `given-<name>`.
    """
    table = read or instance.exercise.reference
    raw = written_table(table)
    angle = "°" if table.angle_unit is AngleUnit.DEG else "rad"
    length = table.length_unit.value
    standard = table.table.convention is Convention.STANDARD
    order = ("theta", "d", "a", "alpha") if standard else ("alpha", "a", "d", "theta")
    assert set(order) == set(CELLS)
    names = {
        "theta": f"θ [{angle}]",
        "d": f"d [{length}]",
        "a": f"a{'' if standard else ' (i−1)'} [{length}]",
        "alpha": f"α{'' if standard else ' (i−1)'} [{angle}]",
    }
    rows = tuple((str(i), *(str(getattr(row, cell)) for cell in order)) for i, row in enumerate(raw.rows, 1))
    labels = ("i", *(names[cell] for cell in order))
    return GivenNumbers(
        name=name, labels=labels, rows=rows, values={"convention": table.table.convention.value}
    )
