"""The equations of an arm for the pose of its tool in the world."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import chain

from kinematics.expressions import Expression, Parameter, add, multiply, negate, walk
from kinematics.inverse_forms.steps import InverseForm, InverseQuantity, InverseStep

Matrix = Sequence[Sequence[Expression]]

_ROTATION = tuple(tuple(f"t{i}{j}" for j in (1, 2, 3)) for i in (1, 2, 3))
_POSITION = ("t_x", "t_y", "t_z")


def with_base_and_tool(
    form: InverseForm, base: Matrix | None, tool: Matrix | None, taken: Sequence[str] = ()
) -> InverseForm:
    """Return the form for targets base · ⁰T_N · tool.

    Its first steps take the target to frame 0, and its rotation to that of frame N.

    Args:
        form: for the rotation of frame N and the position of the tool, its `tip`.
        base: 4×4 pose of frame 0 in the world, or None.
        tool: 4×4 pose of the tool in frame N, or None.
        taken: names that nothing else may have.
    """
    if base is None and tool is None:
        return form
    used = {*taken, *(step.name for step in form.steps), *form.branches}
    mark = "" if used.isdisjoint(chain(_POSITION, *_ROTATION)) else "0"
    rotation = tuple(tuple(name + mark for name in row) for row in _ROTATION)
    position = tuple(name + mark for name in _POSITION)
    R: Matrix = [[Parameter(name) for name in row] for row in rotation]
    p: Sequence[Expression] = [Parameter(name) for name in position]
    if tool is not None:  # R toolᵀ
        R = _product(R, _transposed(tool))
    if base is not None:  # baseᵀ R, baseᵀ (p - b)
        back = _transposed(base)
        off = [add((x, negate(row[3]))) for x, row in zip(p, base[:3], strict=True)]
        R = _product(back, R)
        p = [add(multiply(pair) for pair in zip(row, off, strict=True)) for row in back]
    values = dict(zip(chain(*form.rotation, form.position), chain(*R, p), strict=True))
    written = (*(step.value for step in form.steps), *form.zeros, *form.case_values)
    needed = {node.name for value in written for node in walk(value) if isinstance(node, Parameter)}
    first = [
        InverseStep(name=name, value=value, quantity=InverseQuantity.TARGET)
        for name, value in values.items()
        if name in needed
    ]
    return replace(form, steps=(*first, *form.steps), rotation=rotation, position=position)


def _transposed(pose: Matrix) -> Matrix:
    return [[pose[j][i] for j in range(3)] for i in range(3)]


def _product(A: Matrix, B: Matrix) -> Matrix:
    columns = list(zip(*B, strict=True))
    return [
        [add(multiply(pair) for pair in zip(row, column, strict=True)) for column in columns] for row in A
    ]
