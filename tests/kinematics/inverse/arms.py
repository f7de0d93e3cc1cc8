"""Arms for inverse kinematics, and random ones."""

import math

import numpy as np

from kinematics.table import Convention, DHRow, DHTable, JointType
from tests.kinematics.robots import numeric

RIGHT = math.pi / 2

# Universal Robots, DH parameters as the maker publishes them: UR5.
UR5 = numeric(
    Convention.STANDARD,
    ("revolute", RIGHT, 0.0, 0.089159, 0.0),
    ("revolute", 0.0, -0.425, 0.0, 0.0),
    ("revolute", 0.0, -0.39225, 0.0, 0.0),
    ("revolute", RIGHT, 0.0, 0.10915, 0.0),
    ("revolute", -RIGHT, 0.0, 0.09465, 0.0),
    ("revolute", 0.0, 0.0, 0.0823, 0.0),
)

# Two links in the plane, as every course has them.
TWO_LINKS = numeric(Convention.STANDARD, ("revolute", 0.0, 0.5, 0.0, 0.0), ("revolute", 0.0, 0.3, 0.0, 0.0))

# Three links in the plane: elbow up or down for every pose in reach.
THREE_LINKS = numeric(
    Convention.STANDARD,
    ("revolute", 0.0, 0.5, 0.0, 0.0),
    ("revolute", 0.0, 0.3, 0.0, 0.0),
    ("revolute", 0.0, 0.1, 0.0, 0.0),
)

# The Stanford arm, lengths of seed 001: a slider before a wrist.
STANFORD = numeric(
    Convention.MODIFIED,
    ("revolute", 0.0, 0.0, 0.412, 0.0),
    ("revolute", -RIGHT, 0.0, 0.154, 0.0),
    ("prismatic", RIGHT, 0.0, 0.0, 0.0),
    ("revolute", 0.0, 0.0, 0.0, 0.0),
    ("revolute", -RIGHT, 0.0, 0.0, 0.0),
    ("revolute", RIGHT, 0.0, 0.263, 0.0),
)

# Six turning joints without any special geometry.
GENERAL = numeric(
    Convention.STANDARD,
    ("revolute", 1.1, 0.3, 0.2, 0.0),
    ("revolute", -0.7, 0.4, 0.1, 0.3),
    ("revolute", 1.9, 0.2, -0.3, 0.0),
    ("revolute", 0.6, 0.1, 0.25, -0.5),
    ("revolute", -1.3, 0.15, 0.1, 0.0),
    ("revolute", 0.4, 0.2, 0.1, 0.0),
)


def random_table(rng, n, sliding=0.15, aligned=False):
    rows = []
    for _ in range(n):
        alpha = rng.choice([0.0, RIGHT, -RIGHT]) if aligned else rng.uniform(-math.pi, math.pi)
        a = rng.choice([0.0, 0.3, 0.5]) if aligned else rng.uniform(-0.5, 0.5)
        d = rng.choice([0.0, 0.0, 0.2, 0.4]) if aligned else rng.uniform(-0.5, 0.5)
        rows.append(
            DHRow(
                joint=JointType.PRISMATIC if rng.random() < sliding else JointType.REVOLUTE,
                theta=0.0 if aligned else float(rng.uniform(-math.pi, math.pi)),
                d=float(d),
                a=float(a),
                alpha=float(alpha),
                sign=int(rng.choice([1, -1])),
            )
        )
    return DHTable(convention=list(Convention)[rng.integers(2)], rows=tuple(rows))


def turning(table):
    return np.array([joint is JointType.REVOLUTE for joint in table.joint_types])


def random_joints(rng, table, slide=1.0):
    n = table.n_joints
    return np.where(turning(table), rng.uniform(-math.pi, math.pi, n), rng.uniform(-slide, slide, n))


def apart(table, q, other):
    """Largest joint difference, turns of 2π not counted."""
    difference = np.asarray(q) - np.asarray(other)
    turned = (difference + math.pi) % (2 * math.pi) - math.pi
    return np.abs(np.where(turning(table), turned, difference)).max(axis=-1)
