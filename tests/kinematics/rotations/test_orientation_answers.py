"""Answers about orientations: every right writing is accepted, nothing else, and slips are told."""

import math
from dataclasses import replace

import numpy as np
import pytest

from kinematics.rotations.frame_chains import ChainFactor, ChainMistake, chain_product, judge_chain
from kinematics.rotations.matrices import IDENTITY, matrix3, transposed
from kinematics.rotations.orientation_answers import (
    judge_axis_angle,
    judge_family,
    judge_matrix,
    judge_quaternion,
    judge_triples,
)
from kinematics.rotations.orientation_verdicts import Built, ComponentOrder, RotationMistake
from kinematics.rotations.properties import RotationProperty, failed_properties
from kinematics.rotations.sequences import Combination, EulerSequence, GimbalFamily, Turning
from kinematics.se3 import inverse_transform
from tests.kinematics.rotations.orientations import turn

ZYZ = EulerSequence(axes="ZYZ")
ANGLES = (0.5, 1.1, -0.7)
EXPECTED = ZYZ.matrix(ANGLES)
BUILT = Built(sequence=ZYZ, angles=ANGLES)
HALF = matrix3(turn(np.array([1.0, 2.0, 2.0]), math.pi).tolist())


def slip(verdict) -> RotationMistake:
    assert not verdict.right
    assert verdict.share < 1
    return verdict.mistakes[0]


def test_slips_with_a_matrix_are_told() -> None:
    assert slip(judge_matrix(EXPECTED, transposed(EXPECTED))) is RotationMistake.TRANSPOSED
    fixed = EulerSequence(axes="ZYZ", turning=Turning.FIXED).matrix(ANGLES)
    assert slip(judge_matrix(EXPECTED, fixed, built=BUILT)) is RotationMistake.ORDER_REVERSED
    left = ZYZ.matrix([-angle for angle in ANGLES])
    assert slip(judge_matrix(EXPECTED, left, built=BUILT)) is RotationMistake.HANDEDNESS
    degrees = ZYZ.matrix([math.degrees(angle) for angle in ANGLES])
    assert slip(judge_matrix(EXPECTED, degrees, built=BUILT)) is RotationMistake.DEGREES
    mirrored = matrix3([(x, y, -z) for x, y, z in EXPECTED])
    assert slip(judge_matrix(EXPECTED, mirrored)) is RotationMistake.RIGHT_HANDED
    assert judge_matrix(EXPECTED, IDENTITY).mistakes == ()


@pytest.mark.parametrize("decimals", [1, 2])
def test_a_matrix_of_few_decimals_is_rounded_and_not_skew(decimals: int) -> None:
    rows = [[round(entry, decimals) for entry in row] for row in EXPECTED]
    assert slip(judge_matrix(EXPECTED, matrix3(rows), tolerance=1e-3)) is RotationMistake.ROUNDED
    rows[0][0] += 0.1
    assert judge_matrix(EXPECTED, matrix3(rows)).mistakes[0] is RotationMistake.UNIT_COLUMNS


def test_slips_with_a_quaternion_are_told() -> None:
    k, angle = np.array([0.6, 0.0, 0.8]), 1.3
    expected = matrix3(turn(k, angle).tolist())
    w, v = math.cos(angle / 2), (k * math.sin(angle / 2)).tolist()
    assert judge_quaternion(expected, [-w, *(-x for x in v)]).right
    assert slip(judge_quaternion(expected, [*v, w])) is RotationMistake.COMPONENT_ORDER
    assert judge_quaternion(expected, [*v, w], ComponentOrder.SCALAR_LAST).right
    assert slip(judge_quaternion(expected, [w, *(-x for x in v)])) is RotationMistake.TRANSPOSED
    whole = [math.cos(angle), *(k * math.sin(angle)).tolist()]
    assert slip(judge_quaternion(expected, whole)) is RotationMistake.HALF_ANGLE
    assert slip(judge_quaternion(expected, [2 * w, *(2 * x for x in v)])) is RotationMistake.NOT_UNIT


