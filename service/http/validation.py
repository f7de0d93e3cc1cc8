"""Pydantic's findings as faults: stable codes, JSON pointers, sentences that say what would be right."""

import re
import types
from collections.abc import Iterable, Sequence
from typing import Any, TypeAlias, TypeVar, Union, get_args, get_origin

from pydantic import BaseModel, Tag, ValidationError
from pydantic_core import ErrorDetails
from pydantic_core.core_schema import ErrorType

from kinematics.errors import Fault, ParamValue
from service.http.problems import RequestError, RequestPart

CODES: dict[str, str] = {
    "missing": "field_missing",
    "extra_forbidden": "field_unknown",
    "float_type": "number_expected",
    "float_parsing": "number_expected",
    "finite_number": "number_not_finite",
    "int_type": "integer_expected",
    "int_parsing": "integer_expected",
    "int_from_float": "integer_expected",
    "bool_type": "boolean_expected",
    "bool_parsing": "boolean_expected",
    "string_type": "string_expected",
    "list_type": "list_expected",
    "tuple_type": "list_expected",
    "set_type": "list_expected",
    "frozen_set_type": "list_expected",
    "dict_type": "object_expected",
    "model_type": "object_expected",
    "model_attributes_type": "object_expected",
    "dataclass_type": "object_expected",
    "literal_error": "value_not_allowed",
    "enum": "value_not_allowed",
    "too_long": "list_too_long",
    "too_short": "list_too_short",
    "string_too_long": "string_too_long",
    "string_too_short": "string_too_short",
    "string_pattern_mismatch": "string_pattern",
    "greater_than": "number_too_small",
    "greater_than_equal": "number_too_small",
    "less_than": "number_too_large",
    "less_than_equal": "number_too_large",
    "none_required": "null_expected",
}
MOST_FAULTS = 50  # Findings that are told; the others are counted: what is no table may have thousands.
CHOICE = "\0"  # Begins the tags of a union's branches, which are no part of the place of a fault.

_PYDANTIC_TYPES = frozenset(get_args(ErrorType))
_QUOTED = re.compile(r"'[^']*'")
_BOUNDS = ("ge", "gt", "le", "lt")
_Allowed: TypeAlias = dict[tuple[int | str, ...], tuple[str, ...]]
"""Names of the fields that an object may have, by its place; many unknown ones stand in one object."""
_PARTS = {part.value: part for part in RequestPart}
Shape = TypeVar("Shape", bound=BaseModel)


def validated(shape: type[Shape], value: object) -> Shape:
    """Return the value in a shape.

    Raises:
        RequestError: it does not have that form; many faults at once.
    """
    try:
        return shape.model_validate(value)
    except ValidationError as error:
        found = error.errors(include_url=False, include_input=False)
        told = faults_of(found[:MOST_FAULTS], shape)
        raise RequestError(told, unlisted=len(found) - len(told)) from None


def faults_of(errors: Iterable[ErrorDetails], model: Any = None) -> tuple[Fault, ...]:
    """Return one fault for each of pydantic's findings, at its place below the validated value."""
    allowed: _Allowed = {}
    return tuple(_fault(error, error["loc"], model, allowed) for error in errors)


def request_error(errors: Sequence[Any], body_model: Any = None, most: int = MOST_FAULTS) -> RequestError:
    """Return the refusal of a request that FastAPI found wrong, in its body, query, path or headers.

    Args:
        errors: pydantic's findings.
        body_model: what the body should have been.
        most: findings that are told; the others are counted.
    """
    first = _part(errors[0])
    found = [error for error in errors if _part(error) is first]
    model = body_model if first is RequestPart.BODY else None
    allowed: _Allowed = {}
    faults = [_fault(error, error["loc"][1:], model, allowed) for error in found[:most]]
    return RequestError(faults, part=first, unlisted=max(0, len(found) - most))


