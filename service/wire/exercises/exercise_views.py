"""Exercises as JSON and SVG, in the caller's language. The key is never among it."""

from collections.abc import Iterator
from dataclasses import fields
from functools import lru_cache
from typing import Any

from exercises.access import lowest
from exercises.definition import Exercise, Part
from exercises.drawings import end_marks, figure_geometry, figure_sentences
from exercises.grading import ConventionRule, HelpLevel
from exercises.instance import Instance, cached_instance
from exercises.library import Library
from exercises.needs import unneeded_dimensions
from exercises.parts.mistakes.frame_mistake import frames_shown
from exercises.parts.protocol import TABLE
from exercises.parts.registry import part_type
from exercises.parts.task import FormField, GivenNumbers
from exercises.statements import first_sentence, to_html
from service.http.link_context import LinkContext
from service.messages import in_sentence, languages, sentence
from service.schemas.exercises.exercises import TASK_FIELDS

FRAMED = (TABLE, "frames", "screws")  # Kinds of part that are held to the rules on frames.
CACHED_TEXTS = 512
"""Exercises whose dimensions have been looked through; in each language their statements, rules and fields of
forms."""
CACHED_DESCRIPTIONS = 2048
"""Instances whose figure has been put into words: the exercise tells them, and then its figure."""


def instance_of(library: Library, exercise_id: str, seed: str | None) -> Instance:
    """Return an exercise with the values of a seed.

    Raises:
        ExerciseError: there is no such exercise, or the seed is too long.
    """
    return cached_instance(library.exercise(exercise_id), seed)


def exercise_list(library: Library, language: str, context: LinkContext | None = None) -> dict[str, Any]:
    """Return all exercises; under the context of a link, only its own."""
    ids = library.ids if context is None else (context.exercise,)
    return {
        "language": language,
        "languages": list(languages()),
        "exercises": [_entry(library.exercise(exercise_id), language) for exercise_id in ids],
    }


def exercise_view(instance: Instance, language: str, context: LinkContext | None = None) -> dict[str, Any]:
    """Return an exercise with one student's values, as it is under the context of a link."""
    found = instance.exercise
    statement = found.statement(language)
    free = free_dimensions(found)
    names = [f"q{i}" for i in range(1, found.reference.table.n_joints + 1)]
    types = found.reference.table.joint_types
    return {
        "id": found.id,
        "version": found.version,
        "seed": instance.seed,
        "language": language,
        "text_language": found.text_language(language),
        "note": language_note(found, language),
        "title": found.title(language),
        "statement": {"markdown": statement, "html": statement_html(found, language)},
        "rules": list(_rules_told(found, language)),
        "conventions": conventions(found),
        "policy": found.policy,
        "help": _most(found, context),
        "access": _access(found, context),
        "angle_unit": found.angle_unit.value,
        "length_unit": found.length_unit.value,
        "parameters": instance.parameters,
        "dimensions": [
            {
                "name": name,
                "value": value,
                "unit": found.length_unit.value,
                "needed": name not in free,
                "aliases": [alias for alias, meant in found.aliases.items() if meant == name],
            }
            for name, value in instance.parameters.items()
        ],
        "joints": [{"name": name, "type": kind.value} for name, kind in zip(names, types, strict=True)],
        "parts": [_part(part, instance, language) for part in found.parts],
        "points": float(found.points),
        "figure": {
            **figure_geometry(instance, frames_shown(instance)),
            "description": figure_description(instance, language),
        },
    }


def _most(found: Exercise, context: LinkContext | None) -> HelpLevel:
    """Return the most that a verdict tells."""
    if context is None or context.help is None:
        return found.help
    return lowest((found.help, context.help))


def _access(found: Exercise, context: LinkContext | None) -> dict[str, Any]:
    own, most = found.access, _most(found, context)
    return {
        "off": sorted(own.off | (context.off if context else frozenset())),
        "ladder": [lowest((level, most)) for level in own.ladder],
        "attempts": attempts_of(found, context),
        "attempt": context.attempt if context else None,
    }


def attempts_of(found: Exercise, context: LinkContext | None) -> int | None:
    """Return how many attempts there are: what the link says, else what the exercise says."""
    return found.access.attempts if context is None or context.attempts is None else context.attempts