def test_slips_with_an_axis_are_told() -> None:
    expected = matrix3(turn(np.array([0.0, 0.6, 0.8]), 1.2).tolist())
    assert judge_axis_angle(expected, (0, -3, -4), -1.2).right
    assert slip(judge_axis_angle(expected, (0, 3, 4), math.degrees(1.2))) is RotationMistake.DEGREES
    assert slip(judge_axis_angle(expected, (0, 3, 4), -1.2)) is RotationMistake.TRANSPOSED
    assert slip(judge_axis_angle(expected, (0, 0, 0), 1.2)) is RotationMistake.NO_AXIS


def test_slips_with_triples_are_told() -> None:
    a, b, c = ANGLES
    assert slip(judge_triples(EXPECTED, ZYZ, [(a + math.pi, b, c)])) is RotationMistake.QUADRANT
    for signs in ((-1, 1, 1), (1, -1, 1), (1, 1, -1)):
        triple = [sign * angle for sign, angle in zip(signs, ANGLES, strict=True)]
        assert slip(judge_triples(EXPECTED, ZYZ, [triple])) is RotationMistake.ANGLE_SIGN
    assert slip(judge_triples(EXPECTED, ZYZ, [(c, b, a)])) is RotationMistake.ORDER_REVERSED
    assert slip(judge_triples(EXPECTED, ZYZ, [(-a, -b, -c)])) is RotationMistake.HANDEDNESS
    assert slip(judge_triples(EXPECTED, ZYZ, [(-c, -b, -a)])) is RotationMistake.TRANSPOSED
    assert slip(judge_triples(EXPECTED, ZYZ, [ANGLES], every=True)) is RotationMistake.SOLUTION_MISSING
    again = [ANGLES, (a + math.tau, b, c - math.tau)]
    assert slip(judge_triples(EXPECTED, ZYZ, again, every=True)) is RotationMistake.SOLUTION_TWICE


def test_a_half_turn_has_either_axis_and_is_never_called_transposed() -> None:
    assert judge_axis_angle(HALF, (1, 2, 2), math.pi).right
    assert judge_axis_angle(HALF, (-1, -2, -2), math.pi).right
    assert judge_axis_angle(HALF, (1, 2, 2), -math.pi).right
    assert judge_quaternion(HALF, (0, -1 / 3, -2 / 3, -2 / 3)).right
    assert judge_matrix(HALF, transposed(HALF)).right


def test_no_rotation_has_any_axis() -> None:
    assert judge_axis_angle(IDENTITY, (3, 1, 2), math.tau).right
    assert judge_axis_angle(IDENTITY, (0, 0, 0), 0).right
    assert judge_quaternion(IDENTITY, (-1, 0, 0, 0)).right


@pytest.mark.parametrize(
    ("turning", "fixed", "value"),
    [(Turning.CURRENT, Combination.DIFFERENCE, 0.7), (Turning.FIXED, Combination.SUM, -0.1)],
)
def test_a_locked_rotation_needs_its_family(turning, fixed, value) -> None:
    sequence = EulerSequence(axes="ZYX", turning=turning)
    rotation = sequence.matrix((0.3, math.pi / 2, -0.4))
    family = GimbalFamily(middle=math.pi / 2, combination=fixed, value=value + math.tau)
    member = (1.0, math.pi / 2, family.last(1.0))
    assert judge_triples(rotation, sequence, [member]).right
    asked = judge_triples(rotation, sequence, [member], every=True)
    assert slip(asked) is RotationMistake.FAMILY_MISSING
    assert judge_family(rotation, sequence, family).right
    (other,) = set(Combination) - {fixed}
    exchanged = judge_family(rotation, sequence, replace(family, combination=other))
    assert (exchanged.right, exchanged.share, slip(exchanged)) == (False, 0.5, RotationMistake.COMBINATION)
    negative = judge_family(rotation, sequence, replace(family, value=-value))
    assert slip(negative) is RotationMistake.ANGLE_SIGN
    degrees = replace(family, middle=90.0, value=math.degrees(value))
    assert slip(judge_family(rotation, sequence, degrees)) is RotationMistake.DEGREES
    off = judge_family(rotation, sequence, replace(family, value=value + 0.1))
    assert (off.right, off.share, off.mistakes) == (False, 0.0, ())


