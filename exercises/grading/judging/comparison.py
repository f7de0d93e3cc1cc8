"""The key and the answer with numbers in their cells: which parameter values they are compared at.

A table with parameters is compared at several random draws of them, so that nothing is right by the accident
of two dimensions being equal. Where the exercise gives its parameters values, an answer may be in numbers
instead, or in numbers here and names there.
"""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property, lru_cache
from itertools import islice
from typing import NamedTuple

from exercises.grading.judging.name_values import (
    Values,
    drawn_value,
    has_a_value_always,
    typical_length,
    values_of,
    with_values,
)
from exercises.grading.judging.typed import Place, Typed, meant
from exercises.grading.judging.ways import ways_of
from kinematics.caching import USUAL_ROWS, cached_by_size
from kinematics.cells import AngleUnit, ReadTable, in_length_unit
from kinematics.errors import Fault, ParameterError
from kinematics.expressions import ZERO, Expression, parameters_in
from kinematics.table import ANGLES, CELLS, Convention, DHTable, NumericTable, SymbolicTable, bind

DRAWS = 3
"""Two unequal sums of names agree at a random draw with probability zero; three leave room for signs."""
# Tables with roots may have values at few draws.
ATTEMPTS = 60
LARGEST_ENTRY = 1e70
"""Volumes and fourth powers of lengths are computed, and sums of them over all rows: doubles end at 1e308."""


class Drawn(NamedTuple):
    """Two tables at one draw of their parameters.

    Attributes:
        values: of the parameters that are drawn [rad, or the submission's length unit].
        reference: the key.
        submission: the answer as it was typed.
        meant: the answer as it was meant; the same object where nothing was rounded.
    """

    values: Mapping[str, float]
    reference: NumericTable
    submission: NumericTable
    meant: NumericTable


@dataclass(frozen=True, kw_only=True, eq=False)
class Comparison:
    """Two tables and the parameter values at which they are compared; lengths in the submission's unit.

    Attributes:
        reference: the key, exact, with the values of those parameters that are not drawn.
        submission: the answer, likewise.
        drawn: both tables at draws of the parameters that are left; a single one if none is left.
        in_names: some parameter is drawn.
        meant_table: the answer with rounded entries replaced by what they stand for, exact.
        steps: half a unit of the last place of decimals that stand for themselves, by row and cell.
        typed_steps: the same of all decimals, whatever they stand for.
        by_value: no name stands in the answer.
        exact: the answer is in names, and nothing in it or in the key is known only to some digits, but for
            lengths by which it moves frames to and fro.
    """

    reference: SymbolicTable
    submission: SymbolicTable
    drawn: tuple[Drawn, ...]
    in_names: bool
    meant_table: SymbolicTable
    steps: Mapping[Place, float]
    typed_steps: Mapping[Place, float]
    exact: bool
    by_value: bool

    @cached_property
    def named_entries(self) -> tuple[tuple[Place, Expression, frozenset[str]], ...]:
        """The entries of the answer as it was meant with names in them: where, what, and which names."""
        return tuple(
            ((i, cell), entry, names)
            for i, row in enumerate(() if self.by_value else self.meant_table.rows)
            for cell in CELLS
            if (names := parameters_in(entry := getattr(row, cell)))
        )

    @cached_property
    def draws(self) -> tuple[Mapping[str, float], ...]:
        """The values of each draw."""
        return tuple(drawn.values for drawn in self.drawn)

    @cached_property
    def references(self) -> tuple[NumericTable, ...]:
        """The key at each draw."""
        return tuple(drawn.reference for drawn in self.drawn)

    @cached_property
    def submissions(self) -> tuple[NumericTable, ...]:
        """The answer at each draw, as it was typed."""
        return tuple(drawn.submission for drawn in self.drawn)

    @cached_property
    def meant(self) -> tuple[NumericTable, ...]:
        """The answer at each draw, as it was meant."""
        return tuple(drawn.meant for drawn in self.drawn)

    @property
    def typed_exactly(self) -> bool:
        """Whether no entry was rounded."""
        return self.drawn[0].meant is self.drawn[0].submission

    def declared(self, convention: Convention) -> "Comparison":
        """Return the same, with the answer declared in a convention."""
        drawn = (one._replace(meant=replace(one.meant, convention=convention)) for one in self.drawn)
        table = replace(self.meant_table, convention=convention)
        return replace(self, drawn=tuple(drawn), meant_table=table)

    def with_first(self, draw: int) -> "Comparison":
        """Return the same, with a draw (its number, from 0) moved to the front."""
        if not draw:
            return self
        first = self.drawn[draw]
        return replace(self, drawn=(first, *(drawn for drawn in self.drawn if drawn is not first)))


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
        for answer, fixed in ways_of(reference, submission, tuple((parameters or {}).items()))
        if (comparison := _comparison(key, answer, fixed, values)) is not None
    ]
    if not found:
        given = {name: float(value) for name, value in values.given.items()}
        _within_bounds(bind(key.table, given))
        _within_bounds(bind(submission.table, given))
        raise ParameterError(Fault.at("tables_without_value"))
    return tuple(found)


