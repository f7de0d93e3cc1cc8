"""Motion of an SCM chain in numbers: direct kinematics, its inverse, and the Jacobians by inspection.

Nothing here goes through a DH table, so the two derivations of a robot can be held against each other.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.errors import Fault, JointValueError
from kinematics.expressions import Expression, evaluate, evaluate_each
from kinematics.jacobian import JacobianFrame
from kinematics.joint_values import one_configuration
from kinematics.poses import transform_from_xyzabc
from kinematics.scm.chain import ChainRow, Entry, Placement, ScmChain
from kinematics.se3 import Place, Transform, cross_arrays, skew
from kinematics.table import JointType

_ENTRIES = tuple(Entry)
_SKEW = tuple(map(skew, np.eye(3)))


@dataclass(frozen=True, kw_only=True, slots=True)
class ScmKinematics:
    """Poses of an SCM chain at one configuration.

    Attributes:
        transform: (4, 4) pose of the tool in frame 0: ⁰H_FT of seed 001, FT = Final Transformation · Tool.
        links: (n, 4, 4) pose of frame i in frame i-1.
        frames: (n, 4, 4) pose of frame i in frame 0.
        end: (4, 4) pose of the tool in frame n.
    """

    transform: Transform
    links: NDArray[np.float64]
    frames: NDArray[np.float64]
    end: Transform


def forward_kinematics_scm(
    chain: ScmChain, joints: Sequence[float], parameters: Mapping[str, float] | None = None
) -> ScmKinematics:
    """Return poses of every frame: H = H_1 ⋯ H_n · FT with H_i = Trans(x, y, z) Rot_z(A) Rot_y(B) Rot_x(C).

    Args:
        chain: the chain; it need not pass `verify`.
        joints: (n,) joint variables [rad, or m of a prismatic joint].
        parameters: value of every parameter [m or rad].

    Raises:
        JointValueError: not n finite values.
        ParameterError: a parameter has no value.

    Source: seed 001 eq. 2.4, 2.5 and 3.1.
    """
    q = one_configuration(joints, chain.n_joints)
    values = parameters or {}
    moved = enumerate(zip(chain.rows, q, strict=True))
    links = np.stack([_row_transform(row, value, values, i) for i, (row, value) in moved])
    end = _placement(chain.final, values, "final") @ _placement(chain.tool, values, "tool")
    frames = np.empty_like(links)
    pose = np.eye(4)
    with np.errstate(over="ignore", invalid="ignore"):
        for i, link in enumerate(links):
            pose = pose @ link
            frames[i] = pose
        transform = pose @ end
    if not (np.isfinite(frames).all() and np.isfinite(transform).all()):
        raise JointValueError(Fault.at("result_not_finite", "joints"))
    return ScmKinematics(transform=transform, links=links, frames=frames, end=end)


def check_values(chain: ScmChain, parameters: Mapping[str, float]) -> None:
    """Make sure that every entry has a value.

    Raises:
        ParameterError: a parameter has no value, or an entry none that is finite, at ("joints", i, entry),
            ("final", entry) or ("tool", entry).
    """
    placements: list[tuple[Placement, Place]]
    placements = [(row.constant, ("joints", i)) for i, row in enumerate(chain.rows)]
    placements += [(chain.final, ("final",)), (chain.tool, ("tool",))]
    evaluate_each((entry for each in placements for entry in _entries(*each)), parameters)


def jacobian_by_inspection(
    chain: ScmChain,
    joints: Sequence[float],
    parameters: Mapping[str, float] | None = None,
    frame: JacobianFrame = JacobianFrame.BASE,
) -> NDArray[np.float64]:
    """Return the Jacobian of the tool, J0 or Jn, column by column without differentiating.

    Column i of J0 is [R u × (R p) ; R u] of a revolute joint and [R u ; 0] of a prismatic one, with u the
    joint's unit vector in frame i, p from frame i to the tool and R the rotation of frame i. Jn is J0 in the
    axes of the tool.

    Returns:
        (6, n): velocity above, angular velocity below.

    Source: seed 001 eq. 3.20–3.23.
    """
    motion = forward_kinematics_scm(chain, joints, parameters)
    columns = []
    for i, row in enumerate(chain.rows):
        axis = motion.frames[i, :3, :3] @ _unit_vector(row, parameters or {})
        arm = motion.transform[:3, 3] - motion.frames[i, :3, 3]
        slides = row.joint is JointType.PRISMATIC
        columns.append([*axis, 0.0, 0.0, 0.0] if slides else [*cross_arrays(axis, arm), *axis])
    J: NDArray[np.float64] = np.array(columns).T
    return J if frame is JacobianFrame.BASE else np.kron(np.eye(2), motion.transform[:3, :3].T) @ J


def _unit_vector(row: ChainRow, values: Mapping[str, float]) -> NDArray[np.float64]:
    """The joint's unit vector u_i in frame i: what the turns that follow the variable leave of its axis."""
    unit = np.zeros(3)
    unit[row.variable.axis] = row.sign
    following = {Entry.B: (Entry.C,), Entry.C: ()}.get(row.variable, (Entry.B, Entry.C))
    if row.variable in (Entry.X, Entry.Y, Entry.Z):
        following = (Entry.A, Entry.B, Entry.C)
    turns = [evaluate(row.constant.entry(e), values) if e in following else 0.0 for e in _ENTRIES]
    return transform_from_xyzabc(turns)[:3, :3].T @ unit


