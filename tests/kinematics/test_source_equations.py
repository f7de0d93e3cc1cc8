"""Equations of the source documents, written out as they are printed (docs/sources.md lists them)."""

import math
import re

import numpy as np
import pytest

from kinematics import catalogue
from kinematics.cells import bind_parameters
from kinematics.dh import link_transform
from kinematics.forward import end_pose, forward_kinematics
from kinematics.frames.assignment import CrossProduct, assign_frames
from kinematics.frames.axes import JointAxis
from kinematics.inverse import inverse_kinematics
from kinematics.poses import transform_from_xyzabc
from kinematics.scm import forward_kinematics_scm, jacobian_by_inspection, unit_vectors
from kinematics.se3 import from_matrix, inverse_transform, move
from kinematics.table import Convention, DHRow, JointType, NumericTable

LENGTH, ANGLE = 0.37, 0.83
C, S = math.cos(ANGLE), math.sin(ANGLE)


def only(**entries: float) -> np.ndarray:
    """A frame with these of its six entries."""
    return transform_from_xyzabc([entries.get(name, 0.0) for name in "xyzabc"])


@pytest.mark.parametrize(
    ("shift", "turn", "printed"),
    [
        ("x", "c", [[1, 0, 0, LENGTH], [0, C, -S, 0], [0, S, C, 0]]),
        ("y", "b", [[C, 0, S, 0], [0, 1, 0, LENGTH], [-S, 0, C, 0]]),
        ("z", "a", [[C, -S, 0, 0], [S, C, 0, 0], [0, 0, 1, LENGTH]]),
    ],
)
def test_motions_about_one_axis_commute(shift: str, turn: str, printed: list[list[float]]) -> None:
    """001 eq. 2.10, 2.11, 2.12."""
    one, other = only(**{shift: LENGTH}), only(**{turn: ANGLE})
    expected = np.array([*printed, [0, 0, 0, 1]])
    np.testing.assert_allclose(one @ other, expected, atol=1e-15)
    np.testing.assert_allclose(other @ one, expected, atol=1e-15)
    np.testing.assert_allclose(only(**{shift: LENGTH, turn: ANGLE}), expected, atol=1e-15)


@pytest.mark.parametrize(
    ("entry", "printed"),
    [
        ("x", [[1, 0, 0, ANGLE], [0, 1, 0, 0], [0, 0, 1, 0]]),
        ("y", [[1, 0, 0, 0], [0, 1, 0, ANGLE], [0, 0, 1, 0]]),
        ("z", [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, ANGLE]]),
        ("a", [[C, -S, 0, 0], [S, C, 0, 0], [0, 0, 1, 0]]),
        ("b", [[C, 0, S, 0], [0, 1, 0, 0], [-S, 0, C, 0]]),
        ("c", [[1, 0, 0, 0], [0, C, -S, 0], [0, S, C, 0]]),
    ],
)
def test_the_six_motions_of_a_frame(entry: str, printed: list[list[float]]) -> None:
    """001 eq. 2.4: the six matrices of the product."""
    np.testing.assert_allclose(only(**{entry: ANGLE}), [*printed, [0, 0, 0, 1]], atol=1e-15)


def test_a_rotation_holds_the_projections_of_the_axes() -> None:
    """001 eq. 2.1, 2.2: row i, column j is the product of axis j of frame 1 with axis i of frame 0."""
    drawn = [((0.1, 0.2, 0.3), (0.0, 0.6, 0.8)), ((0.5, -0.2, 0.1), (1.0, 0.0, 0.0))]
    axes = [JointAxis(joint=JointType.REVOLUTE, direction=z, point=point) for point, z in drawn]
    found = assign_frames(axes, Convention.STANDARD)
    zero, one, _ = found.frames
    T = forward_kinematics(found.table, [0.0, 0.0]).links[0]
    projected = np.dot(np.array([zero.x, zero.y, zero.z]), np.array([one.x, one.y, one.z]).T)
    np.testing.assert_allclose(T[:3, :3], projected, atol=1e-15)
    assert not np.allclose(T[:3, :3], projected.T)


