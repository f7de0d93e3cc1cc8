"""What the search for repairs finds, and what it costs: the same on every machine."""

import math
import re
from collections.abc import Mapping
from dataclasses import replace

import pytest

from exercises.grading import (
    BaseRule,
    DirectionRule,
    Finding,
    Policy,
    ToolRule,
    ZeroRule,
    explanation,
    grade,
)
from exercises.grading.edits import repairs
from exercises.grading.edits.repaired import Repaired
from exercises.grading.edits.repairs import MOST_WORK, find_repairs
from exercises.grading.edits.work import Work
from exercises.grading.explanation import work_on
from exercises.grading.facts import Weights
from exercises.grading.judging.comparison import comparisons
from exercises.grading.judging.judgement import REFUTED, with_a_telling_draw_first
from exercises.grading.score import lost
from kinematics.cells import ReadTable
from kinematics.equivalence.meter import Meter
from tests.exercises.grading.test_grade import PUMA, SCARA, VALUES, with_cells
from tests.exercises.grading.test_scores import STANFORD
from tests.exercises.grading.written import Cell, read

Rows = list[tuple[Cell, Cell, Cell, Cell]]

USUAL, FREE = Policy(), Policy(tool=ToolRule.FREE)
FIXED = Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME, zero=ZeroRule.FIGURE, direction=DirectionRule.FIGURE)


def of(rows: Rows, convention: str = "standard") -> ReadTable:
    """A table whose variables are numbered anew, as whoever leaves a row out numbers them."""
    joints = 0
    numbered = []
    for row in rows:
        cells = list(row)
        for place, cell in enumerate(row):
            if re.search(r"q\d", str(cell)):
                joints += 1
                cells[place] = re.sub(r"q\d", f"q{joints}", str(cell))
        numbered.append(tuple(cells))
    return read(convention, numbered)  # type: ignore[arg-type]


def valued(rows: Rows, values: Mapping[str, float]) -> Rows:
    """The rows with numbers in place of names."""
    return [tuple(values.get(str(cell), cell) for cell in row) for row in rows]  # type: ignore[misc]


ARM: Rows = [("pi/2", 0.1, 0, "q1"), (0, 0.4, 0.2, "q2"), ("pi/6", 0, "q3", 0.3), (0, 0.05, 0.2, 0)]
SLIDERS: Rows = [
    ("pi/3", 0.1, 0.2, "q1"), (0.4, 0.2, "q2", 0.5), (0.9, 0.3, "q3", 0.2), ("-pi/4", 0.1, 0.1, "q4")
]  # fmt: skip
NAMED: Rows = [
    ("pi/3", "a1", "b1", "q1"), (0.4, "a2", "q2", "beta"), (0.9, "a3", "q3", "gamma"),
    ("-pi/4", "a4", "d4", "q4"),
]  # fmt: skip
SKEW: Rows = [
    (math.radians(twist), a, d, f"q{joint}")
    for joint, (twist, a, d) in enumerate(
        [
            (60, 0.1, 0.4),
            (30, 0.4, 0.1),
            (-45, 0.05, 0.2),
            (60, 0.02, 0.35),
            (-60, 0.03, 0.1),
            (0, 0.01, 0.08),
        ],
        1,
    )
]
NUMBERS = valued(PUMA, {**VALUES, "d4": 0.35})
ROUND = valued(SCARA, {"a2": 0.4, "a3": 0.3})
CRAIG: Rows = [
    *((0, 0, 0, "q1"), ("pi/2", 0, 0, "q2"), (0, 0, "d3", "q3"), ("-pi/2", "a3", "d4", "q4")),
    *(("pi/2", 0, 0, "q5"), ("-pi/2", 0, 0, "q6")),
]
WITH_SLIDER: Rows = valued(STANFORD, {"d2": 0.15})

