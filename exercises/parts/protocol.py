"""What a part type is: the one protocol of all modules in this package that define `PART`.

A part type reads its definition, draws a student's values, reads an answer, grades it with what follows from
the student's own table, describes itself for the page, and makes right and wrong answers for the self-test.
How an answer is written is `raw`, an annotation of plain Python types and records; whoever serves the
exercises derives the wire schema and its documentation from it.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from random import Random
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, ClassVar, Generic, TypeVar

from exercises.definition import Exercise, Part
from exercises.draws import Picker
from exercises.grading import HelpLevel
from exercises.names import in_own_names, table_faults, without_aliases
from exercises.parts.first_values import Start
from exercises.parts.report import Disclosure, PartReport, shown
from exercises.parts.task import PartTask
from exercises.reading import DefinitionKey, Reader, keys_read
from kinematics.cells import AngleUnit, LengthUnit, Limits, ReadTable, parameters_in_radians
from kinematics.errors import CellError, Fault, KinematicsError
from kinematics.expressions import Expression
from kinematics.table import JointType, bind

if TYPE_CHECKING:
    from exercises.instance import Instance
    from exercises.parts.context import Context

TABLE = "table"  # The kind of part that all others may follow from.

P = TypeVar("P", bound=Part)
Raw = TypeVar("Raw")
Read = TypeVar("Read")
Kept = TypeVar("Kept")


@dataclass(frozen=True, kw_only=True, slots=True)
class Length:
    """How many entries a sequence in an answer may have; stands in `Annotated[...]`."""

    least: int = 0
    most: int = 64


@dataclass(frozen=True, kw_only=True, slots=True)
class RobotFacts:
    """What a part's definition is read beside.

    Attributes:
        row_types: what varies in each row of the robot's table.
        degrees: the exercise gives angles in degrees.
        limits: of the catalogue robot's joints, if they are known.
    """

    row_types: tuple[JointType, ...]
    degrees: bool
    limits: Sequence[tuple[float, float]] | None

    @property
    def joint_types(self) -> tuple[JointType, ...]:
        """Types of the robot's joints: of the rows that are not fixed."""
        return tuple(kind for kind in self.row_types if kind is not JointType.FIXED)


class RawAnswer:
    """An answer as handed in: by kind of part what was written; None is the same as nothing."""

    __slots__ = ("parts",)

    def __init__(self, **parts: Any) -> None:
        self.parts: Mapping[str, Any] = MappingProxyType(
            {kind: raw for kind, raw in parts.items() if raw is not None}
        )

    def get(self, kind: str) -> Any:
        """Return what was handed in for a kind of part, or None."""
        return self.parts.get(kind)


@dataclass(frozen=True, kw_only=True, eq=False)
class Answer:
    """An answer as read.

    Attributes:
        parts: by kind of part what was read.
        angle_unit: unit of its angles: the table's, or else the exercise's.
        length_unit: unit of its lengths: the table's, or else the exercise's.
    """

    parts: Mapping[str, Any]
    angle_unit: AngleUnit
    length_unit: LengthUnit

    def get(self, kind: str) -> Any:
        """Return what was read for a kind of part, or None."""
        return self.parts.get(kind)

    @property
    def table(self) -> ReadTable | None:
        """The student's own DH table, if one was handed in."""
        table: ReadTable | None = self.parts.get(TABLE)
        return table


@dataclass(frozen=True, kw_only=True, eq=False)
class Reading:
    """What the answer to one part is read beside.

    Attributes:
        instance: the exercise with the student's values.
        raw: everything that was handed in.
        table: the student's own table, if one was handed in and could be read.
        limits: how large a table may be.
        faults: what was found wrong with the part, seen from there.
    """

    instance: Instance
    raw: RawAnswer
    table: ReadTable | None
    limits: Limits
    faults: list[Fault] = field(default_factory=list)

    @property
    def source(self) -> ReadTable:
        """The table whose units and joints the answer uses: the student's own, else the key."""
        return self.table or self.instance.exercise.reference

    @property
    def joint_types(self) -> tuple[JointType, ...]:
        """Types of the joints whose variables may stand in the answer."""
        return self.source.table.joint_types

    @property
    def angle_unit(self) -> AngleUnit:
        """Unit of plain numbers where an angle stands."""
        return self.source.angle_unit

    @property
    def values(self) -> dict[str, float]:
        """Value of every dimension in the answer's length unit (an angle in the exercise's unit)."""
        return self.instance.values_in(self.source.length_unit)

    def fault(self, code: str, *where: str | int, **params: Any) -> None:
        """Keep a fault at a place in the answer to the part."""
        self.faults.append(Fault.at(code, *where, **params))

    def is_row_of(
        self, count: int, row: Sequence[Any], *where: str | int, code: str = "joint_row_length"
    ) -> bool:
        """Return whether a row has as many entries as it must; if not, keep a fault at its place."""
        if len(row) != count:
            self.fault(code, *where, expected=count, given=len(row))
        return len(row) == count

    def own_table(self, read: ReadTable) -> ReadTable | None:
        """Return a table in the exercise's own names, or None.

        Faults are kept: names that the exercise does not know, and cells that have no value for the student's
        dimensions, as `sqrt(L2 - L1)` where L1 is the longer one.
        """
        exercise = self.instance.exercise
        self.faults.extend(table_faults(read, exercise))
        own = None if self.faults else self.keep(lambda: without_aliases(read, exercise))
        if own is None:
            return None
        values = parameters_in_radians(
            self.instance.values_in(own.length_unit), exercise.reference.parameters, exercise.angle_unit
        )
        return None if self.keep(lambda: bind(own.table, values)) is None else own

    def own_names(
        self,
        expression: Expression,
        where: tuple[str | int, ...],
        others: Collection[str] = (),
        idle: Collection[str] = (),
    ) -> Expression | None:
        """Return an expression in the exercise's own names, or None; faults are kept.

        Args:
            where: the place of its cell in the part.
            others: names that may stand in it besides the exercise's own.
            idle: names in its cell that make no difference.
        """
        try:
            return in_own_names(expression, self.instance.exercise, where, others, idle=idle)
        except CellError as error:
            self.faults.extend(error.faults)
            return None

    def keep(self, read: Callable[[], Kept]) -> Kept | None:
        """Return what a function reads, or None; its faults are kept."""
        try:
            return read()
        except KinematicsError as error:
            self.faults.extend(error.faults)
            return None


