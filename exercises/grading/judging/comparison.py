"""The key and the answer with numbers in their cells: which parameter values they are compared at.

A table with parameters is compared at several random draws of them, so that nothing is right by the accident
of two dimensions being equal. Where the exercise gives its parameters values, an answer may be in numbers
instead, or in numbers here and names there.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

from exercises.grading.judging.name_values import (
    Values,
    drawn_value,
    has_a_value_always,
    typical_length,
    values_of,
    with_values,
)
from exercises.grading.judging.named_numbers import with_names
from exercises.grading.judging.typed import ANGLES, Place, Typed, meant
from kinematics.cells import AngleUnit, ParameterKind, ReadTable, in_length_unit
from kinematics.errors import Fault, ParameterError
from kinematics.expressions import ZERO, Expression, Number, parameters_in
from kinematics.remembering import USUAL_ROWS, remembered
from kinematics.table import CELLS, DHTable, NumericTable, SymbolicTable, bind

# Two unequal sums of names agree at a random draw with probability zero; three leave room for signs.
DRAWS = 3
# Tables with roots may have values at few draws.
ATTEMPTS = 60


WAYS_REMEMBERED = 32
"""Answers at hand, with the ways in which each may be meant."""
LARGEST_ENTRY = 1e70
"""Volumes and fourth powers of lengths are computed, and sums of them over all rows: doubles end at 1e308."""


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
        meant_table: the answer with rounded entries replaced by what they stand for, exact.
        meant: that at each draw; `submissions` itself where nothing was rounded.
        steps: half a unit of the last place of decimals that stand for themselves, by row and cell.
        by_value: no name stands in the answer.
        exact: the answer is in names, and nothing in it or in the key is known only to some digits, but for
            lengths by which it moves frames to and fro.
    """

    reference: SymbolicTable
    submission: SymbolicTable
    draws: tuple[Mapping[str, float], ...]
    references: tuple[NumericTable, ...]
    submissions: tuple[NumericTable, ...]
    in_names: bool
    meant_table: SymbolicTable
    meant: tuple[NumericTable, ...]
    steps: Mapping[Place, float]
    exact: bool
    by_value: bool

    @cached_property
    def named_entries(self) -> tuple[tuple[Place, Expression, frozenset[str]], ...]:
        """The entries of the answer as it was meant with names in them: where, what, and which names."""
        return tuple(
            ((i, cell), entry, names)
            for i, row in enumerate(self.meant_table.rows)
            for cell in CELLS
            if (names := parameters_in(entry := getattr(row, cell)))
        )

    def with_first(self, draw: int) -> Comparison:
        """Return the same, with a draw (its number, from 0) moved to the front."""
        if not draw:
            return self
        order = (draw, *(k for k in range(len(self.draws)) if k != draw))
        references, submissions, meant = (
            tuple(tables[k] for k in order) for tables in (self.references, self.submissions, self.meant)
        )
        return replace(
            self,
            draws=tuple(self.draws[k] for k in order),
            references=references,
            submissions=submissions,
            meant=submissions if self.meant is self.submissions else meant,
        )


