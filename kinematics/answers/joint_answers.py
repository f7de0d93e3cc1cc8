"""Joint values that reach a pose: is an answer right, and are all of them there?

A row of joint values is right when F(q) is the target, to within a tolerance of positions (as a share of the
arm's size) and angles; revolute joints count modulo 2π. All are there when every solution of the complete set
of `kinematics.inverse` has its row. Where solutions form a family, a row is one member of it, and a
combination c·q that is fixed on the family says which others belong: every row q + t d with c·d = 0, over the
joints that stand in c, is then computed and has to reach the target, too.

Answers in other frames are carried over by a certificate: q = σ∘(q_s − δ), T = B⁻¹ T_s E⁻¹, and a combination
c_s·q_s = (c_s∘σ)·q + constant.
"""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from kinematics.answers.joint_questions import JointQuestion
from kinematics.answers.joint_rows import judged_rows
from kinematics.answers.joint_verdicts import Branch, JointAnswer, JointClaim, JointVerdict, RowVerdict
from kinematics.inverse import IKSolution
from kinematics.se3 import Floats

STEPS = (0.7, 2.1, -1.3)
"""How far along a family an answer's condition is tried [rad or shares of the arm's size]: on no symmetry."""
STILL = 1e-9  # Share of a family's direction below which a joint does not move along it.
PARALLEL = 1e-6
"""Sine of the angle [rad] below which neighbouring axes count as parallel, to tell elbows from shoulders."""


def judge_joints(question: JointQuestion, answer: JointAnswer) -> JointVerdict:
    """Judge an answer against the complete set."""
    expected = question.expected
    if expected in _NONE:
        right = answer.claim is expected
        told = expected is JointClaim.JOINT_LIMITS and not right
        rows = judged_rows(question, answer) if told else ()
        share = 1.0 if right else 0.5 * (answer.claim in _NONE)
        return JointVerdict(right=right, share=share, expected=expected, rows=rows)
    rows = judged_rows(question, answer)
    good = [row for row in rows if row.right]
    says_none = answer.claim in _NONE
    valid = tuple(_combination_holds(question, answer, rows, c) for c in answer.combinations)
    loose = tuple(
        not holds and _stays(question, c) for holds, c in zip(valid, answer.combinations, strict=True)
    )
    if any(valid):  # beside a condition, what is fixed besides is true
        valid = tuple(a or b for a, b in zip(valid, loose, strict=True))
        loose = (False,) * len(loose)
    if not question.every:
        reached = bool(rows) and len(good) == len(rows) and not says_none
        too_many = answer.claim is JointClaim.INFINITE and expected is JointClaim.FINITE
        right = reached and not too_many and all(valid)
        return JointVerdict(
            right=right,
            share=1.0 if right else 0.5 * reached,
            expected=expected,
            rows=rows,
            combinations=valid,
            loose=loose,
        )
    solutions = question.found.solutions
    covered = {k for k in range(len(solutions)) if _covered(question, answer, rows, valid, k)}
    touched = {row.solution for row in good}
    meant = touched | {row.solution for row in rows}
    missing = tuple(
        _branch(question, solutions[k], [solutions[j] for j in sorted(covered)])
        for k in range(len(solutions))
        if k not in meant and not says_none
    )
    whole = len(covered) == len(solutions)
    right = answer.claim is expected and whole and len(good) == len(rows) and all(valid)
    wrong = len(rows) - len(good) + valid.count(False)
    wrong += answer.claim is JointClaim.INFINITE and expected is JointClaim.FINITE
    found = len(covered) + 0.5 * len(touched - covered)
    share = 0.0 if says_none else max(0.0, min(found, len(solutions) - wrong)) / len(solutions)
    return JointVerdict(
        right=right,
        share=1.0 if right else min(share, 0.95),
        expected=expected,
        rows=rows,
        missing=missing,
        combination_missing=any(_has_condition(solutions[k]) for k in touched - covered if k is not None)
        and not says_none,
        combinations=valid,
        loose=loose,
        complete=question.known,
    )


_NONE = (JointClaim.OUT_OF_REACH, JointClaim.JOINT_LIMITS)


def _combination_holds(
    question: JointQuestion, answer: JointAnswer, rows: Sequence[RowVerdict], combination: Sequence[float]
) -> bool:
    """Return whether a combination describes some family, or that of some row."""
    families = [found for found in question.found.solutions if found.family is not None]
    if any(_moves_alone(found, combination) for found in families):
        return True
    members = [row for row, verdict in zip(answer.rows, rows, strict=True) if verdict.right]
    members += [found.joints for found in families]
    return any(combination) and any(_describes(question, row, combination) for row in members)


