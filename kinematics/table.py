"""The DH table: conventions, joint types, rows.

A table exists twice: with exact entries in parameters (`SymbolicTable`, what a person writes) and with
numbers (`NumericTable`, what is computed with). `bind` leads from the first to the second.

Angles are in radians. Lengths are in one unit throughout a table (metres unless the caller chose another):
nothing in this package depends on which one it is, and results come out in the same unit.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property
from typing import Generic, TypeAlias, TypeVar

from kinematics.expressions import Expression, evaluate_each, parameters_in

Entry = TypeVar("Entry", float, Expression)

CELLS = ("alpha", "a", "d", "theta")
ANGLES, LENGTHS = ("alpha", "theta"), ("a", "d")


class Convention(StrEnum):
    """Which four elementary motions make a link, and in which order.

    STANDARD: A_i = Rot_z(θ_i) Trans_z(d_i) Trans_x(a_i) Rot_x(α_i); joint i moves about or along z_{i-1}.
    MODIFIED: A_i = Rot_x(α_{i-1}) Trans_x(a_{i-1}) Rot_z(θ_i) Trans_z(d_i); joint i moves about or along z_i.
    """

    STANDARD = "standard"
    MODIFIED = "modified"

    @property
    def other(self) -> "Convention":
        """The other of the two."""
        return Convention.MODIFIED if self is Convention.STANDARD else Convention.STANDARD


COLUMNS = {
    Convention.STANDARD: ("theta", "d", "a", "alpha"),
    Convention.MODIFIED: ("alpha", "a", "d", "theta"),
}
"""The cells in the order in which textbooks print the columns of each convention."""


class JointType(StrEnum):
    """What varies in a row: θ (revolute), d (prismatic) or nothing (fixed)."""

    REVOLUTE = "revolute"
    PRISMATIC = "prismatic"
    FIXED = "fixed"


VARIABLE_CELLS = {JointType.REVOLUTE: "theta", JointType.PRISMATIC: "d"}
"""The cell that holds the joint variable; a fixed row has none."""


@dataclass(frozen=True, kw_only=True, slots=True)
class DHRow(Generic[Entry]):
    """One row of a DH table.

    Attributes:
        theta: joint angle θ [rad]; in a revolute row the offset, θ = sign·q + theta.
        d: link offset [m]; in a prismatic row the offset, d = sign·q + d.
        a: link length [m] (of link i-1 in a modified table).
        alpha: link twist [rad] (of link i-1 in a modified table).
        sign: +1, or -1 if the joint variable enters with a minus sign.
    """

    joint: JointType
    theta: Entry
    d: Entry
    a: Entry
    alpha: Entry
    sign: int = 1


@dataclass(frozen=True, kw_only=True)
class DHTable(Generic[Entry]):
    """A DH table: a convention and its rows, base first. Fixed rows may stand anywhere.

    Attributes:
        convention: how each row is read.
        rows: the rows, base first.
    """

    convention: Convention
    rows: tuple[DHRow[Entry], ...]

    def __hash__(self) -> int:
        return self._hash

    @cached_property
    def _hash(self) -> int:
        """Computed once: a table is what most caches look results up by."""
        return hash((self.convention, self.rows))

    @cached_property
    def joint_rows(self) -> tuple[int, ...]:
        """For joint 1 … n the index of its row, counted from 0."""
        return tuple(i for i, row in enumerate(self.rows) if row.joint is not JointType.FIXED)

    @cached_property
    def joint_types(self) -> tuple[JointType, ...]:
        """Types of joint 1 … n, fixed rows not counted."""
        return tuple(row.joint for row in self.rows if row.joint is not JointType.FIXED)

    @cached_property
    def axis_frames(self) -> tuple[int, ...]:
        """For each joint the frame whose z is its axis: row i's i-1 (standard) or i (modified)."""
        behind = self.convention is Convention.MODIFIED
        return tuple(i + behind for i in self.joint_rows)

    @property
    def n_joints(self) -> int:
        """Number of joint variables."""
        return len(self.joint_types)

    def _repr_html_(self) -> str:
        from kinematics.printing.table_markup import table_html  # a notebook asks, and nobody else

        return table_html(self)

    def _repr_latex_(self) -> str:
        from kinematics.printing.table_markup import table_latex

        return table_latex(self)


NumericRow: TypeAlias = DHRow[float]
NumericTable: TypeAlias = DHTable[float]
SymbolicRow: TypeAlias = DHRow[Expression]
SymbolicTable: TypeAlias = DHTable[Expression]


def table_parameters(table: SymbolicTable) -> tuple[str, ...]:
    """Return the names of the parameters of a table, in order of first appearance."""
    names: dict[str, None] = {}
    for row in table.rows:
        for cell in CELLS:
            names.update(dict.fromkeys(sorted(parameters_in(getattr(row, cell)))))
    return tuple(names)


def bind(table: SymbolicTable, parameters: Mapping[str, float] | None = None) -> NumericTable:
    """Return the table with a number in every cell.

    Args:
        table: entries exact, possibly with parameters.
        parameters: value of every parameter [m or rad]; names that are not in the table are ignored.

    Raises:
        ParameterError: a parameter has no value, or a cell has no finite value; all faults at once, each
            at ("parameters", name) or at ("rows", i, cell).
    """
    cells = ((("rows", i, cell), getattr(row, cell)) for i, row in enumerate(table.rows) for cell in CELLS)
    values = iter(evaluate_each(cells, parameters))
    rows = (
        DHRow(joint=row.joint, sign=row.sign, **dict(zip(CELLS, values, strict=False))) for row in table.rows
    )
    return DHTable(convention=table.convention, rows=tuple(rows))
