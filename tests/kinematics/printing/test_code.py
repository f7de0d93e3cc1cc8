"""Functions in every language, run where its tool is installed, and held against the numeric core."""

import ctypes
import json
import random
import re
import shutil
import subprocess
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy
from sympy.parsing.mathematica import parse_mathematica

from kinematics.catalogue import robots
from kinematics.expressions import Function, Parameter, add, call, multiply, number, pi_times, power
from kinematics.forward import forward_kinematics
from kinematics.jacobian import JacobianFrame
from kinematics.jacobian import jacobian as numeric_jacobian
from kinematics.printing import Format, MatrixPrinter, Purpose
from kinematics.printing.languages import LANGUAGES
from kinematics.symbolic import closed_form, inverse, jacobian
from kinematics.table import Convention, JointType, SymbolicTable, bind, table_parameters
from tests.conftest import EXPLORE
from tests.kinematics.symbolic.tables import puma, random_table, row, table

CODE = tuple(Format(name) for name in LANGUAGES)

# Keywords, names of the libraries, macros, names that the writer itself uses, and names that differ from them
# by what is appended to avoid them.
_HOSTILE = """
lambda int for in end pi PI I E e i j q T J t1 c1 s1 c23 s23 sin cos sqrt math np len float double void
linux unix M_PI NAN gamma y0 y1 j0 struct let var new this eval arguments Math q_ c1_ t1_ lambda_ function
assert numel ans None True false null class async await yield return ValueError inf pow M_SQRT2
catch register concept co_await
"""
HOSTILE = _HOSTILE.split()


@dataclass(frozen=True)
class Case:
    """A matrix, the names of its arguments, values for them, and what must come out."""

    name: str
    table: SymbolicTable
    entries: Sequence[Sequence[Any]]
    parameters: tuple[str, ...]
    values: tuple[float, ...]
    joints: tuple[float, ...]
    expected: np.ndarray  # type: ignore[type-arg]

    def source(self, chosen: Format) -> str:
        printer = MatrixPrinter(n_joints=self.table.n_joints, parameters=self.parameters)
        purpose = Purpose(name=self.name, meaning="A matrix under test.")
        return str(printer.write(self.entries, (chosen,), purpose)[chosen.value])


def cases_of(name: str, symbolic: SymbolicTable, rng: random.Random) -> list[Case]:
    parameters = table_parameters(symbolic)
    values = tuple(rng.uniform(0.2, 1.5) for _ in parameters)
    joints = tuple(rng.uniform(-3, 3) for _ in range(symbolic.n_joints))
    numeric = bind(symbolic, dict(zip(parameters, values, strict=True)))
    forward = forward_kinematics(numeric, joints)
    form = closed_form(symbolic)
    wanted = {
        f"T_{name}": (form.transform, forward.transform),
        f"link_{name}": (form.links[-1], forward.links[-1]),
        f"inverse_{name}": (inverse(symbolic), np.linalg.inv(forward.transform)),
        f"J0_{name}": (jacobian(symbolic), numeric_jacobian(numeric, joints)),
        f"Jn_{name}": (
            jacobian(symbolic, JacobianFrame.END),
            numeric_jacobian(numeric, joints, JacobianFrame.END),
        ),
    }
    return [
        Case(key, symbolic, entries, parameters, values, joints, expected)
        for key, (entries, expected) in wanted.items()
    ]


def hostile_table() -> SymbolicTable:
    names = iter(HOSTILE)
    rows = [
        row(kind, a=Parameter(next(names)), alpha=pi_times(Fraction(1, 2)))
        for kind in (JointType.PRISMATIC, JointType.REVOLUTE, JointType.REVOLUTE) * 2
    ]
    rest = add(multiply((Parameter(name), number("0.01"))) for name in names)
    return table(Convention.STANDARD, *rows, row(JointType.FIXED, a=rest))


def every_construct() -> SymbolicTable:
    """Every function, power and kind of number that a cell can hold."""
    x, y = Parameter("x"), Parameter("y")
    lengths = [
        power(x, 2),
        power(add((x, y)), 3),
        power(x, -1),
        multiply((number("2/7"), power(add((x, y)), -2))),
        call(Function.SQRT, add((x, y))),
        power(x, Fraction(1, 3)),
        power(y, Fraction(-3, 2)),
        call(Function.ABS, add((x, number(-9)))),
        multiply((number("0.4318"), x)),
        multiply((number("-1/2"), call(Function.TAN, y))),
        multiply((pi_times(Fraction(2, 3)), x)),
        number("123456789.5"),
    ]
    angles = [
        call(Function.ATAN2, x, y),
        call(Function.ATAN, x),
        call(Function.ASIN, multiply((number("1/2"), x))),
        call(Function.ACOS, multiply((number("1/2"), y))),
        multiply((number("1/2"), y)),
        pi_times(Fraction(37, 180)),
        number("-0.3"),
        pi_times(Fraction(1, 12)),
        pi_times(Fraction(-5, 6)),
    ]
    rows = [
        row(a=length, d=lengths[-i], theta=angles[i % len(angles)], alpha=angles[-1 - i % len(angles)])
        for i, length in enumerate(lengths[:5])
    ]
    rows += [row(JointType.FIXED, a=length) for length in lengths]
    rows += [row(JointType.FIXED, alpha=angle, theta=angle) for angle in angles[:3]]
    return table(Convention.MODIFIED, *rows)


