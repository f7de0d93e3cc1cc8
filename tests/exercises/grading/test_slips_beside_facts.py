"""A slip that spoils many facts costs what it costs, and only what else is wrong comes on top of it."""

from dataclasses import replace

import pytest

from exercises.grading import ConventionRule, DirectionRule, Policy, ToolRule, Verdict, ZeroRule, grade
from exercises.grading.edits.changes import Change, Extent, with_joints_mended
from kinematics.table import Convention, DHRow, JointType, NumericTable
from tests.exercises.grading.written import written
from tests.kinematics.equivalence.campaign import catalogue, references
from tests.kinematics.equivalence.tables import HALF, PUMA, P, R, changed, standard

FREE = Policy(tool=ToolRule.FREE)
RX90 = dict(catalogue())["rx90"]
CELLS: dict[tuple[int, str], float] = {(1, "alpha"): 0.3, (2, "a"): 0.5, (4, "d"): 0.3, (4, "alpha"): 0.3}
OF_PUMA = 9


def judged(key: NumericTable, answer: NumericTable) -> Verdict:
    return grade(written(key), written(answer), FREE)


def in_the_wrong_convention(key: NumericTable) -> NumericTable:
    other = Convention.MODIFIED if key.convention is Convention.STANDARD else Convention.STANDARD
    return replace(key, convention=other)


def with_rows_exchanged(key: NumericTable, row: int) -> NumericTable:
    rows = list(key.rows)
    rows[row - 1], rows[row] = rows[row], rows[row - 1]
    return replace(key, rows=tuple(rows))


@pytest.mark.parametrize("cell", CELLS, ids=lambda cell: f"{cell[1]} of row {cell[0]}")
def test_another_cell_costs_one_fact_in_the_wrong_convention(cell: tuple[int, str]) -> None:
    row, name = cell
    verdict = judged(PUMA, in_the_wrong_convention(changed(PUMA, row, **{name: CELLS[cell]})))
    assert verdict.score == round(1 - 4 / OF_PUMA, 2)
    assert verdict.repairs[0].edits[0].code == "convention"


def test_every_more_cell_costs_one_more() -> None:
    scores, wrong = [], PUMA
    for (row, name), value in CELLS.items():
        wrong = changed(wrong, row, **{name: value})
        scores.append(judged(PUMA, in_the_wrong_convention(wrong)).score)
    assert scores == [round(1 - (3 + k) / OF_PUMA, 2) for k in range(1, 5)]


@pytest.mark.parametrize("row", range(1, 7))
def test_a_wrong_type_in_the_wrong_convention_is_told_and_costs_both(row: int) -> None:
    rows = list(PUMA.rows)
    rows[row - 1] = replace(rows[row - 1], joint=JointType.PRISMATIC)
    verdict = judged(PUMA, in_the_wrong_convention(replace(PUMA, rows=tuple(rows))))
    told = [(edit.code, edit.row) for edit in verdict.repairs[0].edits]
    assert told == [("convention", None), ("joint_type", row)]
    assert verdict.score == round(1 - (3 + 2) / OF_PUMA, 2)


def test_a_cell_beside_two_rows_exchanged_costs_one_fact() -> None:
    exchanged = with_rows_exchanged(RX90, 3)
    alone, of_rx90 = judged(RX90, exchanged), 8
    assert (alone.repairs[0].edits[0].code, alone.score) == ("rows_swapped", 1 - 2 / of_rx90)
    both = judged(RX90, changed(exchanged, 5, alpha=0.3))
    assert both.score == round(1 - 3 / of_rx90, 2)


SLIDERS = standard(
    (R, 0.4, 0.2, 0.1, 0.3),
    (P, -1.1, 0, 0, 0.5),
    (P, 0.5, 0, 0, 1.0),
    (P, -1.2, 0.1, 0, 0.8),
    (R, 0, 0, 0, 0),
)


@pytest.mark.parametrize(("row", "other"), [(2, 3), (2, 4), (3, 4)])
def test_two_rows_of_sliders_exchanged_are_one_slip(row: int, other: int) -> None:
    """What is wrong across sliders counts as one fact at the least; so one row might do as well."""
    rows = list(SLIDERS.rows)
    rows[row - 1], rows[other - 1] = rows[other - 1], rows[row - 1]
    assert judged(SLIDERS, replace(SLIDERS, rows=tuple(rows))).score == round(1 - 2 / 7, 2)


@pytest.mark.parametrize("zero", [ZeroRule.FREE, ZeroRule.FIGURE])
@pytest.mark.parametrize("direction", [DirectionRule.FREE, DirectionRule.FIGURE])
def test_a_twist_in_the_wrong_convention_earns_no_rule_that_nobody_sees_kept(
    zero: ZeroRule, direction: DirectionRule
) -> None:
    """Of the facts and the rules together the convention costs three, the twist one, and each rule one."""
    policy = replace(FREE, zero=zero, direction=direction)
    rules = (zero is ZeroRule.FIGURE) + (direction is DirectionRule.FIGURE)
    answer = in_the_wrong_convention(changed(PUMA, 4, alpha=0.3))
    verdict = grade(written(PUMA), written(answer), policy)
    assert verdict.score == round(1 - (3 + 1 + rules) / (OF_PUMA + rules), 2)


