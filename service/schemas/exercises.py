"""Exercises and answers to them on the wire."""

from __future__ import annotations

from typing import Annotated, Any, Literal, TypeAlias

from pydantic import Field, PlainValidator, WithJsonSchema
from pydantic_core import PydanticCustomError

from exercises.answers import RawAnswer
from exercises.definition import PartKind
from exercises.grading import Finding, HelpLevel
from exercises.parts.report import Credit
from exercises.parts.schematic import AxisRelation, Schematic
from kinematics.table import JointType
from service.schemas.base import Matrix4, Real, Vector3, Wire
from service.schemas.tables import Cell, Table, Units
from service.schemas.verdicts import (
    CertificateModel,
    FeedbackModel,
    Help,
    LinkModel,
    PolicyModel,
    RepairModel,
)

CellRow: TypeAlias = Annotated[list[Cell], Field(min_length=4, max_length=4)]
CellMatrix: TypeAlias = Annotated[
    list[CellRow], Field(min_length=4, max_length=4, description="4×4 of numbers or expressions, row by row")
]


def _seed(value: object) -> str | None:
    """The seed as text; a whole number is as good."""
    if value is None or isinstance(value, str):
        return value
    if isinstance(value, int) and not isinstance(value, bool):
        return str(value)
    raise PydanticCustomError("seed_invalid", "a seed is a text or a whole number")


Seed: TypeAlias = Annotated[
    Any,
    PlainValidator(_seed),
    WithJsonSchema({"anyOf": [{"type": "string", "maxLength": 200}, {"type": "integer"}, {"type": "null"}]}),
]


class SchematicModel(Wire):
    """The structure of a robot."""

    joints: list[Annotated[JointType, Field(strict=False)]] = Field(
        min_length=1, max_length=64, description="type of joint 1 … n"
    )
    relations: list[Annotated[AxisRelation, Field(strict=False)]] = Field(
        max_length=63, description="how axis i lies to axis i+1, for i = 1 … n-1"
    )


class WorkspaceModel(Wire):
    """The radii of a workspace."""

    inner: Cell = Field(description="least distance")
    outer: Cell = Field(description="greatest distance")


class ExerciseAnswer(Wire):
    """What a student hands in: any of what the exercise asks, at least one of it."""

    table: Table | None = Field(None, description="the DH table")
    link_matrices: Annotated[list[CellMatrix | None], Field(min_length=1, max_length=64)] | None = Field(
        None, description="for each row of the table the matrix of its link, or null"
    )
    transform: CellMatrix | None = Field(None, description="⁰T_N in closed form")
    pose: CellMatrix | None = Field(None, description="⁰T_N in numbers, at the exercise's joint values")
    schematic: SchematicModel | None = Field(None, description="joint types, and how neighbouring axes lie")
    workspace: WorkspaceModel | None = Field(None, description="inner and outer radius")
    seed: Seed = Field(None, description="the seed that the student's values were drawn from")
    help: Help | None = Field(None, description="less help than the exercise allows; more is not given")

    def raw(self) -> RawAnswer:
        """The answer as the parts read it."""
        schematic = self.schematic
        return RawAnswer(
            table=self.table.raw() if self.table else None,
            link_matrices=self.link_matrices,
            transform=self.transform,
            pose=self.pose,
            schematic=Schematic(joints=tuple(schematic.joints), relations=tuple(schematic.relations))
            if schematic
            else None,
            workspace={"inner": self.workspace.inner, "outer": self.workspace.outer}
            if self.workspace
            else None,
        )


class ExerciseEntry(Wire):
    """An exercise in the list."""

    id: str
    version: int = Field(description="raised whenever right answers or values change")
    title: str
    summary: str = Field(description="the statement's first sentence")
    joints: int
    parts: list[PartKind] = Field(description="what is asked")
    points: Real


class ExerciseList(Wire):
    """All exercises."""

    language: str
    languages: list[str] = Field(description="the languages that every exercise speaks")
    exercises: list[ExerciseEntry]


class StatementModel(Wire):
    """A statement."""

    markdown: str
    html: str = Field(description="the same, safe to put into a page")


class DimensionValue(Wire):
    """A dimension of the robot."""

    name: str
    value: Real
    unit: str


