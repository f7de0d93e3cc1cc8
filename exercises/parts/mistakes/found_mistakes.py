"""What all parts share in which a planted mistake is to be found, named and mended.

Each of the three earns a third. Whatever mends is right; a repair that does says where the mistake was.
"""

from abc import abstractmethod
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, fields
from fractions import Fraction
from random import Random
from typing import Any, ClassVar, NamedTuple, TypeVar

from exercises.definition import Exercise, Part
from exercises.grading import Feedback, Finding, HelpLevel
from exercises.instance import Instance
from exercises.parts.context import Context
from exercises.parts.mistakes.planting import read_mistakes
from exercises.parts.protocol import TABLE, PartType, Raw, Read, Reading, RobotFacts
from exercises.parts.report import Credit, Disclosure, Fact, PartReport, fact, judged, told_from
from exercises.parts.task import FormField, choice_field
from exercises.reading import Reader
from kinematics.errors import Fault


@dataclass(frozen=True, kw_only=True, slots=True)
class MistakePart(Part):
    """Something with a planted mistake.

    Attributes:
        mistakes: codes of those that may be planted.
    """

    mistakes: tuple[str, ...]


class FoundStep(NamedTuple):
    """One of the three things that are asked.

    Attributes:
        right: whether it is right, or follows from what is.
        given: what the student gave; None: nothing.
    """

    right: bool
    given: object


class MistakeWords(NamedTuple):
    """Codes of what is told of place, name and repair if they are wrong, and of what is empty."""

    place: str
    name: str
    mended: str
    missing: str

    def told(self) -> dict[str, Disclosure]:
        """Return the level of help from which each is told."""
        return told_from(HelpLevel.ROW, *self)


M = TypeVar("M", bound=MistakePart)


class MistakeType(PartType[M, Raw, Read]):
    """Find the mistake in something.

    Attributes:
        catalogue: every mistake that may be planted.
        words: what is told.
        fields: of the answer, for place, name and repair.
    """

    gives_away: ClassVar[tuple[str, ...]] = (TABLE,)
    catalogue: ClassVar[Collection[str]]
    words: ClassVar[MistakeWords]
    fields: ClassVar[tuple[str, str, str]]

    def define(self, reader: Reader, points: Fraction, robot: RobotFacts) -> M:
        """Return the part with the mistakes that may be planted."""
        mistakes = read_mistakes(reader, tuple(self.catalogue))
        return MistakePart(kind=self.kind, points=points, mistakes=mistakes)  # type: ignore[return-value]

    def inconsistencies(self, part: M, exercise: Exercise) -> Iterator[Fault]:
        """Yield a fault where nothing can be planted."""
        if not self.can_be_planted(part, exercise):
            yield Fault.at("no_mistake_does_harm", "mistakes")

    def can_be_planted(self, part: M, exercise: Exercise) -> bool:
        """Return whether some mistake of the part does harm in the exercise."""
        return True

    def wrong(self, part: M, context: Context, rng: Random) -> Iterator[tuple[str, Raw]]:
        """Yield what was shown in the place of a repair, and nothing but a name."""
        right = self.right(part, context)
        yield self.words.mended, self.left_as_shown(right, context.instance)
        name = self.fields[1]
        yield self.words.missing, self.raw(**{name: getattr(right, name)})

    @abstractmethod
    def left_as_shown(self, right: Raw, instance: Instance) -> Raw:
        """Return a right answer but for the repair, which is what was shown."""

    def is_empty(self, raw: Raw, reading: Reading) -> bool:
        """Return whether none of the fields holds anything; if so, keep a fault."""
        empty = all(is_blank(getattr(raw, field.name)) for field in fields(self.raw))
        if empty:
            reading.fault("mistake_empty")
        return empty

    def name_field(self, mistakes: Collection[str]) -> FormField:
        """Return the field in which the mistake is named."""
        return choice_field(self.fields[1], mistakes)

    def known_name(self, given: str | None, reading: Reading, known: Sequence[str]) -> str | None:
        """Return the name of a mistake as it was given; one that is not in the catalogue is a fault."""
        if given and given not in known:
            reading.fault("misconception_unknown", self.fields[1], name=given, known=", ".join(known))
        return given or None

    def number(
        self, text: int | str | None, field: str, within: range, reading: Reading, code: str, **params: Any
    ) -> int | None:
        """Return a number as it was given, None if none was; one that is out of range is a fault."""
        if text is None or text == "":
            return None
        digits = str(text)
        number = int(digits) if digits.isascii() and digits.isdecimal() and len(digits) < 4 else -1
        if number in within:
            return number
        reading.fault(code, field, count=within[-1], **params)
        return None

    def report(self, part: M, place: FoundStep, name: FoundStep, mended: FoundStep) -> PartReport:
        """Return the report on an answer, a third of the points for each of these."""
        steps = list(zip(self.fields, (place, name, mended), self.words, strict=False))
        facts = [
            Fact(where=(field,), finding=Finding.MISSING)
            if step.given is None and not step.right
            else fact(step.right, field)
            for field, step, _ in steps
        ]
        wrong = [
            Feedback(code=self.words.missing, params={"what": field})
            if step.given is None
            else Feedback(code=code)
            for field, step, code in steps
            if not step.right
        ]
        score = sum(step.right for _, step, _ in steps) / len(steps)
        right = [Feedback(code="mistake_found")]
        return judged(part, score, Credit.KEY, facts=facts, feedback=wrong or right)


def is_blank(value: object) -> bool:
    """Return whether a field, or every cell in it, was left out or has no text."""
    return all(map(is_blank, value)) if isinstance(value, list | tuple) else value in (None, "")
