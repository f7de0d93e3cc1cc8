"""Axes to table: nothing is lost, the rules are the documents', the choices leave fewest parameters."""

import math
import os

import numpy as np
import pytest

from kinematics.errors import DescriptionError, PoseError
from kinematics.forward import forward_kinematics
from kinematics.frames.assigned_frames import Freedom, Rule
from kinematics.frames.assignment import assign_frames
from kinematics.frames.axes import Gripper, JointAxis, gripper_frame
from kinematics.frames.directions import CrossProduct, LengthSigns
from kinematics.frames.exactness import exact_table
from kinematics.frames.parallels import NearParallel
from kinematics.poses import transform_from_xyzabc
from kinematics.table import Convention, DHRow, DHTable, JointType, bind
from tests.kinematics.frames.chains import KINDS, direction_of, motion, random_chain, random_end

CHAINS = int(os.environ.get("FRAMEWISE_CHAINS", "400"))
R, P = JointType.REVOLUTE, JointType.PRISMATIC
X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)

both = pytest.mark.parametrize("convention", list(Convention))


def axes(*triples):
    return [JointAxis(joint=joint, point=point, direction=direction) for joint, point, direction in triples]


def entries(table):
    return [
        (round(math.degrees(row.alpha), 9), row.a, row.d, round(math.degrees(row.theta), 9))
        for row in table.rows
    ]


def discrepancy(chain, convention, result, tool, rng):
    """Largest difference between base · table · tool and the screws, over axes, frames and tool."""
    worst, zero_pose = 0.0, tool
    for q in (np.zeros(len(chain)), rng.normal(size=len(chain))):
        fk = forward_kinematics(result.table, q, base=result.base, tool=result.tool)
        frames = [result.base, *fk.frames]
        moved = np.eye(4)
        for k, axis in enumerate(chain):
            frame = frames[k if convention is Convention.STANDARD else k + 1]
            u = moved[:3, :3] @ direction_of(axis)
            worst = max(worst, np.abs(frame[:3, 2] - u).max())
            if axis.joint is R:
                w = frame[:3, 3] - (moved[:3, :3] @ np.array(axis.point, float) + moved[:3, 3])
                worst = max(worst, np.linalg.norm(w - u * (w @ u)) / (1 + np.abs(w).max()))
            moved = moved @ motion(axis, q[k])
        zero_pose = fk.transform if zero_pose is None else zero_pose
        worst = max(worst, np.abs(moved @ zero_pose - fk.transform).max())
        if not q.any():
            for told, frame in zip(result.frames, frames, strict=True):
                columns = np.column_stack((told.x, told.y, told.z, told.origin))
                worst = max(worst, np.abs(columns - frame[:3]).max() / (1 + np.abs(frame).max()))
    return worst


def discrepancy_of_tool(chain, result, tool, rng):
    """Largest difference of the tool between base · table · tool and the screws."""
    rest = np.zeros(len(chain))
    tool = forward_kinematics(result.table, rest, base=result.base).transform if tool is None else tool
    q = rng.normal(size=len(chain))
    moved = np.eye(4)
    for axis, value in zip(chain, q, strict=True):
        moved = moved @ motion(axis, value)
    got = forward_kinematics(result.table, q, base=result.base, tool=result.tool).transform
    return np.abs(got - moved @ tool).max()


@both
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("prismatic", [0.0, 0.3, 1.0])
def test_random_chains_are_reproduced(convention, kind, prismatic):
    rng = np.random.default_rng([KINDS.index(kind), int(10 * prismatic)])
    for _ in range(math.ceil(CHAINS / 9)):
        chain = random_chain(rng, kind, prismatic)
        base = random_end(rng, chain[0]) if rng.random() < 0.4 else None
        tool = random_end(rng, chain[-1]) if rng.random() < 0.4 else None
        result = assign_frames(chain, convention, base=base, tool=tool)
        assert len(result.table.rows) == len(chain)
        assert len(result.frames) == len(chain) + 1
        if any(warning.code == "near_parallel" for warning in result.warnings):
            lossless = assign_frames(
                chain, convention, base=base, tool=tool, near_parallel=NearParallel.DUMMY_ROW
            )
            assert discrepancy_of_tool(chain, lossless, tool, rng) < 1e-9
            continue
        assert discrepancy(chain, convention, result, tool, rng) < 1e-9