@pytest.mark.parametrize(
    ("middle", "combination", "told"),
    [
        (0.0, Combination.SUM, RotationMistake.TRANSPOSED),
        (math.pi, Combination.DIFFERENCE, RotationMistake.HANDEDNESS),
    ],
)
def test_a_family_of_the_other_sign_is_the_inverse_only_where_it_is(
    middle: float, combination: Combination, told: RotationMistake
) -> None:
    """With a middle angle of half a turn every member is a half turn, which is its own inverse."""
    family = GimbalFamily(middle=middle, combination=combination, value=0.7)
    rotation = ZYZ.matrix((1.0, middle, family.last(1.0)))
    other = replace(family, value=-0.7)
    given = ZYZ.matrix((1.0, middle, other.last(1.0)))
    assert np.allclose(given, np.transpose(rotation)) is (told is RotationMistake.TRANSPOSED)
    assert slip(judge_family(rotation, ZYZ, other)) is told


def test_a_family_is_not_claimed_where_there_are_two_triples() -> None:
    family = GimbalFamily(middle=ANGLES[1], combination=Combination.SUM, value=ANGLES[0] + ANGLES[2])
    assert slip(judge_family(EXPECTED, ZYZ, family)) is RotationMistake.NOT_LOCKED


@pytest.mark.parametrize("value", [1e308, -1e308, 1e-320, 1e17])
def test_no_number_is_too_large_to_be_judged(value) -> None:
    rows = matrix3([[value] * 3] * 3)
    assert not judge_matrix(EXPECTED, rows, built=BUILT).right
    assert not judge_triples(EXPECTED, ZYZ, [(value, value, value)]).right
    assert not judge_quaternion(EXPECTED, [value] * 4).right
    assert not judge_axis_angle(EXPECTED, (0, 0, 1), value).right


def test_properties_of_rotations() -> None:
    assert failed_properties(EXPECTED, 1e-9) == ()
    x, y, z = transposed(EXPECTED)
    double = tuple(2 * value for value in z)
    assert failed_properties(transposed((x, y, (double[0], double[1], double[2]))), 1e-3) == (
        RotationProperty.UNIT_COLUMNS,
    )
    assert failed_properties(transposed((x, y, x)), 1e-3) == (RotationProperty.PERPENDICULAR_COLUMNS,)
    assert failed_properties(transposed((y, x, z)), 1e-3) == (RotationProperty.RIGHT_HANDED,)


def pose(axis, angle, position):
    result = np.eye(4)
    result[:3, :3] = turn(np.array(axis, float), angle)
    result[:3, 3] = position
    return result


A = pose((1, 2, 3), 0.8, (0.3, -0.2, 0.5))
B = pose((2, -1, 1), 1.9, (0.7, 0.1, -0.4))
FACTORS = (ChainFactor(pose=A, inverted=True), ChainFactor(pose=B))


def test_a_chain_of_frames() -> None:
    right = np.linalg.inv(A) @ B
    assert np.allclose(chain_product(FACTORS), right)
    assert judge_chain(FACTORS, np.round(right, 4), size=1, tolerance=0.005).right
    inverse = inverse_transform(A)
    kept = inverse.copy()
    kept[:3, :3] = A[:3, :3]
    plain = inverse.copy()
    plain[:3, 3] = -A[:3, 3]
    turned = right.copy()
    turned[:3, :3] = right[:3, :3].T
    told = {
        ChainMistake.NOT_INVERTED: A @ B,
        ChainMistake.INVERSE_WITHOUT_TRANSPOSE: kept @ B,
        ChainMistake.INVERSE_POSITION: plain @ B,
        ChainMistake.ORDER_REVERSED: B @ inverse,
        ChainMistake.INVERTED: np.linalg.inv(right),
        ChainMistake.TRANSPOSED: turned,
        ChainMistake.NOT_RIGID: 2 * right - np.diag([0, 0, 0, 1.0]),
    }
    for mistake, given in told.items():
        found = judge_chain(FACTORS, given, size=1, tolerance=0.005)
        assert not found.right
        assert found.mistakes == (mistake,)
    assert not judge_chain(FACTORS, 2 * right, size=1, tolerance=0.005).right
    other = judge_chain(FACTORS, A @ np.linalg.inv(B), size=1, tolerance=0.005)
    assert other.mistakes == (ChainMistake.NOT_INVERTED,)
