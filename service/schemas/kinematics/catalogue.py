"""The robot catalogue on the wire."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Self

from pydantic import Field

from kinematics.catalogue import Robot as CatalogueRobot
from service.schemas.base import Real, Wire
from service.schemas.kinematics.scm import ScmChainModel
from service.schemas.tables import AnsweredRow, AnsweredTable


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
        """Return a robot of the catalogue as it goes over the wire.

        Args:
            robot: the robot.
            told: the sentence of a message in the caller's language, None if there is none.
        """
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
