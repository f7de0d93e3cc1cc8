"""The programming languages that functions are written in.

A language is one class here and one member of `Format`; with a `template` for lists of equations it may also
be one of `EquationFormat`. All of them stand in this one file, however long it grows, so that they can be
compared. Importing it imports SymPy.
"""

import keyword
from typing import Any, ClassVar

import sympy
import sympy.tensor.tensor  # SymPy loads it at the first sum otherwise, in the midst of an answer
from sympy.printing import cxx
from sympy.printing.c import C99CodePrinter
from sympy.printing.fortran import FCodePrinter
from sympy.printing.jscode import JavascriptCodePrinter
from sympy.printing.julia import JuliaCodePrinter
from sympy.printing.mathematica import MCodePrinter
from sympy.printing.numpy import NumPyPrinter
from sympy.printing.octave import OctaveCodePrinter
from sympy.printing.pycode import PythonCodePrinter
from sympy.printing.rust import RustCodePrinter
from sympy.printing.str import StrPrinter

from kinematics.expressions import Expression, JointVariable
from kinematics.printing import words as reserved
from kinematics.printing.language import IDENTIFIER, EquationTemplate, Language, NamedExtremes


class Python(Language, PythonCodePrinter):
    """Python with the module math."""

    settings: ClassVar[dict[str, Any]] = {"fully_qualified_modules": False}
    words = " ".join([*keyword.kwlist, *keyword.softkwlist, "pi len max min ValueError"])
    template = EquationTemplate(
        '{imports}def {function}({arguments}):\n    """{meaning}"""', "    {} = {}", "    return [{entries}]"
    )

    def _lines(self) -> list[str]:
        steps, rows = self.steps("    {} = {}"), self.listed("        [{}]")
        lines = [f"def {self.function}(q{self.signature()}):", *self.docstring()]
        if self.program.n_joints:
            lines += [f"    if len(q) != {self.program.n_joints}:"]
            lines += [f'        raise ValueError("{self.wrong_length()}")']
        lines += [*steps, "    return [", *rows, "    ]"]
        return [*self.imports(), *lines]

    def imports(self) -> list[str]:
        """Return what is used of the module math."""
        used = set(self.module_imports["math"]) | ({"pi"} if "o:pi" in self.names else set())
        return [f"from math import {', '.join(sorted(used))}", "", ""] if used else []

    def docstring(self, *more: str) -> list[str]:
        """Return the comments as a docstring."""
        first, *rest = [*self.comments(), *more]
        if not rest:
            return [f'    """{first}"""']
        return [f'    """{first}', "", *(f"    {line}" for line in rest), '    """']


class Numpy(NamedExtremes, Python, NumPyPrinter):
    """Python with NumPy, for one configuration or a batch."""

    words = f"{Python.words} np float"
    variable = "q[..., {}]"
    pi = "np.pi"
    extremes = ("np.maximum", "np.minimum")
    template = EquationTemplate(
        'import numpy as np\n\n\ndef {function}({arguments}):\n    """{meaning}"""',
        "    {} = {}",
        "    return np.stack(np.broadcast_arrays({entries}), axis=-1)",
    )

    def _module_format(self, fqn: str, register: bool = True) -> str:
        return fqn.replace("numpy.", "np.")

    def _lines(self) -> list[str]:
        return [
            "import numpy as np",
            "",
            "",
            f"def {self.function}(q{self.signature()}):",
            *self.docstring("One configuration of shape (n,), or a batch (…, n)."),
            "    q = np.asarray(q, dtype=float)",
            f"    if q.shape[-1:] != ({self.program.n_joints},):",
            f'        raise ValueError("{self.wrong_length()}")',
            *self.steps("    {} = {}"),
            f"    {self.result} = np.empty(q.shape[:-1] + {self.shape})",
            *self.assigned(f"    {self.result}[..., {{}}, {{}}] = {{}}"),
            f"    return {self.result}",
        ]


class Sympy(Language, StrPrinter):
    """A script that makes a SymPy matrix, nested as it is read."""

    settings: ClassVar[dict[str, Any]] = {"sympy_integers": True, "order": "none"}
    words = f"{Python.words} Abs Matrix Rational S Symbol"
    decimal, tiny = 'Rational("{}")', 'Rational("{}e{}")'
    _uses: ClassVar[str] = "Abs Rational S acos asin atan atan2 cos pi sin sqrt tan"

    def _atom(self, node: Expression) -> str:
        if isinstance(node, JointVariable):
            return self.program.variables[node.index - 1]
        return super()._atom(node)

    def _lines(self) -> list[str]:
        matrix = self.listed("    [{}]")
        joints = self.program.variables
        symbols = {name: name for name in joints} | {new: old for old, new in self.arguments.items()}
        written = set(IDENTIFIER.findall(" ".join(matrix)))
        used = ["Matrix", *(["Symbol"] if symbols else []), *(written & set(self._uses.split()))]
        return [
            f"from sympy import {', '.join(sorted(used))}",
            "",
            *self.comments("# "),
            *(f"{new} = Symbol({old!r})" for new, old in symbols.items()),
            f"{self.function} = Matrix([",
            *matrix,
            "])",
        ]


