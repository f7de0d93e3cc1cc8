"""The proof that two tables are the same robot: complete, sound, and honest about what it can't decide."""

import random
from dataclasses import replace
from fractions import Fraction

import pytest

from kinematics.expressions import (
    ONE,
    ZERO,
    Expression,
    Function,
    Parameter,
    add,
    call,
    negate,
    number,
    pi_times,
    power,
)
from kinematics.symbolic import ProofStatus, prove_identity
from kinematics.table import Convention, JointType
from tests.kinematics.symbolic.tables import (
    other_convention,
    random_angle,
    random_length,
    random_table,
    reparametrised,
    row,
    table,
    with_axis_turned,
)

L1, L2 = Parameter("L1"), Parameter("L2")
MOST_PRODUCTS = 40_000
"""Terms multiplied for one table; several times as many where what cancels piles up from joint to joint."""


def plain(n: int) -> dict[str, tuple[object, ...]]:
    return {"signs": (1,) * n, "offsets": (ZERO,) * n}


def matrix(*rows: tuple[Expression, ...]) -> tuple[tuple[Expression, ...], ...]:
    return (*rows, (ZERO, ZERO, ZERO, ONE))


@pytest.mark.parametrize("seed", range(150))
def test_every_rewriting_of_a_random_table_is_proved(seed: int) -> None:
    rng = random.Random(seed)
    joints = rng.randrange(1, 8)
    reference = random_table(rng, joints, fixed=rng.randrange(3))
    signs = [rng.choice([1, -1]) for _ in range(joints)]
    offsets = [
        random_angle(rng) if kind is JointType.REVOLUTE else random_length(rng)
        for kind in reference.joint_types
    ]
    submission = reparametrised(reference, signs, offsets)
    for _ in range(rng.randrange(3)):
        if submission.convention is Convention.STANDARD and rng.random() < 0.5:
            submission = with_axis_turned(submission, rng.randrange(len(submission.rows)))
        else:
            submission = other_convention(submission)
    proof = prove_identity(reference, submission, signs=signs, offsets=offsets, limit=MOST_PRODUCTS)
    assert (proof.verdict, proof.joint) == (ProofStatus.PROVED, 0)


@pytest.mark.parametrize("seed", range(150))
def test_one_changed_cell_is_refuted(seed: int) -> None:
    rng = random.Random(seed)
    reference = random_table(rng, 5)
    where, cell = rng.randrange(5), rng.choice(["a", "d", "alpha", "theta"])
    change = number("0.001") if cell in ("a", "d") else pi_times(Fraction(1, 180))
    rows = list(reference.rows)
    rows[where] = replace(rows[where], **{cell: add((getattr(rows[where], cell), change))})
    proof = prove_identity(reference, table(reference.convention, *rows), **plain(5))
    assert proof.verdict is ProofStatus.REFUTED


def test_base_and_tool_enter_exactly() -> None:
    reference = table(Convention.STANDARD, row(a=L1), row(a=L2))
    # frame 0 turned by a right angle, frame 2 moved back to the second joint
    turned = table(
        Convention.STANDARD,
        row(JointType.FIXED, theta=pi_times(Fraction(1, 2))),
        row(a=L1),
        row(),
    )
    base = matrix((ZERO, number(-1), ZERO, ZERO), (ONE, ZERO, ZERO, ZERO), (ZERO, ZERO, ONE, ZERO))
    tool = matrix((ONE, ZERO, ZERO, negate(L2)), (ZERO, ONE, ZERO, ZERO), (ZERO, ZERO, ONE, ZERO))
    assert prove_identity(reference, turned, **plain(2), base=base, tool=tool).verdict is ProofStatus.PROVED
    without_tool = prove_identity(reference, turned, **plain(2), base=base)
    assert (without_tool.verdict, without_tool.joint) == (ProofStatus.REFUTED, 0)
    assert prove_identity(reference, turned, **plain(2), tool=tool).verdict is ProofStatus.REFUTED


def test_the_first_joint_that_disagrees_is_named() -> None:
    reference = table(Convention.STANDARD, row(a=L1), row(a=L2, alpha=pi_times(Fraction(1, 2))), row())
    wrong = table(Convention.STANDARD, row(a=L1), row(a=L2, alpha=pi_times(Fraction(1, 3))), row())
    assert prove_identity(reference, wrong, **plain(3)).joint == 3


