"""DH tables in files that courses use: JSON, CSV, TSV and spreadsheets, as answers to be graded."""

import codecs
import csv
import io
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import date, time, timedelta
from pathlib import PurePosixPath
from typing import Any, TypeAlias
from unicodedata import normalize

from kinematics.errors import Fault
from kinematics.table import CELLS
from service.adapters.column_titles import column_of, is_header, repeated_titles, told_by
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

_JOINT_TYPES = {
    "r": "revolute", "revolute": "revolute", "rotational": "revolute", "0": "revolute",
    "p": "prismatic", "prismatic": "prismatic", "1": "prismatic", "t": "prismatic", "linear": "prismatic",
    "f": "fixed", "fixed": "fixed",
}  # fmt: skip
_HEADER_WITHIN = 50  # Lines in which the names of the columns are looked for, to tell what separates them.
_RULE = re.compile(":?-{3,}:?")  # What stands below each title of a table in Markdown.
_TWO_ARGUMENTS = "atan2("  # Behind it a comma between digits is no decimal one.


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
    elif columns := _json_columns(name, document):
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


def _json_columns(name: str, document: Mapping[str, Any]) -> dict[str, list[object]]:
    """The columns of a table that is written by columns; none if one of the four is missing."""
    lists = {str(key): values for key, values in document.items() if isinstance(values, list)}
    if not is_header(tuple(lists)):
        return {}
    _refuse_repeated(name, tuple(lists))
    return {column: values for key, values in lists.items() if (column := column_of(key)) in CELLS}


def _refuse_repeated(name: str, titles: Sequence[str]) -> None:
    if repeated := repeated_titles(titles):
        raise _refused("columns_repeated", name, titles=tuple(repeated))


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
    widths = [_width(grid) for _, grid in sheets]
    least = min(max(widths, default=0), len(CELLS))  # a narrower sheet holds notes beside a table
    for (title, grid), width in zip(sheets, widths, strict=True):
        if width and width >= least:
            for found in _grid_tables(name, grid, settings):
                exercise = found.exercise or (title if len(sheets) > 1 else None)
                yield FoundTable(student=found.student, exercise=exercise, table=found.table)


def _width(grid: Grid) -> int:
    """How many cells of the widest row hold something."""
    return max((sum(cell not in ("", None) for cell in row) for row in grid), default=0)


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
    csv.field_size_limit(LARGEST_FILE)
    headers = ((mark, line) for line in lines[:_HEADER_WITHIN] for mark in "\t;,|")
    delimiter = next((mark for mark, line in headers if is_header(_split(line, mark))), ",")
    rows = csv.reader(io.StringIO(text, newline=None), delimiter=delimiter)
    try:
        return [row for row, _ in zip(rows, range(MOST_ROWS), strict=False)]
    except csv.Error:
        raise _refused("file_unreadable", name, reason="columns") from None


def _split(line: str, delimiter: str) -> list[str]:
    """The cells of a line, without their quotation marks."""
    return next(csv.reader([line], delimiter=delimiter))


def _grid_tables(name: str, grid: Grid, settings: TableSettings) -> Iterator[FoundTable]:
    """Yield the tables below a header row: one for each student and exercise."""
    rows = [[_cell(cell) for cell in row] for row in grid]
    rows = [row for row in rows if any(cell != "" for cell in row)]
    start = next((i for i, row in enumerate(rows) if is_header(row)), None)
    if start is None:
        raise _refused("columns_unknown", name, known=CELLS)
    header = [str(cell) for cell in rows[start]]
    _refuse_repeated(name, header)
    columns = [column_of(title) for title in header]
    head = {**_head(settings, {}), **dict(told_by(header))}
    groups: dict[tuple[str, str], list[dict[str, object]]] = {}
    conventions: dict[tuple[str, str], str] = {}
    key = ("", "")
    below = start + 1
    if below < len(rows) and all(_RULE.fullmatch(str(cell)) for cell in rows[below] if cell != ""):
        below += 1
    for row in rows[below:]:
        cells = {column: cell for column, cell in zip(columns, row, strict=False) if column}
        key = _owner(cells, key)
        groups.setdefault(key, []).append(_row(cells))
        if convention := _name(cells.get("convention")).lower():
            conventions[key] = convention
    for (student, exercise), table_rows in groups.items():
        convention = conventions.get((student, exercise), head["convention"])
        table = {**head, "convention": convention, "rows": table_rows}
        yield FoundTable(student=student or None, exercise=exercise or None, table=table)


def _owner(cells: Mapping[str, object], above: tuple[str, str]) -> tuple[str, str]:
    """Student and exercise of a row; where a cell is empty, such as the rest of a merged one, those above."""
    student = _name(cells.get("student")) or above[0]
    return student, _name(cells.get("exercise")) or (above[1] if student == above[0] else "")


def _row(cells: Mapping[str, object]) -> dict[str, object]:
    row = {name: cells.get(name, "") for name in CELLS}
    joint = _JOINT_TYPES.get(_name(cells.get("joint")).lower())
    return {**row, "joint": joint} if joint else row


def _name(value: object) -> str:
    """A cell as a name; the numbers of a workbook all have a fraction: 12345.0."""
    if value is None:
        return ""
    whole = int(value) if isinstance(value, float) and value.is_integer() else value
    return normalize("NFC", str(whole)).strip()


def _cell(value: object) -> object:
    """A cell as the grammar reads it; a decimal comma becomes a point."""
    if value is None:
        return ""
    if isinstance(value, bool | int | float | date | time | timedelta):
        return value  # a date that a workbook made of 1/2 is refused where cells are read
    text = str(value).strip()
    return text if _TWO_ARGUMENTS in text else re.sub(r"(?<=\d),(?=\d)", ".", text)


def _head(settings: TableSettings, document: Mapping[str, Any]) -> dict[str, str]:
    names = ("convention", "angle_unit", "length_unit")
    return {name: str(document.get(name) or getattr(settings, name)) for name in names}


def _text(value: object) -> str | None:
    return str(value) if isinstance(value, str | int) and not isinstance(value, bool) else None


def _refused(code: str, name: str, **params: Any) -> RequestError:
    return RequestError(Fault.at(code, name, file=PurePosixPath(name).name, **params))
