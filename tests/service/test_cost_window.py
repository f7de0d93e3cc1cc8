"""Limits by cost: a sliding minute of monotonic time."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from service.http import cost_window
from service.http.cost_window import CALLERS, CostWindow

MOST = 100


class Clock:
    """Monotonic time that a test sets."""

    def __init__(self) -> None:
        self.seconds = 1000.0

    def monotonic(self) -> float:
        return self.seconds


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    made = Clock()
    monkeypatch.setattr(cost_window, "time", made)
    return made


@given(calls=st.lists(st.tuples(st.floats(0.0, 40.0), st.integers(1, MOST)), max_size=60))
def test_no_minute_between_two_ticks_costs_more_and_who_waits_is_let_in(
    calls: list[tuple[float, int]],
) -> None:
    clock, window = Clock(), CostWindow()
    allowed: list[tuple[float, int]] = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(cost_window, "time", clock)
        for pause, cost in calls:
            clock.seconds += pause
            charged = window.charge("a", cost, MOST)
            if not charged.allowed:
                assert charged.wait > 0.0
                clock.seconds += charged.wait + 1e-6
                charged = window.charge("a", cost, MOST)
            assert charged.allowed
            allowed.append((clock.seconds, cost))
            minute = clock.seconds // 60
            assert sum(c for at, c in allowed if at // 60 == minute) <= MOST
            assert 0 <= charged.left <= MOST - cost


def test_callers_do_not_pay_for_each_other_and_few_are_remembered(clock: Clock) -> None:
    window = CostWindow()
    assert window.charge("a", MOST, MOST).allowed
    assert not window.charge("a", 1, MOST).allowed
    assert window.charge("b", MOST, MOST) == (True, 0, pytest.approx(window.charge("b", MOST, MOST).wait))
    for number in range(CALLERS):
        window.charge(str(number), 1, MOST)
    assert window.charge("a", 1, MOST).allowed


def test_two_minutes_later_all_is_free(clock: Clock) -> None:
    window = CostWindow()
    window.charge("a", MOST, MOST)
    clock.seconds += 120.0
    assert window.charge("a", 1, MOST).left == MOST - 1