class PartType(ABC, Generic[P, Raw, Read]):
    """One kind of question.

    Attributes:
        kind: its name in definitions, answers and reports, in snake_case.
        raw: how an answer is written, as an annotation; records are described by their docstrings.
        meaning: what an answer says, for the documentation of the API.
        given: the record that `task` shows beside its sentence, if there is one.
        follows_table: an answer that follows from the student's own wrong table earns its points.
        gives_away: kinds that cannot be asked beside it, because it shows their answer.
        disclosures: by feedback code from which help level on it is told; what is not listed always is.
    """

    kind: ClassVar[str]
    raw: ClassVar[Any]
    meaning: ClassVar[str]
    given: ClassVar[type | None] = None
    follows_table: ClassVar[bool] = False
    gives_away: ClassVar[tuple[str, ...]] = ()
    disclosures: ClassVar[Mapping[str, Disclosure]] = MappingProxyType({})

    def define(self, reader: Reader, points: Fraction, robot: RobotFacts) -> P:
        """Return the part as its definition asks for it; faults go to the reader.

        Args:
            reader: of the part's entry; `kind` and `points` are read already.
        """
        return Part(kind=self.kind, points=points)  # type: ignore[return-value]

    def keys(self, robot: RobotFacts) -> tuple[DefinitionKey, ...]:
        """Return what the definition may say beside `kind` and `points`: what `define` reads."""
        return keys_read(lambda reader: self.define(reader, Fraction(1), robot))

    def start(self, robot: RobotFacts) -> Start:
        """Return what a definition must say beside `kind` and `points`, to go on from."""
        return {}

    def inconsistencies(self, part: P, exercise: Exercise) -> Iterable[Fault]:
        """Return what does not fit the rest of the exercise; places inside the part's entry."""
        return ()

    def warnings(self, part: P, exercise: Exercise) -> Iterable[str]:
        """Return what the author should know although nothing breaks on it: codes of `check-<code>`."""
        return ()

    def draw(self, part: P, exercise: Exercise, picker: Picker) -> Any:
        """Return what is drawn for one student beside the robot's dimensions; None if nothing is."""
        return None

    def task(self, part: P, instance: Instance) -> PartTask:
        """Return what the part asks of one student: of all the same, if nothing else is said."""
        return PartTask(message=f"task-{self.kind.replace('_', '-')}")

    @abstractmethod
    def read(self, raw: Raw, reading: Reading) -> Read | None:
        """Return the answer as read; None if faults were kept in the reading.

        Args:
            reading: the exercise, the student's own table, and where faults go.
        """

    @abstractmethod
    def grade(self, part: P, answer: Read, context: Context) -> PartReport:
        """Judge an answer; everything that was found, whatever the help level.

        Args:
            answer: what was handed in, as read.
            context: the key, the student's own table, values, tolerance, the other parts.
        """

    def shown(self, report: PartReport, level: HelpLevel) -> PartReport:
        """Return the report as a level of help shows it."""
        return shown(report, level, self.disclosures)

    @abstractmethod
    def right(self, part: P, context: Context) -> Raw:
        """Return what a student with the table in `context.own` writes who makes no further mistake."""

    @abstractmethod
    def wrong(self, part: P, context: Context, rng: Random) -> Iterator[tuple[str, Raw]]:
        """Yield wrong answers beside the table in `context.own`, each with the code that explains it."""

    @property
    def misconceptions(self) -> tuple[str, ...]:
        """Feedback codes of the misconceptions that are told at the highest level of help."""
        return tuple(code for code, entry in self.disclosures.items() if entry.level is HelpLevel.REPAIR)
