"""The parts of a parameter's name."""

import re
from typing import NamedTuple

from kinematics.cells.characters import GREEK

_LETTERS = {name: letter for letter, name in GREEK.items()}
_PARTS = re.compile(r"([A-Za-z]+)_?(.*)", re.DOTALL)
_RATE = re.compile(r"dq([0-9]+)", re.ASCII)


class NameParts(NamedTuple):
    """A name as it is typeset.

    Attributes:
        word: the letter or word that it begins with.
        script: its index, or nothing.
        greek: the Greek letter that the word names, or nothing.
        dotted: it is a rate of change, with a dot above.
    """

    word: str
    script: str
    greek: str
    dotted: bool = False


def split_name(name: str) -> NameParts:
    """Return a name in its pieces.

    L1 is L with the index 1, alpha2 is α with the index 2, L_x is L with the index x, dq1 is q̇ with 1.
    """
    rate = _RATE.fullmatch(name)
    if rate:
        return NameParts("q", rate[1], "", dotted=True)
    match = _PARTS.fullmatch(name)
    word, script = match.groups() if match else (name, "")
    return NameParts(word, script, _LETTERS.get(word, ""))
