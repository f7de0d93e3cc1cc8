"""Equations one after another: as text, LaTeX and trees, and as a function in programming languages."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from enum import StrEnum
from typing import Any, NamedTuple

from kinematics.expressions import Expression, Function, walk
from kinematics.printing.latex import LatexWriter, parameter
from kinematics.printing.ledger import Ledger
from kinematics.printing.notation import Names, Notation, short_name
from kinematics.printing.program import Program, ProgramStep, Purpose, SourceAtoms
from kinematics.printing.text import TextWriter
from kinematics.printing.trees import TreeWriter
from kinematics.symbolic.interchange import SympyNodes


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
    template = _TEMPLATES[chosen]
    steps = language.steps(template.step)
    rows = [row[0] for row in language.rows()]
    words = {
        "imports": "".join(f"{line}\n" for line in language.imports()),
        "function": language.function,
        "arguments": language.signature(template.argument).removeprefix(", "),
        "meaning": language.purpose.meaning,
        "result": language.result,
        "count": len(rows),
        "joints": ", ".join(rows),
        "assigned": "\n".join(f"    {language.result}[{i}] = {row};" for i, row in enumerate(rows)),
    }
    return "\n".join([template.opening.format(**words), *steps, template.closing.format(**words), ""])


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


class _Template(NamedTuple):
    """What stands around the equations in a language.

    Attributes:
        opening: the lines before.
        step: an equation.
        closing: the lines after.
        argument: one argument of the function.
    """

    opening: str
    step: str
    closing: str
    argument: str = "{}"


_TEMPLATES = {
    EquationFormat.PYTHON: _Template(
        '{imports}def {function}({arguments}):\n    """{meaning}"""', "    {} = {}", "    return [{joints}]"
    ),
    EquationFormat.NUMPY: _Template(
        'import numpy as np\n\n\ndef {function}({arguments}):\n    """{meaning}"""',
        "    {} = {}",
        "    return np.stack(np.broadcast_arrays({joints}), axis=-1)",
    ),
    EquationFormat.C: _Template(
        "#include <math.h>\n\n/* {meaning} */\nvoid {function}({arguments}, double {result}[{count}])\n{{",
        "    const double {} = {};",
        "{assigned}\n}}",
        "double {}",
    ),
    EquationFormat.MATLAB: _Template(
        "function {result} = {function}({arguments})\n% {meaning}",
        "    {} = {};",
        "    {result} = [{joints}];\nend",
    ),
    EquationFormat.JAVASCRIPT: _Template(
        "// {meaning}\nexport function {function}({arguments}) {{",
        "  const {} = {};",
        "  return [{joints}];\n}}",
    ),
    EquationFormat.JULIA: _Template(
        "# {meaning}\nfunction {function}({arguments})", "    {} = {}", "    return [{joints}]\nend"
    ),
}
SOURCE_FORMATS = frozenset(_TEMPLATES)
"""The formats that are source code."""


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
