"""Joint values on the wire: one configuration, or a batch."""

from __future__ import annotations

from typing import Annotated, Any, TypeAlias

from pydantic import Discriminator, Field, Tag, WithJsonSchema

from service.http.validation import CHOICE
from service.schemas.base import LONGEST_LIST, Real

_ONE = {"type": "array", "items": {"type": "number"}, "maxItems": LONGEST_LIST}


def _shape_of(joints: Any) -> str:
    batch = isinstance(joints, list) and joints and isinstance(joints[0], list)
    return CHOICE + ("batch" if batch else "one")


Configuration: TypeAlias = Annotated[list[Real], Field(max_length=LONGEST_LIST, fail_fast=True)]
"""One value a joint. A batch may have millions: the first that is no number is named, and no more."""

Configurations: TypeAlias = Annotated[list[Configuration], Field(fail_fast=True)]

Joints: TypeAlias = Annotated[
    Annotated[list[Real], Field(max_length=LONGEST_LIST), Tag(CHOICE + "one")]
    | Annotated[Configurations, Tag(CHOICE + "batch")],
    Discriminator(_shape_of),
    WithJsonSchema(
        {
            "anyOf": [
                _ONE,
                {"type": "array", "minItems": 1, "items": _ONE},
            ],
            "description": "q_1 … q_n in joint order (fixed rows not counted), or a list of such lists",
        }
    ),
]
