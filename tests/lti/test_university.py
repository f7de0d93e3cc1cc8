"""The evening that `make university` draws is the one that is assumed, and queues obey their recursion."""

import numpy as np

from tests.lti.university import EVENING, Cost, Costs, Habits, evening, report, waiting


def test_a_queue_is_what_its_recursion_says() -> None:
    demand = np.random.default_rng(3).exponential(1.0, 500)
    left, expected = 0.0, []
    for asked in demand:
        left = max(0.0, left + asked - 1.05)
        expected.append(left)
    assert np.allclose(waiting(demand, 1.05), expected, rtol=0, atol=1e-9)


def test_everybody_opens_and_hands_in_at_least_once() -> None:
    habits = Habits()
    drawn = evening(20_000, habits)
    assert drawn.openings.sum() == 20_000
    assert drawn.readings[: EVENING // 2].sum() > 0
    tries = (1 - (1 - habits.success) ** habits.attempts) / habits.success
    assert 20_000 < drawn.submissions.sum() < 20_000 * tries  # the deadline ends some
    assert drawn.submissions.sum() > 0.85 * 20_000 * tries


def test_the_report_names_what_saturates_first() -> None:
    cost = Cost(service=1e-3, database=1e-4)
    text = report(2_000, Habits(), Costs(opening=cost, reading=cost, draft=cost, submission=cost))
    assert "2,000 students" in text
    assert "saturates first is" in text
    assert text.count("| 2 |") == 1
