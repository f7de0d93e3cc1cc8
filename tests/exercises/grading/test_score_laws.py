"""Laws of the mark: it does not depend on the frames, and it never rises for one more thing wrong."""

from dataclasses import replace
from itertools import pairwise
from random import Random

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from exercises.grading import BaseRule, DirectionRule, Policy, ToolRule, ZeroRule, grade
from exercises.grading.alignments import MOST_ALIGNMENTS, NOT_THERE, alignments
from exercises.grading.edits.changes import Change, Extent
from exercises.grading.explanation import work_on
from exercises.grading.facts import Weights
from exercises.grading.judging.comparison import comparisons
from exercises.grading.standard import at_least_lost, shared_across_prismatic, standard_of, wrong_of
from kinematics.table import NumericTable
from tests.exercises.grading.campaign import redrawn, spoiled_tables
from tests.exercises.grading.written import Cell, read, written
from tests.kinematics.equivalence import tables
from tests.kinematics.equivalence.campaign import references
from tests.kinematics.equivalence.tables import HALF, P, R

FREE = Policy(tool=ToolRule.FREE)
SEEDS = st.integers(0, 10**6)


def score(key: NumericTable, answer: NumericTable, policy: Policy = FREE) -> float:
    return grade(written(key), written(answer), policy).score


@settings(max_examples=20)
@given(SEEDS)
def test_a_wrong_type_beside_wrong_cells_costs_the_same_in_all_frames(seed: int) -> None:
    """The joint is read as one of the key's type, on the line on which it was drawn."""
    rng = Random(seed)
    _, key = rng.choice(references())
    *_, wrong = spoiled_tables(key, rng, cells=rng.choice((1, 2, 3)), types=True)
    assume(wrong.joint_types != key.joint_types)
    drawn = redrawn(wrong, key, rng)
    assume(drawn is not None)
    assert drawn
    assert abs(score(key, drawn) - score(key, wrong)) < 0.011


@given(SEEDS)
def test_a_wrong_type_and_cells_one_after_the_other_never_raise_the_mark(seed: int) -> None:
    rng = Random(seed)
    _, key = rng.choice(references())
    scores = [score(key, wrong) for wrong in spoiled_tables(key, rng, cells=4, types=True)]
    assert scores == sorted(scores, reverse=True)


def test_a_wrong_type_hides_no_length_beside_it() -> None:
    """A slider has no place, but it was drawn where the joint is."""
    for row in (2, 3):
        turned = tables.changed(tables.PUMA, row, joint=P)
        alone = score(tables.PUMA, turned)
        for cell in ((row, "a"), (row - 1, "a"), (row, "alpha")):
            wrong = tables.changed(turned, cell[0], **{cell[1]: 0.7})
            assert score(tables.PUMA, wrong) < alone


LADDER = tables.modified(
    (R, 2 * HALF, 0, 0, HALF / 2),
    (R, HALF / 3, 0.444, 0.153, 0),
    (P, -HALF / 2, 0.572, -0.82, HALF),
    (R, 0, 0.7, 0.894, 0),
    (R, HALF / 6, 0, 0, HALF),
    (R, 0, 0, 0.37, 2 * HALF),
)
STRICT = Policy(tool=ToolRule.FREE, zero=ZeroRule.FIGURE, direction=DirectionRule.FIGURE)


@pytest.mark.parametrize("policy", [FREE, STRICT], ids=["free", "strict"])
def test_a_third_row_missing_brings_no_link_back(policy: Policy) -> None:
    """The link of row 5 stands there whether row 4 does or not."""
    wrong = tables.changed(tables.changed(LADDER, 1, d=0.5, alpha=1.0), 6, d=-0.9)
    rows, scores = list(wrong.rows), []
    for missing in (3, 1, 1):
        del rows[missing]
        scores.append(score(LADDER, replace(wrong, rows=tuple(rows)), policy))
    assert scores == sorted(scores, reverse=True)


