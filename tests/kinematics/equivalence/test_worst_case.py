"""A certificate stands at every configuration, not at the sampled ones only; and relative to which size."""

import math
from dataclasses import replace
from random import Random

import numpy as np
import pytest

from kinematics.chain import chain_of_table
from kinematics.equivalence import Policy, Tolerance, ToolRule, decide
from kinematics.equivalence.certificates import CertificateCandidate
from kinematics.equivalence.reference import prepared
from kinematics.equivalence.verification import residual
from kinematics.equivalence.worst_case import worst_case
from kinematics.se3 import IDENTITY
from kinematics.table import DHTable, NumericTable
from tests.kinematics.equivalence.campaign import MARGIN, catalogue, size_beside, wrong_tables
from tests.kinematics.equivalence.evaluation import evaluated
from tests.kinematics.equivalence.generators import random_robot, random_valid_table, rounded
from tests.kinematics.equivalence.tables import HALF, PUMA, P, R, changed, scaled, standard

FREE = Policy(tool=ToolRule.FREE)
STRICT = Policy(tool=ToolRule.FREE, tolerance=Tolerance(length=0.001, angle=0.001))
WIDE = Policy(tool=ToolRule.FREE, tolerance=Tolerance(length=0.05, angle=0.05))


@pytest.mark.parametrize("seed", range(30))
def test_the_residual_is_the_largest_difference_at_any_configuration(seed: int) -> None:
    rng = Random(f"worst {seed}")
    key = random_robot(rng, joints=rng.randint(2, 8))
    table = rounded(random_valid_table(key, rng, dummies=0.0, textbook_ends=True), 2)
    certificate = decide(key, table, WIDE).certificate
    if certificate is None:
        return
    size = size_beside(key, table)
    found = evaluated(key, table, certificate, size, f"worst {seed}")
    assert max(found.angle, found.length / size) <= MARGIN * certificate.residual + 1e-9


def test_random_configurations_are_no_worse() -> None:
    table = rounded(random_valid_table(PUMA, Random(3), dummies=0.0), 2)
    certificate = decide(PUMA, table, WIDE).certificate
    assert certificate is not None
    reference, chain, candidate = prepared(PUMA), chain_of_table(table), certificate.draws[0]
    worst = worst_case(reference, chain, candidate).residual
    sampled = residual(reference, chain, candidate)
    joints = np.random.default_rng(0).uniform(-math.pi, math.pi, (6, 20000))
    elsewhere = replace(reference, samples=(joints, reference.chain.poses(joints.T)))
    beyond = residual(elsewhere, chain, candidate)
    assert sampled.length < beyond.length <= worst.length
    assert sampled.angle < beyond.angle <= worst.angle


@pytest.mark.parametrize("theta", [0.0, 0.07, 0.15, 0.19])
def test_the_worst_angle_is_found_between_those_that_are_tried(theta: float) -> None:
    """Two axes are parallel but for e: the tip of the second link, of length b, moves by 2 b sin(e/2)."""
    e, a, b = 0.01, 0.3, 0.4
    key = standard((R, 0, a, 0, 0), (R, 0, b, 0, theta))
    wrong = standard((R, e, a, 0, 0), (R, 0, b, 0, theta))
    candidate = CertificateCandidate(signs=(1, 1), offsets=(0.0, 0.0), base=IDENTITY, tool=IDENTITY)
    found = worst_case(prepared(key), chain_of_table(wrong), candidate).residual
    assert found.angle == pytest.approx(e)
    assert found.length * prepared(key).size == pytest.approx(2.0 * b * math.sin(e / 2.0), rel=2e-4)


@pytest.mark.parametrize("seed", range(20))
def test_what_is_accepted_near_the_tolerance_keeps_it_everywhere(seed: int) -> None:
    """Certificates that were refined to fit the samples must stand elsewhere too."""
    rng = Random(f"near {seed}")
    table = rounded(random_valid_table(PUMA, rng, dummies=0.0), 2)
    certificate = decide(PUMA, table, FREE).certificate
    if certificate is None:
        return
    size = prepared(PUMA).size
    found = evaluated(PUMA, table, certificate, size, f"near {seed}")
    assert found.angle <= 0.005 * MARGIN
    assert found.length <= 0.005 * MARGIN * size


WRIST = standard((R, HALF, 0, 0, 0), (R, -HALF, 0, 0, 0), (R, 0, 0, 0, 0))
SLIDER = standard((P, HALF, 0, 0, 0), (R, HALF, 0, 0, 0), (R, 0, 0, 0, 0))


def test_a_key_without_lengths_has_the_size_of_the_submission() -> None:
    chain = chain_of_table(changed(WRIST, 1, d=0.4))
    assert prepared(WRIST).beside(chain).size == pytest.approx(0.4)
    assert prepared(WRIST).beside(chain_of_table(WRIST)).size == 1.0
    assert prepared(PUMA).beside(chain) is prepared(PUMA)


@pytest.mark.parametrize("unit", [0.001, 1.0, 1000.0])
def test_sliders_travel_as_far_as_the_size_whatever_the_unit(unit: float) -> None:
    """A slider in a wrong direction is wrong however small its travel is beside the lengths drawn."""
    askew = scaled(changed(SLIDER, 1, d=10.0, alpha=HALF + 0.02), unit)
    upright = scaled(changed(SLIDER, 1, d=10.0, alpha=HALF + 0.0008), unit)
    assert not decide(SLIDER, askew, FREE).accepted
    assert decide(SLIDER, upright, FREE).accepted


@pytest.mark.parametrize("unit", [1e-6, 1.0, 1000.0])
def test_no_unit_makes_a_length_small(unit: float) -> None:
    assert not decide(WRIST, scaled(changed(WRIST, 2, a=0.01), unit), FREE).accepted
    assert not decide(WRIST, scaled(changed(changed(WRIST, 2, a=0.01), 1, d=1.0), unit), FREE).accepted
    assert decide(WRIST, scaled(changed(WRIST, 1, d=1.0), unit), FREE).accepted


@pytest.mark.parametrize("block", [50, 74, 323])
def test_keys_without_lengths_among_the_mutants(block: int) -> None:
    outcome = wrong_tables(block)
    assert outcome.failures == []
    assert outcome.confirmed == outcome.accepted > 0


def right_angles_typed(table: NumericTable, decimals: int) -> NumericTable:
    rows = tuple(replace(row, alpha=round(row.alpha, decimals)) for row in table.rows)
    return DHTable(convention=table.convention, rows=rows)


@pytest.mark.parametrize(("name", "key"), catalogue(), ids=[name for name, _ in catalogue()])
def test_what_the_usual_tolerance_is_for(name: str, key: NumericTable) -> None:
    """1.57 for a right angle is accepted, 1 % of the size in a length is not; docs/checker.md says so."""
    assert decide(key, right_angles_typed(key, 2), FREE).accepted
    assert decide(key, right_angles_typed(key, 4), STRICT).accepted
    size = prepared(key).size
    for i, row in enumerate(key.rows, start=1):
        for cell in ("a", "d"):
            matters = not decide(key, changed(key, i, **{cell: getattr(row, cell) + size}), FREE).accepted
            for share, policy in ((0.01, FREE), (0.002, STRICT)):
                longer = changed(key, i, **{cell: getattr(row, cell) + share * size})
                assert decide(key, longer, policy).accepted is not matters
