"""Every catalogue file: the DH table against the SCM chain, the named configurations, the written pose."""

import math

import numpy as np
import pytest

from kinematics.catalogue import read_robot, robot, robot_ids
from kinematics.cells import bind_parameters
from kinematics.errors import DescriptionError
from kinematics.forward import forward_kinematics
from kinematics.scm import forward_kinematics_scm, modified_dh_from_scm, verify
from kinematics.table import JointType, bind

IDS = """cloos dmra kr100p kr125 kr2150k onelink puma560 puma600 rx90 scara scara-scm
scorbot ssrms stanford twolink uw""".split()  # noqa: SIM905


def test_the_sixteen_robots_are_there():
    assert set(IDS) <= set(robot_ids())


@pytest.fixture(params=robot_ids())
def arm(request):
    return robot(request.param)


def radians(arm, joints):
    types = arm.table.table.joint_types
    return [
        math.radians(q) if kind is JointType.REVOLUTE else q for q, kind in zip(joints, types, strict=True)
    ]


def pose(arm, q):
    return forward_kinematics(bind_parameters(arm.table, arm.parameters), q).transform


def chain_pose(arm, q):
    lengths = {name: arm.parameters[ours] for name, ours in arm.chain.parameters.items()}
    return forward_kinematics_scm(arm.chain.read.chain, q, lengths).transform


def test_written_pose(arm):
    q = radians(arm, arm.reference.joints)
    size = 1 + np.abs(arm.reference.transform).max()
    np.testing.assert_allclose(pose(arm, q), arm.reference.transform, atol=1e-11 * size)
    np.testing.assert_allclose(chain_pose(arm, q), arm.reference.transform, atol=1e-11 * size)


def test_table_and_chain_are_one_robot(arm):
    random = np.random.default_rng(7)
    size = 1 + max(arm.parameters.values(), default=0)
    for _ in range(25):
        q = random.uniform(-7, 7, arm.table.table.n_joints)
        np.testing.assert_allclose(pose(arm, q), chain_pose(arm, q), atol=1e-12 * size)


def test_configurations(arm):
    assert "zero" in arm.configurations
    size = 1 + max(arm.parameters.values(), default=0)
    for configuration in arm.configurations.values():
        q = radians(arm, configuration.joints)
        np.testing.assert_allclose(pose(arm, q), chain_pose(arm, q), atol=1e-12 * size)
        assert len(configuration.meaning) > 10


def test_chain_passes_the_toolbox_check(arm):
    assert not verify(arm.chain.read.chain)


def test_sources_are_named(arm):
    assert len(arm.source.document) > 10
    assert len(arm.source.place) > 5
    assert len(arm.source.figures) > 10


@pytest.mark.parametrize(
    "robot_id", [i for i in IDS if i not in {"puma560", "scara", "rx90", "dmra", "ssrms"}]
)
def test_tables_of_document_001_are_what_scm2dh_makes(robot_id):
    arm = robot(robot_id)
    derived = bind(modified_dh_from_scm(arm.chain.read.chain), arm.parameters)
    written = bind_parameters(arm.table, arm.parameters)
    assert derived.joint_types == written.joint_types
    for ours, theirs in zip(written.rows, derived.rows, strict=True):
        np.testing.assert_allclose(
            [ours.alpha, ours.a, ours.d, ours.theta, ours.sign],
            [theirs.alpha, theirs.a, theirs.d, theirs.theta, theirs.sign],
            atol=1e-15,
        )


GOOD = """
name = "Arm"
[source]
document = "a book"
place = "a page"
figures = "as printed"
[table]
convention = "standard"
angle_unit = "deg"
length_unit = "m"
rows = [{ joint = "revolute", theta = "q1", d = 0, a = "L1", alpha = 0 }]
[parameters]
L1 = 1
[limits]
joints = [[-10, 10]]
[configurations.zero]
joints = [0]
meaning = "stretched"
[reference]
derivation = "by hand"
joints = [0]
transform = [[1, 0, 0, 1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
"""


def test_a_new_file_is_read():
    assert read_robot("arm", GOOD).limits == ((-10.0, 10.0),)


@pytest.mark.parametrize(
    ("old", "new", "code", "where"),
    [
        ("name =", "name", "file_not_toml", ()),
        ('name = "Arm"', "", "key_missing", ("name",)),
        ('place = "a page"', 'palce = "a page"', "key_missing", ("source", "place")),
        ('"standard"', '"craig"', "key_type", ("table", "convention")),
        ('"L1", alpha', '"L1 +", alpha', None, ("table", "rows", 0, "a")),
        ("L1 = 1", "L2 = 1", None, ("parameters", "L2")),
        ("L1 = 1", "L1 = nan", "key_type", ("parameters", "L1")),
        ("[[-10, 10]]", "[[10, -10]]", "limits_reversed", ("limits", "joints", 0)),
        ("[[-10, 10]]", "[[-10, 10], [1, 2]]", "joints_wrong_length", ("limits", "joints")),
        (
            "joints = [0]\nmeaning",
            "joints = [20]\nmeaning",
            "outside_limits",
            ("configurations", "zero", "joints", 0),
        ),
        ("[[1, 0, 0, 1], [0, 1", "[[1, 0, 0, 1], [0, 2", None, ("reference", "transform")),
    ],
)
def test_faults_carry_the_file_and_the_key(old, new, code, where):
    assert old in GOOD
    with pytest.raises(DescriptionError) as refusal:
        read_robot("arm", GOOD.replace(old, new))
    places = [fault.where for fault in refusal.value.faults]
    assert ("arm.toml", *where) in [place[: len(where) + 1] for place in places]
    assert code is None or code in {fault.code for fault in refusal.value.faults}
