"""Campaigns: the checker against many tables, valid and wrong; `make campaign` runs a million.

Every function here takes the number of a block and returns what happened in it, so that blocks can be run by
as many processes as there are, and any block again by itself.
"""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass, field, replace
from functools import cache
from random import Random

import numpy as np

from kinematics.catalogue import robots
from kinematics.equivalence import (
    BaseRule,
    Certificate,
    DirectionRule,
    Policy,
    Tolerance,
    ToolRule,
    ZeroRule,
    decide,
    rounding_tolerance,
)
from kinematics.equivalence.reference import prepared
from kinematics.table import JointType, NumericTable, bind
from tests.kinematics.equivalence.evaluation import CONFIGURATIONS, evaluated, poses_of
from tests.kinematics.equivalence.generators import random_robot, random_valid_table, rounded
from tests.kinematics.equivalence.mutations import mutations
from tests.kinematics.equivalence.strict_generator import strict_table

EXACT = Tolerance(length=1e-9, angle=1e-9)
NOTHING = 1e-8
NOTHING_FREE = Policy(
    base=BaseRule.FRAME,
    tool=ToolRule.FRAME,
    zero=ZeroRule.FIGURE,
    direction=DirectionRule.FIGURE,
    tolerance=EXACT,
)
RANDOM_ROBOTS = 200
TABLES_PER_BLOCK = 100
MUTANTS_PER_TABLE = 10
DECIMALS = 3
MEANINGLESS = 1.0
# what is found by climbing may be a little less than the largest there is
MARGIN = 1.05


@dataclass
class Outcome:
    """What happened to a number of tables.

    Attributes:
        tables: how many were tried.
        accepted: how many were accepted.
        confirmed: how many of these have a certificate that stood when evaluated afresh.
        left_out: how many were drawn and not tried.
        mended: for how many a single edit was found.
        right_row: how many of these edits are in the row of the mistake.
        failures: what should not have happened, each with what is needed to see it again.
        residual: the largest residual of an accepted one.
        kinds: how many of each kind.
    """

    tables: int = 0
    accepted: int = 0
    confirmed: int = 0
    left_out: int = 0
    mended: int = 0
    right_row: int = 0
    failures: list[str] = field(default_factory=list)
    residual: float = 0.0
    kinds: Counter[str] = field(default_factory=Counter)

    def __iadd__(self, other: Outcome) -> Outcome:
        self.tables += other.tables
        self.accepted += other.accepted
        self.confirmed += other.confirmed
        self.left_out += other.left_out
        self.mended += other.mended
        self.right_row += other.right_row
        self.failures += other.failures
        self.residual = max(self.residual, other.residual)
        self.kinds += other.kinds
        return self


def catalogue() -> list[tuple[str, NumericTable]]:
    """The robots of the catalogue, with numbers."""
    return [(robot.id, bind(robot.table.table, dict(robot.parameters))) for robot in robots()]


@cache
def references() -> list[tuple[str, NumericTable]]:
    """Every robot of the catalogue and 200 random ones."""
    drawn = [(f"random {k}", random_robot(Random(f"robot {k}"))) for k in range(RANDOM_ROBOTS)]
    return catalogue() + drawn


def valid_tables(block: int) -> Outcome:
    """Valid tables of every robot must be accepted, with a certificate that holds to 1e-9."""
    rng = Random(f"valid {block}")
    known = references()
    outcome = Outcome()
    for i in range(TABLES_PER_BLOCK):
        name, reference = known[(block * TABLES_PER_BLOCK + i) % len(known)]
        policy, changes = policy_and_choices(reference, rng)
        table = random_valid_table(reference, rng, **changes)
        decision = decide(reference, table, policy)
        outcome.tables += 1
        outcome.kinds[policy.tool.value if policy.base is BaseRule.FREE else policy.base.value] += 1
        if decision.certificate is None:
            outcome.failures.append(f"rejected: {name}, block {block}, table {i}: {decision.mismatches}")
            continue
        outcome.accepted += 1
        outcome.residual = max(outcome.residual, decision.certificate.residual)
        if i % 10 == 0:
            place = f"{name}, block {block}, table {i}"
            confirm(outcome, reference, table, decision.certificate, EXACT, place)
    return outcome


