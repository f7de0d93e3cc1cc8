"""What goes wrong with exercises, and where.

    ExerciseError
    ├── DefinitionError        an exercise's folder is malformed; faults name the file and the path of the key
    ├── UnknownExerciseError   there is no exercise of that name
    └── AnswerError            an answer cannot be graded; it costs no attempt

An error carries one or more faults, as in `kinematics.errors`. A wrong answer is a result, never an error.
"""

from kinematics.errors import FaultyError


class ExerciseError(FaultyError):
    """Root of this package's errors."""


class DefinitionError(ExerciseError):
    """An exercise's folder is malformed."""


class UnknownExerciseError(ExerciseError):
    """There is no exercise of that name."""


class AnswerError(ExerciseError):
    """An answer cannot be graded; it costs no attempt."""