@both
@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_parallel_axes_that_all_but_coincide_are_reproduced(convention, sense):
    """The normal of two such axes is short, and no less perpendicular to them."""
    rng = np.random.default_rng(17)
    for exponent in np.linspace(-9.0, -3.0, 60):
        u, v, w = (x / np.linalg.norm(x) for x in rng.normal(size=(3, 3)))
        across = np.cross(u, w) / np.linalg.norm(np.cross(u, w))
        point = rng.normal(size=3)
        beside = point + 10.0**exponent * across + rng.normal() * u
        chain = axes((R, point, u), (R, beside, sense * u), (R, rng.normal(size=3), v), (R, point, w))
        assert discrepancy(chain, convention, assign_frames(chain, convention), None, rng) < 1e-9


PUMA = axes(
    (R, (0, 0, 0), Z),
    (R, (0, 0, 0), (0, -1, 0)),
    (R, (0.4318, 0, 0), (0, -1, 0)),
    (R, (0.4521, -0.15005, 0), Z),
    (R, (0.4521, -0.15005, 0.4318), (0, -1, 0)),
    (R, (0.4521, -0.15005, 0.4318), Z),
)


def test_puma_560_comes_out_as_published():
    """Standard: α 90 0 −90 90 −90 0, a 0 .4318 .0203 0 0 0, d 0 0 .15005 .4318 0 0 (Corke and"
    " Armstrong-Hélouvry)."""
    standard = assign_frames(PUMA, Convention.STANDARD)
    assert entries(standard.table) == [
        (90, 0, 0, 0),
        (0, 0.4318, 0, 0),
        (-90, 0.0203, 0.15005, 0),
        (90, 0, 0.4318, 0),
        (-90, 0, 0, 0),
        (0, 0, 0, 0),
    ]
    assert [frame.rule for frame in standard.frames] == [
        Rule.FIRST,
        Rule.INTERSECTING,
        Rule.PARALLEL,
        Rule.SKEW,
        Rule.INTERSECTING,
        Rule.INTERSECTING,
        Rule.LAST,
    ]
    modified = assign_frames(PUMA, Convention.MODIFIED)
    assert entries(modified.table) == [
        (0, 0, 0, 0),
        (90, 0, 0, 0),
        (0, 0.4318, 0.15005, 0),
        (-90, 0.0203, 0.4318, 0),
        (90, 0, 0, 0),
        (-90, 0, 0, 0),
    ]
    assert np.array_equal(modified.base, np.eye(4))


def test_scara_of_seed_002_comes_out_as_printed():
    """(0, 0, 0, θ1) (0, a2, 0, θ2) (0, a3, d, 0) prismatic (0, 0, 0, θ4)."""
    chain = axes((R, (0, 0, 0), Z), (R, (0.3, 0, 0.4), Z), (P, (9, 9, 9), Z), (R, (0.5, 0, 0.2), Z))
    table = assign_frames(chain, Convention.MODIFIED).table
    assert entries(table) == [(0, 0, 0, 0), (0, 0.3, 0, 0), (0, 0.2, 0, 0), (0, 0, 0, 0)]


def test_rx_90_comes_out_as_published():
    """α 0 π/2 0 −π/2 π/2 −π/2, D3 = RL4 = 0.45 (Khalil and Dombre)."""
    chain = axes(
        (R, (0, 0, 0), Z),
        (R, (0, 0, 0), (0, -1, 0)),
        (R, (0.45, 0, 0), (0, -1, 0)),
        (R, (0.45, 0, 0), Z),
        (R, (0.45, 0, 0.45), (0, -1, 0)),
        (R, (0.45, 0, 0.45), Z),
    )
    table = assign_frames(chain, Convention.MODIFIED).table
    assert [row[0] for row in entries(table)] == [0, 90, 0, -90, 90, -90]
    assert [row[1] for row in entries(table)] == [0, 0, 0.45, 0, 0, 0]
    assert [row[2] for row in entries(table)] == [0, 0, 0, 0.45, 0, 0]
    assert [row[3] for row in entries(table)] == [0] * 6


