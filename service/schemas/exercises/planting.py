"""POST /plant-…, POST /compare-tables and POST /other-tables on the wire."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from exercises.parts.mistakes.compare_tables import ComparisonReason
from exercises.parts.mistakes.planted_matrices import MatrixKind
from exercises.parts.mistakes.planting import PLANTABLE
from kinematics.table import Convention
from service.schemas.base import WHOLE, OneOf, Wire
from service.schemas.exercises.exercises import FigureFrame, Seed
from service.schemas.exercises.verdicts import PolicyModel
from service.schemas.kinematics.joint_axes import AxisModel
from service.schemas.spoken import SpokenFeedback
from service.schemas.tables import Parameters, Table

MOST_TABLES = 10
"""As many as an author is shown of right answers that look different."""
PlantableCode = Literal[PLANTABLE]  # type: ignore[valid-type]


class PlantMistakeRequest(Wire):
    """A right table, and which mistakes may be planted in it."""

    table: Table = Field(description="a right table")
    parameters: Parameters = Field(
        default_factory=dict, description="values of the table's parameters, in its units"
    )
    mistakes: Annotated[list[PlantableCode], Field(min_length=1, max_length=len(PLANTABLE))] = Field(
        list(PLANTABLE), description="codes of the catalogue to choose from"
    )
    policy: PolicyModel = PolicyModel()
    seed: Seed = Field(None, description="names a student or a try: the same seed plants the same mistake")


class PlantMistakeAnswer(Wire):
    """A table with one mistake that makes it another robot, or breaks its policy."""

    table: Table
    mistake: PlantableCode = Field(description="what was planted")
    label: str = Field(description="what it is called, in the caller's language")
    row: int = Field(description="in which row, from 1")
    mended: Table = Field(description="the table as it was")


class PlantMatrixMistakeRequest(Wire):
    """A right table, in one of whose matrices a mistake is wanted."""

    table: Table = Field(description="a right table")
    matrix: OneOf[MatrixKind] = Field(MatrixKind.LINK, description="the matrix of one of its rows, or ⁰T_N")
    seed: Seed = Field(None, description="names a student or a try: the same seed plants the same mistake")


class WrongCell(Wire):
    """A wrong entry of a matrix."""

    row: int = Field(description="from 1")
    column: int = Field(description="from 1")


class PlantMatrixMistakeAnswer(Wire):
    """A matrix with one mistake."""

    row: int | None = Field(description="whose matrix it is: the row, from 1; null of ⁰T_N")
    mistake: str = Field(description="what was planted")
    label: str = Field(description="what it is called, in the caller's language")
    matrix: list[list[str]] = Field(description="the matrix with the mistake")
    wrong_cells: list[WrongCell] = Field(description="its wrong entries")
    mended: list[list[str]] = Field(description="the matrix as it should be")


class PlantFrameMistakeRequest(Wire):
    """A robot by its joint axes, in one of whose frames a mistake is wanted."""

    axes: list[AxisModel] = Field(min_length=1, max_length=64, description="the joint axes, base first")
    convention: OneOf[Convention]
    seed: Seed = Field(None, description="names a student or a try: the same seed plants the same mistake")


class PlantFrameMistakeAnswer(Wire):
    """Frames on a robot, one of them with a mistake."""

    frame: int = Field(description="which one is wrong, from 0")
    mistake: str = Field(description="what was planted: the rule that is broken, or y_left_handed")
    label: str = Field(description="what it is called, in the caller's language")
    frames: list[FigureFrame] = Field(description="frame 0 … N, in the coordinates of the axes")
    mended: FigureFrame = Field(description="the wrong frame as it should be")


class CompareTablesRequest(Wire):
    """Two tables that may describe the same robot."""

    first: Table = Field(description="one table")
    second: Table = Field(description="the other; its units and its convention may differ")
    parameters: Parameters = Field(
        default_factory=dict, description="values of the first table's parameters, in its units"
    )


class CompareTablesAnswer(Wire):
    """Whether two tables describe the same robot, whatever frames were chosen, and why."""

    same: bool
    reasons: list[ComparisonReason] = Field(
        description="of the same robot what differs in the frames; of another one what differs in the robot"
    )
    feedback: list[SpokenFeedback] = Field(description="the explanation of the verdict")


class OtherTablesRequest(Wire):
    """A table, and what is free beside it."""

    table: Table = Field(description="a table of the robot")
    policy: PolicyModel = Field(default_factory=PolicyModel, description="what the other tables are held to")
    parameters: Parameters = Field(
        default_factory=dict, description="values of the table's parameters, in its units"
    )
    count: Annotated[int, Field(ge=1, le=MOST_TABLES), WHOLE] = Field(1, description="how many are wanted")


class ComparedTable(Wire):
    """Another table of the same robot."""

    table: Table = Field(description="it, in the units of the first")
    reasons: list[ComparisonReason] = Field(description="in what its frames differ from those of the first")


class OtherTablesAnswer(Wire):
    """Other tables of the same robot."""

    tables: list[ComparedTable] = Field(
        description="the other convention first, if it is free, then tables that differ in one choice; "
        "fewer than were asked for where the policy leaves little free"
    )
