"""The problem document (RFC 9457): a refusal, ready to be written in any language."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

import orjson

from courses.refusals import StorageUnavailableError
from kinematics.errors import Fault, KinematicsError
from service.http.problems import (
    RETRY_SECONDS,
    MessageId,
    RequestPart,
    ServiceError,
    fault_sentence,
    status_of,
)
from service.messages import sentence

PROBLEM_JSON = "application/problem+json"


@dataclass(frozen=True, kw_only=True, slots=True)
class Problem:
    """A refusal, ready to be written in any language.

    Attributes:
        status: HTTP status.
        faults: what is wrong; the first one gives the document its code and detail.
        part: the part of the request that the faults point into.
        headers: further headers of the response.
        members: further members of the document.
        request_id: what the log calls this request.
        unlisted: how many more faults were found than are told here.
    """

    status: int
    faults: tuple[Fault, ...]
    part: RequestPart = RequestPart.BODY
    headers: Mapping[str, str] = field(default_factory=dict)
    members: Mapping[str, object] = field(default_factory=dict)
    request_id: str = ""
    unlisted: int = 0

    def document(self, language: str, *, prefix: str = "", fault_limit: int = 50) -> dict[str, object]:
        """Return the problem document of RFC 9457 in the given language."""
        listed = [self._entry(fault, language) for fault in self.faults[:fault_limit]]
        first = listed[0]
        document: dict[str, object] = {
            "type": f"{prefix}/api/v1/problems/{first['code']}",
            "title": sentence(language, f"problem-title-{self.status}") or "Problem",
            "status": self.status,
            "detail": first["detail"],
            "code": first["code"],
            "pointer": first["pointer"],
            "errors": listed,
        }
        total = len(self.faults) + self.unlisted
        if total > fault_limit:
            document["errors_total"] = total
        if self.request_id:
            document["request_id"] = self.request_id
        for name, value in self.members.items():
            document[name] = sentence(language, value) if isinstance(value, MessageId) else value
        return document

    def encoded(self, language: str, *, prefix: str = "", fault_limit: int = 50) -> bytes:
        """Return the problem document as JSON."""
        return orjson.dumps(self.document(language, prefix=prefix, fault_limit=fault_limit), default=str)

    def _entry(self, fault: Fault, language: str) -> dict[str, object]:
        entry: dict[str, object] = {
            "code": fault.code,
            "pointer": json_pointer(fault.where) if self.part is RequestPart.BODY else "",
            "detail": fault_sentence(fault, language),
            "params": {name: _writable(value) for name, value in fault.params.items()},
        }
        if self.part is not RequestPart.BODY:
            entry["in"] = self.part.value
            entry["name"] = ".".join(str(part) for part in fault.where)
        return entry


def problem_of(error: ServiceError | KinematicsError, request_id: str = "") -> Problem:
    """Return the problem that tells of an error."""
    own = error if isinstance(error, ServiceError) else None
    return Problem(
        status=status_of(error),
        faults=error.faults,
        part=own.part if own else RequestPart.BODY,
        headers=own.headers if own else _headers(error),
        members=own.members if own else {},
        unlisted=own.unlisted if own else 0,
        request_id=request_id,
    )


def _headers(error: ServiceError | KinematicsError) -> Mapping[str, str]:
    return {"Retry-After": str(RETRY_SECONDS)} if isinstance(error, StorageUnavailableError) else {}


def json_pointer(where: Iterable[str | int]) -> str:
    """Return the RFC 6901 pointer of a path of keys and indices; the empty string is the whole document."""
    return "".join("/" + str(part).replace("~", "~0").replace("/", "~1") for part in where)


def _writable(value: object) -> object:
    if isinstance(value, int) and not -(2**63) <= value < 2**64:
        return str(value)
    if isinstance(value, str) and len(value) > 200:
        return value[:199] + "…"
    return value
