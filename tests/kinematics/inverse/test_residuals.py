"""How far a pose is from its target: rotation vectors, at half turns too."""

import numpy as np
import pytest

from kinematics.inverse.residuals import error_vectors
from kinematics.poses import transform_from_axis_angle

AXES = [(1, 0, 0), (0, 1, 0), (0, 0, -1), (1, 1, 0), (0, -1, 1), (0.3, -0.5, 0.2), (-1e-9, 1, 1e-7)]
BELOW_HALF_TURNS = [0.0, 1e-15, 1e-13, 1e-9, 1e-7, 1e-6, 1e-3]


@pytest.mark.parametrize("axis", AXES)
def test_error_vectors_are_rotation_vectors(axis):
    rng = np.random.default_rng(5)
    unit = np.array(axis) / np.linalg.norm(axis)
    for angle in (0.0, 1e-12, 1e-6, 0.4, 3.0, *(np.pi - short for short in BELOW_HALF_TURNS)):
        from_here = transform_from_axis_angle(rng.normal(size=3), rng.uniform(0, 3), rng.normal(size=3))
        target = from_here.copy()
        target[:3, :3] = transform_from_axis_angle(axis, angle)[:3, :3] @ from_here[:3, :3]
        target[:3, 3] += (0.3, 0.2, 0.1)
        found = error_vectors(from_here[None], target, 0.1)[0]
        assert np.allclose(found[:3], (3.0, 2.0, 1.0), atol=1e-12)
        turned = found[3:] if found[3:] @ unit >= 0 or angle < 3.1 else -found[3:]
        assert np.allclose(turned, angle * unit, atol=3e-8)


def test_an_exact_half_turn_is_no_small_error():
    for diagonal in ((1, -1, -1), (-1, 1, -1), (-1, -1, 1)):
        target = np.diag([*diagonal, 1.0])
        assert np.linalg.norm(error_vectors(np.eye(4)[None], target, 1.0)) == np.pi
