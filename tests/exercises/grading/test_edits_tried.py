"""Which edits each misconception leads to: in which cells, and what is put there."""

import math
from collections.abc import Iterable, Iterator
from dataclasses import replace

import pytest

from exercises.grading import BaseRule, DirectionRule, Policy, ToolRule, ZeroRule
from exercises.grading.edits import cell_edits, row_edits, table_edits
from exercises.grading.edits.cell_edits import _is_a_name
from exercises.grading.edits.changes import Change, Extent, TableSlip
from exercises.grading.edits.misconceptions import CATALOGUE
from exercises.grading.edits.scope import EditScope
from exercises.grading.edits.wanted_changes import changes_beforehand, changes_of
from exercises.grading.edits.work import Work
from exercises.grading.explanation import work_on
from exercises.grading.judging.comparison import comparisons
from kinematics.cells import ReadTable
from kinematics.equivalence.meter import PER_ROW, Meter
from kinematics.equivalence.search import Effort
from kinematics.table import JointType, NumericTable
from tests.exercises.grading.test_grade import KEY as PUMA
from tests.exercises.grading.test_grade import PUMA as PUMA_ROWS
from tests.exercises.grading.test_grade import with_cells
from tests.exercises.grading.written import Cell, read

Rows = list[tuple[Cell, Cell, Cell, Cell]]

USUAL = Policy()
FIXED = Policy(base=BaseRule.FRAME, tool=ToolRule.FRAME, zero=ZeroRule.FIGURE, direction=DirectionRule.FIGURE)
# R, R, P, and a row without a variable
ARM: Rows = [("pi/2", 0.1, 0, "q1"), (0, 0.4, 0.2, "q2"), ("pi/6", 0, "q3", 0.3), (0, 0.05, 0.2, 0)]
KEY = read("standard", ARM)
WRONG: Rows = [
    (0.5, 0.1, 0, "q1 + pi/2"),
    (0, 0.4, 200, "q2"),
    ("pi/6", 0.3, "q3 + 0.2", 30),
    (90, 0.05, 0, 0),
]
DEGREES: Rows = [(1.57, 0.1, 0, "q1 + 1.5"), (0, 0.4, 200, "q2"), (0.52, 0.3, "q3", 30), (90, 0.05, 0, 0)]
CHANGES = {entry.code: entry.changes for entry in CATALOGUE}
SIGNS = {"alpha": "α", "a": "a", "d": "d", "theta": "θ"}


def work(answer: ReadTable, policy: Policy = FIXED, key: ReadTable = KEY) -> Work:
    return work_on(comparisons(key, answer, {})[0], (key, answer), policy)


ON_WRONG = work(read("standard", WRONG))
ON_PUMA = work(PUMA, USUAL, PUMA)


def test_what_is_not_decided_with_the_work_that_is_left_is_not_right() -> None:
    mended = ON_WRONG.reference.table
    change = Change(code="any", extent=Extent.TABLE, table=mended)
    for units, right in ((10**6, True), (PER_ROW * len(mended.rows) + 1, False)):
        assert replace(ON_WRONG, meter=Meter(units)).accepts(change, Effort.PLAIN) is right


def shown(cell: str, value: float) -> str:
    """A value as in `α2 90°`, `a1 0.3`: rows counted from 1."""
    return f"{math.degrees(value):.4g}°" if cell in ("alpha", "theta") else f"{value:.4g}"


def cells(change: Change) -> str:
    return " ".join(f"{SIGNS[cell]}{row + 1} {shown(cell, value)}" for row, cell, value in change.cells)


def tried(code: str, on: Work = ON_WRONG) -> list[str]:
    return [cells(change) for change in CHANGES[code](on)]


def rows(table: NumericTable | None) -> str:
    """The rows by their types and lengths, as in `r0.1 r0.4`; R or P counts backwards."""
    assert table is not None
    letters = [row.joint.value[0] for row in table.rows]
    turned = [
        letter.upper() if row.sign < 0 else letter for letter, row in zip(letters, table.rows, strict=True)
    ]
    return " ".join(f"{letter}{row.a:g}" for letter, row in zip(turned, table.rows, strict=True))


