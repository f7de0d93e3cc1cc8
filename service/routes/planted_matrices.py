"""Mistakes planted in the matrices of tables."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Any

from fastapi import Body

from exercises.draws import Picker
from exercises.errors import ExerciseError
from exercises.instance import seed_text
from exercises.parts.matrix_cells import write_matrix
from exercises.parts.planted_matrices import MATRIX_MISTAKES, PlantedMatrix, plantable_in
from kinematics.cells import Limits, ReadTable, read_table
from kinematics.errors import Fault, TableError
from kinematics.symbolic import Matrix
from service.http.languages import language_of
from service.http.openapi import problems
from service.http.problems import RequestError, located
from service.http.routing import ApiRequest, api_router
from service.messages import sentence
from service.schemas import examples
from service.schemas.matrix_planting import (
    PlantMatrixMistakeAnswer,
    PlantMatrixMistakeRequest,
    WrongCell,
)
from service.work.limiters import WorkKind

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
    body: Annotated[PlantMatrixMistakeRequest, Body(openapi_examples=examples.named(_EXAMPLES))],
    request: ApiRequest,
) -> PlantMatrixMistakeAnswer:
    """One mistake of the catalogue, in the matrix of one row or in ⁰T_N, that makes it another function.

    The seed decides which one it is and where.
    """
    work = partial(_planted, body, request.settings.cell_limits, language_of(request))
    return await request.resources.limiters[WorkKind.GRADING].run(work)


def _planted(body: PlantMatrixMistakeRequest, limits: Limits, language: str) -> PlantMatrixMistakeAnswer:
    try:
        seed = seed_text(body.seed)
    except ExerciseError as error:
        raise RequestError(fault.within("seed") for fault in error.faults) from None
    with located("table"):
        read = read_table(body.table.raw(), limits)
    ways: dict[str, tuple[PlantedMatrix, ...]] = {
        code: found
        for code in MATRIX_MISTAKES[body.matrix]
        if (found := plantable_in(read.table, body.matrix, code))
    }
    if not ways:
        raise TableError(Fault(code="not_plantable", where=("table",)))
    picker = Picker(exercise_id="plant-matrix-mistake", seed=seed)
    code = picker.choice(tuple(ways), "mistake")
    chosen = picker.choice(ways[code], "place")
    return PlantMatrixMistakeAnswer(
        row=None if chosen.link is None else chosen.link + 1,
        mistake=code,
        label=sentence(language, f"option-{code}") or code,
        matrix=_written(chosen.shown, read),
        wrong_cells=[WrongCell(row=r + 1, column=c + 1) for r, c in sorted(chosen.wrong_cells)],
        mended=_written(chosen.right, read),
    )


def _written(matrix: Matrix, read: ReadTable) -> list[list[str]]:
    cells = write_matrix(matrix, read.table.n_joints, tuple(read.parameters))
    return [[str(cell) for cell in row] for row in cells]
