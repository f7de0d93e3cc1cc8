"""Every robot of the catalogue, because its file exists: table, chain, reference, configurations, axes."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kinematics import catalogue
from kinematics.cells import AngleUnit, bind_parameters
from kinematics.errors import DescriptionError
from kinematics.expressions import evaluate
from kinematics.forward import forward_kinematics
from kinematics.scm import forward_kinematics_scm, modified_dh_from_scm, verify
from kinematics.table import JointType, bind, table_parameters
from tests.conftest import EXPLORE
from tests.kinematics.scm.chains import ENTRIES, elementary

IDS = [
    "cloos",
    "dmra",
    "kr100p",
    "kr125",
    "kr2150k",
    "onelink",
    "puma560",
    "puma600",
    "rx90",
    "scara",
    "scara-scm",
    "scorbot",
    "ssrms",
    "stanford",
    "twolink",
    "uw",
]
KNOWN = ["gen3", "iiwa14", "irb140", "lrmate200id", "panda", "ur10", "ur5"]
ROBOTS = pytest.mark.parametrize("robot", catalogue.robots(), ids=lambda robot: robot.id)
PRINTED_AS_CHAINS = [
    "onelink",
    "twolink",
    "uw",
    "scara-scm",
    "scorbot",
    "stanford",
    "cloos",
    "kr100p",
    "kr125",
    "kr2150k",
    "puma560",
    "puma600",
]


def in_radians(robot, joints):
    """Joint values of a file, whose angles may be in degrees, as the functions take them."""
    degrees = robot.table.angle_unit is AngleUnit.DEG
    types = robot.table.table.joint_types
    return [
        math.radians(q) if degrees and joint is JointType.REVOLUTE else q
        for q, joint in zip(joints, types, strict=True)
    ]


def pose(robot, joints):
    return forward_kinematics(bind_parameters(robot.table, robot.parameters), joints).transform


def lengths_of_chain(robot):
    return {name: robot.parameters[known] for name, known in robot.chain.parameters.items()}


def test_the_robots_of_the_documents_and_those_that_people_know_are_there():
    assert list(catalogue.robot_ids()) == sorted(IDS + KNOWN)


def test_an_unknown_robot_is_a_key_error():
    with pytest.raises(KeyError):
        catalogue.robot("puma561")


@ROBOTS
def test_reference_pose_of_the_second_derivation(robot):
    found = pose(robot, in_radians(robot, robot.reference.joints))
    scale = max(1.0, float(np.abs(found[:3, 3]).max()))
    np.testing.assert_allclose(found, robot.reference.transform, atol=2e-12 * scale)


@ROBOTS
def test_reference_joints_show_every_joint_and_lie_within_limits(robot):
    assert all(q != 0 for q in robot.reference.joints)
    for q, (low, high) in zip(robot.reference.joints, robot.limits or (), strict=False):
        assert low <= q <= high


@ROBOTS
def test_configurations_put_the_end_frame_where_the_figure_does(robot):
    within = all(low <= 0 <= high for low, high in robot.limits or ())
    assert ("zero" in robot.configurations) is within
    for configuration in robot.configurations.values():
        assert configuration.position is not None
        expected = [evaluate(cell, robot.parameters) for cell in configuration.position]
        found = pose(robot, in_radians(robot, configuration.joints))[:3, 3]
        np.testing.assert_allclose(found, expected, atol=1e-12 * max(1.0, float(np.abs(expected).max())))


@ROBOTS
def test_limits_cite_their_source(robot):
    assert (robot.limits is None) == (robot.limits_source is None)


@ROBOTS
@settings(max_examples=40 if EXPLORE else 10)
@given(data=st.data())
def test_the_table_is_the_chain_for_every_q_and_every_length(robot, data):
    """Against the SCM chain, moved without any DH table: for random joints and random lengths."""
    n = robot.table.table.n_joints
    q = data.draw(st.lists(st.floats(-10, 10), min_size=n, max_size=n))
    sizes = st.floats(-2, 2)
    values = {name: data.draw(sizes) for name in robot.table.parameters}
    lengths = {name: values[known] for name, known in robot.chain.parameters.items()}
    by_chain = forward_kinematics_scm(robot.chain.read.chain, q, lengths).transform
    by_table = forward_kinematics(bind_parameters(robot.table, values), q).transform
    np.testing.assert_allclose(by_table, by_chain, atol=1e-12)
    derived = bind(modified_dh_from_scm(robot.chain.read.chain), lengths)
    np.testing.assert_allclose(forward_kinematics(derived, q).transform, by_chain, atol=1e-12)


@ROBOTS
def test_the_chain_is_the_product_of_its_elementary_motions(robot):
    """Written out matrix by matrix from the cells as printed, without the package's own reading of them."""
    lengths = lengths_of_chain(robot) | {"pi": math.pi}
    q = in_radians(robot, robot.reference.joints)
    product = np.eye(4)
    for i, cells in enumerate((*robot.chain.raw.joints, robot.chain.raw.final), start=1):
        names = {f"{letter}{i}" for letter in "adq"}
        for entry in ENTRIES:
            product = product @ elementary(entry, plain_value(cells[entry], names, q[i - 1 : i], lengths))
    np.testing.assert_allclose(product, robot.reference.transform, atol=1e-9)


