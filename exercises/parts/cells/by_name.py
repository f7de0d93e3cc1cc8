"""Answers that name their lengths: they are right for other lengths, too, or the names are wrong.

An answer in names is a function of the dimensions. At the student's own values 2*L2 may be L1, so what is
right there is judged once more at others. An answer that holds lengths in numbers says nothing about other
values, and is left alone.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, fields, is_dataclass, replace
from enum import Enum
from fractions import Fraction
from functools import lru_cache
from types import MappingProxyType
from typing import Any, Generic, TypeVar

from exercises.instance import Instance
from exercises.parts.context import Context
from exercises.parts.joint_draws import key_numbers
from exercises.parts.protocol import Reading
from kinematics.cells import ParameterKind
from kinematics.equivalence import Tolerance
from kinematics.errors import ParameterError

Read = TypeVar("Read")

EXACT = 1e-6
"""A share and [rad]: what is asked of an answer without decimals at other lengths."""
UNITS = 3.0
"""Of the last place: what half a unit in each of several cells comes to."""
SAME = 1e-9
"""A share, and in the exercise's unit: what rounding leaves of lengths that have doubled."""
_DECIMALS = re.compile(r"\.([0-9]+)")


@dataclass(frozen=True, kw_only=True, eq=False)
class ByName(Generic[Read]):
    """An answer at the student's values, and at others if it names every length.

    Attributes:
        here: at the student's own values.
        other: at the values of `instance`; None of an answer in numbers.
        instance: the exercise with the other values.
    """

    here: Read
    other: Read | None = None
    instance: Instance | None = None

    def elsewhere(self, context: Context) -> tuple[Read, Context] | None:
        """The answer at other lengths and what it is judged by there; None of an answer in numbers."""
        if self.other is None or self.instance is None:
            return None
        return self.other, replace(context, instance=self.instance)


def read_by_name(
    raw: Any,
    reading: Reading,
    read: Callable[[Reading], Read | None],
    lengths: Callable[[Read], Sequence[float]],
) -> ByName[Read] | None:
    """Read an answer at the student's values and, if it names every length, at others.

    Args:
        raw: what was handed in; the decimals in it say how exactly it holds elsewhere.
        reading: the exercise with the student's values; its faults are those at these values.
        read: reads the answer at the values of a reading; None if there are faults.
        lengths: the lengths in an answer, which are twice as large with twice the dimensions.
    """
    here = read(reading)
    if here is None:
        return None
    if not any(map(str.isalpha, "".join(_cells(raw)))):  # what has no name in it is the same at any values
        return ByName(here=here)
    exact = exactness(raw)
    twice, other = (
        read(_at(reading, instance))
        for instance in (_twice(reading.instance), _other(reading.instance, exact))
    )
    if twice is None or other is None or not _key_holds(_other(reading.instance, exact)):
        return ByName(here=here)
    pairs = list(zip(lengths(here), lengths(twice), strict=True))
    named = any(pairs) and all(math.isclose(2.0 * one, two, rel_tol=SAME, abs_tol=SAME) for one, two in pairs)
    if not named or all(one == two for one, two in pairs):
        return ByName(here=here)
    return ByName(here=here, other=other, instance=_other(reading.instance, exact))


def exactness(raw: Any) -> float:
    """Return how far an answer may be off for its decimals: some units of the coarsest last place."""
    found = (len(match[1]) for cell in _cells(raw) for match in _DECIMALS.finditer(cell))
    return max(EXACT, UNITS * 10.0 ** -min(found, default=9))


def _cells(raw: Any) -> Iterator[str]:
    """Yield the cells of an answer as they were typed; what was chosen from a list is none."""
    if isinstance(raw, Enum):
        return
    if is_dataclass(raw):
        for entry in fields(raw):
            yield from _cells(getattr(raw, entry.name))
    elif isinstance(raw, list | tuple):
        for value in raw:
            yield from _cells(value)
    elif isinstance(raw, str | float):
        yield str(raw)


def _at(reading: Reading, instance: Instance) -> Reading:
    return replace(reading, instance=instance, faults=[])


@lru_cache(maxsize=512)
def _twice(instance: Instance) -> Instance:
    return _with_lengths(instance, lambda _: Fraction(2))


@lru_cache(maxsize=512)
def _other(instance: Instance, exact: float) -> Instance:
    """The exercise with every length changed by another share, and no more tolerance than decimals need."""
    exercise = instance.exercise
    usual = exercise.policy.tolerance
    tolerance = Tolerance(length=min(usual.length, exact), angle=min(usual.angle, exact))
    changed = _with_lengths(instance, lambda k: 1 + Fraction((-1) ** k * (3 + 2 * k), 41 + 2 * k))
    policy = replace(exercise.policy, tolerance=tolerance)
    return replace(changed, exercise=replace(exercise, policy=policy))


def _key_holds(instance: Instance) -> bool:
    """Whether every entry of the key has a value there."""
    try:
        key_numbers(instance)
    except ParameterError:
        return False
    return True


def _with_lengths(instance: Instance, factor: Callable[[int], Fraction]) -> Instance:
    kinds = instance.exercise.reference.parameters
    exact = {
        name: value * factor(k) if kinds.get(name) is ParameterKind.LENGTH else value
        for k, (name, value) in enumerate(sorted(instance.exact.items()))
    }
    return replace(instance, exact=MappingProxyType(exact))
