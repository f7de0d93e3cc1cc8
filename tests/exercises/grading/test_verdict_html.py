"""A verdict as a notebook shows it."""

import xml.etree.ElementTree as ET

from exercises.grading import HelpLevel, Policy
from exercises.grading.grade import grade
from kinematics.cells import RawRow, RawTable, read_table
from kinematics.table import Convention


def read(length: str):
    rows = (RawRow(theta="q1", d=0, a="L1", alpha=0), RawRow(theta="q2", d=0, a=length, alpha=0))
    return read_table(RawTable(convention=Convention.STANDARD, rows=rows))


def shown(verdict) -> ET.Element:
    return ET.fromstring(f"<div>{verdict._repr_html_()}</div>")


def test_a_right_answer_shows_its_score_and_what_it_rests_on() -> None:
    root = shown(grade(read("L2"), read("L2"), Policy(), {"L1": 1, "L2": 0.5}))
    assert "".join(root.find("p").itertext()) == "✓ 1.00 (proved)"  # type: ignore[union-attr]


def test_a_wrong_answer_shows_its_rows_and_the_codes_of_its_feedback() -> None:
    verdict = grade(read("L2"), read("0"), Policy(), {"L1": 1, "L2": 0.5})
    root = shown(verdict)
    heads, *rows = [["".join(cell.itertext()) for cell in row] for row in root.iter("tr")]
    assert heads == ["row", "length", "twist", "offset", "joint"]
    assert rows == [["1", "✓", "✓", "✓", "✓"], ["2", "✓", "✓", "✓", "✓"]]  # the end alone is wrong
    assert len(verdict.links) == 2
    assert [code.text for code in root.iter("code")][: len(verdict.feedback)] == [
        item.code for item in verdict.feedback
    ]


def test_the_help_level_holds_here_as_well() -> None:
    hidden = grade(read("L2"), read("0"), Policy(), {"L1": 1, "L2": 0.5}, HelpLevel.VERDICT)
    assert "length_wrong" not in hidden._repr_html_()
