"""Where the line of a prismatic joint is drawn.

A prismatic joint has a direction and no place: any parallel line is its axis. The line is drawn through the
origin on the next axis, so that a_i and d_{i+1} vanish; after the last revolute joint, through the origin
before it, so that a and d vanish up to the end.
"""

from collections.abc import Sequence

from kinematics.frames.axes import AxisLine
from kinematics.frames.normals import CommonNormal, common_normal
from kinematics.se3 import Vector, foot
from kinematics.table import JointType


def draw_prismatic_axes(
    lines: Sequence[AxisLine], size: float, *, start: Vector | None = None, end: Vector | None = None
) -> list[AxisLine]:
    """Return the axes with a line chosen for every prismatic joint.

    Args:
        lines: the axes; the points of prismatic ones are overwritten, unless all axes are prismatic.
        size: the robot's size [m].
        start: origin of a given frame 0, through which leading prismatic axes are drawn.
        end: origin of a given frame N, through which trailing prismatic axes are drawn.

    Source: seed 002 step 3 (an axis of a prismatic joint leaves the origin free) and step 7; seed 000 §3.2.2.
    """
    slides = [line.joint is JointType.PRISMATIC for line in lines]
    if not any(slides):
        return list(lines)
    if all(slides):
        through = start or end or lines[0].point
        drawn = [AxisLine(line.joint, through, line.direction) for line in lines]
        drawn[-1] = AxisLine(drawn[-1].joint, end or through, drawn[-1].direction)
        return drawn
    first = slides.index(False)
    last = len(lines) - 1 - slides[::-1].index(False)
    drawn = list(lines)
    _draw_trailing(drawn, last, size, end)
    for k in range(last - 1, -1, -1):
        if slides[k]:
            through = start if start is not None and k < first else _next_origin(drawn, k + 1, size)
            drawn[k] = AxisLine(drawn[k].joint, through, drawn[k].direction)
    return drawn


def _draw_trailing(drawn: list[AxisLine], last: int, size: float, end: Vector | None) -> None:
    if last == len(drawn) - 1:
        return
    through = end
    if through is None:
        through = drawn[last].point
        before = drawn[last - 1] if last else None
        if before is not None and before.joint is not JointType.PRISMATIC:
            normal = common_normal(before, drawn[last], size)
            through = _level_from_left(drawn, last, size) if normal.relation.slides else normal.far
    for k in range(last + 1, len(drawn)):
        drawn[k] = AxisLine(drawn[k].joint, through, drawn[k].direction)


def _level_from_left(drawn: Sequence[AxisLine], k: int, size: float) -> Vector:
    """Origin on axis k at the level at which the run of parallel axes up to it begins."""
    start = k
    while start > 0 and drawn[start - 1].joint is not JointType.PRISMATIC:
        normal = common_normal(drawn[start - 1], drawn[start], size)
        if not normal.relation.slides:
            return foot(normal.far, drawn[k].point, drawn[k].direction)
        start -= 1
    return drawn[k].point


def _next_origin(drawn: Sequence[AxisLine], k: int, size: float) -> Vector:
    """Foot on axis k of its common normal with the next axis; along parallel axes, that of their end."""
    for j in range(k, len(drawn) - 1):
        normal: CommonNormal = common_normal(drawn[j], drawn[j + 1], size)
        if not normal.relation.slides:
            return foot(normal.near, drawn[k].point, drawn[k].direction)
    return drawn[k].point
