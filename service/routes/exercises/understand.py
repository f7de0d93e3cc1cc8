"""What is made of a table while it is being typed: cell by cell, also beside cells that cannot be read."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache, partial
from typing import Any

from fastapi import Response

from exercises.access import Tool
from exercises.definition import Exercise
from exercises.errors import UnknownExerciseError
from exercises.library import Library
from exercises.names import table_faults
from exercises.parts.cells.matrix_cells import read_entries
from kinematics.cells import (
    AngleUnit,
    Limits,
    RawTable,
    ReadTable,
    canonical_name,
    parameter_values,
    read_table,
)
from kinematics.dh import link_transform
from kinematics.errors import CellError, Fault, ParameterError, TableError
from kinematics.expressions import Expression, JointVariable, add, evaluate, multiply, number, parameters_in
from kinematics.printing.latex import LatexWriter
from kinematics.printing.mathml import MathmlWriter
from kinematics.printing.notation import Names
from kinematics.printing.text import TextWriter
from kinematics.table import CELLS, VARIABLE_CELLS, DHRow, JointType, SymbolicRow
from service.http.languages import language_for
from service.http.link_guard import switched_off
from service.http.problems import RequestError
from service.http.routing import ApiRequest, OneRobotRoute, api_router
from service.schemas.exercises.understanding import (
    Meaning,
    UnderstandAnswer,
    UnderstandRequest,
    UnderstoodParameter,
    UnderstoodRow,
)
from service.settings import Settings
from service.wire.fault_pointers import fault_entries

router = api_router("kinematics", route_class=OneRobotRoute)


Place = tuple[int, str]
MATHML = "http://www.w3.org/1998/Math/MathML"
WRITTEN = 512  # Entries that are kept as written, each as long as a cell may be.


@router.post("/understand", summary="What a table means, cell by cell, while it is being typed")
async def understand(body: UnderstandRequest, request: ApiRequest, response: Response) -> UnderstandAnswer:
    """Return the meaning of every readable cell, the link matrix of every row with numbers, and the faults.

    Unlike the other calls, this one does not refuse a table with faults, but reads the rest of it. With
    the id of an `exercise`, names that the exercise does not know are among the faults.
    """
    language = language_for(request.headers.get("accept-language"))
    response.headers["Content-Language"] = language
    response.headers["Vary"] = "Accept-Language"
    hidden = switched_off(request, Tool.MATRICES, request.resources.exercises)
    exercise = None if body.exercise is None else _exercise(body.exercise, request.resources.exercises)
    work = partial(_understood, body, exercise, request.settings, language, links=not hidden)
    return await request.in_turn(work)


def _exercise(name: str, library: Library) -> Exercise:
    try:
        return library.exercise(name)
    except UnknownExerciseError as error:
        raise RequestError(replace(fault, where=("exercise",)) for fault in error.faults) from error


def _understood(
    body: UnderstandRequest, exercise: Exercise | None, settings: Settings, language: str, *, links: bool
) -> UnderstandAnswer:
    read, faults, unread = _read_what_can_be(body.table.raw(), settings.cell_limits)
    if read and exercise:
        faults += tuple(table_faults(read, exercise))
    values = _known_values(read, body.parameters) if read else {}
    matrices, of_matrices = _matrices(body, read)
    return UnderstandAnswer(
        readable=not faults,
        rows=_rows(read, unread, values, links=links) if read else [],
        parameters=[UnderstoodParameter(name=name, kind=kind) for name, kind in read.parameters.items()]
        if read
        else [],
        matrices=matrices,
        faults=fault_entries(
            (*(fault.within("table") for fault in faults), *of_matrices), language, settings.fault_limit
        ),
    )


def _matrices(
    body: UnderstandRequest, read: ReadTable | None
) -> tuple[list[list[list[Meaning | None]]], list[Fault]]:
    """What the cells of matrices mean in the joint variables of the table, and what is wrong with them."""
    types, variables = (read.table.joint_types, read.variables) if read else ((), ())
    unit = AngleUnit(body.table.angle_unit)
    found: list[list[list[Meaning | None]]] = []
    faults: list[Fault] = []
    for i, cells in enumerate(body.matrices):
        entries = read_entries(cells, types, unit, ("matrices", i))
        rows: list[list[Meaning | None]] = []
        for texts, row in zip(cells, entries, strict=True):
            typed = [bool(text.strip()) for text in texts]
            faults += [
                entry for entry, here in zip(row, typed, strict=True) if here and isinstance(entry, Fault)
            ]
            rows.append(
                [None if isinstance(entry, Fault) else _meaning(entry.expression, variables) for entry in row]
            )
        found.append(rows)
    return found, faults


def _meaning(entry: Expression, variables: Sequence[str]) -> Meaning:
    names = Names(parameters=frozenset(parameters_in(entry)), variables=tuple(variables))
    return _told(entry, names, _value(entry, {}, len(variables)))


def _told(entry: Expression, names: Names, value: float | None) -> Meaning:
    mathml, latex, text = _written(entry, names)
    return Meaning(mathml=mathml, latex=latex, text=text, value=value)


@lru_cache(maxsize=WRITTEN)
def _written(entry: Expression, names: Names) -> tuple[str, str, str]:
    """An entry as a math element, in LaTeX and as a cell takes it; a class types the same few."""
    mathml = f'<math xmlns="{MATHML}">{MathmlWriter(names).text(entry)}</math>'
    return mathml, LatexWriter(names).text(entry), TextWriter(Names()).text(entry)


def _read_what_can_be(
    raw: RawTable, limits: Limits
) -> tuple[ReadTable | None, tuple[Fault, ...], frozenset[Place]]:
    """The table with 0 for every cell that cannot be read; the faults; the places of those cells."""
    faults: tuple[Fault, ...] = ()
    unread: frozenset[Place] = frozenset()
    while True:
        try:
            return read_table(raw, limits), faults, unread
        except (CellError, TableError) as error:
            new = frozenset(_places(error.faults)) - unread
            faults = faults or error.faults
            if not new:
                return None, faults, unread
            unread |= new
            raw = _without(raw, new)


def _places(faults: Iterable[Fault]) -> Iterable[Place]:
    for fault in faults:
        match fault.where:
            case ("rows", int(row), str(cell), *_) if cell in CELLS:
                yield row, cell


def _without(raw: RawTable, places: frozenset[Place]) -> RawTable:
    rows = list(raw.rows)
    for i, cell in places:
        nothing: dict[str, Any] = {cell: 0}
        rows[i] = replace(rows[i], **nothing)
    return RawTable(
        convention=raw.convention, rows=tuple(rows), angle_unit=raw.angle_unit, length_unit=raw.length_unit
    )


def _known_values(read: ReadTable, given: Mapping[str, float]) -> dict[str, float]:
    """Values of those of the table's parameters that have one, by canonical name, angles in [rad]."""
    named = {canonical_name(name): value for name, value in given.items()}
    kinds = {name: kind for name, kind in read.parameters.items() if name in named}
    return parameter_values(kinds, read.angle_unit, {name: named[name] for name in kinds})


