"""Exercises as JSON and SVG, in the caller's language. The key is never among it."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import Any

from exercises.definition import Exercise, Part, PartKind, PosePart, ReachFrom, WorkspacePart
from exercises.drawings import figure_geometry, figure_sentences, figure_svg
from exercises.grading import ConventionRule
from exercises.instance import Instance, generate
from exercises.loader import exercise, exercise_ids
from exercises.statements import first_sentence, to_html
from kinematics.cells import AngleUnit
from kinematics.table import JointType
from service.messages import languages, sentence

KEPT = 512
"""Instances and figures that are kept."""


def instance_of(exercise_id: str, seed: str | None) -> Instance:
    """An exercise with the values of a seed.

    Raises:
        ExerciseError: there is no such exercise, or the seed is too long.
    """
    return _instance(exercise(exercise_id), seed)


@lru_cache(maxsize=KEPT)
def _instance(found: Exercise, seed: str | None) -> Instance:
    return generate(found, seed)


def exercise_list(language: str) -> dict[str, Any]:
    """All exercises."""
    return {
        "language": language,
        "languages": list(languages()),
        "exercises": [_entry(exercise(exercise_id), language) for exercise_id in exercise_ids()],
    }


def exercise_view(instance: Instance, language: str) -> dict[str, Any]:
    """An exercise with one student's values."""
    found = instance.exercise
    statement = found.statements[language]
    names = [f"q{i}" for i in range(1, found.reference.table.n_joints + 1)]
    types = found.reference.table.joint_types
    return {
        "id": found.id,
        "version": found.version,
        "seed": instance.seed,
        "language": language,
        "title": found.titles[language],
        "statement": {"markdown": statement, "html": to_html(statement)},
        "rules": list(rules(found, language)),
        "conventions": conventions(found),
        "policy": found.policy,
        "help": found.help.value,
        "angle_unit": found.angle_unit.value,
        "length_unit": found.length_unit.value,
        "parameters": instance.parameters,
        "dimensions": [
            {"name": name, "value": value, "unit": found.length_unit.value}
            for name, value in instance.parameters.items()
        ],
        "joints": [{"name": name, "type": kind.value} for name, kind in zip(names, types, strict=True)],
        "parts": [_part(part, instance, language) for part in found.parts],
        "points": float(found.points),
        "figure": {**figure_geometry(instance), "description": figure_description(instance, language)},
    }


def conventions(found: Exercise) -> list[str]:
    """The conventions that an exercise accepts."""
    rule = found.policy.convention
    return ["standard", "modified"] if rule is ConventionRule.ANY else [rule.value]


def rules(found: Exercise, language: str) -> Iterator[str]:
    """What is free and what is fixed, in sentences."""
    policy = found.policy
    for name in ("convention", "base", "tool", "zero", "direction"):
        rule = getattr(policy, name).value
        text = sentence(language, f"rule-{name}-{rule}", {"points": ", ".join(found.figure.marks)})
        if text:
            yield text


def figure_description(instance: Instance, language: str) -> str:
    """The figure in words."""
    sentences = (
        sentence(language, f"figure-{entry.code}", entry.params) for entry in figure_sentences(instance)
    )
    return " ".join(text for text in sentences if text)


@lru_cache(maxsize=KEPT)
def figure_file(instance: Instance, language: str) -> bytes:
    """The figure as an SVG file."""
    title = sentence(language, "figure-title", {"title": instance.exercise.titles[language]}) or ""
    description = figure_description(instance, language)
    note = sentence(language, "figure-note") or ""
    return figure_svg(instance, title=title, description=description, language=language, note=note).encode()


def _entry(found: Exercise, language: str) -> dict[str, Any]:
    return {
        "id": found.id,
        "version": found.version,
        "title": found.titles[language],
        "summary": first_sentence(found.statements[language]),
        "joints": found.reference.table.n_joints,
        "parts": [part.kind.value for part in found.parts],
        "points": float(found.points),
    }


def _part(part: Part, instance: Instance, language: str) -> dict[str, Any]:
    view: dict[str, Any] = {
        "kind": part.kind.value,
        "points": float(part.points),
        "task": sentence(language, _task(part), _task_values(part, instance)),
        "joints": None,
        "point": None,
        "reach_from": None,
    }
    if isinstance(part, PosePart):
        view["joints"] = [float(value) for value in instance.pose_joints]
    if isinstance(part, WorkspacePart):
        view["point"] = part.point
        view["reach_from"] = part.origin or ReachFrom.AXIS.value
    return view


def _task(part: Part) -> str:
    if isinstance(part, WorkspacePart):
        return f"task-workspace-{part.reach_from.value}"
    return f"task-{part.kind.value.replace('_', '-')}"


def _task_values(part: Part, instance: Instance) -> dict[str, Any]:
    found = instance.exercise
    values: dict[str, Any] = {
        "n": found.reference.table.n_joints,
        "unit": found.length_unit.value,
        "names": ", ".join(instance.exact),
    }
    if isinstance(part, WorkspacePart):
        limits = "some" if any(limit is not None for limit in part.limits) else "none"
        values |= {"point": part.point, "origin": part.origin or "", "limits": limits}
    if part.kind is PartKind.POSE:
        units = {
            JointType.REVOLUTE: "°" if found.angle_unit is AngleUnit.DEG else " rad",
            JointType.PRISMATIC: f" {found.length_unit.value}",
        }
        joints = zip(instance.pose_joints, found.reference.table.joint_types, strict=True)
        values["joints"] = ", ".join(
            f"q{i} = {float(value):g}{units[kind]}" for i, (value, kind) in enumerate(joints, 1)
        )
    return values
