"""A decimal may be near what it does not stand for: read as it was typed, the answer may still be right."""

import math

from exercises.grading import BaseRule, Policy, ToolRule, ZeroRule, grade
from kinematics.cells import RawRow, RawTable, read_table
from kinematics.table import Convention, JointType
from tests.exercises.grading.written import written
from tests.kinematics.equivalence.tables import HALF, P, R, modified

SLANTED = modified(
    (R, math.pi / 3, 0, 0, 0), (P, 2 * math.pi / 3, 0, 0, 0), (R, 0, 0, 0, 0), (R, HALF, 0, 0, 0)
)
POLICY = Policy(base=BaseRule.ORIGIN, tool=ToolRule.FREE, zero=ZeroRule.FIGURE)


def answer(theta: str, a: str) -> RawTable:
    rows = [
        (JointType.REVOLUTE, "-q1 + (0.000)", "-1.063", "0.000", "0.000"),
        (JointType.PRISMATIC, theta, "q2 + (0.153)", a, "-1.047"),
        (JointType.REVOLUTE, "q3 + (1.308)", "0.378", "-0.953", "0.000"),
        (JointType.REVOLUTE, "q4 + (1.821)", "-1.764", "0.000", "1.571"),
        (JointType.FIXED, "0.000", "0.000", "-0.830", "-1.648"),
    ]
    return RawTable(
        convention=Convention.MODIFIED,
        rows=tuple(
            RawRow(joint=joint, theta=theta, d=d, a=length, alpha=alpha)
            for joint, theta, d, length, alpha in rows
        ),
    )


def test_a_constant_near_a_multiple_of_15_degrees_stands_for_itself_too() -> None:
    """θ = 1.833458 is typed 1.833, and so is 105°: as that, two axes that meet would pass too far apart."""
    assert grade(written(SLANTED), read_table(answer("1.833", "-0.248")), POLICY).correct
    for theta, a in (("1.843", "-0.248"), ("1.823", "-0.248"), ("1.833", "-0.258"), ("1.833", "-0.238")):
        assert not grade(written(SLANTED), read_table(answer(theta, a)), POLICY).correct