class C(Language, C99CodePrinter):
    """C99; the matrix is the last argument."""

    settings: ClassVar[dict[str, Any]] = {"math_macros": {}}  # M_PI is no part of the standard
    words = f"{reserved.C} {reserved.CPP} {' '.join(cxx.reserved['C++17'])}"
    pi = "3.14159265358979323846"
    template = EquationTemplate(
        "#include <math.h>\n\n/* {meaning} */\nvoid {function}({arguments}, double {result}[{count}])\n{{",
        "    const double {} = {};",
        "{assigned}\n}}",
        "double {}",
        "    (void){};",
    )

    def _lines(self) -> list[str]:
        rows, columns = self.shape
        result = f"double {self.result}[{rows}][{columns}]" if columns else f"double *{self.result}"
        steps = self.steps("    const double {} = {};")
        entries = self.assigned(f"    {self.result}[{{}}][{{}}] = {{}};")
        return [
            "#include <math.h>",
            "",
            "/*",
            *self.comments(" * "),
            " */",
            f"void {self.function}(const double *q{self.signature('double {}')}, {result})",
            "{",
            *(f"    (void){name};" for name in self.unused([*steps, *entries], "q", self.result)),
            *steps,
            *entries,
            "}",
        ]


class Cpp(Language, cxx.CXX17CodePrinter):
    """C++17 without any library but the standard one."""

    settings = C.settings
    words = C.words
    pi = C.pi

    def _lines(self) -> list[str]:
        rows, columns = self.shape
        joints = f"[[maybe_unused]] const std::array<double, {self.program.n_joints}>& q"
        return [
            "#include <array>",
            "#include <cmath>",
            "",
            *self.comments("// "),
            f"inline std::array<std::array<double, {columns}>, {rows}> {self.function}("
            f"{joints}{self.signature('[[maybe_unused]] double {}')})",
            "{",
            *self.steps("    const double {} = {};"),
            "    return {{",
            *self.listed("        {{{{{}}}}}"),
            "    }};",
            "}",
        ]


class Matlab(Language, OctaveCodePrinter):
    """MATLAB and Octave."""

    words = reserved.MATLAB
    variable = "q({})"
    first = 1
    template = EquationTemplate(
        "function {result} = {function}({arguments})\n% {meaning}",
        "    {} = {};",
        "    {result} = [{entries}];\nend",
    )

    def _lines(self) -> list[str]:
        rows, columns = self.shape
        joints = self.program.n_joints
        check = f"assert(numel(q) == {joints}, '{self.wrong_length()}');"
        matrix = [f"{self.result} = [", *self.listed("    {}", between=";", last=""), "];"]
        return [
            f"function {self.result} = {self.function}(q{self.signature()})",
            *self.comments("% "),
            *([check] if joints else []),
            *self.steps("{} = {};"),
            *(matrix if columns else [f"{self.result} = zeros({rows}, 0);"]),
            "end",
        ]


class Javascript(Language, JavascriptCodePrinter):
    """JavaScript, a plain function."""

    words = reserved.JAVASCRIPT
    pi = "Math.PI"
    template = EquationTemplate(
        "// {meaning}\nexport function {function}({arguments}) {{",
        "  const {} = {};",
        "  return [{entries}];\n}}",
    )

    def _lines(self) -> list[str]:
        joints = self.program.n_joints
        check = f'  if (q.length !== {joints}) throw new RangeError("{self.wrong_length()}");'
        return [
            "/**",
            *self.comments(" * "),
            " */",
            f"function {self.function}(q{self.signature()}) {{",
            *([check] if joints else []),
            *self.steps("  const {} = {};"),
            "  return [",
            *self.listed("    [{}]"),
            "  ];",
            "}",
        ]


class Julia(NamedExtremes, Language, JuliaCodePrinter):
    """Julia."""

    # the printer calls atan2, which Julia 1.0 renamed
    settings: ClassVar[dict[str, Any]] = {"user_functions": {"atan2": "atan"}}
    words = reserved.JULIA
    first = 1
    template = EquationTemplate(
        "# {meaning}\nfunction {function}({arguments})", "    {} = {}", "    return [{entries}]\nend"
    )

    def _lines(self) -> list[str]:
        rows, columns = self.shape
        joints = self.program.n_joints
        return [
            '"""',
            *self.comments(),
            '"""',
            f"function {self.function}(q{self.signature()})",
            f'    length(q) == {joints} || throw(DimensionMismatch("{self.wrong_length()}"))',
            *self.steps("    {} = {}"),
            f"    {self.result} = zeros({rows}, {columns})",
            *self.assigned(f"    {self.result}[{{}}, {{}}] = {{}}"),
            f"    return {self.result}",
            "end",
        ]