def tables(changes: Iterable[Change]) -> list[tuple[str, str]]:
    return [(change.code, rows(change.table)) for change in changes]


IN_CELLS = {
    "alpha_sign": ["α1 -28.65°", "α3 -30°", "α4 -5157°"],
    "alpha_value": [
        *("α1 0°", "α1 90°", "α1 -90°", "α1 180°", "α1 151.4°", "α1 -151.4°"),
        *("α2 90°", "α2 -90°", "α2 180°"),
        *("α3 0°", "α3 90°", "α3 -90°", "α3 180°", "α3 150°", "α3 -150°"),
        *("α4 0°", "α4 90°", "α4 -90°", "α4 180°", "α4 -4977°", "α4 4977°"),
    ],
    "a_sign": ["a1 -0.1", "a2 -0.4", "a3 -0.3", "a4 -0.05"],
    "d_sign": ["d2 -200", "d3 -0.2"],
    "cell_in_degrees": ["θ1 1.571°", "θ3 30°", "α4 90°"],
    "cell_length_unit": ["d2 0.2", "d2 2"],
    "a_value": ["a1 0", "a2 0", "a3 0", "a4 0"],
    "d_value": ["d2 0"],
    "theta_value": [
        *("θ1 0°", "θ1 -90°", "θ1 180°", "θ1 -90°"),
        *("θ2 90°", "θ2 -90°", "θ2 180°"),
        *("θ3 0°", "θ3 90°", "θ3 -90°", "θ3 180°", "θ3 -1719°"),
        *("θ4 90°", "θ4 -90°", "θ4 180°"),
    ],
    "a_d_swapped": ["a1 0 d1 0.1", "a2 200 d2 0.4", "a4 0 d4 0.05"],
}
WHERE_ENDS_AND_ZEROS_ARE_FREE = {
    **IN_CELLS,
    "alpha_value": [
        one for one in IN_CELLS["alpha_value"] if one.split()[1] in ("0°", "90°", "-90°", "180°")
    ],
    "d_sign": ["d2 -200"],
    "cell_in_degrees": ["θ3 30°", "α4 90°"],
    "theta_value": [one for one in IN_CELLS["theta_value"] if one[1] in "34"],
}


@pytest.mark.parametrize(
    ("policy", "expected"),
    [(FIXED, IN_CELLS), (USUAL, WHERE_ENDS_AND_ZEROS_ARE_FREE)],
    ids=["fixed", "usual"],
)
def test_a_cell_is_given_what_a_student_may_have_meant(
    policy: Policy, expected: dict[str, list[str]]
) -> None:
    on = work(read("standard", WRONG), policy)
    assert {code: tried(code, on) for code in expected} == expected


@pytest.mark.parametrize(
    ("policy", "told_apart"),
    [
        (Policy(tool=ToolRule.AXIS), False),
        (Policy(tool=ToolRule.FREE, base=BaseRule.AXIS), False),
        (Policy(tool=ToolRule.FREE, base=BaseRule.ORIGIN), True),
        (Policy(tool=ToolRule.FREE, base=BaseRule.FRAME), True),
        (Policy(tool=ToolRule.POINT), True),
        (Policy(tool=ToolRule.FRAME), True),
        (Policy(direction=DirectionRule.FIGURE), True),
    ],
)
def test_the_supplement_of_a_twist_is_tried_where_the_senses_of_axes_matter(
    policy: Policy, told_apart: bool
) -> None:
    assert ("α3 150°" in tried("alpha_value", work(read("standard", WRONG), policy))) is told_apart


def test_a_twist_is_not_set_to_its_opposite_which_is_another_slip() -> None:
    on = work(read("standard", [("-pi/2", 0.1, 0, "q1"), *ARM[1:]]))
    assert tried("alpha_value", on)[:2] == ["α1 0°", "α1 180°"]
    fitting = replace(on, fits={(0, "alpha"): [math.pi / 2, 1.0]})
    assert tried("alpha_value", fitting)[:3] == ["α1 0°", "α1 180°", "α1 57.3°"]


