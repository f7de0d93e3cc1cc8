"""The student web form: pages, the files they load, and the messages they speak with."""

from __future__ import annotations

from functools import lru_cache
from urllib.parse import urlencode

from fastapi import APIRouter, Request, Response

from exercises.definition import Exercise
from exercises.errors import AnswerError, UnknownExerciseError
from service.http.link_context import QUERY
from service.http.link_guard import context_of
from service.http.routing import ApiRequest, DirectRoute
from service.messages import LOCALES, languages
from service.resources import resources_of
from service.web.responses import missing_page, page_language, page_response, text_response
from service.web.shell import Page
from service.wire.exercise_views import instance_of, statement_html
from service.wire.figure_files import figure_path
from service.work.limiters import WorkKind

router = APIRouter(include_in_schema=False, route_class=DirectRoute)

YEAR = 365 * 24 * 3600

HOME = Page(name="home", title="form-home-title", styles=("exercise",))
EXERCISE = Page(
    name="exercise",
    title="form-exercise-title",
    rooms=("session",),
    depth=1,
    styles=("scene", "editor", "exercise"),
)
RECEIPTS = Page(name="receipts", title="receipts-title", rooms=("receipts",))


@router.get("/")
async def home(request: ApiRequest) -> Response:
    """Return the list of exercises."""
    return page_response(request, HOME)


@router.get("/exercises/{exercise_id}")
async def exercise_page(request: ApiRequest) -> Response:
    """Return the page of an exercise: its title and statement stand in it before any script runs."""
    try:
        found = resources_of(request).exercises.exercise(request.path_params["exercise_id"])
    except UnknownExerciseError:
        return missing_page(request)
    language = page_language(request)
    kept = {name: value for name in ("seed", QUERY) if (value := request.query_params.get(name))}
    query = urlencode({"lang": language, **kept})

    def work() -> dict[str, str]:
        return {
            "id": found.id,
            "title": found.title(language),
            "statement": statement_html(found, language),
            "figure": _figure(request, found, language, query),
        }

    question = ("page", found.id, query, context_of(request))
    values = (
        await resources_of(request).limiters[WorkKind.DRAWING].run_first(question, work, ("page", found.id))
    )
    # A SCORM package frames the page from whatever origin its LMS has. Nobody is signed in there: a page that
    # frames it gains nothing that it could not ask for itself.
    packaged = request.query_params.get("embed") == "scorm"
    return page_response(request, EXERCISE, values, in_any_frame=packaged, off=found.access.off)


def _figure(request: Request, found: Exercise, language: str, query: str) -> str:
    """The path of the figure with the values that the page's address, or its link, gives a seed for."""
    context = context_of(request)
    seed = request.query_params.get("seed") if context is None or context.seed is None else context.seed
    resources = resources_of(request)
    try:
        instance = instance_of(resources.exercises, found.id, seed)
    except AnswerError:  # a seed too long: the page asks for the exercise, and shows what it is told
        instance = instance_of(resources.exercises, found.id, None)
    return figure_path(resources.figures, instance, language, query)


@router.get("/receipts")
async def receipts_page(request: ApiRequest) -> Response:
    """Return where a lecturer verifies a folder of receipts."""
    return page_response(request, RECEIPTS)


@router.get("/static/{version}/{name:path}")
async def static_file(request: ApiRequest) -> Response:
    """Return a file of the form. Under the current version's address it may be kept for ever."""
    store = resources_of(request).assets
    asset = store.get(request.path_params["name"], request.headers.get("accept-encoding", ""))
    if asset is None:
        return Response(status_code=404, headers={"Cache-Control": "no-cache"})
    current = request.path_params["version"] == store.version
    headers = {
        "Cache-Control": f"public, max-age={YEAR}, immutable" if current else "no-cache",
        "ETag": asset.etag,
        "Vary": "Accept-Encoding",
        "Access-Control-Allow-Origin": "*",
    }
    if asset.encoding:
        headers["Content-Encoding"] = asset.encoding
    if asset.etag in request.headers.get("if-none-match", ""):
        return Response(status_code=304, headers=headers)
    return Response(asset.body, media_type=asset.media_type, headers=headers)


@lru_cache(maxsize=64)
def _messages(language: str, rooms: frozenset[str]) -> str:
    paths = sorted((LOCALES / language).glob("*.ftl"))
    return "\n".join(path.read_text(encoding="utf-8") for path in paths if path.stem in rooms)


@router.get("/locales/{language}.ftl")
async def messages(request: ApiRequest) -> Response:
    """The messages of a language, the same that the API answers with; `?rooms=form+feedback` picks files."""
    language, rooms = request.path_params["language"], request.query_params.get("rooms", "")
    if language not in languages():
        return Response(status_code=404, headers={"Cache-Control": "no-cache"})
    files = frozenset(path.stem for path in (LOCALES / language).glob("*.ftl"))
    text = _messages(language, files.intersection(rooms.split()) if rooms else files)
    headers = {"Cache-Control": "no-cache", "Access-Control-Allow-Origin": "*"}
    return text_response(request, text, "text/plain; charset=utf-8", headers)
