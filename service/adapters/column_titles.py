"""What the titles of a file's columns mean: which column each is, its unit, and the convention."""

import re
from collections.abc import Iterator, Sequence
from unicodedata import normalize

from kinematics.table import ANGLES, CELLS

_COLUMNS = {
    "theta": "theta θ th thetai θi jointangle thetaoffset θoffset thêta teta тета",
    "d": "d di linkoffset offset",
    "a": "a ai r ri linklength ai-1 a(i-1)",
    "alpha": "alpha α alphai αi linktwist twist alphai-1 αi-1 alpha(i-1) α(i-1) alfa альфа",
    "joint": "joint",
    "type": "type jointtype sigma σ",
    "student": "student name",
    "identifier": "studentid user username userid login email e-mail id",
    "exercise": "exercise robot task",
    "convention": "convention",
    "link": "link row i linki # frame no nr",
}
_MEANING = {spelling: column for column, spellings in _COLUMNS.items() for spelling in spellings.split()}
_UNIT_IN_HEADER = re.compile(r"[\[(]\s*(deg|degrees|°|rad|radians|m|cm|mm|in)\s*[\])]")
_UNITS = {"°": "deg", "degrees": "deg", "radians": "rad"}


def is_header(row: Sequence[object]) -> bool:
    """Return whether a row names the four columns of a table."""
    return set(CELLS) <= {column_of(str(cell)) for cell in row}


def column_of(title: str) -> str:
    """Return the column that a title means; "" if none is known by it."""
    bare = _UNIT_IN_HEADER.sub("", _plain(title))
    return _MEANING.get(re.sub(r"[\s_{}$\\*]", "", bare), "")


def columns_of(header: Sequence[str]) -> list[str]:
    """Return the columns that titles mean; "" for what is unknown, or stands before under another title."""
    meant = [column_of(title) for title in header]
    return ["" if column in meant[:i] else column for i, column in enumerate(meant)]


def _plain(title: str) -> str:
    """A title in lower case, its indices on the line: aᵢ₋₁ as ai-1."""
    return normalize("NFKC", title.strip().lower()).replace("−", "-")


def told_by(header: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Yield convention and units as the titles name them: a_{i-1}, alpha (deg), d [mm]."""
    for title in header:
        column = column_of(title)
        if column in CELLS and (found := _UNIT_IN_HEADER.search(_plain(title))):
            yield "angle_unit" if column in ANGLES else "length_unit", _UNITS.get(found[1], found[1])
        if column in ("a", "alpha") and re.search(r"i\s*-\s*1", _plain(title)):
            yield "convention", "modified"


def repeated_titles(header: Sequence[str]) -> list[str]:
    """Return the titles of the first of the four columns that is named more than once; none if none is."""
    meant = [column_of(title) for title in header]
    twice = next((column for column in CELLS if meant.count(column) > 1), None)
    return [title for title, column in zip(header, meant, strict=True) if column == twice]
