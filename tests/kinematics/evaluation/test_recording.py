"""Recording and replaying: whatever is done to symbols, the tape does to numbers."""

import dis
import math
from types import CodeType

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kinematics.evaluation.blocks import BLOCK, run_blocks
from kinematics.evaluation.plan import Computation, Quantity
from kinematics.evaluation.recurrences import base_jacobian, end_pose, motions_of_table
from kinematics.evaluation.straight_line import straight_line
from kinematics.evaluation.tape import Operator, Recorder
from kinematics.table import JointType
from tests.kinematics.robots import PLANAR4, PUMA560, SCARA_RRPR
from tests.kinematics.strategies import tables

N = 3
SLIDES = (JointType.PRISMATIC,) * N

constants = st.sampled_from((0.0, -0.0, 1.0, -1.0, 0.5, -2.0, 3.0, 2.0))


def _node(parts):
    operator, left, right = parts
    return {
        "+": lambda q: left(q) + right(q),
        "-": lambda q: left(q) - right(q),
        "*": lambda q: left(q) * right(q),
        "n": lambda q: -left(q),
    }[operator]


programs = st.recursive(
    st.integers(0, N - 1).map(lambda i: lambda q: q[i]) | constants.map(lambda c: lambda q: c),
    lambda inner: st.tuples(st.sampled_from("+-*n"), inner, inner).map(_node),
    max_leaves=12,
)


@given(st.lists(programs, min_size=1, max_size=5), st.lists(st.integers(-4, 4), min_size=N, max_size=N))
def test_a_tape_does_what_was_done_to_its_symbols(program, numbers):
    """Small integers and halves: every way of computing is exact, so the results must be equal."""
    recorder = Recorder(2 * N)
    tape = recorder.tape([one(recorder.inputs[:N]) for one in program])
    joints = [float(x) for x in numbers]
    expected = [one(joints) for one in program]
    straight = straight_line(tape, SLIDES, (len(program),))(joints)
    assert straight.tolist() == expected
    out = np.empty((2, len(program)))
    run_blocks(tape, SLIDES, np.array([joints, joints[::-1]]), out)
    assert out.tolist() == [expected, [one(joints[::-1]) for one in program]]
    assert not np.signbit(out[out == 0]).any()
    assert not np.signbit(straight[straight == 0]).any() or 0.0 not in joints


def test_what_is_not_needed_is_not_computed():
    recorder = Recorder(4)
    a, b, c, d = recorder.inputs
    _ = a * b * c
    kept = (a - b) * (c + d)
    assert kept is not None
    assert len(recorder.tape([kept, 0.0, a]).operations) == 3


def test_what_is_known_is_not_computed_again():
    recorder = Recorder(2)
    a, b = recorder.inputs
    tape = recorder.tape([a * b, b * a, -a * b, (a - b) * 0.0, (b - a) + (a - b)])
    assert [operation.operator for operation in tape.operations] == [Operator.MULTIPLY, Operator.SUBTRACT]


def test_zero_and_one_cost_nothing_and_register_zero_is_not_the_number_zero():
    recorder = Recorder(2)
    a, b = recorder.inputs
    tape = recorder.tape([a * 1.0, a + 0.0, b * -1.0, a - b, a - 1.0, 1.0 - b])
    out = np.empty((1, 6))
    run_blocks(tape, (JointType.PRISMATIC,), np.array([[7.0]]), out)
    sine = math.sin(7.0)
    np.testing.assert_allclose(out[0], [7.0, 7.0, -sine, 7.0 - sine, 6.0, 1.0 - sine], atol=1e-15)


@pytest.mark.parametrize(("table", "most"), [(PUMA560, 71), (SCARA_RRPR, 22), (PLANAR4, 42)])
def test_the_end_pose_takes_few_operations(table, most):
    """A yardstick against silent losses: the PUMA's product of six 4×4 matrices would take 560."""
    assert len(Computation(motions_of_table(table), Quantity.POSE)._tape.operations) <= most


