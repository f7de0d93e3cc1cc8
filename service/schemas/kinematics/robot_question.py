"""Robots, poses and joint values as callers write them."""

from collections.abc import Sequence
from typing import Annotated, Any, Literal, Self, TypeAlias

from pydantic import BeforeValidator, Discriminator, Field, Tag, WithJsonSchema, model_validator
from pydantic_core import PydanticCustomError

from service.http.validation import CHOICE
from service.schemas.base import LONGEST_LIST, GivenMatrix4, Real, Vector3, Wire
from service.schemas.choices import forbidding, not_one_of
from service.schemas.tables import Parameters, Table

NO_ROBOT = not_one_of("table", "robot")


class RobotQuestion(Wire):
    """Base of the calls that take a robot: exactly one of `table` and `robot`."""

    model_config = forbidding(*NO_ROBOT)

    table: Table | None = Field(None, description="the robot's DH table")
    robot: str | None = Field(None, max_length=64, description="or the id of a robot of the catalogue")
    parameters: Parameters = Field(default_factory=dict)

    @model_validator(mode="after")
    def _one_robot(self) -> Self:
        if (self.table is None) == (self.robot is None):
            raise PydanticCustomError("table_or_robot", "give either table or robot, exactly one of them")
        return self


_FORMS = ("numeric", "symbolic")


def _known_form(form: object) -> object:
    if form not in _FORMS:
        expected = " or ".join(map(repr, _FORMS))
        raise PydanticCustomError("value_not_allowed", "this must be {expected}", {"expected": expected})
    return form


NumericForm: TypeAlias = Annotated[Literal["numeric"], BeforeValidator(_known_form)]
"""The form of an answer in numbers; a fault names the symbolic one too."""


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


class PlacedRobotQuestion(RobotQuestion):
    """Base of the calls whose robot may stand somewhere, and hold a tool."""

    base: PoseInput | None = Field(None, description="pose of frame 0 in the world; the identity if left out")
    tool: PoseInput | None = Field(None, description="pose of the tool in frame N; the identity if left out")


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
            "anyOf": [_ONE, {"type": "array", "minItems": 1, "items": _ONE}],
            "description": "q_1 … q_n in joint order (fixed rows not counted), or a list of such lists",
        }
    ),
]


Range: TypeAlias = Annotated[list[Real | None], Field(min_length=2, max_length=2)]
JointRanges: TypeAlias = Annotated[
    list[Range | None],
    Field(
        max_length=64,
        description="[least, greatest] of each joint in the table's units; null where there is no limit",
    ),
]

DomainLimits: TypeAlias = list[tuple[float | None, float | None] | None]


def domain_limits(
    limits: Sequence[Sequence[float | None] | None] | None, units: Sequence[float]
) -> DomainLimits | None:
    """Return the limits in [rad] and in the table's length unit.

    Args:
        limits: as they were sent.
        units: for joint 1 … n what one unit of the request is; further limits are left to be refused.
    """
    if limits is None:
        return None
    factors = [*units, *([1.0] * (len(limits) - len(units)))]
    return [
        None if pair is None else (_scaled(pair[0], factor), _scaled(pair[1], factor))
        for pair, factor in zip(limits, factors, strict=False)
    ]


def _scaled(bound: float | None, factor: float) -> float | None:
    return None if bound is None else bound * factor
