"""The pages: each is its shell, in the reader's language; its script asks the API for the rest."""

from urllib.parse import urlencode

from fastapi import APIRouter, Request, Response
from fastapi.responses import RedirectResponse

from exercises.definition import Exercise
from exercises.errors import AnswerError, UnknownExerciseError
from service.http.forms import own_root
from service.http.link_context import QUERY
from service.http.link_guard import context_of
from service.http.routing import ApiRequest, DirectRoute
from service.resources import resources_of
from service.settings import Publishers
from service.web.responses import missing_page, page_language, page_response
from service.web.shell import Page
from service.wire.exercises.exercise_views import instance_of, language_note, statement_html
from service.wire.exercises.figure_files import figure_path
from service.work.limiters import WorkKind

router = APIRouter(include_in_schema=False, route_class=DirectRoute)

HOME = Page(name="home", title="form-home-title", styles=("exercise",))
EXERCISE = Page(
    name="exercise",
    title="form-exercise-title",
    messages=("session",),
    depth=1,
    styles=("scene", "editor", "exercise"),
)
LESSON = Page(
    name="lesson", title="lesson-title", messages=("lesson",), styles=("scene", "exercise", "playground")
)
PLAYGROUND = Page(
    name="playground",
    title="playground-title",
    messages=("playground",),
    styles=("editor", "scene", "exercise", "playground"),
)
TRAINER = Page(
    name="trainer",
    title="trainer-title",
    messages=("trainer",),
    depth=1,
    styles=("scene", "exercise", "playground"),
)
AUTHOR = Page(
    name="author",
    title="author-title",
    messages=("author", "exercises", "kinds"),
    styles=("scene", "editor", "exercise", "playground", "author"),
)
RECEIPTS = Page(name="receipts", title="receipts-title", messages=("receipts",))
PLATFORMS = Page(name="platforms", title="platforms-title", messages=("platforms",), styles=("lecturer",))
CONNECT = Page(name="connect", title="connect-title", messages=("platforms",), depth=1, styles=("lecturer",))


@router.get("/")
async def home(request: ApiRequest) -> Response:
    """Return the list of exercises."""
    return page_response(request, HOME)


@router.get("/exercises")
async def exercises_page(request: ApiRequest) -> Response:
    """Lead to the list of exercises, which is the first page."""
    query = request.url.query
    return RedirectResponse(f"./{query and '?'}{query}", 308)


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

    def work() -> tuple[dict[str, str], dict[str, str]]:
        told = {
            "id": found.id,
            "title": found.title(language),
            "statement": statement_html(found, language),
            "text_language": found.text_language(language),
            "note": language_note(found, language) or "",
        }
        return told, {"figure": _figure(request, found, language, query)}

    question = ("page", found.id, query, context_of(request))
    drawing = resources_of(request).limiters[WorkKind.DRAWING]
    values, own = await drawing.run_first(question, work, ("page", found.id))
    # A SCORM package frames the page from whatever origin its LMS has. Nobody is signed in there: a page that
    # frames it gains nothing that it could not ask for itself.
    packaged = request.query_params.get("embed") == "scorm"
    return page_response(request, EXERCISE, values, own=own, in_any_frame=packaged, off=found.access.off)


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


@router.get("/lesson")
async def lesson(request: ApiRequest) -> Response:
    """Return a page to read before the first exercise; what is drawn in it can be moved."""
    return page_response(request, LESSON)


@router.get("/playground")
async def playground(request: ApiRequest) -> Response:
    """Return a page to project in class: type any table, or take a robot of the catalogue."""
    return page_response(request, PLAYGROUND)


@router.get("/trainer/{exercise_id}")
async def trainer(request: ApiRequest) -> Response:
    """Return a page to attach frames to the axes of an exercise's robot, by the rules of the procedure."""
    try:
        found = resources_of(request).exercises.exercise(request.path_params["exercise_id"])
    except UnknownExerciseError:
        return missing_page(request)
    return page_response(request, TRAINER, {"id": found.id, "title": found.title(page_language(request))})


@router.get("/author")
async def author(request: ApiRequest) -> Response:
    """Return a page for lecturers: make an exercise from a robot, look at it, try it, take it along."""
    resources = resources_of(request)
    publishing = resources.settings.publishing if resources.courses is not None else Publishers.NOBODY
    return page_response(request, AUTHOR, {"publishing": publishing.value})


@router.get("/receipts")
async def receipts_page(request: ApiRequest) -> Response:
    """Return where a lecturer verifies a folder of receipts."""
    return page_response(request, RECEIPTS)


@router.get("/platforms")
async def platforms_page(request: ApiRequest) -> Response:
    """Return the administrator's page: who may launch."""
    resources_of(request).with_courses()
    return page_response(request, PLATFORMS)


@router.get("/lti/connect")
async def connect_page(request: ApiRequest) -> Response:
    """Return what a platform has to know of this tool, to be sent to its administrator."""
    resources_of(request).with_courses()
    root = own_root(request, resources_of(request).settings.public_url)
    return page_response(request, CONNECT, {"address": root})
