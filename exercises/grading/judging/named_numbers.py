"""Numbers in an answer that stand for names: those that are the values of some."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import islice, product

from exercises.grading.judging.name_values import Values
from exercises.grading.judging.typed import SAME, Place, half_steps
from kinematics.cells import ParameterKind, ReadTable
from kinematics.expressions import Expression, Number, Parameter, negate
from kinematics.table import DHTable

MOST_NAMED = 16
"""Ways in which an answer is taken whose numbers are values of two names."""
NAMED = 0.02
"""How far a number may be from the value of the name that it stands for, as a share, whatever its digits."""


def with_names(submission: ReadTable, values: Values) -> Iterator[ReadTable]:
    """Yield the answer with names for the numbers that are values of names.

    Where two names have one value, a number may stand for either of them.
    """
    fits = _names_meant(submission, values)
    if not fits:
        return
    for chosen in islice(product(*fits.values()), MOST_NAMED):
        rows = list(submission.table.rows)
        for (i, cell), (_, name) in zip(fits, chosen, strict=True):
            rows[i] = replace(rows[i], **{cell: name})  # type: ignore[arg-type]
        table = DHTable(convention=submission.table.convention, rows=tuple(rows))
        found = {name: ParameterKind.LENGTH for name, _ in chosen}
        yield replace(submission, table=table, parameters={**submission.parameters, **found})


def _names_meant(submission: ReadTable, values: Values) -> dict[Place, list[tuple[str, Expression]]]:
    """The names that numbers of the answer may stand for, with the sign that makes them agree."""
    steps = half_steps(submission.table, submission.angle_unit, submission.last_places)
    lengths = {
        name: float(value)
        for name, value in values.given.items()
        if values.kinds[name] is ParameterKind.LENGTH and value
    }
    found: dict[Place, list[tuple[str, Expression]]] = {}
    for i, row in enumerate(submission.table.rows):
        for cell in ("a", "d"):
            entry = getattr(row, cell)
            if not isinstance(entry, Number) or not entry.value:
                continue
            here, step = float(entry.value), steps.get((i, cell), 0.0)
            fits = [name for name, value in lengths.items() if _is_meant(abs(here), abs(value), 0.0)]
            fits = fits or [name for name, value in lengths.items() if _is_meant(abs(here), abs(value), step)]
            if len({lengths[name] for name in fits}) == 1:
                found[i, cell] = [
                    (name, Parameter(name) if (here > 0) == (lengths[name] > 0) else negate(Parameter(name)))
                    for name in fits
                ]
    return found


def _is_meant(typed: float, value: float, step: float) -> bool:
    return abs(typed - value) <= min(step, NAMED * value) + SAME * value
