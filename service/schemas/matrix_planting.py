"""POST /plant-matrix-mistake on the wire."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from exercises.parts.mistakes.planted_matrices import MatrixKind
from service.schemas.base import Wire
from service.schemas.exercises import Seed
from service.schemas.tables import Table


class PlantMatrixMistakeRequest(Wire):
    """A right table, in one of whose matrices a mistake is wanted."""

    table: Table = Field(description="a right table")
    matrix: Annotated[MatrixKind, Field(strict=False)] = Field(
        MatrixKind.LINK, description="the matrix of one of its rows, or ⁰T_N"
    )
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
