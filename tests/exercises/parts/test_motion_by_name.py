"""Equations of motion in names are as exact as they were typed, whatever a student was given."""

from dataclasses import replace
from fractions import Fraction
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from exercises.answers import RawAnswer, parse
from exercises.grader import grade
from exercises.instance import generate
from exercises.loader import load_exercise, robot_facts
from exercises.parts.motion.motion_cells import MotionCells
from exercises.parts.motion.weighed_links import units_of_names
from exercises.parts.registry import part_type
from exercises.reading import Reader
from kinematics.dynamics.reading import RawBody
from tests.exercises.answering import part
from tests.exercises.folders import folder
from tests.exercises.packaged import exercise

H = "m2*L1*r2*sin(q2)"
ANSWER = MotionCells(
    mass=(
        ("m1*r1^2 + m2*(L1^2 + r2^2 + 2*L1*r2*cos(q2)) + I1 + I2", "m2*r2*(r2 + L1*cos(q2)) + I2"),
        ("m2*r2*(r2 + L1*cos(q2)) + I2", "I2 + m2*r2^2"),
    ),
    coriolis=((f"-{H}*dq2", f"-{H}*(dq1 + dq2)"), (f"{H}*dq1", "0")),
    gravity=("(m1*r1 + m2*L1)*g*cos(q1) + m2*r2*g*cos(q1+q2)", "m2*r2*g*cos(q1+q2)"),
)
STUDENTS = [str(number) for number in range(12)]


def earned(answer: MotionCells, seed: str) -> tuple[bool, float]:
    instance = generate(exercise("twolink-dynamics"), seed)
    found = part(
        grade(instance, parse(instance, RawAnswer(equations_of_motion=answer))), "equations_of_motion"
    )
    return found.correct, found.score


def changed(old: str, new: str) -> MotionCells:
    """The answer with something else in every cell."""

    def row(cells: tuple) -> tuple:
        return tuple(cell.replace(old, new) for cell in cells)

    return MotionCells(
        mass=tuple(map(row, ANSWER.mass)),
        coriolis=tuple(map(row, ANSWER.coriolis)),
        gravity=row(ANSWER.gravity),
    )


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("L1*cos", "1.01*L1*cos"),
        ("L1*cos", "1.005*L1*cos"),
        ("L1*cos", "(L1 + 0.004)*cos"),
        ("I1", "1.01*I1"),
        ("m2*L1*r2*sin", "1.003*m2*L1*r2*sin"),
        ("g*cos(q1+q2)", "(g + 0.02)*cos(q1+q2)"),
    ],
)
def test_a_factor_or_a_term_that_no_rounding_explains_is_wrong_for_every_student(old: str, new: str) -> None:
    assert {earned(changed(old, new), seed)[0] for seed in STUDENTS} == {False}


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("2*L1*r2*cos", "2.0*L1*r2*cos"),
        ("r2^2", "0.333*3*r2^2"),
        ("L1*cos", "0.71*sqrt(2)*L1*cos"),
        ("m2*L1*r2*sin", "0.333*0.75*4*m2*L1*r2*sin"),
        ("cos(q1+q2)", "0.707*0.707*2*cos(q1+q2)"),
    ],
)
def test_what_decimals_leave_open_is_right_for_every_student(old: str, new: str) -> None:
    assert {earned(changed(old, new), seed)[0] for seed in STUDENTS} == {True}


def test_values_that_were_given_may_stand_for_their_names() -> None:
    for seed in STUDENTS:
        instance = generate(exercise("twolink-dynamics"), seed)
        values = instance.drawn["equations_of_motion"]
        gravity = f"{float(values['g']):.2f}"
        mass = f"{float(values['m2']):.2f}"
        for old, new in (("*g", f"*{gravity}"), ("m2", mass), ("r2", f"{float(values['r2']):.2f}")):
            assert earned(changed(old, new), seed)[0], (seed, old)


