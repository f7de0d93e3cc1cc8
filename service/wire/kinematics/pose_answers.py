"""Poses as the wire shows them: parts of an answer, for one configuration or for a batch sent in blocks."""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum

import numpy as np
import orjson

from kinematics.errors import Fault, JointValueError
from kinematics.evaluation.plan import plan_of
from kinematics.forward import ForwardKinematics, end_poses, forward_kinematics
from kinematics.pose_batches import (
    axis_angles_from_transforms,
    quaternions_from_transforms,
    xyzabcs_from_transforms,
)
from kinematics.poses import pose_notations
from kinematics.se3 import Floats, inverse_transform
from kinematics.table import JointType
from service.http.npy import npy_data, npy_header
from service.wire.json_chunks import blocks, list_chunks, written
from service.wire.kinematics.link_points import LinkPoint, place_chunks, places_of
from service.wire.kinematics.prepared_robots import PreparedRobot

Matrix = Sequence[Sequence[float]]

JSON_BLOCK = 256
NPY_BLOCK = 16384  # Poses that are computed and written at a time, as JSON and as bytes: memory stays flat.
_SAFE_REACH = 1e150  # Lengths below it can be squared and summed within a double's range.
_QUATERNION, _RPY, _XYZABC, _AXIS, _ANGLE = slice(0, 4), slice(4, 7), slice(7, 13), slice(13, 16), 16
_POSITION = slice(7, 10)


class PoseQuantity(StrEnum):
    """A part of the answer that may be asked for."""

    TRANSFORM = "transform"
    LINKS = "links"
    FRAMES = "frames"
    POSITION = "position"
    ORIENTATION = "orientation"
    INVERSE = "inverse"


STANDARD_PARTS = (
    PoseQuantity.TRANSFORM,
    PoseQuantity.LINKS,
    PoseQuantity.FRAMES,
    PoseQuantity.POSITION,
    PoseQuantity.ORIENTATION,
)


@dataclass(frozen=True, kw_only=True, slots=True)
class PoseQuestion:
    """What is to be computed.

    Attributes:
        joints: q_1 … q_n, or (m, n) of them, in [rad] and in the table's length unit.
        base: pose of frame 0 in the world, or None.
        tool: pose of the tool in frame N, or None.
        parts: what is wanted of the answer.
        points: of links, whose places are wanted: the number of the frame, from 1, and coordinates in it.
    """

    robot: PreparedRobot
    joints: list[float] | Floats
    parts: Sequence[PoseQuantity]
    base: Matrix | None = None
    tool: Matrix | None = None
    points: Sequence[LinkPoint] = ()

    def poses(self, start: int | None = None, stop: int | None = None) -> ForwardKinematics:
        """Return the poses, or those of a block of the batch."""
        joints = self.joints if start is None else self.joints[start:stop]
        return forward_kinematics(self.robot.table, joints, base=self.base, tool=self.tool)

    def array(self, part: PoseQuantity, start: int, stop: int) -> Floats:
        """Return a part of the answer, of a block of the batch."""
        if part is PoseQuantity.TRANSFORM:
            return end_poses(self.robot.table, self.joints[start:stop], base=self.base, tool=self.tool)
        return _ARRAYS[part](self.poses(start, stop))


_ARRAYS: dict[PoseQuantity, Callable[[ForwardKinematics], Floats]] = {
    PoseQuantity.TRANSFORM: lambda poses: poses.transform,
    PoseQuantity.LINKS: lambda poses: poses.links,
    PoseQuantity.FRAMES: lambda poses: poses.frames,
    PoseQuantity.POSITION: lambda poses: poses.transform[..., :3, 3].copy(),
    PoseQuantity.INVERSE: lambda poses: inverse_transform(poses.transform),
}
ARRAY_PARTS = tuple(_ARRAYS)


def one_answer(question: PoseQuestion) -> bytes:
    """Return the answer for one configuration, as JSON."""
    poses = question.poses()
    answer: dict[str, object] = {**question.robot.units}
    if question.parts is STANDARD_PARTS:
        _add_standard_parts(answer, poses, question.robot.angle)
    else:
        for part in question.parts:
            if part is PoseQuantity.ORIENTATION:
                answer[part.value] = orientation_of(poses.transform, question.robot.angle)
            else:
                answer[part.value] = _ARRAYS[part](poses)
    if question.points:
        answer["points"] = places_of(question.points, poses)
    return orjson.dumps(answer, option=orjson.OPT_SERIALIZE_NUMPY)


def _add_standard_parts(answer: dict[str, object], poses: ForwardKinematics, angle: float) -> None:
    """What nearly every request wants, without looking each part up."""
    row = _notations(poses.transform, angle)
    answer["transform"] = poses.transform
    answer["links"] = poses.links
    answer["frames"] = poses.frames
    answer["position"] = row[_POSITION]
    answer["orientation"] = _orientation(row)


def json_blocks(question: PoseQuestion) -> Iterator[bytes]:
    """Yield the answer for a batch, as pieces of one JSON document."""
    yield orjson.dumps(question.robot.units)[:-1]
    for part in question.parts:
        if part is PoseQuantity.ORIENTATION:
            yield from _orientations(question)
            continue
        yield f',"{part}":['.encode()
        for start, stop in blocks(len(question.joints), JSON_BLOCK):
            yield (b"," if start else b"") + written(question.array(part, start, stop))[1:-1]
        yield b"]"
    if question.points:
        yield b',"points":'
        yield from place_chunks(question.points, len(question.joints), question.poses)
    yield b"}"


