"""Screws of robots by means that the package does not use, written differently, and spoilt.

Axes are the z columns of products of DH matrices; a screw is (p × ω, ω) there. Other zeros move the arm
before the axes are read off, other frames move everything.
"""

import math
import random

import numpy as np
from numpy.typing import NDArray

from kinematics.answers.screw_answers import ScrewAnswer, ScrewFrame
from kinematics.equivalence import Policy, Tolerance, ToolRule
from kinematics.table import Convention, JointType, NumericTable
from tests.kinematics.answers.joint_values import product

Floats = NDArray[np.float64]
ROBOTS = ("twolink", "scara", "puma560", "stanford", "rx90", "scorbot")
POLICY = Policy(tool=ToolRule.FREE, tolerance=Tolerance(length=0.002, angle=0.002))


def motion(rng: random.Random, size: float) -> Floats:
    """A random rigid motion, from three turns about coordinate axes."""
    pose = np.eye(4)
    for axis in (0, 1, 2):
        angle, (j, k) = rng.uniform(-3, 3), [(1, 2), (2, 0), (0, 1)][axis]
        turn = np.eye(4)
        turn[j, j] = turn[k, k] = math.cos(angle)
        turn[j, k], turn[k, j] = -math.sin(angle), math.sin(angle)
        pose = pose @ turn
    pose[:3, 3] = [rng.uniform(-size, size) for _ in range(3)]
    return pose


def lines(table: NumericTable, joints: list[float]) -> list[tuple[Floats, Floats]]:
    """Direction and a point of each joint's axis at a configuration: z of the frame before or of its own."""
    found, values = [], list(joints)
    for i, row in enumerate(table.rows):
        if row.joint is JointType.FIXED:
            continue
        before = i if table.convention is Convention.STANDARD else i + 1
        part = NumericTable(convention=table.convention, rows=table.rows[:before])
        pose = product(part, values[: part.n_joints])
        found.append((row.sign * pose[:3, 2], pose[:3, 3]))
    return found


def written(table: NumericTable, rng: random.Random, tool: Floats | None = None) -> ScrewAnswer:
    """The robot in screws: with some zero, senses, points on the axes, frames, and lengths of sliders."""
    size = sum(abs(row.a) + abs(row.d) for row in table.rows)
    joints = [
        rng.uniform(-3, 3) if kind is JointType.REVOLUTE else rng.uniform(0.1, 0.5)
        for kind in table.joint_types
    ]
    base, tool = motion(rng, size), motion(rng, size) if tool is None else tool
    rotation, shift = base[:3, :3], base[:3, 3]
    rows = []
    for (direction, point), kind in zip(lines(table, joints), table.joint_types, strict=True):
        omega = rng.choice([-1, 1]) * (rotation @ direction)
        place = rotation @ (point + rng.uniform(-size, size) * direction) + shift
        if kind is JointType.REVOLUTE:
            rows.append([*np.cross(place, omega), *omega])
        else:
            rows.append([*(rng.uniform(0.3, 3) * omega), 0.0, 0.0, 0.0])
    home = base @ product(table, joints) @ tool
    space = np.array(rows)
    if rng.random() < 0.5:
        return ScrewAnswer(screws=np.round(space, 6), home=np.round(home, 6))
    back = np.linalg.inv(home)
    body = [
        [*(back[:3, :3] @ v - back[:3, :3] @ np.cross(home[:3, 3], w)), *(back[:3, :3] @ w)]
        for v, w in ((row[:3], row[3:]) for row in space)
    ]
    return ScrewAnswer(screws=np.round(np.array(body), 6), home=np.round(home, 6), frame=ScrewFrame.BODY)


def spoilt(answer: ScrewAnswer, table: NumericTable, rng: random.Random) -> ScrewAnswer:
    """An axis tilted across both neighbours' common plane, or moved away from its line: another robot."""
    size = sum(abs(row.a) + abs(row.d) for row in table.rows)
    rows = answer.screws.copy()
    turning = [i for i, row in enumerate(rows) if row[3:].any()]
    i = rng.choice(turning[1:-1] or turning)
    omega = rows[i, 3:]
    side = np.cross(omega, [rng.gauss(0, 1) for _ in range(3)])
    side /= np.linalg.norm(side)
    if rng.random() < 0.5:
        point = np.cross(omega, rows[i, :3])
        tilted = math.cos(0.3) * omega + math.sin(0.3) * side
        rows[i] = [*np.cross(point + 0.3 * size * side, tilted), *tilted]
    else:
        rows[i] *= 1.5
    return ScrewAnswer(screws=rows, home=answer.home, frame=answer.frame)
