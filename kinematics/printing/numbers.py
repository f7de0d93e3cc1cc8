"""How an exact number is written."""

from fractions import Fraction
from functools import lru_cache

_LARGEST_POWER_OF_TWO = 8
"""Denominators of cosines and averages: 1/2, 1/4, 1/8; a sixteenth is typed as a decimal."""
_MOST_PLACES = 9
"""So many decimal places are counted at a glance; a smaller number is written with a power of ten."""


@lru_cache(maxsize=4096)
def decimal_text(value: Fraction) -> str | None:
    """Return a rational number as the decimal that a person typed, or None if it is written as a fraction.

    0.4318, 0.1 and 6.1e-17 are decimals, as is whatever else has a 5 in its denominator; 1/2, 3/4 and 1/8 are
    fractions, as they come from cosines and averages; so are 1/3 and 5/7, which no decimal equals.
    """
    twos, fives, rest = _powers(value.denominator)
    if rest != 1 or (not fives and 2**twos <= _LARGEST_POWER_OF_TWO):
        return None
    return _written(value, max(twos, fives))


def fraction_as_decimal(value: Fraction) -> str | None:
    """Return a fraction as the decimal that it is beside other decimals, 1/2 as 0.5; None if it is none."""
    twos, fives, rest = _powers(value.denominator)
    return _written(value, max(twos, fives)) if rest == 1 and twos + fives else None


def _powers(denominator: int) -> tuple[int, int, int]:
    """The powers of 2 and 5 in a denominator, and the rest of it."""
    twos = fives = 0
    while denominator % 2 == 0:
        denominator //= 2
        twos += 1
    while denominator % 5 == 0:
        denominator //= 5
        fives += 1
    return twos, fives, denominator


def _written(value: Fraction, places: int) -> str:
    sign, digits = "-" if value < 0 else "", str(abs(value.numerator) * 10**places // value.denominator)
    if places - len(digits) >= _MOST_PLACES:
        return f"{sign}{digits[0]}{'.' * (len(digits) > 1)}{digits[1:]}e{len(digits) - places - 1}"
    digits = digits.zfill(places + 1)
    return f"{sign}{digits[:-places]}.{digits[-places:]}"
