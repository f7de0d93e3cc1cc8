"""Mistakes planted in tables, matrices and frames, and tables compared."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Annotated, Any, TypeVar

import numpy as np

from exercises.alternatives import other_tables
from exercises.draws import Picker
from exercises.errors import ExerciseError
from exercises.grading import Policy, ToolRule, grade
from exercises.instance import seed_text
from exercises.parts.cells.matrix_cells import write_matrix
from exercises.parts.mistakes.compare_tables import true_reasons
from exercises.parts.mistakes.planted_matrices import MATRIX_MISTAKES, PlantedMatrix, plantable_in
from exercises.parts.mistakes.planting import Planted, plantable
from kinematics.cells import Limits, ReadTable, read_table
from kinematics.errors import Fault, TableError
from kinematics.frames.assignment import assign_frames
from kinematics.frames.wrong_frames import plantable_in_frames, right_handed
from kinematics.symbolic import Matrix
from service.http.languages import language_of
from service.http.openapi import body_with, problems
from service.http.problems import RequestError, located
from service.http.routing import ApiRequest, api_router
from service.schemas import examples
from service.schemas.exercises import planting as wire
from service.schemas.exercises.exercises import FigureFrame
from service.schemas.spoken import option_name, spoken
from service.schemas.tables import Table
from service.wire.kinematics.written_tables import TableWriter

Way = TypeVar("Way")
router = api_router("exercises")

_ELBOW: dict[str, Any] = {
    "convention": "standard",
    "angle_unit": "deg",
    "rows": [
        {"theta": "q1", "d": 0.4, "a": 0, "alpha": 90},
        {"theta": "q2", "d": 0, "a": 0.5, "alpha": 0},
        {"theta": "q3", "d": 0, "a": 0.3, "alpha": 0},
    ],
}
_REVERSED: dict[str, Any] = {
    **_ELBOW,
    "rows": [{**_ELBOW["rows"][0], "alpha": -90}, *_ELBOW["rows"][1:]],
}
_IN_TABLE = {"an elbow arm": {"table": _ELBOW, "seed": "ana"}}
_OTHERS = {"an elbow arm, in its own convention": {"table": _ELBOW, "policy": {"convention": "standard"}}}
_COMPARE = {"the axes of joints 2 and 3 reversed": {"first": _ELBOW, "second": _REVERSED}}
_IN_MATRIX: dict[str, Any] = {
    "a cylindrical arm": {"table": examples.CYLINDRICAL, "seed": "ana"},
    "two links, their last frame": {"table": examples.TWO_LINKS, "matrix": "transform", "seed": "ana"},
}
_IN_FRAMES: dict[str, Any] = {
    "a SCARA": {
        "axes": [
            {"joint": "revolute", "point": [0, 0, 0], "direction": [0, 0, 1]},
            {"joint": "revolute", "point": [0.4, 0, 0], "direction": [0, 0, 1]},
            {"joint": "prismatic", "point": [0.65, 0, 0], "direction": [0, 0, 1]},
        ],
        "convention": "standard",
        "seed": "ana",
    },
}


@router.post(
    "/plant-mistake", summary="A right table in, a table with one mistake out", responses=problems(503)
)
async def plant_mistake(
    body: Annotated[wire.PlantMistakeRequest, body_with(_IN_TABLE)], request: ApiRequest
) -> wire.PlantMistakeAnswer:
    """Plant a mistake of the catalogue, in one row, that makes the table another robot or breaks its policy.

    What the frames leave free is no mistake and is never planted. The seed decides which one it is.
    """
    work = partial(_planted_in_table, body, request.settings.cell_limits, language_of(request))
    return await request.resources.grading.run(work)


@router.post(
    "/plant-matrix-mistake",
    summary="A right table in, one of its matrices with a mistake out",
    responses=problems(503),
)
async def plant_matrix_mistake(
    body: Annotated[wire.PlantMatrixMistakeRequest, body_with(_IN_MATRIX)], request: ApiRequest
) -> wire.PlantMatrixMistakeAnswer:
    """Plant a mistake of the catalogue, in the matrix of one row or in ⁰T_N, that makes it another function.

    The seed decides which one it is and where.
    """
    work = partial(_planted_in_matrix, body, request.settings.cell_limits, language_of(request))
    return await request.resources.grading.run(work)


@router.post(
    "/plant-frame-mistake", summary="Joint axes in, frames with a mistake out", responses=problems(503)
)
async def plant_frame_mistake(
    body: Annotated[wire.PlantFrameMistakeRequest, body_with(_IN_FRAMES)], request: ApiRequest
) -> wire.PlantFrameMistakeAnswer:
    """Return the frames by the procedure of the lecture, one of which breaks one rule of the convention.

    The seed decides which frame it is and what is wrong with it.
    """
    work = partial(_planted_in_frames, body, language_of(request))
    return await request.resources.grading.run(work)


@router.post(
    "/compare-tables", summary="Do two tables describe the same robot, and why?", responses=problems(503)
)
async def compare_tables(
    body: Annotated[wire.CompareTablesRequest, body_with(_COMPARE)], request: ApiRequest
) -> wire.CompareTablesAnswer:
    """Return whether they are one robot, whichever way frames, zeros, directions and conventions were chosen.

    Nothing is fixed but the joints: frame 0 and the last frame may lie anywhere. For the certificate and for
    policies see `/grade`.
    """
    work = partial(_compared, body, request.settings.cell_limits, language_of(request))
    return await request.resources.grading.run(work)


@router.post("/other-tables", summary="Other tables of the same robot", responses=problems(503))
async def write_other_tables(
    body: Annotated[wire.OtherTablesRequest, body_with(_OTHERS)], request: ApiRequest
) -> wire.OtherTablesAnswer:
    """Return tables of a given one's robot that keep a policy, with what differs in their frames.

    Each was judged against the given table by the checker before it was sent.
    """
    work = partial(_others, body, request.settings.cell_limits)
    return await request.resources.grading.run(work)


def _planted_in_table(
    body: wire.PlantMistakeRequest, limits: Limits, language: str
) -> wire.PlantMistakeAnswer:
    with located("table"):
        read = read_table(body.table.raw(), limits)
    policy = body.policy.policy()
    ways: dict[str, list[Planted]] = {
        code: found
        for code in dict.fromkeys(body.mistakes)
        if (found := plantable(read, code, policy, body.parameters))
    }
    code, chosen = _chosen_mistake("plant-mistake", body.seed, ways, "mistakes")
    return wire.PlantMistakeAnswer(
        table=_sent(chosen.table, read),
        mistake=code,
        label=option_name(code, language),
        row=chosen.row + 1,
        mended=_sent(read, read),
    )


def _planted_in_matrix(
    body: wire.PlantMatrixMistakeRequest, limits: Limits, language: str
) -> wire.PlantMatrixMistakeAnswer:
    with located("table"):
        read = read_table(body.table.raw(), limits)
    ways: dict[str, tuple[PlantedMatrix, ...]] = {
        code: found
        for code in MATRIX_MISTAKES[body.matrix]
        if (found := plantable_in(read.table, body.matrix, code))
    }
    code, chosen = _chosen_mistake("plant-matrix-mistake", body.seed, ways, "table")
    return wire.PlantMatrixMistakeAnswer(
        row=None if chosen.link is None else chosen.link + 1,
        mistake=code,
        label=option_name(code, language),
        matrix=_written(chosen.shown, read),
        wrong_cells=[wire.WrongCell(row=r + 1, column=c + 1) for r, c in sorted(chosen.wrong_cells)],
        mended=_written(chosen.right, read),
    )


def _written(matrix: Matrix, read: ReadTable) -> list[list[str]]:
    cells = write_matrix(matrix, read.table.n_joints, tuple(read.parameters))
    return [[str(cell) for cell in row] for row in cells]


def _planted_in_frames(body: wire.PlantFrameMistakeRequest, language: str) -> wire.PlantFrameMistakeAnswer:
    axes = [axis.axis() for axis in body.axes]
    assigned = assign_frames(axes, body.convention)
    frames = [right_handed(frame.origin, frame.x, frame.z) for frame in assigned.frames]
    ways = plantable_in_frames(axes, body.convention, frames)
    code, chosen = _chosen_mistake("plant-frame-mistake", body.seed, ways, "axes")
    return wire.PlantFrameMistakeAnswer(
        frame=chosen.index,
        mistake=code,
        label=option_name(code, language),
        frames=[FigureFrame.from_record(frame) for frame in chosen.shown],
        mended=FigureFrame.from_record(chosen.right),
    )


def _chosen_mistake(
    call: str, seed: str | None, ways: Mapping[str, Sequence[Way]], field: str
) -> tuple[str, Way]:
    """Return a mistake and the place where it is planted, the same for the same seed for ever.

    Args:
        call: what asks for it; a seed plants something else for every call.
        seed: names a student or a try.
        ways: by code of a mistake where it can be planted.
        field: of the request, where nothing can be planted.

    Raises:
        RequestError: the seed is too long.
        TableError: there is no way.
    """
    try:
        picker = Picker(exercise_id=call, seed=seed_text(seed))
    except ExerciseError as error:
        raise RequestError(error.faults) from None
    if not ways:
        raise TableError(Fault.at("not_plantable", field))
    code = picker.choice(tuple(ways), "mistake")
    return code, picker.choice(ways[code], "place")


def _others(body: wire.OtherTablesRequest, limits: Limits) -> wire.OtherTablesAnswer:
    with located("table"):
        read = read_table(body.table.raw(), limits)
    with np.errstate(all="ignore"):
        found = other_tables(read, body.policy.policy(), body.parameters, body.count)
    return wire.OtherTablesAnswer(
        tables=[
            wire.ComparedTable(table=_sent(other.table, read), reasons=sorted(other.reasons))
            for other in found
        ]
    )


def _sent(table: ReadTable, asked: ReadTable) -> Table:
    """Return a table in the units of the one that was asked about."""
    writer = TableWriter(angle_unit=asked.angle_unit, length_unit=asked.length_unit)
    return Table.model_validate(writer.table(table.table), strict=False)


def _compared(body: wire.CompareTablesRequest, limits: Limits, language: str) -> wire.CompareTablesAnswer:
    with located("first"):
        first = read_table(body.first.raw(), limits)
    with located("second"):
        second = read_table(body.second.raw(), limits)
    with np.errstate(all="ignore"):
        verdict = grade(first, second, Policy(tool=ToolRule.FREE), body.parameters)
    return wire.CompareTablesAnswer(
        same=verdict.correct,
        reasons=sorted(true_reasons(verdict)),
        feedback=spoken(verdict.feedback, language),
    )
