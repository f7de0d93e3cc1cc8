"""Columns of Jacobians: what a joint's motion does to the end of its chain."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from kinematics.dh import MotionKind
from kinematics.symbolic.angles import NO_ANGLE, Angle
from kinematics.symbolic.motions import Motion
from kinematics.symbolic.nested import Arena
from kinematics.symbolic.runs import Run, Runs, Vector, swung, turned, twisted
from kinematics.symbolic.terms import NOTHING, UNITY, Nested
from kinematics.symbolic.writing import AXES, ORIGIN, MatrixWriter, Pose

_LONG = 1000
"""From here on nobody reads it, and z × (p - p_k) may be shorter than what is carried from joint to joint."""


@dataclass(frozen=True, slots=True)
class MovingJoint:
    """A joint and what lies before and after it."""

    motion: Motion
    before: tuple[Run, ...]
    after: Sequence[Motion]

    def axis(self, arena: Arena) -> Vector:
        """Return the direction of the joint's axis, in the frame where it moves."""
        return NOTHING, NOTHING, UNITY if self.motion.sign == 1 else arena.negative(UNITY)

    def run(self, runs: Sequence[Run]) -> int:
        """Return in which run a revolute joint is."""
        return next(i for i, run in enumerate(runs) if run.angle.weight_of(self.motion.joint))

    def lever(self, arena: Arena, run: Run, tip: Vector, *, after: Angle = NO_ANGLE) -> Vector:
        """Return ∂p/∂q in the frame where the joint's run begins, turned back by the angle `after`.

        Only the arms that the joint turns count; each enters with the sum of its own angles, so a run of
        parallel joints gives a2·c2 + a3·c23 for the first and a3·c23 for the second.
        """
        name = self.motion.joint
        arms = {angle.plus(after, -1): arm for angle, arm in run.arms.items() if angle.weight_of(name)}
        x, y, _ = swung(arena, Run(angle=run.angle.plus(after, -1), arms=arms), tip)
        if run.angle.weight_of(name) == 1:
            return arena.negative(y), x, NOTHING
        return y, arena.negative(x), NOTHING


def column_in_base(
    writer: MatrixWriter, joint: MovingJoint, runs: Sequence[Run], end: Pose | None
) -> tuple[Vector, Vector]:
    """Return linear and angular velocity of the end in the axes of the base: (z × (p - p_k), z)."""
    arena = writer.arena
    axis = writer.in_world(writer.rotated(joint.before, joint.axis(arena)))
    if joint.motion.kind is MotionKind.SHIFT_Z:
        return axis, ORIGIN
    at = joint.run(runs)
    tip = writer.carried(runs[at + 1 :], ORIGIN if end is None else end[3])
    lever = joint.lever(arena, runs[at], twisted(arena, tip, runs[at].twist))
    return writer.in_world(writer.rotated(runs[:at], lever)), axis


def column_in_end(
    writer: MatrixWriter, joint: MovingJoint, runs: Sequence[Run], end: Pose | None
) -> tuple[Vector, Vector]:
    """Return linear and angular velocity of the end in its own axes: carried outward from joint to joint.

    Source: J. J. Craig, Introduction to Robotics, 3rd ed., eq. 5.45 ff., run by run.
    """
    arena = writer.arena
    if joint.motion.kind is MotionKind.SHIFT_Z:
        axis = joint.axis(arena)
        for run in Runs.of(arena, joint.after).finished():
            axis = _turned_back(arena, run, axis)
        return axis if end is None else writer.projected(end[:3], axis), ORIGIN
    at = joint.run(runs)
    own, *following = with_rises_moved_back(arena, runs[at:])
    z = UNITY if own.angle.weight_of(joint.motion.joint) == 1 else arena.negative(UNITY)
    back = NO_ANGLE.plus(own.twist, -1)
    omega = twisted(arena, (NOTHING, NOTHING, z), back)
    v = twisted(arena, joint.lever(arena, own, ORIGIN, after=own.angle), back)
    for run in following:
        omega, v = _carried_outward(arena, run, omega, v)
    if sum(map(arena.size, v)) > _LONG:
        arm = ORIGIN
        for run in Runs.of(arena, joint.after).finished():
            arm = passed(arena, run, arm)
        v = min(v, _cross(arena, omega, arm), key=lambda vector: sum(map(arena.size, vector)))
    if end is None:
        return v, omega
    v = writer.combined(AXES, v, _cross(arena, omega, end[3]))
    return writer.projected(end[:3], v), writer.projected(end[:3], omega)


def passed(arena: Arena, run: Run, point: Vector) -> Vector:
    """Return a vector from a fixed point to a run's beginning as one to its end, seen from there."""
    point = turned(arena, point, NO_ANGLE.plus(run.angle, -1))
    return twisted(arena, swung(arena, _seen_from_end(run), point), NO_ANGLE.plus(run.twist, -1))


def with_rises_moved_back(arena: Arena, runs: Sequence[Run]) -> list[Run]:
    """Return the runs, each rise across the run before as an arm of that one: a2·c2 + a3·c23 - d4·s23."""
    moved = [Run(run.angle, dict(run.arms), run.rise, run.twist) for run in runs]
    for before, run in pairwise(moved):
        if before.twist.quarter_turns in (1, -1):
            _, sine = arena.circle(before.twist)
            x, y = before.arms.get(before.angle, (NOTHING, NOTHING))
            y = arena.sum(y, arena.negative(arena.product(sine, run.rise)))
            if x or y:
                before.arms[before.angle] = (x, y)
            run.rise = NOTHING
    return moved


def _seen_from_end(run: Run) -> Run:
    """The run's translation in the axes after its rotation."""
    return Run(arms={angle.plus(run.angle, -1): arm for angle, arm in run.arms.items()}, rise=run.rise)


def _turned_back(arena: Arena, run: Run, direction: Vector) -> Vector:
    """A direction, given where the run begins, in the frame where it ends."""
    direction = turned(arena, direction, NO_ANGLE.plus(run.angle, -1))
    return twisted(arena, direction, NO_ANGLE.plus(run.twist, -1))


def _carried_outward(arena: Arena, run: Run, omega: Vector, v: Vector) -> tuple[Vector, Vector]:
    """Angular and linear velocity where a run begins, as those where it ends, seen from there.

    v + ω × r is formed after the run's rotation, but for its component along z, which no rotation about z
    changes: that one may be shorter before it.
    """
    back = NO_ANGLE.plus(run.angle, -1)
    before = _cross(arena, omega, swung(arena, run, ORIGIN))
    omega, v = turned(arena, omega, back), turned(arena, v, back)
    x, y, z = _cross(arena, omega, swung(arena, _seen_from_end(run), ORIGIN))
    z = min(before[2], z, key=arena.size)
    v = arena.sum(v[0], x), arena.sum(v[1], y), arena.sum(v[2], z)
    back = NO_ANGLE.plus(run.twist, -1)
    return twisted(arena, omega, back), twisted(arena, v, back)


def _cross(arena: Arena, a: Vector, b: Vector) -> Vector:
    def minor(i: int, j: int) -> Nested:
        return arena.sum(arena.product(a[i], b[j]), arena.negative(arena.product(a[j], b[i])))

    return minor(1, 2), minor(2, 0), minor(0, 1)
