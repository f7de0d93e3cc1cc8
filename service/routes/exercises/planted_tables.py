"""Mistakes planted in tables, and tables compared."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Any

import numpy as np

from exercises.alternatives import other_tables
from exercises.grading import Policy, ToolRule, grade
from exercises.parts.mistakes.compare_tables import true_reasons
from exercises.parts.mistakes.planting import Planted, plantable
from kinematics.cells import Limits, ReadTable, read_table
from service.http.languages import language_of
from service.http.openapi import body_with, problems
from service.http.problems import located
from service.http.routing import ApiRequest, api_router
from service.schemas.exercises.planting import (
    ComparedTable,
    CompareTablesAnswer,
    CompareTablesRequest,
    OtherTablesAnswer,
    OtherTablesRequest,
    PlantMistakeAnswer,
    PlantMistakeRequest,
)
from service.schemas.spoken import option_name, spoken
from service.schemas.tables import Table
from service.wire.exercises.planted_choice import chosen_mistake
from service.wire.kinematics.written_tables import TableWriter

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
_PLANT = {"an elbow arm": {"table": _ELBOW, "seed": "ana"}}
_OTHERS = {"an elbow arm, in its own convention": {"table": _ELBOW, "policy": {"convention": "standard"}}}
_COMPARE = {"the axes of joints 2 and 3 reversed": {"first": _ELBOW, "second": _REVERSED}}


@router.post(
    "/plant-mistake",
    summary="A right table in, a table with one mistake out",
    responses=problems(400, 413, 415, 422, 503),
)
async def plant_mistake(
    body: Annotated[PlantMistakeRequest, body_with(_PLANT)],
    request: ApiRequest,
) -> PlantMistakeAnswer:
    """Plant a mistake of the catalogue, in one row, that makes the table another robot or breaks its policy.

    What the frames leave free is no mistake and is never planted. The seed decides which one it is.
    """
    work = partial(_planted, body, request.settings.cell_limits, language_of(request))
    return await request.resources.grading.run(work)


@router.post(
    "/compare-tables",
    summary="Do two tables describe the same robot, and why?",
    responses=problems(400, 413, 415, 422, 503),
)
async def compare_tables(
    body: Annotated[CompareTablesRequest, body_with(_COMPARE)],
    request: ApiRequest,
) -> CompareTablesAnswer:
    """Return whether they are one robot, whichever way frames, zeros, directions and conventions were chosen.

    Nothing is fixed but the joints: frame 0 and the last frame may lie anywhere. For the certificate and for
    policies see `/grade`.
    """
    work = partial(_compared, body, request.settings.cell_limits, language_of(request))
    return await request.resources.grading.run(work)


@router.post(
    "/other-tables",
    summary="Other tables of the same robot",
    responses=problems(400, 413, 415, 422, 503),
)
async def write_other_tables(
    body: Annotated[OtherTablesRequest, body_with(_OTHERS)],
    request: ApiRequest,
) -> OtherTablesAnswer:
    """Return tables of a given one's robot that keep a policy, with what differs in their frames.

    Each was judged against the given table by the checker before it was sent.
    """
    work = partial(_others, body, request.settings.cell_limits)
    return await request.resources.grading.run(work)


def _planted(body: PlantMistakeRequest, limits: Limits, language: str) -> PlantMistakeAnswer:
    with located("table"):
        read = read_table(body.table.raw(), limits)
    policy = body.policy.policy()
    ways: dict[str, list[Planted]] = {
        code: found
        for code in dict.fromkeys(body.mistakes)
        if (found := plantable(read, code, policy, body.parameters))
    }
    code, chosen = chosen_mistake("plant-mistake", body.seed, ways, "mistakes")
    return PlantMistakeAnswer(
        table=_sent(chosen.table, read),
        mistake=code,
        label=option_name(code, language),
        row=chosen.row + 1,
        mended=_sent(read, read),
    )


def _others(body: OtherTablesRequest, limits: Limits) -> OtherTablesAnswer:
    with located("table"):
        read = read_table(body.table.raw(), limits)
    with np.errstate(all="ignore"):
        found = other_tables(read, body.policy.policy(), body.parameters, body.count)
    return OtherTablesAnswer(
        tables=[
            ComparedTable(table=_sent(other.table, read), reasons=sorted(other.reasons)) for other in found
        ]
    )


def _sent(table: ReadTable, asked: ReadTable) -> Table:
    """Return a table in the units of the one that was asked about."""
    writer = TableWriter(angle_unit=asked.angle_unit, length_unit=asked.length_unit)
    return Table.model_validate(writer.table(table.table), strict=False)


def _compared(body: CompareTablesRequest, limits: Limits, language: str) -> CompareTablesAnswer:
    with located("first"):
        first = read_table(body.first.raw(), limits)
    with located("second"):
        second = read_table(body.second.raw(), limits)
    with np.errstate(all="ignore"):
        verdict = grade(first, second, Policy(tool=ToolRule.FREE), body.parameters)
    return CompareTablesAnswer(
        same=verdict.correct,
        reasons=sorted(true_reasons(verdict)),
        feedback=spoken(verdict.feedback, language),
    )
