"""Parameters replaced, in an expression and in a table."""

from __future__ import annotations

from collections.abc import Callable

from kinematics.expressions import (
    Call,
    Expression,
    Parameter,
    Power,
    Product,
    Sum,
    add,
    call,
    multiply,
    power,
)
from kinematics.table import CELLS, DHRow, DHTable, SymbolicTable

Replacement = Callable[[str], Expression | None]


def replaced(expression: Expression, value: Replacement) -> Expression:
    """The expression with parameters replaced; `value` says by what, or None to leave one as it is."""
    match expression:
        case Parameter(name):
            found = value(name)
            return expression if found is None else found
        case Sum(terms):
            return add(replaced(term, value) for term in terms)
        case Product(factors):
            return multiply(replaced(factor, value) for factor in factors)
        case Power(base, exponent):
            return power(replaced(base, value), exponent)
        case Call(function, arguments):
            return call(function, *(replaced(argument, value) for argument in arguments))
    return expression


def substituted(table: SymbolicTable, value: Replacement) -> SymbolicTable:
    """The table with parameters replaced; `value` says by what, or None to leave one as it is."""
    rows = tuple(
        DHRow(
            joint=row.joint,
            sign=row.sign,
            **{cell: replaced(getattr(row, cell), value) for cell in CELLS},
        )
        for row in table.rows
    )
    return DHTable(convention=table.convention, rows=rows)
