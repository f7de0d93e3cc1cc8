"""Several equally small repairs are told by what they share."""

import pytest

from exercises.grading import Edit, HelpLevel, Repair
from exercises.grading.edits.accused import _is_of_the_key, own_table_first
from exercises.grading.edits.changes import Change, Extent
from exercises.grading.edits.in_common import in_common
from exercises.grading.edits.own_table import is_own_table
from exercises.grading.edits.repaired import Repaired
from tests.exercises.answering import judged, table
from tests.kinematics.equivalence.tables import R, changed, standard


def repair(*edits: tuple[str, int | None, str | None]) -> Repair:
    return Repair(edits=tuple(Edit(code=code, row=row, cell=cell) for code, row, cell in edits))


@pytest.mark.parametrize(
    ("repairs", "code", "row"),
    [
        ([], None, None),
        ([repair(("a_sign", 1, "a"))], None, None),
        ([repair(("a_sign", 1, "a")), repair(("a_value", 1, "a"))], "repairs_one_cell", 1),
        ([repair(("a_sign", 2, "a")), repair(("d_sign", 2, "d"))], "repairs_one_row", 2),
        ([repair(("a_sign", 1, "a")), repair(("a_sign", 2, "a"))], "repairs_one_column", None),
        ([repair(("row_missing", 1, None)), repair(("row_missing", 2, None))], "repairs_one_kind", None),
        ([repair(("a_sign", 1, "a")), repair(("d_value", 2, "d"))], None, None),
        ([repair(("a_sign", 1, "a")), repair(("a_sign", 1, "a"), ("d_sign", 2, "d"))], None, None),
    ],
)
def test_what_repairs_share(repairs: list[Repair], code: str | None, row: int | None) -> None:
    found = in_common(repairs)
    assert (found and found.code, found and found.row) == (code, row)


def test_of_repairs_as_small_the_one_to_the_own_table_of_the_key_comes_first() -> None:
    key = standard((R, 0.5, 0.4, 0.2, 0.0), (R, 0.3, 0.3, 0.1, 0.0))
    answer = changed(key, 1, a=0.5)
    length = Change(code="any", extent=Extent.CELL, row=0, cell="a", cells=((0, "a", 0.4),))
    other = length._replace(cells=((0, "a", 0.45),))
    elsewhere, two, own = Repaired((other,)), Repaired((other, length)), Repaired((length,))
    assert own_table_first((elsewhere, two, own), answer, key) == (own, elsewhere, two)
    assert own_table_first((elsewhere, two), answer, key) == (elsewhere, two)


@pytest.mark.parametrize(
    ("extent", "is_told"), [(Extent.CELL, False), (Extent.ROW, True), (Extent.TABLE, True)]
)
def test_columns_exchanged_in_one_row_are_no_other_story_beside_a_cell(extent: Extent, is_told: bool) -> None:
    """Beside a row they are: what is wrong is more than a cell."""
    key = standard((R, 0.5, 0.4, 0.2, 0.0), (R, 0.3, 0.3, 0.1, 0.0))
    answer = changed(key, 1, a=0.5)
    first = Change(code="any", extent=extent, row=0, cells=((0, "a", 0.45),))
    columns = first._replace(extent=Extent.TABLE, row=None, cells=((0, "a", 0.2), (0, "d", 0.5)))
    repairs = Repaired((first,)), Repaired((columns,))
    assert own_table_first(repairs, answer, key) == (repairs if is_told else repairs[:1])


def test_with_the_axes_the_other_way_it_is_no_own_table_unless_either_way_will_do() -> None:
    key = standard((R, 0.5, 0.4, 0.2, 0.0), (R, 0.3, 0.3, 0.1, 0.0))
    other = standard((R, -0.5, 0.4, 0.2, 0.0), (R, -0.3, 0.3, -0.1, 0.0))
    assert is_own_table(key, key)
    assert not is_own_table(other, key)
    assert is_own_table(other, key, either_way=True)


def test_a_verdict_with_several_repairs_tells_it_at_the_highest_help_alone() -> None:
    wrong = table("standard", (90, "a2", 0, "q1"), (180, "a3", 0, "q2"), (0, 0, "q3", 0), (90, 0, 0, "q4"))
    for level in HelpLevel:
        verdict = judged("scara", table=wrong, help_level=level).verdict
        assert verdict is not None
        shared = [entry.code for entry in verdict.feedback if entry.code.startswith("repairs_one")]
        expected = in_common(verdict.repairs)
        assert shared == ([expected.code] if expected else [])


def test_several_repairs_are_announced_once() -> None:
    """Without its first row or its second one the PUMA's table is the same: either may be the missing one."""
    wrist = [(-90, "a3", "d4", "q3"), (90, 0, 0, "q4"), (-90, 0, 0, "q5")]
    rest = table("modified", (-90, 0, 0, "q1"), (0, "a2", "d3", "q2"), *wrist)
    verdict = judged("puma560", table=rest).verdict
    assert verdict is not None
    codes = [entry.code for entry in verdict.feedback]
    assert codes == ["not_equivalent", "joint_count_wrong", "one_of_these", "row_missing", "row_missing"]
    assert in_common(verdict.repairs) is not None


@pytest.mark.parametrize(
    ("length", "of_the_key"), [(0.4, True), (-0.4, True), (0.4035, True), (0.4045, False), (0.395, False)]
)
def test_a_length_is_one_of_the_key_within_a_per_cent(length: float, of_the_key: bool) -> None:
    key = standard((R, 0, 0.4, 0.1, 0), (R, 0, 30.0, 0, 0))
    for scale in 1.0, 100.0:
        scaled = changed(key, 0, a=0.4 * scale)
        change = Change("a_value", Extent.CELL, 1, "a", ((1, "a", length * scale),))
        assert _is_of_the_key(change, scaled) is of_the_key
    assert not _is_of_the_key(Change("alpha_value", Extent.CELL, 1, "alpha", ((1, "alpha", 0.4),)), key)
