"""Methods that yield all solutions of an arm, and which arm has which.

What a method returns are candidates: each is refined and judged by our own forward kinematics. Every
method is tried on the inverse chain as well, T⁻¹ being a chain of the reversed joints at -q;
and an arm of five joints is an arm of six of which the last stands still.

Arms of which the Jacobian has full rank nowhere have redundant joints, so no finite number of solutions.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np

from kinematics.inverse.arm import Arm, ArmReach, Array, low_discrepancy
from kinematics.inverse.methods.general import general_arm_of
from kinematics.inverse.methods.parallel import parallel_arm_of
from kinematics.inverse.methods.partition import partition_of, placement_of
from kinematics.inverse.methods.wrist import wrist_arm_of
from kinematics.se3 import inverse_transform, skew

NEARLY = 0.1  # Candidates with a larger error vector than this are least-squares answers, not solutions.

STANDING_STILL = 0.05
"""Largest turn [rad] of the joint that was added to an arm of five: at a double root rounding moves it most,
by its square root, 1e-6 or so."""

TARGETS_BESIDE = 8  # Targets beside one without an answer, some of which have an answer each.

BESIDE = 1e-3
"""How far they are from it [rad, and parts of the size]: nearer ones have as few digits as the target
itself, and from farther ones Newton steps lead astray."""


class InverseClosedForm(Protocol):
    """A method that yields candidates among which all solutions are."""

    def candidates(self, target: Array) -> Array | None:
        """Return the configurations among which all solutions are.

        Returns:
            (m, n); every isolated solution is near one of them. None where the method has no answer for this
            target.
        """
        ...


@dataclass(frozen=True, eq=False)
class FromTheHand:
    """The closed form of the reversed chain."""

    reversed: InverseClosedForm

    def candidates(self, target: Array) -> Array | None:
        """See `InverseClosedForm`."""
        found = self.reversed.candidates(inverse_transform(target))
        return None if found is None else -found[:, ::-1]


@dataclass(frozen=True, eq=False)
class WithoutLast:
    """The closed form of an arm with one more joint, which has to stand still."""

    longer: InverseClosedForm

    def candidates(self, target: Array) -> Array | None:
        """See `InverseClosedForm`."""
        found = self.longer.candidates(target)
        if found is None:
            return None
        last = np.abs((found[:, -1] + np.pi) % (2.0 * np.pi) - np.pi)
        return np.asarray(found[last <= STANDING_STILL, :-1])


def closed_form_of(arm: Arm) -> InverseClosedForm | None:
    """Return the closed form of an arm, or None if there is none."""
    if arm.n_joints > 6 or arm.redundancy:
        return None
    if arm.reach is not ArmReach.POSE:
        return placement_of(arm) if arm.reach is ArmReach.POSITION else None
    if arm.n_joints <= 4:
        return partition_of(arm)
    methods: list[Callable[[Arm], InverseClosedForm | None]] = [wrist_arm_of, partition_of, parallel_arm_of]
    found = _either_way(arm, methods)
    if found is not None or not arm.revolute.all():
        return found
    if arm.n_joints == 6:
        return general_arm_of(arm)
    longer = _with_one_more(arm)
    inner = _either_way(longer, [parallel_arm_of]) or general_arm_of(longer)
    return None if inner is None else WithoutLast(inner)


def candidates_beside(closed_form: InverseClosedForm, arm: Arm, target: Array) -> Array:
    """Return (m, n) configurations near the solutions for a target at which a closed form has no answer.

    Some poses, as of an arm folded into a plane, make its equations dependent; beside them they are not.
    """
    found = [np.empty((0, arm.n_joints))]
    for off in BESIDE * (2.0 * low_discrepancy(TARGETS_BESIDE, 6) - 1.0):
        half = 0.5 * skew(off[3:])
        beside = target.copy()
        beside[:3, :3] = np.linalg.solve(np.eye(3) - half, (np.eye(3) + half) @ target[:3, :3])
        beside[:3, 3] += arm.size * off[:3]
        candidates = closed_form.candidates(beside)
        if candidates is not None:
            found.append(candidates)
    return np.concatenate(found)


def _either_way(
    arm: Arm, methods: list[Callable[[Arm], InverseClosedForm | None]]
) -> InverseClosedForm | None:
    """The first method that has an answer for the arm or for its reversed chain."""
    for method in methods:
        found = method(arm)
        if found is not None:
            return found
        found = method(reversed_arm(arm))
        if found is not None:
            return FromTheHand(found)
    return None


def reversed_arm(arm: Arm) -> Arm:
    """Return the inverse chain: T⁻¹ = K_n⁻¹ J_n(-q_n) ⋯ J_1(-q_1) K_0⁻¹."""
    return replace(
        arm, constants=inverse_transform(arm.constants)[::-1].copy(), revolute=arm.revolute[::-1].copy()
    )


def _with_one_more(arm: Arm) -> Arm:
    """The arm with one more revolute joint at its end; its axis meets and is parallel to no other."""
    away = np.eye(4)
    away[:3, :3] = np.linalg.qr(np.array(((0.3, -0.8, 0.5), (0.9, 0.2, -0.4), (0.1, 0.7, 0.6))))[0]
    away[:3, :3] *= np.linalg.det(away[:3, :3])
    away[:3, 3] = arm.size * np.array((0.21, -0.13, 0.17))
    constants = np.concatenate((arm.constants[:-1], [arm.constants[-1] @ away], [inverse_transform(away)]))
    return replace(arm, constants=constants, revolute=np.append(arm.revolute, True))
