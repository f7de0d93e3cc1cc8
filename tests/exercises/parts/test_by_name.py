"""Names in screws, frames and radii: wrong ones are wrong whatever values a student was given."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from exercises.answers import RawAnswer, parse
from exercises.errors import AnswerError
from exercises.grader import grade
from exercises.instance import generate
from exercises.loader import load_exercise
from exercises.parts.cells.by_name import read_by_name
from exercises.parts.cells.exactness import exactness
from exercises.parts.cells.short_forms import CELL_LIMITS
from exercises.parts.context import Context
from exercises.parts.forward.frames import FrameCells, FramesCells
from exercises.parts.forward.workspace import RadiiCells
from exercises.parts.motion.screws import ScrewsCells
from exercises.parts.protocol import Reading
from exercises.parts.registry import part_type
from exercises.parts.report import PartReport
from exercises.parts.rotations.frame_chain import FrameChainCells
from kinematics.answers.screw_answers import ScrewFrame, ScrewOrder
from kinematics.cells import ParameterKind
from kinematics.cells.entries import read_cell
from kinematics.expressions import evaluate
from kinematics.table import Convention
from tests.exercises.answering import codes, judged, part, table
from tests.exercises.folders import changed, folder
from tests.exercises.packaged import exercise

SEEDS = ("ana", "b2", "c3", "d4", None)


def screws(seed: str | None, first: str, reach: str) -> PartReport:
    """The SCARA stretched along x, with these lengths from joint 1 to joint 2 and to the tool."""
    rows: Any = (
        (0, 0, 0, 0, 0, 1),
        (0, f"-({first})", 0, 0, 0, 1),
        (0, 0, 1, 0, 0, 0),
        (0, f"-({reach})", 0, 0, 0, 1),
    )
    home = ((1, 0, 0, reach), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))
    cells = ScrewsCells(frame=ScrewFrame.SPACE, order=ScrewOrder.LINEAR_FIRST, screws=rows, home=home)
    return part(judged("scara-screws", seed=seed, screws=cells), "screws")


def frames(seed: str | None, first: Any, second: Any) -> PartReport:
    """The planar arm as its figure shows it, bent by 90°."""
    placed = (((0, 0, 0), (1, 0, 0)), ((first, 0, 0), (1, 0, 0)), ((first, second, 0), (0, 1, 0)))
    cells = tuple(FrameCells(origin=origin, x=x, z=(0, 0, 1)) for origin, x in placed)
    answer = FramesCells(convention=Convention.STANDARD, frames=cells)
    return part(judged("twolink-frames", seed=seed, frames=answer), "frames")


def radii(seed: str | None, inner: Any, outer: Any) -> PartReport:
    """The workspace of the SCARA."""
    return radii_of("scara", seed, inner, outer)


def radii_of(exercise_id: str, seed: str | None, inner: Any, outer: Any) -> PartReport:
    """A workspace."""
    return part(judged(exercise_id, seed=seed, workspace=RadiiCells(inner=inner, outer=outer)), "workspace")


def values(exercise_id: str, seed: str | None) -> list[float]:
    """The student's dimensions, by name."""
    return [value for _, value in sorted(generate(exercise(exercise_id), seed).parameters.items())]


@pytest.mark.parametrize("seed", SEEDS)
def test_right_names_and_right_numbers_are_right(seed: str | None) -> None:
    a2, a3 = values("scara-screws", seed)
    assert screws(seed, "a2", "a2+a3").correct
    assert screws(seed, f"{a2:.3f}", f"{a2 + a3:.3f}").correct
    assert screws(seed, "a2", f"{a2 + a3:.3f}").correct
    assert screws(seed, "1.000 a2", "a2+a3").correct
    one, two = values("twolink-frames", seed)
    assert frames(seed, "L1", "L2").correct
    assert frames(seed, f"{one:.3f}", f"{two:.3f}").correct
    assert frames(seed, "L1", f"{two:.3f}").correct
    assert radii(seed, "a2 - a3", "a2 + a3").correct
    assert radii(seed, "|a3 - a2|", "a2 + a3").correct


@pytest.mark.parametrize("seed", SEEDS)
def test_another_dimension_that_is_as_long_is_wrong(seed: str | None) -> None:
    a2, a3 = values("scara-screws", seed)
    assert not screws(seed, f"{a2 / a3!r}*a3", "a2+a3").correct
    assert not screws(seed, "1.005*a2", "1.005*a2+a3").correct
    one, two = values("twolink-frames", seed)
    wrong = frames(seed, f"{one / two!r}*L2", "L2")
    assert (wrong.correct, codes(wrong)[0]) == (False, "frame_origin_not_on_axis")
    assert wrong.score < 1.0
    assert not frames(seed, "1.004*L1", "L2").correct
    a2, a3 = values("scara", seed)
    assert codes(radii(seed, f"{(a2 - a3) / a3!r}*a3", "a2+a3")) == ["workspace_inner_wrong"]
    assert not radii(seed, "a2 - a3", f"{(a2 + a3) / a2!r}*a2").correct


