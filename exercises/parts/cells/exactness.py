"""How exactly an answer in names holds, for the decimals that stand in it."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import fields, is_dataclass, replace
from enum import Enum
from typing import Any

from kinematics.expressions import Expression, parameters_in
from kinematics.expressions.values import holds_decimals

EXACT = 1e-6  # A share and [rad]: what is asked of an answer without decimals at other lengths.
EITHER_WAY = 2.0  # What a length that is off may do to a pose: a turn carries it to the other side.
MOST_DECIMALS = 64
"""Decimals that are looked at one by one; an answer with more is held to the usual tolerance."""
MOST_READ_AGAIN = 16_000  # Characters that are read again with a decimal moved: a tenth of a second of work.
_DECIMAL = re.compile(r"(?<![\w.])[0-9]*\.([0-9]+)")
_NUMBER = re.compile(r"(?<![\w.])(?:[0-9]+(?:\.([0-9]+))?|\.([0-9]+))")
KNOWN = (*(math.sin(k * math.pi / 12) for k in (1, 3, 4, 5)), math.sqrt(2), math.sqrt(3))
"""What students round: sines and cosines, beside fractions of four, which are exact."""


def exactness(raw: Any, lengths_of: Callable[[Any], Sequence[float] | None]) -> float:
    """Return how far an answer may be off for its decimals: a share of its lengths, and [rad].

    Args:
        lengths_of: the lengths in an answer, at the values at which it is judged.
    """
    cells = list(typed_cells(raw))
    found = [
        (i, match, step)
        for i, cell in enumerate(cells)
        for match in _DECIMAL.finditer(cell)
        if (step := left_open(float(match[0]), len(match[1])))
    ]
    if len(found) > MOST_DECIMALS:
        return 1.0
    here = lengths_of(raw) if found else None
    effects = (_effect(raw, cells, i, match, step, here or (), lengths_of) for i, match, step in found)
    return max(EXACT, EITHER_WAY * sum(effects))


def _effect(
    raw: Any,
    cells: Sequence[str],
    i: int,
    match: re.Match[str],
    step: float,
    here: Sequence[float],
    lengths_of: Callable[[Any], Sequence[float] | None],
) -> float:
    """Return what a decimal does to the lengths, as a share of the longest, if it is off by a step."""
    cell = cells[i]
    if not has_letters(cell):
        return step
    other = f"{float(match[0]) + step:.12f}"
    there = lengths_of(_with_cell(raw, i, cell[: match.start()] + other + cell[match.end() :]))
    longest = max(map(abs, here), default=0.0)
    if there is None or len(there) != len(here) or not longest:
        return step
    return max(abs(one - two) for one, two in zip(here, there, strict=True)) / longest or step


def roundings(
    cells: Iterable[tuple[Any, Expression]],
    rates: Collection[str],
    read: Callable[[list[str]], Sequence[Expression] | None],
) -> dict[Expression, tuple[Expression, ...]]:
    """Return entries with each of their decimals in turn moved by what its rounding leaves open.

    Entries without decimals or without names are left out; all are where that is too much to read.

    Args:
        cells: of an answer, each as typed and what it means.
        rates: names that are no dimensions.
        read: returns what cells mean; None where one means nothing.
    """
    moved = {
        entry: moved_decimals(str(cell))
        for cell, entry in cells
        if holds_decimals(entry) and not parameters_in(entry) <= set(rates)
    }
    if sum(len(text) for texts in moved.values() for text in texts) > MOST_READ_AGAIN:
        return {}
    meant = ((entry, read(texts)) for entry, texts in moved.items())
    return {entry: tuple(found) for entry, found in meant if found is not None}


def moved_decimals(cell: str, *, measured: bool = False) -> list[str]:
    """Return a cell with each of its decimals in turn moved by what its rounding leaves open.

    Args:
        measured: its decimals are values of what is asked for, which may be rounded to a fraction of four.
    """
    step = _half_unit if measured else left_open
    found = ((match, step(float(match[0]), len(match[1]))) for match in _DECIMAL.finditer(cell))
    return [
        f"{cell[: match.start()]}{float(match[0]) + off:.12f}{cell[match.end() :]}"
        for match, off in found
        if off
    ]


def left_open(value: float, decimals: int) -> float:
    """Return by how much a decimal may be off: a fraction of four by nothing, others by their rounding."""
    half = _half_unit(value, decimals)
    if (4.0 * value).is_integer():
        return 0.0
    return min((off for known in KNOWN if (off := abs(value - known)) <= half), default=half)


def _half_unit(_: float, decimals: int) -> float:
    return 0.5 * 10.0**-decimals


def numbers_in(cell: str) -> Iterator[tuple[float, float]]:
    """Yield the numbers in a cell, each with half a unit of its last place."""
    for match in _NUMBER.finditer(cell):
        yield float(match[0]), 0.5 * 10.0 ** -len(match[1] or match[2] or "")


def has_letters(cell: str) -> bool:
    """Return whether a name or a function may stand in a cell."""
    return any(map(str.isalpha, cell))


def typed_cells(raw: Any) -> Iterator[str]:
    """Yield the cells of an answer as they were typed; what was chosen from a list is none."""
    if isinstance(raw, Enum):
        return
    if is_dataclass(raw):
        for entry in fields(raw):
            yield from typed_cells(getattr(raw, entry.name))
    elif isinstance(raw, list | tuple):
        for value in raw:
            yield from typed_cells(value)
    elif isinstance(raw, str | float):
        yield str(raw)


def _with_cell(raw: Any, number: int, text: str) -> Any:
    """Return an answer with something else in one of its cells, counted as `typed_cells` yields them."""
    left = iter(range(number + 1))

    def changed(value: Any) -> Any:
        if isinstance(value, Enum):
            return value
        if is_dataclass(value) and not isinstance(value, type):
            return replace(
                value, **{entry.name: changed(getattr(value, entry.name)) for entry in fields(value)}
            )
        if isinstance(value, list | tuple):
            return type(value)([changed(entry) for entry in value])
        if isinstance(value, str | float):
            return text if next(left, None) == number else value
        return value

    return changed(raw)