def test_a_frame_is_a_shift_and_then_a_turn() -> None:
    """001 eq. 2.3 and 2.7: H = HT HR, its columns, and its inverse; the other order is another frame."""
    H = transform_from_xyzabc((0.1, -0.2, 0.3, 0.4, -0.5, 0.6))
    HT, HR = np.eye(4), np.eye(4)
    HT[:3, 3], HR[:3, :3] = H[:3, 3], H[:3, :3]
    np.testing.assert_allclose(HT @ HR, H, atol=1e-15)
    assert np.abs(HR @ HT - H).max() > 0.1
    x, y, z, p = (H[:3, k] for k in range(4))
    printed = [[*x, -(p @ x)], [*y, -(p @ y)], [*z, -(p @ z)], [0, 0, 0, 1]]
    np.testing.assert_allclose(inverse_transform(H), printed, atol=1e-15)


def test_motions_about_different_axes_do_not() -> None:
    """001 §2.3: the order matters else."""
    assert np.abs(only(x=LENGTH) @ only(a=ANGLE) - only(a=ANGLE) @ only(x=LENGTH)).max() > 0.1
    assert np.abs(only(b=ANGLE) @ only(a=ANGLE) - only(a=ANGLE) @ only(b=ANGLE)).max() > 0.1


def test_the_inverse_is_the_product_backwards() -> None:
    """001 eq. 2.5 to 2.9."""
    entries = dict(zip("xyzabc", (0.1, -0.2, 0.3, 0.4, -0.5, 0.6), strict=True))
    product, backwards = np.eye(4), np.eye(4)
    for name in "xyzabc":
        product = product @ only(**{name: entries[name]})
        backwards = only(**{name: -entries[name]}) @ backwards
    np.testing.assert_allclose(only(**entries), product, atol=1e-15)
    np.testing.assert_allclose(inverse_transform(product), backwards, atol=1e-15)
    np.testing.assert_array_equal(only(), np.eye(4))


def test_the_link_of_the_modified_convention() -> None:
    """000 eq. 3.1, 3.2; 001 eq. 2.14; 002, the modified matrix and the last column of its inverse."""
    a, d, alpha = 0.3, -0.7, 1.1
    ca, sa = math.cos(alpha), math.sin(alpha)
    printed = np.array(
        [[C, -S, 0, a], [S * ca, C * ca, -sa, -sa * d], [S * sa, C * sa, ca, ca * d], [0, 0, 0, 1]]
    )
    row = DHRow(joint=JointType.REVOLUTE, theta=0.0, d=d, a=a, alpha=alpha)
    found = link_transform(row, Convention.MODIFIED, ANGLE)
    np.testing.assert_allclose(found, printed, atol=1e-15)
    motions = only(c=alpha) @ only(x=a) @ only(a=ANGLE) @ only(z=d)
    np.testing.assert_allclose(found, motions, atol=1e-15)
    np.testing.assert_allclose(inverse_transform(found)[:3, 3], [-a * C, a * S, -d], atol=1e-15)


def test_the_link_of_the_standard_convention() -> None:
    """003 eq. 2; 001 eq. 2.13; 002, the matrix and its inverse, with the corrections of docs/sources.md."""
    a, d, alpha = 0.3, -0.7, 1.1
    ca, sa = math.cos(alpha), math.sin(alpha)
    printed = np.array(
        [[C, -S * ca, S * sa, a * C], [S, C * ca, -C * sa, a * S], [0, sa, ca, d], [0, 0, 0, 1]]
    )
    row = DHRow(joint=JointType.REVOLUTE, theta=0.0, d=d, a=a, alpha=alpha)
    found = link_transform(row, Convention.STANDARD, ANGLE)
    np.testing.assert_allclose(found, printed, atol=1e-15)
    motions = only(z=d, a=ANGLE) @ only(x=a, c=alpha)
    np.testing.assert_allclose(found, motions, atol=1e-15)
    np.testing.assert_allclose(inverse_transform(found)[:3, 3], [-a, -d * sa, -d * ca], atol=1e-15)


def dmra(q: list[float]):
    robot = catalogue.robot("dmra")
    return robot.parameters, forward_kinematics(bind_parameters(robot.table, robot.parameters), q)


