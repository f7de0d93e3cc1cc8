"""What the search for repairs finds, and what it costs: the same on every machine."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import replace

import pytest

from exercises.grading import BaseRule, DirectionRule, Policy, ToolRule, ZeroRule
from exercises.grading.edits.repairs import MOST_WORK, find_repairs
from exercises.grading.explanation import work_on
from exercises.grading.judging.comparison import comparisons
from exercises.grading.judging.judgement import with_a_telling_draw_first
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
    "one cell of names": (of(PUMA), of(with_cells(PUMA, (4, 2, 0))), USUAL, ["d_missing 4"], 1389),
    "two cells of names": (
        of(PUMA),
        of(with_cells(PUMA, (4, 2, "a2"), (2, 1, "a3"))),
        USUAL,
        ["cell_parameter 2 + cell_parameter 4"],
        2401,
    ),
    "a row of names missing": (of(PUMA), of([*PUMA[:2], *PUMA[3:]]), FREE, ["row_missing 3"], 10350),
    "the other convention and a cell": (of(PUMA), of(CRAIG, "modified"), USUAL, ["a_missing 3"], 1389),
    "two cells of numbers": (
        of(NUMBERS),
        of(with_cells(NUMBERS, (2, 1, 0.5), (4, 2, 0.2))),
        USUAL,
        ["a_value 2 + d_value 4"],
        2365,
    ),
    "a row missing and a cell": (
        of(NUMBERS),
        of([*with_cells(NUMBERS, (2, 1, 0.5))[:3], *NUMBERS[4:]]),
        FREE,
        ["a_value 2 + row_missing 4"],
        7395,
    ),
    "a row too many": (
        of(NUMBERS),
        of([*NUMBERS[:3], ("pi/3", 0.2, 0.1, "q9"), *NUMBERS[3:]]),
        FREE,
        ["row_extra 4"],
        2216,
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
        28486,
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
        4450,
    ),
    "a fixed row missing for a frame": (of(ARM), of(ARM[:3]), FIXED, ["fixed_row_missing 4"], 3767),
    "a fixed row missing for a point": (
        of(ARM),
        of(ARM[:3]),
        Policy(tool=ToolRule.POINT),
        ["a_value 2", "a_missing 3", "fixed_row_missing 4"],
        3272,
    ),
    "an offset at the base": (of(ARM), of(with_cells(ARM, (1, 2, 0.3))), FIXED, ["d_not_zero 1"], 2148),
    "a variable that counts backwards": (
        of(ARM),
        of(with_cells(ARM, (2, 3, "-q2"))),
        FIXED,
        ["variable_sign 2"],
        1003,
    ),
    "another zero and a length": (
        of(ARM),
        of(with_cells(ARM, (2, 3, "q2 + pi/2"), (1, 1, 0.3))),
        FIXED,
        ["a_value 1 + theta_offset 2"],
        42729,
    ),
    "a variable forgotten": (
        of(ARM),
        of(with_cells(ARM, (2, 3, 0.3))),
        FREE,
        ["joint_fixed 2", "row_missing 2"],
        3059,
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
        13350,
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
        22942,
    ),
    "two columns exchanged and a row missing": (
        of(SKEW),
        of([(alpha, d, a, q) for alpha, a, d, q in [*SKEW[:3], *SKEW[4:]]]),
        FREE,
        ["columns_exchanged + row_missing 4"],
        11663,
    ),
    "two rows exchanged and a cell": (
        of(SKEW),
        of(with_cells([SKEW[0], SKEW[2], SKEW[1], *SKEW[3:]], (5, 1, 0.2))),
        FREE,
        ["rows_swapped 2 + a_value 5"],
        2404,
    ),
    "a tool and a cell": (
        of(SKEW),
        of(with_cells(SKEW, (6, 1, 0.3), (2, 1, 0.5))),
        FIXED,
        ["a_value 2 + a_value 6", "a_value 2 + fixed_row_missing 7"],
        9748,
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
