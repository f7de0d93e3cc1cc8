"""Find the mistake in a figure: one of the drawn frames breaks a rule; find it, name it, mend it.

Whatever obeys the rules mends it: the frame of the key, or any other that the convention allows. A place is
right if the frame there was mended.
"""

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Annotated, Any, ClassVar

from exercises.definition import Exercise
from exercises.draws import Picker
from exercises.errors import DefinitionError
from exercises.figures.geometry import close
from exercises.figures.points import frames_in_figure
from exercises.instance import Instance, generate
from exercises.parts.cells.by_name import ByName, read_by_name
from exercises.parts.context import Context
from exercises.parts.forward.figure_frames import (
    figure_axes,
    figure_coordinates,
    key_frames,
    lengths_in_frame,
    read_vector,
)
from exercises.parts.mistakes.found_mistakes import (
    FoundStep,
    MistakePart,
    MistakeType,
    MistakeWords,
    is_blank,
)
from exercises.parts.protocol import TABLE, Length, Reading
from exercises.parts.report import PartReport
from exercises.parts.task import FieldShape, FormField, GivenNumbers, PartTask, choice_field
from kinematics.cells import Cell
from kinematics.errors import Fault
from kinematics.frames.wrong_frames import (
    FRAME_MISTAKES,
    DrawnFrame,
    PlantedFrame,
    mends,
    plantable_in_frames,
)
from kinematics.se3 import Vector, position
from kinematics.table import JointType

ThreeCells = Annotated[tuple[Cell, ...], Length(least=3, most=3)]
MENDED = ("mended_origin", "mended_x", "mended_y", "mended_z")  # The fields of the frame as it should be.
DECIMALS = 4  # What is shown of a coordinate: less than what a student may be off by.


@dataclass(frozen=True, kw_only=True, slots=True)
class FoundFrameMistakeCells:
    """Which frame is wrong, what is wrong with it, and the frame as it should be.

    Attributes:
        wrong_frame: number of the frame, from 0.
        mistake: what is wrong with it, by name.
        mended_origin: its origin, in the coordinates of the figure and the exercise's length unit.
        mended_x: direction of its x axis; any length but zero.
        mended_y: direction of its y axis; any length but zero.
        mended_z: direction of its z axis; any length but zero.
    """

    wrong_frame: int | str | None = None
    mistake: str | None = None
    mended_origin: ThreeCells | None = None
    mended_x: ThreeCells | None = None
    mended_y: ThreeCells | None = None
    mended_z: ThreeCells | None = None


@dataclass(frozen=True, kw_only=True, slots=True)
class FoundFrameMistake:
    """A mistake that was found, in numbers; the mended frame only if all of it was given."""

    frame: int | None
    mistake: str | None
    mended: DrawnFrame | None


class FrameMistakeType(MistakeType[MistakePart, FoundFrameMistakeCells, ByName[FoundFrameMistake]]):
    """Find the mistake in a figure."""

    kind = "frame_mistake"
    raw: ClassVar = FoundFrameMistakeCells
    meaning = "the planted mistake in a figure: which frame is wrong, why, and the frame as it should be"
    words: ClassVar = MistakeWords(
        "frame_mistake_place_wrong", "frame_mistake_name_wrong", "frame_not_mended", "frame_mistake_missing"
    )
    disclosures: ClassVar = words.told()
    fields: ClassVar = ("wrong_frame", "mistake", "mended_origin")
    catalogue: ClassVar = FRAME_MISTAKES
    gives_away: ClassVar = (TABLE, "frames")

    def inconsistencies(self, part: MistakePart, exercise: Exercise) -> Iterator[Fault]:
        """Yield a fault where the robot cannot show any of the mistakes."""
        # a figure that cannot be drawn has faults of its own
        with suppress(DefinitionError):
            able = _ways(generate(exercise))
            if not any(code in able for code in part.mistakes):
                yield Fault.at("frame_mistakes_not_shown", "mistakes", known=", ".join(able))

    def warnings(self, part: MistakePart, exercise: Exercise) -> Iterable[str]:
        """Return a code where a slider is drawn at zero, so that the frames before and behind it coincide."""
        key = exercise.reference.table
        at = [position(pose) for pose in frames_in_figure(exercise.figure, key, generate(exercise).values)]
        slides = (i for i, row in enumerate(key.rows) if row.joint is JointType.PRISMATIC)
        return ("frames_coincide",) if any(close(at[i], at[i + 1]) for i in slides) else ()

    def draw(self, part: MistakePart, exercise: Exercise, picker: Picker) -> tuple[str, str]:
        """Return what decides the student's mistake; the frames follow from the student's dimensions."""
        places = tuple(f"{k:03d}" for k in range(MOST_PLACES))
        return (
            picker.choice(part.mistakes, f"{self.kind} mistake"),
            picker.choice(places, f"{self.kind} place"),
        )

    def task(self, part: MistakePart, instance: Instance) -> PartTask:
        """Show the frames in numbers beside the figure."""
        found = planted_in(instance)
        unit = instance.exercise.length_unit.value
        rows = tuple(
            (str(i), *(_text(vector) for vector in (frame.origin, frame.x, frame.y, frame.z)))
            for i, frame in enumerate(found.shown)
        )
        convention = instance.exercise.reference.table.convention.value
        shown = GivenNumbers(
            name="drawn-frames", labels=("i", f"O [{unit}]", "x", "y", "z"), rows=rows, values={}
        )
        return PartTask(
            message="task-frame-mistake",
            values={"convention": convention, **figure_coordinates(instance)},
            form=(
                choice_field("wrong_frame", tuple(str(i) for i in range(len(found.shown)))),
                self.name_field(FRAME_MISTAKES),
                *(FormField(name=name, shape=FieldShape.VECTOR, labels=("X", "Y", "Z")) for name in MENDED),
            ),
            numbers=(shown,),
        )

    def read(self, raw: FoundFrameMistakeCells, reading: Reading) -> ByName[FoundFrameMistake] | None:
        """Return the answer in numbers."""
        if self.is_empty(raw, reading):
            return None
        return read_by_name(raw, reading, self._read, _lengths)

    def _read(self, raw: FoundFrameMistakeCells, reading: Reading) -> FoundFrameMistake | None:
        last = len(key_frames(reading.instance)) - 1
        shown = str(raw.wrong_frame)[:20]
        frames = range(last + 1)
        frame = self.number(raw.wrong_frame, "wrong_frame", frames, reading, "frame_unknown", given=shown)
        mistake = self.known_name(raw.mistake, reading, FRAME_MISTAKES)
        cells = {name: getattr(raw, name) for name in MENDED if not is_blank(getattr(raw, name))}
        vectors = [read_vector(typed, reading, name) for name, typed in cells.items()]
        if reading.faults:
            return None
        given = [vector for vector in vectors if vector is not None]
        mended = DrawnFrame(*given) if len(given) == len(MENDED) else None
        return FoundFrameMistake(frame=frame, mistake=mistake, mended=mended)

    def grade(self, part: MistakePart, answer: ByName[FoundFrameMistake], context: Context) -> PartReport:
        """Grade place, name and repair, a third each; a repair that works shows the place, too."""
        found, here = planted_in(context.instance), answer.here
        mended = _mends(found, here, context) and _mends_elsewhere(found, answer, context)
        return self.report(
            part,
            FoundStep(mended or here.frame == found.index, here.frame),
            FoundStep(here.mistake == found.code, here.mistake),
            FoundStep(mended, here.mended),
        )

    def right(self, part: MistakePart, context: Context) -> FoundFrameMistakeCells:
        """Return the planted mistake and the frame as it was."""
        found = planted_in(context.instance)
        return _with_frame(FoundFrameMistakeCells(wrong_frame=found.index, mistake=found.code), found.right)

    def left_as_shown(self, right: FoundFrameMistakeCells, instance: Instance) -> FoundFrameMistakeCells:
        """Return the frame as it is drawn."""
        found = planted_in(instance)
        return _with_frame(right, found.shown[found.index])


