"""Arms with one redundant joint: one joint is locked, and what is left has a closed form.

A family of solutions of such an arm is a curve; wherever it crosses a value of the locked joint the closed
form finds it, exactly. Where it only comes near the value, or is a single point, the closed form's candidates
are the configurations that come nearest, from which a descent finds it.

Source: for the joint that is chosen as a parameter, S. Lee, A. K. Bejczy, Redundant arm kinematic control
based on parameterization, IEEE Int. Conf. Robotics and Automation (1991) 458.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from kinematics.inverse.arm import Arm, Array
from kinematics.inverse.methods.closed_form import InverseClosedForm, closed_form_of
from kinematics.inverse.methods.general import GeneralArm
from kinematics.inverse.residuals import errors_at

VALUES = 32  # Angles at which a joint is locked, spread over a turn.

EVERY = 4  # Of exact solutions those of every fourth angle are enough: families cross many.

EXACT = 1e-6  # Size of the error vector of a candidate that is a solution.

NEAR = 0.2  # The same of one from which a descent is worth while.

_FIRST = 0.37
"""Part of the distance between angles by which the first is off a half turn: round angles are special."""


@dataclass(frozen=True, eq=False)
class LockedArms:
    """Closed forms of an arm with one joint locked.

    Attributes:
        arm: with one redundant joint.
    """

    arm: Arm

    def starts(self, target: Array) -> Array:
        """Return (m, n) configurations at or near solutions."""
        n = self.arm.n_joints
        exact, near = [np.empty((0, n))], [np.empty((0, n))]
        for k, joint, value, closed in self._closed_forms:
            candidates = closed.candidates(target)
            if candidates is None or not len(candidates):
                continue
            q = np.insert(candidates, joint, value, axis=1)
            errors = np.linalg.norm(errors_at(self.arm, q, target), axis=1)
            near.append(q[(errors > EXACT) & (errors < NEAR)])
            if k % EVERY == 0:
                exact.append(q[errors <= EXACT])
        return np.concatenate((*exact, *near))

    @cached_property
    def _closed_forms(self) -> list[tuple[int, int, float, InverseClosedForm]]:
        """Which of the values, which joint, its value, and the closed form of what is left."""
        return list(self._locked())

    def _locked(self) -> Iterator[tuple[int, int, float, InverseClosedForm]]:
        for joint in np.flatnonzero(self.arm.revolute).tolist():
            for k in range(VALUES):
                value = math.tau * (k + _FIRST) / VALUES - math.pi
                closed = closed_form_of(_with_locked(self.arm, joint, value))
                if closed is None or isinstance(closed, GeneralArm):
                    break
                yield k, joint, value, closed


def locked_arms_of(arm: Arm) -> LockedArms | None:
    """Return the closed forms of an arm with one joint locked; None unless exactly one is redundant."""
    return LockedArms(arm) if arm.redundancy == 1 else None


def _with_locked(arm: Arm, joint: int, value: float) -> Arm:
    c, s = math.cos(value), math.sin(value)
    turn = np.array(((c, -s, 0.0, 0.0), (s, c, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0), (0.0, 0.0, 0.0, 1.0)))
    K = arm.constants
    constants = np.concatenate((K[:joint], [K[joint] @ turn @ K[joint + 1]], K[joint + 2 :]))
    return replace(arm, constants=constants, revolute=np.delete(arm.revolute, joint))
