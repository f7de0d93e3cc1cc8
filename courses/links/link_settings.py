"""Settings of a link as JSON: what a lecturer sends is checked, what is stored is read as it stands."""

import hashlib
import json
from collections.abc import Callable, Collection, Mapping
from datetime import UTC, datetime
from typing import Any, TypeVar

from courses.model import LinkSettings
from courses.policies import AttemptPolicy, Counting, FeedbackTiming, Mode
from courses.refusals import CourseError
from exercises.access import MOST_VARIANTS
from exercises.grading import HelpLevel
from kinematics.errors import Fault

Choice = TypeVar("Choice", Mode, Counting, FeedbackTiming)

MOST_ATTEMPTS = 1000
MOST_POINTS = 1_000_000.0  # More than any course gives; so that a slip of the finger is refused.
LATEST = datetime(9000, 1, 1, tzinfo=UTC)
"""No course closes later, and with any extra time it is still a time: Python's calendar ends with 9999."""


class LinkSettingsError(CourseError):
    """Settings of a link that cannot be meant."""


def written(settings: LinkSettings) -> dict[str, Any]:
    """Return the settings as JSON, without the exercise."""
    policy = settings.policy
    return {
        "parts": list(settings.parts),
        "help": settings.help,
        "points": settings.points,
        "per_student": settings.per_student,
        "variants": settings.variants,
        "language": settings.language,
        "attempts": policy.attempts,
        "counting": policy.counting.value,
        "penalty": policy.penalty,
        "opens": policy.opens.isoformat() if policy.opens else None,
        "closes": policy.closes.isoformat() if policy.closes else None,
        "feedback": policy.feedback.value,
        "feedback_after": policy.feedback_after,
        "mode": policy.mode.value,
    }


def version_of(settings: LinkSettings) -> str:
    """Return what tells these settings from those that somebody else has saved meanwhile."""
    content = json.dumps([settings.exercise_id, written(settings)], sort_keys=True)
    return hashlib.sha256(content.encode()).hexdigest()[:16]


def read(
    exercise_id: str | None, values: Mapping[str, Any], *, parts: Collection[str], languages: Collection[str]
) -> LinkSettings:
    """Return settings that somebody has just made; what is left out has its default.

    Raises:
        LinkSettingsError: a value cannot be meant, or there is no such setting; each with its place.
    """
    reader = _SettingsReader(values)
    settings = _understood(exercise_id, reader)
    if any(part not in parts for part in settings.parts):
        reader.refuse("parts", ", ".join(parts))
    if settings.language is not None and settings.language not in languages:
        reader.refuse("language", ", ".join(languages))
    allowed = tuple(written(settings))
    for name in values:
        if name not in allowed:
            reader.faults.append(Fault.at("field_unknown", name, field=name, allowed=allowed))
    if reader.faults:
        raise LinkSettingsError(reader.faults)
    return settings


def stored(exercise_id: str | None, values: Mapping[str, Any]) -> LinkSettings:
    """Return settings that stand in the database, or that a platform's link brings.

    What cannot be meant has its default: whoever opens the link cannot mend it.
    """
    return _understood(exercise_id, _SettingsReader(values))


def _understood(exercise_id: str | None, reader: "_SettingsReader") -> LinkSettings:
    policy = AttemptPolicy(
        attempts=reader.whole("attempts", None, 1, MOST_ATTEMPTS),
        counting=reader.choice("counting", Counting.BEST),
        penalty=reader.number("penalty", 0.0, 0.0, 1.0),
        opens=reader.instant("opens"),
        closes=reader.instant("closes"),
        feedback=reader.choice("feedback", FeedbackTiming.AT_ONCE),
        feedback_after=reader.whole("feedback_after", 1, 1, MOST_ATTEMPTS) or 1,
        mode=reader.choice("mode", Mode.PRACTICE),
    )
    if policy.opens and policy.closes and policy.opens >= policy.closes:
        reader.faults.append(Fault.at("closes_before_opening", "closes"))
    points = reader.number("points", 1.0, 0.0, MOST_POINTS)
    if points == 0.0:
        reader.refuse("points", "a number above 0")
        points = 1.0
    return LinkSettings(
        exercise_id=exercise_id,
        parts=reader.texts("parts"),
        help=reader.help_level("help"),
        points=points,
        per_student=reader.whether("per_student"),
        variants=reader.whole("variants", None, 1, MOST_VARIANTS),
        language=reader.text("language"),
        policy=policy,
    )


class _SettingsReader:
    """Reads values; keeps the faults of all of them."""

    def __init__(self, values: Mapping[str, Any]) -> None:
        self.values = values
        self.faults: list[Fault] = []

    def refuse(self, name: str, known: str) -> None:
        """Keep a fault of one value."""
        self.faults.append(Fault.at("setting_invalid", name, name=name, known=known))

    def whole(self, name: str, otherwise: int | None, least: int, most: int) -> int | None:
        """Return a whole number, or what it is otherwise."""
        found: int | None = self._found(
            name, lambda value: type(value) is int and least <= value <= most, f"{least} … {most}", otherwise
        )
        return found

    def number(self, name: str, otherwise: float, least: float, most: float) -> float:
        """Return a number."""
        known = f"{least:g} … {most:g}"
        return float(
            self._found(
                name, lambda value: type(value) in (int, float) and least <= value <= most, known, otherwise
            )
        )

    def text(self, name: str) -> str | None:
        """Return a short text."""
        return self._found(name, lambda value: isinstance(value, str) and len(value) <= 64, "≤ 64") or None

    def texts(self, name: str) -> tuple[str, ...]:
        """Return a list of texts."""
        found = self._found(
            name,
            lambda value: not value or (isinstance(value, list) and all(isinstance(v, str) for v in value)),
            "[…]",
        )
        return tuple(dict.fromkeys(found or ()))

    def whether(self, name: str) -> bool:
        """Return yes or no."""
        return bool(self._found(name, lambda value: isinstance(value, bool), "false, true"))

    def help_level(self, name: str) -> str | None:
        """Return the most help given; None for what the exercise gives."""
        known = list(HelpLevel)
        return self._found(name, lambda value: not value or value in known, ", ".join(known)) or None

    def choice(self, name: str, otherwise: Choice) -> Choice:
        """Return one of the values of an enumeration."""
        kind = type(otherwise)
        known = [item.value for item in kind]
        return kind(self._found(name, lambda value: value in known, ", ".join(known), otherwise))

    def instant(self, name: str) -> datetime | None:
        """Return a time with its zone (RFC 3339)."""
        value = self.values.get(name)
        if value is None or value == "":
            return None
        try:
            found = datetime.fromisoformat(str(value))
            if found.tzinfo is not None and found.astimezone(UTC) < LATEST:
                return found.astimezone(UTC)
        except (ValueError, OverflowError):
            pass
        self.refuse(name, "2027-01-31T12:00:00+00:00")
        return None

    def _found(self, name: str, fits: Callable[[Any], bool], known: str, otherwise: Any = None) -> Any:
        """The value, if it fits; what it is otherwise where it is left out, or refused."""
        value = self.values.get(name)
        if value is None or fits(value):
            return otherwise if value is None else value
        self.refuse(name, known)
        return otherwise
