"""Tables and given values as exact expressions: what closed forms start from."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any, Protocol

from kinematics.cells import AngleUnit, ParameterKind, ReadTable, canonical_name, parameter_values, read_table
from kinematics.cells.exact import snapped
from kinematics.expressions import Expression, pi_times
from kinematics.symbolic.exact_poses import decimal
from service.http.problems import located
from service.schemas.robot_question import RobotQuestion
from service.settings import Settings
from service.wire.prepared_robots import listed_robot


def read_symbolic(question: RobotQuestion, settings: Settings) -> ReadTable:
    """The table of a question, cells as expressions.

    Raises:
        KinematicsError: the table cannot be read.
    """
    if question.table is None:
        return listed_robot(str(question.robot)).table
    with located("table"):
        return read_table(question.table.raw(), settings.cell_limits)


class NamedValues(Protocol):
    """What has parameters: a table, a chain, products of motions."""

    @property
    def parameters(self) -> Mapping[str, ParameterKind]:
        """The parameters, and what each measures."""

    @property
    def angle_unit(self) -> AngleUnit:
        """Unit of the angles among given values."""


def exact_values(read: NamedValues, given: Mapping[str, Any]) -> dict[str, Expression]:
    """Given values as exact expressions: decimals as typed, degrees as multiples of π.

    Raises:
        ParameterError: a value is not a finite number, or of a parameter that the robot does not have.
    """
    names = {name: canonical_name(name) for name in given}
    wanted = {name: kind for name, kind in read.parameters.items() if name in names.values()}
    parameter_values(wanted, read.angle_unit, given)
    values: dict[str, Expression] = {}
    for spelling, name in names.items():
        assert name is not None
        number = decimal(given[spelling])
        if wanted[name] is ParameterKind.LENGTH:
            values[name] = number
        elif read.angle_unit is AngleUnit.DEG:
            values[name] = pi_times(number.value / 180)
        else:
            values[name] = snapped(Fraction(number.value))
    return values
