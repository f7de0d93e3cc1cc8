"""What a wrong number is told to be: another unit, radians among degrees, a row twice."""

from __future__ import annotations

import math

import pytest

from exercises.grading import Verdict, grade
from exercises.grading.judging.name_values import FREE_ATTEMPTS, Values, drawn_value
from exercises.grading.judging.typed import meant_in_radians
from kinematics.cells.binding import ParameterKind
from tests.exercises.grading.test_grade import KEY, PUMA, USUAL, VALUES, Rows, numbers, with_cells
from tests.exercises.grading.written import Cell, read

RAD = math.pi / 180


def repairs(verdict: Verdict) -> list[list[tuple[str, int | None]]]:
    return [[(edit.code, edit.row) for edit in repair.edits] for repair in verdict.repairs]


@pytest.mark.parametrize("power", [10, 100, 1000])
@pytest.mark.parametrize(("row", "column", "name"), [(2, 1, "a2"), (4, 2, "d4")])
def test_a_length_in_another_unit(row: int, column: int, name: str, power: int) -> None:
    code = "cell_length_unit"
    for value in (VALUES[name] * power, VALUES[name] / power):
        rows = with_cells(numbers(PUMA), (row, column, round(value, 9)))
        assert repairs(grade(KEY, read("standard", rows), USUAL, VALUES)) == [[(code, row)]]


@pytest.mark.parametrize(
    ("typed", "meant"), [(1.57, math.pi / 2), (-1.57, -math.pi / 2), (0.79, math.pi / 4), (1.4, 1.4)]
)
def test_radians_where_degrees_are_declared(typed: float, meant: float) -> None:
    assert meant_in_radians(typed * RAD) == pytest.approx(meant, abs=1e-12)


def test_values_drawn_in_vain_come_nearer_to_the_given_one() -> None:
    values = Values(kinds={"a2": ParameterKind.LENGTH}, given={"a2": 0.4}, scale=3.0)
    for attempt in range(FREE_ATTEMPTS, FREE_ATTEMPTS + 80, 4):
        bound = 0.6 / (1 + (attempt - FREE_ATTEMPTS) // 4)
        drawn = [drawn_value("a2", attempt + i, values) / 0.4 - 1.0 for i in range(4)]
        assert max(map(abs, drawn)) <= bound * (1 + 1e-12)
    early = [drawn_value("a2", attempt, values) for attempt in range(FREE_ATTEMPTS)]
    assert min(early) > 1.0


@pytest.mark.parametrize("rows", [1, 2])
def test_a_joint_too_many_of_a_short_arm(rows: int) -> None:
    links: list[tuple[Cell, Cell, Cell, Cell]] = [("pi/2", "L1", 0, "q1"), (0, "L2", 0, "q2")]
    key: Rows = links[:rows]
    more: Rows = [*key, ("pi/4", "L1", 0, f"q{rows + 1}")]
    names = {"L1": 0.4, "L2": 0.3}
    values = {name: names[name] for name in ("L1", "L2")[:rows]}
    found = repairs(grade(read("standard", key), read("standard", more), USUAL, values))
    assert [("row_extra", rows + 1)] in found