def compared_by_names(reference: ReadTable, submission: ReadTable, parameters: Mapping[str, float]) -> bool:
    """Whether the values of the parameters make no difference: no number of the answer may stand for a name.

    Args and raises as in `comparisons`.
    """
    values_of(reference, submission, parameters, 1.0)
    (way, fixed), *others = ways_of(reference, submission, tuple(parameters.items()))
    if others or fixed or way != submission:
        return False
    return has_a_value_always(reference.table) and has_a_value_always(submission.table)


@lru_cache(maxsize=256)
def _converted(reference: ReadTable, unit: str) -> ReadTable:
    return in_length_unit(reference, type(reference.length_unit)(unit))


def _in_unit_of(reference: ReadTable, submission: ReadTable) -> ReadTable:
    if reference.length_unit is submission.length_unit:
        return reference
    return _converted(reference, submission.length_unit.value)


def _comparison(
    reference: ReadTable, submission: ReadTable, fixed: frozenset[str], values: Values
) -> Comparison | None:
    try:
        key, answer = (with_values(read, fixed, values) for read in (reference, submission))
    except ZeroDivisionError:
        return None
    names = sorted(set(values.kinds) - fixed)
    typed = _meant(key, answer, submission, values.lengths_of(fixed), in_names=bool(names))
    drawn = tuple(islice(_drawn(key, answer, typed, names, values), DRAWS if names else 1))
    if not drawn:
        return None
    return Comparison(
        reference=key,
        submission=answer,
        drawn=drawn,
        in_names=bool(names),
        meant_table=typed.table,
        steps=typed.steps,
        typed_steps=typed.typed_steps,
        by_value=not submission.parameters,
        exact=bool(names) and _is_exact(key) and (typed.exact or _stands_for_nothing(typed, key)),
    )


def _drawn(
    key: SymbolicTable, answer: SymbolicTable, typed: Typed, names: Sequence[str], values: Values
) -> Iterator[Drawn]:
    """The draws at which both tables have values."""
    for attempt in range(ATTEMPTS if names else 1):
        draw = {name: drawn_value(name, attempt, values) for name in names}
        try:
            bound = _bound(key, tuple(draw.items())), _within_bounds(bind(answer, draw))
            as_meant = bound[1] if typed.table is answer else _within_bounds(bind(typed.table, draw))
        except ParameterError:
            continue
        yield Drawn(draw, *bound, as_meant)


def _meant(
    key: SymbolicTable,
    answer: SymbolicTable,
    submission: ReadTable,
    given: Collection[Fraction],
    *,
    in_names: bool,
) -> Typed:
    """The answer as it was meant; how exactly an entry was typed is seen where no value was put in.

    A given length is exact where it stands for its name; beside the name it is a number like any other.
    """
    angles, lengths = _known(key)
    known = meant(
        submission.table,
        submission.angle_unit,
        angles,
        lengths if in_names else (),
        submission.last_places,
        given,
    )
    if known.table is submission.table:
        return replace(known, table=answer)
    rows = tuple(
        replace(
            row,
            **{cell: getattr(new, cell) for cell in CELLS if getattr(new, cell) != getattr(old, cell)},
        )
        for row, old, new in zip(answer.rows, submission.table.rows, known.table.rows, strict=True)
    )
    return replace(known, table=DHTable(convention=answer.convention, rows=rows))


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


@cached_by_size(lambda key, draw: len(key.rows), longest=USUAL_ROWS, most=1024, few=64)
def _bound(key: SymbolicTable, draw: tuple[tuple[str, float], ...]) -> NumericTable:
    """The key at a draw; cached, for one key is compared with many answers."""
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
        Fault.at("result_not_finite", "rows", i, cell)
        for i, row in enumerate(table.rows)
        for cell in CELLS
        if abs(getattr(row, cell)) > LARGEST_ENTRY
    )
