"""POST /convert on the wire."""

from enum import StrEnum
from typing import Annotated, Any, Self, TypeAlias, TypeGuard

from pydantic import Discriminator, Field, Tag, ValidationError, WithJsonSchema, model_validator
from pydantic_core import InitErrorDetails, PydanticCustomError

from kinematics.cells import AngleUnit, LengthUnit
from kinematics.table import JointType
from kinematics.urdf import MAX_CHARACTERS
from service.http.validation import CHOICE
from service.schemas.base import GivenMatrix4, OneOf, Real, Vector3, Wire
from service.schemas.choices import forbidding, not_one_of, together
from service.schemas.kinematics.robot_question import (
    MATRIX,
    PLACED,
    POSE_SHAPES,
    XYZABC,
    JointRanges,
    PlacedPose,
    PoseInput,
    Range,
    XyzabcPose,
    notation_of,
)
from service.schemas.kinematics.scm import ScmChainModel, Verification
from service.schemas.tables import SHORT_CELL, AnsweredRow, AnsweredTable, Parameters, Table, Units


class Target(StrEnum):
    """What a robot can be converted to."""

    STANDARD = "standard"
    MODIFIED = "modified"
    POE = "poe"
    SCM = "scm"
    URDF = "urdf"


class GivenScrew(Wire):
    """A joint's motion: the velocity field of a unit joint rate."""

    joint: OneOf[JointType | None] = Field(
        None, description="its type, which follows from ω and may be left out"
    )
    linear: Vector3 = Field(
        description="v: the velocity at the world's origin, per radian of a revolute joint"
    )
    angular: Vector3 = Field(
        description="ω: the unit vector along a revolute joint's axis; zero if prismatic"
    )


class ScrewProduct(Wire):
    """T(q) = exp([S_1] q_1) ⋯ exp([S_n] q_n) · home, q in radians and in the length unit."""

    screws: list[GivenScrew] = Field(
        min_length=1, max_length=64, description="S_1 … S_n at q = 0, in the axes of the world"
    )
    home: PoseInput = Field(description="the pose of the end frame at q = 0")
    length_unit: OneOf[LengthUnit] = Field(LengthUnit.M, description="unit of every length")


_CELLS = CHOICE + "cells"
_FourCells = Annotated[list[Any], Field(min_length=4, max_length=4)]
_FOUR = {"minItems": 4, "maxItems": 4}


def has_names(pose: Any) -> TypeGuard[list[list[float | str]]]:
    """Whether a pose is a matrix in which something is written: a 4×4 of cells, not of numbers."""
    rows = pose if isinstance(pose, list) else []
    return any(isinstance(cell, str) for row in rows if isinstance(row, list) for cell in row)


NamedPose: TypeAlias = Annotated[
    Annotated[XyzabcPose, Tag(XYZABC)]
    | Annotated[PlacedPose, Tag(PLACED)]
    | Annotated[GivenMatrix4, Tag(MATRIX)]
    | Annotated[list[_FourCells], Field(min_length=4, max_length=4), Tag(_CELLS)],
    Discriminator(lambda pose: _CELLS if has_names(pose) else notation_of(pose)),
    WithJsonSchema(
        {
            "description": "a pose: 4×4, in which expressions may stand, as in an answer; or "
            "[X, Y, Z, A, B, C], R = Rot_z(A) Rot_y(B) Rot_x(C); or a position with a quaternion "
            "[w, x, y, z]",
            "anyOf": [
                *POSE_SHAPES,
                {"type": "array", "items": {"type": "array", "items": SHORT_CELL, **_FOUR}, **_FOUR},
            ],
        }
    ),
]
"""A pose of which a length, or an angle, may be known only by name."""

SOURCES = ("poe", "robot", "scm", "table", "urdf")
_NO_URDF = {"not": {"const": "urdf"}}
OPTIONS_OF_ROWS = ("base", "tool", "parameters")  # Options of the sources that are written in rows of cells.