@given(SEEDS)
def test_rows_missing_one_after_the_other_never_raise_the_mark(seed: int) -> None:
    rng = Random(seed)
    _, key = rng.choice(references())
    rows, scores = list(key.rows), [1.0]
    for _ in range(min(3, len(rows) - 1)):
        del rows[rng.randrange(len(rows))]
        answer = replace(key, rows=tuple(rows))
        if answer.n_joints and not (verdict := grade(written(key), written(answer), FREE)).correct:
            scores.append(verdict.score)
    assert scores == sorted(scores, reverse=True)


def test_the_other_convention_hides_no_entry_that_the_key_does_not_have() -> None:
    """Read as modified, the first row of a standard wrist lies before its first joint, where all is free."""
    key = tables.modified((R, HALF, 0, 0, 0), (R, -HALF, 0, 0, 2 * HALF), (R, HALF, 0, 0, HALF))
    own = tables.modified(
        (R, HALF, 0, 0, 0), (R, -1.1552, 0.2143, 0.384, 2 * HALF), (R, HALF, 0, -0.2244, HALF)
    )
    standard = tables.standard(
        (R, -1.9864, -0.2143, 1.5436, 0), (R, -HALF, 0, 0.384, 0), (R, 0, 0, 0.4681, 0)
    )
    assert score(key, own) == score(key, standard)


def test_a_sign_that_makes_an_offset_another_costs_the_same_in_all_frames() -> None:
    """Axes 2 to 4 are parallel: what one drawing has as a sign in three rows, another has in one row."""
    arm = [(R, 0, 0.4, 0.3, 0), (R, 0, 0.3, -0.1, 0), (R, HALF, 0.2, 0.2, 0)]
    key = tables.standard((R, HALF, 0.2, 0.1, 0), *arm, (R, 0, 0.1, 0.2, 0))
    sign, one_row = tables.changed(key, 3, d=0.1), key
    for row, d in ((2, 0.6), (3, 0.0), (4, 0.0)):
        one_row = tables.changed(one_row, row, d=d)
    assert score(key, sign) == score(key, one_row)


TYPES = st.lists(st.booleans(), min_size=3, max_size=8).map(lambda joints: (False, *joints, False))


@given(TYPES, TYPES)
def test_alignments_keep_both_ends_and_the_order(ours: tuple[bool, ...], theirs: tuple[bool, ...]) -> None:
    """As many links are matched as the shorter of the two has, each with one link of the other."""
    ways = alignments(ours, theirs)
    links, other = len(ours) - 1, len(theirs) - 1
    assert 0 < len(ways.shifts) <= MOST_ALIGNMENTS
    for shifts, others in zip(ways.shifts.tolist(), ways.others, strict=True):
        matched = [(i, i - shift) for i, shift in enumerate(shifts) if shift != NOT_THERE]
        assert len(matched) == min(links, other)
        assert (matched[0], matched[-1]) == ((0, 0), (links - 1, other - 1))
        assert all(i < k and j < m for (i, j), (k, m) in pairwise(matched))
        for (i, j), (k, m) in pairwise(matched):
            alike = set(ours[i + 1 : k + 1]) & set(theirs[j + 1 : m + 1])
            assert (i + 1 in others) == (not alike)


def test_an_offset_that_another_type_hides_is_neither_right_nor_wrong() -> None:
    """Where the variable stands now, the key has a constant; the rest is worth as much as all was."""
    slides = read("standard", [("pi/2", 0, 0.4, "q1"), (0, 0.5, 0.3, "q2"), ("pi/2", 0.2, 0.1, "q3")])
    for offset in ("q2", "q2 + 0.7"):
        answer = read("standard", [("pi/2", 0, 0.4, "q1"), (0, 0.5, offset, 0), ("pi/2", 0.2, 0.1, "q3")])
        assert grade(slides, answer, FREE).score == 0.5


