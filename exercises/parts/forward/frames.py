"""The student's frames, placed in the figure: right if they obey a convention's rules and keep the policy.

Every valid assignment is accepted: what counts are the rules of `kinematics.frames.rules`, and the table that
follows from the frames is graded like any other. The facts that earn points are independent of one another:
for each frame its z, its origin and its x.
"""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from random import Random
from typing import Annotated, ClassVar

from exercises.definition import Part
from exercises.errors import DefinitionError
from exercises.grading import ConventionRule, Feedback, Finding, HelpLevel, Policy, ToolRule, is_accepted
from exercises.instance import Instance
from exercises.parts.cells.by_name import ByName, read_by_name
from exercises.parts.context import Context
from exercises.parts.forward.figure_frames import (
    figure_axes,
    figure_coordinates,
    key_frames,
    lengths_in_frame,
    read_vector,
)
from exercises.parts.protocol import Length, PartType, Reading
from exercises.parts.report import Credit, Fact, PartReport, fact, judged, share_earned, told_from
from exercises.parts.task import PartTask
from kinematics.cells import Cell, ReadTable
from kinematics.frames.axes import JointAxis
from kinematics.frames.chosen_frames import ChosenFrame
from kinematics.frames.exactness import exact_table
from kinematics.frames.rules import BINDING, FrameFinding
from kinematics.frames.trainer import rules_and_table
from kinematics.frames.wrong_frames import DrawnFrame
from kinematics.se3 import triple
from kinematics.table import Convention, NumericTable

PARTS = ("z", "origin", "x")  # The independent facts of a frame.


@dataclass(frozen=True, kw_only=True, slots=True)
class FrameCells:
    """A frame in the figure.

    Attributes:
        origin: its origin, in the coordinates of the figure and the exercise's length unit.
        x: direction of its x axis; any length but zero.
        z: direction of its z axis; any length but zero.
    """

    origin: tuple[Cell, Cell, Cell]
    x: tuple[Cell, Cell, Cell]
    z: tuple[Cell, Cell, Cell]


@dataclass(frozen=True, kw_only=True, slots=True)
class FramesCells:
    """Frames 0 … N, in the position that the figure shows.

    Attributes:
        convention: whose rules they follow.
        frames: frame 0 … N; null for one that has not been placed.
    """

    convention: Convention
    frames: Annotated[tuple[FrameCells | None, ...], Length(least=1, most=65)]


@dataclass(frozen=True, kw_only=True, slots=True)
class FramesAnswer:
    """Frames 0 … N in numbers; lengths in the exercise's unit."""

    convention: Convention
    frames: tuple[ChosenFrame | None, ...]


class FramesPart(PartType[Part, FramesCells, ByName[FramesAnswer]]):
    """Frames on the robot of the figure."""

    kind = "frames"
    raw: ClassVar = FramesCells
    meaning = "frames 0 … N, placed in the figure"
    disclosures: ClassVar = {
        **told_from(HelpLevel.ROW, "frame_wrong", "frame_missing", "frames_not_as_asked"),
        **told_from(HelpLevel.KIND, *(f"frame_{rule.value}" for rule in BINDING), instead="frame_wrong"),
        **told_from(HelpLevel.REPAIR, "frames_other_convention"),
    }

    def task(self, part: Part, instance: Instance) -> PartTask:
        """Ask for a frame on every link."""
        exercise = instance.exercise
        values = {"n": exercise.reference.table.n_joints, "unit": exercise.length_unit.value}
        return PartTask(message="task-frames", values={**values, **figure_coordinates(instance)})

    def read(self, raw: FramesCells, reading: Reading) -> ByName[FramesAnswer] | None:
        """Return the frames in numbers."""
        return read_by_name(raw, reading, self._read, _lengths)

    def _read(self, raw: FramesCells, reading: Reading) -> FramesAnswer | None:
        n = reading.instance.exercise.reference.table.n_joints
        if len(raw.frames) != n + 1:
            reading.fault("frames_count", "frames", expected=n + 1, given=len(raw.frames))
        rule = reading.instance.exercise.policy.convention
        if rule is not ConventionRule.ANY and rule.value != raw.convention.value:
            reading.fault("convention_not_asked", "convention", asked=rule.value)
        frames = tuple(
            None if frame is None else _read_frame(frame, reading, i) for i, frame in enumerate(raw.frames)
        )
        return None if reading.faults else FramesAnswer(convention=raw.convention, frames=frames)

    def grade(self, part: Part, answer: ByName[FramesAnswer], context: Context) -> PartReport:
        """Judge an answer at the student's lengths and, if it is right there and in names, at others."""
        report = self._judged(part, answer.here, context)
        elsewhere = answer.elsewhere(context) if report.correct else None
        # a figure that other lengths spoil says nothing
        with suppress(DefinitionError):
            return self._judged(part, *elsewhere) if elsewhere else report
        return report

    def _judged(self, part: Part, answer: FramesAnswer, context: Context) -> PartReport:
        """Judge frame by frame: z, origin and x count the same, and so does what the policy asks for."""
        axes = figure_axes(context.instance)
        found, table = _checked(context, axes, answer)
        facts: list[Fact] = []
        feedback: list[Feedback] = []
        for i, (broken, chosen) in enumerate(zip(found, answer.frames, strict=True)):
            wrong = {entry.part.value for entry in broken}
            for name in PARTS:
                finding = Finding.MISSING if chosen is None else Finding.OK
                finding = Finding.WRONG if name in wrong else finding
                facts.append(Fact(where=("frames", i, name), finding=finding))
            number = {"frame": i}
            if chosen is None:
                feedback.append(Feedback(code="frame_missing", params=number))
            feedback += [
                Feedback(code=f"frame_{entry.rule.value}", params={**number, **entry.params})
                for entry in broken
            ]
        if feedback and _follows_other_convention(context, axes, answer):
            feedback.insert(0, Feedback(code="frames_other_convention"))
        if not feedback:
            kept = _keeps_policy(context, table)
            facts.append(fact(kept, "policy"))
            feedback.append(Feedback(code="frames_right" if kept else "frames_not_as_asked"))
        else:
            facts.append(Fact(where=("policy",), finding=Finding.UNKNOWN))
        right = [fact.finding is Finding.OK for fact in facts]
        score = 1.0
        if not all(right):
            score = share_earned(right, [*_right_for_nothing(context, axes, answer), False])
        return judged(part, score, Credit.KEY, facts=facts, feedback=feedback)

    def right(self, part: Part, context: Context) -> FramesCells:
        """Return the frames of the key where it has one for each joint, else those of the procedure."""
        instance = context.instance
        reference = instance.exercise.reference.table
        frames = tuple(_cells(frame) for frame in key_frames(instance))
        return FramesCells(convention=reference.convention, frames=frames)

    def wrong(self, part: Part, context: Context, rng: Random) -> Iterator[tuple[str, FramesCells]]:
        """Yield the frames with one that is missing, and with one z that lies along no axis."""
        right = self.right(part, context)
        i = rng.randrange(len(right.frames))
        yield "frame_missing", replace(right, frames=(*right.frames[:i], None, *right.frames[i + 1 :]))
        modified = right.convention is Convention.MODIFIED
        k = rng.randrange(1, len(right.frames)) if modified else rng.randrange(len(right.frames) - 1)
        frame = right.frames[k]
        assert frame is not None
        tilted = replace(frame, z=frame.x, x=frame.z)
        frames = (*right.frames[:k], tilted, *right.frames[k + 1 :])
        yield "frame_z_not_along_axis", replace(right, frames=frames)


