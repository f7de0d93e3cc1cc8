"""Values of the names in two tables: those that an exercise gives, and random ones."""

import math
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, lru_cache
from random import Random

from kinematics.cells import AngleUnit, LengthUnit, ParameterKind, ReadTable, canonical_name, substitution
from kinematics.errors import Fault, ParameterError
from kinematics.expressions import Call, Number, Power, walk
from kinematics.table import CELLS, SymbolicTable

FREE_ATTEMPTS = 20  # Draws of a name that owe nothing to its given value.


@dataclass(frozen=True, kw_only=True, eq=False)
class Values:
    """What is known of the parameters.

    Attributes:
        kinds: length or angle, of every parameter of either table.
        given: the values that the exercise gives [rad, or the submission's length unit].
        scale: a length typical of the tables, to draw lengths by.
    """

    kinds: Mapping[str, ParameterKind]
    given: Mapping[str, Fraction | float]
    scale: float

    def lengths_of(self, names: Collection[str]) -> frozenset[Fraction]:
        """Return the lengths that the exercise gives to some names, without signs."""
        return frozenset(
            abs(Fraction(self.given[name])) for name in names if self.kinds[name] is ParameterKind.LENGTH
        )


def values_of(
    reference: ReadTable, submission: ReadTable, parameters: Mapping[str, float], scale: float
) -> Values:
    """Return what is known of the parameters of two tables; given lengths are exact as typed.

    Args:
        reference: the key.
        submission: the answer.
        parameters: the values that the exercise gives [the key's units].
        scale: a length typical of the tables.

    Raises:
        ParameterError: a value is not a finite number or belongs to no parameter.
    """
    kinds = {**submission.parameters, **reference.parameters}
    ratio = _ratio(reference.length_unit, submission.length_unit)
    values: dict[str, Fraction | float] = {}
    faults: list[Fault] = []
    for spelled, value in parameters.items():
        name = canonical_name(spelled)
        found = _fault(spelled, name, value, kinds, values)
        if found is not None:
            faults.append(found)
        elif name is not None and kinds[name] is ParameterKind.LENGTH:
            values[name] = _typed(value) if ratio == 1 else _typed(value) * ratio
        elif name is not None:
            values[name] = math.radians(value) if reference.angle_unit is AngleUnit.DEG else float(value)
    if faults:
        raise ParameterError(faults)
    return Values(kinds=kinds, given=values, scale=scale)


@cache
def _ratio(given: LengthUnit, wanted: LengthUnit) -> Fraction:
    return given.metres_per_unit / wanted.metres_per_unit


@lru_cache(maxsize=4096)
def _typed(value: float) -> Fraction:
    return Fraction(repr(value))


def _fault(
    spelled: str,
    name: str | None,
    value: object,
    kinds: Mapping[str, ParameterKind],
    values: Mapping[str, object],
) -> Fault | None:
    if name is None:
        code = "parameter_name_invalid"
    elif name not in kinds:
        code = "parameter_unused"
    elif name in values:
        code = "parameter_given_twice"
    elif isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        code = "parameter_not_finite"
    else:
        return None
    return Fault.at(code, "parameters", spelled, name=spelled[:40], other=name or "")


def drawn_value(name: str, attempt: int, values: Values) -> float:
    """Return a value for a parameter.

    At first it owes nothing to the given one, so that what is right in names is so whatever a student is
    given; after some attempts in vain it comes nearer and nearer to that, so that roots exist.
    """
    given = float(values.given.get(name, 0.0))
    if given and attempt >= FREE_ATTEMPTS:
        return given * (1.0 + _deviation(name, attempt, 0.6 / (1.0 + (attempt - FREE_ATTEMPTS) // 4)))
    middle = values.scale if values.kinds[name] is ParameterKind.LENGTH else 0.7
    return middle * (1.0 + _deviation(name, attempt, 0.6))


@lru_cache(maxsize=256)
def has_a_value_always(table: SymbolicTable) -> bool:
    """Whether a table has a value at every draw, which then owes nothing to given values: it has no root."""
    entries = (getattr(row, cell) for row in table.rows for cell in CELLS)
    return not any(isinstance(node, Power | Call) for entry in entries for node in walk(entry))


@lru_cache(maxsize=1024)
def _deviation(name: str, attempt: int, spread: float) -> float:
    random = Random(f"{name}/{attempt}")  # noqa: S311 - reproducible values, not secrets
    return random.uniform(-spread, spread)


def with_values(read: ReadTable, names: frozenset[str], values: Values) -> SymbolicTable:
    """Return the table with some of its parameters replaced by their values."""
    known = tuple((name, Fraction(values.given[name])) for name in read.parameters if name in names)
    return _with_numbers(read.table, known) if known else read.table


@lru_cache(maxsize=1024)
def _with_numbers(table: SymbolicTable, known: tuple[tuple[str, Fraction], ...]) -> SymbolicTable:
    return substitution.with_values(table, {name: Number(value) for name, value in known})


@lru_cache(maxsize=256)
def typical_length(table: SymbolicTable) -> float:
    """Return the mean of the plain numbers that stand as lengths, or 1."""
    entries = [entry for row in table.rows for entry in (row.a, row.d)]
    lengths = [float(abs(entry.value)) for entry in entries if isinstance(entry, Number) and entry.value]
    return sum(lengths) / len(lengths) if lengths else 1.0
