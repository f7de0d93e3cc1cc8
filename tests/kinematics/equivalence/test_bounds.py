"""What a bound settles must be so: nothing is larger than the upper one, nothing told apart is acceptable."""

import math
from dataclasses import replace
from random import Random

import pytest

from kinematics.chain import Axis, Chain, chain_of_table
from kinematics.equivalence import Policy, Tolerance, ToolRule, decide
from kinematics.equivalence.bounds import surely_apart, upper_bound
from kinematics.equivalence.certificates import CertificateCandidate
from kinematics.equivalence.decision import certify, is_certified
from kinematics.equivalence.reference import prepared
from kinematics.equivalence.search import Effort
from kinematics.equivalence.worst_case import worst_case
from kinematics.se3 import IDENTITY, along, perpendicular, rotate, rotation_about
from tests.kinematics.equivalence.generators import random_robot, random_valid_table, rounded
from tests.kinematics.equivalence.tables import PUMA, changed


@pytest.mark.parametrize("unit", [1e-3, 1.0, 1e3])
def test_parallel_axes_are_surely_apart_by_ten_tolerances_of_the_robot(unit: float) -> None:
    rows = tuple(replace(row, a=unit * row.a, d=unit * row.d) for row in PUMA.rows)
    key = replace(PUMA, rows=rows)
    reference, tolerance = prepared(key), Tolerance(length=1e-3, angle=1e-3)
    for times, apart in ((9.9, False), (10.1, True)):
        wrong = changed(key, 2, a=rows[1].a + times * 1e-3 * reference.size)
        assert surely_apart(reference, chain_of_table(wrong), tolerance) is apart


@pytest.mark.parametrize("decimals", [1, 2, 4])
@pytest.mark.parametrize("seed", range(15))
def test_no_difference_is_larger_than_the_bound_and_what_is_accepted_is_not_apart(
    seed: int, decimals: int
) -> None:
    rng = Random(f"bound {seed} {decimals}")
    key = random_robot(rng, joints=rng.randint(1, 8))
    table = rounded(random_valid_table(key, rng, dummies=0.0, textbook_ends=True), decimals)
    tolerance = 3 * 10.0**-decimals
    policy = Policy(tool=ToolRule.FREE, tolerance=Tolerance(length=tolerance, angle=tolerance))
    certificate = decide(key, table, policy).certificate
    if certificate is None:
        return
    reference, chain = prepared(key), chain_of_table(table)
    assert not surely_apart(reference, chain, policy.tolerance)
    bound = upper_bound(reference, chain, certificate.draws[0])
    worst = worst_case(reference, chain, certificate.draws[0]).residual
    assert worst.angle <= bound.angle + 1e-12
    assert worst.length <= bound.length + 1e-12
    assert worst.angle + worst.length >= (bound.angle + bound.length) / 100


@pytest.mark.parametrize("decimals", [1, 2, 4, 9])
@pytest.mark.parametrize("seed", range(15))
def test_what_stands_by_a_bound_stands_as_measured(seed: int, decimals: int) -> None:
    rng = Random(f"stands {seed} {decimals}")
    key = random_robot(rng, joints=rng.randint(1, 8))
    table = rounded(random_valid_table(key, rng, dummies=0.0, textbook_ends=True), decimals)
    sides = (prepared(key),), (chain_of_table(table),)
    for tolerance in (10.0**-decimals, 3 * 10.0**-decimals, 1e-2):
        policy = Policy(tool=ToolRule.FREE, tolerance=Tolerance(length=tolerance, angle=tolerance))
        measured = certify(*sides, policy, Effort.PLAIN)
        bounded = certify(*sides, policy, Effort.PLAIN, measured=False)
        assert (bounded is None) == (measured is None)
        assert is_certified(*sides, policy, Effort.PLAIN) == (measured is not None)
        if bounded is not None and measured is not None:
            assert bounded.draws == measured.draws
            assert measured.residual <= bounded.residual + 1e-12 <= tolerance + 1e-12


def test_an_axis_aslant_or_beside_its_place_is_apart() -> None:
    reference, tolerance = prepared(PUMA), Tolerance(length=0.002, angle=0.002)
    assert not surely_apart(reference, chain_of_table(PUMA), tolerance)
    aslant = changed(PUMA, 2, alpha=PUMA.rows[2].alpha + 0.1)
    assert surely_apart(reference, chain_of_table(aslant), tolerance)
    longer = changed(PUMA, 2, a=PUMA.rows[1].a + 0.1)
    assert surely_apart(reference, chain_of_table(longer), tolerance)


@pytest.mark.parametrize("joint", range(6))
def test_one_axis_beside_its_place_or_aslant_is_all_of_the_bound(joint: int) -> None:
    """‖exp([A] q) x − exp([B] q) x‖: twice the distance of the axes, or twice their angle, of rotations."""
    reference = prepared(PUMA)
    chain = reference.chain
    alike = CertificateCandidate(signs=(1,) * 6, offsets=(0.0,) * 6, base=IDENTITY, tool=IDENTITY)

    def with_axis(other: Axis) -> Chain:
        return replace(chain, axes=(*chain.axes[:joint], other, *chain.axes[joint + 1 :]))

    assert upper_bound(reference, chain, alike) == pytest.approx((0.0, 0.0), abs=1e-12)
    axis, aside = chain.axes[joint], perpendicular(chain.axes[joint].direction)
    beside = with_axis(axis._replace(point=along(axis.point, 0.01, aside)))
    bound = upper_bound(reference, beside, alike)
    assert bound.angle == pytest.approx(0.0, abs=1e-12)
    assert bound.length * reference.size == pytest.approx(0.02)
    turned = rotate(rotation_about(axis.point, aside, math.cos(0.01), math.sin(0.01)), axis.direction)
    aslant = with_axis(axis._replace(direction=turned))
    bound = upper_bound(reference, aslant, alike)
    worst = worst_case(reference, aslant, alike).residual
    assert bound.angle == pytest.approx(0.02)
    assert worst.angle == pytest.approx(0.02, rel=1e-3)
    assert worst.length <= bound.length + 1e-12


def test_both_sides_have_as_many_joints() -> None:
    reference, chain = prepared(PUMA), chain_of_table(PUMA)
    with pytest.raises(ValueError, match="shorter"):
        upper_bound(reference, chain, CertificateCandidate((1,) * 6, (0.0,) * 5, IDENTITY, IDENTITY))
    with pytest.raises(ValueError, match="shorter"):
        surely_apart(reference, replace(chain, axes=chain.axes[:5]), Tolerance())
