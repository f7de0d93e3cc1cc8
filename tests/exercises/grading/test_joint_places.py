"""Where a joint may have been left out or be one too many: never elsewhere than where it was."""

from dataclasses import replace
from random import Random

import pytest

from exercises.grading import BaseRule, HelpLevel, Policy, ToolRule, grade
from exercises.grading.edits.joint_places import joint_places
from exercises.grading.edits.work import Work
from exercises.grading.explanation import work_on
from exercises.grading.facts import Weights
from exercises.grading.judging.comparison import comparisons
from exercises.grading.standard import standard_of, wrong_of
from kinematics.chain import chain_of_table
from kinematics.equivalence.invariants import axes_of
from kinematics.table import DHRow, DHTable, JointType, NumericTable
from tests.exercises.grading.campaign import drawn_by_hand
from tests.exercises.grading.written import written
from tests.kinematics.equivalence.campaign import catalogue

FREE = Policy(tool=ToolRule.FREE)
SIX = [(name, key) for name, key in catalogue() if key.n_joints == 6]


FRAMES = Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME)


def work(key: NumericTable, answer: NumericTable, policy: Policy = FREE) -> Work:
    tables = written(key), written(answer)
    (way,) = comparisons(*tables, None)
    return work_on(way, tables, policy)


def without(table: NumericTable, row: int) -> NumericTable:
    return DHTable(convention=table.convention, rows=(*table.rows[:row], *table.rows[row + 1 :]))


def with_more(table: NumericTable, row: int) -> NumericTable:
    more = DHRow(joint=JointType.REVOLUTE, theta=0.0, d=0.0, a=0.3, alpha=1.0)
    return DHTable(convention=table.convention, rows=(*table.rows[:row], more, *table.rows[row:]))


@pytest.mark.parametrize(("name", "key"), SIX, ids=[name for name, _ in SIX])
def test_the_place_of_the_joint_is_among_those_that_may_be(name: str, key: NumericTable) -> None:
    table = drawn_by_hand(key, Random(name))
    assert table is not None
    for joint, row in enumerate(table.joint_rows, 1):
        ((start, end),) = joint_places([work(key, without(table, row))])
        assert start <= joint <= end
        ((start, end),) = joint_places([work(key, with_more(table, row))])
        assert start <= joint <= end


@pytest.mark.parametrize(("name", "key"), SIX, ids=[name for name, _ in SIX])
def test_what_is_lost_is_seen_as_it_is_counted_from_both_ends(name: str, key: NumericTable) -> None:
    table = drawn_by_hand(key, Random(name))
    assert table is not None
    for row in table.joint_rows:
        for answer in (work(key, without(table, row)), work(key, with_more(table, row))):
            standard = standard_of(answer.reference, answer.policy, Weights())
            facts = replace(standard.facts, invariants=answer.facts)
            by_axes = facts.wrong(axes_of(chain_of_table(answer.table), answer.policy))
            assert wrong_of(answer, standard) == pytest.approx(by_axes, abs=1e-12)


@pytest.mark.parametrize("name", ["irb140", "kr100p", "kr2150k", "lrmate200id"])
def test_where_links_differ_there_is_one_place_beside_the_joint_itself(name: str) -> None:
    """A joint, and the one behind it: between the two nothing but the joint itself is measured."""
    key = dict(SIX)[name]
    table = drawn_by_hand(key, Random(name))
    assert table is not None
    more = [joint_places([work(key, with_more(table, row))]) for row in table.joint_rows[1:5]]
    assert more == [[(joint, joint + 1)] for joint in range(2, 6)]
    fewer = [joint_places([work(key, without(table, row))]) for row in table.joint_rows[:3]]
    assert fewer == [[(joint, joint + 1)] for joint in range(1, 4)]


