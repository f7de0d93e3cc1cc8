"""Joint screws and a home pose as an answer: is it the robot, whatever frames it is written in?

    space   T(q) = exp([S_1] q_1) ⋯ exp([S_n] q_n) M        body   T(q) = M exp([B_1] q_1) ⋯ exp([B_n] q_n)

with S_i = Ad_M B_i. An answer is right when there are σ, δ, B, E with T(σ∘q + δ) = B · F(q) · E for all
q, as for a table (`kinematics.equivalence`). So either sense of an axis is right, any point on it, any zero,
and any length of a prismatic joint's direction; a revolute joint's ω is a unit vector, for q is its angle,
and its v has no part along ω. Nothing is compared row by row.

Source: K. M. Lynch, F. C. Park, Modern Robotics (2017), 4.1; R. M. Murray, Z. Li, S. S. Sastry (1994), 3.2.
"""

import math
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from enum import StrEnum
from typing import TypeVar

import numpy as np

from kinematics.answers.axis_pairs import AxisPair, axis_pairs
from kinematics.chain import Axis, Chain, chain_of_axes, size_of
from kinematics.equivalence import Certificate, Policy, ToolRule
from kinematics.equivalence.decision import WORK_OF_ACCEPTANCE, certify
from kinematics.equivalence.meter import Meter, WorkExhaustedError
from kinematics.equivalence.reference import prepared
from kinematics.se3 import (
    ORIGIN,
    Floats,
    Transform,
    cross,
    from_matrix,
    inverse_transform,
    norm,
    scale,
    skew,
    unit,
)
from kinematics.table import JointType, NumericTable

Entry = TypeVar("Entry")

UNIT = 0.01
"""How far |ω| may be from 1, and v·ω from 0 as a share of |v|: two decimals. A pitch is allowed, too, that
moves the joint by no more than the tolerance in half a turn."""
NO_ROTATION = 1e-9  # |ω| of a prismatic joint.
NO_PITCH = 1e-11  # v·ω of a robot without a length: what the arithmetic leaves of zero.
OTHER_UNITS = (1e-3, 1e-2, 1e2, 1e3)
"""Of a length, in parts of the key's: mm for m, cm for m, and the reverse."""


class ScrewFrame(StrEnum):
    """Where screws are written: in the fixed frame, or in the tool's at the zero position."""

    SPACE = "space"
    BODY = "body"


class ScrewOrder(StrEnum):
    """Which half of a screw stands first: (v, ω) or (ω, v)."""

    LINEAR_FIRST = "linear_first"
    ANGULAR_FIRST = "angular_first"

    def linear_first(self, entries: Sequence[Entry]) -> tuple[Entry, ...]:
        """Return six entries in this order, numbers or rows, as (v, ω)."""
        swapped = (*entries[3:], *entries[:3])
        return tuple(entries) if self is ScrewOrder.LINEAR_FIRST else swapped


class ScrewMistake(StrEnum):
    """What a wrong answer looks like.

    NOT_UNIT: ω of a revolute joint is no unit vector. PITCH: v has a part along ω. JOINT_TYPE: a joint turns
    that slides, or the reverse. HALVES: v and ω are exchanged. MOMENT_SIGN: v = ω × p for −ω × p.
    OTHER_FRAME: body screws for space screws, or the reverse. HOME_INVERTED: M leads the other way.
    SIGN_OR_HOME: it is one of these two, and nothing tells which: all axes are parallel, and M is not turned.
    HOME: M is wrong and the screws are right. NOT_RIGID: M is no rigid motion. LENGTH_UNIT: moments, and
    perhaps M, are in another unit of length. EXCHANGED: the rows of a joint and the next one are exchanged.
    REVERSED: the rows lead from the tool to the base.
    """

    NOT_UNIT = "not_unit"
    PITCH = "pitch"
    JOINT_TYPE = "joint_type"
    HALVES = "halves"
    MOMENT_SIGN = "moment_sign"
    OTHER_FRAME = "other_frame"
    HOME_INVERTED = "home_inverted"
    SIGN_OR_HOME = "sign_or_home"
    HOME = "home"
    NOT_RIGID = "not_rigid"
    LENGTH_UNIT = "length_unit"
    EXCHANGED = "exchanged"
    REVERSED = "reversed"


@dataclass(frozen=True, kw_only=True, eq=False)
class ScrewAnswer:
    """Screws and a home pose.

    Attributes:
        screws: (n, 6) rows (v, ω).
        home: (4, 4) M.
        frame: where the screws are written.
    """

    screws: Floats
    home: Floats
    frame: ScrewFrame = ScrewFrame.SPACE


