"""Campaigns: the checker against many tables, valid and wrong; `make campaign` runs a million.

Every function here takes the number of a block and returns what happened in it, so that blocks can be run by
as many processes as there are, and any block again by itself.
"""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass, field
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
)
from kinematics.equivalence.reference import prepared
from kinematics.forward import forward_kinematics
from kinematics.table import DHTable, JointType, NumericTable, bind
from tests.kinematics.equivalence.generators import random_robot, random_valid_table, rounded
from tests.kinematics.equivalence.mutations import mutations

EXACT = Tolerance(length=1e-9, angle=1e-9)
RANDOM_ROBOTS = 200
TABLES_PER_BLOCK = 100
LARGEST_TOLERANCE = 0.1


@dataclass
class Outcome:
    """What happened to a number of tables.

    Attributes:
        tables: how many were tried.
        accepted: how many were accepted.
        failures: what should not have happened, each with what is needed to see it again.
        residual: the largest residual of an accepted one.
        kinds: how many of each kind.
    """

    tables: int = 0
    accepted: int = 0
    failures: list[str] = field(default_factory=list)
    residual: float = 0.0
    kinds: Counter[str] = field(default_factory=Counter)

    def __iadd__(self, other: Outcome) -> Outcome:
        self.tables += other.tables
        self.accepted += other.accepted
        self.failures += other.failures
        self.residual = max(self.residual, other.residual)
        self.kinds += other.kinds
        return self


def catalogue() -> list[tuple[str, NumericTable]]:
    """The robots of the catalogue, with numbers."""
    return [(robot.id, bind(robot.table.table, dict(robot.parameters))) for robot in robots()]


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
            outcome.failures += _contradictions(
                reference, table, decision.certificate, EXACT, f"{name}, block {block}, table {i}"
            )
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


def rounded_tables(block: int) -> Outcome:
    """Valid tables with entries rounded to three decimals must be accepted at the matching tolerance.

    Left out are tables with axes so far away that rounding moves the end by a tenth of the robot's size.
    """
    rng = Random(f"rounded {block}")
    known = references()
    outcome = Outcome()
    for i in range(TABLES_PER_BLOCK):
        name, reference = known[(block * TABLES_PER_BLOCK + i) % len(known)]
        table = rounded(random_valid_table(reference, rng, dummies=0.0, textbook_ends=True), 3)
        tolerance = matching_tolerance(reference, table, 0.5e-3)
        if tolerance.length > LARGEST_TOLERANCE:
            outcome.kinds["three decimals say nothing"] += 1
            continue
        outcome.tables += 1
        decision = decide(reference, table, Policy(tool=ToolRule.FREE, tolerance=tolerance))
        if decision.certificate is None:
            outcome.failures.append(f"rejected: {name}, block {block}, table {i}: {decision.mismatches}")
        else:
            outcome.accepted += 1
            outcome.residual = max(outcome.residual, decision.certificate.residual)
    return outcome


def matching_tolerance(reference: NumericTable, table: NumericTable, half_step: float) -> Tolerance:
    """What rounding can do at the worst: every entry off by half a step, and all adding up."""
    entries = 2 * len(table.rows)
    reach = sum(abs(row.a) + abs(row.d) for row in table.rows)
    slides = sum(row.joint is JointType.PRISMATIC for row in table.rows) * prepared(reference).size
    angle = entries * half_step
    length = entries * half_step + angle * (reach + slides)
    return Tolerance(length=length / prepared(reference).size, angle=angle)


def wrong_tables(block: int) -> Outcome:
    """A table with a mistake is rejected, or accepted with a certificate that stands afresh."""
    rng = Random(f"wrong {block}")
    known = references()
    policy = Policy(tool=ToolRule.FREE)
    outcome = Outcome()
    while outcome.tables < TABLES_PER_BLOCK:
        name, reference = rng.choice(known)
        table = random_valid_table(reference, rng, dummies=0.0)
        for mutation in rng.sample(made := mutations(table, rng), min(10, len(made))):
            decision = decide(reference, mutation.table, policy)
            outcome.tables += 1
            outcome.kinds[mutation.kind] += 1
            if decision.certificate is not None:
                outcome.accepted += 1
                place = f"{name}, block {block}, {mutation.kind}"
                outcome.failures += _contradictions(
                    reference, mutation.table, decision.certificate, policy.tolerance, place
                )
    return outcome


def _contradictions(
    reference: NumericTable, table: NumericTable, certificate: Certificate, tolerance: Tolerance, place: str
) -> list[str]:
    """Where F_s(σ∘q + δ) = B · F_r(q) · E fails, evaluated from the DH tables row by row."""
    rng = Random(place)
    size = prepared(reference).size
    signs, offsets = np.array(certificate.joint_signs), np.array(certificate.joint_offsets)
    for _ in range(5):
        q = np.array(
            [
                rng.uniform(-math.pi, math.pi) if joint is JointType.REVOLUTE else rng.uniform(-size, size)
                for joint in reference.joint_types
            ]
        )
        left = forward_kinematics(table, signs * q + offsets).transform
        right = certificate.base @ forward_kinematics(reference, q).transform @ certificate.tool
        turned = float(np.linalg.norm(left[:3, :3] - right[:3, :3])) / math.sqrt(2.0)
        apart = float(np.linalg.norm(left[:3, 3] - right[:3, 3])) / size
        # the largest error lies a little beyond the largest one sampled
        if turned > 1.5 * tolerance.angle + 1e-9 or apart > 1.5 * tolerance.length + 1e-9:
            return [f"certificate does not stand: {place}: {turned:.2e} rad, {apart:.2e}"]
    return []


def order_swapped(table: NumericTable, i: int, j: int) -> NumericTable:
    """The table with two rows exchanged."""
    rows = list(table.rows)
    rows[i], rows[j] = rows[j], rows[i]
    return DHTable(convention=table.convention, rows=tuple(rows))