def test_values_that_fit_are_put_into_their_cells() -> None:
    fits = {(0, "a"): [0.7, 0.8], (1, "d"): [0.2], (2, "d"): [0.3], (2, "theta"): [1.0], (3, "a"): []}
    on = replace(ON_WRONG, fits=fits)
    assert tried("a_value", on) == ["a1 0.7", "a1 0.8", "a2 0", "a3 0"]
    assert [(one.code, cells(one)) for one in CHANGES["d_value"](on)] == [
        ("cell_length_unit", "d2 0.2"),
        ("d_offset", "d3 0.3"),
    ]
    assert "θ3 57.3°" in tried("theta_value", on)


@pytest.mark.parametrize(
    ("typed", "value", "code"),
    [
        (0.4, 0.0, "a_not_zero"),
        (0.0, 0.4, "a_missing"),
        (0.4, -0.4, "a_sign"),
        (0.4, 0.004, "cell_length_unit"),
        (0.4, 40.0, "cell_length_unit"),
        (0.4, -4.0, "cell_length_unit"),
        (0.4, 0.3, "a_value"),
        (0.4, 0.4008, "a_value"),
        (0.4, -0.4008, "a_sign"),  # within a per cent, as numbers are compared
        (0.4, -0.41, "a_value"),
    ],
)
def test_what_happened_to_a_length(typed: float, value: float, code: str) -> None:
    on = work(read("standard", with_cells(ARM, (2, 1, typed))), USUAL)
    changes = CHANGES["a_value"](replace(on, fits={(1, "a"): [value]}))
    assert [change.code for change in changes if change.row == 1] == [code]


def test_one_name_for_another_is_told_as_that() -> None:
    """A name, or a multiple of one, stands where the value of another belongs."""
    for typed, code in (("a3", "cell_parameter"), ("2*a3", "cell_parameter"), ("a3 + d3", "a_value")):
        on = work(read("standard", with_cells(PUMA_ROWS, (2, 1, typed))), USUAL, PUMA)
        value = on.comparison.draws[0]["a2"]
        assert [
            change.code
            for change in CHANGES["a_value"](replace(on, fits={(1, "a"): [value]}))
            if change.row == 1
        ] == [code]


@pytest.mark.parametrize(
    ("typed", "told"),
    [
        (1300.0, ["a2 1.3", "a2 13"]),  # the robot's size is 0.6 m or so
        (0.001, ["a2 1", "a2 0.1"]),
        (0.02, []),
        (1.0, []),
    ],
)
def test_a_length_is_in_another_unit_if_it_is_out_of_all_proportion(typed: float, told: list[str]) -> None:
    on = work(read("standard", with_cells(ARM, (2, 1, typed), (3, 2, "q3 + 900"))))
    assert tried("cell_length_unit", on) == told


THROUGHOUT = {
    "angles_in_degrees": ["α1 0.5° θ1 1.571° α3 0.5236° θ3 30° α4 90°", "θ3 30° α4 90°"],
    "angles_in_radians": [],
    "length_unit": [
        "a1 0.0001 a2 0.0004 d2 0.2 a3 0.0003 d3 0.0002 a4 5e-05",
        "a1 0.001 a2 0.004 d2 2 a3 0.003 d3 0.002 a4 0.0005",
        "a1 0.01 a2 0.04 d2 20 a3 0.03 d3 0.02 a4 0.005",
    ],
    "columns_late": ["α1 0° a1 0.4 α2 30° a2 0.3 α3 5157° a3 0.05 α4 0° a4 0"],
    "columns_early": ["α1 0° a1 0 α2 28.65° a2 0.1 α3 0° a3 0.4 α4 30° a4 0.3"],
    "twists_late": ["α1 0° α2 30° α3 5157° α4 0°"],
    "twists_early": ["α1 0° α2 28.65° α3 0° α4 30°"],
    "columns_exchanged": [
        "α1 5.73° a1 0.5 α2 22.92° a2 0 α3 17.19° a3 0.5236 α4 2.865° a4 90",
        "d1 0.1 a1 0 d2 0.4 a2 200 d4 0.05 a4 0",
        "d1 0.5 α1 0° d2 0 α2 1.146e+04° d4 90 α4 0°",
    ],
    "columns_reordered": [
        "a1 0.5 d1 0.1 α1 0° a2 0 d2 0.4 α2 1.146e+04° a4 90 d4 0.05 α4 0°",
        "d1 0.5 a1 0 α1 5.73° d2 0 a2 200 α2 22.92° d4 90 a4 0 α4 2.865°",
    ],
    "twists_all_reversed": ["α1 -28.65° α3 -30° α4 -5157°"],
}
IN_DEGREES = {
    "angles_in_degrees": [],
    "angles_in_radians": ["α1 90° θ1 85.94° α3 30° θ3 1719° α4 5157°", "α1 90° θ1 85.94° α3 30°"],
    "cell_in_degrees": [],
    "cell_in_radians": ["α1 90°", "θ1 85.94°", "α3 30°"],
    # a number stays what was typed: 0.1 under α is 0.1°
    "columns_exchanged": [
        "α1 0.1° a1 1.57 α2 0.4° a2 0 α3 0.3° a3 0.52 α4 0.05° a4 90",
        "d1 0.1 a1 0 d2 0.4 a2 200 d4 0.05 a4 0",
        "d1 1.57 α1 0° d2 0 α2 200° d4 90 α4 0°",
    ],
}


