"""Joint values on the wire: one configuration, or a batch."""

from __future__ import annotations

from typing import Annotated, Any, TypeAlias

from pydantic import Discriminator, Tag, WithJsonSchema

from service.http.validation import CHOICE
from service.schemas.base import Real


def _shape_of(joints: Any) -> str:
    batch = isinstance(joints, list) and joints and isinstance(joints[0], list)
    return CHOICE + ("batch" if batch else "one")


Joints: TypeAlias = Annotated[
    Annotated[list[Real], Tag(CHOICE + "one")] | Annotated[list[list[Real]], Tag(CHOICE + "batch")],
    Discriminator(_shape_of),
    WithJsonSchema(
        {
            "anyOf": [
                {"type": "array", "items": {"type": "number"}},
                {"type": "array", "minItems": 1, "items": {"type": "array", "items": {"type": "number"}}},
            ],
            "description": "q_1 … q_n in joint order (fixed rows not counted), or a list of such lists",
        }
    ),
]
