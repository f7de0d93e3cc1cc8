"""Inverse kinematics in symbols, as books print it: one joint after another, by atan2, case by case.

Arms whose axes are at right angles are taken apart as a lecturer does. At the end-effector up to three turns
about axes through one point w, which they cannot move. Before them joints that move in a plane with normal h:
two, which place w, or three with parallel axes, which turn the end-effector about h as well. Before these, or
among them, one joint more: a turn across h, to which w keeps the distance that it has along h, or a slide
along h. The turn across h may also stand behind two planar joints: then it alone lifts w along h.

    planar arms, SCARA, cylindrical arms    planar joints, a slide along h
    PUMA, IRB 140, the Stanford arm         a turn, two planar joints, a wrist
    SCORBOT, Universal Robots               a turn, three planar joints, one or two turns
    two parallel axes, an elbow across      two planar joints, a turn, a wrist
    one joint, a wrist, pan and tilt        no planar joints; a slide or none, and the last turns

Source: J. J. Craig, Introduction to robotics, 3rd ed. (2005) ch. 4; R. P. Paul, Robot manipulators (1981)
ch. 3.
"""

from collections.abc import Sequence

from kinematics.errors import Fault, TableError
from kinematics.expressions import ZERO, Expression, Function, Parameter, add, negate
from kinematics.inverse.solve import MAX_JOINTS
from kinematics.inverse_forms.axis_turns import Turn, turn_of_joint, write_turns
from kinematics.inverse_forms.formulas import atan2, less_angle, root, square, times
from kinematics.inverse_forms.parts import Parts, partitions
from kinematics.inverse_forms.planar_joints import PlanarJoints, circular_root
from kinematics.inverse_forms.signed_axes import (
    Axis,
    SignedArm,
    SignedJoint,
    Vector,
    along,
    circular,
    minus,
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
from kinematics.se3 import cross, triple
from kinematics.table import SymbolicTable, table_parameters

MOST_JOINTS = 6  # A pose fixes no more.


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
        TableError: code `inverse_form_unknown` of an arm that is not taken apart so, at ("rows",), or at the
            cell that leaves axes neither parallel nor at right angles; `inverse_form_idle_joint` of one that
            is, but for a joint that cannot move what it would have to: a length is 0, or two slides are
            parallel.
    """
    if not table.n_joints:
        raise TableError(Fault.at("inverse_joint_count", "rows", count=0, limit=MAX_JOINTS))
    if table.n_joints <= MOST_JOINTS:
        arm = signed_arm_of(table, tip)
        idle = 0
        for parts in partitions(arm):
            writer = _Writer(arm, parts, (*table_parameters(table), *taken))
            form = writer.form()
            if form is not None:
                return form
            idle = idle or writer.write.idle
        if idle:
            raise TableError(Fault.at("inverse_form_idle_joint", "rows", joint=idle))
    raise TableError(Fault.at("inverse_form_unknown", "rows"))


class _Writer:
    """Writes the equations of an arm that has been taken apart."""

    def __init__(self, arm: SignedArm, parts: Parts, parameters: Sequence[str]) -> None:
        self.arm, self.parts = arm, parts
        joints = [f"q{joint.number}" for joint in arm.joints]
        self.write = InverseDerivation((*parameters, *joints))
        self.planar = PlanarJoints(self.write, parts.plane)
        self.rotation = tuple(tuple(map(self.write.fresh, row)) for row in ROTATION_NAMES)
        self.position = tuple(map(self.write.fresh, POSITION_NAMES))
        R = [[Parameter(name) for name in row] for row in self.rotation]
        # R' = R Mᵀ, the rotation from the pose at θ = 0: column k of M is a unit vector.
        columns = arm.columns
        self.R: list[Vector] = [
            triple(add(signed(columns[k][j], row[k]) for k in range(3)) for j in range(3)) for row in R
        ]
        lever = minus(parts.point, arm.end)
        self.target: Vector = plus(
            triple(map(Parameter, self.position)),
            triple(add(times(row[j], lever[j]) for j in range(3)) for row in self.R),
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
            start = self._tilted(parts.tilt, target) if parts.tilt else parts.point
            written = (
                start is not None
                and self.planar.place_point(
                    parts.planar, start, parts.plane.point(target), varying=parts.tilt is not None
                )
                and self._tail(N)
            )
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
        axes = [] if parts.lead or parts.slide or parts.tilt else [parts.plane.h]
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

    def _tilted(self, joint: SignedJoint, target: Vector) -> Vector | None:
        """Write down the turn behind a plane; returned is where it puts the point, or None if it lifts none.

        F from the joint's axis e to the point is lifted to (h·F) cos θ + (h × e)·F sin θ along h.
        """
        write, plane, e = self.write, self.parts.plane, joint.axis
        F = minus(self.parts.point, joint.point)
        a, b = along(plane.h, F), along(cross(plane.h, e), F)
        if a == b == ZERO:
            write.idles(joint)
            return None
        theta = circular_root(write, a, b, along(plane.h, minus(target, joint.point)), joint)
        F = turned(e, circular(Function.COS, theta), circular(Function.SIN, theta), F)
        way = write.let("l", along(plane.f, F), InverseQuantity.ARM_POINT)
        return plus(joint.point, plus(scaled(plane.f, way), scaled(e, along(e, F))))

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
        return write_turns(write, turns, N) and self.planar.place_pose(
            parts.planar, parts.point, plane.point(target), noted[0]
        )

    def _tail(self, N: Sequence[Vector]) -> bool:
        """Write down the turns at the end-effector, from what rotation the planar joints leave."""
        parts, write = self.parts, self.write
        if not parts.tail:
            return True
        N = _turned_back(N, parts.plane.h, parts.plane.turn_of(parts.planar))
        if parts.tilt is not None:
            N = _turned_back(N, parts.tilt.axis, parts.tilt.angle)
        return write_turns(write, [turn_of_joint(write, joint) for joint in parts.tail], N)


def _turned_back(N: Sequence[Vector], axis: Axis, angle: Expression) -> list[Vector]:
    """Rot(axis, -angle) N."""
    c, s = circular(Function.COS, angle), negate(circular(Function.SIN, angle))
    columns = [turned(axis, c, s, column) for column in zip(*N, strict=True)]
    return list(zip(*columns, strict=True))
