"""Numbers, names and expressions in the place of parameters."""

from collections.abc import Mapping

from kinematics.cells.exact import absolute, inverse_trigonometric, raised, trigonometric
from kinematics.errors import Fault, ParameterError
from kinematics.expressions import (
    ZERO,
    Call,
    Expression,
    Function,
    Parameter,
    Power,
    Product,
    Sum,
    add,
    call,
    evaluate,
    multiply,
    parameters_in,
)
from kinematics.table import CELLS, DHRow, DHTable, SymbolicRow, SymbolicTable

_TRIGONOMETRIC = (Function.SIN, Function.COS, Function.TAN)
_INVERSE = (Function.ASIN, Function.ACOS, Function.ATAN, Function.ATAN2)


def substitute(expression: Expression, values: Mapping[str, Expression]) -> Expression:
    """Return the expression with some parameters replaced, and folded where that made it exact.

    Raises:
        ZeroDivisionError: it now divides by zero.
    """
    match expression:
        case Parameter(name):
            return values.get(name, expression)
        case Sum(terms):
            return add(substitute(term, values) for term in terms)
        case Product(factors):
            return multiply(substitute(factor, values) for factor in factors)
        case Power(base, exponent):
            return raised(substitute(base, values), exponent)
        case Call(function, arguments):
            return _called(function, [substitute(argument, values) for argument in arguments])
    return expression


def _called(function: Function, arguments: list[Expression]) -> Expression:
    if function in _TRIGONOMETRIC:
        return trigonometric(function, arguments[0])
    if function in _INVERSE:
        return inverse_trigonometric(function, *arguments)
    return absolute(arguments[0]) if function is Function.ABS else call(function, *arguments)


def with_values(table: SymbolicTable, values: Mapping[str, Expression]) -> SymbolicTable:
    """Return the table with some of its parameters replaced.

    Raises:
        ParameterError: a cell now has no value (1/0, the root of -1), at ("rows", i, cell).
    """
    if not values:
        return table
    faults: list[Fault] = []
    rows: list[SymbolicRow] = []
    for i, row in enumerate(table.rows):
        cells = {}
        for cell in CELLS:
            try:
                cells[cell] = valued(getattr(row, cell), values)
            except (ZeroDivisionError, ParameterError):
                cells[cell] = ZERO
                faults.append(Fault.at("value_undefined", "rows", i, cell))
        rows.append(DHRow(joint=row.joint, sign=row.sign, **cells))
    if faults:
        raise ParameterError(faults)
    return DHTable(convention=table.convention, rows=tuple(rows))


def valued(cell: Expression, values: Mapping[str, Expression]) -> Expression:
    """Return the cell with some of its parameters replaced, having made sure that it has a value.

    Raises:
        ZeroDivisionError: it now divides by zero.
        ParameterError: it has no parameters left, and no finite value.
    """
    replaced = substitute(cell, values)
    if not parameters_in(replaced):
        evaluate(replaced)
    return replaced
