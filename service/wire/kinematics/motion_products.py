"""Products of motions as the wire shows them: what a worker process computes."""

from dataclasses import dataclass
from typing import Any

from kinematics.errors import Fault, ParameterError, PoseError
from kinematics.expressions import Expression
from kinematics.poses import pose_notations
from kinematics.printing import Format, Notation, Purpose
from kinematics.scm.chain import Placement
from kinematics.scm.product_reading import ReadProducts
from kinematics.scm.products import (
    check_rotations,
    compare_matrices,
    jacobian_of_product,
    matrix_in_numbers,
    matrix_with_values,
    names_left,
    product_of,
)
from kinematics.se3 import check_transform
from kinematics.symbolic import Matrix
from service.schemas.tables import units_of
from service.wire.kinematics.symbolic_forms import JACOBIANS, Writing


@dataclass(frozen=True, kw_only=True, slots=True)
class ProductsTask:
    """Products to be formed, compared and written.

    Joint values are in [rad] and length units.
    """

    read: ReadProducts
    values: dict[str, Expression]
    joints: tuple[float, ...] | None
    jacobian: bool
    formats: tuple[Format, ...]
    notation: Notation


def written_products(task: ProductsTask) -> bytes:
    """Return the products in the wanted formats, their values and which are equal, as JSON.

    Raises:
        DescriptionError: a Jacobian is wanted of what has none.
        FormSizeError: a matrix has too many operations to be written out.
        ParameterError: an entry has no value.
    """
    read = task.read
    try:
        matrices = [matrix_with_values(product_of(factors), task.values) for factors in read.products]
    except ZeroDivisionError:
        raise ParameterError(Fault.at("value_undefined", "parameters")) from None
    if task.jacobian:
        for i, factors in enumerate(read.products):
            valued = (f if isinstance(f, Placement) else matrix_with_values(f, task.values) for f in factors)
            check_rotations(list(valued), i)
    left = {name for matrix in matrices for name in names_left(matrix)[0]}
    parameters = tuple(name for name in read.parameters if name in left)
    writing = Writing(task.formats, task.notation, read.n_joints, parameters, read.variables)

    def write(matrix: Matrix, name: str, meaning: str) -> dict[str, Any]:
        return writing.matrix(matrix, Purpose(name=name, meaning=meaning))

    products = []
    for i, matrix in enumerate(matrices, start=1):
        product: dict[str, Any] = {"transform": write(matrix, f"product_{i}", f"Product {i} of motions.")}
        if task.jacobian:
            for frame, name in JACOBIANS.items():
                J = jacobian_of_product(matrix, read.n_joints, frame)
                product[name] = write(J, f"{name}_{i}", f"Jacobian {name} of product {i}, linear rows first.")
        products.append(product | _numbers(matrix, task))
    return writing.answer(
        **units_of(read),
        variables=list(read.variables),
        parameters=list(parameters),
        products=products,
        equal_to_first=[compare_matrices(matrices[0], matrix).value for matrix in matrices],
    )


def _numbers(matrix: Matrix, task: ProductsTask) -> dict[str, Any]:
    """The values of a matrix, if all that stands in it has one, and its frame."""
    parameters, variables = names_left(matrix)
    if parameters or (variables and task.joints is None):
        return {}
    values = matrix_in_numbers(matrix, task.joints or ())
    try:
        check_transform(values)
    except PoseError:
        return {"numbers": values.tolist()}
    xyzabc, unit = pose_notations(values).xyzabc, task.read.angle_unit.radians
    return {"numbers": values.tolist(), "xyzabc": [*xyzabc[:3], *(angle / unit for angle in xyzabc[3:])]}
