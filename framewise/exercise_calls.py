"""The calls that judge answers, and those for authors of exercises; both clients send them, too."""

from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

from framewise.calls import Joints, KinematicsCalls, Matrix
from framewise.sender import Answer, Answers, ApiCall, Content, Table, posted, step

Draft: TypeAlias = Mapping[str, Any]  # An exercise as its author has it: `id`, `definition` and `statements`.


class ExerciseCalls(KinematicsCalls[Answer, Content, Answers]):
    """Calls about exercises and answers."""

    def check_inverse_kinematics(self, robot: Table | str, target: Any, **options: Any) -> Answer:
        """Return whether joint values, or a claim, answer a question (POST /check-inverse-kinematics)."""
        return self._of_robot("check-inverse-kinematics", robot, target=target, **options)

    def check_frames(
        self,
        axes: Sequence[Mapping[str, Any]],
        convention: str,
        frames: Sequence[Mapping[str, Any]],
        **options: Any,
    ) -> Answer:
        """Return which rules of a convention frames break (POST /check-frames)."""
        return self.post(
            "check-frames", axes=list(axes), convention=convention, frames=list(frames), **options
        )

    def check_rotation(self, expected: Mapping[str, Any], answer: Any, **options: Any) -> Answer:
        """Return whether an orientation is the expected one (POST /check-rotation)."""
        return self.post("check-rotation", expected=dict(expected), answer=answer, **options)

    def exercises(self, *, language: str | None = None) -> Answer:
        """Return all exercises (GET /exercises)."""
        return self.get("exercises", lang=language)

    def exercise(self, exercise_id: str, *, seed: str | None = None, language: str | None = None) -> Answer:
        """Return an exercise with one student's values (GET /exercises/{exercise_id})."""
        return self.get(f"exercises/{step(exercise_id)}", seed=seed, lang=language)

    def figure(self, exercise_id: str, *, seed: str | None = None, language: str | None = None) -> Content:
        """Return an exercise's figure as SVG (GET /exercises/{exercise_id}/figure.svg)."""
        query = {"seed": seed, "lang": language}
        return self.fetch(
            ApiCall(method="GET", path=f"exercises/{step(exercise_id)}/figure.svg", query=query)
        )

    def scorm_package(
        self,
        exercise_id: str,
        *,
        version: str = "1.2",
        language: str | None = None,
        help_level: str | None = None,
        per_student: bool = False,
        passing: float | None = None,
    ) -> Content:
        """Return an exercise as a SCORM package (GET /exercises/{exercise_id}/scorm.zip).

        Args:
            version: "1.2" or "2004".
            language: of the page.
            help_level: less help than the exercise allows.
            per_student: whether every student gets values of their own.
            passing: share of the points from which on the LMS is told "passed".
        """
        query = {
            "version": version,
            "lang": language,
            "help": help_level,
            "per_student": "true" if per_student else None,
            "pass": None if passing is None else str(passing),
        }
        return self.fetch(ApiCall(method="GET", path=f"exercises/{step(exercise_id)}/scorm.zip", query=query))

    def grade(self, reference: Table, submission: Table, **options: Any) -> Answer:
        """Return the verdict on a table by a key of your own (POST /grade).

        Args:
            options: `policy`, `parameters`, `help`.
        """
        return self.post("grade", reference=dict(reference), submission=dict(submission), **options)

    def grade_all(self, reference: Table, submissions: Sequence[Table], **options: Any) -> Answer:
        """Return the verdicts on many tables by one key, in their order (POST /grade).

        One that cannot be graded has a problem document in the place of its verdict.
        """
        return self.post(
            "grade", reference=dict(reference), submissions=list(map(dict, submissions)), **options
        )

    def grade_each(self, reference: Table, submissions: Sequence[Table], **options: Any) -> Answers:
        """Yield what `grade_all` returns, verdict by verdict (POST /grade)."""
        submitted = list(map(dict, submissions))
        return self.stream(posted("grade", reference=dict(reference), submissions=submitted, **options))

    def grade_exercise(
        self, exercise_id: str, answer: Mapping[str, Any], *, language: str | None = None
    ) -> Answer:
        """Return what is said of an answer (POST /exercises/{exercise_id}/grade).

        Args:
            answer: `table` and further parts, `seed`, `help`.
        """
        path = f"exercises/{step(exercise_id)}/grade"
        return self.send(ApiCall(method="POST", path=path, body=dict(answer), query={"lang": language}))

    def receipt(self, exercise_id: str, answer: Mapping[str, Any], name: str) -> Answer:
        """Return the receipt of an answer (POST /exercises/{exercise_id}/receipts).

        Args:
            answer: as for `grade_exercise`.
            name: the student's, as it is to stand there.
        """
        return self.post(f"exercises/{step(exercise_id)}/receipts", **{**answer, "name": name})

    def verify_receipts(self, receipts: Sequence[str]) -> Answer:
        """Return what receipts say, and which of them are not ours (POST /receipts/verify)."""
        return self.post("receipts/verify", receipts=list(receipts))

    def receipt_keys(self) -> Answer:
        """Return the public keys of receipts, a JWK Set (GET /receipts/keys)."""
        return self.get("receipts/keys")

    def check_jacobian(self, robot: Table | str, joints: Joints, jacobian: Matrix, **options: Any) -> Answer:
        """Return whether a Jacobian, as numbers, is a table's (POST /check-jacobian).

        Args:
            robot: a table, or the id of a robot of the catalogue.
            joints: where it was taken [units of the table].
            jacobian: the matrix.
            options: further members of the body: `point`, `frame`, `wrench`, `forces` ….
        """
        return self._of_robot("check-jacobian", robot, joints=joints, jacobian=jacobian, **options)

    def check_jacobian_form(
        self, robot: Table | str, jacobian: Sequence[Sequence[Any]], **options: Any
    ) -> Answer:
        """Return whether a Jacobian, as functions of the joints, is a table's (POST /check-jacobian-form)."""
        return self._of_robot("check-jacobian-form", robot, jacobian=jacobian, **options)

    def check_singularities(self, robot: Table | str, conditions: Sequence[str], **options: Any) -> Answer:
        """Return whether an arm is singular just where conditions hold (POST /check-singularities).

        Args:
            robot: a table, or the id of a robot of the catalogue.
            conditions: functions that vanish, or equations.
            options: further members of the body: `motion`, `joints`, `lost`, `parameters` ….
        """
        return self._of_robot("check-singularities", robot, conditions=list(conditions), **options)

    def check_dynamics(self, robot: Table | str, **options: Any) -> Answer:
        """Return whether M, C and g are those of a robot with weights (POST /check-dynamics).

        Args:
            robot: a table, or the id of a robot of the catalogue.
            options: the answer's `M`, `C` or `h`, and `g`; `links`, `gravity`, `parameters`, `tolerance`.
        """
        return self._of_robot("check-dynamics", robot, **options)

    def check_screws(self, robot: Table | str, screws: Sequence[Any], home: Any, **options: Any) -> Answer:
        """Return whether screws and a home pose describe a table's robot (POST /check-screws)."""
        return self._of_robot("check-screws", robot, screws=screws, home=home, **options)

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
        """Return the commonest wrong answers with their points (POST /author/mistakes)."""
        return self.post("author/mistakes", draft=dict(draft), **options)

    def author_grade(self, draft: Draft, answer: Mapping[str, Any], **options: Any) -> Answer:
        """Return what is said of an answer to a draft (POST /author/grade)."""
        return self.post("author/grade", draft=dict(draft), answer=dict(answer), **options)

    def author_folder(self, draft: Draft) -> Content:
        """Return the folder of a draft, a zip (POST /author/folder.zip)."""
        return self.fetch(posted("author/folder.zip", draft=dict(draft)))