def npy_blocks(question: PoseQuestion) -> Iterator[bytes | memoryview]:
    """Yield the one array that is wanted of a batch, as pieces of an npy file."""
    (part,) = question.parts
    yield npy_header(npy_shape(question))
    for start, stop in blocks(len(question.joints), NPY_BLOCK):
        yield npy_data(question.array(part, start, stop))


def npy_shape(question: PoseQuestion) -> tuple[int, ...]:
    """Return the shape of the one array that is wanted."""
    (part,) = question.parts
    rows = len(question.robot.table.rows)
    shapes: dict[PoseQuantity, tuple[int, ...]] = {
        PoseQuantity.LINKS: (rows, 4, 4),
        PoseQuantity.FRAMES: (rows, 4, 4),
        PoseQuantity.POSITION: (3,),
    }
    batch = (len(question.joints),) if isinstance(question.joints, np.ndarray) else ()
    return (*batch, *shapes.get(part, (4, 4)))


def npy_length(question: PoseQuestion) -> int:
    """Return the length of that npy file [byte]."""
    shape = npy_shape(question)
    return len(npy_header(shape)) + math.prod(shape) * 8


def one_array(question: PoseQuestion) -> bytes:
    """Return the one array that is wanted at one configuration, as an npy file."""
    (part,) = question.parts
    return npy_header(npy_shape(question)) + npy_data(_ARRAYS[part](question.poses()))


def check_batch(question: PoseQuestion) -> None:
    """Make sure before anything is sent that a batch has an answer.

    Raises:
        PoseError: base or tool is not a rigid transform.
        JointValueError: a result overflows, at the configuration where it does.
    """
    plan_of(question.robot.table, question.base, question.tool)
    if may_overflow(question):
        refuse_overflow(question)


def may_overflow(question: PoseQuestion) -> bool:
    """Return whether a result may be too large for a double, and `refuse_overflow` has something to do."""
    return _reach(question) >= _SAFE_REACH


def refuse_overflow(question: PoseQuestion) -> None:
    """Make sure before anything is sent that every result of a batch is finite.

    Raises:
        JointValueError: a result overflows, at the configuration where it does.
    """
    for start, stop in blocks(len(question.joints), NPY_BLOCK):
        try:
            poses = question.poses(start, stop)
            for part in ARRAY_PARTS:
                _ARRAYS[part](poses)
        except JointValueError as error:
            raise JointValueError(_later(fault, start) for fault in error.faults) from None


def _reach(question: PoseQuestion) -> float:
    """No frame is further from the world's origin than this, nor the world from the end frame."""
    table = question.robot.table
    reach = sum(abs(row.a) + abs(row.d) for row in table.rows)
    poses = [pose for pose in (question.base, question.tool) if pose]
    reach += sum(abs(x) for pose in poses for row in pose[:3] for x in row[3:4])
    prismatic = [i for i, joint in enumerate(table.joint_types) if joint is JointType.PRISMATIC]
    joints = np.asarray(question.joints)
    if prismatic and joints.size:
        reach += float(np.abs(joints[..., prismatic]).max()) * len(prismatic)
    return reach


def _notations(transform: Floats, angle: float) -> list[float]:
    """Quaternion, roll, pitch and yaw, X Y Z A B C, axis, angle: in one row, angles in the answer's unit."""
    _, quaternion, rpy, (axis, turn), xyzabc = pose_notations(transform)
    if angle == 1.0:
        return [*quaternion, *rpy, *xyzabc, *axis, turn]
    roll, pitch, yaw = (value / angle for value in rpy)
    return [*quaternion, roll, pitch, yaw, *xyzabc[:3], yaw, pitch, roll, *axis, turn / angle]


def orientation_of(transform: Floats, angle: float) -> dict[str, object]:
    """Return the orientation of a pose in four notations, angles in units of so many [rad]."""
    return _orientation(_notations(transform, angle))


def _orientation(row: list[float]) -> dict[str, object]:
    return {
        "quaternion": row[_QUATERNION],
        "rpy": row[_RPY],
        "axis_angle": {"axis": row[_AXIS], "angle": row[_ANGLE]},
        "xyzabc": row[_XYZABC],
    }


def _orientations(question: PoseQuestion) -> Iterator[bytes]:
    count, angle = len(question.joints), question.robot.angle
    quaternion, axis = np.empty((count, 4)), np.empty((count, 3))
    turn, xyzabc = np.empty(count), np.empty((count, 6))
    for start, stop in blocks(count, NPY_BLOCK):
        poses = question.poses(start, stop).transform
        quaternion[start:stop] = quaternions_from_transforms(poses)
        axis[start:stop], turn[start:stop] = axis_angles_from_transforms(poses)
        xyzabc[start:stop] = xyzabcs_from_transforms(poses)
        yield b""
    turn /= angle
    xyzabc[:, 3:] /= angle
    yield b',"orientation":{"quaternion":'
    yield from list_chunks(quaternion)
    yield b',"rpy":'
    yield from list_chunks(xyzabc[:, :2:-1])
    yield b',"axis_angle":{"axis":'
    yield from list_chunks(axis)
    yield b',"angle":'
    yield from list_chunks(turn)
    yield b'},"xyzabc":'
    yield from list_chunks(xyzabc)
    yield b"}"


def _later(fault: Fault, start: int) -> Fault:
    """A block's fault, counted from the start of the batch."""
    match fault.where:
        case (name, int(i), *rest):
            return Fault.at(fault.code, name, start + i, *rest, **fault.params)
    return fault
