"""Cosines and sines against 400-digit arithmetic."""

import math

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.angles import are_ordinary, cos_sin, cos_sin_arrays

EPS = np.finfo(float).eps


def exact(angle):
    with mpmath.workdps(400):
        return mpmath.cos(mpmath.mpf(float(angle))), mpmath.sin(mpmath.mpf(float(angle)))


def by_tangent(angles):
    half = np.asarray(angles, dtype=float) / 2
    cos, sin = np.empty_like(half), np.empty_like(half)
    cos_sin_arrays(half, cos, sin)
    return cos, sin


@pytest.mark.parametrize("k", range(-24, 25))
def test_multiples_of_15_degrees_are_correctly_rounded(k):
    with mpmath.workdps(40):
        meant = [float(mpmath.cos(mpmath.pi * k / 12)), float(mpmath.sin(mpmath.pi * k / 12))]
    meant = [0.0 if abs(x) < 1e-30 else x for x in meant]
    written = [
        k * math.pi / 12,
        k * (math.pi / 12),
        math.radians(15 * k),
        15 * k * math.pi / 180,
        15 * k * (math.pi / 180),
    ]
    for angle in written:
        assert list(cos_sin(angle)) == meant
    cos, sin = by_tangent(written)
    assert cos.tolist() == [meant[0]] * 5
    assert sin.tolist() == [meant[1]] * 5


def test_one_configuration_and_a_batch_agree_on_what_is_exact():
    around = [
        k * math.pi / 12 + step * math.ulp(k * math.pi / 12) for k in range(-30, 31) for step in range(-9, 10)
    ]
    counted = np.array([not are_ordinary([angle]) for angle in around])
    single, batch = np.array([cos_sin(angle) for angle in around]), np.array(by_tangent(around)).T
    library = np.array([(math.cos(angle), math.sin(angle)) for angle in around])
    assert 48 < counted.sum() <= 83
    assert np.array_equal(single[counted], batch[counted])
    assert np.array_equal(single[~counted], library[~counted])
    np.testing.assert_allclose(single, library, rtol=0, atol=1e-15)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_other_angles_are_as_the_library_has_them(angle):
    c, s = cos_sin(angle)
    assert c == pytest.approx(math.cos(angle), abs=1e-14)
    assert s == pytest.approx(math.sin(angle), abs=1e-14)


@pytest.mark.parametrize(
    "angle",
    [1e-12, -3e-300, math.pi / 2 + 1e-12, math.nextafter(math.pi, 4), 25 * math.pi / 12, 1e6 * math.pi],
)
def test_an_angle_that_is_merely_near_a_multiple_is_left_alone(angle):
    assert cos_sin(angle) == (math.cos(angle), math.sin(angle))


@pytest.mark.parametrize("scale", [1e-12, 1e-3, 1.0, math.pi, 1e2, 1e6, 1e15, 1e22, 1e100, 1e300])
def test_tangent_of_the_half_angle_is_accurate_at_any_size(scale):
    angles = np.random.default_rng(1).uniform(-scale, scale, 200)
    cos, sin = by_tangent(angles)
    for angle, c, s in zip(angles, cos, sin, strict=True):
        exact_c, exact_s = exact(angle)
        assert abs(float(exact_c - float(c))) < 4 * EPS
        assert abs(float(exact_s - float(s))) < 4 * EPS


@pytest.mark.parametrize("quarter", [-2, -1, 1, 2, 3, 6, -202, 2000002])
def test_around_quarter_and_half_turns(quarter):
    middle = quarter * math.pi / 2
    angles = [middle + k * math.ulp(middle) for k in range(-20, 21)]
    cos, sin = by_tangent(angles)
    for angle, c, s in zip(angles, cos, sin, strict=True):
        exact_c, exact_s = exact(angle)
        assert abs(float(exact_c - float(c))) < 4 * EPS
        assert abs(float(exact_s - float(s))) < 4 * EPS
        if quarter % 2 == 0 and are_ordinary([angle]):
            assert abs(float((exact_s - float(s)) / exact_s)) < 8 * EPS


def test_the_double_nearest_to_a_half_turn_of_all_doubles():
    """The worst case of range reduction, Kahan's 6381956970095103·2^797: far from overflow."""
    worst = 6381956970095103.0 * 2.0**797
    cos, sin = by_tangent([worst, 2 * worst, np.finfo(float).max])
    for angle, c, s in zip((worst, 2 * worst, np.finfo(float).max), cos, sin, strict=True):
        exact_c, exact_s = exact(angle)
        assert abs(float(exact_c - float(c))) < 4 * EPS
        assert abs(float(exact_s - float(s))) < 4 * EPS
