"""DH tables in files that courses use: JSON, CSV, TSV and spreadsheets, as answers to be graded."""

import codecs
import csv
import io
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from datetime import date, time, timedelta
from itertools import islice
from pathlib import PurePosixPath
from typing import Any, TypeAlias

from kinematics.errors import Fault
from kinematics.table import CELLS
from service.adapters.class_rows import groups_of, name_in, records_of, row_of
from service.adapters.column_titles import column_of, columns_of, is_header, repeated_titles, told_by
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
        identifier: what tells the student from others of that name, where the file has a column for it, too.
        exercise: the exercise or robot, where the file says so.
        table: the table as POST /exercises/{id}/grade takes it.
    """

    student: str | None
    identifier: str | None = None
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
        for entry in document:
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
        told = _told_by(name, tuple(document))
        table = {**_head(settings, {**told, **document}), "rows": rows}
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


def _told_by(name: str, titles: Sequence[str]) -> dict[str, str]:
    """Convention and units as titles name them, the same for all angles and for all lengths."""
    told: dict[str, str] = {}
    for kind, value in told_by(titles):
        if told.setdefault(kind, value) != value:
            raise _refused("units_differ", name, units=(told[kind], value))
    return told


def _refuse_repeated(name: str, titles: Sequence[str]) -> None:
    if repeated := repeated_titles(titles):
        raise _refused("columns_repeated", name, titles=tuple(repeated))


def _rows_of_columns(
    name: str, columns: Mapping[str, list[object]], types: object
) -> list[dict[str, object]]:
    typed = {**columns, "type": types} if isinstance(types, list) else columns
    if len({len(values) for values in typed.values()}) > 1:
        raise _refused("columns_differ_in_length", name)
    return [row_of(dict(zip(typed, cells, strict=True))) for cells in zip(*typed.values(), strict=True)]


def _workbook_tables(name: str, content: bytes, settings: TableSettings) -> Iterator[FoundTable]:
    try:
        sheets = sheets_of(content, MOST_ROWS + 1, _MOST_CELLS)
    except UnreadableError as error:
        raise _refused("file_unreadable", name, reason=str(error)) from None
    widths = [_width(grid) for _, grid in sheets]
    least = min(max(widths, default=0), len(CELLS))  # a narrower sheet holds notes beside a table
    for (title, grid), width in zip(sheets, widths, strict=True):
        if width and width >= least:
            for found in _grid_tables(name, grid, settings):
                yield replace(found, exercise=found.exercise or (title if len(sheets) > 1 else None))


def _width(grid: Grid) -> int:
    """How many cells of the widest row hold something."""
    return max((sum(cell not in ("", None) for cell in row) for row in grid), default=0)


def decoded(name: str, content: bytes) -> str:
    """Return the text of a file: UTF-8, UTF-16 as Excel's "Unicode text" is, or Windows' Western one.

    Raises:
        RequestError: it begins like UTF-16, and is not.
    """
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
    text = decoded(name, content)
    lines = [line for line in text.splitlines() if line.strip()]
    if "\0" in text or not lines:
        raise _refused("file_unreadable", name, reason="empty" if not lines else "binary")
    csv.field_size_limit(LARGEST_FILE)
    headers = ((mark, line) for line in lines[:_HEADER_WITHIN] for mark in "\t;,|")
    delimiter = next((mark for mark, line in headers if is_header(_split(line, mark))), ",")
    rows = csv.reader(io.StringIO(text, newline=None), delimiter=delimiter)
    try:
        return list(islice((row for row in rows if any(row)), MOST_ROWS + 1))
    except csv.Error:
        raise _refused("file_unreadable", name, reason="columns") from None


def _split(line: str, delimiter: str) -> list[str]:
    """The cells of a line, without their quotation marks."""
    return next(csv.reader([line], delimiter=delimiter))


def _grid_tables(name: str, grid: Grid, settings: TableSettings) -> Iterator[FoundTable]:
    """Yield the tables below a header row: one for each student and exercise."""
    if len(grid) > MOST_ROWS:
        raise _refused("rows_too_many", name, limit=MOST_ROWS)
    rows = [[_cell(cell) for cell in row] for row in grid]
    rows = [row for row in rows if any(cell != "" for cell in row)]
    start = next((i for i, row in enumerate(rows) if is_header(row)), None)
    if start is None:
        raise _refused("columns_unknown", name, known=CELLS)
    header = [str(cell) for cell in rows[start]]
    _refuse_repeated(name, header)
    columns = columns_of(header)
    head = {**_head(settings, {}), **_told_by(name, header)}
    below = start + 1
    if below < len(rows) and all(_RULE.fullmatch(str(cell)) for cell in rows[below] if cell != ""):
        below += 1
    records = records_of(columns, rows[below:])
    for (student, identifier, exercise), group in groups_of(records).items():
        conventions = (name_in(cells.get("convention")).lower() for cells in group)
        convention = next(filter(None, conventions), head["convention"])
        table = {**head, "convention": convention, "rows": [row_of(cells) for cells in group]}
        yield FoundTable(
            student=student or identifier or None,
            identifier=identifier or None if student else None,
            exercise=exercise or None,
            table=table,
        )


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
