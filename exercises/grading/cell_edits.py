"""Misconceptions about one cell."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace

from exercises.grading.fitting import fitted_tables, fitting_values
from exercises.grading.work import Apply, Change, Extent, Work, change, with_cell, with_row
from kinematics.cells import AngleUnit
from kinematics.equivalence import DirectionRule, ZeroRule
from kinematics.expressions import Number, Parameter, Product
from kinematics.table import JointType, NumericTable

RIGHT_ANGLES = (0.0, math.pi / 2, -math.pi / 2, math.pi)
# A share of the robot: the arithmetic’s errors.
SAME = 1e-9
TOO_LONG, TOO_SHORT = 2.0, 0.02


def _set(row: int, cell: str, value: Callable[[float], float]) -> Apply:
    """The edit that replaces a cell by a function of what stands there."""

    def apply(table: NumericTable, draw: int) -> Iterable[NumericTable]:
        return (with_cell(table, row, cell, value(getattr(table.rows[row], cell))),)

    return apply


def _always(value: float) -> Callable[[float], float]:
    return lambda _: value


def _cell(code: str, row: int, cell: str, value: Callable[[float], float]) -> Change:
    return change(code, _set(row, cell, value), extent=Extent.CELL, row=row, cell=cell)


def alpha_sign(work: Work) -> Iterator[Change]:
    """α with the other sign."""
    for i, row in enumerate(work.tables[0].rows):
        if abs(math.sin(row.alpha)) > work.policy.tolerance.angle:
            yield _cell("alpha_sign", i, "alpha", lambda x: -x)


def alpha_value(work: Work) -> Iterator[Change]:
    """α another multiple of a right angle, or whatever the key's axes ask for."""
    near = work.policy.tolerance.angle
    for i, row in enumerate(work.tables[0].rows):
        for angle in RIGHT_ANGLES:
            apart = abs(math.remainder(row.alpha - angle, 2 * math.pi))
            mirrored = abs(math.remainder(row.alpha + angle, 2 * math.pi))
            if apart > near and mirrored > near:
                yield _cell("alpha_value", i, "alpha", _always(angle))
        yield change("alpha_value", _fitted(work, i, "alpha"), extent=Extent.CELL, row=i, cell="alpha")


def sign_of_length(work: Work) -> Iterator[Change]:
    """A with the other sign."""
    for i, row in enumerate(work.tables[0].rows):
        if row.a:
            yield _cell("a_sign", i, "a", lambda x: -x)


def sign_of_offset(work: Work) -> Iterator[Change]:
    """D with the other sign."""
    for i, row in enumerate(work.tables[0].rows):
        if row.d and (row.joint is not JointType.PRISMATIC or work.policy.zero is ZeroRule.FIGURE):
            yield _cell("d_sign", i, "d", lambda x: -x)


def sign_of_variable(work: Work) -> Iterator[Change]:
    """The variable counted the other way."""
    if work.policy.direction is DirectionRule.FREE:
        return

    def reversed_in(row: int) -> Apply:
        def apply(table: NumericTable, draw: int) -> Iterable[NumericTable]:
            return (with_row(table, row, replace(table.rows[row], sign=-table.rows[row].sign)),)

        return apply

    for i, row in enumerate(work.tables[0].rows):
        if row.joint is not JointType.FIXED:
            cell = "theta" if row.joint is JointType.REVOLUTE else "d"
            yield change("variable_sign", reversed_in(i), extent=Extent.CELL, row=i, cell=cell)


def angle_in_degrees(work: Work) -> Iterator[Change]:
    """One angle of a table in radians was meant in degrees."""
    if work.answer.angle_unit is not AngleUnit.RAD:
        return
    for i, cell in _angles(work):
        if abs(getattr(work.tables[0].rows[i], cell)) > 1.0:
            yield _cell("cell_in_degrees", i, cell, math.radians)


def angle_in_radians(work: Work) -> Iterator[Change]:
    """One angle of a table in degrees was meant in radians."""
    if work.answer.angle_unit is not AngleUnit.DEG:
        return
    for i, cell in _angles(work):
        if 0 < abs(getattr(work.tables[0].rows[i], cell)) <= math.radians(2 * math.pi) + SAME:
            yield _cell("cell_in_radians", i, cell, math.degrees)


def _angles(work: Work) -> Iterator[tuple[int, str]]:
    """Where an angle stands that matters."""
    for i, row in enumerate(work.tables[0].rows):
        yield i, "alpha"
        if row.joint is not JointType.REVOLUTE or work.policy.zero is ZeroRule.FIGURE:
            yield i, "theta"


