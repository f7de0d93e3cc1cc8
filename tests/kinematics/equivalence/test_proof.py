"""Proofs: closed forms of certificates, guessed and proved."""

import math
from random import Random

import pytest

from kinematics.cells import ReadTable
from kinematics.equivalence import ExactCertificate, Policy, ToolRule, decide_draws, prove
from kinematics.equivalence.closed_forms import LengthForms, angle_form, known_number
from kinematics.expressions import Parameter, add, evaluate, multiply, number, pi_times
from kinematics.table import bind, table_parameters
from tests.exercises.grading.written import read

PUMA = [
    ("pi/2", 0, 0, "q1"),
    (0, "a2", 0, "q2"),
    ("-pi/2", "a3", "d3", "q3"),
    ("pi/2", 0, "d4", "q4"),
    ("-pi/2", 0, 0, "q5"),
    (0, 0, 0, "q6"),
]
PUMA_CRAIG = [
    (0, 0, 0, "q1"),
    ("pi/2", 0, 0, "q2"),
    (0, "a2", "d3", "q3"),
    ("-pi/2", "a3", "d4", "q4"),
    ("pi/2", 0, 0, "q5"),
    ("-pi/2", 0, 0, "q6"),
]


def proved(reference: ReadTable, submission: ReadTable) -> ExactCertificate | None:
    names = sorted({*table_parameters(reference.table), *table_parameters(submission.table)})
    rng = Random(1)
    draws = [{name: rng.uniform(0.4, 1.6) for name in names} for _ in range(3 if names else 1)]
    decision = decide_draws(
        [bind(reference.table, draw) for draw in draws],
        [bind(submission.table, draw) for draw in draws],
        Policy(tool=ToolRule.FREE),
    )
    assert decision.certificate is not None
    return prove(reference.table, submission.table, decision.certificate.draws, draws)


def test_two_conventions_with_lengths_as_symbols() -> None:
    assert proved(read("standard", PUMA), read("modified", PUMA_CRAIG)) is not None


def test_a_proof_ends_after_a_count_of_products(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("kinematics.equivalence.proof.MOST_TERM_PRODUCTS", 1)
    assert proved(read("standard", PUMA), read("modified", PUMA_CRAIG)) is None


def test_offsets_and_frames_with_symbols() -> None:
    shifted = [*PUMA]
    shifted[0] = ("pi/2", 0, "h", "q1 - pi/6")
    exact = proved(read("standard", PUMA), read("standard", shifted))
    assert exact is not None
    assert exact.base[2][3] == Parameter("h")


def test_a_number_among_names_is_proved() -> None:
    on_a_pillar = [*PUMA]
    on_a_pillar[0] = ("pi/2", 0, 0.66, "q1")
    exact = proved(read("standard", PUMA), read("standard", on_a_pillar))
    assert exact is not None
    assert exact.base[2][3] == number("0.66")


def test_numbers_are_proved_as_well() -> None:
    lengths = {"a2": 0.4318, "a3": 0.0203, "d3": 0.15005, "d4": 0.4318}
    numeric = [tuple(lengths.get(cell, cell) for cell in row) for row in PUMA]
    moved = list(numeric)
    moved[1] = (0, 0.4318, 0.05, "q2")
    moved[2] = ("-pi/2", 0.0203, 0.10005, "q3")
    assert proved(read("standard", numeric), read("standard", moved)) is not None


@pytest.mark.parametrize("unit", ["", "0000000", "000000000000"])
def test_numbers_in_a_large_unit_are_proved(unit: str) -> None:
    """How many decimals a length has, and which is none, is seen beside the longest and not beside 1."""
    cells = {"a2": f"0.{unit}4318", "a3": f"0.{unit}0203", "d3": f"0.{unit}15005", "d4": f"0.{unit}4318"}
    numeric = [tuple(cells.get(cell, cell) for cell in row) for row in PUMA]
    on_a_pillar = [("pi/2", 0, f"0.{unit}66127", "q1"), *numeric[1:]]
    assert proved(read("standard", numeric), read("standard", on_a_pillar)) is not None


def test_a_slider_with_an_offset_in_symbols() -> None:
    arm = [("pi/2", 0, 0, "q1"), ("pi/2", 0, "q2", "pi/2"), (0, "L3", 0, "q3")]
    other = [("pi/2", 0, 0, "q1"), ("pi/2", 0, "q2 + 2L1 - L3", "pi/2"), (0, "L3", 0, "q3")]
    exact = proved(read("standard", arm), read("standard", other))
    assert exact is not None
    values = {"L1": 0.7, "L3": 0.3}
    assert evaluate(exact.joint_offsets[1], values) == pytest.approx(-(2 * 0.7 - 0.3))


def test_a_twist_as_a_symbol() -> None:
    arm = [("beta", "L1", 0, "q1"), (0, "L2", 0, "q2")]
    reversed_axis = [("beta", "L1", 0, "q1"), ("pi", "L2", 0, "q2")]
    assert proved(read("standard", arm), read("standard", reversed_axis)) is not None


def test_rounded_entries_are_not_proved() -> None:
    typed = [(1.57 if row[0] == "pi/2" else row[0], *row[1:]) for row in PUMA]
    assert proved(read("standard", PUMA), read("standard", typed)) is None


def test_known_numbers() -> None:
    for k in range(25):
        for j in range(25):
            value = math.cos(k * math.pi / 12) * math.sin(j * math.pi / 12)
            form = known_number(value)
            assert form is not None
            assert evaluate(form) == pytest.approx(value, abs=1e-12)
    assert known_number(0.123456) is None


def test_lengths_are_recognised_at_three_draws() -> None:
    atoms = [Parameter(f"L{k}") for k in range(1, 7)]
    rng = Random(3)
    draws = [{f"L{k}": rng.uniform(0.4, 1.6) for k in range(1, 7)} for _ in range(3)]
    wanted = add((atoms[4], multiply((number(-1), atoms[1]))))
    values = [evaluate(wanted, draw) for draw in draws]
    lengths = LengthForms(atoms, draws, 1.6)
    form = lengths.form(values)
    assert form is not None
    assert [evaluate(form, draw) for draw in draws] == pytest.approx(values)
    assert lengths.form([0.1, 0.2, 0.4]) is None
    with_number = lengths.form([value + 0.25 for value in values])
    assert with_number is not None
    assert evaluate(with_number, draws[0]) == pytest.approx(values[0] + 0.25)
    assert lengths.form([0.25, 0.25, 0.25]) == number("0.25")
    assert LengthForms([], [{}], 0.25).form([0.25]) == number("0.25")


def test_angles_are_recognised() -> None:
    form = angle_form([math.pi / 12 - 2 * math.pi], [], [{}])
    assert form == pi_times(1) or evaluate(form) == pytest.approx(math.pi / 12)  # type: ignore[arg-type]
    assert angle_form([0.2], [], [{}]) is None
    beta = Parameter("beta")
    with_symbol = angle_form([math.pi - 0.3], [beta], [{"beta": 0.3}])
    assert with_symbol is not None
    assert evaluate(with_symbol, {"beta": 0.9}) == pytest.approx(math.pi - 0.9)
