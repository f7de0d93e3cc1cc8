"""Products of motions: elementary ones, frames, and matrices of one's own, in symbols.

HRX … HTZ are placements with one entry, GEO(F) is a placement, GEO(A, B) a product of two; H2J differentiates
a product, and two products are compared as functions of whatever stands in them.

Source: seed 001 §2, eq. 2.1 to 2.5 (motions), 2.10 to 2.12 (products), 3.24 (H2J), table 1 (the toolbox).
"""

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from kinematics.cells.substitution import substitute
from kinematics.dh import MotionKind
from kinematics.errors import DescriptionError, Fault, FormSizeError, ParameterError
from kinematics.expressions import ZERO, Expression, evaluate, joint_variables_in, negate, parameters_in
from kinematics.jacobian import JacobianFrame
from kinematics.scm.chain import Placement
from kinematics.scm.differentiation import jacobian_by_differentiation
from kinematics.scm.product_reading import IDENTITY, Factor
from kinematics.scm.rows import RIGHT_ANGLE
from kinematics.se3 import ORTHONORMAL_TOLERANCE
from kinematics.symbolic import Matrix, ProofStatus, compare
from kinematics.symbolic.motions import Motion
from kinematics.symbolic.runs import Runs
from kinematics.symbolic.shortening import shortened
from kinematics.symbolic.writing import MatrixWriter


def product_of(factors: Sequence[Factor]) -> Matrix:
    """Return the product of motions as a 4×4 matrix: neighbours about and along one axis are added.

    Source: seed 001 eq. 2.4 for a placement, 2.10 to 2.12 for neighbours.
    """
    product: Matrix | None = None
    motions: list[Motion] = []
    for factor in (*factors, IDENTITY):
        if isinstance(factor, Placement):
            motions += _motions(factor)
            continue
        writer = MatrixWriter(product)
        runs = Runs.of(writer.arena, motions).finished()
        writer.know(runs)
        product = writer.matrix(runs) if factor is IDENTITY else writer.matrix(runs, writer.read(factor))
        motions = []
    return IDENTITY if product is None else product


def compare_matrices(left: Matrix, right: Matrix) -> ProofStatus:
    """Return whether two matrices are the same function of their variables and parameters."""
    status = ProofStatus.PROVED
    for one, other in zip(left[:3], right[:3], strict=True):
        for a, b in zip(one, other, strict=True):
            try:
                found = compare(a, b)
            except (FormSizeError, ZeroDivisionError):
                found = ProofStatus.UNDECIDED
            if found is ProofStatus.REFUTED:
                return found
            status = found if found is ProofStatus.UNDECIDED else status
    return status


def jacobian_of_product(product: Matrix, n_joints: int, frame: JacobianFrame) -> Matrix:
    """Return J0 or Jn of any matrix of direct kinematics (H2J), each entry in the shortest form found.

    Raises:
        DescriptionError: a joint variable stands in a function of which no transform consists.

    Source: seed 001 eq. 3.19, 3.24.
    """
    try:
        J = jacobian_by_differentiation(product, n_joints, frame)
    except ValueError:
        raise DescriptionError(Fault.at("no_derivative", "products")) from None
    return shortened(J)


def check_rotations(factors: Sequence[Factor], product: int) -> None:
    """Make sure that velocities can be had of a product: the rotation parts of its matrices are rotations.

    Numbers are put in for the names, so that rounded entries pass as elsewhere. A part in parameters alone
    may be a rotation for values that satisfy conditions nobody has stated, and passes.

    Raises:
        DescriptionError: code `matrix_not_rotation`, at ("products", i, k).
    """
    faults = [
        Fault.at("matrix_not_rotation", "products", product, k)
        for k, factor in enumerate(factors)
        if not isinstance(factor, Placement) and not _may_rotate(factor)
    ]
    if faults:
        raise DescriptionError(faults)


def _may_rotate(matrix: Matrix) -> bool:
    part = tuple(row[:3] for row in matrix[:3])
    parameters, variables = names_left(part)
    if parameters and not variables:
        return True
    values = {name: 0.37 + 0.61 * i for i, name in enumerate(sorted(parameters))}
    joints = [0.83 + 0.47 * i for i in range(max(variables, default=0))]
    try:
        R = np.array([[float(evaluate(entry, values, joints)) for entry in row] for row in part])
    except ParameterError:
        return True
    return bool(np.abs(R @ R.T - np.eye(3)).max() <= ORTHONORMAL_TOLERANCE and np.linalg.det(R) > 0.0)


def names_left(matrix: Matrix) -> tuple[frozenset[str], frozenset[int]]:
    """Return the parameters and the numbers of the joint variables in a matrix."""
    entries = [entry for row in matrix for entry in row]
    return (
        frozenset().union(*map(parameters_in, entries)),
        frozenset().union(*map(joint_variables_in, entries)),
    )


def matrix_with_values(matrix: Matrix, values: Mapping[str, Expression]) -> Matrix:
    """Return a matrix with parameters replaced: S2D with some of the values.

    Raises:
        ZeroDivisionError: an entry now divides by zero.
    """
    return tuple(tuple(substitute(entry, values) for entry in row) for row in matrix)


def matrix_in_numbers(matrix: Matrix, joints: Sequence[float]) -> NDArray[np.float64]:
    """Return the (r, c) values of a matrix without parameters (S2D).

    Args:
        joints: q_1 … q_n [rad, or length units].

    Raises:
        ParameterError: an entry has no finite value there.
    """
    values = [[float(evaluate(entry, {}, joints)) for entry in row] for row in matrix]
    return np.array(values, dtype=np.float64) + 0.0


def _motions(placement: Placement) -> Iterator[Motion]:
    """Trans(x, y, z) Rot_z(A) Rot_y(B) Rot_x(C) as motions about and along x and z."""
    back = negate(RIGHT_ANGLE)
    yield Motion(MotionKind.SHIFT_X, placement.x)
    yield Motion(MotionKind.TURN_Z, RIGHT_ANGLE)
    yield Motion(MotionKind.SHIFT_X, placement.y)
    yield Motion(MotionKind.TURN_Z, back)
    yield Motion(MotionKind.SHIFT_Z, placement.z)
    yield Motion(MotionKind.TURN_Z, placement.a)
    if placement.b != ZERO:
        yield Motion(MotionKind.TURN_X, back)
        yield Motion(MotionKind.TURN_Z, placement.b)
        yield Motion(MotionKind.TURN_X, RIGHT_ANGLE)
    yield Motion(MotionKind.TURN_X, placement.c)