SSRMS = axes(
    (R, (1.3589, 0, 0), X),
    (R, (1.3589, 0, 0.7026), Z),
    (R, (1.3589, -0.5692, 0.7026), Y),
    (R, (8.4689, -1.0442, 0.7026), Y),
    (R, (15.5789, -1.0442, 0.7026), Y),
    (R, (15.5789, -1.6134, 0.7026), Z),
    (R, (15.5789, -1.6134, 0.0), X),
)


@both
def test_ssrms_needs_only_the_lengths_that_it_has(convention):
    """Seed 004, fig. 8: x_1, x_2, x_5 and x_6 where axes intersect, x_3 and x_4 where they are parallel."""
    result = assign_frames(SSRMS, convention)
    lengths = sorted(round(abs(v), 9) for row in entries(result.table) for v in row[1:3] if v)
    assert lengths == sorted([7.11, 7.11, 0.7026, 0.7026, 0.5692 * 2 + 0.475])
    rules = [frame.rule for frame in result.frames[1:7]]
    assert rules == [*[Rule.INTERSECTING] * 2, *[Rule.PARALLEL] * 2, *[Rule.INTERSECTING] * 2]


@both
def test_slider_is_drawn_through_the_next_origin(convention):
    """Stanford arm: d2 = 0.154 and nothing else between the shoulder and the wrist but the slider."""
    chain = axes(
        (R, (0, 0, 0), Z),
        (R, (0, 0, 0.412), Y),
        (P, (5, 5, 5), Z),
        (R, (0, 0.154, 0.675), Z),
        (R, (0, 0.154, 0.675), Y),
        (R, (0, 0.154, 0.675), Z),
    )
    result = assign_frames(chain, convention)
    assert sum(1 for row in entries(result.table) for v in row[1:3] if v) == 2
    assert result.frames[2].rule is Rule.PRISMATIC
    assert Freedom.LINE in result.frames[2].free


def test_entries_are_exact():
    chain = axes((R, (0.1, 0.2, 0.3), Z), (R, (0.1, 0.2, 0.7), (0, 0.7071, 0.7071)), (R, (0.4, 0.2, 0.7), X))
    table = assign_frames(chain, Convention.STANDARD).table
    assert table.rows[0].alpha in (math.pi / 4, -math.pi / 4)
    assert all(row.a == round(row.a, 12) and row.d == round(row.d, 12) for row in table.rows)
    exact = exact_table(table)
    assert bind(exact) == table


UR5_CALIBRATED = {
    "theta": (
        -9.62699668632896e-06,
        -1.43707039992005,
        2.02543119975016,
        -0.588254688694989,
        4.13647390228702e-05,
        8.1737464953645e-06,
    ),
    "a": (
        0.000279332356195598,
        -0.0566854832098269,
        -0.32646702272051,
        1.49388687216263e-05,
        2.23692592990586e-07,
        0.0,
    ),
    "d": (
        0.0888794492754001,
        574.241384579456,
        -507.363402098168,
        -66.7676839353205,
        0.0949734691141216,
        0.0825625014554953,
    ),
    "alpha": (
        1.57033858830411,
        -0.000733893428160216,
        0.00325607356326439,
        1.57040005185553,
        -1.57101000328584,
        0.0,
    ),
}
"""A calibrated UR5 as its owner published it, puzzled by 574 m (Universal Robots ROS driver, question"
" 457)."""


