"""What does not fit, with joint, row and amount; which numbers are recognised; what a decision costs."""

import math
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from itertools import product

import pytest

from kinematics.chain import chain_of_table
from kinematics.equivalence import BaseRule, DirectionRule, Kind, Policy, ToolRule, ZeroRule, decide
from kinematics.equivalence.closed_forms import CLOSE, known_number
from kinematics.equivalence.decision import EXACT, certify
from kinematics.equivalence.diagnosis import diagnose
from kinematics.equivalence.meter import Meter, per_batch, per_certificate
from kinematics.equivalence.policy import Tolerance
from kinematics.equivalence.reference import SAMPLES, prepared
from kinematics.equivalence.search import Effort, Search
from kinematics.equivalence.verification import Residual, residual
from kinematics.expressions import evaluate
from kinematics.table import NumericTable
from tests.kinematics.equivalence.campaign import catalogue
from tests.kinematics.equivalence.tables import HALF, PUMA, PUMA_CRAIG, P, R, changed, modified
from tests.kinematics.equivalence.test_diagnosis import CROSSED

FRAMES = Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME)
POINT, AXIS, FREE = Policy(tool=ToolRule.POINT), Policy(tool=ToolRule.AXIS), Policy(tool=ToolRule.FREE)
IN_MODIFIED = modified(
    (R, HALF, 0.1, 0.2, 0), (R, HALF, 0.4, 0.25, 0), (P, -HALF, 0.3, 0.1, 0.4), (R, HALF, 0.35, 0.15, 0)
)
Told = list[tuple[Kind, int | None, int | None, float, float]]


