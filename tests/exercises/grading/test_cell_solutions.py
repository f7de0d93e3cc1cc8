"""Cells from the invariants: what is found solves its equation, and what solves it is found."""

import math
from dataclasses import replace

import numpy as np
import pytest

from exercises.grading import Policy, ToolRule
from exercises.grading.edits.fitting import (
    MOST_SIGNS,
    SMALL_TURN,
    _angles,
    _lengths,
    _likely_signs,
    _turns,
)
from kinematics.chain import chain_of_table
from kinematics.equivalence.cell_fitting import fitted_cells
from kinematics.equivalence.diagnosis import likely_signs
from kinematics.equivalence.meter import Meter
from kinematics.equivalence.reference import prepared
from tests.kinematics.equivalence.campaign import references

FREE = Policy(tool=ToolRule.FREE)
RNG = np.random.default_rng(11)
WAVES = RNG.uniform(-1.0, 1.0, (60, 4)).tolist()


@pytest.mark.parametrize(("a", "b", "c", "target"), WAVES)
def test_angles_at_which_a_wave_has_a_size(a: float, b: float, c: float, target: float) -> None:
    def wave(x: float) -> float:
        return a + b * math.cos(x) + c * math.sin(x)

    third = 2.0 * math.pi / 3.0
    found = list(_angles([wave(0.0), wave(third), wave(-third)], target))
    for x in found:
        assert abs(x) <= math.pi
        assert min(abs(wave(x) - target), abs(wave(x) + target)) < 1e-9
    grid = np.linspace(-math.pi, math.pi, 20_001)
    crossings = sum(
        int((np.diff(np.sign(a + b * np.cos(grid) + c * np.sin(grid) - goal)) != 0).sum())
        for goal in (target, -target)
    )
    assert len(found) == crossings


def test_an_angle_at_which_a_wave_is_greatest_is_found() -> None:
    third = 2.0 * math.pi / 3.0
    around = [0.2 + 0.5 * math.cos(x - 0.3) for x in (0.0, third, -third)]
    found = list(_angles(around, 0.7))
    assert found == pytest.approx([0.3] * len(found), abs=1e-6)
    assert found
    assert list(_angles([0.4, 0.4, 0.4], 0.4)) == []


@pytest.mark.parametrize("seed", range(20))
def test_lengths_at_which_a_square_is_met(seed: int) -> None:
    rng = np.random.default_rng(seed)
    a, b, c, here, scale = *rng.uniform(0.2, 2.0, 3), rng.uniform(-1.0, 1.0), rng.uniform(0.1, 1.0)

    def square(x: float) -> float:
        return float(a * x * x + b * x + c)

    least = c - b * b / (4.0 * a)
    target = math.sqrt(max(least, 0.0) + rng.uniform(0.1, 2.0))
    found = list(_lengths(square(here - scale), square(here), square(here + scale), target, here, scale))
    assert len(found) == 2
    assert found[0] != pytest.approx(found[1])
    assert [square(x) for x in found] == pytest.approx([target**2] * 2)


def test_a_square_that_is_nowhere_met_is_least_where_it_comes_nearest() -> None:
    assert list(_lengths(5.0, 2.0, 1.0, 0.5, here=0.0, scale=1.0)) == pytest.approx([1.0])
    assert list(_lengths(1.0, 2.0, 3.0, 0.5, here=0.0, scale=1.0)) == []


@pytest.mark.parametrize("scale", [1e-4, 1.0, 1e6])
def test_a_square_is_met_at_as_many_lengths_in_every_unit(scale: float) -> None:
    """At two that are a thousandth of the robot apart, and at one where it is but touched."""
    for apart in (0.001, 0.0):
        middle, target = 0.25 * (1.0 - apart**2 / 4.0), 0.5
        beside = middle * scale**2 + scale**2
        found = sorted(_lengths(beside, middle * scale**2, beside, target * scale, 0.3 * scale, scale))
        expected = [0.3 - apart / 4.0, 0.3 + apart / 4.0] if apart else [0.3]
        assert [x / scale for x in found] == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize("sense", [1, -1])
def test_a_turn_is_met_whichever_way_the_angle_enters_it(sense: int) -> None:
    for k, here, target in RNG.uniform([-3.0, -3.0, 0.1], [3.0, 3.0, 3.0], (20, 3)).tolist():

        def turn(x: float, k: float = k) -> float:
            return abs(math.remainder(k + sense * x, 2.0 * math.pi))

        found = list(_turns(turn(here) ** 2, turn(here + SMALL_TURN) ** 2, here, target))
        assert sum(abs(turn(x) - target) < 1e-9 for x in found) >= 2
        assert list(_turns(turn(here) ** 2, turn(here) ** 2, here, target)) == []


@pytest.mark.parametrize("row", range(5))
def test_a_last_joint_is_not_turned_round_where_the_tool_makes_up_for_it(row: int) -> None:
    """With a right angle before it, whichever way it counts, the same cells mend the table."""
    key = dict(references())["stanford"]
    rows = list(key.rows)
    rows[row] = replace(rows[row], d=rows[row].d + 0.1, a=0.05)
    table = replace(key, rows=tuple(rows))
    every = likely_signs(prepared(key), chain_of_table(table), FREE)[:MOST_SIGNS]
    tried = _likely_signs(prepared(key), table, FREE)
    assert set(tried) < set(every)
    assert {signs[:-1] for signs in tried} == {signs[:-1] for signs in every}

    def is_mended(cell: str, signs: tuple[int, ...]) -> bool:
        places = [(row, cell), (row, "a")]
        return fitted_cells(prepared(key), table, places, signs, FREE.tolerance, Meter(10**9)) is not None

    turned = [(*signs[:-1], -signs[-1]) for signs in tried]
    for cell in ("d", "alpha"):
        assert [is_mended(cell, signs) for signs in tried] == [is_mended(cell, signs) for signs in turned]
    assert any(is_mended("d", signs) for signs in tried)
