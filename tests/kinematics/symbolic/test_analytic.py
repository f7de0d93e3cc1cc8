"""Rates of angles in closed form, against those in numbers."""

import numpy as np
import pytest

from kinematics import catalogue
from kinematics.chain import chain_of_table
from kinematics.expressions import MINUS_ONE, ONE, ZERO, evaluate
from kinematics.rates import analytic_jacobian
from kinematics.rotations.sequences import SEQUENCES, EulerSequence
from kinematics.symbolic.analytic import analytic_form
from kinematics.symbolic.exact_poses import exact_pose
from kinematics.table import bind


@pytest.mark.parametrize("sequence", SEQUENCES, ids=lambda found: f"{found.axes}-{found.turning}")
def test_the_analytic_form_is_the_analytic_jacobian_in_numbers(sequence: EulerSequence) -> None:
    """Both belong to the same one of the two triples that have the orientation."""
    listed = catalogue.robot("stanford")
    table, values = listed.table.table, dict(listed.parameters)
    form = analytic_form(table, sequence)
    assert form is not None
    chain = chain_of_table(bind(table, values))
    rng = np.random.default_rng(3)
    for _ in range(2):
        q = rng.uniform(-2, 2, 6).tolist()
        found = np.array([[evaluate(entry, values, q) for entry in row] for row in form])
        expected = analytic_jacobian(chain, q, sequence)
        assert expected is not None
        assert np.allclose(found, expected, rtol=1e-9, atol=1e-9)


def test_constants_are_written_as_such() -> None:
    """The first joint of an upright wrist turns the first angle, and no other."""
    table = catalogue.robot("stanford").table.table
    form = analytic_form(table, EulerSequence(axes="ZYZ"))
    assert form is not None
    assert [form[row][0] for row in (3, 4, 5)] == [ONE, ZERO, ZERO]
    assert MINUS_ONE not in (entry for row in form[3:] for entry in row)


def test_angles_that_are_always_locked_have_no_form() -> None:
    assert analytic_form(catalogue.robot("scara").table.table, EulerSequence(axes="ZYZ")) is None


def test_base_and_tool_are_those_of_the_chain() -> None:
    listed = catalogue.robot("stanford")
    table, values = listed.table.table, dict(listed.parameters)
    base = [[0, -1, 0, 0.1], [1, 0, 0, 0.2], [0, 0, 1, 0.3], [0, 0, 0, 1.0]]
    tool = [[0, 0, 1, 0.0], [0, 1, 0, 0.4], [-1, 0, 0, 0.1], [0, 0, 0, 1.0]]
    angles = EulerSequence(axes="ZYX")
    form = analytic_form(table, angles, base=exact_pose(base), tool=exact_pose(tool))
    assert form is not None
    q = [0.3, 0.7, 0.5, -0.4, 0.9, 0.2]
    found = np.array([[evaluate(entry, values, q) for entry in row] for row in form])
    expected = analytic_jacobian(
        chain_of_table(bind(table, values), np.array(base), np.array(tool)), q, angles
    )
    assert expected is not None
    assert np.allclose(found, expected, rtol=1e-9, atol=1e-9)
