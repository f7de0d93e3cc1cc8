"""Every robot of the catalogue in every format."""

import re

import pytest

from kinematics.catalogue import robots
from kinematics.errors import FormSizeError
from kinematics.expressions import number, pi_times
from kinematics.printing import Format, MatrixPrinter, Notation, Purpose
from kinematics.symbolic import closed_form, inverse, jacobian
from kinematics.table import Convention, table_parameters
from tests.conftest import EXPLORE
from tests.kinematics.symbolic.tables import row, table

READ = (Format.LATEX, Format.MATHML, Format.TEXT, Format.ENTRIES)
FORMATS = {Notation.FULL: tuple(Format), Notation.SHORT: READ}
"""Programs and trees are the same in either notation."""


def test_only_what_people_read_depends_on_the_notation() -> None:
    form = closed_form(table(Convention.STANDARD, row(a=number("0.5")), row(a=number("0.3")))).transform
    purpose = Purpose(name="f", meaning="A matrix.")
    full, short = (
        MatrixPrinter(n_joints=2, parameters=(), notation=notation).write(form, Format, purpose)
        for notation in (Notation.FULL, Notation.SHORT)
    )
    assert {Format(name) for name in full if full[name] != short[name]} == set(READ)


@pytest.mark.parametrize("robot", robots(), ids=lambda robot: robot.id)
@pytest.mark.parametrize("notation", FORMATS)
def test_every_robot_in_every_format(robot: object, notation: Notation) -> None:
    symbolic = robot.table.table  # type: ignore[attr-defined]
    printer = MatrixPrinter(
        n_joints=symbolic.n_joints, parameters=table_parameters(symbolic), notation=notation
    )
    form = closed_form(symbolic)
    frames = form.frames if EXPLORE else ()
    for matrix in (form.transform, *form.links, *frames, inverse(symbolic), jacobian(symbolic)):
        written = printer.write(matrix, FORMATS[notation], Purpose(name="f", meaning="A matrix."))
        assert set(written) == {chosen.value for chosen in FORMATS[notation]}
        text = repr(written)
        assert "1.0*" not in text
        assert "0.0*" not in text
        assert not re.search(r"--(?! )", text.replace("---", ""))  # "-- " begins a comment in some languages
        assert "+ -" not in text


def test_what_is_too_large_to_read_is_refused_but_still_computed() -> None:
    rows = [row(alpha=number(f"0.{i + 11}"), a=number(f"0.{i + 1}")) for i in range(16)]
    transform = closed_form(table(Convention.STANDARD, *rows)).transform
    printer = MatrixPrinter(n_joints=16, parameters=())
    purpose = Purpose(name="f", meaning="A matrix.")
    for chosen in (Format.LATEX, Format.MATHML, Format.TEXT, Format.JSON):
        with pytest.raises(FormSizeError) as refused:
            printer.write(transform, (chosen,), purpose)
        assert refused.value.code == "closed_form_too_large"
    assert len(printer.write(transform, (Format.C,), purpose)["c"]) < 100_000


def test_the_legend_names_what_is_abbreviated() -> None:
    symbolic = table(Convention.STANDARD, row(a=number(1), alpha=number(0)), row(a=number(1), sign=-1))
    printer = MatrixPrinter(n_joints=2, parameters=(), notation=Notation.SHORT)
    assert printer.symbols([closed_form(symbolic).transform]) == {
        "c1": "cos(q1)",
        "c1-2": "cos(q1 - q2)",
        "s1": "sin(q1)",
        "s1-2": "sin(q1 - q2)",
    }


def test_the_legend_has_the_names_of_every_format_when_joints_have_two_digits() -> None:
    rows = [row(a=number(1), alpha=pi_times(i % 2)) for i in range(10)]
    symbolic = table(Convention.STANDARD, row(a=number(1)), *rows)
    printer = MatrixPrinter(n_joints=11, parameters=(), notation=Notation.SHORT)
    matrix = closed_form(symbolic).frames[1]
    written = printer.write(matrix, (Format.TEXT, Format.LATEX), Purpose(name="f", meaning="."))
    legend = printer.symbols([matrix])
    assert written["text"][0][0] == "c1_2"
    assert "c_{1,2}" in written["latex"]
    assert legend["c1_2"] == legend["c1,2"] == "cos(q1 + q2)"
