"""Minors and their factors, against determinants of Jacobians in numbers."""

from fractions import Fraction

import numpy as np
import pytest

from kinematics import catalogue
from kinematics.chain import chain_of_table
from kinematics.expressions import (
    ZERO,
    Function,
    JointVariable,
    Parameter,
    call,
    evaluate,
    multiply,
    number,
    pi_times,
)
from kinematics.symbolic import determinants
from kinematics.symbolic.determinants import MotionRows, largest_minor, minor_factors
from kinematics.symbolic.elements import Form
from kinematics.symbolic.ring import Ring
from kinematics.table import Convention, DHTable, JointType, SymbolicTable, bind
from tests.kinematics.symbolic.tables import row

TWIST, TRANSLATION = MotionRows.TWIST, MotionRows.TRANSLATION
CASES = [
    *(("scara", TWIST), ("stanford", TWIST), ("rx90", TWIST), ("puma560", TWIST), ("kr125", TWIST)),
    *(("twolink", TRANSLATION), ("onelink", TRANSLATION)),
]


def arm(name: str) -> tuple[SymbolicTable, dict[str, float]]:
    listed = catalogue.robot(name)
    return listed.table.table, dict(listed.parameters)


def moving_rows(
    table: SymbolicTable, values: dict[str, float], rows: MotionRows, q: np.ndarray
) -> np.ndarray:
    """The Jacobian without the rows that vanish for all q."""
    chain = chain_of_table(bind(table, values))
    height = 6 if rows is TWIST else 3
    ever = np.abs([chain.jacobian(q + step)[:height] for step in np.linspace(0, 1, 7)]).max(axis=(0, 2))
    return chain.jacobian(q)[:height][ever > 1e-9]


def draws(table: SymbolicTable, count: int = 6) -> list[np.ndarray]:
    rng = np.random.default_rng(11)
    return [rng.uniform(0.2, 1.4, table.n_joints) for _ in range(count)]


def test_of_two_joints_on_one_axis_one_is_lost() -> None:
    """Three parallel axes, two of them one: turning and moving across are left, with the arm L1 between."""
    rows = (row(), row(a=Parameter("L1")), row(a=Parameter("L2")))
    minor, only = largest_minor(DHTable(convention=Convention.STANDARD, rows=rows), TWIST)
    assert minor.exact
    assert not only
    found = [evaluate(minor.expression(), {"L1": each, "L2": 0.4}, [0.5, 0.6, 0.7]) for each in (0.1, 0.3)]
    assert found[1] / found[0] == pytest.approx(3.0)


def test_a_slider_has_no_rows_of_rotation() -> None:
    """Lifted and turned: both moves are always there, and nothing moves without a joint."""
    lift, turn = row(JointType.PRISMATIC, a=Parameter("L1")), row(a=Parameter("L2"))
    table = DHTable(convention=Convention.STANDARD, rows=(lift, turn))
    for order in (table, DHTable(convention=Convention.STANDARD, rows=(turn, lift))):
        minor, _ = largest_minor(order, TWIST)
        assert minor.exact
        assert abs(evaluate(minor.expression(), {"L1": 0.3, "L2": 0.4}, [0.5, 0.5])) == pytest.approx(1.0)
    still = DHTable(convention=Convention.STANDARD, rows=(row(JointType.FIXED, a=Parameter("L1")),))
    turned = DHTable(convention=Convention.STANDARD, rows=(row(), row(alpha=pi_times(Fraction(1, 2)))))
    for nothing, rows in ((still, TWIST), (turned, TRANSLATION)):
        minor, only = largest_minor(nothing, rows)
        assert (minor.terms, minor.exact, only) == (frozenset(), True, True)


@pytest.mark.parametrize(("name", "rows"), [case for case in CASES if case[0] != "onelink"])
def test_the_only_minor_is_the_determinant(name: str, rows: MotionRows) -> None:
    table, values = arm(name)
    minor, only = largest_minor(table, rows)
    assert only
    assert minor.exact
    expression = minor.expression()
    found = [evaluate(expression, values, q.tolist()) for q in draws(table)]
    expected = [np.linalg.det(moving_rows(table, values, rows, q)) for q in draws(table)]
    assert np.allclose(np.abs(found), np.abs(expected), rtol=1e-9)
    assert len({np.sign(a * b) for a, b in zip(found, expected, strict=True)}) == 1


@pytest.mark.parametrize(("name", "rows"), CASES)
def test_factors_vanish_where_the_minor_does(name: str, rows: MotionRows) -> None:
    """Along lines through the joint space: where a factor changes its sign, the determinant is nothing."""
    table, values = arm(name)
    minor, _ = largest_minor(table, rows)
    factors, _ = minor_factors(table, rows)
    whole = minor.expression()
    rng = np.random.default_rng(5)
    met = set()
    for _ in range(4):
        start, way = rng.uniform(-3, 3, (2, table.n_joints))
        usual = np.mean(
            [abs(evaluate(whole, values, (start + s * way).tolist())) for s in np.linspace(0, 1, 9)]
        )

        def value(factor, s, start=start, way=way):
            return evaluate(factor, values, (start + s * way).tolist())

        grid = np.linspace(0, 2, 80)
        for place, factor in enumerate(factors):
            signs = [value(factor, s) > 0 for s in grid]
            for k in np.flatnonzero(np.diff(signs)):
                low, high = grid[k], grid[k + 1]
                for _ in range(45):
                    middle = (low + high) / 2
                    low, high = (middle, high) if (value(factor, middle) > 0) == signs[k] else (low, middle)
                assert abs(value(whole, low)) < 1e-9 * usual
                met.add(place)
        changes = [value(whole, s) > 0 for s in grid]
        for k in np.flatnonzero(np.diff(changes)):
            assert any((value(f, grid[k]) > 0) != (value(f, grid[k + 1]) > 0) for f in factors)
    assert met == set(range(len(factors)))


