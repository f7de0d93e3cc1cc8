"""The DH table on the wire."""

from typing import Annotated, Any, Literal, Protocol, TypeAlias

from pydantic import Field, WithJsonSchema

from kinematics.cells import AngleUnit, LengthUnit, Limits, RawRow, RawTable, ReadTable, read_table
from kinematics.table import Convention, JointType
from service.http.problems import located
from service.schemas.base import LONGEST_LIST, Listed, OneOf, Real, Wire

Cell: TypeAlias = Annotated[
    Any,
    WithJsonSchema(
        {
            "anyOf": [{"type": "number"}, {"type": "string", "minLength": 1}],
            "description": "a number or an expression",
        }
    ),
]
"""Checked by the cell grammar, which says of every cell at once what is wrong with it."""
SHORT_CELL = {"anyOf": [{"type": "number"}, {"type": "string", "minLength": 1, "maxLength": 200}]}
"""How the documentation of the API describes an entry of a matrix or of a placement."""


class Row(Wire):
    """One row of a DH table."""

    joint: OneOf[JointType] | None = Field(
        None, description="what varies; left out, it follows from the cell that holds the row's variable"
    )
    alpha: Cell = Field(description="link twist α_i, or α_{i-1} in a modified table")
    a: Cell = Field(description="link length a_i, or a_{i-1} in a modified table")
    d: Cell = Field(description="link offset d_i; in a prismatic row it holds the variable or the offset")
    theta: Cell = Field(description="joint angle θ_i; in a revolute row it holds the variable or the offset")


class TableHead(Wire):
    """What a table says before its rows."""

    convention: OneOf[Convention] = Field(description="standard (a_i, α_i) or modified (a_{i-1}, α_{i-1})")
    angle_unit: OneOf[AngleUnit] = Field(
        AngleUnit.RAD, description="unit of every angle: table, joints, parameters and answer"
    )
    length_unit: OneOf[LengthUnit] = Field(
        LengthUnit.M, description="unit of every length: table, joints, parameters and answer"
    )


class Table(TableHead):
    """A Denavit–Hartenberg table: a convention and its rows, base first."""

    rows: Listed[Row] = Field(
        json_schema_extra={"minItems": 1},
        description="the rows, base first; at least one, and 64 where nothing else is set",
    )

    def read(self, limits: Limits, *where: str | int) -> ReadTable:
        """Return what the table says, exact.

        Raises:
            KinematicsError: it cannot be read; every fault at its place below `where`.
        """
        with located(*where):
            return read_table(self.raw(), limits)

    def raw(self) -> RawTable:
        """Return the table as the cell grammar reads it."""
        return RawTable(
            convention=self.convention,
            rows=tuple(
                RawRow(joint=row.joint, alpha=row.alpha, a=row.a, d=row.d, theta=row.theta)
                for row in self.rows
            ),
            angle_unit=self.angle_unit,
            length_unit=self.length_unit,
        )


class AnsweredRow(Row):
    """One row of a DH table in an answer: it says what varies."""

    joint: OneOf[JointType] = Field(description="what varies")


class AnsweredTable(TableHead):
    """A Denavit–Hartenberg table in an answer."""

    rows: list[AnsweredRow] = Field(max_length=LONGEST_LIST, description="the rows, base first")


class Units(Wire):
    """The units of an answer: those of the request's table."""

    angle_unit: Literal["rad", "deg"] = Field(description="unit of every angle in this answer")
    length_unit: Literal["m", "cm", "mm", "in"] = Field(description="unit of every length in this answer")


class Measured(Protocol):
    """What has units: a table, a chain, products of motions, a question about them."""

    @property
    def angle_unit(self) -> AngleUnit:
        """Unit of its angles."""

    @property
    def length_unit(self) -> LengthUnit:
        """Unit of its lengths."""


def units_of(measured: Measured) -> dict[str, Any]:
    """Return the names of its units, as an answer states them."""
    return {"angle_unit": measured.angle_unit.value, "length_unit": measured.length_unit.value}


Parameters: TypeAlias = Annotated[
    dict[str, Real],
    Field(max_length=LONGEST_LIST, description="the value of every parameter in the table, in its units"),
]
