"""Two or three joints that move in a plane: turns about its normal h, and slides in it.

In coordinates u, v along f and g = h × f a turn by φ takes (1, 0) to (cos φ, sin φ). Two joints bring a point
to its place; three, of which the last turns, a point and a direction: the axis of the last is such a point.

Source: for two revolute joints, J. J. Craig, Introduction to robotics, 3rd ed. (2005) §4.4 eq. 4.13 to 4.27;
R. P. Paul, Robot manipulators (1981) §3.4 for a cos + b sin = d.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

from kinematics.expressions import ONE, ZERO, Expression, Function, Sum, add, negate, parameters_in
from kinematics.inverse_forms.formulas import atan2, halved, less_angle, over, root, square, times
from kinematics.inverse_forms.signed_axes import Axis, SignedJoint, Vector, along, circular, signed
from kinematics.inverse_forms.steps import (
    InverseCondition,
    InverseDerivation,
    InverseQuantity,
    SingularCase,
    determined,
    fulfilled,
    reachable,
)
from kinematics.se3 import cross, dot

Point: TypeAlias = tuple[Expression, Expression]


@dataclass(frozen=True, slots=True)
class JointPlane:
    """A plane with its coordinates.

    h is its normal, f the direction of the first coordinate.
    """

    h: Axis
    f: Axis

    @property
    def g(self) -> Axis:
        """Direction of the second coordinate."""
        return cross(self.h, self.f)

    def point(self, v: Vector) -> Point:
        """Return coordinates of a point."""
        return along(self.f, v), along(self.g, v)

    def moves_in(self, joint: SignedJoint) -> bool:
        """Return whether a joint moves points in the plane.

        It turns about its normal, or slides across that.
        """
        return (dot(joint.axis, self.h) != 0) is joint.turns

    def sense(self, joint: SignedJoint) -> int:
        """Return 1 if a joint turns about h, -1 if about -h."""
        return dot(joint.axis, self.h)

    def way(self, joint: SignedJoint) -> tuple[int, int]:
        """Return the direction of a slide."""
        return dot(joint.axis, self.f), dot(joint.axis, self.g)

    def turn_of(self, joints: Sequence[SignedJoint]) -> Expression:
        """Return the sum of the angles by which joints turn the plane."""
        return add(signed(self.sense(j), j.angle) for j in joints if j.turns)


class PlanarJoints:
    """Writes down joints that move in one plane."""

    def __init__(self, write: InverseDerivation, plane: JointPlane) -> None:
        self._write, self._plane = write, plane

    def place_point(
        self, joints: Sequence[SignedJoint], start: Vector, target: Point, *, varying: bool = False
    ) -> bool:
        """Write down two joints that bring a point of the plane to its place.

        The start is where the point is at θ = 0, the target its place in the plane. Where `varying` holds,
        other joints move the start, possibly onto the axis of one of these.

        Returns:
            Whether there is a form for these joints: there is none where the second cannot move the point,
            two joints turn about one axis, or slide the same way. The second is then noted as idle.
        """
        write, plane = self._write, self._plane
        first, second = joints
        point = plane.point(start)
        if second.turns and _from(point, plane.point(second.point)) == (ZERO, ZERO):
            return write.idles(second)
        if first.turns and second.turns:
            if plane.point(first.point) == plane.point(second.point):
                return write.idles(second)
            self._two_turns(first, second, point, target, varying)
        elif first.turns:
            self._turn_and_slide(first, second, point, target, varying)
        elif second.turns:
            self._slide_and_turn(first, second, point, target, varying)
        elif dot(first.axis, second.axis) == 0:
            off = _from(target, point)
            for joint in joints:
                write.joint(joint, _component(plane.way(joint), off))
        else:
            return write.idles(second)
        return True

    def place_pose(
        self, joints: Sequence[SignedJoint], start: Vector, target: Point, turn: Expression
    ) -> bool:
        """Write down three joints that bring a point to its place and turn the plane by an angle.

        Where the last alone turns, its equation is that of the angle, and has been written.
        """
        write, plane = self._write, self._plane
        *others, last = joints
        if not last.turns:
            return False
        lever = _from(plane.point(start), plane.point(last.point))
        if lever != (ZERO, ZERO):
            c, s = circular(Function.COS, turn), circular(Function.SIN, turn)
            target = _from(target, _turned(c, s, lever))
        if not self.place_point(others, last.point, target):
            return False
        if any(joint.turns for joint in others):
            rest = add((turn, negate(plane.turn_of(others))))
            write.joint(last, rest, sense=plane.sense(last))
        return True

    def _two_turns(
        self, first: SignedJoint, second: SignedJoint, start: Point, target: Point, varying: bool
    ) -> None:
        """By the law of cosines: with U from the first axis, L between the axes, F from the second."""
        write, plane = self._write, self._plane
        a, b = plane.point(first.point), plane.point(second.point)
        U = _named(write, "u", "v", _from(target, a), InverseQuantity.PLANE_POINT)
        L, F = _from(b, a), _from(start, b)
        (lx, ly), (fx, fy) = L, F
        squares = [square(U[0]), square(U[1]), *(negate(square(x)) for x in (lx, ly, fx, fy))]
        half = halved(add(squares))
        if ly == ZERO:  # as books have it, divided by the upper arm
            equation = fx, negate(fy), over(half, lx)
        elif lx == ZERO:
            equation = fy, fx, over(half, ly)
        else:
            A = add((times(lx, fx), times(ly, fy)))
            B = add((times(ly, fx), negate(times(lx, fy))))
            coefficients = _named(write, "A", "B", (A, B), InverseQuantity.COEFFICIENT)
            equation = *coefficients, half
        # Where the two axes coincide, as lengths that are names may have it, one of the joints is enough.
        one_axis = SingularCase(
            free=(second.number, first.number),
            conditions=tuple(fulfilled(value) for value in (lx, ly, half) if value != ZERO),
        )
        between = [value for value in L if value != ZERO]
        phi = circular_root(
            write,
            *equation,
            second,
            plane.sense(second),
            varying=varying,
            conditions=() if _never_zero(between) else (determined(*between),),
            cases=() if _never_zero(between) else (one_axis,),
        )
        c, s = circular(Function.COS, phi), circular(Function.SIN, phi)
        x, y = _turned(c, s, F)
        W = _named(write, "k_x", "k_y", (add((lx, x)), add((ly, y))), InverseQuantity.ARM_POINT)
        self._turn_onto(first, W, U)

    def _turn_onto(self, joint: SignedJoint, start: Point, target: Point) -> None:
        """Write down the joint that turns one direction onto another; both are seen from its axis."""
        angle = less_angle(atan2(target[1], target[0]), start[1], start[0])
        self._write.joint(joint, angle, determined(*target), sense=self._plane.sense(joint))
        self._write.free(joint, *target)

    def _turn_and_slide(
        self, first: SignedJoint, second: SignedJoint, start: Point, target: Point, varying: bool
    ) -> None:
        """|U|² = (k + d)² + m²: the slide's way d; k + d counts from where the point is nearest to the axis.

        Where m = 0, the point is on the line of the slide through the axis, on the side that the sign tells.
        """
        write, plane = self._write, self._plane
        a = plane.point(first.point)
        U = _named(write, "u", "v", _from(target, a), InverseQuantity.PLANE_POINT)
        W = _from(start, a)
        way = plane.way(second)
        k, m = _component(way, W), _component((-way[1], way[0]), W)
        sign = write.sign()
        radicand = add((square(U[0]), square(U[1]), negate(square(m))))
        length = add((times(sign, root(radicand)), negate(k)))
        if m == ZERO:
            write.joint(second, length, branch=sign)
            along_way, aside = _component(way, U), _component((-way[1], way[0]), U)
            angle = atan2(times(sign, aside), times(sign, along_way))
            write.joint(first, angle, determined(*U), sense=plane.sense(first))
            write.free(first, *U)
            return
        d = write.joint(second, length, reachable(radicand), branch=sign)
        W = add((W[0], signed(way[0], d))), add((W[1], signed(way[1], d)))
        if varying:
            self._turn_onto(first, W, U)
        else:  # |U| is |m| at least: the turn is determined
            angle = less_angle(atan2(U[1], U[0]), W[1], W[0])
            write.joint(first, angle, sense=plane.sense(first))

    def _slide_and_turn(
        self, first: SignedJoint, second: SignedJoint, start: Point, target: Point, varying: bool
    ) -> None:
        """The turn from what is across the slide, the slide from what is along it."""
        write, plane = self._write, self._plane
        b = plane.point(second.point)
        U, F = _from(target, b), _from(start, b)
        way = plane.way(first)
        aside = (-way[1], way[0])
        phi = circular_root(
            write,
            _component(aside, F),
            _component(aside, (negate(F[1]), F[0])),
            _component(aside, U),
            second,
            plane.sense(second),
            varying=varying,
        )
        c, s = circular(Function.COS, phi), circular(Function.SIN, phi)
        write.joint(first, _component(way, _from(U, _turned(c, s, F))))


def circular_root(
    write: InverseDerivation,
    a: Expression,
    b: Expression,
    d: Expression,
    joint: SignedJoint,
    sense: int = 1,
    *,
    varying: bool = False,
    conditions: Sequence[InverseCondition] = (),
    cases: Sequence[SingularCase] = (),
) -> Expression:
    """Write down φ with a cos φ + b sin φ = d; returned is φ in terms of the joint's variable.

    The joint turns by ±φ, as `sense` says. Where `varying` holds, a and b may both be 0 on some targets;
    lengths that are names may always be. Of further conditions, `cases` tells where they do not hold.
    """
    coefficients = [value for value in (a, b) if value != ZERO]
    singular = (*coefficients, d)
    sign = write.sign()
    cosine = circular(Function.COS, joint.angle)
    sine = signed(sense, circular(Function.SIN, joint.angle))
    if b == ZERO:
        c = write.let("K", over(d, a), InverseQuantity.CIRCULAR, meaning=cosine)
        radicand: Expression = Sum((ONE, negate(square(c))))
        angle = atan2(times(sign, root(radicand)), c)
    elif a == ZERO:
        s = write.let("K", over(d, b), InverseQuantity.CIRCULAR, meaning=sine)
        radicand = Sum((ONE, negate(square(s))))
        angle = atan2(s, times(sign, root(radicand)))
    else:
        meaning = add((times(a, cosine), times(b, sine)))
        d = write.let("K", d, InverseQuantity.CIRCULAR, meaning=meaning)
        radicand = add((square(a), square(b), negate(square(d))))
        angle = add((atan2(b, a), atan2(times(sign, root(radicand)), d)))
    needed = [reachable(radicand), *conditions]
    told = [*cases]
    if varying or not _never_zero(coefficients):
        needed.append(determined(*coefficients))
        told.append(SingularCase(free=(joint.number,), conditions=tuple(map(fulfilled, singular))))
    theta = write.joint(joint, angle, *needed, branch=sign, sense=sense)
    write.singular(*told)
    return theta if sense > 0 else negate(theta)


def _never_zero(values: Sequence[Expression]) -> bool:
    """Whether values that are not 0 cannot all be 0, whatever the lengths with names are."""
    return any(not parameters_in(value) for value in values)


def _named(write: InverseDerivation, x: str, y: str, point: Point, quantity: InverseQuantity) -> Point:
    return write.let(x, point[0], quantity), write.let(y, point[1], quantity)


def _from(point: Point, other: Point) -> Point:
    return add((point[0], negate(other[0]))), add((point[1], negate(other[1])))


def _turned(c: Expression, s: Expression, point: Point) -> Point:
    x, y = point
    return add((times(x, c), negate(times(y, s)))), add((times(x, s), times(y, c)))


def _component(way: tuple[int, int], point: Point) -> Expression:
    return add((signed(way[0], point[0]), signed(way[1], point[1])))
