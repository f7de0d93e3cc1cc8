"""Rows of a class's file: whose each is, and what type of joint it says."""

from collections.abc import Iterable, Mapping, Sequence
from typing import TypeAlias
from unicodedata import normalize

from kinematics.table import CELLS

Cells: TypeAlias = Mapping[str, object]

_JOINT_TYPES = {
    "r": "revolute", "revolute": "revolute", "rotational": "revolute", "0": "revolute",
    "p": "prismatic", "prismatic": "prismatic", "1": "prismatic", "t": "prismatic", "linear": "prismatic",
    "f": "fixed", "fixed": "fixed",
}  # fmt: skip


def records_of(columns: Sequence[str], rows: Iterable[Sequence[object]]) -> list[Cells]:
    """Return rows by their columns. What counts the joints, 1, 2, 3, says no type, although 1 alone would."""
    records: list[Cells] = [dict(zip(columns, row, strict=False)) for row in rows]
    joints = {name_in(cells.get("joint")) for cells in records}
    if any(text.isdecimal() and text not in _JOINT_TYPES for text in joints):
        return [{**cells, "joint": ""} for cells in records]
    return records


def groups_of(records: Iterable[Cells]) -> dict[tuple[str, str, str], list[Cells]]:
    """Return rows by student, identifier and exercise.

    A cell left empty, as the rest of a merged one is, holds what stands above it.
    """
    groups: dict[tuple[str, str, str], list[Cells]] = {}
    names: dict[str, str] = {}
    student = identifier = exercise = ""
    for cells in records:
        name, known_as = name_in(cells.get("student")), name_in(cells.get("identifier"))
        if known_as not in ("", identifier) or name not in ("", student):
            student, identifier, exercise = name, known_as, ""
        if identifier:
            student = names.setdefault(identifier, student)
        exercise = name_in(cells.get("exercise")) or exercise
        groups.setdefault((student, identifier, exercise), []).append(cells)
    return groups


def row_of(cells: Cells) -> dict[str, object]:
    """Return a row as calls take it; they refuse an unknown type, but a joint may have any name."""
    row = {name: cells.get(name, "") for name in CELLS}
    told = name_in(cells.get("type"))
    joint = _JOINT_TYPES.get(told.lower(), told) or _JOINT_TYPES.get(name_in(cells.get("joint")).lower())
    return {**row, "joint": joint} if joint else row


def name_in(value: object) -> str:
    """Return a cell as a name; the numbers of a workbook all have a fraction: 12345.0."""
    if value is None:
        return ""
    whole = int(value) if isinstance(value, float) and value.is_integer() else value
    return normalize("NFC", str(whole)).strip()