def test_registers_share_buffers():
    """A hundred registers of a PUMA Jacobian fit into the cache."""
    from kinematics.evaluation.blocks import _layout

    tape = Computation(motions_of_table(PUMA560), Quantity.BASE_JACOBIAN)._tape
    assert _layout(tape).n_buffers < 60 < tape.n_inputs + len(tape.operations)


@settings(max_examples=30)
@given(tables(max_rows=5))
def test_functions_are_made_of_arithmetic_alone(table):
    """No name but those of the namespace, no attribute, no import, no text of the table."""
    computation = Computation(motions_of_table(table), Quantity.POSE)
    function = straight_line(computation._tape, table.joint_types, computation.shape)
    assert function.__globals__["__builtins__"] == {}
    names = {"cos", "sin", "ordinary", "exact", "tidy", "empty", "shape", "pack_into"}
    assert set(function.__globals__) == names | {"__builtins__"}
    code = function.__code__
    assert set(code.co_names) <= names
    assert not any(isinstance(constant, str | CodeType) for constant in code.co_consts[1:])
    forbidden = {"LOAD_ATTR", "LOAD_METHOD", "IMPORT_NAME", "STORE_GLOBAL", "MAKE_FUNCTION", "STORE_ATTR"}
    assert not forbidden & {instruction.opname for instruction in dis.get_instructions(code)}


def test_deep_computations_can_be_compiled():
    """Sixty-four rows: the longest table that the service takes."""
    long = type(PUMA560)(convention=PUMA560.convention, rows=PUMA560.rows * 10 + PUMA560.rows[:4])
    joints = np.random.default_rng(64).uniform(-3, 3, long.n_joints)
    for quantity in Quantity:
        computation = Computation(motions_of_table(long), quantity)
        walked = computation.once(joints.tolist())
        straight = straight_line(computation._tape, long.joint_types, computation.shape)(joints.tolist())
        np.testing.assert_allclose(straight, walked, rtol=0, atol=1e-12)
        np.testing.assert_allclose(computation.many(joints[None])[0], walked, rtol=0, atol=1e-12)


def test_walking_and_replaying_agree_to_the_last_bit():
    """So that an answer does not change when a table has been asked for often enough to be recorded."""
    for table in (PUMA560, SCARA_RRPR, PLANAR4):
        chain = motions_of_table(table)
        for joints in np.random.default_rng(1).uniform(-3, 3, (20, table.n_joints)).tolist():
            for quantity in Quantity:
                computation = Computation(chain, quantity)
                walked = computation.once(joints)
                straight = straight_line(computation._tape, table.joint_types, computation.shape)(joints)
                assert straight.tobytes() == walked.tobytes()


def test_any_kind_of_number_will_do():
    """The recurrences on fractions: exact poses of exact configurations."""
    from fractions import Fraction

    three, four = Fraction(3, 5), Fraction(4, 5)
    chain = motions_of_table(PLANAR4)
    values = [(three, four)] * 4
    r0, r1, _ = end_pose(chain, values)
    turned = complex(0.6, 0.8) ** 4
    assert abs(complex(float(r0[0]), float(r1[0])) - turned) < 1e-15
    assert r0[0] ** 2 + r1[0] ** 2 == 1
    assert len(base_jacobian(chain, values)) == 4


@pytest.mark.parametrize("size", [1, BLOCK - 1, BLOCK, BLOCK + 1, 2 * BLOCK])
def test_blocks_meet_without_a_gap(size):
    recorder = Recorder(2)
    tape = recorder.tape([recorder.inputs[0] * 2.0, 1.0])
    joints = np.arange(float(size))[:, None]
    out = np.full((size, 2), np.nan)
    run_blocks(tape, (JointType.PRISMATIC,), joints, out)
    assert np.array_equal(out[:, 0], 2.0 * joints[:, 0])
    assert (out[:, 1] == 1.0).all()
