"""The equations of an arm for the pose of its tool in the world."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import chain

from kinematics.dh import MotionKind
from kinematics.errors import Fault, TableError
from kinematics.expressions import ONE, ZERO, Expression, Function, Parameter, add, multiply, negate, walk
from kinematics.inverse_forms.derivation import inverse_form
from kinematics.inverse_forms.signed_axes import Vector, circular
from kinematics.inverse_forms.steps import InverseForm, InverseQuantity, InverseStep
from kinematics.se3 import triple
from kinematics.symbolic.motions import Motion, motions_of
from kinematics.table import SymbolicTable, table_parameters

Matrix = Sequence[Sequence[Expression]]

_ROTATION = tuple(tuple(f"t{i}{j}" for j in (1, 2, 3)) for i in (1, 2, 3))
_POSITION = ("t_x", "t_y", "t_z")


def inverse_form_in_world(
    table: SymbolicTable, base: Matrix | None = None, tool: Matrix | None = None, taken: Sequence[str] = ()
) -> InverseForm:
    """Return the inverse kinematics for targets base · ⁰T_N · tool.

    Fixed rows before the first joint, and behind the last, count as base and tool where they turn by anything
    but right angles.

    Args:
        table: the DH table; lengths may be numbers or parameters.
        base: 4×4 pose of frame 0 in the world, or None.
        tool: 4×4 pose of the tool in frame N, or None.
        taken: names that nothing else may have, besides those of the parameters.

    Raises:
        TableError: as `inverse_form`.
    """
    try:
        form = inverse_form(table, taken, _origin(tool))
    except TableError:
        first, behind = table.joint_rows[:1], table.joint_rows[-1:]
        if not first or (first[0] == 0 and behind[0] == len(table.rows) - 1):
            raise
        start, stop = first[0], behind[0] + 1
        ahead, arm, hand = (
            replace(table, rows=rows)
            for rows in (table.rows[:start], table.rows[start:stop], table.rows[stop:])
        )
        base, tool = _joined(base, _pose(ahead)), _joined(_pose(hand), tool)
        try:
            form = inverse_form(arm, taken, _origin(tool))
        except TableError as error:
            raise TableError(_behind(start, fault) for fault in error.faults) from None
    return with_base_and_tool(form, base, tool, (*table_parameters(table), *taken))


def _behind(rows: int, fault: Fault) -> Fault:
    """A fault at its row of the whole table."""
    match fault.where:
        case ("rows", int(i), *cell):
            return replace(fault, where=("rows", rows + i, *cell))
    return fault


def _origin(tool: Matrix | None) -> Vector:
    """The tool's origin in frame N."""
    return (ZERO, ZERO, ZERO) if tool is None else triple(row[3] for row in tool[:3])


def _joined(one: Matrix | None, other: Matrix | None) -> Matrix | None:
    return _product(one, other) if one is not None and other is not None else one or other


def _pose(table: SymbolicTable) -> Matrix | None:
    """The product of fixed rows; None of none."""
    pose: Matrix | None = None
    for motion in chain.from_iterable(motions_of(table)):
        pose = _joined(pose, _moved(motion))
    return pose


def _moved(motion: Motion) -> Matrix:
    moved: list[list[Expression]] = [[ONE if i == j else ZERO for j in range(4)] for i in range(4)]
    axis = 0 if motion.kind in (MotionKind.SHIFT_X, MotionKind.TURN_X) else 2
    if motion.kind in (MotionKind.SHIFT_X, MotionKind.SHIFT_Z):
        moved[axis][3] = motion.amount
    else:
        i, j = (axis + 1) % 3, (axis + 2) % 3
        c, s = circular(Function.COS, motion.amount), circular(Function.SIN, motion.amount)
        moved[i][i], moved[i][j], moved[j][i], moved[j][j] = c, negate(s), s, c
    return moved


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
