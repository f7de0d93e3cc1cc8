"""Arms whose axes are at right angles, in symbols: directions and points of the axes at θ = 0.

Where every twist and every constant turn is a multiple of π/2, an axis has the direction of ±x, ±y or ±z, and
its points have coordinates that are sums of the table's lengths. Any other constant turn about a joint's own
axis is an offset of that joint. About a parallel axis it is an offset of the joint before, and the way
between the two is turned back: Trans(v) Rot_z(β) = Rot_z(β) Trans(Rot_z(-β) v).

Tables that a program computed have twists such as 1.2e-16 and offsets such as 5.5e-17: rounding, not an arm.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TypeAlias

from kinematics.dh import MotionKind
from kinematics.errors import Fault, TableError
from kinematics.expressions import (
    ONE,
    ZERO,
    Expression,
    Function,
    JointVariable,
    add,
    call,
    multiply,
    negate,
    pi_fraction,
    rational_value,
)
from kinematics.se3 import cross, dot, opposite, triple
from kinematics.symbolic.motions import Motion, motions_of
from kinematics.table import SymbolicTable

Vector: TypeAlias = tuple[Expression, Expression, Expression]
Axis: TypeAlias = tuple[int, int, int]  # One of ±x, ±y, ±z.

_X, _Y, _Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)

_SHIFTS = (MotionKind.SHIFT_X, MotionKind.SHIFT_Z)

_ROUNDED_ANGLE = 5e-15  # As far [rad] as π with fifteen digits is off.

_MOST_RADIANS = 8  # Beyond a turn, the rounding of a double hides how far a number is off right angles.

_ROUNDED_LENGTH = Fraction(1, 10**15)
"""Lengths below this part of the largest, or of 1 where some are parameters, are zero."""


@dataclass(frozen=True, kw_only=True, slots=True)
class SignedJoint:
    """A joint at θ = 0.

    Attributes:
        number: of the joint, from 1.
        turns: whether it turns.
        axis: about which it turns, or along which it slides, with its variable's sign.
        point: a point of the axis.
        offset: θ - q [rad].
    """

    number: int
    turns: bool
    axis: Axis
    point: Vector
    offset: Expression = ZERO

    @property
    def angle(self) -> Expression:
        """θ = q + offset."""
        return add((JointVariable(self.number), self.offset))


@dataclass(frozen=True, kw_only=True, slots=True)
class SignedArm:
    """A chain of such joints.

    Attributes:
        joints: base first.
        end: position of the tip at θ = 0.
        columns: the x, y and z axis of the end-effector at θ = 0.
    """

    joints: tuple[SignedJoint, ...]
    end: Vector
    columns: tuple[Axis, Axis, Axis]


def signed_arm_of(table: SymbolicTable, tip: Vector = (ZERO, ZERO, ZERO)) -> SignedArm:
    """Return the arm of a table.

    `tip` is what is to be placed, a point in frame N.

    Raises:
        TableError: code `inverse_form_unknown`, at the cell that leaves axes neither parallel nor at right
            angles.
    """
    walker = _Walker()
    rows = motions_of(table)
    least = _ROUNDED_LENGTH * _largest_length([motion for row in rows for motion in row])
    for i, row in enumerate(rows):
        for motion in row:
            value = rational_value(motion.amount)
            if motion.joint or motion.kind not in _SHIFTS or value is None or abs(value) > least:
                walker.take(motion, i)
    walker.turn_back()
    end = triple(along(axis, tip) for axis in zip(*walker.columns, strict=True))
    return SignedArm(joints=tuple(walker.joints), end=plus(walker.point, end), columns=walker.columns)


def _largest_length(motions: Sequence[Motion]) -> Fraction:
    lengths = [rational_value(m.amount) for m in motions if m.kind in _SHIFTS and not m.joint]
    largest = max((abs(length) for length in lengths if length is not None), default=Fraction(0))
    return largest if None not in lengths else max(largest, Fraction(1))


def _quarter_turns(angle: Expression) -> int | None:
    """How many right angles an angle is, or None if it is something else."""
    turns, radians = pi_fraction(angle), rational_value(angle)
    if turns is not None:
        quarters = 2 * turns
    elif radians is not None and abs(radians) < _MOST_RADIANS:
        quarters = Fraction(float(radians) / (0.5 * math.pi))
    else:
        return None
    nearest = round(quarters)
    return nearest % 4 if abs(quarters - nearest) * 0.5 * math.pi <= _ROUNDED_ANGLE else None


class _Walker:
    """The frame that has been reached, and the joints passed."""

    def __init__(self) -> None:
        self.columns: tuple[Axis, Axis, Axis] = (_X, _Y, _Z)
        self.point: Vector = (ZERO, ZERO, ZERO)
        self.joints: list[SignedJoint] = []
        self._ahead: Expression = ZERO
        self._ahead_row = 0
        self._on_axis = False

    def take(self, motion: Motion, row: int) -> None:
        """Go on by a motion of a row; see `signed_arm_of` for what is raised."""
        if motion.kind in (MotionKind.SHIFT_X, MotionKind.TURN_X):
            self.turn_back()
        x, _, z = self.columns
        if motion.joint:
            turns = motion.kind is MotionKind.TURN_Z
            axis = z if motion.sign > 0 else opposite(z)
            offset = signed(motion.sign, self._ahead) if turns else ZERO
            self.joints.append(
                SignedJoint(number=motion.joint, turns=turns, axis=axis, point=self.point, offset=offset)
            )
            self._on_axis = turns or self._on_axis
            self._ahead = ZERO if turns else self._ahead
        elif motion.kind is MotionKind.SHIFT_Z:
            self.point = plus(self.point, scaled(z, motion.amount))
        elif motion.kind is MotionKind.SHIFT_X:
            self.point = plus(self.point, scaled(x, motion.amount))
            self._on_axis = False
        else:
            self._turn(motion, row)

    def turn_back(self) -> None:
        """Make a turn that no joint has taken up the offset of a parallel joint before it."""
        if self._ahead == ZERO:
            return
        z = self.columns[2]
        last = next((i for i in reversed(range(len(self.joints))) if self.joints[i].turns), None)
        if last is None or not all(dot(joint.axis, z) for joint in self.joints[last:]):
            raise _oblique(self._ahead_row, "theta")
        joint = self.joints[last]
        angle = signed(dot(joint.axis, z), self._ahead)
        c, s = circular(Function.COS, angle), negate(circular(Function.SIN, angle))
        self.point = plus(joint.point, turned(joint.axis, c, s, minus(self.point, joint.point)))
        self.joints[last] = replace(joint, offset=add((joint.offset, angle)))
        self._ahead = ZERO

    def _turn(self, motion: Motion, row: int) -> None:
        quarters = _quarter_turns(motion.amount)
        x, y, z = self.columns
        if motion.kind is MotionKind.TURN_X:
            self._on_axis = False
            if quarters is None:
                raise _oblique(row, "alpha")
            for _ in range(quarters):
                y, z = z, opposite(y)
        elif quarters is not None:
            for _ in range(quarters):
                x, y = y, opposite(x)
        elif self._on_axis:
            last = next(i for i in reversed(range(len(self.joints))) if self.joints[i].turns)
            joint = self.joints[last]
            offset = add((joint.offset, signed(dot(joint.axis, z), motion.amount)))
            self.joints[last] = replace(joint, offset=offset)
        else:
            self._ahead, self._ahead_row = add((self._ahead, motion.amount)), row
        self.columns = (x, y, z)


def _oblique(row: int, cell: str) -> TableError:
    return TableError(Fault.at("inverse_form_unknown", "rows", row, cell))


def along(axis: Axis, v: Sequence[Expression]) -> Expression:
    """Return the component of a vector along an axis."""
    return add(signed(a, x) for a, x in zip(axis, v, strict=True))


def signed(sign: int, x: Expression) -> Expression:
    """Return x, -x or 0."""
    return (ZERO, x, negate(x))[sign]


def scaled(axis: Axis, length: Expression) -> Vector:
    """Return a length along an axis."""
    return triple(signed(entry, length) for entry in axis)


def plus(v: Vector, w: Vector) -> Vector:
    """Return the sum of two vectors."""
    return triple(map(add, zip(v, w, strict=True)))


def minus(v: Vector, w: Vector) -> Vector:
    """Return the difference of two vectors."""
    return plus(v, triple(map(negate, w)))


def turned(axis: Axis, cosine: Expression, sine: Expression, v: Vector) -> Vector:
    """Return a vector turned about an axis: (a·v) a + cos (v - (a·v) a) + sin a × v."""
    kept = scaled(axis, along(axis, v))
    across = minus(v, kept)
    aside = [along(cross(unit, axis), v) for unit in (_X, _Y, _Z)]  # unit·(axis × v) = (unit × axis)·v
    c, s = (tuple(multiply((factor, x)) for x in part) for factor, part in ((cosine, across), (sine, aside)))
    return plus(kept, plus(c, s))  # type: ignore[arg-type]


def circular(function: Function, angle: Expression) -> Expression:
    """Return the sine or cosine of an angle; of a multiple of π/2 what it is."""
    turns = pi_fraction(angle)
    if turns is None or (2 * turns).denominator != 1:
        return call(function, angle)
    quarters = int(2 * turns) + (function is Function.COS)
    return (ZERO, ONE, ZERO, negate(ONE))[quarters % 4]
