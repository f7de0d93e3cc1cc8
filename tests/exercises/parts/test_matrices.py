"""Link matrices and ⁰T_N: right, wrong in every known way, and right only for a wrong table."""

from pathlib import Path
from typing import Any

import pytest

from exercises.answers import RawAnswer, parse
from exercises.errors import AnswerError
from exercises.grader import grade
from exercises.grading import Finding, HelpLevel
from exercises.instance import generate
from exercises.loader import load_exercise
from exercises.parts.cells.matrix_cells import read_functions, read_matrix
from exercises.parts.motion.singularity_cells import SingularityCells
from exercises.parts.report import Credit
from kinematics.cells import AngleUnit
from kinematics.errors import CellError, Fault
from kinematics.table import JointType
from tests.exercises.answering import (
    SCARA,
    SCARA_MATRICES,
    SCARA_TRANSFORM,
    codes,
    edited,
    judged,
    part,
    table,
)
from tests.exercises.folders import changed, folder, with_part
from tests.exercises.packaged import exercise

WRONG = table("standard", (0, "a3", 0, "q1"), (180, "a2", 0, "q2"), (0, 0, "q3", 0), (0, 0, 0, "q4"))
"""a2 and a3 have changed places."""
WRONG_MATRICES = tuple(
    [[str(cell).replace("a2", "A").replace("a3", "a2").replace("A", "a3") for cell in row] for row in matrix]
    for matrix in SCARA_MATRICES
)
WRONG_TRANSFORM = [
    [str(cell).replace("a2", "A").replace("a3", "a2").replace("A", "a3") for cell in row]
    for row in SCARA_TRANSFORM
]


def matrices(*given: Any) -> list[Any]:
    return [*given, *SCARA_MATRICES[len(given) :]]


def test_right_matrices_in_many_notations() -> None:
    report = part(judged("scara", table=SCARA, link_matrices=SCARA_MATRICES), "link_matrices")
    assert (report.correct, report.score, report.credit) == (True, 1.0, Credit.KEY)
    assert codes(report) == ["matrices_right"]


def test_matrices_of_a_table_without_a_joint_are_judged() -> None:
    fixed = table("standard", (0, "a3", 0, 0), (180, "a2", 0, 0), (0, 0, 0, 0), (0, 0, 0, 0))
    identity = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    first = [[1, 0, 0, "a3"], *identity[1:]]
    second = [[1, 0, 0, "a2"], [0, -1, 0, 0], [0, 0, -1, 0], [0, 0, 0, 1]]
    report = judged("scara", table=fixed, link_matrices=[first, second, identity, identity])
    links = part(report, "link_matrices")
    assert (links.correct, links.score, links.credit) == (False, 1.0, Credit.OWN_TABLE)


def test_matrices_of_a_wrong_table_earn_their_marks() -> None:
    report = judged("scara", table=WRONG, link_matrices=WRONG_MATRICES, transform=WRONG_TRANSFORM)
    assert not part(report, "table").correct
    links, transform = part(report, "link_matrices"), part(report, "transform")
    assert (links.correct, links.score, links.credit) == (False, 1.0, Credit.OWN_TABLE)
    assert (transform.correct, transform.score, transform.credit) == (False, 1.0, Credit.OWN_TABLE)
    assert codes(links) == ["matrices_follow_table"]
    assert codes(transform) == ["transform_follows_table"]


def test_right_matrices_beside_a_wrong_table_are_right() -> None:
    report = judged("scara", table=WRONG, link_matrices=SCARA_MATRICES, transform=SCARA_TRANSFORM)
    links, transform = part(report, "link_matrices"), part(report, "transform")
    assert (links.correct, links.credit, codes(links)) == (
        True,
        Credit.KEY,
        ["matrices_right_not_from_table"],
    )
    assert (transform.correct, codes(transform)) == (True, ["transform_right_not_from_table"])


def test_matrices_without_a_table_are_judged_by_their_product() -> None:
    assert part(judged("scara", link_matrices=SCARA_MATRICES), "link_matrices").correct
    assert part(judged("scara", transform=SCARA_TRANSFORM), "transform").correct
    wrong = part(judged("scara", link_matrices=WRONG_MATRICES), "link_matrices")
    assert (wrong.score, codes(wrong)) == (0.0, ["matrices_product_wrong"])
    assert codes(part(judged("scara", transform=WRONG_TRANSFORM), "transform")) == ["transform_wrong"]