def tiny_numbers() -> SymbolicTable:
    """Numbers that are written with a power of ten, where they matter."""
    x, y = Parameter("x"), Parameter("y")
    angle = call(Function.ATAN2, add((multiply((number("2.5e-10"), x)), number("3e-11"))), number("7.5e-10"))
    return table(Convention.STANDARD, row(a=y, d=number("-1.3e-33"), theta=angle), row(alpha=angle))


@cache
def cases() -> list[Case]:
    rng = random.Random(7)
    found = []
    for robot in robots() if EXPLORE else robots()[::3]:
        found += cases_of(robot.id.replace("-", "_"), robot.table.table, rng)
    found += cases_of("puma_craig", puma(Convention.MODIFIED), rng)
    found += cases_of("hostile", hostile_table(), rng)
    found += cases_of("constructs", every_construct(), rng)
    found += cases_of("tiny", tiny_numbers(), rng)
    for i in range(12):
        found += cases_of(f"random{i}", random_table(rng, rng.randrange(1, 6), fixed=rng.randrange(3)), rng)
    return found


def assert_agrees(case: Case, computed: Any) -> None:
    scale = max(1.0, float(np.abs(case.expected).max()))
    computed = np.array(computed, dtype=float)
    np.testing.assert_allclose(computed, case.expected, rtol=0, atol=1e-12 * scale, err_msg=case.name)


def python_function(case: Case, chosen: Format) -> Callable[..., Any]:
    scope: dict[str, Any] = {}
    exec(compile(case.source(chosen), case.name, "exec"), scope)
    function: Callable[..., Any] = scope[case.name]
    return function


def test_python_computes_what_the_numeric_core_does() -> None:
    for case in cases():
        assert_agrees(case, python_function(case, Format.PYTHON)(case.joints, *case.values))


@pytest.mark.parametrize("function", [Function.SIN, Function.COS, Function.TAN])
def test_an_arctangent_of_two_lengths_may_have_both_of_them_zero(function: Function) -> None:
    L1, L2 = Parameter("L1"), Parameter("L2")
    turned = multiply((number(-1), call(Function.ATAN2, add((L1, L2)), L2)))
    one_row = table(Convention.STANDARD, row(theta=turned, d=add((L1, L2)), a=call(function, turned)))
    form = closed_form(one_row).transform
    case = Case("T_0_1", one_row, form, ("L1", "L2"), (0.0, 0.0), (0.5,), np.empty(0))
    expected = forward_kinematics(bind(one_row, {"L1": 0.0, "L2": 0.0}), case.joints).transform
    assert_agrees(replace(case, expected=expected), python_function(case, Format.PYTHON)([0.5], 0.0, 0.0))


def test_numpy_takes_one_configuration_or_a_batch() -> None:
    for case in cases():
        function = python_function(case, Format.NUMPY)
        assert_agrees(case, function(case.joints, *case.values))
        batch = np.tile(case.joints, (2, 3, 1))
        computed = function(batch, *case.values)
        assert computed.shape == (2, 3, *case.expected.shape)
        assert_agrees(case, computed[1, 2])


@pytest.mark.parametrize("chosen", [Format.PYTHON, Format.NUMPY])
@pytest.mark.parametrize(("n", "held"), [(1, "1 joint variable"), (2, "2 joint variables")])
def test_python_refuses_the_wrong_number_of_joints(chosen: Format, n: int, held: str) -> None:
    case = next(case for case in cases() if case.table.n_joints == n)
    assert f"q: the {held}." in case.source(chosen)
    with pytest.raises(ValueError, match=f"q holds {held}$"):
        python_function(case, chosen)([0.0] * 9, *case.values)


def tool(*names: str) -> str:
    """A compiler or interpreter; the test is skipped where it is not installed."""
    found = next(filter(None, map(shutil.which, names)), None)
    if found is None:
        pytest.skip(f"{names[0]} is not installed")
    return found


def output_of(*command: str | Path) -> str:
    return subprocess.run([*map(str, command)], check=True, capture_output=True, text=True).stdout


