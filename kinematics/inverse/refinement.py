"""From the candidates of a closed form to its solutions, none lost at special targets.

At a stretched elbow or a wrist in line two branches meet, and a closed form that takes square roots of
rounding may lose them there. Near such a target it has them. So where a candidate had to be dropped, or a
solution is singular, the closed form is asked again for a few targets close by, and what it has there and not
here is brought back by Newton steps.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.inverse.arm import Arm, Array, volumes
from kinematics.inverse.closed_form import NEARLY, ClosedForm, Decomposition
from kinematics.inverse.distinct import differences, distinct
from kinematics.inverse.residuals import are_solutions, error_vectors
from kinematics.inverse.search import low_discrepancy, polish
from kinematics.se3 import Transform

TOLERANCE = 5e-10
"""Largest distance [m] and angle [rad] of a solution from a closed form."""

AS_IT_IS = 1e-11
"""A candidate this exact [m and rad] is left as it is."""

FIRST_STEPS = 3
"""Newton steps for a candidate far from the target: at a wrist in line a closed form may leave the turns
about the common axis undetermined, and the first step determines them."""

NEARBY = 1e-4
"""How far off the targets close by are [rad, and parts of the size]."""

APART = 1e-2
"""Joint values of different branches differ by more than this [rad, and parts of the size]."""

SMALL_VOLUME = 1e-6
"""|det J| (of arms with fewer than six joints det JᵀJ) below which two branches may have met."""

_SHIFTS = 2.0 * low_discrepancy(8, 6) - 1.0


def solutions_of(arm: Arm, closed_form: ClosedForm, target: Transform) -> Array | None:
    """All solutions of a closed form, each once, as exact as floating point has them.

    Args:
        arm: the arm.
        closed_form: its closed form.
        target: (4, 4).

    Returns:
        (m, n), or None where the method has no answer for this target.
    """
    candidates = closed_form.candidates(target)
    if candidates is None:
        return None
    found, dropped = refined(arm, candidates, target)
    lossy = dropped and isinstance(closed_form, Decomposition)
    if lossy or not len(found) or _near_singular(arm, found):
        beside = _branches_nearby(arm, closed_form, target, found)
        if len(beside):
            more, _ = refined(arm, beside, target)
            found = distinct(arm, target, np.concatenate((found, more)))
    return found


def refined(arm: Arm, candidates: Array, target: Transform) -> tuple[Array, int]:
    """The solutions among candidates, each once, the most exact first; and how many were dropped."""
    if not len(candidates):
        return candidates, 0
    q = candidates
    vectors = error_vectors(arm.frames(q)[-1], target, arm.size)
    errors = np.linalg.norm(vectors, axis=1)
    far = errors >= NEARLY
    if far.any():
        q = _polished(arm, target, q, far, FIRST_STEPS)
        vectors = error_vectors(arm.frames(q)[-1], target, arm.size)
        errors = np.linalg.norm(vectors, axis=1)
    rough = ~are_solutions(vectors, arm, AS_IT_IS) & (errors < NEARLY)
    if rough.any():
        q = _polished(arm, target, q, rough, 20)
        vectors = error_vectors(arm.frames(q)[-1], target, arm.size)
        errors = np.linalg.norm(vectors, axis=1)
    exact = are_solutions(vectors, arm, TOLERANCE)
    ranked = np.argsort(errors[exact], kind="stable")
    return distinct(arm, target, q[exact][ranked]), int((~exact).sum())


def _polished(arm: Arm, target: Transform, q: Array, which: NDArray[np.bool_], steps: int) -> Array:
    q = q.copy()
    q[which] = polish(arm, target, q[which], steps)
    return q


def _near_singular(arm: Arm, joints: Array) -> bool:
    J = arm.jacobians(arm.frames(joints)) * arm.units
    volume = volumes(J)
    return bool((volume < SMALL_VOLUME).any())


def _branches_nearby(arm: Arm, closed_form: ClosedForm, target: Transform, found: Array) -> Array:
    """Solutions for targets close by that are on no branch that was found."""
    rows, owners = [], []
    targets = [_shifted(target, NEARBY * shift, arm.size) for shift in _SHIFTS]
    for beside in targets:
        candidates = closed_form.candidates(beside)
        if candidates is not None and len(candidates):
            rows.append(candidates)
            owners.append(np.broadcast_to(beside, (len(candidates), 4, 4)))
    if not rows:
        return np.empty((0, arm.n_joints))
    q = np.concatenate(rows)
    vectors = error_vectors(arm.frames(q)[-1], np.concatenate(owners), arm.size)
    q = q[np.linalg.norm(vectors, axis=1) < NEARBY]
    if len(found):
        q = q[
            np.abs(differences(q[:, None], found[None], arm)).max(axis=2).min(axis=1, initial=np.inf) > APART
        ]
    new: list[Array] = []
    for one in q:
        if all(np.abs(differences(one, other, arm)).max() > APART for other in new):
            new.append(one)
    return np.array(new).reshape(-1, arm.n_joints)


def _shifted(target: Transform, shift: Array, size: float) -> Transform:
    """The target moved by shift[:3] of the size and turned by shift[3:], in the base."""
    x, y, z = shift[3:]
    turned, _ = np.linalg.qr(np.eye(3) + np.array(((0.0, -z, y), (z, 0.0, -x), (-y, x, 0.0))))
    beside = target.copy()
    beside[:3, :3] = turned * np.sign(np.diag(turned)) @ target[:3, :3]
    beside[:3, 3] += size * shift[:3]
    return beside
