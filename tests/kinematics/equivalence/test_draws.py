"""Tables with parameters: one certificate, with the same signs, at every draw of them."""

from dataclasses import replace
from random import Random

import pytest

from kinematics.chain import chain_of_table
from kinematics.equivalence import Kind, Policy, Tolerance, ToolRule, decide, decide_draws
from kinematics.equivalence.decision import certify
from kinematics.equivalence.diagnosis import likely_signs
from kinematics.equivalence.reference import prepared
from kinematics.equivalence.search import Effort
from kinematics.table import DHTable, NumericTable
from tests.kinematics.equivalence.generators import random_robot, random_valid_table, rounded
from tests.kinematics.equivalence.tables import R, changed, standard

FREE = Policy(tool=ToolRule.FREE)
SKEW = standard((R, 1.1, 0.4, 0.2, 0.3), (R, -0.7, 0.3, 0.25, 0.1), (R, 0.9, 0.35, 0.15, -0.2))


def turned_over(table: NumericTable) -> NumericTable:
    """The same robot, drawn with every z axis the other way."""
    rows = tuple(replace(row, theta=-row.theta, d=-row.d) for row in table.rows)
    return DHTable(convention=table.convention, rows=rows)


def test_signs_are_the_same_at_all_draws() -> None:
    longer = changed(SKEW, 2, a=0.5)
    keys = (SKEW, longer, changed(longer, 1, d=0.4))
    for answers, signs in (keys, (1, 1, 1)), (tuple(map(turned_over, keys)), (-1, -1, -1)):
        certificate = decide_draws(keys, answers, FREE).certificate
        assert certificate is not None
        assert certificate.joint_signs == signs
        assert len(certificate.draws) == 3
    for mixed in (SKEW, turned_over(longer), keys[2]), (SKEW, longer, turned_over(keys[2])):
        assert all(decide(key, answer, FREE).accepted for key, answer in zip(keys, mixed, strict=True))
        assert not decide_draws(keys, mixed, FREE).accepted


@pytest.mark.parametrize("wrong", range(3))
def test_what_is_wrong_at_one_draw_is_wrong(wrong: int) -> None:
    keys = (SKEW, changed(SKEW, 2, a=0.5), changed(SKEW, 1, d=0.4))
    answers = [changed(key, 2, d=0.3) if draw == wrong else key for draw, key in enumerate(keys)]
    assert not decide_draws(keys, answers, FREE).accepted


def test_what_stands_at_every_draw_after_refining_only_is_refined_at_every_draw() -> None:
    """Rounded to two decimals, some certificates stand as they come from the alignments, and some do not."""
    policy = Policy(tool=ToolRule.FREE, tolerance=Tolerance(length=0.006, angle=0.006))
    refined = 0
    for seed in range(40):
        rng = Random(f"draws {seed}")
        key = random_robot(rng, joints=rng.randint(4, 6))
        exact = random_valid_table(key, rng, dummies=0.0, textbook_ends=True)
        answer = rounded(exact, 2)
        alone = decide(key, answer, policy).certificate
        plain = certify([prepared(key)], [chain_of_table(answer)], policy, Effort.PLAIN)
        signs = decide(key, exact, policy).certificate
        if alone is None or plain is not None or signs is None or signs.joint_signs != alone.joint_signs:
            continue
        refined += 1
        both = decide_draws((key, key), (exact, answer), policy).certificate
        assert both is not None
        assert both.residual == pytest.approx(alone.residual, rel=0.3)
        assert (
            certify([prepared(key)] * 2, list(map(chain_of_table, (exact, answer))), policy, Effort.PLAIN)
            is None
        )
    assert refined > 3


@pytest.mark.parametrize("seed", range(8))
def test_the_signs_that_fit_best_are_those_of_the_certificate(seed: int) -> None:
    """Of a right table, and of one in which the last length is off."""
    rng = Random(f"signs {seed}")
    key = (
        SKEW
        if seed % 2
        else standard(*((R, rng.uniform(0.4, 1.2), 0.4, rng.uniform(0.2, 0.5), 0.1) for _ in range(4)))
    )
    table = random_valid_table(key, rng, dummies=0.0)
    certificate = decide(key, table, FREE).certificate
    assert certificate is not None
    last = len(table.rows)
    for answer in table, changed(table, last - 1, a=table.rows[last - 2].a + 0.05):
        found = likely_signs(prepared(key), chain_of_table(answer), FREE)
        assert found[0] == certificate.joint_signs
        assert len(set(found)) == len(found)


@pytest.mark.parametrize("seed", range(8))
def test_signs_are_those_of_axes_that_are_parallel_only_nearly(seed: int) -> None:
    """However small the angles between them: in an exact table they tell which way the axes point."""
    key = standard(*((R, twist, 0.4, 0.2 + twist, 0.1) for twist in (0.009, 0.004, 0.008, 0.7)))
    table = random_valid_table(key, Random(f"nearly parallel {seed}"), dummies=0.0)
    certificate = decide(key, table, FREE).certificate
    assert certificate is not None
    assert likely_signs(prepared(key), chain_of_table(table), FREE)[0] == certificate.joint_signs


def test_a_table_is_given_at_every_draw() -> None:
    with pytest.raises(ValueError, match="shorter"):
        decide_draws((SKEW, changed(SKEW, 2, a=0.5)), (SKEW,), FREE)


def test_what_fits_at_no_draw_is_told_from_the_first() -> None:
    keys = (SKEW, changed(SKEW, 2, a=0.5))
    decision = decide_draws(keys, (changed(SKEW, 1, a=0.6), keys[1]), FREE)
    assert [mismatch.kind for mismatch in decision.mismatches] == [Kind.LENGTH]
