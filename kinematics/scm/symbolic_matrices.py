"""The matrices of an SCM chain in closed form."""

from dataclasses import dataclass, replace
from typing import TypeAlias

from kinematics.expressions import MINUS_ONE, ONE, ZERO, Expression, JointVariable, add, multiply, negate
from kinematics.jacobian import JacobianFrame
from kinematics.scm.chain import ChainRow, Placement, ScmChain
from kinematics.scm.unrolled import table_of_chain
from kinematics.symbolic import Matrix, closed_form, inverse, jacobian
from kinematics.symbolic.angles import angle_of, cosine_and_sine

Rotation: TypeAlias = tuple[tuple[Expression, Expression, Expression], ...]


@dataclass(frozen=True, kw_only=True, slots=True)
class ScmClosedForm:
    """The transforms of an SCM chain, each a 4×4 matrix of expressions.

    Attributes:
        links: pose of frame i in frame i-1, one for each joint: the document's H_i.
        frames: pose of frame i in frame 0, one for each joint.
        end: pose of the tool in frame n: Final Transformation · Tool.
        transform: pose of the tool in frame 0.
    """

    links: tuple[Matrix, ...]
    frames: tuple[Matrix, ...]
    end: Matrix
    transform: Matrix


def closed_form_scm(chain: ScmChain) -> ScmClosedForm:
    """Return every matrix of a chain, in joint variables and parameters.

    Products are written as those of DH tables are (`kinematics.symbolic`), through the table that moves as
    the chain does; the links are written out from their definition.

    Source: seed 001 eq. 2.4 (links) and 3.1 (transform).
    """
    n = chain.n_joints
    arms = [replace(chain, rows=chain.rows[: i + 1], final=Placement(), tool=Placement()) for i in range(n)]
    return ScmClosedForm(
        links=tuple(link_matrix(row, i) for i, row in enumerate(chain.rows, start=1)),
        frames=tuple(closed_form(table_of_chain(arm)).transform for arm in arms),
        end=closed_form(table_of_chain(replace(chain, rows=()))).transform,
        transform=closed_form(table_of_chain(chain)).transform,
    )


def inverse_closed_form_scm(chain: ScmChain) -> Matrix:
    """Return the pose of frame 0 in the tool: the toolbox's (direct kinematics)^-1.

    Source: seed 001 eq. 2.6, 2.7.
    """
    return inverse(table_of_chain(chain))


def jacobian_closed_form_scm(chain: ScmChain, frame: JacobianFrame = JacobianFrame.BASE) -> Matrix:
    """Return J0 or Jn by inspection: columns [u × p; u] of a revolute and [u; 0] of a prismatic joint.

    Source: seed 001 eq. 3.22 and 3.23.
    """
    return jacobian(table_of_chain(chain), frame)


def link_matrix(row: ChainRow, number: int) -> Matrix:
    """Return H = Trans(x, y, z) Rot_z(A) Rot_y(B) Rot_x(C), the variable of the row being q_number.

    Source: seed 001 eq. 2.4.
    """
    variable = multiply((MINUS_ONE if row.sign < 0 else ONE, JointVariable(number)))
    moving = replace(row.constant, **{row.variable.value: add((variable, row.constant.entry(row.variable)))})
    p = (moving.x, moving.y, moving.z)
    R = _rotation(moving)
    return (*((*R[i], p[i]) for i in range(3)), (ZERO, ZERO, ZERO, ONE))


def _rotation(turn: Placement) -> Rotation:
    (ca, sa), (cb, sb), (cc, sc) = (cosine_and_sine(angle_of(angle)) for angle in (turn.a, turn.b, turn.c))
    return (
        (
            multiply((ca, cb)),
            add((multiply((ca, sb, sc)), negate(multiply((sa, cc))))),
            add((multiply((ca, sb, cc)), multiply((sa, sc)))),
        ),
        (
            multiply((sa, cb)),
            add((multiply((sa, sb, sc)), multiply((ca, cc)))),
            add((multiply((sa, sb, cc)), negate(multiply((ca, sc))))),
        ),
        (negate(sb), multiply((cb, sc)), multiply((cb, cc))),
    )
