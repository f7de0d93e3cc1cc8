"""Faults that are part of an answer: each at its place, in the caller's language."""

from __future__ import annotations

from collections.abc import Sequence

from kinematics.errors import Fault
from service.http.problems import Problem
from service.schemas.base import FaultEntry


def fault_entries(faults: Sequence[Fault], language: str, limit: int) -> list[FaultEntry]:
    """Return the first `limit` faults as an answer lists them."""
    if not faults:
        return []
    document = Problem(status=422, faults=tuple(faults)).document(language, fault_limit=limit)
    return [FaultEntry.model_validate(entry, strict=False) for entry in document["errors"]]  # type: ignore[attr-defined]
