"""What a part asks, as a page shows it: the task, the numbers that it is about, the fields of its form."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any


class FieldShape(StrEnum):
    """How a field of an answer is filled in.

    CELL: one cell. VECTOR: a row of cells. MATRIX: rows of cells. LIST: rows of cells, as many as needed.
    CHOICE: one of some options.
    """

    CELL = "cell"
    VECTOR = "vector"
    MATRIX = "matrix"
    LIST = "list"
    CHOICE = "choice"


@dataclass(frozen=True, kw_only=True, slots=True)
class FormField:
    """A field of the form in which a page takes an answer.

    Attributes:
        name: key in the answer.
        shape: how it is filled in.
        labels: what the cells of a row are called, such as "q1 [°]"; as many as there are.
        rows: of a matrix how many rows it has, of a list how many it may have.
        options: what may be chosen; their names are the messages `option-<option>`.
        caption: the message `field-<caption>` says what the field is called; the name where none is given.
    """

    name: str
    shape: FieldShape
    labels: tuple[str, ...] = ()
    rows: int = 1
    options: tuple[str, ...] = ()
    caption: str = ""


def choice_field(name: str, options: Iterable[str], caption: str = "") -> FormField:
    """Return the field in which one of some options is chosen."""
    return FormField(name=name, shape=FieldShape.CHOICE, options=tuple(map(str, options)), caption=caption)


@dataclass(frozen=True, kw_only=True, slots=True)
class GivenNumbers:
    """Numbers that a task is about, for a page to show.

    Attributes:
        name: what they are; the message `given-<name>`.
        labels: what the columns are called; empty if they need no name.
        rows: the numbers, or cells of a table, row by row.
        values: the values in that message.
    """

    name: str
    labels: tuple[str, ...]
    rows: tuple[tuple[float | str, ...], ...]
    values: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True, slots=True)
class PartTask:
    """What a part asks, for a page to show.

    Attributes:
        message: id of the sentence that asks for it.
        values: the values in that sentence.
        given: a record of the data that the task is about, or None; its fields are shown beside the task.
        form: fields of the answer, in order; empty where the page has a form of its own for the kind.
        numbers: what the task is about, in numbers.
    """

    message: str
    values: Mapping[str, Any] = field(default_factory=dict)
    given: Any = None
    form: tuple[FormField, ...] = ()
    numbers: tuple[GivenNumbers, ...] = ()