def assert_printed(printed: str) -> None:
    """One line for each case, row by row."""
    for case, line in zip(cases(), printed.splitlines(), strict=True):
        assert_agrees(case, np.array(line.split(), dtype=float).reshape(case.expected.shape))


def sources(chosen: Format) -> list[str]:
    return [case.source(chosen) for case in cases()]


def test_c_compiles_without_a_warning_and_agrees(tmp_path: Path) -> None:
    compiler, source, library = tool("gcc"), tmp_path / "all.c", tmp_path / "all.so"
    source.write_text("\n".join(sources(Format.C)))
    flags = ["-Wall", "-Wextra", "-Wshadow", "-pedantic", "-Werror", "-O0"]
    output_of(compiler, "-std=c99", *flags, "-fsyntax-only", source)
    output_of(compiler, "-std=gnu17", *flags, "-shared", "-fPIC", source, "-o", library, "-lm")
    loaded = ctypes.CDLL(str(library))
    for case in cases():
        joints = (ctypes.c_double * max(1, len(case.joints)))(*case.joints)
        result = (ctypes.c_double * case.expected.size)()
        getattr(loaded, case.name)(joints, *map(ctypes.c_double, case.values), result)
        assert_agrees(case, np.array(result).reshape(case.expected.shape))


def test_cpp_compiles_without_a_warning_and_agrees(tmp_path: Path) -> None:
    compiler, source, program = tool("g++"), tmp_path / "all.cpp", tmp_path / "all"
    calls = [
        "    for (const auto &row : {}({{{}}}{}))\n"
        '        for (double entry : row) std::printf("%.17g ", entry);\n'
        '    std::printf("\\n");'.format(
            case.name,
            "{" + ", ".join(map(repr, case.joints)) + "}",
            "".join(f", {value!r}" for value in case.values),
        )
        for case in cases()
    ]
    head = ["#include <cstdio>", *sources(Format.CPP)]
    source.write_text("\n".join([*head, "int main()", "{", *calls, "}"]))
    output_of(
        compiler, "-std=c++17", "-Wall", "-Wextra", "-pedantic", "-Werror", "-O0", source, "-o", program
    )
    assert_printed(output_of(program))


def test_fortran_compiles_and_agrees(tmp_path: Path) -> None:
    compiler, source, library = tool("gfortran"), tmp_path / "all.f90", tmp_path / "all.so"
    source.write_text("\n".join(sources(Format.FORTRAN)))
    output_of(
        compiler,
        "-std=f2003",
        "-Wall",
        "-Wno-unused-dummy-argument",
        "-O0",
        "-shared",
        "-fPIC",
        source,
        "-o",
        library,
    )
    loaded = ctypes.CDLL(str(library))
    for case in cases():
        joints = (ctypes.c_double * max(1, len(case.joints)))(*case.joints)
        result = (ctypes.c_double * case.expected.size)()
        values = [ctypes.byref(ctypes.c_double(value)) for value in case.values]
        getattr(loaded, f"{case.name.lower()}_")(joints, *values, result)
        assert_agrees(case, np.array(result).reshape(case.expected.shape, order="F"))


def test_rust_compiles_without_a_warning_and_agrees(tmp_path: Path) -> None:
    compiler, source, program = tool("rustc"), tmp_path / "all.rs", tmp_path / "all"
    calls = [
        '    for row in {}(&[{}]{}) {{ for entry in row {{ print!("{{:e}} ", entry); }} }}\n'
        "    println!();".format(
            case.name,
            ", ".join(f"{value!r}_f64" for value in case.joints),
            "".join(f", {value!r}_f64" for value in case.values),
        )
        for case in cases()
    ]
    source.write_text("\n".join([*sources(Format.RUST), "fn main() {", *calls, "}"]))
    allowed = ["-A", "unused_parens"]
    output_of(compiler, "--edition=2021", "-D", "warnings", *allowed, source, "-o", program)
    assert_printed(output_of(program))


def test_javascript_runs_under_node_and_agrees(tmp_path: Path) -> None:
    node, script = tool("node"), tmp_path / "all.js"
    program = ['"use strict";', *sources(Format.JAVASCRIPT), "const out = {};"]
    for case in cases():
        given = ", ".join(json.dumps(value) for value in (case.joints, *case.values))
        program.append(f"out[{case.name!r}] = {case.name}({given});")
    program.append("process.stdout.write(JSON.stringify(out));")
    script.write_text("\n".join(program))
    computed = json.loads(output_of(node, script))
    for case in cases():
        assert_agrees(case, computed[case.name])