class ConvertRequest(Wire):
    """A robot, described in exactly one way, and the description that is wanted."""

    model_config = forbidding(
        *not_one_of(*SOURCES),
        *(together(name, without=["urdf"], to=_NO_URDF) for name in ("base_link", "tip_link")),
        *(together(name, source) for name in OPTIONS_OF_ROWS for source in ("urdf", "poe")),
        together("angle_unit", without=["urdf", "poe"]),
        together("verify", without=["scm"]),
        together("name", to=_NO_URDF),
    )

    to: OneOf[Target] = Field(
        description="standard, modified: a DH table; poe: a product of exponentials; scm: an SCM chain; "
        "urdf: a URDF description"
    )
    table: Table | None = Field(None, description="a DH table")
    robot: str | None = Field(None, max_length=64, description="the id of a robot of the catalogue")
    scm: ScmChainModel | None = Field(None, description="an SCM chain; it becomes a DH table (SCM2DH)")
    poe: ScrewProduct | None = Field(None, description="a product of exponentials")
    urdf: str | None = Field(
        None,
        max_length=MAX_CHARACTERS,
        description="a URDF description, XML; one serial chain of it is taken",
    )
    base_link: str | None = Field(
        None,
        max_length=200,
        description="of a URDF: the first link of the chain; the root if left out. To URDF from anything "
        "else: its name; base_link if left out",
    )
    tip_link: str | None = Field(
        None,
        max_length=200,
        description="of a URDF: the last link of the chain; needed where the description branches. To URDF "
        "from anything else: its name; tool0 if left out",
    )
    base: NamedPose | None = Field(None, description="what stands before a table, a listed robot or a chain")
    tool: NamedPose | None = Field(None, description="what stands behind a table, a listed robot or a chain")
    angle_unit: OneOf[AngleUnit | None] = Field(
        None,
        description="of a URDF or a product: the unit of angles in the answer, and in a `home` that is "
        "written as [X, Y, Z, A, B, C]; rad if left out",
    )
    name: str | None = Field(
        None, min_length=1, max_length=100, description="to URDF: the robot's name in the description"
    )
    joint_names: list[Annotated[str, Field(min_length=1, max_length=200)]] | None = Field(
        None, max_length=64, description="names of joint 1 … n; left out, those of the source if it has any"
    )
    link_names: list[Annotated[str, Field(min_length=1, max_length=200)]] | None = Field(
        None,
        max_length=64,
        description="names of the links that joint 1 … n carry; left out, those of the source if it has any",
    )
    limits: JointRanges | None = Field(
        None,
        description="[least, greatest] of each joint in the table's units, null where there is "
        "none; left out, those of the source if it has any",
    )
    parameters: Parameters | None = None
    verify: OneOf[Verification | None] = Field(
        None,
        description="of an SCM chain: strict (if left out) refuses one that does not pass the document's "
        "input check; off takes it all the same, with fixed rows",
    )

    @model_validator(mode="after")
    def _one_source(self) -> Self:
        if sum(getattr(self, name) is not None for name in SOURCES) != 1:
            raise PydanticCustomError(
                "one_source", "describe the robot in exactly one way: {allowed}", {"allowed": SOURCES}
            )
        return self

    @model_validator(mode="after")
    def _no_idle_option(self) -> Self:
        idle = {
            **dict.fromkeys(("base_link", "tip_link"), self.urdf is None and self.to is not Target.URDF),
            **dict.fromkeys(OPTIONS_OF_ROWS, self.urdf is not None or self.poe is not None),
            "angle_unit": self.urdf is None and self.poe is None,
            "verify": self.scm is None,
            "name": self.to is not Target.URDF,
        }
        found = [name for name, is_idle in idle.items() if is_idle and getattr(self, name) is not None]
        if found:
            says = "leave out {found}: this conversion has no use for it"
            details = [
                InitErrorDetails(
                    type=PydanticCustomError("option_idle", says, {"found": name}),
                    loc=(name,),
                    input=getattr(self, name),
                )
                for name in found
            ]
            raise ValidationError.from_exception_data(type(self).__name__, details)
        return self


MatrixOfCells: TypeAlias = Annotated[
    list[Annotated[list[Real | str], Field(min_length=4, max_length=4)]],
    Field(
        min_length=4, max_length=4, description="4×4; an entry that depends on a parameter is an expression"
    ),
]


class NamedAnswer(Units):
    """Names, and limits of the joints, beside a description that has no place for them."""

    name: str | None = Field(None, description="the robot's name, if the source has one")
    base_link: str | None = Field(None, description="the name of the first link, if the source has one")
    tip_link: str | None = Field(None, description="the name of the last link, if the source has one")
    joint_names: list[str] | None = Field(None, description="the names of joint 1 … n, if the source has any")
    link_names: list[str] | None = Field(
        None, description="the names of the links that joint 1 … n carry, if the source has any"
    )
    limits: list[Range | None] | None = Field(
        None, description="[least, greatest] of each joint, if any are known; null where there is none"
    )


class TableAnswer(NamedAnswer):
    """base · (this table) · tool is the described robot, for every q."""

    table: AnsweredTable
    base: MatrixOfCells = Field(description="what stands before the table")
    tool: MatrixOfCells = Field(description="what stands behind the table")
    base_row: AnsweredRow | None = Field(None, description="the base as a fixed row, where it is one")
    tool_row: AnsweredRow | None = Field(None, description="the tool as a fixed row, where it is one")
    base_rows: list[AnsweredRow] | None = Field(
        None, description="the base as fixed rows before the table's; null if it depends on names"
    )
    tool_rows: list[AnsweredRow] | None = Field(
        None, description="the tool as fixed rows behind the table's; null if it depends on names"
    )


class ScrewModel(GivenScrew):
    """A joint's motion, with its type."""

    joint: JointType


class ProductAnswer(NamedAnswer):
    """T(q) = exp([S_1] q_1) ⋯ exp([S_n] q_n) · home, q in radians and in the length unit."""

    screws: list[ScrewModel] = Field(description="S_1 … S_n at q = 0, in the axes of the world")
    home: GivenMatrix4 = Field(description="the pose of the end frame at q = 0")


class UrdfAnswer(Units):
    """A URDF description; its lengths are in metres and its angles in radians, as the format has it."""

    urdf: str = Field(description="the description, XML")
    base_link: str = Field(description="the name of its first link")
    tip_link: str = Field(description="the name of its last link, the end frame")
    assumed_limits: list[int] = Field(
        description="joints, counted from 1, with a limit that stands for none: the format has no prismatic "
        "joint without limits and no limit on one side, so ±1e16 stands for none"
    )


class ScmAnswer(NamedAnswer):
    """base · (the chain's pose) is the described robot, for every q."""

    scm: ScmChainModel = Field(
        description="the chain; where a twist is not zero it turns about two axes in a row"
    )
    base: MatrixOfCells = Field(description="what stands before the chain")
    verify: Verification = Field(
        description="what to send with the chain: off where a row holds a constant turn or an offset, "
        "which does not pass the document's input check"
    )


ConvertAnswer: TypeAlias = TableAnswer | ProductAnswer | ScmAnswer | UrdfAnswer
