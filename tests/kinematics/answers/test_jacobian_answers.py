"""Jacobians and joint forces against differences of poses; slips are told."""

import random

import numpy as np
import pytest

from kinematics.answers.jacobian_answers import judge_forces, judge_jacobian
from kinematics.answers.jacobian_verdicts import JacobianMistake
from kinematics.cells import RawRow, RawTable, read_table
from kinematics.chain import chain_of_table
from kinematics.jacobian import JacobianFrame
from kinematics.table import Convention, JointType, bind
from tests.kinematics.answers.joint_values import product, robot

ROBOTS = ("twolink", "scara", "puma560", "stanford", "rx90", "scorbot", "kr125")
STEP = 1e-5


def differences(table, joints, frame: JacobianFrame) -> np.ndarray:
    """The Jacobian by central differences of products of DH matrices: velocity of the origin, and Ṙ Rᵀ."""
    pose = product(table, joints)
    columns = []
    for i in range(len(joints)):
        forward, back = list(joints), list(joints)
        forward[i] += STEP
        back[i] -= STEP
        rate = (product(table, forward) - product(table, back)) / (2 * STEP)
        spin = rate[:3, :3] @ pose[:3, :3].T
        columns.append([*rate[:3, 3], spin[2, 1], spin[0, 2], spin[1, 0]])
    jacobian = np.array(columns).T
    turn = np.kron(np.eye(2), pose[:3, :3].T)
    return jacobian if frame is JacobianFrame.BASE else turn @ jacobian


def configuration(table, rng: random.Random) -> list[float]:
    return [
        rng.uniform(-3, 3) if kind is JointType.REVOLUTE else rng.uniform(0.1, 0.6)
        for kind in table.joint_types
    ]


def test_right_ones_are_accepted_and_any_wrong_entry_is_found() -> None:
    rng = random.Random(1)
    for _ in range(300):
        table = robot(rng.choice(ROBOTS))
        frame = rng.choice(list(JacobianFrame))
        joints = configuration(table, rng)
        chain = chain_of_table(table)
        right = np.round(differences(table, joints, frame), 4)
        assert judge_jacobian(chain, joints, right, frame, 0.005).right
        spoilt = right.copy()
        r, c = rng.randrange(6), rng.randrange(len(joints))
        spoilt[r, c] += rng.choice([-1, 1]) * rng.uniform(0.1, 2)
        found = judge_jacobian(chain, joints, spoilt, frame, 0.005)
        assert not found.right
        assert np.argwhere(~found.entries).tolist() == [[r, c]]


def test_forces_are_what_holds_the_wrench_in_virtual_work() -> None:
    rng = random.Random(2)
    for _ in range(200):
        table = robot(rng.choice(ROBOTS))
        frame = rng.choice(list(JacobianFrame))
        joints, chain = configuration(table, rng), chain_of_table(table)
        wrench = [rng.uniform(-20, 20) for _ in range(6)]
        torques = np.round(differences(table, joints, frame).T @ np.array(wrench), 3).tolist()
        assert all(judge_forces(chain, joints, wrench, torques, frame, 0.005)[0])
        i = rng.randrange(len(joints))
        torques[i] += rng.choice([-1, 1]) * rng.uniform(5, 30)
        right, _ = judge_forces(chain, joints, wrench, torques, frame, 0.005)
        assert [k for k, good in enumerate(right) if not good] == [i]
        turned = (-np.array(differences(table, joints, frame).T @ np.array(wrench))).tolist()
        if np.abs(turned).max() > 5:
            assert judge_forces(chain, joints, wrench, turned, frame, 0.005)[1] is JacobianMistake.SIGN


@pytest.mark.parametrize("name", ["stanford", "puma560"])
def test_slips_are_told(name) -> None:
    table = robot(name)
    joints = [0.4, 0.5, 0.3, 0.6, 0.7, 0.8]
    chain, base = chain_of_table(table), JacobianFrame.BASE
    right = differences(table, joints, base)
    end = product(table, joints)

    def told(matrix, frame=base):
        return judge_jacobian(chain, joints, matrix, frame, 0.005).mistakes

    assert told(right, JacobianFrame.END) == ((JacobianMistake.OTHER_FRAME, None),)
    assert told(np.vstack([right[3:], right[:3]])) == ((JacobianMistake.ROWS_EXCHANGED, None),)
    spatial = right.copy()
    spatial[:3] += np.cross(right[3:].T, -end[:3, 3]).T
    assert told(spatial) == ((JacobianMistake.SPATIAL, None),)
    swapped = right.copy()
    swapped[:3, 1] *= -1
    assert told(swapped) == ((JacobianMistake.POINT_SWAPPED, 2),)
    late = right.copy()
    late[:, 0] = right[:, 1]
    assert told(late) == ((JacobianMistake.NEXT_AXIS, 1),)
    sliding = right.copy()
    sliding[:, 3] = [*right[3:, 3], 0, 0, 0]
    assert told(sliding) == ((JacobianMistake.PRISMATIC, 4),)
    if name == "stanford":
        both = right.copy()
        both[3:, 2] = both[:3, 2]
        assert told(both) == ((JacobianMistake.PRISMATIC, 3),)
    degrees = right * np.radians([180 / np.pi if name == "stanford" and i == 2 else 1 for i in range(6)])
    assert told(degrees) == ((JacobianMistake.PER_DEGREE, None),)
    for ratio in (1000, 0.001, 100, 0.01):
        lengths = right.copy()
        lengths[:3, [not axis.prismatic for axis in chain.axes]] *= ratio
        assert told(lengths) == ((JacobianMistake.OTHER_UNIT, None),)
        lengths[:3, 0] *= 2
        assert told(lengths) == ()
        assert told(right * np.array([[ratio]] * 3 + [[1]] * 3)) == ((JacobianMistake.OTHER_UNIT, None),)
    opposite = right.copy()
    opposite[:, 1] *= -1
    assert told(opposite) == ((JacobianMistake.REVERSED, 2),)
    away = right.copy()
    turning = [i for i in range(right.shape[1]) if right[3:, i].any()]
    away[:3, turning] += np.cross(right[3:, turning].T, [0.1, -0.2, 0.15]).T
    assert told(away) == ((JacobianMistake.OTHER_POINT, None),)
    assert told(right + 1) == ()


def test_numbers_in_the_place_of_zeros_are_in_no_other_unit() -> None:
    row = RawRow(theta="q1", d=0.5, a=0, alpha=0)
    table = read_table(RawTable(convention=Convention.STANDARD, rows=(row,))).table
    away = np.array([[0.3], [0.2], [0], [0], [0], [1]])
    assert (
        judge_jacobian(chain_of_table(bind(table, {})), [0.4], away, JacobianFrame.BASE, 0.005).mistakes == ()
    )


def test_a_singular_configuration_is_judged_like_any_other() -> None:
    table = robot("puma560")
    joints = [0.0] * 6
    right = differences(table, joints, JacobianFrame.BASE)
    assert judge_jacobian(chain_of_table(table), joints, right, JacobianFrame.BASE, 0.005).right


@pytest.mark.parametrize("value", [1e308, -1e300, 1e-300])
def test_no_number_is_too_large_to_be_judged(value) -> None:
    chain = chain_of_table(robot("scara"))
    found = judge_jacobian(chain, [0.1] * 4, np.full((6, 4), value), JacobianFrame.END, 0.005)
    assert not found.right
    right, _ = judge_forces(chain, [0.1] * 4, [value] * 6, [1.0] * 4, JacobianFrame.BASE, 0.005)
    assert len(right) == 4
