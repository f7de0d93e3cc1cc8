"""The grader without a service: for notebooks and autograders that run where no network is."""

from collections.abc import Mapping
from dataclasses import dataclass
from html import escape
from typing import Any

from service.adapters.judging import JudgedAnswer, judge, with_joint_types


@dataclass(frozen=True, kw_only=True, slots=True)
class Checked:
    """What is said of an answer.

    Attributes:
        gradable: whether it could be graded; what cannot costs no attempt.
        correct: everything that was handed in is right.
        score: 0 to 1.
        codes: what was found, as stable codes.
        feedback: the same in sentences.
    """

    gradable: bool
    correct: bool
    score: float
    codes: tuple[str, ...]
    feedback: tuple[str, ...]

    def points_of(self, most: float) -> float:
        """Return what the answer earns where a right one earns `most`; nbgrader reads it from a test cell."""
        return self.score * most

    def __str__(self) -> str:
        """Return the sentences, one to a line."""
        return "\n".join(self.feedback)

    def _repr_html_(self) -> str:
        mark = "✓" if self.correct else "✗" if self.gradable else "?"
        told = "".join(f"<li>{escape(line)}</li>" for line in self.feedback)
        return f"<p><strong>{mark} {100 * self.score:.0f} %</strong></p><ul>{told}</ul>"


def check(
    answer: Mapping[str, Any], exercise: str, *, seed: str | None = None, language: str = "en"
) -> Checked:
    """Grade a table, or an answer with several parts, in this process.

    Args:
        answer: a table (`convention`, `rows`, units), or what POST /exercises/{id}/grade takes.
        exercise: id of the exercise.
        seed: what the student's values were drawn from.

    Raises:
        UnknownExerciseError: there is no such exercise.
    """
    body: dict[str, Any] = {"table": answer} if "rows" in answer else dict(answer)
    if isinstance(body.get("table"), Mapping):
        body["table"] = with_joint_types(exercise, body["table"])
    if seed is not None:
        body["seed"] = seed
    judged = judge(exercise, body, language)
    if not isinstance(judged, JudgedAnswer):
        codes = tuple(fault.code for fault in judged.faults)
        told = judged.sentences(language)
        return Checked(gradable=False, correct=False, score=0.0, codes=codes, feedback=told)
    return Checked(
        gradable=True,
        correct=judged.correct,
        score=judged.score,
        codes=judged.codes,
        feedback=judged.sentences(),
    )