def unit_vectors(chain: ScmChain, parameters: Mapping[str, float] | None = None) -> NDArray[np.float64]:
    """Return the unit vectors u_i of the joints, each in the frame of its own row, (n, 3).

    In a strict chain they are coordinate axes, with the sign of the variable.

    Source: seed 001 eq. 3.20 and 3.21.
    """
    return np.stack([_unit_vector(row, parameters or {}) for row in chain.rows])


def _row_transform(row: ChainRow, q: float, values: Mapping[str, float], i: int) -> Transform:
    numbers = _numbers(row.constant, values, ("joints", i))
    numbers[_ENTRIES.index(row.variable)] += row.sign * q
    return transform_from_xyzabc(numbers)


def row_derivative(row: ChainRow, q: float, values: Mapping[str, float]) -> Transform:
    """Return ∂H/∂q of one row, 4×4: the factor that holds the variable is replaced by its derivative.

    A translation's derivative is the unit vector; that of Rot_u(φ) is [u] Rot_u(φ), [u] the skew matrix of u.
    """
    numbers = _numbers(row.constant, values, ())
    numbers[_ENTRIES.index(row.variable)] += row.sign * q
    change = np.zeros((4, 4))
    if row.joint is JointType.PRISMATIC:
        change[row.variable.axis, 3] = row.sign
        return change
    before, after = [0.0] * 6, [0.0] * 6
    for entry in (Entry.A, Entry.B, Entry.C):
        at = _ENTRIES.index(entry)
        (before if at < _ENTRIES.index(row.variable) else after)[at] = numbers[at]
    turned = transform_from_xyzabc(before)[:3, :3]
    change[:3, :3] = row.sign * turned @ _SKEW[row.variable.axis] @ transform_from_xyzabc(after)[:3, :3]
    return change


def _placement(placement: Placement, values: Mapping[str, float], name: str) -> Transform:
    return transform_from_xyzabc(_numbers(placement, values, (name,)))


def _numbers(placement: Placement, values: Mapping[str, float], where: Place) -> list[float]:
    return evaluate_each(_entries(placement, where), values)


def _entries(placement: Placement, where: Place) -> Iterator[tuple[Place, Expression]]:
    return (((*where, entry.value), placement.entry(entry)) for entry in _ENTRIES)
