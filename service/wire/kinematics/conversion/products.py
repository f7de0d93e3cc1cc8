"""Products of exponentials."""

from kinematics import screws as screws_module
from kinematics.cells import AngleUnit, ReadTable
from kinematics.errors import DescriptionError, Fault
from kinematics.frames.exactness import exact_table
from kinematics.inverse.lengths import check_lengths
from kinematics.screws import product_of_exponentials, table_of_product
from kinematics.se3 import check_transform, triple
from kinematics.table import Convention, JointType
from service.http.problems import located
from service.schemas.kinematics.conversion import ConvertRequest, ProductAnswer, ScrewModel, Target
from service.schemas.tables import units_of
from service.settings import Settings
from service.wire.fault_pointers import traced
from service.wire.kinematics.conversion.described import RobotDescription
from service.wire.kinematics.pose_matrices import pose_matrix
from service.wire.kinematics.prepared_robots import robot_of


def described_product(request: ConvertRequest, _settings: Settings) -> RobotDescription:
    """Return the robot of a product of exponentials, by frames assigned to its joint axes.

    Raises:
        DescriptionError: a screw is none of a joint, or of another type than it is said to be.
        PoseError: the home pose is not a rigid transform.
    """
    given = request.poe
    assert given is not None
    convention = Convention.STANDARD if request.to is Target.STANDARD else Convention.MODIFIED
    screws = tuple(screws_module.Screw(triple(one.linear), triple(one.angular)) for one in given.screws)
    with located("poe"):
        for i, (one, screw) in enumerate(zip(given.screws, screws, strict=True)):
            meant = JointType.REVOLUTE if screws_module.turns(screw) else JointType.PRISMATIC
            if one.joint not in (None, meant):
                raise DescriptionError(Fault.at("screw_of_other_type", "screws", i, joint=i + 1))
        unit = request.angle_unit or AngleUnit.RAD
        home = check_transform(pose_matrix(given.home, unit.radians, "home"), where=("home",))
        assigned = table_of_product(screws_module.ProductOfExponentials(screws=screws, home=home), convention)
    read = ReadTable(
        table=exact_table(assigned.table), angle_unit=unit, length_unit=given.length_unit, parameters={}
    )
    return RobotDescription(read=read, base=assigned.base, tool=assigned.tool)


def product_answer(robot: RobotDescription, request: ConvertRequest) -> ProductAnswer:
    """Return the joint screws and the home pose of a robot whose parameters all have values.

    Raises:
        ParameterError: a parameter has no value.
        TableError: a length is too large.
    """
    prepared = robot_of(robot.read, robot.parameters or {})
    with traced(request):
        check_lengths(prepared.table)
    product = product_of_exponentials(prepared.table, base=robot.base, tool=robot.tool)
    screws = [
        ScrewModel(joint=joint, linear=list(screw.linear), angular=list(screw.angular))
        for joint, screw in zip(prepared.table.joint_types, product.screws, strict=True)
    ]
    return ProductAnswer(
        **units_of(robot.read), screws=screws, home=product.home.tolist(), **robot.names_and_limits
    )