@pytest.mark.parametrize(
    ("answer", "expected"),
    [(read("standard", WRONG), THROUGHOUT), (read("standard", DEGREES, "deg"), IN_DEGREES)],
    ids=["radians", "degrees"],
)
def test_a_table_is_read_in_another_way(answer: ReadTable, expected: dict[str, list[str]]) -> None:
    on = work(answer)
    assert {code: tried(code, on) for code in expected} == expected


def test_the_other_convention_is_another_reading_of_the_same_rows() -> None:
    (change,) = CHANGES["convention"](ON_WRONG)
    assert change.table is not None
    assert (change.table.convention.value, change.table.rows) == ("modified", ON_WRONG.table.rows)
    assert dict(change.params) == {"declared": "standard", "meant": "modified"}


def test_only_twists_that_tell_are_counted_among_all() -> None:
    """A single one that is not 0 or π is no left-handed table."""
    assert tried("twists_all_reversed", work(read("standard", ARM))) != []
    assert tried("twists_all_reversed", work(read("standard", with_cells(ARM, (1, 0, "pi"))))) == []


def test_an_empty_table_has_no_order_of_columns() -> None:
    on = work(read("standard", [(0, 0.4, 0, "q1"), (0, 0.3, 0, "q2")]))
    assert tried("columns_reordered", on) == []
    assert (
        len(tried("columns_reordered", work(read("standard", [(0, 0.4, 0.2, "q1"), (0, 0.3, 0, "q2")])))) == 2
    )
    assert tried("columns_exchanged", on) != []
    assert tried("length_unit", work(read("standard", [(0, 0, 0, "q1"), (0, 0, 0, "q2")]))) == []


@pytest.mark.parametrize(
    ("size", "ratios"),
    [
        (1.0, [100, 0.1, 10]),
        (1e3, [0.001, 0.01, 0.1]),
        (1e-3, [1000, 100]),
        (1e-5, []),
        (2e5, [0.001]),
        (1e6, []),
    ],
)
def test_the_lengths_of_a_table_come_to_something_like_the_robot(size: float, ratios: list[float]) -> None:
    """In the unit that they are taken for: 0.05 to 300 times its size."""
    on = work(read("standard", [(0, size, 0, "q1")]), key=read("standard", [(0, 1, 0, "q1")]))
    assert [change.cells[0][2] / size for change in CHANGES["length_unit"](on)] == pytest.approx(
        sorted(ratios, key=lambda ratio: (abs(math.log10(ratio)) != 3, abs(math.log10(ratio)) != 2, -ratio))
    )


IN_ROWS = {
    "rows_swapped": [(1, 2), (1, 3), (1, 4), (2, 3), (2, 4), (3, 4)],
    "row_extra": ["r0.1 r0.4 p0.3"],
    "variable_sign": ["R0.1 r0.4 p0.3 f0.05", "r0.1 R0.4 p0.3 f0.05", "r0.1 r0.4 P0.3 f0.05"],
}