# key, answer, policy; the repairs, likeliest first; the units of work that were spent
CASES: dict[str, tuple[ReadTable, ReadTable, Policy, list[str], int]] = {
    "one cell of names": (of(PUMA), of(with_cells(PUMA, (4, 2, 0))), USUAL, ["d_missing 4"], 1235),
    "two cells of names": (
        of(PUMA),
        of(with_cells(PUMA, (4, 2, "a2"), (2, 1, "a3"))),
        USUAL,
        ["cell_parameter 2 + cell_parameter 4"],
        2278,
    ),
    "a row of names missing": (of(PUMA), of([*PUMA[:2], *PUMA[3:]]), FREE, ["row_missing 3"], 10071),
    "the other convention and a cell": (of(PUMA), of(CRAIG, "modified"), USUAL, ["a_missing 3"], 1245),
    "two cells of numbers": (
        of(NUMBERS),
        of(with_cells(NUMBERS, (2, 1, 0.5), (4, 2, 0.2))),
        USUAL,
        ["a_value 2 + d_value 4"],
        1837,
    ),
    "a row missing and a cell": (
        of(NUMBERS),
        of([*with_cells(NUMBERS, (2, 1, 0.5))[:3], *NUMBERS[4:]]),
        FREE,
        ["a_value 2 + row_missing 4"],
        5904,
    ),
    "a row of the wrist missing": (
        of(NUMBERS),
        of([*NUMBERS[:5], *NUMBERS[6:]]),
        FREE,
        ["row_missing 5", "row_missing 6"],
        841,  # no cells of a row are solved for where one without lengths does
    ),
    "a row too many": (
        of(NUMBERS),
        of([*NUMBERS[:3], ("pi/3", 0.2, 0.1, "q9"), *NUMBERS[3:]]),
        FREE,
        ["row_extra 4"],
        1688,
    ),
    "two rows missing": (of(NUMBERS), of([*NUMBERS[:2], *NUMBERS[4:]]), FREE, [], 0),
    "three rows missing": (of(NUMBERS), of(NUMBERS[:3]), FREE, [], 0),
    "another type of joint": (
        of(ROUND, "modified"),
        of([*ROUND[:2], (0, 0.3, 0, "q3"), ROUND[3]], "modified"),
        USUAL,
        ["joint_type 3"],
        1224,
    ),
    "an offset that may stand in any row": (
        of(ROUND, "modified"),
        of(with_cells(ROUND, (4, 2, 0.19), (2, 1, 0.5)), "modified"),
        FIXED,
        [
            "d_missing 1 + a_value 2",
            "a_value 2 + d_missing 2",
            "a_value 2 + d_offset 3",
            "a_value 2 + d_not_zero 4",
            "a_value 2 + fixed_row_missing 5",
        ],
        28498,
    ),
    "a twist before a slider": (
        of(WITH_SLIDER),
        of(with_cells(WITH_SLIDER, (2, 0, 0.7))),
        USUAL,
        ["alpha_value 2"],
        1378,
    ),
    "a twist between sliders": (
        of(SLIDERS),
        of(with_cells(SLIDERS, (2, 0, 1.0))),
        FREE,
        ["alpha_value 2"],
        1242,
    ),
    "an angle about a slider": (
        of(SLIDERS),
        of(with_cells(SLIDERS, (3, 3, 1.0))),
        FREE,
        ["theta_value 3"],
        1439,
    ),
    "a row missing beside a slider": (
        of(SLIDERS),
        of([SLIDERS[0], *SLIDERS[2:]]),
        FREE,
        ["row_missing 2"],
        4596,
    ),
    "a fixed row missing for a frame": (of(ARM), of(ARM[:3]), FIXED, ["fixed_row_missing 4"], 1769),
    "a fixed row missing for a point": (
        of(ARM),
        of(ARM[:3]),
        Policy(tool=ToolRule.POINT),
        ["a_value 2", "a_missing 3", "fixed_row_missing 4"],
        3272,
    ),
    "an offset at the base": (of(ARM), of(with_cells(ARM, (1, 2, 0.3))), FIXED, ["d_not_zero 1"], 2162),
    "a variable that counts backwards": (
        of(ARM),
        of(with_cells(ARM, (2, 3, "-q2"))),
        FIXED,
        ["variable_sign 2"],
        1011,
    ),
    "another zero and a length": (
        of(ARM),
        of(with_cells(ARM, (2, 3, "q2 + pi/2"), (1, 1, 0.3))),
        FIXED,
        ["a_value 1 + theta_offset 2"],
        42751,
    ),
    "a variable forgotten": (
        of(ARM),
        of(with_cells(ARM, (2, 3, 0.3))),
        FREE,
        ["joint_fixed 2", "row_missing 2"],
        2106,
    ),
    "a slider turned by a name": (
        of(NAMED),
        of(with_cells(NAMED, (3, 3, "gamma + 0.4"))),
        FREE,
        ["theta_value 3"],
        1536,
    ),
    "a named row missing beside a slider": (
        of(NAMED),
        of([NAMED[0], *NAMED[2:]]),
        FREE,
        ["row_missing 2"],
        13788,
    ),
    "the first named row missing": (of(NAMED), of(NAMED[1:]), FREE, ["row_missing 1"], 7887),
    "an angle in degrees and a row missing": (
        of(SKEW),
        of([(60, *SKEW[0][1:]), *SKEW[1:3], *SKEW[4:]]),
        FREE,
        [
            "cell_in_degrees 1 + row_missing 4",
            "alpha_value 1 + row_missing 4",
            "angles_in_degrees + row_missing 4",
        ],
        21_084,
    ),
    "two columns exchanged and a row missing": (
        of(SKEW),
        of([(alpha, d, a, q) for alpha, a, d, q in [*SKEW[:3], *SKEW[4:]]]),
        FREE,
        ["columns_exchanged + row_missing 4"],
        11_072,
    ),
    "two rows exchanged and a cell": (
        of(SKEW),
        of(with_cells([SKEW[0], SKEW[2], SKEW[1], *SKEW[3:]], (5, 1, 0.2))),
        FREE,
        ["rows_swapped 2 + a_value 5"],
        1866,
    ),
    "a tool and a cell": (
        of(SKEW),
        of(with_cells(SKEW, (6, 1, 0.3), (2, 1, 0.5))),
        FIXED,
        ["a_value 2 + a_value 6", "a_value 2 + fixed_row_missing 7"],
        9771,
    ),
    "three cells": (of(SKEW), of(with_cells(SKEW, (2, 1, 0.5), (3, 2, 0.3), (4, 0, 0.1))), FREE, [], 957),
}


