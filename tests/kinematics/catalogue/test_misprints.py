"""The misprints of docs/sources.md that can be computed: as printed it fails, as corrected it holds."""

import math

import numpy as np

from kinematics.cells import AngleUnit, RawRow, RawTable, read_table
from kinematics.dh import link_transform
from kinematics.scm import RawChain, read_chain, verify
from kinematics.scm.motion import forward_kinematics_scm
from kinematics.table import Convention, DHRow, JointType

THETA, D, A, ALPHA = 0.7, 0.3, 0.2, -0.4


def matrix(rotation, column):
    result = np.eye(4)
    result[:3, :3], result[:3, 3] = rotation, column
    return result


def row(theta=THETA, d=D, a=A, alpha=ALPHA):
    return DHRow(joint=JointType.FIXED, theta=theta, d=d, a=a, alpha=alpha)


def is_rigid(transform):
    rotation = transform[:3, :3]
    return np.allclose(rotation @ rotation.T, np.eye(3)) and np.linalg.det(rotation) > 0


def test_document_002_matrix_of_the_original_convention():
    ct, st, ca, sa = math.cos(THETA), math.sin(THETA), math.cos(ALPHA), math.sin(ALPHA)
    rotation = [[ct, -ca * st, sa * st], [st, ca * ct, -sa * ct], [0, sa, ca]]
    true = link_transform(row(), Convention.STANDARD)
    assert not np.allclose(matrix(rotation, [D * ct, D * st, A]), true)
    np.testing.assert_allclose(matrix(rotation, [A * ct, A * st, D]), true, atol=1e-15)
    inverse = np.transpose(rotation)
    assert not np.allclose(matrix(inverse, [-D, -A * sa, -A * ca]) @ true, np.eye(4))
    np.testing.assert_allclose(matrix(inverse, [-A, -D * sa, -D * ca]) @ true, np.eye(4), atol=1e-15)


def test_document_002_inverse_of_the_modified_convention():
    ct, st, ca, sa = math.cos(THETA), math.sin(THETA), math.cos(ALPHA), math.sin(ALPHA)
    rotation = [[ct, st * ca, st * sa], [-st, ct * ca, ct * sa], [0, -sa, ca]]
    true = link_transform(row(), Convention.MODIFIED)
    np.testing.assert_allclose(matrix(rotation, [-A * ct, A * st, -D]) @ true, np.eye(4), atol=1e-15)


def test_document_002_variable_of_the_slider():
    def scara(slider):
        rows = ((0, 0, 0, "θ1"), (0, "a2", 0, "θ2"), (0, "a3", slider, 0), (0, 0, 0, "θ4"))
        return RawTable(
            convention=Convention.MODIFIED,
            rows=tuple(RawRow(alpha=r[0], a=r[1], d=r[2], theta=r[3]) for r in rows),
            angle_unit=AngleUnit.DEG,
        )

    printed = read_table(scara("d2"))
    assert printed.table.joint_types == (JointType.REVOLUTE,) * 3
    assert "d2" in printed.parameters
    corrected = read_table(scara("d3"))
    assert corrected.table.joint_types[2] is JointType.PRISMATIC
    assert set(corrected.parameters) == {"a2", "a3"}


def test_document_003_link_matrices():
    theta = 0.6
    c, s = math.cos(theta), math.sin(theta)
    first = {
        sign: np.array([[c, 0, -s, 45 * c], [s, 0, c, 45 * s], [0, sign, 0, 75], [0, 0, 0, 1]])
        for sign in (1, -1)
    }
    assert not is_rigid(first[1])
    true = link_transform(row(theta, 75, 45, -math.pi / 2), Convention.STANDARD)
    np.testing.assert_allclose(first[-1], true, atol=1e-13)

    def second(d):
        return np.array([[c, -s, 0, 115 * c], [s, c, 0, 115 * s], [0, 0, 1, d], [0, 0, 0, 1]])

    true = link_transform(row(theta, 0, 115, 0), Convention.STANDARD)
    assert not np.allclose(second(75), true)
    np.testing.assert_allclose(second(0), true, atol=1e-13)

    printed_last = matrix(np.eye(3), [0, 0, 50])
    true = link_transform(row(theta, 50, 0, 0), Convention.STANDARD)
    assert not np.allclose(printed_last, true)
    np.testing.assert_allclose(matrix([[c, -s, 0], [s, c, 0], [0, 0, 1]], [0, 0, 50]), true, atol=1e-13)


def _wrist(turn):
    entries = dict(zip("xyzabc", (0, 0, 0.2, "q1", 0, 0), strict=True))
    return read_chain(RawChain(joints=(entries,), final={"x": 0.5, "c": turn}, tool={})).chain


def test_document_001_displays_pi_rounded():
    exact = forward_kinematics_scm(_wrist("pi"), [0.3]).transform
    rounded = forward_kinematics_scm(_wrist(3.1416), [0.3]).transform
    assert 5e-6 < np.abs(exact - rounded).max() < 1e-5


def test_document_001_first_form_of_the_scara_fails_the_documents_own_check():
    entries = dict(zip("xyzabc", ("L2", 0, "-q1", 0, 0, 0), strict=True))
    chain = read_chain(RawChain(joints=(entries,), final={}, tool={})).chain
    assert [fault.code for fault in verify(chain)] == ["scm_prismatic_second_length"]
