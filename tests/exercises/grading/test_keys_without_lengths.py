"""A key all of whose axes meet has no size, and that of an answer depends on the frames that it chose."""

import math
from random import Random

from exercises.grading import Policy, ToolRule, is_accepted
from kinematics.table import NumericTable
from tests.exercises.grading.answers_campaign import as_typed, certificate_of, rounded_answers
from tests.exercises.grading.campaign import drawn_by_hand
from tests.exercises.grading.written import written
from tests.kinematics.equivalence.tables import P, R, changed, modified

FREE = Policy(tool=ToolRule.FREE)
KEY = modified(
    (R, 0.88, 0, 0, 0),
    (R, 1.65, 0, 0, 0),
    (P, -2.08, 0, 0, math.pi),
    (R, -0.08, 0, 0, 0),
    (P, 2.74, 0, 0, math.pi / 2),
    (R, 0.46, 0, 0, 0),
)


def _drawn(table: NumericTable, seeds: int) -> list[NumericTable]:
    return [drawn for seed in range(seeds) if (drawn := drawn_by_hand(table, Random(seed)))]


def test_a_wrong_length_is_wrong_in_all_frames() -> None:
    """Long frames made it small beside the size of the answer; of such an offset no fact of the key tells."""
    wrong = _drawn(changed(KEY, 4, d=0.6), 12)
    assert not any(is_accepted(written(KEY), written(table), FREE) for table in wrong)


def test_right_tables_are_right_however_they_are_rounded() -> None:
    for decimals in (3, 4, 5):
        for table in _drawn(KEY, 12):
            assert certificate_of(written(KEY), as_typed(table, decimals), FREE), decimals


def test_where_zeros_are_fixed_the_digits_of_variables_count() -> None:
    """A key without lengths is the fifth of this block."""
    assert not rounded_answers(880003, 5).failures
