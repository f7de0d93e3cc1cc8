"""Every single slip in a robot of the catalogue is told in the cell where it was made."""

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

import pytest

from exercises.grading import BaseRule, DirectionRule, HelpLevel, Policy, ToolRule, ZeroRule, grade
from kinematics.catalogue import robots
from kinematics.cells import AngleUnit, RawRow, RawTable, ReadTable, read_table
from kinematics.expressions import ZERO, Expression, Number, add, multiply, parameters_in, pi_times
from kinematics.table import CELLS, Convention, DHRow, DHTable, JointType

STRICT = Policy(
    base=BaseRule.FRAME, tool=ToolRule.FRAME, zero=ZeroRule.FIGURE, direction=DirectionRule.FIGURE
)
ROBOTS = {robot.id: robot for robot in robots()}
CODES = {"a": "length_wrong", "alpha": "twist_wrong", "d": "offset_wrong", "theta": "angle_wrong"}


def slips(row: DHRow[Expression]) -> Iterator[tuple[str, Expression]]:
    """Cells that hold no variable, and what may stand there: nothing, the other sign, something else."""
    variable = {JointType.REVOLUTE: "theta", JointType.PRISMATIC: "d"}.get(row.joint)
    for cell in CELLS:
        here: Expression = getattr(row, cell)
        if cell == variable:
            continue
        if here != ZERO:
            yield from ((cell, ZERO), (cell, multiply((Number(Fraction(-1)), here))))
        off = Number(Fraction(1, 3)) if cell in ("a", "d") else pi_times(Fraction(1, 6))
        yield cell, add((here, off))


def tilted_gantry(alpha3: int) -> ReadTable:
    """Three sliders, no two at right angles, and a wrist."""
    rows = (
        RawRow(joint=JointType.PRISMATIC, alpha=90, a=0, d="q1", theta=90),
        RawRow(joint=JointType.PRISMATIC, alpha=60, a=0, d="q2", theta=90),
        RawRow(joint=JointType.PRISMATIC, alpha=alpha3, a="w", d="q3", theta=0),
        RawRow(joint=JointType.REVOLUTE, alpha=90, a=0, d="k", theta="q4"),
        RawRow(joint=JointType.REVOLUTE, alpha=0, a=0, d=0, theta="q5"),
    )
    return read_table(RawTable(convention=Convention.STANDARD, rows=rows, angle_unit=AngleUnit.DEG))


@pytest.mark.parametrize("alpha", [0, 180, 10, 90])
def test_a_twist_left_out_beside_sliders_is_the_only_one_told(alpha: int) -> None:
    """Parallel axes have no turn about a slider: one that appears once they are tilted solves nothing."""
    verdict = grade(tilted_gantry(30), tilted_gantry(alpha), Policy())
    assert [(entry.code, entry.row) for entry in verdict.feedback] == [
        ("not_equivalent", None),
        ("twist_wrong", 3),
    ]


@pytest.mark.parametrize("policy", [Policy(), STRICT], ids=["usual", "strict"])
@pytest.mark.parametrize("name", ["onelink", "twolink", "scara-scm", "stanford", "puma560", "panda"])
def test_a_single_slip_is_told_where_it_was_made(name: str, policy: Policy) -> None:
    key = ROBOTS[name].table
    given = dict(ROBOTS[name].parameters)
    wrong = 0
    for i, row in enumerate(key.table.rows):
        for cell, slip in slips(row):
            rows = (*key.table.rows[:i], replace(row, **{cell: slip}), *key.table.rows[i + 1 :])
            used = {name for each in rows for here in CELLS for name in parameters_in(getattr(each, here))}
            answer: ReadTable = replace(
                key,
                table=DHTable(convention=key.table.convention, rows=rows),
                parameters={name: kind for name, kind in key.parameters.items() if name in used},
            )
            verdict = grade(key, answer, policy, given, HelpLevel.KIND)
            if verdict.correct:  # an end that the policy leaves free
                continue
            wrong += 1
            told = {(entry.code, entry.row) for entry in verdict.feedback}
            assert told & {(CODES[cell], i + 1), ("sign_wrong", i + 1)}, (i + 1, cell, slip, told)
    assert wrong
