"""The Denavit–Hartenberg product: what a row of a table means, written once.

    standard:  A_i = Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha)
    modified:  A_i = Rot_x(alpha) Trans_x(a) Rot_z(theta) Trans_z(d)

A link is a product of four elementary motions, one for each cell of its row. The two conventions differ in
their order alone (`MOTIONS`). Whatever is computed from a table, for one configuration or many, is derived
from this order and from the two rotations `turn_z` and `turn_x`.
"""

import math
from collections.abc import Iterable, Sequence
from enum import StrEnum
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from kinematics.angles import cos_sin
from kinematics.errors import Fault, JointValueError, TableError
from kinematics.se3 import ORIGIN, X_AXIS, Z_AXIS, Floats, Motion, Scalar, Scalars, Transform, cross
from kinematics.table import VARIABLE_CELLS, Convention, JointType, NumericRow

MOTIONS = {
    Convention.STANDARD: ("theta", "d", "a", "alpha"),
    Convention.MODIFIED: ("alpha", "a", "theta", "d"),
}
"""The order of the motions, base side first. The cells theta and d move along z, a and alpha along x."""
_ALONG_Z = {
    convention: tuple(cell == "theta" for cell in order if cell in ("theta", "alpha"))
    for convention, order in MOTIONS.items()
}
"""Whether a row first moves along z and then along x, or the other way round."""


def link_transform(row: NumericRow, convention: Convention, q: float = 0.0) -> Transform:
    """Return the pose of frame i in frame i-1, from one row of a DH table.

    standard:  Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha)
    modified:  Rot_x(alpha) Trans_x(a) Rot_z(theta) Trans_z(d)

    Args:
        row: theta joint angle [rad], d link offset [m], a link length [m], alpha link twist [rad];
            in a modified table a and alpha belong to link i-1.
        convention: which of the two products to form.
        q: the joint variable [rad, or m for a prismatic row]; a fixed row ignores it.

    Returns:
        (4, 4) homogeneous transform, translation in [m]. Angles that are multiples of π/12 count as exact.

    Raises:
        TableError: an entry of the row is NaN or infinite.
        JointValueError: q is NaN or infinite.

    Source: seed 000 eq. 3.2 (modified); seed 003 eq. 2 (standard).
    """
    if not math.isfinite(q):
        raise JointValueError(Fault.at("joint_not_finite", "joints", 0, joint=1))
    value = cos_sin(q) if row.joint is JointType.REVOLUTE else q
    motions = set_joints(link_motions(row, convention), (value,))
    return np.array([*pose_of_motions(motions), (0.0, 0.0, 0.0, 1.0)])


def link_transforms(rows: Sequence[NumericRow], convention: Convention, q: Sequence[Floats]) -> Floats:
    """Return the poses of frame i in frame i-1 at many values of the joint variable, (k, 4, 4).

    Args:
        rows: a row of a table, see `link_transform`, with one set of finite numbers or several.
        convention: which of the two products to form.
        q: for each set, (k_j,) joint variables [rad or m], k in all; a fixed row ignores them.
    """
    counts, joint = [len(values) for values in q], np.concatenate(q)
    motions: list[ElementaryMotion] = []
    for cell in MOTIONS[convention]:
        kind, numbers = CELL_MOTIONS[cell], [float(getattr(row, cell)) for row in rows]
        if any(numbers):
            motions.append(ElementaryMotion(kind, *_spread(kind, numbers, counts)))
        if cell == VARIABLE_CELLS.get(rows[0].joint):
            motions.append(ElementaryMotion(kind, 0.0, 0.0, 0, rows[0].sign))
    value = (np.cos(joint), np.sin(joint)) if rows[0].joint is JointType.REVOLUTE else joint
    poses = np.zeros((len(joint), 4, 4))
    poses[:, 3, 3] = 1.0
    for r, entries in enumerate(pose_of_motions(set_joints(motions, (value,)))):
        for c, entry in enumerate(entries):
            poses[:, r, c] = entry
    return poses


