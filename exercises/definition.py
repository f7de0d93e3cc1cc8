"""What an exercise is: frozen records, as `loader` reads them from a folder."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from fractions import Fraction
from types import MappingProxyType

from exercises.figures.specification import FigureSpecification
from exercises.grading import HelpLevel, Policy
from kinematics.cells import AngleUnit, LengthUnit, RawTable, ReadTable

LANGUAGES = ("en", "ro", "pt", "fr", "uk", "es")
"""The languages that every exercise speaks."""


class PartKind(StrEnum):
    """What may be asked.

    SCHEMATIC: the type of every joint, and how each axis lies to the next.
    TABLE: the DH table.
    LINK_MATRICES: {}^{i-1}T_i for every row.
    TRANSFORM: ⁰T_N in closed form.
    POSE: ⁰T_N in numbers, at given joint values.
    WORKSPACE: inner and outer radius of the workspace.
    """

    SCHEMATIC = "schematic"
    TABLE = "table"
    LINK_MATRICES = "link_matrices"
    TRANSFORM = "transform"
    POSE = "pose"
    WORKSPACE = "workspace"


class ReachFrom(StrEnum):
    """From where the radii of a workspace are measured.

    AXIS: from the axis of the first joint, square to it.
    POINT: from a named point of the figure that no joint moves, or only joint 1 about itself.
    """

    AXIS = "axis"
    POINT = "point"


@dataclass(frozen=True, kw_only=True, slots=True)
class Draw:
    """Values from which a student's own one is drawn: start, start + step, …, not beyond stop.

    Attributes:
        start: the least value [unit of the exercise].
        stop: no value is greater.
        step: distance of neighbours.
        without: values that are left out.
    """

    start: Fraction
    stop: Fraction
    step: Fraction
    without: tuple[Fraction, ...] = ()

    def values(self) -> tuple[Fraction, ...]:
        """The values, in ascending order."""
        count = int((self.stop - self.start) / self.step)
        grid = (self.start + k * self.step for k in range(count + 1))
        return tuple(value for value in grid if value not in self.without)


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
        kind: what.
        points: what it is worth.
    """

    kind: PartKind
    points: Fraction


@dataclass(frozen=True, kw_only=True, slots=True)
class PosePart(Part):
    """⁰T_N in numbers.

    Attributes:
        joints: the joint values where no seed is given [units of the exercise].
        draws: per joint, from where a student's own value is drawn, or None.
        tolerance: largest error of a position as a fraction of the robot's size, and of a direction cosine.
    """

    joints: tuple[Fraction, ...]
    draws: tuple[Draw | None, ...]
    tolerance: float


@dataclass(frozen=True, kw_only=True, slots=True)
class WorkspacePart(Part):
    """Inner and outer radius of the workspace.

    Attributes:
        point: name of the point of the figure whose workspace is meant.
        reach_from: from where the radii are measured.
        origin: name of the point from which they are measured, if from a point.
        limits: per joint its lowest and highest value [units of the exercise]; None leaves it unlimited
            (a revolute joint turns fully).
        tolerance: largest error of a radius, as a fraction of the outer radius.
    """

    point: str
    reach_from: ReachFrom
    origin: str | None
    limits: tuple[tuple[Fraction, Fraction] | None, ...]
    tolerance: float


@dataclass(frozen=True, kw_only=True, slots=True)
class Sample:
    """An answer with the judgement that is expected of it; part of an exercise's own tests.

    Attributes:
        name: what it shows.
        table: the answer.
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
        help: how much a verdict may give away at most.
        figure: how the robot is drawn.
        misconceptions: codes of the misconceptions that its own tests apply to the key.
        samples: answers with the judgement that is expected of them.
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
    help: HelpLevel
    figure: FigureSpecification
    misconceptions: tuple[str, ...]
    samples: tuple[Sample, ...] = ()
    defaults: Mapping[str, float] = field(default_factory=lambda: MappingProxyType({}))

    def part(self, kind: PartKind) -> Part | None:
        """The part of a kind, if it is asked."""
        return next((part for part in self.parts if part.kind is kind), None)

    @property
    def points(self) -> Fraction:
        """What all parts together are worth."""
        return sum((part.points for part in self.parts), Fraction(0))
