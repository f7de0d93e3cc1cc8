"""Poses as callers write them: a 4×4 matrix, six numbers, or a position with a quaternion."""

from __future__ import annotations

from typing import Annotated, Any, TypeAlias

from pydantic import BeforeValidator, Discriminator, Field, Tag, WithJsonSchema
from pydantic_core import PydanticCustomError

from service.http.validation import CHOICE
from service.schemas.base import GivenMatrix4, Real, Vector3, Wire


class PlacedPose(Wire):
    """A pose as a position with a quaternion."""

    position: Vector3 = Field(description="where the origin is")
    quaternion: Annotated[list[Real], Field(min_length=4, max_length=4)] = Field(
        description="[w, x, y, z] of any length but zero"
    )


PLACED, XYZABC, MATRIX = (CHOICE + name for name in ("placed", "xyzabc", "matrix"))


def notation_of(pose: Any) -> str:
    """Return the tag of the notation in which a pose is given."""
    if isinstance(pose, dict | PlacedPose):
        return PLACED
    numbers = isinstance(pose, list) and pose and not isinstance(pose[0], list)
    return XYZABC if numbers else MATRIX


def _not_a_flat_matrix(pose: Any) -> Any:
    if len(pose) == 16:
        raise PydanticCustomError("pose_in_one_row", "sixteen numbers in one list")
    return pose


XyzabcPose: TypeAlias = Annotated[
    list[Real], Field(min_length=6, max_length=6), BeforeValidator(_not_a_flat_matrix)
]


def _numbers(count: int) -> dict[str, Any]:
    return {"type": "array", "items": {"type": "number"}, "minItems": count, "maxItems": count}


POSE_SHAPES: list[dict[str, Any]] = [
    _numbers(6),
    {"type": "array", "items": _numbers(4), "minItems": 4, "maxItems": 4},
    {
        "type": "object",
        "properties": {"position": _numbers(3), "quaternion": _numbers(4)},
        "required": ["position", "quaternion"],
        "additionalProperties": False,
    },
]
PoseInput: TypeAlias = Annotated[
    Annotated[XyzabcPose, Tag(XYZABC)]
    | Annotated[PlacedPose, Tag(PLACED)]
    | Annotated[GivenMatrix4, Tag(MATRIX)],
    Discriminator(notation_of),
    WithJsonSchema(
        {
            "description": "a pose: 4×4; or [X, Y, Z, A, B, C], R = Rot_z(A) Rot_y(B) Rot_x(C); or a "
            "position with a quaternion [w, x, y, z]",
            "anyOf": POSE_SHAPES,
        }
    ),
]
