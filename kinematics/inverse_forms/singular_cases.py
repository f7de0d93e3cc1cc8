"""The equations of a singular case: one joint is chosen, and what it leaves follows."""

from __future__ import annotations

from dataclasses import replace

from kinematics.expressions import Parameter, walk
from kinematics.inverse_forms.steps import InverseForm, InverseStep, SingularCase


def form_of_case(form: InverseForm, case: SingularCase, chosen: str) -> InverseForm:
    """Return the equations that hold in a singular case, the first of its free joints chosen.

    The equations are those of the form but for the ones that the case replaces. What is 0 in this case
    becomes a condition, and a sign that no equation holds is no branch any more. What is returned may have
    another singular case, and be asked for that.

    Args:
        form: the general equations.
        case: one of theirs.
        chosen: name of the value that is chosen, a parameter of the equations.

    Raises:
        ValueError: the case is not one of the form's.
    """
    if not any(case in step.singular for step in form.steps):
        raise ValueError("no case of these equations")
    (free, *_) = case.free
    replaced = {f"q{free}", *(step.name for step in case.steps)}
    steps = [InverseStep(name=f"q{free}", joint=free, value=Parameter(chosen))]
    for step in form.steps:
        if case in step.singular:
            steps.extend(case.steps)
        elif step.name not in replaced:
            steps.append(step)
    written = {node.name for step in steps for node in walk(step.value) if isinstance(node, Parameter)}
    return replace(
        form,
        steps=tuple(steps),
        branches=tuple(sign for sign in form.branches if sign in written),
        conditions=(*case.conditions, *form.conditions),
    )