@dataclass(frozen=True, kw_only=True, eq=False)
class ScrewVerdict:
    """What is said of an answer.

    Attributes:
        certificate: how the answer agrees with the key; None if it is wrong.
        mistakes: what a wrong one looks like, each with the joint, from 1, that it is about, or None.
        pairs: axes beside each other, and across prismatic joints, of a wrong answer.
        broken: of the robot that does not keep the policy, the one rule that it breaks; none if it may be one
            or another, and None if it is not the robot.
    """

    certificate: Certificate | None
    mistakes: tuple[tuple[ScrewMistake, int | None], ...] = ()
    pairs: tuple[AxisPair, ...] = ()
    broken: tuple[str, ...] | None = None

    @property
    def right(self) -> bool:
        """The answer is the robot and keeps the policy."""
        return self.certificate is not None


def judge_screws(key: NumericTable, answer: ScrewAnswer, policy: Policy) -> ScrewVerdict:
    """Judge screws and a home pose against a robot.

    Args:
        key: a table of the robot.
        answer: with as many screws as the robot has joints; lengths in the key's unit, numbers finite.
        policy: what is left free and what is fixed.
    """
    faults, broken = tuple(_malformed(key, answer, policy)), None
    if faults:
        halves = replace(answer, screws=np.hstack([answer.screws[:, 3:], answer.screws[:, :3]]))
        exchanged = not any(_malformed(key, halves, policy))
        if exchanged and _certified(key, halves, policy) is not None:
            answer, faults = halves, ((ScrewMistake.HALVES, None),)
    else:
        found = _certified(key, answer, policy)
        if found is not None:
            return ScrewVerdict(certificate=found)
        faults, broken = tuple(_explained(key, answer, policy)), _broken(key, answer, policy)
    pairs = tuple(axis_pairs(key, _axes(answer.screws), policy.tolerance.length))
    return ScrewVerdict(certificate=None, mistakes=faults, pairs=pairs, broken=broken)


def _broken(key: NumericTable, answer: ScrewAnswer, policy: Policy) -> tuple[str, ...] | None:
    """Return the one rule that keeps the robot from being right, if there is one; None: not the robot."""
    free = Policy(tool=ToolRule.FREE, tolerance=policy.tolerance)
    if _certified(key, answer, free) is None:
        return None
    freed = {rule: getattr(free, rule) for rule in ("base", "tool", "zero", "direction")}
    mending = tuple(
        rule
        for rule, value in freed.items()
        if value is not getattr(policy, rule)
        and _certified(key, answer, replace(policy, **{rule: value})) is not None
    )
    return mending if len(mending) == 1 else ()


def screw_chain(answer: ScrewAnswer) -> Chain:
    """Return the chain of an answer; directions are made unit vectors, moments are put across them."""
    axes = _axes(_in_space(answer))
    home = np.eye(4)
    left, _, right = np.linalg.svd(answer.home[:3, :3])
    home[:3, :3], home[:3, 3] = left @ right, answer.home[:3, 3]
    return chain_of_axes(axes, from_matrix(home))


def adjoint(pose: Transform) -> Floats:
    """Return Ad_T, (6, 6), of twists (v, ω): v' = R v + p × R ω, ω' = R ω."""
    rotation = pose[:3, :3]
    result = np.zeros((6, 6))
    result[:3, :3] = result[3:, 3:] = rotation
    result[:3, 3:] = skew(pose[:3, 3]) @ rotation
    return result


def _axes(rows: Floats) -> list[Axis]:
    """Return the axes of rows (v, ω); a row of zeros is a prismatic joint without a direction."""
    axes = []
    for vx, vy, vz, wx, wy, wz in rows.tolist():
        linear, angular = (vx, vy, vz), (wx, wy, wz)
        length = norm(angular)
        if length <= NO_ROTATION:
            axes.append(Axis(True, unit(linear) if norm(linear) > 0.0 else ORIGIN, ORIGIN))
        else:
            direction = scale(angular, 1.0 / length)
            axes.append(Axis(False, direction, scale(cross(direction, linear), 1.0 / length)))
    return axes


def _in_space(answer: ScrewAnswer) -> Floats:
    if answer.frame is ScrewFrame.SPACE:
        return answer.screws
    return np.asarray(answer.screws @ adjoint(answer.home).T, dtype=np.float64)


