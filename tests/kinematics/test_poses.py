"""Notations of a pose: round trips, edges, and what the notations mean."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from kinematics.errors import PoseError
from kinematics.pose_batches import (
    axis_angles_from_transforms,
    quaternions_from_transforms,
    rpys_from_transforms,
    xyzabcs_from_transforms,
)
from kinematics.poses import (
    Quaternion,
    axis_angle_from_transform,
    pose_notations,
    quaternion_from_transform,
    rpy_from_transform,
    transform_from_axis_angle,
    transform_from_quaternion,
    transform_from_rpy,
    transform_from_xyzabc,
    xyzabc_from_transform,
)
from tests.kinematics import oracle
from tests.kinematics.strategies import transforms

RIGHT = math.pi / 2
SMALL = (0.0, 1e-300, 1e-16, 1e-12, -1e-9, 1e-5)

angles = st.one_of(
    st.floats(-math.pi, math.pi),
    st.sampled_from(SMALL),
    st.builds(sum, st.tuples(st.sampled_from((0.0, RIGHT, -RIGHT, math.pi)), st.sampled_from(SMALL))),
)
unit_quaternions = (
    st.tuples(*[st.one_of(st.floats(-1, 1), st.sampled_from(SMALL))] * 4)
    .filter(lambda q: math.hypot(*q) > 1e-2)
    .map(lambda q: Quaternion(*(x / math.hypot(*q) for x in q)))
)


def elementary(axis, angle):
    """Rotation about x, y or z, from the elementary matrices of the oracle."""
    if axis == "y":
        swap = np.array([[0, 1, 0], [0, 0, 1], [1, 0, 0]])
        return swap @ elementary("z", angle) @ swap.T
    return oracle.as_array(oracle.elementary(axis, angle, 0.0))[:3, :3]


def same_rotation(transform, rotation, tolerance=2e-15):
    np.testing.assert_allclose(transform[:3, :3], rotation, rtol=0, atol=tolerance)


@pytest.mark.parametrize("part", [5e-324, 1e-310, 1e-160, 1.0, 1e160, 1.7e308])
def test_the_length_of_a_quaternion_does_not_matter(part):
    third = transform_from_quaternion((part, part, part, part))
    np.testing.assert_array_equal(third[:3, :3], [[0, 0, 1], [1, 0, 0], [0, 1, 0]])


@given(unit_quaternions)
@example((0.0, 0.0, 1.6e-15, -1.0))
@example((0.0, -1.0, 2e-15, 1e-15))
def test_quaternions_there_and_back(q):
    found = quaternion_from_transform(transform_from_quaternion(q))
    sign = 1.0 if np.dot(found, q) > 0 else -1.0
    np.testing.assert_allclose(np.multiply(found, sign), q, atol=4e-15)
    assert math.hypot(*found) == pytest.approx(1.0, abs=1e-15)
    assert found.w > 0 or (found.w == 0 and next(x for x in found[1:] if abs(x) > 1e-14) > 0)


@given(angles, angles, angles)
def test_roll_pitch_yaw_there_and_back(roll, pitch, yaw):
    expected = elementary("z", yaw) @ elementary("y", pitch) @ elementary("x", roll)
    transform = transform_from_rpy((roll, pitch, yaw))
    same_rotation(transform, expected)
    found = rpy_from_transform(transform)
    same_rotation(transform_from_rpy(found), expected, tolerance=3e-12)
    assert -math.pi < found.roll <= math.pi
    assert -math.pi < found.yaw <= math.pi
    assert -RIGHT <= found.pitch <= RIGHT
    if abs(pitch) < 1.5 and abs(roll) < 3.1 and abs(yaw) < 3.1:
        np.testing.assert_allclose(found, (roll, pitch, yaw), atol=1e-13)


@pytest.mark.parametrize("beside", [1e-16, 1e-13, 1e-11, 1e-9, 1e-7, 1e-3])
@pytest.mark.parametrize("lock", [RIGHT, -RIGHT])
def test_beside_gimbal_lock_the_three_angles_still_make_the_matrix(lock, beside):
    transform = transform_from_rpy((0.4, lock - math.copysign(beside, lock), -0.7))
    same_rotation(transform_from_rpy(rpy_from_transform(transform)), transform[:3, :3], tolerance=2e-12)


@pytest.mark.parametrize("lock", [RIGHT, -RIGHT])
def test_in_gimbal_lock_yaw_is_zero(lock):
    found = rpy_from_transform(transform_from_rpy((0.4, lock, -0.7)))
    assert found.yaw == 0.0
    assert found.pitch == pytest.approx(lock, abs=1e-15)
    assert found.roll == pytest.approx(0.4 + 0.7 if lock > 0 else 0.4 - 0.7, abs=1e-15)


@given(unit_quaternions, angles)
def test_axis_and_angle_there_and_back(q, angle):
    axis = np.array(q[1:]) / math.hypot(*q[1:]) if math.hypot(*q[1:]) > 1e-2 else np.array([0.0, 0.6, 0.8])
    transform = transform_from_axis_angle(axis, angle)
    found = axis_angle_from_transform(transform)
    assert 0.0 <= found.angle <= math.pi
    assert math.hypot(*found.axis) == pytest.approx(1.0, abs=1e-15)
    same_rotation(transform_from_axis_angle(*found), transform[:3, :3], tolerance=4e-15)
    if 1e-12 <= abs(angle) <= math.pi:
        assert found.angle == pytest.approx(abs(angle), rel=1e-3, abs=3e-15)


@pytest.mark.parametrize("angle", [1e-14, 1e-12, 1e-8, 1e-4, math.pi - 1e-4, math.pi - 1e-8, math.pi - 1e-12])
def test_small_angles_and_near_half_turns_are_accurate(angle):
    axis = (2 / 7, -3 / 7, 6 / 7)
    found = axis_angle_from_transform(transform_from_axis_angle(axis, angle))
    assert found.angle == pytest.approx(angle, abs=1e-15)
    np.testing.assert_allclose(found.axis, axis, atol=max(1e-15, 2e-16 / angle))


@pytest.mark.parametrize("axis", [(1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (-0.6, 0.8, 0.0), (0.0, 0.6, -0.8)])
def test_half_turns_have_one_axis(axis):
    found = [
        axis_angle_from_transform(transform_from_axis_angle(axis, angle)) for angle in (math.pi, -math.pi)
    ]
    first = next(x for x in axis if x)
    for one in found:
        assert one.angle == pytest.approx(math.pi, abs=1e-15)
        np.testing.assert_allclose(one.axis, np.multiply(axis, math.copysign(1.0, first)), atol=1e-15)


def test_the_identity_has_axis_z_and_angle_zero():
    notations = pose_notations(np.eye(4))
    assert notations.quaternion == (1.0, 0.0, 0.0, 0.0)
    assert notations.rpy == (0.0, 0.0, 0.0)
    assert notations.axis_angle == ((0.0, 0.0, 1.0), 0.0)
    assert notations.xyzabc == (0.0,) * 6
    assert not any(
        math.copysign(1.0, x) < 0 for x in (*notations.quaternion, *notations.rpy, *notations.xyzabc)
    )


@given(st.tuples(*[st.floats(-5, 5)] * 3), angles, angles, angles)
def test_xyzabc_is_a_translation_and_three_turns(position, a, b, c):
    """Seed 001 eq. 2.5: H = X(x) Y(y) Z(z) A(a) B(b) C(c)."""
    transform = transform_from_xyzabc((*position, a, b, c))
    same_rotation(transform, elementary("z", a) @ elementary("y", b) @ elementary("x", c))
    assert tuple(transform[:3, 3].tolist()) == position
    again = transform_from_xyzabc(xyzabc_from_transform(transform))
    np.testing.assert_allclose(again, transform, rtol=0, atol=3e-12)


@pytest.mark.parametrize("a", range(-2, 3))
def test_right_angles_leave_zeros_and_ones(a):
    for b, c in itertools.product(range(-2, 3), repeat=2):
        pose = transform_from_xyzabc([0.0, 0.0, 0.0, a * RIGHT, b * RIGHT, c * RIGHT])
        assert set(np.abs(pose).ravel().tolist()) == {0.0, 1.0}
        assert not np.signbit(pose[pose == 0.0]).any()
    about_z = transform_from_axis_angle([0.0, 0.0, 2.0], a * RIGHT)
    assert np.array_equal(about_z, transform_from_xyzabc([0.0, 0.0, 0.0, a * RIGHT, 0.0, 0.0]))


@given(transforms())
def test_all_notations_at_once_are_each_of_them(pose):
    notations = pose_notations(pose)
    assert notations.position == tuple(pose[:3, 3].tolist())
    assert notations.quaternion == quaternion_from_transform(pose)
    assert notations.rpy == rpy_from_transform(pose)
    assert notations.axis_angle == axis_angle_from_transform(pose)
    assert notations.xyzabc == xyzabc_from_transform(pose)


@given(st.lists(transforms(), min_size=1, max_size=6))
def test_batches_are_the_single_poses(poses):
    batch = np.array(poses)
    notations = [pose_notations(pose) for pose in poses]
    axes, turns = axis_angles_from_transforms(batch)
    pairs = [
        (quaternions_from_transforms(batch), [n.quaternion for n in notations]),
        (rpys_from_transforms(batch), [n.rpy for n in notations]),
        (axes, [n.axis_angle.axis for n in notations]),
        (turns, [n.axis_angle.angle for n in notations]),
        (xyzabcs_from_transforms(batch), [n.xyzabc for n in notations]),
    ]
    for many, each in pairs:
        np.testing.assert_allclose(many, each, rtol=0, atol=1e-14)
    grid = quaternions_from_transforms(batch[None, :, None])
    assert grid.shape == (1, len(poses), 1, 4)
    assert quaternions_from_transforms(batch[:0]).shape == (0, 4)
    assert rpys_from_transforms(batch[0]).shape == (3,)


@pytest.mark.parametrize(
    ("make", "code", "where"),
    [
        (lambda: transform_from_quaternion((0, 0, 0, 0)), "quaternion_length", ("quaternion",)),
        (lambda: transform_from_quaternion((1, 0, 0)), "notation_wrong_length", ("quaternion",)),
        (lambda: transform_from_quaternion((1, 0, math.nan, 0)), "notation_not_finite", ("quaternion", 2)),
        (lambda: transform_from_rpy((0, math.inf, 0)), "notation_not_finite", ("rpy", 1)),
        (lambda: transform_from_rpy("abc"), "notation_wrong_length", ("rpy",)),
        (lambda: transform_from_rpy(None), "notation_wrong_length", ("rpy",)),
        (lambda: transform_from_rpy((0, 0, 0), (0, 0)), "notation_wrong_length", ("position",)),
        (lambda: transform_from_xyzabc((0, 0, 0, 0, 0)), "notation_wrong_length", ("xyzabc",)),
        (lambda: transform_from_xyzabc((0, 0, 0, 0, 0, 10**400)), "notation_wrong_length", ("xyzabc",)),
        (lambda: transform_from_axis_angle((0, 0, 0), 1.0), "axis_length", ("axis",)),
        (lambda: transform_from_axis_angle((0, 0, 1), math.nan), "notation_not_finite", ("angle", 0)),
    ],
)
def test_malformed_notations_are_refused(make, code, where):
    with pytest.raises(PoseError) as error:
        make()
    assert error.value.code == code
    assert error.value.faults[0].where == where


def test_a_quaternion_of_any_length_means_its_direction():
    expected = transform_from_quaternion((0.5, 0.5, 0.5, 0.5))
    for scale in (1e-300, 1e-3, 7.0, 1e300):
        np.testing.assert_allclose(transform_from_quaternion((scale,) * 4), expected, atol=1e-15)
