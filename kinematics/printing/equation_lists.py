"""Equations one after another: as text, LaTeX and trees, and as a function in programming languages."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

from kinematics.expressions import ZERO, Call, Expression, Function, walk
from kinematics.inverse_forms.formulas import rounding_of
from kinematics.printing.formats import EquationFormat
from kinematics.printing.latex import LatexWriter, parameter
from kinematics.printing.ledger import Ledger
from kinematics.printing.notation import Names, Notation, short_name
from kinematics.printing.program import Program, ProgramStep, Purpose, SourceAtoms
from kinematics.printing.text import TextWriter
from kinematics.printing.trees import TreeWriter
from kinematics.symbolic.interchange import SympyNodes

if TYPE_CHECKING:
    import sympy


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
        """Return an expression in the formats that are no source."""
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
        """Return what is defined, as it stands in text."""
        return self._names.variable(equation.joint) if equation.joint else equation.name

    def equation(self, equation: NamedValue, formats: Iterable[EquationFormat]) -> dict[str, Any]:
        """Return an equation: its name, and its value; in LaTeX the whole of it."""
        name = self.name(equation)
        written = {"name": name, **self.value(equation.value, formats)}
        if "latex" in written:
            written["latex"] = f"{parameter(name)}={written['latex']}"
        return written


VALUES = Purpose(
    name="inverse_kinematics",
    meaning="The joint variables of one branch, angles in radians; each sigma is 1 or -1.",
    result="joints",
)
MISFIT = Purpose(
    name="inverse_kinematics_misfit",
    meaning="All 0, but for rounding of the target, if the branch reaches it; each sigma is 1 or -1.",
    result="misfit",
)


def source_of(
    equations: Sequence[NamedValue],
    arguments: Sequence[str],
    results: Sequence[Expression],
    chosen: EquationFormat,
    purpose: Purpose = VALUES,
) -> str:
    """Return a function of the arguments that computes results from equations, in a programming language."""
    from kinematics.printing.languages import LANGUAGES  # this imports SymPy

    return LANGUAGES[chosen.value](_program(equations, tuple(arguments), results, purpose)).equations()


def _program(
    equations: Sequence[NamedValue],
    arguments: tuple[str, ...],
    results: Sequence[Expression],
    purpose: Purpose,
) -> Program:
    steps = _ProgramSteps()
    for name, joint, value in equations:
        steps.define(f"q:{joint:02}" if joint else f"p:{name}", f"q{joint}" if joint else name, value)
    entries = [[steps.converted(value)] for value in results]
    return Program(
        purpose=purpose,
        n_joints=0,
        parameters=arguments,
        variables=(),
        atoms=steps.atoms(),
        steps=steps.needed(entries),
        entries=entries,
    )


class _RoundedRoots(SympyNodes):
    """Converts roots so that what is negative by rounding alone counts as 0.

    Attributes:
        radicands: those found, each by the symbol that stands for it.
    """

    def __init__(self, atoms: "Callable[[Expression], sympy.Expr | None]") -> None:
        super().__init__(atoms=atoms)
        self.radicands: dict[str, sympy.Expr] = {}

    def _converted(self, node: Expression) -> "sympy.Expr":
        import sympy

        if not isinstance(node, Call) or node.function is not Function.SQRT:
            return super()._converted(node)
        rounding = rounding_of(node.arguments[0])
        if rounding == ZERO:
            return super()._converted(node)
        radicand = sympy.Symbol(f"t:{len(self.radicands) + 1}")
        self.radicands[radicand.name] = self.convert(node.arguments[0])
        least = sympy.Min(0, radicand + self.convert(rounding), evaluate=False)
        return sympy.sqrt(sympy.Max(radicand, least, evaluate=False))


class _ProgramSteps:
    """Equations as the steps of a program; sines, cosines and radicands before what first holds them."""

    def __init__(self) -> None:
        self._atoms = SourceAtoms(stepwise=True)
        self._nodes = _RoundedRoots(self._atoms.symbol)
        self._steps: list[ProgramStep] = []
        self._known: set[str] = set()

    def define(self, symbol: str, word: str, value: Expression) -> None:
        """Let a symbol stand for a value."""
        converted = self.converted(value)
        self._known.add(symbol)
        self._steps.append(ProgramStep(symbol, word, converted))

    def converted(self, value: Expression) -> "sympy.Expr":
        """Return a value in SymPy's nodes; new sines, cosines and radicands in it become steps."""
        import sympy

        found = self._nodes.convert(value)
        for symbol, node in self._atoms.circular.items():
            if symbol not in self._known:
                self._known.add(symbol)
                short = short_name(node)
                function = getattr(sympy, Function(node.function).value)
                self._steps.append(
                    ProgramStep(
                        symbol, short.word if short else "", function(self._nodes.convert(node.arguments[0]))
                    )
                )
        for symbol, radicand in self._nodes.radicands.items():
            if symbol not in self._known:
                self._known.add(symbol)
                self._steps.append(ProgramStep(symbol, "", radicand))
        return found

    def atoms(self) -> dict[str, Expression]:
        """Return what the symbols stand for that no step defines."""
        return {symbol: node for symbol, node in self._atoms.known.items() if symbol not in self._known}

    def needed(self, entries: "Sequence[Sequence[sympy.Expr]]") -> list[ProgramStep]:
        """Return the steps that entries rest on."""
        used = {symbol.name for row in entries for entry in row for symbol in entry.free_symbols}
        kept: list[ProgramStep] = []
        for step in reversed(self._steps):
            if step.symbol in used:
                used |= {symbol.name for symbol in step.value.free_symbols}
                kept.append(step)
        return kept[::-1]


def symbols_of(names: Names, expressions: Iterable[Expression]) -> dict[str, str]:
    """Return what the short names in some expressions stand for: c23 for cos(q2 + q3)."""
    writer = TextWriter(replace(names, notation=Notation.FULL))
    found = {}
    for expression in expressions:
        for node in walk(expression):
            short = names.short(node)
            if short is not None:
                found[short.plain] = writer.text(node)
    return dict(sorted(found.items()))