def _part(error: Any) -> RequestPart:
    return _PARTS.get(str(error["loc"][0]), RequestPart.BODY) if error["loc"] else RequestPart.BODY


def _fault(error: ErrorDetails, loc: tuple[int | str, ...], model: Any, allowed: _Allowed) -> Fault:
    where = tuple(step for step in loc if not _is_tag(step))
    kind, context = error["type"], error.get("ctx") or {}
    code = CODES.get(kind, kind if kind not in _PYDANTIC_TYPES else "value_invalid")
    if code == "object_expected" and not where:
        code = "body_not_object"
    params: dict[str, ParamValue] = {"field": _name(where)}
    params |= {name: _plain(value) for name, value in context.items() if name != "error"}
    if code == "field_unknown":
        if loc[:-1] not in allowed:
            allowed[loc[:-1]] = tuple(dict.fromkeys(_fields_at(model, loc[:-1])))
        params["allowed"] = allowed[loc[:-1]]
    elif code in ("number_too_small", "number_too_large"):
        name = next(name for name in _BOUNDS if name in context)
        params = {"limit": _plain(context[name]), "bound": "included" if name in ("ge", "le") else "excluded"}
    elif code in ("list_too_long", "string_too_long"):
        params = {"limit": _plain(context["max_length"])}
    elif code in ("list_too_short", "string_too_short"):
        params = {"limit": _plain(context["min_length"])}
    elif code == "value_not_allowed":
        # pydantic joins them in English
        expected = str(context.get("expected", ""))
        params = {"expected": ", ".join(_QUOTED.findall(expected)) or expected}
    elif code == "string_pattern":
        params = {"pattern": str(context.get("pattern", ""))}
    elif code == "value_invalid":
        params = {"reason": error["msg"]}
    return Fault.at(code, *where, **params)


def _name(where: Sequence[int | str]) -> str:
    """The innermost named field, with the indices below it: joints[3][0]."""
    named = max((i for i, step in enumerate(where) if isinstance(step, str)), default=0)
    return "".join(f"[{step}]" if isinstance(step, int) else str(step) for step in where[named:])


def _is_tag(step: int | str) -> bool:
    return str(step).startswith(CHOICE)


def _plain(value: object) -> ParamValue:
    return value if isinstance(value, (str, int, float, tuple)) else str(value)


def _fields_at(model: Any, loc: Sequence[int | str]) -> Iterable[str]:
    """Names of the fields that an object at this place may have; tags say which branch of a union it is."""
    for step in loc:
        model = (_branch(model, step) or model) if _is_tag(step) else _below(model, step)
    found = [candidate for candidate in _alternatives(model) if _is_model(candidate)]
    return [info.alias or name for candidate in found for name, info in candidate.model_fields.items()]


def _branch(model: Any, tag: int | str) -> Any:
    """The branch of a union that has a tag, or None."""
    if any(isinstance(mark, Tag) and mark.tag == tag for mark in getattr(model, "__metadata__", ())):
        return model
    inner = get_args(model)[:1] if hasattr(model, "__metadata__") else _choices(model)
    return next((found for part in inner if (found := _branch(part, tag)) is not None), None)


def _below(model: Any, step: int | str) -> Any:
    for candidate in _alternatives(model):
        if _is_model(candidate) and step in candidate.model_fields:
            return candidate.model_fields[str(step)].annotation
        arguments = get_args(candidate)
        if arguments:
            return arguments[0] if isinstance(step, int) else arguments[-1]
    return None


def _alternatives(model: Any) -> list[Any]:
    if hasattr(model, "__metadata__"):
        model = get_args(model)[0]
    choices = _choices(model)
    return [part for choice in choices for part in _alternatives(choice)] if choices else [model]


def _choices(model: Any) -> tuple[Any, ...]:
    return get_args(model) if get_origin(model) in (Union, types.UnionType) else ()


def _is_model(candidate: Any) -> bool:
    return isinstance(candidate, type) and issubclass(candidate, BaseModel)
