"""Chains of frames: the pose of one frame in another, from poses that are known.

The frames are those of the key, at joint values that are drawn; what is known and what is asked are pairs of
them. There is one right matrix: both frames are named.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from random import Random
from typing import ClassVar

from exercises.definition import Exercise, Part
from exercises.draws import Picker
from exercises.grading import Feedback, HelpLevel
from exercises.instance import Instance
from exercises.parts.cells.by_name import ByName, read_by_name
from exercises.parts.cells.matrix_cells import CellMatrix, read_numbers
from exercises.parts.cells.number_cells import on_paper
from exercises.parts.context import Context
from exercises.parts.first_values import Start, usual_joints
from exercises.parts.joint_draws import JointDraws, key_frames, read_joints
from exercises.parts.protocol import PartType, Reading, RobotFacts
from exercises.parts.report import Credit, PartReport, fact, judged, told_from
from exercises.parts.task import FieldShape, FormField, GivenNumbers, PartTask
from exercises.reading import KeyShape, Reader
from kinematics.errors import Fault
from kinematics.rotations.frame_chains import ChainFactor, ChainMistake, chain_product, judge_chain
from kinematics.se3 import Floats, inverse_transform

Pair = tuple[int, int]
AS_SHOWN = 5e-4  # A share: how exactly a pose follows from others of which so many decimals are shown.


@dataclass(frozen=True, kw_only=True, slots=True)
class FrameChainCells:
    """The pose that is asked.

    Attributes:
        pose: 4×4, row by row; lengths in the exercise's unit.
    """

    pose: CellMatrix


@dataclass(frozen=True, kw_only=True, slots=True)
class FrameChainPart(Part):
    """Known poses of frames, and one that follows from them.

    Attributes:
        joints: of the configuration.
        known: (a, b) of each known pose of frame b in frame a.
        asked: (a, b) of the pose that is asked.
        path: the known poses on the way from a to b, and whether each is walked against its sense.
        tolerance: largest error of a direction cosine, and of a position as a share of the robot's size.
    """

    joints: JointDraws
    known: tuple[Pair, ...]
    asked: Pair
    path: tuple[tuple[int, bool], ...]
    tolerance: float


class FrameChainType(PartType[FrameChainPart, FrameChainCells, ByName[Floats]]):
    """{}^A T_B from other poses."""

    kind = "frame_chain"
    raw: ClassVar = FrameChainCells
    meaning = "the pose of one frame in another, in numbers"
    disclosures: ClassVar = {
        **told_from(HelpLevel.ROW, "chain_wrong", "chain_rotation_right", "chain_position_right"),
        **told_from(HelpLevel.REPAIR, *(f"chain_{mistake.value}" for mistake in ChainMistake)),
    }

    def define(self, reader: Reader, points: Fraction, robot: RobotFacts) -> FrameChainPart:
        """Return the part with its joint values and frames."""
        joints = read_joints(reader, robot, single=False)
        reader.note("known", KeyShape.FRAME_PAIRS)
        reader.note("asked", KeyShape.FRAMES)
        known = tuple(_pair(inner) for inner in reader.entries("known"))
        asked = _pair(reader.table("asked", needed=True))
        path = path_between(known, asked)
        if path is None:
            reader.fault("frames_not_connected", "asked", start=asked[0], end=asked[1])
        return FrameChainPart(
            kind=self.kind,
            points=points,
            joints=joints,
            known=known,
            asked=asked,
            path=path or (),
            tolerance=reader.tolerance("tolerance", 0.005),
        )

    def start(self, robot: RobotFacts) -> Start:
        """Return two known poses, and the one that leads from the first frame to the last."""
        return {
            "joints": usual_joints(robot),
            "known": [{"from": 0, "to": 1}, {"from": 1, "to": len(robot.joint_types)}],
            "asked": {"from": 0, "to": len(robot.joint_types)},
        }

    def inconsistencies(self, part: FrameChainPart, exercise: Exercise) -> Iterator[Fault]:
        """Yield the frames that the key does not have."""
        last = len(exercise.reference.table.rows)
        pairs: list[tuple[tuple[str | int, ...], Pair]]
        pairs = [(("known", i), pair) for i, pair in enumerate(part.known)] + [(("asked",), part.asked)]
        for where, pair in pairs:
            if not all(0 <= frame <= last for frame in pair):
                yield Fault.at("unknown_frame", *where, last=last)

    def warnings(self, part: FrameChainPart, exercise: Exercise) -> Iterable[str]:
        """Return a code where the asked pose is a known one."""
        return ("asked_as_shown",) if part.asked in part.known else ()

    def draw(self, part: FrameChainPart, exercise: Exercise, picker: Picker) -> tuple[Fraction, ...]:
        """Return the student's joint values [the exercise's units]."""
        return part.joints.drawn(picker, self.kind)

    def task(self, part: FrameChainPart, instance: Instance) -> PartTask:
        """Show the known poses and ask for one."""
        shown = tuple(
            GivenNumbers(
                name="frame-pose",
                labels=(),
                rows=tuple(tuple(row) for row in pose.tolist()),
                values={"start": a, "end": b},
            )
            for (a, b), pose in zip(part.known, _known(part, instance), strict=True)
        )
        start, end = part.asked
        return PartTask(
            message="task-frame-chain",
            values={"start": start, "end": end, "unit": instance.exercise.length_unit.value},
            form=(FormField(name="pose", shape=FieldShape.MATRIX, labels=("x", "y", "z", "p"), rows=4),),
            numbers=shown,
        )

    def read(self, raw: FrameChainCells, reading: Reading) -> ByName[Floats] | None:
        """Return (4, 4) numbers."""
        return read_by_name(raw, reading, self._read, lambda pose: pose[:3, 3].tolist())

    def _read(self, raw: FrameChainCells, reading: Reading) -> Floats | None:
        return read_numbers(raw.pose, reading, "pose")

    def grade(self, part: FrameChainPart, answer: ByName[Floats], context: Context) -> PartReport:
        """Judge a pose at the student's lengths and, if it is right there and in names, at others."""
        report = self._judged(part, answer.here, context)
        elsewhere = answer.elsewhere(context) if report.correct else None
        if elsewhere is None:
            return report
        named, there = elsewhere
        exact = there.policy.tolerance.length
        if exact < context.policy.tolerance.length:  # the decimals of the answer leave less than usual
            part = replace(part, tolerance=min(part.tolerance, max(exact, AS_SHOWN)))
        return self._judged(part, named, there)

    def _judged(self, part: FrameChainPart, answer: Floats, context: Context) -> PartReport:
        """Judge a pose: its rotation and its position count half each."""
        factors = _factors(part, context.instance)
        found = judge_chain(factors, answer, size=context.size / context.unit_ratio, tolerance=part.tolerance)
        facts = [
            fact(good, "pose", r, c) for r, row in enumerate(found.entries) for c, good in enumerate(row)
        ]
        feedback = [Feedback(code="chain_right" if found.right else "chain_wrong")]
        if found.rotation != found.position:
            feedback.append(
                Feedback(code="chain_rotation_right" if found.rotation else "chain_position_right")
            )
        feedback += [Feedback(code=f"chain_{mistake.value}") for mistake in found.mistakes]
        score = 0.5 * (found.rotation + found.position)
        return judged(part, score, Credit.KEY, facts=facts, feedback=feedback)

    def right(self, part: FrameChainPart, context: Context) -> FrameChainCells:
        """Return the product of the known poses, rounded as on paper."""
        return _cells(chain_product(_factors(part, context.instance)))

    def wrong(
        self, part: FrameChainPart, context: Context, rng: Random
    ) -> Iterator[tuple[str, FrameChainCells]]:
        """Yield the pose with another position."""
        pose = chain_product(_factors(part, context.instance)).copy()
        pose[0, 3] += context.size / context.unit_ratio
        yield "chain_wrong", _cells(pose)