@pytest.mark.parametrize(
    ("key", "policy", "slips", "told"),
    [
        (CROSSED, FREE, {(2, "alpha"): 0.2}, [(Kind.TWIST, 3, 1, 1.37438, 0.0)]),
        (CROSSED, FREE, {(2, "a"): 0.5}, [(Kind.LENGTH, 3, 1, 0.0, 0.2)]),
        (CROSSED, FREE, {(3, "d"): 0.5}, [(Kind.OFFSET, 3, 2, 0.0, 0.35)]),
        (
            CROSSED,
            FREE,
            {(1, "a"): 0.1, (3, "a"): 0.1},
            [(Kind.LENGTH, 2, 0, 0.0, 0.3), (Kind.LENGTH, 4, 2, 0.0, 0.25)],
        ),
        (
            CROSSED,
            FREE,
            {(2, "alpha"): 0.2, (3, "d"): 0.5},
            [(Kind.TWIST, 3, 1, 1.37438, 0.0), (Kind.OFFSET, 3, 2, 0.0, 0.33885)],
        ),
        (CROSSED, POINT, {(4, "d"): 0.4}, [(Kind.OFFSET, 4, 3, 0.0, 0.3)]),
        (CROSSED, POINT, {(4, "a"): 0.5}, [(Kind.LENGTH, 5, 3, 0.0, 0.3)]),
        (CROSSED, AXIS, {(4, "alpha"): 0.9}, [(Kind.TWIST, 5, 3, 0.67084, 0.0)]),
        (CROSSED, AXIS, {(4, "a"): 0.5}, [(Kind.LENGTH, 5, 3, 0.0, 0.3)]),
        (
            CROSSED,
            AXIS,
            {(2, "a"): 0.5, (4, "alpha"): 0.9},
            [(Kind.LENGTH, 3, 1, 0.0, 0.2), (Kind.TWIST, 5, 3, 0.67084, 0.0)],
        ),
        (CROSSED, FRAMES, {(1, "d"): 0.5}, [(Kind.OFFSET, 1, 0, 0.0, 0.3)]),
        (
            CROSSED,
            FRAMES,
            {(4, "alpha"): 0.9, (4, "a"): 0.1},
            [(Kind.TWIST, 5, 3, 0.67081, 0.0), (Kind.LENGTH, 5, 3, 0.0, 0.1)],
        ),
        (
            CROSSED,
            FRAMES,
            {(2, "a"): 0.5, (4, "d"): 0.3},
            [(Kind.LENGTH, 3, 1, 0.0, 0.2), (Kind.OFFSET, 4, 3, 0.0, 0.2)],
        ),
        (IN_MODIFIED, FREE, {(2, "a"): 0.6}, [(Kind.LENGTH, 2, 1, 0.0, 0.2)]),
        (IN_MODIFIED, FREE, {(2, "d"): 0.6}, [(Kind.LENGTH, 4, 3, 0.0, 0.1363)]),
        (IN_MODIFIED, FREE, {(4, "alpha"): 0.2}, [(Kind.TWIST, 4, 3, 1.3708, 0.0)]),
        (IN_MODIFIED, FRAMES, {(1, "a"): 0.5}, [(Kind.BASE, 1, 0, 0.0, 0.4)]),
        (
            IN_MODIFIED,
            FRAMES,
            {(1, "a"): 0.5, (4, "d"): 0.4},
            [(Kind.BASE, 1, 0, 0.0, 0.4), (Kind.TOOL, 4, 3, 0.0, 0.25), (Kind.OFFSET, 4, 3, 0.0, 0.25)],
        ),
        (IN_MODIFIED, FRAMES, {(1, "d"): 0.5}, [(Kind.OFFSET, 1, 0, 0.0, 0.3)]),
        (IN_MODIFIED, POINT, {(4, "a"): 0.6}, [(Kind.LENGTH, 4, 3, 0.0, 0.25)]),
        (PUMA, FREE, {(4, "d"): 0.2}, [(Kind.OFFSET, 4, 3, 0.0, 0.2318)]),
        (PUMA, FREE, {(3, "d"): 0.3}, [(Kind.OFFSET, 3, 2, 0.0, 0.14995)]),
        (PUMA, FREE, {(2, "alpha"): 0.1}, [(Kind.TWIST, 3, 1, 0.1, 0.0)]),
        (PUMA, AXIS, {(6, "alpha"): 0.1}, [(Kind.TOOL, 6, 5, 0.1, 0.0), (Kind.TWIST, 7, 5, 0.09983, 0.0)]),
        (PUMA, POINT, {(6, "a"): 0.1}, [(Kind.TOOL, 6, 5, 0.0, 0.1), (Kind.LENGTH, 7, 5, 0.0, 0.1)]),
        (PUMA, FREE, {(2, "joint"): P}, [(Kind.JOINT_TYPE, 2, 1, 0.0, 0.0)]),
        (PUMA, FREE, {}, [(Kind.PRECISION, None, None, 0.0, 0.0)]),
    ],
)
def test_what_does_not_fit_is_told_with_joint_row_and_amount(
    key: NumericTable, policy: Policy, slips: Mapping[tuple[int, str], float], told: Told
) -> None:
    """Joint, row from 0, angle [rad] and length of every wrong fact."""
    table = key
    for (row, cell), value in slips.items():
        table = changed(table, row, **{cell: value})
    found = diagnose(prepared(key), table, chain_of_table(table), policy)
    assert [(one.kind, one.joint, one.row) for one in found] == [one[:3] for one in told]
    amounts = [amount for one in found for amount in (one.angle, one.length)]
    assert amounts == pytest.approx([amount for one in told for amount in one[3:]], abs=1e-4)


def test_products_of_cosines_of_multiples_of_fifteen_degrees_are_known() -> None:
    """Whatever their last digits: within half of what counts as close to either side."""
    cosines = [math.cos(k * math.pi / 12) for k in range(13)]
    for one, other in product(cosines, cosines):
        value = one * other
        for off in (-0.45, 0.0, 0.45):
            form = known_number(value + off * CLOSE)
            assert form is not None
            assert abs(evaluate(form) - value) < 2.0 * CLOSE


@pytest.mark.parametrize(
    "value", [Fraction(n, 8) for n in range(-8, 9)] + [Fraction(n, 4) for n in range(-12, 13)]
)
def test_small_rational_numbers_are_known(value: Fraction) -> None:
    form = known_number(float(value))
    assert form is not None
    assert evaluate(form) == float(value)
    assert known_number(0.123456) is None
    assert known_number(3.25) is None


