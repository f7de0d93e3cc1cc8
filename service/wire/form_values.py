"""The values of a robot's parameters where functions of them are asked for."""

from __future__ import annotations

import math

from kinematics.cells import AngleUnit, ParameterKind
from service.schemas.robot_question import RobotQuestion
from service.wire.prepared_robots import PreparedRobot, listed_robot


def form_values(question: RobotQuestion, robot: PreparedRobot) -> dict[str, float]:
    """Return the value of each parameter of a request's robot [rad, or the table's length]."""
    values = dict(question.parameters)
    if question.robot is not None:
        values = {**listed_robot(question.robot).parameters, **values}
    degrees = robot.read.angle_unit is AngleUnit.DEG
    kinds = robot.read.parameters
    return {
        name: math.radians(value) if degrees and kinds.get(name) is ParameterKind.ANGLE else value
        for name, value in values.items()
    }