def calibrated_ur5():
    rows = zip(*(UR5_CALIBRATED[cell] for cell in ("theta", "a", "d", "alpha")), strict=True)
    table = DHTable(
        convention=Convention.STANDARD,
        rows=tuple(DHRow(joint=R, theta=t, a=a, d=d, alpha=al) for t, a, d, al in rows),
    )
    fk = forward_kinematics(table, np.zeros(6))
    frames = [np.eye(4), *fk.frames[:-1]]
    chain = [
        JointAxis(joint=R, point=frame[:3, 3].tolist(), direction=frame[:3, 2].tolist()) for frame in frames
    ]
    return table, chain, fk.transform


@both
def test_near_parallel_axes_stay_at_hand(convention):
    table, chain, tool = calibrated_ur5()
    result = assign_frames(chain, convention, tool=tool)
    assert max(abs(v) for row in result.table.rows for v in (row.a, row.d)) < 0.5
    assert [warning.code for warning in result.warnings] == ["near_parallel", "near_parallel"]
    assert [warning.params["joint"] for warning in result.warnings] == [3, 4]
    stated = sum(float(warning.params["displacement"]) for warning in result.warnings)
    rng = np.random.default_rng(1)
    for q in rng.uniform(-math.pi, math.pi, (50, 6)):
        got = forward_kinematics(result.table, q, base=result.base, tool=result.tool).transform
        want = forward_kinematics(table, q).transform
        assert np.linalg.norm(got[:3, 3] - want[:3, 3]) <= stated
        assert np.abs(got[:3, :3] - want[:3, :3]).max() <= 2 * (7.34e-4 + 3.64e-3)


@both
def test_the_stated_displacement_is_that_of_a_tool_that_is_not_the_last_frame(convention):
    """Two upright axes 0.003 rad apart, and a tool askew 2 m in front of them."""
    tilted = [math.sin(3e-3), 0.0, math.cos(3e-3)]
    chain = [
        JointAxis(joint=R, point=[0.0, 0.0, 0.0], direction=[0.0, 0.0, 1.0]),
        JointAxis(joint=R, point=[0.1, 0.0, 0.0], direction=tilted),
    ]
    tool = transform_from_xyzabc([2.0, 0.3, 0.1, 0.4, 0.5, 0.6])
    result = assign_frames(chain, convention, tool=tool)
    (warning,) = (one for one in result.warnings if one.code == "near_parallel")
    stated = float(warning.params["displacement"])
    got = forward_kinematics(result.table, [0.0, math.pi], base=result.base, tool=result.tool).transform
    turned = 2.0 * np.outer(tilted, tilted) - np.eye(3)  # half a turn about the second axis
    want = turned @ (tool[:3, 3] - [0.1, 0.0, 0.0]) + [0.1, 0.0, 0.0]
    assert 5e-3 < np.linalg.norm(got[:3, 3] - want) <= stated


@both
def test_a_dummy_row_carries_the_tilt_exactly(convention):
    table, chain, tool = calibrated_ur5()
    result = assign_frames(chain, convention, tool=tool, near_parallel=NearParallel.DUMMY_ROW)
    assert max(abs(v) for row in result.table.rows for v in (row.a, row.d)) < 0.5
    assert [row.joint for row in result.table.rows].count(JointType.FIXED) == 2
    assert {warning.code for warning in result.warnings} == {"near_parallel_dummy_row"}
    rng = np.random.default_rng(2)
    for q in rng.uniform(-math.pi, math.pi, (50, 6)):
        got = forward_kinematics(result.table, q, base=result.base, tool=result.tool).transform
        assert np.abs(got - forward_kinematics(table, q).transform).max() < 1e-11


def test_without_tolerance_the_far_normal_is_there():
    _, chain, _ = calibrated_ur5()
    result = assign_frames(chain, Convention.STANDARD, parallel_tolerance=1e-10)
    assert max(abs(row.d) for row in result.table.rows) == pytest.approx(574.24, abs=0.01)
    assert result.warnings == ()


