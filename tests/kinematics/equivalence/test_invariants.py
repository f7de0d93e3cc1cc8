"""What no choice of frames changes: the same strains in every unit, angles about sliders, and what is off."""

import math
from random import Random

import numpy as np
import pytest

from kinematics.chain import Axis, chain_of_table
from kinematics.equivalence import BaseRule, Kind, Policy, ToolRule, ZeroRule
from kinematics.equivalence.batches import axis_batch
from kinematics.equivalence.diagnosis import mismatches_of
from kinematics.equivalence.home_invariants import home_invariants_of
from kinematics.equivalence.invariants import FLOOR, SLACK, axes_of, invariants_of
from kinematics.equivalence.measures import Measure, Shape, measured
from kinematics.equivalence.reference import prepared
from kinematics.se3 import Vector
from kinematics.table import NumericTable
from tests.kinematics.equivalence.generators import random_valid_table
from tests.kinematics.equivalence.tables import HALF, F, P, R, changed, modified, scaled, standard

FREE = Policy(tool=ToolRule.FREE)
FIXED = Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME, zero=ZeroRule.FIGURE)
ARM = standard(
    (R, HALF, 0.1, 0.4, 0.2), (R, 0, 0.5, 0.05, 0.4), (R, -0.7, 0.3, 0.1, 0.3), (R, HALF, 0.02, 0.45, 0.1)
)
# Two joints across a column that lifts, before and behind it.
COLUMN = standard(
    (R, HALF, 0.1, 0.3, 0.2),
    (R, 0, 0.4, 0.2, 0.3),
    (P, 0, 0.05, 0.1, 0.1),
    (R, HALF, 0.3, 0.15, 0.2),
    (R, 0.6, 0.1, 0.2, 0.1),
)


def strains(key: NumericTable, table: NumericTable, policy: Policy) -> list[float]:
    reference = prepared(key)
    invariants = invariants_of(reference, policy).beside(home_invariants_of(reference, policy))
    axes = axis_batch([axes_of(chain_of_table(table), policy)])
    return [float(strain) for strain in invariants.strains(invariants.measured(axes))[:, 0]]


@pytest.mark.parametrize("unit", [1e-3, 1e3])
@pytest.mark.parametrize("key", [ARM, COLUMN], ids=["arm", "column"])
@pytest.mark.parametrize("policy", [FREE, FIXED], ids=["free", "fixed"])
def test_strains_do_not_depend_on_the_unit(key: NumericTable, unit: float, policy: Policy) -> None:
    wrong = changed(changed(key, 2, a=key.rows[1].a + 0.2), 4, alpha=key.rows[3].alpha + 0.1)
    found = strains(key, wrong, policy)
    assert max(found) > 1.0
    np.testing.assert_allclose(
        strains(scaled(key, unit), scaled(wrong, unit), policy), found, rtol=1e-6, atol=1e-6
    )


@pytest.mark.parametrize("row", [2, 3, 4])
def test_a_length_along_a_column_shows_behind_it(row: int) -> None:
    """Where the configuration of the figure is fixed, a wrong d shows between what lies before and behind."""
    wrong = changed(COLUMN, row, d=COLUMN.rows[row - 1].d + 0.2)
    reference = prepared(COLUMN)
    invariants = home_invariants_of(reference, FIXED)
    axes = axis_batch([axes_of(chain_of_table(wrong), FIXED)])
    apart = np.abs(invariants.sizes(invariants.measured(axes)) - invariants.own_sizes)[:, 0]
    (offset,) = [k for k, shape in enumerate(invariants.shapes) if shape.measure is Measure.OFFSET]
    assert invariants.shapes[offset].axes == (1, 2, 4, 5)
    assert apart[offset] == pytest.approx(0.2)


def unit_vector(rng: Random) -> Vector:
    x, y, z = (rng.gauss(0.0, 1.0) for _ in range(3))
    size = math.hypot(x, y, z)
    return x / size, y / size, z / size


@pytest.mark.parametrize("number", range(20))
def test_a_turn_about_a_slider_is_the_angle_of_two_planes(number: int) -> None:
    """The planes hold the slider's direction, and that of the axis before it or behind it."""
    rng = Random(f"turn {number}")
    before, slider, after = (unit_vector(rng) for _ in range(3))
    origin = (0.0, 0.0, 0.0)
    axes = [Axis(False, before, origin), Axis(True, slider, origin), Axis(False, after, origin)]
    (found,) = measured((Shape(Measure.TURN, (0, 1, 2)),), axis_batch([axes]))[:, 0]
    one, other = np.cross(slider, before), np.cross(slider, after)
    cosine = abs(float(one @ other)) / float(np.linalg.norm(one) * np.linalg.norm(other))
    assert found == pytest.approx(math.acos(cosine), abs=1e-7)