def test_octave_agrees(tmp_path: Path) -> None:
    octave, path = tool("octave-cli", "octave"), tmp_path / "all_matrices.m"
    script = ["1;", *sources(Format.MATLAB)]
    for case in cases():
        given = ", ".join(["[" + ", ".join(map(repr, case.joints)) + "]", *map(repr, case.values)])
        script.append(f"printf('%.17g ', transpose({case.name}({given}))); printf('\\n');")
    path.write_text("\n".join(script))
    assert_printed(output_of(octave, path))


def test_julia_agrees(tmp_path: Path) -> None:
    julia, path = tool("julia"), tmp_path / "all.jl"
    script = sources(Format.JULIA)
    for case in cases():
        given = ", ".join(["Float64[" + ", ".join(map(repr, case.joints)) + "]", *map(repr, case.values)])
        script.append(f"println(join(permutedims({case.name}({given})), ' '))".replace("'", '"'))
    path.write_text("\n".join(script))
    assert_printed(output_of(julia, path))


def test_sympy_makes_the_matrix() -> None:
    written = [case for case in cases() if "constructs" not in case.name]  # those are too large to be read
    for case in written[::3]:
        scope: dict[str, Any] = {}
        exec(compile(case.source(Format.SYMPY), case.name, "exec"), scope)
        matrix = scope[case.name]
        names = [*(f"q{i}" for i in range(1, case.table.n_joints + 1)), *case.parameters]
        values = dict(zip(map(sympy.Symbol, names), (*case.joints, *case.values), strict=True))
        computed = [float(entry.evalf(20, subs=values)) for entry in matrix]
        assert_agrees(case, np.array(computed).reshape(case.expected.shape))


def test_mathematica_is_read_by_sympy_and_agrees() -> None:
    """No interpreter of the language is free to install; SymPy reads expressions of it."""
    for case in cases()[:40:5]:
        lines = case.source(Format.MATHEMATICA).splitlines()
        start = next(i for i, line in enumerate(lines) if "Module" in line)
        names = re.findall(r"(\w+)_[,\]]", lines[start])[1:]
        known = dict(zip(names, map(sympy.Float, case.values), strict=True))
        known |= {f"q{i}": sympy.Float(value) for i, value in enumerate(case.joints, 1)}

        def value(text: str, known: dict[str, Any] = known) -> float:
            parsed = parse_mathematica(re.sub(r"q\[\[(\d+)\]\]", r"q\1", text))
            return float(parsed.subs(known))

        for name, text in re.findall(r"^  (\w+) = (.*);$", "\n".join(lines), re.MULTILINE):
            known[name] = sympy.Float(value(text))
        rows = re.findall(r"^    \{(.*)\},?$", "\n".join(lines), re.MULTILINE)
        computed = [[value(entry) for entry in row.split(", ")] for row in rows if row]
        if computed and "ArcTan" not in "".join(rows):  # its two arguments are split by a comma
            assert_agrees(case, computed)


@pytest.mark.parametrize("chosen", CODE)
def test_a_name_can_neither_break_out_nor_collide(chosen: Format) -> None:
    """A library may hold names that the cell grammar would refuse; they still become plain identifiers."""
    evil = ["*/ system(0); /*", '"' * 3, "a\nb", '");', "τ", "%", "a b", "a_b", "1x", "_", "__import__('os')"]
    rows = [row(a=Parameter(name)) for name in evil]
    symbolic = table(Convention.STANDARD, *rows)
    printer = MatrixPrinter(n_joints=len(rows), parameters=tuple(evil))
    purpose = Purpose(name="f", meaning="Names.")
    source = printer.write(closed_form(symbolic).transform, (chosen,), purpose)[chosen.value]
    scope: dict[str, Any]
    if chosen is Format.SYMPY:  # names stand in literals there
        scope = {}
        exec(compile(source, "f", "exec"), scope)
        assert {symbol.name for symbol in scope["f"].free_symbols} == {
            *evil,
            *(f"q{i}" for i in range(1, 12)),
        }
        return
    assert not any(word in source for word in ("system(", "a b,", "τ", "import__(", " 1x,"))
    if chosen is Format.PYTHON:
        scope = {}
        exec(compile(source, "f", "exec"), scope)
        assert scope["f"]([0.0] * len(evil), *range(1, 1 + len(evil)))[0][3] == sum(range(1, 1 + len(evil)))


def test_c_takes_no_whole_number_for_an_integer() -> None:
    """1/2 is 0 in C; a rational number must never be written as a quotient of integers."""
    half = table(Convention.STANDARD, row(a=number("1/3")))
    printer = MatrixPrinter(n_joints=1, parameters=())
    source = printer.write(closed_form(half).transform, (Format.C,), Purpose(name="f", meaning="."))["c"]
    assert "(1.0/3.0)*c1" in source
