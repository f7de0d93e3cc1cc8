"""POST /plant-mistake, /plant-matrix-mistake and /plant-frame-mistake: what is right in, one mistake out."""

from collections.abc import Mapping, Sequence
from typing import Annotated, Literal, TypeVar

from pydantic import Field

from exercises.draws import Picker
from exercises.errors import ExerciseError
from exercises.instance import seed_text
from exercises.parts.cells.matrix_cells import write_matrix
from exercises.parts.mistakes.planted_matrices import MATRIX_MISTAKES, MatrixKind, PlantedMatrix, plantable_in
from exercises.parts.mistakes.planting import PLANTABLE, Planted, plantable
from kinematics.cells import Limits, ReadTable
from kinematics.errors import Fault, TableError
from kinematics.frames.assignment import assign_frames
from kinematics.frames.wrong_frames import plantable_in_frames, right_handed
from kinematics.symbolic import Matrix
from kinematics.table import Convention
from service.http.calls import CallRouter
from service.http.problems import RequestError
from service.schemas.base import OneOf, Wire
from service.schemas.exercises.exercises import FigureFrame, Seed
from service.schemas.exercises.verdicts import PolicyModel
from service.schemas.kinematics.joint_axes import AxisModel
from service.schemas.spoken import option_name
from service.schemas.tables import Parameters, Table
from service.wire.kinematics.written_tables import table_in_units_of

Way = TypeVar("Way")
router = CallRouter("exercises")

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


@router.judge("/plant-mistake", "A right table in, a table with one mistake out")
def plant_mistake(body: PlantMistakeRequest, limits: Limits, language: str) -> PlantMistakeAnswer:
    """Plant a mistake of the catalogue, in one row, that makes the table another robot or breaks its policy.

    What the frames leave free is no mistake and is never planted. The seed decides which one it is.
    """
    read = body.table.read(limits, "table")
    policy = body.policy.policy()
    ways: dict[str, list[Planted]] = {
        code: found
        for code in dict.fromkeys(body.mistakes)
        if (found := plantable(read, code, policy, body.parameters))
    }
    code, chosen = _chosen_mistake("plant-mistake", body.seed, ways, "mistakes")
    return PlantMistakeAnswer(
        table=table_in_units_of(read, chosen.table.table),
        mistake=code,
        label=option_name(code, language),
        row=chosen.row + 1,
        mended=table_in_units_of(read, read.table),
    )


@router.judge("/plant-matrix-mistake", "A right table in, one of its matrices with a mistake out")
def plant_matrix_mistake(
    body: PlantMatrixMistakeRequest, limits: Limits, language: str
) -> PlantMatrixMistakeAnswer:
    """Plant a mistake of the catalogue, in the matrix of one row or in ⁰T_N, that makes it another function.

    The seed decides which one it is and where.
    """
    read = body.table.read(limits, "table")
    ways: dict[str, tuple[PlantedMatrix, ...]] = {
        code: found
        for code in MATRIX_MISTAKES[body.matrix]
        if (found := plantable_in(read.table, body.matrix, code))
    }
    code, chosen = _chosen_mistake("plant-matrix-mistake", body.seed, ways, "table")
    return PlantMatrixMistakeAnswer(
        row=None if chosen.link is None else chosen.link + 1,
        mistake=code,
        label=option_name(code, language),
        matrix=_written(chosen.shown, read),
        wrong_cells=[WrongCell(row=r + 1, column=c + 1) for r, c in sorted(chosen.wrong_cells)],
        mended=_written(chosen.right, read),
    )


@router.judge("/plant-frame-mistake", "Joint axes in, frames with a mistake out")
def plant_frame_mistake(body: PlantFrameMistakeRequest, language: str) -> PlantFrameMistakeAnswer:
    """Return the frames by the procedure of the lecture, one of which breaks one rule of the convention.

    The seed decides which frame it is and what is wrong with it.
    """
    axes = [axis.axis() for axis in body.axes]
    assigned = assign_frames(axes, body.convention)
    frames = [right_handed(frame.origin, frame.x, frame.z) for frame in assigned.frames]
    ways = plantable_in_frames(axes, body.convention, frames)
    code, chosen = _chosen_mistake("plant-frame-mistake", body.seed, ways, "axes")
    return PlantFrameMistakeAnswer(
        frame=chosen.index,
        mistake=code,
        label=option_name(code, language),
        frames=[FigureFrame.from_record(frame) for frame in chosen.shown],
        mended=FigureFrame.from_record(chosen.right),
    )


def _written(matrix: Matrix, read: ReadTable) -> list[list[str]]:
    cells = write_matrix(matrix, read.table.n_joints, tuple(read.parameters))
    return [[str(cell) for cell in row] for row in cells]


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
