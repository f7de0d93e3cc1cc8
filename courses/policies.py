"""What attempts are worth, whether another one is taken, and what may be shown: pure functions of attempts.

The clock is handed in. Nothing here reads a database.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime, timedelta
from enum import StrEnum

from kinematics.errors import Fault


class Mode(StrEnum):
    """Practice answers late attempts too, without counting them; an exam takes none."""

    PRACTICE = "practice"
    EXAM = "exam"


class Counting(StrEnum):
    """Which attempt makes the grade."""

    BEST = "best"
    LAST = "last"
    FIRST = "first"


class FeedbackTiming(StrEnum):
    """When a student sees what was found."""

    AT_ONCE = "at_once"
    AFTER_ATTEMPTS = "after_attempts"
    AFTER_DEADLINE = "after_deadline"
    VERDICT_ONLY = "verdict_only"
    ON_RELEASE = "on_release"


class Shown(StrEnum):
    """How much of a judgement is shown: that it was received, right or wrong with its score, or all of it."""

    RECEIPT = "receipt"
    VERDICT = "verdict"
    ALL = "all"


@dataclass(frozen=True, kw_only=True, slots=True)
class AttemptPolicy:
    """The rules of a link.

    Attributes:
        attempts: how many may be made; None for any number.
        counting: which of them makes the grade.
        penalty: what each attempt before it takes off a score, 0 … 1 of the maximum.
        opens: from when attempts are taken; None for always.
        closes: until when they count; None for ever.
        feedback: when a student sees what was found.
        feedback_after: with `after_attempts`, after how many.
        mode: practice or exam.
    """

    attempts: int | None = None
    counting: Counting = Counting.BEST
    penalty: float = 0.0
    opens: datetime | None = None
    closes: datetime | None = None
    feedback: FeedbackTiming = FeedbackTiming.AT_ONCE
    feedback_after: int = 1
    mode: Mode = Mode.PRACTICE


@dataclass(frozen=True, kw_only=True, slots=True)
class Allowance:
    """What one student is given beyond the policy."""

    extra_time: timedelta = timedelta()
    extra_attempts: int = 0


@dataclass(frozen=True, kw_only=True, slots=True)
class AttemptOutcome:
    """What policies need to know of an attempt: its number from 1, when it was handed in, its score 0 … 1."""

    number: int
    at: datetime
    score: float


@dataclass(frozen=True, kw_only=True, slots=True)
class Counted:
    """The attempt that makes the grade, and what it is worth, 0 … 1."""

    number: int
    worth: float


def deadline(policy: AttemptPolicy, allowance: Allowance) -> datetime | None:
    """Return until when a student's attempts count."""
    return None if policy.closes is None else policy.closes + allowance.extra_time


def counts_from(
    policy: AttemptPolicy, allowance: Allowance, first: datetime | None, came: datetime
) -> datetime:
    """Return as of when an attempt counts: when it came, or came first if it has become late since then."""
    closes = deadline(policy, allowance)
    return first if first is not None and closes is not None and first <= closes < came else came


def attempts_allowed(policy: AttemptPolicy, allowance: Allowance) -> int | None:
    """Return how many attempts a student has; None for any number."""
    return None if policy.attempts is None else policy.attempts + allowance.extra_attempts


def refusal(policy: AttemptPolicy, made: int, allowance: Allowance, now: datetime) -> Fault | None:
    """Return why no attempt is taken now, or None if one is."""
    if policy.opens is not None and now < policy.opens:
        return Fault.at("attempts_not_open", opens=policy.opens.isoformat())
    closes = deadline(policy, allowance)
    if policy.mode is Mode.EXAM and closes is not None and now > closes:
        return Fault.at("attempts_closed", closes=closes.isoformat())
    allowed = attempts_allowed(policy, allowance)
    if allowed is not None and made >= allowed:
        return Fault.at("attempts_used", allowed=allowed)
    return None


def worth(policy: AttemptPolicy, outcome: AttemptOutcome) -> float:
    """Return what an attempt is worth, 0 … 1: its score less the penalty for each attempt before it."""
    return min(1.0, max(0.0, outcome.score - policy.penalty * (outcome.number - 1)))


def counted(
    policy: AttemptPolicy, outcomes: Sequence[AttemptOutcome], allowance: Allowance
) -> Counted | None:
    """Return the attempt that makes the grade; None if none does. What was handed in late does not count.

    Of several best ones the first counts.
    """
    closes = deadline(policy, allowance)
    timely = sorted(
        (outcome for outcome in outcomes if closes is None or outcome.at <= closes),
        key=lambda outcome: outcome.number,
    )
    if not timely:
        return None
    if policy.counting is Counting.FIRST:
        chosen = timely[0]
    elif policy.counting is Counting.LAST:
        chosen = timely[-1]
    else:
        chosen = max(timely, key=lambda outcome: (worth(policy, outcome), -outcome.number))
    return Counted(number=chosen.number, worth=worth(policy, chosen))


def advanced(
    policy: AttemptPolicy, before: Counted | None, outcome: AttemptOutcome, allowance: Allowance
) -> Counted | None:
    """Return what makes the grade after one more attempt: `counted` of all, from that of those before."""
    latest = counted(policy, [outcome], allowance)
    if before is None or latest is None:
        return latest or before
    match policy.counting:
        case Counting.FIRST:
            return before
        case Counting.LAST:
            return latest
        case Counting.BEST:
            return latest if latest.worth > before.worth else before


def disclosed(
    policy: AttemptPolicy, made: int, now: datetime, *, released: bool, longest: timedelta
) -> Shown:
    """Return how much of a student's judgements may be shown now.

    Args:
        made: attempts that the student has made.
        released: the lecturer has released the feedback of the link.
        longest: the longest extra time of any student of the link: what is shown after the deadline waits
            until nobody can use it.
    """
    if released:
        return Shown.ALL
    closed = policy.closes is not None and now > policy.closes + longest
    if policy.mode is Mode.EXAM and not closed:
        return Shown.RECEIPT
    match policy.feedback:
        case FeedbackTiming.AT_ONCE:
            return Shown.ALL
        case FeedbackTiming.VERDICT_ONLY:
            return Shown.VERDICT
        case FeedbackTiming.AFTER_ATTEMPTS:
            return Shown.ALL if made >= policy.feedback_after else Shown.VERDICT
        case FeedbackTiming.AFTER_DEADLINE:
            return Shown.ALL if closed else Shown.RECEIPT
        case FeedbackTiming.ON_RELEASE:
            return Shown.RECEIPT


def score_due(policy: AttemptPolicy, now: datetime, *, released: bool, longest: timedelta) -> datetime | None:
    """Return when a grade may go to the gradebook: as soon as its student may know it; None until a release.

    A grade in the gradebook must not tell what the page still withholds.
    """
    if disclosed(policy, 0, now, released=released, longest=longest) is not Shown.RECEIPT:
        return now
    if policy.closes is None or policy.feedback is FeedbackTiming.ON_RELEASE:
        return None
    return policy.closes + longest + timedelta(seconds=1)
