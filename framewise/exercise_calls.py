"""The calls for those who make exercises, or hand them out; both clients send them, too."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

from framewise.calls import ApiCall, Table, post, step

Draft: TypeAlias = Mapping[str, Any]
"""An exercise as its author has it: `id`, `definition` and `statements`."""


def compare_tables(first: Table, second: Table, **options: Any) -> ApiCall:
    """Return whether two tables describe the same robot, and why (POST /compare-tables)."""
    return post("compare-tables", first=dict(first), second=dict(second), **options)


def other_tables(table: Table, **options: Any) -> ApiCall:
    """Return other tables of the same robot (POST /other-tables).

    Args:
        table: one of them.
        options: further members of the body: `policy`, `count`, `parameters`.
    """
    return post("other-tables", table=dict(table), **options)


def plant_mistake(table: Table, seed: str, **options: Any) -> ApiCall:
    """Return a right table with one mistake in it (POST /plant-mistake).

    Args:
        table: the right one.
        seed: from which the mistake is drawn.
        options: further members of the body: `kinds`, `parameters` ….
    """
    return post("plant-mistake", table=dict(table), seed=seed, **options)


def plant_matrix_mistake(table: Table, seed: str, **options: Any) -> ApiCall:
    """Return a matrix of a robot with one mistake in it (POST /plant-matrix-mistake).

    Args:
        table: the robot's table.
        seed: from which the mistake is drawn.
        options: further members of the body.
    """
    return post("plant-matrix-mistake", table=dict(table), seed=seed, **options)


def plant_frame_mistake(axes: Sequence[Mapping[str, Any]], convention: str, seed: str) -> ApiCall:
    """Return the frames of a robot with one mistake in them (POST /plant-frame-mistake).

    Args:
        axes: the joint axes, base first: `joint`, `point`, `direction`.
        convention: "standard" or "modified".
        seed: from which the mistake is drawn.
    """
    return post("plant-frame-mistake", axes=[dict(axis) for axis in axes], convention=convention, seed=seed)


def signed_link(exercise_id: str, **settings: Any) -> ApiCall:
    """Return a link that carries its settings signed (POST /exercises/{exercise_id}/links).

    Args:
        exercise_id: the exercise.
        settings: what students cannot change: `help`, `attempts`, `off` ….
    """
    return post(f"exercises/{step(exercise_id)}/links", **settings)


def receipt_page(exercise_id: str, answer: Mapping[str, Any], name: str) -> ApiCall:
    """Return the receipt of an answer as a page to print (POST /exercises/{exercise_id}/receipts.pdf)."""
    return post(f"exercises/{step(exercise_id)}/receipts.pdf", **{**answer, "name": name})


def author_start(exercise_id: str, source: Mapping[str, Any], **options: Any) -> ApiCall:
    """Return the first draft of an exercise about a robot (POST /author/start).

    Args:
        exercise_id: what it will be called.
        source: the robot: a table, axes, URDF, or one of the catalogue.
        options: further members of the body.
    """
    return post("author/start", id=exercise_id, source=dict(source), **options)


def author_import(archive: str) -> ApiCall:
    """Return the draft in the folder of an exercise, a zip in Base64 (POST /author/import)."""
    return post("author/import", archive=archive)


def author_preview(draft: Draft, **options: Any) -> ApiCall:
    """Return a draft as students will see it (POST /author/preview)."""
    return post("author/preview", draft=dict(draft), **options)


def author_check(draft: Draft, seed: str | None = None, **options: Any) -> ApiCall:
    """Return a round of a draft's self-test (POST /author/check)."""
    return post("author/check", draft=dict(draft), seed=seed, **options)


def author_right_answers(draft: Draft, **options: Any) -> ApiCall:
    """Return right answers that look different (POST /author/right-answers)."""
    return post("author/right-answers", draft=dict(draft), **options)


def author_mistakes(draft: Draft, **options: Any) -> ApiCall:
    """Return the commonest wrong answers with their marks (POST /author/mistakes)."""
    return post("author/mistakes", draft=dict(draft), **options)


def author_grade(draft: Draft, answer: Mapping[str, Any], **options: Any) -> ApiCall:
    """Return what is said of an answer to a draft (POST /author/grade)."""
    return post("author/grade", draft=dict(draft), answer=dict(answer), **options)


def author_folder(draft: Draft) -> ApiCall:
    """Return the folder of a draft, a zip (POST /author/folder.zip)."""
    return post("author/folder.zip", draft=dict(draft))
