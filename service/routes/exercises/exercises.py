"""Exercises: the list, one of them with a student's values, its figure, and judging answers."""

from collections.abc import Callable
from functools import lru_cache, partial
from typing import Annotated, Any, TypeVar

from fastapi import Path, Request, Response

from exercises.access import lowest
from exercises.answers import parse
from exercises.definition import Exercise
from exercises.errors import AnswerError
from exercises.grader import Report, grade
from exercises.grading import HelpLevel
from exercises.instance import SEED_CHARACTERS, Instance, cached_instance
from kinematics.errors import Fault
from service.http.languages import language_of
from service.http.link_context import LinkContext
from service.http.link_guard import context_of
from service.http.openapi import problems, request_body
from service.http.problems import ForbiddenError, RequestError, RequestPart
from service.http.routing import JSON, ApiRequest, DirectRoute, api_router
from service.http.validation import validated
from service.messages import languages
from service.resources import resources_of
from service.schemas.exercises.exercises import ExerciseAnswer, ExerciseList, ExerciseModel, GradedModel
from service.web.responses import IMMUTABLE, packed_response, text_response
from service.wire.exercises.exercise_views import attempts_of, exercise_list, exercise_view, instance_of
from service.wire.exercises.figure_files import figure_address, figure_path, known_figure, packed_figure
from service.wire.exercises.ungraded import answer_refused, known_exercise
from service.wire.exercises.verdicts import encoded, report_body
from service.work.limiters import WorkKind
from service.work.shared_answers import SharedAnswers

router = api_router("exercises", route_class=DirectRoute)

_Result = TypeVar("_Result")
SVG = "image/svg+xml"
CACHED_VIEWS = 256
"""Exercises with one student's or one variant's values in the cache, some seven kilobytes each."""
_FIGURE_POLICY = "default-src 'none'; style-src 'unsafe-inline'"
Id = Annotated[
    str,
    Path(max_length=64, description="id of the exercise", openapi_examples={"PUMA": {"value": "puma560"}}),
]
_EXERCISE_ID: dict[str, Any] = {
    "name": "exercise_id",
    "in": "path",
    "required": True,
    "description": "id of the exercise",
    "schema": {"type": "string", "maxLength": 64},
    "examples": {"SCARA": {"value": "scara"}},
}
_SEED: dict[str, Any] = {
    "name": "seed",
    "in": "query",
    "required": False,
    "description": "names a student or a try; the same seed gives the same values",
    "schema": {"type": "string", "maxLength": SEED_CHARACTERS},
}
_LANGUAGE: dict[str, Any] = {
    "name": "lang",
    "in": "query",
    "required": False,
    "description": "en, es, fr, pt, ro or uk; else Accept-Language decides",
    "schema": {"type": "string", "enum": list(languages())},
}
_ONE_STUDENTS = {"parameters": [_EXERCISE_ID, _SEED, _LANGUAGE]}


@router.get(
    "/exercises",
    response_model=ExerciseList,
    openapi_extra={"parameters": [_LANGUAGE]},
    summary="All exercises",
)
async def list_exercises(request: ApiRequest) -> Response:
    """Return every exercise with its title, in the caller's language."""
    language = language_of(request)
    listed = exercise_list(resources_of(request).exercises, language, context_of(request))
    return text_response(request, encoded(listed), JSON, _headers(language))


@router.get(
    "/exercises/{exercise_id}",
    response_model=ExerciseModel,
    responses=problems(404),
    openapi_extra=_ONE_STUDENTS,
    summary="One exercise",
)
async def show_exercise(request: ApiRequest) -> Response:
    """Return an exercise with one student's values: statement, rules, dimensions, figure; never the key."""
    language = language_of(request)

    def work() -> bytes:
        return _view(resources_of(request).figures, _asked_instance(request), language, context_of(request))

    body = await _first(request, "view", work)
    return text_response(request, body, JSON, _headers(language))


@lru_cache(maxsize=CACHED_VIEWS)
def _view(figures: SharedAnswers, instance: Instance, language: str, context: LinkContext | None) -> bytes:
    """An exercise as JSON: students who share a variant are told the same."""
    view = exercise_view(instance, language, context)
    view["figure"]["file"] = figure_path(figures, instance, language)
    return encoded(view)


@router.get(
    "/exercises/{exercise_id}/figure.svg",
    responses={200: {"content": {SVG: {"schema": {"type": "string"}}}}, **problems(404, 503)},
    response_class=Response,
    openapi_extra=_ONE_STUDENTS,
    summary="The figure of an exercise",
)
async def show_figure(request: ApiRequest) -> Response:
    """Return the robot with its joints, dimensions and marked points; frames are the question."""
    return await _figure(request, "no-cache")


@router.get("/exercises/{exercise_id}/figures/{address}.svg", include_in_schema=False)
async def show_addressed_figure(request: ApiRequest) -> Response:
    """Return the same figure under the address that the exercise gives; its content never changes.

    Caches may store it for good. Students with the same values have the same address.
    """
    return await _figure(request, IMMUTABLE, request.path_params["address"])


