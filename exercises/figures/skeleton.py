"""The figure that a DH table alone gives, for whatever a specification leaves out.

Links run along the table's own common normals: O_{i-1} → foot → O_i. Bodies stand on the axes, and those that
would stand in one another (a wrist) move apart along their axes.
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise

import numpy as np

from exercises.figures.specification import (
    DimensionMark,
    FigureSpecification,
    Ground,
    JointMark,
    Point,
    PointAlongAxis,
    PointBeside,
    PointBetween,
    PointInFrame,
)
from exercises.grading.judging.exact_text import expression_text
from kinematics.expressions import ZERO, Expression, negate, number, rational_value
from kinematics.se3 import Floats
from kinematics.table import Convention, JointType, SymbolicTable, bind

CLOSE = 0.05  # Bodies closer than this, relative to the robot's reach, move apart.

APART = 0.14  # How far they move, relative to the robot's reach.

ABOVE = 0.1  # From which height above O0 joint 1 stands on the ground there, relative to the robot's reach.


def says_all(specification: FigureSpecification, reference: SymbolicTable) -> bool:
    """Return whether a specification leaves nothing out that `completed` adds, but names of points."""
    joints = range(1, reference.n_joints + 1)
    return bool(specification.links and specification.dimensions) and all(
        joint in specification.joints for joint in joints
    )


def completed(
    specification: FigureSpecification,
    reference: SymbolicTable,
    values: Mapping[str, float],
    frames: Sequence[Floats],
) -> FigureSpecification:
    """Complete the specification with links, bodies, dimensions and ground where it says nothing.

    Args:
        reference: the table.
        values: value of every parameter.
        frames: (4, 4) poses of frame 0 … N of the reference at the figure's posture.
    """
    points: dict[str, Point] = {**_feet(reference), **specification.points}
    reach = sum(abs(row.a) + abs(row.d) for row in bind(reference, values).rows) or 1.0
    joints = dict(_bodies(reference, frames, points, reach))
    joints.update(specification.joints)
    chain = specification.links or (_chain(reference, joints, points),)
    ground = specification.ground
    if ground is None and not specification.links:
        if _stands_on_base(reference, frames, reach):
            points.setdefault("ground", PointInFrame(frame=0, at=(ZERO, ZERO, ZERO)))
        drop = number(Fraction(round(0.25 * reach * 1e6), 1_000_000))
        points.setdefault("ground", PointBeside(origin=chain[0][0], by=(ZERO, ZERO, negate(drop))))
        chain = (("ground", *chain[0]), *chain[1:])
        ground = Ground(at="ground")
    return replace(
        specification,
        points=points,
        joints=joints,
        links=chain,
        dimensions=specification.dimensions or tuple(usual_dimensions(reference)),
        ground=ground,
    )


def _feet(table: SymbolicTable) -> dict[str, Point]:
    """The foot of each row's common normal on the axis about which θ turns."""
    if table.convention is Convention.STANDARD:
        return {
            f"foot{i}": PointInFrame(frame=i, at=(negate(row.a), ZERO, ZERO))
            for i, row in enumerate(table.rows, 1)
        }
    return {
        f"foot{i}": PointInFrame(frame=i - 1, at=(row.a, ZERO, ZERO)) for i, row in enumerate(table.rows, 1)
    }


def _chain(
    table: SymbolicTable, joints: Mapping[int, JointMark], points: Mapping[str, Point]
) -> tuple[str, ...]:
    """Names of the points that the links run through: the body of the last joint stands between its links.

    Where it was moved off the end of the link before it, the next link begins at the body.
    """
    last = table.n_joints
    names = [joints[1].at if joints else "O0"]
    axis = table.joint_rows[-1] + (table.convention is Convention.MODIFIED) if joints else None
    for i in range(len(table.rows) + 1):
        steps = [f"foot{i}", f"O{i}"] if i else []
        if axis is not None and i == axis + 1 and _moved(joints[last], last, points):
            steps.remove(f"foot{i}")
        names += steps
        if i == axis:
            names.append(joints[last].at)
    return tuple(names)


def _moved(mark: JointMark, joint: int, points: Mapping[str, Point]) -> bool:
    return mark.at == f"joint{joint}" and f"joint{joint}on" in points


def _bodies(
    table: SymbolicTable, frames: Sequence[Floats], points: dict[str, Point], reach: float
) -> list[tuple[int, JointMark]]:
    """A body per joint in the middle of its offset d, moved along the axis where two would meet."""
    standard = table.convention is Convention.STANDARD
    for joint, i in enumerate(table.joint_rows, 1):
        start, end = (f"O{i}", f"foot{i + 1}") if standard else (f"foot{i + 1}", f"O{i + 1}")
        points.setdefault(f"joint{joint}", PointBetween(start=start, end=end, ratio=0.5))
    centres = [_centre(table, frames, joint) for joint in range(1, table.n_joints + 1)]
    for group in _groups(centres, CLOSE * reach):
        _spread(group, table, frames, points, reach, centres)
    return [(joint, JointMark(at=f"joint{joint}")) for joint in range(1, table.n_joints + 1)]


