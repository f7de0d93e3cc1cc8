"""Inverse kinematics in symbols, as books print it: one joint after another, by atan2, case by case.

Arms whose axes are at right angles are taken apart as a lecturer does. At the hand up to three turns about
axes through one point w, which they cannot move. Before them joints that move in a plane with normal h: two,
which place w, or three with parallel axes, which turn the hand about h as well. Before these, or among them,
one joint more: a turn across h, to which w keeps the distance that it has along h, or a slide along h.

    planar arms, SCARA, cylindrical arms    planar joints, a slide along h
    PUMA, IRB 140, the Stanford arm         a turn, two planar joints, a wrist
    SCORBOT, Universal Robots               a turn, three planar joints, one or two turns
    one joint, a wrist, pan and tilt        no planar joints; a slide or none, and the turns at the hand

Source: J. J. Craig, Introduction to robotics, 3rd ed. (2005) ch. 4; R. P. Paul, Robot manipulators (1981)
ch. 3.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from kinematics.errors import Fault, TableError
from kinematics.expressions import ZERO, Expression, Function, Parameter, add, negate
from kinematics.inverse_forms.axis_turns import Turn, turn_of_joint, write_turns
from kinematics.inverse_forms.formulas import (
    atan2,
    less_angle,
    root,
    square,
    times,
)
from kinematics.inverse_forms.planar_joints import JointPlane, place_point, place_pose
from kinematics.inverse_forms.signed_axes import (
    Axis,
    SignedArm,
    SignedJoint,
    Vector,
    along,
    circular,
    cross,
    dot,
    minus,
    opposite,
    plus,
    scaled,
    signed,
    signed_arm_of,
    turned,
)
from kinematics.inverse_forms.steps import (
    POSITION_NAMES,
    ROTATION_NAMES,
    InverseCondition,
    InverseDerivation,
    InverseForm,
    InverseQuantity,
    InverseReach,
    determined,
    fulfilled,
    reachable,
)
from kinematics.table import SymbolicTable, table_parameters

LONGEST_TAIL = 3
MOST_JOINTS = 6
_UNIT: tuple[Axis, ...] = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def inverse_form(
    table: SymbolicTable, taken: Sequence[str] = (), tip: Vector = (ZERO, ZERO, ZERO)
) -> InverseForm:
    """Return the inverse kinematics of a table in closed form.

    Angles come out beyond (-π, π] where two are added; they are right up to full turns. Each branch sign may
    be +1 or -1. Every solution of a regular pose is that of one choice of signs.

    Args:
        table: the DH table; lengths may be numbers or parameters.
        taken: names that nothing else may have, besides those of the parameters.
        tip: the point whose position the target gives, in frame N.

    Raises:
        TableError: code `inverse_form_unknown` of an arm that is not taken apart so.
    """
    arm = signed_arm_of(table, tip)
    if arm is not None and 1 <= len(arm.joints) <= MOST_JOINTS:
        for parts in _partitions(arm):
            form = _Writer(arm, parts, (*table_parameters(table), *taken)).form()
            if form is not None:
                return form
    raise TableError(Fault(code="inverse_form_unknown", where=("rows",)))


@dataclass(frozen=True, kw_only=True, slots=True)
class _Parts:
    """An arm taken apart.

    Attributes:
        lead: the joint that turns across the plane, or None.
        slide: the joint that slides along the plane's normal, or None.
        planar: two or three joints that move in the plane; or none, and the tail is all but a slide.
        tail: the turns at the hand.
        plane: the plane.
        point: the point that the tail leaves alone.
    """

    lead: SignedJoint | None
    slide: SignedJoint | None
    planar: tuple[SignedJoint, ...]
    tail: tuple[SignedJoint, ...]
    plane: JointPlane
    point: Vector


def _partitions(arm: SignedArm) -> Iterator[_Parts]:
    """The ways to take an arm apart."""
    n = len(arm.joints)
    for size in (3, 2, 0):
        for length in range(min(LONGEST_TAIL, n - size), -1, -1):
            head, tail = arm.joints[: n - length], arm.joints[n - length :]
            if len(head) - size > 1 or (size == 3 and length == LONGEST_TAIL):
                continue
            point = _point_left_alone(tail, arm.end)
            if point is None:
                continue
            for h in _UNIT:
                parts = _parts(head, tail, size, h, point)
                if parts is not None:
                    yield parts


def _parts(
    head: Sequence[SignedJoint], tail: Sequence[SignedJoint], size: int, h: Axis, point: Vector
) -> _Parts | None:
    plane = JointPlane(h, cross(h, _across(h)))
    planar = tuple(joint for joint in head if plane.moves_in(joint))
    others = [joint for joint in head if not plane.moves_in(joint)]
    if len(planar) != size or len(others) > 1 or (not any(joint.turns for joint in planar) and size == 3):
        return None
    senses = [plane.sense(joint) for joint in planar if joint.turns]
    if senses and senses[0] < 0:
        h = opposite(h)
    lead = slide = None
    if others:
        (other,) = others
        if other.turns and other is head[0] and planar:
            lead = other
        elif not other.turns:
            slide = other
        else:
            return None
    f = _upright(cross(h, lead.axis if lead else _across(h)))
    plane = JointPlane(h, f)
    return _Parts(lead=lead, slide=slide, planar=planar, tail=tuple(tail), plane=plane, point=point)


def _upright(axis: Axis) -> Axis:
    """The axis or its opposite, whichever is x, y or z."""
    return axis if axis in _UNIT else opposite(axis)


def _across(h: Axis) -> Axis:
    """The axis with cross(h, it) = x, y, z in turn: coordinates x, y of h = z."""
    i = next(i for i in range(3) if h[i])
    return tuple(-int(k == (i + 2) % 3) for k in range(3))  # type: ignore[return-value]


def _point_left_alone(tail: Sequence[SignedJoint], end: Vector) -> Vector | None:
    """The point of all axes of the tail that is nearest to the hand; of no axis the hand itself."""
    if not all(joint.turns for joint in tail):
        return None
    if any(dot(one.axis, other.axis) for one, other in pairwise(tail)):
        return None
    known: list[Expression | None] = [None, None, None]
    for joint in tail:
        for i in range(3):
            if joint.axis[i]:
                continue
            if known[i] is not None and add((known[i], negate(joint.point[i]))) != ZERO:  # type: ignore[arg-type]
                return None
            known[i] = joint.point[i]
    x, y, z = (end[i] if known[i] is None else known[i] for i in range(3))
    return x, y, z  # type: ignore[return-value]


class _Writer:
    """Writes the equations of an arm that has been taken apart."""

    def __init__(self, arm: SignedArm, parts: _Parts, parameters: Sequence[str]) -> None:
        self.arm, self.parts = arm, parts
        joints = [f"q{joint.number}" for joint in arm.joints]
        self.write = InverseDerivation((*parameters, *joints))
        self.rotation = tuple(tuple(map(self.write.fresh, row)) for row in ROTATION_NAMES)
        self.position = tuple(map(self.write.fresh, POSITION_NAMES))
        R = [[Parameter(name) for name in row] for row in self.rotation]
        # R' = R Mᵀ, the rotation from the pose at θ = 0: column k of M is a unit vector.
        columns = arm.columns
        self.R: list[Vector] = [
            tuple(add(signed(columns[k][j], row[k]) for k in range(3)) for j in range(3))  # type: ignore[misc]
            for row in R
        ]
        x, y, z = (Parameter(name) for name in self.position)
        lever = minus(parts.point, arm.end)
        self.target: Vector = plus(
            (x, y, z),
            tuple(add(times(row[j], lever[j]) for j in range(3)) for row in self.R),  # type: ignore[arg-type]
        )

    def form(self) -> InverseForm | None:
        """Return the equations, or None if there are none for these joints."""
        parts, write = self.parts, self.write
        turning = len(parts.planar) == 3
        by_position = not parts.tail and not turning
        target = self.target
        if target != tuple(map(Parameter, self.position)):
            target = tuple(  # type: ignore[assignment]
                write.let(f"w_{axis}", entry, InverseQuantity.WRIST_POINT)
                for axis, entry in zip("xyz", target, strict=True)
            )
        N: Sequence[Vector] = self.R
        if parts.lead is not None:
            target, theta = self._lead(parts.lead, target)
            N = _turned_back(N, parts.lead.axis, theta)
        if parts.slide is not None:
            axis, way = parts.slide.axis, minus(target, parts.point)
            write.joint(parts.slide, along(axis, way))
        if turning:
            written = self._by_pose(N, target)
        elif not parts.planar:
            written = self._tail(N)
        else:
            written = place_point(
                write, parts.plane, parts.planar, parts.point, parts.plane.point(target)
            ) and self._tail(N)
        if not written:
            return None
        return InverseForm(
            steps=tuple(write.steps),
            branches=tuple(write.branches),
            reach=InverseReach.POSITION if by_position else InverseReach.POSE,
            rotation=self.rotation,
            position=self.position,
            conditions=tuple(condition for condition in self._level(target) if condition.value != ZERO),
        )

    def _level(self, target: Vector) -> list[InverseCondition]:
        """The target lies in the plane of all joints; without joints in a plane, where the arm leaves it."""
        parts = self.parts
        axes = [] if parts.lead or parts.slide else [parts.plane.h]
        if not parts.planar:
            axes += [parts.plane.f, parts.plane.g]
        return [fulfilled(along(axis, minus(target, parts.point))) for axis in axes]

    def _lead(self, joint: SignedJoint, target: Vector) -> tuple[Vector, Expression]:
        """Write down the turn before a plane; returned is the target seen from behind it, and the turn.

        With k = e × f and X, Y, D along f and k: X = ρ cos θ - D sin θ, Y = ρ sin θ + D cos θ.
        """
        write, f, e = self.write, self.parts.plane.f, joint.axis
        k = cross(e, f)
        off = minus(target, joint.point)
        X, Y = (
            write.let(name, along(axis, off), InverseQuantity.TURNED_POINT)
            for name, axis in (("x", f), ("y", k))
        )
        D = along(k, minus(self.parts.point, joint.point))
        sign = write.sign()
        if D == ZERO:
            theta = write.joint(joint, atan2(times(sign, Y), times(sign, X)), determined(X, Y), branch=sign)
            write.free(joint, X, Y)
            c, s = circular(Function.COS, theta), circular(Function.SIN, theta)
            rho = write.let("rho", add((times(c, X), times(s, Y))), InverseQuantity.RADIUS)
        else:  # X² + Y² is D² at least: θ is determined
            radicand = add((square(X), square(Y), negate(square(D))))
            rho = write.let("rho", times(sign, root(radicand)), InverseQuantity.RADIUS, reachable(radicand))
            theta = write.joint(joint, less_angle(atan2(Y, X), D, rho), branch=sign)
        seen = plus(scaled(f, rho), plus(scaled(k, D), scaled(e, along(e, off))))
        return plus(joint.point, seen), theta

    def _by_pose(self, N: Sequence[Vector], target: Vector) -> bool:
        """Write down three planar joints and the tail, the turn of the plane first."""
        parts, write, plane = self.parts, self.write, self.parts.plane
        turning = [joint for joint in parts.planar if joint.turns]
        angle = plane.turn_of(parts.planar)
        offset = add(signed(plane.sense(joint), joint.offset) for joint in turning)
        only = turning[0] if len(turning) == 1 else None
        noted: list[Expression] = []

        def note(
            value: Expression, *conditions: InverseCondition, branch: Expression | None = None
        ) -> Expression:
            if only is None:
                turn = write.let(
                    "phi", value, InverseQuantity.PLANE_TURN, *conditions, branch=branch, meaning=angle
                )
            else:
                write.joint(only, value, *conditions, branch=branch, sense=plane.sense(only))
                turn = angle
            noted.append(turn)
            return turn

        first = Turn(
            axis=plane.h,
            joint=0 if only is None else only.number,
            variables=add((angle, negate(offset))),
            offset=offset,
            writing=note,
        )
        turns = [first, *(turn_of_joint(write, joint) for joint in parts.tail)]
        return write_turns(write, turns, N) and place_pose(
            write, plane, parts.planar, parts.point, plane.point(target), noted[0]
        )

    def _tail(self, N: Sequence[Vector]) -> bool:
        """Write down the turns at the hand, from what rotation the planar joints leave."""
        parts, write = self.parts, self.write
        if not parts.tail:
            return True
        N = _turned_back(N, parts.plane.h, parts.plane.turn_of(parts.planar))
        return write_turns(write, [turn_of_joint(write, joint) for joint in parts.tail], N)


def _turned_back(N: Sequence[Vector], axis: Axis, angle: Expression) -> list[Vector]:
    """Rot(axis, -angle) N."""
    c, s = circular(Function.COS, angle), negate(circular(Function.SIN, angle))
    columns = [turned(axis, c, s, column) for column in zip(*N, strict=True)]
    return list(zip(*columns, strict=True))
