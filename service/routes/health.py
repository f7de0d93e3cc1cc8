"""How the service is: alive, ready, and which version."""

from typing import Annotated, Literal

from fastapi import APIRouter, Response
from fastapi.responses import PlainTextResponse
from prometheus_client import CONTENT_TYPE_LATEST
from pydantic import Field

from kinematics.errors import Fault
from service import __version__
from service.http.openapi import problems
from service.http.problems import NotFoundError, RequestPart
from service.resources import AppResources
from service.schemas.base import Wire
from service.work.limiters import WorkKind

EXAMPLE = 'framewise_grades_total{kept="yes",outcome="right"} 2000.0'

router = APIRouter(tags=["service"])


class Health(Wire):
    """The service's state."""

    status: Literal["ok"]


class LaneState(Wire):
    """The worker processes of a lane."""

    ready: bool = Field(description="whether all of its processes are there")
    running: int = Field(description="tasks that are being done")
    waiting: int = Field(description="tasks that wait")


class Readiness(Wire):
    """Whether requests should be sent here."""

    status: Literal["ready", "starting", "impaired"]
    lanes: Annotated[dict[str, LaneState], Field(description="worker processes, by the name of their lane")]
    storage: Literal["up", "down", "off"] = Field(
        description="whether the database answers, and takes what is written"
    )


class Version(Wire):
    """Which version answers."""

    name: Literal["framewise"]
    version: str = Field(description="by the rules of Semantic Versioning")


@router.get("/healthz", summary="Is the service alive?")
@router.get("/livez", summary="Is the process alive?")
async def livez(response: Response) -> Health:
    """Answer as long as requests are served; what does not answer should be started again."""
    response.headers["Cache-Control"] = "no-store"
    return Health(status="ok")


@router.get("/readyz", summary="Should requests be sent here?", responses={503: {"model": Readiness}})
async def readyz(response: Response, resources: AppResources) -> Readiness:
    """Ask each lane for its worker processes, and the database; processes that have died are started again.

    While one is being started, and while the database does not answer or has no room, the answer is 503 with
    this document.
    """
    response.headers["Cache-Control"] = "no-store"
    lanes = {
        name.value: LaneState(ready=lane.heal(), running=lane.queue.running, waiting=lane.queue.waiting)
        for name, lane in resources.workers.lanes.items()
    }
    storage: Literal["up", "down", "off"] = "off"
    if resources.courses is not None:
        answers = await resources.limiters[WorkKind.COURSES].run(resources.courses.answers)
        storage = "up" if answers else "down"
    started = all(lane.ready for lane in lanes.values())
    response.status_code = 200 if started and storage != "down" else 503
    status: Literal["ready", "starting", "impaired"] = "ready" if started else "starting"
    return Readiness(
        status="impaired" if started and storage == "down" else status, lanes=lanes, storage=storage
    )


@router.get(
    "/metrics",
    summary="What is to be watched",
    response_class=PlainTextResponse,
    responses={200: {"content": {CONTENT_TYPE_LATEST: {"example": EXAMPLE}}}, **problems(404)},
)
async def metrics(resources: AppResources) -> Response:
    """Return figures in Prometheus's text format; they name nobody.

    Latency by route, refusals by code, judgements by outcome, what runs and waits in each lane, and the
    scores that wait to be sent.
    """
    if resources.settings.metrics == "off":
        raise NotFoundError(Fault.at("address_unknown", path="/metrics"), part=RequestPart.PATH)
    told = await resources.limiters[WorkKind.COURSES].run(resources.metrics.exposition)
    return Response(told, media_type=CONTENT_TYPE_LATEST, headers={"Cache-Control": "no-store"})


@router.get("/version", summary="Which version answers?")
async def version(response: Response) -> Version:
    """Return the version of the service, for those who operate it."""
    response.headers["Cache-Control"] = "no-store"
    return Version(name="framewise", version=__version__)
