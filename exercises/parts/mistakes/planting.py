"""Mistakes of the catalogue, planted in a table: which there are, and what a repair of one is called."""

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import lru_cache
from types import MappingProxyType

import numpy as np

from exercises.definition import Exercise
from exercises.draws import Picker
from exercises.grading import ConventionRule, Policy, is_accepted
from exercises.reading import KeyShape, Reader
from exercises.selftest.mistakes import MISTAKES
from kinematics.cells import ReadTable

PLANTABLE: tuple[str, ...] = (
    "alpha_sign",
    "alpha_value",
    "a_sign",
    "d_sign",
    "a_value",
    "d_value",
    "a_d_swapped",
)
"""Mistakes of one row that are mended in that row."""
_OF_CELLS = {"alpha": "twist", "a": "length", "d": "offset"}
FACTS: Mapping[str, str] = MappingProxyType({code: _OF_CELLS[code.partition("_")[0]] for code in PLANTABLE})
"""The fact of the robot that a mistake changes."""
REPAIRS: Mapping[str, str] = MappingProxyType(
    {
        "a_missing": "a_value",
        "a_not_zero": "a_value",
        "d_missing": "d_value",
        "d_not_zero": "d_value",
        **{code: code for code in PLANTABLE},
    }
)
"""What the catalogue of repairs calls more finely than the choice that students have."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Planted:
    """A table with a mistake in it.

    Its row counts from 0.
    """

    table: ReadTable
    code: str
    row: int


def read_mistakes(reader: Reader, catalogue: Sequence[str]) -> tuple[str, ...]:
    """Return which mistakes of a catalogue a definition lets be planted: all, unless it names some."""
    reader.note("mistakes", KeyShape.CHOICES, options=catalogue)
    codes = reader.texts("mistakes", default=tuple(catalogue))
    for i, code in enumerate(codes):
        if code not in catalogue:
            reader.fault("misconception_unknown", "mistakes", i, name=code, known=", ".join(catalogue))
    return tuple(code for code in codes if code in catalogue) or tuple(catalogue)


def planted(exercise: Exercise, codes: Sequence[str], picker: Picker, name: str) -> Planted:
    """Return the key with a mistake that a student's seed chooses among those that do harm."""
    harmful = {code: ways for code in codes if (ways := _ways(exercise, code))}
    code = picker.choice(tuple(harmful), f"{name} mistake")
    return picker.choice(harmful[code], f"{name} place")


def plantable(read: ReadTable, code: str, policy: Policy, parameters: Mapping[str, float]) -> list[Planted]:
    """Return the ways to make a mistake in a table that make it another robot, or break its policy."""
    found = []
    for table in MISTAKES[code](read):
        rows = [
            i
            for i, (row, other) in enumerate(zip(read.table.rows, table.table.rows, strict=True))
            if row != other
        ]
        if len(rows) == 1 and _refused(read, table, policy, parameters):
            found.append(Planted(table=table, code=code, row=rows[0]))
    return found


def _refused(read: ReadTable, table: ReadTable, policy: Policy, parameters: Mapping[str, float]) -> bool:
    """Return whether a table is refused; one that cannot be decided for its tiny numbers is not planted."""
    with np.errstate(all="ignore"), suppress(np.linalg.LinAlgError):
        return not is_accepted(read, table, as_given(policy), parameters)
    return False


@lru_cache(maxsize=256)
def _ways(exercise: Exercise, code: str) -> tuple[Planted, ...]:
    return tuple(plantable(exercise.reference, code, exercise.policy, exercise.usual_values))


def as_given(policy: Policy) -> Policy:
    """Return a policy for a table that is given: nobody chose its convention."""
    return replace(policy, convention=ConventionRule.ANY)


def usable(exercise: Exercise, codes: Sequence[str]) -> bool:
    """Return whether some of the mistakes can be planted in an exercise's key."""
    return any(_ways(exercise, code) for code in codes)