def theta_value(work: Work) -> Iterator[Change]:
    """θ turned by right angles, where it is no joint variable or the figure says where that is zero."""
    for i, row in enumerate(work.tables[0].rows):
        if row.joint is JointType.REVOLUTE and work.policy.zero is ZeroRule.FREE:
            continue
        code = "theta_offset" if row.joint is JointType.REVOLUTE else "theta_value"
        for angle in {*RIGHT_ANGLES, -row.theta}:
            if abs(math.remainder(row.theta - angle, 2 * math.pi)) > work.policy.tolerance.angle:
                apply = _set(i, "theta", _always(angle))
                yield change(code, apply, extent=Extent.CELL, row=i, cell="theta")
        if row.joint is not JointType.REVOLUTE:
            yield change(code, _fitted(work, i, "theta"), extent=Extent.CELL, row=i, cell="theta")


def length_value(work: Work) -> Iterator[Change]:
    """A as the key's axes ask for."""
    return _fitted_lengths(work, "a")


def offset_value(work: Work) -> Iterator[Change]:
    """D as the key's axes ask for."""
    return _fitted_lengths(work, "d")


def _fitted_lengths(work: Work, cell: str) -> Iterator[Change]:
    for i, row in enumerate(work.tables[0].rows):
        if cell == "d" and row.joint is JointType.PRISMATIC:
            continue
        for value in fitting_values(work, work.tables[0], 0, i, cell):
            code = _story(work, i, cell, value)
            yield change(code, _near(work, i, cell, value), extent=Extent.CELL, row=i, cell=cell)


def length_in_other_unit(work: Work) -> Iterator[Change]:
    """One length typed in millimetres or centimetres where metres are declared, or the reverse."""
    for i, row in enumerate(work.tables[0].rows):
        for cell in ("a", "d"):
            if not getattr(row, cell) or (cell == "d" and row.joint is JointType.PRISMATIC):
                continue
            here, size = abs(getattr(row, cell)), work.references[0].size
            ratios = (
                (0.001, 0.01)
                if here > TOO_LONG * size
                else (1000.0, 100.0)
                if here < TOO_SHORT * size
                else ()
            )
            for ratio in ratios:
                yield _cell("cell_length_unit", i, cell, _times(ratio))


def _times(ratio: float) -> Callable[[float], float]:
    return lambda x: x * ratio


def any_cell(work: Work) -> Iterator[Change]:
    """A cell as the whole robot asks for, where no single fact of it shows the value."""
    for i, row in enumerate(work.tables[0].rows):
        cells = ["a", "alpha"]
        if row.joint is not JointType.PRISMATIC:
            cells.append("d")
        if row.joint is not JointType.REVOLUTE:
            cells.append("theta")
        for cell in cells:
            for table in fitted_tables(work, work.tables[0], 0, ((i, cell),)):
                value = getattr(table.rows[i], cell)
                code = f"{cell}_value" if cell in ("alpha", "theta") else _story(work, i, cell, value)
                yield change(code, _fitted_to_all(work, i, cell), extent=Extent.CELL, row=i, cell=cell)


def _fitted_to_all(work: Work, row: int, cell: str) -> Apply:
    return lambda table, draw: fitted_tables(work, table, draw, ((row, cell),))


def _story(work: Work, row: int, cell: str, value: float) -> str:
    """What happened to a length that stands there instead of `value`."""
    here = getattr(work.tables[0].rows[row], cell)
    scale = work.references[0].size * max(work.policy.tolerance.length, SAME)
    if abs(value) <= scale:
        return f"{cell}_not_zero"
    if abs(here) <= scale:
        return f"{cell}_missing"
    if abs(value + here) <= scale:
        return f"{cell}_sign"
    for power in (1000.0, 100.0, 10.0):
        for ratio in (power, 1.0 / power):
            if abs(abs(here) - abs(value) * ratio) <= 1e-6 * abs(here):
                return "cell_length_unit"
    if _is_a_name(work, row, cell) and _is_some_name(work, value):
        return "cell_parameter"
    return f"{cell}_value"


def _is_a_name(work: Work, row: int, cell: str) -> bool:
    entry = (
        getattr(work.comparison.meant_table.rows[row], cell)
        if row < len(work.comparison.meant_table.rows)
        else None
    )
    match entry:
        case Parameter() | Product((Number(), Parameter())):
            return True
    return False


def _is_some_name(work: Work, value: float) -> bool:
    return any(
        abs(abs(value) - abs(known)) <= 1e-6 * abs(known) for known in work.comparison.draws[0].values()
    )


def _fitted(work: Work, row: int, cell: str) -> Apply:
    def apply(table: NumericTable, draw: int) -> Iterable[NumericTable]:
        return [with_cell(table, row, cell, x) for x in fitting_values(work, table, draw, row, cell)]

    return apply


def _near(work: Work, row: int, cell: str, value: float) -> Apply:
    """At the first draw the value found; at others, whichever of those that fit there."""

    def apply(table: NumericTable, draw: int) -> Iterable[NumericTable]:
        values = [value] if draw == 0 else fitting_values(work, table, draw, row, cell)
        return [with_cell(table, row, cell, x) for x in values]

    return apply
