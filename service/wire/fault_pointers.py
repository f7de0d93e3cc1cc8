"""Where a fault of a table belongs in the request that the table was made from.

Methods speak of rows of a DH table. The caller may have sent a table, but also the name of a robot, an SCM
chain or a URDF, and what is too long may be a parameter.
"""

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

from kinematics.errors import Fault, KinematicsError
from service.http.problem_documents import Problem
from service.http.problems import cause
from service.schemas.base import FaultEntry

_SOURCES: Mapping[str, tuple[str, ...]] = {
    "table": ("table",),
    "robot": ("robot",),
    "chain": ("chain", "joints"),
    "scm": ("scm", "joints"),
    "poe": ("poe", "screws"),
    "urdf": ("urdf",),
}
"""The fields that describe a robot, and where faults of its rows are shown; only a table shows its rows."""

_TOO_LONG = ("result_not_finite", "urdf_length_overflow")
"""Codes of lengths beyond a limit, in units of the request."""


@contextmanager
def traced(request: Any) -> Iterator[None]:
    """Place the faults of a robot's rows, base and tool into the request that describes the robot."""
    try:
        yield
    except KinematicsError as error:
        placed = [fault for each in error.faults for fault in _placed(each, request)]
        raise type(error)({(fault.code, fault.where): fault for fault in placed}.values()) from cause(error)


def _placed(fault: Fault, request: Any) -> list[Fault]:
    derived = (
        fault.where[:1] in (("base",), ("tool",)) and getattr(request, str(fault.where[0]), None) is None
    )
    if fault.where[:1] != ("rows",) and not derived:
        return [fault]
    if fault.code in _TOO_LONG:
        limit = float(str(fault.params["limit"]))
        parameters: Mapping[str, float] = getattr(request, "parameters", None) or {}
        blamed = [name for name, value in parameters.items() if abs(value) > limit]
        if blamed:
            return [replace(fault, where=("parameters", name)) for name in blamed]
    source = next(name for name in _SOURCES if getattr(request, name, None) is not None)
    below = fault.where if source == "table" and not derived else ()
    return [replace(fault, where=(*_SOURCES[source], *below))]


def fault_entries(faults: Sequence[Fault], language: str, limit: int) -> list[FaultEntry]:
    """Return the first `limit` faults as an answer lists them."""
    if not faults:
        return []
    document = Problem(status=422, faults=tuple(faults)).document(language, fault_limit=limit)
    return [FaultEntry.model_validate(entry, strict=False) for entry in document["errors"]]  # type: ignore[attr-defined]
