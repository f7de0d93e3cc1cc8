"""The SCM method on the wire: chains of [X Y Z A B C] rows, and which of them a call speaks of."""

from enum import StrEnum
from typing import Annotated, Any, Self, TypeAlias

from pydantic import BeforeValidator, Field, WithJsonSchema, model_validator
from pydantic_core import PydanticCustomError

from kinematics.cells import AngleUnit, LengthUnit
from kinematics.scm import RawChain
from service.schemas.base import LONGEST_LIST, OneOf, Real, Wire
from service.schemas.choices import forbidding, not_one_of
from service.schemas.tables import SHORT_CELL, Cell, Parameters

ENTRIES = ("x", "y", "z", "a", "b", "c")


class PlacementModel(Wire):
    """Trans(x, y, z) Rot_z(a) Rot_y(b) Rot_x(c): what is left out is zero."""

    x: Cell = 0
    y: Cell = 0
    z: Cell = 0
    a: Cell = 0
    b: Cell = 0
    c: Cell = 0

    def cells(self) -> dict[str, Any]:
        """Return the six entries by name."""
        return {entry: getattr(self, entry) for entry in ENTRIES}


class ListedPlacement(PlacementModel):
    """A placement that was written as the list of its entries."""


def placement_by_name(value: Any) -> Any:
    """Return six entries by name, whether they came by name or in order."""
    if isinstance(value, list) and len(value) == len(ENTRIES):
        return ListedPlacement(**dict(zip(ENTRIES, value, strict=True)))
    if not isinstance(value, dict | PlacementModel):
        raise PydanticCustomError("scm_six_entries", "six entries: [X, Y, Z, A, B, C], or an object")
    return value


PLACEMENT_SHAPES: list[dict[str, Any]] = [
    {"type": "object", "properties": dict.fromkeys(ENTRIES, SHORT_CELL), "additionalProperties": False},
    {"type": "array", "items": SHORT_CELL, "minItems": 6, "maxItems": 6},
]
SixEntries: TypeAlias = Annotated[
    PlacementModel,
    BeforeValidator(placement_by_name),
    WithJsonSchema(
        {
            "description": "Trans(x, y, z) Rot_z(a) Rot_y(b) Rot_x(c): an object (left out means 0), "
            "or the list [X, Y, Z, A, B, C]",
            "anyOf": PLACEMENT_SHAPES,
        }
    ),
]


class ScmChainModel(Wire):
    """A serial arm by the SCM method."""

    joints: list[SixEntries] = Field(
        min_length=1,
        max_length=LONGEST_LIST,
        description="one row a joint; one entry of row i holds its variable, qi (or ai, di), with its sign",
    )
    final: SixEntries = Field(default_factory=PlacementModel, description="the Final Transformation")
    tool: SixEntries = Field(default_factory=PlacementModel, description="the tool")
    angle_unit: OneOf[AngleUnit] = Field(
        AngleUnit.RAD, description="unit of every angle: chain, joints, parameters and answer"
    )
    length_unit: OneOf[LengthUnit] = Field(
        LengthUnit.M, description="unit of every length: chain, joints, parameters and answer"
    )

    def raw(self) -> RawChain:
        """Return the chain as the cell grammar reads it."""
        return RawChain(
            joints=tuple(row.cells() for row in self.joints),
            final=self.final.cells(),
            tool=self.tool.cells(),
            angle_unit=self.angle_unit,
            length_unit=self.length_unit,
        )

    def place(self, where: tuple[str | int, ...]) -> tuple[str | int, ...]:
        """Return the place of an entry in what was sent: by its number where the row is a list."""
        match where:
            case ("joints", int(i), str(entry)):
                row = self.joints[i]
            case ("final" | "tool" as name, str(entry)):
                row = getattr(self, name)
            case _:
                return where
        return (*where[:-1], ENTRIES.index(entry)) if isinstance(row, ListedPlacement) else where


class Verification(StrEnum):
    """What becomes of a chain that does not pass the document's input check.

    strict: it is refused, with every reason. off: it is computed with all the same.
    """

    STRICT = "strict"
    OFF = "off"


class ChainQuestion(Wire):
    """Base of the calls that take a chain: exactly one of `chain` and `robot`."""

    model_config = forbidding(*not_one_of("chain", "robot"))

    chain: ScmChainModel | None = Field(None, description="the arm as an SCM chain")
    robot: str | None = Field(None, max_length=64, description="or the id of a robot of the catalogue")
    parameters: Parameters = Field(default_factory=dict)
    verify: OneOf[Verification] = Field(
        Verification.STRICT, description="strict refuses a chain that breaks the method's rules; off does not"
    )

    @model_validator(mode="after")
    def _one_chain(self) -> Self:
        if (self.chain is None) == (self.robot is None):
            raise PydanticCustomError("chain_or_robot", "give either chain or robot, exactly one of them")
        return self


ScmJoints: TypeAlias = Annotated[
    list[Real], Field(max_length=LONGEST_LIST, description="q_1 … q_n, in the chain's units")
]
