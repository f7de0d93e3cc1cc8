"""POST /convert: from one description of a robot to another.

A *source* reads a description into a `RobotDescription`, a *target* writes one. Every source meets every
target.

To add a source, give `service.schemas.kinematics.conversion.ConvertRequest` a field for it and `SOURCES` a
reader under that field's name; to add a target, give `Target` a name and `TARGETS` a writer.
"""

from collections.abc import Callable, Mapping

from numpy.typing import ArrayLike

from service.schemas.kinematics.conversion import ConvertAnswer, ConvertRequest, Target
from service.settings import Settings
from service.wire.kinematics.conversion.described import RobotDescription
from service.wire.kinematics.conversion.dh_tables import described_table, table_answer
from service.wire.kinematics.conversion.named_poses import in_numbers
from service.wire.kinematics.conversion.products import described_product, product_answer
from service.wire.kinematics.conversion.scm_chains import described_chain, scm_answer
from service.wire.kinematics.conversion.urdf_files import described_urdf, urdf_answer
from service.wire.kinematics.pose_matrices import pose_matrix

Source = Callable[[ConvertRequest, Settings], RobotDescription]
Writer = Callable[[RobotDescription, ConvertRequest], ConvertAnswer]

SOURCES: Mapping[str, Source] = {
    "table": described_table,
    "robot": described_table,
    "scm": described_chain,
    "poe": described_product,
    "urdf": described_urdf,
}

TARGETS: Mapping[Target, Writer] = {
    Target.STANDARD: table_answer,
    Target.MODIFIED: table_answer,
    Target.POE: product_answer,
    Target.SCM: scm_answer,
    Target.URDF: urdf_answer,
}


def converted(request: ConvertRequest, settings: Settings) -> ConvertAnswer:
    """Return the answer to a request that names exactly one source.

    Raises:
        KinematicsError: the description cannot be read, or not be written in the other form.
    """
    robot = SOURCES[next(name for name in SOURCES if getattr(request, name) is not None)](request, settings)
    robot = robot.between(*_ends(request, robot))
    robot = robot.with_joints(request.joint_names, request.link_names, request.limits)
    return TARGETS[request.to](robot, request)


def _ends(request: ConvertRequest, robot: RobotDescription) -> list[ArrayLike | None]:
    """Base and tool of a request in numbers, None where none is given or a name has no value."""
    ends: list[ArrayLike | None] = []
    for where, pose in (("base", request.base), ("tool", request.tool)):
        if where not in robot.named:
            ends.append(None if pose is None else pose_matrix(pose, robot.angle, where))
        elif robot.parameters is None:
            ends.append(None)
        else:
            ends.append(in_numbers(robot.named[where], robot.read, robot.parameters, where))
    return ends
