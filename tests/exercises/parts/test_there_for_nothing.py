"""What the identity has right, and rows of zeros in a table, earn nothing in matrices."""

from pathlib import Path
from typing import Any

import pytest

from exercises.answers import RawAnswer, parse
from exercises.grader import grade
from exercises.instance import generate
from exercises.loader import load_exercise
from kinematics.cells import RawTable
from tests.exercises.answering import part, table
from tests.exercises.folders import TWO_LINKS, changed, folder

LINKS = TWO_LINKS[TWO_LINKS.index("\nrows") : TWO_LINKS.index("\n[[parts]]")]
ASKED = """
[[parts]]
kind = "table"
points = 10

[[parts]]
kind = "link_matrices"
points = 10

[[parts]]
kind = "transform"
points = 10

[[parts]]
kind = "pose"
points = 10
joints = {joints}
"""
WRIST = """
rows = [
  { joint = "revolute", theta = "q1", d = 0, a = 0, alpha = -90 },
  { joint = "revolute", theta = "q2", d = 0, a = 0, alpha = 90 },
  { joint = "revolute", theta = "q3", d = 0, a = 0, alpha = 0 },
]
"""
SLIDE = """
rows = [
  { joint = "prismatic", theta = 0, d = "q1", a = 0, alpha = 0 },
]
"""
ROWS = {"wrist": WRIST, "slide": SLIDE, "links": LINKS}
JOINTS = {"wrist": [30, 45, 60], "slide": [0.3], "links": [30, 45]}
TABLES = {
    "wrist": table("standard", (-90, 0, 0, "q1"), (90, 0, 0, "q2"), (0, 0, 0, "q3")),
    "slide": table("standard", (0, 0, "q1", 0)),
    "links": table("standard", (0, "L1", 0, "q1"), (0, "L2", 0, "q2")),
}
IDENTITY = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
ZEROS = [[0, 0, 0, 0], [0, 0, 0, 0], [0, 0, 0, 0], [0, 0, 0, 1]]
ORIGIN = [[0, 0, 0, 0]] * 4


def score(path: Path, robot: str, kind: str, answer: Any, own: RawTable | None = None) -> float:
    """What a part earns beside a right table."""
    text = changed(LINKS, ROWS[robot])
    text = changed('[[parts]]\nkind = "table"\npoints = 10\n', ASKED.format(joints=JOINTS[robot]), text)
    path = folder(path, text, statement="An arm.")
    instance = generate(load_exercise(path), None)
    given: Any = {"table": own or TABLES[robot], kind: answer}
    return part(grade(instance, parse(instance, RawAnswer(**given))), kind).score


@pytest.mark.parametrize("answer", [IDENTITY, ZEROS, ORIGIN])
@pytest.mark.parametrize("kind", ["transform", "pose"])
@pytest.mark.parametrize("robot", ["wrist", "slide"])
def test_what_the_identity_has_right_earns_nothing(
    tmp_path: Path, robot: str, kind: str, answer: Any
) -> None:
    assert score(tmp_path, robot, kind, answer) == 0.0


def test_half_of_a_matrix_still_counts(tmp_path: Path) -> None:
    turned = [["c12", "-s12", 0, "L1"], ["s12", "c12", 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    assert score(tmp_path, "links", "transform", turned) == 0.5


def test_a_matrix_needs_its_last_row(tmp_path: Path) -> None:
    right = [["c12", "-s12", 0, "L1 c1 + L2 c12"], ["s12", "c12", 0, "L1 s1 + L2 s12"], [0, 0, 1, 0]]
    assert score(tmp_path, "links", "transform", [*right, [0, 0, 0, 0]]) == 0.0


def links(*lengths: str) -> list[Any]:
    """The matrices of the two links with these lengths."""
    return [
        [[f"c{i}", f"-s{i}", 0, f"{a} c{i}"], [f"s{i}", f"c{i}", 0, f"{a} s{i}"], [0, 0, 1, 0], [0, 0, 0, 1]]
        for i, a in enumerate(lengths, 1)
    ]


@pytest.mark.parametrize(
    ("lengths", "earned"), [(("L2", "L1"), 0.0), (("L1", "L1"), 0.5), (("L1", "L2"), 1.0)]
)
def test_rows_of_zeros_change_nothing(tmp_path: Path, lengths: tuple[str, str], earned: float) -> None:
    """Sixty rows of zeros and their identities had nearly all of the marks."""
    rows = [(0, "L1", 0, "q1"), (0, "L2", 0, "q2")]
    padded = table("standard", *rows, *[(0, 0, 0, 0)] * 60)
    answer = [*links(*lengths), *[IDENTITY] * 60]
    assert score(tmp_path, "links", "link_matrices", answer, padded) == earned


def test_rows_that_move_to_and_fro_count_as_one(tmp_path: Path) -> None:
    rows = [(0, "L1", 0, "q1"), (0, "L2", 0, "q2")]
    padded = table("standard", *rows, *[(0, 0, 1, 0), (0, 0, -1, 0)] * 20)
    there = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 1], [0, 0, 0, 1]]
    back = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -1], [0, 0, 0, 1]]
    answer = [*links("L2", "L1"), *[there, back] * 20]
    assert score(tmp_path, "links", "link_matrices", answer, padded) == pytest.approx(1 / 3)
