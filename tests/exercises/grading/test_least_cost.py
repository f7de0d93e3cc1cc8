"""The sweep over the directions of axes, against trying every one of them."""

from itertools import product

import numpy as np
import pytest

from exercises.grading.axis_directions import fixed_ends, fixed_signs, least_cost
from kinematics.equivalence import BaseRule, DirectionRule, Policy, ToolRule, ZeroRule
from kinematics.equivalence.home_invariants import home_invariants_of
from kinematics.equivalence.invariants import Measure, invariants_of
from kinematics.equivalence.reference import prepared
from tests.kinematics.equivalence.campaign import catalogue

ROBOTS = dict(catalogue())
FRAMES = Policy(
    base=BaseRule.FRAME, tool=ToolRule.FRAME, zero=ZeroRule.FIGURE, direction=DirectionRule.FIGURE
)


@pytest.mark.parametrize("policy", [Policy(tool=ToolRule.FREE), FRAMES], ids=["free", "frames"])
@pytest.mark.parametrize("name", ["puma560", "stanford", "scara", "ur5"])
def test_the_least_of_all_directions_is_found(name: str, policy: Policy) -> None:
    reference = prepared(ROBOTS[name])
    shapes = invariants_of(reference, policy).beside(home_invariants_of(reference, policy)).shapes
    axes = reference.table.n_joints + 2
    for fixed in {fixed_ends(axes, policy), (), (0,), (2, 3), (1, 2, 3, 4), tuple(range(axes))}:
        costs = np.random.default_rng(axes).uniform(size=(2, len(shapes), 3))
        turned = (signs for signs in product((0, 1), repeat=axes) if not any(signs[i] for i in fixed))
        tried = np.array([cost_of(shapes, costs, signs, fixed) for signs in turned])
        np.testing.assert_allclose(least_cost(shapes, axes, costs, fixed), tried.min(axis=0), atol=1e-12)


def cost_of(shapes, costs, signs, fixed):
    """What the invariants cost with some axes turned round; those of axes far apart as suits each best."""
    total = np.zeros(costs.shape[2])
    for q, shape in enumerate(shapes):
        i, j = shape.axes[:2]
        if shape.measure is Measure.OFFSET:
            total += costs[signs[j], q]
        elif shape.measure is not Measure.TURN and j == i + 1:
            total += costs[signs[i] ^ signs[j], q]
        elif q in fixed_signs(tuple(shapes), fixed):
            total += costs[0, q]
        else:
            total += costs[:, q].min(axis=0)
    return total