class Rust(Language, RustCodePrinter):
    """Rust without any crate."""

    words = reserved.RUST
    decimal, tiny = "{}_f64", "{}e{}_f64"
    pi = "std::f64::consts::PI"

    def _lines(self) -> list[str]:
        rows, columns = self.shape
        return [
            *self.comments("/// "),
            "#[allow(non_snake_case, unused_variables)]",
            f"pub fn {self.function}(q: &[f64; {self.program.n_joints}]{self.signature('{}: f64')})"
            f" -> [[f64; {columns}]; {rows}] {{",
            *self.steps("    let {} = {};"),
            "    [",
            *self.listed("        [{}]"),
            "    ]",
            "}",
        ]

    # Where a factor is a number, the printer of SymPy 1.14 loses the parentheses of the others
    # (-1/3*s*x + y for -s*(x + y)/3), and it mixes integers with floating-point numbers.
    def _print_Mul(self, expr: sympy.Mul) -> str:
        return str(StrPrinter._print_Mul(self, expr))

    def _print_Add(self, expr: sympy.Add, order: str | None = None) -> str:
        return str(StrPrinter._print_Add(self, expr, order))

    def _print_Integer(self, expr: sympy.Integer, _type: bool = False) -> str:
        return f"{expr.p}.0_f64"

    def _print_Rational(self, expr: sympy.Rational) -> str:
        return f"{expr.p}.0_f64/{expr.q}.0_f64"

    def _print_caller_var(self, expr: sympy.Expr) -> str:
        return f"({self._print(expr)})"

    def _print_Pow(self, expr: sympy.Pow, rational: bool = False) -> str:
        base = self._print_caller_var(expr.base)
        if expr.exp == sympy.S.Half:
            return f"{base}.sqrt()"
        if expr.exp.is_integer:
            return f"{base}.powi({expr.exp.p})"
        return f"{base}.powf({self._print(expr.exp)})"


class Fortran(Language, FCodePrinter):
    """Fortran 2003, free form; the matrix is the last argument."""

    settings: ClassVar[dict[str, Any]] = {"source_format": "free", "standard": 2003}
    words = reserved.FORTRAN
    decimal, tiny = "{}d0", "{}d{}"
    pi = "3.14159265358979323846d0"
    variable = "q({})"
    first = 1
    fold = str.lower
    _WIDTH = 100

    def _lines(self) -> list[str]:
        rows, columns = self.shape
        real = "real(kind(1d0))"
        names = [self.names[symbol] for symbol, _, _ in self.program.steps]
        arguments = [f"q({self.program.n_joints})", *self.arguments.values()]
        lines = [
            *self.comments("! "),
            f"subroutine {self.function}(q{self.signature()}, {self.result})",
            "    implicit none",
            *(f"    {real}, intent(in) :: {name}" for name in arguments),
            f"    {real}, intent(out) :: {self.result}({rows}, {columns})",
            *(f"    {real} :: {name}" for name in names),
            *self.steps("    {} = {}"),
            *self.assigned(f"    {self.result}({{}}, {{}}) = {{}}"),
            f"end subroutine {self.function}",
        ]
        return [piece for line in lines for piece in self._wrapped(line)]

    def _wrapped(self, line: str) -> list[str]:
        if line.startswith("!"):
            return [line]
        pieces = [line[i : i + self._WIDTH] for i in range(0, len(line), self._WIDTH)]
        ends = [*["&"] * (len(pieces) - 1), ""]
        return [f"{'&' if i else ''}{piece}{ends[i]}" for i, piece in enumerate(pieces)]


class Mathematica(Language, MCodePrinter):
    """Mathematica and the Wolfram Language."""

    pi, tiny = "Pi", "{}*^{}"
    variable = "q[[{}]]"
    first = 1
    suffix = "0"

    def identifier(self, wanted: str) -> str:
        """Return a name without underscores, which make patterns, and unlike any built-in symbol."""
        first, *rest = super().identifier(wanted).split("_")
        name = first + "".join(word[:1].upper() + word[1:] for word in rest)
        return f"{name[0].lower()}{name[1:]}0" if name[0].isupper() and name.isalpha() else name

    def _lines(self) -> list[str]:
        steps = self.steps("  {} = {};")
        names = ", ".join(self.names[symbol] for symbol, _, _ in self.program.steps)
        return [
            *(f"(* {line} *)" for line in self.comments()),
            f"{self.function}[q_{self.signature('{}_')}] := Module[{{{names}}},",
            *steps,
            "  {",
            *self.listed("    {{{}}}", last=""),
            "  }",
            "]",
        ]


LANGUAGES: dict[str, type[Language]] = {
    language.__name__.lower(): language
    for language in (*(Python, Numpy, Sympy, C, Cpp, Matlab, Javascript, Julia, Rust, Fortran), Mathematica)
}
"""Languages by the names of their formats."""
