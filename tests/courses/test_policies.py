"""Laws of the policies: which attempt counts, what it is worth, what may be shown."""

from datetime import UTC, datetime, timedelta

from hypothesis import given
from hypothesis import strategies as st

from courses.policies import (
    Allowance,
    AttemptOutcome,
    AttemptPolicy,
    Counting,
    FeedbackTiming,
    Mode,
    Shown,
    advanced,
    counted,
    disclosed,
    refusal,
    score_due,
    worth,
)

START = datetime(2027, 1, 1, tzinfo=UTC)
ORDER = [Shown.RECEIPT, Shown.VERDICT, Shown.ALL]

minutes = st.integers(0, 10_000).map(lambda m: START + timedelta(minutes=m))
extra = st.integers(0, 5_000).map(lambda m: timedelta(minutes=m))
policies = st.builds(
    AttemptPolicy,
    attempts=st.none() | st.integers(1, 6),
    counting=st.sampled_from(Counting),
    penalty=st.floats(0, 1),
    opens=st.none() | minutes,
    closes=st.none() | minutes,
    feedback=st.sampled_from(FeedbackTiming),
    feedback_after=st.integers(1, 5),
    mode=st.sampled_from(Mode),
)
outcomes = st.lists(st.tuples(st.integers(0, 10_000), st.floats(0, 1)), max_size=6).map(
    lambda found: [
        AttemptOutcome(number=i, at=START + timedelta(minutes=m), score=score)
        for i, (m, score) in enumerate(sorted(found, key=lambda item: item[0]), 1)
    ]
)


@given(policies, outcomes)
def test_a_grade_is_the_worth_of_a_timely_attempt_or_there_is_none(policy, made) -> None:
    found = counted(policy, made, Allowance())
    timely = [o for o in made if policy.closes is None or o.at <= policy.closes]
    assert (found is None) == (not timely)
    if found:
        chosen = next(o for o in timely if o.number == found.number)
        assert found.worth == worth(policy, chosen)
        assert 0.0 <= found.worth <= chosen.score


@given(policies, outcomes)
def test_the_best_is_never_beaten_and_never_falls_with_one_more_attempt(policy, made) -> None:
    if policy.counting is not Counting.BEST:
        return
    grades = [
        found.worth for n in range(1, len(made) + 1) if (found := counted(policy, made[:n], Allowance()))
    ]
    assert grades == sorted(grades)
    final = counted(policy, made, Allowance())
    if final:
        timely = [o for o in made if policy.closes is None or o.at <= policy.closes]
        assert final.worth == max(worth(policy, o) for o in timely)


@given(policies, outcomes, extra)
def test_a_grade_that_follows_attempt_by_attempt_is_the_grade_of_all(policy, made, more) -> None:
    allowance = Allowance(extra_time=more)
    grade = None
    for n, outcome in enumerate(made, 1):
        grade = advanced(policy, grade, outcome, allowance)
        assert grade == counted(policy, made[:n], allowance)


@given(policies, outcomes, extra)
def test_extra_time_takes_no_attempt_and_no_grade_away(policy, made, more) -> None:
    plain, favoured = counted(policy, made, Allowance()), counted(policy, made, Allowance(extra_time=more))
    assert plain is None or favoured is not None
    if plain and favoured and policy.counting is Counting.BEST:
        assert favoured.worth >= plain.worth
    for outcome in made:
        if refusal(policy, 0, Allowance(), outcome.at) is None:
            assert refusal(policy, 0, Allowance(extra_time=more), outcome.at) is None


@given(policies, st.integers(0, 10), st.integers(0, 10), minutes)
def test_attempts_are_taken_until_they_are_used_up(policy, made, additional, now) -> None:
    fault = refusal(policy, made, Allowance(extra_attempts=additional), now)
    used = policy.attempts is not None and made >= policy.attempts + additional
    early = policy.opens is not None and now < policy.opens
    late = policy.mode is Mode.EXAM and policy.closes is not None and now > policy.closes
    assert (fault is not None) == (used or early or late)


@given(policies, st.integers(0, 10), minutes, extra, extra)
def test_what_is_shown_only_grows(policy, made, now, later, longest) -> None:
    def level(made: int, now: datetime, released: bool) -> int:
        return ORDER.index(disclosed(policy, made, now, released=released, longest=longest))

    assert level(made, now, False) <= level(made, now + later, False) <= level(made, now + later, True) == 2
    assert level(made, now, False) <= level(made + 1, now, False)


@given(policies, minutes, extra)
def test_no_mark_goes_out_before_its_student_may_know_it(policy, now, longest) -> None:
    due = score_due(policy, now, released=False, longest=longest)
    if due is None:
        assert policy.feedback is FeedbackTiming.ON_RELEASE or policy.closes is None
    else:
        assert disclosed(policy, 1, due, released=False, longest=longest) is not Shown.RECEIPT
    assert score_due(policy, now, released=True, longest=longest) == now


def test_nobody_sees_an_exam_while_somebody_still_writes() -> None:
    policy = AttemptPolicy(mode=Mode.EXAM, closes=START)
    after = START + timedelta(minutes=5)
    assert disclosed(policy, 1, after, released=False, longest=timedelta(minutes=10)) is Shown.RECEIPT
    assert disclosed(policy, 1, after, released=False, longest=timedelta()) is Shown.ALL


def test_a_penalty_is_taken_for_each_attempt_before() -> None:
    policy = AttemptPolicy(penalty=0.1)
    made = [AttemptOutcome(number=n, at=START, score=s) for n, s in ((1, 0.4), (2, 0.5), (3, 1.0))]
    found = counted(policy, made, Allowance())
    assert found is not None
    assert (found.number, round(found.worth, 12)) == (3, 0.8)
