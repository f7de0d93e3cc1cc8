"""Receipts on the wire."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import Field

from service.receipts.receipt import LONGEST, LONGEST_NAME
from service.schemas.base import Real, Wire
from service.schemas.exercises.exercises import ExerciseAnswer

MOST_RECEIPTS = 1000
"""Receipts that one call verifies."""


class ReceiptRequest(ExerciseAnswer):
    """An answer, and the name that its receipt is to bear."""

    name: str = Field(
        min_length=1,
        max_length=LONGEST_NAME,
        description="the name as the student typed it; nobody checks it",
    )


class IssuedReceipt(Wire):
    """A receipt for a verdict."""

    receipt: str = Field(description="compact JWS (RFC 7515), EdDSA")
    qr: str = Field(description="the same as a QR code, an SVG picture")
    points: Real
    max_points: Real
    issued: str = Field(description="when, in UTC (ISO 8601)")


class VerifyRequest(Wire):
    """Receipts to be verified."""

    receipts: list[Annotated[str, Field(max_length=4 * LONGEST)]] = Field(
        min_length=1, max_length=MOST_RECEIPTS, description="texts as students handed them in"
    )


class ReceiptPart(Wire):
    """What one part earned."""

    points: Real
    max_points: Real
    correct: bool


class VerifiedReceipt(Wire):
    """What a receipt says; of one that is not ours, why."""

    valid: bool
    code: str | None = Field(description="why it is not valid")
    message: str | None = Field(description="the same in the caller's language")
    exercise: str | None
    version: int | None
    seed: str | None
    name: str | None = Field(description="the name that the student typed; nobody has checked it")
    points: Real | None
    max_points: Real | None
    parts: dict[str, ReceiptPart] | None
    settings: dict[str, Any] | None = Field(description="what was in force: help level, parts")
    answer: str | None = Field(description="SHA-256 of the answer")
    issued: str | None = Field(description="when, in UTC (ISO 8601)")
    service: str | None = Field(description="origin of the service that judged")
    repeated: bool = Field(description="the same answer stands in another receipt of this call, too")


class VerifiedReceipts(Wire):
    """The receipts in the order in which they were sent."""

    receipts: list[VerifiedReceipt]


class KeySet(Wire):
    """A JWK Set (RFC 7517)."""

    keys: list[dict[str, str]] = Field(description="Ed25519 keys (RFC 8037); the first one signs")
