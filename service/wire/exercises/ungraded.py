"""What cannot be graded is refused, and the refusal says that it cost no attempt."""

from collections.abc import Iterator
from contextlib import contextmanager

from courses.refusals import CourseError
from exercises.errors import ExerciseError, UnknownExerciseError
from kinematics.errors import KinematicsError
from service.http.problems import MessageId, NotFoundError, RequestError, RequestPart, ServiceError, cause

MEMBERS = {"attempt_counted": False, "note": MessageId("problem-note-ungraded")}


@contextmanager
def answer_refused() -> Iterator[None]:
    """Let whatever is refused inside cost no attempt, and say so in the problem document."""
    try:
        with known_exercise():
            yield
    except ServiceError as error:
        error.members |= MEMBERS
        raise
    except CourseError:  # what a policy refuses is told by its own status
        raise
    except (KinematicsError, ExerciseError) as error:
        raise RequestError(error.faults, members=MEMBERS) from cause(error)


@contextmanager
def known_exercise() -> Iterator[None]:
    """Refuse an exercise that does not exist as an address at which nothing is."""
    try:
        yield
    except UnknownExerciseError as error:
        raise NotFoundError(error.faults, part=RequestPart.PATH) from cause(error)
