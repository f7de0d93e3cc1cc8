"""The application: routes, the one way from an error to a problem document, and the outermost layer."""

import asyncio
import functools
import logging
from collections.abc import AsyncIterator, Iterator
from contextlib import asynccontextmanager
from datetime import timedelta

from anyio import to_thread
from fastapi import FastAPI, Request, Response
from fastapi.exceptions import RequestValidationError
from fastapi.routing import APIRoute
from starlette.exceptions import HTTPException
from starlette.middleware.cors import CORSMiddleware
from starlette.routing import BaseRoute, Match

from kinematics.errors import Fault, KinematicsError
from service import __version__
from service.http import openapi
from service.http.idempotency import IdempotencyMiddleware
from service.http.link_guard import LinkGuard
from service.http.metering import MeteringMiddleware, path_of
from service.http.middleware import OuterMiddleware
from service.http.negotiation import preferred_media_type
from service.http.problem_answers import refusal
from service.http.problems import BodyError, MethodError, NotFoundError, RequestPart, ServiceError
from service.http.routing import DirectRoute
from service.http.tracing import TracingMiddleware, exporting
from service.http.validation import request_error
from service.metrics import Metrics
from service.resources import Resources, resources_of
from service.routes import routers
from service.secret import installation_secret
from service.settings import Settings
from service.web.responses import missing_page, refusal_page
from service.work.collection import LOOK_SECONDS, Collection, new_objects_alone
from service.work.drawing_ahead import DrawingAhead, ReadingAhead
from service.work.heaps import share_heaps, switch_threads_often
from service.work.retention import Retention
from service.work.score_sender import ScoreSender
from service.work.settling import Settling
from service.work.threads import BackgroundThread, call_briefly, stop_all

_log = logging.getLogger("uvicorn.error")
THREADS = 4
"""Threads for what has no limiter of its own, such as compressing: more of them would only wait for each
other."""

WATCH_SECONDS = 2.0  # Seconds between two looks at the folders of exercises.

DESCRIPTION = """\
Denavit–Hartenberg kinematics over HTTP: a table and joint values in; poses, Jacobians, closed forms and other
descriptions of the same robot out. Angles and lengths come and go in the units that the table names. Every
refusal is an `application/problem+json` document with a stable code, the place of the fault and a sentence in
the caller's language (`Accept-Language`).
"""

TAGS = (
    {
        "name": "kinematics",
        "description": "What follows from a DH table, and other ways to describe its robot.",
    },
    {"name": "robots", "description": "The robots of the source documents."},
    {"name": "scm", "description": "The Sistema Coordenado Móvel."},
    {"name": "exercises", "description": "Exercises, and the judgement of answers."},
    {"name": "authoring", "description": "Making exercises."},
    {"name": "receipts", "description": "What a student takes away from a verdict, signed."},
    {"name": "service", "description": "About the service itself."},
)


_EXPOSED = (
    "X-Request-Id", "Content-Language", "Idempotency-Replayed", "Framewise-Arrival",
    "Retry-After", "RateLimit-Limit", "RateLimit-Remaining", "RateLimit-Reset",
)  # fmt: skip
"""Headers that scripts of other origins may read."""


OFTEN = frozenset(
    {
        "/api/v1/grade",
        "/api/v1/exercises/{exercise_id}/grade",
        "/api/v1/forward-kinematics",
        "/api/v1/jacobian",
        "/api/v1/understand",
        "/api/v1/session",
        "/api/v1/session/attempts",
        "/api/v1/session/draft",
        "/api/v1/exercises/{exercise_id}",
        "/api/v1/exercises/{exercise_id}/figures/{address}.svg",
        "/exercises/{exercise_id}",
        "/static/{version}/{name:path}",
    }
)
"""Paths that are asked for more than any other, by pages and by programs: each route that is tried before the
right one costs a request some microseconds."""


def _rank(route: BaseRoute) -> int:
    """Where a route stands among those that are tried one after the other."""
    if getattr(route, "path", "") in OFTEN:
        return 0
    return 1 if isinstance(route, DirectRoute) else 2


def create_app(settings: Settings | None = None) -> FastAPI:
    """Return the service with the given settings; those of the environment if left out."""
    settings = settings or Settings()
    app = FastAPI(
        title="Framewise",
        summary="DH kinematics, and an exercise checker that accepts every valid frame choice.",
        description=DESCRIPTION,
        version=__version__,
        license_info={"name": "Apache-2.0", "identifier": "Apache-2.0"},
        openapi_url=None,
        docs_url=None,
        redoc_url=None,
        redirect_slashes=False,
        telemetry={"tracing": False, "metrics": False, "logs": False},
        lifespan=_lifespan,
    )
    app.state.resources = Resources(settings)
    app.state.endings = [app.state.resources.close]
    app.router.routes.extend(sorted([route for router in routers() for route in router.routes], key=_rank))
    app.add_exception_handler(KinematicsError, _refuse)
    app.add_exception_handler(ServiceError, _refuse)
    app.add_exception_handler(RequestValidationError, _refuse_invalid)
    app.add_exception_handler(HTTPException, _refuse_http)
    app.add_middleware(IdempotencyMiddleware)
    if settings.api_keys or settings.cost_per_minute:
        app.add_middleware(MeteringMiddleware, settings=settings)
    secret, library = installation_secret(settings), app.state.resources.exercises
    app.add_middleware(LinkGuard, secret=secret, library=library, refused=_refused_link)
    if origins := settings.calling_origins:  # outside of what refuses, or a page could not read why
        app.add_middleware(
            CORSMiddleware,
            allow_origins=list(origins),
            allow_methods=["GET", "POST", "PUT", "DELETE"],
            allow_headers=["*"],
            expose_headers=list(_EXPOSED),
        )
    app.add_middleware(OuterMiddleware, settings=settings)
    if settings.traces:
        provider = exporting(settings.traces)
        app.state.endings.append(provider.shutdown)
        app.add_middleware(TracingMiddleware, provider=provider)
    app.openapi = functools.cache(lambda: openapi.document(app, TAGS))  # type: ignore[method-assign]
    return app


