"""From drawn axes to a table in named lengths, checked against arms whose tables are printed."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from exercises.authoring.draft import exercise_of_draft
from exercises.authoring.scaffold import started
from exercises.authoring.sources import read_source
from exercises.authoring.trials import new_draft
from exercises.errors import DefinitionError
from exercises.selftest.checks import check_values
from kinematics.cells import read_table
from kinematics.chain import chain_of_table
from kinematics.table import bind

LENGTHS = {"d1": 0.0892, "a2": 0.425, "a3": 0.392, "d4": 0.1093, "d5": 0.09475}
"""Of a UR5, after Universal Robots' published DH parameters, rounded."""

UR5: dict[str, Any] = {
    "length_unit": "m",
    "lengths": LENGTHS,
    "axes": [
        {"joint": "revolute", "point": [0, 0, 0], "direction": [0, 0, 1]},
        {
            "joint": "revolute",
            "point": {"on": 1, "at": "d1"},
            "direction": {"perpendicular": 1, "towards": [0, -1, 0]},
        },
        {"joint": "revolute", "point": {"from": 2, "by": ["a2", 0, 0]}, "direction": {"parallel": 2}},
        {"joint": "revolute", "point": {"from": 3, "by": ["a3", "-d4", 0]}, "direction": {"parallel": 2}},
        {"joint": "revolute", "point": {"from": 4, "by": [0, 0, 0]}, "direction": {"opposite": 1}},
        {"joint": "revolute", "point": {"on": 5, "at": "d5"}, "direction": {"parallel": 2}},
    ],
}


def test_the_table_of_a_drawn_arm_is_in_its_lengths() -> None:
    source = read_source({"axes": UR5})
    assert source.values == LENGTHS
    assert [(row.alpha, row.a, row.d, row.theta) for row in source.table.rows] == [
        ("0", "0", "d1", "q1"),
        ("90", "0", "0", "q2"),
        ("0", "a2", "0", "q3"),
        ("0", "a3", "d4", "q4"),
        ("90", "0", "d5", "q5"),
        ("-90", "0", "0", "q6"),
    ]


@pytest.mark.parametrize("length", [5e-324, 1e-320, 1e-310, 1e-200, 0])
def test_a_length_too_small_to_be_changed_by_a_share_is_taken(length: float) -> None:
    source = read_source({"axes": {**UR5, "lengths": {**LENGTHS, "d1": length}}})
    assert [row.a for row in source.table.rows] == ["0", "0", "a2", "a3", "0", "0"]
    assert {"a2", "a3"} <= started("ur5-like", source).definition["parameters"].keys()


def test_the_self_test_of_a_drawn_arm_is_green() -> None:
    exercise = exercise_of_draft(started("ur5-like", read_source({"axes": UR5})))
    findings = check_values((None, 1), exercise, 4)
    assert not findings.failures
    assert findings.passed.total() > 50


SIZES = st.floats(0.05, 3).map(lambda value: round(value, 3))


@given(st.fixed_dictionaries(dict.fromkeys(LENGTHS, SIZES)))
def test_the_named_table_has_the_drawn_axes_at_every_size(values: dict[str, float]) -> None:
    """The table of one drawing, with other values put in, carries the axes that are drawn at these values."""
    source = read_source({"axes": UR5})
    chain = chain_of_table(bind(read_table(source.table).table, values))
    redrawn = read_source({"axes": {**UR5, "lengths": values}})
    other = chain_of_table(bind(read_table(redrawn.table).table, redrawn.values))
    for own, drawn in zip(chain.axes, other.axes, strict=True):
        assert np.allclose(own.direction, drawn.direction, atol=1e-9)
        assert np.allclose(
            np.cross(own.point, own.direction), np.cross(drawn.point, drawn.direction), atol=1e-9
        )


def test_a_length_that_is_a_sum_is_written_as_one() -> None:
    drawing = {
        "lengths": {"L1": 0.3, "L2": 0.2},
        "axes": [
            {"joint": "revolute", "point": [0, 0, 0], "direction": [0, 0, 1]},
            {"joint": "prismatic", "point": ["L1 + L2", 0, 0], "direction": [0, 0, 1]},
            {"joint": "revolute", "point": ["L1 - L2", 0, 0], "direction": {"perpendicular": 1, "and": 1}},
        ],
    }
    with pytest.raises(DefinitionError):  # an axis is across itself in no direction
        read_source({"axes": drawing})
    drawing["axes"][2] = {"joint": "revolute", "point": ["L1 + L2", 0, 0], "direction": {"parallel": 1}}  # type: ignore[index]
    assert read_source({"axes": drawing}).table.rows[1].a in ("L1 + L2", "L2 + L1")


