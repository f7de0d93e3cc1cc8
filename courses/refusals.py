"""What goes wrong in courses.

CourseError
├── StorageError        the database cannot be used
│   └── StorageUnavailableError  it could be, and will be again
├── UnknownRecordError  there is no such link, attempt or person
├── AttemptError        the policy takes no attempt now
├── OutdatedError       what was looked at has changed meanwhile
├── PublicationError    no more exercises can be published here
└── SessionError        nobody is signed in by this token, or not with the role that is needed
"""

from kinematics.errors import Fault, KinematicsError


class CourseError(KinematicsError):
    """Root of this package's errors: one or more faults."""


class StorageError(CourseError):
    """The database cannot be used."""


class StorageUnavailableError(StorageError):
    """The database does not answer, or takes nothing: it is gone, full, read-only or overrun.

    Attributes:
        is_gone: whether the next request would fare the same.
    """

    def __init__(self, *, is_gone: bool) -> None:
        super().__init__(Fault.at("storage_unavailable"))
        self.is_gone = is_gone


class UnknownRecordError(CourseError):
    """There is no such record, or it is not of this course."""


class AttemptError(CourseError):
    """The policy takes no attempt now."""


class OutdatedError(CourseError):
    """What somebody has looked at, and decided upon, has changed meanwhile."""


class SessionError(CourseError):
    """The token signs nobody in."""


class StaffOnlyError(CourseError):
    """What was asked for is open to the course's staff."""

    def __init__(self) -> None:
        super().__init__(Fault.at("staff_only"))


class PublicationError(CourseError):
    """No more exercises can be published here."""


class NoExerciseError(CourseError):
    """No exercise has been chosen for the link yet."""

    def __init__(self) -> None:
        super().__init__(Fault.at("link_without_exercise"))


def unknown_record(kind: str) -> UnknownRecordError:
    """Return the refusal of a record that is not there, or belongs to another course."""
    return UnknownRecordError(Fault.at("record_unknown", kind=kind))


def platform_inactive(issuer: str) -> Fault:
    """Return the fault of what comes from a platform that was not activated, or was switched off."""
    return Fault.at("lti_platform_inactive", issuer=issuer[:200])
