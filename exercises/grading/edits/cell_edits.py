"""Misconceptions about one cell."""

import math
from collections.abc import Iterator
from dataclasses import replace

from exercises.grading.edits.changes import Change, Extent, with_row
from exercises.grading.edits.fitting import fitted_table
from exercises.grading.edits.own_table import is_length_of
from exercises.grading.edits.work import Work
from exercises.grading.judging.judgement import share_of
from exercises.grading.judging.typed import SAME, meant_in_radians
from kinematics.cells import AngleUnit
from kinematics.equivalence import BaseRule, DirectionRule, Policy, ToolRule, ZeroRule
from kinematics.expressions import Number, Parameter, Product
from kinematics.table import ANGLES, LENGTHS, VARIABLE_CELLS, JointType

RIGHT_ANGLES = (0.0, math.pi / 2, -math.pi / 2, math.pi)
TOO_LONG, TOO_SHORT = 2.0, 0.02
"""Parts of the robot's size: a length beyond them may stand in another unit; what comes of that is judged."""


def _set(code: str, row: int, cell: str, value: float) -> Change:
    return Change(code, Extent.CELL, row, cell, ((row, cell, value),))


def alpha_sign(work: Work) -> Iterator[Change]:
    """Flip the sign of α."""
    for i, row in work.rows:
        if abs(math.sin(row.alpha)) > work.policy.tolerance.angle:
            yield _set("alpha_sign", i, "alpha", -row.alpha)


def alpha_value(work: Work) -> Iterator[Change]:
    """Set α to another multiple of a right angle, to its supplement, or to what the key's axes ask for."""
    near = work.policy.tolerance.angle
    for i, row in work.rows:
        supplements = _supplements(row.alpha) if _tells_senses_apart(work.policy) else ()
        for angle in (*RIGHT_ANGLES, *supplements):
            apart = abs(math.remainder(row.alpha - angle, math.tau))
            if apart > near and not _is_mirrored(row.alpha, angle, near):
                yield _set("alpha_value", i, "alpha", angle)
        for angle in work.fits.get((i, "alpha"), ()):
            if not _is_mirrored(row.alpha, angle, near):
                yield _set("alpha_value", i, "alpha", angle)


def _is_mirrored(alpha: float, angle: float, near: float) -> bool:
    """Whether an angle is -α, which is another change."""
    return abs(math.remainder(alpha + angle, math.tau)) <= near < abs(math.sin(alpha))


def _supplements(alpha: float) -> tuple[float, ...]:
    """The angles with which the next axis lies on the same line as with α or -α, but points the other way."""
    return () if abs(math.sin(2 * alpha)) <= SAME else (math.pi - alpha, alpha - math.pi)


def _tells_senses_apart(policy: Policy) -> bool:
    """Whether an axis that points the other way may make another robot, or break a rule."""
    return (
        policy.base in (BaseRule.ORIGIN, BaseRule.FRAME)
        or policy.tool in (ToolRule.POINT, ToolRule.FRAME)
        or policy.direction is DirectionRule.FIGURE
    )


def sign_of_length(work: Work) -> Iterator[Change]:
    """Flip the sign of `a`."""
    for i, row in work.rows_of_lengths:
        if row.a:
            yield _set("a_sign", i, "a", -row.a)


def sign_of_offset(work: Work) -> Iterator[Change]:
    """Flip the sign of `d`."""
    for i, row in work.rows_of_lengths:
        if row.d and (row.joint is not JointType.PRISMATIC or work.policy.zero is ZeroRule.FIGURE):
            yield _set("d_sign", i, "d", -row.d)


def sign_of_variable(work: Work) -> Iterator[Change]:
    """Count the variable the other way."""
    if work.policy.direction is DirectionRule.FREE:
        return
    for i, row in work.rows:
        if row.joint is not JointType.FIXED:
            cell = VARIABLE_CELLS[row.joint]
            table = with_row(work.table, i, replace(row, sign=-row.sign))
            yield Change("variable_sign", Extent.CELL, i, cell, table=table)


def angle_in_degrees(work: Work) -> Iterator[Change]:
    """Read one angle of a table in radians as degrees."""
    if work.answer.angle_unit is not AngleUnit.RAD:
        return
    for i, cell, angle in _angles(work):
        if abs(angle) > 1.0:
            yield _set("cell_in_degrees", i, cell, math.radians(angle))


def angle_in_radians(work: Work) -> Iterator[Change]:
    """Read one angle of a table in degrees as radians."""
    if work.answer.angle_unit is not AngleUnit.DEG:
        return
    for i, cell, angle in _angles(work):
        if 0 < abs(angle) <= math.radians(math.tau) + SAME:
            yield _set("cell_in_radians", i, cell, meant_in_radians(angle))


