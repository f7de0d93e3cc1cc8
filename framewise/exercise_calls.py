"""The calls for those who make exercises, or hand them out; both clients send them, too."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

from framewise.calls import Answer, Answers, Content, KinematicsCalls, Table, posted, step

Draft: TypeAlias = Mapping[str, Any]
"""An exercise as its author has it: `id`, `definition` and `statements`."""


class ExerciseCalls(KinematicsCalls[Answer, Content, Answers]):
    """Calls for those who make exercises, or hand them out."""

    def compare_tables(self, first: Table, second: Table, **options: Any) -> Answer:
        """Return whether two tables describe the same robot, and why (POST /compare-tables)."""
        return self.post("compare-tables", first=dict(first), second=dict(second), **options)

    def other_tables(self, table: Table, **options: Any) -> Answer:
        """Return other tables of the same robot (POST /other-tables).

        Args:
            table: one of them.
            options: further members of the body: `policy`, `count`, `parameters`.
        """
        return self.post("other-tables", table=dict(table), **options)

    def plant_mistake(self, table: Table, seed: str, **options: Any) -> Answer:
        """Return a right table with one mistake in it (POST /plant-mistake).

        Args:
            table: the right one.
            seed: from which the mistake is drawn.
            options: further members of the body: `kinds`, `parameters` ….
        """
        return self.post("plant-mistake", table=dict(table), seed=seed, **options)

    def plant_matrix_mistake(self, table: Table, seed: str, **options: Any) -> Answer:
        """Return a matrix of a robot with one mistake in it (POST /plant-matrix-mistake).

        Args:
            table: the robot's table.
            seed: from which the mistake is drawn.
            options: further members of the body.
        """
        return self.post("plant-matrix-mistake", table=dict(table), seed=seed, **options)

    def plant_frame_mistake(self, axes: Sequence[Mapping[str, Any]], convention: str, seed: str) -> Answer:
        """Return the frames of a robot with one mistake in them (POST /plant-frame-mistake).

        Args:
            axes: the joint axes, base first: `joint`, `point`, `direction`.
            convention: "standard" or "modified".
            seed: from which the mistake is drawn.
        """
        return self.post(
            "plant-frame-mistake", axes=[dict(axis) for axis in axes], convention=convention, seed=seed
        )

    def signed_link(self, exercise_id: str, **settings: Any) -> Answer:
        """Return a link that carries its settings signed (POST /exercises/{exercise_id}/links).

        Args:
            exercise_id: the exercise.
            settings: what students cannot change: `help`, `attempts`, `off` ….
        """
        return self.post(f"exercises/{step(exercise_id)}/links", **settings)

    def receipt_page(self, exercise_id: str, answer: Mapping[str, Any], name: str) -> Content:
        """Return the receipt of an answer as a page to print (POST /exercises/{exercise_id}/receipts.pdf)."""
        return self.fetch(posted(f"exercises/{step(exercise_id)}/receipts.pdf", **{**answer, "name": name}))

    def author_start(self, exercise_id: str, source: Mapping[str, Any], **options: Any) -> Answer:
        """Return the first draft of an exercise about a robot (POST /author/start).

        Args:
            exercise_id: what it will be called.
            source: the robot: a table, axes, URDF, or one of the catalogue.
            options: further members of the body.
        """
        return self.post("author/start", id=exercise_id, source=dict(source), **options)

    def author_import(self, archive: str) -> Answer:
        """Return the draft in the folder of an exercise, a zip in Base64 (POST /author/import)."""
        return self.post("author/import", archive=archive)

    def author_preview(self, draft: Draft, **options: Any) -> Answer:
        """Return a draft as students will see it (POST /author/preview)."""
        return self.post("author/preview", draft=dict(draft), **options)

    def author_check(self, draft: Draft, seed: str | None = None, **options: Any) -> Answer:
        """Return a round of a draft's self-test (POST /author/check)."""
        return self.post("author/check", draft=dict(draft), seed=seed, **options)

    def author_right_answers(self, draft: Draft, **options: Any) -> Answer:
        """Return right answers that look different (POST /author/right-answers)."""
        return self.post("author/right-answers", draft=dict(draft), **options)

    def author_mistakes(self, draft: Draft, **options: Any) -> Answer:
        """Return the commonest wrong answers with their marks (POST /author/mistakes)."""
        return self.post("author/mistakes", draft=dict(draft), **options)

    def author_grade(self, draft: Draft, answer: Mapping[str, Any], **options: Any) -> Answer:
        """Return what is said of an answer to a draft (POST /author/grade)."""
        return self.post("author/grade", draft=dict(draft), answer=dict(answer), **options)

    def author_folder(self, draft: Draft) -> Content:
        """Return the folder of a draft, a zip (POST /author/folder.zip)."""
        return self.fetch(posted("author/folder.zip", draft=dict(draft)))
