"""The schematic: the type of every joint, and how each axis lies to the next.

It is what a drawing of the structure says (joint types in order, which consecutive axes are parallel, which
intersect), in words that can be graded. An axis of a prismatic joint has a direction but no place, so next to
one only the angle is judged.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from random import Random
from typing import Annotated, ClassVar

import numpy as np

from exercises.definition import Part
from exercises.grading import Feedback, Finding, HelpLevel
from exercises.parts.context import Context
from exercises.parts.protocol import Length, PartType, Reading
from exercises.parts.report import Credit, Fact, PartReport, judged, share_earned, told_from
from kinematics.chain import Axis, chain_of_table, size_of
from kinematics.errors import Fault
from kinematics.se3 import cross_arrays
from kinematics.table import JointType, NumericTable

EXACT = 1e-9  # Far above rounding, far below what a drawing shows.


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

    joints: Annotated[tuple[JointType, ...], Length(least=1)]
    relations: Annotated[tuple[AxisRelation, ...], Length(most=63)]


def schematic_faults(answer: Schematic) -> list[Fault]:
    """Return what keeps an answer from being graded; places inside the part's answer."""
    faults: list[Fault] = []
    if JointType.FIXED in answer.joints:
        faults.append(Fault.at("schematic_fixed_joint", "joints", answer.joints.index(JointType.FIXED)))
    pairs = max(len(answer.joints) - 1, 0)
    if len(answer.relations) != pairs:
        faults.append(
            Fault.at("schematic_relations_count", "relations", joints=len(answer.joints), expected=pairs)
        )
    return faults


def schematic_of(table: NumericTable) -> Schematic:
    """Return the structure of a robot.

    Neighbouring axes belong to one link, so their relation is the same in every configuration (but for the
    place of a prismatic axis, which has no meaning).
    """
    chain = chain_of_table(table)
    size = size_of(chain) or 1.0
    relations = tuple(relation(a, b, size) for a, b in zip(chain.axes, chain.axes[1:], strict=False))
    return Schematic(joints=table.joint_types, relations=relations)


def relation(first: Axis, second: Axis, size: float) -> AxisRelation:
    """Return how two axes lie relative to each other.

    Distances count as zero below `EXACT` of the robot's size.
    """
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


def _facts(key: Schematic, answer: Schematic, feedback: list[Feedback]) -> list[Fact]:
    return [*_joint_facts(key, answer, feedback), *_relation_facts(key, answer, feedback)]


def _about_one_axis(key: Schematic) -> Schematic:
    """Return what a table of zeros with revolute joints would show: as many as the robot's on one axis."""
    return Schematic(
        joints=(JointType.REVOLUTE,) * len(key.joints),
        relations=(AxisRelation.COINCIDENT,) * len(key.relations),
    )


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
        finding = _finding(expected, [_comparable(r, directions_only) for r in answer.relations], i)
        facts.append(Fact(where=("relations", i), finding=finding))
        if finding is Finding.WRONG and i < len(key.relations):
            feedback.append(
                Feedback(
                    code=_what_is_off(key.relations[i], answer.relations[i]),
                    params={"first": i + 1, "second": i + 2},
                )
            )
    return facts


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


class SchematicPart(PartType[Part, Schematic, Schematic]):
    """The structure: joint types, and how neighbouring axes lie."""

    kind = "schematic"
    raw: ClassVar = Schematic
    meaning = "joint types, and how neighbouring axes lie"
    disclosures: ClassVar = {
        **told_from(HelpLevel.ROW, "schematic_joint_count", "schematic_joint_type", "schematic_relation"),
        **told_from(
            HelpLevel.KIND, "schematic_angle_right", "schematic_meeting_right", instead="schematic_relation"
        ),
    }

    def read(self, raw: Schematic, reading: Reading) -> Schematic | None:
        """Return the structure, if its counts fit."""
        reading.faults.extend(schematic_faults(raw))
        return None if reading.faults else raw

    def grade(self, part: Part, answer: Schematic, context: Context) -> PartReport:
        """Judge each joint's type and each relation, less what turns about one axis have right."""
        key = schematic_of(context.reference_numbers)
        feedback: list[Feedback] = []
        facts = _facts(key, answer, feedback)
        right = [fact.finding is Finding.OK for fact in facts]
        if not feedback and not all(right):
            raise AssertionError("a wrong fact has its feedback")
        told = feedback or [Feedback(code="schematic_right")]
        asked = {fact.where: fact.finding is Finding.OK for fact in _facts(key, _about_one_axis(key), [])}
        score = share_earned(right, [asked.get(fact.where, True) for fact in facts])
        return judged(part, score, Credit.KEY, facts=facts, feedback=told)

    def right(self, part: Part, context: Context) -> Schematic:
        """Return the robot's structure: it does not follow from a table."""
        return schematic_of(context.reference_numbers)

    def wrong(self, part: Part, context: Context, rng: Random) -> Iterator[tuple[str, Schematic]]:
        """Yield the structure with a joint of another type, with one too many, and with another relation."""
        key = schematic_of(context.reference_numbers)
        other = {JointType.REVOLUTE: JointType.PRISMATIC, JointType.PRISMATIC: JointType.REVOLUTE}
        i = rng.randrange(len(key.joints))
        joints = (*key.joints[:i], other[key.joints[i]], *key.joints[i + 1 :])
        yield "schematic_joint_type", replace(key, joints=joints)
        longer = Schematic(
            joints=(*key.joints, JointType.REVOLUTE), relations=(*key.relations, AxisRelation.PARALLEL)
        )
        yield "schematic_joint_count", longer
        for k, relation_ in enumerate(key.relations):
            turned = (
                AxisRelation.SKEW_OBLIQUE if _ANGLES[relation_] is _Angle.PARALLEL else AxisRelation.PARALLEL
            )
            relations = (*key.relations[:k], turned, *key.relations[k + 1 :])
            yield "schematic_relation", replace(key, relations=relations)


PART = SchematicPart()