def test_rows_change_places_or_are_too_many_or_count_the_other_way() -> None:
    swaps = [
        ((change.row or 0) + 1, dict(change.params)["other"]) for change in CHANGES["rows_swapped"](ON_WRONG)
    ]
    assert swaps == IN_ROWS["rows_swapped"]
    assert [one for _, one in tables(CHANGES["row_extra"](ON_WRONG))] == IN_ROWS["row_extra"]
    assert [one for _, one in tables(CHANGES["variable_sign"](ON_WRONG))] == IN_ROWS["variable_sign"]
    assert list(CHANGES["variable_sign"](replace(ON_WRONG, policy=USUAL))) == []
    first = next(CHANGES["rows_swapped"](ON_WRONG))
    assert cells(first) == "α2 28.65° α1 0° a2 0.1 a1 0.4 d2 0 d1 200 θ2 90° θ1 0°"


def test_in_a_long_table_only_neighbours_change_places() -> None:
    arm: Rows = [(0, 0.1 * k, 0, f"q{k}") for k in range(1, 10)]
    for long, count in ((arm[:8], 28), (arm, 8)):
        answer = read("standard", long)
        assert len(list(CHANGES["rows_swapped"](work(answer, USUAL, answer)))) == count


def joints_of(answer: Rows, policy: Policy = USUAL) -> Iterator[tuple[str, str]]:
    on = work(read("standard", answer), policy)
    for code in ("joint_type", "joint_fixed", "row_missing", "row_extra", "fixed_row_missing"):
        yield from dict.fromkeys(tables(CHANGES[code](on)))


def test_joints_that_are_missing_spare_or_of_another_type() -> None:
    """The key has a revolute joint, another, and a prismatic one."""
    other: Rows = [ARM[0], (0, 0.4, "q2", 0.2), ARM[2]]
    assert list(joints_of(other)) == [("joint_type", "r0.1 r0.4 p0")]
    one_less: Rows = [ARM[0], (0, 0.4, 0.2, 0), ARM[2]]
    assert list(joints_of(one_less)) == [
        *[("joint_type", "p0.1 f0.4 p0"), ("joint_type", "r0.1 f0.4 r0")],
        *[("joint_fixed", "r0.1 p0.4 p0"), ("joint_fixed", "r0.1 r0.4 p0")],
        *[
            ("row_missing", "r0 r0.1 f0.4 p0"),
            ("row_missing", "r0.1 r0 f0.4 p0"),
            ("row_missing", "r0.1 f0.4 r0 p0"),
        ],
    ]
    one_more: Rows = [ARM[0], ARM[1], ("pi/6", 0.3, 0, "q3"), (0, 0, "q4", 0.3)]
    assert list(joints_of(one_more)) == [
        *[("joint_type", "p0.1 r0.4 r0.3 p0"), ("joint_type", "r0.1 p0.4 r0.3 p0")],
        *[("joint_type", "r0.1 r0.4 p0.3 p0"), ("joint_type", "r0.1 r0.4 r0.3 r0")],
        *[("joint_moving", "f0.1 r0.4 r0.3 p0"), ("joint_moving", "r0.1 f0.4 r0.3 p0")],
        *[("joint_moving", "r0.1 r0.4 f0.3 p0"), ("joint_moving", "r0.1 r0.4 r0.3 f0")],
        *[("row_extra", "r0.4 r0.3 p0"), ("row_extra", "r0.1 r0.3 p0")],
        *[("row_extra", "r0.1 r0.4 p0"), ("row_extra", "r0.1 r0.4 r0.3")],
    ]