@pytest.mark.parametrize(("key", "answer", "policy", "repairs", "spent"), CASES.values(), ids=CASES.keys())
def test_repairs_and_their_price(
    key: ReadTable, answer: ReadTable, policy: Policy, repairs: list[str], spent: int
) -> None:
    way = with_a_telling_draw_first(comparisons(key, answer, {})[0], policy)
    work = replace(work_on(way, (key, answer), policy), meter=Meter(MOST_WORK))
    found = [
        " + ".join(
            f"{change.code} {'' if change.row is None else change.row + 1}".strip() for change in one.changes
        )
        for one in find_repairs(work)
    ]
    assert (found, MOST_WORK - work.meter.left) == (repairs, spent)


# the score; of each row which facts are wrong or missing; what is told, and of which row
VERDICTS: dict[str, tuple[float, str, list[str]]] = {
    "one cell of names": (0.89, ".... .... .... ..x. .... ....", ["not_equivalent", "offset_wrong 4"]),
    "two cells of names": (
        0.78,
        ".... x... .... ..x. .... ....",
        ["not_equivalent", "length_wrong 2", "offset_wrong 4"],
    ),
    "a row of names missing": (
        0.78,
        ".... .... .... .... .... ++++",
        ["not_equivalent", "joint_count_wrong", "row_missing 3"],
    ),
    "the other convention and a cell": (
        0.89,
        ".... .... x... .... .... ....",
        ["not_equivalent", "length_wrong 3"],
    ),
    "two cells of numbers": (
        0.78,
        ".... x... .... ..x. .... ....",
        ["not_equivalent", "length_wrong 2", "offset_wrong 4"],
    ),
    "a row of the wrist missing": (
        0.78,
        ".... .... .... .... .... ++++ ++++",
        ["not_equivalent", "joint_count_wrong", "one_of_these", "row_missing 5", "row_missing 6"],
    ),
    "a row missing and a cell": (
        0.67,
        ".... x... .... .... .... ++++",
        ["not_equivalent", "joint_count_wrong", "length_wrong 2", "row_missing 4"],
    ),
    "a row too many": (
        0.79,
        ".... .... .... xxxx .... .... ....",
        ["not_equivalent", "joint_count_wrong", "row_not_needed 4"],
    ),
    "two rows missing": (0.18, "???? ???? ???? ????", ["not_equivalent", "joint_count_wrong"]),
    "three rows missing": (0.02, "???? ???? ????", ["not_equivalent", "joint_count_wrong"]),
    "another type of joint": (0.5, ".... .... ...x ....", ["not_equivalent", "joint_type_wrong 3"]),
    "an offset that may stand in any row": (
        0.25,
        ".... x... .... ..x.",
        ["not_equivalent", "length_wrong 2", "offset_wrong 4"],
    ),
    "a twist before a slider": (0.83, ".... .x.. .... .... .... ....", ["not_equivalent", "twist_wrong 2"]),
    "a twist between sliders": (0.8, ".... .x.. .... ....", ["not_equivalent", "twist_wrong 2"]),
    "an angle about a slider": (0.8, ".... .... ..x. ....", ["not_equivalent", "angle_wrong 3"]),
    "a row missing beside a slider": (
        0.6,
        ".... .... .... ++++",
        ["not_equivalent", "joint_count_wrong", "row_missing 2"],
    ),
    "a fixed row missing for a frame": (
        0.86,
        ".... .... .... ++++",
        ["right_robot", "tool_frame_missed", "row_missing 4"],
    ),
    "a fixed row missing for a point": (
        0.67,
        ".... x... x...",
        ["right_robot", "tool_point_missed", "one_of_these", "length_wrong 2", "length_wrong 3"],
    ),
    "an offset at the base": (
        0.86,
        "..x. .... .... ....",
        ["right_robot", "base_frame_missed", "offset_wrong 1"],
    ),
    "a variable that counts backwards": (
        0.93,
        ".... ...x .... ....",
        ["right_robot", "direction_missed", "variable_direction_wrong 2"],
    ),
    "another zero and a length": (
        0.57,
        "x... ...x .... ....",
        ["not_equivalent", "length_wrong 1", "variable_zero_wrong 2"],
    ),
    "a variable forgotten": (
        0.5,
        ".... ...x .... ....",
        ["not_equivalent", "joint_count_wrong", "joint_type_wrong 2", "repairs_one_row 2"],
    ),
    "a slider turned by a name": (0.8, ".... .... ..x. ....", ["not_equivalent", "angle_wrong 3"]),
    "a named row missing beside a slider": (
        0.6,
        ".... .... .... ++++",
        ["not_equivalent", "joint_count_wrong", "row_missing 2"],
    ),
    "the first named row missing": (
        0.6,
        ".... .... .... ++++",
        ["not_equivalent", "joint_count_wrong", "row_missing 1"],
    ),
    "an angle in degrees and a row missing": (
        0.79,
        ".x.. .... .... .... .... ++++",
        ["not_equivalent", "joint_count_wrong", "twist_wrong 1", "row_missing 4"],
    ),
    "two columns exchanged and a row missing": (
        0.64,
        "x.x. x.x. x.x. .... x.x. ++++",
        ["not_equivalent", "joint_count_wrong", "columns_in_disorder", "row_missing 4"],
    ),
    "two rows exchanged and a cell": (
        0.79,
        ".... xxxx xxxx .... x... ....",
        ["not_equivalent", "rows_out_of_order 2", "length_wrong 5"],
    ),
    "a tool and a cell": (
        0.79,
        ".... x... .... .... .... x...",
        ["not_equivalent", "length_wrong 2", "length_wrong 6"],
    ),
    "three cells": (
        0.79,
        ".... x... ..x. .x.. .... ....",
        [
            "not_equivalent",
            "length_wrong 2",
            "offset_wrong 3",
            "twist_wrong 4",
        ],
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_what_is_told_and_lost(name: str) -> None:
    """A fact of a row: length, twist, offset, joint; `.` right, `x` wrong, `?` not judged, `+` missing."""
    key, answer, policy, _, _ = CASES[name]
    verdict = grade(key, answer, policy)
    marks = {Finding.OK: ".", Finding.WRONG: "x", Finding.UNKNOWN: "?", Finding.MISSING: "+"}
    rows = " ".join(
        "".join(marks[fact] for fact in (link.length, link.twist, link.offset, link.joint))
        for link in verdict.links
    )
    told = [f"{entry.code} {entry.row or ''}".strip() for entry in verdict.feedback]
    assert (verdict.score, rows, told) == VERDICTS[name]


@pytest.mark.parametrize(
    ("key", "cells", "facts"),
    [
        (SLIDERS, [(3, 3, 1.0)], 1.0),
        (
            SLIDERS,
            [(2, 0, 1.0), (3, 3, 1.0)],
            2.0,
        ),  # beside another twist, too
        (SLIDERS, [(2, 2, 0.5), (2, 3, "q2")], 2.0),  # a type: two fifths of the five facts
        (SLIDERS, [], 0.0),
    ],
)
def test_facts_that_are_wrong_are_counted(
    key: Rows, cells: list[tuple[int, int, Cell]], facts: float
) -> None:
    tables = of(key), of(with_cells(key, *cells))
    work = work_on(comparisons(*tables, {})[0], tables, FREE)
    assert lost(REFUTED, work, Weights()) == facts


@pytest.mark.parametrize("cells", [[(4, 2, "d3")], [(4, 2, "d3"), (3, 0, 0)]], ids=["one", "two"])
def test_what_mends_the_nearest_reading_is_searched_for_once(
    cells: list[tuple[int, int, Cell]], monkeypatch: pytest.MonkeyPatch
) -> None:
    searched: list[bool] = []

    def counted(work: Work, *, pairs: bool = True) -> tuple[Repaired, ...]:
        searched.append(pairs)
        return find_repairs(work, pairs=pairs)

    monkeypatch.setattr(explanation, "find_repairs", counted)
    answer = of(with_cells(PUMA, (1, 2, 0.12345), *cells))
    assert len(comparisons(of(PUMA), answer, VALUES)) == 2
    verdict = grade(of(PUMA), answer, USUAL, VALUES)
    assert len(verdict.repairs[0].edits) == len(cells)
    # of the other reading only that no single edit mends it is asked
    assert searched == [True, False][: len(cells)]


def test_an_offset_that_makes_up_for_another_is_a_difference_of_names_at_every_draw(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def fails(*_: object) -> bool:
        raise AssertionError("it is known what the value is at the other draws")

    monkeypatch.setattr(repairs, "_mends", fails)
    # joints 2 and 3 are parallel: where d3 is missing, any offset along both of them does
    answer = of(with_cells(PUMA, (3, 2, "d4"), (4, 2, "d4")))
    found = grade(of(PUMA), answer, USUAL).repairs
    assert [(edit.code, edit.row) for one in found for edit in one.edits] == [
        ("cell_parameter", 3),
        ("d_missing", 2),
    ]
