"""Arms that many tests need, with where their figures come from."""

import math

from kinematics import catalogue
from kinematics.cells import bind_parameters
from kinematics.table import Convention, DHRow, DHTable, JointType, NumericTable

RIGHT = math.pi / 2


def numeric(convention: Convention, *rows: tuple[str, float, float, float, float]) -> NumericTable:
    """A table from (joint, alpha, a, d, theta)."""
    return DHTable(
        convention=convention,
        rows=tuple(
            DHRow(joint=JointType(joint), alpha=alpha, a=a, d=d, theta=theta)
            for joint, alpha, a, d, theta in rows
        ),
    )


def listed_numbers(robot_id: str) -> NumericTable:
    """A robot of the catalogue, with the values that it brings along."""
    robot = catalogue.robot(robot_id)
    return bind_parameters(robot.table, robot.parameters)


# P. I. Corke and B. Armstrong-Hélouvry, A search for consensus among model parameters reported for the PUMA
# 560 robot, ICRA 1994.
PUMA560 = numeric(
    Convention.STANDARD,
    ("revolute", RIGHT, 0.0, 0.0, 0.0),
    ("revolute", 0.0, 0.4318, 0.0, 0.0),
    ("revolute", -RIGHT, 0.0203, 0.15005, 0.0),
    ("revolute", RIGHT, 0.0, 0.4318, 0.0),
    ("revolute", -RIGHT, 0.0, 0.0, 0.0),
    ("revolute", 0.0, 0.0, 0.0, 0.0),
)

# J. J. Craig, Introduction to Robotics (3rd ed.), fig. 3.21: the frames of the book, the figures as above.
PUMA560_CRAIG = numeric(
    Convention.MODIFIED,
    ("revolute", 0.0, 0.0, 0.0, 0.0),
    ("revolute", -RIGHT, 0.0, 0.0, 0.0),
    ("revolute", 0.0, 0.4318, 0.15005, 0.0),
    ("revolute", -RIGHT, 0.0203, 0.4318, 0.0),
    ("revolute", RIGHT, 0.0, 0.0, 0.0),
    ("revolute", -RIGHT, 0.0, 0.0, 0.0),
)

# W. Khalil and E. Dombre, Modélisation, identification et commande des robots: Stäubli RX-90.
RX90 = numeric(
    Convention.MODIFIED,
    ("revolute", 0.0, 0.0, 0.0, 0.0),
    ("revolute", RIGHT, 0.0, 0.0, 0.0),
    ("revolute", 0.0, 0.45, 0.0, 0.0),
    ("revolute", -RIGHT, 0.0, 0.45, 0.0),
    ("revolute", RIGHT, 0.0, 0.0, 0.0),
    ("revolute", -RIGHT, 0.0, 0.0, 0.0),
)

# Seed 002: SCARA, with link lengths of 0.4 m and 0.3 m.
SCARA_RRPR = numeric(
    Convention.MODIFIED,
    ("revolute", 0.0, 0.0, 0.0, 0.0),
    ("revolute", 0.0, 0.4, 0.0, 0.0),
    ("prismatic", 0.0, 0.3, 0.0, 0.0),
    ("revolute", 0.0, 0.0, 0.0, 0.0),
)

# A planar arm of four joints: one more than the plane needs.
PLANAR4 = numeric(Convention.STANDARD, *(("revolute", 0.0, 0.5, 0.0, 0.0) for _ in range(4)))

# J. J. Craig's cylindrical arm in spirit: a prismatic joint first and last, a fixed row in between.
PRISMATIC_ENDS = numeric(
    Convention.STANDARD,
    ("prismatic", RIGHT, 0.1, 0.3, 0.2),
    ("fixed", 0.4, 0.2, 0.1, -0.3),
    ("revolute", -RIGHT, 0.0, 0.2, 0.5),
    ("prismatic", 0.3, 0.25, 0.0, 1.0),
)
