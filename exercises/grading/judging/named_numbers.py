"""Numbers in an answer that stand for names: those that are the values of some."""

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import islice, product

from exercises.grading.judging.name_values import Values
from exercises.grading.judging.typed import SAME, Place, half_steps
from kinematics.cells import ParameterKind, ReadTable
from kinematics.expressions import Expression, Number, Parameter, negate, pi_fraction
from kinematics.table import ANGLES, LENGTHS, DHTable

MOST_NAMED = 16  # Ways in which an answer is taken whose numbers are values of two names.
NAMED = 0.02
"""How far a number may be from the value of the name that it stands for, as a share, whatever its digits."""


def with_names(submission: ReadTable, values: Values) -> Iterator[ReadTable]:
    """Yield the answer with names for the numbers that are values of names.

    Where two names have one value, a number may stand for either of them. An angle may also be a number of
    the key, and the value of a name by chance.
    """
    lengths = _names_meant(submission, values, ParameterKind.LENGTH)
    angles = {
        (i, cell): [*fits, ("", getattr(submission.table.rows[i], cell))]
        for (i, cell), fits in _names_meant(submission, values, ParameterKind.ANGLE).items()
    }
    ways = (
        (meant, chosen)
        for meant in ((lengths, angles, {**lengths, **angles}) if angles else (lengths,))
        for chosen in product(*meant.values())
    )
    for meant, chosen in islice(ways, MOST_NAMED):
        found = {name: values.kinds[name] for name, _ in chosen if name}
        if not found:
            continue
        rows = list(submission.table.rows)
        for (i, cell), (_, entry) in zip(meant, chosen, strict=True):
            rows[i] = replace(rows[i], **{cell: entry})
        table = DHTable(convention=submission.table.convention, rows=tuple(rows))
        yield replace(submission, table=table, parameters={**submission.parameters, **found})


def _names_meant(
    submission: ReadTable, values: Values, kind: ParameterKind
) -> dict[Place, list[tuple[str, Expression]]]:
    """The names that lengths or angles of the answer may stand for, with the sign that makes them agree."""
    known = {
        name: float(value) for name, value in values.given.items() if values.kinds[name] is kind and value
    }
    if not known:
        return {}
    steps = half_steps(submission.table, submission.angle_unit, submission.last_places)
    found: dict[Place, list[tuple[str, Expression]]] = {}
    for i, row in enumerate(submission.table.rows):
        for cell in ANGLES if kind is ParameterKind.ANGLE else LENGTHS:
            here, step = _value(getattr(row, cell)), steps.get((i, cell), 0.0)
            if not here:
                continue
            fits = [name for name, value in known.items() if _is_meant(abs(here), abs(value), 0.0)]
            fits = fits or [name for name, value in known.items() if _is_meant(abs(here), abs(value), step)]
            if len({known[name] for name in fits}) == 1:
                found[i, cell] = [
                    (name, Parameter(name) if (here > 0) == (known[name] > 0) else negate(Parameter(name)))
                    for name in fits
                ]
    return found


def _value(entry: Expression) -> float:
    """The value of a number or a multiple of π; 0 of anything else."""
    if isinstance(entry, Number):
        return float(entry.value)
    turns = pi_fraction(entry)
    return 0.0 if turns is None else float(turns) * math.pi


def _is_meant(typed: float, value: float, step: float) -> bool:
    return abs(typed - value) <= min(step, NAMED * value) + SAME * value
