"""The names that an answer may use: the exercise's dimensions, and a lecturer's aliases for them.

A name that is neither is refused with the nearest one that is known, and costs no attempt: nothing can be
said of what a student meant by it.
"""

from collections.abc import Collection
from dataclasses import replace
from functools import lru_cache

from exercises.definition import Exercise
from kinematics.cells import ParameterKind, ReadTable, nearest_name
from kinematics.cells.substitution import substitute, with_values
from kinematics.cells.unit_words import is_symbol_of_unit
from kinematics.cells.variables import misspelled_index, variable_index
from kinematics.errors import CellError, Fault, ParamValue
from kinematics.expressions import Expression, Parameter, parameters_in
from kinematics.table import ANGLES

ZEROS = {"o", "zero", "cero", "nul", "nula", "nulle", "nulo", "null", "nil", "none"}
"""What stands for zero in the languages of the pages, and the letter O."""


def unknown_name(
    name: str,
    exercise: Exercise,
    where: tuple[str | int, ...],
    others: Collection[str] = (),
    *,
    moving: bool = False,
) -> Fault:
    """Return the fault of a name that means nothing in an exercise.

    Args:
        others: names that may stand there besides the exercise's own.
        moving: joint variables may stand there, too.
    """
    own = tuple(exercise.reference.parameters)
    known = (*own, *sorted(set(others) - set(own)))
    close = nearest_name(name, (*known, *exercise.aliases))
    if close is None and name.lower() in ZEROS:
        close = "0"
    elif close is None and moving:
        index = misspelled_index(name) or 0
        close = f"q{index}" if 1 <= index <= exercise.reference.table.n_joints else None
    if name.startswith("alpha") and where and where[-1] in ANGLES and _is_length(close, exercise):
        close = None  # no a is taken for the twist of a row
    params: dict[str, ParamValue] = {
        "name": name,
        "unit": int(close is None and is_symbol_of_unit(name)),
        "found": int(close is not None),
        "close": close or "",
        "known": known or "–",
    }
    return Fault.at("name_unknown", *where, **params)


def table_faults(read: ReadTable, exercise: Exercise) -> list[Fault]:
    """Return the unknown names of a table, each at its first cell; also of one that makes no difference."""
    return [
        unknown_name(name, exercise, ("rows", *read.places.get(name, ())))
        for name in read.parameters
        if name not in _known(exercise)
    ]


def without_aliases(read: ReadTable, exercise: Exercise) -> ReadTable:
    """Return a table in the exercise's own names, the same object for the same table.

    Verdicts are known by the tables that they are of.

    Raises:
        ParameterError: a cell has no value in them, as 1/(a2 - L2) where L2 is another name of a2.
    """
    aliases = tuple((name, own) for name, own in exercise.aliases.items() if name in read.parameters)
    return _renamed(read, aliases) if aliases else read


@lru_cache(maxsize=512)
def _renamed(read: ReadTable, aliases: tuple[tuple[str, str], ...]) -> ReadTable:
    own = dict(aliases)
    table = with_values(read.table, {name: Parameter(named) for name, named in aliases})
    kinds = {own.get(name, name): kind for name, kind in read.parameters.items()}
    return replace(read, table=table, parameters=kinds)


def in_own_names(
    expression: Expression,
    exercise: Exercise,
    where: tuple[str | int, ...] = (),
    others: Collection[str] = (),
    *,
    idle: Collection[str] = (),
    is_constant: bool = False,
) -> Expression:
    """Return an expression of an answer in the exercise's own names.

    Args:
        others: names that may stand there besides the exercise's own.
        idle: names in the cell that make no difference.
        is_constant: joint variables mean nothing there, which is said of their names.

    Raises:
        CellError: it holds unknown names, or has no value in the exercise's own.
    """
    names = parameters_in(expression)
    unknown = sorted({*names, *idle} - _known(exercise) - set(others))
    if unknown:
        raise CellError(
            Fault.at("joint_variable_in_number", *where, name=name)
            if is_constant and variable_index(name) is not None
            else unknown_name(name, exercise, where, others, moving=not is_constant)
            for name in unknown
        )
    meanings = _meanings(names, exercise)
    if not meanings:
        return expression  # as read, so that what is known of it still is
    try:
        return substitute(expression, meanings)
    except ZeroDivisionError:
        raise CellError(Fault.at("value_undefined", *where)) from None


def _meanings(names: Collection[str], exercise: Exercise) -> dict[str, Expression]:
    """Return what stands in an expression for those of its names that are aliases."""
    aliases = exercise.aliases
    return {name: Parameter(aliases[name]) for name in names if name in aliases}


def _is_length(name: str | None, exercise: Exercise) -> bool:
    kinds = exercise.reference.parameters
    return name is not None and kinds.get(exercise.aliases.get(name, name)) is ParameterKind.LENGTH


def _known(exercise: Exercise) -> frozenset[str]:
    return frozenset(exercise.reference.parameters) | frozenset(exercise.aliases)
