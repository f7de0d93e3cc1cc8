"""POST /receipts/verify and GET /receipts/keys: what lecturers believe of receipts, and why."""

import io
from functools import partial
from typing import Annotated, Any

from fastapi import Query, Request, Response
from fastapi.responses import JSONResponse
from pydantic import Field

from service.adapters.gradebook import GradebookFormat, write_gradebook
from service.adapters.judging import told_fault
from service.http.languages import language_of
from service.http.routing import api_router
from service.receipts.checking import CheckedReceipt, check_receipts, entries_of
from service.receipts.receipt import LONGEST
from service.resources import AppResources
from service.schemas.base import Real, Wire

router = api_router("receipts")

MOST_RECEIPTS = 1000  # Receipts that one call verifies.


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


_CSV = "text/csv; charset=utf-8"


@router.post(
    "/receipts/verify",
    response_model=VerifiedReceipts,
    responses={200: {"content": {"text/csv": {"schema": {"type": "string"}}}}},
    summary="Verify receipts",
)
async def verify_receipts(
    request: Request,
    body: VerifyRequest,
    resources: AppResources,
    gradebook: Annotated[
        GradebookFormat | None, Query(alias="format", description="a gradebook file instead of JSON")
    ] = None,
) -> Any:
    """Return what receipts say, in the order in which they were sent.

    A forged one says why it is not believed.
    """
    language = language_of(request)
    checked = await resources.grading.run(partial(check_receipts, body.receipts, resources.receipt_keys))
    if gradebook is not None:
        stream = io.StringIO()
        write_gradebook(entries_of(checked), stream, gradebook)
        return Response(stream.getvalue(), media_type=_CSV)
    return JSONResponse({"receipts": [_verified(entry, language) for entry in checked]})


@router.get("/receipts/keys", summary="Public keys of receipts (JWK Set)", response_model=KeySet)
async def receipt_keys(resources: AppResources) -> Response:
    """Return the keys that verify receipts (RFC 7517); the first one signs."""
    return JSONResponse(resources.receipt_keys.public(), headers={"Cache-Control": "public, max-age=600"})


def _verified(entry: CheckedReceipt, language: str) -> dict[str, Any]:
    receipt = entry.receipt
    if receipt is None:
        assert entry.fault is not None
        said = dict.fromkeys(_CLAIMS)
        message = told_fault(entry.fault, language)
        return {**said, "valid": False, "code": entry.fault.code, "message": message, "repeated": False}
    return {
        "valid": True,
        "code": None,
        "message": None,
        **{name: getattr(receipt, name) for name in _CLAIMS if name not in ("parts", "issued")},
        "parts": {
            kind: {"points": part.points, "max_points": part.max_points, "correct": part.correct}
            for kind, part in receipt.parts.items()
        },
        "issued": receipt.time.isoformat(),
        "repeated": entry.repeated,
    }


_CLAIMS = (
    "exercise", "version", "seed", "name", "points", "max_points", "parts", "settings", "answer", "issued",
    "service",
)  # fmt: skip
