"""A chain of elementary motions as runs: joints with parallel axes, and what lies between them, merged.

    T = Run_1 · Rot_x(τ_1) · Run_2 · Rot_x(τ_2) ⋯

Within a run every rotation is about one direction z, so the run is a rotation by the sum of its angles and a
translation Σ_j Rot_z(Φ_j) (x_j, y_j, 0) + z ẑ, where Φ_j are partial sums. Antiparallel axes belong to it
too, for Rot_x(π) Rot_z(θ) = Rot_z(-θ) Rot_x(π). The twists τ between runs are not multiples of π.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field
from fractions import Fraction
from typing import TypeAlias

from kinematics.dh import MotionKind
from kinematics.expressions import JointVariable
from kinematics.symbolic.angles import NO_ANGLE, Angle, angle_of, joint_angle
from kinematics.symbolic.motions import Motion
from kinematics.symbolic.nested import Arena
from kinematics.symbolic.terms import NOTHING, Nested

Vector: TypeAlias = tuple[Nested, Nested, Nested]

_STRAIGHT = Angle(half_turns=Fraction(1))
_RIGHT = Angle(half_turns=Fraction(1, 2))


@dataclass(slots=True)
class Run:
    """Joints with parallel axes, merged.

    Attributes:
        angle: sum of all angles.
        arms: for each partial sum Φ the components (x, y) of the translation that is turned by it.
        rise: the translation along z.
        twist: τ, the rotation about x that follows.
    """

    angle: Angle = NO_ANGLE
    arms: dict[Angle, tuple[Nested, Nested]] = field(default_factory=dict)
    rise: Nested = NOTHING
    twist: Angle = NO_ANGLE


@dataclass(slots=True)
class Runs:
    """The runs of a chain of motions.

    Attributes:
        arena: where the lengths live.
        runs: the runs, base first; the last one may have a twist of π.
    """

    arena: Arena
    runs: list[Run] = field(default_factory=lambda: [Run()])
    _flipped: bool = False

    @classmethod
    def of(cls, arena: Arena, motions: Iterable[Motion]) -> "Runs":
        """Return the chain of some motions."""
        chain = cls(arena)
        chain.extend(motions)
        return chain

    def extend(self, motions: Iterable[Motion]) -> None:
        """Append motions at the end of the chain."""
        for motion in motions:
            match motion.kind:
                case MotionKind.TURN_Z:
                    turn = joint_angle(motion.joint, motion.sign) if motion.joint else angle_of(motion.amount)
                    self._turn(turn)
                case MotionKind.SHIFT_Z:
                    self._slide_along_z(self._length(motion))
                case MotionKind.SHIFT_X:
                    self._add_arm(self.runs[-1], self._length(motion), NOTHING)
                case MotionKind.TURN_X:
                    self._twist(angle_of(motion.amount))

    def finished(self) -> tuple[Run, ...]:
        """Return the runs of the motions so far; what is flipped at the end is flipped by the last twist."""
        runs = [Run(run.angle, dict(run.arms), run.rise, run.twist) for run in self.runs]
        runs[-1].twist = _STRAIGHT if self._flipped else NO_ANGLE
        return tuple(runs)

    def _length(self, motion: Motion) -> Nested:
        if not motion.joint:
            return self.arena.read(motion.amount)
        variable = self.arena.read(JointVariable(motion.joint))
        return variable if motion.sign == 1 else self.arena.negative(variable)

    def _turn(self, angle: Angle) -> None:
        run = self.runs[-1]
        run.angle = run.angle.plus(angle, -1 if self._flipped else 1)

    def _slide_along_z(self, length: Nested) -> None:
        run = self.runs[-1]
        run.rise = self.arena.sum(run.rise, self.arena.negative(length) if self._flipped else length)

    def _add_arm(self, run: Run, x: Nested, y: Nested) -> None:
        if not x and not y:
            return
        old = run.arms.get(run.angle, (NOTHING, NOTHING))
        run.arms[run.angle] = (self.arena.sum(old[0], x), self.arena.sum(old[1], y))

    def _twist(self, twist: Angle) -> None:
        """Close the run, unless the twist is a multiple of π or the last run can be dissolved."""
        if self._flipped:
            twist, self._flipped = twist.plus(_STRAIGHT), False
        following = NO_ANGLE
        while twist.quarter_turns not in (0, 2):
            dissolved = self._dissolve_constant_run(twist)
            if dissolved is None:
                self.runs[-1].twist = twist
                self.runs.append(Run(angle=following))
                return
            twist, turn = dissolved
            following = turn.plus(following)
        self._flipped = twist.quarter_turns == 2
        self._turn(following)

    def _dissolve_constant_run(self, twist: Angle) -> tuple[Angle, Angle] | None:
        """Replace τ_1, a last run without joint variable, and τ_2 by one twist and quarter turns about z.

        Rot_x(τ_1) Rot_z(0) Rot_x(τ_2)        = Rot_x(τ_1 + τ_2)
        Rot_x(τ_1) Rot_z(π) Rot_x(τ_2)        = Rot_z(π) Rot_x(τ_2 - τ_1)
        Rot_x(±π/2) Rot_z(β) Rot_x(∓π/2)      = Rot_z(π/2) Rot_x(∓β) Rot_z(-π/2)
        Rot_x(±π/2) Rot_z(β) Rot_x(±π/2)      = Rot_z(π/2) Rot_x(π ∓ β) Rot_z(π/2)

        Returns:
            The twist, and the turn about z that follows it; None if no rule applies.
        """
        if len(self.runs) == 1 or not self.runs[-1].angle.is_constant:
            return None
        before, run = self.runs[-2:]
        quarters, first, second = run.angle.quarter_turns, before.twist.quarter_turns, twist.quarter_turns
        if quarters in (0, 2):
            self._move_translation_back()
            if quarters == 2:
                before.angle = before.angle.plus(_STRAIGHT)
                return twist.plus(before.twist, -1), NO_ANGLE
            return twist.plus(before.twist), NO_ANGLE
        if first in (1, -1) and second in (1, -1):
            self._move_translation_back()
            before.angle = before.angle.plus(_RIGHT)
            turned = NO_ANGLE.plus(run.angle, -first)
            if first == second:
                return turned.plus(_STRAIGHT), _RIGHT
            return turned, NO_ANGLE.plus(_RIGHT, -1)
        return None

    def _move_translation_back(self) -> None:
        """Remove the last run and write its translation in the run before it."""
        run, before = self.runs.pop(), self.runs[-1]
        vector = swung(self.arena, run, (NOTHING, NOTHING, NOTHING))
        x, y, z = twisted(self.arena, vector, before.twist)
        self._add_arm(before, x, y)
        before.rise = self.arena.sum(before.rise, z)


def turned(arena: Arena, vector: Vector, angle: Angle) -> Vector:
    """Return Rot_z(angle) · vector."""
    x, y, z = vector
    return (*_rotated(arena, x, y, angle), z)


def twisted(arena: Arena, vector: Vector, angle: Angle) -> Vector:
    """Return Rot_x(angle) · vector."""
    x, y, z = vector
    return (x, *_rotated(arena, y, z, angle))


def _rotated(arena: Arena, u: Nested, v: Nested, angle: Angle) -> tuple[Nested, Nested]:
    if not (u or v):
        return u, v
    c, s = arena.circle(angle)
    return (
        arena.sum(arena.product(c, u), arena.negative(arena.product(s, v))),
        arena.sum(arena.product(s, u), arena.product(c, v)),
    )


def swung(arena: Arena, run: Run, vector: Vector) -> Vector:
    """Return a point, given where the run ends, in the frame where it begins."""
    arms = dict(run.arms)
    old = arms.get(run.angle, (NOTHING, NOTHING))
    arms[run.angle] = (arena.sum(old[0], vector[0]), arena.sum(old[1], vector[1]))
    x = y = NOTHING
    for angle, (along, across) in arms.items():
        arm = turned(arena, (along, across, NOTHING), angle)
        x, y = arena.sum(x, arm[0]), arena.sum(y, arm[1])
    return x, y, arena.sum(run.rise, vector[2])
