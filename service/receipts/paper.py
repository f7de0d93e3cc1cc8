"""Pages on which text and lines are put (PDF, written by PDFium).

Lengths are points, from the upper left corner. PDFium is no library for several threads at once: whoever
makes a Paper holds the lock until its file is read.
"""

import ctypes
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from enum import StrEnum
from functools import cache
from typing import Any

import pymupdf_fonts
from pypdfium2 import raw

WIDTH, HEIGHT = 210 / 25.4 * 72, 297 / 25.4 * 72  # A4 [pt].
Colour = tuple[float, float, float, float]  # Red, green, blue and opacity, from 0 to 1.
BLACK: Colour = (0.0, 0.0, 0.0, 1.0)
_ONE_AT_A_TIME = threading.Lock()
_NO_FILL = 0
_ROUND = 1
_END = b"startxref"  # What follows the last thing in a file whose place is written down.


class Face(StrEnum):
    """Typefaces: FiraGO has the letters of all six languages, Greek, and what formulas need."""

    UPRIGHT = "figo"
    BOLD = "figbo"
    ITALIC = "figit"
    TYPEWRITER = "Courier"


OutlineStep = tuple[str, Sequence[float]]
"""A step of an outline: M and L with a point, C with three, Z with none."""


@contextmanager
def paper(language: str) -> "Iterator[Paper]":
    """Give pages to write on; the first one is there."""
    with _ONE_AT_A_TIME:
        document = raw.FPDF_CreateNewDocument()
        try:
            raw.FPDFCatalog_SetLanguage(document, _wide(language))
            yield Paper(document)
        finally:
            raw.FPDF_CloseDocument(document)


class Paper:
    """The pages of a document."""

    def __init__(self, document: Any) -> None:
        self._document = document
        self._fonts: dict[Face, Any] = {}
        self._widths: dict[tuple[Face, str], float] = {}
        self._page: Any = None
        self._pages = 0
        self.turn()

    def turn(self) -> None:
        """Go on with a new page."""
        self._end_page()
        self._page = raw.FPDFPage_New(self._document, self._pages, WIDTH, HEIGHT)
        self._pages += 1

    def width(self, text: str, face: Face, size: float) -> float:
        """Return the width of a text [pt]."""
        return size * sum(self._width(face, letter) for letter in text)

    def text(
        self,
        at: tuple[float, float],
        text: str,
        face: Face,
        size: float,
        colour: Colour = BLACK,
        *,
        halo: tuple[Colour, float] | None = None,
    ) -> None:
        """Put a line of text.

        A halo is a line around the letters, drawn before them.
        """
        if halo is not None:
            outline = self._text(at, text, face, size)
            raw.FPDFTextObj_SetTextRenderMode(outline, raw.FPDF_TEXTRENDERMODE_STROKE)
            self._stroke(outline, *halo)
            raw.FPDFPage_InsertObject(self._page, outline)
        letters = self._text(at, text, face, size)
        raw.FPDFPageObj_SetFillColor(letters, *_bytes(colour))
        raw.FPDFPage_InsertObject(self._page, letters)

    def outline(
        self,
        steps: Sequence[OutlineStep],
        *,
        fill: Colour | None = None,
        stroke: tuple[Colour, float] | None = None,
        dashes: Sequence[float] = (),
    ) -> None:
        """Draw an outline, filled, stroked (colour, width), or both."""
        path = raw.FPDFPageObj_CreateNewPath(0, 0)
        for name, numbers in steps:
            points = [value if i % 2 == 0 else HEIGHT - value for i, value in enumerate(map(float, numbers))]
            _STEPS[name](path, *points)
        if fill is not None:
            raw.FPDFPageObj_SetFillColor(path, *_bytes(fill))
        if stroke is not None:
            self._stroke(path, *stroke)
        if dashes:
            raw.FPDFPageObj_SetDashArray(path, (ctypes.c_float * len(dashes))(*dashes), len(dashes), 0)
        raw.FPDFPath_SetDrawMode(
            path, raw.FPDF_FILLMODE_WINDING if fill is not None else _NO_FILL, stroke is not None
        )
        raw.FPDFPage_InsertObject(self._page, path)

    def pdf(self, comment: str) -> bytes:
        """Return the file. Nothing can be put on its pages afterwards.

        The comment is a line of the file that is on no page, and can be read without what unpacks pages.
        """
        self._end_page()
        written = bytearray()
        file = raw.FPDF_FILEWRITE()
        file.version = 1

        def write(_file: Any, data: Any, size: int) -> int:
            written.extend(ctypes.string_at(data, size))
            return 1

        file.WriteBlock = type(file.WriteBlock)(write)
        if not raw.FPDF_SaveAsCopy(self._document, file, raw.FPDF_SUBSET_NEW_FONTS):
            raise OSError("PDFium could not write the document")
        body, end = bytes(written).rsplit(_END, 1)
        return b"%s%%%s\n%s%s" % (body, comment.encode("ascii"), _END, end)

    def _width(self, face: Face, letter: str) -> float:
        """Width of a letter of size 1."""
        if (face, letter) not in self._widths:
            told = ctypes.c_float()
            raw.FPDFFont_GetGlyphWidth(self._font(face), ord(letter), 1.0, told)
            self._widths[face, letter] = told.value
        return self._widths[face, letter]

    def _end_page(self) -> None:
        if self._page is not None:
            raw.FPDFPage_GenerateContent(self._page)
            raw.FPDF_ClosePage(self._page)
            self._page = None

    def _text(self, at: tuple[float, float], text: str, face: Face, size: float) -> Any:
        written = raw.FPDFPageObj_CreateTextObj(self._document, self._font(face), size)
        raw.FPDFText_SetText(written, _wide(text))
        raw.FPDFPageObj_Transform(written, 1, 0, 0, 1, at[0], HEIGHT - at[1])
        return written

    @staticmethod
    def _stroke(drawn: Any, colour: Colour, width: float) -> None:
        raw.FPDFPageObj_SetStrokeColor(drawn, *_bytes(colour))
        raw.FPDFPageObj_SetStrokeWidth(drawn, width)
        raw.FPDFPageObj_SetLineCap(drawn, _ROUND)
        raw.FPDFPageObj_SetLineJoin(drawn, _ROUND)

    def _font(self, face: Face) -> Any:
        if face not in self._fonts:
            if face is Face.TYPEWRITER:
                self._fonts[face] = raw.FPDFText_LoadStandardFont(self._document, face.encode())
            else:
                data = _file(face)
                self._fonts[face] = raw.FPDFText_LoadFont(
                    self._document, data, len(data), raw.FPDF_FONT_TRUETYPE, True
                )
        return self._fonts[face]


_STEPS = {
    "M": raw.FPDFPath_MoveTo,
    "L": raw.FPDFPath_LineTo,
    "C": raw.FPDFPath_BezierTo,
    "Z": raw.FPDFPath_Close,
}


@cache
def _file(face: Face) -> Any:
    data = pymupdf_fonts.myfont(face.value)
    return (ctypes.c_uint8 * len(data)).from_buffer_copy(data)


def _bytes(colour: Colour) -> tuple[int, ...]:
    return tuple(round(255 * part) for part in colour)


def _wide(text: str) -> Any:
    """UTF-16 with a zero behind it, as PDFium reads texts."""
    data = (text + "\0").encode("utf-16-le", "replace")
    return (ctypes.c_ushort * (len(data) // 2)).from_buffer_copy(data)
