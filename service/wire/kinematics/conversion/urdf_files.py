"""URDF descriptions: one serial chain of them read, tables written."""

from kinematics.cells import AngleUnit, LengthUnit, ReadTable
from kinematics.frames.exactness import exact_table
from kinematics.table import Convention, JointType
from kinematics.urdf import BASE_LINK, TIP_LINK, table_from_urdf, urdf_from_table
from service.http.problems import located
from service.schemas.kinematics.conversion import ConvertRequest, Target, UrdfAnswer
from service.schemas.kinematics.robot_question import domain_limits
from service.settings import Settings
from service.wire.fault_pointers import traced
from service.wire.kinematics.conversion.described import RobotDescription
from service.wire.kinematics.prepared_robots import robot_of
from service.wire.kinematics.written_tables import angle_in


def described_urdf(request: ConvertRequest, _settings: Settings) -> RobotDescription:
    """Return the robot of a chain of a URDF description, by frames assigned to its joint axes.

    Raises:
        DescriptionError: the description cannot be read, or the chain is none that a DH table can hold.
    """
    convention = Convention.STANDARD if request.to is Target.STANDARD else Convention.MODIFIED
    with located("urdf"):
        robot = table_from_urdf(
            str(request.urdf), convention, base_link=request.base_link, tip_link=request.tip_link
        )
    unit = request.angle_unit or AngleUnit.RAD
    turning = [kind is JointType.REVOLUTE for kind in robot.table.joint_types]
    read = ReadTable(table=exact_table(robot.table), angle_unit=unit, length_unit=LengthUnit.M, parameters={})
    return RobotDescription(
        read=read,
        base=robot.base,
        tool=robot.tool,
        name=_printable(robot.name),
        base_link=_printable(robot.base_link),
        tip_link=_printable(robot.tip_link),
        joint_names=robot.joints,
        link_names=robot.links if all(map(_printable, robot.links)) else None,
        limits=[
            None if pair is None else [_bound(bound, unit if turns else AngleUnit.RAD) for bound in pair]
            for pair, turns in zip(robot.limits, turning, strict=True)
        ],
    )


def _printable(name: str) -> str | None:
    return name if name.strip() and name.isprintable() else None


def _bound(bound: float | None, unit: AngleUnit) -> float | None:
    return None if bound is None else angle_in(unit, bound)


def urdf_answer(robot: RobotDescription, request: ConvertRequest) -> UrdfAnswer:
    """Return the URDF description of a robot whose parameters all have values.

    Raises:
        ParameterError: a parameter has no value.
        JointValueError: limits of the wrong number, or reversed.
        DescriptionError: a length that no reader of URDF takes.
    """
    prepared = robot_of(robot.read, robot.parameters or {})
    limits = domain_limits(robot.limits, prepared.joint_units)
    with traced(request):
        written = urdf_from_table(
            prepared.table,
            name=request.name or robot.name or "robot",
            base=robot.base,
            tool=robot.tool,
            limits=limits,
            joint_names=robot.joint_names,
            link_names=robot.link_names,
            base_link=robot.base_link or request.base_link or BASE_LINK,
            tip_link=robot.tip_link or request.tip_link or TIP_LINK,
            metres_per_unit=float(robot.read.length_unit.metres_per_unit),
        )
    return UrdfAnswer(
        angle_unit=AngleUnit.RAD.value,
        length_unit=LengthUnit.M.value,
        urdf=written.text,
        base_link=written.base_link,
        tip_link=written.tip_link,
        assumed_limits=list(written.assumed_limits),
    )
