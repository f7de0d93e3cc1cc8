"""The Jacobian by differentiating the matrix of direct kinematics (H2J), in symbols and in numbers.

Another way to the same columns as inspection (`motion`, `closed_form`): the two check each other.
"""

from collections.abc import Mapping, Sequence
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from kinematics.expressions import (
    MINUS_ONE,
    ONE,
    ZERO,
    Call,
    Expression,
    Function,
    JointVariable,
    Power,
    Product,
    Sum,
    add,
    call,
    joint_variables_in,
    multiply,
    number,
    power,
)
from kinematics.jacobian import JacobianFrame
from kinematics.scm.chain import ScmChain
from kinematics.scm.motion import forward_kinematics_scm, row_derivative

Matrix: TypeAlias = Sequence[Sequence[Expression]]


def derivative(expression: Expression, joint: int) -> Expression:
    """Return ∂/∂q_joint of an expression in sines, cosines, products and sums of joint variables.

    Raises:
        ValueError: a joint variable stands in a function other than sine and cosine; no transform has one.
    """
    if joint not in joint_variables_in(expression):
        return ZERO
    match expression:
        case JointVariable():
            return ONE
        case Sum(terms):
            return add(derivative(term, joint) for term in terms)
        case Product(factors):
            return add(
                multiply((*factors[:i], derivative(factor, joint), *factors[i + 1 :]))
                for i, factor in enumerate(factors)
            )
        case Power(base, exponent):
            return multiply((number(exponent), power(base, exponent - 1), derivative(base, joint)))
        case Call(Function.SIN, (angle,)):
            return multiply((call(Function.COS, angle), derivative(angle, joint)))
        case Call(Function.COS, (angle,)):
            return multiply((MINUS_ONE, call(Function.SIN, angle), derivative(angle, joint)))
    raise ValueError(f"no derivative of {type(expression).__name__} is needed for a transform")


def jacobian_by_differentiation(
    transform: Matrix, n_joints: int, frame: JacobianFrame = JacobianFrame.BASE
) -> tuple[tuple[Expression, ...], ...]:
    """Return J0 or Jn from the matrix of direct kinematics: v = ∂p/∂q, and ω from the skew matrix (∂R/∂q) Rᵀ.

    Args:
        transform: 4×4 pose of the end frame in closed form.
        frame: whose axes the velocities are written in; in those of the end frame v becomes Rᵀv, ω Rᵀω.

    Returns:
        (6, n) velocity above, angular velocity below; not simplified.

    Raises:
        ValueError: an entry isn't one of a transform.

    Source: seed 001 eq. 3.19 and 3.24.
    """
    R = [row[:3] for row in transform[:3]]
    columns = [_column(transform, R, joint, frame) for joint in range(1, n_joints + 1)]
    return tuple(tuple(column[i] for column in columns) for i in range(6))


def _column(transform: Matrix, R: Matrix, joint: int, frame: JacobianFrame) -> tuple[Expression, ...]:
    velocity = [derivative(transform[i][3], joint) for i in range(3)]
    turning = [[derivative(R[i][k], joint) for k in range(3)] for i in range(3)]

    def skew(i: int, j: int) -> Expression:
        return add(multiply((turning[i][k], R[j][k])) for k in range(3))

    spin = [skew(2, 1), skew(0, 2), skew(1, 0)]
    if frame is JacobianFrame.END:
        velocity, spin = _in_end_frame(R, velocity), _in_end_frame(R, spin)
    return (*velocity, *spin)


def _in_end_frame(R: Matrix, vector: Sequence[Expression]) -> list[Expression]:
    return [add(multiply((R[k][i], vector[k])) for k in range(3)) for i in range(3)]


def jacobian_numbers_by_differentiation(
    chain: ScmChain,
    joints: Sequence[float],
    parameters: Mapping[str, float] | None = None,
    frame: JacobianFrame = JacobianFrame.BASE,
) -> NDArray[np.float64]:
    """Return J0 or Jn in numbers.

    ∂H/∂q_i = H_1 ⋯ (∂H_i/∂q_i) ⋯ H_n · FT, v = ∂p/∂q_i, and ω from (∂R/∂q_i) Rᵀ.

    Args:
        chain: the chain; it need not pass `verify`.
        joints: (n,) joint variables [rad, or m of a prismatic joint].
        parameters: value of every parameter [m or rad].
        frame: whose axes the velocities are written in.

    Returns:
        (6, n): velocity above, angular velocity below.

    Raises:
        JointValueError: not n finite values, or a result that overflows.
        ParameterError: a parameter has no value.

    Source: seed 001 eq. 3.19 and 3.24.
    """
    values = parameters or {}
    motion = forward_kinematics_scm(chain, joints, values)
    R = motion.transform[:3, :3]
    behind = motion.end
    columns: list[NDArray[np.float64]] = []
    for i in reversed(range(chain.n_joints)):
        before = motion.frames[i - 1] if i else np.eye(4)
        change = before @ row_derivative(chain.rows[i], joints[i], values) @ behind
        spin = change[:3, :3] @ R.T
        column = np.array([change[:3, 3], [spin[2, 1], spin[0, 2], spin[1, 0]]])
        columns.append((column if frame is JacobianFrame.BASE else column @ R).ravel())
        behind = motion.links[i] @ behind
    return np.stack(columns[::-1], axis=1)
