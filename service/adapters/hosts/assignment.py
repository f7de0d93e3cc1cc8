"""What a lecturer set, and one answer graded by it: shared by all hosts."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from exercises.errors import UnknownExerciseError
from exercises.library import Library, packaged
from kinematics.errors import Fault
from service.adapters.hand_ins import hand_ins
from service.adapters.judging import JudgedAnswer, NotGraded, exercise_named, judge, with_joint_types
from service.adapters.table_files import TableSettings, read_tables
from service.http.problems import RequestError


@dataclass(frozen=True, kw_only=True, slots=True)
class Assignment:
    """What a lecturer set.

    Attributes:
        exercise: the exercise; None where the hand-in names it.
        help_level: how much is told, never more than the exercise allows.
        points: what the assignment is worth at the host; None for the exercise's own points.
        tables: convention and units, where a file does not name them.
        library: the exercises, also those of one's own.
    """

    exercise: str | None = None
    language: str = "en"
    help_level: str | None = None
    points: float | None = None
    tables: TableSettings = field(default_factory=TableSettings)
    library: Library = field(default_factory=packaged)

    def grade_table(self, table: Mapping[str, Any], seed: str | None = None) -> JudgedAnswer | NotGraded:
        """Grade a table, or any answer that POST /exercises/{id}/grade takes.

        Raises:
            UnknownExerciseError: there is no exercise such as the lecturer named.
        """
        answer: dict[str, Any] = dict(table) if "rows" not in table else {"table": table}
        told = answer.pop("exercise", None)
        named = self.exercise or told
        if not isinstance(named, str):
            return NotGraded(faults=(Fault.at("exercise_not_named"),))
        exercise_id = exercise_named(named, self.library) or named
        if seed is not None:
            answer["seed"] = seed
        if self.help_level is not None:
            answer["help"] = self.help_level
        try:
            if isinstance(answer.get("table"), Mapping):
                answer["table"] = with_joint_types(exercise_id, answer["table"], self.library)
            return judge(exercise_id, answer, self.language, self.library)
        except UnknownExerciseError as error:
            if self.exercise is not None:
                raise
            return NotGraded(faults=error.faults)

    def grade_text(self, text: bytes, seed: str | None = None) -> JudgedAnswer | NotGraded:
        """Grade what a student typed: JSON, or a table with a header row.

        Raises:
            UnknownExerciseError: there is no exercise such as the lecturer named.
        """
        name = "answer.json" if text.lstrip()[:1] in (b"{", b"[") else "answer.csv"
        try:
            found = read_tables(name, text, self.tables)
        except RequestError as error:
            return NotGraded(faults=error.faults)
        return self.grade_table({"table": found[0].table, "exercise": found[0].exercise}, seed)

    def grade_path(self, path: Path) -> JudgedAnswer | NotGraded:
        """Grade the first table that a file or folder holds.

        Raises:
            RequestError: nothing can be read at the path.
            UnknownExerciseError: there is no such exercise.
        """
        refused: NotGraded | None = None
        for found in hand_ins(path, self.tables):
            if found.found is not None:
                table = dict(found.found.table)
                if self.exercise is None and found.found.exercise:
                    return self.grade_table({"table": table, "exercise": found.found.exercise})
                return self.grade_table(table)
            refused = refused or NotGraded(faults=found.faults)
        return refused or NotGraded(faults=(Fault.at("file_without_table", file=path.name),))

    def worth(self, judged: JudgedAnswer) -> tuple[float, float]:
        """Return what an answer earned and what the assignment is worth, in the host's points."""
        most = judged.max_points if self.points is None else self.points
        return judged.score * most, most
