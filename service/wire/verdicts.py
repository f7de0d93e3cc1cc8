"""Verdicts and reports as JSON, with their sentences in the caller's language."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import orjson

from exercises.drawings import KeyPose
from exercises.grader import Report
from exercises.grading import Edit, Feedback, Repair, Verdict
from exercises.instance import Instance
from exercises.parts.report import PartReport
from service.messages import sentence


def encoded(body: dict[str, Any]) -> bytes:
    """A body as JSON; records of the domain are written by their fields."""
    return orjson.dumps(body, default=_plain)


def _plain(value: object) -> object:
    if isinstance(value, Mapping):
        return dict(value)
    raise TypeError(type(value).__name__)


def verdict_body(verdict: Verdict, language: str) -> dict[str, Any]:
    """A verdict on a table."""
    return {
        "angle_unit": verdict.angle_unit,
        "length_unit": verdict.length_unit,
        "correct": verdict.correct,
        "score": verdict.score,
        "basis": verdict.basis.value,
        "certificate": verdict.certificate,
        "links": verdict.links,
        "feedback": told(verdict.feedback, language),
        "repairs": [_repair(repair, language) for repair in verdict.repairs],
    }


def report_body(
    report: Report, instance: Instance, units: tuple[str, str], key: KeyPose | None, language: str
) -> dict[str, Any]:
    """A report on all that was handed in: the verdict on the table, with the parts beside it."""
    if report.verdict is not None:
        body = verdict_body(report.verdict, language)
    else:
        most = sum(part.max_points for part in report.parts)
        body = {
            "angle_unit": units[0],
            "length_unit": units[1],
            "correct": report.correct,
            "score": report.points / most,
            "basis": None,
            "certificate": None,
            "links": [],
            "feedback": [],
            "repairs": [],
        }
    return {
        **body,
        "parts": {part.kind.value: part_body(part, language) for part in report.parts},
        "total": {
            "points": report.points,
            "max_points": report.max_points,
            "score": report.score,
            "missing": [kind.value for kind in report.missing],
        },
        "help": report.help_level.value,
        "seed": instance.seed,
        "version": instance.exercise.version,
        "figure": key and {"base": key.base.tolist(), "posture": key.posture, "directions": key.directions},
    }


def part_body(report: PartReport, language: str) -> dict[str, Any]:
    """What is said of one part."""
    return {
        "kind": report.kind.value,
        "correct": report.correct,
        "score": report.score,
        "points": report.points,
        "max_points": report.max_points,
        "credit": report.credit.value,
        "facts": report.facts,
        "feedback": told(report.feedback, language),
    }


def told(feedback: Iterable[Feedback], language: str) -> list[dict[str, Any]]:
    """Feedback with its sentences."""
    return [
        {
            "code": entry.code,
            "row": entry.row,
            "params": entry.params,
            "message": _sentence("feedback", entry.code, entry.row, entry.params, language),
        }
        for entry in feedback
    ]


def _repair(repair: Repair, language: str) -> dict[str, Any]:
    return {"edits": [_edit(edit, language) for edit in repair.edits]}


def _edit(edit: Edit, language: str) -> dict[str, Any]:
    return {
        "code": edit.code,
        "row": edit.row,
        "cell": edit.cell,
        "params": edit.params,
        "message": _sentence("repair", edit.code, edit.row, edit.params, language),
    }


def _sentence(room: str, code: str, row: int | None, params: Mapping[str, object], language: str) -> str:
    values = params if row is None else {"row": row, **params}
    return sentence(language, f"{room}-{code}", values) or code