@both
@pytest.mark.parametrize("tilt", [1e-12, 1e-9, 1e-6, 1e-3, 4.9e-3])
@pytest.mark.parametrize("sense", [1, -1])
def test_any_small_tilt_leaves_short_offsets(convention, tilt, sense):
    chain = axes(
        (R, (0, 0, 0), Z),
        (R, (0, 0, 0.1), Y),
        (R, (0.4, 0, 0.1), (0.0, sense * math.cos(tilt), math.sin(tilt))),
        (R, (0.8, 0.1, 0.1), Z),
    )
    result = assign_frames(chain, convention)
    assert max(abs(v) for row in result.table.rows for v in (row.a, row.d)) < 1.0
    assert [w.code for w in result.warnings] == ([] if tilt < 1e-10 else ["near_parallel"])


@both
@pytest.mark.parametrize("away", [0.0, 60.0, 1e4])
def test_zero_is_judged_by_the_robot_wherever_on_its_axes_the_points_are(convention, away):
    tool = np.eye(4)
    tool[:3, 3] = 0.3, 0.1, 0.6
    for miss, a in ((5e-9, pytest.approx(5e-9, abs=1e-11)), (0.0, 0.0)):
        tilted = (0.0, math.sin(0.9), math.cos(0.9))
        point = (miss, away * tilted[1], 0.2 + away * tilted[2])
        chain = axes((R, (0, 0, -away), Z), (R, point, tilted))
        result = assign_frames(chain, convention, base=np.eye(4), tool=tool)
        assert [row.a for row in result.table.rows if row.alpha == pytest.approx(-0.9)] == [a]


def test_given_base_becomes_frame_zero_where_it_can():
    floor = np.eye(4)
    floor[2, 3] = -0.66
    standard = assign_frames(PUMA, Convention.STANDARD, base=floor)
    assert np.array_equal(standard.base, floor)
    assert standard.table.rows[0].d == 0.66
    assert standard.frames[0].rule is Rule.GIVEN
    aside = np.eye(4)
    aside[:3, 3] = 1, 1, 0
    assert [w.code for w in assign_frames(PUMA, Convention.STANDARD, base=aside).warnings] == [
        "base_not_frame_zero_standard"
    ]
    assert [w.code for w in assign_frames(PUMA, Convention.MODIFIED, base=aside).warnings] == [
        "base_not_frame_zero_modified"
    ]


def test_gripper_of_seed_002():
    gripper = Gripper(point=(0.4521, -0.15005, 0.5318), approach=(0, 0, 2), jaws=(0, -1, 0.3))
    T = gripper_frame(gripper)
    assert np.allclose(T[:3, 2], Z)
    assert np.allclose(T[:3, 1], (0, -1, 0))
    assert np.allclose(T[:3, 0], np.cross(T[:3, 1], T[:3, 2]))
    for convention in Convention:
        result = assign_frames(PUMA, convention, tool=gripper)
        assert result.frames[-1].rule is Rule.GIVEN
        assert result.table.rows[-1].d == 0.1
        assert np.array_equal(result.tool, np.eye(4))
        assert np.allclose(forward_kinematics(result.table, np.zeros(6), base=result.base).transform, T)


def test_one_axis_alone():
    for joint in (R, P):
        for convention in Convention:
            result = assign_frames(axes((joint, (1, 2, 3), Y)), convention)
            assert entries(result.table) == [(0, 0, 0, 0)]


@pytest.mark.parametrize(
    ("chain", "code", "where"),
    [
        ([], "axes_wrong_number", ("axes",)),
        (axes((R, (0, 0, 0), Z)) * 65, "axes_wrong_number", ("axes",)),
        (axes((R, (0, 0, 0), (0, 0, 0))), "direction_zero", ("axes", 0, "direction")),
        (axes((R, (0, 0), Z)), "vector_malformed", ("axes", 0, "point")),
        (axes((R, (0, math.nan, 0), Z)), "vector_malformed", ("axes", 0, "point")),
        (axes((R, (0, 1e13, 0), Z)), "vector_malformed", ("axes", 0, "point")),
        (axes((R, (0, 0, 0), (0, 0, math.inf))), "vector_malformed", ("axes", 0, "direction")),
        (axes((JointType.FIXED, (0, 0, 0), Z)), "axis_joint_unknown", ("axes", 0, "joint")),
    ],
)
def test_malformed_axes_are_refused(chain, code, where):
    with pytest.raises(DescriptionError) as refusal:
        assign_frames(chain, Convention.STANDARD)
    assert refusal.value.code == code
    assert refusal.value.faults[0].where == where


