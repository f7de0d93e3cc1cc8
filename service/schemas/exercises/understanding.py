"""POST /understand on the wire: what is made of a table while it is being typed."""

from typing import Annotated, Any

from pydantic import Field, WithJsonSchema

from kinematics.cells import ParameterKind
from kinematics.table import JointType
from service.schemas.base import LONGEST_LIST, FaultEntry, Listed, Matrix4, OneOf, Real, Wire
from service.schemas.tables import Row, Table

MOST_MATRICES = 66  # A link matrix for each of the rows that a table may have, and two poses.
MatrixRow = Annotated[list[Annotated[str, Field(max_length=2000)]], Field(min_length=4, max_length=4)]
MatrixCells = Annotated[list[MatrixRow], Field(min_length=4, max_length=4)]


TypedCell = Annotated[Any, WithJsonSchema({"description": "whatever stands in a cell that is being typed"})]


class TypedRow(Row):
    """One row of a table that is being typed."""

    alpha: TypedCell
    a: TypedCell
    d: TypedCell
    theta: TypedCell


class TypedTable(Table):
    """A table that is being typed: anything may stand in its cells yet, and it may have no rows."""

    rows: Listed[TypedRow] = Field(description="the rows so far, base first")  # type: ignore[assignment]


class UnderstandRequest(Wire):
    """A table, finished or not, and what values its parameters have so far."""

    table: TypedTable
    matrices: Annotated[list[MatrixCells], Field(max_length=MOST_MATRICES)] = Field(
        default_factory=list,
        description="4×4 matrices as they are typed, in the table's joint variables; empty cells are let be",
    )
    parameters: dict[str, Real] = Field(
        default_factory=dict,
        max_length=LONGEST_LIST,
        description="values of parameters, in the table's units; "
        "names that the table does not hold are ignored",
    )
    exercise: str | None = Field(
        None,
        max_length=64,
        description="id of the exercise that the table is typed for: names that it does not know are faults",
    )


class Meaning(Wire):
    """What a cell was understood as: angles in radians, lengths as they are."""

    mathml: str = Field(description="for a page: one math element")
    latex: str = Field(description="for a formula")
    text: str = Field(description="as a cell would accept it")
    value: float | None = Field(
        description="its number [rad or the table's length unit] with the joint variables at zero; "
        "null where a parameter in it has no value"
    )


class UnderstoodRow(Wire):
    """What was understood of a row; a cell that cannot be read is left out."""

    joint: OneOf[JointType]
    sign: int = Field(description="+1, or -1 where the joint variable enters reversed")
    variable: str | None = Field(description="the row's joint variable; null in a fixed row")
    alpha: Meaning | None = None
    a: Meaning | None = None
    d: Meaning | None = None
    theta: Meaning | None = None
    link: Matrix4 | None = Field(
        None,
        description="pose of frame i in frame i-1 with the joint at zero; left out where a cell has no value",
    )


class UnderstoodParameter(Wire):
    """A parameter of the table."""

    name: str
    kind: Annotated[ParameterKind, Field(strict=False, description="whether it is a length or an angle")]


class UnderstandAnswer(Wire):
    """What was understood, and what was not."""

    readable: bool = Field(description="the whole table could be read")
    rows: list[UnderstoodRow] = Field(description="row by row; empty if the rows do not form a table")
    parameters: list[UnderstoodParameter] = Field(description="in the order in which they stand in the table")
    matrices: list[list[list[Meaning | None]]] = Field(
        description="cell by cell; null where a cell is empty or cannot be read"
    )
    faults: list[FaultEntry] = Field(description="what cannot be read, each at its place in the request")