def _spread(kind: "MotionKind", numbers: Sequence[float], counts: Sequence[int]) -> Iterable[Any]:
    """Return what a motion holds, (k,) each, or one number where all are the same."""
    found = [
        cos_sin(number) if kind in (MotionKind.TURN_Z, MotionKind.TURN_X) else (number,) for number in numbers
    ]
    if all(entry == found[0] for entry in found):
        return found[0]
    return (np.repeat(part, counts) for part in zip(*found, strict=True))


def around_joint(row: NumericRow, convention: Convention) -> tuple[Transform, Transform]:
    """Return the constants K, L of a row whose link transform is K · J(q) · L, J about or along z.

    A standard row is J(q) A(0), a modified one A(0) J(q); a fixed row is all in K.

    Raises:
        TableError: an entry of the row is NaN or infinite.
    """
    constant = link_transform(row, convention)
    return (np.eye(4), constant) if _joint_leads(row, convention) else (constant, np.eye(4))


def _joint_leads(row: NumericRow, convention: Convention) -> bool:
    """Whether the joint of a row moves all of its constant motions."""
    return convention is Convention.STANDARD and row.joint is not JointType.FIXED


Row: TypeAlias = tuple[Scalar, Scalar, Scalar, Scalar]
JointValue: TypeAlias = Any  # (cos q, sin q) of a revolute joint, q of a prismatic one.


class MotionKind(StrEnum):
    """The four elementary motions."""

    TURN_Z = "turn_z"
    SHIFT_Z = "shift_z"
    SHIFT_X = "shift_x"
    TURN_X = "turn_x"


class ElementaryMotion(NamedTuple):
    """An elementary motion.

    Attributes:
        kind: which one.
        first: cosine of a turn's angle, or the length of a shift.
        second: sine of a turn's angle.
        joint: number of the joint that makes the motion, from 0; None for a constant motion.
        sign: −1 if the joint's variable enters with a minus sign.
    """

    kind: MotionKind
    first: Scalar
    second: Scalar = 0.0
    joint: int | None = None
    sign: int = 1


CELL_MOTIONS = {
    "theta": MotionKind.TURN_Z,
    "d": MotionKind.SHIFT_Z,
    "a": MotionKind.SHIFT_X,
    "alpha": MotionKind.TURN_X,
}
"""What each cell of a row does."""


def turn_z(v: Scalars, c: Scalar, s: Scalar) -> Scalars:
    """Return Rot_z(angle) · v, from the angle's cosine and sine; with −s, Rot_z(angle)ᵀ · v."""
    x, y, z = v
    return x * c - y * s, x * s + y * c, z


def turn_x(v: Scalars, c: Scalar, s: Scalar) -> Scalars:
    """Return Rot_x(angle) · v, from the angle's cosine and sine; with −s, Rot_x(angle)ᵀ · v."""
    x, y, z = v
    return x, y * c - z * s, y * s + z * c


def link_motions(
    row: NumericRow, convention: Convention, joint: int = 0, where: tuple[str | int, ...] = ()
) -> list[ElementaryMotion]:
    """Return the elementary motions of a row, base side first, without constant motions by zero.

    Args:
        convention: their order.
        joint: number of the row's joint, from 0; ignored for a fixed row.
        where: place of the row, for the faults.

    Raises:
        TableError: an entry is NaN or infinite.
    """
    faults: list[Fault] = []
    motions: list[ElementaryMotion] = []
    holds_variable = VARIABLE_CELLS.get(row.joint)
    for cell in MOTIONS[convention]:
        kind, value = CELL_MOTIONS[cell], float(getattr(row, cell))
        if not math.isfinite(value):
            faults.append(Fault.at("entry_not_finite", *where, cell, cell=cell))
        elif value:
            turns = kind is MotionKind.TURN_Z or kind is MotionKind.TURN_X
            motions.append(
                ElementaryMotion(kind, *cos_sin(value)) if turns else ElementaryMotion(kind, value)
            )
        if cell == holds_variable:
            motions.append(ElementaryMotion(kind, 0.0, 0.0, joint, row.sign))
    if faults:
        raise TableError(faults)
    return motions


