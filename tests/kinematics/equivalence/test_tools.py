"""How frames 0 and N may move from where a rule has put them."""

import numpy as np
import pytest

from kinematics.equivalence import BaseRule, Policy, ToolRule, ZeroRule
from kinematics.equivalence.reference import prepared
from kinematics.equivalence.search import base_twists
from kinematics.equivalence.tools import tool_choices
from kinematics.table import NumericTable
from tests.kinematics.equivalence.tables import PUMA, SCARA, F, P, R, standard

SLIDER_LAST = standard((R, 1.0, 0.2, 0.3, 0), (P, 0.7, 0.1, 0.2, 0.4))
ROTATION, SHIFT = [0, 1, 2], [3, 4, 5]
MAY = {
    ToolRule.FREE: [*ROTATION, *SHIFT],
    ToolRule.POINT: ROTATION,
    ToolRule.AXIS: [2, 5],
    ToolRule.FRAME: [],
}


@pytest.mark.parametrize("rule", ToolRule)
@pytest.mark.parametrize("key", [PUMA, SCARA, SLIDER_LAST], ids=["puma", "scara", "slider last"])
def test_a_frame_is_turned_and_shifted_as_its_rule_lets_it(key: NumericTable, rule: ToolRule) -> None:
    """On a line it turns about z and slides along it; beside a slider it is shifted anywhere as well."""
    reference = prepared(key)
    near = reference.nearnesses(Policy().tolerance)[0]
    (plan, *_) = reference.plans(BaseRule.FREE, ZeroRule.FREE, near)
    for choice in tool_choices(reference, plan, rule, near):
        slides = rule is ToolRule.AXIS and choice.step is not None and choice.step.axis.prismatic
        wanted = [2, *SHIFT] if slides else MAY[rule]
        np.testing.assert_array_equal(choice.twists, np.eye(6)[:, wanted])
    assert any(choice.step is not None for choice in tool_choices(reference, plan, ToolRule.AXIS, near))


@pytest.mark.parametrize(
    ("rule", "moves"),
    [
        (BaseRule.FREE, [[*ROTATION, *SHIFT]]),
        (BaseRule.ORIGIN, [ROTATION]),
        (BaseRule.FRAME, [[]]),
        (BaseRule.AXIS, [[2, *SHIFT], [2, 5]]),
    ],
)
def test_frame_0_is_turned_and_shifted_as_its_rule_lets_it(rule: BaseRule, moves: list[list[int]]) -> None:
    """Beside a slider that comes first the line of z_0 is a direction, or the one that the key has."""
    slider_first = standard((P, 0.7, 0.1, 0.2, 0.4), (R, 1.0, 0.2, 0.3, 0))
    for key, wanted in (slider_first, moves), (PUMA, moves[-1:]):
        reference = prepared(key)
        plans = reference.plans(rule, ZeroRule.FREE, reference.nearnesses(Policy().tolerance)[0])
        for plan, numbers in zip(plans, wanted, strict=True):
            np.testing.assert_array_equal(base_twists(plan, rule), np.eye(6)[:, numbers])


def test_without_joints_frame_0_stays_where_the_line_of_its_z_is_fixed() -> None:
    reference = prepared(standard((F, 0.7, 0.1, 0.2, 0.4)))
    (plan,) = reference.plans(BaseRule.AXIS, ZeroRule.FREE, reference.nearnesses(Policy().tolerance)[0])
    assert base_twists(plan, BaseRule.AXIS).shape == (6, 0)
