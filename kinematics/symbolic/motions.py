"""A DH table as a product of elementary motions about and along x and z, with exact amounts."""

from dataclasses import dataclass

from kinematics.dh import CELL_MOTIONS, MOTIONS, MotionKind
from kinematics.expressions import ZERO, Expression
from kinematics.table import VARIABLE_CELLS, Convention, JointType, SymbolicRow, SymbolicTable


@dataclass(frozen=True, slots=True)
class Motion:
    """One factor of the product.

    Attributes:
        kind: what moves.
        amount: constant angle [rad] or distance; 0 of a joint, whose offset is a factor of its own.
        joint: number of the joint, from 1; 0 of a constant motion.
        sign: the sign with which the joint variable enters.
    """

    kind: MotionKind
    amount: Expression = ZERO
    joint: int = 0
    sign: int = 1


def motions_of(table: SymbolicTable) -> list[list[Motion]]:
    """Return the factors of each row, base side first; constant ones that do not move are left out."""
    joint = 0
    rows = []
    for row in table.rows:
        joint += row.joint is not JointType.FIXED
        rows.append(_row_motions(row, table.convention, joint))
    return rows


def _row_motions(row: SymbolicRow, convention: Convention, joint: int) -> list[Motion]:
    motions = []
    holds_variable = VARIABLE_CELLS.get(row.joint)
    for cell in MOTIONS[convention]:
        amount = getattr(row, cell)
        if amount != ZERO:
            motions.append(Motion(CELL_MOTIONS[cell], amount))
        if cell == holds_variable:
            motions.append(Motion(CELL_MOTIONS[cell], joint=joint, sign=row.sign))
    return motions
