"""All 24 sequences: every triple of a rotation, and the whole family where two axes fall together."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.errors import PoseError
from kinematics.rotations.matrices import angle_between, distance, product
from kinematics.rotations.sequences import (
    SEQUENCES,
    Combination,
    EulerSequence,
    Turning,
    euler_solutions,
)
from tests.kinematics.rotations.orientations import made_by

ANGLES = st.floats(-9, 9)
EACH = st.sampled_from(SEQUENCES)


def test_there_are_twenty_four() -> None:
    assert len(set(SEQUENCES)) == 24
    assert sum(sequence.proper for sequence in SEQUENCES) == 12


@given(EACH, ANGLES, ANGLES, ANGLES)
def test_a_sequence_makes_what_three_turns_make(sequence, a, b, c) -> None:
    assert np.allclose(sequence.matrix((a, b, c)), made_by(sequence, (a, b, c)), atol=1e-12)


@given(EACH, ANGLES, ANGLES, ANGLES)
def test_fixed_axes_are_current_ones_in_reverse(sequence, a, b, c) -> None:
    other = Turning.FIXED if sequence.turning is Turning.CURRENT else Turning.CURRENT
    reverse = EulerSequence(axes=sequence.axes[::-1], turning=other)
    assert distance(sequence.matrix((a, b, c)), reverse.matrix((c, b, a))) < 1e-12


@given(EACH, ANGLES, ANGLES, ANGLES)
def test_every_triple_makes_the_rotation_and_the_given_one_is_among_them(sequence, a, b, c) -> None:
    rotation = sequence.matrix((a, b, c))
    found = euler_solutions(rotation, sequence)
    assert all(distance(sequence.matrix(triple), rotation) < 1e-9 for triple in found.triples)
    level = math.sin(b) if sequence.proper else math.cos(b)
    if abs(level) > 1e-4:
        assert found.family is None
        assert len(found.triples) == 2
        near = [
            all(abs(math.remainder(x - y, math.tau)) <= 1e-6 for x, y in zip(triple, (a, b, c), strict=True))
            for triple in found.triples
        ]
        assert near.count(True) == 1


@given(EACH, ANGLES, ANGLES, ANGLES)
def test_the_first_triple_has_the_middle_angle_of_textbooks(sequence, a, b, c) -> None:
    found = euler_solutions(sequence.matrix((a, b, c)), sequence)
    middle = found.triples[0][1]
    if sequence.proper:
        assert 0.0 <= middle <= math.pi
    else:
        assert abs(middle) <= math.pi / 2


@given(EACH, ANGLES, ANGLES, st.booleans(), ANGLES)
def test_a_locked_rotation_has_one_family(sequence, a, c, upper, first) -> None:
    middle = (math.pi if upper else 0.0) if sequence.proper else (0.5 - upper) * math.pi
    rotation = sequence.matrix((a, middle, c))
    family = euler_solutions(rotation, sequence).family
    assert family is not None
    member = (first, family.middle, family.last(first))
    assert distance(sequence.matrix(member), rotation) < 1e-9
    together = a + c if family.combination is Combination.SUM else a - c
    assert abs(math.remainder(family.value - together, math.tau)) <= 1e-9


@pytest.mark.parametrize("axes", ["", "XX", "XXY", "XYY", "XYZX", "ABC", "xyz"])
def test_other_orders_are_no_sequence(axes) -> None:
    with pytest.raises(PoseError) as refusal:
        EulerSequence(axes=axes)
    assert refusal.value.code == "euler_axes_unknown"


def test_roll_pitch_yaw_of_a_textbook() -> None:
    """J. J. Craig, Introduction to Robotics, eq. 2.64: R_XYZ(γ, β, α) about fixed axes."""
    roll, pitch, yaw = 0.3, -0.4, 0.9
    rotation = EulerSequence(axes="XYZ", turning=Turning.FIXED).matrix((roll, pitch, yaw))
    assert rotation[0][0] == pytest.approx(math.cos(yaw) * math.cos(pitch))
    assert rotation[2][0] == pytest.approx(-math.sin(pitch))
    assert rotation[2][1] == pytest.approx(math.cos(pitch) * math.sin(roll))


@given(st.lists(ANGLES, min_size=3, max_size=3), st.floats(0, math.pi))
def test_the_angle_between_two_orientations_is_that_of_the_turn(angles, turn) -> None:
    first = SEQUENCES[1].matrix(angles)
    second = product(first, EulerSequence(axes="ZXZ").matrix((0.4, turn, -0.4)))
    assert angle_between(first, second) == pytest.approx(turn, abs=1e-7)
