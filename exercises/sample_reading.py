"""DH tables in a definition's file: the key, and samples for the exercise's own tests."""

from enum import StrEnum

from exercises.definition import Sample
from exercises.reading import Reader
from kinematics.cells import AngleUnit, LengthUnit, RawRow, RawTable, ReadTable
from kinematics.table import CELLS, Convention, JointType


class Expectation(StrEnum):
    """What is expected of a sample."""

    CORRECT = "correct"
    INCORRECT = "incorrect"
    INVALID = "invalid"


def read_raw_table(
    reader: Reader, angle_unit: AngleUnit = AngleUnit.DEG, length_unit: LengthUnit = LengthUnit.M
) -> RawTable | None:
    """Return a DH table as handed in; None if its shape is wrong (faults go to the reader)."""
    before = len(reader.faults)
    convention = reader.choice("convention", Convention)
    angle_unit = reader.choice("angle_unit", AngleUnit, angle_unit)
    length_unit = reader.choice("length_unit", LengthUnit, length_unit)
    rows = tuple(_row(entry) for entry in reader.entries("rows"))
    if len(reader.faults) > before:
        return None
    return RawTable(convention=convention, rows=rows, angle_unit=angle_unit, length_unit=length_unit)


def read_samples(reader: Reader, reference: ReadTable) -> tuple[Sample, ...]:
    """Return the [[tests.samples]] of a definition."""
    samples: list[Sample] = []
    for i, entry in enumerate(reader.entries("samples")):
        name = entry.text("name", f"sample {i + 1}")
        expectation = entry.choice("expect", Expectation)
        feedback = entry.texts("feedback", default=())
        raw = read_raw_table(entry, reference.angle_unit, reference.length_unit)
        entry.finish()
        if raw is not None:
            correct = None if expectation is Expectation.INVALID else expectation is Expectation.CORRECT
            samples.append(Sample(name=name, table=raw, correct=correct, feedback=feedback))
    return tuple(samples)


def _row(reader: Reader) -> RawRow:
    joint = reader.choice("joint", JointType) if reader.given("joint") else None
    cells = {}
    for cell in CELLS:
        cells[cell] = reader.cell(cell)
    reader.finish()
    return RawRow(joint=joint, **cells)
