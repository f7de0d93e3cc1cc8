"""What the definition of a part begins with, on a page on which exercises are made."""

from typing import TYPE_CHECKING, Any

from kinematics.table import JointType

if TYPE_CHECKING:
    from exercises.parts.protocol import RobotFacts

Start = dict[str, Any]  # Keys of a definition with their values, as a file has them.
DEGREES = (30, 45, -60, 90, -30, 60)
RADIANS = (0.5, 0.8, -1.0, 1.5, -0.5, 1.0)
SLIDE = 0.2  # Joint values to begin with: away from the zeros at which wrong answers look right.


def joint_names(count: int) -> tuple[str, ...]:
    """Return q1 … qn."""
    return tuple(f"q{i}" for i in range(1, count + 1))


def usual_joints(robot: "RobotFacts") -> list[int | float]:
    """Return joint values to begin with [the exercise's units]."""
    turns: tuple[int | float, ...] = DEGREES if robot.degrees else RADIANS
    return [
        SLIDE if kind is JointType.PRISMATIC else turns[i % len(turns)]
        for i, kind in enumerate(robot.joint_types)
    ]