class JointName(Wire):
    """A joint of the robot."""

    name: str = Field(description="what its variable is called in cells")
    type: Literal["revolute", "prismatic"]


class AskedPart(Wire):
    """Something that is asked."""

    kind: PartKind
    points: Real
    task: str = Field(description="what to do, in the caller's language")
    joints: list[Real] | None = Field(
        None, description="joint values of the numeric pose, in the exercise's units"
    )
    point: str | None = Field(None, description="whose workspace is asked for")
    reach_from: str | None = Field(
        None, description="from where radii are measured: axis, or a point of the figure"
    )


class FigureAxis(Wire):
    """The axis of a joint."""

    joint: int
    type: Literal["revolute", "prismatic"]
    point: Vector3 = Field(description="where the joint's body stands")
    direction: Vector3 = Field(description="unit vector; its sense means something only if signed")
    signed: bool = Field(description="the sense is that of the positive joint variable")


class FigureDimension(Wire):
    """A named length."""

    name: str
    from_: Vector3 = Field(alias="from")
    to: Vector3


class FigurePoint(Wire):
    """A marked point."""

    name: str
    at: Vector3


class FigureGround(Wire):
    """Where the robot is fixed."""

    at: Vector3
    normal: Vector3


class FigureModel(Wire):
    """The geometry of the figure, lengths in metres, z up; no frames."""

    axes: list[FigureAxis]
    links: list[list[Vector3]] = Field(description="polylines")
    dimensions: list[FigureDimension]
    points: list[FigurePoint]
    ground: FigureGround | None
    size: Real = Field(description="diagonal of the box that holds the robot")
    description: str = Field(description="the figure in words, in the caller's language")


class ExerciseModel(Units):
    """An exercise with one student's values. It never holds the key."""

    id: str
    version: int
    seed: str | None
    language: str
    title: str
    statement: StatementModel
    rules: list[str] = Field(description="what is free and what is fixed, in the caller's language")
    conventions: list[Literal["standard", "modified"]] = Field(description="conventions that are accepted")
    policy: PolicyModel
    help: HelpLevel = Field(description="the most that a verdict tells")
    parameters: dict[str, Real] = Field(description="values of the dimensions, in the exercise's units")
    dimensions: list[DimensionValue] = Field(description="the same with units, in the order of the table")
    joints: list[JointName]
    parts: list[AskedPart]
    points: Real = Field(description="what all parts together are worth")
    figure: FigureModel


class FactModel(Wire):
    """One thing that an answer says, and what was found of it."""

    where: list[str | int] = Field(description="path inside the part's answer")
    finding: Finding


class PartModel(Wire):
    """What is said of one part of an answer."""

    kind: PartKind
    correct: bool = Field(description="right for the robot")
    score: Real = Field(ge=0, le=1)
    points: Real
    max_points: Real
    credit: Credit = Field(
        description="what the marks rest on: key, own_table (an error before it is marked once), none"
    )
    facts: list[FactModel]
    feedback: list[FeedbackModel]


class TotalModel(Wire):
    """The points of an answer."""

    points: Real
    max_points: Real
    score: Real = Field(ge=0, le=1)
    missing: list[PartKind] = Field(description="parts that are asked and were not handed in")


class KeyInFigure(Wire):
    """How the key lies in the figure; told with an accepted table only."""

    base: Matrix4 = Field(description="pose of the key's frame 0 in the figure [m]")
    posture: list[Real] = Field(description="the key's joint values in the figure [rad or m]")
    directions: list[Vector3] = Field(
        description="unit vectors along the axes, in the sense of the key's variables"
    )


class GradedModel(Units):
    """The verdict on the table, and what is said of every part that was handed in."""

    correct: bool = Field(description="of the table; without one, of all parts that were handed in")
    score: Real = Field(ge=0, le=1, description="of the table; without one, of the parts that were handed in")
    basis: str | None = Field(
        description="what the verdict on the table rests on: proved, verified or refuted"
    )
    certificate: CertificateModel | None
    links: list[LinkModel]
    feedback: list[FeedbackModel]
    repairs: list[RepairModel]
    parts: dict[PartKind, PartModel]
    total: TotalModel
    help: HelpLevel = Field(description="how much was told")
    seed: str | None
    version: int = Field(description="of the exercise")
    figure: KeyInFigure | None
