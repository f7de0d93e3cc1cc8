"""Valid DH tables made from axis lines, by the definition of the DH frames and by nothing of the checker's.

A robot is a list of joint axes in space and a tool frame. A table is drawn for it as a person would: point
every z axis one way or the other, put prismatic axes anywhere, choose a common normal wherever there is a
choice, slip in dummy lines if wanted, and read off θ, d, a and α.
"""

import math
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise
from random import Random

import numpy as np

from kinematics.forward import forward_kinematics
from kinematics.table import Convention, DHRow, DHTable, JointType, NumericTable

MEETING = 1e-9


@dataclass(frozen=True)
class Joint:
    """A joint axis in space: type, a point and a unit direction in which its variable counts."""

    type: JointType
    point: np.ndarray
    direction: np.ndarray


@dataclass(frozen=True)
class Robot:
    """Joint axes and tool frame at one configuration."""

    joints: tuple[Joint, ...]
    tool: np.ndarray
    size: float


@dataclass(frozen=True)
class Line:
    """A line that becomes a z axis; `joint` is FIXED for a dummy, `sign` is the variable's in its row."""

    point: np.ndarray
    direction: np.ndarray
    joint: JointType
    sign: int


@dataclass(frozen=True)
class Choices:
    """What to vary in drawing a table."""

    convention: Convention
    dummies: float = 0.15
    textbook_ends: bool = False
    signed_rows: bool = True
    keep_zero: bool = False
    keep_direction: bool = False


def cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """a × b; many times faster than numpy's for single vectors."""
    (x, y, z), (u, v, w) = a.tolist(), b.tolist()
    return np.array((y * w - z * v, z * u - x * w, x * v - y * u))


def length_of(v: np.ndarray) -> float:
    return math.sqrt(float(v @ v))


def rotation(axis: np.ndarray, angle: float) -> np.ndarray:
    x, y, z = axis
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * k + (1 - math.cos(angle)) * (k @ k)


def random_direction(rng: Random) -> np.ndarray:
    v = np.array([rng.gauss(0, 1) for _ in range(3)])
    return v / length_of(v)


def random_rotation(rng: Random) -> np.ndarray:
    return rotation(random_direction(rng), rng.uniform(-math.pi, math.pi))


def some_normal(direction: np.ndarray, rng: Random) -> np.ndarray:
    v = cross(direction, random_direction(rng))
    return v / length_of(v)


@lru_cache(maxsize=1024)
def robot_of(table: NumericTable) -> Robot:
    """The joint axes and the last frame of a table at q = 0."""
    return robot_at(table, (0.0,) * table.n_joints)


def robot_at(table: NumericTable, values: tuple[float, ...]) -> Robot:
    """The joint axes and the last frame of a table at a configuration."""
    poses = forward_kinematics(table, values)
    before = [np.eye(4), *poses.frames]
    joints = []
    for i in table.joint_rows:
        frame = before[i] if table.convention is Convention.STANDARD else before[i + 1]
        row = table.rows[i]
        joints.append(Joint(row.joint, frame[:3, 3].copy(), row.sign * frame[:3, 2]))
    size = sum(abs(r.a) + abs(r.d) for r in table.rows) or 1.0
    return Robot(tuple(joints), poses.transform, min(size, 20.0))


def moved(robot: Robot, rng: Random) -> Robot:
    """The same robot with every joint moved by some amount, and carried elsewhere as a whole."""
    R = random_rotation(rng)
    p = np.array([rng.uniform(-1, 1) for _ in range(3)]) * robot.size
    joints = []
    for joint in robot.joints:
        here = Joint(joint.type, R @ joint.point + p, R @ joint.direction)
        joints.append(here)
        if joint.type is JointType.REVOLUTE:
            turn = rotation(here.direction, rng.uniform(-math.pi, math.pi))
            R, p = turn @ R, turn @ (p - here.point) + here.point
        else:
            p = p + rng.uniform(-1, 1) * robot.size * here.direction
    tool = np.eye(4)
    tool[:3, :3] = R @ robot.tool[:3, :3]
    tool[:3, 3] = R @ robot.tool[:3, 3] + p
    return Robot(tuple(joints), tool, robot.size)


def lines_of(robot: Robot, rng: Random, choices: Choices) -> list[Line]:
    """The z axes, in order: the joints' and, now and then, dummies; one more at the free end."""
    scale = robot.size

    def dummy() -> Line:
        point = np.array([rng.uniform(-1, 1) for _ in range(3)]) * scale + robot.joints[0].point
        return Line(point, random_direction(rng), JointType.FIXED, 1)

    lines: list[Line] = []
    for joint in robot.joints:
        if rng.random() < choices.dummies:
            lines.append(dummy())
        z_sign = rng.choice((1, -1))
        point = joint.point + rng.uniform(-1, 1) * scale * joint.direction
        if joint.type is JointType.PRISMATIC:
            point = point + np.array([rng.uniform(-1, 1) for _ in range(3)]) * scale
        row_sign = rng.choice((1, -1)) if choices.signed_rows else 1
        if choices.keep_direction:
            row_sign = z_sign
        lines.append(Line(point, z_sign * joint.direction, joint.type, row_sign))
    return lines


