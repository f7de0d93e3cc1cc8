"""How large a cell and a table may be."""

import math
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache

RESULT_BITS = 1280
"""No exact number that comes out of a cell has a numerator or denominator of more bits.

The smallest double with the 17 digits that programs print is a fraction over 10^340: 1130 bits.
"""


@dataclass(frozen=True, kw_only=True, slots=True)
class Limits:
    """Bounds on what is read. Every refusal names the bound that was passed.

    Attributes:
        cell_characters: length of a cell's text.
        cell_depth: nesting of parentheses, functions, powers and signs in a cell.
        cell_symbols: different names in a cell.
        table_characters: length of all cells of a table together; it bounds the time that reading takes.
        table_parameters: different parameters in a table.
        exponent: absolute value of an exponent, and its denominator.
        digits: digits of one number.
        smallest: smallest absolute value of a number that is not zero; programs write all doubles. What
            rounds to it is admitted: they write the least one as 5e-324, 4.9E-324 or 4.9406564584124654e-324.
        largest: largest absolute value of a number.
    """

    cell_characters: int = 200
    cell_depth: int = 32
    cell_symbols: int = 16
    table_characters: int = 8192
    table_parameters: int = 64
    rows: int = 64
    exponent: int = 16
    digits: int = 32
    smallest: float = 5e-324
    largest: float = 1e15

    def admits(self, value: Fraction) -> bool:
        """Return whether a number is of a size that is read."""
        numerator, denominator = abs(value.numerator), value.denominator
        if not numerator or (denominator == 1 and numerator < self.largest and self.smallest < 1.0):
            return True
        smallest, largest = _exact_range(self.smallest, self.largest)
        return (
            smallest.numerator * denominator <= numerator * smallest.denominator
            and numerator * largest.denominator <= largest.numerator * denominator
        )


@lru_cache(maxsize=64)
def _exact_range(smallest: float, largest: float) -> tuple[Fraction, Fraction]:
    # 1e15 is meant, not the double nearest to it
    return (Fraction(math.nextafter(smallest, 0.0)) + Fraction(smallest)) / 2, Fraction(repr(largest))


DEFAULT = Limits()
