"""Functions of joint variables and parameters that an answer to one of the `check-…` calls holds."""

from collections.abc import Collection, Iterable, Sequence
from typing import Any

from exercises.parts.cells.exactness import roundings
from exercises.parts.cells.matrix_cells import read_functions
from kinematics.answers.left_open import Rounded
from kinematics.cells import ReadTable, nearest_name, parameters_in_radians, rate_in_marks
from kinematics.cells.meaning import CellMeaning
from kinematics.errors import CellError, Fault, JointValueError, ParamValue
from kinematics.expressions import Expression
from service.schemas.kinematics.robot_question import RobotQuestion
from service.wire.kinematics.prepared_robots import PreparedRobot, listed_robot

Where = tuple[str | int, ...]


def read_row(
    cells: Sequence[Any],
    expected: int,
    robot: ReadTable,
    known: Collection[str],
    where: Where,
    *,
    variables: bool = True,
) -> tuple[Expression, ...]:
    """Return what the cells of a row mean.

    Raises:
        JointValueError: it has more or fewer cells.
        CellError: a cell cannot be read, or holds a name without a value.
    """
    check_count(cells, expected, where)
    types = robot.table.joint_types if variables else ()
    read = [
        _with_rate_named(cell, entry, known, (*where, k))
        for k, (cell, entry) in enumerate(
            zip(cells, read_functions(cells, types, robot.angle_unit, where), strict=True)
        )
    ]
    return known_functions(read, known, [(*where, k) for k in range(len(cells))])


def roundings_of(
    typed: Iterable[Any],
    meant: Iterable[Expression],
    robot: ReadTable,
    known: Collection[str],
    rates: Collection[str],
) -> Rounded:
    """Return what entries with names are with each of their decimals moved by half of its last place."""

    def read_again(texts: list[str]) -> tuple[Expression, ...] | None:
        try:
            return read_row(texts, len(texts), robot, known, ())
        except CellError:  # longer by its digits, a cell may be too long
            return None

    return roundings(zip(typed, meant, strict=True), rates, read_again)


def known_functions(
    read: Sequence[CellMeaning | Fault], known: Collection[str], places: Sequence[Where]
) -> tuple[Expression, ...]:
    """Return what was read, if nothing is wrong with it and every name in it has a value.

    Raises:
        CellError: one cannot be read, or holds a name without a value.
    """
    faults = [entry for entry in read if isinstance(entry, Fault)]
    functions = tuple(entry for entry in read if not isinstance(entry, Fault))
    if not faults:
        faults = [
            _without_value(name, known, where)
            for where, entry in zip(places, functions, strict=True)
            for name in sorted(entry.kinds.keys() - set(known))
        ]
    if faults:
        raise CellError(faults)
    return tuple(entry.expression for entry in functions)


def _with_rate_named(
    cell: Any, entry: CellMeaning | Fault, known: Collection[str], where: Where
) -> CellMeaning | Fault:
    """What was read or, if it is wrong and the cell has a rate in marks of calculus, how that is written."""
    wrong = isinstance(entry, Fault) or entry.kinds.keys() - set(known)
    found = rate_in_marks(cell, known) if wrong and isinstance(cell, str) else None
    if found is None:
        return entry
    typed, name = found
    return Fault.at("rate_in_marks", *where, text=typed, suggestion=name)


def _without_value(name: str, known: Collection[str], where: Where) -> Fault:
    close = nearest_name(name, known)
    params: dict[str, ParamValue] = {
        "name": name,
        "found": int(close is not None),
        "close": close or "",
        "known": tuple(known) or "–",
    }
    return Fault.at("name_without_value", *where, **params)


def check_count(row: Sequence[Any], expected: int, where: Where) -> None:
    """Make sure that a row has as many entries as it must.

    Raises:
        JointValueError: it has not.
    """
    if len(row) != expected:
        raise JointValueError(Fault.at("joint_row_length", *where, expected=expected, given=len(row)))


def form_values(question: RobotQuestion, robot: PreparedRobot) -> dict[str, float]:
    """Return the value of each parameter of a request's robot [rad, or the table's length]."""
    values = dict(question.parameters)
    if question.robot is not None:
        values = {**listed_robot(question.robot).parameters, **values}
    return parameters_in_radians(values, robot.read.parameters, robot.read.angle_unit)