def test_a_transform_from_other_frames_is_right_without_a_table() -> None:
    turned = [
        ["sin(q1 + q2 - q4)", "-cos(q1 + q2 - q4)", 0, "0.5 + a2*s1 + a3*s12"],
        ["-cos(q1 + q2 - q4)", "-sin(q1 + q2 - q4)", 0, "-a2*c1 - a3*c12"],
        [0, 0, -1, "1 - q3"],
        [0, 0, 0, 1],
    ]
    assert part(judged("scara", transform=turned), "transform").correct


def test_equal_dimensions_are_told_apart_by_name() -> None:
    """RX-90: D3 and RL4 are both 0.45 m."""
    rows = ((0, 0, 0, "q1"), (90, 0, 0, "q2"), (0, "D3", 0, "q3"), (-90, 0, "RL4", "q4"), (90, 0, 0, "q5"))
    rx90 = table("modified", *rows, (-90, 0, 0, "q6"))
    right = [["c3", "-s3", 0, "D3"], ["s3", "c3", 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    given = [None, None, right, None, None, None]
    assert part(judged("rx90", table=rx90, link_matrices=given), "link_matrices").score == pytest.approx(
        1 / 6
    )
    given[2] = edited(right, 0, 3, "RL4")
    assert part(judged("rx90", table=rx90, link_matrices=given), "link_matrices").score == 0.0
    given[2] = edited(right, 0, 3, 0.45)  # a number is as good as its name
    assert part(judged("rx90", table=rx90, link_matrices=given), "link_matrices").score > 0


@pytest.mark.parametrize(
    ("first", "code"),
    [
        ([["c1", "-s1", 0, "-a2*c1"], *SCARA_MATRICES[0][1:]], "matrix_cells_wrong"),
        ([["c1", "s1", 0, "-a2"], ["-s1", "c1", 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], "matrix_inverse"),
        (
            [["c1", "s1", 0, "a2*c1"], ["-s1", "c1", 0, "a2*s1"], [0, 0, 1, 0], [0, 0, 0, 1]],
            "matrix_rotation_transposed",
        ),
        ([["c1", "-s1", 0, "a2"], ["s1", "c1", 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], "matrix_other_convention"),
        ([[1, 0, 0, "a2"], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], "matrix_without_variable"),
        (SCARA_MATRICES[3], "matrix_of_other_row"),
        ([["2*c1", "-s1", 0, "a2*c1"], *SCARA_MATRICES[0][1:]], "matrix_not_rigid"),
        ([*SCARA_MATRICES[0][:3], [0, 0, 0, 2]], "matrix_not_rigid"),
        ([["sqrt(-1 - c1^2)", "-s1", 0, "a2*c1"], *SCARA_MATRICES[0][1:]], "matrix_cells_wrong"),
    ],
)
def test_a_wrong_matrix_is_explained(first: Any, code: str) -> None:
    report = part(judged("scara", table=SCARA, link_matrices=matrices(first)), "link_matrices")
    assert report.score == 0.75
    assert codes(report) == [code]
    assert report.facts[0].finding is Finding.WRONG


def test_a_missing_matrix_costs_its_share() -> None:
    report = part(judged("scara", table=SCARA, link_matrices=matrices(None)), "link_matrices")
    assert (report.score, codes(report)) == (0.75, ["matrix_missing"])
    assert report.facts[0].finding is Finding.MISSING


@pytest.mark.parametrize(
    ("level", "told", "shows_cells"),
    [
        (HelpLevel.VERDICT, ["part_wrong"], False),
        (HelpLevel.ROW, ["matrix_wrong"], True),
        (HelpLevel.KIND, ["matrix_cells_wrong"], True),
        (HelpLevel.REPAIR, ["matrix_inverse"], True),
    ],
)
def test_help_levels_of_matrices(level: HelpLevel, told: list[str], shows_cells: bool) -> None:
    inverse = [["c1", "s1", 0, "-a2"], ["-s1", "c1", 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    report = part(
        judged("scara", table=SCARA, link_matrices=matrices(inverse), help_level=level), "link_matrices"
    )
    assert codes(report) == told
    assert bool(report.facts) is shows_cells


@pytest.mark.parametrize(
    ("wrong", "code", "score"),
    [
        (edited(SCARA_TRANSFORM, 0, 3, "a2*c1"), "transform_cells_wrong", 0.5),
        (edited(SCARA_TRANSFORM, 0, 0, "-cos(q1 + q2 - q4)"), "transform_not_rigid", 0.5),
        (
            [
                ["cos(q1+q2-q4)", "sin(q1+q2-q4)", 0, "-a2*cos(q2-q4) - a3*c4"],
                ["sin(q1+q2-q4)", "-cos(q1+q2-q4)", 0, "-a2*sin(q2-q4) + a3*s4"],
                [0, 0, -1, "-q3"],
                [0, 0, 0, 1],
            ],
            "transform_inverse",
            0.5,  # the rotation of this one is its own inverse
        ),
        (
            [["c1", "-s1", 0, "a2*c1"], ["s1", "c1", 0, "a2*s1"], [0, 0, 1, 0], [0, 0, 0, 1]],
            "transform_links_missing",
            0.0,
        ),
    ],
)
def test_a_wrong_transform_is_explained(wrong: Any, code: str, score: float) -> None:
    report = part(judged("scara", table=SCARA, transform=wrong), "transform")
    assert (report.score, codes(report)[0]) == (score, code)
    assert ("transform_rotation_right" in codes(report)) is (score == 0.5 and code != "transform_not_rigid")


def test_reversed_order_and_transposition_are_told() -> None:
    two = table("standard", (0, "L1", 0, "q1"), (0, "L2", 0, "q2"))
    backwards = [
        ["c12", "-s12", 0, "L2*c2 + L1*c12"],
        ["s12", "c12", 0, "L2*s2 + L1*s12"],
        [0, 0, 1, 0],
        [0, 0, 0, 1],
    ]
    assert (
        codes(part(judged("twolink", table=two, transform=backwards), "transform"))[0]
        == "transform_order_reversed"
    )
    transposed = [
        ["c12", "s12", 0, "L1*c1 + L2*c12"],
        ["-s12", "c12", 0, "L1*s1 + L2*s12"],
        [0, 0, 1, 0],
        [0, 0, 0, 1],
    ]
    assert codes(part(judged("twolink", table=two, transform=transposed), "transform"))[0] == (
        "transform_rotation_transposed"
    )


def test_units_of_the_table_are_units_of_the_matrices() -> None:
    rows = ((-90, 45, 75, "q1"), (0, 115, 0, "q2"), (-90, 20, 0, "q3"), (90, 0, 130, "q4"), (-90, 0, 0, "q5"))
    dmra = table("standard", *rows, (0, 0, 50, "q6"), length="mm")
    first = [["c1", 0, "-s1", "45*c1"], ["s1", 0, "c1", "45*s1"], [0, -1, 0, 75], [0, 0, 0, 1]]
    named = [["c1", 0, "-s1", "a1*c1"], ["s1", 0, "c1", "a1*s1"], [0, -1, 0, "d1"], [0, 0, 0, 1]]
    for matrix in (first, named):
        report = judged("dmra", table=dmra, link_matrices=[matrix, None, None, None, None, None])
        assert part(report, "link_matrices").facts[0].finding is Finding.OK


@pytest.mark.parametrize(
    "entry",
    ["c1 (a2 + a3 c2)", "c1(a2 + a3 c2)", "C_1 (a2 + a3 c2)", "c_{1}(a2 + a3 c(q2))", "cθ1 (a2 + a3 cθ2)"],
)
def test_a_short_form_before_a_bracket_is_a_factor(entry: str) -> None:
    types = (JointType.REVOLUTE, JointType.REVOLUTE)
    (read,) = read_functions([entry], types, AngleUnit.RAD, ("row",))
    (same,) = read_functions(["c1*(a2 + a3*cos(q2))"], types, AngleUnit.RAD, ("row",))
    assert not isinstance(read, Fault)
    assert not isinstance(same, Fault)
    assert read.expression == same.expression


@pytest.mark.parametrize(
    "entry",
    [
        "cθ₁",
        "Cθ₁",
        "cϑ_1",
        "cθ_{1}",
        "c\\theta_1",
        "c_{θ1}",
        "c_{θ₁}",
        r"c_{\theta_1}",
        r"c_{\theta_{1}}",
        "cq1",
        "cq₁",
        "c_{q_1}",
    ],
)
def test_a_short_form_may_name_its_variable(entry: str) -> None:
    types = (JointType.REVOLUTE, JointType.REVOLUTE)
    (read,) = read_functions([f"a2*{entry}*cθ₂ - 1"], types, AngleUnit.RAD, ("row",))
    (same,) = read_functions(["a2*cos(q1)*cos(q2) - 1"], types, AngleUnit.RAD, ("row",))
    assert not isinstance(read, Fault)
    assert not isinstance(same, Fault)
    assert read.expression == same.expression


@pytest.mark.parametrize(
    ("entry", "column"), [("c1(a2 + ?)", 9), ("c1 (a2 + ?)", 10), ("C(q1) s2(?)", 10), ("c1(c(q2) ?)", 10)]
)
def test_a_fault_is_found_where_it_was_typed(entry: str, column: int) -> None:
    (fault,) = read_functions([entry], (JointType.REVOLUTE,) * 2, AngleUnit.RAD, ("row",))
    assert isinstance(fault, Fault)
    assert fault.params["column"] == column


@pytest.mark.parametrize("entry", [{}, [], {"a": 1}, None, True])
def test_what_is_no_cell_is_refused_at_its_place(entry: Any) -> None:
    with pytest.raises(CellError) as refused:
        read_matrix([[1, 0, 0, 0], [0, 1, entry, 0], [0, 0, 1, 0], [0, 0, 0, 1]], (), AngleUnit.RAD, ("m",))
    assert [(fault.code, fault.where) for fault in refused.value.faults] == [
        ("cell_not_a_value", ("m", 1, 2))
    ]
    (fault,) = read_functions([entry], (), AngleUnit.RAD, ("row",))
    assert isinstance(fault, Fault)
    assert (fault.code, fault.where) == ("cell_not_a_value", ("row", 0))


def test_names_are_exact_where_values_are_equal() -> None:
    """Both links are 1 m long; a closed form that takes one name for the other is wrong all the same."""
    mistaken = table("standard", (0, "L1", 0, "q1"), (0, "L1", 0, "q2"))
    form = [
        ["c12", "-s12", 0, "L1*c1 + L1*c12"],
        ["s12", "c12", 0, "L1*s1 + L1*s12"],
        [0, 0, 1, 0],
        [0, 0, 0, 1],
    ]
    beside = part(judged("twolink", table=mistaken, transform=form), "transform")
    assert (beside.correct, codes(beside)) == (False, ["transform_follows_table"])
    assert codes(part(judged("twolink", transform=form), "transform")) == ["transform_wrong"]
    right = [[str(cell).replace("L1*c12", "L2*c12").replace("L1*s12", "L2*s12") for cell in r] for r in form]
    assert part(judged("twolink", transform=right), "transform").correct
    numbers = [[str(cell).replace("L1", "1") for cell in row] for row in form]
    assert part(judged("twolink", transform=numbers), "transform").correct


RAISED = "sqrt(1.1*L2^2 - L1^2)"
"""Has a value where both links are 1 m long, and none where the first one is much longer."""


def test_a_table_that_holds_for_some_lengths_only_is_judged_where_it_does() -> None:
    own = table("standard", (0, "L1", RAISED, "q1"), (0, "L2", 0, "q2"))
    first = [["c1", "-s1", 0, "L1*c1"], ["s1", "c1", 0, "L1*s1"], [0, 0, 1, RAISED], [0, 0, 0, 1]]
    second = [["c2", "-s2", 0, "L2*c2"], ["s2", "c2", 0, "L2*s2"], [0, 0, 1, 0], [0, 0, 0, 1]]
    form = [
        ["c12", "-s12", 0, "L1*c1 + L2*c12"],
        ["s12", "c12", 0, "L1*s1 + L2*s12"],
        [0, 0, 1, RAISED],
        [0, 0, 0, 1],
    ]
    report = judged("twolink", table=own, link_matrices=[first, second], transform=form)
    assert codes(part(report, "link_matrices")) == ["matrices_right"]
    assert codes(part(report, "transform")) == ["transform_right"]
    doubled = [[*first[:2], [0, 0, 1, f"2*{RAISED}"], first[3]], second]
    wrong = part(judged("twolink", table=own, link_matrices=doubled), "link_matrices")
    assert (wrong.score, codes(wrong)) == (0.5, ["matrix_cells_wrong"])


def test_a_key_that_holds_for_some_lengths_only_is_no_trouble(tmp_path: Path) -> None:
    raised = changed('d = 0, a = "L1"', 'd = "sqrt(L1^2 - 2.5*L2^2)", a = "L1"')
    asked = load_exercise(
        folder(tmp_path, with_part('kind = "transform"\npoints = 5', raised.replace("L1.draw", "# L1.draw")))
    )
    instance = generate(asked, None)
    form = [
        ["c12", "-s12", 0, "L1*c1 + L2*c12"],
        ["s12", "c12", 0, "L1*s1 + L2*s12"],
        [0, 0, 1, "sqrt(L1^2 - 2.5*L2^2)"],
        [0, 0, 0, 1],
    ]
    report = grade(instance, parse(instance, RawAnswer(transform=form)))
    assert codes(part(report, "transform")) == ["transform_right"]


def test_a_cell_without_a_value_is_named_not_called_no_rigid_motion() -> None:
    undefined = matrices([*SCARA_MATRICES[0][:2], [0, 0, 1, "sqrt(a3 - 2*a2)"], SCARA_MATRICES[0][3]])
    report = judged("scara", table=SCARA, link_matrices=undefined, transform=undefined[0])
    assert codes(part(report, "link_matrices")) == ["matrix_cells_wrong"]
    assert codes(part(report, "transform"))[0] == "transform_cells_wrong"


def test_cells_that_were_read_before_are_the_same_ones_again() -> None:
    """What is known of them is then not computed again for everybody who writes the same."""
    instance = generate(exercise("scara"), "1")
    one, other = (
        parse(instance, RawAnswer(transform=SCARA_TRANSFORM)).parts["transform"].entries for _ in range(2)
    )
    assert all(a is b for row, again in zip(one, other, strict=True) for a, b in zip(row, again, strict=True))


@pytest.mark.parametrize("entry", ["0*foo", "foo - foo", "foo^0 - 1", "sin(foo - foo)"])
def test_a_name_that_makes_no_difference_is_no_less_unknown(entry: str) -> None:
    transform = [[*SCARA_TRANSFORM[0][:2], entry, SCARA_TRANSFORM[0][3]], *SCARA_TRANSFORM[1:]]
    with pytest.raises(AnswerError) as refused:
        judged("scara", transform=transform)
    (fault,) = refused.value.faults
    assert (fault.code, fault.where, fault.params["name"]) == ("name_unknown", ("transform", 0, 2), "foo")
    known = [[entry.replace("foo", "a2") if cell is entry else cell for cell in row] for row in transform]
    assert part(judged("scara", transform=known), "transform").correct


@pytest.mark.parametrize("condition", ["sin(q2) + 0*foo", "sin(q2) = foo - foo", "q2 = k*pi + 0*foo"])
def test_a_name_that_makes_no_difference_is_unknown_in_conditions(condition: str) -> None:
    with pytest.raises(AnswerError) as refused:
        judged("twolink-singularities", singularities=SingularityCells(conditions=((condition,),)))
    assert [fault.code for fault in refused.value.faults] == ["name_unknown"]


@pytest.mark.parametrize(
    ("conditions", "right"),
    [
        (("q2 ∈ {0, π}",), True),
        (("q2 \\in \\{0, \\pi\\}",), True),
        (("q2 ∈ {0; 180°} (k ∈ Z)",), True),
        (("q2 ∈ {0, π/2}",), False),
        (("q2 ∈ {0}",), False),
    ],
)
def test_the_values_of_an_angle_may_be_a_set(conditions: tuple[str, ...], right: bool) -> None:
    cells = SingularityCells(conditions=(conditions,), lost=(1, 0, 0))
    report = part(judged("twolink-singularities", singularities=cells), "singularities")
    told = {entry.code for entry in report.feedback}
    assert (not told & {"singularities_missing", "singularity_invented"}) is right


@pytest.mark.parametrize(
    ("x", "right"),
    [
        ("1.002*a2*c1 + a3*c12", False),
        ("(a2 + 0.002)*c1 + a3*c12", False),
        ("(a2 + 1/500)*c1 + a3*c12", False),
        ("3*0.3333*a2*c1 + a3*c12", True),
        ("1.0*a2*c1 + a3*c12", True),
    ],
)
def test_names_in_a_transform_are_as_exact_as_the_decimals_beside_them(x: str, right: bool) -> None:
    given = edited(SCARA_TRANSFORM, 0, 3, x)
    assert part(judged("scara", table=SCARA, transform=given), "transform").correct is right
    assert part(judged("scara", transform=given), "transform").correct is right


def test_names_in_a_link_matrix_are_exact() -> None:
    given = matrices(edited(SCARA_MATRICES[0], 0, 3, "1.003*a2*c1"))
    assert not part(judged("scara", table=SCARA, link_matrices=given), "link_matrices").correct
