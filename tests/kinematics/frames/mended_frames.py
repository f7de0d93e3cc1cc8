"""Frames spoilt and mended, judged by the matrices of the rows that would follow, not by any rule."""

from collections.abc import Iterator, Sequence

import numpy as np

from kinematics.frames.assignment import assign_frames
from kinematics.frames.axes import JointAxis
from kinematics.frames.wrong_frames import (
    DrawnFrame,
    frame_mistakes,
    mends,
    plantable_in_frames,
    right_handed,
)
from kinematics.table import Convention, JointType
from tests.kinematics.frames.chains import KINDS, direction_of, random_chain, rotation

NEAR = 1e-5
"""Above what the rules forgive, below what is changed here."""
STEP = 0.01


def follow_from_rows(axes: Sequence[JointAxis], convention: Convention, frames: Sequence[DrawnFrame]) -> bool:
    """Whether each frame is reached from the one before by the motions of a row, along the joints' axes."""
    poses = []
    for frame in frames:
        pose = np.eye(4)
        for k, column in enumerate((frame.x, frame.y, frame.z, frame.origin)):
            pose[:3, k] = column
        if abs(np.linalg.det(pose[:3, :3]) - 1) > NEAR:
            return False
        poses.append(pose)
    behind = convention is Convention.MODIFIED
    for i, axis in enumerate(axes):
        held, u = poses[i + behind], direction_of(axis)
        if np.linalg.norm(np.cross(held[:3, 2], u)) > NEAR:
            return False
        if axis.joint is JointType.REVOLUTE and (
            np.linalg.norm(np.cross(held[:3, 3] - np.array(axis.point, float), u)) > NEAR
        ):
            return False
        step = np.linalg.inv(poses[i]) @ poses[i + 1]
        if np.abs(step - _row(step, convention)).max() > NEAR:
            return False
    return True


def _row(step: np.ndarray, convention: Convention) -> np.ndarray:
    """The four motions of the row that comes nearest to a step."""
    r, p = step[:3, :3], step[:3, 3]
    theta, d, a, alpha = (np.eye(4) for _ in range(4))
    if convention is Convention.STANDARD:
        turn, twist = np.arctan2(r[1, 0], r[0, 0]), np.arctan2(r[2, 1], r[2, 2])
        d[2, 3], a[0, 3] = p[2], p[0] * np.cos(turn) + p[1] * np.sin(turn)
    else:
        turn, twist = np.arctan2(-r[0, 1], r[0, 0]), np.arctan2(-r[1, 2], r[2, 2])
        a[0, 3], d[2, 3] = p[0], p[2] * np.cos(twist) - p[1] * np.sin(twist)
    theta[:3, :3] = rotation(np.array([0.0, 0.0, 1.0]), turn)
    alpha[:3, :3] = rotation(np.array([1.0, 0.0, 0.0]), twist)
    return theta @ d @ a @ alpha if convention is Convention.STANDARD else alpha @ a @ theta @ d


def cases(count: int, seed: int) -> Iterator[tuple[bool, bool]]:
    """What is said of frames, and what their rows say."""
    rng = np.random.default_rng(seed)
    made = 0
    while made < count:
        axes = random_chain(rng, KINDS[rng.integers(len(KINDS))], most=6)
        convention = list(Convention)[rng.integers(2)]
        assigned = assign_frames(axes, convention)
        frames = [right_handed(frame.origin, frame.x, frame.z) for frame in assigned.frames]
        ways = [way for found in plantable_in_frames(axes, convention, frames).values() for way in found]
        for way in rng.permutation(np.arange(len(ways)))[:6]:
            planted = ways[way]
            yield (
                not any(frame_mistakes(axes, convention, planted.shown)),
                follow_from_rows(axes, convention, planted.shown),
            )
            for index, frame in ((planted.index, other) for other in _others(planted.right, rng)):
                shown = [*planted.shown[:index], frame, *planted.shown[index + 1 :]]
                yield (
                    mends(axes, convention, planted, index, frame),
                    follow_from_rows(axes, convention, shown),
                )
                made += 1
            made += 1


def _others(frame: DrawnFrame, rng: np.random.Generator) -> Iterator[DrawnFrame]:
    """The frame, the frame the other way round, turned about one of its axes, slid, and with a wrong y."""
    x, y, z, o = (np.array(part) for part in (frame.x, frame.y, frame.z, frame.origin))
    yield frame
    yield _frame(o, -x, z)
    yield _frame(o, x, -z)
    turn = rotation((x, y, z)[rng.integers(3)], rng.choice((-1, 1)) * rng.uniform(STEP, 3.0))
    yield _frame(o, turn @ x, turn @ z)
    yield _frame(o + rng.uniform(STEP, 1.0) * (x, y, z)[rng.integers(3)], x, z)
    yield DrawnFrame(frame.origin, frame.x, _vector(-y), frame.z)


def _frame(origin: np.ndarray, x: np.ndarray, z: np.ndarray) -> DrawnFrame:
    return right_handed(_vector(origin), _vector(x), _vector(z))


def _vector(column: np.ndarray) -> tuple[float, float, float]:
    return float(column[0]), float(column[1]), float(column[2])
