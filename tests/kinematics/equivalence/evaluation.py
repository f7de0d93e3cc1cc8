"""Does a certificate stand? Evaluated afresh, from the DH formulas alone and with nothing of the checker's.

Both sides of F_s(σ∘q + δ) = B · F_r(q) · E are computed at random configurations. Where they are not equal to
within rounding errors, the worst of these configurations are made worse, one joint at a time, on a grid.
"""

import math
from typing import NamedTuple

import numpy as np

from kinematics.equivalence import Certificate
from kinematics.table import Convention, JointType, NumericTable

CONFIGURATIONS = 24
MORE_CONFIGURATIONS = 1000
EXACT = 1e-8
PURSUED = 4
GRID = 24
ROUNDS = 2


class Difference(NamedTuple):
    """The largest differences found: rotation [rad], and distance of the origins [length]."""

    angle: float
    length: float


def poses_of(table: NumericTable, joints: np.ndarray) -> np.ndarray:
    """⁰T_N at (samples, n) configurations, by the formula of the table's convention; (samples, 4, 4)."""
    rows, samples = table.rows, len(joints)
    theta = np.tile([float(row.theta) for row in rows], (samples, 1))
    d = np.tile([float(row.d) for row in rows], (samples, 1))
    for joint, i in enumerate(table.joint_rows):
        variable = theta if rows[i].joint is JointType.REVOLUTE else d
        variable[:, i] += rows[i].sign * joints[:, joint]
    a = np.array([row.a for row in rows])
    alpha = np.array([row.alpha for row in rows])
    c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    links = np.zeros((samples, len(rows), 4, 4))
    links[..., 3, 3] = 1.0
    if table.convention is Convention.STANDARD:
        links[..., 0, 0], links[..., 0, 1], links[..., 0, 2], links[..., 0, 3] = c, -s * ca, s * sa, a * c
        links[..., 1, 0], links[..., 1, 1], links[..., 1, 2], links[..., 1, 3] = s, c * ca, -c * sa, a * s
        links[..., 2, 1], links[..., 2, 2], links[..., 2, 3] = sa, ca, d
    else:
        links[..., 0, 0], links[..., 0, 1], links[..., 0, 3] = c, -s, a
        links[..., 1, 0], links[..., 1, 1], links[..., 1, 2], links[..., 1, 3] = s * ca, c * ca, -sa, -sa * d
        links[..., 2, 0], links[..., 2, 1], links[..., 2, 2], links[..., 2, 3] = s * sa, c * sa, ca, ca * d
    product = links[:, 0]
    for i in range(1, len(rows)):
        product = product @ links[:, i]
    return product


def evaluated(
    reference: NumericTable, table: NumericTable, certificate: Certificate, size: float, seed: str
) -> Difference:
    """The largest differences between the two sides that were found.

    Args:
        reference: the key.
        table: the table that was accepted.
        certificate: what it was accepted for.
        size: how far sliders go.
        seed: of the random configurations.
    """
    n = reference.n_joints
    reach = np.array([math.pi if joint is JointType.REVOLUTE else size for joint in reference.joint_types])
    signs, offsets = np.array(certificate.joint_signs), np.array(certificate.joint_offsets)

    def differences(joints: np.ndarray) -> np.ndarray:
        left = poses_of(table, signs * joints + offsets)
        right = certificate.base @ poses_of(reference, joints) @ certificate.tool
        turned = np.linalg.norm(left[:, :3, :3] - right[:, :3, :3], axis=(1, 2)) / math.sqrt(8.0)
        apart = np.linalg.norm(left[:, :3, 3] - right[:, :3, 3], axis=1)
        return np.array([2.0 * np.arcsin(np.minimum(turned, 1.0)), apart])

    drawn = np.random.default_rng(list(seed.encode()))
    joints = drawn.uniform(-1.0, 1.0, (CONFIGURATIONS, n)) * reach
    found = differences(joints)
    if found[0].max() > EXACT or found[1].max() > EXACT * size:
        joints = drawn.uniform(-1.0, 1.0, (MORE_CONFIGURATIONS, n)) * reach
        found = differences(joints)
        for which in (0, 1):
            for start in np.argsort(found[which])[-PURSUED:]:
                worse = _pursued(differences, joints[start], reach, which)
                found[which, start] = max(found[which, start], worse)
    return Difference(float(found[0].max()), float(found[1].max()))


def _pursued(differences: object, start: np.ndarray, reach: np.ndarray, which: int) -> float:
    """The largest difference found by taking one joint after the other round, from a configuration."""
    assert callable(differences)
    here, worst = start.copy(), 0.0
    for _ in range(ROUNDS):
        for joint, farthest in enumerate(reach):
            trials = np.tile(here, (GRID, 1))
            trials[:, joint] = np.linspace(-farthest, farthest, GRID)
            found = differences(trials)[which]
            here, worst = trials[found.argmax()], max(worst, float(found.max()))
    return worst
