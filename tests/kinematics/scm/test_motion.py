"""Direct kinematics and Jacobians of chains, against elementary motions and finite differences."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.errors import JointValueError, ParameterError
from kinematics.jacobian import JacobianFrame
from kinematics.scm import (
    RawChain,
    check_values,
    closed_form_scm,
    forward_kinematics_scm,
    jacobian_by_inspection,
    read_chain,
    verify,
)
from kinematics.symbolic import same_function

from .chains import STANFORD, STANFORD_LENGTHS, chain_of, elementary, placement, product, strict_chains

SCARA_FORMS = [
    # Seed 001 eq. 3.6: the slider within the second arm, after it, and alone
    ((0, 0, "L0", "a1", 0, 0), ("L1", 0, 0, "-a2", 0, 0), ("L2", 0, "-d3", 0, 0, 0), (0, 0, 0, "-a4", 0, 0)),
    ((0, 0, "L0", "a1", 0, 0), ("L1", 0, 0, "-a2", 0, 0), (0, 0, "-d3", 0, 0, 0), ("L2", 0, 0, "-a4", 0, 0)),
    ((0, 0, "L0", "a1", 0, 0), ("L1", 0, 0, "-a2", 0, 0), ("L2", 0, 0, "-q3", 0, 0), (0, 0, "-q4", 0, 0, 0)),
]


def test_stanford_moves_as_the_document_multiplies_it_out():
    q = [0.3, -0.7, 0.4, 1.1, -0.2, 2.0]
    expected = np.eye(4)
    for i, (row, value) in enumerate(zip(STANFORD, q, strict=True), start=1):
        joint = "d3" if i == 3 else f"a{i}"
        expected = expected @ product(placement(*row), STANFORD_LENGTHS, joint, value)
    found = forward_kinematics_scm(chain_of(*STANFORD).chain, q, STANFORD_LENGTHS)
    np.testing.assert_allclose(found.transform, expected, atol=1e-15)
    np.testing.assert_allclose(found.frames[-1], np.linalg.multi_dot(found.links), atol=1e-15)


def test_three_scara_forms_are_one_robot():
    lengths = {"L0": 0.5, "L1": 0.3, "L2": 0.25, "L3": 0.1}
    end = (0, 0, "-L3", 0, 0, "pi")
    a1, a2, d3, a4 = 0.4, -1.2, 0.08, 2.5
    poses = [
        forward_kinematics_scm(chain_of(*form, final=end).chain, q, lengths).transform
        for form, q in zip(SCARA_FORMS, ([a1, a2, d3, a4], [a1, a2, d3, a4], [a1, a2, a4, d3]), strict=True)
    ]
    np.testing.assert_allclose(poses[1], poses[0], atol=1e-15)
    np.testing.assert_allclose(poses[2], poses[0], atol=1e-15)


def test_only_the_forms_with_the_slider_alone_pass_the_check():
    assert [len(verify(chain_of(*form).chain)) for form in SCARA_FORMS] == [1, 0, 0]


@given(strict_chains(), st.randoms(use_true_random=False))
def test_jacobians_by_inspection_are_the_derivative(chain, random):
    rows, final, tool = chain
    read = read_chain(RawChain(joints=tuple(rows), final=final, tool=tool))
    numbers = {name: random.uniform(-1, 1) for name in read.parameters}
    q = np.array([random.uniform(-3, 3) for _ in rows])
    _assert_jacobians(read.chain, q, numbers)


def test_jacobians_of_rows_that_also_turn_by_constants():
    chain = chain_of(
        (1, 2, 3, "q1", 0.4, -0.7), (0.1, 0.2, 0.3, 0.5, "-q2+1", 0.2), (1, "q3", 2, 0.3, 0.6, -1.1)
    ).chain
    assert verify(chain)
    _assert_jacobians(chain, np.array([0.3, -0.8, 0.5]), {})


def _assert_jacobians(chain, q, numbers):
    base, end = (jacobian_by_inspection(chain, q, numbers, frame) for frame in JacobianFrame)
    pose = forward_kinematics_scm(chain, q, numbers).transform
    step = 1e-6
    for i in range(len(q)):
        delta = np.zeros(len(q))
        delta[i] = step
        ahead = forward_kinematics_scm(chain, q + delta, numbers).transform
        behind = forward_kinematics_scm(chain, q - delta, numbers).transform
        derivative = (ahead - behind) / (2 * step)
        spin = derivative[:3, :3] @ pose[:3, :3].T
        numeric = [*derivative[:3, 3], spin[2, 1], spin[0, 2], spin[1, 0]]
        np.testing.assert_allclose(base[:, i], numeric, atol=1e-6)
    turn = np.kron(np.eye(2), pose[:3, :3])
    np.testing.assert_allclose(turn @ end, base, atol=1e-12)


def test_wrong_joint_values_and_parameters_are_refused():
    chain = chain_of(*STANFORD).chain
    with pytest.raises(JointValueError) as refusal:
        forward_kinematics_scm(chain, [0.0] * 5, STANFORD_LENGTHS)
    assert refusal.value.code == "joints_wrong_length"
    with pytest.raises(JointValueError) as refusal:
        forward_kinematics_scm(chain, [0.0] * 5 + [float("nan")], STANFORD_LENGTHS)
    assert (refusal.value.code, refusal.value.faults[0].where) == ("joint_not_finite", ("joints", 5))
    with pytest.raises(ParameterError) as missing:
        forward_kinematics_scm(chain, [0.0] * 6, {"L0": 1.0})
    assert missing.value.code == "parameter_missing"


def test_a_parameter_that_is_missing_in_several_places_is_told_once():
    chain = chain_of(("L1", "2*L1", "L2", "a1", 0, 0), ("L1", 0, 0, "a2", 0, 0)).chain
    with pytest.raises(ParameterError) as missing:
        check_values(chain, {})
    assert [fault.where for fault in missing.value.faults] == [("parameters", "L1"), ("parameters", "L2")]


def test_the_three_products_of_eq_3_6_are_equal():
    """As printed: frame 3 with X(L2) Z(-d3) A(-a4), with Z(-d3) X(L2) A(-a4), and split in two frames."""
    L0, L1, L2, L3 = 0.5, 0.3, 0.25, 0.1
    a1, a2, d3, a4 = 0.4, -1.2, 0.08, 2.5
    before = [("z", L0), ("a", a1), ("x", L1), ("a", -a2)]
    after = [("z", -L3), ("c", np.pi)]
    printed = [
        [("x", L2), ("z", -d3), ("a", -a4)],
        [("z", -d3), ("x", L2), ("a", -a4)],
        [("z", -d3), ("a", 0), ("b", 0), ("c", 0), ("x", L2), ("a", -a4)],
    ]
    poses = [
        np.linalg.multi_dot([elementary(*motion) for motion in (*before, *middle, *after)])
        for middle in printed
    ]
    chain = chain_of(*SCARA_FORMS[1], final=(0, 0, "-L3", 0, 0, "pi")).chain
    lengths = {"L0": L0, "L1": L1, "L2": L2, "L3": L3}
    expected = forward_kinematics_scm(chain, [a1, a2, d3, a4], lengths).transform
    for found in poses:
        np.testing.assert_allclose(found, expected, atol=1e-15)


def test_the_forms_of_eq_3_6_are_one_function():
    end = (0, 0, "-L3", 0, 0, "pi")
    first, second = (closed_form_scm(chain_of(*form, final=end).chain).transform for form in SCARA_FORMS[:2])
    for row, other in zip(first, second, strict=True):
        assert all(same_function(a, b) for a, b in zip(row, other, strict=True))
