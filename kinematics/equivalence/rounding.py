"""How much the rounding of a table's entries can do: the tolerance that matches a number of decimals."""

from kinematics.chain import Chain, chain_of_table, frames_at_zero, walk
from kinematics.equivalence.policy import Tolerance
from kinematics.equivalence.reference import prepared
from kinematics.se3 import Vector, norm, position, scale, subtract, x_axis, z_axis
from kinematics.table import Convention, JointType, NumericTable


def rounding_tolerance(
    reference: NumericTable, table: NumericTable, *, length_step: float, angle_step: float
) -> Tolerance:
    """Return the tolerance within which a right table stays, however its entries are rounded.

    Every entry may be off by half a step, and all may add up. A length that is off moves frame N by as much;
    an angle moves it by that times the lever, the largest distance at which frame N can be from the line that
    the angle turns about. θ of a revolute row and d of a prismatic one do not count: joint offsets make up
    for them. First order in the steps.

    Args:
        reference: the key, to whose size the tolerance refers.
        table: a right table; the key itself, where its frames are those that students are expected to draw.
        length_step: one unit of the last decimal of a and d [length].
        angle_step: one unit of the last decimal of α and θ [rad].
    """
    chain = chain_of_table(table)
    size = prepared(reference).beside(chain).size
    frames = frames_at_zero(table)
    standard = table.convention is Convention.STANDARD
    lengths, levers = 0, []
    joint = 0
    for after, row in zip(frames[1:], table.rows, strict=True):
        # where the row's twist turns, and its angle; then how many joints come before these turns
        twist, turn = position(after), subtract(position(after), scale(x_axis(after), row.a))
        earlier = joint + (row.joint is not JointType.FIXED)
        if not standard:
            twist, turn = subtract(position(after), scale(z_axis(after), row.d)), position(after)
        levers.append(_lever(chain, twist, earlier if standard else joint, size))
        if row.joint is not JointType.REVOLUTE:
            levers.append(_lever(chain, turn, earlier, size))
        lengths += 1 + (row.joint is not JointType.PRISMATIC)
        joint = earlier
    apart = 0.5 * (lengths * length_step + angle_step * sum(levers))
    return Tolerance(length=apart / size, angle=0.5 * angle_step * len(levers))


def _lever(chain: Chain, start: Vector, earlier: int, size: float) -> float:
    """The farthest that frame N can be from a point of the link before some joints.

    From the point to the nearest one of each later revolute axis in turn, and to frame N: steps that stay as
    long as they are whatever the joints do, apart from the travel of the prismatic joints.
    """
    later = chain.axes[earlier:]
    end, there = position(chain.end), [axis for axis in later if not axis.prismatic]
    here, length = walk(start, there)
    return length + norm(subtract(end, here)) + size * (len(later) - len(there))