def comparisons(
    reference: ReadTable, submission: ReadTable, parameters: Mapping[str, float] | None
) -> tuple[Comparison, ...]:
    """Return the ways in which an answer may be meant: in names, in numbers, in names here and numbers there.

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
    values = values_of(reference, submission, parameters or {}, typical_length(key.table))
    found = [
        comparison
        for answer, fixed in _ways_of(reference, submission, tuple((parameters or {}).items()))
        if (comparison := _comparison(key, answer, fixed, values)) is not None
    ]
    if not found:
        given = {name: float(value) for name, value in values.given.items()}
        _within_bounds(bind(key.table, given))
        _within_bounds(bind(submission.table, given))
        raise ParameterError(Fault(code="tables_without_value"))
    return tuple(found)


def compared_by_names(reference: ReadTable, submission: ReadTable, parameters: Mapping[str, float]) -> bool:
    """Whether the values of the parameters make no difference: no number of the answer may stand for a name.

    Args and raises as in `comparisons`.
    """
    values_of(reference, submission, parameters, 1.0)
    ways = _ways_of(reference, submission, tuple(parameters.items()))
    always = has_a_value_always(reference.table) and has_a_value_always(submission.table)
    return always and ways == ((submission, frozenset()),)


@lru_cache(maxsize=256)
def _converted(reference: ReadTable, unit: str) -> ReadTable:
    return in_length_unit(reference, type(reference.length_unit)(unit))


def _in_unit_of(reference: ReadTable, submission: ReadTable) -> ReadTable:
    if reference.length_unit is submission.length_unit:
        return reference
    return _converted(reference, submission.length_unit.value)


@lru_cache(maxsize=WAYS_REMEMBERED)
def _ways_of(
    reference: ReadTable, submission: ReadTable, parameters: tuple[tuple[str, float], ...]
) -> tuple[tuple[ReadTable, frozenset[str]], ...]:
    """The ways of `_ways` with values that are known to be numbers; asked for twice of every answer."""
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
        for cell in ("a", "d")
    )
    return lengths or all(values.kinds[name] is ParameterKind.ANGLE for name in names)


def _comparison(
    reference: ReadTable, submission: ReadTable, fixed: frozenset[str], values: Values
) -> Comparison | None:
    try:
        key, answer = (with_values(read, fixed, values) for read in (reference, submission))
    except ZeroDivisionError:
        return None
    names = sorted(set(values.kinds) - fixed)
    typed = _meant(key, answer, submission, values, in_names=bool(names))
    draws: list[Mapping[str, float]] = []
    keys: list[NumericTable] = []
    answers: list[NumericTable] = []
    meanings: list[NumericTable] = []
    for attempt in range(ATTEMPTS if names else 1):
        draw = {name: drawn_value(name, attempt, values) for name in names}
        try:
            bound = _bound(key, tuple(draw.items())), _within_bounds(bind(answer, draw))
            meanings.append(bound[1] if typed.table is answer else _within_bounds(bind(typed.table, draw)))
        except ParameterError:
            continue
        draws.append(draw)
        keys.append(bound[0])
        answers.append(bound[1])
        if len(draws) == DRAWS:
            break
    if not draws:
        return None
    submissions = tuple(answers)
    return Comparison(
        reference=key,
        submission=answer,
        draws=tuple(draws),
        references=tuple(keys),
        submissions=submissions,
        in_names=bool(names),
        meant_table=typed.table,
        meant=submissions if typed.table is answer else tuple(meanings),
        steps=typed.steps,
        by_value=not submission.parameters,
        exact=bool(names) and _is_exact(key) and (typed.exact or _stands_for_nothing(typed, key)),
    )


def _meant(
    key: SymbolicTable, answer: SymbolicTable, submission: ReadTable, values: Values, *, in_names: bool
) -> Typed:
    """The answer as it was meant; how exactly an entry was typed is seen where no value was put in."""
    angles, lengths = _known(key)
    known = meant(
        submission.table,
        submission.angle_unit,
        angles,
        lengths if in_names else (),
        submission.last_places,
        values.lengths,
    )
    if known.table is submission.table:
        return Typed(answer, known.steps)
    rows = tuple(
        replace(
            row,
            **{cell: getattr(new, cell) for cell in CELLS if getattr(new, cell) != getattr(old, cell)},
        )
        for row, old, new in zip(answer.rows, submission.table.rows, known.table.rows, strict=True)
    )
    return Typed(DHTable(convention=answer.convention, rows=rows), known.steps)


@lru_cache(maxsize=256)
def _known(key: SymbolicTable) -> tuple[tuple[Expression, ...], tuple[Expression, ...]]:
    """The angles and the lengths of the key that are numbers."""
    entries = [(cell, getattr(row, cell)) for row in key.rows for cell in CELLS]
    plain = [(cell, entry) for cell, entry in entries if entry != ZERO and not parameters_in(entry)]
    return (
        tuple(dict.fromkeys(entry for cell, entry in plain if cell in ANGLES)),
        tuple(dict.fromkeys(entry for cell, entry in plain if cell not in ANGLES)),
    )


@lru_cache(maxsize=256)
def _is_exact(key: SymbolicTable) -> bool:
    """Whether no angle of the key is a rounded multiple of 15°."""
    return meant(key, AngleUnit.RAD, ()).table is key


def _stands_for_nothing(typed: Typed, key: SymbolicTable) -> bool:
    """Whether the rounded entries of an answer are lengths, and no length of the key is a number.

    They must cancel, to the last digit: no wrong name is right because of them.
    """
    return not _known(key)[1] and all(cell not in ANGLES for _, cell in typed.steps)


@remembered(lambda key, draw: len(key.rows), longest=USUAL_ROWS, most=1024, few=64)
def _bound(key: SymbolicTable, draw: tuple[tuple[str, float], ...]) -> NumericTable:
    """The key at a draw; remembered, for one key is compared with many answers."""
    return _within_bounds(bind(key, dict(draw)))


def _within_bounds(table: NumericTable) -> NumericTable:
    """Return a table whose invariants can be computed.

    Raises:
        ParameterError: an entry is too large: its powers would be infinite.
    """
    for row in table.rows:
        if max(abs(row.alpha), abs(row.a), abs(row.d), abs(row.theta)) > LARGEST_ENTRY:
            break
    else:
        return table
    raise ParameterError(
        Fault(code="result_not_finite", where=("rows", i, cell))
        for i, row in enumerate(table.rows)
        for cell in CELLS
        if abs(getattr(row, cell)) > LARGEST_ENTRY
    )
