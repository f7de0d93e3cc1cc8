"""Poses as callers write them: a 4×4 matrix, six numbers, or a position with a quaternion."""

from __future__ import annotations

from typing import Annotated, Any, TypeAlias

from pydantic import Discriminator, Field, Tag, WithJsonSchema

from service.http.validation import CHOICE
from service.schemas.base import Matrix4, Real, Vector3, Wire


class PlacedPose(Wire):
    """A pose as a position with a quaternion."""

    position: Vector3 = Field(description="where the origin is")
    quaternion: Annotated[list[Real], Field(min_length=4, max_length=4)] = Field(
        description="[w, x, y, z] of any length but zero"
    )


def _notation_of(target: Any) -> str:
    if isinstance(target, dict | PlacedPose):
        return CHOICE + "placed"
    numbers = isinstance(target, list) and target and not isinstance(target[0], list)
    return CHOICE + ("xyzabc" if numbers else "matrix")


def _numbers(count: int) -> dict[str, Any]:
    return {"type": "array", "items": {"type": "number"}, "minItems": count, "maxItems": count}


PoseInput: TypeAlias = Annotated[
    Annotated[list[Real], Field(min_length=6, max_length=6), Tag(CHOICE + "xyzabc")]
    | Annotated[PlacedPose, Tag(CHOICE + "placed")]
    | Annotated[Matrix4, Tag(CHOICE + "matrix")],
    Discriminator(_notation_of),
    WithJsonSchema(
        {
            "description": "a pose: 4×4; or [X, Y, Z, A, B, C], R = Rot_z(A) Rot_y(B) Rot_x(C); or a "
            "position with a quaternion [w, x, y, z]",
            "anyOf": [
                _numbers(6),
                {"type": "array", "items": _numbers(4), "minItems": 4, "maxItems": 4},
                {
                    "type": "object",
                    "properties": {"position": _numbers(3), "quaternion": _numbers(4)},
                    "required": ["position", "quaternion"],
                    "additionalProperties": False,
                },
            ],
        }
    ),
]
