"""Any chain as a modified DH table, motion by motion.

`dh` derives the table that a person would write, and asks for a chain that passes `verify`. Here every
elementary motion becomes a row or a part of one, so chains that turn by constants between their joints have a
table too. It has more rows than needed, but it moves as the chain does.
"""

from dataclasses import replace

from kinematics.expressions import ZERO, Expression, negate
from kinematics.scm.chain import ChainRow, Entry, Placement, ScmChain, verify
from kinematics.scm.dh import modified_dh_from_scm
from kinematics.scm.rows import RIGHT_ANGLE, appended, constant_row, joined, shift_rows, turn_rows
from kinematics.table import Convention, DHRow, DHTable, JointType, SymbolicRow, SymbolicTable


def table_of_chain(chain: ScmChain) -> SymbolicTable:
    """Return a modified DH table that moves as the chain.

    It is derived where `verify` passes, else made motion by motion.
    """
    return unrolled_dh_from_scm(chain) if verify(chain) else modified_dh_from_scm(chain)


def unrolled_dh_from_scm(chain: ScmChain) -> SymbolicTable:
    """Return the modified DH table made of the elementary motions of a chain, of whatever form.

    Where B varies, Rot_y(B) = Rot_x(-π/2) Rot_z(B) Rot_x(π/2), and likewise about and along x.

    Source: seed 001 eq. 2.4.
    """
    rows: list[SymbolicRow] = []
    for row in chain.rows:
        rows = _with_row(rows, row)
    for end in (chain.final, chain.tool):
        rows = joined(rows, [*shift_rows(end), *turn_rows(end)])
    return DHTable(convention=Convention.MODIFIED, rows=tuple(rows))


def _with_row(rows: list[SymbolicRow], row: ChainRow) -> list[SymbolicRow]:
    before, after = _split(row)
    offset = row.constant.entry(row.variable)
    turn_to_axis, turn_back = _about_axis(row.variable)
    rows = joined(rows, [*shift_rows(before), *turn_rows(before), *turn_to_axis])
    rows = appended(rows, _joint_row(row, offset))
    return joined(rows, [*turn_back, *shift_rows(after), *turn_rows(after)])


def _joint_row(row: ChainRow, offset: Expression) -> SymbolicRow:
    if row.joint is JointType.REVOLUTE:
        return DHRow(joint=row.joint, sign=row.sign, alpha=ZERO, a=ZERO, d=ZERO, theta=offset)
    return DHRow(joint=row.joint, sign=row.sign, alpha=ZERO, a=ZERO, d=offset, theta=ZERO)


def _split(row: ChainRow) -> tuple[Placement, Placement]:
    """The constant motions before and after the variable one; translations commute, so all come before."""
    order = (Entry.A, Entry.B, Entry.C)
    constant = replace(row.constant, **{row.variable.value: ZERO})
    if not row.variable.is_turn:
        return replace(constant, a=ZERO, b=ZERO, c=ZERO), replace(constant, x=ZERO, y=ZERO, z=ZERO)
    at = order.index(row.variable)
    later = {entry.value: ZERO for entry in order[at:]}
    earlier = {entry.value: ZERO for entry in order[:at]} | dict.fromkeys("xyz", ZERO)
    return replace(constant, **later), replace(constant, **earlier)


def _about_axis(entry: Entry) -> tuple[list[SymbolicRow], list[SymbolicRow]]:
    """Rows that turn z onto the entry's axis, and back."""
    if entry.axis == 2:
        return [], []
    if entry.axis == 1:
        return [constant_row(alpha=negate(RIGHT_ANGLE))], [constant_row(alpha=RIGHT_ANGLE)]
    return turn_rows(Placement(b=RIGHT_ANGLE)), turn_rows(Placement(b=negate(RIGHT_ANGLE)))