def policy_and_choices(reference: NumericTable, rng: Random) -> tuple[Policy, dict[str, object]]:
    """A policy, and how tables that keep it are drawn."""
    choice = rng.randrange(6)
    if choice < 3:
        return Policy(tool=ToolRule.FREE, tolerance=EXACT), {}
    if choice == 3:
        return Policy(tool=ToolRule.AXIS, tolerance=EXACT), {"dummies": 0.0, "textbook_ends": True}
    if choice == 4:
        rules = {"base": BaseRule.AXIS, "tool": ToolRule.FREE}
        return Policy(**rules, tolerance=EXACT), {"dummies": 0.0, "textbook_ends": True}
    rules = {"zero": ZeroRule.FIGURE, "direction": DirectionRule.FIGURE, "tool": ToolRule.FREE}
    return Policy(**rules, tolerance=EXACT), {"keep_zero": True, "keep_direction": True}


def strict_tables(block: int) -> Outcome:
    """Tables that keep any rules together are accepted, with a certificate that keeps them as well.

    Where the rules leave nothing free, a table with a mistake is accepted exactly if it is the same function
    of the joint variables, which is seen by evaluating both.
    """
    rng = Random(f"strict {block}")
    known = references()
    outcome = Outcome()
    for i in range(TABLES_PER_BLOCK):
        name, reference = known[(block * TABLES_PER_BLOCK + i) % len(known)]
        place = f"{name}, block {block}, table {i}"
        policy = replace(random_rules(rng), tolerance=EXACT)
        table = strict_table(reference, policy, rng)
        certificate = decide(reference, table, policy).certificate
        outcome.tables += 1
        outcome.kinds[f"base {policy.base.value}, tool {policy.tool.value}"] += 1
        if certificate is None:
            outcome.failures.append(f"rejected: {place}: {policy}")
        else:
            outcome.accepted += 1
            outcome.residual = max(outcome.residual, certificate.residual)
            confirm(outcome, reference, table, certificate, EXACT, place)
            broken = rules_broken(certificate, policy, reference)
            outcome.failures += [f"certificate breaks {rule}: {place}" for rule in broken]
        drawn = strict_table(reference, NOTHING_FREE, rng)
        made = [m.table for m in mutations(drawn, rng) if m.table.joint_types == reference.joint_types]
        if made:
            wrong = rng.choice(made)
            same = are_the_same(reference, wrong)
            if decide(reference, wrong, NOTHING_FREE).accepted is not same:
                outcome.failures.append(f"accepted is {not same}: {place}, with a mistake and nothing free")
    return outcome


def random_rules(rng: Random) -> Policy:
    """Any rules together."""
    return Policy(
        base=rng.choice(list(BaseRule)),
        tool=rng.choice(list(ToolRule)),
        zero=rng.choice(list(ZeroRule)),
        direction=rng.choice(list(DirectionRule)),
    )


def rules_broken(certificate: Certificate, policy: Policy, reference: NumericTable) -> list[str]:
    """The rules that a certificate itself shows to be broken."""
    offsets = [
        math.remainder(offset, 2 * math.pi) if joint is JointType.REVOLUTE else offset
        for offset, joint in zip(certificate.joint_offsets, reference.joint_types, strict=True)
    ]
    broken = []
    if policy.zero is ZeroRule.FIGURE and max(map(abs, offsets)) > NOTHING:
        broken.append("zero")
    if policy.direction is DirectionRule.FIGURE and min(certificate.joint_signs) < 0:
        broken.append("direction")
    if policy.base in (BaseRule.FRAME, BaseRule.ORIGIN) and abs(certificate.base[:3, 3]).max() > NOTHING:
        broken.append("base")
    if policy.base is BaseRule.FRAME and abs(certificate.base - np.eye(4)).max() > NOTHING:
        broken.append("base")
    if policy.tool in (ToolRule.FRAME, ToolRule.POINT) and abs(certificate.tool[:3, 3]).max() > NOTHING:
        broken.append("tool")
    if policy.tool is ToolRule.FRAME and abs(certificate.tool - np.eye(4)).max() > NOTHING:
        broken.append("tool")
    return broken


