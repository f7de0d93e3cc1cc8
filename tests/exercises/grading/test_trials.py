"""Edits tried at once: where another may finish, which cells are solved for, what is alike at other draws."""

import math
from collections.abc import Iterator
from dataclasses import replace

import pytest

from exercises.grading import Policy, ToolRule, ZeroRule
from exercises.grading.edits.changes import Change, Extent, TableSlip
from exercises.grading.edits.other_draws import alike_at
from exercises.grading.edits.scope import EVERYWHERE, EditScope
from exercises.grading.edits.trials import _Batch, _fits, finishing, finishing_reaches
from exercises.grading.edits.work import Work
from exercises.grading.explanation import work_on
from exercises.grading.judging.comparison import comparisons
from kinematics.table import NumericTable
from tests.exercises.grading.test_edits_tried import ARM, CHANGES, FIXED, Rows, work
from tests.exercises.grading.test_grade import with_cells
from tests.exercises.grading.written import read

SHORT_ROWS = [ARM[0], ("pi/6", 0, "q2", 0.3), ARM[3]]
SHORT = read("standard", SHORT_ROWS)
"""The arm without its second row."""


@pytest.mark.parametrize(
    ("reach", "meets"), [((1, 4), True), ((2, 3), True), ((3, 3), False), ((4, 3), False)], ids=str
)
def test_what_fails_meets_where_one_edit_has_to_do_with_all_of_it(
    reach: tuple[int, int], meets: bool
) -> None:
    assert EditScope(reach).meet is meets


def test_a_joint_that_is_missing_is_sought_where_nothing_is_known_yet() -> None:
    """Between what fits as counted from the base and from the tool; what is known already stays."""
    short = work(SHORT)
    known, right = (1, 2), work(read("standard", ARM))
    found = finishing_reaches([short, replace(short, scope=EditScope(known)), right])
    assert found[0] != EVERYWHERE
    assert found[0][0] <= 2 <= found[0][1]
    assert found[1:] == [known, EVERYWHERE]


def test_no_edit_is_asked_for_where_the_missing_joint_has_no_place() -> None:
    """But a table that has the key's joints may be wrong throughout, wherever that shows."""
    asked: list[Work] = []

    def nothing(work: Work) -> Iterator[Change]:
        asked.append(work)
        return iter(())

    short, right = (
        replace(work(read("standard", rows)), scope=EditScope((3, 2))) for rows in (SHORT_ROWS, ARM)
    )
    assert finishing([short, right], nothing) == [[], []]
    assert [one.table for one in asked] == [right.table]


def test_after_a_length_no_angle_is_solved_for() -> None:
    """With a length first, an angle that fails is never mended."""
    short = work(SHORT)
    made = [(0, change) for change in CHANGES["row_missing"](short)]
    turned = [(0, change) for _, change in made if change.cells[0][2] == math.pi / 2]
    left = {
        (change.cells[-1][1], change.unsolved)
        for _, change in _Batch([short], turned).solved(finishing=False)
    }
    assert left == {("alpha", ("a", "d")), ("a", ("d",))}
    # of twists nothing comes that is not among the rows put in already
    assert {change.cells[-1][1] for _, change in _Batch([short], made).solved(finishing=False)} == {"a"}


def test_cells_solved_for_in_another_order_make_the_same_row() -> None:
    change = Change("row_missing", Extent.ROW, 1, cells=((1, "a", 0.2), (1, "d", 0.1), (1, "alpha", math.pi)))
    other = change._replace(cells=((1, "alpha", 2e-8 - math.pi), (1, "d", 0.1), (1, "a", 0.2 + 1e-12)))
    assert _Batch._content(0, change) == _Batch._content(0, other)
    for apart in (((1, "alpha", 1e-6),), ((1, "alpha", 0.0), (1, "a", 1e-8))):
        further = change._replace(cells=apart)
        assert _Batch._content(0, further) != _Batch._content(0, change._replace(cells=((1, "alpha", 0.0),)))


def test_values_are_sought_for_all_cells_while_nothing_is_known_of_what_is_off() -> None:
    for place, wrong in (
        ((0, "alpha"), (1, 0, 0.7)),
        ((1, "a"), (2, 1, 0.3)),
        ((1, "theta"), (2, 3, "q2 + 0.4")),
    ):
        (found,) = _fits([work(read("standard", with_cells(ARM, wrong)))])
        assert found[place]
    free = work_on(
        comparisons(*(tables := (read("standard", ARM), read("standard", ARM))), {})[0],
        tables,
        Policy(tool=ToolRule.FREE, zero=ZeroRule.FREE),
    )
    assert not any(_fits([free])[0].values())


