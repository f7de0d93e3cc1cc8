"""What a caller should know about an assignment that succeeded."""

import math
from collections.abc import Sequence

from kinematics.errors import Fault
from kinematics.frames.parallels import NearParallel, Tilt
from kinematics.se3 import Transform, Vector, norm, subtract
from kinematics.table import NumericTable


def tilt_remarks(
    tilts: Sequence[Tilt],
    table: NumericTable,
    axis_points: Sequence[Vector],
    tool: Transform,
    policy: NearParallel,
) -> list[Fault]:
    """Return one warning for each tilt.

    A turn about an axis that is tilted by ε moves a point at distance r from the pivot by at most 2 ε r; r is
    bounded by the lengths of the rows from that joint on, and that of the tool in the last frame.
    """
    remarks = []
    for tilt in tilts:
        i = tilt.joint - 1
        angle = float(f"{tilt.angle:.6g}")
        where = ("axes", i, "direction")
        if policy is NearParallel.DUMMY_ROW:
            remarks.append(Fault.at("near_parallel_dummy_row", *where, joint=i + 1, previous=i, angle=angle))
            continue
        reach = norm(subtract(tilt.pivot, axis_points[i]))
        reach += sum(abs(row.a) + abs(row.d) for row in table.rows[i:]) + math.hypot(*tool[:3, 3])
        displacement = float(f"{2.0 * tilt.angle * reach:.3g}")
        remarks.append(
            Fault.at("near_parallel", *where, joint=i + 1, previous=i, angle=angle, displacement=displacement)
        )
    return remarks