def test_the_matrices_of_the_dmra() -> None:
    """003 eq. 3 to 7, as corrected in docs/sources.md."""
    q = [0.3, -0.4, 0.5, 0.6, -0.7, 0.8]
    at, found = dmra(q)
    (c1, s1), (c2, s2), (c3, s3), (c4, s4), (c5, s5), (c6, s6) = ((math.cos(x), math.sin(x)) for x in q)
    bottom = [0, 0, 0, 1]
    printed = [
        [[c1, 0, -s1, at["a1"] * c1], [s1, 0, c1, at["a1"] * s1], [0, -1, 0, at["d1"]], bottom],
        [[c2, -s2, 0, at["a2"] * c2], [s2, c2, 0, at["a2"] * s2], [0, 0, 1, 0], bottom],
        [[c3, 0, -s3, at["a3"] * c3], [s3, 0, c3, at["a3"] * s3], [0, -1, 0, 0], bottom],
        [[c4, 0, s4, 0], [s4, 0, -c4, 0], [0, 1, 0, at["d4"]], bottom],
        [[c5, 0, -s5, 0], [s5, 0, c5, 0], [0, -1, 0, 0], bottom],
        [[c6, -s6, 0, 0], [s6, c6, 0, 0], [0, 0, 1, at["d6"]], bottom],
    ]
    np.testing.assert_allclose(found.links, printed, atol=1e-12)


def test_a_point_of_a_link_in_frame_0() -> None:
    """003 eq. 1 and 8."""
    _, found = dmra([0.3, -0.4, 0.5, 0.6, -0.7, 0.8])
    point = (10.0, -20.0, 30.0)
    here: tuple[float, float, float] = point
    for link in found.links[3::-1]:
        here = move(from_matrix(link), here)
    np.testing.assert_allclose(here, move(from_matrix(found.frames[3]), point), atol=1e-10)
    np.testing.assert_allclose(move(from_matrix(found.frames[3]), (0, 0, 0)), found.frames[3, :3, 3])