@pytest.mark.parametrize("wrong_cells", [0, 1])
def test_a_slip_does_not_hide_a_convention_that_is_not_asked_for(wrong_cells: int) -> None:
    """The rule costs beside exchanged rows what it costs beside one wrong cell."""
    wrong = changed(PUMA, 2, a=0.5) if wrong_cells else PUMA
    answer = with_rows_exchanged(wrong, 3)
    asked = replace(FREE, convention=ConventionRule.MODIFIED)
    assert judged(PUMA, answer).score == round(1 - (2 + wrong_cells) / OF_PUMA, 2)
    verdict = grade(written(PUMA), written(answer), asked)
    assert verdict.score == round(1 - (2 + wrong_cells + 1) / OF_PUMA, 2)


def test_zeros_earn_nothing_however_they_are_read() -> None:
    """Across its prismatic joints a table of zeros has more facts wrong than may count."""
    for name, key in references():
        if name in ("random 41", "random 90", "stanford", "scara"):
            rows = tuple(replace(row, theta=0.0, d=0.0, a=0.0, alpha=0.0) for row in key.rows)
            assert judged(key, replace(key, rows=rows)).score == 0.0
            assert judged(key, in_the_wrong_convention(replace(key, rows=rows))).score == 0.0


def test_one_row_too_many_and_one_missing_are_put_right_one_after_the_other() -> None:
    key = standard((R, 0, 0.2, 0, 0))
    fixed = replace(key, rows=(DHRow(joint=JointType.FIXED, theta=0.0, d=0.0, a=0.3, alpha=0.0),))
    changes = (Change("row_extra", Extent.ROW, 0), Change("row_missing", Extent.ROW, 1))
    mended = with_joints_mended(fixed, changes, key.joint_types)
    assert mended.joint_types == key.joint_types
    twice = (Change("row_missing", Extent.ROW, 1), Change("row_missing", Extent.ROW, 1))
    types = (JointType.REVOLUTE, JointType.REVOLUTE, JointType.PRISMATIC)
    assert with_joints_mended(key, twice, types).joint_types == types


def test_what_is_put_right_stands_in_the_rows_of_the_answer() -> None:
    """With a row too many in front of it a joint stands one row earlier then; a new row is one of zeros."""
    table = standard((R, 0, 0.1, 0, 0), (R, 0, 0.2, 0, 0), (R, 0, 0.3, 0, 0))
    wanted = (JointType.REVOLUTE, JointType.PRISMATIC)
    changes = (Change("row_extra", Extent.ROW, 0), Change("joint_type", Extent.ROW, 2))
    mended = with_joints_mended(table, changes, wanted)
    assert [(row.joint, row.a) for row in mended.rows] == [(wanted[0], 0.2), (wanted[1], 0.3)]
    both = (Change("row_extra", Extent.ROW, 0), Change("row_extra", Extent.ROW, 2))
    assert [row.a for row in with_joints_mended(table, both, wanted).rows] == [0.2]
    longer = with_joints_mended(table, (Change("row_missing", Extent.ROW, 1),), (wanted[1],) * 4)
    assert longer.rows[1] == DHRow(joint=JointType.PRISMATIC, theta=0.0, d=0.0, a=0.0, alpha=0.0)
    assert [row.a for row in longer.rows] == [0.1, 0.0, 0.2, 0.3]


KR2150K, KR125 = (dict(catalogue())[name] for name in ("kr2150k", "kr125"))


@pytest.mark.parametrize(
    ("key", "wrong", "cell"),
    [
        (PUMA, changed(changed(PUMA, 2, alpha=1.1), 5, alpha=0.0), (6, "alpha", -HALF)),
        (RX90, changed(RX90, 3, alpha=-HALF, a=0.0), (1, "a", RX90.rows[2].a)),
        (KR2150K, changed(KR2150K, 5, alpha=2 * HALF, a=0.4), (1, "alpha", -HALF)),
        (KR125, changed(changed(KR125, 5, d=-0.85), 3, alpha=-HALF), (6, "d", 0.0)),
        (KR2150K, changed(changed(KR2150K, 6, alpha=0.0), 3, a=-1.3), (7, "alpha", HALF)),
    ],
    ids=["puma", "rx90", "kr2150k", "kr125, fixed row", "kr2150k, fixed row"],
)
def test_a_cell_that_no_fact_asks_for_makes_no_exchange_of_two_rows(
    key: NumericTable, wrong: NumericTable, cell: tuple[int, str, float]
) -> None:
    """What such a cell holds neither mends the other row nor needs to be mended."""
    row, name, value = cell
    assert judged(key, changed(key, row, **{name: value})).correct
    assert judged(key, changed(wrong, row, **{name: value})).score == judged(key, wrong).score
