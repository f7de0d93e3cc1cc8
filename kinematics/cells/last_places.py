"""How exactly a decimal was typed, where its value does not show it: 0.2100."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from decimal import Decimal

from kinematics.cells.tables import RawRow
from kinematics.expressions import ZERO, evaluate, parameters_in
from kinematics.table import CELLS, SymbolicRow

_ONE_NUMBER = re.compile(r"[\s()+=−–-]*((?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)[\s()°]*")
_LARGEST_EXPONENT = 100
Place = tuple[int, str]


def last_places(raw: Sequence[RawRow], rows: Sequence[SymbolicRow]) -> Iterator[tuple[Place, float]]:
    """Yield units of the last place [rad or length] of cells that are one number with zeros at its end."""
    for i, (typed, row) in enumerate(zip(raw, rows, strict=True)):
        for cell in CELLS:
            text = getattr(typed, cell)
            if not isinstance(text, str) or "0" not in text:
                continue
            entry = getattr(row, cell)
            if entry == ZERO or parameters_in(entry):
                continue
            match = _ONE_NUMBER.fullmatch(text)
            if match is None or not match[1].endswith("0"):
                continue
            number = Decimal(match[1])
            exponent = number.as_tuple().exponent
            if number and abs(number.adjusted()) < _LARGEST_EXPONENT and isinstance(exponent, int):
                yield (i, cell), abs(evaluate(entry)) / float(number) * 10.0**exponent
