"""One matrix in every format."""

from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import replace
from enum import StrEnum
from itertools import chain
from typing import Any, TypeAlias

from kinematics.errors import Fault, FormSizeError
from kinematics.expressions import Expression
from kinematics.printing.entries import entry_lines
from kinematics.printing.latex import LatexWriter
from kinematics.printing.ledger import Entered, Ledger
from kinematics.printing.mathml import MathmlWriter
from kinematics.printing.notation import Names, Notation
from kinematics.printing.program import Purpose, program
from kinematics.printing.text import TextWriter
from kinematics.printing.trees import TreeWriter

Matrix: TypeAlias = Sequence[Sequence[Expression]]

LIMIT = 50_000  # Operations that a matrix may have when it is written out.


class Format(StrEnum):
    """What a matrix can be written as.

    latex and mathml are one string for the matrix; text is a list of rows of infix strings, json one of
    expression trees; entries is a list of equations, named intermediates first; sympy is a script that makes
    the matrix, the others are the source of one function.
    """

    LATEX = "latex"
    MATHML = "mathml"
    TEXT = "text"
    JSON = "json"
    ENTRIES = "entries"
    PYTHON = "python"
    NUMPY = "numpy"
    C = "c"
    MATLAB = "matlab"
    JAVASCRIPT = "javascript"
    SYMPY = "sympy"
    CPP = "cpp"
    JULIA = "julia"
    RUST = "rust"
    FORTRAN = "fortran"
    MATHEMATICA = "mathematica"


class EquationFormat(StrEnum):
    """What a list of equations can be written as; the last are the source of one function."""

    LATEX = "latex"
    TEXT = "text"
    JSON = "json"
    PYTHON = "python"
    NUMPY = "numpy"
    C = "c"
    MATLAB = "matlab"
    JAVASCRIPT = "javascript"
    JULIA = "julia"

    @property
    def is_source(self) -> bool:
        """Whether it is the source of one function: its language has a `template` then."""
        return self.value in SOURCES


SOURCES = {
    Format.PYTHON: "a function of q and the parameters, with the module math",
    Format.NUMPY: "the same for one configuration or a batch",
    Format.C: "the same in C99; the matrix is the last argument",
    Format.MATLAB: "the same in MATLAB and Octave",
    Format.JAVASCRIPT: "the same in JavaScript",
    Format.SYMPY: "a script that makes a SymPy matrix, nested as it is read",
    Format.CPP: "the same in C++17",
    Format.JULIA: "the same in Julia",
    Format.RUST: "the same in Rust",
    Format.FORTRAN: "a subroutine in Fortran 2003; the matrix is the last argument",
    Format.MATHEMATICA: "the same in Mathematica",
}
"""The formats that are source code, and what it is."""


class MatrixPrinter:
    """Writes the matrices of one table; what they share is written once."""

    def __init__(
        self,
        *,
        n_joints: int,
        parameters: Sequence[str],
        variables: Sequence[str] = (),
        notation: Notation = Notation.FULL,
    ) -> None:
        self._names = Names(
            notation=notation,
            parameters=frozenset((*parameters, *variables)),
            separated=n_joints > 9,
            variables=tuple(variables),
        )
        self._ledger = Ledger()
        self._n_joints, self._parameters = n_joints, tuple(parameters)
        self._variables = tuple(map(self._names.variable, range(1, n_joints + 1)))
        self._answers: dict[Hashable, dict[str, Any]] = {}
        self._writers: dict[Format, Callable[[Entered], Any]] = {
            Format.LATEX: LatexWriter(self._names, self._ledger).table,
            Format.MATHML: MathmlWriter(self._names, self._ledger).table,
            Format.TEXT: TextWriter(self._names, self._ledger).lines,
            Format.JSON: TreeWriter(self._names, self._ledger).entries,
        }

    def write(self, matrix: Matrix, formats: Iterable[Format], purpose: Purpose) -> dict[str, Any]:
        """Return the matrix in the wanted formats.

        Raises:
            FormSizeError: written out, it has more operations than `LIMIT`; as a function it may still do.
        """
        wanted = tuple(formats)
        entered = self._ledger.matrix(matrix)
        question = (entered.rows, purpose, wanted)
        if question not in self._answers:
            self._answers[question] = self._written(matrix, entered, wanted, purpose)
        return self._answers[question]

    def symbols(self, matrices: Iterable[Matrix]) -> dict[str, str]:
        """Return what the short names in some matrices stand for: c23 for cos(q2 + q3).

        With ten joints or more there are two names for one thing: c2,3 is typeset, c2_3 stands in text.
        """
        ledger, found = self._ledger, {}
        nodes = ledger.under(ledger.numbers(chain.from_iterable(chain.from_iterable(matrices))))
        named = [(number, self._names.short(ledger.nodes[number])) for number in nodes]
        abbreviated = {number: name for number, name in named if name is not None}
        writer = TextWriter(replace(self._names, notation=Notation.FULL), ledger)
        texts = writer.lines(ledger.entered((tuple(abbreviated),)))[0]
        for name, text in zip(abbreviated.values(), texts, strict=True):
            found[name.plain] = text
            if name.is_sum:
                found[name.word] = text
        return dict(sorted(found.items()))

    def _written(
        self, matrix: Matrix, entered: Entered, wanted: Sequence[Format], purpose: Purpose
    ) -> dict[str, Any]:
        if not SOURCES.keys() - {Format.SYMPY} >= set(wanted):
            self._refuse_large(entered)
        sources = self._sources(matrix, [chosen for chosen in wanted if chosen in SOURCES], purpose)
        written: dict[str, Any] = {}
        for chosen in wanted:
            if chosen in sources:
                written[chosen.value] = sources[chosen]
            elif chosen is Format.ENTRIES:
                lines = entry_lines(entered, self._ledger, self._names, purpose.result)
                written[chosen.value] = [line._asdict() for line in lines]
            else:
                written[chosen.value] = self._writers[chosen](entered)
        return written

    def _sources(self, matrix: Matrix, wanted: Sequence[Format], purpose: Purpose) -> dict[Format, str]:
        if not wanted:
            return {}
        from kinematics.printing.languages import LANGUAGES  # this imports SymPy

        plans = {
            stepwise: program(
                matrix,
                purpose,
                n_joints=self._n_joints,
                parameters=self._parameters,
                variables=self._variables,
                stepwise=stepwise,
            )
            for stepwise in {chosen is not Format.SYMPY for chosen in wanted}
        }
        return {
            chosen: LANGUAGES[chosen.value](plans[chosen is not Format.SYMPY]).source() for chosen in wanted
        }

    def _refuse_large(self, matrix: Entered) -> None:
        if sum(self._ledger.operations[number] for number in chain.from_iterable(matrix.rows)) > LIMIT:
            raise FormSizeError(Fault.at("closed_form_too_large", limit=LIMIT))