@pytest.mark.parametrize(
    ("row", "cell", "kind", "joint"),
    [(1, "d", Kind.OFFSET, 1), (1, "a", Kind.LENGTH, 2), (3, "alpha", Kind.TWIST, 4), (4, "a", Kind.TOOL, 4)],
)
def test_invariants_that_are_off_say_what_is(row: int, cell: str, kind: Kind, joint: int) -> None:
    fixed = Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME)
    wrong = changed(ARM, row, **{cell: getattr(ARM.rows[row - 1], cell) + 0.2})
    reference, chain = prepared(ARM), chain_of_table(wrong)
    told = mismatches_of(invariants_of(reference, fixed), reference, wrong, chain, fixed)
    off = [mismatch for mismatch in told if max(mismatch.angle, mismatch.length) > 1e-6]
    assert (kind, joint) in [(mismatch.kind, mismatch.joint) for mismatch in off]


FIXED_FIRST = modified(
    (F, 0.4, 0.1, 0.3, 0.2), (R, HALF, 0.1, 0.2, 0.3), (R, 0.5, 0.3, 0.2, 0.1), (R, -0.7, 0.3, 0.2, 0.1)
)


@pytest.mark.parametrize("row", range(1, 5))
@pytest.mark.parametrize("cell", ["alpha", "a", "d"])
def test_what_is_off_along_the_first_z_is_the_base_or_the_first_joint(row: int, cell: str) -> None:
    fixed = Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME)
    wrong = changed(FIXED_FIRST, row, **{cell: getattr(FIXED_FIRST.rows[row - 1], cell) + 0.15})
    reference, chain = prepared(FIXED_FIRST), chain_of_table(wrong)
    told = mismatches_of(invariants_of(reference, fixed), reference, wrong, chain, fixed)
    off = [mismatch for mismatch in told if max(mismatch.angle, mismatch.length) > 1e-6]
    assert {mismatch.joint for mismatch in off} == {max(row - 1, 1)}
    assert {mismatch.row for mismatch in off} == {max(row - 1, 1)}
    assert (row == 1) <= (Kind.BASE in {mismatch.kind for mismatch in off})


def test_what_is_off_along_z_0_alone_is_the_base() -> None:
    key = standard((F, 0.4, 0.1, 0.3, 0.2), (R, HALF, 0.1, 0.2, 0.3), (R, 0.5, 0.3, 0.2, 0.1))
    fixed = Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME)
    wrong = changed(key, 1, d=0.45)
    reference, chain = prepared(key), chain_of_table(wrong)
    told = mismatches_of(invariants_of(reference, fixed), reference, wrong, chain, fixed)
    (off,) = (mismatch for mismatch in told if max(mismatch.angle, mismatch.length) > 1e-6)
    assert (off.kind, off.joint, off.length) == (Kind.BASE, 1, pytest.approx(0.15))


ELBOW, WRIST = (R, 1.2, 0.1, 0.4, 0.2), (R, 0.9, 0.1, 0.3, 0.2)
SLIDES: dict[str, tuple[NumericTable, tuple[int, ...]]] = {
    "behind": (
        standard(ELBOW, (R, 1.0, 0.05, 0.1, 0.3), (P, 1.1, 0.2, 0.15, 0.8), WRIST),
        (1, 2, 2, 4, 2, 3),
    ),
    "before": (
        standard(ELBOW, (P, 1.0, 0.05, 0.1, 0.9), (R, 1.1, 0.2, 0.15, 0.8), WRIST),
        (1, 3, 3, 4, 2, 3),
    ),
    "both": (
        standard(ELBOW, (P, 1.0, 0.05, 0.1, 0.9), (R, 1.1, 0.2, 0.15, 0.8), (P, 0.8, 0.1, 0.1, 0.7), WRIST),
        (1, 3, 3, 5, 2, 4),
    ),
    "before a run": (
        standard(ELBOW, (P, 1.0, 0.05, 0.1, 0.9), (R, 0, 0.2, 0.15, 0.8), (R, 0.8, 0.1, 0.1, 0.7), WRIST),
        (1, 3, 4, 5, 2, 4),
    ),
    "along the axis before": (
        standard(ELBOW, (R, 0, 0.2, 0.1, 0.3), (P, 0.9, 0.05, 0.1, 0.9), (R, 1.1, 0.2, 0.15, 0.8), WRIST),
        (2, 4, 4, 5),
    ),
}  # fmt: skip


@pytest.mark.parametrize("way", SLIDES)
def test_an_offset_past_sliders_is_the_same_in_all_frames(way: str) -> None:
    """Where sliders move an axis in a plane, that plane meets the run in one point."""
    key, axes = SLIDES[way]
    invariants = invariants_of(prepared(key), FREE)
    place = invariants.shapes.index(Shape(Measure.OFFSET, axes))
    others = [random_valid_table(key, Random(f"{way} {seed}")) for seed in range(8)]
    found = invariants.measured(axis_batch([axes_of(chain_of_table(table), FREE) for table in others]))
    np.testing.assert_allclose(np.abs(found[place]), abs(invariants.values[place, 0]), rtol=1e-9, atol=1e-9)
    longer = changed(key, axes[1], d=key.rows[axes[1] - 1].d + 0.125)
    further = invariants.measured(axis_batch([axes_of(chain_of_table(longer), FREE)]))[place, 0]
    assert further - invariants.values[place, 0] == pytest.approx(0.125)


