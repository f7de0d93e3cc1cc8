"""POST /exercises/{exercise_id}/receipts and receipts.pdf: receipts given for a verdict."""

import io
from contextlib import suppress
from datetime import UTC, datetime
from functools import partial
from typing import TYPE_CHECKING, Any

import segno
from fastapi import Request, Response
from pydantic import Field

from exercises.grader import Report
from exercises.instance import Instance
from exercises.parts.protocol import TABLE
from kinematics.table import COLUMNS
from service.http.languages import language_of
from service.http.link_context import LinkContext
from service.http.link_guard import context_of
from service.http.openapi import problems
from service.http.routing import api_router
from service.messages import sentence
from service.receipts.receipt import LONGEST_NAME, PartScore, Receipt, answer_hash, issue
from service.resources import AppResources
from service.routes.exercises.exercises import Id, judged
from service.schemas.base import Real, Wire
from service.schemas.exercises.exercises import ExerciseAnswer
from service.wire.exercises.exercise_views import instance_of
from service.wire.exercises.figure_files import figure_file
from service.wire.exercises.ungraded import answer_refused
from service.work.limiters import WorkKind

if TYPE_CHECKING:
    from service.receipts.sheet import Sheet

router = api_router("receipts")


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
    qr: str = Field(description="the same as a QR code, an SVG picture; empty if it is too long for one")
    points: Real
    max_points: Real
    issued: str = Field(description="when, in UTC (ISO 8601)")


_PDF = "application/pdf"
_LETTERS = {"theta": "θ", "d": "d", "a": "a", "alpha": "α"}
_OUTSIDE = {"name", "seed", "help", "attempt"}  # Members of a request that are no part of the answer.


@router.post(
    "/exercises/{exercise_id}/receipts",
    response_model=IssuedReceipt,
    responses=problems(404, 503),
    summary="Judge an answer and sign a receipt for it",
)
async def issue_receipt(
    request: Request, exercise_id: Id, body: ReceiptRequest, resources: AppResources
) -> Any:
    """Return a compact JWS that says what an answer earned, for a student to hand to a lecturer.

    It names the exercise and its version, the seed, the name typed, the score by part, the settings that were
    in force and a hash of the answer. Anybody can verify it with the keys at /receipts/keys.
    """
    token, receipt = await _issued(request, exercise_id, body, resources)
    return IssuedReceipt(
        receipt=token,
        qr=await resources.limiters[WorkKind.DRAWING].run(partial(_picture, token)),
        points=receipt.points,
        max_points=receipt.max_points,
        issued=receipt.time.isoformat(),
    )


@router.post(
    "/exercises/{exercise_id}/receipts.pdf",
    responses={
        200: {"content": {_PDF: {"schema": {"type": "string", "format": "binary"}}}},
        **problems(404, 503),
    },
    response_class=Response,
    summary="A receipt as a page to print",
)
async def receipt_page(
    request: Request, exercise_id: Id, body: ReceiptRequest, resources: AppResources
) -> Response:
    """Return the same receipt on a page.

    What it earned, the robot, the table as it was typed, the QR code (PDF).
    """
    token, receipt = await _issued(request, exercise_id, body, resources)
    language = language_of(request)

    def work() -> bytes:
        from service.receipts.sheet import pdf_of  # takes a quarter of a second, and few ask for it

        instance = instance_of(resources.exercises, exercise_id, receipt.seed)
        sheet = _sheet(instance, receipt, token, body, language)
        code = _code(token)
        drawn = () if code is None else code.matrix
        return pdf_of(sheet, figure=figure_file(instance, language).decode(), code=drawn)

    page = await resources.limiters[WorkKind.DRAWING].run(work)
    headers = {
        "Content-Disposition": f'attachment; filename="{exercise_id}.pdf"',
        "Cache-Control": "no-store",
    }
    return Response(page, media_type=_PDF, headers=headers)


async def _issued(
    request: Request, exercise_id: str, body: ReceiptRequest, resources: AppResources
) -> tuple[str, Receipt]:
    """A signed receipt for an answer, judged as its link says."""
    with answer_refused():
        instance, report = await judged(request, resources.exercises.exercise(exercise_id), body)
    receipt = _receipt(request, instance, body, report)
    return issue(receipt, resources.receipt_keys), receipt


def _sheet(instance: Instance, receipt: Receipt, token: str, body: ReceiptRequest, language: str) -> "Sheet":
    from service.receipts.sheet import Sheet

    def say(message: str, **values: Any) -> str:
        return sentence(language, message, values) or message

    points = {"points": f"{receipt.points:g}", "total": f"{receipt.max_points:g}"}
    table = body.raw().get(TABLE)
    columns = COLUMNS[table.convention] if table is not None else ()
    service = receipt.service
    facts = [
        (say("receipts-name"), receipt.name),
        (say("receipts-points"), say("form-points", **points)),
        (say("receipts-time"), f"{receipt.time:%Y-%m-%d %H:%M} UTC"),
        (say("receipts-settings"), say(f"form-help-{receipt.settings['help']}")),
        *([("", say("receipts-by-link"))] if "link" in receipt.settings else []),
    ]
    rows = [[str(getattr(row, name)) for name in columns] for row in table.rows] if table is not None else []
    return Sheet(
        title=instance.exercise.title(language),
        language=language,
        facts=facts,
        answer=say("receipts-answer"),
        columns=["i", *(_LETTERS[name] for name in columns)],
        rows=[[str(i), *row] for i, row in enumerate(rows, 1)],
        signature=say("receipts-sign", service=service, page=f"{service}/receipts"),
        receipt=token,
    )


def _receipt(request: Request, instance: Instance, body: ReceiptRequest, report: Report) -> Receipt:
    answer = body.model_dump(mode="json", exclude=_OUTSIDE, exclude_none=True)
    context = context_of(request)
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
            **({} if context is None else {"link": _of_link(context)}),
        },
        answer=answer_hash(answer),
        time=datetime.now(UTC).replace(microsecond=0),
        service=str(request.base_url).rstrip("/"),
    )


def _of_link(context: LinkContext) -> dict[str, Any]:
    """What a lecturer's link said: a student who left it behind has a receipt without it."""
    told = {
        "off": sorted(context.off),
        "help": context.help,
        "attempts": context.attempts,
        "seed": context.seed,
    }
    return {name: value for name, value in told.items() if value}


def _code(token: str) -> segno.QRCode | None:
    """Return the QR code of a receipt; None of one too long for any: a name of 200 emoji, and such a seed."""
    with suppress(segno.DataOverflowError):
        return segno.make(token, micro=False, error="l")
    return None


def _picture(token: str) -> str:
    code = _code(token)
    if code is None:
        return ""
    stream = io.BytesIO()
    code.save(
        stream, kind="svg", xmldecl=False, svgns=True, scale=3, dark="#000", light="#fff", omitsize=True
    )
    return stream.getvalue().decode()
