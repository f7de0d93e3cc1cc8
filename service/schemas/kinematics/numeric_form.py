"""Calls that answer in numbers or in symbols."""

from __future__ import annotations

from typing import Annotated, Literal, TypeAlias

from pydantic import BeforeValidator
from pydantic_core import PydanticCustomError

_FORMS = ("numeric", "symbolic")


def _known_form(form: object) -> object:
    if form not in _FORMS:
        expected = " or ".join(map(repr, _FORMS))
        raise PydanticCustomError("value_not_allowed", "this must be {expected}", {"expected": expected})
    return form


NumericForm: TypeAlias = Annotated[Literal["numeric"], BeforeValidator(_known_form)]
"""The form of an answer in numbers; a fault names the symbolic one too."""
