"""The numbers of a solution in symbols: one choice of signs after another."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import product

import numpy as np
from numpy.typing import ArrayLike

from kinematics.errors import ParameterError
from kinematics.expressions import Expression, evaluate
from kinematics.inverse_forms.formulas import rounding_of, without_root
from kinematics.inverse_forms.steps import ConditionKind, InverseCondition, InverseForm, InverseStep
from kinematics.se3 import check_transform

FULFILLED = 1e-9
"""Part of 1 and of the target's distance by which a condition on the target may be off: rounding."""


def joint_values(
    form: InverseForm, target: ArrayLike, parameters: Mapping[str, float] | None = None
) -> Iterator[tuple[tuple[int, ...], tuple[float, ...]]]:
    """Yield every choice of signs with its joint variables, where they exist.

    Args:
        target: (4, 4) pose of the end-effector; of an arm that only reaches positions the rotation does not
            matter.
        parameters: value of each parameter by name [m or rad].

    Raises:
        PoseError: not a rigid motion.
    """
    T = check_transform(target, where=("target",))
    far = 1.0 + float(np.abs(T[:3, 3]).max())
    known = dict(parameters or {})
    for row, names in zip(T[:3, :3].tolist(), form.rotation, strict=True):
        known |= dict(zip(names, row, strict=True))
    known |= dict(zip(form.position, T[:3, 3].tolist(), strict=True))
    count = max(step.joint for step in form.steps)
    for signs in product((1, -1), repeat=len(form.branches)):
        values = known | dict(zip(form.branches, map(float, signs), strict=True))
        joints = [0.0] * count
        try:
            for step in form.steps:
                _require(step.conditions, values, joints, far)
                value = evaluate(_rounded(step, values, joints), values, joints)
                if step.joint:
                    joints[step.joint - 1] = value
                else:
                    values[step.name] = value
            _require(form.conditions, values, joints, far)
        except (ParameterError, _Unfulfilled):
            continue
        yield signs, tuple(joints)


def _rounded(step: InverseStep, values: Mapping[str, float], joints: Sequence[float]) -> Expression:
    """The step's value, without roots of what is negative by rounding alone."""
    value = step.value
    for condition in step.conditions:
        if condition.kind is ConditionKind.REACHABLE:
            radicand = evaluate(condition.value, values, joints)
            if -evaluate(rounding_of(condition.value), values, joints) <= radicand < 0.0:
                value = without_root(value, condition.value)
    return value


class _Unfulfilled(Exception):  # noqa: N818
    """A target is none that the arm can have."""


def _require(
    conditions: Sequence[InverseCondition], values: Mapping[str, float], joints: Sequence[float], far: float
) -> None:
    for condition in conditions:
        if condition.kind is ConditionKind.FULFILLED:
            off = evaluate(condition.value, values, joints)
            if abs(off) > FULFILLED * far:
                raise _Unfulfilled
