"""The frames that a student has chosen, as far as they are chosen: read, and refused where they are none."""

from collections.abc import Sequence
from dataclasses import dataclass

from kinematics.errors import DescriptionError, Fault
from kinematics.frames.axes import PartialPose, read_direction, read_point
from kinematics.se3 import Vector, cross, norm, subtract, unit


@dataclass(frozen=True, kw_only=True, slots=True)
class ChosenFrame:
    """A frame as far as a student has chosen it, at the robot's zero position; y follows from z and x.

    Attributes:
        origin: the origin [m], or None.
        x: direction of x, or None.
        z: direction of z, or None.
        y: None, or the direction z × x beside both of them.
    """

    origin: Sequence[float] | None = None
    x: Sequence[float] | None = None
    z: Sequence[float] | None = None
    y: Sequence[float] | None = None


SAME_DIRECTION = 1e-6  # A y that differs from z × x by no more than this is it.


def read_frames(chosen: Sequence[ChosenFrame | None], count: int) -> list[PartialPose]:
    """Return frames 0 … count, those that are not chosen as nothing.

    Raises:
        DescriptionError: there are more, points or directions are none, or a y is not z × x.
    """
    if len(chosen) > count + 1:
        raise DescriptionError(Fault.at("frames_too_many", "frames", count=count))
    faults: list[Fault] = []
    frames = []
    for i in range(count + 1):
        frame = chosen[i] if i < len(chosen) else None
        frame = ChosenFrame() if frame is None else frame
        where = ("frames", i)
        read = PartialPose(
            None if frame.origin is None else read_point(frame.origin, (*where, "origin"), faults),
            None if frame.x is None else read_direction(frame.x, (*where, "x"), faults),
            None if frame.z is None else read_direction(frame.z, (*where, "z"), faults),
        )
        frames.append(read)
        if frame.y is not None:
            before = len(faults)
            y = read_direction(frame.y, (*where, "y"), faults)
            if len(faults) == before and not _follows(y, read):
                faults.append(Fault.at("frame_y_not_z_cross_x", *where, "y"))
    if faults:
        raise DescriptionError(faults)
    return frames


def _follows(y: Vector, frame: PartialPose) -> bool:
    """Whether y is z × x; where x lies along z that rule is broken, and y is not to be blamed for it."""
    if frame.x is None or frame.z is None:
        return False
    across = cross(frame.z, frame.x)
    return norm(across) < SAME_DIRECTION or norm(subtract(y, unit(across))) <= SAME_DIRECTION