def test_sliders_that_take_an_axis_anywhere_leave_no_offset() -> None:
    slides = (P, 1.1, 0.2, 0.15, 0.8), (P, 0.8, 0.1, 0.1, 0.7)
    key = standard(ELBOW, (R, 1.0, 0.05, 0.1, 0.3), *slides, WRIST)
    assert not any(shape.measure is Measure.OFFSET for shape in invariants_of(prepared(key), FREE).shapes)


def skew(twist: float) -> NumericTable:
    return standard((R, twist, 0.1, 0.4, 0.2), (R, HALF, 0.3, 0.2, 0.1), (R, HALF, 0.2, 0.1, 0.3))


def with_sliders(twist: float, *, skew: bool) -> NumericTable:
    first = (R, HALF, 0.1, 0.4, 0.2), (R, HALF, 0.1, 0.2, 0.3), (P, twist, 0.0, 0.1, 0.1)
    second = ((P, HALF, 0.1, 0.1, 0.2),) if skew else ()
    return standard(*first, *second, (R, HALF, 0.2, 0.1, 0.1), (R, 0.0, 0.1, 0.1, 0.0))


@pytest.mark.parametrize("seed", range(6))
def test_a_sum_of_offsets_is_the_same_in_all_frames(seed: int) -> None:
    """Across the plane of two sliders, whatever each of the two offsets beside it is."""
    key = with_sliders(0.9, skew=True)
    invariants = invariants_of(prepared(key), FREE)
    (place,) = (k for k, shape in enumerate(invariants.shapes) if shape.measure is Measure.SUM)
    table = random_valid_table(key, Random(f"sum {seed}"))
    found = invariants.measured(axis_batch([axes_of(chain_of_table(table), FREE)]))
    assert abs(invariants.values[place, 0]) > 0.05
    assert abs(found[place, 0]) == pytest.approx(abs(invariants.values[place, 0]), rel=1e-9)


def test_the_runs_of_an_offset_are_those_along_which_it_is_measured() -> None:
    assert Shape(Measure.OFFSET, (1, 2, 4, 5)).runs == (2, 4)
    assert Shape(Measure.SUM, (4, 5, 3, 2, 1, 3, 6, 7, 8, 6)).runs == (2, 3, 6, 7)
    assert Shape(Measure.DISTANCE, (1, 2, 1, 2)).runs == ()


@pytest.mark.parametrize("policy", [FREE, FIXED], ids=["free", "fixed"])
def test_without_joints_nothing_is_measured(policy: Policy) -> None:
    reference = prepared(standard((F, 0.4, 0.1, 0.3, 0.2)))
    for found in (invariants_of(reference, policy), home_invariants_of(reference, policy)):
        assert found.shapes == ()
        assert found.values.shape == found.slacks.shape == (0, 1)


def lift(twist: float) -> NumericTable:
    ends = (R, HALF, 0.1, 0.1, 0.2), (R, 1.0, 0.1, 0.2, 0.1)
    return standard((R, twist, 0.1, 0.4, 0.2), (R, 0, 0.1, 0.2, 0.3), (P, 0, 0.1, 0.1, 0.1), *ends)


@pytest.mark.parametrize("twist", [0.3, 0.9, HALF])
def test_what_lies_between_flat_axes_may_be_off_by_as_much_more_as_they_lever_it_up(twist: float) -> None:
    """A pose within the tolerance fixes their common normal to within that over the sine between them."""
    for key, made, shape in (
        (skew(twist), invariants_of, Shape(Measure.DISTANCE, (1, 2, 1, 2))),
        (skew(twist), invariants_of, Shape(Measure.OFFSET, (1, 2, 2, 3))),
        (with_sliders(twist, skew=True), invariants_of, Shape(Measure.SUM, (3, 4, 2, 2, 1, 2, 5, 5, 6, 5))),
        (with_sliders(twist, skew=False), invariants_of, Shape(Measure.TURN, (2, 3, 4))),
        (lift(twist), home_invariants_of, Shape(Measure.DISTANCE, (0, 2, 0, 2))),
        (lift(twist), home_invariants_of, Shape(Measure.OFFSET, (1, 2, 4, 5))),
    ):
        reference = prepared(key)
        found = made(reference, FIXED)
        slack = float(found.slacks[found.shapes.index(shape), 0])
        least = (SLACK * FIXED.tolerance.length + FLOOR) * (1.0 if shape.is_angle else reference.size)
        assert slack == pytest.approx(least / math.sin(twist), rel=1e-4)
