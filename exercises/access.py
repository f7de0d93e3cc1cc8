"""What an exercise lets its students use and be told: switches, the help ladder, attempts."""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from itertools import pairwise

from exercises.grading import HelpLevel
from exercises.grading.verdict import LEVELS
from exercises.reading import Reader
from kinematics.keys import ValueKind

MOST_VARIANTS = 1000
"""Variants of an exercise: each is drawn and tested beforehand, which takes a second or two."""


class Tool(StrEnum):
    """What the service offers beside an exercise and a lecturer may switch off.

    CATALOGUE: the robots of the source documents, with their tables.
    PLAYGROUND: poses, Jacobians, closed forms, conversions and inverse kinematics of any table.
    MATRICES: the matrices of a table, numeric or in closed form.
    TRAINER: frame assignment, step by step, and its rules.
    """

    CATALOGUE = "catalogue"
    PLAYGROUND = "playground"
    MATRICES = "matrices"
    TRAINER = "trainer"


@dataclass(frozen=True, kw_only=True, slots=True)
class ExerciseAccess:
    """What students of an exercise may use.

    Attributes:
        off: what is switched off.
        ladder: the most that is told at the first attempt, at the second, …; the last holds from then on.
        attempts: how many attempts there are; None: as many as one likes.
        variants: how many sets of values there are, for all students together; None: a seed has its own.
    """

    off: frozenset[Tool] = frozenset()
    ladder: tuple[HelpLevel, ...] = (HelpLevel.REPAIR,)
    attempts: int | None = None
    variants: int | None = None

    @property
    def most(self) -> HelpLevel:
        """The most that is ever told."""
        return self.ladder[-1]

    def help_at(self, attempt: int | None) -> HelpLevel:
        """Return the most that an attempt is told; one of unknown number is told as much as the first."""
        return self.ladder[min(attempt or 1, len(self.ladder)) - 1]


def read_access(reader: Reader) -> ExerciseAccess:
    """Return what [access] and [help] of a definition say; faults go to the reader."""
    switches = reader.table("access")
    off = frozenset(tool for tool in Tool if not _switched_on(switches, tool))
    attempts, variants = (
        switches.count(name) if switches.given(name) else None for name in ("attempts", "variants")
    )
    if variants is not None and variants > MOST_VARIANTS:
        switches.fault("variants_too_many", "variants", limit=MOST_VARIANTS)
    switches.finish()
    helps = reader.table("help")
    ladder = _ladder(helps)
    helps.finish()
    return ExerciseAccess(off=off, ladder=ladder, attempts=attempts, variants=variants)


def lowest(levels: Sequence[HelpLevel]) -> HelpLevel:
    """Return the level that tells least."""
    return min(levels, key=LEVELS.index)


def _switched_on(reader: Reader, tool: Tool) -> bool:
    if not reader.given(tool.value):
        return True
    value = reader.values[tool.value]
    if not isinstance(value, bool):
        reader.mistyped(ValueKind.FLAG, tool.value)
    return value is not False


def _ladder(reader: Reader) -> tuple[HelpLevel, ...]:
    most = reader.choice("most", HelpLevel, HelpLevel.REPAIR)
    if not reader.given("ladder"):
        return (most,)
    ladder = tuple(lowest((level, most)) for level in reader.choices("ladder", HelpLevel))
    if any(lowest(pair) is not pair[0] for pair in pairwise(ladder)):
        reader.fault("ladder_falls", "ladder")
    if not ladder:
        reader.mistyped(ValueKind.HELP_LEVELS, "ladder")
    return ladder or (most,)