@pytest.mark.parametrize("name", ["irb140", "kr100p", "kr2150k", "lrmate200id"])
def test_frames_at_the_ends_stay_where_they_are(name: str) -> None:
    """Axes are counted from the one to the joint, and behind it from the other."""
    table = drawn_by_hand(dict(SIX)[name], Random(name))
    assert table is not None
    more = [joint_places([work(table, with_more(table, row), FRAMES)]) for row in table.joint_rows]
    assert more == [[(joint, joint + 1)] for joint in range(1, 7)]
    fewer = [joint_places([work(table, without(table, row), FRAMES)]) for row in table.joint_rows]
    assert fewer[:3] == [[(joint, joint + 1)] for joint in range(1, 4)]
    assert all(start <= joint <= end for joint, ((start, end),) in enumerate(fewer, 1))


@pytest.mark.parametrize("name", ["irb140", "kr100p", "kr2150k", "lrmate200id"])
def test_a_frame_0_beside_the_first_axis_stays_where_it_is(name: str) -> None:
    table = drawn_by_hand(dict(SIX)[name], Random(name))
    assert table is not None
    foot = DHRow(joint=JointType.FIXED, theta=0.3, d=0.2, a=0.4, alpha=0.7)
    tilted = DHTable(convention=table.convention, rows=(foot, *table.rows))
    more = [joint_places([work(tilted, with_more(tilted, row), FRAMES)]) for row in tilted.joint_rows]
    assert more == [[(joint, joint + 1)] for joint in range(1, 7)]


def test_a_length_wrong_on_the_far_side_leaves_no_place() -> None:
    key = dict(SIX)["ur5"]
    far = replace(key.rows[1], a=2.0 * key.rows[1].a)
    table = DHTable(convention=key.convention, rows=(key.rows[0], far, *key.rows[2:]))
    struck = work(key, without(table, 4))
    ((start, end),) = joint_places([struck])
    assert not start <= 5 <= end
    ((start, end),) = joint_places([work(key, without(key, 4))])
    assert start <= 5 <= end


def test_a_table_without_a_joint_is_told_the_only_one() -> None:
    row = DHRow(joint=JointType.REVOLUTE, theta=0.0, d=0.2, a=0.3, alpha=0.0)
    one = DHTable(convention=SIX[0][1].convention, rows=(row,))
    none = replace(one, rows=(replace(row, joint=JointType.FIXED, theta=0.0),))
    assert joint_places([work(one, none)]) == [(0, 10**6)]
    verdict = grade(written(one), written(none), FREE)
    assert "joint_fixed" in {edit.code for repair in verdict.repairs for edit in repair.edits}


@pytest.mark.parametrize(("name", "row"), [("puma560", 1), ("puma560", 6), ("rx90", 5), ("scara", 2)])
def test_of_a_row_typed_twice_it_is_told_once_that_it_is_not_needed(name: str, row: int) -> None:
    """Without its variable it would stand for nothing, too; its type is as right as that of the other one."""
    key = dict(catalogue())[name]
    twice = replace(key, rows=(*key.rows[:row], *key.rows[row - 1 :]))
    told = [(entry.code, entry.row) for entry in grade(written(key), written(twice), FREE).feedback]
    assert {code for code, at in told if at is not None} == {"row_not_needed"}
    assert {("row_not_needed", row), ("row_not_needed", row + 1)} <= set(told)
    assert len(told) == len(set(told))


@pytest.mark.parametrize("name", ["rx90", "kr125", "puma600", "panda"])
@pytest.mark.parametrize("level", [HelpLevel.KIND, HelpLevel.ROW, HelpLevel.REPAIR])
def test_one_joint_more_at_the_end_is_told_as_its_row_alone(name: str, level: HelpLevel) -> None:
    """A joint before it could lose its variable as well; two of these robots end in a row without one."""
    key = dict(catalogue())[name]
    more = DHRow(joint=JointType.REVOLUTE, theta=0.0, d=0.0, a=0.0, alpha=0.0)
    longer = replace(key, rows=(*key.rows, more))
    verdict = grade(written(key), written(longer), FREE, None, level)
    told = {(entry.code, entry.row) for entry in verdict.feedback if entry.row is not None}
    assert told == {("row_not_needed", len(longer.rows))}
    if level is HelpLevel.REPAIR:
        assert [edit.code for edit in verdict.repairs[0].edits] == ["row_extra"]
