"""How much of a wrong answer is right."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

from exercises.grading.repairs import Repaired
from kinematics.equivalence import Decision, Kind, Policy, ToolRule, decide
from kinematics.table import DHRow, JointType, NumericTable

WITHOUT_REPAIR = 0.9
HIGHEST_PARTIAL = 0.95


def score_of(
    decision: Decision, repairs: Sequence[Repaired], table: NumericTable, key: NumericTable
) -> float:
    """Partial credit of a wrong answer, in [0, 0.95].

    With a repair, 1 less the share of the rows that its misconceptions spoiled: half a row for a cell, a row
    for a row, one and a half for a misconception about the table, out of one more than there are rows.
    Without one, nine tenths of the share of facts that were found; what a table of zeros has right counts for
    nothing.
    """
    if repairs:
        spoiled = sum(change.extent.value for change in repairs[0].changes)
        return round(max(0.0, min(HIGHEST_PARTIAL, 1.0 - spoiled / (len(table.rows) + 1))), 4)
    if decision.same_robot:
        return round(min(HIGHEST_PARTIAL, 1.0 - len(decision.mismatches) / (key.n_joints + 1)), 4)
    wrong = _number_wrong(decision) + 3 * abs(key.n_joints - table.n_joints)
    facts = max(_facts_to_find(key), wrong, 1)
    return round(WITHOUT_REPAIR * (1.0 - wrong / facts), 4)


def _number_wrong(decision: Decision) -> int:
    return len({(m.kind, m.joint) for m in decision.mismatches if m.kind is not Kind.HANDEDNESS})


@lru_cache(maxsize=256)
def _facts_to_find(key: NumericTable) -> int:
    """How many facts of a robot a table of zeros, all of whose joints turn, has wrong."""
    empty = tuple(
        DHRow(
            joint=JointType.FIXED if row.joint is JointType.FIXED else JointType.REVOLUTE,
            theta=0.0,
            d=0.0,
            a=0.0,
            alpha=0.0,
        )
        for row in key.rows
    )
    return _number_wrong(decide(key, replace(key, rows=empty), Policy(tool=ToolRule.FREE)))
