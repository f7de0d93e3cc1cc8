"""Verdicts and reports as JSON, with their sentences in the caller's language.

The records of `exercises` are written field by field; `service.schemas.derived` documents the same fields.
"""

from collections.abc import Mapping
from dataclasses import fields
from functools import cache
from typing import Any, cast

import orjson
from pydantic import TypeAdapter

from exercises.grader import Report
from exercises.grading import Edit, Feedback
from service.messages import in_sentence, sentence
from service.schemas.derived import SPOKEN, carries_sentences
from service.schemas.spoken import values_told


def encoded(body: dict[str, Any] | Report) -> bytes:
    """Return a body as JSON; records of the domain are written by their fields."""
    return orjson.dumps(body, default=_plain)


def restored(report: object) -> Report:
    """Return the report that `encoded` wrote, from its JSON.

    A key that a record does not know is ignored, and one that is missing takes the field's default: what was
    stored by another version can still be shown.

    Raises:
        ValueError: the data does not fit a report.
    """
    return _reports().validate_python(report)


@cache
def _reports() -> TypeAdapter[Report]:
    return TypeAdapter(Report)


def report_body(report: Report, language: str) -> dict[str, Any]:
    """Return a report on all that was handed in: the verdict on the table, with the parts beside it."""
    return {
        **(_without_table(report) if report.verdict is None else record_body(report.verdict, language)),
        "parts": {part.kind: record_body(part, language) for part in report.parts},
        "total": {
            "points": report.points,
            "max_points": report.max_points,
            "score": report.score,
            "missing": report.missing,
        },
        "help": report.help_level,
        "seed": report.seed,
        "version": report.version,
        "figure": report.figure,
        "departure": report.departure,
        "remarks": [_in_language(texts, language) for texts in report.remarks],
    }


def _in_language(texts: Mapping[str, str], language: str) -> str:
    """Return a lecturer's words in the reader's language, else in English, else in any."""
    return next(texts[found] for found in (language, "en", *texts) if found in texts)


def _without_table(report: Report) -> dict[str, Any]:
    """Return what stands in the place of a verdict where no table was handed in."""
    most = sum(part.max_points for part in report.parts)
    return {
        "correct": report.correct,
        "score": report.points / most,
        "basis": None,
        "certificate": None,
        "links": (),
        "feedback": (),
        "repairs": (),
        "angle_unit": report.angle_unit,
        "length_unit": report.length_unit,
    }


def _written(value: Any, language: str) -> Any:
    """Return a value with its sentences; what has none stays the record that it is."""
    if isinstance(value, tuple):
        return [_written(entry, language) for entry in value] if value and _speaks(value[0]) else value
    return record_body(value, language) if _speaks(value) else value


def _speaks(value: object) -> bool:
    return hasattr(value, "__dataclass_fields__") and carries_sentences(cast(type, type(value)))


def record_body(record: Any, language: str) -> dict[str, Any]:
    """Return a record, as a verdict, with its sentences as `encoded` takes it."""
    body = {name: _written(getattr(record, name), language) for name in _names(cast(type, type(record)))}
    if type(record) in SPOKEN:
        body["message"] = _sentence(cast("Feedback | Edit", record), language)
    return body


@cache
def _names(record: type) -> tuple[str, ...]:
    return tuple(entry.name for entry in fields(record))


def _sentence(told: Feedback | Edit, language: str) -> str:
    values = in_sentence(values_told(told), language)
    return sentence(language, f"{SPOKEN[type(told)]}-{told.code}", values) or told.code


def _plain(value: object) -> object:
    if isinstance(value, Mapping):
        return dict(value)
    raise TypeError(type(value).__name__)
