"""A table as URDF has the table's poses in a foreign library."""

import math
import re
from dataclasses import replace

import numpy as np
import pytest
from defusedxml.ElementTree import fromstring
from hypothesis import example, given
from hypothesis import strategies as st

from kinematics import catalogue, end_poses
from kinematics.cells import bind_parameters
from kinematics.errors import DescriptionError, JointValueError, PoseError
from kinematics.table import Convention, DHTable, JointType
from kinematics.urdf import table_from_urdf, urdf_from_table
from tests.kinematics.robots import PRISMATIC_ENDS, PUMA560, SCARA_RRPR, numeric
from tests.kinematics.strategies import tables, transforms
from tests.kinematics.urdf.foreign import foreign_poses


def random_joints(table, count, seed=0):
    rng = np.random.default_rng(seed)
    return rng.uniform(-3.0, 3.0, (count, table.n_joints))


@pytest.mark.parametrize("robot_id", catalogue.robot_ids())
def test_every_robot_there_and_back(robot_id):
    """Table → URDF → table, each against the foreign library's poses [m]."""
    listed = catalogue.robot(robot_id)
    table = bind_parameters(listed.table, listed.parameters)
    metres = float(listed.table.length_unit.metres_per_unit)
    written = urdf_from_table(table, name=robot_id, metres_per_unit=metres)
    joints = random_joints(table, 25)
    foreign = foreign_poses(written.text, joints, written.base_link, written.tip_link)
    own = joints / [metres if kind is JointType.PRISMATIC else 1.0 for kind in table.joint_types]
    poses = end_poses(table, own)
    poses[:, :3, 3] *= metres
    size = max(1.0, float(np.abs(poses[:, :3, 3]).max()))
    np.testing.assert_allclose(foreign, poses, atol=1e-12 * size, rtol=0)
    for convention in Convention:
        back = table_from_urdf(written.text, convention)
        assert back.name == robot_id
        assert back.joints == tuple(f"joint_{i}" for i in range(1, table.n_joints + 1))
        again = end_poses(back.table, joints, base=back.base, tool=back.tool)
        np.testing.assert_allclose(again, foreign, atol=1e-12 * size, rtol=0)


@example(numeric(Convention.STANDARD, ("revolute", 0.0, 0.0, 1.19e-10, 0.0)), np.eye(4), np.eye(4), 0.001)
@given(tables(max_rows=7), transforms(), transforms(), st.sampled_from([1.0, 0.001, 0.0254]))
def test_any_table_has_the_same_poses(table, base, tool, metres):
    written = urdf_from_table(table, base=base, tool=tool, metres_per_unit=metres)
    joints = random_joints(table, 4)
    foreign = foreign_poses(written.text, joints, written.base_link, written.tip_link)
    own = joints / [metres if kind is JointType.PRISMATIC else 1.0 for kind in table.joint_types]
    poses = end_poses(table, own.reshape(4, -1), base=base, tool=tool)
    poses[:, :3, 3] *= metres
    size = 1.0 + sum(abs(row.a) + abs(row.d) for row in table.rows) * metres
    np.testing.assert_allclose(foreign, poses, atol=4e-12 * size, rtol=0)


def elements(text):
    return {joint.get("name"): joint for joint in fromstring(text).findall("joint")}


def test_limits_become_metres_and_unlimited_joints_turn_on():
    table = replace(SCARA_RRPR, rows=SCARA_RRPR.rows)
    limits = [(-1.0, 2.0), None, (100.0, 400.0), (None, 3.0)]
    written = urdf_from_table(table, limits=limits, metres_per_unit=0.001)
    found = elements(written.text)
    kinds = [found[f"joint_{i}"].get("type") for i in range(1, 5)]
    assert kinds == ["revolute", "continuous", "prismatic", "revolute"]
    assert found["joint_1"].find("limit").attrib["lower"] == "-1"
    slide = found["joint_3"].find("limit").attrib
    assert (float(slide["lower"]), float(slide["upper"])) == pytest.approx((0.1, 0.4))
    assert written.assumed_limits == (4,)
    back = table_from_urdf(written.text, Convention.STANDARD).limits
    assert back == ((-1.0, 2.0), None, (0.1, 0.4), (None, 3.0))


