"""POST /symbolic on the wire."""

from __future__ import annotations

from typing import Annotated, Any, Literal, TypeAlias

from pydantic import ConfigDict, Field, RootModel

from kinematics.jacobian import JacobianFrame
from kinematics.printing import SOURCES, Format, Notation
from service.schemas.base import LONGEST_LIST, OneOf, Real, Wire
from service.schemas.examples import PUMA_560, TWO_LINKS
from service.schemas.kinematics.jacobian_request import JacobianAnswer, NumericJacobianRequest
from service.schemas.kinematics.orientations import RatesOfAngles
from service.schemas.kinematics.pose_input import PoseInput
from service.schemas.kinematics.robot_question import RobotQuestion
from service.schemas.tables import Units
from service.wire.kinematics.symbolic_forms import FormPart

STANDARD_FORMATS = (Format.LATEX, Format.TEXT)
STANDARD_PARTS = (FormPart.LINKS, FormPart.FRAMES, FormPart.TRANSFORM)

Formats: TypeAlias = Annotated[
    list[OneOf[Format]],
    Field(
        min_length=1,
        max_length=LONGEST_LIST,
        description="how matrices are written; latex and text if left out",
    ),
]
SomeParameters: TypeAlias = Annotated[
    dict[str, Real],
    Field(
        max_length=LONGEST_LIST,
        description="values for some of the table's parameters, in its units; the others stay symbols",
    ),
]


class WritingQuestion(RobotQuestion):
    """Base of the calls that write matrices: a robot, and how."""

    parameters: SomeParameters = Field(default_factory=dict)
    base: PoseInput | None = Field(None, description="pose of frame 0 in the world; the identity if left out")
    tool: PoseInput | None = Field(None, description="pose of the tool in frame N; the identity if left out")
    formats: Formats = Field(default_factory=lambda: list(STANDARD_FORMATS))
    notation: OneOf[Notation] = Field(Notation.FULL, description="full: cos(q2 + q3); short: c23")


class SymbolicRequest(WritingQuestion):
    """A robot whose closed form is wanted."""

    parts: list[OneOf[FormPart]] | None = Field(
        None,
        max_length=LONGEST_LIST,
        min_length=1,
        description="what is wanted; links, frames and transform if left out",
    )
    inverse: bool = Field(False, description="whether the inverse of the transform is wanted as well")
    jacobian: bool = Field(False, description="whether the Jacobians J0 and Jn are wanted as well")

    def wanted(self) -> tuple[FormPart, ...]:
        """Return what is wanted, in the order of the enumeration."""
        chosen = set(self.parts if self.parts is not None else STANDARD_PARTS)
        chosen |= {FormPart.INVERSE} if self.inverse else set()
        chosen |= {FormPart.JACOBIAN} if self.jacobian else set()
        return tuple(part for part in FormPart if part in chosen)


class SymbolicJacobianRequest(WritingQuestion):
    """A robot whose Jacobians are wanted in closed form: no joint values."""

    form: Literal["symbolic"] = Field(description="the word symbolic: closed forms, and no joint values")
    frame: OneOf[JacobianFrame] | None = Field(
        None, description="base for J0 alone, end for Jn alone; both if left out"
    )
    angles: RatesOfAngles | None = Field(
        None, description="whose rates `analytic` has, which is wanted as well; none if left out"
    )


def _with_sources(schema: dict[str, Any]) -> None:
    for chosen, description in SOURCES.items():
        schema["properties"][chosen.value] = {"type": "string", "description": description}


class WrittenEntry(Wire):
    """An entry of a matrix, or an intermediate that several of them hold."""

    name: str = Field(
        description="r11 … r33 and px, py, pz of a pose, J11 … of a Jacobian, g1 … of a column; k1 … before "
        "them"
    )
    text: str = Field(description="its value as an infix expression")
    latex: str = Field(description="the equation in LaTeX")


