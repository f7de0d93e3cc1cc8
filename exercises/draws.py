"""From where a student's own values are drawn, and the draw itself.

A value follows from names (the exercise's id, the seed, the value's name) by a hash, so the same seed gives
the same values in every process, on every machine and in every later version.
"""

import hashlib
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import TypeVar

from exercises.reading import KeyShape, Reader

ALIKE = Fraction(1, 100)
"""Sizes that differ by no more than this share pass for each other in an answer in numbers."""
EQUAL = Fraction(0)
MOST_VALUES = 10_000  # Longest list of values that one draw chooses from: a finer step is a slip of the pen.

Value = TypeVar("Value")


@dataclass(frozen=True, kw_only=True)
class Draw:
    """Values from which a student's own one is drawn: start, start + step, …, not beyond stop.

    Attributes:
        start: the least value [unit of the exercise].
        stop: no value is greater.
        step: distance of neighbours.
        without: values that are left out.
    """

    start: Fraction
    stop: Fraction
    step: Fraction
    without: tuple[Fraction, ...] = ()

    @cached_property
    def values(self) -> tuple[Fraction, ...]:
        """The values, in ascending order; every student of an exercise chooses from them."""
        count = int((self.stop - self.start) / self.step)
        grid = (self.start + k * self.step for k in range(count + 1))
        return tuple(value for value in grid if value not in self.without)


@dataclass(frozen=True, kw_only=True, slots=True)
class Picker:
    """Draws a student's values for one exercise.

    Attributes:
        seed: names the student or the try; None for the values that everyone sees without a seed.
    """

    exercise_id: str
    seed: str | None

    def value(
        self, usual: Fraction, draw: Draw | None, name: str, without: Collection[Fraction] = ()
    ) -> Fraction:
        """Return the value of a name: the usual one without a seed or without anything to draw from.

        Args:
            usual: the value that everyone sees without a seed.
            draw: the values to choose from.
            without: sizes that it is kept apart from, as far as the draw has others.
        """
        if self.seed is None or draw is None:
            return usual
        value = pick(draw.values, self.exercise_id, self.seed, name)
        for share in (ALIKE, EQUAL) if without else ():
            if not is_alike(value, without, share):
                return value
            others = [other for other in draw.values if not is_alike(other, without, share)]
            if others:
                return pick(others, self.exercise_id, self.seed, name)
        return value

    def choice(self, values: Sequence[Value], name: str) -> Value:
        """Return one of the values: the first without a seed."""
        return values[0] if self.seed is None else pick(values, self.exercise_id, self.seed, name)


def is_alike(value: Fraction, others: Collection[Fraction], share: Fraction = ALIKE) -> bool:
    """Return whether a value is as large as one of some sizes, to within a share."""
    a, b = abs(value.numerator), value.denominator
    p, q = share.as_integer_ratio()
    products = ((a * d, c * b) for c, d in (other.as_integer_ratio() for other in others))
    return any(q * abs(one - two) <= p * max(one, two) for one, two in products)


def pick(values: Sequence[Value], *names: str) -> Value:
    """Return one of the values, the same one for the same names for ever."""
    digest = hashlib.blake2b("\x1f".join(names).encode(), digest_size=16).digest()
    return values[int.from_bytes(digest, "big") % len(values)]


def read_draw(reader: Reader, key: str, *, of_use: bool = True) -> Draw | None:
    """Return from where values are drawn; None if the key is missing. Faults go to the reader.

    Args:
        of_use: something is drawn from it, so authors are offered the key.
    """
    if of_use:
        reader.note(key, KeyShape.DRAW)
    if not reader.given(key):
        return None
    inner = reader.table(key)
    before = len(reader.faults)
    draw = Draw(
        start=inner.exact("from"),
        stop=inner.exact("to"),
        step=inner.exact("step"),
        without=inner.exacts("without", ()),
    )
    inner.finish()
    if len(reader.faults) > before:
        return None
    if draw.step <= 0 or draw.stop < draw.start:
        inner.fault("draw_empty")
        return None
    if (draw.stop - draw.start) / draw.step > MOST_VALUES:
        inner.fault("draw_too_large", limit=MOST_VALUES)
        return None
    if not draw.values:
        inner.fault("draw_empty")
        return None
    return draw