def test_a_slide_of_unknown_limits_is_told_of():
    written = urdf_from_table(PRISMATIC_ENDS)
    assert written.assumed_limits == (1, 3)
    assert written.text.count("stands for none") == 2
    assert elements(written.text)["joint_1"].find("limit").attrib["upper"] == "1e+16"


def test_a_reversed_variable_is_a_reversed_axis():
    rows = (replace(PUMA560.rows[0], sign=-1), *PUMA560.rows[1:])
    found = elements(urdf_from_table(replace(PUMA560, rows=rows)).text)
    assert found["joint_1"].find("axis").get("xyz") == "0 0 -1"
    assert found["joint_2"].find("axis").get("xyz") == "0 0 1"


def test_right_angles_and_zeros_are_exact():
    """A row's α and θ are the roll and yaw of its origin, digit for digit."""
    found = elements(urdf_from_table(PUMA560).text)
    assert found["joint_2"].find("origin").attrib == {"xyz": "0 0 0", "rpy": f"{math.pi / 2!r} 0 0"}
    assert found["joint_3"].find("origin").attrib == {"xyz": "0.4318 0 0", "rpy": "0 0 0"}


def test_fixed_rows_are_fixed_joints():
    lifted = np.eye(4)
    lifted[2, 3] = 0.1
    found = elements(urdf_from_table(PRISMATIC_ENDS, base=lifted, tool=np.eye(4)).text)
    kinds = [joint.get("type") for joint in found.values()]
    assert list(found) == ["fixed_base", "joint_1", "fixed_row_2", "joint_2", "joint_3", "fixed_tool"]
    assert kinds == ["fixed", "prismatic", "fixed", "continuous", "prismatic", "fixed"]


def test_a_name_cannot_break_out():
    name = "a\"/><link name='x'/>&<b>"
    assert table_from_urdf(urdf_from_table(PUMA560, name=name).text, Convention.STANDARD).name == name


@pytest.mark.parametrize("name", ["", "  ", "two\nlines", "\x00"])
def test_names_that_are_none(name):
    with pytest.raises(DescriptionError) as refusal:
        urdf_from_table(PUMA560, name=name)
    assert refusal.value.code == "urdf_name_invalid"


def test_what_else_is_refused():
    with pytest.raises(JointValueError):
        urdf_from_table(PUMA560, limits=[None])
    with pytest.raises(JointValueError):
        urdf_from_table(PUMA560, limits=[(1.0, -1.0), *[None] * 5])
    with pytest.raises(PoseError):
        urdf_from_table(PUMA560, tool=np.ones((4, 4)))
    far = numeric(Convention.STANDARD, ("revolute", 0.0, 1e300, 0.0, 0.0))
    with pytest.raises(DescriptionError) as refusal:
        urdf_from_table(far, metres_per_unit=1e300)
    assert refusal.value.code == "urdf_length_overflow"


def test_names_and_limits_survive():
    names, limits = ("base turn", "lift", "elbow"), ((-1.0, 2.0), (None, 0.25), None)
    kinds = ("revolute", "prismatic", "revolute")
    table = numeric(Convention.MODIFIED, *((kind, 0.3, 0.2, 0.1, 0.0) for kind in kinds))
    first = table_from_urdf(
        urdf_from_table(table, name="arm 1", limits=limits, joint_names=names).text, Convention.STANDARD
    )
    again = table_from_urdf(
        urdf_from_table(
            first.table, name=first.name, base=first.base, tool=first.tool,
            limits=first.limits, joint_names=first.joints,
        ).text,
        Convention.STANDARD,
    )  # fmt: skip
    for found in (first, again):
        assert (found.name, found.joints, found.limits) == ("arm 1", names, limits)
    joints = random_joints(table, 4)
    one, two = (end_poses(r.table, joints, base=r.base, tool=r.tool) for r in (first, again))
    np.testing.assert_allclose(one, two, atol=1e-14)


