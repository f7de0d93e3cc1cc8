"""What the authors' page offers of a part is what its definition may say: no more, no less."""

from fractions import Fraction

import pytest

from exercises.parts.protocol import RobotFacts
from exercises.parts.registry import part_type, part_types
from exercises.reading import Reader
from kinematics.errors import Fault
from kinematics.table import JointType

ROBOTS = {
    "an elbow arm": RobotFacts(row_types=(JointType.REVOLUTE,) * 3, degrees=True, limits=None),
    "a slider beside a turn": RobotFacts(
        row_types=(JointType.REVOLUTE, JointType.PRISMATIC), degrees=False, limits=None
    ),
}


@pytest.mark.parametrize("robot", ROBOTS.values(), ids=ROBOTS)
@pytest.mark.parametrize("kind", part_types())
def test_the_keys_that_are_offered_are_those_that_are_read(kind: str, robot: RobotFacts) -> None:
    offered = {key.name for key in part_type(kind).keys(robot)}
    faults: list[Fault] = []
    reader = Reader({**dict.fromkeys(offered), "nonsense": 1}, ("parts", 0), faults)
    part_type(kind).define(reader, Fraction(1), robot)
    reader.finish()
    (told,) = (fault for fault in faults if fault.code == "exercise_key_unknown")
    read = set(filter(None, str(told.params["known"]).split(", ")))
    draws = {"turns", "slides"}  # read for every robot; of use where such a joint is
    assert read - draws == offered - draws


@pytest.mark.parametrize("robot", ROBOTS.values(), ids=ROBOTS)
@pytest.mark.parametrize("kind", part_types())
def test_what_a_part_starts_with_is_a_definition(kind: str, robot: RobotFacts) -> None:
    faults: list[Fault] = []
    reader = Reader({"kind": kind, "points": 1, **part_type(kind).start(robot)}, ("parts", 0), faults)
    reader.given("kind")
    reader.given("points")
    part_type(kind).define(reader, Fraction(1), robot)
    reader.finish()
    assert faults == []
    assert part_type(kind).start(robot).keys() <= {key.name for key in part_type(kind).keys(robot)}


@pytest.mark.parametrize(
    ("written", "code"),
    [(0, "tolerance_out_of_range"), (-0.005, "tolerance_out_of_range"), ("x", "exercise_value_type")],
)
@pytest.mark.parametrize("kind", part_types())
def test_a_tolerance_is_above_zero(kind: str, written: object, code: str) -> None:
    """With 0, the right answer was told to be refused."""
    robot = ROBOTS["an elbow arm"]
    if "tolerance" not in {key.name for key in part_type(kind).keys(robot)}:
        return
    faults: list[Fault] = []
    part_type(kind).define(Reader({"tolerance": written}, ("parts", 0), faults), Fraction(1), robot)
    assert [fault.code for fault in faults if "tolerance" in fault.where] == [code]
