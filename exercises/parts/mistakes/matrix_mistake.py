"""Find the mistake in a matrix: planted in that of a row, or in ⁰T_N; find it, name it, mend it.

The table is given, so the right matrix is one function of the joint variables, in whatever form it is
written. A wrong entry is every one that differs from it; a name is right if doing that gives the matrix that
is shown.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Annotated, ClassVar

import numpy as np

from exercises.definition import Exercise
from exercises.draws import Picker
from exercises.instance import Instance
from exercises.parts.cells.matrix_cells import CellMatrix, read_known_matrix, write_matrix
from exercises.parts.cells.symbolic_matrix import SymbolicMatrix
from exercises.parts.context import Context
from exercises.parts.given_table import given_table
from exercises.parts.mistakes.found_mistakes import FoundStep, MistakePart, MistakeType, MistakeWords
from exercises.parts.mistakes.planted_matrices import (
    MATRIX_MISTAKES,
    MatrixKind,
    PlantedMatrix,
    differing,
    plantable_in,
)
from exercises.parts.mistakes.planting import read_mistakes
from exercises.parts.protocol import Length, Reading, RobotFacts
from exercises.parts.report import PartReport
from exercises.parts.task import FieldShape, FormField, GivenNumbers, PartTask, choice_field
from exercises.reading import KeyShape, Reader
from kinematics.answers.left_open import EXACT, left_open
from kinematics.cells import Cell
from kinematics.expressions import parameters_in
from kinematics.expressions.arrays import values_at
from kinematics.symbolic import Matrix

FourCells = Annotated[tuple[Cell, ...], Length(least=4, most=4)]
FourRows = Annotated[tuple[FourCells, ...], Length(least=4, most=4)]


@dataclass(frozen=True, kw_only=True, slots=True)
class FoundMatrixMistakeCells:
    """Where a mistake stands in a matrix, what it is, and the matrix as it should be.

    Attributes:
        cell_row: row of a wrong entry, from 1.
        cell_column: its column, from 1.
        mistake: the mistake, a code of the catalogue.
        mended_matrix: the 4×4 matrix as it should be, in the variables of the table.
    """

    cell_row: int | str | None = None
    cell_column: int | str | None = None
    mistake: str | None = None
    mended_matrix: FourRows | None = None


@dataclass(frozen=True, kw_only=True, slots=True)
class FoundMatrixMistake:
    """A mistake that was found: its row and column count from 0."""

    cell: tuple[int, int] | None
    mistake: str | None
    mended: SymbolicMatrix | None


@dataclass(frozen=True, kw_only=True, slots=True)
class MatrixMistakePart(MistakePart):
    """A matrix with a planted mistake.

    Attributes:
        matrix: which one.
    """

    matrix: MatrixKind


class MatrixMistakeType(MistakeType[MatrixMistakePart, FoundMatrixMistakeCells, FoundMatrixMistake]):
    """Find the mistake in a matrix."""

    kind = "matrix_mistake"
    raw: ClassVar = FoundMatrixMistakeCells
    meaning = "the planted mistake in a matrix: a wrong entry, its name, and the matrix as it should be"
    words: ClassVar = MistakeWords(
        "matrix_mistake_place_wrong",
        "matrix_mistake_name_wrong",
        "matrix_not_mended",
        "matrix_mistake_missing",
    )
    disclosures: ClassVar = words.told()
    fields: ClassVar = ("cell_row", "mistake", "mended_matrix")
    catalogue: ClassVar = tuple(dict.fromkeys(code for codes in MATRIX_MISTAKES.values() for code in codes))

    def define(self, reader: Reader, points: Fraction, robot: RobotFacts) -> MatrixMistakePart:
        """Return the part with the matrix and the mistakes that may be planted."""
        kind = reader.choice("matrix", MatrixKind, MatrixKind.LINK)
        reader.note("mistakes", KeyShape.CHOICES, options=self.catalogue)
        mistakes = read_mistakes(reader, MATRIX_MISTAKES[kind])
        return MatrixMistakePart(kind=self.kind, points=points, matrix=kind, mistakes=mistakes)

    def can_be_planted(self, part: MatrixMistakePart, exercise: Exercise) -> bool:
        """Return whether one of the mistakes changes a matrix of the key."""
        return any(plantable_in(exercise.reference.table, part.matrix, code) for code in part.mistakes)

    def draw(self, part: MatrixMistakePart, exercise: Exercise, picker: Picker) -> PlantedMatrix:
        """Return the student's matrix."""
        table = exercise.reference.table
        harmful = {code: plantable_in(table, part.matrix, code) for code in part.mistakes}
        code = picker.choice(tuple(code for code, ways in harmful.items() if ways), f"{self.kind} mistake")
        return picker.choice(harmful[code], f"{self.kind} place")

    def task(self, part: MatrixMistakePart, instance: Instance) -> PartTask:
        """Show the table and the matrix."""
        found: PlantedMatrix = instance.drawn[self.kind]
        shown = GivenNumbers(
            name="matrix-with-mistake",
            labels=(),
            rows=tuple(tuple(str(cell) for cell in row) for row in _written(instance, found.shown)),
            values={"matrix": part.matrix.value, "row": (found.link or 0) + 1},
        )
        return PartTask(
            message="task-matrix-mistake",
            values={"matrix": part.matrix.value, "row": (found.link or 0) + 1},
            form=(
                choice_field("cell_row", ("1", "2", "3")),
                choice_field("cell_column", ("1", "2", "3", "4")),
                self.name_field(MATRIX_MISTAKES[part.matrix]),
                FormField(name="mended_matrix", shape=FieldShape.MATRIX, labels=("",) * 4, rows=4),
            ),
            numbers=(given_table(instance), shown),
        )

    def read(self, raw: FoundMatrixMistakeCells, reading: Reading) -> FoundMatrixMistake | None:
        """Return the answer with the mended matrix."""
        if self.is_empty(raw, reading):
            return None
        row = self.number(raw.cell_row, "cell_row", range(1, 4), reading, "row_unknown")
        column = self.number(raw.cell_column, "cell_column", range(1, 5), reading, "column_unknown")
        mistake = self.known_name(raw.mistake, reading, sorted(self.catalogue))
        mended = None
        if raw.mended_matrix is not None and any(cell != "" for cells in raw.mended_matrix for cell in cells):
            mended = read_known_matrix(raw.mended_matrix, reading, "mended_matrix")
        if reading.faults:
            return None
        cell = None if row is None or column is None else (row - 1, column - 1)
        return FoundMatrixMistake(cell=cell, mistake=mistake, mended=mended)

    def grade(self, part: MatrixMistakePart, answer: FoundMatrixMistake, context: Context) -> PartReport:
        """Grade place, name and repair, a third each; a repair that works shows a place not given."""
        found: PlantedMatrix = context.instance.drawn[self.kind]
        table = context.reference.table
        mended = answer.mended is not None and _is_right(found, answer.mended, context)
        name = answer.mistake
        return self.report(
            part,
            FoundStep(mended if answer.cell is None else answer.cell in found.wrong_cells, answer.cell),
            FoundStep(name is not None and found.shows(name, table), name),
            FoundStep(mended, answer.mended),
        )

    def right(self, part: MatrixMistakePart, context: Context) -> FoundMatrixMistakeCells:
        """Return a wrong entry, the planted mistake, and the right matrix."""
        found: PlantedMatrix = context.instance.drawn[self.kind]
        row, column = min(found.wrong_cells)
        return FoundMatrixMistakeCells(
            cell_row=row + 1,
            cell_column=column + 1,
            mistake=found.code,
            mended_matrix=_rows(_written(context.instance, found.right)),
        )

    def left_as_shown(self, right: FoundMatrixMistakeCells, instance: Instance) -> FoundMatrixMistakeCells:
        """Return the matrix as it was."""
        found: PlantedMatrix = instance.drawn[self.kind]
        return replace(right, mended_matrix=_rows(_written(instance, found.shown)))


