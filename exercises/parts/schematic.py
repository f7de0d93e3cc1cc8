"""The schematic: the type of every joint, and how each axis lies to the next.

It is what a drawing of the structure says (joint types in order, which consecutive axes are parallel, which
intersect), in words that can be graded. An axis of a prismatic joint has a direction but no place, so next to
one only the angle is judged.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from fractions import Fraction

import numpy as np

from exercises.definition import PartKind
from exercises.grading import Feedback, Finding, HelpLevel
from exercises.parts.report import Credit, Disclosure, Fact, PartReport, shown
from kinematics.chain import Axis, chain_of_table, size_of
from kinematics.errors import Fault
from kinematics.se3 import cross_arrays
from kinematics.table import JointType, NumericTable

EXACT = 1e-9


class AxisRelation(StrEnum):
    """How an axis lies to the next."""

    COINCIDENT = "coincident"
    PARALLEL = "parallel"
    INTERSECTING_PERPENDICULAR = "intersecting_perpendicular"
    INTERSECTING_OBLIQUE = "intersecting_oblique"
    SKEW_PERPENDICULAR = "skew_perpendicular"
    SKEW_OBLIQUE = "skew_oblique"


class _Angle(StrEnum):
    PARALLEL = "parallel"
    PERPENDICULAR = "perpendicular"
    OBLIQUE = "oblique"


_ANGLES = {
    AxisRelation.COINCIDENT: _Angle.PARALLEL,
    AxisRelation.PARALLEL: _Angle.PARALLEL,
    AxisRelation.INTERSECTING_PERPENDICULAR: _Angle.PERPENDICULAR,
    AxisRelation.SKEW_PERPENDICULAR: _Angle.PERPENDICULAR,
    AxisRelation.INTERSECTING_OBLIQUE: _Angle.OBLIQUE,
    AxisRelation.SKEW_OBLIQUE: _Angle.OBLIQUE,
}


@dataclass(frozen=True, kw_only=True, slots=True)
class Schematic:
    """A robot's structure.

    Attributes:
        joints: type of joint 1 … n, fixed joints left out.
        relations: how axis i lies to axis i+1, for i = 1 … n-1.
    """

    joints: tuple[JointType, ...]
    relations: tuple[AxisRelation, ...]


def schematic_faults(answer: Schematic) -> list[Fault]:
    """What keeps an answer from being graded; places inside the part's answer."""
    faults: list[Fault] = []
    if JointType.FIXED in answer.joints:
        faults.append(
            Fault(
                code="schematic_fixed_joint",
                where=("joints", answer.joints.index(JointType.FIXED)),
            )
        )
    pairs = max(len(answer.joints) - 1, 0)
    if len(answer.relations) != pairs:
        faults.append(
            Fault(
                code="schematic_relations_count",
                where=("relations",),
                params={"joints": len(answer.joints), "expected": pairs},
            )
        )
    return faults


def schematic_of(table: NumericTable) -> Schematic:
    """The structure of a robot.

    Neighbouring axes belong to one link, so their relation is the same in every configuration (but for the
    place of a prismatic axis, which has no meaning).
    """
    chain = chain_of_table(table)
    size = size_of(chain) or 1.0
    relations = tuple(relation(a, b, size) for a, b in zip(chain.axes, chain.axes[1:], strict=False))
    return Schematic(joints=table.joint_types, relations=relations)


def relation(first: Axis, second: Axis, size: float) -> AxisRelation:
    """How two axes lie to each other; distances count as zero below `EXACT` of the robot's size."""
    a, b = np.array(first.direction), np.array(second.direction)
    apart = np.array(second.point) - np.array(first.point)
    normal = cross_arrays(a, b)
    sine = float(np.linalg.norm(normal))
    if sine < EXACT:
        distance = float(np.linalg.norm(cross_arrays(apart, a)))
        return AxisRelation.COINCIDENT if distance < EXACT * size else AxisRelation.PARALLEL
    meets = abs(float(apart @ normal)) / sine < EXACT * size
    square = math.isclose(abs(float(a @ b)), 0.0, abs_tol=EXACT)
    if meets:
        return AxisRelation.INTERSECTING_PERPENDICULAR if square else AxisRelation.INTERSECTING_OBLIQUE
    return AxisRelation.SKEW_PERPENDICULAR if square else AxisRelation.SKEW_OBLIQUE