def test_a_joint_is_looked_for_among_its_places() -> None:
    short: Rows = [ARM[0], (0, 0.4, 0.2, 0), ARM[2], ARM[3]]
    for place, forgotten, missing in (
        (1, [], [0]),
        (2, [1, 1], [1, 2]),
        (3, [3, 3], []),
        (4, [], []),
    ):
        near = replace(work(read("standard", short)), scope=EditScope((place, place)))
        assert [change.row for change in CHANGES["joint_fixed"](near)] == forgotten
        assert list(dict.fromkeys(change.row for change in CHANGES["row_missing"](near))) == missing
    behind = replace(work(read("standard", ARM[:2])), scope=EditScope((3, 3)))
    change = next(CHANGES["row_missing"](behind))
    assert (change.row, dict(change.params)) == (2, {"place": 3, "after": 2})
    assert [one.cells[0][2] for one in CHANGES["row_missing"](behind)] == list(cell_edits.RIGHT_ANGLES)
    for put_in in CHANGES["row_missing"](behind):
        assert put_in.table is not None
        blank = put_in.table.rows[2]
        assert (blank.theta, blank.d, blank.a, blank.alpha) == (0.0, 0.0, 0.0, 0.0)
    more: Rows = [*ARM[:2], ("pi/6", 0.3, 0, "q3"), (0, 0, "q4", 0.3)]
    near = replace(work(read("standard", more)), scope=EditScope((2, 2)))
    for code in ("joint_fixed", "row_extra"):
        assert [change.row for change in CHANGES[code](near)] == [1]


def test_a_cell_and_a_row_that_the_whole_robot_asks_for() -> None:
    """In a right table every cell that is no variable is what is asked for; in a wrong one the wrong cell."""
    right = work(read("standard", ARM), USUAL)

    def asked_for(on: Work) -> list[tuple[int | None, str]]:
        return [(change.row, SIGNS[change.cell or ""]) for change in cell_edits.any_cell(on, 0)]

    assert asked_for(right) == [
        *((row, sign) for row in (0, 1) for sign in ("a", "α", "d")),
        *((2, sign) for sign in ("a", "α", "θ")),
        *((3, sign) for sign in ("a", "α", "d", "θ")),
    ]
    angles = [(0, "α"), (1, "α"), (2, "α"), (2, "θ"), (3, "α"), (3, "θ")]
    assert asked_for(replace(right, scope=EditScope(angular=True))) == angles
    off = work(read("standard", with_cells(ARM, (1, 1, 0.3))), USUAL)
    (change,) = cell_edits.any_cell(off, 0)
    assert (change.code, change.row, change.cell) == ("a_value", 0, "a")
    assert change.cells[0][2] == pytest.approx(0.1, rel=1e-4)
    flat = work(read("standard", with_cells(ARM, (1, 0, 0))), USUAL)
    assert "alpha_value" in {
        change.code for change in cell_edits.any_cell(replace(flat, scope=EditScope(angular=True)), 0)
    }
    slip = TableSlip(0, "a")
    assert len(list(cell_edits.any_cell(replace(off, only=slip), 0))) == 1
    assert list(cell_edits.any_cell(replace(off, only=TableSlip(4, "d")), 0)) == []
    assert list(cell_edits.any_cell(replace(off, only=slip._replace(code="a_d_swapped")), 0)) == []


@pytest.mark.parametrize(
    ("tool", "count"), [(ToolRule.FREE, 0), (ToolRule.AXIS, 0), (ToolRule.POINT, 1), (ToolRule.FRAME, 16)]
)
def test_a_last_row_may_be_missing_where_the_tool_is_asked_for(tool: ToolRule, count: int) -> None:
    """To a point lengths alone lead; to a frame right angles about z and x as well."""
    on = work(read("standard", ARM[:3]), Policy(tool=tool), read("standard", ARM[:3]))
    found = list(row_edits.fixed_row_left_out(on))
    assert len(found) == count
    assert all(change.row == 3 and dict(change.params) == {"place": 4, "after": 3} for change in found)
    assert list(row_edits.fixed_row_left_out(work(read("standard", ARM[:2]), Policy(tool=tool)))) == []


def test_the_frame_of_the_tool_shows_the_whole_row_that_is_missing() -> None:
    (change,) = row_edits.fixed_row_left_out(work(read("standard", ARM[:3])))
    assert change.of(ON_WRONG.table) == change.table
    assert change.table is not None
    assert rows(change.table) == "r0.1 r0.4 p0 f0.05"
    assert change.table.rows[3].d == pytest.approx(0.2)
    assert (change.row, dict(change.params)) == (3, {"place": 4, "after": 3})


