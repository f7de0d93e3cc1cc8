"""How large a cell and a table may be."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True, slots=True)
class Limits:
    """Bounds on what is read. Every refusal names the bound that was passed.

    Attributes:
        cell_characters: length of a cell's text.
        cell_depth: nesting of parentheses, functions, powers and signs in a cell.
        cell_symbols: different names in a cell.
        table_parameters: different parameters in a table.
        rows: rows of a table.
        exponent: absolute value of an exponent, and its denominator.
        digits: digits of one number.
        smallest: smallest absolute value of a number that is not zero.
        largest: largest absolute value of a number.
    """

    cell_characters: int = 200
    cell_depth: int = 32
    cell_symbols: int = 16
    table_parameters: int = 64
    rows: int = 64
    exponent: int = 16
    digits: int = 32
    smallest: float = 1e-30
    largest: float = 1e15


DEFAULT = Limits()
