"""Closed forms: every printed robot, links as defined, products against numbers, J0 and Jn in two ways."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kinematics import catalogue
from kinematics.expressions import (
    Call,
    Function,
    JointVariable,
    Parameter,
    call,
    evaluate,
    multiply,
    number,
    power,
)
from kinematics.jacobian import JacobianFrame
from kinematics.printing.notation import Names, Notation
from kinematics.printing.text import TextWriter
from kinematics.scm import (
    closed_form_scm,
    derivative,
    forward_kinematics_scm,
    inverse_closed_form_scm,
    jacobian_by_differentiation,
    jacobian_by_inspection,
    jacobian_closed_form_scm,
    jacobian_numbers_by_differentiation,
)
from kinematics.scm.products import jacobian_of_product
from kinematics.symbolic import count_operations, same_function
from tests.conftest import EXPLORE

from .chains import STANFORD, chain_of, loose_chains

ROBOTS = pytest.mark.parametrize("robot_id", catalogue.robot_ids())
DEAR = () if EXPLORE else ("panda", "iiwa14")
"""Two of four arms of seven joints, which take as long as all others."""
FRAMES = pytest.mark.parametrize("frame", list(JacobianFrame))


def numbers_of(matrix, parameters, q):
    return np.array([[evaluate(entry, parameters, q) for entry in row] for row in matrix])


def printed(matrix):
    writer = TextWriter(Names(notation=Notation.SHORT))
    return [[writer.text(entry) for entry in row] for row in matrix]


@ROBOTS
def test_closed_forms_of_the_printed_robots(robot_id):
    chain = catalogue.robot(robot_id).chain.read
    lengths = {name: 0.3 + 0.2 * i for i, name in enumerate(chain.parameters)}
    q = [0.4 + 0.3 * i * (-1) ** i for i in range(chain.chain.n_joints)]
    form = closed_form_scm(chain.chain)
    motion = forward_kinematics_scm(chain.chain, q, lengths)
    np.testing.assert_allclose(numbers_of(form.transform, lengths, q), motion.transform, atol=1e-13)
    np.testing.assert_allclose(numbers_of(form.end, lengths, q), motion.end, atol=1e-13)
    for matrices, expected in ((form.links, motion.links), (form.frames, motion.frames)):
        for matrix, pose in zip(matrices, expected, strict=True):
            np.testing.assert_allclose(numbers_of(matrix, lengths, q), pose, atol=1e-13)
    back = numbers_of(inverse_closed_form_scm(chain.chain), lengths, q)
    np.testing.assert_allclose(back @ motion.transform, np.eye(4), atol=1e-13)


@ROBOTS
@FRAMES
def test_inspection_and_differentiation_give_the_same_functions(robot_id, frame):
    """Eq. 3.22 and 3.23 against eq. 3.24: not at sample points, but proved equal entry by entry.

    With seven joints the angular rows take minutes to prove: there the linear ones are, and of those in the
    end's frame, a second or more each, the first of one arm.
    """
    chain = catalogue.robot(robot_id).chain.read.chain
    in_end = 1 if robot_id == "gen3" else 0
    inspected = jacobian_closed_form_scm(chain, frame)
    differentiated = jacobian_by_differentiation(closed_form_scm(chain).transform, chain.n_joints, frame)
    linear = slice(0, in_end if frame is JacobianFrame.END and not EXPLORE else 3)
    proved = linear if chain.n_joints > 6 else slice(0, 6)
    for row, other in zip(inspected[proved], differentiated[proved], strict=True):
        for entry, derived in zip(row, other, strict=True):
            assert same_function(entry, derived)


@pytest.mark.parametrize("robot_id", [name for name in catalogue.robot_ids() if name not in DEAR])
def test_what_differentiation_leaves_is_as_short_as_what_inspection_writes(robot_id):
    """J0: before s² + c² is 1, an angular entry of six joints has hundreds of operations."""
    chain = catalogue.robot(robot_id).chain.read
    lengths = {name: 0.3 + 0.2 * i for i, name in enumerate(chain.parameters)}
    q = [0.4 + 0.3 * i * (-1) ** i for i in range(chain.chain.n_joints)]
    inspected = jacobian_closed_form_scm(chain.chain)
    transform = closed_form_scm(chain.chain).transform
    differentiated = jacobian_of_product(transform, chain.chain.n_joints, JacobianFrame.BASE)
    expected = numbers_of(inspected, lengths, q)
    np.testing.assert_allclose(numbers_of(differentiated, lengths, q), expected, atol=1e-13)
    written = [count_operations([entry for row in J for entry in row]) for J in (differentiated, inspected)]
    assert written[0] <= written[1]


@settings(max_examples=50 if EXPLORE else 10)
@given(chain=loose_chains(), random=st.randoms(use_true_random=False))
def test_all_ways_to_a_jacobian_agree_for_any_chain(chain, random):
    numbers = {name: random.uniform(-1, 1) for name in chain.parameters}
    q = [random.uniform(-3, 3) for _ in chain.chain.rows]
    transform = closed_form_scm(chain.chain).transform
    for frame in JacobianFrame:
        expected = jacobian_by_inspection(chain.chain, q, numbers, frame)
        symbolic = numbers_of(jacobian_closed_form_scm(chain.chain, frame), numbers, q)
        derived = numbers_of(jacobian_by_differentiation(transform, len(q), frame), numbers, q)
        differentiated = jacobian_numbers_by_differentiation(chain.chain, q, numbers, frame)
        np.testing.assert_allclose(differentiated, expected, atol=1e-11)
        np.testing.assert_allclose(symbolic, expected, atol=1e-11)
        np.testing.assert_allclose(derived, expected, atol=1e-11)


def test_stanford_as_the_document_has_it():
    """Seed 001 eq. 3.1: each link one elementary rotation and translation; the unit vectors of eq. 3.21."""
    chain = chain_of(*STANFORD).chain
    links = [printed(matrix) for matrix in closed_form_scm(chain).links]
    assert [" ".join(row) for row in links[0][:3]] == ["c1 -s1 0 0", "s1 c1 0 0", "0 0 1 L0"]
    assert [" ".join(row) for row in links[1][:3]] == ["c2 0 s2 0", "0 1 0 L1", "-s2 0 c2 0"]
    assert [" ".join(row) for row in links[2][:3]] == ["1 0 0 0", "0 1 0 0", "0 0 1 q3"]
    no_lengths = dict.fromkeys(("L0", "L1", "L2"), 0.0)
    at_zero = numbers_of(jacobian_closed_form_scm(chain), no_lengths, [0.0] * 6)
    expected = np.array([[0, 0, 1], [0, 1, 0], [0, 0, 0], [0, 0, 1], [0, 1, 0], [0, 0, 1]]).T
    np.testing.assert_allclose(at_zero[3:], expected, atol=1e-15)


def test_short_notation_of_the_planar_arm():
    """SCZIP: s and c of a sum of joint angles."""
    form = closed_form_scm(catalogue.robot("twolink").chain.read.chain)
    assert printed(form.transform)[:2] == [
        ["c12", "-s12", "0", "L1*c1 + L2*c12"],
        ["s12", "c12", "0", "L1*s1 + L2*s12"],
    ]


def test_derivative_of_a_power_and_of_what_no_transform_holds():
    q1 = JointVariable(1)
    twice = call(Function.SIN, multiply((number(2), q1)))
    assert same_function(derivative(power(call(Function.COS, q1), 2), 1), multiply((number(-1), twice)))
    with pytest.raises(ValueError, match="no derivative"):
        derivative(Call(Function.TAN, (q1,)), 1)
    assert evaluate(derivative(Parameter("L1"), 1)) == 0.0
