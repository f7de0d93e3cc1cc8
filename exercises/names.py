"""The names that an answer may use: the exercise's dimensions, and a lecturer's aliases for them.

A name that is neither is refused with the nearest one that is known, and costs no attempt: nothing can be
said of what a student meant by it.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

from exercises.definition import Exercise
from exercises.grading.substitution import replaced, substituted
from kinematics.cells import ReadTable, nearest_name
from kinematics.cells.unit_words import is_symbol_of_unit
from kinematics.errors import Fault, ParamValue
from kinematics.expressions import Expression, Parameter, parameters_in
from kinematics.table import CELLS


def unknown_name(
    name: str, exercise: Exercise, where: tuple[str | int, ...], others: Collection[str] = ()
) -> Fault:
    """Return the fault of a name that means nothing in an exercise.

    Args:
        name: the name.
        exercise: the exercise.
        where: the place of the cell.
        others: names that may stand there besides the exercise's own.
    """
    own = tuple(exercise.reference.parameters)
    known = (*own, *sorted(set(others) - set(own)))
    close = nearest_name(name, (*known, *exercise.aliases))
    params: dict[str, ParamValue] = {
        "name": name,
        "unit": int(close is None and is_symbol_of_unit(name)),
        "found": int(close is not None),
        "close": close or "",
        "known": known or "–",
    }
    return Fault(code="name_unknown", where=where, params=params)


def table_faults(read: ReadTable, exercise: Exercise) -> list[Fault]:
    """Return the unknown names of a table, each at its first cell."""
    faults: dict[str, Fault] = {}
    if read.parameters.keys() <= _known(exercise):
        return []
    for i, row in enumerate(read.table.rows):
        for cell in CELLS:
            for name in sorted(parameters_in(getattr(row, cell)) - _known(exercise)):
                faults.setdefault(name, unknown_name(name, exercise, ("rows", i, cell)))
    return list(faults.values())


def without_aliases(read: ReadTable, exercise: Exercise) -> ReadTable:
    """Return a table in the exercise's own names."""
    aliases = exercise.aliases
    if not aliases.keys() & read.parameters.keys():
        return read
    table = substituted(read.table, lambda name: Parameter(aliases[name]) if name in aliases else None)
    kinds = {aliases.get(name, name): kind for name, kind in read.parameters.items()}
    return replace(read, table=table, parameters=kinds)


def renamed(expression: Expression, aliases: Mapping[str, str]) -> Expression:
    """Return an expression in the exercise's own names."""
    if not aliases:
        return expression
    return replaced(expression, lambda name: Parameter(aliases[name]) if name in aliases else None)


def _known(exercise: Exercise) -> frozenset[str]:
    return frozenset(exercise.reference.parameters) | frozenset(exercise.aliases)
