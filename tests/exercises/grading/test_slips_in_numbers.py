"""What a wrong number is told to be: another unit, radians among degrees, a row twice."""

from __future__ import annotations

import math
from itertools import combinations

import pytest

from exercises.grading import Policy, ToolRule, Verdict, grade
from exercises.grading.judging.name_values import FREE_ATTEMPTS, Values, drawn_value
from exercises.grading.judging.typed import meant_in_radians
from kinematics.cells.binding import ParameterKind
from tests.exercises.grading.test_grade import KEY, PUMA, PUMA_CRAIG, USUAL, VALUES, Rows, numbers, with_cells
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


@pytest.mark.parametrize("lengths", [("L", "x", "M"), ("x", "x", "M"), ("L", "L", "x")])
def test_a_name_that_the_key_does_not_know(lengths: tuple[str, str, str]) -> None:
    """Also where every name of the key stands somewhere: two links are of one length."""
    key = read("standard", [(0, "L", 0, "q1"), (0, "L", 0, "q2"), (0, "M", 0, "q3")])
    answer = read("standard", [(0, length, 0, f"q{i}") for i, length in enumerate(lengths, 1)])
    verdict = grade(key, answer, Policy(tool=ToolRule.POINT), {"L": 0.5, "M": 0.3})
    assert repairs(verdict)[0] == [("parameter_misnamed", None)]


UR: Rows = [
    ("pi/2", 0, "d1", "q1"),
    (0, "a2", 0, "q2"),
    (0, "a3", 0, "q3"),
    ("pi/2", 0, "d4", "q4"),
    ("-pi/2", 0, "d5", "q5"),
    (0, 0, "d6", "q6"),
]
UR_VALUES = {"d1": 0.0892, "a2": -0.425, "a3": -0.3922, "d4": 0.1091, "d5": 0.0947, "d6": 0.0823}


@pytest.mark.parametrize(
    ("changes", "score"),
    [
        ([(2, 0, "pi/2")], 0.86),
        ([(2, 0, "pi/2"), (4, 2, 0)], 0.62),
        ([(2, 0, "pi/2"), (5, 0, "pi/4")], 0.48),
        ([(3, 0, "pi/2"), (2, 1, 0)], 0.48),
        ([(2, 0, "pi/2"), (3, 0, "pi/2")], 0.39),
    ],
)
def test_what_a_twist_among_parallel_axes_takes_with_it(
    changes: list[tuple[int, int, Cell]], score: float
) -> None:
    """Of a UR, the one offset along three parallel axes is none where two of them are not parallel."""
    answer = read("standard", with_cells(UR, *changes))
    assert grade(read("standard", UR), answer, USUAL, UR_VALUES).score == score


@pytest.mark.parametrize(
    "names", [names for n in range(len(VALUES) + 1) for names in combinations(VALUES, n)], ids="-".join
)
def test_the_other_convention_with_values_for_some_names(names: tuple[str, ...]) -> None:
    """No fact tells whether a number is the value of a name there: all of them are wrong."""
    given = {name: VALUES[name] for name in names}
    rows: Rows = [tuple(given.get(str(cell), cell) for cell in row) for row in PUMA_CRAIG]  # type: ignore[misc]
    verdict = grade(KEY, read("standard", rows), USUAL, VALUES)
    assert repairs(verdict)[0] == [("convention", None)]
    assert verdict.score == 0.67
    assert "length_wrong" not in [entry.code for entry in verdict.feedback]