def end_line(robot: Robot, rng: Random, choices: Choices, joint: Joint) -> Line:
    """The line at the free end of the chain: z_N of a standard table, z_0 of a modified one."""
    if choices.textbook_ends or rng.random() < 0.3:
        sign = rng.choice((1, -1))
        point = joint.point + rng.uniform(-1, 1) * robot.size * joint.direction
        return Line(point, sign * joint.direction, JointType.FIXED, 1)
    point = np.array([rng.uniform(-1, 1) for _ in range(3)]) * robot.size + joint.point
    return Line(point, random_direction(rng), JointType.FIXED, 1)


@dataclass(frozen=True)
class Normal:
    """A common normal: its feet on the first and on the second line, and its unit direction (the x axis)."""

    first: np.ndarray
    second: np.ndarray
    direction: np.ndarray


def common_normal(one: Line, two: Line, rng: Random, scale: float) -> Normal:
    """A common normal of two lines: any of them, where there are many; x either way, where both will do."""
    u, v, w = one.direction, two.direction, two.point - one.point
    across = cross(u, v)
    sine = length_of(across)
    if sine < MEETING:
        foot = one.point + rng.uniform(-1, 1) * scale * u
        gap = two.point - foot
        gap = gap - (gap @ u) * u
        distance = length_of(gap)
        if distance < MEETING * scale:
            return Normal(foot, foot, some_normal(u, rng))
        return Normal(foot, foot + gap, rng.choice((1, -1)) * gap / distance)
    s = float(cross(w, v) @ across) / sine**2
    t = float(cross(w, u) @ across) / sine**2
    return Normal(one.point + s * u, two.point + t * v, rng.choice((1, -1)) * across / sine)


def angle(a: np.ndarray, b: np.ndarray, about: np.ndarray) -> float:
    return math.atan2(float(about @ cross(a, b)), float(a @ b))


def draw_table(robot: Robot, rng: Random, choices: Choices) -> NumericTable:
    """A random valid table of the robot as it stands (see `moved` for other zeros and another place)."""
    lines = lines_of(robot, rng, choices)
    standard = choices.convention is Convention.STANDARD
    if standard:
        lines.append(end_line(robot, rng, choices, robot.joints[-1]))
    else:
        lines.insert(0, end_line(robot, rng, choices, robot.joints[0]))
    normals = [common_normal(a, b, rng, robot.size) for a, b in pairwise(lines)]
    free = lines[0] if standard else lines[-1]
    loose_x = some_normal(free.direction, rng)
    loose_o = free.point + rng.uniform(-1, 1) * robot.size * free.direction
    rows = []
    for i, normal in enumerate(normals):
        one, two = lines[i], lines[i + 1]
        a = float((normal.second - normal.first) @ normal.direction)
        alpha = angle(one.direction, two.direction, normal.direction)
        if standard:
            x, o = (loose_x, loose_o) if i == 0 else (normals[i - 1].direction, normals[i - 1].second)
            turning = one
            theta = angle(x, normal.direction, one.direction)
            d = float((normal.first - o) @ one.direction)
        else:
            last = i == len(normals) - 1
            x, o = (loose_x, loose_o) if last else (normals[i + 1].direction, normals[i + 1].first)
            turning = two
            theta = angle(normal.direction, x, two.direction)
            d = float((o - normal.second) @ two.direction)
        rows.append(DHRow(joint=turning.joint, theta=theta, d=d, a=a, alpha=alpha, sign=turning.sign))
    return DHTable(convention=choices.convention, rows=tuple(rows))


def random_valid_table(table: NumericTable, rng: Random, **changes: object) -> NumericTable:
    """A random valid table of the robot that a table describes."""
    usual = Choices(convention=rng.choice(list(Convention)), dummies=rng.choice((0.0, 0.0, 0.3)))
    choices = replace(usual, **changes)
    robot = robot_of(table)
    return draw_table(robot if choices.keep_zero else moved(robot, rng), rng, choices)


RIGHT_ANGLES = (0.0, math.pi / 2, -math.pi / 2, math.pi, 0.0, math.pi / 2)


def random_robot(rng: Random, joints: int | None = None) -> NumericTable:
    """A random robot, full of parallel, coincident, perpendicular, intersecting and prismatic axes."""
    n = joints or rng.randint(1, 12)
    rows = []
    prismatic_share = rng.choice((0.0, 0.2, 0.2, 0.5, 1.0))
    skew_share = rng.choice((0.0, 0.2, 1.0))
    zero_share = rng.choice((0.1, 0.5, 0.9, 1.0)) if rng.random() < 0.9 else 0.5

    def length() -> float:
        return 0.0 if rng.random() < zero_share else rng.choice((-1, 1)) * rng.uniform(0.1, 1.0)

    for _ in range(n):
        joint = JointType.PRISMATIC if rng.random() < prismatic_share else JointType.REVOLUTE
        alpha = rng.uniform(-3, 3) if rng.random() < skew_share else rng.choice(RIGHT_ANGLES)
        theta = rng.choice((0.0, math.pi / 2, math.pi, rng.uniform(-3, 3)))
        rows.append(
            DHRow(joint=joint, theta=theta, d=length(), a=length(), alpha=alpha, sign=rng.choice((1, 1, -1)))
        )
    return DHTable(convention=rng.choice(list(Convention)), rows=tuple(rows))


def rounded(table: NumericTable, decimals: int) -> NumericTable:
    """Every entry as a student rounds it."""
    return DHTable(
        convention=table.convention,
        rows=tuple(
            replace(
                row,
                theta=round(row.theta, decimals),
                d=round(row.d, decimals),
                a=round(row.a, decimals),
                alpha=round(row.alpha, decimals),
            )
            for row in table.rows
        ),
    )
