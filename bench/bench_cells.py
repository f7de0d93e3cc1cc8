"""Reading the cells of a table beside SymPy's parsers."""

import warnings

from bench import Outcome, race

TITLE = "Reading cells"
ABOUT = """
`parse_expr` and `sympify` are what a kinematics program in Python usually reads expressions with; both run
code that stands in the text, so they are no choice for a service. Ours is a grammar with bounds, whose trees
are exact. A cell is read *anew* when nothing is remembered; a table that was read before is looked up.
"""

CELL = "-q1 + pi/2 - atan2(L1, L2)"
PUMA = [("pi/2", 0, 0, "q1"), (0, 0.4318, 0, "q2"), ("-pi/2", 0.0203, 0.15005, "q3"),
        ("pi/2", 0, 0.4318, "q4"), ("-pi/2", 0, 0, "q5"), (0, 0, 0, "q6")]  # fmt: skip


def rows() -> list[Outcome]:
    """Measure."""
    from sympy import sympify
    from sympy.parsing.sympy_parser import parse_expr

    from kinematics.cells import ParameterKind, RawRow, RawTable, read_cell, read_table
    from kinematics.cells.grammar import parse
    from kinematics.table import Convention

    def raw() -> RawTable:
        cells = [RawRow(alpha=alpha, a=a, d=d, theta=theta) for alpha, a, d, theta in PUMA]
        return RawTable(convention=Convention.STANDARD, rows=tuple(cells))

    def anew() -> object:
        parse.cache_clear()
        return read_cell(CELL, ParameterKind.ANGLE)

    def by_sympy() -> object:
        return [[parse_expr(str(cell)) for cell in row] for row in PUMA]

    warnings.simplefilter("ignore")
    known = raw()
    read_table(known)
    return [
        *race(
            f"`{CELL}`, anew",
            anew,
            {"SymPy `parse_expr`": lambda: parse_expr(CELL), "SymPy `sympify`": lambda: sympify(CELL)},
        ),
        *race("a PUMA 560 table that was read before, as new objects", lambda: read_table(raw()), {
            "SymPy `parse_expr`, 24 cells": by_sympy,
        }),
        *race("the same table object again", lambda: read_table(known), {
            "SymPy `parse_expr`, 24 cells": by_sympy,
        }),
    ]  # fmt: skip
