"""A student's frames against the rules, and the table that follows from them."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from kinematics.forward import forward_kinematics
from kinematics.frames.advice import direction_advice, first_advice, last_advice, vanishing_advice
from kinematics.frames.axes import (
    AxisLine,
    Gripper,
    JointAxis,
    PartialPose,
    Pose,
    ends_of,
    matrix,
    read_axes,
    robot_size,
)
from kinematics.frames.candidates import Candidates, candidates
from kinematics.frames.chosen_frames import ChosenFrame, read_frames
from kinematics.frames.exactness import clean_angle, clean_length
from kinematics.frames.parallels import PARALLEL_TOLERANCE, straighten
from kinematics.frames.placement import draw_prismatic_axes
from kinematics.frames.rounding import settled, slides_on_neighbours
from kinematics.frames.rules import FrameFinding, FramePlace, broken_rules
from kinematics.se3 import Transform, angle_from_to, dot, inverse_transform, subtract
from kinematics.table import Convention, DHRow, DHTable, JointType, NumericRow, NumericTable


@dataclass(frozen=True, kw_only=True, slots=True)
class JudgedFrame:
    """What is to be said about one frame.

    Attributes:
        index: number of the frame, 0 … N.
        complete: whether origin, x and z have been chosen; what has been chosen is judged before.
        findings: the rules it breaks; if none, what would make the table simpler.
        candidates: origins and directions to choose from.
    """

    index: int
    complete: bool
    findings: tuple[FrameFinding, ...]
    candidates: Candidates


@dataclass(frozen=True, kw_only=True, slots=True)
class JudgedFrames:
    """A student's frames, judged.

    Attributes:
        frames: frame 0 … N.
        rows: row 1 … N; None while a frame beside it is missing or breaks a rule.
        table: the table, once every row is there.
        base: (4, 4) pose of frame 0; None without a table.
        tool: (4, 4) pose of the given tool in frame N, the identity if none was given; None without a table.
    """

    frames: tuple[JudgedFrame, ...]
    rows: tuple[NumericRow | None, ...]
    table: NumericTable | None
    base: Transform | None
    tool: Transform | None


def check_frames(
    axes: Sequence[JointAxis],
    convention: Convention,
    chosen: Sequence[ChosenFrame | None],
    *,
    base: ArrayLike | None = None,
    tool: ArrayLike | Gripper | None = None,
    rounding: float = 0.0,
) -> JudgedFrames:
    """Return the rules that chosen frames break, what to choose from, and the table that follows.

    The line of a prismatic joint is where the student draws it: through the origin of the frame whose z is
    that axis. A z against the positive direction of its joint is allowed; the joint variable then enters the
    table with a minus sign.

    Args:
        axes: the joint axes at the zero position.
        chosen: frame 0 … N, as far as chosen; shorter lists are filled up with None.
        base: (4, 4) prescribed frame 0, if any: no advice is given on frame 0 then.
        tool: (4, 4) tool, or the gripper, if any: no advice is given on frame N then.
        rounding: how far a frame may be from one that obeys the rules and still be taken for it: directions
            [rad], and points as a part of the robot's size.

    Raises:
        DescriptionError: malformed axes or frames, a y that is not z × x, or more than N+1 frames.
        PoseError: base or tool is not a rigid motion.
    """
    lines, _ = straighten(read_axes(axes), PARALLEL_TOLERANCE)
    read = read_frames(chosen, len(lines))
    first, last = ends_of(base, tool)
    size = robot_size(lines, first, last)
    robot = _Robot(lines, convention, size)
    frames, places, broken = robot.against_rules(read, rounding)
    sound = _sound(frames, broken)
    drawn = zip(robot.drawn_lines(frames), draw_prismatic_axes(lines, size), strict=True)
    shown = [own or other for own, other in drawn]
    prescribed = {0: first, len(lines): last}
    judged = tuple(
        JudgedFrame(
            index=i,
            complete=_whole(frames[i]) is not None,
            findings=tuple(broken[i] or _advice(sound, places[i], prescribed.get(i))),
            candidates=candidates(i, shown, frames, first=first, last=last, size=size),
        )
        for i in range(len(frames))
    )
    rows = robot.rows(sound)
    table, frame_0 = robot.table(rows, sound[0]), sound[0]
    if table is None or frame_0 is None:
        return JudgedFrames(frames=judged, rows=rows, table=None, base=None, tool=None)
    T_w_0, T_n_tool = matrix(frame_0), np.eye(4)
    if last is not None:
        T_w_n = forward_kinematics(table, [0.0] * len(rows), base=T_w_0).transform
        T_n_tool = inverse_transform(T_w_n) @ matrix(last)
    return JudgedFrames(frames=judged, rows=rows, table=table, base=T_w_0, tool=T_n_tool)


def rules_and_table(
    axes: Sequence[JointAxis],
    convention: Convention,
    chosen: Sequence[ChosenFrame | None],
    *,
    rounding: float = 0.0,
) -> tuple[list[list[FrameFinding]], NumericTable | None]:
    """Return the rules that each of the chosen frames breaks, and the table that follows, or None.

    It is what `check_frames` finds, without advice and without what to choose from; arguments and errors as
    there.
    """
    lines, _ = straighten(read_axes(axes), PARALLEL_TOLERANCE)
    robot = _Robot(lines, convention, robot_size(lines, None, None))
    frames, _, broken = robot.against_rules(read_frames(chosen, len(lines)), rounding)
    sound = _sound(frames, broken)
    return broken, robot.table(robot.rows(sound), sound[0])


class _Robot(NamedTuple):
    """The axes to which frames are attached, and by which convention."""

    lines: Sequence[AxisLine]
    convention: Convention
    size: float

    def against_rules(
        self, frames: Sequence[PartialPose], rounding: float
    ) -> tuple[list[PartialPose], list[FramePlace], list[list[FrameFinding]]]:
        """Return the frames as they are meant, what judges them, and the rules that each of them breaks.

        Frames are moved onto what the rules ask for where they are that near.
        """
        meant = list(frames)
        if rounding:
            holders = [self._held(k) for k in range(len(self.lines))]
            meant = slides_on_neighbours(meant, self.lines, holders, rounding * self.size)
        places = self._places(meant)
        if rounding:
            meant = [settled(frame, place, rounding) for frame, place in zip(meant, places, strict=True)]
            places = self._places(meant)
        return meant, places, [broken_rules(frame, place) for frame, place in zip(meant, places, strict=True)]

    def drawn_lines(self, frames: Sequence[PartialPose]) -> list[AxisLine | None]:
        """Return the axes with a place: revolute joints, and prismatic ones whose frame has an origin."""
        drawn: list[AxisLine | None] = list(self.lines)
        for k, line in enumerate(self.lines):
            if line.joint is JointType.PRISMATIC:
                origin = frames[self._held(k)].origin
                drawn[k] = None if origin is None else AxisLine(line.joint, origin, line.direction)
        return drawn

    def rows(self, sound: Sequence[Pose | None]) -> tuple[NumericRow | None, ...]:
        return tuple(self._row(i, sound) for i in range(1, len(sound)))

    def table(self, rows: Sequence[NumericRow | None], frame_0: Pose | None) -> NumericTable | None:
        """Return the table, once every row and frame 0 are there."""
        whole = tuple(row for row in rows if row is not None)
        if len(whole) < len(rows) or frame_0 is None:
            return None
        return DHTable(convention=self.convention, rows=whole)

    def _held(self, k: int) -> int:
        """The number of the frame whose z lies along line k."""
        return k if self.convention is Convention.STANDARD else k + 1

    def _places(self, frames: Sequence[PartialPose]) -> list[FramePlace]:
        drawn = self.drawn_lines(frames)
        return [self._place(i, drawn) for i in range(len(self.lines) + 1)]

    def _place(self, i: int, drawn: Sequence[AxisLine | None]) -> FramePlace:
        before, after = i or None, i + 1 if i < len(self.lines) else None  # axis 1 … N, or none
        own, partner = (after, before) if self.convention is Convention.STANDARD else (before, after)
        return FramePlace(
            index=i,
            convention=self.convention,
            own=own,
            own_line=None if own is None else drawn[own - 1] or self.lines[own - 1],
            partner=partner,
            partner_direction=None if partner is None else self.lines[partner - 1].direction,
            partner_line=None if partner is None else drawn[partner - 1],
            size=self.size,
        )

    def _row(self, i: int, sound: Sequence[Pose | None]) -> NumericRow | None:
        """Row i, from frames i-1 and i."""
        before, frame, line = sound[i - 1], sound[i], self.lines[i - 1]
        if before is None or frame is None:
            return None
        w = subtract(frame.origin, before.origin)
        x, z = (frame.x, before.z) if self.convention is Convention.STANDARD else (before.x, frame.z)
        return DHRow(
            joint=line.joint,
            theta=clean_angle(angle_from_to(before.x, frame.x, z)),
            d=clean_length(dot(w, z), self.size),
            a=clean_length(dot(w, x), self.size),
            alpha=clean_angle(angle_from_to(before.z, frame.z, x)),
            sign=1 if dot(z, line.direction) > 0 else -1,
        )


def _sound(frames: Sequence[PartialPose], broken: Sequence[Sequence[FrameFinding]]) -> list[Pose | None]:
    """The frames that are whole and break no rule."""
    return [None if faults else _whole(frame) for frame, faults in zip(frames, broken, strict=True)]


def _whole(frame: PartialPose) -> Pose | None:
    if frame.origin is None or frame.x is None or frame.z is None:
        return None
    return Pose(frame.origin, frame.x, frame.z)


def _advice(sound: Sequence[Pose | None], place: FramePlace, prescribed: Pose | None) -> list[FrameFinding]:
    i = place.index
    frame = sound[i]
    if frame is None:
        return []
    findings = direction_advice(frame, place)
    before = sound[i - 1] if i else None
    after = sound[i + 1] if i + 1 < len(sound) else None
    if i == 0:
        if after is not None and prescribed is None:
            findings.extend(first_advice(frame, after, place))
    elif before is not None and i == len(sound) - 1:
        if prescribed is None:
            findings.extend(last_advice(frame, before, place))
    elif before is not None and i > 1:
        findings.extend(vanishing_advice(frame, before, place))
    return findings