@pytest.mark.parametrize(
    ("axis", "code"),
    [
        ({"point": {"on": 1, "at": 0}, "direction": [0, 0, 1]}, "axis_not_before"),
        ({"point": ["L9", 0, 0], "direction": [0, 0, 1]}, "length_unknown"),
        ({"point": ["q1 + 1", 0, 0], "direction": [0, 0, 1]}, "joint_variable_in_number"),
        ({"point": {"from": 1, "by": [0, "sin(q2)", 0]}, "direction": [0, 0, 1]}, "joint_variable_in_number"),
        ({"point": [0, 0, 0], "direction": [0, 0, 0]}, "direction_zero"),
        ({"point": [0, 0, 0], "direction": {"parallel": 7}}, "axis_not_before"),
        ({"point": [0, 0], "direction": [0, 0, 1]}, "exercise_value_type"),
        ({"point": [0, 0, 0], "direction": {"up": 1}}, "exercise_key_missing"),
        ({"point": [0, 0, 0], "direction": [0, 0, 1], "colour": 1}, "exercise_key_unknown"),
    ],
)
def test_what_cannot_be_drawn_is_told(axis: dict[str, Any], code: str) -> None:
    with pytest.raises(DefinitionError) as caught:
        read_source({"axes": {"axes": [{"joint": "revolute", **axis}]}})
    assert code in {fault.code for fault in caught.value.faults}


def test_too_many_axes_are_told() -> None:
    axis = {"joint": "revolute", "point": [0, 0, 0], "direction": [0, 0, 1]}
    with pytest.raises(DefinitionError) as caught:
        read_source({"axes": {"axes": [axis] * 200}})
    assert caught.value.code == "drawing_too_many_axes"


SCM = {
    "parameters": {"L0": 0.5, "L1": 0.4, "L2": 0.3},
    "joints": [{"z": "L0", "c": "q1"}, {"x": "L1", "c": "q2"}, {"z": "q3"}],
    "final": {"x": "L2"},
}


@pytest.mark.parametrize(
    "document",
    [
        {"robot": "scara"},
        {"scm": SCM},
        {
            "table": {
                "convention": "standard",
                "angle_unit": "deg",
                "rows": [
                    {"theta": "q1", "d": 0.3, "a": "L1", "alpha": 0},
                    {"theta": "q2", "d": 0, "a": "L2", "alpha": 180},
                    {"theta": 0, "d": "q3", "a": 0, "alpha": 0},
                ],
                "parameters": {"L1": 0.4, "L2": 0.3},
            }
        },
    ],
)
def test_every_start_leads_to_an_exercise_that_passes_its_own_tests(document: dict[str, Any]) -> None:
    exercise = exercise_of_draft(started("mine", read_source(document)))
    assert not check_values((None,), exercise, 3).failures


@pytest.mark.parametrize(
    "document", [{}, {"robot": "scara", "urdf": ""}, {"magic": 1}, {"robot": "r2d2"}, {"urdf": "<"}]
)
def test_no_start_is_told(document: dict[str, Any]) -> None:
    with pytest.raises(DefinitionError):
        read_source(document)


def two_links(first: float, second: float) -> dict[str, Any]:
    rows = [
        {"theta": "q1", "d": 0, "a": "L1", "alpha": 0},
        {"theta": "q2", "d": 0, "a": second, "alpha": 0},
    ]
    return {"table": {"convention": "standard", "rows": rows, "parameters": {"L1": first}}}


@pytest.mark.parametrize("length", [0, -0.0, 1e-300, -1e-12, 1e-7])
def test_a_length_that_no_figure_can_show_is_refused_when_an_exercise_is_started(length: float) -> None:
    chain = {"joints": [{"x": "L1", "c": "q1"}, {"x": 1, "c": "q2"}], "parameters": {"L1": length}}
    for document, key in (
        (two_links(length, 1), "parameters"),
        ({"scm": chain}, "parameters"),
        ({"axes": {**UR5, "lengths": {**LENGTHS, "a2": 0}}}, "lengths"),
    ):
        with pytest.raises(DefinitionError) as caught:
            new_draft("mine", document)
        (fault,) = caught.value.faults
        assert fault.code == "dimension_too_short"
        (form,) = document
        assert fault.where == ("source", form, key, fault.params["name"])
        assert float(str(fault.params["length"])) < float(str(fault.params["least"]))


def test_a_length_without_a_name_of_its_own_is_refused_where_the_table_stands() -> None:
    with pytest.raises(DefinitionError) as caught:
        new_draft("mine", two_links(1e9, 1))
    (fault,) = caught.value.faults
    assert (fault.code, fault.where) == ("dimension_too_short", ("source", "table"))
    assert fault.params["name"] == "a2"


def test_a_length_of_zero_that_is_added_to_another_is_taken() -> None:
    table = two_links(0, 1)["table"]
    table["rows"][0]["a"] = "L1 + L2"
    table["parameters"]["L2"] = 1
    draft, axes = new_draft("mine", {"table": table})
    assert exercise_of_draft(draft).id == "mine"
    assert axes == ()
