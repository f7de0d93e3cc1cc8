"""What goes wrong over HTTP, and the one table of statuses; how it is told: `service.http.problem_documents`.

    ServiceError
    ├── BodyError            the body is not what its media type says
    ├── NotFoundError        nothing is at this address
    ├── ForbiddenError       the link that the caller came by does not allow it
    ├── MethodError          this address knows no such method
    ├── NotAcceptableError   no representation that the caller accepts
    ├── BodyTimeoutError     the body comes too slowly
    ├── BodySizeError        the body, or what it asks for, is larger than a limit
    ├── MediaTypeError       the body comes in a form that is not read
    ├── RequestError         the body is well formed and does not say what is needed
    ├── UnauthorizedError    the caller is not believed
    ├── ConflictError        the same is under way already
    ├── RateError            the caller asks for more than its share
    ├── BusyError            no slot is free; try again later
    └── UnavailableError     the server itself is in trouble; try again later

Errors of `kinematics` and `exercises` carry faults of the same shape and know no status: this table does.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from enum import StrEnum
from typing import TypeVar

from courses.refusals import (
    AttemptError,
    NoExerciseError,
    OutdatedError,
    PublicationError,
    SessionError,
    StaffOnlyError,
    StorageUnavailableError,
    UnknownRecordError,
)
from kinematics.errors import Fault, KinematicsError
from service.messages import sentence

RETRY_SECONDS = 2
"""What Retry-After says: about as long as a task of the slow lane takes that is neither small nor refused."""


class RequestPart(StrEnum):
    """The part of a request that a fault points into."""

    BODY = "body"
    QUERY = "query"
    PATH = "path"
    HEADER = "header"


class MessageId(str):
    """A member of a problem document that is written as the message of this id."""

    __slots__ = ()


class ServiceError(Exception):
    """Root of the errors of this package: one or more faults, and the part of the request they speak of.

    `members` are further members of the problem document; `unlisted` says how many more faults were found.
    """

    def __init__(
        self,
        faults: Fault | Iterable[Fault],
        *,
        part: RequestPart = RequestPart.BODY,
        headers: Mapping[str, str] | None = None,
        members: Mapping[str, object] | None = None,
        unlisted: int = 0,
    ) -> None:
        self.faults: tuple[Fault, ...] = (faults,) if isinstance(faults, Fault) else tuple(faults)
        self.part, self.unlisted = part, unlisted
        self.headers = dict(headers or {})
        self.members = dict(members or {})
        super().__init__(self.faults)

    def __str__(self) -> str:
        return "; ".join(map(str, self.faults))


class BodyError(ServiceError):
    """The body cannot be read as what its media type says."""


class NotFoundError(ServiceError):
    """There is nothing at this address."""


class MethodError(ServiceError):
    """This address does not support the method."""


class NotAcceptableError(ServiceError):
    """There is no representation that the caller accepts."""


class BodySizeError(ServiceError):
    """The body, or what it asks for, is larger than a limit."""


class BodyTimeoutError(ServiceError):
    """The body comes too slowly."""

    def __init__(self, faults: Fault | Iterable[Fault]) -> None:
        super().__init__(faults, headers={"Connection": "close"})


class MediaTypeError(ServiceError):
    """The body comes in a form that is not read here."""


class RequestError(ServiceError):
    """The body is well formed, and what it says cannot be done."""


class UnauthorizedError(ServiceError):
    """The caller is not believed to be who it says."""


class ForbiddenError(ServiceError):
    """The caller is known, and may not do this."""


class ConflictError(ServiceError):
    """The same is under way already."""


class RateError(ServiceError):
    """The caller asks for more than its share; it may try again later."""


class BusyError(ServiceError):
    """No slot is free; the caller may try again later."""


class UnavailableError(ServiceError):
    """The server itself is in trouble, not the request; the caller may try again later."""

    def __init__(self, faults: Fault | Iterable[Fault]) -> None:
        super().__init__(faults, headers={"Retry-After": str(RETRY_SECONDS)})


def busy() -> BusyError:
    """Return the refusal of work for which there is no slot."""
    return BusyError(Fault.at("busy", seconds=RETRY_SECONDS), headers={"Retry-After": str(RETRY_SECONDS)})


STATUS: dict[type[Exception], int] = {
    BodyError: 400,
    ForbiddenError: 403,
    NotFoundError: 404,
    MethodError: 405,
    NotAcceptableError: 406,
    BodyTimeoutError: 408,
    BodySizeError: 413,
    MediaTypeError: 415,
    RequestError: 422,
    UnauthorizedError: 401,
    ConflictError: 409,
    RateError: 429,
    KinematicsError: 422,
    BusyError: 503,
    SessionError: 401,
    StaffOnlyError: 403,
    UnknownRecordError: 404,
    NoExerciseError: 404,
    PublicationError: 503,
    AttemptError: 409,
    OutdatedError: 409,
    StorageUnavailableError: 503,
    UnavailableError: 503,
}
INTERNAL = 500


def fault_sentence(fault: Fault, language: str) -> str:
    """Return what is wrong, in a language."""
    return sentence(language, f"error-{fault.code}", fault.params) or str(fault)


def status_of(error: Exception) -> int:
    """Return the HTTP status of an error: that of its nearest ancestor in `STATUS`, 500 if there is none."""
    return next((STATUS[kind] for kind in type(error).__mro__ if kind in STATUS), INTERNAL)


_Refusal = TypeVar("_Refusal", bound=Exception)


def cause(error: _Refusal) -> _Refusal:
    """Return a refusal as the cause of another one that a context manager raises: without its traceback.

    Python 3.12 leaves a context manager's frame bound to the caller's, which holds the refusal: a cycle with
    everything that the request made, until the next garbage collection.
    """
    return error.with_traceback(None)


@contextmanager
def moved(place: Callable[[Fault], Fault]) -> Iterator[None]:
    """Tell the faults of what is computed inside at other places of the request."""
    try:
        yield
    except KinematicsError as error:
        raise type(error)(map(place, error.faults)) from cause(error)


@contextmanager
def located(*prefix: str | int) -> Iterator[None]:
    """Place the faults of what is read inside: an object at `prefix` of the request's body.

    The server's own trouble stands nowhere in the request.
    """
    try:
        with moved(lambda fault: fault.within(*prefix)):
            yield
    except (BusyError, UnavailableError):
        raise
    except ServiceError as error:
        if error.part is RequestPart.BODY:
            error.faults = tuple(fault.within(*prefix) for fault in error.faults)
        raise
