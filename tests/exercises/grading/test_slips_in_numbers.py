"""What a wrong number is told to be: another unit, radians among degrees, a row twice."""

import math
from itertools import combinations

import pytest

from exercises.grading import Policy, ToolRule, explanation, grade
from exercises.grading.edits.repaired import Repaired
from exercises.grading.edits.repairs import find_repairs
from exercises.grading.edits.work import Work
from exercises.grading.judging.name_values import FREE_ATTEMPTS, Values, drawn_value
from exercises.grading.judging.typed import meant_in_radians
from kinematics.cells.binding import ParameterKind
from tests.exercises.grading.test_grade import KEY, PUMA, PUMA_CRAIG, USUAL, VALUES, Rows, numbers, with_cells
from tests.exercises.grading.told import codes, repairs
from tests.exercises.grading.written import Cell, read

RAD = math.pi / 180


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
    assert "length_wrong" not in codes(verdict)


def in_degrees(rows: Rows) -> Rows:
    """α in degrees, in a table that declares radians."""
    degrees = {"pi/2": 90, "-pi/2": -90, "pi/4": 45}
    return [(degrees.get(str(alpha), alpha), *rest) for alpha, *rest in rows]  # type: ignore[misc]


def in_millimetres(rows: Rows) -> Rows:
    return [(alpha, a * 1000, d * 1000, theta) for alpha, a, d, theta in numbers(rows)]  # type: ignore[operator]


def without(row: int, rows: Rows) -> Rows:
    left = [cells[:3] for i, cells in enumerate(rows, 1) if i != row]
    return [(*cells, f"q{i}") for i, cells in enumerate(left, 1)]


THREE_WRONG = with_cells(PUMA, (2, 0, "pi/4"), (3, 1, "d4"), (4, 2, "d3"))
ONE_WRONG = with_cells(PUMA, (4, 2, "d3"))
EXTRA: Rows = [*ONE_WRONG, ("pi/2", 0, 0, "q7")]
OTHER_TYPE: Rows = [
    (alpha, a, theta, 0) if i == 2 else (alpha, a, d, theta)
    for i, (alpha, a, d, theta) in enumerate(ONE_WRONG)
]


@pytest.mark.parametrize(
    ("rows", "hint", "wrong"),
    [
        (in_millimetres(THREE_WRONG), "lengths_throughout", {2, 3, 4}),
        (in_degrees(with_cells(ONE_WRONG, (2, 1, "a3"))), "angles_throughout", {2, 4}),
        (in_degrees(THREE_WRONG), "angles_throughout", {2, 3, 4}),
        (in_degrees(without(5, ONE_WRONG)), "angles_throughout", {4, 5}),
        (in_degrees(without(2, ONE_WRONG)), "angles_throughout", {2, 3}),
        (in_millimetres(without(5, ONE_WRONG)), "lengths_throughout", {4, 5}),
        (in_degrees(EXTRA), "angles_throughout", {4, 7}),
        (in_degrees(OTHER_TYPE), "angles_throughout", {3, 4}),
    ],
)
def test_a_unit_throughout_is_told_in_names_and_beside_wrong_joints_too(
    rows: Rows, hint: str, wrong: set[int]
) -> None:
    """Of these nothing was told but that the joints are wrong, or all twists and lengths were accused."""
    verdict = grade(KEY, read("standard", rows), USUAL, VALUES)
    assert hint in codes(verdict)
    assert {entry.row for entry in verdict.feedback if entry.row} == wrong


@pytest.mark.parametrize("rows", [without(5, THREE_WRONG), without(5, numbers(THREE_WRONG)), THREE_WRONG])
def test_no_unit_is_told_that_is_not_wrong(rows: Rows) -> None:
    verdict = grade(KEY, read("standard", rows), USUAL, VALUES)
    assert not [entry for entry in verdict.feedback if entry.code.endswith("_throughout")]


def test_what_is_wrong_beside_a_unit_is_searched_by_the_work_that_is_left(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Two searches together cost what one may: the second had half as much again."""
    granted: list[int] = []
    left: list[int] = []

    def counted(work: Work) -> tuple[Repaired, ...]:
        granted.append(work.meter.left)
        found = find_repairs(work)
        left.append(work.meter.left)
        return found

    monkeypatch.setattr(explanation, "find_repairs", counted)
    monkeypatch.setattr(explanation, "MOST_WORK", 1500)
    rows = in_degrees(with_cells(THREE_WRONG, (5, 2, "d4")))
    verdict = grade(KEY, read("standard", rows), USUAL, VALUES)
    assert "angles_throughout" in codes(verdict)
    assert granted == [1500, left[0]]
    assert left[0] < 750
