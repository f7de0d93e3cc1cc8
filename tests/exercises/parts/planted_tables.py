"""Planted mistakes and answers about them.

A repair is right by construction: the key's own row, as it stands or written otherwise, without the checker.
A wrong one leaves the row as it was, or adds to a length or an angle of the key's row what no frame can undo.
"""

import random
from dataclasses import replace
from fractions import Fraction

from exercises.definition import Exercise
from exercises.grading import Policy, ToolRule
from exercises.instance import Instance
from exercises.parts.given_table import columns_of
from exercises.parts.mistakes.find_mistake import FoundMistakeCells
from exercises.parts.mistakes.found_mistakes import MistakePart
from exercises.parts.mistakes.planting import PLANTABLE, Planted
from exercises.written_table import written_table
from tests.exercises.packaged import exercise

ROBOTS = ("scorbot", "puma560", "rx90", "stanford", "kr125", "scara", "cloos")


def asked(name: str) -> Exercise:
    """An exercise of the package that asks to find a mistake, and nothing else."""
    part = MistakePart(kind="find_mistake", points=Fraction(10), mistakes=PLANTABLE)
    return replace(exercise(name), parts=(part,), policy=Policy(tool=ToolRule.POINT))


def answer(planted: Planted, instance: Instance, rng: random.Random) -> tuple[bool, FoundMistakeCells]:
    """A repair, whether it is right: undone, undone and written otherwise, or spoilt further."""
    key = instance.exercise.reference
    row = written_table(key).rows[planted.row]
    cells = [getattr(row, cell) for cell, _ in columns_of(planted.table)]
    kind = rng.random()
    if kind < 0.25:
        turn = " + 360" if key.angle_unit.value == "deg" else " + 2*pi"
        cells = [
            f"{value}{turn}" if name == "alpha" else value
            for (name, _), value in zip(columns_of(planted.table), cells, strict=True)
        ]
    elif kind < 0.5:
        cells = [
            str(instance.parameters.get(str(value), value)) if name in ("a", "d") else value
            for (name, _), value in zip(columns_of(planted.table), cells, strict=True)
        ]
    elif kind < 0.75:
        wrong = written_table(planted.table).rows[planted.row]
        cells = [getattr(wrong, cell) for cell, _ in columns_of(planted.table)]
    right = kind < 0.5
    mended = (cells[0], cells[1], cells[2], cells[3])
    if kind >= 0.75:
        name = rng.choice(["a", "alpha"])
        k = [cell for cell, _ in columns_of(planted.table)].index(name)
        spoilt = list(mended)
        spoilt[k] = f"{mended[k]} + {0.237 if name == 'a' else 23}"
        mended = (spoilt[0], spoilt[1], spoilt[2], spoilt[3])
    return right, FoundMistakeCells(row=planted.row + 1, name=planted.code, mended=mended)
