"""From a request for inverse kinematics in symbols to the written equations."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Any

from kinematics.errors import Fault, FormSizeError
from kinematics.expressions import Expression, JointVariable, Parameter, walk
from kinematics.inverse_forms import InverseCondition, InverseForm, InverseStep, SingularCase
from kinematics.inverse_forms.derivation import MOST_JOINTS
from kinematics.inverse_forms.outer_frames import inverse_form_in_world
from kinematics.printing import LIMIT, Notation
from kinematics.printing.equation_lists import MISFIT, EquationPrinter, NamedValue, source_of, symbols_of
from kinematics.printing.formats import EquationFormat
from kinematics.printing.notation import Names
from kinematics.symbolic import count_operations
from kinematics.symbolic.size import bottom_up
from kinematics.table import CELLS
from service.schemas.kinematics.inverse_forms import SymbolicInverseAnswer, SymbolicInverseRequest
from service.settings import Settings
from service.wire.kinematics.exact_values import exact_question
from service.wire.kinematics.symbolic_forms import FormTask

QUICK_NODES = 500
"""Nodes of the table's expressions up to which a closed form takes some ten milliseconds, and a format as
much."""


@dataclass(frozen=True, kw_only=True, slots=True)
class InverseFormTask(FormTask[EquationFormat]):
    """Equations to be found and written."""

    def is_quick(self) -> bool:
        """Return whether the answer is certain to be small: no arm with more joints has a closed form."""
        cells = (getattr(row, cell) for row in self.table.rows for cell in CELLS)
        return self.table.n_joints <= MOST_JOINTS and len(bottom_up(cells)) <= QUICK_NODES


def inverse_form_task(question: SymbolicInverseRequest, settings: Settings) -> InverseFormTask:
    """Return what a validated request asks of the workers.

    Raises:
        KinematicsError: see `exact_question`.
    """
    return InverseFormTask(**exact_question(question, settings))


def written_inverse(task: InverseFormTask) -> bytes:
    """Return the answer to a task, as JSON.

    Raises:
        TableError: the arm has no such form, at a row or a cell of its table.
        FormSizeError: the equations have too many operations to be written out.
    """
    parameters = task.parameters
    form = inverse_form_in_world(task.table, task.base, task.tool, task.variables)
    expressions = [*(step.value for step in form.steps), *_values_of(form)]
    printed = [*expressions, *form.case_values, *(step.meaning for step in form.steps if step.meaning)]
    if count_operations(printed) > LIMIT:
        raise FormSizeError(Fault.at("closed_form_too_large", limit=LIMIT))
    names = Names(
        notation=task.notation,
        parameters=frozenset((*parameters, *(step.name for step in form.steps if not step.joint))),
        variables=task.variables,
    )
    printer = EquationPrinter(names)
    equations = [NamedValue(step.name, step.joint, step.value) for step in form.steps]
    arguments = _arguments(form, expressions, parameters)
    sources = [chosen for chosen in task.formats if chosen.is_source]

    written = _Written(printer, task.formats)
    answer: dict[str, Any] = {
        **task.head,
        "target": {
            "reach": form.reach,
            "rotation": [list(row) for row in form.rotation],
            "position": list(form.position),
        },
        "branches": list(form.branches),
        "equations": [
            {
                **written.definition(step),
                "quantity": step.quantity,
                "meaning": written.value(step.meaning),
                "branch": step.branch or None,
                "conditions": written.conditions(step.conditions),
                "singular": [written.case(case) for case in step.singular],
            }
            for step in form.steps
        ],
        "conditions": written.conditions(form.conditions),
        "arguments": arguments,
    }
    if sources:
        joints = [JointVariable(joint) for joint in range(1, task.table.n_joints + 1)]
        answer["code"] = {one.value: source_of(equations, arguments, joints, one) for one in sources}
        zeros = form.zeros
        if zeros:
            answer["misfit_code"] = {
                one.value: source_of(equations, arguments, zeros, one, MISFIT) for one in sources
            }
    if task.notation is Notation.SHORT:
        answer["symbols"] = symbols_of(names, printed)
    return SymbolicInverseAnswer(**answer).model_dump_json(by_alias=True, exclude_none=True).encode()


@dataclass(frozen=True, slots=True)
class _Written:
    """What stands in an answer, in the formats that were asked for."""

    printer: EquationPrinter
    formats: Sequence[EquationFormat]

    def value(self, expression: Expression | None) -> dict[str, Any] | None:
        return None if expression is None else self.printer.value(expression, self.formats)

    def definition(self, step: InverseStep) -> dict[str, Any]:
        equation = NamedValue(step.name, step.joint, step.value)
        return {**self.printer.equation(equation, self.formats), "joint": step.joint or None}

    def conditions(self, some: Iterable[InverseCondition]) -> list[dict[str, Any]]:
        return [{"kind": one.kind, **self.printer.value(one.value, self.formats)} for one in some]

    def case(self, case: SingularCase) -> dict[str, Any]:
        return {
            "conditions": [self.value(one.value) for one in case.conditions],
            "joint": case.joint or None,
            "at": self.value(case.at),
            "free": list(case.free),
            "combination": self.value(case.combination),
            "value": self.value(case.value),
            "equations": [self.definition(step) for step in case.steps],
        }


def _values_of(form: InverseForm) -> list[Expression]:
    return [one.value for one in chain(form.conditions, *(step.conditions for step in form.steps))]


def _arguments(form: InverseForm, expressions: Iterable[Expression], parameters: Iterable[str]) -> list[str]:
    used = {node.name for value in expressions for node in walk(value) if isinstance(node, Parameter)}
    target = [name for name in chain(*form.rotation, form.position) if name in used]
    return [*target, *form.branches, *parameters]