@pytest.mark.parametrize("seed", SEEDS)
def test_a_radius_that_leaves_out_a_short_length_is_wrong(seed: str | None) -> None:
    """The wrist passes the elbow at a3: without it the arm is within a hundredth as long."""
    stretched, short = "a1 + a2 + sqrt(a3^2 + d4^2) + d6", "a1 + a2 + d4 + d6"
    assert codes(radii_of("dmra", seed, 0, stretched)) == ["workspace_right"]
    assert codes(radii_of("dmra", seed, 0, short)) == ["workspace_outer_wrong"]
    sums = [f"sqrt(d3^2 + (a2 {sign} sqrt(a3^2 + d4^2))^2)" for sign in "-+"]
    assert codes(radii_of("puma560", seed, *sums)) == ["workspace_right"]
    assert not radii_of("puma560", seed, sums[0], "sqrt(d3^2 + (a2 + d4)^2)").correct


def test_names_are_judged_at_the_students_lengths_where_the_key_has_no_others(tmp_path: Path) -> None:
    changed_key = changed('d = 0, a = "L1"', 'd = "sqrt(9*L2^2 - L1^2)", a = "L1"')
    text = changed('kind = "table"', 'kind = "screws"', changed_key).replace("L1.draw", "# L1.draw")
    instance = generate(load_exercise(folder(tmp_path, text.replace("L1.value = 0.5", "L1.value = 0.89"))))
    rows: Any = ((0, 0, 0, 0, 0, 1), (0, "-L1", 0, 0, 0, 1))
    home = ((1, 0, 0, "L1 + L2"), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))
    cells = ScrewsCells(frame=ScrewFrame.SPACE, order=ScrewOrder.LINEAR_FIRST, screws=rows, home=home)
    assert grade(instance, parse(instance, RawAnswer(screws=cells))).correct


def lengths_of(raw: RadiiCells) -> list[float]:
    """The radii with a2 = 0.5 and a3 = 0.25."""
    return [
        evaluate(read_cell(str(cell), ParameterKind.LENGTH), {"a2": 0.5, "a3": 0.25})
        for cell in (raw.inner, raw.outer)
    ]


@pytest.mark.parametrize(
    ("inner", "outer", "exact"),
    [
        ("a2 - a3", 2, 1e-6),
        ("0.5*a2", "1.25*a2", 1e-6),  # fractions of four are exact
        ("0.819*a2", "a2", 2 * 0.0005),
        ("0.8192*a2", "a2", 2 * 0.00005),
        ("0.866*a2", "a2", 2 * (0.75**0.5 - 0.866)),
        ("a2 - a3", "a2 + 0.004", 2 * 0.0005 / 0.504),
        ("0.82*a2", "a2 + 0.004", 2 * (0.005 * 0.5 + 0.0005) / 0.504),
        ("a2" + " + 0.001" * 70, "a2", 1.0),
    ],
)
def test_decimals_say_how_exact_an_answer_is(inner: str, outer: Any, exact: float) -> None:
    assert exactness(RadiiCells(inner=inner, outer=outer), lengths_of) == pytest.approx(exact, rel=1e-3)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_name_and_a_number_in_one_cell(seed: str | None) -> None:
    """What is off by the difference of two dimensions is right for nobody; a dimension's value may stand."""
    a2, a3 = values("scara-screws", seed)
    assert not screws(seed, f"a3 + {a2 - a3:.3f}", f"a2 + a3 + {0:.3f}").correct
    assert not screws(seed, f"a3 + {a2 - a3:.3f}", "a2 + a3").correct
    assert not screws(seed, "a2 + 0.004", "a2 + a3 + 0.004").correct
    assert not screws(seed, "0.5*a2 + 0.5*a2", "1.004*a2 + a3").correct
    assert screws(seed, "0.5*a2 + 0.5*a2", "a2 + a3").correct
    assert screws(seed, "a2", f"a2 + {a3:.3f}").correct
    one, two = values("twolink-frames", seed)
    assert not frames(seed, "L1 + 0.002", "L2").correct
    assert not frames(seed, f"L2 + {one - two:.3f}", "L2 + 0.002").correct
    a2, a3 = values("scara", seed)
    assert not radii(seed, f"a2 - {a3:.3f}", "1.004*a2 + a3").correct
    assert not radii(seed, "a2 - a3", "a2 + a3 + 0.004").correct
    assert not radii(seed, "a2 - a3 + 0.004", "a2 + a3").correct
    assert radii(seed, f"a2 - {a3:.3f}", "a2 + a3").correct


@pytest.mark.parametrize("cell", ["q1", "θ2"])
def test_a_joint_variable_in_a_radius_is_told_as_such(cell: str) -> None:
    with pytest.raises(AnswerError) as error:
        radii(None, cell, "a2 + a3")
    (fault,) = error.value.faults
    assert (fault.code, fault.where) == ("joint_variable_in_number", ("workspace", "inner"))