def _asked_instance(request: ApiRequest) -> Instance:
    """The exercise that the address names, with the values of the seed that it names.

    Raises:
        NotFoundError: there is no such exercise.
        RequestError: the seed is too long.
    """
    seed = _seed_of(request)
    try:
        with known_exercise():
            return instance_of(resources_of(request).exercises, request.path_params["exercise_id"], seed)
    except AnswerError as error:
        raise RequestError(error.faults, part=RequestPart.QUERY) from error


async def _first(request: ApiRequest, what: str, work: Callable[[], _Result]) -> _Result:
    """What follows from the values of the address's seed; for one exercise all of them take as long."""
    context, seed = context_of(request), _seed_of(request)
    exercise_id = request.path_params["exercise_id"]
    question = (what, exercise_id, seed, language_of(request), context)
    return (
        await resources_of(request).limiters[WorkKind.DRAWING].run_first(question, work, (what, exercise_id))
    )


async def _figure(request: ApiRequest, caching: str, asked: str | None = None) -> Response:
    """The figure; where another address was asked for than it has now, where it is."""
    language, figures = language_of(request), resources_of(request).figures

    def look() -> tuple[Instance, str, bytes | None]:
        instance = _asked_instance(request)
        now = figure_address(figures, instance, language)
        return instance, now, known_figure(figures, instance, language) if asked in (None, now) else None

    instance, address, packed = await _first(request, "figure", look)
    if packed is None and asked in (None, address):
        draw = partial(packed_figure, figures, instance, language)
        packed = await resources_of(request).limiters[WorkKind.DRAWING].run(draw)
    if packed is None:
        query = f"?{request.url.query}" if request.url.query else ""
        moved = {"Location": f"{address}.svg{query}", "Cache-Control": "no-store"}
        return Response(status_code=307, headers=moved)
    headers = {**_headers(language), "Cache-Control": caching, "Content-Security-Policy": _FIGURE_POLICY}
    return packed_response(request, packed, address, SVG, headers)


@router.post(
    "/exercises/{exercise_id}/grade",
    response_model=GradedModel,
    responses=problems(404, 503),
    openapi_extra={**request_body(ExerciseAnswer), **_ONE_STUDENTS},
    summary="Judge an answer to an exercise",
)
async def grade_answer(request: ApiRequest) -> Response:
    """Return the verdict on the table, and the feedback on every other part that was handed in.

    Every valid choice of frames is accepted. A part that follows correctly from a wrong table earns its
    points. A request that cannot be graded is refused and costs no attempt.
    """
    language = language_of(request)
    resources = resources_of(request)
    with answer_refused():
        # an address at which nothing is comes before what is wrong
        found = resources.exercises.exercise(request.path_params["exercise_id"])
        wire = validated(ExerciseAnswer, await request.json())
        _, report = await judged(request, found, wire, resources.help_now)
    resources.metrics.graded(correct=report.correct, score=report.score, kept=False)
    return Response(encoded(report_body(report, language)), media_type=JSON, headers=_headers(language))


async def judged(
    request: Request,
    found: Exercise,
    wire: ExerciseAnswer,
    help_now: Callable[[HelpLevel | None], HelpLevel | None] = lambda asked: asked,
) -> tuple[Instance, Report]:
    """Return what an answer is judged by, and the report; a link's settings go before those of the answer.

    Args:
        help_now: how much of the help that it allows is given at the moment.

    Raises:
        ForbiddenError: there are no more attempts.
    """
    resources, context = resources_of(request), context_of(request)
    level, attempt = _help_of(context, wire.help, wire.attempt)
    attempts = attempts_of(found, context)
    if attempts is not None and attempt is not None and attempt > attempts:
        raise ForbiddenError(Fault.at("attempts_used_up", "attempt", limit=attempts))

    def work() -> tuple[Instance, Report]:
        instance = cached_instance(found, _seed_of(request, wire.seed))
        answer = parse(instance, wire.raw(), resources.settings.cell_limits)
        return instance, grade(instance, answer, help_now(level), attempt)

    return await resources.grading.run(work)


def _seed_of(request: Request, asked: str | None = None) -> str | None:
    """The seed of the student's link, else that of the body, else that of the address."""
    context = context_of(request)
    if context is not None and context.seed is not None:
        return context.seed
    return request.query_params.get("seed") if asked is None else asked


def _help_of(
    context: LinkContext | None, asked: HelpLevel | None, attempt: int | None
) -> tuple[HelpLevel | None, int | None]:
    """The help that may be given and the number of the attempt; a link's own go before a caller's."""
    if context is None:
        return asked, attempt
    levels = [level for level in (asked, context.help) if level is not None]
    return (lowest(levels) if levels else None), attempt if context.attempt is None else context.attempt


def _headers(language: str) -> dict[str, str]:
    return {"Content-Language": language, "Vary": "Accept-Language", "Cache-Control": "no-cache"}
