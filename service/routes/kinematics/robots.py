"""GET /robots and GET /robots/{robot_id}: the robot catalogue."""

from collections.abc import Callable
from functools import cache, partial
from typing import Annotated, Self

import orjson
from fastapi import Path, Request, Response
from pydantic import Field

from kinematics import catalogue
from kinematics.catalogue import Robot as CatalogueRobot
from kinematics.errors import Fault
from service.http.languages import Language, language_of
from service.http.openapi import problems
from service.http.problems import NotFoundError, RequestPart
from service.http.routing import JSON, api_router
from service.messages import sentence
from service.schemas.base import Real, Wire
from service.schemas.kinematics.scm import ScmChainModel
from service.schemas.tables import AnsweredRow, AnsweredTable
from service.web.responses import text_response


class SourceModel(Wire):
    """Where a robot comes from."""

    document: str = Field(description="title, author and year")
    place: str = Field(description="figure, equation, table or script in it")
    figures: str = Field(description="where the lengths come from, as printed")


class ConfigurationModel(Wire):
    """Joint values that mean something."""

    joints: list[Real] = Field(description="q_1 … q_n, in the table's units")
    meaning: str = Field(description="what the arm looks like there")


class ScmForm(Wire):
    """The same robot as an SCM chain, ready to be sent to the SCM calls."""

    chain: ScmChainModel
    parameters: dict[str, Real] = Field(description="the value of every parameter in the chain")


class RobotModel(Wire):
    """A robot of the catalogue: table and parameters are ready for every call that takes a table."""

    id: str = Field(description="its name in this API, and its exercise's")
    name: str
    source: SourceModel
    table: AnsweredTable
    parameters: dict[str, Real] = Field(description="the value of every parameter, in the table's units")
    configurations: dict[str, ConfigurationModel] = Field(description="named joint values")
    limits: list[Annotated[list[Real], Field(min_length=2, max_length=2)]] | None = Field(
        None, description="[low, high] of every joint in the table's units; left out where they are not known"
    )
    limits_source: str | None = Field(None, description="where the limits come from")
    scm: ScmForm | None = Field(None, description="the robot by the SCM method")

    @classmethod
    def of(cls, robot: CatalogueRobot, told: Callable[[str], str | None]) -> Self:
        """Return a robot of the catalogue as it goes over the wire."""
        raw = robot.raw
        return cls(
            id=robot.id,
            name=told(f"robot-{robot.id}") or robot.name,
            source=SourceModel.from_record(robot.source),
            table=AnsweredTable(
                convention=raw.convention,
                angle_unit=raw.angle_unit,
                length_unit=raw.length_unit,
                rows=[
                    AnsweredRow(joint=read.joint, alpha=row.alpha, a=row.a, d=row.d, theta=row.theta)
                    for row, read in zip(raw.rows, robot.table.table.rows, strict=True)
                ],
            ),
            parameters=dict(robot.parameters),
            configurations={
                name: ConfigurationModel(
                    joints=list(found.joints),
                    meaning=told(f"configuration-{robot.id}-{name}") or found.meaning,
                )
                for name, found in robot.configurations.items()
            },
            limits=[list(pair) for pair in robot.limits] if robot.limits else None,
            limits_source=robot.limits_source,
            scm=None
            if robot.chain is None
            else ScmForm(chain=ScmChainModel.from_record(robot.chain.raw), parameters=robot.chain_values),
        )


class RobotList(Wire):
    """The catalogue."""

    robots: list[RobotModel]


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
    return {"Cache-Control": "public, max-age=300", "Content-Language": language, "Vary": "Accept-Language"}


@cache
def _written(robot_id: str, language: str) -> bytes:
    wire = RobotModel.of(catalogue.robot(robot_id), partial(sentence, language))
    return orjson.dumps(wire.model_dump(mode="json", exclude_none=True))
