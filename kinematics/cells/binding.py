"""From a read table to numbers, and from one length unit to another."""

import math
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from kinematics.caching import USUAL_TABLE, cached_by_size
from kinematics.cells.scaling import scaled_cell
from kinematics.cells.scanner import canonical_name
from kinematics.cells.tables import ReadTable
from kinematics.cells.units import AngleUnit, LengthUnit, ParameterKind
from kinematics.errors import Fault, ParameterError
from kinematics.table import DHRow, DHTable, NumericTable, SymbolicRow, bind


def bind_parameters(read: ReadTable, parameters: Mapping[str, float]) -> NumericTable:
    """Return the table with a number in every cell: angles in [rad], lengths in the table's unit.

    Args:
        parameters: the value of each of its parameters, in the table's own units (an angle parameter of a
            table in degrees in degrees); names may be spelled as in a cell, L_1 is L1.

    Raises:
        ParameterError: a parameter is missing, given twice, unknown to the table or not a finite number, at
            ("parameters", name as given); or a cell has no finite value, at ("rows", i, cell).
    """
    if not parameters and not read.parameters:
        return _bound(read, ())
    return _bound(read, tuple(parameter_values(read.parameters, read.angle_unit, parameters).items()))


def parameter_values(
    kinds: Mapping[str, ParameterKind], angle_unit: AngleUnit, parameters: Mapping[str, float]
) -> dict[str, float]:
    """Return the value of each parameter by its canonical name, angles in [rad], in the order of `kinds`.

    Args:
        kinds: the parameters that are needed, and what each measures.
        angle_unit: unit of the angles among the given values.
        parameters: the given values; names may be spelled as in a cell.

    Raises:
        ParameterError: a parameter is missing, given twice, not needed or not a finite number; all faults,
            each at ("parameters", name as given).
    """
    values: dict[str, float] = {}
    spelled: dict[str, str] = {}
    faults: list[Fault] = []
    for given, value in parameters.items():
        name = canonical_name(given)
        found = _fault(kinds, given, name, value, spelled)
        if found:
            faults.append(found)
        if name is not None and name not in spelled:
            spelled[name] = given
            values[name] = value
    faults.extend(
        Fault.at("parameter_missing", "parameters", name, name=name) for name in kinds if name not in spelled
    )
    if faults:
        raise ParameterError(faults)
    return parameters_in_radians({name: float(values[name]) for name in kinds}, kinds, angle_unit)


def parameters_in_radians(
    values: Mapping[str, float], kinds: Mapping[str, ParameterKind], angle_unit: AngleUnit
) -> dict[str, float]:
    """Return values of parameters as the kinematics takes them: angles in [rad], lengths as they are."""
    return {
        name: angle_unit.in_radians(value) if kinds.get(name) is ParameterKind.ANGLE else value
        for name, value in values.items()
    }


def in_length_unit(read: ReadTable, unit: LengthUnit) -> ReadTable:
    """Return the same mechanism with its lengths, and its length parameters, in another unit; exact.

    With s old units in a new one and length parameters p, a cell that gives a length becomes c(p·s)/s and a
    cell that gives an angle c(p·s).
    """
    ratio = unit.metres_per_unit / read.length_unit.metres_per_unit
    if ratio == 1:
        return read
    table = DHTable(
        convention=read.table.convention,
        rows=tuple(_scaled_row(row, read.parameters, ratio) for row in read.table.rows),
    )
    return replace(read, table=table, length_unit=unit, last_places={})


def _scaled_row(row: SymbolicRow, kinds: Mapping[str, ParameterKind], ratio: Fraction) -> SymbolicRow:
    return DHRow(
        joint=row.joint,
        sign=row.sign,
        theta=scaled_cell(row.theta, ParameterKind.ANGLE, kinds, ratio),
        alpha=scaled_cell(row.alpha, ParameterKind.ANGLE, kinds, ratio),
        d=scaled_cell(row.d, ParameterKind.LENGTH, kinds, ratio),
        a=scaled_cell(row.a, ParameterKind.LENGTH, kinds, ratio),
    )


@cached_by_size(lambda read, values: read.length, longest=USUAL_TABLE, most=1024, few=16)
def _bound(read: ReadTable, values: tuple[tuple[str, float], ...]) -> NumericTable:
    return bind(read.table, dict(values))


def _fault(
    kinds: Mapping[str, ParameterKind],
    given: str,
    name: str | None,
    value: object,
    spelled: Mapping[str, str],
) -> Fault | None:
    if name is None:
        return Fault.at("parameter_name_invalid", "parameters", given, name=given[:40])
    if name not in kinds:
        return Fault.at("parameter_unused", "parameters", given, name=given)
    if name in spelled:
        return Fault.at("parameter_given_twice", "parameters", given, name=given, other=spelled[name])
    if not _is_finite(value):
        return Fault.at("parameter_not_finite", "parameters", given, name=given)
    return None


def _is_finite(value: object) -> bool:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    try:
        return math.isfinite(value)
    except OverflowError:  # an integer beyond every double
        return False