def _moves_alone(found: IKSolution, combination: Sequence[float]) -> bool:
    """Return whether one joint moves alone along a family, and a combination names one that stands still."""
    direction = None if found.family is None else found.family.direction
    moving = [] if direction is None else [i for i, rate in enumerate(direction) if abs(rate) > STILL]
    named = [i for i, value in enumerate(combination) if value]
    return len(moving) == len(named) == 1 and moving != named


def _stays(question: JointQuestion, combination: Sequence[float]) -> bool:
    """Return whether a combination is fixed along every straight family, of which there is one."""
    families = [found.family for found in question.found.solutions if found.family is not None]
    directions = [family.direction for family in families if family.direction is not None]
    return any(combination) and bool(directions) and all(_fixed(combination, d) for d in directions)


def _fixed(combination: Sequence[float], direction: Sequence[float]) -> bool:
    """Return whether c·d = 0."""
    c, d = np.array(combination), np.array(direction)
    return abs(float(c @ d)) <= 1e-6 * float(np.linalg.norm(c)) * float(np.linalg.norm(d))


def _describes(question: JointQuestion, row: Sequence[float], combination: Sequence[float]) -> bool:
    """Return whether every configuration with the same c·q, other joints as they are, reaches the target."""
    joints = [i for i, value in enumerate(combination) if value]
    directions = _free(combination, joints, len(row))
    if not directions:
        return False
    for direction in directions:
        for step in STEPS:
            scale = step * (question.size if question.chain.axes[joints[0]].prismatic else 1.0)
            if not question.reaches([q + scale * d for q, d in zip(row, direction, strict=True)]):
                return False
    return True


def _free(combination: Sequence[float], joints: Sequence[int], n: int) -> list[Floats]:
    """Return directions d with c·d = 0 over the joints of c, as many as are independent."""
    pivot = max(joints, key=lambda i: abs(combination[i]))
    found = []
    for i in joints:
        if i != pivot:
            direction = np.zeros(n)
            direction[i], direction[pivot] = 1.0, -combination[i] / combination[pivot]
            found.append(direction)
    return found


def _covered(
    question: JointQuestion, answer: JointAnswer, rows: Sequence[RowVerdict], valid: Sequence[bool], k: int
) -> bool:
    """Return whether a solution has its row, and a straight family its condition besides.

    Of a family without a condition it has to be said that there are infinitely many.
    """
    own = [row for row, verdict in zip(answer.rows, rows, strict=True) if verdict.solution == k]
    family = question.found.solutions[k].family
    if not own or family is None:
        return bool(own)
    direction = family.direction
    if direction is None or not _has_condition(question.found.solutions[k]):
        return answer.claim is JointClaim.INFINITE
    return any(
        holds and _fixed(c, direction) and any(_describes(question, row, c) for row in own)
        for c, holds in zip(answer.combinations, valid, strict=True)
    )


def _has_condition(found: IKSolution) -> bool:
    """Return whether a solution is a straight family of several joints, which a combination describes."""
    direction = None if found.family is None else found.family.direction
    return direction is not None and sum(abs(rate) > STILL for rate in direction) > 1


def _branch(question: JointQuestion, missing: IKSolution, others: Sequence[IKSolution]) -> Branch:
    """Return how a solution differs from the one among others that is most like it."""
    if not others:
        return Branch.OTHER
    axes = question.chain.axes
    n = len(axes)
    elbow = next(
        (
            i
            for i in range(n - 1)
            if not axes[i].prismatic
            and not axes[i + 1].prismatic
            and np.linalg.norm(np.cross(axes[i].direction, axes[i + 1].direction)) < PARALLEL
        ),
        None,
    )

    def same(other: IKSolution, i: int) -> bool:
        apart = missing.joints[i] - other.joints[i]
        return abs(apart if axes[i].prismatic else math.remainder(apart, math.tau)) < 1e-6

    alike = max(others, key=lambda other: sum(same(other, i) for i in range(n)))
    if n >= 3 and all(same(alike, i) for i in range(n - 3)) and n > 3:
        return Branch.WRIST
    if elbow is None:
        return Branch.OTHER
    return Branch.ELBOW if all(same(alike, i) for i in range(elbow)) else Branch.SHOULDER


def in_other_frames(answer: JointAnswer, signs: Sequence[int], offsets: Sequence[float]) -> JointAnswer:
    """Return an answer in the key's variables: q = σ∘(q_s − δ), and c = c_s∘σ.

    Args:
        answer: in the variables of an accepted table.
        signs: σ of its certificate.
        offsets: δ of its certificate [rad, or a length].
    """
    n = len(signs)
    moved = replace(answer, signs=tuple(signs), offsets=tuple(offsets))
    return replace(
        moved,
        rows=tuple(moved.of_own(row) for row in answer.rows),
        combinations=tuple(tuple(row[i] * signs[i] for i in range(n)) for row in answer.combinations),
    )