def test_the_unit_vectors_of_the_stanford_arm() -> None:
    """001 eq. 3.20 and 3.21: ω of a frame grows by R u q̇ from frame to frame."""
    robot = catalogue.robot("stanford")
    assert robot.chain is not None
    chain = robot.chain.read.chain
    lengths = {name: robot.parameters[known] for name, known in robot.chain.parameters.items()}
    q, rates = np.random.default_rng(3).uniform(-1, 1, (2, chain.n_joints))
    motion, units = forward_kinematics_scm(chain, q.tolist(), lengths), unit_vectors(chain, lengths)
    about_y, about_z = (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
    printed = [about_z, about_y, about_z, about_z, about_y, about_z]
    np.testing.assert_array_equal(units, printed)
    for link, u in zip(motion.links, units, strict=True):
        joint = link[:3, :3] if abs(np.trace(link[:3, :3]) - 3) > 1e-9 else np.eye(3)
        np.testing.assert_allclose(joint @ u, u, atol=1e-15)  # eq. 3.20: the joint leaves its own axis
    turning = [row.joint is JointType.REVOLUTE for row in chain.rows]
    omega = sum(motion.frames[i, :3, :3] @ units[i] * rates[i] for i in range(chain.n_joints) if turning[i])
    J = jacobian_by_inspection(chain, q.tolist(), lengths)
    np.testing.assert_allclose(J[3:] @ rates, omega, atol=1e-12)


def test_the_jacobian_is_the_derivative() -> None:
    """001 eq. 3.19: the linear rows are ∂p/∂q."""
    robot = catalogue.robot("stanford")
    assert robot.chain is not None
    chain, step = robot.chain.read.chain, 1e-6
    lengths = {name: robot.parameters[known] for name, known in robot.chain.parameters.items()}
    q = np.random.default_rng(4).uniform(-1, 1, chain.n_joints)
    J = jacobian_by_inspection(chain, q.tolist(), lengths)
    for i, by in enumerate(step * np.eye(len(q))):
        ahead, behind = (
            forward_kinematics_scm(chain, at.tolist(), lengths).transform[:3, 3] for at in (q + by, q - by)
        )
        np.testing.assert_allclose(J[:3, i], (ahead - behind) / (2 * step), atol=1e-8)


def test_angular_velocity_is_the_derivative_of_the_rotation() -> None:
    """001 eq. 3.16 to 3.18 and 3.24: Ω = Ṙ Rᵀ, and (v, Ω) = J q̇."""
    robot = catalogue.robot("stanford")
    assert robot.chain is not None
    chain, step = robot.chain.read.chain, 1e-6
    lengths = {name: robot.parameters[known] for name, known in robot.chain.parameters.items()}
    q, rates = np.random.default_rng(5).uniform(-1, 1, (2, chain.n_joints))
    here, ahead, behind = (
        forward_kinematics_scm(chain, (q + s * rates).tolist(), lengths).transform for s in (0.0, step, -step)
    )
    change = (ahead - behind) / (2 * step)
    spin = change[:3, :3] @ here[:3, :3].T
    printed = [[0, -spin[1, 0], spin[0, 2]], [spin[1, 0], 0, -spin[2, 1]], [-spin[0, 2], spin[2, 1], 0]]
    np.testing.assert_allclose(spin, printed, atol=1e-8)
    velocity = jacobian_by_inspection(chain, q.tolist(), lengths) @ rates
    expected = [*change[:3, 3], spin[2, 1], spin[0, 2], spin[1, 0]]
    np.testing.assert_allclose(velocity, expected, atol=1e-8)


PRINTED_PRODUCTS = {
    "stanford": "Z(L0)A(a1) Y(L1)B(a2) Z(d3) A(a4) B(a5) Z(L2)A(a6)",
    "onelink": "A(a1) X(L1)",
    "twolink": "A(a1) X(L1)A(a2) X(L2)",
    "uw": "A(a1) X(L1)B(-a2) X(L2)B(-a3) X(L3)C(pi/2)",
    "scara-scm": "Z(L0)A(a1) X(L1)A(-a2) Z(-d3) X(L2)A(-a4) Z(-L3)C(pi)",
    "scorbot": "Z(L0)A(a1) X(L1)Y(-L2)B(-a2) X(L3)B(-a3) X(L4)B(-a4) Z(L5)A(a5)",
    "cloos": "A(a1) B(-a2) X(L1)B(a3) Z(L2)A(a4) B(-a5) Z(-L3)A(-a6) C(pi)",
    "kr100p": "Z(L0)A(-a1) X(L1)B(a2) X(L2)B(a3) X(L4)Z(L3)C(-a4) B(a5) X(L5)C(-a6) B(pi/2)",
    "kr125": "Z(L0)A(-a1) X(L1)B(a2) X(L2)B(a3) X(L3)C(-a4) B(a5) X(L4)C(-a6) B(pi/2)",
    "kr2150k": "Z(L0)A(-a1) X(L1)B(a2) X(L2)B(a3) X(L4)Z(-L3)C(-a4) B(a5) X(L5)C(-a6) B(pi/2)",
    "puma560": "A(a1) Y(-L1)B(-a2) X(L2)B(-a3) X(L3)Z(L4)A(a4) B(-a5) A(a6)",
    "puma600": "Z(L0)A(a1) Y(-L1)B(-a2) X(L2)B(-a3) Z(-L3)A(-a4) B(-a5) Z(-L4)A(-a6) C(pi)",
}
"""001 eq. 3.1 and 3.3 to 3.13, with the signs of the scripts that the document prints beside them."""


@pytest.mark.parametrize("name", PRINTED_PRODUCTS)
def test_the_printed_products_are_the_catalogues_arms(name: str) -> None:
    robot = catalogue.robot(name)
    assert robot.chain is not None
    rng = np.random.default_rng(6)
    chain = robot.chain.read.chain
    q = rng.uniform(-1, 1, chain.n_joints).tolist()
    lengths = {known: float(rng.uniform(0.1, 1)) for known in robot.chain.parameters}
    values = lengths | {"pi": math.pi, "pi/2": math.pi / 2}
    values |= {f"{letter}{i}": value for i, value in enumerate(q, 1) for letter in "ad"}
    product = np.eye(4)
    for axis, sign, symbol in re.findall(r"([XYZABC])\((-?)([^)]+)\)", PRINTED_PRODUCTS[name]):
        product = product @ only(**{axis.lower(): -values[symbol] if sign else values[symbol]})
    np.testing.assert_allclose(forward_kinematics_scm(chain, q, lengths).transform, product, atol=1e-14)


@pytest.mark.parametrize(
    ("given", "order"), [(CrossProduct.BACKWARD, -1.0), (CrossProduct.FORWARD, 1.0)], ids=["004", "usual"]
)
def test_x_where_axes_intersect(given: CrossProduct, order: float) -> None:
    """004 §2.3, case 1: x_i = z_i × z_{i-1}; the usual one is z_{i-1} × z_i, and α_i has the other sign."""
    directions = [(0.0, 0.0, 1.0), (0.0, -0.6, 0.8), (1.0, 0.0, 0.0)]
    axes = [JointAxis(joint=JointType.REVOLUTE, direction=one, point=(0.1, 0.2, 0.3)) for one in directions]
    found = assign_frames(axes, Convention.STANDARD, intersecting=given)
    for i in (0, 1):
        across = order * np.cross(directions[i], directions[i + 1])
        np.testing.assert_allclose(found.frames[i + 1].x, across / np.linalg.norm(across), atol=1e-15)
        assert math.copysign(1.0, found.table.rows[i].alpha) == order


def test_the_base_of_the_dmra_turns_through_half_a_turn() -> None:
    """003, text before fig. 8."""
    limits = catalogue.robot("dmra").limits
    assert limits is not None
    assert limits[0][1] - limits[0][0] == 180.0


def test_a_joint_of_three_freedoms_is_three_joints_without_lengths() -> None:
    """000 §3.1: n joints of one freedom, joined by n - 1 links of length 0; a ball turns to any pose."""
    table = NumericTable(
        convention=Convention.MODIFIED,
        rows=tuple(
            DHRow(joint=JointType.REVOLUTE, alpha=alpha, a=0.0, d=0.0, theta=0.0)
            for alpha in (0.0, math.pi / 2, -math.pi / 2)
        ),
    )
    wanted = transform_from_xyzabc([0.0, 0.0, 0.0, 0.4, -1.1, 2.3])
    answer = inverse_kinematics(table, wanted)
    assert (len(answer.solutions), answer.complete) == (2, True)
    for solution in answer.solutions:
        assert np.allclose(end_pose(table, solution.joints), wanted, atol=1e-12)


@pytest.mark.parametrize("kind", [JointType.REVOLUTE, JointType.PRISMATIC])
def test_the_first_and_the_last_frame_leave_what_can_be_zero(kind: JointType) -> None:
    """000 §3.2.2, 002 steps 6 and 7: frame 0 is frame 1 at q_1 = 0, and frame n leaves d_n or θ_n zero."""
    axes = [
        JointAxis(joint=kind, point=(0.1, 0.2, 0.3), direction=(0.0, 0.0, 1.0)),
        JointAxis(joint=JointType.REVOLUTE, point=(0.5, 0.0, 0.4), direction=(0.0, 1.0, 0.0)),
        JointAxis(joint=kind, point=(0.5, 0.7, 0.9), direction=(1.0, 0.0, 0.0)),
    ]
    first, _, last = assign_frames(axes, Convention.MODIFIED).table.rows
    assert (first.alpha, first.a, first.d, first.theta) == (0.0, 0.0, 0.0, 0.0)
    assert (last.d, last.theta) == (0.0, 0.0)


def test_the_arm_takes_several_postures_for_one_pose_of_its_gripper() -> None:
    """003, on the method: with six joints links may stand differently for one place of the gripper."""
    dmra = catalogue.robot("dmra")
    table = bind_parameters(dmra.table, dmra.parameters)
    answer = inverse_kinematics(table, end_pose(table, [0.3, -0.9, 0.4, 0.5, 0.9, -0.2]))
    assert answer.complete
    assert len(answer.solutions) == 8