class WrittenMatrix(Wire):
    """A matrix in the formats that were asked for."""

    model_config = ConfigDict(populate_by_name=True, json_schema_extra=_with_sources)

    latex: str | None = Field(None, description="a bmatrix environment, without dollar signs")
    mathml: str | None = Field(None, description="one math element: presentation, annotated with content")
    text: list[list[str]] | None = Field(None, description="rows of infix expressions")
    json_: list[list[dict[str, Any]]] | None = Field(
        None, alias="json", description="rows of expression trees: a type, and what belongs to it"
    )
    entries: list[WrittenEntry] | None = Field(
        None, description="entry by entry, as books print it; what is repeated has a name of its own"
    )


class WrittenJacobians(Wire):
    """Jacobians, 6×n: three linear rows, three angular rows."""

    J0: WrittenMatrix | None = Field(None, description="in the axes of the world")
    Jn: WrittenMatrix | None = Field(None, description="in the axes of the end frame")


class WritingAnswer(Units):
    """What every answer with written matrices says.

    Angles stand in radians in the matrices and in the functions' arguments, whatever the table's angle unit:
    π/2 is a right angle.
    """

    variables: list[str] = Field(description="the joint variables as the table names them, in joint order")
    parameters: list[str] = Field(
        description="the parameters that are left; functions take them in this order"
    )
    notation: str = Field(description="full or short")
    symbols: dict[str, str] | None = Field(None, description="what the short names stand for")


class SymbolicAnswer(WritingAnswer):
    """Closed forms, nested from the last joint to the first, angles of parallel joints added."""

    operations: int | None = Field(None, description="operations in the transform, counted as written")
    links: list[WrittenMatrix] | None = Field(
        None, description="for each row the pose of frame i in frame i-1"
    )
    frames: list[WrittenMatrix] | None = Field(
        None, description="for each row the pose of frame i in the world, base included"
    )
    transform: WrittenMatrix | None = Field(None, description="⁰T_N, base and tool included")
    inverse: WrittenMatrix | None = Field(None, description="the inverse of the transform")
    jacobian: WrittenJacobians | None = None


class JacobianBody(RootModel[NumericJacobianRequest | SymbolicJacobianRequest]):
    """A question about Jacobians, in numbers or in closed form."""


class SymbolicJacobianAnswer(WritingAnswer, WrittenJacobians):
    """Jacobians in closed form."""

    analytic: WrittenMatrix | None = Field(
        None,
        description="rates of x, y, z and of `angles`, if these were named; null where the first and the "
        "last turn about one line in every configuration",
    )


class JacobianReply(RootModel[JacobianAnswer | SymbolicJacobianAnswer]):
    """Jacobians in numbers or in closed form."""


PUMA_LENGTHS: dict[str, Any] = {
    **PUMA_560,
    "rows": [
        {**row, **cells}
        for row, cells in zip(
            PUMA_560["rows"],
            [{}, {"a": "a2"}, {"a": "a3", "d": "d3"}, {"d": "d4"}, {}, {}],
            strict=True,
        )
    ],
}

SYMBOLIC_JACOBIAN: dict[str, Any] = {
    "PUMA 560 in closed form, no joint values": {
        "form": "symbolic",
        "robot": "puma560",
        "notation": "short",
        "formats": ["latex", "text"],
    },
    "Stanford arm, rates of its wrist's angles": {
        "form": "symbolic",
        "robot": "stanford",
        "frame": "base",
        "angles": {"axes": "ZYZ"},
        "formats": ["text"],
    },
}

SYMBOLIC: dict[str, Any] = {
    "PUMA 560 with its lengths as symbols": {
        "table": PUMA_LENGTHS,
        "formats": ["latex", "text"],
        "notation": "short",
    },
    "two links as functions, one length given": {
        "table": TWO_LINKS,
        "parameters": {"L1": 0.4},
        "formats": ["python", "c", "matlab", "sympy"],
        "parts": ["transform"],
        "inverse": True,
        "jacobian": True,
    },
}