def set_joints(motions: Iterable[ElementaryMotion], values: Sequence[JointValue]) -> list[ElementaryMotion]:
    """Return the same motions with the joints' values in place."""
    placed = []
    for motion in motions:
        if motion.joint is None:
            placed.append(motion)
        elif motion.kind is MotionKind.TURN_Z:
            cos, sin = values[motion.joint]
            placed.append(
                ElementaryMotion(
                    MotionKind.TURN_Z, cos, sin if motion.sign > 0 else -sin, motion.joint, motion.sign
                )
            )
        else:
            by = values[motion.joint]
            placed.append(
                ElementaryMotion(
                    MotionKind.SHIFT_Z, by if motion.sign > 0 else -by, 0.0, motion.joint, motion.sign
                )
            )
    return placed


def pose_of_motions(motions: Sequence[ElementaryMotion]) -> tuple[Row, Row, Row]:
    """Return the 3×4 pose that a product of elementary motions makes, by rows, for any kind of number.

    Columns x and z of the rotation and the origin p are transformed from the tip to the base. Rotations
    about parallel axes are combined (by the addition theorems) before the columns are rotated, and
    y = z × x.
    """
    x, z, p = X_AXIS, Z_AXIS, ORIGIN
    c, s = 1.0, 0.0
    for kind, first, second, _, _ in reversed(motions):
        if kind is MotionKind.TURN_Z:
            c, s, _ = turn_z((c, s, 0.0), first, second)
            p = turn_z(p, first, second)
        elif kind is MotionKind.TURN_X:
            x, z, p = (turn_x(v, first, second) for v in (turn_z(x, c, s), turn_z(z, c, s), p))
            c, s = 1.0, 0.0
        elif kind is MotionKind.SHIFT_Z:
            p = (p[0], p[1], p[2] + first)
        else:
            p = (p[0] + first, p[1], p[2])
    x, z = turn_z(x, c, s), turn_z(z, c, s)
    y = cross(z, x)
    return (x[0], y[0], z[0], p[0]), (x[1], y[1], z[1], p[1]), (x[2], y[2], z[2], p[2])


def frame_after(here: Motion, row: NumericRow, convention: Convention) -> Motion:
    """Return the frame after a row, at q = 0, given the frame before it.

    The row's elementary motions are applied to the columns of the frame in the convention's order: a turn
    mixes two columns, a shift moves the origin along one. For one frame at a time this is some fifteen times
    faster than composing it with the row's `link_transform`.
    """
    xx, yx, zx, xy, yy, zy, xz, yz, zz, px, py, pz = here
    for along_z in _ALONG_Z[convention]:
        if along_z:  # a turn and a shift along one axis may change places
            if value := row.theta:
                c, s = cos_sin(value)
                xx, yx = c * xx + s * yx, c * yx - s * xx
                xy, yy = c * xy + s * yy, c * yy - s * xy
                xz, yz = c * xz + s * yz, c * yz - s * xz
            if value := row.d:
                px, py, pz = px + value * zx, py + value * zy, pz + value * zz
            continue
        if value := row.alpha:
            c, s = cos_sin(value)
            yx, zx = c * yx + s * zx, c * zx - s * yx
            yy, zy = c * yy + s * zy, c * zy - s * yy
            yz, zz = c * yz + s * zz, c * zz - s * yz
        if value := row.a:
            px, py, pz = px + value * xx, py + value * xy, pz + value * xz
    return (xx, yx, zx, xy, yy, zy, xz, yz, zz, px, py, pz)