def test_names_are_taken_for_one_another_if_they_are_of_one_kind() -> None:
    key = read("standard", [("beta", "a1", 0, "q1"), (0, "a2", "d2", "q2")])
    swapped = read("standard", [("beta", "a2", 0, "q1"), (0, "a1", "d2", "q2")])
    on = work(swapped, USUAL, key)
    pairs = [dict(change.params) for change in CHANGES["parameters_swapped"](on)]
    assert [(pair["name"], pair["other"]) for pair in pairs] == [("a2", "a1"), ("a2", "d2"), ("a1", "d2")]
    misnamed = read("standard", [("beta", "a1", 0, "q1"), (0, "b", "d2", "q2")])
    on = work(misnamed, USUAL, key)
    (change,) = CHANGES["parameter_misnamed"](on)
    assert change.touched == ((1, "a"),)
    assert change.cells == ((1, "a", on.comparison.draws[0]["a2"]),)


# what is known of a table: where the mistake is, what an edit before has changed, what is to be undone


def test_edits_are_made_where_all_that_is_wrong_may_be_mended() -> None:
    """Joints from … to; an edit in a row concerns the joint that moves it and the next one."""
    for reach, signs in (
        ((2, 2), ["a2 -0.4"]),
        ((1, 2), ["a1 -0.1", "a2 -0.4"]),
        ((3, 3), ["a3 -0.3", "a4 -0.05"]),
        ((3, 2), []),
        ((4, 4), []),
    ):
        near = replace(ON_WRONG, scope=EditScope(reach))
        assert tried("a_sign", near) == signs
        assert [row + 1 for row, _ in near.rows] == [int(one[1]) for one in signs]
    for reach, swaps in (((1, 1), [0, 0, 0, 1, 1]), ((4, 4), [0, 0, 1, 1, 2])):
        found = [change.row for change in CHANGES["rows_swapped"](replace(ON_WRONG, scope=EditScope(reach)))]
        assert found == swaps


def test_an_angle_is_not_mended_by_lengths() -> None:
    angular = replace(ON_WRONG, scope=EditScope(angular=True))
    for code in ("a_sign", "d_sign", "a_d_swapped", "a_value", "d_value", "cell_length_unit", "length_unit"):
        assert tried(code, angular) == []
    assert [one.split()[0][0] for one in tried("columns_exchanged", angular)] == ["α", "d"]
    assert len(tried("columns_reordered", angular)) == 2
    assert tried("alpha_sign", angular) == IN_CELLS["alpha_sign"]


def test_what_an_edit_before_has_changed_is_left_alone() -> None:
    kept = replace(ON_WRONG, kept=frozenset({(1, "a")}))
    for code in ("length_unit", "columns_late", "columns_early", "columns_reordered"):
        assert tried(code, kept) == []
    assert [one[0] for one in tried("columns_exchanged", kept)] == ["d"]
    assert tried("angles_in_degrees", kept) == THROUGHOUT["angles_in_degrees"]
    swaps = [(change.row, dict(change.params)["other"]) for change in CHANGES["rows_swapped"](kept)]
    assert swaps == [(0, 3), (0, 4), (2, 4)]
    in_a_slider = replace(ON_WRONG, kept=frozenset({(2, "a")}))  # whose row stays where columns change with d
    assert [one[0] for one in tried("columns_exchanged", in_a_slider)] == ["d", "d"]
    assert len(tried("columns_reordered", in_a_slider)) == 2
    turned = replace(ON_WRONG, kept=frozenset({(0, "theta")}))
    assert len(list(CHANGES["rows_swapped"](turned))) == 6


