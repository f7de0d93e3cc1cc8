"""From what a request says of a robot to a table that can be computed with; what was read is kept.

Clients send the same table again and again: a table and its parameters are read and validated once, and then
looked up by their JSON.
"""

from collections import OrderedDict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from threading import Lock
from typing import Any

import orjson

from kinematics import catalogue
from kinematics.caching import USUAL_TABLE
from kinematics.cells import Limits, ReadTable, bind_parameters
from kinematics.errors import Fault
from kinematics.table import JointType, NumericTable
from service.http.problems import RequestError, moved
from service.schemas.kinematics.robot_question import RobotQuestion
from service.schemas.tables import units_of
from service.settings import Settings

_LARGEST_KEY = 16 * 1024
"""Bytes of a question that is cached by its text; a table of a hundred rows has about half of it."""


@dataclass(frozen=True, kw_only=True, slots=True)
class PreparedRobot:
    """A robot that can be computed with.

    Attributes:
        read: its table, exact.
        table: its table in numbers, angles in [rad].
        joint_units: for joint 1 … n what one unit of the request is in [rad], or in the table's length unit.
        angle: what one unit of the request's angles is in [rad].
        units: the names of its units, as an answer states them.
    """

    read: ReadTable
    table: NumericTable
    joint_units: tuple[float, ...]
    angle: float
    units: Mapping[str, Any]


class RobotCache:
    """Reads robots, and keeps what it read."""

    def __init__(self, settings: Settings) -> None:
        self._limits: Limits = settings.cell_limits
        self._size = settings.table_cache
        self._length = 0
        self._keeping = Lock()  # large tables are read in a thread
        self._robots: OrderedDict[bytes, PreparedRobot] = OrderedDict()

    def recall(self, request: Mapping[str, Any]) -> PreparedRobot | None:
        """Return the robot of a request's JSON, if it was prepared before."""
        key = _key(request)
        try:
            robot = self._robots[key]
            self._robots.move_to_end(key)
        except KeyError:  # never seen; or dropped just now by a large batch that is read in a thread
            return None
        return robot

    def prepare(self, question: RobotQuestion, request: Mapping[str, Any] | None = None) -> PreparedRobot:
        """Return the robot of a validated request; `request` is its JSON, under which it is kept.

        Raises:
            KinematicsError: the table cannot be read, or its parameters do not fit; every fault at its place.
        """
        robot = _robot(question, self._limits)
        key = _key(request) if request is not None else b""
        if 0 < len(key) <= _LARGEST_KEY:
            self._keep(key, robot)
        return robot

    def _keep(self, key: bytes, robot: PreparedRobot) -> None:
        """Keep a robot, and of those used last as many as tables of usual length have room for."""
        with self._keeping:
            if key not in self._robots:
                self._length += robot.read.length
            self._robots[key] = robot
            while len(self._robots) > self._size or self._length > self._size * USUAL_TABLE:
                self._length -= self._robots.popitem(last=False)[1].read.length


def _key(request: Mapping[str, Any]) -> bytes:
    return orjson.dumps((request.get("table"), request.get("robot"), request.get("parameters")))


def _robot(question: RobotQuestion, limits: Limits) -> PreparedRobot:
    if question.table is None:
        listed = listed_robot(str(question.robot))
        return robot_of(listed.table, {**listed.parameters, **question.parameters})
    return robot_of(question.table.read(limits, "table"), question.parameters)


def listed_robot(robot_id: str) -> catalogue.Robot:
    """Return the robot of the catalogue that a request names in its field `robot`.

    Raises:
        RequestError: there is none of that id.
    """
    try:
        return catalogue.robot(robot_id)
    except KeyError:
        known = catalogue.robot_ids()
        raise RequestError(Fault.at("robot_unknown", "robot", robot=robot_id, known=known)) from None


def robot_of(read: ReadTable, parameters: Mapping[str, float]) -> PreparedRobot:
    """Return the robot of a read table with these parameters.

    Raises:
        KinematicsError: the parameters do not fit, at ("parameters", name) or ("table", "rows", i, cell).
    """
    with moved(lambda fault: fault if fault.where[:1] == ("parameters",) else fault.within("table")):
        table = bind_parameters(read, parameters)
    angle = read.angle_unit.radians
    return PreparedRobot(
        read=read,
        table=table,
        joint_units=joint_units(table.joint_types, angle),
        angle=angle,
        units=units_of(read),
    )


def joint_units(types: Sequence[JointType], angle: float) -> tuple[float, ...]:
    """Return for joint 1 … n what one unit of the request is in [rad], or in the table's length unit."""
    return tuple(angle if joint is JointType.REVOLUTE else 1.0 for joint in types)
