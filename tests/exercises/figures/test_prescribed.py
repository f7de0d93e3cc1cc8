"""What a policy prescribes stands in the figure; what the figure adds by itself agrees with the table."""

import math
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest

from exercises.definition import Exercise
from exercises.drawings import end_marks, figure_drawing, figure_geometry, figure_sentences
from exercises.errors import DefinitionError
from exercises.figures.skeleton import usual_dimensions
from exercises.figures.svg import split_name
from exercises.instance import generate
from exercises.loader import load_exercise
from exercises.selftest.checks import check
from tests.exercises.folders import TWO_LINKS, changed, folder
from tests.exercises.grading.written import read

RPPR = """
version = 1
[title]
en = "RPPR"
[reference]
convention = "standard"
angle_unit = "deg"
length_unit = "cm"
rows = [
  { theta = "q1", d = "H + 2*w", a = 0, alpha = 0 },
  { theta = 0, d = "q2", a = "-2*w", alpha = -90 },
  { theta = 0, d = "q3", a = 0.5, alpha = 0 },
  { theta = "q4", d = "w", a = "-w", alpha = 0 },
]
[parameters]
H.value = 60
w.value = 12
[[parts]]
kind = "table"
points = 60
[figure]
posture = [0, 40, 30, 0]
"""


def with_policy(root: Path, policy: str, text: str = TWO_LINKS, statement: str = "Two links.") -> Exercise:
    return load_exercise(
        folder(root, changed("[[parts]]", f"[policy]\n{policy}\n[[parts]]", text), statement=statement)
    )


def geometry(found: Exercise) -> dict[str, Any]:
    return figure_geometry(generate(found))


def words(found: Exercise) -> set[str]:
    """The names that are drawn."""
    root = ElementTree.fromstring(
        f'<svg xmlns="http://www.w3.org/2000/svg">{figure_drawing(generate(found)).elements}</svg>'
    )
    return {"".join(node.itertext()) for node in root.iter("{http://www.w3.org/2000/svg}text")}


def test_frames_that_are_prescribed_are_drawn_where_the_key_has_them(tmp_path: Path) -> None:
    posture = "\n[figure]\nposture = [90, 0]\nupright = { roll = 90, pitch = 0, yaw = 0 }\n"
    found = with_policy(tmp_path, 'base = "frame"\ntool = "frame"', TWO_LINKS + posture)
    base, tool = geometry(found)["frames"]
    assert (base["number"], tool["number"]) == (0, 2)
    assert base["origin"] == pytest.approx([0, 0, 0])
    assert (base["x"], base["y"], base["z"]) == ([1, 0, 0], [0, 0, 1], [0, -1, 0])
    assert tool["origin"] == pytest.approx([0, 0, 0.8])  # L1 + L2 along y0, which points up
    assert (tool["x"], tool["z"]) == (pytest.approx([0, 0, 1]), [0, -1, 0])
    assert {"x0", "y0", "z0", "x2", "y2", "z2"} <= words(found)
    told = [sentence.params for sentence in figure_sentences(generate(found)) if sentence.code == "frame"]
    assert [params["number"] for params in told] == [0, 2]
    assert (told[1]["place"], told[1]["x"]) == ("(0; 0; 0.8)", "(0; 0; 1)")


def test_frames_that_are_free_are_not_drawn(tmp_path: Path) -> None:
    found = with_policy(tmp_path, 'base = "origin"\ntool = "point"')
    assert geometry(found)["frames"] == []
    assert not {"x0", "z0", "x2", "z2"} & words(found)


def test_origins_that_are_prescribed_are_marked(tmp_path: Path) -> None:
    found = with_policy(tmp_path, 'base = "origin"\ntool = "point"')
    points = {point["name"]: point["at"] for point in geometry(found)["points"]}
    assert points == {"P": pytest.approx([0.8, 0, 0]), "O0": [0, 0, 0]}
    assert end_marks(found) == ("P",)