def test_gravity_to_one_decimal_may_stand_for_its_name() -> None:
    """9.8 is 49/5, whose denominator was taken for that of an exact fraction."""
    for seed in STUDENTS:
        assert earned(changed("*g", "*9.8"), seed)[0], seed
        assert not earned(changed("*g", "*9.7"), seed)[0], seed


def test_a_fraction_that_was_typed_is_exact() -> None:
    assert {earned(changed("*g", "*(49/5)"), seed)[0] for seed in STUDENTS} == {False}


def test_an_answer_of_very_many_decimals_is_read_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """To read each cell anew for each decimal in it took seconds."""
    rows = 0
    module = import_module("exercises.parts.cells.matrix_cells")
    read_row = module.read_row

    def counted(*given: Any, **named: Any) -> Any:
        nonlocal rows
        rows += 1
        return read_row(*given, **named)

    for each in (module, import_module("exercises.parts.motion.motion_cells")):
        monkeypatch.setattr(each, "read_row", counted)
    cells = iter(["+".join(f"0.{100 + 61 * i + k}*L1" for k in range(60)) for i in range(4)])
    answer = replace(ANSWER, mass=((next(cells), next(cells)), (next(cells), next(cells))))
    assert not earned(answer, "1")[0]
    assert rows == 5


PENDULUM = """
version = 1
[title]
en = "Pendulum"
ro = "Pendul"
pt = "Pêndulo"
fr = "Pendule"
uk = "Маятник"
es = "Péndulo"
[reference]
convention = "standard"
angle_unit = "deg"
length_unit = "m"
rows = [{ joint = "revolute", theta = "q1", d = 0, a = "L1", alpha = 0 }]
[parameters]
L1.value = 0.5
[[parts]]
kind = "equations_of_motion"
points = 10
ask = ["mass", "coriolis", "gravity"]
gravity = [0, "-g", 0]
links = [{ mass = "m1", centre = [0, 0, 0], moments = [0, 0, "I1"] }]
weights = { m1 = { value = 2 }, I1 = { value = 0.15 }, g = { value = 9.81 } }
"""


@pytest.mark.parametrize(
    ("mass", "score"), [("m1*L1^2 + I1", 1.0), ("m1*L1^2", 2 / 3), ("1.01*m1*L1^2 + I1", 2 / 3)]
)
def test_the_equations_of_a_single_joint_are_matrices_of_one_entry(
    tmp_path: Path, mass: str, score: float
) -> None:
    instance = generate(load_exercise(folder(tmp_path, PENDULUM, name="pendulum", statement="Length *L1*.")))
    answer = MotionCells(mass=((mass,),), coriolis=((0,),), gravity=("m1*g*L1*cos(q1)",))
    found = grade(instance, parse(instance, RawAnswer(equations_of_motion=answer)))
    assert part(found, "equations_of_motion").score == pytest.approx(score)


def test_the_symbols_of_what_links_weigh_are_given_with_their_units() -> None:
    instance = generate(exercise("twolink-dynamics"))
    told = part_type("equations_of_motion").task(instance.exercise.part("equations_of_motion"), instance)
    (given,) = (numbers.labels for numbers in told.numbers if numbers.name == "weights")
    assert given == ("m1 [kg]", "m2 [kg]", "r1 [m]", "r2 [m]", "I1 [kg m²]", "I2 [kg m²]", "g [m/s²]")
    entry = RawBody(mass="k", centre=("m*2", 0, 0), inertia=((0, 0, 0), (0, 0, 0), (0, 0, "k")))
    assert "k" not in units_of_names([entry], (0, 0, 0), "mm")  # a mass and a moment by one name


@pytest.mark.parametrize("name", ["twolink", "scara", "stanford"])
def test_equations_of_motion_begin_with_a_link_for_each_row(name: str) -> None:
    """Beside a fixed row, as of a planar arm's tip, the authors' page began with a fault: 3 links, not 2."""
    asked, judge = exercise(name), part_type("equations_of_motion")
    robot = robot_facts(asked.reference, asked.robot)
    begun = judge.define(Reader(judge.start(robot), ("parts", 0), []), Fraction(10), robot)
    assert list(judge.inconsistencies(begun, asked)) == []
