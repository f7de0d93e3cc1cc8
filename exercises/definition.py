"""What an exercise is: frozen records, as `loader` reads them from a folder."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from types import MappingProxyType

from exercises.access import ExerciseAccess
from exercises.draws import Draw
from exercises.figures.specification import FigureSpecification
from exercises.grading import HelpLevel, Policy
from exercises.grading.facts import Weights
from kinematics.cells import AngleUnit, LengthUnit, RawTable, ReadTable

LANGUAGES = ("en", "ro", "pt", "fr", "uk", "es")
"""The languages that the package's own exercises speak; one of your own needs one language."""


@dataclass(frozen=True, kw_only=True, slots=True)
class DrawnParameter:
    """A dimension of the robot.

    Attributes:
        name: as it stands in the table and in the figure.
        value: its value where no seed is given [unit of the exercise].
        draw: from where a student's own value is drawn; None keeps `value` for everyone.
    """

    name: str
    value: Fraction
    draw: Draw | None = None


@dataclass(frozen=True, kw_only=True, slots=True)
class Part:
    """Something that is asked.

    Attributes:
        kind: what, a key of `exercises.parts.registry.part_types`.
    """

    kind: str
    points: Fraction


@dataclass(frozen=True, kw_only=True, slots=True)
class Sample:
    """An answer with the judgement that is expected of it; part of an exercise's own tests.

    Attributes:
        name: what it shows.
        correct: it must be accepted; None: it must be refused as malformed.
        feedback: codes that the verdict must contain.
    """

    name: str
    table: RawTable
    correct: bool | None
    feedback: tuple[str, ...] = ()


@dataclass(frozen=True, kw_only=True, eq=False)
class Exercise:
    """An exercise.

    Attributes:
        id: name of its folder.
        version: raised whenever right answers or values change.
        titles: title by language.
        statements: statement by language, in Markdown.
        robot: id of the catalogue robot that it is about, if it is one.
        reference: the key, with parameters.
        angle_unit: unit of its angles, in the file and towards students.
        length_unit: unit of its lengths, in the file and towards students.
        parameters: the robot's dimensions, in the order in which they are shown.
        parts: what is asked, in order.
        policy: what a table is held to.
        weights: what facts and slips are worth in a wrong table.
        access: what its students may use, how much they are told, and how often they may try.
        figure: how the robot is drawn.
        misconceptions: codes of the misconceptions that its own tests apply to the key.
        samples: answers with the judgement that is expected of them.
        needs: dimensions that every right answer contains; the policy sees to it, and loading checks that.
        aliases: other names that students may use, with the dimension that each stands for.
        remarks: the lecturer's own words on a misconception, by its code and by language.
    """

    id: str
    version: int
    titles: Mapping[str, str]
    statements: Mapping[str, str]
    robot: str | None
    reference: ReadTable
    angle_unit: AngleUnit
    length_unit: LengthUnit
    parameters: tuple[DrawnParameter, ...]
    parts: tuple[Part, ...]
    policy: Policy
    access: ExerciseAccess
    figure: FigureSpecification
    misconceptions: tuple[str, ...]
    samples: tuple[Sample, ...] = ()
    needs: tuple[str, ...] = ()
    weights: Weights = field(default_factory=Weights)
    aliases: Mapping[str, str] = field(default_factory=lambda: MappingProxyType({}))
    remarks: Mapping[str, Mapping[str, str]] = field(default_factory=lambda: MappingProxyType({}))

    @property
    def help(self) -> HelpLevel:
        """How much a verdict may give away at most."""
        return self.access.most

    def text_language(self, language: str) -> str:
        """Return the language in which a reader is shown the texts: their own, else English, else any."""
        written = [found for found in self.titles if found in self.statements]
        return next((found for found in (language, "en") if found in written), written[0])

    def title(self, language: str) -> str:
        """Return the title for a reader of a language."""
        return self.titles[self.text_language(language)]

    def statement(self, language: str) -> str:
        """Return the statement for a reader of a language."""
        return self.statements[self.text_language(language)]

    def part(self, kind: str) -> Part | None:
        """Return the part of a kind, if it is asked."""
        return next((part for part in self.parts if part.kind == kind), None)

    @property
    def usual_values(self) -> dict[str, float]:
        """Value of every dimension where no seed is given [the exercise's unit]."""
        return {parameter.name: float(parameter.value) for parameter in self.parameters}

    @cached_property
    def points(self) -> Fraction:
        """What all parts together are worth."""
        return sum((part.points for part in self.parts), Fraction(0))
