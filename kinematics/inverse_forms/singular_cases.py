"""The equations of a singular case: one joint is chosen, and what it leaves follows."""

from collections.abc import Sequence
from dataclasses import replace

from kinematics.expressions import Parameter, parameters_in
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
    conditions = (*case.conditions, *form.conditions)
    steps, held = _needed(steps, {name for one in conditions for name in parameters_in(one.value)})
    return replace(
        form,
        steps=tuple(steps),
        branches=tuple(sign for sign in form.branches if sign in held),
        conditions=conditions,
    )


def _needed(steps: Sequence[InverseStep], held: set[str]) -> tuple[list[InverseStep], set[str]]:
    """The steps of joints, and those whose names are held; and all names that are held then.

    What the case leaves out may have no value: a quotient by what is 0.
    """
    kept: list[InverseStep] = []
    for step in reversed(steps):
        if step.joint or step.name in held:
            kept.append(step)
            values = (step.value, *(one.value for one in step.conditions))
            held = held.union(*map(parameters_in, values))
    return kept[::-1], held
