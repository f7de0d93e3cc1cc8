"""The robots of the source documents: one TOML file each, with source, figures and a reference pose."""

from functools import cache
from importlib.resources import files

from kinematics.catalogue.robot_files import read_robot
from kinematics.catalogue.robots import NamedConfiguration, ReferencePose, Robot, RobotSource, ScmDescription

__all__ = [
    "NamedConfiguration",
    "ReferencePose",
    "Robot",
    "RobotSource",
    "ScmDescription",
    "read_robot",
    "robot",
    "robot_ids",
    "robots",
]


@cache
def robot_ids() -> tuple[str, ...]:
    """Return the ids of all robots, in alphabetical order."""
    names = (file.name for file in files(__package__).iterdir())
    return tuple(sorted(name.removesuffix(".toml") for name in names if name.endswith(".toml")))


@cache
def robot(robot_id: str) -> Robot:
    """Return the robot of that id.

    Raises:
        KeyError: the catalogue holds none.
        DescriptionError: its file is malformed.
    """
    if robot_id not in robot_ids():
        raise KeyError(robot_id)
    return read_robot(robot_id, (files(__package__) / f"{robot_id}.toml").read_text(encoding="utf-8"))


def robots() -> tuple[Robot, ...]:
    """Return every robot of the catalogue, in alphabetical order of the ids."""
    return tuple(map(robot, robot_ids()))
