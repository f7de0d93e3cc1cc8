"""A receipt as pages to print: points, robot, table, QR code (PDF)."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from service.receipts.figure_on_paper import draw_figure
from service.receipts.paper import BLACK, HEIGHT, WIDTH, Colour, Face, OutlineStep, Paper, paper

_MM = 72 / 25.4
_MARGIN = 18 * _MM
_LEFT, _RIGHT, _TOP, _BOTTOM = _MARGIN, WIDTH - _MARGIN, _MARGIN, HEIGHT - _MARGIN
_SIZE = 10.5
_LINE = 1.35  # Distance of lines in sizes of their letters.
_CODE = 65 * _MM
_GUTTER = 8 * _MM
_INSET = 4.0
_ROUNDING = 0.01
_QUIET = 4  # Modules that stay white around a QR code (ISO/IEC 18004, 6.3.8).
_GREY: Colour = (0.3, 0.3, 0.3, 1.0)
_RULE: Colour = (0.6, 0.6, 0.6, 1.0)


@dataclass(frozen=True, kw_only=True, slots=True)
class Sheet:
    """What stands on the page, in the reader's language.

    Attributes:
        language: of everything on the page.
        facts: name and value, line by line.
        answer: heading of the table.
        columns: headings of the table's columns.
        rows: the table as it was typed; none where no table was handed in.
        signature: who signed.
        receipt: the compact JWS.
    """

    title: str
    language: str
    facts: Sequence[tuple[str, str]]
    answer: str
    columns: Sequence[str]
    rows: Sequence[Sequence[str]]
    signature: str
    receipt: str


def pdf_of(sheet: Sheet, *, figure: str, code: Sequence[bytes | bytearray]) -> bytes:
    """Return the pages as PDF.

    The figure is SVG; the QR code has a byte for each module, 1 where it is dark.
    """
    with paper(sheet.language) as page:
        flow = _Flow(page)
        flow.paragraph(sheet.title, Face.BOLD, 18)
        flow.skip(6)
        flow.pairs(sheet.facts)
        flow.skip(10)
        flow.pictures(figure, code)
        if sheet.rows:
            flow.skip(14)
            flow.paragraph(sheet.answer, Face.BOLD, 13)
            flow.skip(4)
            flow.table(sheet.columns, sheet.rows)
        flow.at_the_foot(sheet.signature, sheet.receipt)
        return page.pdf(sheet.receipt)


class _Flow:
    """What follows one another down the pages."""

    def __init__(self, page: Paper) -> None:
        self.page, self.y = page, _TOP

    def skip(self, height: float) -> None:
        self.y += height

    def room(self, height: float) -> None:
        """Begin a new page where less than this is left of the old one."""
        if self.y + height > _BOTTOM + _ROUNDING:
            self.page.turn()
            self.y = _TOP

    def paragraph(self, text: str, face: Face, size: float, left: float = _LEFT) -> None:
        for line in self.lines(text, face, size, _RIGHT - left):
            self.room(size * _LINE)
            self.page.text((left, self.y + size), line, face, size, BLACK)
            self.y += size * _LINE

    def pairs(self, pairs: Sequence[tuple[str, str]]) -> None:
        """Names in grey and values beside them."""
        column = max((self.page.width(name, Face.UPRIGHT, _SIZE) for name, _ in pairs), default=0)
        for name, value in pairs:
            self.room(_SIZE * _LINE)
            self.page.text((_LEFT, self.y + _SIZE), name, Face.UPRIGHT, _SIZE, _GREY)
            self.paragraph(value, Face.BOLD, _SIZE, _LEFT + min(column, (_RIGHT - _LEFT) / 2) + _GUTTER)
            self.y += 2

    def pictures(self, figure: str, code: Sequence[bytes | bytearray]) -> None:
        """The robot, and the code on its right."""
        high = draw_figure(self.page, figure, (_LEFT, self.y), _RIGHT - _LEFT - _CODE - _GUTTER)
        module = _CODE / (len(code) + 2 * _QUIET)
        steps: list[OutlineStep] = []
        for i, row in enumerate(code):
            y = self.y + (i + _QUIET) * module
            for begin, end in _dark(row):
                left, right = (_RIGHT - _CODE + (j + _QUIET) * module for j in (begin, end))
                steps += _box(left, y, right, y + module)
        self.page.outline(steps, fill=BLACK)
        self.y += max(high, _CODE)

    def table(self, columns: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
        """A table with rules, its columns as wide as they must be; its head again on every page."""
        lines = [(columns, Face.BOLD), *((row, Face.UPRIGHT) for row in rows)]
        natural = [
            max(self.page.width(row[i], face, _SIZE) for row, face in lines) for i in range(len(columns))
        ]
        widths = _fitted([width + 2 * _INSET for width in natural], _RIGHT - _LEFT)
        self._row(columns, widths, Face.BOLD)
        for row in rows:
            if self.y + self._row_height(row, widths, Face.UPRIGHT) > _BOTTOM + _ROUNDING:
                self.page.turn()
                self.y = _TOP
                self._row(columns, widths, Face.BOLD)
            self._row(row, widths, Face.UPRIGHT)

    def at_the_foot(self, signature: str, receipt: str) -> None:
        """Who signed, and the receipt as text."""
        said = self.lines(signature, Face.UPRIGHT, 8, _RIGHT - _LEFT)
        token = self.lines(receipt, Face.TYPEWRITER, 6, _RIGHT - _LEFT)
        high = (8 * len(said) + 6 * len(token)) * _LINE + 6
        self.skip(10)
        self.room(min(high, _BOTTOM - _TOP))
        self.y = max(self.y, _BOTTOM - high)
        self.paragraph(signature, Face.UPRIGHT, 8)
        self.skip(6)
        self.paragraph(receipt, Face.TYPEWRITER, 6)

    def lines(self, text: str, face: Face, size: float, width: float) -> list[str]:
        """Return the text in lines of a width: broken between words, and inside a word where it must be."""
        lines, line, used = [], "", 0.0
        space = self.page.width(" ", face, size)
        for word in text.split():
            wide = self.page.width(word, face, size)
            if line and used + space + wide <= width:
                line, used = f"{line} {word}", used + space + wide
                continue
            if line:
                lines.append(line)
            line, used = "", 0.0
            for letter in word:
                step = self.page.width(letter, face, size)
                if line and used + step > width:
                    lines.append(line)
                    line, used = "", 0.0
                line, used = line + letter, used + step
        return [*lines, line]

    def _row_height(self, cells: Sequence[str], widths: Sequence[float], face: Face) -> float:
        most = max(
            len(self.lines(cell, face, _SIZE, width - 2 * _INSET))
            for cell, width in zip(cells, widths, strict=True)
        )
        return most * _SIZE * _LINE + _INSET

    def _row(self, cells: Sequence[str], widths: Sequence[float], face: Face) -> None:
        high = self._row_height(cells, widths, face)
        self.room(high)
        left = _LEFT
        for cell, width in zip(cells, widths, strict=True):
            self.page.outline(_box(left, self.y, left + width, self.y + high), stroke=(_RULE, 0.5))
            for i, line in enumerate(self.lines(cell, face, _SIZE, width - 2 * _INSET)):
                x = left + (width - self.page.width(line, face, _SIZE)) / 2
                self.page.text((x, self.y + _INSET / 2 + _SIZE * (1 + i * _LINE)), line, face, _SIZE)
            left += width
        self.y += high


def _box(left: float, top: float, right: float, low: float) -> list[OutlineStep]:
    return [("M", (left, top)), ("L", (right, top)), ("L", (right, low)), ("L", (left, low)), ("Z", ())]


def _dark(row: bytes | bytearray) -> Iterator[tuple[int, int]]:
    """Begin and end of each run of dark modules."""
    begin = None
    for i, dark in enumerate([*row, 0]):
        if dark and begin is None:
            begin = i
        elif not dark and begin is not None:
            yield begin, i
            begin = None


def _fitted(widths: Sequence[float], total: float) -> list[float]:
    """Widths that fill no more than the total: the widest ones give way."""
    fair = total / len(widths)
    over = [width for width in widths if width > fair]
    if sum(widths) <= total:
        return list(widths)
    left = total - sum(width for width in widths if width <= fair)
    return [width if width <= fair else left * width / sum(over) for width in widths]
