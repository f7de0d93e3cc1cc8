"""The robot catalogue."""

from __future__ import annotations

from functools import cache, partial
from typing import Annotated

import orjson
from fastapi import Path, Request, Response

from kinematics import catalogue
from kinematics.errors import Fault
from service.http.languages import Language, language_of
from service.http.openapi import problems
from service.http.problems import NotFoundError, RequestPart
from service.http.routing import JSON, api_router
from service.messages import sentence
from service.schemas.kinematics.catalogue import RobotList, RobotModel
from service.web.responses import text_response

router = api_router("robots")


@router.get("/robots", response_model=RobotList, summary="The robots of the source documents")
async def robots(request: Request, lang: Language = None) -> Response:
    """Return every robot of the catalogue, with its source; its table and parameters can be sent back."""
    language = language_of(request)
    entries = b",".join(_written(robot_id, language) for robot_id in catalogue.robot_ids())
    return text_response(request, b'{"robots":[%b]}' % entries, JSON, _headers(language))


@router.get(
    "/robots/{robot_id}",
    response_model=RobotModel,
    responses=problems(404),
    summary="One robot of the catalogue",
)
async def robot(
    request: Request,
    robot_id: Annotated[str, Path(max_length=64, openapi_examples={"PUMA 560": {"value": "puma560"}})],
    lang: Language = None,
) -> Response:
    """Return a robot of the catalogue: source, DH table, parameters, named configurations, limits, SCM chain.

    Its name and the descriptions of its configurations are in the caller's language; quotations of a source
    stay as they were written.
    """
    language = language_of(request)
    known = catalogue.robot_ids()
    if robot_id not in known:
        fault = Fault.at("robot_unknown", "robot_id", robot=robot_id, known=known)
        raise NotFoundError(fault, part=RequestPart.PATH)
    return text_response(request, _written(robot_id, language), JSON, _headers(language))


def _headers(language: str) -> dict[str, str]:
    return {
        "Cache-Control": "public, max-age=300",
        "Content-Language": language,
        "Vary": "Accept-Language",
    }


@cache
def _written(robot_id: str, language: str) -> bytes:
    wire = RobotModel.of(catalogue.robot(robot_id), partial(sentence, language))
    return orjson.dumps(wire.model_dump(mode="json", exclude_none=True))