def test_an_entry_of_the_answer_is_first_what_it_is_itself_at_another_draw() -> None:
    """Two entries are equal at one draw and differ at another: the sign of one is flipped."""

    def table(a: float, other: float) -> NumericTable:
        rows: Rows = [("pi/2", a, 0, "q1"), (0, other, 0, "q2")]
        return work(read("standard", rows), FIXED, read("standard", rows)).table

    own, keys = (table(0.3, 0.3), table(0.7, 0.5)), (table(0.3, 0.2), table(0.4, 0.6))
    for row, alike in ((0, -0.7), (1, -0.5)):
        flipped = Change("a_sign", Extent.CELL, row, "a", ((row, "a", -0.3),))
        changed = alike_at(flipped, own, keys)
        assert changed is not None
        assert changed.cells == ((row, "a", pytest.approx(alike)),)
    taken = alike_at(Change("a_value", Extent.CELL, 0, "a", ((0, "a", 0.2),)), own, keys)
    assert taken is not None
    assert taken.cells == ((0, "a", pytest.approx(0.6)),)


@pytest.mark.parametrize("sign", [1, -1])
def test_a_length_that_is_a_sum_or_a_difference_is_that_at_another_draw(sign: int) -> None:
    """An offset makes up for another; a twist that is a sum is no such thing, and stays itself."""

    def table(first: float, second: float) -> NumericTable:
        rows: Rows = [(first, first, 0, "q1"), (second, second, 0, "q2")]
        return work(read("standard", rows), FIXED, read("standard", rows)).table

    tables = table(0.7, 0.2), table(0.5, 0.4)
    here, there = (first + sign * second for first, second in ((0.7, 0.2), (0.5, 0.4)))
    for cell, expected in (("a", there), ("d", there), ("alpha", here)):
        changed = alike_at(Change("", Extent.CELL, 0, cell, ((0, cell, -here),)), tables, tables)
        assert changed is not None
        assert changed.cells == ((0, cell, pytest.approx(-expected)),)


def test_a_length_that_is_near_to_no_entry_is_not_taken_for_one() -> None:
    rows: Rows = [("pi/2", 1e-4, 0, "q1"), (0, 0.3, 0, "q2")]
    tables = work(read("standard", rows), FIXED, read("standard", rows)).table
    near = Change("a_value", Extent.CELL, 1, "a", ((1, "a", 1.0002e-4),))
    assert alike_at(near, (tables, tables), (tables, tables)) is None
    assert alike_at(near._replace(cells=((1, "a", 1e-4),)), (tables, tables), (tables, tables)) is not None


@pytest.mark.parametrize(("off", "sought"), [((True, False, False), "alpha"), ((False, True, False), "a")])
def test_where_angles_alone_or_lengths_alone_are_off_no_other_value_will_do(
    off: tuple[bool, bool, bool], sought: str
) -> None:
    """Not even zero, which is tried where nothing is known of a cell."""
    wrong = work(read("standard", with_cells(ARM, (2, 1, 0.3), (1, 0, 0.7))))
    (found,) = _fits([replace(wrong, scope=EditScope(off=off))])
    other = "a" if sought == "alpha" else "alpha"
    assert any(found[row, sought] for row in range(4))
    assert [found.get((row, other)) for row in range(4)] == [[]] * 4


@pytest.mark.parametrize(
    ("of", "places"),
    [
        ({"only": TableSlip(0, None, "rows_swapped")}, set()),
        ({"only": TableSlip(0, "a")}, {(0, "a")}),
        ({"scope": EditScope(lacking=frozenset({"a", "alpha"}))}, set()),
        ({"scope": EditScope(lacking=frozenset({"a"}))}, {(row, "a") for row in range(4)}),
    ],
    ids=("two rows exchanged", "a cell", "an angle and a length missing", "a length missing"),
)
def test_values_are_sought_for_the_cells_that_a_slip_may_be_in(
    of: dict[str, object], places: set[tuple[int, str]]
) -> None:
    """Not for what one cell cannot mend: a slip of another kind, or entries missing from two columns."""
    on = replace(work(read("standard", with_cells(ARM, (2, 1, 0.3)))), **of)  # type: ignore[arg-type]
    assert set(_fits([on])[0]) == places