def _centre(table: SymbolicTable, frames: Sequence[Floats], joint: int) -> Floats:
    """The middle of a joint's offset d."""
    i = table.joint_rows[joint - 1]
    pose, other = frames[i : i + 2] if table.convention is Convention.STANDARD else frames[i : i + 2][::-1]
    along = (other[:3, 3] - pose[:3, 3]) @ pose[:3, 2]
    return np.asarray(pose[:3, 3] + 0.5 * along * pose[:3, 2], dtype=np.float64)


def _stands_on_base(table: SymbolicTable, frames: Sequence[Floats], reach: float) -> bool:
    """Whether joint 1 stands straight above O0."""
    if not table.joint_rows:
        return False
    x, y, rise = _centre(table, frames, 1) - frames[0][:3, 3]
    return bool(abs(x) + abs(y) < 1e-6 * reach and rise > ABOVE * reach)


def _groups(centres: Sequence[Floats], close: float) -> list[list[int]]:
    groups: list[list[int]] = []
    for joint, centre in enumerate(centres, 1):
        if groups and np.linalg.norm(centres[groups[-1][-1] - 1] - centre) < close:
            groups[-1].append(joint)
        else:
            groups.append([joint])
    return [group for group in groups if len(group) > 1]


def _spread(
    group: Sequence[int],
    table: SymbolicTable,
    frames: Sequence[Floats],
    points: dict[str, Point],
    reach: float,
    centres: Sequence[Floats],
) -> None:
    """Bodies whose axes run along a link slide onto it, back to the one before or on to the one behind.

    The last joint of the robot slides on along its own axis, joint 1 down towards the ground; others stay.
    """
    bones = _bones(table, frames)
    for joint in group:
        i = table.joint_rows[joint - 1]
        axis = frames[table.axis_frames[joint - 1]][:3, 2]
        here = centres[joint - 1]
        back = _away(here, bones[: 2 * i + 1][::-1]) if joint > 1 else np.array([0.0, 0.0, -1.0])
        on = _away(here, bones[2 * i + 1 :])
        is_last = joint == table.n_joints > 1
        if back is not None and _runs_along(axis, back) and not is_last:
            sense = 1 if axis @ back > 0 else -1
        elif on is not None and _runs_along(axis, on):
            sense = 1 if axis @ on > 0 else -1
        elif is_last:
            sense = -1 if back is not None and axis @ back > 0 else 1
        else:
            continue
        distance = number(Fraction(round(sense * APART * reach * 1e6), 1_000_000))
        name = f"joint{joint}"
        points[f"{name}on"] = points[name]
        points[name] = PointAlongAxis(origin=f"{name}on", joint=joint, distance=distance)


def _bones(table: SymbolicTable, frames: Sequence[Floats]) -> list[Floats]:
    """O_0, foot_1, O_1, foot_2, …: the feet follow from the frames, for they stand where two axes say so."""
    standard = table.convention is Convention.STANDARD
    bones = [frames[0][:3, 3]]
    for before, after in pairwise(frames):
        pose, other = (before, after) if standard else (after, before)
        along = (other[:3, 3] - pose[:3, 3]) @ pose[:3, 2]
        bones += [pose[:3, 3] + along * pose[:3, 2], after[:3, 3]]
    return bones


def _away(here: Floats, path: Sequence[Floats]) -> Floats | None:
    """The direction to the first point of a path that is elsewhere."""
    for point in path:
        distance = float(np.linalg.norm(point - here))
        if distance > 1e-9:
            return np.asarray((point - here) / distance, dtype=np.float64)
    return None


def _runs_along(axis: Floats, direction: Floats) -> bool:
    return abs(float(axis @ direction)) > 1 - 1e-6


def usual_dimensions(table: SymbolicTable) -> list[DimensionMark]:
    """Return a dimension for each constant length as in the table; one of a length and its opposite."""
    standard = table.convention is Convention.STANDARD
    marks: list[DimensionMark] = []
    for i, row in enumerate(table.rows, 1):
        spans = [(row.a, *((f"foot{i}", f"O{i}") if standard else (f"O{i - 1}", f"foot{i}")))]
        if row.joint is not JointType.PRISMATIC:
            spans.append((row.d, *((f"O{i - 1}", f"foot{i}") if standard else (f"foot{i}", f"O{i}"))))
        for value, start, end in spans:
            if rational_value(value) != 0 and all(mark.value != negate(value) for mark in marks):
                marks.append(DimensionMark(name=_name(value), value=value, start=start, end=end))
    return marks


def _name(value: Expression) -> str:
    """A length without its sign, as it is read off a drawing."""
    size = rational_value(value)
    if size is not None:
        return f"{abs(float(size)):.6g}"
    text = min(expression_text(value), expression_text(negate(value)), key=len)
    return re.sub(r"(?<![\w.])([0-9.]+)\*", r"\1", text).replace("*", "·")  # Lpi would be another name