def _written(instance: Instance, matrix: Matrix) -> CellMatrix:
    reference = instance.exercise.reference
    return write_matrix(matrix, reference.table.n_joints, tuple(reference.parameters))


def _rows(cells: Sequence[Sequence[Cell]]) -> FourRows:
    return tuple(tuple(row) for row in cells)


def _is_right(found: PlantedMatrix, mended: SymbolicMatrix, context: Context) -> bool:
    """Return whether a matrix is the right one: the same functions, or in numbers at the student's values."""
    other = differing(mended.entries, found.right)
    if not other:
        return True
    nominal = context.values(mended.names())
    # what is named holds for every value of the name, what is a number at the student's values
    moved = {name: value * (1.1 + 0.07 * i) for i, (name, value) in enumerate(sorted(nominal.items()))}
    joints = context.configurations(context.reference.table.joint_types).T
    tolerance = context.policy.tolerance
    for r, c in other:
        names = parameters_in(mended.entries[r][c])
        values = {name: moved[name] if name in names else value for name, value in nominal.items()}
        given, right = (values_at(of[r][c], values, joints) for of in (mended.entries, found.right))
        limit = tolerance.length * context.size if c == 3 and r < 3 else tolerance.angle
        at = {name: np.full(joints.shape[1], value) for name, value in values.items()}
        typed = EXACT * context.size + left_open(mended.entries[r][c], mended.rounded, at, joints)
        if not bool((np.abs(given - right) <= np.minimum(limit, typed)).all()):
            return False
    return True


PART = MatrixMistakeType()
