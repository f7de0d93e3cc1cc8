"""LaTeX: typeset as in a textbook, balanced, and safe for any name."""

import random
import re
import shutil
import subprocess
from fractions import Fraction
from pathlib import Path

import pytest

from kinematics.expressions import (
    Expression,
    Function,
    JointVariable,
    Parameter,
    add,
    call,
    multiply,
    negate,
    number,
    pi_times,
    power,
)
from kinematics.printing.latex import LatexWriter
from kinematics.printing.notation import Names, Notation
from kinematics.symbolic import closed_form
from kinematics.table import Convention
from tests.kinematics.symbolic.rewriting import random_expression
from tests.kinematics.symbolic.tables import puma

L1, ALPHA = Parameter("L1"), Parameter("alpha2")
q1, q2, q3 = map(JointVariable, (1, 2, 3))
KATEX = Path(__file__).resolve().parents[3] / "node_modules" / "katex" / "dist" / "katex.mjs"


def latex(expression: Expression, notation: Notation = Notation.SHORT) -> str:
    return LatexWriter(Names(notation=notation)).text(expression)


@pytest.mark.parametrize(
    ("expression", "written"),
    [
        (L1, "L_{1}"),
        (ALPHA, r"\alpha_{2}"),
        (Parameter("reach"), r"\mathrm{reach}"),
        (Parameter("L_x"), "L_{x}"),
        (Parameter("Omega"), r"\Omega"),
        (Parameter("Alpha"), r"\mathrm{Alpha}"),
        (Parameter("omicron"), r"\mathrm{omicron}"),
        (q1, "q_{1}"),
        (call(Function.COS, add((q2, q3))), "c_{23}"),
        (call(Function.SIN, add((q2, negate(q3)))), "s_{2-3}"),
        (call(Function.COS, add((q1, pi_times(Fraction(1, 4))))), r"\cos\left(q_{1}+\frac{\pi}{4}\right)"),
        (power(call(Function.COS, q1), 2), "c_{1}^{2}"),
        (multiply((number("1/2"), call(Function.SQRT, number(3)), L1)), r"\frac{\sqrt{3}}{2}L_{1}"),
        (multiply((number("-1/2"), L1)), r"-\frac{1}{2}L_{1}"),
        (multiply((number("-1.3e-33"), L1)), r"-1.3 \cdot 10^{-33}L_{1}"),
        (multiply((number("1/2"), L1, call(Function.COS, q1))), r"\frac{1}{2}L_{1}c_{1}"),
        (multiply((number("0.4318"), call(Function.COS, q1))), "0.4318c_{1}"),
        (pi_times(Fraction(37, 180)), r"\frac{37\pi}{180}"),
        (multiply((L1, power(add((L1, ALPHA)), -1))), r"\frac{L_{1}}{L_{1}+\alpha_{2}}"),
        (power(L1, Fraction(1, 3)), r"L_{1}^{1/3}"),
        (call(Function.ATAN2, L1, ALPHA), r"\operatorname{atan2}(L_{1}, \alpha_{2})"),
        (call(Function.ABS, L1), r"\left|L_{1}\right|"),
        (multiply((call(Function.COS, q1), add((L1, negate(ALPHA))))), r"c_{1}\left(L_{1}-\alpha_{2}\right)"),
        (
            multiply((power(number(2), Fraction(1, 3)), power(number(3), Fraction(1, 3)))),
            r"2^{1/3} \cdot 3^{1/3}",
        ),
    ],
)
def test_typesetting(expression: Expression, written: str) -> None:
    assert latex(expression) == written


def test_full_notation_has_parentheses_that_end_the_angle() -> None:
    factor = multiply((call(Function.COS, q1), add((L1, ALPHA))))
    assert latex(factor, Notation.FULL) == r"\cos(q_{1})\left(L_{1}+\alpha_{2}\right)"
    assert latex(power(call(Function.SIN, q1), 2), Notation.FULL) == r"\sin^{2}(q_{1})"


def test_a_matrix_is_a_bmatrix() -> None:
    writer = LatexWriter(Names(notation=Notation.SHORT))
    written = writer.table(writer.ledger.matrix(closed_form(puma(Convention.STANDARD)).transform))
    assert written.startswith("\\begin{bmatrix}\n")
    assert written.endswith("\n\\end{bmatrix}")
    assert written.count("\\\\\n") == 3
    assert written.count("&") == 12


@pytest.mark.parametrize("seed", range(60))
def test_braces_and_brackets_are_balanced(seed: int) -> None:
    written = latex(random_expression(random.Random(seed)))
    assert written.count("{") == written.count("}")
    assert written.count(r"\left(") == written.count(r"\right)")
    assert not re.search(r"\\[a-z]+[A-Za-z]*\\\\", written)


@pytest.mark.parametrize("name", [r"\input{x}", "a}{b", "x$y", "a^b", "x&y", "50%", "a#1", "L~1", "x\\\\y"])
def test_no_name_can_break_out(name: str) -> None:
    written = latex(Parameter(name))
    assert not re.search(r"(?<!\\)[$&#%^~]", written.replace("^{", "").replace("_{", ""))
    assert r"\input" not in written
    assert written.count("{") - written.count(r"\{") == written.count("}") - written.count(r"\}")


def test_katex_typesets_every_catalogue_robot(tmp_path: Path) -> None:
    from kinematics.catalogue import robots

    node = shutil.which("node")
    if node is None or not KATEX.exists():
        pytest.skip("no node, or KaTeX was not installed")
    shutil.copy(KATEX, tmp_path / "katex.mjs")
    sources = []
    for robot in robots():
        for notation in Notation:
            writer = LatexWriter(Names(notation=notation))
            sources.append(writer.table(writer.ledger.matrix(closed_form(robot.table.table).transform)))
    script = tmp_path / "typeset.mjs"
    lines = ['import katex from "./katex.mjs";']
    lines += [
        f"katex.renderToString({source!r}, {{throwOnError: true, strict: 'error'}});" for source in sources
    ]
    script.write_text("\n".join(lines))
    subprocess.run([node, str(script)], check=True, capture_output=True)
