"""The key and the answer with numbers in their cells: which parameter values they are compared at.

A table with parameters is compared at several random draws of them, so that nothing is right by the accident
of two dimensions being equal. Where the exercise gives its parameters values, an answer may be in numbers
instead, or in numbers here and names there.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from random import Random

from exercises.grading.substitution import substituted
from kinematics.cells import AngleUnit, ParameterKind, ReadTable, canonical_name, in_length_unit
from kinematics.errors import Fault, ParameterError
from kinematics.expressions import Number
from kinematics.table import NumericTable, SymbolicTable, bind

DRAWS = 3
ATTEMPTS = 40


@dataclass(frozen=True, kw_only=True, eq=False)
class Comparison:
    """Two tables and the parameter values at which they are compared; lengths in the submission's unit.

    Attributes:
        reference: the key, exact, with the values of those parameters that are not drawn.
        submission: the answer, likewise.
        draws: values of the parameters that are left [rad, or the submission's length unit]; one empty draw
            if none is.
        references: the key at each draw.
        submissions: the answer at each draw.
        in_names: some parameter is drawn.
    """

    reference: SymbolicTable
    submission: SymbolicTable
    draws: tuple[Mapping[str, float], ...]
    references: tuple[NumericTable, ...]
    submissions: tuple[NumericTable, ...]
    in_names: bool


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


def comparisons(
    reference: ReadTable, submission: ReadTable, parameters: Mapping[str, float] | None
) -> tuple[Comparison, ...]:
    """The ways in which an answer may be meant: in names, in numbers, in names here and numbers there.

    Args:
        reference: the key.
        submission: the answer.
        parameters: the values that the exercise gives its parameters [the key's units].

    Returns:
        At least one; the answer is right if it is right in one of them.

    Raises:
        ParameterError: a value is not a finite number or belongs to no parameter, or the tables have no
            finite value for any values of their parameters.
    """
    key = _in_unit_of(reference, submission)
    kinds = {**submission.parameters, **reference.parameters}
    values = Values(
        kinds=kinds,
        given=_given(reference, submission, parameters or {}, kinds),
        scale=_typical_length(key.table),
    )
    found = [
        comparison
        for fixed in _fixings(reference, submission, values)
        if (comparison := _comparison(key, submission, fixed, values)) is not None
    ]
    if not found:
        bind(key.table, {name: float(value) for name, value in values.given.items()})
        bind(submission.table, {name: float(value) for name, value in values.given.items()})
        raise ParameterError(
            Fault(
                code="tables_without_value",
            )
        )
    return tuple(found)


@lru_cache(maxsize=256)
def _converted(reference: ReadTable, unit: str) -> ReadTable:
    return in_length_unit(reference, type(reference.length_unit)(unit))


def _in_unit_of(reference: ReadTable, submission: ReadTable) -> ReadTable:
    if reference.length_unit is submission.length_unit:
        return reference
    return _converted(reference, submission.length_unit.value)


def _given(
    reference: ReadTable,
    submission: ReadTable,
    parameters: Mapping[str, float],
    kinds: Mapping[str, ParameterKind],
) -> dict[str, Fraction | float]:
    """The values by canonical name, in [rad] and the submission's length unit; lengths exact as typed."""
    ratio = reference.length_unit.metres_per_unit / submission.length_unit.metres_per_unit
    values: dict[str, Fraction | float] = {}
    faults: list[Fault] = []
    for spelled, value in parameters.items():
        name = canonical_name(spelled)
        found = _fault(spelled, name, value, kinds, values)
        if found is not None:
            faults.append(found)
        elif name is not None and kinds[name] is ParameterKind.LENGTH:
            values[name] = _typed(value) * ratio
        elif name is not None:
            values[name] = math.radians(value) if reference.angle_unit is AngleUnit.DEG else float(value)
    if faults:
        raise ParameterError(faults)
    return values


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
    params = {"name": spelled[:40], "other": name or ""}
    return Fault(code=code, where=("parameters", spelled), params=params)


def _fixings(reference: ReadTable, submission: ReadTable, values: Values) -> Iterator[frozenset[str]]:
    """Sets of parameters to be put in by value, the fewest first."""
    asked, used = set(reference.parameters), set(submission.parameters)
    known = set(values.given)
    if not asked | used:
        yield frozenset()
        return
    if used or not asked <= known:
        yield frozenset()
    unnamed = asked - used
    if unnamed and unnamed <= known:
        yield frozenset(unnamed)
    if unnamed != asked | used and asked | used <= known and _are_told_apart(values):
        yield frozenset(asked | used)


def _are_told_apart(values: Values) -> bool:
    """Whether no two given lengths are equal, so that a name used for another would show."""
    lengths = [
        abs(float(v)) for name, v in values.given.items() if values.kinds[name] is ParameterKind.LENGTH
    ]
    return all(
        not math.isclose(one, other, rel_tol=1e-6) for i, one in enumerate(lengths) for other in lengths[:i]
    )


def _comparison(
    reference: ReadTable, submission: ReadTable, fixed: frozenset[str], values: Values
) -> Comparison | None:
    try:
        key, answer = (_with_values(read, fixed, values) for read in (reference, submission))
    except ZeroDivisionError:
        return None
    names = sorted(set(values.kinds) - fixed)
    draws: list[Mapping[str, float]] = []
    keys: list[NumericTable] = []
    answers: list[NumericTable] = []
    for attempt in range(ATTEMPTS if names else 1):
        draw = {name: _drawn(name, attempt, values) for name in names}
        try:
            bound = _bound(key, tuple(draw.items())), bind(answer, draw)
        except ParameterError:
            continue
        draws.append(draw)
        keys.append(bound[0])
        answers.append(bound[1])
        if len(draws) == DRAWS:
            break
    if not draws:
        return None
    return Comparison(
        reference=key,
        submission=answer,
        draws=tuple(draws),
        references=tuple(keys),
        submissions=tuple(answers),
        in_names=bool(names),
    )


@lru_cache(maxsize=1024)
def _bound(key: SymbolicTable, draw: tuple[tuple[str, float], ...]) -> NumericTable:
    """The key at a draw; remembered, for one key is compared with many answers."""
    return bind(key, dict(draw))


def _drawn(name: str, attempt: int, values: Values) -> float:
    """A value for a parameter: the later the attempt, the nearer to the given one, so that roots exist."""
    given = float(values.given.get(name, 0.0))
    if given:
        return given * (1.0 + _deviation(name, attempt, 0.6 / (1.0 + attempt // 4)))
    middle = values.scale if values.kinds[name] is ParameterKind.LENGTH else 0.7
    return middle * (1.0 + _deviation(name, attempt, 0.6))


@lru_cache(maxsize=1024)
def _deviation(name: str, attempt: int, spread: float) -> float:
    random = Random(f"{name}/{attempt}")  # noqa: S311 - reproducible values, not secrets
    return random.uniform(-spread, spread)


def _with_values(read: ReadTable, names: frozenset[str], values: Values) -> SymbolicTable:
    """The table with some of its parameters replaced by their values."""
    known = tuple((name, Fraction(values.given[name])) for name in read.parameters if name in names)
    return _with_numbers(read.table, known) if known else read.table


@lru_cache(maxsize=1024)
def _with_numbers(table: SymbolicTable, known: tuple[tuple[str, Fraction], ...]) -> SymbolicTable:
    numbers = {name: Number(value) for name, value in known}
    return substituted(table, lambda name: numbers.get(name))


@lru_cache(maxsize=256)
def _typical_length(table: SymbolicTable) -> float:
    """Mean of the plain numbers that stand as lengths, or 1."""
    entries = [entry for row in table.rows for entry in (row.a, row.d)]
    lengths = [float(abs(entry.value)) for entry in entries if isinstance(entry, Number) and entry.value]
    return sum(lengths) / len(lengths) if lengths else 1.0
