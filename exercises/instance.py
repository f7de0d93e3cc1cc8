"""`generate`: an exercise with one student's values."""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache
from itertools import product
from math import prod
from types import MappingProxyType
from typing import Any

from exercises.definition import DrawnParameter, Exercise
from exercises.draws import Picker, pick
from exercises.errors import AnswerError
from exercises.parts.registry import part_type
from kinematics.cells import LengthUnit, ParameterKind, parameters_in_radians
from kinematics.errors import Fault

SEED_CHARACTERS = 200  # Characters of a seed: a name, a mail address or a digest.
CACHED_INSTANCES = 2048
"""Instances in the cache, some kilobytes each: a large class opens an exercise, and hands in later."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Instance:
    """An exercise with one student's values.

    Attributes:
        seed: from what the values were drawn, of an exercise with variants the variant's; None for the values
            that everyone sees without a seed.
        exact: value of every dimension [the exercise's unit].
        drawn: what a part draws beside the dimensions, by the part's kind.
    """

    exercise: Exercise
    seed: str | None
    exact: Mapping[str, Fraction]
    drawn: Mapping[str, Any]

    @property
    def parameters(self) -> dict[str, float]:
        """Value of every dimension [the exercise's unit]."""
        return {name: float(value) for name, value in self.exact.items()}

    @property
    def values(self) -> dict[str, float]:
        """The same as the kinematics takes it: angles in [rad]."""
        exercise = self.exercise
        return parameters_in_radians(self.parameters, exercise.reference.parameters, exercise.angle_unit)

    def values_in(self, unit: LengthUnit) -> dict[str, float]:
        """Return the value of every dimension in a length unit (an angle in the exercise's unit)."""
        ratio = float(self.exercise.length_unit.metres_per_unit / unit.metres_per_unit)
        kinds = self.exercise.reference.parameters
        return {
            name: value * (ratio if kinds[name] is ParameterKind.LENGTH else 1.0)
            for name, value in self.parameters.items()
        }


def cached_instance(exercise: Exercise, seed: str | None) -> Instance:
    """Return what `generate` returns, one object for all who ask for the same.

    What follows from it is shared.

    Raises:
        AnswerError: the seed is longer than 200 characters.
    """
    return _cached_by_text(exercise, variant_of(exercise.id, seed_text(seed), exercise.access.variants))


def generate(exercise: Exercise, seed: str | int | None = None) -> Instance:
    """Return the exercise with the values of a seed.

    Args:
        seed: names a student or a try: text or a whole number; 7 and "7" are the same seed. None: the usual
            values.

    Raises:
        AnswerError: the seed is longer than 200 characters.
    """
    text = variant_of(exercise.id, seed_text(seed), exercise.access.variants)
    picker = Picker(exercise_id=exercise.id, seed=text)
    exact = _values_kept_apart(exercise.parameters, picker)
    drawn = {part.kind: part_type(part.kind).draw(part, exercise, picker) for part in exercise.parts}
    return Instance(
        exercise=exercise, seed=text, exact=MappingProxyType(exact), drawn=MappingProxyType(drawn)
    )


def _values_kept_apart(parameters: Sequence[DrawnParameter], picker: Picker) -> dict[str, Fraction]:
    """Return the value of every dimension: each drawn one of another size, where its draw has a choice.

    Two lengths of about one size could be exchanged by mistake without a difference.
    """
    exact: dict[str, Fraction] = {}
    taken = [abs(parameter.value) for parameter in parameters if parameter.draw is None]
    for parameter in parameters:
        value = picker.value(parameter.value, parameter.draw, parameter.name, without=taken)
        exact[parameter.name] = value
        taken.append(abs(value))
    return exact


def possible_instances(exercise: Exercise, fixed: Collection[str], most: int) -> Iterator[Instance]:
    """Yield the exercise with every set of values that a student may have.

    Names in `fixed` keep their usual values. What parts draw beside the dimensions is as without a seed.

    Args:
        fixed: names of dimensions whose values make no difference.
        most: nothing is returned where there are more sets of values.
    """
    choices = [
        (parameter.value,) if parameter.draw is None or parameter.name in fixed else parameter.draw.values
        for parameter in exercise.parameters
    ]
    if prod(map(len, choices)) > most:
        return
    names, usual = [parameter.name for parameter in exercise.parameters], generate(exercise)
    for exact in product(*choices):
        yield replace(usual, exact=MappingProxyType(dict(zip(names, exact, strict=True))))


@lru_cache(maxsize=CACHED_INSTANCES)
def _cached_by_text(exercise: Exercise, text: str | None) -> Instance:
    return generate(exercise, text)


def variant_of(exercise_id: str, seed: str | None, variants: int | None) -> str | None:
    """Return the seed of the variant (variant-1, variant-2 and so on) that a seed falls to.

    A variant falls to itself, and without a seed there is none. Each variant falls to about as many seeds.

    Args:
        exercise_id: of the exercise: who has variant 3 of one exercise has another one of the next.
        seed: names a student or a try.
        variants: how many variants there are; None: every seed has values of its own.
    """
    if variants is None or seed is None or seed in variant_seeds(variants):
        return seed
    return pick(variant_seeds(variants), exercise_id, seed, "variant")


@lru_cache(maxsize=64)
def variant_seeds(variants: int) -> tuple[str, ...]:
    """Return the seeds of so many variants."""
    return tuple(f"variant-{number}" for number in range(1, variants + 1))


def seed_text(seed: str | int | None) -> str | None:
    """Return a seed as text.

    Raises:
        AnswerError: it is longer than 200 characters.
    """
    text = None if seed is None else str(seed)
    if text is not None and len(text) > SEED_CHARACTERS:
        raise AnswerError(Fault.at("seed_too_long", "seed", limit=SEED_CHARACTERS))
    return text