def plain_value(cell, names, q, lengths):
    if not isinstance(cell, str):
        return cell
    sign = -1 if cell.startswith("-") else 1
    name, _, divisor = cell.lstrip("-").partition("/")
    value = q[0] if q and name in names and name not in lengths else lengths[name]
    return sign * value / float(divisor or 1)


@ROBOTS
def test_the_chain_passes_the_documents_own_check(robot):
    assert verify(robot.chain.read.chain) == ()


@ROBOTS
def test_no_parameter_is_idle(robot):
    assert set(table_parameters(robot.table.table)) == set(robot.parameters)
    assert set(robot.chain.parameters.values()) == set(robot.parameters)


@pytest.mark.parametrize("robot_id", PRINTED_AS_CHAINS)
def test_the_chain_document_is_cited_with_its_equation(robot_id):
    source = catalogue.robot(robot_id).source
    assert "Nascimento" in source.document
    assert "eq. 3." in source.place
    assert f"scm_{robot_id.removesuffix('-scm')}" in source.place


@pytest.mark.parametrize(
    ("robot_id", "printed"),
    [
        ("stanford", {"L0": 0.412, "L1": 0.154, "L2": 0.263}),
        ("dmra", {"a1": 45, "a2": 115, "a3": 20, "d1": 75, "d4": 130, "d6": 50}),
        ("puma560", {"a2": 0.4318, "a3": 0.0203, "d3": 0.15005, "d4": 0.4318}),
        ("rx90", {"D3": 0.45, "RL4": 0.45}),
        ("ur5", {"d1": 0.089159, "a2": -0.425, "a3": -0.39225, "d4": 0.10915, "d5": 0.09465, "d6": 0.0823}),
        ("ur10", {"d1": 0.1273, "a2": -0.612, "a3": -0.5723, "d4": 0.163941, "d5": 0.1157, "d6": 0.0922}),
        ("panda", {"d1": 0.333, "d3": 0.316, "a4": 0.0825, "d5": 0.384, "a7": 0.088, "df": 0.107}),
        ("iiwa14", {"d1": 0.36, "d3": 0.42, "d5": 0.4, "d7": 0.126}),
        ("irb140", {"d1": 0.352, "a1": 0.07, "a2": 0.36, "d4": 0.38, "d6": 0.065}),
        ("lrmate200id", {"a1": 0.05, "a2": 0.33, "a3": 0.035, "d4": 0.335, "d6": 0.08}),
    ],
)
def test_figures_are_those_of_the_source(robot_id, printed):
    assert catalogue.robot(robot_id).parameters == printed


