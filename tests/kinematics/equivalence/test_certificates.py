"""Of the certificates that say the same, the one whose base and tool motions are nearest to none."""

from random import Random

import pytest

from kinematics.chain import chain_of_table
from kinematics.equivalence import Policy, ToolRule, decide
from kinematics.equivalence.certificates import CertificateCandidate
from kinematics.equivalence.search import Unfinished, Way, _promise
from kinematics.se3 import IDENTITY, angle_about, compose, dot, inverse, position, subtract, z_axis
from kinematics.table import NumericTable
from tests.kinematics.equivalence.generators import random_valid_table
from tests.kinematics.equivalence.tables import HALF, PUMA, RX90, SCARA, P, R, standard

SLIDER_LAST = standard((R, HALF, 0, 0.3, 0), (R, -HALF, 0.2, 0.1, 0), (P, 0, 0, 0, 0.4))
SLIDER_FIRST = standard((P, HALF, 0.1, 0, 0), (R, -HALF, 0.2, 0.1, 0), (R, 0, 0.3, 0, 0))
ROBOTS = {"puma": PUMA, "rx90": RX90, "scara": SCARA, "first": SLIDER_FIRST, "last": SLIDER_LAST}


@pytest.mark.parametrize("rule", [ToolRule.FREE, ToolRule.AXIS])
@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("key", ROBOTS.values(), ids=ROBOTS.keys())
def test_what_the_first_and_the_last_joint_can_do_is_in_their_offsets(
    key: NumericTable, seed: int, rule: ToolRule
) -> None:
    table = random_valid_table(key, Random(f"{seed}"), dummies=0.0)
    certificate = decide(key, table, Policy(tool=rule)).certificate
    assert certificate is not None
    (candidate,) = certificate.draws
    chain = chain_of_table(key)
    first, last = chain.axes[0], chain.axes[-1]
    end = compose(chain.end, candidate.tool)
    if not first.prismatic:
        assert angle_about(inverse(candidate.base), first.direction) == pytest.approx(0.0, abs=1e-9)
    if last.prismatic:
        moved = subtract(position(end), position(chain.end))
        assert dot(last.direction, moved) == pytest.approx(0.0, abs=1e-9)
    elif dot(z_axis(end), z_axis(chain.end)) > 0.0:  # turned over, it has no angle about the axis
        assert angle_about(compose(end, inverse(chain.end)), last.direction) == pytest.approx(0.0, abs=1e-9)


def test_of_nearly_as_good_certificates_the_plain_one_is_refined_first() -> None:
    """A twentieth for every reversed joint: of two the excess must be less by a tenth."""
    candidate = CertificateCandidate(signs=(), offsets=(), base=IDENTITY, tool=IDENTITY)

    def unfinished(excess: float, *signs: int) -> Unfinished:
        return Unfinished(excess, Way(0, 0, signs, 0, 0), candidate)

    best, plain, nearly = unfinished(1.8, -1, -1), unfinished(2.0, 1, 1), unfinished(1.84, -1, -1)
    assert sorted((nearly, plain, best), key=_promise) == [best, plain, nearly]
