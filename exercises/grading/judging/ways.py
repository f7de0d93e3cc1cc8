"""The ways in which an answer may be meant: in names, in numbers, in names here and numbers there."""

from collections.abc import Iterable, Iterator
from functools import lru_cache

from exercises.grading.judging.name_values import Values, values_of
from exercises.grading.judging.named_numbers import with_names
from kinematics.cells import ParameterKind, ReadTable
from kinematics.expressions import Number
from kinematics.table import LENGTHS, SymbolicTable

CACHED_ANSWERS = 32  # Answers at hand; asked for twice of every one.


@lru_cache(maxsize=CACHED_ANSWERS)
def ways_of(
    reference: ReadTable, submission: ReadTable, parameters: tuple[tuple[str, float], ...]
) -> tuple[tuple[ReadTable, frozenset[str]], ...]:
    """Return the tables that an answer may stand for, each with the parameters that are put in by value.

    Args:
        reference: the key.
        submission: the answer.
        parameters: the values that the exercise gives its parameters.

    Raises:
        ParameterError: a value is not a finite number or belongs to no parameter.
    """
    return tuple(_ways(reference, submission, values_of(reference, submission, dict(parameters), 1.0)))


def _ways(
    reference: ReadTable, submission: ReadTable, values: Values
) -> Iterator[tuple[ReadTable, frozenset[str]]]:
    """The answer, and the parameters that are put in by value.

    What is in names is decided by the names: values are put in only for names that the answer does not use,
    and only if it has numbers that may stand for them. Where a name and its value both stand in the answer,
    the value is taken for the name.
    """
    asked, used = set(reference.parameters), set(submission.parameters)
    unnamed = asked - used
    if used or not asked or not asked <= set(values.given):
        yield submission, frozenset()
    known = set(values.given)
    if unnamed and unnamed <= known and (not used or _has_numbers(submission.table, values, unnamed)):
        yield submission, frozenset(unnamed)
    if not asked and used and used <= known:
        yield submission, frozenset(used)
    if used:
        for named in with_names(submission, values):
            yield named, frozenset()


def _has_numbers(table: SymbolicTable, values: Values, names: Iterable[str]) -> bool:
    """Whether numbers stand where each of some names might: lengths for lengths, angles for angles."""
    lengths = any(
        isinstance(entry := getattr(row, cell), Number) and entry.value
        for row in table.rows
        for cell in LENGTHS
    )
    return lengths or all(values.kinds[name] is ParameterKind.ANGLE for name in names)
