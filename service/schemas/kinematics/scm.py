"""The SCM method on the wire: chains of [X Y Z A B C] rows, and what is asked of them."""

from __future__ import annotations

from enum import StrEnum
from typing import Annotated, Any, Self, TypeAlias

from pydantic import BeforeValidator, Field, WithJsonSchema, model_validator
from pydantic_core import PydanticCustomError

from kinematics.cells import AngleUnit, LengthUnit
from kinematics.printing import Format, Notation
from kinematics.scm import RawChain
from service.schemas.base import LONGEST_LIST, WHOLE, Matrix4, OneOf, Real, Vector3, Wire
from service.schemas.choices import forbidding, not_one_of
from service.schemas.kinematics.forward_kinematics import Orientation
from service.schemas.kinematics.pose_input import PoseInput
from service.schemas.tables import SHORT_CELL, Cell, Parameters, Units

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


SixEntries: TypeAlias = Annotated[
    PlacementModel,
    BeforeValidator(placement_by_name),
    WithJsonSchema(
        {
            "description": "Trans(x, y, z) Rot_z(a) Rot_y(b) Rot_x(c): an object (left out means 0), "
            "or the list [X, Y, Z, A, B, C]",
            "anyOf": [
                {
                    "type": "object",
                    "properties": dict.fromkeys(ENTRIES, SHORT_CELL),
                    "additionalProperties": False,
                },
                {"type": "array", "items": SHORT_CELL, "minItems": 6, "maxItems": 6},
            ],
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


class JacobianMethod(StrEnum):
    """How a Jacobian is formed: by columns (eq. 3.22, 3.23), or from the derivative of the matrix (3.24)."""

    INSPECTION = "inspection"
    DIFFERENTIATION = "differentiation"


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


class ClosedFormQuestion(ChainQuestion):
    """Base of the calls that answer in numbers where joints are given, in closed form where not.

    In closed form parameters without a value stay symbols.
    """

    joints: ScmJoints | None = Field(None, description="q_1 … q_n; left out, the answer is in closed form")
    formats: list[OneOf[Format]] | None = Field(
        None,
        max_length=LONGEST_LIST,
        min_length=1,
        description="of the closed form; text and latex if left out",
    )
    notation: OneOf[Notation] = Field(
        Notation.SHORT, description="of the closed form: short writes c23 (SCZIP), full cos(q2 + q3)"
    )


class ScmForwardKinematicsRequest(ClosedFormQuestion):
    """A chain, and joint values."""


class ScmInverseTransformRequest(ClosedFormQuestion):
    """A chain, and joint values."""


class ScmJacobianRequest(ClosedFormQuestion):
    """A chain, and joint values."""

    method: OneOf[JacobianMethod] = Field(
        JacobianMethod.INSPECTION,
        description="inspection (eq. 3.22, 3.23) or differentiation (eq. 3.24, H2J)",
    )


LimitPair: TypeAlias = Annotated[list[Real | None], Field(min_length=2, max_length=2)]


class ScmInverseKinematicsRequest(ChainQuestion):
    """A chain, and a pose to reach."""

    target: PoseInput
    limits: list[LimitPair | None] | None = Field(
        None, max_length=LONGEST_LIST, description="[low, high] of every joint, null where there is none"
    )
    start: ScmJoints | None = Field(
        None, description="joint values; the solution nearest to them comes first"
    )


class RandomConfigurationRequest(ChainQuestion):
    """A chain, and how many configurations are wanted."""

    limits: list[Annotated[list[Real], Field(min_length=2, max_length=2)] | None] | None = Field(
        None,
        max_length=LONGEST_LIST,
        description="[low, high] of every joint; null or left out: a full turn, and 0 to the sum of lengths",
    )
    count: Annotated[int, Field(ge=1, le=10_000), WHOLE] = Field(1, description="how many configurations")
    seed: Annotated[int, Field(ge=0, le=2**53), WHOLE] | None = Field(
        None, description="the same seed gives the same values"
    )


Forms: TypeAlias = Annotated[dict[str, Any], Field(description="one entry for each format, as in /symbolic")]


class ScmForwardKinematicsAnswer(Units):
    """Poses of a chain: in numbers, or in closed form where no joints were given."""

    variables: list[str] | None = Field(None, description="the joint variables of a closed form")
    transform: Matrix4 | Forms = Field(description="⁰H_FT: pose of the tool in frame 0")
    links: list[Forms] | list[Matrix4] = Field(description="H_i: pose of frame i in frame i-1, one a joint")
    frames: list[Forms] | list[Matrix4] = Field(description="pose of frame i in frame 0, one a joint")
    end: Matrix4 | Forms = Field(description="Final Transformation · tool, in the last joint's frame")
    orientation: Orientation | None = None
    symbols: dict[str, str] | None = Field(None, description="what the short names of a closed form mean")


class ScmInverseTransformAnswer(Units):
    """The inverse of direct kinematics."""

    variables: list[str] | None = Field(None, description="the joint variables of a closed form")
    transform: Matrix4 | Forms = Field(description="pose of frame 0 in the tool")
    symbols: dict[str, str] | None = Field(None, description="what the short names of a closed form mean")


class ScmJacobianAnswer(Units):
    """J0 and Jn: velocity of the tool above, its angular velocity below."""

    joint_unit: str = Field(
        "rad", description="per radian of a revolute joint, whatever the chain's angle unit"
    )
    method: JacobianMethod
    variables: list[str] | None = Field(None, description="the joint variables of a closed form")
    J0: list[list[Real]] | Forms = Field(description="6×n, in the axes of frame 0")
    Jn: list[list[Real]] | Forms = Field(description="6×n, in the axes of the tool")
    unit_vectors: list[Vector3] | None = Field(
        None,
        description="in numbers: u_1 … u_n (eq. 3.20, 3.21), along or about which joint i moves, each in the "
        "frame of its own row",
    )
    symbols: dict[str, str] | None = Field(None, description="what the short names of a closed form mean")


class RandomConfigurationAnswer(Units):
    """Joint values, drawn evenly within the limits."""

    joints: list[Real] = Field(description="the first configuration")
    configurations: list[list[Real]] = Field(description="all of them")
    limits: list[list[Real]] = Field(description="[low, high] of every joint, as used")
