"""Up to three turns about axes at right angles that make a rotation N.

Rot(a, θ_4) Rot(b, θ_5) Rot(c, θ_6) = N with b across a and c. Where c is a or its opposite (a wrist of most
arms, Euler's z-y-z) N c has the component c·a cos θ_5 along a; where all are at right angles (roll, pitch and
yaw) it has ±sin θ_5 there. What is across a tells θ_4 up to half a turn; with it b tells θ_6.

Where nothing is across a, N c = κ a with κ = ±1. Then N b = Rot(a, θ_4 + κ θ_6) b: this sum or difference is
determined, and one of both angles may be chosen.

Source: R. P. Paul, Robot manipulators (1981) §3.4.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from itertools import pairwise
from typing import TypeAlias

from kinematics.expressions import ONE, Expression, Function, JointVariable, add, negate, number, pi_times
from kinematics.inverse_forms.formulas import atan2, product_with, times
from kinematics.inverse_forms.signed_axes import Axis, SignedJoint, Vector, along, circular, signed
from kinematics.inverse_forms.steps import (
    InverseDerivation,
    InverseQuantity,
    InverseStep,
    SingularCase,
    determined,
    fulfilled,
)
from kinematics.se3 import cross, dot

Writing: TypeAlias = Callable[..., Expression]
"""Writes down an angle with its conditions and its branch sign, and returns what stands for it."""


@dataclass(frozen=True, kw_only=True, slots=True)
class Turn:
    """A turn of one joint, or of several with parallel axes at once.

    Attributes:
        axis: about which it turns.
        joint: the joint's number, or 0 of several.
        variables: the joint variable, or the sum of several.
        offset: the angle less the variables [rad].
        writing: what writes it down.
    """

    axis: Axis
    joint: int
    variables: Expression
    offset: Expression
    writing: Writing

    @property
    def angle(self) -> Expression:
        """The angle in the joint variables."""
        return add((self.variables, self.offset))


def turn_of_joint(write: InverseDerivation, joint: SignedJoint) -> Turn:
    """Return the turn of one joint."""
    return Turn(
        axis=joint.axis,
        joint=joint.number,
        variables=JointVariable(joint.number),
        offset=joint.offset,
        writing=partial(write.joint, joint),
    )


def write_turns(write: InverseDerivation, turns: Sequence[Turn], N: Sequence[Vector]) -> bool:
    """Write down one, two or three turns that make a rotation.

    N is given by rows; neighbouring axes are at right angles.

    Returns:
        Whether there is a form for these axes.
    """
    axes = [turn.axis for turn in turns]
    writings = [turn.writing for turn in turns]
    if any(dot(one, other) for one, other in pairwise(axes)):
        return False
    transposed = list(zip(*N, strict=True))
    if len(axes) == 1:
        (a,) = axes
        across = next(b for b in ((1, 0, 0), (0, 1, 0), (0, 0, 1)) if not dot(a, b))
        seen = product_with(N, across)
        level = fulfilled(add((ONE, negate(along(a, product_with(N, a))))))
        writings[0](atan2(along(cross(a, across), seen), along(across, seen)), level)
        return True
    a, b = axes[:2]
    if len(axes) == 2:
        seen, back = product_with(N, b), product_with(transposed, a)
        level = fulfilled(along(a, seen))
        writings[0](atan2(along(cross(a, b), seen), along(b, seen)), level)
        writings[1](atan2(along(cross(a, b), back), along(a, back)))
        return True
    _three_turns(write, turns, N, transposed)
    return True


def _three_turns(
    write: InverseDerivation, turns: Sequence[Turn], N: Sequence[Vector], transposed: Sequence[Vector]
) -> None:
    first, second, third = turns
    a, b, c = (turn.axis for turn in turns)
    seen = product_with(N, c)
    same, handedness = dot(a, c), dot(a, cross(b, c))
    # N c = (along a) + Rot(a, θ_4) of a multiple of x, which is across a; y = a × x.
    x = cross(b, c) if same else c
    y = cross(a, x)
    c5, s5 = circular(Function.COS, second.angle), circular(Function.SIN, second.angle)
    across, level = (s5, signed(same, c5)) if same else (c5, signed(handedness, s5))
    m_x, m_y, m_z = (
        write.let(name, along(axis, seen), InverseQuantity.HAND_AXIS, meaning=meaning)
        for name, axis, meaning in (
            ("m_x", x, times(circular(Function.COS, first.angle), across)),
            ("m_y", y, times(circular(Function.SIN, first.angle), across)),
            ("m_z", a, level),
        )
    )
    sign = write.sign()
    theta = first.writing(atan2(times(sign, m_y), times(sign, m_x)), determined(m_x, m_y), branch=sign)
    name = write.steps[-1].name
    write.singular(*(_aligned(name, turns, N, (m_x, m_y, m_z), kappa) for kappa in (1, -1)))
    cosine, sine = circular(Function.COS, theta), circular(Function.SIN, theta)
    out = add((times(cosine, m_x), times(sine, m_y)))
    if same:
        second.writing(atan2(out, signed(same, m_z)))
    else:
        second.writing(atan2(signed(handedness, m_z), out))
    # Nᵀ Rot(a, θ_4) b = Rot(c, -θ_6) b, also where θ_4 may be chosen
    rows = product_with(transposed, b), product_with(transposed, cross(a, b))
    n_x, n_y = (
        add((times(cosine, along(axis, rows[0])), times(sine, along(axis, rows[1]))))
        for axis in (b, cross(b, c))
    )
    third.writing(atan2(n_y, n_x))


def _aligned(name: str, turns: Sequence[Turn], N: Sequence[Vector], m: Vector, kappa: int) -> SingularCase:
    """The case N c = κ a, in which the first and the last turn are about one direction.

    m is N c, its last component along a.
    """
    first, second, third = turns
    a, b, c = (turn.axis for turn in turns)
    same, handedness = dot(a, c), dot(a, cross(b, c))
    at = pi_times(Fraction(1 - same * kappa, 2) if same else Fraction(handedness * kappa, 2))
    at = add((at, negate(second.offset)))
    seen = product_with(N, b)
    together = atan2(along(cross(a, b), seen), along(b, seen))
    if first.joint:
        free: tuple[int, ...] = (first.joint, third.joint)
        rest = signed(kappa, add((together, negate(first.angle))))
        other = InverseStep(
            name=f"q{third.joint}", joint=third.joint, value=add((rest, negate(third.offset)))
        )
    else:
        free = (third.joint,)
        other = InverseStep(
            name=name,
            value=add((together, signed(-kappa, third.angle))),
            quantity=InverseQuantity.PLANE_TURN,
            meaning=first.angle,
        )
    return SingularCase(
        free=free,
        conditions=tuple(map(fulfilled, (m[0], m[1], add((m[2], number(-kappa)))))),
        joint=second.joint,
        at=at,
        combination=add((first.variables, signed(kappa, third.variables))),
        value=add((together, negate(first.offset), signed(-kappa, third.offset))),
        steps=(InverseStep(name=f"q{second.joint}", joint=second.joint, value=at), other),
    )
