"""Names in an answer: the exercise's own, and others for them; an unknown one is told, and no attempt."""

from dataclasses import replace

import pytest

from exercises.answers import RawAnswer, parse
from exercises.errors import AnswerError
from exercises.grader import grade
from exercises.instance import generate
from exercises.parts.forward.workspace import RadiiCells
from tests.exercises.answering import SCARA, SCARA_TRANSFORM, edited, table
from tests.exercises.packaged import exercise

EYE = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]


@pytest.mark.parametrize(
    ("typed", "close"),
    [("A2", "a2"), ("α2", "a2"), ("a4", ""), ("ab2", "a2"), ("a22", ""), ("x", ""), ("L1", "")],
)
def test_an_unknown_name_is_no_attempt_and_is_told_the_nearest_known_one(typed: str, close: str) -> None:
    rows = [(0, typed, 0, "q1"), (180, "a3", 0, "q2"), (0, 0, "q3", 0), (0, 0, 0, "q4")]
    with pytest.raises(AnswerError) as error:
        parse(generate(exercise("scara")), RawAnswer(table=table("standard", *rows)))
    (fault,) = error.value.faults
    assert (fault.code, fault.where) == ("name_unknown", ("table", "rows", 0, "a"))
    assert (fault.params["close"], fault.params["known"]) == (close, ("a2", "a3"))


def test_no_length_is_suggested_for_a_twist() -> None:
    rows = [("α2", "a2", 0, "q1"), (180, "a3", 0, "q2"), (0, 0, "q3", 0), (0, 0, 0, "q4")]
    with pytest.raises(AnswerError) as error:
        parse(generate(exercise("scara")), RawAnswer(table=table("standard", *rows)))
    (fault,) = error.value.faults
    assert (fault.code, fault.params["close"]) == ("name_unknown", "")


def test_an_alias_means_its_dimension() -> None:
    found = replace(exercise("scara"), aliases={"L1": "a2", "L2": "a3"})
    rows = [(0, "L1", 0, "q1"), (180, "L2", 0, "q2"), (0, 0, "q3", 0), (0, 0, 0, "q4")]
    renamed = [[str(cell).replace("a2", "L1") for cell in row] for row in SCARA_TRANSFORM]
    raw = RawAnswer(table=table("standard", *rows), transform=renamed)
    report = grade(generate(found), parse(generate(found), raw))
    assert report.correct


def test_an_alias_that_leaves_a_cell_without_a_value_is_refused_at_its_place() -> None:
    found = generate(replace(exercise("scara"), aliases={"L1": "a2"}))
    rows = [(0, "a2", 0, "q1"), (180, "a3/(L1-a2)", 0, "q2"), (0, 0, "q3", 0), (0, 0, 0, "q4")]
    with pytest.raises(AnswerError) as error:
        parse(
            found,
            RawAnswer(
                table=table("standard", *rows),
                transform=edited(SCARA_TRANSFORM, 0, 3, "a3/(L1-a2)"),
                workspace=RadiiCells(inner="1/(a2-L1)", outer=2),
            ),
        )
    assert {".".join(map(str, fault.where)): fault.code for fault in error.value.faults} == {
        "table.rows.1.a": "value_undefined",
        "transform.0.3": "value_undefined",
        "workspace.inner": "value_undefined",
    }


@pytest.mark.parametrize(
    ("name", "close"), [("th1", "q1"), ("t_2", "q2"), ("teta3", "q3"), ("th9", ""), ("z1", "")]
)
def test_what_means_a_joint_variable_in_a_matrix_is_told_as_it(name: str, close: str) -> None:
    rows = edited(EYE, 0, 3, f"a2*cos({name})")
    with pytest.raises(AnswerError) as error:
        parse(generate(exercise("scara")), RawAnswer(table=SCARA, transform=rows))
    (fault,) = error.value.faults
    assert (fault.code, fault.params["close"]) == ("name_unknown", close)


@pytest.mark.parametrize(
    ("cell", "close"), [("O", "0"), ("o", "0"), ("zero", "0"), ("Cero", "0"), ("nul", "0"), ("x", "")]
)
def test_a_word_for_zero_is_told_as_zero(cell: str, close: str) -> None:
    rows = ((0, "a2", cell, "q1"), (180, "a3", 0, "q2"), (0, 0, "q3", 0), (0, 0, 0, "q4"))
    with pytest.raises(AnswerError) as error:
        parse(generate(exercise("scara")), RawAnswer(table=table("standard", *rows)))
    (fault,) = error.value.faults
    assert (fault.code, fault.where, fault.params["close"]) == (
        "name_unknown",
        ("table", "rows", 0, "d"),
        close,
    )


def test_a_name_in_a_radius_is_told_as_anywhere() -> None:
    with pytest.raises(AnswerError) as error:
        parse(
            generate(exercise("twolink")), RawAnswer(workspace=RadiiCells(inner="|L1 - L2|", outer="l1+L2"))
        )
    (fault,) = error.value.faults
    assert (fault.code, fault.where, fault.params["close"]) == ("name_unknown", ("workspace", "outer"), "L1")


@pytest.mark.parametrize(
    ("cell", "name", "unit"), [("10 N", "N", 1), ("a2 m", "m", 1), ("2 A2", "A2", 0), ("b9", "b9", 0)]
)
def test_a_unit_that_no_number_precedes_is_told_as_one(cell: str, name: str, unit: int) -> None:
    with pytest.raises(AnswerError) as error:
        parse(generate(exercise("scara")), RawAnswer(workspace=RadiiCells(inner=0, outer=cell)))
    (fault,) = error.value.faults
    assert (fault.code, fault.params["name"], fault.params["unit"]) == ("name_unknown", name, unit)


@pytest.mark.parametrize(
    ("cell", "name"), [("0 (cero)", "cero"), ("0*A2", "A2"), ("a2 + xyz - xyz", "xyz"), ("0/yy", "yy")]
)
def test_an_unknown_name_that_makes_no_difference_is_told(cell: str, name: str) -> None:
    """No word is accepted silently, even where its value drops out."""
    rows = ((0, "a2", 0, "q1"), (180, cell, 0, "q2"), (0, 0, "q3", 0), (0, 0, 0, "q4"))
    instance = generate(exercise("scara"))
    with pytest.raises(AnswerError) as refused:
        parse(instance, RawAnswer(table=table("standard", *rows)))
    (fault,) = refused.value.faults
    assert (fault.code, fault.where, fault.params["name"]) == (
        "name_unknown",
        ("table", "rows", 1, "a"),
        name,
    )