def _rows(
    read: ReadTable, unread: frozenset[Place], values: Mapping[str, float], *, links: bool
) -> list[UnderstoodRow]:
    names = Names(parameters=frozenset(read.parameters), variables=tuple(read.variables))
    rows = []
    joint = 0
    for i, row in enumerate(read.table.rows):
        joint += row.joint is not JointType.FIXED
        cells = {cell: _entry(row, cell, joint) for cell in CELLS if (i, cell) not in unread}
        meanings = {
            cell: _told(entry, names, _value(getattr(row, cell), values)) for cell, entry in cells.items()
        }
        variable = None if row.joint is JointType.FIXED else f"q{joint}"
        numbers = {cell: meaning.value for cell, meaning in meanings.items()}
        link = _link(read, row, numbers) if links else None
        rows.append(UnderstoodRow(joint=row.joint, sign=row.sign, variable=variable, link=link, **meanings))
    return rows


def _value(entry: Expression, values: Mapping[str, float], joints: int = 0) -> float | None:
    """The number of a cell with its joint variables at zero.

    None where a parameter has no value, or the number does not exist.
    """
    try:
        return evaluate(entry, values, (0.0,) * joints)
    except ParameterError:
        return None


def _link(read: ReadTable, row: SymbolicRow, cells: Mapping[str, float | None]) -> list[list[float]] | None:
    """The row's link matrix with its joint at zero, if every cell has a number."""
    numbers = {cell: value for cell, value in cells.items() if value is not None}
    if len(numbers) < len(CELLS):
        return None
    matrix = link_transform(DHRow(joint=row.joint, sign=row.sign, **numbers), read.table.convention)
    return matrix.tolist()  # type: ignore[no-any-return]


def _entry(row: SymbolicRow, cell: str, joint: int) -> Expression:
    """A cell as it stands in the table: offset and joint variable together."""
    offset: Expression = getattr(row, cell)
    if cell != VARIABLE_CELLS.get(row.joint):
        return offset
    return add((multiply((number(row.sign), JointVariable(joint))), offset))
