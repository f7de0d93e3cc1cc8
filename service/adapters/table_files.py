"""DH tables in files that courses use: JSON, CSV, TSV and spreadsheets, as answers to be graded."""

import codecs
import csv
import io
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import PurePosixPath
from typing import Any, TypeAlias
from unicodedata import normalize

from kinematics.errors import Fault
from kinematics.table import ANGLES, CELLS
from service.adapters.workbooks import UnreadableError, sheets_of
from service.http.decoding import JsonLimits, decode_json
from service.http.problems import RequestError, ServiceError

Grid: TypeAlias = Sequence[Sequence[object]]

WORKBOOKS = (".xlsx", ".xls", ".ods")
SUFFIXES = (".json", ".csv", ".tsv", ".txt", *WORKBOOKS)
LARGEST_FILE = 8 * 1024 * 1024  # Bytes of a file: as many rows as are read, with 80 characters each.
MOST_LEVELS = 8
"""Levels of a JSON file: lists of students, of robots, of tables, and some that mean nothing here."""
MOST_ROWS = 100_000  # Rows of a file: a table of six rows for each of 15 000 students.
_MOST_CELLS = 16 * MOST_ROWS
"""Cells of the rectangle about those of a sheet that hold something: its reader makes all of them."""
_JSON_LIMITS = JsonLimits(
    objects=MOST_ROWS, lists=MOST_ROWS, values=8 * MOST_ROWS, fields=MOST_ROWS, colons=8 * MOST_ROWS
)
"""As many rows as other files may have, each an object of eight values at most."""

_COLUMNS = {
    "theta": "theta θ th thetai θi jointangle thetaoffset θoffset thêta teta тета",
    "d": "d di linkoffset offset",
    "a": "a ai r ri linklength ai-1 a(i-1)",
    "alpha": "alpha α alphai αi linktwist twist alphai-1 αi-1 alpha(i-1) α(i-1) alfa альфа",
    "joint": "joint type jointtype sigma σ",
    "student": "student studentid user username userid login email name id",
    "exercise": "exercise robot task",
    "convention": "convention",
    "link": "link row i linki # frame no nr",
}
_MEANING = {spelling: column for column, spellings in _COLUMNS.items() for spelling in spellings.split()}
_JOINT_TYPES = {
    "r": "revolute", "revolute": "revolute", "rotational": "revolute", "0": "revolute",
    "p": "prismatic", "prismatic": "prismatic", "1": "prismatic", "t": "prismatic", "linear": "prismatic",
    "f": "fixed", "fixed": "fixed",
}  # fmt: skip
_HEADER_WITHIN = 50  # Lines in which the names of the columns are looked for, to tell what separates them.
_UNIT_IN_HEADER = re.compile(r"[\[(]\s*(deg|degrees|°|rad|radians|m|cm|mm|in)\s*[\])]")
_UNITS = {"°": "deg", "degrees": "deg", "radians": "rad"}


@dataclass(frozen=True, kw_only=True, slots=True)
class TableSettings:
    """What a file leaves open.

    Attributes:
        angle_unit: rad or deg.
        length_unit: m, cm, mm or in.
    """

    convention: str = "standard"
    angle_unit: str = "rad"
    length_unit: str = "m"


@dataclass(frozen=True, kw_only=True, slots=True)
class FoundTable:
    """A table that stands in a file.

    Attributes:
        student: who handed it in, where the file says so.
        exercise: the exercise or robot, where the file says so.
        table: the table as POST /exercises/{id}/grade takes it.
    """

    student: str | None
    exercise: str | None
    table: Mapping[str, Any]


def read_tables(name: str, content: bytes, settings: TableSettings) -> tuple[FoundTable, ...]:
    """Return every table of a file.

    Raises:
        RequestError: the file is too large, cannot be read, or holds no table.
    """
    if len(content) > LARGEST_FILE:
        raise _refused("file_too_large", name, limit=LARGEST_FILE)
    suffix = PurePosixPath(name).suffix.lower()
    if suffix == ".json":
        found = tuple(_json_tables(name, _json(name, content), settings))
    elif suffix in WORKBOOKS:
        found = tuple(_workbook_tables(name, content, settings))
    elif suffix in SUFFIXES:
        found = tuple(_grid_tables(name, _delimited(name, content), settings))
    else:
        raise _refused("file_type_unknown", name, known=SUFFIXES)
    if not found:
        raise _refused("file_without_table", name)
    return found