def test_only_the_mark_at_the_last_origin_is_the_tool_point(tmp_path: Path) -> None:
    figure = '\n[figure]\nmarks = ["S", "T"]\npoints.S = { frame = 1 }\n'
    figure += 'points.T = { from = "O1", by = ["L2", 0, 0] }\n'
    assert end_marks(with_policy(tmp_path, 'tool = "point"', TWO_LINKS + figure)) == ("T",)
    with pytest.raises(DefinitionError) as refused:
        with_policy(tmp_path, 'tool = "point"', TWO_LINKS + figure.replace(', "T"]', "]"))
    (fault,) = refused.value.faults
    slid = 'points.S = { from = "O4", by = [0, 0, "w"] }\nmarks = ["S"]\n'  # at another zero of joint 2
    assert end_marks(with_policy(tmp_path, 'tool = "point"', RPPR + slid)) == ("S",)
    assert (fault.code, fault.where[-2:], fault.params) == (
        "tool_point_unmarked",
        ("figure", "marks"),
        {"last": 2},
    )


def test_a_figure_that_is_to_show_the_zeros_stands_at_them(tmp_path: Path) -> None:
    posture = "\n[figure]\nposture = [0, 30]\n"
    with pytest.raises(DefinitionError) as refused:
        with_policy(tmp_path, 'zero = "figure"', TWO_LINKS + posture)
    (fault,) = refused.value.faults
    assert (fault.code, fault.where[-2:]) == ("posture_not_zero", ("figure", "posture"))
    with_policy(tmp_path, 'zero = "figure"', TWO_LINKS + posture.replace("30", "0"))


def test_a_dimension_is_named_as_its_length_is_written(tmp_path: Path) -> None:
    found = load_exercise(folder(tmp_path, RPPR, statement="An arm."))
    lengths = [
        (entry["name"], round(math.dist(entry["from"], entry["to"]), 6))
        for entry in geometry(found)["dimensions"]
    ]
    assert lengths == [("H + 2w", 0.84), ("2w", 0.24), ("0.5", 0.005), ("w", 0.12)]  # -w back: the same one
    assert {"H + 2w", "2w", "0.5", "w"} <= words(found)


@pytest.mark.parametrize(
    ("written", "name", "index"),
    [
        ("L1", "L", "1"),
        ("L_12", "L", "12"),
        ("L1_2", "L1", "2"),
        ("0.45", "0.45", ""),
        ("3L/4", "3L/4", ""),
        ("L1^2", "L1^2", ""),
        ("H + L2", "H + L2", ""),
    ],
)
def test_only_digits_behind_a_letter_are_an_index(written: str, name: str, index: str) -> None:
    """A length of 0.45 was drawn with its decimals as an index."""
    assert split_name(written) == (name, index)


@pytest.mark.parametrize(
    ("written", "name"),
    [("2*w", "2w"), ("L*pi", "L·pi"), ("L1*L2/L3", "L1·L2/L3"), ("L*3^(1/2)", "L·sqrt(3)")],
)
def test_a_dimension_runs_no_names_together(written: str, name: str) -> None:
    table = read("standard", [(0, written, 0, "q1")]).table
    assert [mark.name for mark in usual_dimensions(table)] == [name]


def test_the_ground_lies_at_frame_0_where_the_column_rises_from_it(tmp_path: Path) -> None:
    found = load_exercise(folder(tmp_path, RPPR, statement="An arm."))
    assert geometry(found)["ground"] == {"at": [0, 0, 0], "normal": [0, 0, 1]}
    assert (
        geometry(load_exercise(folder(tmp_path)))["ground"]["at"][2] < 0
    )  # O0 is inside the body of joint 1


def test_a_statement_may_name_joint_variables_axes_of_frames_and_weights(tmp_path: Path) -> None:
    statement = "Turn *q2* about *z1*; the link has mass *m*."
    part = """[[parts]]
kind = "equations_of_motion"
points = 10
ask = ["mass"]
gravity = [0, 0, 0]
links = [{ mass = 0 }, { mass = "m" }]
weights.m = { value = 2 }
"""
    text = TWO_LINKS[: TWO_LINKS.index("[[parts]]")] + part
    assert load_exercise(folder(tmp_path, text, statement=statement)).statements["en"] == statement
    for name in ("q3", "z3", "m"):
        with pytest.raises(DefinitionError) as refused:
            load_exercise(folder(tmp_path, statement=f"See *{name}*."))
        assert {fault.code for fault in refused.value.faults} == {"statement_name_unknown"}


def test_such_exercises_pass_their_own_tests(tmp_path: Path) -> None:
    found = with_policy(tmp_path, 'base = "frame"\ntool = "frame"', RPPR)
    assert not check(found, 1).failures