def test_columns_that_lack_a_size_are_mended_by_what_puts_one_there() -> None:
    def codes(lacking: str) -> set[str]:
        return {
            change.code
            for change in changes_of(replace(ON_WRONG, scope=EditScope(lacking=frozenset(lacking.split()))))
        }

    assert "alpha_value" in codes("alpha")
    assert not codes("alpha") & {"a_sign", "d_sign", "alpha_sign", "a_not_zero", "length_unit", "theta_value"}
    assert {"a_not_zero", "length_unit", "a_d_swapped", "cell_length_unit"} <= codes("a")
    assert not codes("a") & {"alpha_value", "d_not_zero", "angles_in_degrees", "cell_in_degrees"}
    assert "columns_late" in codes("alpha a")
    assert "columns_late" not in codes("a d")
    assert {"columns_exchanged", "columns_reordered", "convention"} <= codes("a d")
    assert "columns_exchanged" not in codes("alpha a d")
    assert "columns_reordered" in codes("alpha a d")


def test_rows_change_places_only_where_two_joints_are_of_another_type() -> None:
    for others, wanted in ((1, {"joint_type"}), (2, {"joint_type", "rows_swapped"})):
        joints = [
            JointType.PRISMATIC if i < others else row.joint for i, row in enumerate(ON_PUMA.table.rows)
        ]
        rows = (replace(row, joint=joint) for row, joint in zip(ON_PUMA.table.rows, joints, strict=True))
        other = replace(ON_PUMA, table=replace(ON_PUMA.table, rows=tuple(rows)))
        assert {change.code for change in changes_of(other)} == wanted


def test_of_a_slip_that_is_known_only_that_is_tried() -> None:
    def codes(slip: TableSlip) -> list[tuple[str, int | None, str | None]]:
        only = replace(ON_WRONG, only=slip)
        return sorted({(one.code, one.row, one.cell) for one in changes_of(only) if one.slip == slip})

    assert codes(TableSlip(1, "a")) == [("a_not_zero", 1, "a"), ("a_sign", 1, "a")]
    assert codes(TableSlip(2, "theta")) == [("cell_in_degrees", 2, "theta"), ("theta_value", 2, "theta")]
    assert codes(TableSlip(None, None, "columns_late")) == [("columns_late", None, None)]
    assert {
        change.code for change in changes_of(replace(ON_WRONG, only=TableSlip(None, None, "convention")))
    } == {"convention"}


def test_before_a_joint_too_few_what_leaves_one_too_few_is_undone() -> None:
    """Never what adds or removes a joint, or concerns one cell: those come after."""
    short: Rows = [ARM[0], ("pi/3", 0.4, 0.2, "q2"), ARM[3]]
    on = work(read("standard", short))
    codes = {change.code for change in changes_beforehand(on)}
    assert codes == {
        *("convention", "angles_in_degrees", "length_unit", "columns_late", "columns_early"),
        *(
            "twists_late",
            "twists_early",
            "columns_exchanged",
            "columns_reordered",
            "twists_all_reversed",
            "joint_type",
            "rows_swapped",
        ),
    }
    named = read("standard", [("beta", "a2", 0, "q1"), (0, "b", "h", 0)])
    key = read("standard", [("beta", "a1", 0, "q1"), (0, "a2", "h", "q2")])
    of_names = {change.code for change in changes_beforehand(work(named, USUAL, key))}
    assert {"parameter_misnamed", "parameters_swapped"} <= of_names
    types = [rows(change.table) for change in changes_beforehand(on) if change.code == "joint_type"]
    assert types == ["r0.1 p0.4 f0.05"]
    assert list(changes_beforehand(ON_WRONG)) == []
    only = replace(
        on, only=TableSlip(None, None, "convention", (("declared", "standard"), ("meant", "modified")))
    )
    assert [change.code for change in changes_beforehand(only)] == ["convention"]


def test_the_catalogue_is_made_of_pure_functions() -> None:
    homes = {cell_edits.__name__, row_edits.__name__, table_edits.__name__}
    assert {entry.changes.__module__ for entry in CATALOGUE} == homes


def test_a_row_that_an_edit_has_added_holds_no_name() -> None:
    named = work(
        read("standard", [*ARM[:1], (0, "L1", 0.2, "q2"), *ARM[2:]]),
        key=read("standard", [*ARM[:1], (0, "L1", 0.2, "q2"), *ARM[2:]]),
    )
    assert [_is_a_name(named, row, "a") for row in range(len(ARM) + 1)] == [False, True, False, False, False]
