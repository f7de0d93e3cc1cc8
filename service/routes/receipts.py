"""Receipts: given for a verdict, verified for a lecturer, and the keys to verify them elsewhere."""

from __future__ import annotations

import io
from datetime import UTC, datetime
from functools import partial
from typing import Annotated, Any

import segno
from fastapi import Body, Query, Request, Response
from fastapi.responses import JSONResponse

from exercises.answers import parse
from exercises.grader import Report, grade
from exercises.instance import Instance
from service.adapters.gradebook import GradebookFormat, write_marks
from service.adapters.judging import told_fault
from service.http.languages import language_of
from service.http.openapi import problems
from service.http.routing import api_router
from service.receipts.checking import CheckedReceipt, check_receipts, marks_of
from service.receipts.receipt import PartScore, Receipt, answer_hash, issue
from service.resources import AppResources
from service.routes.exercises import Id
from service.schemas import examples_grading
from service.schemas.examples import named
from service.schemas.receipts import IssuedReceipt, ReceiptRequest, VerifiedReceipts, VerifyRequest
from service.wire.exercise_views import instance_of
from service.wire.ungraded import answer_refused
from service.work.limiters import WorkKind

router = api_router("receipts")

_RECEIPT: dict[str, Any] = named(
    {"a table": {"table": examples_grading.SCARA_BY_THE_BOOK, "name": "Ada Lovelace"}}
)
_VERIFY: dict[str, Any] = named({"a text that is no receipt": {"receipts": ["eyJhbGciOiJFZERTQSIsImtpZCI6"]}})
_CSV = "text/csv; charset=utf-8"
_OUTSIDE = {"name", "seed", "help"}
"""Members of a request that are no part of the answer."""


@router.post(
    "/exercises/{exercise_id}/receipts",
    response_model=IssuedReceipt,
    responses=problems(404, 503),
    summary="Judge an answer and sign a receipt for it",
)
async def issue_receipt(
    request: Request,
    exercise_id: Id,
    body: Annotated[ReceiptRequest, Body(openapi_examples=_RECEIPT)],
    resources: AppResources,
) -> Any:
    """A compact JWS that says what an answer earned, for a student to hand to a lecturer.

    It names the exercise and its version, the seed, the name typed, the score by part, the settings that were
    in force and a hash of the answer. Anybody can verify it with the keys at /receipts/keys.
    """
    with answer_refused():
        instance = instance_of(resources.exercises, exercise_id, body.seed)
        judged = partial(_judged, instance, body, resources)
        report = await resources.limiters[WorkKind.GRADING].run(judged)
    receipt = _receipt(request, instance, body, report)
    token = issue(receipt, resources.receipt_keys)
    return IssuedReceipt(
        receipt=token,
        qr=_picture(token),
        points=receipt.points,
        max_points=receipt.max_points,
        issued=receipt.time.isoformat(),
    )


@router.post(
    "/receipts/verify",
    response_model=VerifiedReceipts,
    responses={200: {"content": {"text/csv": {"schema": {"type": "string"}}}}},
    summary="Verify receipts",
)
async def verify_receipts(
    request: Request,
    body: Annotated[VerifyRequest, Body(openapi_examples=_VERIFY)],
    resources: AppResources,
    gradebook: Annotated[
        GradebookFormat | None, Query(alias="format", description="a gradebook file instead of JSON")
    ] = None,
) -> Any:
    """What receipts say, in the order in which they were sent; a forged one says why it is not believed."""
    language = language_of(request)
    check = partial(check_receipts, body.receipts, resources.receipt_keys)
    checked = await resources.limiters[WorkKind.GRADING].run(check)
    if gradebook is not None:
        stream = io.StringIO()
        write_marks(marks_of(checked), stream, gradebook)
        return Response(stream.getvalue(), media_type=_CSV)
    return JSONResponse({"receipts": [_verified(entry, language) for entry in checked]})


@router.get("/receipts/keys", summary="Public keys of receipts (JWK Set)")
async def receipt_keys(resources: AppResources) -> Response:
    """The keys that verify receipts (RFC 7517); the first one signs."""
    return JSONResponse(resources.receipt_keys.public(), headers={"Cache-Control": "public, max-age=600"})


def _judged(instance: Instance, body: ReceiptRequest, resources: AppResources) -> Report:
    return grade(instance, parse(instance, body.raw(), resources.settings.cell_limits), body.help)


def _receipt(request: Request, instance: Instance, body: ReceiptRequest, report: Report) -> Receipt:
    answer = body.model_dump(mode="json", exclude=_OUTSIDE, exclude_none=True)
    return Receipt(
        exercise=instance.exercise.id,
        version=instance.exercise.version,
        seed=instance.seed,
        name=body.name,
        points=report.points,
        max_points=report.max_points,
        parts={
            part.kind: PartScore(points=part.points, max_points=part.max_points, correct=part.correct)
            for part in report.parts
        },
        settings={
            "help": report.help_level.value,
            "parts": [part.kind for part in instance.exercise.parts],
        },
        answer=answer_hash(answer),
        time=datetime.now(UTC).replace(microsecond=0),
        service=str(request.base_url).rstrip("/"),
    )


def _picture(token: str) -> str:
    stream = io.BytesIO()
    segno.make(token, micro=False, error="l").save(
        stream, kind="svg", xmldecl=False, svgns=True, scale=3, dark="#000", light="#fff", omitsize=True
    )
    return stream.getvalue().decode()


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
