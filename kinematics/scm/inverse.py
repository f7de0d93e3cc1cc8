"""Inverse kinematics of a chain, through the DH table that moves as it does."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from numpy.typing import ArrayLike

from kinematics.inverse import InverseKinematics, JointLimits, Solver, solver_of
from kinematics.scm.chain import ScmChain
from kinematics.scm.unrolled import table_of_chain
from kinematics.table import bind


def inverse_kinematics_scm(
    chain: ScmChain,
    target: ArrayLike,
    parameters: Mapping[str, float] | None = None,
    *,
    limits: JointLimits | None = None,
    start: Sequence[float] | None = None,
) -> InverseKinematics:
    """Return the joint variables at which the tool reaches a target: scm(manipulator, target, origin).

    The toolbox iterates with the pseudo-inverse from one origin and finds at most one solution; here all are
    found where a closed form exists, and the one nearest to the origin comes first.

    Args:
        chain: the chain, of 1 to 12 joints.
        target: (4, 4) pose of the tool in frame 0.
        parameters: value of every parameter [m or rad].
        limits: (least, greatest) of each joint [rad, or m], None where there is none.
        start: joint values; solutions are sorted by their distance from them, turns counted on the circle.

    Raises:
        TableError: no joint, more than 12, or a length too large.
        JointValueError: malformed limits.
        ParameterError: a parameter has no value.
        PoseError: the target is not a rigid motion, at ("target", …).

    Source: seed 001 §3.1.2.
    """
    solver = solver_of_chain(chain, parameters, limits=limits)
    return solver.nearest_first(solver.solve(target), start)


def solver_of_chain(
    chain: ScmChain, parameters: Mapping[str, float] | None = None, *, limits: JointLimits | None = None
) -> Solver:
    """Return the chain made ready for many targets.

    Arguments and refusals are those of `inverse_kinematics_scm`.
    """
    return solver_of(bind(table_of_chain(chain), parameters), limits=limits)
