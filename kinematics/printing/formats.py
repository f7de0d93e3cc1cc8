"""One matrix in every format."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from enum import StrEnum
from typing import Any, TypeAlias

from kinematics.errors import Fault, FormSizeError
from kinematics.expressions import Expression
from kinematics.printing.code import write_function
from kinematics.printing.latex import LatexWriter
from kinematics.printing.mathml import MathmlWriter
from kinematics.printing.notation import Names, Notation
from kinematics.printing.program import Plan, Purpose, plan
from kinematics.printing.text import text_writer
from kinematics.printing.trees import to_tree
from kinematics.symbolic.size import bottom_up, count_operations

Matrix: TypeAlias = Sequence[Sequence[Expression]]

LIMIT = 50_000
"""Operations that a matrix may have when it is written out."""


class Format(StrEnum):
    """What a matrix can be written as.

    latex and mathml are one string for the matrix; text is a list of rows of infix strings, json one of
    expression trees; the others are the source of one function.
    """

    LATEX = "latex"
    MATHML = "mathml"
    TEXT = "text"
    JSON = "json"
    PYTHON = "python"
    NUMPY = "numpy"
    C = "c"
    MATLAB = "matlab"
    JAVASCRIPT = "javascript"


WRITTEN_OUT = (Format.LATEX, Format.MATHML, Format.TEXT, Format.JSON)
"""Formats in which nothing is abbreviated, so that their length grows with the number of operations."""


class MatrixPrinter:
    """Writes the matrices of one table; what they share is written once."""

    def __init__(
        self,
        *,
        n_joints: int,
        parameters: Sequence[str],
        notation: Notation = Notation.FULL,
        limit: int = LIMIT,
    ) -> None:
        self._n_joints = n_joints
        self._parameters = tuple(parameters)
        self._limit = limit
        self._names = Names(notation=notation, parameters=frozenset(parameters), separated=n_joints > 9)
        self._latex = LatexWriter(self._names)
        self._mathml = MathmlWriter(self._names)
        self._text = text_writer(self._names)
        self._full_text = text_writer(Names())
        self._symbols: dict[str, str] = {}
        self._writers: dict[Format, Callable[[Matrix], Any]] = {
            Format.LATEX: self._latex.matrix,
            Format.MATHML: self._mathml.matrix,
            Format.TEXT: lambda matrix: [[self._text.text(entry) for entry in row] for row in matrix],
            Format.JSON: lambda matrix: [[to_tree(entry) for entry in row] for row in matrix],
        }

    def write(self, matrix: Matrix, formats: Iterable[Format], purpose: Purpose) -> dict[str, Any]:
        """The matrix in the wanted formats.

        Raises:
            FormSizeError: written out, it has more operations than the limit; as a function it may still do.
        """
        wanted = tuple(formats)
        if any(chosen in WRITTEN_OUT for chosen in wanted):
            self._refuse_large(matrix)
        computed = None if set(wanted) <= set(WRITTEN_OUT) else plan(matrix)
        return {chosen.value: self._write(matrix, computed, chosen, purpose) for chosen in wanted}

    def symbols(self, matrices: Iterable[Matrix]) -> dict[str, str]:
        """What the short names in some matrices stand for: c23 for cos(q2 + q3)."""
        entries = (entry for matrix in matrices for row in matrix for entry in row)
        found = {}
        for node in bottom_up(entries):
            name = self._names.short(node)
            if name is not None:
                found[name.plain] = self._full_text.text(node)
        return dict(sorted(found.items()))

    def _write(self, matrix: Matrix, computed: Plan | None, chosen: Format, purpose: Purpose) -> Any:
        if computed is None or chosen in WRITTEN_OUT:
            return self._writers[chosen](matrix)
        return write_function(
            chosen.value, computed, purpose, n_joints=self._n_joints, parameters=self._parameters
        )

    def _refuse_large(self, matrix: Matrix) -> None:
        operations = count_operations(entry for row in matrix for entry in row)
        if operations > self._limit:
            raise FormSizeError(
                Fault(
                    code="closed_form_too_large",
                    message=f"written out, a matrix has more than {self._limit} operations; ask for fewer "
                    "rows, or for a function (python, numpy, c, matlab, javascript), which shares what is "
                    "repeated",
                    params={"limit": self._limit},
                )
            )