def _angles(work: Work) -> Iterator[tuple[int, str, float]]:
    """The angles that matter."""
    for i, row in work.rows:
        yield i, "alpha", row.alpha
        if row.joint is not JointType.REVOLUTE or work.policy.zero is ZeroRule.FIGURE:
            yield i, "theta", row.theta


def theta_value(work: Work) -> Iterator[Change]:
    """Turn θ by right angles, if it is no joint variable or the figure fixes its zero."""
    for i, row in work.rows:
        if row.joint is JointType.REVOLUTE and work.policy.zero is ZeroRule.FREE:
            continue
        code = "theta_offset" if row.joint is JointType.REVOLUTE else "theta_value"
        for angle in (*RIGHT_ANGLES, -row.theta):
            if abs(math.remainder(row.theta - angle, math.tau)) > work.policy.tolerance.angle:
                yield _set(code, i, "theta", angle)
        for angle in work.fits.get((i, "theta"), ()):
            yield _set(code, i, "theta", angle)


def length_value(work: Work) -> Iterator[Change]:
    """Set `a` to what the key's axes ask for."""
    return _fitted_lengths(work, "a")


def offset_value(work: Work) -> Iterator[Change]:
    """Set `d` to what the key's axes ask for."""
    return _fitted_lengths(work, "d")


def _fitted_lengths(work: Work, cell: str) -> Iterator[Change]:
    """Lengths that fit, the key's first; where no fact shows one, at either end, zero."""
    key = work.reference.table
    for i, row in work.rows_of_lengths:
        of_prismatic = cell == "d" and row.joint is JointType.PRISMATIC
        nothing = () if of_prismatic or not getattr(row, cell) else (0.0,)
        values = sorted(work.fits.get((i, cell), nothing), key=lambda value: not is_length_of(key, value))
        for value in values:
            yield _set("d_offset" if of_prismatic else _story(work, i, cell, value), i, cell, value)


def length_in_other_unit(work: Work) -> Iterator[Change]:
    """Read one length in millimetres or centimetres where metres are declared, or the reverse."""
    for i, row in work.rows_of_lengths:
        for cell in LENGTHS:
            if not getattr(row, cell) or (cell == "d" and row.joint is JointType.PRISMATIC):
                continue
            here, size = abs(getattr(row, cell)), work.reference.size
            ratios = (
                (0.001, 0.01)
                if here > TOO_LONG * size
                else (1000.0, 100.0)
                if here < TOO_SHORT * size
                else ()
            )
            for ratio in ratios:
                yield _set("cell_length_unit", i, cell, getattr(row, cell) * ratio)


def any_cell(work: Work, choice: int) -> Iterator[Change]:
    """Set a cell to what the whole robot asks for, if no single fact shows the value.

    Args:
        work: the table.
        choice: see `fitted_table`.
    """
    if work.only is not None and work.only.code is not None:
        return
    for i, row in work.rows:
        cells = ["alpha"] if work.scope.angular else ["a", "alpha"]
        if row.joint is not JointType.PRISMATIC and not work.scope.angular:
            cells.append("d")
        if row.joint is not JointType.REVOLUTE:
            cells.append("theta")
        for cell in cells:
            if work.only is not None and work.only.cell != cell:
                continue
            table = fitted_table(work, work.table, ((i, cell),), choice)
            if table is not None:
                value = getattr(table.rows[i], cell)
                code = f"{cell}_value" if cell in ANGLES else _story(work, i, cell, value)
                yield _set(code, i, cell, value)


def _story(work: Work, row: int, cell: str, value: float) -> str:
    """What happened to a length that stands there instead of `value`."""
    here = getattr(work.table.rows[row], cell)
    scale = work.reference.size * max(work.policy.tolerance.length, SAME)
    digits = max(share_of(work.comparison) * abs(value), work.comparison.steps.get((row, cell), 0.0))
    as_typed = min(scale, digits + SAME * work.reference.size)
    if abs(value) <= scale:
        return f"{cell}_not_zero"
    for power in (1000.0, 100.0, 10.0):
        for ratio in (power, 1.0 / power):
            if abs(abs(here) - abs(value) * ratio) <= 1e-6 * abs(here):
                return "cell_length_unit"
    if abs(here) <= as_typed:
        return f"{cell}_missing"
    if abs(value + here) <= as_typed:
        return f"{cell}_sign"
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
        abs(abs(value) - abs(known)) <= 1e-6 * abs(known)
        for known in work.comparison.draws[work.draw].values()
    )
