"""Keys with coaxial and nearly parallel axes: an exact table gets an exact certificate."""

import math
from random import Random

import pytest

from kinematics.equivalence import Policy, Tolerance, ToolRule, decide
from kinematics.equivalence.decision import EXACT
from kinematics.table import Convention, DHRow, DHTable, JointType, NumericTable
from tests.kinematics.equivalence.generators import random_valid_table

RIGHT, HALF = math.pi / 2, math.pi


def key(*links: tuple[float, float, float]) -> NumericTable:
    """Revolute joints, from (α, a, d)."""
    rows = tuple(DHRow(joint=JointType.REVOLUTE, theta=0.0, d=d, a=a, alpha=alpha) for alpha, a, d in links)
    return DHTable(convention=Convention.STANDARD, rows=rows)


KEYS = {
    "1e-4 after a run, coaxial joints 5 and 6": key(
        (0, 0.117, 0), (HALF, 0, 0.219), (HALF, 0, 0), (1e-4, 0.464, 0.729), (HALF, 0, 0.201),
        (RIGHT, 0.32, 0), (0, 0, 0), (HALF, 0, 0), (0, 0, 0.676),
    ),
    "2e-3 at the base, 1e-4 at joint 7, coaxial joints 4 and 5": key(
        (-2e-3, 0, 0.321), (HALF, 0, 0), (-RIGHT, 0.638, 0), (0, 0, 0), (HALF, 0.825, 0.17),
        (1e-4, 0.884, 0), (RIGHT, 0, 0.7), (0, 0, 0.194),
    ),
    "1e-4 twice in a row, 2e-3 at joint 7": key(
        (0, 0, 0), (-1e-4, 0.28, 0.176), (-1e-4, 0.14, 0), (HALF, 0, 0), (RIGHT, 0.854, 0),
        (-2e-3, 0, 0.534), (-RIGHT, 0, 0.65), (RIGHT, 0, 0.814), (HALF, 0, 0.379),
    ),
    "joints 7 and 8 coaxial": key(
        (RIGHT, 0.1, 0.3), (0, 0.5, 0), (RIGHT, 0.05, 0.1), (-RIGHT, 0, 0.4), (RIGHT, 0, 0),
        (-RIGHT, 0.1, 0.2), (0, 0, 0.15), (RIGHT, 0.2, 0.1),
    ),
}  # fmt: skip


@pytest.mark.parametrize("robot", KEYS.values(), ids=list(KEYS))
@pytest.mark.parametrize("tolerance", [EXACT, Tolerance()], ids=["exact", "usual"])
def test_an_exact_table_has_an_exact_certificate(robot: NumericTable, tolerance: Tolerance) -> None:
    rng = Random("nearly parallel")
    for _ in range(12):
        table = random_valid_table(robot, rng)
        decision = decide(robot, table, Policy(tool=ToolRule.FREE, tolerance=tolerance))
        assert decision.certificate is not None
        assert decision.certificate.residual <= EXACT.length
