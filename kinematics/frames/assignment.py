"""Joint axes in, a DH table out, by the procedure of the lecture documents.

The common normals of neighbouring axes carry the whole table: a_i and α_i lie along normal i, d_i and θ_i
lead along and about axis i from normal i-1 to normal i. Both conventions read the same figure; they differ
in where frame i sits (modified: where normal i leaves axis i; standard: where it reaches axis i+1) and in
what the first and the last frame leave free.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from kinematics.errors import DescriptionError, Fault
from kinematics.forward import forward_kinematics
from kinematics.frames.assigned_frames import AssignedFrame, FrameAssignment, Freedom, Rule
from kinematics.frames.axes import AxisLine, Gripper, JointAxis, Pose, ends_of, matrix, read_axes, robot_size
from kinematics.frames.directions import CrossProduct, LengthSigns, choose_directions
from kinematics.frames.ends import may_stand, meeting
from kinematics.frames.exactness import clean_angle, clean_length
from kinematics.frames.levels import settle_levels
from kinematics.frames.normals import EXACT_ANGLE, CommonNormal, Relation, common_normal
from kinematics.frames.parallels import (
    MAX_PARALLEL_TOLERANCE,
    PARALLEL_TOLERANCE,
    NearParallel,
    straighten,
    with_dummies,
)
from kinematics.frames.placement import draw_prismatic_axes
from kinematics.frames.remarks import tilt_remarks
from kinematics.se3 import Transform, Vector, angle_from_to, cross, dot, scale, subtract
from kinematics.table import Convention, DHRow, DHTable, JointType, NumericTable

_UNFIT_BASE = {
    Convention.STANDARD: "base_not_frame_zero_standard",
    Convention.MODIFIED: "base_not_frame_zero_modified",
}
_UNFIT_TOOL = {
    Convention.STANDARD: "tool_not_last_frame_standard",
    Convention.MODIFIED: "tool_not_last_frame_modified",
}
"""Warnings that a given frame cannot be frame 0, or frame N."""


@dataclass(frozen=True, slots=True)
class _Geometry:
    """The figure that both conventions read: axes, normals, their feet, the x directions, the end frames."""

    lines: Sequence[AxisLine]
    normals: Sequence[CommonNormal]
    feet: Sequence[tuple[Vector, Vector]]
    x: Sequence[Vector]
    first: Pose | None
    last: Pose | None
    entry: Vector | None
    exit: Vector | None
    size: float


def assign_frames(
    axes: Sequence[JointAxis],
    convention: Convention,
    *,
    base: ArrayLike | None = None,
    tool: ArrayLike | Gripper | None = None,
    parallel_tolerance: float = PARALLEL_TOLERANCE,
    near_parallel: NearParallel = NearParallel.PARALLEL,
    lengths: LengthSigns = LengthSigns.POSITIVE,
    intersecting: CrossProduct = CrossProduct.FEWEST,
) -> FrameAssignment:
    """Return a DH table for a robot of which the joint axes are known.

    base · table · tool reproduces every axis and the tool at every q: exactly (each angle to 1e-10 rad, each
    length to 1e-10 of the robot's size) unless axes are near-parallel; those are taken as parallel, with a
    warning that states the tilt, or joined by a fixed dummy row.

    Args:
        axes: the axes, base first, at the zero position: the joint variables count from there.
        base: (4, 4) frame wanted as frame 0; taken where the convention can hold it (standard: z along
            axis 1, origin on it; modified: x across axis 1 and through it), otherwise left with a warning.
        tool: (4, 4) pose of the tool, or the gripper, at the zero position; it becomes frame N where the
            convention can hold it (standard: x across axis N and through it; modified: z along axis N, origin
            on it); what is left over is returned as `tool`.
        parallel_tolerance: tilt [rad] below which axes are near-parallel; 1e-10 turns it off.
        near_parallel: what becomes of near-parallel axes.
        lengths: whether lengths may be negative where that spares an offset of a joint.
        intersecting: which cross product x is where axes intersect; by default the one that leaves fewest
            angles.

    Raises:
        DescriptionError: malformed axes, frames or tolerance.

    Source: seed 000 §3.2.4; seed 002 steps 1 to 8; seed 004.
    """
    if not EXACT_ANGLE <= parallel_tolerance <= MAX_PARALLEL_TOLERANCE:
        fault = Fault.at(
            "parallel_tolerance_out_of_range",
            "parallel_tolerance",
            least=f"{EXACT_ANGLE:g}",
            greatest=f"{MAX_PARALLEL_TOLERANCE:g}",
        )
        raise DescriptionError(fault)
    lines = read_axes(axes)
    first, last = ends_of(base, tool)
    size = robot_size(lines, first, last)
    if near_parallel is NearParallel.PARALLEL:
        lines, tilts = straighten(lines, parallel_tolerance)
    else:
        lines, tilts = with_dummies(lines, parallel_tolerance, size)
    geometry = _geometry(lines, convention, first, last, size, lengths, intersecting)
    table = _table(geometry, convention)
    frames = _frames(geometry, convention)
    base_pose = geometry.first or Pose(frames[0].origin, frames[0].x, frames[0].z)
    on_axis = [frame.origin for frame in frames[convention is Convention.MODIFIED :]]
    T_w_0 = matrix(base_pose)
    T_n_t = _remainder(geometry, table, T_w_0, last)
    warnings = tilt_remarks(tilts, table, on_axis, T_n_t, near_parallel)
    if first is not None and geometry.first is None:
        warnings.append(Fault.at(_UNFIT_BASE[convention], "base"))
    if last is not None and geometry.last is None:
        warnings.append(Fault.at(_UNFIT_TOOL[convention], "tool"))
    return FrameAssignment(
        table=table,
        base=T_w_0,
        tool=T_n_t,
        frames=frames,
        warnings=tuple(warnings),
    )


def _geometry(
    lines: Sequence[AxisLine],
    convention: Convention,
    first: Pose | None,
    last: Pose | None,
    size: float,
    lengths: LengthSigns,
    intersecting: CrossProduct,
) -> _Geometry:
    standard = convention is Convention.STANDARD
    start = first.origin if first and may_stand(first, lines[0], z_on_axis=standard) else None
    end = last.origin if last and may_stand(last, lines[-1], z_on_axis=not standard) else None
    lines = draw_prismatic_axes(lines, size, start=start, end=end)
    entry = meeting(first, lines[0], size, z_on_axis=standard) if first and start else None
    exit_ = meeting(last, lines[-1], size, z_on_axis=not standard) if last and end else None
    normals = [common_normal(one, other, size) for one, other in pairwise(lines)]
    taken_first, taken_last = first if entry else None, last if exit_ else None
    x = choose_directions(
        lines,
        normals,
        start=taken_first.x if taken_first else None,
        end=taken_last.x if taken_last else None,
        lengths=lengths,
        intersecting=intersecting,
    )
    feet = settle_levels(lines, normals, start=entry, end=exit_)
    return _Geometry(lines, normals, feet, x, taken_first, taken_last, entry, exit_, size)


def _ends(g: _Geometry) -> tuple[Vector, Vector]:
    """Where axis 1 is entered and axis N is left; at the neighbouring feet if no frame is given there."""
    if g.feet:
        return g.entry or g.feet[0][0], g.exit or g.feet[-1][1]
    point = g.entry or g.exit or g.lines[0].point
    return point, g.exit or point


def _table(g: _Geometry, convention: Convention) -> NumericTable:
    n = len(g.lines)
    entry, exit_ = _ends(g)
    reached = [entry, *(far for _, far in g.feet)]
    left = [*(near for near, _ in g.feet), exit_]
    u = [line.direction for line in g.lines]
    theta = [clean_angle(angle_from_to(g.x[k], g.x[k + 1], u[k])) for k in range(n)]
    d = [clean_length(dot(subtract(left[k], reached[k]), u[k]), g.size) for k in range(n)]
    a = [clean_length(_along(normal, x), g.size) for normal, x in zip(g.normals, g.x[1:-1], strict=True)]
    alpha = [clean_angle(angle_from_to(u[k], u[k + 1], g.x[k + 1])) for k in range(n - 1)]
    if convention is Convention.MODIFIED:
        a.insert(0, clean_length(dot(subtract(entry, g.first.origin), g.first.x), g.size) if g.first else 0.0)
        alpha.insert(0, clean_angle(angle_from_to(g.first.z, u[0], g.first.x)) if g.first else 0.0)
    else:
        a.append(clean_length(dot(subtract(g.last.origin, exit_), g.last.x), g.size) if g.last else 0.0)
        alpha.append(clean_angle(angle_from_to(u[-1], g.last.z, g.last.x)) if g.last else 0.0)
    return DHTable(
        convention=convention,
        rows=tuple(
            DHRow(joint=g.lines[k].joint, theta=theta[k], d=d[k], a=a[k], alpha=alpha[k]) for k in range(n)
        ),
    )


def _along(normal: CommonNormal, x: Vector) -> float:
    """The length of a normal along x: negative where x points back."""
    back = normal.direction is not None and normal.length > 0.0 and dot(x, normal.direction) < 0.0
    return -normal.length if back else normal.length


def _frames(g: _Geometry, convention: Convention) -> tuple[AssignedFrame, ...]:
    n = len(g.lines)
    entry, exit_ = _ends(g)
    u = [line.direction for line in g.lines]
    first = g.first or Pose(entry, g.x[0], u[0])
    last = g.last or Pose(exit_, g.x[n], u[-1])
    frames = [_frame(first, Rule.GIVEN if g.first else Rule.FIRST, None, () if g.first else (Freedom.FRAME,))]
    for k, normal in enumerate(g.normals):
        modified = convention is Convention.MODIFIED
        pose = Pose(g.feet[k][0 if modified else 1], g.x[k + 1], u[k if modified else k + 1])
        drawn = JointType.PRISMATIC in (g.lines[k].joint, g.lines[k + 1].joint)
        rule = Rule.PRISMATIC if drawn else Rule(normal.relation.value)
        frames.append(_frame(pose, rule, normal.relation, _freedom(normal, drawn)))
    free = (Freedom.FRAME,) if convention is Convention.STANDARD else (Freedom.ORIGIN, Freedom.X_DIRECTION)
    frames.append(_frame(last, Rule.GIVEN if g.last else Rule.LAST, None, () if g.last else free))
    return tuple(frames)


def _freedom(normal: CommonNormal, drawn: bool) -> tuple[Freedom, ...]:
    free = [Freedom.LINE] if drawn else []
    if normal.relation.slides:
        free.append(Freedom.ORIGIN)
    if normal.relation is Relation.COINCIDENT:
        free.append(Freedom.X_DIRECTION)
    elif normal.relation is Relation.INTERSECTING:
        free.append(Freedom.X_SIGN)
    return tuple(free)


def _frame(pose: Pose, rule: Rule, relation: Relation | None, free: tuple[Freedom, ...]) -> AssignedFrame:
    return AssignedFrame(
        origin=pose.origin,
        x=pose.x,
        y=scale(cross(pose.z, pose.x), 1.0),
        z=pose.z,
        rule=rule,
        relation=relation,
        free=free,
    )


def _remainder(g: _Geometry, table: NumericTable, T_w_0: Transform, last: Pose | None) -> Transform:
    """Pose of the given tool in frame N."""
    if last is None or g.last is not None:
        return np.eye(4)
    T_w_n = forward_kinematics(table, [0.0] * table.n_joints, base=T_w_0).transform
    R = T_w_n[:3, :3].T
    T_w_t = matrix(last)
    T_n_t = np.eye(4)
    T_n_t[:3, :3] = R @ T_w_t[:3, :3]
    T_n_t[:3, 3] = R @ (T_w_t[:3, 3] - T_w_n[:3, 3])
    return T_n_t
