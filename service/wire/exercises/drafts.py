"""Drafts as JSON: what is read, shown and refused of them, in the caller's language."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import fields, replace
from functools import lru_cache
from typing import Any

import orjson

from exercises.authoring.admission import PolicyAdmission
from exercises.authoring.draft import ExerciseDraft, exercise_of_draft
from exercises.consistency import FILE
from exercises.definition import Exercise
from exercises.drawings import figure_dimensions
from exercises.errors import DefinitionError
from exercises.instance import Instance, generate
from exercises.loader import robot_facts
from exercises.parts.protocol import RobotFacts
from exercises.parts.registry import part_type, part_types
from exercises.selftest.findings import Failure, Findings
from exercises.selftest.rehearsal import RehearsedAnswer
from exercises.statements import to_html
from exercises.written_table import written_table
from kinematics.errors import Fault
from service.http.problems import RequestError, cause
from service.messages import sentence
from service.wire.exercises.exercise_views import exercise_view
from service.wire.exercises.figure_files import figure_file
from service.wire.exercises.verdicts import record_body

CACHED_DRAFTS = 64  # Drafts in the cache, as read: an author looks at one again and again.


@contextmanager
def draft_refused() -> Iterator[None]:
    """Tell faults of a draft by their place in the request."""
    try:
        yield
    except DefinitionError as error:
        raise RequestError([_placed(fault) for fault in error.faults]) from cause(error)


def _placed(fault: Fault) -> Fault:
    """Return the fault at its place in the body: a file is a member of the draft."""
    head, *rest = (*fault.where, "")[:1] + fault.where[1:] if fault.where else ("",)
    if head == FILE:
        return replace(fault, where=("draft", "definition", *rest))
    if isinstance(head, str) and head.startswith("statement."):
        return replace(fault, where=("draft", "statements", head.split(".")[1], *rest))
    if head == "id":
        return replace(fault, where=("draft", "id"))
    return fault


def exercise_of(draft: ExerciseDraft) -> Exercise:
    """Return the exercise of a draft; one that was read before is not read again.

    Raises:
        DefinitionError: every fault of the draft.
    """
    return _exercise_of(draft.id, orjson.dumps([draft.definition, draft.statements]))


@lru_cache(maxsize=CACHED_DRAFTS)
def _exercise_of(exercise_id: str, content: bytes) -> Exercise:
    definition, statements = orjson.loads(content)
    return exercise_of_draft(ExerciseDraft(id=exercise_id, definition=definition, statements=statements))


def draft_body(draft: ExerciseDraft) -> dict[str, Any]:
    """Return a draft."""
    return {"draft": {"id": draft.id, "definition": draft.definition, "statements": draft.statements}}


def preview_body(draft: ExerciseDraft, admission: PolicyAdmission, language: str) -> dict[str, Any]:
    """Return a draft as students will see it, and what its policy leaves free."""
    exercise = exercise_of(draft)
    instance = generate(exercise)
    robot = robot_facts(exercise.reference, exercise.robot)
    return {
        "exercise": exercise_view(instance, language),
        "figure": figure_file(instance, language).decode(),
        "statements": {name: to_html(text) for name, text in exercise.statements.items()},
        "policy": {
            **{entry.name: getattr(admission, entry.name) for entry in fields(admission)},
            "message": sentence(
                language,
                "author-policy-admits",
                {"choices": admission.choices, "admitted": admission.admitted},
            )
            or "",
        },
        "key": written_table(exercise.reference),
        "dimensions": _dimensions(instance, language),
        "kinds": [_kind(kind, robot, language) for kind in part_types()],
    }


def _dimensions(instance: Instance, language: str) -> dict[str, Any]:
    """The dimensions of the figure, and where their lines may be moved."""
    found = figure_dimensions(instance, sentence(language, "figure-note") or "")
    layout = found.layout
    return {
        "box": layout.box,
        "distances": layout.distances,
        "usual": layout.usual,
        "lines": [
            {"mark": mark, "ends": place.ends, "line": place.line, "label": place.label, "ways": place.ways}
            for mark, place in zip(found.marks, layout.places, strict=True)
        ],
    }


def _kind(kind: str, robot: RobotFacts, language: str) -> dict[str, Any]:
    """A kind of part that may be asked about a robot: with what a definition begins, what else it may say."""
    part = part_type(kind)
    return {
        "kind": kind,
        "label": sentence(language, f"form-part-{kind.replace('_', '-')}") or kind,
        "gives_away": part.gives_away,
        "start": part.start(robot),
        "keys": [
            {
                "name": key.name,
                "label": sentence(language, f"author-key-{key.name}")
                or sentence(language, "author-key-one-joint", {"name": key.name}),
                "shape": key.shape.value,
                "labels": key.labels,
                "options": [
                    {
                        "value": option,
                        "label": sentence(language, f"author-choice-{option}")
                        or sentence(language, f"option-{option}")
                        or option,
                    }
                    for option in key.options
                ],
            }
            for key in part.keys(robot)
        ],
    }


def self_test_body(findings: Findings, seed: int | None, language: str) -> dict[str, Any]:
    """Return what a round of the self-test found."""
    return {
        "seed": seed,
        "passed": findings.passed.total(),
        "failures": _lines(findings.failures, language),
        "warnings": _lines(findings.warnings, language),
    }


def _lines(found: Sequence[Failure], language: str) -> list[dict[str, Any]]:
    return [
        {
            "check": failure.check,
            "params": dict(failure.params),
            "message": sentence(language, f"check-{failure.check}", failure.params) or failure.check,
        }
        for failure in found
    ]


def rehearsal_body(answers: Sequence[RehearsedAnswer], language: str) -> dict[str, Any]:
    """Return rehearsed answers with what a student is told."""
    return {"answers": [record_body(answer, language) for answer in answers]}
