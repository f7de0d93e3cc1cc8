"""A length along an axis past a slider, or between all but parallel axes, is held to its digits, too."""

from random import Random

import pytest

from exercises.grading import Policy, ToolRule, grade
from kinematics.equivalence.reference import prepared
from kinematics.table import NumericTable
from tests.exercises.grading.written import Cell, read, written
from tests.kinematics.equivalence.generators import random_valid_table
from tests.kinematics.equivalence.tables import P, R, changed, standard

ELBOW, WRIST = (R, 1.234567, 0.1, 0.4, 0.2345678), (R, 0.912345, 0.1, 0.3, 0.2345678)
TURNS, SLIDES = (R, 1.034567, 0.05, 0.15, 0.345678), (P, 1.123456, 0.2, 0.15, 0.812345)
KEYS = {
    "behind": (standard(ELBOW, TURNS, SLIDES, WRIST), 2),
    "before": (standard(ELBOW, SLIDES, TURNS, WRIST), 3),
    "both": (standard(ELBOW, SLIDES, TURNS, (P, 0.8765432, 0.1, 0.1, 0.712345), WRIST), 3),
}
FREE = Policy(tool=ToolRule.FREE)


@pytest.mark.parametrize(("key", "row"), KEYS.values(), ids=KEYS)
def test_what_the_pose_would_not_show_is_wrong_in_all_frames(key: NumericTable, row: int) -> None:
    wrong = changed(key, row, d=key.rows[row - 1].d + 0.01 * prepared(key).size)
    verdicts = [grade(written(key), written(drawn(wrong, seed)), FREE) for seed in range(6)]
    assert not any(verdict.correct for verdict in verdicts)
    assert len({verdict.score for verdict in verdicts}) == 1
    right = [grade(written(key), written(drawn(key, seed)), FREE) for seed in range(6)]
    assert all(verdict.correct for verdict in right)


@pytest.mark.parametrize("sine", [0.015, 0.008])
def test_offsets_along_axes_that_are_all_but_parallel_are_two(sine: float) -> None:
    """What is moved from one to the other shows in poses by its hundredth."""
    between = (R, sine, 0.31, 0.2, 0.4), (R, 1.1, 0.17, 0.3, 0.3)
    key = standard(ELBOW, *between, WRIST)
    moved = changed(changed(key, 2, d=0.2 + 0.1), 3, d=0.3 - 0.1)
    assert not grade(written(key), written(moved), FREE).correct
    assert grade(written(key), written(drawn(key, 1)), FREE).correct


def drawn(table: NumericTable, seed: int) -> NumericTable:
    return random_valid_table(table, Random(seed))


def test_a_length_left_out_is_told_before_sums_that_no_key_has() -> None:
    """Along parallel axes several edits would do, with either sign: the key's own length comes first."""
    values = {"d1": 0.5, "d2": 0.8, "d3": 0.3, "a3": 0.6, "a4": 0.7}
    rows: list[tuple[Cell, Cell, Cell, Cell]] = [
        (-90, 0, "d1", "q1"),
        (90, 0, "d2", "q2"),
        (0, "-a3", "-d3", "q3"),
        (0, "-a4", "-d2", "q4"),
        (-90, 0, "-d3", "q5"),
        (90, 0, "-d2", "q6"),
    ]
    for row in (3, 4, 5):
        alpha, a, _, theta = rows[row - 1]
        answer = [*rows[: row - 1], (alpha, a, 0, theta), *rows[row:]]
        verdict = grade(read("standard", rows, "deg"), read("standard", answer, "deg"), FREE, values)
        assert [(edit.code, edit.row) for edit in verdict.repairs[0].edits] == [("d_missing", row)]