def _malformed(
    key: NumericTable, answer: ScrewAnswer, policy: Policy
) -> Iterator[tuple[ScrewMistake, int | None]]:
    """Yield what keeps an answer from being a chain of revolute and prismatic joints."""
    rotation = answer.home[:3, :3]
    gram = np.abs(rotation.T @ rotation - np.eye(3)).max()
    bottom = np.abs(answer.home[3] - [0.0, 0.0, 0.0, 1.0]).max()
    if not max(gram, bottom) <= 3 * UNIT or not np.linalg.det(rotation) > 0:
        yield ScrewMistake.NOT_RIGID, None
    size = size_of(prepared(key).chain)
    # what v is off by, if it is rounded, does not shrink with v
    rounding = policy.tolerance.length * size / math.pi
    rows = zip(answer.screws.tolist(), key.joint_types, strict=True)
    for i, ((vx, vy, vz, wx, wy, wz), kind) in enumerate(rows, 1):
        v, w = math.hypot(vx, vy, vz), math.hypot(wx, wy, wz)
        slides, nearest = w <= NO_ROTATION, min(v, size or v)
        if slides != (kind is JointType.PRISMATIC) or (slides and not v > 0.0):
            yield ScrewMistake.JOINT_TYPE, i
        elif not slides and not abs(w - 1.0) <= UNIT:
            yield ScrewMistake.NOT_UNIT, i
        elif not slides and not abs(vx * wx + vy * wy + vz * wz) <= max(UNIT * nearest, rounding, NO_PITCH):
            yield ScrewMistake.PITCH, i


def _explained(
    key: NumericTable, answer: ScrewAnswer, policy: Policy
) -> Iterator[tuple[ScrewMistake, int | None]]:
    """Yield the single slip whose undoing makes the answer right."""

    def right(changed: ScrewAnswer) -> bool:
        well_formed = next(_malformed(key, changed, policy), None) is None
        return well_formed and _certified(key, changed, policy) is not None

    (other,) = set(ScrewFrame) - {answer.frame}
    if right(replace(answer, frame=other)):
        yield ScrewMistake.OTHER_FRAME, None
        return
    inverted = right(replace(answer, home=inverse_transform(answer.home)))
    reversed_moments = answer.screws * np.array([-1.0, -1.0, -1.0, 1.0, 1.0, 1.0])
    turning = [i for i, row in enumerate(answer.screws) if np.linalg.norm(row[3:]) > NO_ROTATION]
    screws = answer.screws.copy()
    screws[turning] = reversed_moments[turning]
    if right(replace(answer, screws=screws)):
        yield ScrewMistake.SIGN_OR_HOME if inverted else ScrewMistake.MOMENT_SIGN, None
        return
    if inverted:
        yield ScrewMistake.HOME_INVERTED, None
        return
    for i in turning:
        screws = answer.screws.copy()
        screws[i] = reversed_moments[i]
        if right(replace(answer, screws=screws)):
            yield ScrewMistake.MOMENT_SIGN, i + 1
            return
    if _certified(key, answer, replace(policy, tool=ToolRule.FREE)) is not None:
        yield ScrewMistake.HOME, None
        return
    for factor in OTHER_UNITS:
        scaled = answer.screws.copy()
        scaled[turning, :3] *= factor
        home = answer.home.copy()
        home[:3, 3] *= factor
        if any(right(replace(answer, screws=scaled, home=pose)) for pose in (home, answer.home)):
            yield ScrewMistake.LENGTH_UNIT, None
            return
    n = len(answer.screws)
    orders = [(ScrewMistake.EXCHANGED, i + 1, [*range(i), i + 1, i, *range(i + 2, n)]) for i in range(n - 1)]
    for mistake, joint, order in (*orders, (ScrewMistake.REVERSED, None, [*reversed(range(n))])):
        changed = replace(answer, screws=answer.screws[order])
        pairs = axis_pairs(key, _axes(changed.screws), policy.tolerance.length)
        if all(pair.alike for pair in pairs) and right(changed):
            yield mistake, joint
            return


def _certified(key: NumericTable, answer: ScrewAnswer, policy: Policy) -> Certificate | None:
    """Return the certificate of an answer, if it is found with the work that a table is granted."""
    with np.errstate(all="ignore"), suppress(WorkExhaustedError, np.linalg.LinAlgError):
        return certify([prepared(key)], [screw_chain(answer)], policy, meter=Meter(WORK_OF_ACCEPTANCE))
    return None
