"""Mistakes in matrices: planted, found, named and mended."""

from dataclasses import replace

import pytest

from exercises.grading import Finding
from exercises.parts.cells.short_forms import CELL_LIMITS
from exercises.parts.mistakes.matrix_mistake import PART, FoundMatrixMistakeCells
from exercises.parts.mistakes.planted_matrices import MATRIX_MISTAKES, MatrixKind, PlantedMatrix, plantable_in
from exercises.parts.protocol import RawAnswer, Reading
from kinematics import catalogue
from tests.exercises.parts.mended_matrices import EXERCISES, cases, student


def test_repairs_are_judged_by_what_they_mean() -> None:
    for found, rows, right in cases(80, 5):
        report = found.judged(FoundMatrixMistakeCells(mended_matrix=tuple(tuple(row) for row in rows)))
        finding = {fact.where: fact.finding for fact in report.facts}
        assert (finding["mended_matrix",] is Finding.OK) is right
        assert (finding["cell_row",] is Finding.OK) is right  # a repair that does says where it was


@pytest.mark.parametrize("name", EXERCISES)
def test_place_name_and_repair_earn_a_third_each(name: str) -> None:
    found = student(name, 3)
    planted: PlantedMatrix = found.instance.drawn[PART.kind]
    for r in range(3):
        for c in range(4):
            report = found.judged(FoundMatrixMistakeCells(cell_row=str(r + 1), cell_column=c + 1))
            assert report.score == pytest.approx(((r, c) in planted.wrong_cells) / 3)
    assert found.judged(FoundMatrixMistakeCells(mistake=planted.code)).score == pytest.approx(1 / 3)
    right = PART.right(found.part, found.context)
    assert found.judged(right).score == 1.0


def test_a_matrix_of_empty_cells_is_none_given() -> None:
    """As of a row or a frame: place and name stand by themselves."""
    found = student(EXERCISES[0], 3)
    planted: PlantedMatrix = found.instance.drawn[PART.kind]
    report = found.judged(FoundMatrixMistakeCells(mistake=planted.code, mended_matrix=(("",) * 4,) * 4))
    assert report.score == pytest.approx(1 / 3)
    assert {entry.code for entry in report.feedback} == {"matrix_mistake_missing"}


@pytest.mark.parametrize(("factor", "right"), [("1.01", False), ("1.001", False), ("1.0", True)])
def test_a_name_with_a_factor_beside_it_is_another_length(factor: str, right: bool) -> None:
    found = student("puma560-matrix-mistake", 3)
    mended = PART.right(found.part, found.context).mended_matrix
    assert mended is not None
    names = found.instance.exercise.reference.parameters
    scaled = tuple(
        (*row[:3], f"{factor}*({row[3]})" if any(name in str(row[3]) for name in names) else row[3])
        for row in mended
    )
    assert any(str(row[3]).startswith(factor) for row in scaled)
    report = found.judged(FoundMatrixMistakeCells(mended_matrix=scaled))
    assert ("matrix_not_mended" not in {entry.code for entry in report.feedback}) is right


def test_an_entry_that_is_right_is_no_place_even_beside_the_mended_matrix() -> None:
    found = student(EXERCISES[0], 3)
    planted: PlantedMatrix = found.instance.drawn[PART.kind]
    right = PART.right(found.part, found.context)
    r, c = next((r, c) for r in range(3) for c in range(4) if (r, c) not in planted.wrong_cells)
    report = found.judged(replace(right, cell_row=r + 1, cell_column=c + 1))
    assert [entry.code for entry in report.feedback] == ["matrix_mistake_place_wrong"]
    assert report.score == pytest.approx(2 / 3)


def test_each_kind_of_mistake_changes_a_matrix_of_some_robot() -> None:
    for kind, codes in MATRIX_MISTAKES.items():
        for code in codes:
            ways = [
                way
                for name in ("stanford", "ur5", "scorbot")
                for way in plantable_in(catalogue.robot(name).table.table, kind, code)
            ]
            assert ways, code
            assert all(way.wrong_cells for way in ways)


def test_a_mistake_may_be_called_by_every_name_that_makes_it() -> None:
    table = catalogue.robot("twolink").table.table
    ways = [
        way for code in MATRIX_MISTAKES[MatrixKind.LINK] for way in plantable_in(table, MatrixKind.LINK, code)
    ]
    for way in ways:
        names = {other.code for other in ways if other.link == way.link and other.shown == way.shown}
        assert all(way.shows(name, table) for name in names)
    assert not any(way.shows("rotation_transposed", table) for way in ways if way.code == "position_sign")


def test_students_get_different_matrices_and_each_the_same_again() -> None:
    drawn = [student("puma560-matrix-mistake", k).instance.drawn[PART.kind] for k in range(12)]
    assert len({(way.code, way.link, way.shown) for way in drawn}) > 6
    again = student("puma560-matrix-mistake", 3).instance.drawn[PART.kind]
    assert (again.code, again.shown) == (drawn[3].code, drawn[3].shown)


@pytest.mark.parametrize(
    ("raw", "code", "where"),
    [
        (FoundMatrixMistakeCells(cell_row=5), "row_unknown", ("cell_row",)),
        (FoundMatrixMistakeCells(cell_column="x"), "column_unknown", ("cell_column",)),
        (FoundMatrixMistakeCells(mistake="typo"), "misconception_unknown", ("mistake",)),
        (
            FoundMatrixMistakeCells(mended_matrix=(("1/0", 0, 0, 0), *((0, 0, 0, 0),) * 3)),
            "division_by_zero",
            ("mended_matrix", 0, 0),
        ),
        (
            FoundMatrixMistakeCells(mended_matrix=((0, 0, "zz", 0), *((0, 0, 0, 0),) * 3)),
            "name_unknown",
            ("mended_matrix", 0, 2),
        ),
    ],
)
def test_what_cannot_be_read_is_refused_with_its_place(
    raw: FoundMatrixMistakeCells, code: str, where: tuple[str | int, ...]
) -> None:
    found = student("puma560-matrix-mistake", 1)
    reading = Reading(instance=found.instance, raw=RawAnswer(), table=None, limits=CELL_LIMITS)
    assert PART.read(raw, reading) is None
    assert [(fault.code, fault.where) for fault in reading.faults] == [(code, where)]
