"""How a wrong table's robot lies on the figure's: on its axes as far as both are the same mechanism."""

from dataclasses import replace

import numpy as np
import orjson
import pytest
from hypothesis import given
from hypothesis import strategies as st

from exercises.departure import Departure, joints_alike, shared_joints
from exercises.drawings import figure_geometry
from exercises.grading import HelpLevel
from exercises.instance import generate
from kinematics.cells import RawTable, read_table
from kinematics.chain import chain_of_table
from kinematics.equivalence.decision import certify, mechanism_only
from kinematics.equivalence.invariants import invariants_of
from kinematics.equivalence.measures import Measure
from kinematics.equivalence.reference import prepared
from kinematics.equivalence.search import Effort
from kinematics.table import JointType, bind
from service.wire.exercises.verdicts import encoded, restored
from tests.exercises.answering import judged, table
from tests.exercises.packaged import exercise
from tests.kinematics.equivalence.tables import changed
from tests.kinematics.equivalence.test_diagnosis import CROSSED, FREE, SKEW

PUMA = (
    (0, 0, 0, "θ1"),
    (-90, 0, 0, "θ2"),
    (0, "a2", "d3", "θ3"),
    (-90, "a3", "d4", "θ4"),
    (90, 0, 0, "θ5"),
    (-90, 0, 0, "θ6"),
)
CELLS = ("alpha", "a", "d")


def puma(row: int, cell: str, value: object) -> RawTable:
    """The PUMA of the books with one cell changed."""
    rows = [list(entry) for entry in PUMA]
    rows[row - 1][CELLS.index(cell)] = value
    return table("modified", *(tuple(entry) for entry in rows))  # type: ignore[arg-type]


def shared_axes(raw: RawTable, told: Departure) -> int:
    """How many of the table's axes, base first, lie on the figure's where the departure lays them."""
    instance = generate(exercise("puma560"))
    values = dict(instance.parameters)
    axes = figure_geometry(instance)["axes"]
    chain = chain_of_table(bind(read_table(raw).table, values), base=np.array(told.base))
    directions, points = chain.axes_at(told.posture)
    for i, (axis, direction, point) in enumerate(zip(axes, directions, points, strict=True)):  # type: ignore[call-overload]
        target = np.array(axis["direction"])
        apart = np.cross(point - np.array(axis["point"]), target)
        if np.linalg.norm(apart) > 1e-6 or np.linalg.norm(np.cross(direction, target)) > 1e-6:
            return i
        assert told.senses[i] == (1 if direction @ target > 0 else -1)
    return len(directions)


@pytest.mark.parametrize(
    ("row", "cell", "value", "shared"),
    [
        (2, "alpha", 0, 1),
        (2, "a", "a2", 1),
        (3, "a", "d3", 2),
        (4, "a", 0, 3),
        (4, "d", 0, 4),
        (5, "alpha", 0, 4),
    ],
)
def test_the_robot_lies_on_the_figure_up_to_the_row_that_is_named(
    row: int, cell: str, value: object, shared: int
) -> None:
    raw = puma(row, cell, value)
    report = judged("puma560", table=raw)
    told = report.departure
    assert told is not None
    assert report.verdict is not None
    assert shared_axes(raw, told) >= shared
    named = [entry.row for entry in report.verdict.feedback if entry.row is not None]
    assert told.row == named[0] == row


@given(row=st.integers(2, 6), cell=st.sampled_from(CELLS), value=st.sampled_from([0, 30, "a2", "a3", "d4"]))
def test_whatever_is_told_lies_on_the_axes_before_the_first_that_differs(
    row: int, cell: str, value: object
) -> None:
    if cell == "alpha" and isinstance(value, str):
        value = 45
    raw = puma(row, cell, value)
    report = judged("puma560", table=raw)
    if report.departure is None:
        assert report.correct
        return
    instance = generate(exercise("puma560"))
    key = bind(instance.exercise.reference.table, instance.parameters)
    shared, _ = shared_joints(key, bind(read_table(raw).table, instance.parameters), instance.exercise.policy)
    assert shared_axes(raw, report.departure) >= shared


@given(row=st.integers(1, 6), cell=st.sampled_from(CELLS), value=st.sampled_from([0, 30, "a2", "d4"]))
def test_as_many_joints_are_shared_as_have_a_certificate(row: int, cell: str, value: object) -> None:
    if cell == "alpha" and isinstance(value, str):
        value = 45
    instance = generate(exercise("puma560"))
    key = bind(instance.exercise.reference.table, instance.parameters)
    answer = bind(read_table(puma(row, cell, value)).table, instance.parameters)
    shared, _ = shared_joints(key, answer, instance.exercise.policy)
    free = mechanism_only(instance.exercise.policy)
    for joints in range(1, 7):
        ours, theirs = (replace(table, rows=table.rows[:joints]) for table in (key, answer))
        stands = certify((prepared(ours),), (chain_of_table(theirs),), free, Effort.PLAIN) is not None
        assert stands == (joints <= shared)


@pytest.mark.parametrize("level", list(HelpLevel))
def test_it_is_told_only_where_the_help_tells_what_is_wrong(level: HelpLevel) -> None:
    report = judged("puma560", table=puma(3, "a", 0), help_level=level)
    assert (report.departure is not None) == (level in (HelpLevel.KIND, HelpLevel.REPAIR))
    assert restored(orjson.loads(encoded(report))) == report


def test_a_right_table_and_one_that_cannot_be_drawn_have_none() -> None:
    assert judged("puma560", table=table("modified", *PUMA)).departure is None
    prismatic = table("modified", (0, 0, "d1", 0), *PUMA[1:])
    assert read_table(prismatic).table.joint_types[0] is JointType.PRISMATIC
    assert judged("puma560", table=prismatic).departure is None
    assert judged("puma560", table=table("modified", (0, 0, 0, 0))).departure is None


@pytest.mark.parametrize("row", range(1, 5))
@pytest.mark.parametrize("cell", ["alpha", "a"])
def test_first_axes_are_shared_up_to_a_wrong_fact(row: int, cell: str) -> None:
    wrong = changed(CROSSED, row, **{cell: getattr(CROSSED.rows[row - 1], cell) + 0.1})
    assert joints_alike(CROSSED, wrong, FREE) == row
    assert joints_alike(CROSSED, CROSSED, FREE) == CROSSED.n_joints


@pytest.mark.parametrize(("share", "shared"), [(0.9, 4), (1.1, 2)])
def test_an_axis_that_is_off_by_more_than_digits_explain_is_not_shared(share: float, shared: int) -> None:
    invariants = invariants_of(prepared(SKEW), FREE)
    (k,) = (k for k, shape in enumerate(invariants.shapes) if shape == (Measure.DISTANCE, (2, 3, 2, 3)))
    wrong = changed(SKEW, 2, a=SKEW.rows[1].a + share * float(invariants.slacks[k, 0]))
    assert joints_alike(SKEW, wrong, FREE) == shared


@pytest.mark.parametrize(("cell", "shared"), [("d", 3), ("a", 4)])
def test_axes_are_shared_up_to_a_wrong_sign(cell: str, shared: int) -> None:
    """Each axis may point either way, but what is known before and behind it says which."""
    wrong = changed(CROSSED, 3, **{cell: -getattr(CROSSED.rows[2], cell)})
    assert joints_alike(CROSSED, wrong, FREE) == shared
    assert shared_joints(CROSSED, wrong, FREE)[0] == shared
