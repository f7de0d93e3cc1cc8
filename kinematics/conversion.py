"""Standard to modified tables and back, without loss.

Write Z_i for the motion along and about z of row i (theta, d: it holds the joint) and X_i for the one along
and about x (a, alpha: constant). Then

    standard:  Z_1 X_1 Z_2 X_2 ⋯ Z_n X_n              modified:  X_0 Z_1 X_1 Z_2 ⋯ X_{n-1} Z_n

and the same mechanism is written in the other convention by pairing the same factors differently: a and alpha
move by one row. At one end a factor is left over, X_n behind the last modified row or X_0 before the first
standard row. It is a constant motion, so it becomes part of the tool or of the base. No row is lost or added,
every frame but the shifted ones keeps its joint variable and its zero, and entries are moved, never computed:
symbols stay symbols.
"""

from dataclasses import dataclass, replace
from typing import Any, Generic

from kinematics.dh import link_transform
from kinematics.expressions import ZERO, add
from kinematics.se3 import Transform
from kinematics.table import Convention, DHRow, DHTable, Entry, JointType


@dataclass(frozen=True, kw_only=True, slots=True)
class XScrew(Generic[Entry]):
    """The constant motion Trans_x(a) Rot_x(alpha) = Rot_x(alpha) Trans_x(a).

    Attributes:
        a: translation along x [m].
        alpha: rotation about x [rad].
    """

    a: Entry
    alpha: Entry


@dataclass(frozen=True, kw_only=True, slots=True)
class Conversion(Generic[Entry]):
    """A table in another convention: base · (its product) · tool is the old table's product, for every q.

    Base and tool are what stands before and behind the table; None for nothing.
    """

    table: DHTable[Entry]
    base: XScrew[Entry] | None
    tool: XScrew[Entry] | None


def convert(
    table: DHTable[Entry],
    to: Convention,
    *,
    base: XScrew[Entry] | None = None,
    tool: XScrew[Entry] | None = None,
) -> Conversion[Entry]:
    """Return a table in a convention.

    Args:
        table: the old table, numeric or symbolic; fixed rows and prismatic joints may stand anywhere.
        to: the convention wanted; the table's own leaves everything as it is.
        base: a motion before the old table, such as an earlier conversion left over.
        tool: a motion behind the old table, likewise. Where the new convention has room for it in its first
            or last row it goes there, so converting there and back gives back the very same table.

    Source: seed 001, eq. 2.13 and 2.14 and its DHCONV m2s, s2m, which here lose no row.
    """
    if to is table.convention or not table.rows:
        return Conversion(table=replace(table, convention=to), base=_or_none(base), tool=_or_none(tool))
    zero = _zero_like(table.rows[0].a)
    nothing = XScrew(a=zero, alpha=zero)
    between: list[XScrew[Entry]] = [XScrew(a=row.a, alpha=row.alpha) for row in table.rows]
    if to is Convention.MODIFIED:
        shifted = between[:-1]
        shifted.insert(0, base or nothing)
        base, tool = None, _joined(between[-1], tool)
    else:
        shifted = between[1:]
        shifted.append(tool or nothing)
        base, tool = _joined(between[0], base), None
    rows = tuple(
        replace(row, a=screw.a, alpha=screw.alpha) for row, screw in zip(table.rows, shifted, strict=True)
    )
    return Conversion(table=DHTable(convention=to, rows=rows), base=_or_none(base), tool=_or_none(tool))


def fixed_row(screw: XScrew[Entry]) -> DHRow[Entry]:
    """Return the fixed row that makes this motion, the same in both conventions."""
    zero = _zero_like(screw.a)
    return DHRow(joint=JointType.FIXED, theta=zero, d=zero, a=screw.a, alpha=screw.alpha)


def screw_transform(screw: XScrew[float] | None) -> Transform:
    """Return the motion as a (4, 4) transform; the identity of None."""
    return link_transform(fixed_row(screw or XScrew(a=0.0, alpha=0.0)), Convention.STANDARD)


def _joined(first: XScrew[Entry], second: XScrew[Entry] | None) -> XScrew[Entry]:
    """Product of two motions along x; they commute."""
    if second is None:
        return first
    return XScrew(a=_sum(first.a, second.a), alpha=_sum(first.alpha, second.alpha))


def _sum(left: Any, right: Any) -> Any:
    return left + right if isinstance(left, float | int) else add((left, right))


def _zero_like(entry: Any) -> Any:
    return 0.0 if isinstance(entry, float | int) else ZERO


def _or_none(screw: XScrew[Entry] | None) -> XScrew[Entry] | None:
    """None in place of a motion that does not move."""
    if screw is None:
        return None
    zero = _zero_like(screw.a)
    return None if screw.a == zero and screw.alpha == zero else screw
