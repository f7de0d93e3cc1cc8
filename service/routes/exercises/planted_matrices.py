"""Mistakes planted in the matrices of tables."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Any

from exercises.parts.cells.matrix_cells import write_matrix
from exercises.parts.mistakes.planted_matrices import MATRIX_MISTAKES, PlantedMatrix, plantable_in
from kinematics.cells import Limits, ReadTable, read_table
from kinematics.symbolic import Matrix
from service.http.languages import language_of
from service.http.openapi import body_with, problems
from service.http.problems import located
from service.http.routing import ApiRequest, api_router
from service.schemas import examples
from service.schemas.exercises.planting import (
    PlantMatrixMistakeAnswer,
    PlantMatrixMistakeRequest,
    WrongCell,
)
from service.schemas.spoken import option_name
from service.wire.exercises.planted_choice import chosen_mistake

router = api_router("exercises")

_EXAMPLES: dict[str, Any] = {
    "a cylindrical arm": {"table": examples.CYLINDRICAL, "seed": "ana"},
    "two links, their last frame": {"table": examples.TWO_LINKS, "matrix": "transform", "seed": "ana"},
}


@router.post(
    "/plant-matrix-mistake",
    summary="A right table in, one of its matrices with a mistake out",
    responses=problems(400, 413, 415, 422, 503),
)
async def plant_matrix_mistake(
    body: Annotated[PlantMatrixMistakeRequest, body_with(_EXAMPLES)],
    request: ApiRequest,
) -> PlantMatrixMistakeAnswer:
    """Plant a mistake of the catalogue, in the matrix of one row or in ⁰T_N, that makes it another function.

    The seed decides which one it is and where.
    """
    work = partial(_planted, body, request.settings.cell_limits, language_of(request))
    return await request.resources.grading.run(work)


def _planted(body: PlantMatrixMistakeRequest, limits: Limits, language: str) -> PlantMatrixMistakeAnswer:
    with located("table"):
        read = read_table(body.table.raw(), limits)
    ways: dict[str, tuple[PlantedMatrix, ...]] = {
        code: found
        for code in MATRIX_MISTAKES[body.matrix]
        if (found := plantable_in(read.table, body.matrix, code))
    }
    code, chosen = chosen_mistake("plant-matrix-mistake", body.seed, ways, "table")
    return PlantMatrixMistakeAnswer(
        row=None if chosen.link is None else chosen.link + 1,
        mistake=code,
        label=option_name(code, language),
        matrix=_written(chosen.shown, read),
        wrong_cells=[WrongCell(row=r + 1, column=c + 1) for r, c in sorted(chosen.wrong_cells)],
        mended=_written(chosen.right, read),
    )


def _written(matrix: Matrix, read: ReadTable) -> list[list[str]]:
    cells = write_matrix(matrix, read.table.n_joints, tuple(read.parameters))
    return [[str(cell) for cell in row] for row in cells]
