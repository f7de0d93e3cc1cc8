"""Answers that name their lengths: they are right for other lengths, too, or the names are wrong.

An answer in names is a function of the dimensions. At the student's own values 2*L2 may be L1, so what is
right there is judged once more at others. Where a name and a number stand in one cell (a2 + 0.1), only names
that are used change, and none for whose value a number may stand. An answer with a length that is a number
alone says nothing of other values, and is left alone.
"""

import math
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache
from types import MappingProxyType
from typing import Generic, TypeVar

from exercises.instance import Instance
from exercises.parts.cells.exactness import exactness, has_letters, numbers_in, typed_cells
from exercises.parts.context import Context
from exercises.parts.joint_draws import key_numbers
from exercises.parts.protocol import Reading
from kinematics.cells import ParameterKind
from kinematics.equivalence import Tolerance
from kinematics.errors import ParameterError

Raw = TypeVar("Raw")
Read = TypeVar("Read")

SAME = 1e-9  # How far apart lengths may be, as a share, that rounding alone parts.


@dataclass(frozen=True, kw_only=True, eq=False)
class ByName(Generic[Read]):
    """An answer at the student's values, and at others if it names its lengths.

    Attributes:
        here: at the student's own values.
        other: at the values of `instance`; None of an answer in numbers.
        instance: the exercise with the other values.
    """

    here: Read
    other: Read | None = None
    instance: Instance | None = None

    def elsewhere(self, context: Context) -> tuple[Read, Context] | None:
        """Return the answer at other lengths and what it is judged by there; None of an answer in numbers."""
        if self.other is None or self.instance is None:
            return None
        return self.other, replace(context, instance=self.instance)


def read_by_name(
    raw: Raw,
    reading: Reading,
    read: Callable[[Raw, Reading], Read | None],
    lengths: Callable[[Read], Sequence[float]],
) -> ByName[Read] | None:
    """Read an answer at the student's values and, if it names its lengths, at others.

    Args:
        raw: what was handed in; the decimals in it say how exactly it holds elsewhere.
        reading: the exercise with the student's values; its faults are those at these values.
        read: reads an answer at the values of a reading; None if there are faults.
        lengths: the lengths in an answer, which are twice as large with twice the dimensions.
    """
    here = read(raw, reading)
    if here is None:
        return None
    if not any(map(has_letters, typed_cells(raw))):  # what has no name in it is the same at any values
        return ByName(here=here)

    def lengths_at(instance: Instance, cells: Raw) -> Sequence[float] | None:
        found = read(cells, _at(reading, instance))
        return None if found is None else lengths(found)

    names = _varied(raw, reading.instance, lengths(here), lengths_at)
    if not names:
        return ByName(here=here)
    varied = _other(reading.instance, names)
    other = read(raw, _at(reading, varied)) if _key_holds(varied) else None
    if other is None:
        return ByName(here=here)
    exact = exactness(raw, lambda cells: lengths_at(varied, cells))
    return ByName(here=here, other=other, instance=_held_to(varied, exact))


def _varied(
    raw: Raw,
    instance: Instance,
    here: Sequence[float],
    lengths_at: Callable[[Instance, Raw], Sequence[float] | None],
) -> frozenset[str]:
    """Return the names whose values may be others; none if a length is a number alone."""
    names = _lengths_of(instance)
    twice = lengths_at(_twice(instance, names), raw)
    if not here or not twice:
        return frozenset()
    pairs = list(zip(here, twice, strict=True))
    if any(_same(one, two) and abs(one) > SAME for one, two in pairs) or not any(here):
        return frozenset()
    if all(_same(2.0 * one, two) for one, two in pairs):
        return names
    numbers = [number for cell in typed_cells(raw) if has_letters(cell) for number in numbers_in(cell)]
    used: set[str] = set()
    for name in names:
        value = abs(float(instance.exact[name]))
        there = lengths_at(_twice(instance, frozenset((name,))), raw)
        changes = there is not None and not all(map(_same, here, there))
        if changes and not any(abs(number - value) <= half for number, half in numbers):
            used.add(name)
    return frozenset(used)


def _same(one: float, other: float) -> bool:
    return math.isclose(one, other, rel_tol=SAME, abs_tol=SAME)


def _lengths_of(instance: Instance) -> frozenset[str]:
    kinds = instance.exercise.reference.parameters
    return frozenset(name for name in instance.exact if kinds.get(name) is ParameterKind.LENGTH)


def _at(reading: Reading, instance: Instance) -> Reading:
    return replace(reading, instance=instance, faults=[])


@lru_cache(maxsize=512)
def _twice(instance: Instance, names: frozenset[str]) -> Instance:
    return _with_lengths(instance, names, lambda _: Fraction(2))


@lru_cache(maxsize=512)
def _other(instance: Instance, names: frozenset[str]) -> Instance:
    """The exercise with each of some lengths changed by another share."""
    return _with_lengths(instance, names, lambda k: 1 + Fraction((-1) ** k * (3 + 2 * k), 41 + 2 * k))


def _key_holds(instance: Instance) -> bool:
    """Whether every entry of the key has a value there."""
    try:
        key_numbers(instance)
    except ParameterError:
        return False
    return True


@lru_cache(maxsize=512)
def _held_to(instance: Instance, exact: float) -> Instance:
    """The exercise with no more tolerance than decimals need."""
    exercise = instance.exercise
    usual = exercise.policy.tolerance
    tolerance = Tolerance(length=min(usual.length, exact), angle=min(usual.angle, exact))
    return replace(instance, exercise=replace(exercise, policy=replace(exercise.policy, tolerance=tolerance)))


def _with_lengths(instance: Instance, names: Collection[str], factor: Callable[[int], Fraction]) -> Instance:
    exact = {
        name: value * factor(k) if name in names else value
        for k, (name, value) in enumerate(sorted(instance.exact.items()))
    }
    return replace(instance, exact=MappingProxyType(exact))
