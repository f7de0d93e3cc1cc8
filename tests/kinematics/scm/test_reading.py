"""Reading chains: what each malformed one gets, and the check of the toolbox."""

import pytest

from kinematics.cells import ParameterKind
from kinematics.errors import DescriptionError
from kinematics.scm import Entry, RawChain, read_chain, verify
from kinematics.table import JointType

from .chains import STANFORD, chain_of, placement

REFUSALS = [
    ((0, 0, 0, 0, 0, 0), "scm_no_variable", ("joints", 0)),
    (("d1", "d1", 0, 0, 0, 0), "scm_two_variables", ("joints", 0, "y")),
    ((0, 0, 0, "q1", "q1", 0), "scm_two_variables", ("joints", 0, "b")),
    ((0, 0, 0, "2*q1", 0, 0), "scm_variable_form", ("joints", 0, "a")),
    ((0, 0, 0, "sin(q1)", 0, 0), "scm_variable_form", ("joints", 0, "a")),
    ((0, 0, 0, "q2", 0, 0), "scm_variable_of_other_row", ("joints", 0, "a")),
    (("alpha", 0, 0, "q1+alpha", 0, 0), "scm_parameter_two_kinds", ("joints", 0, "x")),
]


@pytest.mark.parametrize(("row", "code", "where"), REFUSALS)
def test_refusals(row, code, where):
    with pytest.raises(DescriptionError) as refusal:
        chain_of(row)
    assert (refusal.value.faults[0].code, refusal.value.faults[0].where) == (code, where)


def test_all_faults_at_once_with_their_places():
    with pytest.raises(DescriptionError) as refusal:
        chain_of((0, 0, "(", "q1", 0, 0), (0, 0, 0, 0, 0, 0), final=("q1", 0, 0, 0, 0, 0))
    assert [fault.where for fault in refusal.value.faults] == [
        ("joints", 0, "z"),
        ("joints", 1),
        ("final", "x"),
    ]


@pytest.mark.parametrize("rows", [0, 65])
def test_number_of_rows_is_bounded(rows):
    joints = tuple(placement(0, 0, 0, f"q{i + 1}", 0, 0) for i in range(rows))
    with pytest.raises(DescriptionError) as refusal:
        read_chain(RawChain(joints=joints, final={}, tool={}))
    assert refusal.value.code == ("scm_too_many_joints" if rows else "scm_chain_empty")


def test_text_of_a_chain_is_bounded():
    long = "+".join(["sin(pi/7)"] * 19)
    joints = tuple({"x": long, "a": f"q{i}"} for i in range(1, 46))
    with pytest.raises(DescriptionError) as refusal:
        read_chain(RawChain(joints=joints, final={}, tool={}))
    assert refusal.value.code == "scm_chain_too_long"


def test_beside_a_variable_q_the_documents_names_are_lengths_and_angles():
    """As in the chain of a table whose length d1 lies before its slide q1."""
    read = chain_of(("d1", 0, "-q1", 0, 0, "a1"))
    assert (read.chain.rows[0].variable, read.chain.rows[0].sign) == (Entry.Z, -1)
    assert read.parameters == {"d1": ParameterKind.LENGTH, "a1": ParameterKind.ANGLE}


def test_variables_as_the_document_writes_them():
    read = chain_of(*STANFORD)
    assert [row.variable for row in read.chain.rows] == [Entry.A, Entry.B, Entry.Z, Entry.A, Entry.B, Entry.A]
    assert read.chain.rows[2].joint is JointType.PRISMATIC
    assert read.parameters == dict.fromkeys(("L0", "L1", "L2"), ParameterKind.LENGTH)
    assert not verify(read.chain)


def test_d_of_a_turning_row_is_a_length():
    read = chain_of(("d1", 0, 0, "-a1", 0, 0))
    assert read.parameters == {"d1": ParameterKind.LENGTH}
    assert read.chain.rows[0].sign == -1


@pytest.mark.parametrize(
    ("row", "codes"),
    [
        ((1, "q1", 0, 0, 0, 0), ["scm_prismatic_second_length"]),
        ((0, "q1+1", 0, 0, 0, 0), ["scm_prismatic_second_length"]),
        ((0, "q1", 0, 0, "pi", 0), ["scm_prismatic_turns"]),
        ((1, 2, 3, "q1", 0, 0), []),
        ((0, 0, 0, "q1+1", 0, 0), ["scm_revolute_offset"]),
        ((0, 0, 0, "q1", 1, 1), ["scm_revolute_second_turn", "scm_revolute_second_turn"]),
    ],
)
def test_verify_says_why(row, codes):
    assert [fault.code for fault in verify(chain_of(row).chain)] == codes
