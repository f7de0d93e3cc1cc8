"""A matrix entry by entry, as books print it: named intermediates first, then r11 = …, px = ….

What stands in parentheses more than once gets a name, so that each line fits a page; nothing else is renamed.
"""

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import chain, count
from typing import NamedTuple

from kinematics.expressions import ONE, ZERO, Call, Sum
from kinematics.printing.latex import LatexWriter, parameter
from kinematics.printing.ledger import Entered, Ledger
from kinematics.printing.notation import Names
from kinematics.printing.text import TextWriter

_LETTERS = "kwuvabdef"
"""Letters for intermediates, in the order in which they are tried; c1 is a cosine, and g, h are results."""
_AXES = "xyz"
_LAST_DIGIT = 9  # Beyond it, the two indices of an entry need a comma between them.


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

    The entries of a matrix that is no pose have the letter `result`: J11, and g1 in a single column.
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
    for name, typeset, number in _entries(matrix, ledger, names, result):
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


def _entries(matrix: Entered, ledger: Ledger, names: Names, result: str) -> Iterator[tuple[str, str, int]]:
    """Name, name in LaTeX and node of every entry, row by row."""
    rows = matrix.rows
    last = [ledger.nodes[number] for number in rows[-1]]
    is_pose = len(rows) == 4 and last == [ZERO, ZERO, ZERO, ONE]
    taken = {_bare(name) for name in (*names.parameters, *names.variables)}
    if not is_pose:
        yield from _named(rows, result, taken)
        return
    rotation = list(_named([row[:3] for row in rows[:3]], "r", taken))
    letter = _free("p", taken, _AXES)
    for i, axis in enumerate(_AXES):
        yield from rotation[3 * i : 3 * i + 3]
        yield f"{letter}{axis}", f"{letter}_{{{axis}}}", rows[i][3]


def _named(
    rows: Sequence[Sequence[int]], letter: str, taken: Collection[str]
) -> Iterator[tuple[str, str, int]]:
    """The entries of rows with their indices: g1 in a single column, r11 in a matrix."""
    wide = max(len(rows), len(rows[0])) > _LAST_DIGIT
    indices = [
        [(f"{i}",)] if len(row) == 1 else [(f"{i}", f"{j}") for j in range(1, len(row) + 1)]
        for i, row in enumerate(rows, 1)
    ]
    words = [("_" * wide).join(index) for row in indices for index in row]
    letter = _free(letter, taken, words)
    typeset = [("," * wide).join(index) for row in indices for index in row]
    for word, index, number in zip(words, typeset, chain.from_iterable(rows), strict=True):
        yield f"{letter}{word}", f"{letter}_{{{index}}}", number


def _free(letter: str, taken: Collection[str], words: Iterable[str]) -> str:
    """The letter, in the other case or repeated if with these words it makes a name of the table."""
    listed = list(words)
    spellings = chain([letter, letter.swapcase()], (letter * n for n in count(2)))
    return next(start for start in spellings if not any(_bare(f"{start}{word}") in taken for word in listed))


def _bare(name: str) -> str:
    """A name as it is told apart in print, where p_x and px are the same."""
    return name.replace("_", "")
