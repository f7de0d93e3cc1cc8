"""What goes wrong with exercises, and where.

    ExerciseError
    ├── DefinitionError        an exercise's folder is malformed; faults name the file and the path of the key
    ├── UnknownExerciseError   there is no exercise of that name
    └── AnswerError            an answer cannot be graded; it costs no attempt

An error carries one or more faults, as in `kinematics.errors`. A wrong answer is a result, never an error.
"""

from __future__ import annotations

from collections.abc import Iterable

from kinematics.errors import Fault


class ExerciseError(Exception):
    """Root of this package's errors: one or more faults."""

    def __init__(self, faults: Fault | Iterable[Fault]) -> None:
        self.faults: tuple[Fault, ...] = (faults,) if isinstance(faults, Fault) else tuple(faults)
        super().__init__("\n".join(map(str, self.faults)))

    def __reduce__(self) -> tuple[type[ExerciseError], tuple[tuple[Fault, ...]]]:
        """Errors travel from worker processes with their faults."""
        return type(self), (self.faults,)

    @property
    def code(self) -> str:
        """The code of the first fault."""
        return self.faults[0].code


class DefinitionError(ExerciseError):
    """An exercise's folder is malformed."""


class UnknownExerciseError(ExerciseError):
    """There is no exercise of that name."""


class AnswerError(ExerciseError):
    """An answer cannot be graded; it costs no attempt."""
