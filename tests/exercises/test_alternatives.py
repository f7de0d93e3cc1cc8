"""Other tables beside a right one: right for the exercise, different, and said to differ in what differs."""

from dataclasses import replace

import pytest

from exercises.alternatives import other_tables
from exercises.answers import RawAnswer, parse
from exercises.grader import grade
from exercises.grading import ConventionRule, Policy
from exercises.instance import generate
from exercises.parts.mistakes.compare_tables import ComparisonReason
from exercises.selftest.robustness import strictest_policy
from exercises.selftest.variants import key_as_asked
from exercises.written_table import written_table
from kinematics.cells import AngleUnit, LengthUnit, RawRow, RawTable, read_table
from kinematics.table import Convention, JointType
from tests.exercises.packaged import exercise, table_ids

ONE_JOINT = RawTable(
    convention=Convention.STANDARD,
    rows=(RawRow(joint=JointType.REVOLUTE, alpha="20", a="1", d="1", theta="q1"),),
    angle_unit=AngleUnit.DEG,
    length_unit=LengthUnit.M,
)


@pytest.mark.parametrize("convention", list(ConventionRule))
@pytest.mark.parametrize("strict", [False, True])
def test_another_table_is_there_and_is_right_under_every_rule(
    convention: ConventionRule, strict: bool
) -> None:
    for name in table_ids:
        asked = exercise(name)
        policy = strictest_policy(asked.policy) if strict else asked.policy
        held = replace(asked, policy=replace(policy, convention=convention))
        key = key_as_asked(held.reference, held.policy)
        instance = generate(held)
        found = other_tables(key, held.policy, instance.parameters, 2)
        assert found
        assert len({written_table(other.table) for other in found} - {written_table(key)}) == len(found)
        for other in found:
            assert other.reasons
            raw = RawAnswer(table=written_table(other.table))
            assert grade(instance, parse(instance, raw)).correct
            if convention is not ConventionRule.ANY:
                assert other.table.table.convention.value == convention.value


def test_where_all_is_prescribed_an_axis_is_reversed_behind_a_fixed_row() -> None:
    policy = replace(strictest_policy(exercise("twolink").policy), convention=ConventionRule.STANDARD)
    (other,) = other_tables(read_table(ONE_JOINT), policy, {}, 2)
    assert [row.joint for row in other.table.table.rows] == [JointType.FIXED, JointType.REVOLUTE]
    assert (other.table.table.rows[1].sign, other.reasons) == (-1, {ComparisonReason.AXIS_REVERSED})


def test_a_table_without_joints_has_no_joint_to_reverse() -> None:
    fixed = replace(ONE_JOINT, rows=(replace(ONE_JOINT.rows[0], joint=JointType.FIXED, theta="30"),))
    policy = Policy(convention=ConventionRule.STANDARD)
    others = other_tables(read_table(fixed), policy, {}, 3)
    assert {reason for other in others for reason in other.reasons} == {ComparisonReason.ORIGIN_MOVED}
