"""POST /convert on the wire."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated, Self, TypeAlias

from pydantic import Field, model_validator
from pydantic_core import PydanticCustomError

from kinematics.table import JointType
from service.schemas.base import Matrix4, Real, Vector3, Wire
from service.schemas.scm import Chain
from service.schemas.tables import Parameters, Row, Table, Units


class Target(StrEnum):
    """What a robot can be converted to."""

    STANDARD = "standard"
    MODIFIED = "modified"
    POE = "poe"


class ConvertRequest(Wire):
    """A robot, described in exactly one way, and the description that is wanted."""

    to: Annotated[Target, Field(strict=False)] = Field(
        description="standard or modified: a DH table; poe: a product of exponentials"
    )
    table: Table | None = Field(None, description="a DH table")
    robot: str | None = Field(None, max_length=64, description="the id of a robot of the catalogue")
    scm: Chain | None = Field(None, description="an SCM chain; it becomes a DH table (SCM2DH)")
    parameters: Parameters | None = None

    @model_validator(mode="after")
    def _one_source(self) -> Self:
        names = sorted(set(type(self).model_fields) - {"to", "parameters"})
        given = [name for name in names if getattr(self, name) is not None]
        if len(given) != 1:
            raise PydanticCustomError(
                "one_source", "describe the robot in exactly one way: {allowed}", {"allowed": tuple(names)}
            )
        return self


MatrixOfCells: TypeAlias = Annotated[
    list[Annotated[list[Real | str], Field(min_length=4, max_length=4)]],
    Field(
        min_length=4, max_length=4, description="4×4; an entry that depends on a parameter is an expression"
    ),
]


class TableAnswer(Units):
    """base · (this table) · tool is the described robot, for every q."""

    table: Table
    base: MatrixOfCells = Field(description="what stands before the table")
    tool: MatrixOfCells = Field(description="what stands behind the table")
    base_row: Row | None = Field(None, description="the base as a fixed row, where it is one")
    tool_row: Row | None = Field(None, description="the tool as a fixed row, where it is one")


class Screw(Wire):
    """A joint's motion: the velocity field of a unit joint rate."""

    joint: JointType
    linear: Vector3 = Field(
        description="v: the velocity at the world's origin, per radian of a revolute joint"
    )
    angular: Vector3 = Field(
        description="ω: the unit vector along a revolute joint's axis; zero if prismatic"
    )


class ProductAnswer(Units):
    """T(q) = exp([S_1] q_1) ⋯ exp([S_n] q_n) · home, q in radians and in the length unit."""

    screws: list[Screw] = Field(description="S_1 … S_n at q = 0, in the axes of the world")
    home: Matrix4 = Field(description="the pose of the end frame at q = 0")


ConvertAnswer: TypeAlias = TableAnswer | ProductAnswer
