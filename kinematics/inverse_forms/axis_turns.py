"""Up to three turns about axes at right angles that make a rotation N.

Rot(a, θ_4) Rot(b, θ_5) Rot(c, θ_6) = N with b across a and c. Where c is a or its opposite (a wrist of most
arms, Euler's z-y-z) N c has the component c·a cos θ_5 along a; where all are at right angles (roll, pitch and
yaw) it has ±sin θ_5 there. What is across a tells θ_4 up to half a turn; with it b tells θ_6.

Source: R. P. Paul, Robot manipulators (1981) §3.4.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import TypeAlias

from kinematics.expressions import ONE, Expression, Function, add, negate
from kinematics.inverse_forms.signed_axes import Axis, Vector, along, circular, cross, dot, signed
from kinematics.inverse_forms.steps import (
    InverseDerivation,
    atan2,
    determined,
    fulfilled,
    product_with,
    times,
)

Writing: TypeAlias = Callable[..., Expression]
"""Writes down an angle with its conditions and its branch sign, and returns what stands for it."""


def write_turns(
    write: InverseDerivation, axes: Sequence[Axis], N: Sequence[Vector], writings: Sequence[Writing]
) -> bool:
    """Write down the turns about one, two or three axes that make a rotation.

    Args:
        write: where to.
        axes: neighbours at right angles.
        N: the rotation, by rows.
        writings: what writes down each angle.

    Returns:
        Whether there is a form for these axes.
    """
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
    _three_turns(write, (a, b, axes[2]), N, transposed, writings)
    return True


def _three_turns(
    write: InverseDerivation,
    axes: tuple[Axis, Axis, Axis],
    N: Sequence[Vector],
    transposed: Sequence[Vector],
    writings: Sequence[Writing],
) -> None:
    a, b, c = axes
    seen = product_with(N, c)
    same = dot(a, c)
    # N c = (along a) + Rot(a, θ_4) of a multiple of x, which is across a; y = a × x.
    x = cross(b, c) if same else c
    y = cross(a, x)
    m_x, m_y = write.let("m_x", along(x, seen)), write.let("m_y", along(y, seen))
    m_z = write.let("m_z", along(a, seen))
    sign = write.sign()
    theta = writings[0](atan2(times(sign, m_y), times(sign, m_x)), determined(m_x, m_y), branch=sign)
    cosine, sine = circular(Function.COS, theta), circular(Function.SIN, theta)
    out = add((times(cosine, m_x), times(sine, m_y)))
    if same:
        writings[1](atan2(out, signed(same, m_z)))
    else:
        writings[1](atan2(signed(dot(a, cross(b, c)), m_z), out))
    # Nᵀ Rot(a, θ_4) b = Rot(c, -θ_6) b, also where θ_4 may be chosen
    rows = product_with(transposed, b), product_with(transposed, cross(a, b))
    n_x, n_y = (
        add((times(cosine, along(axis, rows[0])), times(sine, along(axis, rows[1]))))
        for axis in (b, cross(b, c))
    )
    writings[2](atan2(n_y, n_x))
