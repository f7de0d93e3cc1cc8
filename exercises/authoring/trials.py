"""What is tried with a draft, as one call each: plain data in and out, for a process of its own."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from exercises.authoring.admission import PolicyAdmission, policy_admission
from exercises.authoring.draft import ExerciseDraft, exercise_of_draft
from exercises.authoring.scaffold import RobotName, name_of_catalogue, started
from exercises.authoring.sources import read_source
from exercises.consistency import FILE
from exercises.definition import Exercise
from exercises.drawings import figure_drawing
from exercises.errors import DefinitionError
from exercises.instance import Instance, generate
from exercises.needs import unneeded_dimensions
from exercises.parts.protocol import TABLE
from exercises.selftest.checks import check_values
from exercises.selftest.findings import Findings
from exercises.selftest.rehearsal import RehearsedAnswer, right_answers, usual_mistakes
from kinematics.errors import Fault
from kinematics.frames.axes import JointAxis

MOST_ROWS = 16  # Of a draft's table: twice those of the longest arm in the documents. A folder may have more.
MOST_ANSWERS = 20  # Right answers in one rehearsal: as many as somebody reads through.
SOME_MISTAKES = 6  # So many of the listed mistakes are made for each seed: a round stays below some seconds.


def new_draft(
    exercise_id: str, document: Mapping[str, Any], robot_name: RobotName = name_of_catalogue
) -> tuple[ExerciseDraft, tuple[JointAxis, ...]]:
    """Return a new draft that loads and can be drawn, and the axes that it was drawn by, if it was.

    Args:
        document: what it is about, as `sources.read_source` takes it.
        robot_name: title of an exercise about a catalogue robot.

    Raises:
        DefinitionError: every fault of the id and of the document, at its place there.
    """
    source = read_source(document)
    draft = started(exercise_id, source, robot_name)
    try:
        _drawn(_read(draft))
    except DefinitionError as error:
        raise DefinitionError(_at_its_source(fault, document) for fault in error.faults) from error
    return draft, source.axes


def _at_its_source(fault: Fault, document: Mapping[str, Any]) -> Fault:
    """Return a fault of a new draft at the value that it is about, or at what the draft was started from."""
    (form, content), *_ = document.items()
    key, name = "lengths" if form == "axes" else "parameters", str(fault.params.get("name"))
    values = content.get(key) if isinstance(content, dict) else None
    place = (key, name) if isinstance(values, dict) and name in values else ()
    return replace(fault, where=("source", form, *place))


def trial(draft: ExerciseDraft) -> PolicyAdmission:
    """Do once what every look at a draft needs, so that its cost is known; return what the policy admits.

    Raises:
        DefinitionError: every fault of the draft.
    """
    exercise = _read(draft)
    instance = _drawn(exercise)
    unneeded_dimensions(exercise)
    return policy_admission(exercise, instance.values)


def self_test(draft: ExerciseDraft, seed: int | None) -> Findings:
    """Return one round of the exercise's own tests, with the values of one seed.

    Raises:
        DefinitionError: every fault of the draft.
    """
    return check_values((seed,), _read(draft), SOME_MISTAKES)


def rehearsed_right(draft: ExerciseDraft, count: int) -> tuple[RehearsedAnswer, ...]:
    """Return right answers that look different.

    Raises:
        DefinitionError: every fault of the draft, or it asks for no table.
    """
    return right_answers(_with_table(draft), min(count, MOST_ANSWERS))


def rehearsed_mistakes(draft: ExerciseDraft) -> tuple[RehearsedAnswer, ...]:
    """Return every misconception about the draft's robot, with what it earns.

    Raises:
        DefinitionError: every fault of the draft, or it asks for no table.
    """
    return usual_mistakes(_with_table(draft))


def check_rows(draft: ExerciseDraft) -> None:
    """Refuse a table that is longer than any arm.

    Raises:
        DefinitionError: it has too many rows.
    """
    reference = draft.definition.get("reference")
    rows = reference.get("rows") if isinstance(reference, dict) else None
    if isinstance(rows, list) and len(rows) > MOST_ROWS:
        params = {"count": len(rows), "limit": MOST_ROWS}
        raise DefinitionError(Fault.at("draft_too_many_rows", FILE, "reference", "rows", **params))


def _read(draft: ExerciseDraft) -> Exercise:
    check_rows(draft)
    return exercise_of_draft(draft)


def _drawn(exercise: Exercise) -> Instance:
    """The exercise with its usual values, once its figure can be drawn."""
    instance = generate(exercise)
    figure_drawing(instance)
    return instance


def _with_table(draft: ExerciseDraft) -> Exercise:
    exercise = _read(draft)
    if exercise.part(TABLE) is None:
        raise DefinitionError(Fault.at("draft_without_table", FILE, "parts"))
    return exercise
