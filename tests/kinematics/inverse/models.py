"""Arms that people have: the catalogue's, and others by their makers' published parameters (lengths in m)."""

import math

from kinematics.catalogue import robots
from kinematics.cells import bind_parameters
from kinematics.table import Convention, DHTable
from tests.kinematics.inverse.arms import STANFORD, THREE_LINKS, TWO_LINKS, UR5
from tests.kinematics.robots import PLANAR4, PUMA560, PUMA560_CRAIG, numeric

RIGHT = math.pi / 2


def _turning(convention: Convention, *rows: tuple[float, float, float]) -> DHTable:
    """A table of turning joints from (alpha, a, d)."""
    return numeric(convention, *(("revolute", alpha, a, d, 0.0) for alpha, a, d in rows))


STANDARD, MODIFIED = Convention.STANDARD, Convention.MODIFIED

MODELS: dict[str, DHTable] = {
    **{f"catalogue {r.id}": bind_parameters(r.table, r.parameters) for r in robots()},
    "puma": PUMA560,
    "puma, craig": PUMA560_CRAIG,
    "stanford": STANFORD,
    "two links": TWO_LINKS,
    "three links": THREE_LINKS,
    "four links": PLANAR4,
    "ur5": UR5,
    "ur3": _turning(
        STANDARD,
        (RIGHT, 0.0, 0.1519),
        (0.0, -0.24365, 0.0),
        (0.0, -0.21325, 0.0),
        (RIGHT, 0.0, 0.11235),
        (-RIGHT, 0.0, 0.08535),
        (0.0, 0.0, 0.0819),
    ),
    "ur10": _turning(
        STANDARD,
        (RIGHT, 0.0, 0.1273),
        (0.0, -0.612, 0.0),
        (0.0, -0.5723, 0.0),
        (RIGHT, 0.0, 0.163941),
        (-RIGHT, 0.0, 0.1157),
        (0.0, 0.0, 0.0922),
    ),
    "irb140": _turning(
        STANDARD,
        (-RIGHT, 0.07, 0.352),
        (0.0, 0.36, 0.0),
        (-RIGHT, 0.0, 0.0),
        (RIGHT, 0.0, 0.38),
        (-RIGHT, 0.0, 0.0),
        (0.0, 0.0, 0.065),
    ),
    "kr5": _turning(
        STANDARD,
        (-RIGHT, 0.18, 0.4),
        (0.0, 0.6, 0.0),
        (RIGHT, 0.12, 0.0),
        (-RIGHT, 0.0, 0.62),
        (RIGHT, 0.0, 0.0),
        (0.0, 0.0, 0.115),
    ),
    "no offsets": _turning(
        STANDARD,
        (RIGHT, 0.0, 0.3),
        (0.0, 0.4, 0.0),
        (RIGHT, 0.0, 0.0),
        (-RIGHT, 0.0, 0.4),
        (RIGHT, 0.0, 0.0),
        (0.0, 0.0, 0.1),
    ),
    "jaco": _turning(
        STANDARD,
        (RIGHT, 0.0, 0.2755),
        (math.pi, 0.41, 0.0),
        (RIGHT, 0.0, -0.0098),
        (math.pi / 3, 0.0, -0.2492),
        (math.pi / 3, 0.0, -0.0857),
        (math.pi, 0.0, -0.2028),
    ),
    "mico": _turning(
        STANDARD,
        (RIGHT, 0.0, 0.2755),
        (math.pi, 0.29, 0.0),
        (RIGHT, 0.0, -0.007),
        (math.pi / 3, 0.0, -0.1233 - 0.0741 / math.sqrt(3.0)),
        (math.pi / 3, 0.0, -2.0 * 0.0741 / math.sqrt(3.0)),
        (math.pi, 0.0, -0.1600 - 0.0741 / math.sqrt(3.0)),
    ),
    "five joints": _turning(
        STANDARD,
        (RIGHT, 0.025, 0.147),
        (0.0, 0.155, 0.0),
        (0.0, 0.135, 0.0),
        (RIGHT, 0.0, 0.0),
        (0.0, 0.0, 0.2),
    ),
    "panda": _turning(
        MODIFIED,
        (0.0, 0.0, 0.333),
        (-RIGHT, 0.0, 0.0),
        (RIGHT, 0.0, 0.316),
        (RIGHT, 0.0825, 0.0),
        (-RIGHT, -0.0825, 0.384),
        (RIGHT, 0.0, 0.0),
        (RIGHT, 0.088, 0.107),
    ),
}
"""Sources: Universal Robots, DH parameters for calculations of kinematics and dynamics (UR3, UR5, UR10);
ABB, IRB 140 product specification; KUKA, KR 5 arc specification; Kinova, advanced specification guides of the
JACO² 6 DOF and the MICO² 6 DOF (wrists of 60°); KUKA, youBot arm; Franka Emika, FCI documentation (Panda)."""
