"""The last row that was forgotten: it leads from a table's last frame to the one that the policy asks for.

If T_s(σ∘q + δ) = B · F(q) · E, the motion X = E⁻¹ leads there. Where the figure does not fix the zero of the
last variable, so does exp(−[S] ε) E⁻¹ for every ε, with S that joint's screw in the table's last frame. A
motion is that of a row if two conditions hold, in each of which ε enters by its sine and cosine:

    standard  Rot_z(θ) Trans(a, 0, d) Rot_x(α):   r₃₁ = 0 and p₁ r₂₁ = p₂ r₁₁
    modified  Rot_x(α) Trans(a, 0, 0) Rot_z(θ) Trans(0, 0, d):   r₁₃ = 0 and p₂ r₃₃ = p₃ r₂₃
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial

from exercises.grading.edits.fitting import THIRD
from exercises.grading.edits.work import Work
from exercises.grading.judging.typed import SAME
from kinematics.chain import Axis, Chain, chain_of_table
from kinematics.equivalence import ToolRule, ZeroRule
from kinematics.equivalence.decision import certify
from kinematics.equivalence.search import Effort
from kinematics.se3 import Motion, compose, from_matrix, inverse, to_matrix
from kinematics.table import Convention, DHRow, JointType, NumericRow


def last_row(work: Work) -> NumericRow | None:
    """Return the row without a variable that leads to the frame which is asked for; None if no row does.

    A table that is not the robot itself has none.
    """
    chain = chain_of_table(work.table)
    anywhere = replace(work.policy, tool=ToolRule.FREE)
    found = certify((work.reference,), (chain,), anywhere, Effort.PLAIN, work.meter, measured=False)
    if found is None or not chain.axes:
        return None
    leading = inverse(from_matrix(found.tool))
    moves = work.policy.zero is ZeroRule.FREE
    motions = _behind_the_last_joint(chain, leading, work.table.convention) if moves else iter((leading,))
    rows = (_row_of(motion, work.table.convention, work.reference.size) for motion in motions)
    return next((row for row in rows if row is not None), None)


def _behind_the_last_joint(chain: Chain, motion: Motion, convention: Convention) -> Iterator[Motion]:
    """Yield a motion, and those that it becomes by values of the last variable for which they may be rows."""

    def moved(value: float) -> Motion:
        turned = compose(chain.axes[-1].motion(-value), compose(chain.end, motion))
        return compose(inverse(chain.end), turned)

    def off(value: float, condition: int) -> float:
        return _off(moved(value), convention)[condition]

    yield motion
    for condition in (0, 1):
        for value in _zeros(partial(off, condition=condition), chain.axes[-1]):
            yield moved(value)


def _zeros(function: Callable[[float], float], axis: Axis) -> tuple[float, ...]:
    """Return where a function of a joint's value vanishes: linear in a travel, or A + B cos x + C sin x."""
    here = function(0.0)
    if axis.prismatic:
        rate = function(1.0) - here
        return (-here / rate,) if rate else ()
    there, back = function(THIRD), function(-THIRD)
    mean = (here + there + back) / 3.0
    cosine, sine = here - mean, (there - back) / math.sqrt(3.0)
    size = math.hypot(cosine, sine)
    if not size or abs(mean) > size:
        return ()
    middle, half = math.atan2(sine, cosine), math.acos(-mean / size)
    return middle + half, middle - half


def _off(motion: Motion, convention: Convention) -> tuple[float, float]:
    """Return what vanishes for the motion of a row: an entry of the rotation, and a length."""
    (r11, _, r13, p1), (r21, _, r23, p2), (r31, _, r33, p3), _ = to_matrix(motion).tolist()
    if convention is Convention.STANDARD:
        return r31, p1 * r21 - p2 * r11
    return r13, p2 * r33 - p3 * r23


def _row_of(motion: Motion, convention: Convention, size: float) -> NumericRow | None:
    """Return the row of a motion; None if it is that of no row, or moves nothing."""
    turned, length = _off(motion, convention)
    if abs(turned) > SAME or abs(length) > SAME * size:
        return None
    (r11, r12, _, p1), (r21, _, r23, p2), (_, r32, r33, p3), _ = to_matrix(motion).tolist()
    if convention is Convention.STANDARD:
        theta, alpha = math.atan2(r21, r11), math.atan2(r32, r33)
        a, d = p1 * r11 + p2 * r21, p3
    else:
        theta, alpha = math.atan2(-r12, r11), math.atan2(-r23, r33)
        a, d = p1, p2 * r23 + p3 * r33
    lengths = (0.0 if abs(value) <= SAME * size else value for value in (a, d))
    angles = (0.0 if abs(value) <= SAME else value for value in (theta, alpha))
    (a, d), (theta, alpha) = lengths, angles
    if not any((a, d, theta, alpha)):
        return None
    return DHRow(joint=JointType.FIXED, theta=theta, d=d, a=a, alpha=alpha)
