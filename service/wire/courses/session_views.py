"""Sessions, attempts and stored reports as JSON."""

from collections.abc import Mapping
from typing import Any

from courses.attempts.stored_attempts import shown_now
from courses.model import Attempt, CourseSession, ListedAttempt, StudentStanding
from courses.people.sessions import SESSION
from courses.policies import Shown, attempts_allowed, deadline, refusal
from exercises.instance import variant_of
from service.course_resources import now
from service.wire.exercises.verdicts import report_body, restored


def seed_of(session: CourseSession) -> str | None:
    """Return the seed of a student's values: the same for a student as long as the link's settings are."""
    settings, own = session.link.settings, session.person.key[:16]
    if settings.variants is not None:
        return variant_of(settings.exercise_id or "", own, settings.variants)
    return own if settings.per_student else None


def session_view(session: CourseSession, standing: StudentStanding, version: str | None) -> dict[str, Any]:
    """Return who is signed in, for what, by which rules, and how far they are."""
    grade, draft = standing.grade, standing.draft
    settings, at = session.link.settings, now()
    policy = settings.policy
    closes = deadline(policy, session.allowance)
    fault = refusal(policy, session.made, session.allowance, at)
    shown = shown_now(session, session.made, at)
    return {
        "person": {"key": session.person.key, "name": session.person.name},
        "role": session.role.value,
        "course": {"title": session.course.title},
        "link": {"id": session.link.id, "title": session.link.title},
        "exercise": settings.exercise_id,
        "version": version,
        "seed": seed_of(session),
        "parts": list(settings.parts),
        "help": settings.help,
        "points": settings.points,
        "language": settings.language,
        "mode": policy.mode.value,
        "attempts_allowed": attempts_allowed(policy, session.allowance),
        "attempts_made": session.made,
        "counting": policy.counting.value,
        "penalty": policy.penalty,
        "opens": policy.opens.isoformat() if policy.opens else None,
        "closes": closes.isoformat() if closes else None,
        "refusal": fault.code if fault else None,
        "shown": shown.value,
        "grade": None
        if shown is Shown.RECEIPT or grade is None
        else {"score": grade.worth, "attempt": grade.number},
        "gradebook": bool(session.link.line_item or session.link.line_items),
        "attempts": [attempt_entry(attempt, shown) for attempt in standing.latest],
        "draft": None if draft is None else {"state": draft.state, "at": draft.at.isoformat()},
        "return_url": session.return_url,
        "now": at.isoformat(),
        "expires_in": int(SESSION.total_seconds()),
    }


def attempt_entry(attempt: Attempt | ListedAttempt, shown: Shown) -> dict[str, Any]:
    """Return one attempt in a list, as far as it may be shown."""
    told = shown is not Shown.RECEIPT
    return {
        "number": attempt.number,
        "version": attempt.version,
        "at": attempt.at.isoformat(),
        "score": attempt.score if told else None,
        "correct": attempt.correct if told else None,
    }


def attempt_view(attempt: Attempt, shown: Shown, language: str) -> dict[str, Any]:
    """Return one attempt with what was found, as far as it may be shown."""
    return {
        **attempt_entry(attempt, shown),
        "form": attempt.form,
        "answer": attempt.answer,
        "exercise": attempt.exercise_id,
        "seed": attempt.seed,
        "shown": shown.value,
        "report": masked(stored_report(attempt.report, language), shown),
    }


def masked(report: Mapping[str, Any], shown: Shown) -> dict[str, Any] | None:
    """Return a report as far as it may be shown: nothing, right or wrong with the score, or all."""
    if shown is Shown.RECEIPT:
        return None
    if shown is Shown.ALL:
        return dict(report)
    hidden: dict[str, Any] = {name: [] for name in ("links", "feedback", "repairs")}
    hidden |= dict.fromkeys(("certificate", "figure", "departure"))
    parts = {
        kind: {**part, "facts": [], "feedback": []} for kind, part in dict(report.get("parts") or {}).items()
    }
    return {**report, **hidden, "parts": parts}


def stored_report(report: Mapping[str, Any], language: str) -> dict[str, Any]:
    """Return a stored report with its sentences, in any language."""
    return report_body(restored(report), language)