@asynccontextmanager
async def _lifespan(app: FastAPI) -> AsyncIterator[None]:
    """Start the workers with the application, and end them with it."""
    switch_threads_often()
    share_heaps()
    to_thread.current_default_thread_limiter().total_tokens = THREADS
    with new_objects_alone() as collection:
        watching = [
            asyncio.create_task(_watch(app.state.resources.metrics, collection)),
            asyncio.create_task(_collect(collection)),
        ]
        try:
            async with _working(app):
                yield
        finally:
            for task in watching:
                task.cancel()


@asynccontextmanager
async def _working(app: FastAPI) -> AsyncIterator[None]:
    """Start worker processes and background threads, and end them."""
    resources: Resources = app.state.resources
    resources.workers.warm()
    if resources.courses is not None:
        _log.info("Courses and attempts are stored in %s", resources.courses.store.location)
    threads = list(_background_threads(resources))
    for thread in threads:
        thread.start()
    try:
        yield
    finally:
        await asyncio.to_thread(stop_all, threads)
        await asyncio.gather(*(asyncio.to_thread(call_briefly, end) for end in app.state.endings))


def _background_threads(resources: Resources) -> Iterator[BackgroundThread]:
    """What goes on beside the requests; most of it where there is storage."""
    yield ReadingAhead(resources.exercises)
    courses = resources.courses
    if courses is None:
        return
    yield DrawingAhead(courses.store, resources.exercises, resources.figures, resources.is_busy)
    yield ScoreSender(courses)
    yield Settling(courses.store)
    if (retention := _retention(resources)) is not None:
        yield retention
    yield from (resources.closed_forms, resources.figures)


def _retention(resources: Resources) -> Retention | None:
    """What removes old data every day, where there is any and nobody else does it."""
    settings, courses = resources.settings, resources.courses
    if courses is None or settings.purge == "by_hand":
        return None
    people, log = timedelta(days=settings.people_days), timedelta(days=settings.access_days)
    return Retention(courses.store, people=people, log=log)


async def _watch(metrics: Metrics, collection: Collection) -> None:
    """Keep figures that another process of this server tells for this one; look for garbage now and then."""
    while True:
        metrics.note_occupancy()
        collection.look_at_all(metrics.idle_seconds)
        await asyncio.sleep(WATCH_SECONDS)


async def _collect(collection: Collection) -> None:
    """Look for garbage among what is new, a little at a time."""
    while True:
        collection.look_at_new()
        await asyncio.sleep(LOOK_SECONDS)


async def _refuse(request: Request, error: Exception) -> Response:
    assert isinstance(error, (ServiceError, KinematicsError))
    return refusal(request, error)


def _refused_link(request: Request, error: ServiceError) -> Response:
    return refusal_page(request, error) if _is_for_a_reader(request) else refusal(request, error)


async def _refuse_invalid(request: Request, error: Exception) -> Response:
    assert isinstance(error, RequestValidationError)
    route = request.scope.get("route")
    field = route.body_field if isinstance(route, APIRoute) else None
    model = field.field_info.annotation if field else None
    most = resources_of(request).settings.fault_limit
    return await _refuse(request, request_error(error.errors(), model, most))


async def _refuse_http(request: Request, error: Exception) -> Response:
    """Answer what the framework refuses by itself; OPTIONS is answered with what the address allows."""
    assert isinstance(error, HTTPException)
    if error.status_code == 405:
        methods = _methods_at(request)
        allow = ", ".join(methods)
        if request.method == "OPTIONS":
            return Response(status_code=204, headers={"Allow": allow})
        fault = Fault.at("method_not_allowed", method=request.method, allowed=methods)
        return await _refuse(request, MethodError(fault, headers={"Allow": allow}))
    if error.status_code == 404:
        if _is_for_a_reader(request):
            return missing_page(request)
        fault = Fault.at("address_unknown", path=request.url.path)
        return await _refuse(request, NotFoundError(fault, part=RequestPart.PATH))
    if error.status_code == 400:
        return await _refuse(request, BodyError(Fault.at("body_invalid")))
    raise error


def _is_for_a_reader(request: Request) -> bool:
    """Whether a browser asks for a page, and not a program or a page's script for data."""
    if request.method not in {"GET", "HEAD"} or path_of(request.scope).startswith("/api/"):
        return False
    accept = request.headers.get("accept", "")
    return preferred_media_type(accept, ("application/json", "text/html")) == "text/html"


def _methods_at(request: Request) -> tuple[str, ...]:
    """Every method that some route knows at the request's path."""
    methods = {"OPTIONS"}
    for route in request.app.routes:
        if route.matches(request.scope)[0] is not Match.NONE:
            methods |= set(getattr(route, "methods", None) or ())
    if "GET" in methods:
        methods.add("HEAD")
    return tuple(sorted(methods))