def grade_schematic(
    reference: NumericTable, answer: Schematic, points: Fraction, help_level: HelpLevel
) -> PartReport:
    """Judge a schematic: each joint's type and each relation counts the same.

    Args:
        reference: the robot.
        answer: what was handed in.
        points: what the part is worth.
        help_level: how much may be told.
    """
    key = schematic_of(reference)
    feedback: list[Feedback] = []
    facts = [*_joint_facts(key, answer, feedback), *_relation_facts(key, answer, feedback)]
    right = sum(fact.finding is Finding.OK for fact in facts)
    correct = right == len(facts)
    if not feedback and not correct:
        raise AssertionError("a wrong fact has its feedback")
    report = PartReport(
        kind=PartKind.SCHEMATIC,
        correct=correct,
        score=right / len(facts),
        points=float(points) * right / len(facts),
        max_points=float(points),
        credit=Credit.KEY if right else Credit.NONE,
        facts=tuple(facts),
        feedback=tuple(feedback) or (Feedback(code="schematic_right"),),
    )
    return shown(report, help_level, _DISCLOSURES)


_DISCLOSURES = {
    "schematic_joint_count": Disclosure(level=HelpLevel.ROW),
    "schematic_joint_type": Disclosure(level=HelpLevel.ROW),
    "schematic_relation": Disclosure(level=HelpLevel.ROW),
    "schematic_angle_right": Disclosure(level=HelpLevel.KIND, instead="schematic_relation"),
    "schematic_meeting_right": Disclosure(level=HelpLevel.KIND, instead="schematic_relation"),
}


def _joint_facts(key: Schematic, answer: Schematic, feedback: list[Feedback]) -> list[Fact]:
    if len(answer.joints) != len(key.joints):
        feedback.append(Feedback(code="schematic_joint_count", params={"given": len(answer.joints)}))
    facts: list[Fact] = []
    for i in range(max(len(key.joints), len(answer.joints))):
        finding = _finding(key.joints, answer.joints, i)
        facts.append(Fact(where=("joints", i), finding=finding))
        if finding is Finding.WRONG and i < len(key.joints):
            feedback.append(Feedback(code="schematic_joint_type", params={"joint": i + 1}))
    return facts


def _relation_facts(key: Schematic, answer: Schematic, feedback: list[Feedback]) -> list[Fact]:
    facts: list[Fact] = []
    for i in range(max(len(key.relations), len(answer.relations))):
        directions_only = JointType.PRISMATIC in key.joints[i : i + 2]
        expected = [_comparable(r, directions_only) for r in key.relations]
        given = [_comparable(r, directions_only) for r in answer.relations]
        finding = _finding(expected, given, i)
        facts.append(Fact(where=("relations", i), finding=finding))
        if finding is Finding.WRONG and i < len(key.relations):
            feedback.append(
                Feedback(code=_what_is_off(key.relations[i], answer.relations[i]), params=_pair(i))
            )
    return facts


def _pair(i: int) -> dict[str, str | int | float | tuple[str, ...] | tuple[int, ...]]:
    return {"first": i + 1, "second": i + 2}


def _what_is_off(key: AxisRelation, given: AxisRelation) -> str:
    if _ANGLES[key] is _ANGLES[given]:
        return "schematic_angle_right"
    if _meets(key) and _meets(given):
        return "schematic_meeting_right"
    return "schematic_relation"


def _meets(relation: AxisRelation) -> bool:
    return relation in (AxisRelation.INTERSECTING_PERPENDICULAR, AxisRelation.INTERSECTING_OBLIQUE)


def _comparable(relation: AxisRelation, directions_only: bool) -> str:
    return _ANGLES[relation].value if directions_only else relation.value


def _finding(key: Sequence[str], given: Sequence[str], i: int) -> Finding:
    if i >= len(given):
        return Finding.MISSING
    return Finding.OK if i < len(key) and key[i] == given[i] else Finding.WRONG
