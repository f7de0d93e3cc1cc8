"""One mistake in frames that obey the rules: made, found, named and mended.

Frames are wrong where a rule of their convention is broken, or where y is not z × x. Whatever obeys the rules
mends them: the frame as it was, or any other that the convention allows there.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from kinematics.frames.axes import JointAxis
from kinematics.frames.chosen_frames import ChosenFrame
from kinematics.frames.rules import ANGLE_TOLERANCE, BINDING, Severity
from kinematics.frames.trainer import rules_and_table
from kinematics.se3 import Vector, along, cross, dot, norm, scale, subtract, unit
from kinematics.table import Convention

LEFT_HANDED = "y_left_handed"  # The y of a frame is not z × x.
FRAME_MISTAKES: tuple[str, ...] = (*(code.value for code in BINDING), LEFT_HANDED)
"""What may be wrong with a frame, by name."""
TILT = math.radians(30.0)
"""[rad] By how much a direction is turned that is to be wrong and still look like one that was meant."""
SLIDE = 0.25  # How far an origin is moved, as a part of how far the origins are apart: enough to be seen.


SLIGHT = 1e-3  # Origins nearer than this part of their distance coincide as far as a drawing shows.


@dataclass(frozen=True, slots=True)
class DrawnFrame:
    """A frame as it is drawn: its origin and its axes, of which y may point the wrong way."""

    origin: Vector
    x: Vector
    y: Vector
    z: Vector


@dataclass(frozen=True, kw_only=True, slots=True)
class PlantedFrame:
    """Frames with one mistake.

    `code` is what is wrong with frame `index`, `right` that frame as it was.
    """

    index: int
    code: str
    shown: tuple[DrawnFrame, ...]
    right: DrawnFrame


def right_handed(origin: Vector, x: Vector, z: Vector) -> DrawnFrame:
    """Return the frame whose y is z × x; x and z are unit vectors at right angles."""
    return DrawnFrame(origin, x, cross(z, x), z)


def frame_mistakes(
    axes: Sequence[JointAxis], convention: Convention, frames: Sequence[DrawnFrame], *, rounding: float = 0.0
) -> list[frozenset[str]]:
    """Return by frame what is wrong with it; nothing if the frames obey the convention.

    Args:
        axes: the joint axes, in the position in which the frames stand.
        frames: frame 0 … N.
        rounding: as in `check_frames`; y may be off by twice as much.

    Raises:
        DescriptionError: malformed axes or frames, or more than N+1 frames.
    """
    chosen = [ChosenFrame(origin=frame.origin, x=frame.x, z=frame.z) for frame in frames]
    broken, _ = rules_and_table(axes, convention, chosen, rounding=rounding)
    return [
        frozenset(found.rule.value for found in findings if found.severity is Severity.BROKEN)
        | _handedness(frame, max(2.0 * rounding, ANGLE_TOLERANCE))
        for frame, findings in zip(frames, broken, strict=False)
    ]


def _handedness(frame: DrawnFrame, tolerance: float) -> frozenset[str]:
    """Where x and z lie along each other another rule is broken, and y is not to be blamed for it."""
    across, size = cross(frame.z, frame.x), norm(frame.y)
    if norm(across) < ANGLE_TOLERANCE:
        return frozenset()
    if size == 0.0 or norm(subtract(scale(frame.y, 1.0 / size), unit(across))) > tolerance:
        return frozenset((LEFT_HANDED,))
    return frozenset()


def mends(
    axes: Sequence[JointAxis],
    convention: Convention,
    planted: PlantedFrame,
    index: int,
    frame: DrawnFrame,
    *,
    rounding: float = 0.0,
) -> bool:
    """Return whether the frames are right with another one in the place of one of them.

    Args and raises as in `frame_mistakes`.
    """
    frames = [*planted.shown[:index], frame, *planted.shown[index + 1 :]]
    return not any(frame_mistakes(axes, convention, frames, rounding=rounding))


def plantable_in_frames(
    axes: Sequence[JointAxis], convention: Convention, frames: Sequence[DrawnFrame]
) -> dict[str, tuple[PlantedFrame, ...]]:
    """Return every way to spoil one of some right frames so that exactly one thing is wrong, by what that is.

    Args and raises as in `frame_mistakes`.
    """
    size = _extent(frames)
    found: dict[str, list[PlantedFrame]] = {}
    for index, frame in enumerate(frames):
        for spoilt in _spoilt(frame, index, axes, frames, size):
            shown = (*frames[:index], spoilt, *frames[index + 1 :])
            wrong = {i: codes for i, codes in enumerate(frame_mistakes(axes, convention, shown)) if codes}
            if wrong.keys() == {index} and len(wrong[index]) == 1:
                (code,) = wrong[index]
                planted = PlantedFrame(index=index, code=code, shown=shown, right=frame)
                found.setdefault(code, []).append(planted)
    return {code: tuple(found[code]) for code in FRAME_MISTAKES if code in found}


def _extent(frames: Sequence[DrawnFrame]) -> float:
    """How far the origins are apart; where they coincide, how far they are from where is counted, or 1."""
    apart = max(norm(subtract(frame.origin, frames[0].origin)) for frame in frames)
    away = max(norm(frame.origin) for frame in frames)
    return apart if apart > SLIGHT * away else away or 1.0


def _spoilt(
    frame: DrawnFrame, index: int, axes: Sequence[JointAxis], frames: Sequence[DrawnFrame], size: float
) -> Iterator[DrawnFrame]:
    """What students draw: z along a neighbouring joint, x aside, the origin elsewhere, a left-handed y."""
    for axis in axes[max(index - 2, 0) : index + 2]:
        direction = unit((axis.direction[0], axis.direction[1], axis.direction[2]))
        if abs(dot(direction, frame.x)) <= ANGLE_TOLERANCE:
            yield right_handed(frame.origin, frame.x, direction)
    yield right_handed(frame.origin, frame.x, frame.y)
    yield right_handed(frame.origin, frame.y, frame.z)
    turned = subtract(scale(frame.x, math.cos(TILT)), scale(frame.y, math.sin(TILT)))
    yield right_handed(frame.origin, turned, frame.z)
    yield replace(frame, x=subtract(scale(frame.x, math.cos(TILT)), scale(frame.z, math.sin(TILT))))
    for other in (*frames[max(index - 1, 0) : index], *frames[index + 1 : index + 2]):
        if norm(subtract(other.origin, frame.origin)) > ANGLE_TOLERANCE * size:
            yield replace(frame, origin=other.origin)
    for direction in (frame.x, frame.y, frame.z):
        yield replace(frame, origin=along(frame.origin, SLIDE * size, direction))
    yield replace(frame, y=scale(frame.y, -1.0))
