"""Origins and directions to choose from, right ones and tempting ones alike.

They come from the axes near a frame, in the order of the axes: feet of common normals, points of intersection
and the points that were given; directions of the axes, of their common normals and of the coordinate axes.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum

from kinematics.frames.axes import AxisLine, PartialPose, Pose
from kinematics.frames.normals import Relation, common_normal
from kinematics.se3 import ORIGIN, Vector, foot, norm, perpendicular, scale, subtract

_SAME = 1e-6  # Candidates nearer than what counts as right (`rules.ANGLE_TOLERANCE`) are one.
_COORDINATES: tuple[Vector, ...] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


class CandidateKind(StrEnum):
    """Where a candidate comes from.

    FOOT: on axis `axis`, where its common normal with axis `other` meets it.
    INTERSECTION: of axes `axis` and `other`.
    LEVEL: on axis `axis`, level with the origin of frame `frame`.
    AXIS_POINT: the point given of axis `axis`.
    BASE, TOOL: of the given frames.
    COORDINATES: the origin or an axis of the coordinates.
    AXIS: along axis `axis`.
    NORMAL: from axis `axis` to axis `other`, or across both.
    FRAME_X: along x of frame `frame`.
    ACROSS: some direction across axis `axis`.
    """

    FOOT = "foot"
    INTERSECTION = "intersection"
    LEVEL = "level"
    AXIS_POINT = "axis_point"
    BASE = "base"
    TOOL = "tool"
    COORDINATES = "coordinates"
    AXIS = "axis"
    NORMAL = "normal"
    FRAME_X = "frame_x"
    ACROSS = "across"


@dataclass(frozen=True, kw_only=True, slots=True)
class FrameCandidate:
    """A point or a direction to choose.

    Attributes:
        kind: where it comes from.
        vector: the point [m] or the unit vector.
        params: the numbers, counted from 1, that its kind speaks of; `sign` is -1 for the opposite direction.
    """

    kind: CandidateKind
    vector: Vector
    params: Mapping[str, int] = field(default_factory=dict)


@dataclass(frozen=True, kw_only=True, slots=True)
class Candidates:
    """What to choose the parts of a frame from."""

    z: tuple[FrameCandidate, ...]
    origin: tuple[FrameCandidate, ...]
    x: tuple[FrameCandidate, ...]


def candidates(
    index: int,
    lines: Sequence[AxisLine],
    frames: Sequence[PartialPose],
    *,
    first: Pose | None,
    last: Pose | None,
    size: float,
) -> Candidates:
    """Return candidates for frame `index`.

    The same in both conventions: which axis it is, is the student's choice.

    Args:
        index: number of the frame, 0 … N.
        lines: the N axes, sliding ones drawn somewhere.
        frames: the frames as far as chosen: origins level with the frame before, x along its x.
        first: the given base frame, if any.
        last: the given tool frame, if any.
    """
    near = range(max(index - 1, 0), min(index + 1, len(lines) - 1) + 1)
    before = frames[index - 1] if index else None
    ends = []
    if index == 0 and first is not None:
        ends.append((CandidateKind.BASE, first))
    if index == len(lines) and last is not None:
        ends.append((CandidateKind.TOOL, last))
    z = [*_axis_directions(near, lines), *(FrameCandidate(kind=kind, vector=pose.z) for kind, pose in ends)]
    origins = [
        *(FrameCandidate(kind=kind, vector=pose.origin) for kind, pose in ends),
        *_origins(near, lines, size),
        *_levels(index, near, lines, before),
    ]
    x = [
        *(FrameCandidate(kind=kind, vector=pose.x) for kind, pose in ends),
        *_normal_directions(near, lines, size),
        *_before_x(index, before),
        *_axis_directions(near, lines),
        *_coordinate_directions(),
        *_across(near, lines),
    ]
    if index in (0, len(lines)):
        z.extend(_coordinate_directions())
        origins.append(FrameCandidate(kind=CandidateKind.COORDINATES, vector=ORIGIN))
    return Candidates(z=_distinct(z, _SAME), origin=_distinct(origins, _SAME * size), x=_distinct(x, _SAME))


def _axis_directions(near: range, lines: Sequence[AxisLine]) -> Iterator[FrameCandidate]:
    for k in near:
        for sign in (1, -1):
            vector = scale(lines[k].direction, float(sign))
            yield FrameCandidate(kind=CandidateKind.AXIS, vector=vector, params={"axis": k + 1, "sign": sign})


def _normal_directions(near: range, lines: Sequence[AxisLine], size: float) -> Iterator[FrameCandidate]:
    for k in near[:-1]:
        direction = common_normal(lines[k], lines[k + 1], size).direction
        if direction is not None:
            for sign in (1, -1):
                yield FrameCandidate(
                    kind=CandidateKind.NORMAL,
                    vector=scale(direction, float(sign)),
                    params={"axis": k + 1, "other": k + 2, "sign": sign},
                )


def _before_x(index: int, before: PartialPose | None) -> Iterator[FrameCandidate]:
    if before is not None and before.x is not None:
        yield FrameCandidate(
            kind=CandidateKind.FRAME_X, vector=before.x, params={"frame": index - 1, "sign": 1}
        )


def _coordinate_directions() -> Iterator[FrameCandidate]:
    for number, vector in enumerate(_COORDINATES, start=1):
        for sign in (1, -1):
            yield FrameCandidate(
                kind=CandidateKind.COORDINATES,
                vector=scale(vector, float(sign)),
                params={"axis": number, "sign": sign},
            )


def _across(near: range, lines: Sequence[AxisLine]) -> Iterator[FrameCandidate]:
    for k in near:
        across = perpendicular(lines[k].direction)
        for sign in (1, -1):
            vector = scale(across, float(sign))
            yield FrameCandidate(
                kind=CandidateKind.ACROSS, vector=vector, params={"axis": k + 1, "sign": sign}
            )


def _origins(near: range, lines: Sequence[AxisLine], size: float) -> Iterator[FrameCandidate]:
    for k in near[:-1]:
        normal = common_normal(lines[k], lines[k + 1], size)
        if normal.relation is Relation.INTERSECTING:
            params = {"axis": k + 1, "other": k + 2}
            yield FrameCandidate(kind=CandidateKind.INTERSECTION, vector=normal.near, params=params)
        elif normal.relation is Relation.SKEW:
            for own, other, point in ((k + 1, k + 2, normal.near), (k + 2, k + 1, normal.far)):
                yield FrameCandidate(
                    kind=CandidateKind.FOOT, vector=point, params={"axis": own, "other": other}
                )
    for k in near:
        yield FrameCandidate(kind=CandidateKind.AXIS_POINT, vector=lines[k].point, params={"axis": k + 1})


def _levels(
    index: int, near: range, lines: Sequence[AxisLine], before: PartialPose | None
) -> Iterator[FrameCandidate]:
    if before is None or before.origin is None:
        return
    for k in near:
        point = foot(before.origin, lines[k].point, lines[k].direction)
        yield FrameCandidate(
            kind=CandidateKind.LEVEL, vector=point, params={"axis": k + 1, "frame": index - 1}
        )


def _distinct(found: Sequence[FrameCandidate], tolerance: float) -> tuple[FrameCandidate, ...]:
    kept: list[FrameCandidate] = []
    for candidate in found:
        if all(norm(subtract(candidate.vector, other.vector)) > tolerance for other in kept):
            kept.append(candidate)
    return tuple(kept)
