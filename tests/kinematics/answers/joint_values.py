"""Poses whose solutions are known by other means, and answers about them, right and wrong.

Poses come from the product of DH matrices as the seeds print it; the solutions of the planar arm and of the
SCARA from the law of cosines; those of the PUMA are every one evaluated by that product.
"""

from __future__ import annotations

import math
import random
import statistics
import sys
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics import catalogue
from kinematics.answers.joint_answers import JointQuestion, in_other_frames, joint_question, judge_joints
from kinematics.answers.joint_verdicts import JointAnswer, JointClaim
from kinematics.inverse import ArmReach, solver_of
from kinematics.table import Convention, JointType, NumericTable, bind

Floats = NDArray[np.float64]
CLEAR = 0.05
"""[rad, or share of the size] A wrong joint value is at least so far off."""


def product(table: NumericTable, joints: Sequence[float]) -> Floats:
    """⁰T_N, link by link, by the matrices of the two conventions as they are printed."""
    values = iter(joints)
    pose = np.eye(4)
    for row in table.rows:
        theta, d = row.theta, row.d
        if row.joint is JointType.REVOLUTE:
            theta += row.sign * next(values)
        elif row.joint is JointType.PRISMATIC:
            d += row.sign * next(values)
        ct, st, ca, sa = math.cos(theta), math.sin(theta), math.cos(row.alpha), math.sin(row.alpha)
        if table.convention is Convention.STANDARD:
            link = [[ct, -st * ca, st * sa, row.a * ct], [st, ct * ca, -ct * sa, row.a * st], [0, sa, ca, d]]
        else:
            link = [[ct, -st, 0, row.a], [st * ca, ct * ca, -sa, -d * sa], [st * sa, ct * sa, ca, d * ca]]
        pose = pose @ np.array([*link, [0, 0, 0, 1]])
    return pose


def robot(name: str) -> NumericTable:
    """A robot of the catalogue with its usual values."""
    found = catalogue.robot(name)
    return bind(found.table.table, dict(found.parameters))


@dataclass(frozen=True)
class Posed:
    """A pose, the question about it, and all its solutions by other means."""

    question: JointQuestion
    solutions: list[list[float]]


def posed(rng: random.Random) -> Posed:
    """A random pose of one of three arms."""
    name = rng.choice(["twolink", "scara", "puma560"])
    table = robot(name)
    q = [rng.uniform(-3, 3) for _ in table.joint_types]
    if name == "puma560":
        q[4] = rng.choice([-1, 1]) * rng.uniform(0.3, 2.8)
    else:
        q[1] = rng.choice([-1, 1]) * rng.uniform(0.2, 2.8)
    target = product(table, q)
    reach = ArmReach.POSITION if name == "twolink" else ArmReach.POSE
    question = joint_question(solver_of(table, reach=reach), target, reach=reach)
    if name == "puma560":
        solutions = [list(found.joints) for found in question.found.solutions]
        assert all(np.allclose(product(table, row), target, atol=1e-7) for row in solutions)
        return Posed(question, solutions)
    return Posed(question, [q, _other_elbow(table, q, name)])


def _other_elbow(table: NumericTable, q: list[float], name: str) -> list[float]:
    """The triangle of both links, mirrored over the line to the tip; the last angle keeps the sum."""
    lengths = [row.a for row in table.rows if row.a]
    first, second = lengths[0], lengths[1]
    inside = math.atan2(second * math.sin(q[1]), first + second * math.cos(q[1]))
    other = [*q]
    other[0], other[1] = q[0] + 2 * inside, -q[1]
    if name == "scara":
        sign = round(product(table, [0.0] * 4)[2, 2])
        before, after = q[0] + q[1], other[0] + other[1]
        other[3] = q[3] + sign * (before - after)
    assert np.allclose(product(table, other)[:3, 3], product(table, q)[:3, 3], atol=1e-9)
    return other


def answers(case: Posed, rng: random.Random) -> Iterator[tuple[str, bool, JointAnswer]]:
    """Right answers written differently and wrong ones, in the variables of some other table."""
    axes = case.question.chain.axes
    rows = [
        [
            round(value + (0 if axis.prismatic else 2 * math.pi * rng.randint(-2, 2)), 4)
            for value, axis in zip(row, axes, strict=True)
        ]
        for row in case.solutions
    ]
    rng.shuffle(rows)
    k, joint = rng.randrange(len(rows)), rng.randrange(len(axes))
    bad = [list(row) for row in rows]
    bad[k][joint] += rng.choice([-1, 1]) * rng.uniform(CLEAR, math.pi)
    made = [
        ("all", True, rows, JointClaim.FINITE),
        ("one again", True, [*rows, rows[k]], JointClaim.FINITE),
        ("one missing", False, rows[:k] + rows[k + 1 :], JointClaim.FINITE),
        ("one wrong", False, bad, JointClaim.FINITE),
        ("one beside", False, [*rows, bad[k]], JointClaim.FINITE),
        ("infinite", False, rows, JointClaim.INFINITE),
        ("none", False, [], JointClaim.OUT_OF_REACH),
    ]
    signs = [rng.choice([-1, 1]) for _ in axes]
    offsets = [rng.uniform(-1, 1) for _ in axes]
    for name, right, found, claim in made:
        own = tuple(tuple(s * q + d for s, q, d in zip(signs, row, offsets, strict=True)) for row in found)
        answer = JointAnswer(claim=claim, rows=own)
        yield name, right, in_other_frames(answer, signs, offsets)


def campaign(count: int, seed: int = 1) -> tuple[int, int, list[str]]:
    """Judge answers to so many poses; how many were right, wrong, and which were misjudged."""
    rng = random.Random(seed)
    right = wrong = 0
    misjudged = []
    for i in range(count):
        case = posed(rng)
        for name, expected, answer in answers(case, rng):
            right += expected
            wrong += not expected
            if judge_joints(case.question, answer).right != expected:
                misjudged.append(f"{i}: {name}")
    return right, wrong, misjudged


def timing(count: int, seed: int = 2) -> tuple[float, float]:
    """Median times [ms] of deciding a right and a wrong answer."""
    times: dict[bool, list[float]] = {True: [], False: []}
    rng = random.Random(seed)
    for _ in range(count):
        case = posed(rng)
        for _, expected, answer in answers(case, rng):
            start = time.perf_counter()
            judge_joints(case.question, answer)
            times[expected].append(1e3 * (time.perf_counter() - start))
    return statistics.median(times[True]), statistics.median(times[False])


if __name__ == "__main__":
    amount = int(sys.argv[1]) if len(sys.argv) > 1 else 2_000
    print("right, wrong, misjudged:", campaign(amount), "median ms right, wrong:", timing(300))