def test_another_number_or_type_of_joints_is_refuted() -> None:
    one, two = table(Convention.STANDARD, row()), table(Convention.STANDARD, row(), row())
    sliding = table(Convention.STANDARD, row(JointType.PRISMATIC))
    assert prove_identity(one, two, **plain(1)).verdict is ProofStatus.REFUTED
    assert prove_identity(one, sliding, **plain(1)).verdict is ProofStatus.REFUTED


def test_parallel_prismatic_axes_may_lie_anywhere() -> None:
    reference = table(Convention.STANDARD, row(JointType.PRISMATIC), row(JointType.FIXED, a=L1))
    shifted = table(Convention.STANDARD, row(JointType.FIXED, a=L1), row(JointType.PRISMATIC))
    assert prove_identity(reference, shifted, **plain(1)).verdict is ProofStatus.PROVED
    turning = table(Convention.STANDARD, row(), row(JointType.FIXED, a=L1))
    shifted = table(Convention.STANDARD, row(JointType.FIXED, a=L1), row())
    assert prove_identity(turning, shifted, **plain(1)).verdict is ProofStatus.REFUTED


@pytest.mark.parametrize(
    ("way", "turning", "sliding"),
    [("x", False, True), ("y", False, True), ("z", True, True)],
)
def test_an_axis_may_be_moved_along_itself_and_a_slider_anywhere(
    way: str, turning: bool, sliding: bool
) -> None:
    def shifted(by: Expression) -> tuple[tuple[Expression, ...], ...]:
        column = [by if way == each else ZERO for each in "xyz"]
        return matrix(
            *((*tuple(ONE if i == j else ZERO for j in range(3)), column[i]) for i in range(3)),
        )

    for joint, may in ((JointType.REVOLUTE, turning), (JointType.PRISMATIC, sliding)):
        one = table(Convention.STANDARD, row(joint))
        found = prove_identity(one, one, **plain(1), base=shifted(L1), tool=shifted(negate(L1)))
        assert found.verdict is (ProofStatus.PROVED if may else ProofStatus.REFUTED), joint


def test_square_roots_of_lengths_are_proved_when_equal_and_undecided_otherwise() -> None:
    hypotenuse = call(Function.SQRT, add((power(L1, 2), power(L2, 2))))
    angle = call(Function.ATAN2, L2, L1)
    bent = table(Convention.STANDARD, row(a=L1), row(JointType.FIXED, theta=pi_times(Fraction(1, 2)), a=L2))
    straight = table(
        Convention.STANDARD,
        row(theta=angle, a=hypotenuse),
        row(JointType.FIXED, theta=add((pi_times(Fraction(1, 2)), negate(angle)))),
    )
    assert prove_identity(bent, straight, **plain(1)).verdict is ProofStatus.PROVED
    near = table(Convention.STANDARD, *straight.rows[:1], row(JointType.FIXED))
    assert prove_identity(bent, near, **plain(1)).verdict is ProofStatus.UNDECIDED


def test_what_is_too_large_is_undecided() -> None:
    rows = [
        row(alpha=Parameter(f"alpha{i}"), theta=Parameter(f"beta{i}"), a=Parameter(f"L{i}")) for i in range(6)
    ]
    big = table(Convention.STANDARD, *rows)
    shifted = table(Convention.MODIFIED, *rows)
    assert prove_identity(big, shifted, **plain(6), limit=50).verdict is ProofStatus.UNDECIDED


@pytest.mark.parametrize("joint", [JointType.REVOLUTE, JointType.PRISMATIC])
@pytest.mark.parametrize("entry", [(i, j) for i in range(3) for j in range(4)], ids=str)
def test_a_base_that_differs_in_one_entry_alone_is_refuted_where_it_tells(
    joint: JointType, entry: tuple[int, int]
) -> None:
    """At the joint if its axis, or the direction of a slider, is not kept; else where the end is compared."""
    base = [[number(int(i == j)) for j in range(4)] for i in range(4)]
    base[entry[0]][entry[1]] = add((base[entry[0]][entry[1]], number("0.001")))
    one = table(Convention.STANDARD, row(joint))
    proof = prove_identity(one, one, signs=[1], offsets=[ZERO], base=base)
    slides = joint is JointType.PRISMATIC
    tells = entry[1] == 2 if slides else entry not in {(2, 2), (2, 3)}
    assert (proof.verdict, proof.joint) == (ProofStatus.REFUTED, int(tells))
