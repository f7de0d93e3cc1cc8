"""Where the origins stand along parallel axes.

The common normal of parallel axes may slide along them. It is put where d vanishes: level with the origin
before it, as far as there is one; otherwise level with the origin after it.
"""

from collections.abc import Sequence

from kinematics.frames.axes import AxisLine
from kinematics.frames.normals import CommonNormal
from kinematics.se3 import Vector, foot


def settle_levels(
    lines: Sequence[AxisLine], normals: Sequence[CommonNormal], *, start: Vector | None, end: Vector | None
) -> list[tuple[Vector, Vector]]:
    """Return both feet of every common normal, those that may slide put where d vanishes.

    Args:
        normals: the N-1 common normals between neighbours.
        start: a point given on the first axis: where the normal from a given frame 0 meets it.
        end: a point given on the last axis: where the normal to a given frame N leaves it.

    Returns:
        The feet on the earlier and on the later axis, one pair for each normal.

    Source: seed 002 step 3, second case, and step 4, figure (b, c).
    """
    feet: list[tuple[Vector, Vector] | None] = []
    level = start
    for k, normal in enumerate(normals):
        if not normal.relation.slides:
            feet.append((normal.near, normal.far))
            level = normal.far
        elif level is not None:
            feet.append((level, level := foot(level, lines[k + 1].point, lines[k + 1].direction)))
        else:
            feet.append(None)
    last = lines[-1]
    level = end if end is not None else foot(lines[0].point, last.point, last.direction)
    settled: list[tuple[Vector, Vector]] = []
    for k in range(len(normals) - 1, -1, -1):
        pair = feet[k]
        if pair is None:
            pair = (foot(level, lines[k].point, lines[k].direction), level)
        settled.append(pair)
        level = pair[0]
    return settled[::-1]
