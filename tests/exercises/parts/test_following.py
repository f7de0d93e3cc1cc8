"""What follows from a wrong table earns its points, unless the table says next to nothing."""

import pytest

from exercises import grader
from exercises.parts.report import Credit
from tests.exercises.answering import codes, judged, part, table

TURNS = [
    [[f"cos(q{i})", f"-sin(q{i})", 0, 0], [f"sin(q{i})", f"cos(q{i})", 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    for i in (1, 2)
]
TURN = [["c12", "-s12", 0, 0], ["s12", "c12", 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
IDENTITY = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]


def test_nothing_follows_from_a_table_of_zeros() -> None:
    """Every matrix is a turn about z."""
    zeros = table("standard", (0, 0, 0, "q1"), (0, 0, 0, "q2"))
    report = judged("twolink", table=zeros, link_matrices=TURNS, transform=TURN)
    assert report.points == 0.0
    for kind in ("link_matrices", "transform"):
        found = part(report, kind)
        assert (found.score, found.credit, codes(found)) == (0.0, Credit.NONE, ["table_says_little"])


def test_a_position_at_the_origin_is_none_of_the_robot() -> None:
    """Zeros and an identity had half of the marks of ⁰T."""
    zeros = table("standard", (0, 0, 0, "q1"), (0, 0, 0, "q2"))
    assert part(judged("twolink", table=zeros, transform=IDENTITY), "transform").score == 0.0


def test_from_half_of_the_lengths_and_twists_all_follows() -> None:
    """Of two lengths one is missing."""
    half = table("standard", (0, "L1", 0, "q1"), (0, 0, 0, "q2"))
    first = [["c1", "-s1", 0, "L1*c1"], ["s1", "c1", 0, "L1*s1"], [0, 0, 1, 0], [0, 0, 0, 1]]
    found = part(judged("twolink", table=half, link_matrices=[first, TURNS[1]]), "link_matrices")
    assert (found.score, found.credit, codes(found)) == (1.0, Credit.OWN_TABLE, ["matrices_follow_table"])


@pytest.mark.parametrize(
    ("lengths", "score"), [((0, 0, 0), 0.0), (("d1", 0, 0), 0.2), (("d1", "a1", "a2"), 0.6)]
)
def test_less_than_half_earns_in_proportion(lengths: tuple[object, ...], score: float) -> None:
    """The table of the desktop arm has four twists and six lengths."""
    d1, a1, a2 = lengths
    rows = [(0, a1, d1, "q1"), (0, a2, 0, "q2"), *((0, 0, 0, f"q{i}") for i in (3, 4, 5, 6))]
    links = [
        [
            [f"c{i}", f"-s{i}", 0, f"{a}*c{i}"],
            [f"s{i}", f"c{i}", 0, f"{a}*s{i}"],
            [0, 0, 1, d],
            [0, 0, 0, 1],
        ]
        for i, (_, a, d, _) in enumerate(rows, start=1)
    ]
    report = judged("dmra", table=table("standard", *rows), link_matrices=links)
    assert part(report, "link_matrices").score == pytest.approx(score)


def test_the_pose_of_a_matrix_without_the_joints_is_no_achievement() -> None:
    assert part(judged("twolink", transform=IDENTITY, pose=IDENTITY), "pose").score == 0.0


def test_a_table_alone_is_not_asked_how_much_follows_from_it(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[object] = []
    monkeypatch.setattr(grader, "as_it_follows", lambda report, share: asked.append(share) or report)
    half = table("standard", (0, "L1", 0, "q1"), (0, 0, 0, "q2"))
    judged("twolink", table=half)
    assert asked == []
    first = [["c1", "-s1", 0, "L1*c1"], ["s1", "c1", 0, "L1*s1"], [0, 0, 1, 0], [0, 0, 0, 1]]
    judged("twolink", table=half, link_matrices=[first, TURNS[1]])
    assert asked == [1.0]
