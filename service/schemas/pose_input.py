"""Poses as callers write them: a 4×4 matrix, or six numbers."""

from __future__ import annotations

from typing import Annotated, Any, TypeAlias

from pydantic import Discriminator, Field, Tag, WithJsonSchema

from service.http.validation import CHOICE
from service.schemas.base import Matrix4, Real


def _notation_of(target: Any) -> str:
    numbers = isinstance(target, list) and target and not isinstance(target[0], list)
    return CHOICE + ("xyzabc" if numbers else "matrix")


PoseInput: TypeAlias = Annotated[
    Annotated[list[Real], Field(min_length=6, max_length=6), Tag(CHOICE + "xyzabc")]
    | Annotated[Matrix4, Tag(CHOICE + "matrix")],
    Discriminator(_notation_of),
    WithJsonSchema(
        {
            "description": "a pose: 4×4, or [X, Y, Z, A, B, C], R = Rot_z(A) Rot_y(B) Rot_x(C)",
            "anyOf": [
                {"type": "array", "items": {"type": "number"}, "minItems": 6, "maxItems": 6},
                {
                    "type": "array",
                    "items": {"type": "array", "items": {"type": "number"}, "minItems": 4, "maxItems": 4},
                    "minItems": 4,
                    "maxItems": 4,
                },
            ],
        }
    ),
]
