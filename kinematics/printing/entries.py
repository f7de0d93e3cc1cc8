"""A matrix entry by entry, as books print it: named intermediates first, then r11 = …, px = ….

What stands in parentheses more than once gets a name, so that each line fits a page; nothing else is renamed.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import chain, count
from typing import NamedTuple

from kinematics.expressions import ONE, ZERO, Call, Sum
from kinematics.printing.latex import LatexWriter, parameter
from kinematics.printing.ledger import Entered, Ledger
from kinematics.printing.notation import Names
from kinematics.printing.text import TextWriter

_LETTERS = "kwuvabcdefgh"
"""Letters for intermediates, in the order in which they are tried."""
_AXES = "xyz"
_LAST_DIGIT = 9
"""Beyond it, the two indices of an entry need a comma between them."""


class Equation(NamedTuple):
    """One equation.

    Attributes:
        name: what is defined: k1, r11, px.
        text: its value as infix text.
        latex: the whole equation.
    """

    name: str
    text: str
    latex: str


def entry_lines(matrix: Entered, ledger: Ledger, names: Names, result: str) -> list[Equation]:
    """Write a matrix entry by entry; the last row of a pose is left out.

    Args:
        matrix: what to write, in the ledger.
        ledger: where its nodes are.
        names: how sines, cosines and joint variables are written.
        result: the letter of the entries of a matrix that is no pose: J11.
    """
    text, latex = TextWriter(names, ledger), LatexWriter(names, ledger)
    lines = []
    symbols = _intermediate_names(names)
    repeated = _repeated_sums(matrix, ledger)
    for number in matrix.nodes:
        text.known((number,))
        latex.known((number,))
        if number in repeated:
            name = next(symbols)
            lines.append(_line(name, parameter(name), number, text, latex))
            text.name(number, name)
            latex.name(number, parameter(name))
    for name, typeset, number in _entries(matrix, ledger, result):
        lines.append(_line(name, typeset, number, text, latex))
    return lines


def _line(name: str, typeset: str, number: int, text: TextWriter, latex: LatexWriter) -> Equation:
    entry = Entered(((number,),), [])
    return Equation(name, text.lines(entry)[0][0], f"{typeset}={latex.lines(entry)[0][0]}")


def _repeated_sums(matrix: Entered, ledger: Ledger) -> set[int]:
    """Sums that are factors or terms at several places; the sum of an angle belongs to its cosine."""
    uses = Counter(chain.from_iterable(ledger.below[number] for number in matrix.nodes))
    uses.update(chain.from_iterable(matrix.rows))
    angles = {
        child
        for number in matrix.nodes
        if isinstance(ledger.nodes[number], Call)
        for child in ledger.below[number]
    }
    return {n for n in matrix.nodes if isinstance(ledger.nodes[n], Sum) and uses[n] > 1 and n not in angles}


def _intermediate_names(names: Names) -> Iterator[str]:
    taken = {name[:1] for name in (*names.parameters, *names.variables)}
    letter = next((letter for letter in _LETTERS if letter not in taken), "k_")
    return (f"{letter}{i}" for i in count(1))


def _entries(matrix: Entered, ledger: Ledger, result: str) -> Iterator[tuple[str, str, int]]:
    """Name, name in LaTeX and node of every entry, row by row."""
    rows = matrix.rows
    last = [ledger.nodes[number] for number in rows[-1]]
    is_pose = len(rows) == 4 and last == [ZERO, ZERO, ZERO, ONE]
    for i, row in enumerate(rows[:3] if is_pose else rows, 1):
        for j, number in enumerate(row, 1):
            if is_pose and j == 4:
                yield f"p{_AXES[i - 1]}", f"p_{{{_AXES[i - 1]}}}", number
                continue
            letter = "r" if is_pose else result
            wide = max(len(rows), len(row)) > _LAST_DIGIT
            yield f"{letter}{i}{'_' * wide}{j}", f"{letter}_{{{i}{',' * wide}{j}}}", number
