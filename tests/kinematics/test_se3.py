"""What is a rigid transform, and what is not."""

import math

import numpy as np
import pytest
from hypothesis import given

from kinematics.errors import PoseError
from kinematics.se3 import check_transform, inverse_transform
from tests.kinematics.strategies import transforms

EYE = np.eye(4)


def changed(i, j, value):
    matrix = EYE.copy()
    matrix[i, j] = value
    return matrix


@given(transforms())
def test_rigid_transforms_pass_unchanged(pose):
    checked = check_transform(pose.tolist())
    assert np.array_equal(checked, pose)
    assert checked is not pose


@given(transforms())
def test_inverse(pose):
    np.testing.assert_allclose(inverse_transform(pose) @ pose, EYE, atol=1e-14)
    many = np.array([[pose, EYE], [EYE, pose]])
    np.testing.assert_allclose(inverse_transform(many)[1, 1], inverse_transform(pose), atol=0)
    assert inverse_transform(many).shape == (2, 2, 4, 4)


@pytest.mark.parametrize(
    ("value", "code", "inner"),
    [
        (None, "pose_not_numbers", ()),
        ("identity", "pose_not_numbers", ()),
        ([["1", 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], "pose_not_numbers", ()),
        ([[1, 0], [0]], "pose_not_numbers", ()),
        (EYE.astype(bool), "pose_not_numbers", ()),
        (EYE.astype(complex), "pose_not_numbers", ()),
        (EYE[:3], "pose_wrong_shape", ()),
        (np.eye(3), "pose_wrong_shape", ()),
        (1.0, "pose_wrong_shape", ()),
        (np.array([EYE, EYE]), "pose_wrong_shape", ()),
        (changed(1, 2, math.nan), "pose_not_finite", (1, 2)),
        (changed(3, 3, math.inf), "pose_not_finite", (3, 3)),
        (changed(3, 0, 1e-9), "pose_bottom_row", (3,)),
        (changed(3, 3, 2.0), "pose_bottom_row", (3,)),
        (changed(0, 1, 1e-3), "pose_not_orthonormal", ()),
        (changed(0, 0, 1.1), "pose_not_orthonormal", ()),
        (changed(0, 0, 1e200), "pose_not_orthonormal", ()),
        (np.diag([0.0, 0.0, 0.0, 1.0]), "pose_not_orthonormal", ()),
        (np.diag([1.0, 1.0, -1.0, 1.0]), "pose_left_handed", ()),
    ],
)
def test_what_is_not_rigid_is_refused(value, code, inner):
    with pytest.raises(PoseError) as error:
        check_transform(value, where=("tool",))
    assert error.value.code == code
    assert error.value.faults[0].where == ("tool", *inner)


def test_six_decimals_are_enough():
    rng = np.random.default_rng(6)
    for _ in range(500):
        rotation, _ = np.linalg.qr(rng.normal(size=(3, 3)))
        pose = EYE.copy()
        pose[:3, :3] = (rotation * np.sign(np.linalg.det(rotation))).round(6)
        check_transform(pose)


def test_every_fault_is_told():
    with pytest.raises(PoseError) as error:
        check_transform(np.diag([2.0, 1.0, 1.0, 2.0]))
    assert [fault.code for fault in error.value.faults] == ["pose_bottom_row", "pose_not_orthonormal"]


def test_the_tolerance_is_the_caller_s():
    rounded = np.array([[0.7071, -0.7071, 0, 0], [0.7071, 0.7071, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    assert np.array_equal(check_transform(rounded, tolerance=1e-4), rounded)
    with pytest.raises(PoseError, match="pose_not_orthonormal"):
        check_transform(rounded)