def _json(name: str, content: bytes) -> object:
    try:
        return decode_json(content, _JSON_LIMITS)
    except ServiceError as error:
        raise RequestError(fault.within(name) for fault in error.faults) from None


def _json_tables(
    name: str,
    document: object,
    settings: TableSettings,
    student: str | None = None,
    exercise: str | None = None,
    depth: int = 0,
) -> Iterator[FoundTable]:
    """Walk what JSON files of courses are: a table, columns by name, tables by robot, or a list of them."""
    if depth > MOST_LEVELS:
        return
    if isinstance(document, list):
        for entry in document[:MOST_ROWS]:
            if isinstance(entry, Mapping):
                yield from _json_tables(name, entry, settings, student, exercise, depth + 1)
        return
    if not isinstance(document, Mapping):
        return
    student = _text(document.get("student")) or student
    exercise = _text(document.get("exercise")) or exercise
    if isinstance(document.get("table"), Mapping):
        yield from _json_tables(name, document["table"], settings, student, exercise, depth + 1)
    elif isinstance(document.get("rows"), list):
        yield FoundTable(student=student, exercise=exercise, table=_json_table(document, settings))
    elif columns := _json_columns(document):
        rows = _rows_of_columns(name, columns, document.get("joint_types"))
        table = {**_head(settings, document), "rows": rows}
        yield FoundTable(student=student, exercise=exercise, table=table)
    else:
        for key, entry in document.items():
            if isinstance(entry, Mapping | list):
                yield from _json_tables(name, entry, settings, student, exercise or str(key), depth + 1)


def _json_table(document: Mapping[str, Any], settings: TableSettings) -> dict[str, Any]:
    known = {key: value for key, value in document.items() if key not in ("student", "exercise")}
    return {**_head(settings, {}), **known}


def _json_columns(document: Mapping[str, Any]) -> dict[str, list[object]]:
    """The columns of a table that is written by columns; none if one of the four is missing."""
    columns = {
        column: values
        for key, values in document.items()
        if isinstance(values, list) and (column := _column(str(key))) in CELLS
    }
    return columns if len(columns) == len(CELLS) else {}


def _rows_of_columns(
    name: str, columns: Mapping[str, list[object]], types: object
) -> list[dict[str, object]]:
    lengths = {len(values) for values in columns.values()}
    if len(lengths) > 1:
        raise _refused("columns_differ_in_length", name)
    rows = [dict(zip(columns, cells, strict=True)) for cells in zip(*columns.values(), strict=True)]
    if isinstance(types, list):
        for row, kind in zip(rows, types, strict=False):
            if joint := _JOINT_TYPES.get(str(kind).strip().lower()):
                row["joint"] = joint
    return rows


def _workbook_tables(name: str, content: bytes, settings: TableSettings) -> Iterator[FoundTable]:
    try:
        sheets = sheets_of(content, MOST_ROWS, _MOST_CELLS)
    except UnreadableError as error:
        raise _refused("file_unreadable", name, reason=str(error)) from None
    for title, grid in sheets:
        if any(any(cell not in ("", None) for cell in row) for row in grid):
            for found in _grid_tables(name, grid, settings):
                exercise = found.exercise or (title if len(sheets) > 1 else None)
                yield FoundTable(student=found.student, exercise=exercise, table=found.table)


def _decoded(name: str, content: bytes) -> str:
    """The text of a file: UTF-8, UTF-16 as Excel's "Unicode text" is, or Windows' Western one."""
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        try:
            return content.decode("utf-16")
        except UnicodeDecodeError:
            raise _refused("file_unreadable", name, reason="UTF-16") from None
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("cp1252", errors="replace")