def are_the_same(one: NumericTable, other: NumericTable) -> bool:
    """Whether two tables are the same function of the joint variables."""
    joints = np.random.default_rng(0).uniform(-math.pi, math.pi, (CONFIGURATIONS, one.n_joints))
    return bool(np.allclose(poses_of(one, joints), poses_of(other, joints), atol=NOTHING, rtol=0.0))


def rounded_tables(block: int) -> Outcome:
    """Valid tables with entries rounded to three decimals must be accepted at the matching tolerance.

    Left out are tables in which three decimals say nothing: rounding them may move the end by the robot's
    size.
    """
    rng = Random(f"rounded {block}")
    known = references()
    step = 10.0**-DECIMALS
    outcome = Outcome()
    for i in range(TABLES_PER_BLOCK):
        name, reference = known[(block * TABLES_PER_BLOCK + i) % len(known)]
        exact = random_valid_table(reference, rng, dummies=0.0, textbook_ends=True)
        table = rounded(exact, DECIMALS)
        tolerance = rounding_tolerance(reference, table, length_step=step, angle_step=step)
        if tolerance.length > MEANINGLESS:
            outcome.left_out += 1
            continue
        outcome.tables += 1
        outcome.kinds[f"tolerance up to {10.0 ** math.ceil(math.log10(tolerance.length)):g}"] += 1
        decision = decide(reference, table, Policy(tool=ToolRule.FREE, tolerance=tolerance))
        place = f"{name}, block {block}, table {i}"
        if decision.certificate is None:
            outcome.failures.append(f"rejected: {place}: {decision.mismatches}")
            continue
        outcome.accepted += 1
        outcome.residual = max(outcome.residual, decision.certificate.residual)
        if i % 10 == 0:
            confirm(outcome, reference, table, decision.certificate, tolerance, place)
    return outcome


def wrong_tables(block: int) -> Outcome:
    """A table with a mistake is rejected, or accepted with a certificate that stands afresh."""
    rng = Random(f"wrong {block}")
    known = references()
    policy = Policy(tool=ToolRule.FREE)
    outcome = Outcome()
    while outcome.tables < TABLES_PER_BLOCK:
        name, reference = rng.choice(known)
        table = random_valid_table(reference, rng, dummies=0.0)
        for mutation in rng.sample(made := mutations(table, rng), min(MUTANTS_PER_TABLE, len(made))):
            decision = decide(reference, mutation.table, policy)
            outcome.tables += 1
            outcome.kinds[mutation.kind] += 1
            if decision.certificate is not None:
                outcome.accepted += 1
                outcome.residual = max(outcome.residual, decision.certificate.residual)
                place = f"{name}, block {block}, {mutation.kind}"
                confirm(outcome, reference, mutation.table, decision.certificate, policy.tolerance, place)
    return outcome


def confirm(
    outcome: Outcome,
    reference: NumericTable,
    table: NumericTable,
    certificate: Certificate,
    tolerance: Tolerance,
    place: str,
) -> None:
    """Evaluate a certificate afresh, and enter what comes of it."""
    size = size_beside(reference, table)
    found = evaluated(reference, table, certificate, size, place)
    if found.angle <= MARGIN * tolerance.angle and found.length <= MARGIN * tolerance.length * size:
        outcome.confirmed += 1
    else:
        apart = found.length / size
        outcome.failures.append(f"certificate does not stand: {place}: {found.angle:.2e} rad, {apart:.2e}")


def size_beside(reference: NumericTable, table: NumericTable) -> float:
    """The length that relative ones refer to: see docs/checker.md."""
    lengths = [abs(length) for row in table.rows for length in (row.a, row.d)]
    key = prepared(reference)
    return (sum(lengths) or 1.0) if key.scaleless else key.size
