"""Tables and given values as exact expressions: what closed forms start from."""

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from kinematics.cells import AngleUnit, ParameterKind, ReadTable, canonical_name, parameter_values
from kinematics.cells.exact import snapped
from kinematics.cells.substitution import with_values
from kinematics.expressions import Expression, pi_times
from kinematics.scm import ReadChain
from kinematics.scm.product_reading import ReadProducts
from kinematics.se3 import check_transform
from kinematics.symbolic.exact_poses import decimal, exact_pose
from kinematics.table import table_parameters
from service.http.problems import located
from service.schemas.kinematics.inverse_forms import SymbolicInverseRequest
from service.schemas.kinematics.robot_question import RobotQuestion
from service.schemas.kinematics.written_matrices import WritingQuestion
from service.schemas.tables import units_of
from service.settings import Settings
from service.wire.kinematics.pose_matrices import base_and_tool
from service.wire.kinematics.prepared_robots import listed_robot


def read_symbolic(question: RobotQuestion, settings: Settings) -> ReadTable:
    """Return the table of a question, cells as expressions.

    Raises:
        KinematicsError: the table cannot be read.
    """
    if question.table is None:
        return listed_robot(str(question.robot)).table
    return question.table.read(settings.cell_limits, "table")


def exact_question(question: WritingQuestion | SymbolicInverseRequest, settings: Settings) -> dict[str, Any]:
    """Return what every call says that derives and writes something of a robot: the fields of a `FormTask`.

    Raises:
        KinematicsError: the table cannot be read, a parameter does not fit it, or base or tool is no pose.
    """
    read = read_symbolic(question, settings)
    values = exact_values(read, question.parameters)
    with located("table"):
        table = with_values(read.table, values)
    base, tool = base_and_tool(question, read.angle_unit.radians)
    for name, matrix in (("base", base), ("tool", tool)):
        if matrix is not None:
            check_transform(matrix, where=(name,))
    return {
        "table": table,
        "variables": read.joint_names,
        "formats": tuple(dict.fromkeys(question.formats)),
        "notation": question.notation,
        "base": None if base is None else exact_pose(base),
        "tool": None if tool is None else exact_pose(tool),
        "head": {
            **units_of(read),
            "variables": list(read.joint_names),
            "parameters": list(table_parameters(table)),
            "notation": question.notation.value,
        },
    }


def exact_values(
    read: ReadTable | ReadChain | ReadProducts, given: Mapping[str, Any]
) -> dict[str, Expression]:
    """Return given values as exact expressions: decimals as typed, degrees as multiples of π.

    Raises:
        ParameterError: a value is not a finite number, or of a parameter that the robot does not have.
    """
    names = {name: canonical_name(name) for name in given}
    wanted = {name: kind for name, kind in read.parameters.items() if name in names.values()}
    parameter_values(wanted, read.angle_unit, given)
    values: dict[str, Expression] = {}
    for spelling, name in names.items():
        assert name is not None
        number = decimal(given[spelling])
        if wanted[name] is ParameterKind.LENGTH:
            values[name] = number
        elif read.angle_unit is AngleUnit.DEG:
            values[name] = pi_times(number.value / 180)
        else:
            values[name] = snapped(Fraction(number.value))
    return values
