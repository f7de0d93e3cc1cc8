"""The key as a task shows it, where the table is given and something else is asked."""

from exercises.instance import Instance
from exercises.parts.task import GivenNumbers
from exercises.written_table import written_table
from kinematics.cells import ReadTable
from kinematics.table import COLUMNS, Convention


def given_table(instance: Instance, read: ReadTable | None = None, name: str = "table") -> GivenNumbers:
    """Return a DH table for a page to show: the key, if no other is handed in.

    What it is called is the message `given-<name>`.
    """
    table = read or instance.exercise.reference
    columns = columns_of(table)
    raw = written_table(table)
    rows = tuple(
        (str(i), *(str(getattr(row, cell)) for cell, _ in columns)) for i, row in enumerate(raw.rows, 1)
    )
    labels = ("i", *(label for _, label in columns))
    return GivenNumbers(
        name=name, labels=labels, rows=rows, values={"convention": table.table.convention.value}
    )


def columns_of(table: ReadTable) -> tuple[tuple[str, str], ...]:
    """Return the columns of a table in the order of its convention, each with its label."""
    angle = table.angle_unit.sign
    length = table.length_unit.value
    standard = table.table.convention is Convention.STANDARD
    before = "" if standard else "ᵢ₋₁"
    names = {
        "theta": f"θ [{angle}]",
        "d": f"d [{length}]",
        "a": f"a{before} [{length}]",
        "alpha": f"α{before} [{angle}]",
    }
    return tuple((cell, names[cell]) for cell in COLUMNS[table.table.convention])
