"""Wire models derived from the domain's records: their fields and docstrings are the only description.

A frozen dataclass of `exercises` becomes a pydantic model with the same fields; what its docstring says under
"Attributes:" documents them. Answers come in through such a model (`raw_of` leads back to the record),
verdicts go out as the records themselves and are documented by it.
"""

import re
import types
from collections.abc import Mapping, Sequence
from dataclasses import MISSING, fields, is_dataclass
from enum import Enum
from functools import cache
from typing import Annotated, Any, Union, cast, get_args, get_origin, get_type_hints

from pydantic import Field, create_model

from exercises.grading import Edit, Feedback
from exercises.grading.verdict import Matrix4 as DomainMatrix4
from exercises.parts.cells.matrix_cells import CellMatrix as DomainCellMatrix
from exercises.parts.protocol import Length
from kinematics.cells import Cell as DomainCell
from kinematics.cells import RawTable
from service.schemas.base import Matrix4, Real, Vector3, Whole, WholeOrText, Wire
from service.schemas.tables import Cell, Table

CellRow = Annotated[list[Cell], Field(min_length=4, max_length=4)]
CellMatrix = Annotated[
    list[CellRow], Field(min_length=4, max_length=4, description="4×4 of numbers or expressions, row by row")
]

KNOWN: Sequence[tuple[Any, Any]] = (
    (RawTable, Table),
    (DomainCell, Cell),
    (DomainCellMatrix, CellMatrix),
    (DomainMatrix4, Matrix4),
    (tuple[float, float, float], Vector3),
    (float, Real),
    (int | str, WholeOrText),
)
"""Domain types that have a wire shape of their own."""

SPOKEN: Mapping[type, str] = {Feedback: "feedback", Edit: "repair"}
"""Records that stand for a sentence, and how the ids of their messages begin."""

_MESSAGE = "the sentence, in the caller's language"
_ATTRIBUTE = re.compile(r"^ {4}(?: {4})?(\w+): (.*)$")


@cache
def model_of(record: type) -> type[Wire]:
    """Return the wire model of a frozen dataclass."""
    described = descriptions(record)
    hints = get_type_hints(record, include_extras=True)
    found: dict[str, Any] = {
        entry.name: (
            wire_type(hints[entry.name]),
            Field(... if entry.default is MISSING else entry.default, description=described.get(entry.name)),
        )
        for entry in fields(record)
    }
    if record in SPOKEN:
        found["message"] = (str, Field(description=_MESSAGE))
    summary = (record.__doc__ or "").partition("\n")[0]
    return create_model(record.__name__, __base__=Wire, __doc__=summary, **found)


def wire_type(annotation: Any) -> Any:
    """Return the annotation of a wire model for one of a record.

    Raises:
        TypeError: a type has no wire shape.
    """
    for domain, wire in KNOWN:
        if annotation == domain:
            return wire
    origin, arguments = get_origin(annotation), get_args(annotation)
    if origin is Annotated:
        bounds = next((entry for entry in arguments[1:] if isinstance(entry, Length)), None)
        inner = wire_type(arguments[0])
        if bounds is None:
            return inner
        return Annotated[inner, Field(min_length=bounds.least, max_length=bounds.most)]
    if origin in (Union, types.UnionType) and len(arguments) > 2 and type(None) in arguments:
        given = tuple(argument for argument in arguments if argument is not type(None))
        return wire_type(Union[given]) | None  # noqa: UP007 - made at run time
    if origin in (Union, types.UnionType):
        return Union[tuple(wire_type(argument) for argument in arguments)]  # noqa: UP007 - made at run time
    if origin is tuple and arguments[-1] is Ellipsis:
        return list[wire_type(arguments[0])]  # type: ignore[misc]
    if origin is tuple:
        bounds = Field(min_length=len(arguments), max_length=len(arguments))
        return Annotated[list[wire_type(arguments[0])], bounds]  # type: ignore[misc]
    if origin is not None and issubclass(origin, Mapping):
        return dict.__class_getitem__((arguments[0], wire_type(arguments[1])))
    return _plain_type(annotation)


def raw_of(value: Any, annotation: Any) -> Any:
    """Return the record, or the value of one of its fields, that a validated wire value stands for."""
    if isinstance(value, Table):
        return value.raw()
    if get_origin(annotation) is Annotated:
        annotation = get_args(annotation)[0]
    if is_dataclass(annotation):
        hints = get_type_hints(annotation, include_extras=True)
        record = cast(Any, annotation)
        return record(**{name: raw_of(getattr(value, name), hint) for name, hint in hints.items()})
    if get_origin(annotation) in (Union, types.UnionType):
        chosen = [argument for argument in get_args(annotation) if argument is not type(None)]
        return None if value is None else raw_of(value, chosen[0]) if len(chosen) == 1 else value
    if get_origin(annotation) is tuple and isinstance(value, list):
        return tuple(raw_of(entry, get_args(annotation)[0]) for entry in value)
    return value


@cache
def carries_sentences(record: type) -> bool:
    """Return whether a record or anything inside it stands for a sentence."""
    return record in SPOKEN or any(
        carries_sentences(cast(type, inner))
        for hint in get_type_hints(record).values()
        for inner in _inner_types(hint)
        if is_dataclass(inner)
    )


def descriptions(record: type) -> dict[str, str]:
    """Return what a record's docstring says of its attributes, those of its bases included."""
    found: dict[str, str] = {}
    for ancestor in reversed(record.__mro__):
        _, _, text = (ancestor.__doc__ or "").partition("Attributes:\n")
        name = ""
        for line in text.splitlines():
            match = _ATTRIBUTE.match(line)
            if match:
                name = match[1]
                found[name] = match[2].strip()
            elif name and line.strip():
                found[name] += " " + line.strip()
    return {name: text.rstrip(".") for name, text in found.items()}


def _plain_type(annotation: Any) -> Any:
    if isinstance(annotation, type) and issubclass(annotation, Enum):
        return Annotated[annotation, Field(strict=False)]
    if is_dataclass(annotation):
        return model_of(cast(type, annotation))
    if annotation is int:
        return Whole
    if annotation in (str, bool, type(None)):
        return annotation
    raise TypeError(f"{annotation} has no wire shape")


def _inner_types(hint: Any) -> list[Any]:
    arguments = get_args(hint)
    return [hint] if not arguments else [inner for argument in arguments for inner in _inner_types(argument)]
