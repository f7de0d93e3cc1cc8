"""From a DH table to an SCM chain.

A row of a standard table is Rot_z(θ) Trans_z(d) Trans_x(a) Rot_x(α). Trans_z(d) commutes with the turn before
it and Trans_x(a) with the twist behind it, so a is carried into the next row:

    Trans(a_{i-1}, 0, d_i) Rot_z(θ_i) Rot_x(α_i)     is row i,   Trans_x(a_n) the Final Transformation.

Entries are moved, never computed: symbols stay symbols. Such a chain turns about a second axis where α is not
zero, so it need not pass `verify`.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from kinematics.chain import joint_constants
from kinematics.conversion import XScrew, convert
from kinematics.errors import Fault, TableError
from kinematics.expressions import ZERO, Expression, number
from kinematics.frames.exactness import exact_angle
from kinematics.poses import xyzabc_from_transform
from kinematics.scm.chain import ChainRow, Entry, Placement, ScmChain
from kinematics.se3 import Transform
from kinematics.table import Convention, JointType, NumericTable, SymbolicTable


@dataclass(frozen=True, kw_only=True, slots=True)
class DescribedScm:
    """A table as an SCM chain: base · (the chain's pose) is the table's pose, for every q.

    Attributes:
        base: what stands before it, where the table begins with a turn; None for nothing.
    """

    chain: ScmChain
    base: XScrew[Expression] | None


def scm_from_table(table: SymbolicTable) -> DescribedScm | None:
    """Return the SCM chain of a table entry by entry; None where fixed rows ask for `scm_from_numbers`.

    One fixed row behind the last joint goes into the Final Transformation and the tool.

    Raises:
        TableError: the table has no joints.
    """
    _check_joints(table.n_joints)
    if table.joint_rows != tuple(range(table.n_joints)) or table.n_joints + 1 < len(table.rows):
        return None
    converted = convert(table, Convention.STANDARD)
    base = converted.base
    carried: Expression = ZERO
    if base is not None and base.alpha == ZERO:
        carried, base = base.a, None
    rows = []
    for row in converted.table.rows[: table.n_joints]:
        constant = Placement(x=carried, z=row.d, a=row.theta, c=row.alpha)
        variable = Entry.Z if row.joint is JointType.PRISMATIC else Entry.A
        rows.append(ChainRow(constant=constant, variable=variable, sign=row.sign))
        carried = row.a
    final, tool = Placement(x=carried), Placement()
    if len(converted.table.rows) > table.n_joints:
        last = converted.table.rows[-1]
        final, tool = replace(final, z=last.d, a=last.theta), Placement(x=last.a, c=last.alpha)
    return DescribedScm(chain=ScmChain(rows=tuple(rows), final=final, tool=tool), base=base)


def with_tool(chain: ScmChain, tool: Transform) -> ScmChain | None:
    """Return the chain with a (4, 4) tool behind it; None if it has one already, and this is another one."""
    if np.array_equal(tool, np.eye(4)):
        return chain
    if chain.tool != Placement():
        return None
    return replace(chain, tool=_placement(xyzabc_from_transform(tool)))


def scm_from_numbers(
    table: NumericTable, base: Transform | None = None, tool: Transform | None = None
) -> tuple[Transform, ScmChain]:
    """Return the SCM chain of any table with joints in numbers, and what stands before it.

    With T = K_0 J_1(q_1) K_1 ⋯ J_n(q_n) K_n and K_i = (R_i, p_i), row i is Trans(R_{i-1}ᵀ p_{i-1}) J_i R_i.

    Args:
        table: the table; fixed rows may stand anywhere.
        base: (4, 4) pose of frame 0; the identity if left out.
        tool: (4, 4) pose of the tool in frame N; the identity if left out.

    Returns:
        The (4, 4) K_0, the rest of the constants being in the chain, and the chain.

    Raises:
        TableError: the table has no joints, or an entry is NaN or infinite.
    """
    _check_joints(table.n_joints)
    constants = joint_constants(table, base, tool)
    carried = np.zeros(3)
    rows = []
    for kind, constant in zip(table.joint_types, constants[1:], strict=True):
        turn = xyzabc_from_transform(constant)
        entries = (*carried.tolist(), turn.a, turn.b, turn.c)
        variable = Entry.Z if kind is JointType.PRISMATIC else Entry.A
        rows.append(ChainRow(constant=_placement(entries), variable=variable))
        carried = constant[:3, :3].T @ constant[:3, 3]
    return constants[0], ScmChain(rows=tuple(rows), final=_placement((*carried.tolist(), 0.0, 0.0, 0.0)))


def _check_joints(count: int) -> None:
    if not count:
        raise TableError(Fault.at("scm_chain_empty", "rows"))


def _placement(values: Sequence[float]) -> Placement:
    x, y, z = (number(repr(value + 0.0)) for value in values[:3])
    a, b, c = (exact_angle(value + 0.0) for value in values[3:])
    return Placement(x=x, y=y, z=z, a=a, b=b, c=c)
