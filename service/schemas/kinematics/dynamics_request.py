"""POST /dynamics on the wire."""

from enum import StrEnum
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field, RootModel
from pydantic_core import PydanticCustomError

from kinematics.dynamics.reading import RawBody
from kinematics.printing import Notation
from service.schemas.base import LONGEST_LIST, Listed, OneOf, Real, Wire
from service.schemas.kinematics.robot_question import RobotQuestion
from service.schemas.kinematics.written_matrices import (
    STANDARD_FORMATS,
    Formats,
    SomeParameters,
    WritingAnswer,
    WrittenMatrix,
)
from service.schemas.tables import Cell, Units

Cells3 = Annotated[list[Cell], Field(min_length=3, max_length=3)]
JointValues = Annotated[list[Real], Field(max_length=64)]


class EquationPart(StrEnum):
    """A part of M(q) q̈ + C(q, q̇) q̇ + g(q) = τ that may be asked for.

    M: the mass matrix. C: made of Christoffel symbols. h: C q̇. g: what gravity asks of the joints.
    """

    M = "M"
    C = "C"
    H = "h"
    G = "g"


def _not_in_one_row(inertia: Any) -> Any:
    if isinstance(inertia, list) and inertia and not any(isinstance(row, list) for row in inertia):
        raise PydanticCustomError("inertia_in_one_row", "moments and products of inertia in one list")
    return inertia


class LinkBody(Wire):
    """What moves with one frame of the table."""

    mass: Cell = Field(0, description="[kg]")
    centre: Cells3 = Field([0, 0, 0], description="centre of mass in the link's frame, in the table's unit")
    inertia: Annotated[list[Cells3], Field(min_length=3, max_length=3), BeforeValidator(_not_in_one_row)] = (
        Field(
            [[0, 0, 0], [0, 0, 0], [0, 0, 0]],
            description="3×3 about the centre of mass, in the axes of the link's frame [kg m²]",
        )
    )

    def raw(self) -> RawBody:
        """Return the link as the cell grammar reads it."""
        return RawBody(mass=self.mass, centre=tuple(self.centre), inertia=tuple(map(tuple, self.inertia)))


class WeighedRobot(RobotQuestion):
    """A robot and what its links weigh."""

    links: Listed[LinkBody] | None = Field(
        None, description="one for each row of the table, fixed rows too; `puma560` brings its own"
    )
    gravity: Cells3 = Field([0, 0, -9.81], description="acceleration of free fall in frame 0 [m/s²]")


class NumericDynamicsRequest(WeighedRobot):
    """A robot at one configuration, and how it moves or is driven."""

    joints: JointValues = Field(description="q_1 … q_n, in the table's units")
    rates: JointValues | None = Field(None, description="q̇_1 … q̇_n, in the table's units per second; at rest")
    accelerations: JointValues | None = Field(
        None, description="q̈_1 … q̈_n, in the table's units per second squared: asks for the torque"
    )
    torque: JointValues | None = Field(
        None, description="torques [N m] and forces [N] at the joints: asks for the accelerations"
    )


class SymbolicDynamicsRequest(WeighedRobot):
    """A robot whose equations of motion are wanted in closed form: no joint values."""

    form: Literal["symbolic"] = Field(description="the word symbolic: closed forms, and no joint values")
    parameters: SomeParameters = Field(default_factory=dict)
    parts: list[OneOf[EquationPart]] = Field(
        default_factory=lambda: [EquationPart.M, EquationPart.C, EquationPart.G],
        min_length=1,
        max_length=LONGEST_LIST,
        description="what is wanted; M, C and g if left out",
    )
    formats: Formats = Field(default_factory=lambda: list(STANDARD_FORMATS))
    notation: OneOf[Notation] = Field(Notation.FULL, description="full: cos(q2 + q3); short: c23")


class DynamicsAnswer(Units):
    """The dynamics at one configuration, in SI units whatever the table's: kg, m, s, rad, N, N m."""

    M: list[list[Real]] = Field(description="mass matrix M(q)")
    g: list[Real] = Field(description="what holds the robot still against gravity")
    C: list[list[Real]] | None = Field(None, description="C(q, q̇), made of Christoffel symbols; needs rates")
    h: list[Real] | None = Field(None, description="C(q, q̇) q̇; needs rates")
    torque: list[Real] | None = Field(
        None, description="M q̈ + C q̇ + g; needs accelerations, at rest without rates"
    )
    accelerations: list[Real] | None = Field(
        None, description="M⁻¹ (τ − C q̇ − g) [rad/s², m/s²]; needs torque"
    )
    potential_energy: Real = Field(description="[J], zero where the centres of mass lie level with frame 0")
    kinetic_energy: Real | None = Field(None, description="[J]; needs rates")


class SymbolicDynamicsAnswer(WritingAnswer):
    """The equations of motion in closed form, in SI units: names of lengths stand for metres."""

    rates: list[str] = Field(description="the names of q̇_1 … q̇_n; functions take them after the parameters")
    M: WrittenMatrix | None = Field(None, description="mass matrix M(q), n×n")
    C: WrittenMatrix | None = Field(None, description="C(q, q̇), made of Christoffel symbols, n×n")
    h: WrittenMatrix | None = Field(None, description="C(q, q̇) q̇, n×1")
    g: WrittenMatrix | None = Field(None, description="what gravity asks of the joints, n×1")


class DynamicsBody(RootModel[NumericDynamicsRequest | SymbolicDynamicsRequest]):
    """A question about dynamics, in numbers or in closed form."""


class DynamicsReply(RootModel[DynamicsAnswer | SymbolicDynamicsAnswer]):
    """Dynamics in numbers or in closed form."""
