"""URDF chains to tables: the same poses as a foreign library's, and what is refused."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics import end_poses
from kinematics.errors import DescriptionError
from kinematics.table import Convention, JointType
from kinematics.urdf import chain_from_urdf, table_from_urdf
from tests.kinematics.urdf.foreign import foreign_poses


def joint(name, parent, child, kind="continuous", inner='<axis xyz="0 0 1"/>'):
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>{inner}</joint>'
    )


def robot(*joints, links="abcdefgh", name="arm"):
    declared = "".join(f'<link name="{link}"/>' for link in links)
    return f'<robot name="{name}">{declared}{"".join(joints)}</robot>'


angles = st.one_of(
    st.sampled_from([0.0, math.pi / 2, -math.pi / 2, math.pi, 1.5707963, 1.57, 7e-4, -3e-6, 3.1416]),
    st.floats(-4.0, 4.0),
)
lengths = st.one_of(st.sampled_from([0.0, 0.4318, -0.1, 1.0]), st.floats(-2.0, 2.0))
axes = st.one_of(
    st.sampled_from([(0, 0, 1), (0, 0, -1), (1, 0, 0), (0, -1, 0), (0, 0, 5), (0, 1, 1e-3), (0, 0, 1e-7)]),
    st.tuples(*[st.floats(-1.0, 1.0)] * 3).filter(lambda v: math.hypot(*v) > 1e-2),
)


@st.composite
def chains(draw):
    """A serial chain with fixed joints anywhere and at least one that moves."""
    kinds = draw(st.lists(st.sampled_from(["revolute", "continuous", "prismatic", "fixed"]), max_size=6))
    kinds.insert(draw(st.integers(0, len(kinds))), "continuous")
    joints = []
    for i, kind in enumerate(kinds):
        xyz = " ".join(repr(draw(lengths)) for _ in range(3))
        rpy = " ".join(repr(draw(angles)) for _ in range(3))
        inner = f'<origin xyz="{xyz}" rpy="{rpy}"/>'
        if kind != "fixed":
            axis = np.array(draw(axes))
            if kind == "prismatic":  # the foreign library slides by multiples of the axis as it is written
                axis = axis / np.linalg.norm(axis)
            inner += f'<axis xyz="{" ".join(map(repr, axis.tolist()))}"/>'
        if kind in ("revolute", "prismatic"):
            inner += '<limit lower="-9" upper="9" effort="1" velocity="1"/>'
        joints.append(joint(f"j{i}", f"l{i}", f"l{i + 1}", kind, inner))
    moving = sum(kind != "fixed" for kind in kinds)
    return robot(*joints, links=[f"l{i}" for i in range(len(kinds) + 1)]), moving, f"l{len(kinds)}"


@given(chains(), st.sampled_from(Convention))
def test_nothing_is_lost(chain, convention):
    """Angles within 1e-10 of one another count as the same, so 1e-9; most chains are at rounding."""
    text, moving, tip = chain
    found = table_from_urdf(text, convention)
    assert found.table.convention is convention
    assert (found.base_link, found.tip_link, len(found.joints)) == ("l0", tip, moving)
    joints = np.random.default_rng(1).uniform(-3.0, 3.0, (4, moving))
    poses = end_poses(found.table, joints, base=found.base, tool=found.tool)
    foreign = foreign_poses(text, joints, "l0", tip)
    np.testing.assert_allclose(poses, foreign, atol=1e-9, rtol=0)


@pytest.mark.parametrize("convention", Convention)
def test_general_and_near_parallel_axes_stay_exact(convention):
    """Tilts of 1e-3 to 1e-6 rad, as calibrated arms have them: at rounding, with dummy rows."""
    rng = np.random.default_rng(7)
    for tilt in (1e-6, 7e-4, 4e-3, 0.3):
        joints = [
            joint(
                f"j{i}",
                "abcdefgh"[i],
                "abcdefgh"[i + 1],
                inner=f'<origin xyz="{x} {y} {z}" rpy="{tilt} {-tilt / 3} 0.4"/><axis xyz="0 0 1"/>',
            )
            for i, (x, y, z) in enumerate(rng.uniform(-1, 1, (7, 3)))
        ]
        text = robot(*joints)
        found = table_from_urdf(text, convention)
        fixed = sum(row.joint is JointType.FIXED for row in found.table.rows)
        assert fixed == (0 if tilt > 5e-3 else 6)
        assert max(abs(row.d) for row in found.table.rows) < 10
        q = rng.uniform(-3, 3, (10, 7))
        poses = end_poses(found.table, q, base=found.base, tool=found.tool)
        np.testing.assert_allclose(poses, foreign_poses(text, q, "a", "h"), atol=1e-11, rtol=0)


def test_a_chain_of_a_tree_is_chosen_by_its_ends():
    text = robot(
        joint("turn", "a", "b"),
        joint("camera", "b", "c", "floating"),
        joint("lift", "b", "d", "prismatic", '<axis xyz="0 1 0"/><limit lower="-1" upper="2"/>'),
        joint(
            "finger",
            "d",
            "e",
            "revolute",
            '<axis xyz="0 1 0"/><limit lower="0" upper="1"/><mimic joint="x"/>',
        ),
        joint("grip", "d", "f", "fixed", '<origin xyz="0 0 0.1"/>'),
        links="abcdef",
    )
    found = table_from_urdf(text, Convention.MODIFIED, tip_link="f")
    assert found.joints == ("turn", "lift")
    assert found.limits == (None, (-1.0, 2.0))
    part = table_from_urdf(text, Convention.MODIFIED, base_link="b", tip_link="f")
    assert part.joints == ("lift",)


def test_two_joints_that_follow_one_outside_the_chain_are_refused():
    text, _ = REFUSED["two that follow another"]
    with pytest.raises(DescriptionError) as refusal:
        table_from_urdf(text, Convention.STANDARD, tip_link="c")
    assert refusal.value.code == "urdf_mimic"
    assert refusal.value.faults[0].params == {"joint": "l", "other": "k"}


def mimicking(*followed):
    """Return a chain whose joints j, k, l follow the joints of these names."""
    inner = [f'<axis xyz="0 0 1"/><mimic joint="{other}"/>' if other else "" for other in followed]
    parts = zip("jkl", "abc", "bcd", inner, strict=True)
    return robot(*(joint(*ends, inner=inside) for *ends, inside in parts), links="abcd")


@pytest.mark.parametrize(
    ("followed", "told", "circle"),
    [
        (("j", "", ""), "j", ("j",)),
        (("k", "j", ""), "j", ("j", "k")),
        (("k", "l", "k"), "j", ("k", "l")),
        (("l", "j", "k"), "j", ("j", "l", "k")),
    ],
)
def test_joints_that_follow_one_another_in_a_circle_are_told(followed, told, circle):
    with pytest.raises(DescriptionError) as refusal:
        table_from_urdf(mimicking(*followed), Convention.STANDARD)
    assert refusal.value.code == "urdf_mimic_circle"
    assert refusal.value.faults[0].params == {"joint": told, "circle": circle}


def test_the_two_joints_that_move_as_one_are_both_in_the_chain():
    """j follows k, which is above the chain, and so does l: in the chain are j and l."""
    text = robot(
        joint("k", "a", "x"),
        joint("m", "a", "y", inner='<mimic joint="k"/>'),
        joint("j", "a", "b", inner='<mimic joint="m"/>'),
        joint("l", "b", "c", inner='<mimic joint="k"/>'),
        links="abcxy",
    )
    with pytest.raises(DescriptionError) as refusal:
        table_from_urdf(text, Convention.STANDARD, tip_link="c")
    assert refusal.value.faults[0].params == {"joint": "l", "other": "j"}


def test_links_that_nothing_connects_are_refused():
    text = robot(joint("j", "a", "b"), joint("k", "c", "d"), links="abcd")
    with pytest.raises(DescriptionError) as refusal:
        table_from_urdf(text, Convention.STANDARD, base_link="a", tip_link="d")
    assert refusal.value.code == "urdf_no_path"


def test_a_finger_alone_is_a_joint_of_its_own():
    text = robot(
        joint("left", "a", "b", "prismatic", '<axis xyz="0 1 0"/><limit lower="0" upper="0.04"/>'),
        joint(
            "right", "a", "c", "prismatic", '<axis xyz="0 -1 0"/><mimic joint="left"/><limit upper="0.04"/>'
        ),
        links="abc",
    )
    found = table_from_urdf(text, Convention.MODIFIED, tip_link="c")
    assert found.joints == ("right",)
    assert found.limits == ((0.0, 0.04),)
    poses = end_poses(found.table, [[0.03]], base=found.base, tool=found.tool)
    np.testing.assert_allclose(poses[0, :3, 3], [0, -0.03, 0], atol=1e-15)


def test_a_joint_that_follows_by_nothing_stands_at_its_offset():
    text = robot(
        joint("j", "a", "b", inner='<axis xyz="0 0 1"/><mimic joint="k" multiplier="0" offset="0.5"/>'),
        joint("k", "b", "c", inner='<origin xyz="1 0 0"/><axis xyz="0 0 1"/>'),
        links="abc",
    )
    found = table_from_urdf(text, Convention.MODIFIED)
    assert found.joints == ("k",)
    pose = end_poses(found.table, [[0.0]], base=found.base, tool=found.tool)[0]
    np.testing.assert_allclose(pose[:2, 3], [math.cos(0.5), math.sin(0.5)], atol=1e-15)


@pytest.mark.parametrize(
    ("kind", "held_by", "stands"),
    [("fixed", "", 0.0), ("revolute", '<mimic joint="j" multiplier="0" offset="0.2"/>', 0.2)],
)
def test_a_joint_that_follows_one_that_stands_still_stands_still_too(kind, held_by, stands):
    text = robot(
        joint("j", "a", "b", inner='<axis xyz="0 0 1"/>'),
        joint("held", "a", "s", kind, '<axis xyz="0 0 1"/>' + held_by),
        joint("f", "b", "c", inner='<axis xyz="0 0 1"/><mimic joint="held" multiplier="3" offset="0.5"/>'),
        joint("end", "c", "d", "fixed", '<origin xyz="1 0 0"/>'),
        links="abcds",
    )
    for base_link, tip_link, sign in (("a", "d", 1.0), ("c", "a", -1.0)):
        found = table_from_urdf(text, Convention.STANDARD, base_link=base_link, tip_link=tip_link)
        assert found.joints == ("j",)
        pose = end_poses(found.table, [[0.0]], base=found.base, tool=found.tool)[0]
        angle = sign * (3 * stands + 0.5)
        np.testing.assert_allclose(pose[:2, 0], [math.cos(angle), math.sin(angle)], atol=1e-15)


def test_a_quaternion_is_an_orientation():
    half = math.sqrt(0.5)
    by_angles = robot(
        joint("j", "a", "b", inner='<origin xyz="1 2 3" rpy="0 0 1.5707963267948966"/>'), links="ab"
    )
    text = by_angles.replace('rpy="0 0 1.5707963267948966"', f'quat_xyzw="0 0 {half} {half}"')
    ours, theirs = (chain_from_urdf(one).chain.end for one in (text, by_angles))
    np.testing.assert_allclose(ours, theirs, atol=1e-15)


@pytest.mark.parametrize("bound", ["1e16", "inf", "Infinity", "1.7976931348623157e308"])
def test_limits_that_stand_for_none(bound):
    limit = '<axis xyz="0 0 1"/><limit lower="-{}" upper="{}"/>'
    text = robot(
        joint("both", "a", "b", "revolute", limit.format(bound, bound)),
        joint("one", "b", "c", "prismatic", limit.format("0.5", bound)),
        joint("none", "c", "d", "prismatic", limit.format(bound, bound)),
        links="abcd",
    )
    found = table_from_urdf(text, Convention.MODIFIED)
    assert found.limits == (None, (-0.5, None), None)


@pytest.mark.parametrize("convention", Convention)
@pytest.mark.parametrize(("base", "tip"), [("f", "d"), ("d", "a"), ("f", "b")])
def test_a_chain_may_climb_to_a_branch(base, tip, convention):
    """From hand to hand of a torso with two arms: the inverse of one path times the other."""
    text = robot(
        joint("waist", "a", "b", inner='<origin xyz="0 0 0.5"/><axis xyz="0 0 1"/>'),
        joint("left", "b", "c", inner='<origin xyz="0 0.3 0" rpy="0.3 0 0"/><axis xyz="1 0 0"/>'),
        joint("slide", "c", "d", "prismatic", '<origin xyz="0.2 0 0"/><axis xyz="0 0 1"/><limit upper="1"/>'),
        joint("right", "b", "e", inner='<origin xyz="0 -0.3 0" rpy="0 0.7 0"/><axis xyz="0 1 0"/>'),
        joint("palm", "e", "f", "fixed", '<origin xyz="0 0 -0.4" rpy="0 0 1"/>'),
        links="abcdef",
    )
    found = table_from_urdf(text, convention, base_link=base, tip_link=tip)
    values = {"waist": 0.4, "left": -0.8, "slide": 0.25, "right": 1.1}
    assert (found.base_link, found.tip_link) == (base, tip)
    own = [[values[name] for name in found.joints]]
    pose = end_poses(found.table, own, base=found.base, tool=found.tool)[0]
    roots = {
        "a": np.eye(4),
        "b": foreign_poses(text, np.array([[0.4]]), "a", "b")[0],
        "d": foreign_poses(text, np.array([[0.4, -0.8, 0.25]]), "a", "d")[0],
        "f": foreign_poses(text, np.array([[0.4, 1.1]]), "a", "f")[0],
    }
    np.testing.assert_allclose(pose, np.linalg.inv(roots[base]) @ roots[tip], atol=1e-12)


def test_a_default_namespace_is_that_of_the_format():
    plain = robot(joint("j", "a", "b", inner='<origin xyz="0 0 1"/><axis xyz="0 1 0"/>'), links="ab")
    named = plain.replace("<robot", '<robot xmlns="http://drake.mit.edu"', 1)
    read, expected = (table_from_urdf(text, Convention.STANDARD) for text in (named, plain))
    assert (read.table, read.joints) == (expected.table, expected.joints)


def test_a_root_in_a_namespace_is_told_by_its_name():
    with pytest.raises(DescriptionError) as refused:
        table_from_urdf('<model xmlns="http://x"/>', Convention.STANDARD)
    assert refused.value.faults[0].params == {"found": "model"}


def test_the_axis_is_x_if_left_out():
    found = table_from_urdf(robot(joint("j", "a", "b", inner=""), links="ab"), Convention.STANDARD)
    z = found.base[:3, 2]
    assert z.tolist() == pytest.approx([1, 0, 0])


HALF = robot(joint("j", "a", "b"), links="ab")
BOMB = (
    '<!DOCTYPE r [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;"><!ENTITY c "&b;&b;&b;">]>'
    '<robot name="&c;"><link name="x"/></robot>'
)
REFUSED = {
    "nothing": ("", "urdf_not_xml"),
    "no XML": ("hello", "urdf_not_xml"),
    "unclosed": ("<robot><link name='a'>", "urdf_not_xml"),
    "a null character": ("<robot>\0</robot>", "urdf_not_xml"),
    "half a surrogate": ("<robot name='\ud800'/>", "urdf_not_xml"),
    "entities": (BOMB, "urdf_unsafe"),
    "an external entity": (
        '<!DOCTYPE r [<!ENTITY x SYSTEM "file:///etc/passwd">]><robot>&x;</robot>',
        "urdf_unsafe",
    ),
    "an external document type": ('<!DOCTYPE robot SYSTEM "http://localhost/x.dtd"><robot/>', "urdf_unsafe"),
    "huge": (HALF + " " * 1_000_001, "urdf_too_long"),
    "deep": ("<robot>" + "<a>" * 50_000 + "</a>" * 50_000 + "</robot>", "urdf_too_complex"),
    "many": ("<robot>" + "<a/>" * 50_001 + "</robot>", "urdf_too_complex"),
    "another root": ("<sdf/>", "urdf_no_robot"),
    "xacro": (
        '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="x"/></robot>',
        "urdf_is_xacro",
    ),
    "a length that xacro has to put in": (
        robot(joint("j", "a", "b", inner='<origin xyz="${length} 0 0"/>'), links="ab"),
        "urdf_is_xacro",
    ),
    "no links": ('<robot name="x"/>', "urdf_no_links"),
    "a link without a name": ("<robot><link/></robot>", "urdf_name_missing"),
    "two links of a name": (robot(links="aa"), "urdf_name_twice"),
    "two joints of a name": (robot(joint("j", "a", "b"), joint("j", "b", "c")), "urdf_name_twice"),
    "no parent": ('<robot><link name="a"/><joint name="j" type="fixed"/></robot>', "urdf_joint_incomplete"),
    "an unknown link": (robot(joint("j", "a", "z"), links="ab"), "urdf_link_missing"),
    "two parents": (
        robot(joint("j", "a", "c"), joint("k", "b", "c"), links="abc"),
        "urdf_two_parents",
    ),
    "a ring": (robot(joint("j", "a", "b"), joint("k", "b", "a"), links="abc"), "urdf_ring"),
    "a link on itself": (robot(joint("j", "a", "a"), links="a"), "urdf_ring"),
    "two roots": (robot(joint("j", "a", "b"), links="abc"), "urdf_base_needed"),
    "two ends": (robot(joint("j", "a", "b"), joint("k", "a", "c"), links="abc"), "urdf_tip_needed"),
    "nothing moves": (robot(joint("j", "a", "b", "fixed"), links="ab"), "urdf_nothing_moves"),
    "one link": (robot(links="a"), "urdf_nothing_moves"),
    "floating": (robot(joint("j", "a", "b", "floating"), links="ab"), "urdf_several_freedoms"),
    "planar": (robot(joint("j", "a", "b", "planar"), links="ab"), "urdf_several_freedoms"),
    "a screw": (robot(joint("j", "a", "b", "screw"), links="ab"), "urdf_type_unknown"),
    "no type": (robot(joint("j", "a", "b", ""), links="ab"), "urdf_type_unknown"),
    "mimic": (robot(joint("j", "a", "b", inner='<mimic joint="k"/>'), links="ab"), "urdf_mimic_unknown"),
    "a pair of fingers": (
        robot(joint("j", "a", "b"), joint("k", "b", "c", inner='<mimic joint="j"/>'), links="abc"),
        "urdf_mimic",
    ),
    "two that follow another": (
        robot(
            joint("j", "a", "x"),
            joint("k", "a", "b", inner='<mimic joint="j"/>'),
            joint("l", "b", "c", inner='<mimic joint="j" multiplier="-1"/>'),
            links="abcx",
        ),
        "urdf_tip_needed",
    ),
    "followed ever further": (
        robot(
            joint("j", "a", "b", inner='<mimic joint="k" multiplier="1e6"/>'),
            joint("k", "b", "c", inner='<mimic joint="l" multiplier="1e6"/>'),
            joint("l", "c", "d"),
            links="abcd",
        ),
        "urdf_numbers_malformed",
    ),
    "itself": (robot(joint("j", "a", "b", inner='<mimic joint="j"/>'), links="ab"), "urdf_mimic_circle"),
    "an unknown attribute": (
        robot(joint("j", "a", "b", inner='<origin quat="0 0 0 1"/>'), links="ab"),
        "urdf_attribute_unknown",
    ),
    "a misspelled axis": (
        robot(joint("j", "a", "b", inner='<axis xzy="0 0 1"/>'), links="ab"),
        "urdf_attribute_unknown",
    ),
    "a misspelled bound": (
        robot(joint("j", "a", "b", "revolute", '<limit lower="-1" uper="1"/>'), links="ab"),
        "urdf_attribute_unknown",
    ),
    "a misspelled factor": (
        robot(
            joint("k", "a", "b", inner='<mimic joint="l" multiplyer="0"/>'),
            joint("l", "b", "c"),
            links="abc",
        ),
        "urdf_attribute_unknown",
    ),
    "two orientations": (
        robot(joint("j", "a", "b", inner='<origin rpy="0 0 0" quat_xyzw="0 0 0 1"/>'), links="ab"),
        "urdf_two_orientations",
    ),
    "two origins": (
        robot(joint("j", "a", "b", inner='<origin xyz="0 0 1"/><origin xyz="1 0 0"/>'), links="ab"),
        "urdf_element_twice",
    ),
    "two axes": (
        robot(joint("j", "a", "b", inner='<axis xyz="0 0 1"/><axis xyz="1 0 0"/>'), links="ab"),
        "urdf_element_twice",
    ),
    "a zero quaternion": (
        robot(joint("j", "a", "b", inner='<origin quat_xyzw="0 0 0 0"/>'), links="ab"),
        "urdf_quaternion_zero",
    ),
    "no axis": (robot(joint("j", "a", "b", inner='<axis xyz="0 0 0"/>'), links="ab"), "urdf_axis_zero"),
    "two numbers": (
        robot(joint("j", "a", "b", inner='<origin xyz="0 0"/>'), links="ab"),
        "urdf_numbers_malformed",
    ),
    "no number": (
        robot(joint("j", "a", "b", inner='<origin rpy="0 0 pi"/>'), links="ab"),
        "urdf_numbers_malformed",
    ),
    "infinite": (
        robot(joint("j", "a", "b", inner='<origin xyz="0 0 inf"/>'), links="ab"),
        "urdf_numbers_malformed",
    ),
    "too large": (
        robot(joint("j", "a", "b", inner='<origin xyz="0 0 1e300"/>'), links="ab"),
        "urdf_numbers_malformed",
    ),
    "a malformed limit": (
        robot(joint("j", "a", "b", "revolute", '<limit lower="low"/>'), links="ab"),
        "urdf_limit_malformed",
    ),
    "reversed limits": (
        robot(joint("j", "a", "b", "revolute", '<limit lower="1" upper="0"/>'), links="ab"),
        "urdf_limits_reversed",
    ),
    "too many joints": (
        robot(*(joint(f"j{i}", f"l{i}", f"l{i + 1}") for i in range(65)), links=[f"l{i}" for i in range(66)]),
        "urdf_too_many_joints",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_refused(name):
    text, code = REFUSED[name]
    with pytest.raises(DescriptionError) as refusal:
        table_from_urdf(text, Convention.STANDARD)
    assert refusal.value.code == code


@pytest.mark.parametrize(
    ("base", "tip", "code"),
    [
        ("z", None, "urdf_link_unknown"),
        (None, "z", "urdf_link_unknown"),
        ("a", "a", "urdf_nothing_moves"),
    ],
)
def test_ends_that_do_not_fit(base, tip, code):
    with pytest.raises(DescriptionError) as refusal:
        table_from_urdf(HALF, Convention.STANDARD, base_link=base, tip_link=tip)
    assert refusal.value.code == code


def test_a_line_break_before_the_declaration_is_passed_over():
    text = f'\n  <?xml version="1.0"?>\n{HALF}'
    assert table_from_urdf(text, Convention.STANDARD).joints == ("j",)
    with pytest.raises(DescriptionError) as refusal:
        table_from_urdf("\n\n<robot>\n  <link name=a/>\n</robot>", Convention.STANDARD)
    assert refusal.value.faults[0].params["line"] == 4


def test_what_programs_add_to_a_limit_is_passed_over():
    limit = '<limit lower="-1" upper="2" effort="3" current="4" drake:acceleration="6"/>'
    text = robot(joint("j", "a", "b", "revolute", limit), links="ab")
    text = text.replace("<robot", '<robot xmlns:drake="https://drake.mit.edu"')
    assert table_from_urdf(text, Convention.STANDARD).limits == ((-1.0, 2.0),)


def test_where_the_xml_breaks_is_told():
    with pytest.raises(DescriptionError) as refusal:
        table_from_urdf("<robot>\n  <link name=a/>\n</robot>", Convention.STANDARD)
    assert refusal.value.faults[0].params == {"line": 2, "column": 14}


@given(
    st.text(max_size=60)
    | st.text("<>/robotlinkjnme=\"' 01", max_size=80).map(lambda t: f"<robot>{t}</robot>")
)
def test_any_text_is_read_or_refused(text):
    with pytest.raises(DescriptionError):
        table_from_urdf(text, Convention.MODIFIED)
