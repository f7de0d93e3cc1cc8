"""µEd 0.1.0, POST /evaluate and GET /evaluate/health, and Lambda Feedback's call that came before it."""

from functools import partial
from typing import Any

from fastapi import APIRouter, Request, Response
from fastapi.responses import JSONResponse
from pydantic import ValidationError

from exercises.errors import ExerciseError
from service import __version__
from service.adapters import lambda_feedback, mued
from service.adapters.judging import told_fault
from service.http.languages import language_for
from service.http.problem_answers import REQUEST_ID
from service.http.problems import BodySizeError, busy
from service.http.routing import ApiRequest
from service.http.validation import faults_of
from service.messages import DEFAULT_LANGUAGE, languages, sentence
from service.resources import resources_of
from service.schemas.exercises.evaluation import (
    EvaluateRequest,
    EvaluationAccepted,
    EvaluationError,
    EvaluationFeedback,
    EvaluationHealth,
)
from service.schemas.tables import Table

router = APIRouter(tags=["evaluation"], include_in_schema=False)
"""µEd describes its calls itself; they are no part of our own document."""

_TOLD = 20  # Faults of a body that are told.
_LOCATOR = {
    "type": "object",
    "required": ["type", "row"],
    "properties": {
        "type": {"enum": ["cell", "row"]},
        "row": {"type": "integer", "minimum": 1},
        "column": {"enum": ["alpha", "a", "d", "theta", "joint"]},
    },
}
_ERRORS: dict[int | str, dict[str, Any]] = {
    202: {"model": EvaluationAccepted},
    400: {"model": EvaluationError},
    406: {"model": EvaluationError},
}
_BODY = {"content": {"application/json": {"schema": EvaluateRequest.model_json_schema()}}, "required": True}


@router.get("/evaluate/health", response_model=EvaluationHealth, response_model_exclude_none=True)
async def evaluation_health(request: Request, response: Response) -> Any:
    """Return what is evaluated here, in which languages and versions."""
    if refusal := _other_version(request):
        return refusal
    response.headers.update(_headers())
    return {
        "status": "OK",
        "version": __version__,
        "requirements": {
            "requiresAuthorizationHeader": resources_of(request).settings.api_keys is not None,
            "requiresTask": True,
        },
        "capabilities": {
            "supportsEvaluate": True,
            "supportsPreSubmissionFeedback": True,
            "supportsFormativeFeedback": True,
            "supportsSummativeFeedback": True,
            "supportsDataPolicy": "NOT_SUPPORTED",
            "supportedArtefactProfiles": [
                {
                    "type": kind.value,
                    "supportedFormats": [mued.TABLE_FORMAT, mued.ANSWER_FORMAT],
                    "contentSchema": Table.model_json_schema(),
                    "locatorSchema": _LOCATOR,
                }
                for kind in mued.EVALUATED
            ],
            "supportedLanguages": list(languages()),
            "supportedVersions": [mued.VERSION],
        },
    }


@router.post(
    "/evaluate",
    response_model=list[EvaluationFeedback],
    response_model_exclude_none=True,
    responses=_ERRORS,
    openapi_extra={"requestBody": _BODY},
)
async def evaluate_submission(request: Request, response: Response) -> Any:
    """Return feedback on a DH table, or on an answer to an exercise with several parts.

    Nothing is recorded, whether `preSubmissionFeedback` is asked for or not.
    """
    if refusal := _other_version(request):
        return refusal
    try:
        body = await ApiRequest(request.scope, request.receive, request._send).body()
        asked = EvaluateRequest.model_validate_json(body)
    except BodySizeError as error:
        return _refused(error.faults[0].code, message=told_fault(error.faults[0], DEFAULT_LANGUAGE))
    except ValidationError as error:
        return _refused("body_invalid", {"errors": _places(error)}, _said(error))
    language = mued.language_wanted(asked, request.headers.get("accept-language"))
    if asked.callback_url is not None:
        return _accepted(request, asked, asked.callback_url, language)
    work = partial(mued.evaluate, asked, language, resources_of(request).exercises)
    try:
        feedback = await resources_of(request).grading.run(work)
    except mued.NotEvaluatedError as error:
        return _refused(error.fault.code, message=told_fault(error.fault, language))
    except ExerciseError as error:
        return _refused(error.code, message=told_fault(error.faults[0], language))
    response.headers.update(_headers())
    response.headers["Content-Language"] = language
    return feedback


@router.post("/evaluate/lambda-feedback", response_model=None)
async def evaluation_function(request: Request) -> Any:
    """Answer Lambda Feedback's call before µEd: `command` in a header; errors are a body with `error`."""
    try:
        body = await ApiRequest(request.scope, request.receive, request._send).body()
    except BodySizeError as error:
        return _refused(error.faults[0].code, message=told_fault(error.faults[0], DEFAULT_LANGUAGE))
    language = language_for(request.headers.get("accept-language"))
    command = request.headers.get("command") or "eval"
    work = partial(lambda_feedback.answered, command, body, language, resources_of(request).exercises)
    answer = await resources_of(request).grading.run(work)
    return JSONResponse(answer, headers={"Cache-Control": "no-store"})


def _accepted(request: Request, asked: EvaluateRequest, address: str, language: str) -> Any:
    """Evaluate later and send the feedback to a host that the operator allows."""
    callbacks = resources_of(request).callbacks
    if not callbacks.allows(address):
        return _refused("callback_not_allowed", message=sentence(language, "error-callback_not_allowed"))
    request_id = str(request.scope.get(REQUEST_ID) or "")
    if not callbacks.has_room():
        raise busy()
    callbacks.send(
        address, request_id, partial(mued.evaluate, asked, language, resources_of(request).exercises)
    )
    return JSONResponse({"status": "ACCEPTED", "requestId": request_id}, 202, _headers())


def _other_version(request: Request) -> Response | None:
    """Refuse a version of µEd that is not spoken here; callers that name none get ours."""
    asked = request.headers.get("x-api-version")
    if asked in (None, "", mued.VERSION):
        return None
    return _error(406, "version_not_supported", f"X-Api-Version {asked[:20]}", {"supported": [mued.VERSION]})


def _refused(code: str, details: dict[str, Any] | None = None, message: str | None = None) -> Response:
    return _error(400, code, message or sentence(DEFAULT_LANGUAGE, f"error-{code}") or code, details)


def _error(status: int, code: str, message: str, details: dict[str, Any] | None) -> Response:
    body = {"title": code.replace("_", " ").capitalize(), "message": message, "code": code}
    return JSONResponse({**body, **({"details": details} if details else {})}, status, _headers())


def _headers() -> dict[str, str]:
    return {"X-Api-Version": mued.VERSION, "Cache-Control": "no-store"}


def _said(error: ValidationError) -> str | None:
    """Say what is wrong with a body that is JSON; None if it is none."""
    found = error.errors()[:_TOLD]
    if any(fault["type"] == "json_invalid" for fault in found):
        return None
    return " ".join(told_fault(fault, DEFAULT_LANGUAGE) for fault in faults_of(found, EvaluateRequest))


def _places(error: ValidationError) -> list[dict[str, str]]:
    return [
        {"where": ".".join(map(str, fault["loc"])), "what": fault["type"]} for fault in error.errors()[:_TOLD]
    ]
