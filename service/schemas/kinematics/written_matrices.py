"""Matrices in closed form on the wire: what every call says that writes them."""

from typing import Annotated, Any, TypeAlias

from pydantic import ConfigDict, Field

from kinematics.printing import SOURCES, Format, Notation
from service.schemas.base import LONGEST_LIST, OneOf, Real, Wire
from service.schemas.kinematics.robot_question import PlacedRobotQuestion
from service.schemas.tables import Units

STANDARD_FORMATS = (Format.LATEX, Format.TEXT)
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


class WritingQuestion(PlacedRobotQuestion):
    """Base of the calls that write matrices: a robot, and how."""

    parameters: SomeParameters = Field(default_factory=dict)
    formats: Formats = Field(default_factory=lambda: list(STANDARD_FORMATS))
    notation: OneOf[Notation] = Field(Notation.FULL, description="full: cos(q2 + q3); short: c23")


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