@pytest.mark.parametrize(
    ("name", "rows", "count"),
    [
        ("scara", TWIST, 2),
        ("stanford", TWIST, 5),
        ("rx90", TWIST, 5),
        ("puma560", TWIST, 4),
        ("onelink", TWIST, 0),
        ("twolink", TRANSLATION, 2),
    ],
)
def test_factors_are_irreducible(name: str, rows: MotionRows, count: int) -> None:
    """In half angles: sin q = 2 sin(q/2) cos(q/2) is two of them."""
    factors, only = minor_factors(arm(name)[0], rows)
    assert only
    assert len(factors) == count
    assert len(set(factors)) == count


def test_the_one_coordinate_of_a_link_has_its_joint_in_half_angles() -> None:
    factors, only = minor_factors(arm("onelink")[0], TRANSLATION)
    half = multiply((number(Fraction(1, 2)), JointVariable(1)))
    assert set(factors) == {call(Function.COS, half), call(Function.SIN, half)}
    assert not only


def test_a_redundant_arm_has_several_minors() -> None:
    planar = DHTable(
        convention=Convention.STANDARD, rows=tuple(row(a=Parameter(f"L{i}")) for i in range(1, 5))
    )
    minor, only = largest_minor(planar, TWIST)
    assert not only
    values = {f"L{i}": 0.3 + 0.1 * i for i in range(1, 5)}
    q = draws(planar)[0]
    J = moving_rows(planar, values, TWIST, q)
    found = evaluate(minor.expression(), values, q.tolist())
    minors = [abs(np.linalg.det(np.delete(J, joint, axis=1))) for joint in range(4)]
    assert min(abs(abs(found) - value) for value in minors) < 1e-12


def test_parallel_sliders_have_a_smaller_minor_that_is_a_constant() -> None:
    slide = JointType.PRISMATIC
    parallel = DHTable(convention=Convention.STANDARD, rows=(row(slide), row(slide)))
    minor, only = largest_minor(parallel, TRANSLATION)
    assert not only
    assert abs(evaluate(minor.expression(), {}, [0.1, 0.2])) == 1.0
    assert minor_factors(parallel, TRANSLATION) == ((), False)


def test_an_arm_whose_tip_never_moves_has_no_minor() -> None:
    table = DHTable(convention=Convention.STANDARD, rows=(row(),))
    minor, only = largest_minor(table, TRANSLATION)
    assert minor.expression() == ZERO
    assert only


def test_a_factor_that_no_tangent_of_a_half_angle_shows_is_found() -> None:
    """1 + cos q2 = 2 / (1 + t²) has no zero in t; the arm folds back onto its first axis at q2 = π."""
    length, quarter = Parameter("L1"), pi_times(Fraction(1, 2))
    folding = DHTable(
        convention=Convention.STANDARD,
        rows=(row(JointType.FIXED, alpha=quarter), row(a=length, alpha=quarter), row(a=length)),
    )
    factors, _ = minor_factors(folding, TRANSLATION)
    at = {q2: [abs(evaluate(f, {"L1": 1.0}, [0.7, q2])) for f in factors] for q2 in (np.pi, 0.0)}
    assert min(at[np.pi]) < 1e-12
    assert min(at[0.0]) > 1e-3


def test_one_dimension_less_than_joints_is_looked_for_next(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two joints on one axis and a third askew of it: two of the three motions are independent."""
    rows = (row(), row(a=Parameter("L1"), alpha=Parameter("alpha")), row())
    table = DHTable(convention=Convention.STANDARD, rows=rows)
    sizes = []

    def counted(ring: Ring, columns: determinants.Columns) -> Form:
        sizes.append(len(columns))
        return determinant(ring, columns)

    determinant = determinants._determinant
    monkeypatch.setattr(determinants, "_determinant", counted)
    minor, only = largest_minor(table, TWIST)
    assert list(dict.fromkeys(sizes)) == [3, 2]
    assert not only
    for values in {"L1": 0.1, "alpha": 0.4}, {"L1": 0.3, "alpha": -0.9}:
        found = abs(evaluate(minor.expression(), values, [0.5, 0.6, 0.7]))
        motions = abs(chain_of_table(bind(table, values)).jacobian([0.5, 0.6, 0.7]))
        assert found in (
            pytest.approx(values["L1"] * abs(trig(values["alpha"]))) for trig in (np.cos, np.sin)
        )
        assert np.linalg.matrix_rank(motions) == 2