@pytest.mark.parametrize(
    ("robot_id", "joints", "position"),
    [
        # what the makers print of poses and heights [m]
        ("ur5", [0, -90, 0, -90, 0, 0], (0, -0.19145, 1.001059)),
        ("ur10", [0, -90, 0, -90, 0, 0], (0, -0.256141, 1.4273)),
        ("iiwa14", [0] * 7, (0, 0, 1.306)),
        ("irb140", [0] * 6, (0.515, 0, 0.712)),
        ("gen3", [0] * 7, (0, -0.0246, 1.1873)),
        ("lrmate200id", [0] * 6, (0.465, 0, 0.365)),
    ],
)
def test_poses_that_the_makers_print(robot_id, joints, position):
    robot = catalogue.robot(robot_id)
    found = pose(robot, in_radians(robot, joints))[:3, 3]
    np.testing.assert_allclose(found, position, atol=1e-9)


SSRMS_AXES = [
    # Direction of the axis and a point on it at zero [m], as TraceableRobotModels gives them after Nguyen and
    # Hughes (1994): x along the booms, z along the yaw axes, y along the pitch axes.
    ("x", (1.3589, 0, 0)),
    ("z", (1.3589, 0, 0.7026)),
    ("y", (1.3589, -0.5692, 0.7026)),
    ("y", (1.3589 + 7.11, -0.5692 - 0.475, 0.7026)),
    ("y", (1.3589 + 14.22, -0.5692 - 0.475, 0.7026)),
    ("z", (1.3589 + 14.22, -2 * 0.5692 - 0.475, 0.7026)),
    ("x", (1.3589 + 14.22, -2 * 0.5692 - 0.475, 0)),
]


def test_the_axes_of_the_ssrms_are_the_published_ones():
    robot = catalogue.robot("ssrms")
    frames = forward_kinematics(bind_parameters(robot.table, robot.parameters), [0.0] * 7).frames
    before = [np.eye(4), *frames[:-1]]
    ours = {"x": (0, 0, 1), "y": (1, 0, 0), "z": (0, 1, 0)}  # their directions in the table's frame 0
    for frame, (axis, (x, y, z)) in zip(before, SSRMS_AXES, strict=True):
        direction, point = np.array(ours[axis], dtype=float), np.array([y, z, x])
        np.testing.assert_allclose(np.cross(frame[:3, 2], direction), 0, atol=1e-12)
        np.testing.assert_allclose(np.cross(direction, frame[:3, 3] - point), 0, atol=1e-12)
    tip = frames[-1][:3, 3]
    np.testing.assert_allclose(tip, [-2 * 0.5692 - 0.475, 0, 2 * 1.3589 + 14.22], atol=1e-12)


def test_the_puma_is_the_robot_of_both_documents_that_draw_it():
    """Facts of both figures: axes 1 and 2 perpendicular, 2 and 3 parallel, the wrist spherical."""
    robot = catalogue.robot("puma560")
    frames = forward_kinematics(bind_parameters(robot.table, robot.parameters), [0.3] * 6).frames
    z = [np.array([0, 0, 1.0]), *(frame[:3, 2] for frame in frames)]
    origin = [np.zeros(3), *(frame[:3, 3] for frame in frames)]
    np.testing.assert_allclose(np.cross(z[1], z[2]), 0, atol=1e-12)
    assert abs(z[0] @ z[1]) < 1e-12
    np.testing.assert_allclose(origin[4], origin[5], atol=1e-12)
    np.testing.assert_allclose(origin[5], origin[6], atol=1e-12)


def test_a_file_that_is_not_toml():
    with pytest.raises(DescriptionError) as caught:
        catalogue.read_robot("arm", "name = ")
    assert caught.value.faults[0].where == ("arm.toml",)