def test_other_refusals():
    with pytest.raises(DescriptionError) as refusal:
        assign_frames(PUMA, Convention.STANDARD, parallel_tolerance=0.5)
    assert refusal.value.code == "parallel_tolerance_out_of_range"
    with pytest.raises(DescriptionError) as refusal:
        gripper_frame(Gripper(point=(0, 0, 0), approach=(0, 0, 1), jaws=(0, 0, -3)))
    assert refusal.value.code == "gripper_jaws_along_approach"
    with pytest.raises(PoseError) as not_rigid:
        assign_frames(PUMA, Convention.STANDARD, tool=np.ones((4, 4)))
    assert not_rigid.value.faults[0].where[0] == "tool"


UR5_AXES = axes(
    (R, (0, 0, 0), (0, 0, 1)),
    (R, (0, 0, 0.089159), (0, -1, 0)),
    (R, (-0.425, 0, 0.089159), (0, -1, 0)),
    (R, (-0.81725, 0, 0.089159), (0, -1, 0)),
    (R, (-0.81725, -0.10915, 0.089159), (0, 0, -1)),
    (R, (-0.81725, -0.10915, -0.005491), (0, -1, 0)),
)
"""Axes of the UR5 at its zero position, by Universal Robots' own table."""


def test_makers_signs_spare_offsets():
    """Universal Robots print a_2 = -0.425 and a_3 = -0.39225 with no offset of a joint."""
    plain = assign_frames(UR5_AXES, Convention.STANDARD, base=np.eye(4))
    signed = assign_frames(UR5_AXES, Convention.STANDARD, base=np.eye(4), lengths=LengthSigns.SIGNED)
    a = [row.a for row in signed.table.rows]
    assert a[1:3] == pytest.approx([-0.425, -0.39225])
    assert all(row.theta == 0.0 for row in signed.table.rows)
    assert sum(row.theta != 0.0 for row in signed.table.rows) < sum(
        row.theta != 0.0 for row in plain.table.rows
    )
    assert all(row.a >= 0.0 for row in plain.table.rows)


@pytest.mark.parametrize("convention", Convention)
@pytest.mark.parametrize("lengths", LengthSigns)
@pytest.mark.parametrize("intersecting", CrossProduct)
def test_choices_keep_the_robot(convention, lengths, intersecting):
    rng = np.random.default_rng(11)
    for kind in KINDS:
        chain = random_chain(rng, kind, 0.2)
        result = assign_frames(chain, convention, lengths=lengths, intersecting=intersecting)
        assert discrepancy(chain, convention, result, None, rng) < 1e-9
        if lengths is LengthSigns.POSITIVE:
            assert all(row.a >= 0.0 for row in result.table.rows)


@pytest.mark.parametrize(
    ("intersecting", "sign"), [(CrossProduct.FORWARD, 1.0), (CrossProduct.BACKWARD, -1.0)]
)
def test_x_is_the_cross_product_that_was_asked_for(intersecting, sign):
    """Seed 002: x_i = z_i × z_(i+1); seed 004 §2.3, case 1: x_i = z_i × z_(i-1)."""
    chain = axes(
        (R, (0, 0, 0), (0, 0, 1)),
        (R, (0, 0, 0.4), (0, -1, 0)),
        (R, (0, 0, 0.4), (1, 0, 0)),
    )
    result = assign_frames(chain, Convention.STANDARD, intersecting=intersecting)
    for i in (1, 2):
        across = np.cross(result.frames[i - 1].z, result.frames[i].z)
        assert np.allclose(result.frames[i].x, sign * across, atol=1e-12)
