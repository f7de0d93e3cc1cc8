"""What an answer earns that follows from the student's own wrong table: all of it, unless that says little.

An error is marked once. But from a table of zeros every matrix is a turn about z, and none is an achievement.
"""

import math
from dataclasses import replace

from exercises.grading import Feedback
from exercises.parts.report import PLACES, Credit, PartReport
from kinematics.table import JointType, NumericTable

ENOUGH = 0.5  # Of the lengths and twists of the key a wrong table has this share at least, or less is earned.
PARALLEL = 1e-6  # A sine: the table turns no axis against the one before it.
_EARNED = frozenset(
    {"matrices_follow_table", "transform_follows_table", "pose_follows_table", "jacobian_follows_table"}
)


def share_that_follows(own: NumericTable, key: NumericTable) -> float:
    """Return which share of its points an answer earns that follows from a wrong table."""
    wanted = ENOUGH * _says(key)
    return min(1.0, _says(own) / wanted) if wanted else 1.0


def _says(table: NumericTable) -> int:
    """How many lengths and twists a table has that are not zero."""
    return sum(
        (abs(math.sin(row.alpha)) > PARALLEL)
        + bool(row.a)
        + (bool(row.d) and row.joint is not JointType.PRISMATIC)
        for row in table.rows
    )


def as_it_follows(report: PartReport, share: float) -> PartReport:
    """Return the report on a part with what it earns where it follows from a table that says little."""
    if share >= 1.0:
        return report
    kept = tuple(entry for entry in report.feedback if entry.code not in _EARNED)
    return replace(
        report,
        score=report.score * share,
        points=round(report.points * share, PLACES),
        credit=report.credit if share else Credit.NONE,
        feedback=(*kept, Feedback(code="table_says_little")),
    )