def path_between(known: Sequence[Pair], asked: Pair) -> tuple[tuple[int, bool], ...] | None:
    """Return the shortest way from one frame to another along known poses; None if there is none.

    Returns:
        (index of the pose, whether it is inverted) from the first frame to the last.
    """
    start, end = asked
    ways: dict[int, tuple[tuple[int, bool], ...]] = {start: ()}
    pending = [start]
    while pending:
        frame = pending.pop(0)
        for i, (a, b) in enumerate(known):
            for here, there, inverted in ((a, b, False), (b, a, True)):
                if here == frame and there not in ways:
                    ways[there] = (*ways[frame], (i, inverted))
                    pending.append(there)
    return ways.get(end) or None


def _pair(reader: Reader) -> Pair:
    pair = reader.integer("from"), reader.integer("to")
    reader.finish()
    return pair


def _known(part: FrameChainPart, instance: Instance) -> list[Floats]:
    """Return the known poses as they are shown."""
    frames = key_frames(instance, instance.drawn[part.kind])
    return [on_paper(inverse_transform(frames[a]) @ frames[b]) for a, b in part.known]


def _factors(part: FrameChainPart, instance: Instance) -> list[ChainFactor]:
    known = _known(part, instance)
    return [ChainFactor(pose=known[i], inverted=inverted) for i, inverted in part.path]


def _cells(pose: Floats) -> FrameChainCells:
    cells: CellMatrix = on_paper(pose).tolist()
    return FrameChainCells(pose=cells)


PART = FrameChainType()