@pytest.mark.parametrize(
    ("tables", "rows", "invariants", "cost"),
    [(1, 6, 10, 405), (100, 6, 10, 900), (100, 16, 16, 1000), (100, 18, 14, 1100), (100, 20, 12, 1200)],
)
def test_what_a_batch_costs(tables: int, rows: int, invariants: int, cost: int) -> None:
    assert per_batch(tables, rows, invariants) == cost


def test_what_a_certificate_costs() -> None:
    assert [per_certificate(joints) for joints in (1, 7, 8, 10)] == [150, 150, 180, 240]


def test_within_a_tolerance_is_up_to_it() -> None:
    tolerance = Tolerance(length=0.5, angle=0.25)
    assert Residual(0.25, 0.5).within(tolerance)
    assert not Residual(0.26, 0.5).within(tolerance)
    assert not Residual(0.25, 0.51).within(tolerance)
    assert Residual(0.25, 0.25).excess(tolerance) == 1.0
    assert Residual(0.1, 0.75).excess(tolerance) == 1.5


@pytest.mark.parametrize(
    ("name", "policy", "effort", "cost"),
    [
        ("puma560", FREE, Effort.PLAIN, (510, 1380)),
        ("puma560", FREE, Effort.REFINED, (510, 13380)),
        ("puma560", FRAMES, Effort.REFINED, (510, 4200)),
        ("puma560", AXIS, Effort.REFINED, (510, 7980)),
        ("stanford", FREE, Effort.PLAIN, (510, 1620)),
        ("stanford", FREE, Effort.REFINED, (510, 7620)),
        ("stanford", FRAMES, Effort.REFINED, (510, 4440)),
        ("stanford", AXIS, Effort.REFINED, (510, 8220)),
        ("scara", FREE, Effort.PLAIN, (390, 720)),
        ("scara", FREE, Effort.REFINED, (390, 3720)),
        ("scara", FRAMES, Effort.REFINED, (390, 1890)),
        ("scara", AXIS, Effort.REFINED, (390, 7020)),
        ("ur5", FREE, Effort.PLAIN, (510, 1080)),
        ("ur5", FREE, Effort.REFINED, (510, 19080)),
        ("ur5", FRAMES, Effort.REFINED, (510, 8400)),
        ("ur5", AXIS, Effort.REFINED, (510, 31380)),
        ("panda", FREE, Effort.PLAIN, (570, 1200)),
        ("panda", FREE, Effort.REFINED, (570, 4200)),
        ("panda", FRAMES, Effort.REFINED, (570, 2520)),
        ("panda", AXIS, Effort.REFINED, (570, 7500)),
        ("twolink", FREE, Effort.PLAIN, (270, 480)),
        ("twolink", FREE, Effort.REFINED, (270, 18480)),
        ("twolink", FRAMES, Effort.REFINED, (270, 7770)),
        ("twolink", AXIS, Effort.REFINED, (270, 16380)),
    ],
)
def test_what_a_decision_costs(name: str, policy: Policy, effort: Effort, cost: tuple[int, int]) -> None:
    """The right table, and one with an angle that is just beyond the tolerance."""
    key = dict(catalogue())[name]
    assert (spent(key, key, policy, effort), spent(key, slipped(key), policy, effort)) == cost


@pytest.mark.parametrize("direction", DirectionRule)
def test_an_alignment_is_followed_up_to_nine_tolerances(direction: DirectionRule) -> None:
    """What is farther off comes from no rounding; the joints behind it need not be looked at."""

    def looked_at(tolerances: float) -> int:
        table = changed(PUMA, 3, alpha=PUMA.rows[2].alpha + tolerances * FREE.tolerance.angle)
        policy = replace(FREE, direction=direction)
        search = Search([prepared(PUMA)], [chain_of_table(table)], policy, 0, Effort.PLAIN)
        assert search.run() is None
        return search.nodes

    assert looked_at(8.5) > looked_at(9.5) == looked_at(19.0)


