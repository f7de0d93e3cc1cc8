"""A DH table as a product of elementary motions about and along x and z."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum

from kinematics.expressions import ZERO, Expression
from kinematics.table import Convention, JointType, SymbolicRow, SymbolicTable


class Kind(StrEnum):
    """Rotation about, or translation along, an axis of the moving frame."""

    ROTATE_Z = "Rz"
    SLIDE_Z = "Tz"
    ROTATE_X = "Rx"
    SLIDE_X = "Tx"


@dataclass(frozen=True, slots=True)
class Motion:
    """One factor of the product.

    Attributes:
        kind: what moves.
        amount: constant angle [rad] or distance; 0 of a joint, whose offset is a factor of its own.
        joint: number of the joint, from 1; 0 of a constant motion.
        sign: the sign with which the joint variable enters.
    """

    kind: Kind
    amount: Expression = ZERO
    joint: int = 0
    sign: int = 1


def motions_of(table: SymbolicTable) -> list[list[Motion]]:
    """The factors of each row, in the order of the product; those that do nothing are left out.

    standard:  Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha)
    modified:  Rot_x(alpha) Trans_x(a) Rot_z(theta) Trans_z(d)

    Source: seed 000 eq. 3.2 (modified); seed 003 eq. 2 (standard).
    """
    joint = 0
    rows = []
    for row in table.rows:
        joint += row.joint is not JointType.FIXED
        rows.append(list(_row_motions(row, table.convention, joint)))
    return rows


def _row_motions(row: SymbolicRow, convention: Convention, joint: int) -> Iterator[Motion]:
    about_z = (
        *_constant(Kind.ROTATE_Z, row.theta),
        *((Motion(Kind.ROTATE_Z, joint=joint, sign=row.sign),) if row.joint is JointType.REVOLUTE else ()),
        *((Motion(Kind.SLIDE_Z, joint=joint, sign=row.sign),) if row.joint is JointType.PRISMATIC else ()),
        *_constant(Kind.SLIDE_Z, row.d),
    )
    if convention is Convention.STANDARD:
        yield from about_z
        yield from _constant(Kind.SLIDE_X, row.a)
        yield from _constant(Kind.ROTATE_X, row.alpha)
    else:
        yield from _constant(Kind.ROTATE_X, row.alpha)
        yield from _constant(Kind.SLIDE_X, row.a)
        yield from about_z


def _constant(kind: Kind, amount: Expression) -> tuple[Motion, ...]:
    return () if amount == ZERO else (Motion(kind, amount),)