MOST_PLACES = 360
"""Places among which one is drawn; a multiple of most counts of ways, so that none is drawn more often."""


def _mends(found: PlantedFrame, answer: FoundFrameMistake, context: Context) -> bool:
    """Return whether the frame that was given mends what was planted, in its place."""
    if answer.mended is None:
        return False
    tolerance = context.policy.tolerance
    return mends(
        figure_axes(context.instance),
        context.reference.table.convention,
        found,
        found.index if answer.frame is None else answer.frame,
        answer.mended,
        rounding=min(tolerance.length, tolerance.angle),
    )


def _mends_elsewhere(found: PlantedFrame, answer: ByName[FoundFrameMistake], context: Context) -> bool:
    """Return whether a frame in names mends the same mistake at other lengths, if they can show it."""
    elsewhere = answer.elsewhere(context)
    if elsewhere is None:
        return True
    named, there = elsewhere
    # a figure that other lengths spoil says nothing
    with suppress(DefinitionError):
        other = planted_in(there.instance)
        if (other.code, other.index) == (found.code, found.index):
            return _mends(other, named, there)
    return True


def _lengths(answer: FoundFrameMistake) -> list[float]:
    """Return the lengths in an answer."""
    frame = answer.mended
    return [] if frame is None else lengths_in_frame(frame.origin, (frame.x, frame.y, frame.z))


LATELY = 64
"""Students whose frames are cached: a page asks for them and for the figure, an answer for both again."""


@lru_cache(maxsize=LATELY)
def planted_in(instance: Instance) -> PlantedFrame:
    """Return the student's frames: the mistake drawn, or the next that these dimensions can show."""
    part = instance.exercise.part(FrameMistakeType.kind)
    assert isinstance(part, MistakePart)
    code, place = instance.drawn[FrameMistakeType.kind]
    ways = _ways(instance)
    first = part.mistakes.index(code)
    order = (*part.mistakes[first:], *part.mistakes[:first], *FRAME_MISTAKES)
    able = next(ways[code] for code in order if code in ways)
    return able[int(place) % len(able)]


def _ways(instance: Instance) -> dict[str, tuple[PlantedFrame, ...]]:
    convention = instance.exercise.reference.table.convention
    return plantable_in_frames(figure_axes(instance), convention, key_frames(instance))


def frames_shown(instance: Instance) -> tuple[DrawnFrame, ...]:
    """Return the frames that are drawn in the figure; none where no mistake in one is asked for."""
    asked = instance.exercise.part(FrameMistakeType.kind) is not None
    return planted_in(instance).shown if asked else ()


def _with_frame(cells: FoundFrameMistakeCells, frame: DrawnFrame) -> FoundFrameMistakeCells:
    vectors = (frame.origin, frame.x, frame.y, frame.z)
    rounded = (tuple(round(value, 6) + 0.0 for value in vector) for vector in vectors)
    typed: dict[str, Any] = dict(zip(MENDED, rounded, strict=True))
    return replace(cells, **typed)


def _text(vector: Vector) -> str:
    return "(" + ", ".join(f"{round(value, DECIMALS) + 0.0:.10g}" for value in vector) + ")"


PART = FrameMistakeType()
