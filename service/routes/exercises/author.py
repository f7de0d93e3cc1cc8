"""Making exercises: a draft is started, tried, tested, taken along; nothing is kept."""

from functools import partial
from typing import Any

from fastapi import Response

from exercises.answers import parse
from exercises.authoring.archive import LARGEST_ARCHIVE, archive_of_draft, draft_of_archive
from exercises.authoring.trials import new_draft, rehearsed_mistakes, rehearsed_right, self_test, trial
from exercises.grader import grade
from exercises.instance import generate
from service.http.calls import CallRouter
from service.http.languages import language_of
from service.http.openapi import problems, request_body
from service.http.problems import located
from service.http.routing import JSON, ApiRequest, DirectRoute, api_router
from service.http.validation import validated
from service.messages import robot_name
from service.schemas.exercises import authoring as wire
from service.schemas.exercises.exercises import ExerciseAnswer, GradedModel
from service.wire.exercises.drafts import (
    draft_body,
    draft_refused,
    exercise_of,
    preview_body,
    rehearsal_body,
    self_test_body,
)
from service.wire.exercises.ungraded import answer_refused
from service.wire.exercises.verdicts import encoded, report_body
from service.work.limiters import WorkKind
from service.work.workers import Lane

router = CallRouter("authoring")
direct = api_router("authoring", route_class=DirectRoute)

ZIP = "application/zip"
_BINARY: dict[int | str, dict[str, Any]] = {
    200: {"content": {ZIP: {"schema": {"type": "string", "format": "binary"}}}}
}
LARGEST_BODY = 2 * LARGEST_ARCHIVE  # Of an archive in base64, with what is around it.


@router.call("/author/start", "Start an exercise", answer=wire.StartAnswer)
async def start_draft(body: wire.StartRequest, request: ApiRequest) -> Response:
    """Start a draft from a catalogue robot, a DH table, drawn joint axes, an SCM chain or a URDF description.

    The draft loads, can be drawn and passes its own tests unchanged.
    """
    with draft_refused():
        draft, axes = await _in_worker(request, new_draft, body.id, body.source, robot_name)
    return _json({**draft_body(draft), "axes": axes}, language_of(request))


@router.call("/author/preview", "A draft as students will see it", answer=wire.PreviewAnswer)
async def preview_draft(body: wire.DraftRequest, request: ApiRequest) -> Response:
    """Return the exercise with its figure, and what the policy leaves free for this robot.

    An incomplete draft is refused; every fault has its place in the draft.
    """
    language = language_of(request)
    draft = body.draft.draft()
    with draft_refused():
        admission = await _in_worker(request, trial, draft)
        found = await _drawn(request, partial(preview_body, draft, admission, language))
    return _json(found, language)


@router.call("/author/check", "A round of a draft's self-test", answer=wire.SelfTestAnswer)
async def check_draft(body: wire.CheckRequest, request: ApiRequest) -> Response:
    """Run `framewise exercises check` for the values of one seed, with some of the listed mistakes."""
    language = language_of(request)
    with draft_refused():
        findings = await _in_worker(request, self_test, body.draft.draft(), body.seed)
    return _json(self_test_body(findings, body.seed, language), language)


@router.call("/author/right-answers", "Right answers that look different", answer=wire.RehearsalAnswer)
async def right_answers_of_draft(body: wire.RightAnswersRequest, request: ApiRequest) -> Response:
    """Return right tables with other frames, signs, zeros and conventions, as far as the policy allows."""
    return await _rehearsed(request, rehearsed_right, body.draft, body.count)


@router.call("/author/mistakes", "The commonest wrong answers and their points", answer=wire.RehearsalAnswer)
async def mistakes_of_draft(body: wire.DraftRequest, request: ApiRequest) -> Response:
    """Return every misconception about the draft's robot, made in the key.

    Each is given with what it earns and what a student is told.
    """
    return await _rehearsed(request, rehearsed_mistakes, body.draft)


@router.call("/author/grade", "Judge an answer to a draft", answer=GradedModel)
async def grade_against_draft(body: wire.TryRequest, request: ApiRequest) -> Response:
    """Return the verdict that a student would get. Nothing is recorded."""
    language = language_of(request)
    draft = body.draft.draft()
    with draft_refused():
        await _in_worker(request, trial, draft)
    with located("answer"), answer_refused():
        answer = validated(ExerciseAnswer, body.answer)
        raw, limits = answer.raw(), request.settings.cell_limits

        def work() -> Any:
            instance = generate(exercise_of(draft), answer.seed)
            return grade(instance, parse(instance, raw, limits), answer.help, answer.attempt)

        report = await request.resources.grading.run(work)
    return _json(report_body(report, language), language)


@router.post(
    "/author/folder.zip",
    responses={**_BINARY, **problems(503)},
    response_class=Response,
    summary="The folder of a draft",
)
async def folder_of_draft(body: wire.DraftRequest, request: ApiRequest) -> Response:
    """Return the folder as a zip archive, the same bytes for the same draft."""
    draft = body.draft.draft()
    with draft_refused():
        await _in_worker(request, trial, draft)
        archive = archive_of_draft(draft)
    headers = {"Content-Disposition": f'attachment; filename="{draft.id}.zip"', "Cache-Control": "no-store"}
    return Response(archive, media_type=ZIP, headers=headers)


@direct.post(
    "/author/import",
    response_model=wire.DraftAnswer,
    responses=problems(503),
    openapi_extra=request_body(wire.ImportRequest),
    summary="The draft in a folder",
)
async def import_draft(request: ApiRequest) -> Response:
    """Return the draft that the zip archive of a folder holds. Nothing is unpacked to a disk.

    The archive may also be the body itself, as `application/zip`.
    """
    request.body_limit = LARGEST_BODY
    if request.media_type() == ZIP:
        data = await request.body()
    else:
        asked = validated(wire.ImportRequest, await request.json(ZIP))
        data = asked.archive
    with draft_refused():
        draft = draft_of_archive(data)
        await _in_worker(request, trial, draft)
    return _json(draft_body(draft), language_of(request))


async def _in_worker(request: ApiRequest, work: Any, *arguments: Any) -> Any:
    """Do what costs time with a draft, in a process that may only take so much of it."""
    return await request.resources.workers.run(Lane.SLOW, work, *arguments)


async def _rehearsed(request: ApiRequest, work: Any, draft: wire.DraftModel, *arguments: Any) -> Response:
    language = language_of(request)
    with draft_refused():
        answers = await _in_worker(request, work, draft.draft(), *arguments)
    return _json(rehearsal_body(answers, language), language)


async def _drawn(request: ApiRequest, work: Any) -> Any:
    return await request.resources.limiters[WorkKind.DRAWING].run(work)


def _json(body: dict[str, Any], language: str) -> Response:
    headers = {"Content-Language": language, "Vary": "Accept-Language", "Cache-Control": "no-store"}
    return Response(encoded(body), media_type=JSON, headers=headers)


router.routes.extend(direct.routes)
