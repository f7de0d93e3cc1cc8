"""A programming language: a printer of SymPy's that knows the names in one function."""

import re
from abc import abstractmethod
from collections.abc import Callable, Iterable
from typing import Any, ClassVar, NamedTuple

import sympy
from sympy.printing.printer import Printer

from kinematics.expressions import Expression, Function, JointVariable, Number, Parameter
from kinematics.printing.numbers import decimal_text
from kinematics.printing.program import Program

IDENTIFIER = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_PLAIN = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
_FOREIGN = re.compile(r"[^A-Za-z0-9_]")


class EquationTemplate(NamedTuple):
    """What stands around equations in a language, with the names that `Language.equations` fills in.

    Attributes:
        opening: the lines before.
        closing: the lines after.
        argument: one argument of the function.
        unused: a line for an argument that no equation holds, in a language whose compilers warn of it.
    """

    opening: str
    step: str
    closing: str
    argument: str = "{}"
    unused: str = ""


class Language(Printer):
    """A printer of SymPy's that knows the names in one function; mixed in before the printer's class.

    Attributes:
        settings: the printer's.
        words: what no identifier may be, besides the printer's own reserved words.
        decimal: how a decimal is written, given its digits.
        tiny: the same of one with a power of ten, given both.
        variable: a joint variable, given its number.
        first: the number of the first joint variable, row and column.
        suffix: what is appended to a name that is taken.
        template: a function of equations, where the language is offered for them.
        fold: what makes two names one, in a language that takes no notice of case.
    """

    settings: ClassVar[dict[str, Any]] = {}
    words: ClassVar[str] = ""
    decimal: ClassVar[str] = "{}"
    tiny: ClassVar[str] = "{}e{}"
    pi: ClassVar[str] = "pi"
    variable: ClassVar[str] = "q[{}]"
    first: ClassVar[int] = 0
    suffix: ClassVar[str] = "_"
    template: ClassVar[EquationTemplate | None] = None
    fold: ClassVar[Callable[[str], str]] = str

    def __init__(self, program: Program) -> None:
        super().__init__(dict(self.settings))  # printers take entries out of it
        self.program, self.purpose = program, program.purpose
        self.taken = {type(self).fold(word) for word in self._reserved()}
        self.function = self.take(program.purpose.name)
        self.taken |= {"q", *map(type(self).fold, program.variables)}
        self.arguments = {name: self.take(name) for name in program.parameters}
        self.names: dict[str, str] = {}
        for symbol, node in program.atoms.items():
            self.names[symbol] = self._atom(node)
        counter = 0
        for symbol, word, _ in program.steps:
            if not word:
                counter += 1
            self.names[symbol] = self.take(word or f"t{counter}")
        self.result = self.take(program.purpose.result)
        self.shape = len(program.entries), len(program.entries[0])

    def _reserved(self) -> Iterable[str]:
        return [*self.words.split(), *Function, *getattr(self, "reserved_words", ())]

    def take(self, wanted: str) -> str:
        """Return the wanted name, or one like it that nothing else has."""
        name = self.identifier(wanted)
        while type(self).fold(name) in self.taken:
            name += self.suffix
        self.taken.add(type(self).fold(name))
        return name

    def identifier(self, wanted: str) -> str:
        """Return a name made of letters, digits and underscores, a letter first."""
        name = wanted if _PLAIN.fullmatch(wanted) else _FOREIGN.sub("_", wanted)
        return name if name[:1].isalpha() else f"p{name}"

    def _atom(self, node: Expression) -> str:
        match node:
            case Parameter(name):
                return self.arguments[name]
            case JointVariable(index):
                return self.variable.format(index - 1 + self.first)
            case Number(value):
                digits, _, power = str(decimal_text(value)).partition("e")
                return self.tiny.format(digits, power) if power else self.decimal.format(digits)
        return self.pi

    def _print_Symbol(self, symbol: sympy.Symbol) -> str:
        return self.names[symbol.name]

    def comments(self, prefix: str = "") -> list[str]:
        """Return what a reader must know: the joint variables, and parameters that had to be renamed."""
        lines = [self.purpose.meaning]
        if self.program.n_joints:
            lines.append(f"q: the {self._variables()}. All angles are in radians.")
        return [prefix + line for line in [*lines, *self._renamed()]]

    def _renamed(self) -> list[str]:
        changed = [(old, new) for old, new in self.arguments.items() if new != old]
        renamed = [f"{new} is {old}" for old, new in changed if IDENTIFIER.fullmatch(old)]
        return [f"Renamed: {', '.join(renamed)}."] if renamed else []

    def unused(self, lines: Iterable[str], *others: str) -> list[str]:
        """Return the arguments, and other names, that some lines of code do not hold."""
        written = set(IDENTIFIER.findall(" ".join(lines)))
        return [name for name in (*self.arguments.values(), *others) if name not in written]

    def imports(self) -> list[str]:
        """Return what the function needs before it, known once everything is written."""
        return []

    def wrong_length(self) -> str:
        """Return what is said when q does not have one element for each joint."""
        return f"q holds {self._variables()}"

    def _variables(self) -> str:
        n = self.program.n_joints
        return f"{n} joint variable{'' if n == 1 else 's'}"

    def signature(self, argument: str = "{}") -> str:
        """Return the arguments after q."""
        return "".join(f", {argument.format(name)}" for name in self.arguments.values())

    def steps(self, step: str) -> list[str]:
        """Return the assignments of what is computed first, by a format of name and value."""
        return [
            step.format(self.names[symbol], self._print(value)) for symbol, _, value in self.program.steps
        ]

    def rows(self) -> list[list[str]]:
        """Return the entries, written."""
        return [[self._print(entry) for entry in row] for row in self.program.entries]

    def listed(self, row: str, *, between: str = ",", last: str = ",") -> list[str]:
        """Return the rows as one nested literal, by a format of a row."""
        rows = [row.format(", ".join(entries)) for entries in self.rows()]
        return [line + (last if i == len(rows) else between) for i, line in enumerate(rows, 1)]

    def assigned(self, entry: str) -> list[str]:
        """Return the assignments of the entries, by a format of row, column and value."""
        return [
            entry.format(i, j, value)
            for i, row in enumerate(self.rows(), self.first)
            for j, value in enumerate(row, self.first)
        ]

    def source(self) -> str:
        """Return the source of the function."""
        return "\n".join([*self._lines(), ""])

    def equations(self) -> str:
        """Return the source of a function of the arguments alone that returns the first column."""
        template = self.template
        assert template is not None
        steps = self.steps(template.step)
        column = [row[0] for row in self.rows()]
        words = {
            "imports": "".join(f"{line}\n" for line in self.imports()),
            "function": self.function,
            "arguments": self.signature(template.argument).removeprefix(", "),
            "meaning": " ".join([self.purpose.meaning, *self._renamed()]),
            "result": self.result,
            "count": len(column),
            "entries": ", ".join(column),
            "assigned": "\n".join(f"    {self.result}[{i}] = {entry};" for i, entry in enumerate(column)),
        }
        unused = self.unused([*steps, *column]) if template.unused else []
        opening = [template.opening.format(**words), *map(template.unused.format, unused)]
        return "\n".join([*opening, *steps, template.closing.format(**words), ""])

    @abstractmethod
    def _lines(self) -> list[str]:
        """The lines of the source."""


class NamedExtremes(Printer):
    """For languages in which SymPy's printer has no name for the larger or smaller of two numbers."""

    extremes: ClassVar[tuple[str, str]] = ("max", "min")

    def _print_Max(self, expr: sympy.Max) -> str:
        return f"{self.extremes[0]}({', '.join(map(self._print, expr.args))})"

    def _print_Min(self, expr: sympy.Min) -> str:
        return f"{self.extremes[1]}({', '.join(map(self._print, expr.args))})"
