"""Keys whose twists have names, and answers that give them by name, by value, or by the wrong name."""

import pytest

from exercises.grading import Policy, ToolRule, grade
from tests.exercises.grading.written import Cell, read

FREE = Policy(tool=ToolRule.FREE)
KEY = [("beta", "L1", 0, "q1"), ("-gamma", "L2", 0.1, "q2"), ("beta", "L1", 0.2, "q3"), (45, 0, 0, "q4")]
VALUES = {"beta": 31.0, "gamma": 45.0, "L1": 0.4, "L2": 0.3}


@pytest.mark.parametrize(
    ("twists", "right"),
    [
        (("beta", "-gamma", "beta"), True),
        ((31, -45, 31), True),
        ((31, "-gamma", "beta"), True),
        (("beta", -45, 31), True),
        (("beta", "-gamma", 30.6), False),
        (("gamma", "-gamma", 31), False),
    ],
)
@pytest.mark.parametrize("length", ["L2", 0.3])
def test_a_twist_is_given_by_its_name_or_by_its_value(
    twists: tuple[Cell, ...], length: Cell, *, right: bool
) -> None:
    """Here by the one and there by the other; 45 may be γ or, in the last row, what the key has."""
    rows = [(twist, *row[1:]) for twist, row in zip(twists, KEY, strict=False)]
    rows[1] = (twists[1], length, 0.1, "q2")
    answer = read("standard", [*rows, (45, 0, 0, "q4"), (0, 0.5, 0, "q5")], "deg")
    key = read("standard", [*KEY, (0, 0.5, 0, "q5")], "deg")
    assert grade(key, answer, FREE, VALUES).correct is right


def test_two_names_of_twists_exchanged_are_one_slip() -> None:
    """No sign is wrong besides."""
    exchanged = [("gamma", "L1", 0, "q1"), ("-beta", "L2", 0.1, "q2"), ("gamma", "L1", 0.2, "q3"), KEY[3]]
    verdict = grade(read("standard", KEY, "deg"), read("standard", exchanged, "deg"), FREE, VALUES)
    assert [[edit.code for edit in repair.edits] for repair in verdict.repairs] == [["parameters_swapped"]]