def test_an_exact_certificate_is_looked_for_where_a_coarser_one_would_do() -> None:
    """Twice the work, then, for a table that has neither; and in whole units."""

    def cost(tolerance: float) -> int:
        policy = replace(FREE, tolerance=Tolerance(length=tolerance, angle=tolerance))
        return spent(PUMA, changed(PUMA, 2, alpha=1.5e-8), policy, Effort.REFINED)

    dearer = cost(1.1 * EXACT.angle)
    assert cost(0.9 * EXACT.angle) == cost(EXACT.angle) < dearer
    assert isinstance(dearer, int)


def test_a_tolerance_may_be_finer_than_the_exact_one_in_one_of_two() -> None:
    """An angle is held to it, whatever is allowed of lengths."""
    table = changed(PUMA, 2, alpha=2e-9)
    for angle, accepted in (1e-9, False), (EXACT.angle, True):
        policy = replace(FREE, tolerance=Tolerance(length=5e-3, angle=angle))
        assert decide(PUMA, table, policy).accepted is accepted


def slipped(key: NumericTable) -> NumericTable:
    row = key.joint_rows[len(key.joint_rows) // 2] + 1
    return changed(key, row, alpha=key.rows[row - 1].alpha + 0.006, a=key.rows[row - 1].a + 0.004)


def spent(key: NumericTable, table: NumericTable, policy: Policy, effort: Effort) -> int:
    meter = Meter(10**6)
    certify((prepared(key),), (chain_of_table(table),), policy, effort, meter)
    return 10**6 - meter.left


def test_a_certificate_tells_the_residual_at_its_samples() -> None:
    rounded = changed(PUMA, 2, a=0.432, alpha=0.001)
    certificate = decide(PUMA, rounded, FREE).certificate
    assert certificate is not None
    reference = prepared(PUMA).beside(chain_of_table(rounded))
    at_samples = max(residual(reference, chain_of_table(rounded), certificate.draws[0]))
    assert at_samples <= certificate.residual < 1.5 * at_samples
    assert certificate.samples == SAMPLES == 64


def test_rules_that_are_broken_are_named_in_order() -> None:
    strict = Policy(
        base=BaseRule.FRAME, tool=ToolRule.FRAME, zero=ZeroRule.FIGURE, direction=DirectionRule.FIGURE
    )
    for slips, kinds in (
        ({(2, "theta"): HALF}, [Kind.ZERO]),
        ({(1, "d"): 0.3}, [Kind.BASE]),
        ({(6, "d"): 0.3}, [Kind.TOOL]),
        ({(2, "sign"): -1}, [Kind.DIRECTION]),
        ({(2, "sign"): -1, (6, "d"): 0.3}, [Kind.TOOL, Kind.DIRECTION]),
        ({(1, "d"): 0.3, (3, "theta"): 0.2, (6, "alpha"): 0.2}, [Kind.BASE, Kind.TOOL, Kind.ZERO]),
    ):
        table = PUMA
        for (row, cell), value in slips.items():
            table = changed(table, row, **{cell: value})
        found = decide(PUMA, table, strict)
        assert found.same_robot
        assert [one.kind for one in found.mismatches] == kinds
    assert decide(PUMA, PUMA_CRAIG, FREE).accepted


def test_exactly_parallel_axes_come_before_nearly_parallel_ones() -> None:
    """Further notions of what is parallel are looked at only where they make another chain of groups."""
    tolerance = Policy().tolerance
    plain = prepared(PUMA)
    assert list(plain.levels(BaseRule.FREE, ZeroRule.FREE, tolerance)) == [0]
    nearly = prepared(changed(PUMA, 2, alpha=0.003))
    levels = list(nearly.levels(BaseRule.FREE, ZeroRule.FREE, tolerance))
    assert levels[0] == 0
    assert len(levels) > 1
    assert levels == sorted(set(levels))
    exact = Tolerance(length=1e-9, angle=1e-9)
    assert list(nearly.levels(BaseRule.FREE, ZeroRule.FREE, exact)) == [0]
