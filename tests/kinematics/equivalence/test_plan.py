"""What of an axis shows which rotation of a group brings it home: direction, moment, or nothing."""

import pytest

from kinematics.chain import Axis
from kinematics.equivalence.groups import Nearness, about_point, cylinder
from kinematics.equivalence.plan import prepare
from kinematics.se3 import ORIGIN, X_AXIS, Z_AXIS, Vector

NEAR = Nearness(1e-3, 1e-3, 1e-3)
SIZE = 4.0


@pytest.mark.parametrize(
    ("direction", "point", "by_moment"),
    [
        (Z_AXIS, ORIGIN, False),  # through the point
        (Z_AXIS, (1e-4, 0.0, 2.0), False),
        (Z_AXIS, (0.5, 0.0, 2.0), True),
        (X_AXIS, (0.0, 0.5, 0.0), True),
    ],
)
def test_about_a_point_an_axis_beside_it_leaves_no_turn_open(
    direction: Vector, point: Vector, by_moment: bool
) -> None:
    step = prepare(Axis(False, direction, point), about_point(ORIGIN), NEAR, SIZE)
    assert (step.by_direction, step.by_moment) == (0.0, by_moment / SIZE**2)
    assert prepare(Axis(True, direction, point), about_point(ORIGIN), NEAR, SIZE).by_moment == 0.0


@pytest.mark.parametrize(
    ("direction", "point", "by_direction", "by_moment"),
    [
        (X_AXIS, ORIGIN, True, False),
        (X_AXIS, (0.0, 0.5, 0.0), True, False),  # slides along z: its height says nothing
        (Z_AXIS, (0.5, 0.0, 0.0), False, True),
        (Z_AXIS, ORIGIN, False, False),
        (Z_AXIS, (1e-4, 0.0, 3.0), False, False),
    ],
)
def test_about_a_line_parallel_axes_show_by_where_they_stand(
    direction: Vector, point: Vector, by_direction: bool, by_moment: bool
) -> None:
    step = prepare(Axis(False, direction, point), cylinder(ORIGIN, Z_AXIS), NEAR, SIZE)
    assert (step.by_direction, step.by_moment) == (float(by_direction), by_moment / SIZE**2)
