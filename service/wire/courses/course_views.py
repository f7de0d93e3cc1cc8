"""What lecturers read: attempts in a file, and mistakes with an example in words."""

import csv
import io
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from courses.teaching.attempt_export import ExportedAttempt
from service.adapters.gradebook import safe
from service.wire.courses.session_views import stored_report
from service.wire.exercises.verdicts import encoded

COLUMNS = (
    "person",
    "attempt",
    "time",
    "exercise",
    "version",
    "seed",
    "score",
    "points",
    "max_points",
    "counted",
    "correct",
    "codes",
)
PLACES = 6  # Decimals of scores and points: what floating-point arithmetic leaves behind them is not shown.
_BLOCK = 65_536  # Bytes that are sent at a time: a thread is asked for every block.


def attempt_record(found: ExportedAttempt) -> dict[str, Any]:
    """Return one attempt of an export: the student by pseudonym, and the path of codes."""
    attempt = found.attempt
    return {
        "person": found.person,
        "attempt": attempt.number,
        "time": attempt.at.isoformat(),
        "exercise": attempt.exercise_id,
        "version": attempt.version,
        "seed": attempt.seed,
        "score": round(attempt.score, PLACES),
        "points": round(found.points, PLACES),
        "max_points": found.max_points,
        "counted": found.counted,
        "correct": attempt.correct,
        "codes": [f"{kind}:{code}" + (f"@{row}" if row else "") for kind, code, row in found.path],
        "answer": attempt.answer,
        "report": attempt.report,
    }


def csv_of(attempts: Iterable[ExportedAttempt]) -> Iterator[bytes]:
    """Yield the attempts as CSV, block by block; no cell is a formula to a spreadsheet."""
    return _blocks(line.encode() for line in _lines(attempts))


def json_of(attempts: Iterable[ExportedAttempt]) -> Iterator[bytes]:
    """Yield the attempts as JSON, block by block: those of a large class fit into no memory."""
    return _blocks(_pieces(attempts))


def _blocks(pieces: Iterable[bytes]) -> Iterator[bytes]:
    block = bytearray()
    for piece in pieces:
        block += piece
        if len(block) >= _BLOCK:
            yield bytes(block)
            block.clear()
    yield bytes(block)


def _pieces(attempts: Iterable[ExportedAttempt]) -> Iterator[bytes]:
    separator = b'{"attempts":['
    for found in attempts:
        yield separator + encoded(attempt_record(found))
        separator = b","
    yield b"]}" if separator == b"," else separator + b"]}"


def _lines(attempts: Iterable[ExportedAttempt]) -> Iterator[str]:
    yield _line(COLUMNS)
    for found in attempts:
        record = attempt_record(found)
        flags = {name: int(record[name]) for name in ("counted", "correct")}
        values = {**record, **flags, "codes": " ".join(record["codes"])}
        cells = (values[name] for name in COLUMNS)
        yield _line(safe(cell) if isinstance(cell, str) else cell for cell in cells)


def _line(values: Iterable[object]) -> str:
    out = io.StringIO()
    csv.writer(out).writerow(values)
    return out.getvalue()


def with_examples(
    found: Iterable[Mapping[str, Any]], reports: Mapping[int, Mapping[str, Any]], language: str
) -> list[dict[str, Any]]:
    """Return mistakes, each with the sentence that the newest student with it would read."""
    return [
        {**entry, "example": _example(entry, reports.get(entry["newest"], {}), language)} for entry in found
    ]


def _example(entry: Mapping[str, Any], report: Mapping[str, Any], language: str) -> str | None:
    if not report:
        return None
    told = stored_report(report, language)
    entries = [edit for repair in told["repairs"] for edit in repair["edits"]]
    entries += [each for part in told["parts"].values() for each in part["feedback"]]
    return next((each["message"] for each in entries if each["code"] == entry["code"]), None)