def _delimited(name: str, content: bytes) -> Grid:
    text = _decoded(name, content)
    lines = [line for line in text.splitlines() if line.strip()]
    if "\0" in text or not lines:
        raise _refused("file_unreadable", name, reason="empty" if not lines else "binary")
    headers = ((mark, line) for line in lines[:_HEADER_WITHIN] for mark in "\t;,|")
    delimiter = next((mark for mark, line in headers if _is_header(line.split(mark))), ",")
    csv.field_size_limit(LARGEST_FILE)
    rows = csv.reader(io.StringIO(text, newline=None), delimiter=delimiter)
    try:
        return [row for row, _ in zip(rows, range(MOST_ROWS), strict=False)]
    except csv.Error:
        raise _refused("file_unreadable", name, reason="columns") from None


def _grid_tables(name: str, grid: Grid, settings: TableSettings) -> Iterator[FoundTable]:
    """Yield the tables below a header row: one for each student and exercise."""
    rows = [[_cell(cell) for cell in row] for row in grid]
    rows = [row for row in rows if any(cell != "" for cell in row)]
    start = next((i for i, row in enumerate(rows) if _is_header(row)), None)
    if start is None:
        raise _refused("columns_unknown", name, known=CELLS)
    header = [str(cell) for cell in rows[start]]
    columns = [_column(title) for title in header]
    head = _head_of(settings, header)
    groups: dict[tuple[str, str], list[dict[str, object]]] = {}
    conventions: dict[tuple[str, str], str] = {}
    for row in rows[start + 1 :]:
        cells = {column: cell for column, cell in zip(columns, row, strict=False) if column}
        key = (str(cells.get("student", "")), str(cells.get("exercise", "")))
        groups.setdefault(key, []).append(_row(cells))
        if convention := str(cells.get("convention", "")).strip().lower():
            conventions[key] = convention
    for (student, exercise), table_rows in groups.items():
        convention = conventions.get((student, exercise), head["convention"])
        table = {**head, "convention": convention, "rows": table_rows}
        yield FoundTable(student=student or None, exercise=exercise or None, table=table)


def _is_header(row: Sequence[object]) -> bool:
    return set(CELLS) <= {_column(str(cell)) for cell in row}


def _row(cells: Mapping[str, object]) -> dict[str, object]:
    row = {name: cells.get(name, "") for name in CELLS}
    joint = _JOINT_TYPES.get(str(cells.get("joint", "")).strip().lower())
    return {**row, "joint": joint} if joint else row


def _cell(value: object) -> object:
    """A cell as the grammar reads it; a decimal comma becomes a point."""
    if value is None:
        return ""
    if isinstance(value, bool | int | float):
        return value
    return re.sub(r"(?<=\d),(?=\d)", ".", str(value).strip())


def _column(title: str) -> str:
    bare = _UNIT_IN_HEADER.sub("", _plain(title))
    return _MEANING.get(re.sub(r"[\s_{}$\\*]", "", bare), "")


def _plain(title: str) -> str:
    """A title in lower case, its indices on the line: aᵢ₋₁ as ai-1."""
    return normalize("NFKC", title.strip().lower()).replace("−", "-")


def _head(settings: TableSettings, document: Mapping[str, Any]) -> dict[str, str]:
    names = ("convention", "angle_unit", "length_unit")
    return {name: str(document.get(name) or getattr(settings, name)) for name in names}


def _head_of(settings: TableSettings, header: Sequence[str]) -> dict[str, str]:
    """Convention and units as the header's titles name them: a_{i-1}, alpha (deg), d [mm]."""
    head = _head(settings, {})
    for title in header:
        found = _UNIT_IN_HEADER.search(_plain(title))
        column = _column(title)
        if found:
            unit = _UNITS.get(found[1], found[1])
            head["angle_unit" if column in ANGLES else "length_unit"] = unit
        if column in ("a", "alpha") and re.search(r"i\s*-\s*1", _plain(title)):
            head["convention"] = "modified"
    return head


def _text(value: object) -> str | None:
    return str(value) if isinstance(value, str | int) and not isinstance(value, bool) else None


def _refused(code: str, name: str, **params: Any) -> RequestError:
    return RequestError(Fault.at(code, name, file=PurePosixPath(name).name, **params))
