"""All matrices of a table together: the same whatever is asked first, and each as a person writes it."""

import random

import pytest

from kinematics.catalogue import robots
from kinematics.expressions import Parameter, pi_times
from kinematics.jacobian import JacobianFrame
from kinematics.printing.notation import Names, Notation
from kinematics.printing.text import TextWriter
from kinematics.symbolic import Matrix, Workings, closed_form, count_operations, inverse, jacobian
from kinematics.table import Convention, SymbolicTable
from tests.kinematics.symbolic.tables import HALF, puma, random_table, row, table

RIGHT = pi_times(HALF)


def robot(name: str) -> SymbolicTable:
    return next(robot.table.table for robot in robots() if robot.id == name)


def text(matrix: Matrix) -> list[list[str]]:
    writer = TextWriter(Names(notation=Notation.SHORT))
    return [[writer.text(entry) for entry in line] for line in matrix]


def operations(matrix: Matrix) -> int:
    return count_operations(entry for line in matrix for entry in line)


@pytest.mark.parametrize("seed", range(20))
def test_no_matrix_depends_on_which_was_asked_for_before(seed: int) -> None:
    symbolic = random_table(random.Random(seed), 4, fixed=seed % 2)
    forward, backward = Workings(symbolic), Workings(symbolic)
    asked = [
        lambda w: w.links,
        lambda w: w.frames,
        lambda w: w.inverse,
        lambda w: w.jacobian(JacobianFrame.BASE),
        lambda w: w.jacobian(JacobianFrame.END),
        lambda w: w.transform,
    ]
    first = [ask(forward) for ask in asked]
    last = [ask(backward) for ask in reversed(asked)][::-1]
    assert first == last
    form = closed_form(symbolic)
    alone = [form.links, form.frames, inverse(symbolic), jacobian(symbolic)]
    assert first[:4] == alone


def test_the_jacobian_in_the_end_frame_is_carried_outward() -> None:
    """Nothing is left in it that a person would strike out: c4·s5·(L2 - L3·c5 + L3·c5)."""
    assert text(jacobian(robot("cloos"), JacobianFrame.END))[2][:3] == [
        "s4*s5*(L1*c2 - L2*sin(q2 - q3))",
        "-c4*s5*(L1*s3 + L2) - L1*c3*c5",
        "L2*c4*s5",
    ]
    assert text(jacobian(puma(Convention.STANDARD), JacobianFrame.END))[2][:3] == [
        "-s5*(d3*c23*c4 + s4*(a2*c2 + a3*c23 - d4*s23)) - d3*s23*c5",
        "c5*(a2*c3 + a3) - c4*s5*(a2*s3 - d4)",
        "d4*c4*s5 + a3*c5",
    ]


@pytest.mark.parametrize(
    ("name", "most"), [("cloos", 318), ("dmra", 357), ("puma560", 328), ("ssrms", 567), ("stanford", 241)]
)
def test_the_jacobian_in_the_end_frame_has_few_operations(name: str, most: int) -> None:
    assert operations(jacobian(robot(name), JacobianFrame.END)) <= most


def test_a_sum_begins_with_a_plus_and_with_what_moves() -> None:
    written = text(closed_form(robot("ssrms")).transform)
    assert written[0][3].endswith("s1*(a4*s3 + a5*s34 + d1*s345*c6 + d2*c345 - d2)")
    assert text(closed_form(robot("kr100p")).transform)[0][2] == "c1*(c23*c5 - s23*c4*s5) - s1*s4*s5"
    twisted = table(Convention.STANDARD, row(alpha=RIGHT), row(alpha=Parameter("beta")), row())
    assert text(closed_form(twisted).transform)[0][0] == "c1*(c2*c3 - cos(beta)*s2*s3) + sin(beta)*s1*s3"
