"""What is wrong with a table: as few facts as explain it, each of its own kind, with its own amount."""

from __future__ import annotations

from random import Random

import pytest

from kinematics.chain import chain_of_table
from kinematics.equivalence import Kind, Policy, ToolRule
from kinematics.equivalence.diagnosis import diagnose
from kinematics.equivalence.reference import prepared
from kinematics.equivalence.results import Mismatch
from kinematics.table import NumericTable
from tests.kinematics.equivalence.campaign import catalogue
from tests.kinematics.equivalence.generators import random_valid_table
from tests.kinematics.equivalence.tables import HALF, P, R, changed, standard

FREE = Policy(tool=ToolRule.FREE)
SLIDERS = standard(
    (R, HALF, 0, 0.2, 0), (R, 0.7, 0.4, 0.3, 0), (P, 0.6, 0.1, 0, 0), (P, 0.8, 0, 0, 0.3), (R, 0, 0, 0.2, 0)
)


def told(key: NumericTable, table: NumericTable, row: int, cell: str, by: float) -> tuple[Mismatch, ...]:
    """What is said when a cell of a right table (its row counted from 1) is off."""
    wrong = changed(table, row, **{cell: getattr(table.rows[row - 1], cell) + by})
    return diagnose(prepared(key), wrong, chain_of_table(wrong), FREE)


@pytest.mark.parametrize(("robot", "row"), [("cloos", 5), ("panda", 3), ("puma560", 5), ("ssrms", 2)])
def test_one_wrong_twist_is_one_wrong_fact(robot: str, row: int) -> None:
    """Which way axes point shows only at the axes behind them: several ways are followed side by side."""
    key = dict(catalogue())[robot]
    table = random_valid_table(key, Random(robot), dummies=0.0, textbook_ends=True)
    (mismatch,) = told(key, table, row, "alpha", 0.7)
    assert (mismatch.kind, mismatch.row) == (Kind.TWIST, row - 1)


@pytest.mark.parametrize(
    ("row", "cell", "by", "kind"),
    [
        (2, "alpha", 0.2, Kind.TWIST),
        (3, "alpha", 0.2, Kind.TWIST),
        (4, "theta", 0.4, Kind.OFFSET),
    ],
)
def test_angles_of_sliders_are_told_with_their_amounts(row: int, cell: str, by: float, kind: Kind) -> None:
    (mismatch,) = told(SLIDERS, SLIDERS, row, cell, by)
    assert (mismatch.kind, mismatch.row) == (kind, row - 1)
    assert mismatch.angle == pytest.approx(by)


def test_a_slider_that_is_turned_turns_what_comes_behind_it() -> None:
    first, second = told(SLIDERS, SLIDERS, 3, "theta", 0.3)
    assert (first.kind, first.row, second.kind, second.row) == (Kind.OFFSET, 2, Kind.OFFSET, 3)
    assert first.angle == pytest.approx(0.3)
    assert 0.2 < second.angle < 0.3