SCREW = ScrewsCells(
    frame=ScrewFrame.SPACE, order=ScrewOrder.LINEAR_FIRST, screws=((0.0, 0, 0, 0, 0, "1.0"),), home=()
)


@pytest.mark.parametrize(
    ("raw", "times"),
    [
        (RadiiCells(inner=0.1, outer="1.5"), 1),
        (RadiiCells(inner="0", outer="a2+a3"), 3),
        (SCREW, 1),  # what is chosen from a list is no name
        (replace(SCREW, screws=((0, "-a2", 0, 0, 0, 1),)), 3),
    ],
)
def test_only_an_answer_that_may_hold_names_is_read_at_other_lengths(raw: Any, times: int) -> None:
    instance = generate(exercise("scara"), "ana")
    here = Reading(instance=instance, raw=RawAnswer(), table=None, limits=CELL_LIMITS)
    lengths: list[float] = []

    def read(_: Any, at: Reading) -> list[float]:
        lengths.append(at.instance.parameters["a2"])
        return lengths[-1:]

    read_by_name(raw, here, read, lambda found: found)
    assert len(set(lengths)) == len(lengths) == times


def frame_chain(seed: str | None, name: str, off: str = "") -> PartReport:
    """Frame 6 of the Stanford arm in frame 3, its position as multiples of a dimension."""
    instance = generate(exercise("stanford-frame-chain"), seed)
    found = instance.exercise.part("frame_chain")
    assert found is not None
    nothing = parse(instance, RawAnswer(frame_chain=FrameChainCells(pose=np.eye(4).tolist())))
    context = Context(instance=instance, answer=nothing, verdict=None)
    right = np.array(part_type("frame_chain").right(found, context).pose, dtype=np.float64)
    pose: Any = right.tolist()
    for row, value in zip(pose, right[:3, 3] / instance.parameters[name], strict=False):
        row[3] = f"{value:.6f}*{name}{off}" if value else 0
    return part(
        judged("stanford-frame-chain", seed=seed, frame_chain=FrameChainCells(pose=pose)), "frame_chain"
    )


@pytest.mark.parametrize("seed", SEEDS)
def test_another_dimension_is_wrong_in_a_chain_of_frames(seed: str | None) -> None:
    assert frame_chain(seed, "L2").correct
    assert codes(frame_chain(seed, "L1"))[0] == "chain_wrong"
    assert not frame_chain(seed, "L2", " + 0.004").correct
    assert not frame_chain(seed, "L2", "*1.012").correct


def _planar(seed: str, first: str, second: str, **others: Any) -> PartReport:
    """⁰T₂ of the planar arm with these lengths."""
    rows = [
        ["c12", "-s12", 0, f"({first})*c1 + ({second})*c12"],
        ["s12", "c12", 0, f"({first})*s1 + ({second})*s12"],
        [0, 0, 1, 0],
        [0, 0, 0, 1],
    ]
    return part(judged("twolink", seed=seed, transform=rows, **others), "transform")


OWN_PLANAR = table("standard", (0, "L1", 0, "q1"), (0, "L2", 0, "q2"))
"""Seed 16 draws L1 = 0.8 and L2 = 0.7."""


@pytest.mark.parametrize("others", [{}, {"table": OWN_PLANAR}], ids=["alone", "beside a table"])
@pytest.mark.parametrize("first", ["L2 + 0.1", "L1 + 0.004", "1.5 - L2", "sqrt(L2^2 + 0.15)"])
def test_a_closed_form_with_a_wrong_name_and_a_number_is_wrong_where_they_agree(
    first: str, others: dict[str, Any]
) -> None:
    assert not _planar("16", first, "L2", **others).correct


@pytest.mark.parametrize("others", [{}, {"table": OWN_PLANAR}], ids=["alone", "beside a table"])
@pytest.mark.parametrize(
    ("first", "second"), [("0.8", "L2"), ("L1", "0.7"), ("0.80", "0.70"), ("1.0*L1", "L2"), ("L1", "1/2*1.4")]
)
def test_a_closed_form_with_one_length_by_name_and_one_in_numbers_is_right(
    first: str, second: str, others: dict[str, Any]
) -> None:
    assert _planar("16", first, second, **others).correct


def test_a_link_matrix_with_a_wrong_name_and_a_number_is_wrong_where_they_agree() -> None:
    def link(i: int, length: str) -> list[list[Any]]:
        column = f"({length})*c{i}", f"({length})*s{i}"
        return [
            [f"c{i}", f"-s{i}", 0, column[0]],
            [f"s{i}", f"c{i}", 0, column[1]],
            [0, 0, 1, 0],
            [0, 0, 0, 1],
        ]

    def right(first: str) -> bool:
        matrices = (link(1, first), link(2, "L2"))
        report = judged("twolink", seed="16", table=OWN_PLANAR, link_matrices=matrices)
        return part(report, "link_matrices").correct

    assert right("L1")
    assert right("0.8")
    assert not right("L2 + 0.1")