def conventions(found: Exercise) -> list[str]:
    """Return the conventions that an exercise accepts."""
    rule = found.policy.convention
    return ["standard", "modified"] if rule is ConventionRule.ANY else [rule.value]


@lru_cache(maxsize=CACHED_TEXTS)
def statement_html(found: Exercise, language: str) -> str:
    """Return what is asked as HTML; the same for all students of an exercise."""
    return to_html(found.statement(language))


@lru_cache(maxsize=CACHED_TEXTS)
def _rules_told(found: Exercise, language: str) -> tuple[str, ...]:
    return tuple(rules(found, language))


def rules(found: Exercise, language: str) -> Iterator[str]:
    """Yield what is free and what is fixed, in sentences."""
    policy = found.policy
    framed = [part.kind for part in found.parts if part.kind in FRAMED]
    if not framed:
        return
    convention = () if framed == ["screws"] else ("convention",)
    for name in (*convention, "base", "tool", "zero", "direction"):
        rule = getattr(policy, name).value
        text = sentence(language, f"rule-{name}-{rule}", {"points": ", ".join(end_marks(found))})
        if text:
            yield text
    free = free_dimensions(found)
    if free and found.part(TABLE) is not None:
        yield sentence(language, "rule-dimension-free", {"names": free}) or ""


@lru_cache(maxsize=CACHED_TEXTS)
def free_dimensions(found: Exercise) -> tuple[str, ...]:
    """Return the dimensions that an answer may leave out; found out once for an exercise."""
    return unneeded_dimensions(found)


def language_note(found: Exercise, language: str) -> str | None:
    """Return what a reader is told whose language the exercise is not written in."""
    written = found.text_language(language)
    if written == language:
        return None
    name = sentence(written, "language-name")
    return sentence(language, "exercise-other-language", {"language": name or written})


@lru_cache(maxsize=CACHED_DESCRIPTIONS)
def figure_description(instance: Instance, language: str) -> str:
    """Return the figure in words."""
    sentences = (
        _figure_sentence(language, entry.code, tuple(entry.params.items()))
        for entry in figure_sentences(instance)
    )
    return " ".join(text for text in sentences if text)


@lru_cache(maxsize=CACHED_DESCRIPTIONS)
def _figure_sentence(language: str, code: str, params: tuple[tuple[str, str | int], ...]) -> str | None:
    """A sentence on a figure: most are true of every student's."""
    return sentence(language, f"figure-{code}", in_sentence(dict(params), language))


def _entry(found: Exercise, language: str) -> dict[str, Any]:
    return {
        "id": found.id,
        "version": found.version,
        "title": found.title(language),
        "summary": first_sentence(found.statement(language)),
        "joints": found.reference.table.n_joints,
        "parts": [part.kind for part in found.parts],
        "points": float(found.points),
    }


def _part(part: Part, instance: Instance, language: str) -> dict[str, Any]:
    task = part_type(part.kind).task(part, instance)
    given = task.given
    return {
        "kind": part.kind,
        "points": float(part.points),
        "task": sentence(language, task.message, in_sentence(task.values, language)),
        "form": [_field(field, language) for field in task.form],
        "numbers": [_numbers(numbers, language) for numbers in task.numbers],
        **dict.fromkeys(TASK_FIELDS),
        **({} if given is None else {entry.name: getattr(given, entry.name) for entry in fields(given)}),
    }


@lru_cache(maxsize=CACHED_TEXTS)
def _field(field: FormField, language: str) -> dict[str, Any]:
    return {
        "name": field.name,
        "label": sentence(language, f"field-{field.caption or field.name}"),
        "shape": field.shape,
        "labels": list(field.labels),
        "rows": field.rows,
        "options": [
            {"value": option, "label": sentence(language, f"option-{option}") or option}
            for option in field.options
        ],
    }


def _numbers(numbers: GivenNumbers, language: str) -> dict[str, Any]:
    return {
        "name": numbers.name,
        "label": sentence(language, f"given-{numbers.name}", numbers.values),
        "labels": list(numbers.labels),
        "rows": [list(row) for row in numbers.rows],
    }