def _lengths(answer: FramesAnswer) -> list[float]:
    """Return the lengths in an answer."""
    frames = filter(None, answer.frames)
    return [
        value
        for frame in frames
        for value in lengths_in_frame(frame.origin or (), (frame.x or (), frame.z or ()))
    ]


def _read_frame(frame: FrameCells, reading: Reading, i: int) -> ChosenFrame:
    place = "frames", i
    return ChosenFrame(**{name: read_vector(getattr(frame, name), reading, *place, name) for name in PARTS})


def _checked(
    context: Context, axes: Sequence[JointAxis], answer: FramesAnswer
) -> tuple[list[list[FrameFinding]], NumericTable | None]:
    """Return the rules that each frame breaks, and the table that follows."""
    tolerance = context.policy.tolerance
    rounding = min(tolerance.length, tolerance.angle)
    return rules_and_table(axes, answer.convention, answer.frames, rounding=rounding)


def _right_for_nothing(context: Context, axes: Sequence[JointAxis], answer: FramesAnswer) -> list[bool]:
    """Return which facts of the frames are right if each is put where the figure's coordinates begin."""
    untouched = ChosenFrame(origin=(0.0, 0.0, 0.0), x=(1.0, 0.0, 0.0), z=(0.0, 0.0, 1.0))
    found, _ = _checked(context, axes, replace(answer, frames=(untouched,) * len(answer.frames)))
    return [name not in {entry.part.value for entry in broken} for broken in found for name in PARTS]


def _follows_other_convention(context: Context, axes: Sequence[JointAxis], answer: FramesAnswer) -> bool:
    """Return whether the frames obey the rules of the convention that was not named."""
    other = answer.convention.other
    if any(frame is None for frame in answer.frames):
        return False
    return not any(_checked(context, axes, replace(answer, convention=other))[0])


def _keeps_policy(context: Context, table: NumericTable | None) -> bool:
    """Return whether the table that follows from the frames is the robot's under the policy."""
    if table is None:
        return False
    reference = context.reference
    read = ReadTable(
        table=exact_table(table),
        angle_unit=reference.angle_unit,
        length_unit=reference.length_unit,
        parameters={},
    )
    return is_accepted(reference, read, _policy(context), context.parameters)


def _policy(context: Context) -> Policy:
    """Return what the frames are held to.

    Where the key needs a fixed row, the last frame of a joint cannot lie at the tool, and need not.
    """
    table = context.reference.table
    whole = len(table.rows) == table.n_joints
    return context.policy if whole else replace(context.policy, tool=ToolRule.FREE)


def _cells(frame: DrawnFrame) -> FrameCells:
    return FrameCells(**{name: triple(round(v, 6) for v in getattr(frame, name)) for name in PARTS})


PART = FramesPart()