ARM: list[tuple[Cell, Cell, Cell, Cell]] = [
    (90, 0, 0.4, "q1"),
    (0, 0.5, 0.12, "q2"),
    (90, 0.3, -0.05, "q3"),
]
"""A shoulder, an upper arm and a forearm, each with an offset."""
LINE = {(2, 0): 30}
LENGTH, OFFSET, SIGN, TWIST = {(1, 1): 0.4}, {(1, 2): 0.2}, {(1, 1): -0.5}, {(0, 0): 60}


def _marked(*mistakes: dict[tuple[int, int], Cell], policy: Policy, third: Cell = "q3") -> float:
    rows = [list(row) for row in ARM]
    for mistake in mistakes:
        for (row, column), cell in mistake.items():
            rows[row][column] = cell
    rows[2][3] = third
    answer = [(row[0], row[1], row[2], row[3]) for row in rows]
    return grade(read("standard", ARM, "deg"), read("standard", answer, "deg"), policy).score


@pytest.mark.parametrize("third", ["q3", "q3 + 180"])
@pytest.mark.parametrize("base", [BaseRule.FREE, BaseRule.FRAME])
@pytest.mark.parametrize("mistake", [LENGTH, TWIST])
def test_a_line_at_an_end_costs_beside_another_mistake(
    mistake: dict[tuple[int, int], Cell], base: BaseRule, third: Cell
) -> None:
    """It cost something in the right robot only, so that two mistakes were one."""
    axis = Policy(base=base, tool=ToolRule.AXIS)
    alone, line = (_marked(one, policy=axis, third=third) for one in (mistake, LINE))
    both = _marked(mistake, LINE, policy=axis, third=third)
    assert 0.0 < both < min(alone, line)
    # the mistake costs one fact of all there are, and the line as large a share of what that leaves
    assert both == pytest.approx(alone * alone, abs=0.01)
    free = Policy(base=base, tool=ToolRule.FREE)
    assert _marked(mistake, LINE, policy=free, third=third) == _marked(mistake, policy=free, third=third)


@pytest.mark.parametrize("mistakes", [(OFFSET, LENGTH, TWIST), (TWIST, OFFSET), (SIGN, OFFSET)])
def test_beside_a_wrong_line_no_mistake_raises_the_mark(
    mistakes: tuple[dict[tuple[int, int], Cell], ...],
) -> None:
    axis = Policy(tool=ToolRule.AXIS)
    marks = [_marked(LINE, *mistakes[:k], policy=axis) for k in range(len(mistakes) + 1)]
    assert marks == sorted(marks, reverse=True)


@pytest.mark.parametrize(("name", "key"), references()[::12], ids=[name for name, _ in references()[::12]])
def test_no_less_is_lost_than_is_seen_at_once_of_many_answers(name: str, key: NumericTable) -> None:
    """Among them such with a joint of another type: of these, too, it is seen that something is lost."""
    rng, policy = Random(name), Policy(tool=ToolRule.FREE)
    answers = [table for _ in range(3) for table in spoiled_tables(key, rng, cells=3, types=True)]
    works = []
    for answer in (written(table) for table in answers):
        (way,) = comparisons(written(key), answer, None)
        works.append(work_on(way, (written(key), answer), policy))
    standard = standard_of(works[0].reference, policy, Weights())
    changes = [Change("", Extent.TABLE, table=work.table) for work in works]
    least = at_least_lost(works[0], changes, standard)
    for work, at_least in zip(works, least, strict=True):
        assert at_least <= wrong_of(work, standard) - shared_across_prismatic(work, standard) + 1e-9
    others = [at_least for work, at_least in zip(works, least, strict=True) if not work.has_the_joints()]
    prismatic = any(axis.prismatic for axis in standard.facts.axes)
    assert prismatic or not standard.of_zeros or not others or max(others) > 0.0