@pytest.mark.parametrize("convention", Convention)
@pytest.mark.parametrize("kind", ["revolute", "prismatic"])
@pytest.mark.parametrize("axis", ["0 0 -1", "0 1 0", "-1 0 0", "0.6 0 -0.8"])
def test_the_last_link_keeps_its_name_whatever_its_axis(convention, kind, axis):
    text = (
        '<robot name="r"><link name="a"/><link name="b"/><link name="c"/>'
        '<joint name="j" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint>'
        f'<joint name="k" type="{kind}"><parent link="b"/><child link="c"/><axis xyz="{axis}"/>'
        '<origin xyz="0.1 0.2 0.3" rpy="0.4 -0.5 0.6"/><limit lower="-1" upper="2"/></joint></robot>'
    )
    found = table_from_urdf(text, convention)
    written = urdf_from_table(
        found.table, base=found.base, tool=found.tool, limits=found.limits,
        joint_names=found.joints, link_names=found.links,
        base_link=found.base_link, tip_link=found.tip_link,
    )  # fmt: skip
    back = table_from_urdf(written.text, convention)
    assert (back.joints, back.links, back.limits) == (("j", "k"), ("b", "c"), found.limits)
    joints = random_joints(found.table, 5)
    np.testing.assert_allclose(
        foreign_poses(written.text, joints, "a", "c"), foreign_poses(text, joints, "a", "c"), atol=1e-12
    )


def test_links_keep_their_names():
    """The last joint carries the tip, as long as nothing constant comes to stand behind it."""
    links = ["boom", "row_2", "flange"]
    rows = [(kind, 0.3, 0.2, 0.1, 0.0) for kind in ("revolute", "prismatic", "revolute")]
    table = numeric(Convention.MODIFIED, rows[0], ("fixed", 0.1, 0.2, 0.3, 0.4), *rows[1:])
    first = urdf_from_table(table, link_names=links, tip_link="flange")
    assert re.findall('<link name="([^"]+)"', first.text) == [
        "base_link",
        "boom",
        "row_2_",
        "row_2",
        "flange",
    ]
    back = table_from_urdf(first.text, Convention.MODIFIED)
    assert back.links == tuple(links)
    behind = np.eye(4)
    behind[0, 3] = 0.5
    apart = urdf_from_table(table, link_names=links, tip_link="flange", tool=behind).text
    assert re.findall('<link name="([^"]+)"', apart)[-2:] == ["flange_", "flange"]
    upwards = table_from_urdf(first.text, Convention.STANDARD, base_link="flange", tip_link="base_link")
    assert upwards.links == ("row_2", "row_2_", "base_link")


@pytest.mark.parametrize("names", [["a"], ["a", "a"]])
def test_link_names_that_do_not_fit(names):
    table = numeric(Convention.MODIFIED, *[("revolute", 0.3, 0.2, 0.1, 0.0)] * 2)
    with pytest.raises(DescriptionError) as refusal:
        urdf_from_table(table, link_names=names)
    assert refusal.value.code == "urdf_link_names"


@pytest.mark.parametrize("names", [["a"], ["a", "a"], ["a", "fixed_tool"], ["fixed_row_2", "b"]])
def test_joint_names_that_do_not_fit(names):
    table = numeric(Convention.MODIFIED, *[("revolute", 0.3, 0.2, 0.1, 0.0)] * 2)
    with pytest.raises(DescriptionError) as refusal:
        urdf_from_table(table, joint_names=names)
    assert refusal.value.code == "urdf_joint_names"


def test_a_table_without_rows_is_a_fixed_tool():
    written = urdf_from_table(DHTable(convention=Convention.STANDARD, rows=()))
    assert [joint.get("type") for joint in fromstring(written.text).findall("joint")] == ["fixed"]
