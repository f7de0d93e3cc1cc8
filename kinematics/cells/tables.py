"""A DH table as it is handed in, and as it is read."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from numbers import Integral, Rational, Real
from typing import TypeAlias

from kinematics.cells.units import AngleUnit, LengthUnit, ParameterKind
from kinematics.table import CELLS, Convention, JointType, SymbolicTable

Cell: TypeAlias = int | float | str
SHORTEST = 8
"""Characters that any cell counts for: of a number as much is remembered as of a text of this length."""


@dataclass(frozen=True, slots=True)
class NoCell:
    """What stood in the place of a cell and is none, such as a list."""

    kind: str


_CELL_TYPES = {int, float, str}


@dataclass(frozen=True, kw_only=True, slots=True)
class RawRow:
    """A row as handed in.

    Attributes:
        joint: the joint's type; None leaves it to the cells.
        alpha: link twist, in the table's angle unit.
        a: link length, in the table's length unit.
        d: link offset, in the table's length unit.
        theta: joint angle, in the table's angle unit.
    """

    joint: JointType | None = None
    alpha: Cell
    a: Cell
    d: Cell
    theta: Cell

    def __post_init__(self) -> None:
        if self.joint is not None:
            object.__setattr__(self, "joint", JointType(self.joint))
        # True equals 1: a wrong type is put aside before the table is looked up among those read before.
        if _CELL_TYPES.issuperset(map(type, (self.alpha, self.a, self.d, self.theta))):
            return
        for name in CELLS:
            object.__setattr__(self, name, as_cell(getattr(self, name)))


def as_cell(value: object) -> Cell | NoCell:
    """Return the value as a cell: a plain int, float or str; of any other type, what is said about it."""
    if type(value) in _CELL_TYPES:
        return value  # type: ignore[return-value]
    if isinstance(value, bool):
        return NoCell("true/false")
    if value is None:
        return NoCell("null")
    if isinstance(value, str):
        return str(value)
    if isinstance(value, Integral):
        return int(value)
    if isinstance(value, Real) and not isinstance(value, Rational):
        return float(value)
    return NoCell(type(value).__name__)


@dataclass(frozen=True, kw_only=True, eq=False)
class RawTable:
    """A DH table as handed in; two of them are equal if they hold the same.

    Attributes:
        convention: how each row is read.
        rows: the rows, base first.
        angle_unit: unit of plain numbers where an angle stands.

    A convention, units and types of joints may be given by their values, as "standard". That equals
    Convention.STANDARD: left as it is, it would stand in the place of that in what is read once for both.

    Raises:
        ValueError: there is no such convention or unit.
    """

    convention: Convention
    rows: tuple[RawRow, ...]
    angle_unit: AngleUnit = AngleUnit.RAD
    length_unit: LengthUnit = LengthUnit.M
    _length: int = field(init=False, repr=False)
    _content: tuple[object, ...] = field(init=False, repr=False)
    _hash: int = field(init=False, repr=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "rows", tuple(self.rows))
        object.__setattr__(self, "convention", Convention(self.convention))
        object.__setattr__(self, "angle_unit", AngleUnit(self.angle_unit))
        object.__setattr__(self, "length_unit", LengthUnit(self.length_unit))
        cells = [(row.joint, row.alpha, row.a, row.d, row.theta) for row in self.rows]
        content = (self.convention, self.angle_unit, self.length_unit, *cells)
        object.__setattr__(self, "_content", content)
        object.__setattr__(self, "_hash", hash(content))
        texts = [cell for row in cells for cell in row[1:] if type(cell) is str and len(cell) > SHORTEST]
        shortest = SHORTEST * len(CELLS) * len(cells)
        object.__setattr__(self, "_length", shortest + sum(map(len, texts)) - SHORTEST * len(texts))

    @property
    def length(self) -> int:
        """Length of its cells, at least `SHORTEST` each: what is read of them grows with it."""
        return self._length

    def __hash__(self) -> int:
        return self._hash

    def __eq__(self, other: object) -> bool:
        return isinstance(other, RawTable) and self._content == other._content


@dataclass(frozen=True, kw_only=True, eq=False)
class ReadTable:
    """A DH table, understood.

    Attributes:
        table: exact entries; angles in [rad], lengths in `length_unit`.
        angle_unit: the unit in which its angle parameters are given.
        length_unit: the unit of its lengths and length parameters.
        parameters: what each parameter measures, in the order in which they stand in the table; also of one
            that makes no difference, as in 0*x.
        variables: the names of the joint variables as typed (theta1, d3), in joint order; q_i where the table
            does not name the variable, numbers it by row, or has a parameter of that name. Empty if nobody
            typed them.
        last_places: units of the last place [rad or `length_unit`], by row and cell, of decimals whose value
            does not show it, such as 0.2100.
        typed_length: of the cells that it was read from, as in `RawTable`; 0 if nobody typed them.
        places: the row and cell in which each parameter stands first, of a table that was typed.
    """

    table: SymbolicTable
    angle_unit: AngleUnit
    length_unit: LengthUnit
    parameters: Mapping[str, ParameterKind]
    variables: tuple[str, ...] = ()
    last_places: Mapping[tuple[int, str], float] = field(default_factory=dict, repr=False)
    typed_length: int = field(default=0, repr=False)
    places: Mapping[str, tuple[int, str]] = field(default_factory=dict, repr=False)

    @property
    def length(self) -> int:
        """Length of its cells, typed or not, at least `SHORTEST` each."""
        return max(self.typed_length, SHORTEST * len(CELLS) * len(self.table.rows))

    @property
    def joint_names(self) -> tuple[str, ...]:
        """What the joint variables are called, typed or not."""
        return self.variables or tuple(f"q{joint}" for joint in range(1, self.table.n_joints + 1))

    def _repr_html_(self) -> str:
        from kinematics.printing.table_markup import table_html  # a notebook asks, and nobody else

        return table_html(self.table, self.variables)

    def _repr_latex_(self) -> str:
        from kinematics.printing.table_markup import table_latex

        return table_latex(self.table, self.variables)
