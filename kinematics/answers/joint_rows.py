"""One row of joint values: does it reach the pose, as which solution, and what slip explains it if not?"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from kinematics.answers.joint_questions import JointQuestion
from kinematics.answers.joint_verdicts import JointAnswer, JointMistake, RowVerdict
from kinematics.inverse import ArmReach, IKSolution
from kinematics.se3 import Transform

NEAR = math.radians(1.0)
"""How far off a row may be in any joint to be one that was rounded too early [rad or shares of the size]."""
FAR = 1e6  # Size of a joint value beyond which no decimals are missing [rad or the table's length].
_CHANGES = (
    (JointMistake.QUADRANT, 1.0, math.pi),
    (JointMistake.SIGN, -1.0, 0.0),
    (JointMistake.SWAPPED, -1.0, math.pi / 2),
)
"""Of one joint value q ↦ sign·q + shift."""


def judged_rows(question: JointQuestion, answer: JointAnswer) -> tuple[RowVerdict, ...]:
    """Return what is said of the rows: each has to reach the target, whatever the solver found."""
    rows = answer.rows
    if not rows:
        return ()
    poses = question.chain.poses(np.array(rows, dtype=np.float64))
    judged = [_row(question, answer, row, pose) for row, pose in zip(rows, poses, strict=True)]
    right = [(i, row) for i, (row, verdict) in enumerate(zip(rows, judged, strict=True)) if verdict.right]
    return tuple(
        verdict if verdict.right else _half_branch(question, row, verdict, right)
        for row, verdict in zip(rows, judged, strict=True)
    )


def _half_branch(
    question: JointQuestion,
    row: Sequence[float],
    verdict: RowVerdict,
    right: Sequence[tuple[int, Sequence[float]]],
) -> RowVerdict:
    """Return what is said of a wrong row that is a right one but for a joint that was turned over alone.

    To say that the joint is wrong would lead back to the solution that is there.
    """
    if verdict.joint is None or verdict.mistake is JointMistake.LIMITS:
        return verdict
    k = verdict.joint - 1
    for i, other in right:
        if question.apart([*row[:k], other[k], *row[k + 1 :]], other) <= 2.0 * question.tolerance:
            return replace(verdict, solution=None, mistake=JointMistake.HALF_BRANCH, other=i)
    return verdict


def _row(question: JointQuestion, answer: JointAnswer, row: Sequence[float], pose: Transform) -> RowVerdict:
    if all(question.errors(pose)):
        joint = next(_beyond_limits(question, row), None)
        if joint is not None:
            return RowVerdict(right=False, joint=joint, mistake=JointMistake.LIMITS)
        return RowVerdict(right=True, solution=_nearest(question, row)[0])
    nearest, off = _nearest(question, row) if all(abs(value) <= FAR for value in row) else (0, math.inf)
    if off <= NEAR:
        return RowVerdict(right=False, solution=nearest, mistake=JointMistake.ROUNDED)
    return _slip(question, answer, row)


def _beyond_limits(question: JointQuestion, row: Sequence[float]) -> Iterator[int]:
    """Yield the joints, from 1, that no number of full turns brings within their limits."""
    box = question.solver.box
    slack = question.tolerance if question.found.solutions else 0.0
    for i, (value, axis) in enumerate(zip(row, question.chain.axes, strict=True)):
        low, high = float(box.low[i]) - slack, float(box.high[i]) + slack
        if not axis.prismatic and math.isfinite(low):
            value = low + (value - low) % math.tau
        elif not axis.prismatic and math.isfinite(high):
            value = high - (high - value) % math.tau
        if not low <= value <= high:
            yield i + 1


def _slip(question: JointQuestion, answer: JointAnswer, row: Sequence[float]) -> RowVerdict:
    """Return what makes a wrong row right, joint by joint, if anything does: which solution it then is.

    A slip is one in the answerer's own variables.
    """
    turning = [i for i, axis in enumerate(question.chain.axes) if not axis.prismatic]
    own = answer.own(row)
    tried = [
        (mistake, i, answer.of_own([*own[:i], sign * own[i] + shift, *own[i + 1 :]]))
        for mistake, sign, shift in _CHANGES
        for i in (range(len(own)) if mistake is JointMistake.SIGN else turning)
    ]
    for unit in (math.degrees, math.radians):
        turned = [unit(value) if i in turning else value for i, value in enumerate(own)]
        if all(math.isfinite(value) for value in turned):
            tried.append((JointMistake.DEGREES, -1, answer.of_own(turned)))
    poses = question.chain.poses(np.array([changed for _, _, changed in tried], dtype=np.float64))
    for (mistake, i, changed), pose in zip(tried, poses, strict=True):
        if np.isfinite(pose).all() and all(question.errors(pose)):
            joint = i + 1 if i >= 0 else None
            solution = _nearest(question, changed)[0]
            return RowVerdict(right=False, solution=solution, joint=joint, mistake=mistake)
    position, orientation = question.errors(question.pose(row))
    half = None
    if question.reach is not ArmReach.POSITION and (position or orientation):
        half = JointMistake.POSITION_ONLY if position else JointMistake.ORIENTATION_ONLY
    return RowVerdict(right=False, mistake=half)


def _members(found: IKSolution) -> tuple[tuple[float, ...], ...]:
    members = () if found.family is None else found.family.members
    return (found.joints, *members)


def _nearest(question: JointQuestion, row: Sequence[float]) -> tuple[int | None, float]:
    """Return which solution, or family, a row is nearest to, and how far off it is; None if there is none."""
    distances = [
        min(_off(question, found, member, row) for member in _members(found))
        for found in question.found.solutions
    ]
    if not distances:
        return None, math.inf
    least = int(np.argmin(distances))
    return least, distances[least]


def _off(question: JointQuestion, found: IKSolution, member: Sequence[float], row: Sequence[float]) -> float:
    """Return how far a row is from a solution; along a straight family nothing counts."""
    family = found.family
    if family is None or family.direction is None:
        return question.apart(row, member)
    direction = family.direction
    k = max(range(len(direction)), key=lambda i: abs(direction[i]))
    t = (row[k] - member[k]) / direction[k]
    return question.apart(row, [value + t * rate for value, rate in zip(member, direction, strict=True)])
