"""Elementary motions as rows of a modified DH table, and joining rows to as few as possible."""

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction

from kinematics.expressions import ZERO, Expression, add, negate, pi_fraction, pi_times
from kinematics.scm.chain import Placement
from kinematics.table import DHRow, JointType, SymbolicRow

RIGHT_ANGLE = pi_times(Fraction(1, 2))


def constant_row(
    *, alpha: Expression = ZERO, a: Expression = ZERO, d: Expression = ZERO, theta: Expression = ZERO
) -> SymbolicRow:
    """Return a row without a joint."""
    return DHRow(joint=JointType.FIXED, alpha=alpha, a=a, d=d, theta=theta)


def turn_rows(turn: Placement) -> list[SymbolicRow]:
    """Return Rot_z(A) Rot_y(B) Rot_x(C) as rows; Rot_y(B) = Rot_z(π/2) Rot_x(B) Rot_z(-π/2)."""
    rows = [constant_row(theta=turn.a)] if turn.a != ZERO else []
    if turn.b != ZERO:
        rows += [constant_row(theta=RIGHT_ANGLE), constant_row(alpha=turn.b, theta=negate(RIGHT_ANGLE))]
    if turn.c != ZERO:
        rows.append(constant_row(alpha=turn.c))
    return rows


def shift_rows(shift: Placement) -> list[SymbolicRow]:
    """Return Trans(x, y, z) as rows; Trans_y(y) = Rot_z(π/2) Trans_x(y) Rot_z(-π/2)."""
    rows = [constant_row(a=shift.x)] if shift.x != ZERO else []
    if shift.y != ZERO:
        rows += [constant_row(theta=RIGHT_ANGLE), constant_row(a=shift.y, theta=negate(RIGHT_ANGLE))]
    if shift.z != ZERO:
        rows.append(constant_row(d=shift.z))
    return rows


def appended(rows: list[SymbolicRow], row: SymbolicRow) -> list[SymbolicRow]:
    """Return the rows with one more behind them.

    A last row that only turns and shifts along x flows into it.
    """
    last = rows[-1] if rows else row
    if rows and last.joint is JointType.FIXED and last.theta == last.d == ZERO:
        rows = rows[:-1]
        row = replace(row, a=add((last.a, row.a)), alpha=principal(add((last.alpha, row.alpha))))
    return [*rows, row]


def joined(rows: list[SymbolicRow], more: Iterable[SymbolicRow]) -> list[SymbolicRow]:
    """Return the rows with fixed rows behind them; those without a and α flow into the row before."""
    result = list(rows)
    for row in more:
        if row.a == ZERO and row.alpha == ZERO and result:
            last = result[-1]
            result[-1] = replace(last, theta=principal(add((last.theta, row.theta))), d=add((last.d, row.d)))
        else:
            result = appended(result, row)
    return result


def principal(angle: Expression) -> Expression:
    """Return an exact angle brought into (-π, π]."""
    half_turns = pi_fraction(angle)
    return angle if half_turns is None else pi_times(1 - (1 - half_turns) % 2)
