"""How far out the cells of a workbook stand, read before its sheets are made."""

import io
import re
import zipfile
import zlib
from collections.abc import Mapping
from typing import Any
from xml.etree.ElementTree import ParseError

from defusedxml import DefusedXmlException
from defusedxml.ElementTree import DefusedXMLParser

LARGEST_UNPACKED = 64 * 1024 * 1024  # Bytes of a member of a workbook: eight million cells are about as many.
_CHUNK = 1024 * 1024  # Bytes that are unpacked at once.
_PLACE = re.compile(r"([A-Za-z]{1,6})([0-9]{1,9})")  # Where a cell stands: XFD1048576 (ECMA-376-1 §18.18.7).
_NUMBER = re.compile("[0-9]{1,9}")
_COUNT = re.compile("[+]?[0-9]+")
_DIGITS = 24  # More than a number of repetitions has that any reader takes.


class ExtentError(ValueError):
    """A workbook has cells too far out, a member that is too large, or a worksheet that is no XML."""


def check_extent(content: bytes, most_cells: int) -> None:
    """Refuse a workbook whose sheets are larger than so many cells: their reader makes all of them.

    A file that is no archive, or a damaged one, is left to its reader.

    Args:
        most_cells: of the rectangle about the cells with something in them, and of those that are written.

    Raises:
        ExtentError: a sheet is larger, a member is larger than LARGEST_UNPACKED, or a worksheet is no XML.
    """
    try:
        archive = zipfile.ZipFile(io.BytesIO(content))
        for entry in archive.infolist():
            with archive.open(entry) as stream:
                _check_member(stream, entry.filename, most_cells)
    except (zipfile.BadZipFile, zlib.error, EOFError, RuntimeError, NotImplementedError):
        return


def _check_member(stream: Any, name: str, most_cells: int) -> None:
    sheet = _Worksheet(most_cells)
    parser: Any = DefusedXMLParser(target=sheet, forbid_dtd=True, forbid_entities=True, forbid_external=True)
    size, is_xml = 0, True
    while chunk := stream.read(_CHUNK):
        size += len(chunk)
        if size > LARGEST_UNPACKED:
            raise ExtentError(f"{name}: > {LARGEST_UNPACKED} bytes")
        try:
            if is_xml:
                parser.feed(chunk)
        except (ParseError, DefusedXmlException, LookupError) as error:
            if sheet.is_one:
                raise ExtentError(f"{name}: {error}") from error
            is_xml = False


class _Worksheet:
    """Follows the elements of a member, none of which is stored."""

    def __init__(self, most_cells: int) -> None:
        self.is_one = False
        self._most = most_cells
        self._written = 0
        self._rows = self._columns = 1
        self._row = self._column = self._other_tables = 0
        self._in_cell = False

    def start(self, tag: str, attributes: Mapping[str, str]) -> None:
        name = tag.rpartition("}")[2]
        if self._in_cell:
            self._fill()
        elif name == "c":
            self._written += 1
            self._in_cell = True
            self._check()
            found = _PLACE.fullmatch(attributes.get("r", ""))
            self._column = _column_number(found[1]) if found else self._column + 1
            self._row = int(found[2]) if found else self._row
        elif name == "row":
            number = attributes.get("r", "")
            self._row = int(number) if _NUMBER.fullmatch(number) else self._row + 1
            self._column = 0
        elif name in ("table-cell", "covered-table-cell"):
            self._written += 1
            self._in_cell = True
            self._column += _repeated(attributes, "number-columns-repeated")
            if any(key.endswith(("}value-type", "}formula")) for key in attributes):
                self._fill()
        elif name == "table-row":
            self._row += _repeated(attributes, "number-rows-repeated")
            self._column = 0
        elif name == "table":
            self._other_tables += self._rows * self._columns
            self._rows = self._columns = 1
            self._row = self._column = 0
        elif name in ("worksheet", "spreadsheet"):
            self.is_one = True

    def data(self, _: str) -> None:
        if self._in_cell:
            self._fill()

    def end(self, tag: str) -> None:
        if tag.rpartition("}")[2] in ("c", "table-cell", "covered-table-cell"):
            self._in_cell = False

    def _fill(self) -> None:
        """Count the cell in: it has something in it."""
        self._rows, self._columns = max(self._rows, self._row), max(self._columns, self._column)
        self._check()

    def _check(self) -> None:
        if self._other_tables + self._rows * self._columns > self._most or self._written > self._most:
            raise ExtentError(f"{self._rows} × {self._columns}")


def _repeated(attributes: Mapping[str, str], name: str) -> int:
    """Return how often a row or a cell of OpenDocument stands (OpenDocument 1.3 §19.675, §19.677)."""
    found = next((text for key, text in attributes.items() if key.endswith(f"}}{name}")), "")
    return int(found[:_DIGITS]) if _COUNT.fullmatch(found) else 1


def _column_number(letters: str) -> int:
    """Return the number of a column: 1 for A, 27 for AA."""
    number = 0
    for letter in letters.upper():
        number = 26 * number + ord(letter) - 64
    return number
