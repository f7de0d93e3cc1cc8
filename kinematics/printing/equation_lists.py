"""Equations one after another: as text, LaTeX and trees, and as a function in programming languages."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from enum import StrEnum
from typing import TYPE_CHECKING, Any, NamedTuple

from kinematics.expressions import Expression, Function, walk
from kinematics.printing.latex import LatexWriter, parameter
from kinematics.printing.ledger import Ledger
from kinematics.printing.notation import Names, Notation, short_name
from kinematics.printing.program import Program, ProgramStep, Purpose, SourceAtoms
from kinematics.printing.text import TextWriter
from kinematics.printing.trees import TreeWriter
from kinematics.symbolic.interchange import SympyNodes

if TYPE_CHECKING:
    from kinematics.printing.language import Language


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


class NamedValue(NamedTuple):
    """An equation: what is defined, and its value.

    Attributes:
        name: of an intermediate; of a joint variable nothing.
        joint: number of the joint whose variable it is, or 0.
        value: in what was defined before.
    """

    name: str
    joint: int
    value: Expression


class EquationPrinter:
    """Writes the equations of one solution."""

    def __init__(self, names: Names) -> None:
        ledger = Ledger()
        self._names = names
        self._text, self._latex = TextWriter(names, ledger), LatexWriter(names, ledger)
        self._trees = TreeWriter(names, ledger)

    def value(self, expression: Expression, formats: Iterable[EquationFormat]) -> dict[str, Any]:
        """An expression in the formats that are no source."""
        written: dict[str, Any] = {}
        for chosen in formats:
            if chosen is EquationFormat.TEXT:
                written["text"] = self._text.text(expression)
            elif chosen is EquationFormat.LATEX:
                written["latex"] = self._latex.text(expression)
            elif chosen is EquationFormat.JSON:
                written["json"] = self._trees.written(expression)
        return written

    def name(self, equation: NamedValue) -> str:
        """What is defined, as it stands in text."""
        return self._names.variable(equation.joint) if equation.joint else equation.name

    def equation(self, equation: NamedValue, formats: Iterable[EquationFormat]) -> dict[str, Any]:
        """An equation: its name, and its value; in LaTeX the whole of it."""
        name = self.name(equation)
        written = {"name": name, **self.value(equation.value, formats)}
        if "latex" in written:
            written["latex"] = f"{parameter(name)}={written['latex']}"
        return written


def source_of(
    equations: Sequence[NamedValue], arguments: Sequence[str], n_joints: int, chosen: EquationFormat
) -> str:
    """A function of the arguments that returns the joint variables, in a programming language."""
    from kinematics.printing.languages import LANGUAGES  # this imports SymPy

    language = LANGUAGES[chosen.value](_program(equations, tuple(arguments), n_joints))
    return "\n".join([*_SOURCES[chosen](language), ""])


def _program(equations: Sequence[NamedValue], arguments: tuple[str, ...], n_joints: int) -> Program:
    import sympy

    atoms = SourceAtoms(stepwise=True)
    nodes = SympyNodes(atoms=atoms.symbol, evaluate=True)
    steps: list[ProgramStep] = []
    known: set[str] = set()
    for name, joint, value in equations:
        converted = nodes.convert(value)
        for symbol, node in atoms.circular.items():
            if symbol not in known:
                known.add(symbol)
                short = short_name(node)
                function = getattr(sympy, Function(node.function).value)
                steps.append(
                    ProgramStep(
                        symbol, short.word if short else "", function(nodes.convert(node.arguments[0]))
                    )
                )
        symbol = f"q:{joint:02}" if joint else f"p:{name}"
        known.add(symbol)
        steps.append(ProgramStep(symbol, f"q{joint}" if joint else name, converted))
    entries = [[sympy.Symbol(f"q:{joint:02}")] for joint in range(1, n_joints + 1)]
    return Program(
        purpose=Purpose(
            name="inverse_kinematics",
            meaning="The joint variables of one branch, angles in radians; each sigma is 1 or -1.",
            result="joints",
        ),
        n_joints=0,
        parameters=arguments,
        variables=(),
        atoms={symbol: node for symbol, node in atoms.known.items() if symbol not in known},
        steps=steps,
        entries=entries,
    )


def _python(language: Language) -> list[str]:
    steps = language.steps("    {} = {}")
    used = set(language.module_imports["math"]) | ({"pi"} if "o:pi" in language.names else set())
    return [
        *([f"from math import {', '.join(sorted(used))}", "", ""] if used else []),
        f"def {language.function}({_arguments(language)}):",
        f'    """{language.purpose.meaning}"""',
        *steps,
        f"    return [{_joints(language)}]",
    ]


def _numpy(language: Language) -> list[str]:
    return [
        "import numpy as np",
        "",
        "",
        f"def {language.function}({_arguments(language)}):",
        f'    """{language.purpose.meaning}"""',
        *language.steps("    {} = {}"),
        f"    return np.stack(np.broadcast_arrays({_joints(language)}), axis=-1)",
    ]


def _c(language: Language) -> list[str]:
    arguments = _arguments(language, "double {}")
    return [
        "#include <math.h>",
        "",
        f"/* {language.purpose.meaning} */",
        f"void {language.function}({arguments}, double {language.result}[{len(language.rows())}])",
        "{",
        *language.steps("    const double {} = {};"),
        *(f"    {language.result}[{i}] = {row[0]};" for i, row in enumerate(language.rows())),
        "}",
    ]


def _matlab(language: Language) -> list[str]:
    return [
        f"function {language.result} = {language.function}({_arguments(language)})",
        f"% {language.purpose.meaning}",
        *language.steps("    {} = {};"),
        f"    {language.result} = [{_joints(language)}];",
        "end",
    ]


def _javascript(language: Language) -> list[str]:
    return [
        f"// {language.purpose.meaning}",
        f"export function {language.function}({_arguments(language)}) {{",
        *language.steps("  const {} = {};"),
        f"  return [{_joints(language)}];",
        "}",
    ]


def _julia(language: Language) -> list[str]:
    return [
        f"# {language.purpose.meaning}",
        f"function {language.function}({_arguments(language)})",
        *language.steps("    {} = {}"),
        f"    return [{_joints(language)}]",
        "end",
    ]


_SOURCES = {
    EquationFormat.PYTHON: _python,
    EquationFormat.NUMPY: _numpy,
    EquationFormat.C: _c,
    EquationFormat.MATLAB: _matlab,
    EquationFormat.JAVASCRIPT: _javascript,
    EquationFormat.JULIA: _julia,
}
SOURCE_FORMATS = frozenset(_SOURCES)
"""The formats that are source code."""


def _arguments(language: Language, argument: str = "{}") -> str:
    return language.signature(argument).removeprefix(", ")


def _joints(language: Language) -> str:
    return ", ".join(row[0] for row in language.rows())


def symbols_of(names: Names, expressions: Iterable[Expression]) -> dict[str, str]:
    """What the short names in some expressions stand for: c23 for cos(q2 + q3)."""
    writer = TextWriter(replace(names, notation=Notation.FULL))
    found = {}
    for expression in expressions:
        for node in walk(expression):
            short = names.short(node)
            if short is not None:
                found[short.plain] = writer.text(node)
    return dict(sorted(found.items()))
