"""Products of exponentials."""

from __future__ import annotations

from kinematics.inverse.lengths import check_lengths
from kinematics.screws import product_of_exponentials
from service.schemas.conversion import ConvertRequest, ProductAnswer, Screw
from service.wire.conversion.described import RobotDescription
from service.wire.fault_pointers import traced
from service.wire.prepared_robots import robot_of


def product_answer(robot: RobotDescription, request: ConvertRequest) -> ProductAnswer:
    """The joint screws and the home pose of a robot whose parameters all have values.

    Raises:
        ParameterError: a parameter has no value.
        TableError: a length is too large.
    """
    prepared = robot_of(robot.read, robot.parameters or {})
    with traced(request):
        check_lengths(prepared.table)
    product = product_of_exponentials(prepared.table, base=robot.base, tool=robot.tool)
    screws = [
        Screw(joint=joint, linear=list(screw.linear), angular=list(screw.angular))
        for joint, screw in zip(prepared.table.joint_types, product.screws, strict=True)
    ]
    return ProductAnswer(
        angle_unit=robot.read.angle_unit.value,
        length_unit=robot.read.length_unit.value,
        screws=screws,
        home=product.home.tolist(),
    )
