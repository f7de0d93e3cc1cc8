"""One orientation in other notations: matrix, quaternion, axis and angle, angles about current or fixed axes.

What is right is decided by meaning (`kinematics.rotations.orientation_answers`): q and −q, (k, θ) and
(−k, −θ), either triple of angles, full turns; at gimbal lock any triple, and the whole family where all are
asked. Each notation that is asked earns points of its own.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from random import Random
from typing import Any, ClassVar

from exercises.definition import Exercise, Part
from exercises.draws import Draw, Picker, read_draw
from exercises.grading import Feedback, Finding, HelpLevel
from exercises.instance import Instance
from exercises.parts.context import Context
from exercises.parts.first_values import DEGREES, RADIANS, Start
from exercises.parts.protocol import PartType, Reading, RobotFacts
from exercises.parts.report import Credit, Fact, PartReport, judged, told_from
from exercises.parts.rotations.drawn_orientations import drawn_triple, read_sequence, read_triple
from exercises.parts.rotations.orientation_cells import (
    OrientationAnswer,
    OrientationCells,
    OrientationNotation,
    read_orientation,
    rounded,
    written_orientation,
)
from exercises.parts.task import FieldShape, FormField, GivenNumbers, PartTask, choice_field
from exercises.reading import Reader
from kinematics.poses import axis_angle_from_transform, quaternion_from_transform
from kinematics.rotations.matrices import Matrix3, Triple, as_transform
from kinematics.rotations.orientation_answers import (
    USUAL_TOLERANCE,
    judge_axis_angle,
    judge_family,
    judge_matrix,
    judge_quaternion,
    judge_triples,
)
from kinematics.rotations.orientation_verdicts import (
    RIGHT,
    Built,
    ComponentOrder,
    OrientationVerdict,
    RotationMistake,
)
from kinematics.rotations.sequences import Combination, EulerSequence
from kinematics.se3 import triple


@dataclass(frozen=True, kw_only=True, slots=True)
class OrientationPart(Part):
    """One orientation, given in one notation and asked in others.

    Attributes:
        sequence: about which axes the given angles turn.
        angles: the given angles where no seed is given [the exercise's unit].
        turns: from where a student's own are drawn.
        middle: from where the middle one is drawn, if not from `turns`.
        given: in which notation students see it.
        ask: the notations that are asked.
        asked_sequence: about which axes the asked angles turn.
        tolerance: largest error [rad], see `kinematics.rotations.orientation_answers`.
    """

    sequence: EulerSequence
    angles: tuple[Fraction, ...]
    turns: Draw | None
    middle: Draw | None
    given: OrientationNotation
    ask: tuple[OrientationNotation, ...]
    asked_sequence: EulerSequence
    tolerance: float


class OrientationPartType(PartType[OrientationPart, OrientationCells, OrientationAnswer]):
    """An orientation in other notations."""

    kind = "orientation"
    raw: ClassVar = OrientationCells
    meaning = "the orientation of the task in the notations that are asked"
    disclosures: ClassVar = {
        **told_from(HelpLevel.ROW, "orientation_wrong"),
        **told_from(HelpLevel.REPAIR, *(f"rotation_{mistake.value}" for mistake in RotationMistake)),
    }

    def define(self, reader: Reader, points: Fraction, robot: RobotFacts) -> OrientationPart:
        """Return the part with its angles and what is asked."""
        given = reader.choice("given", OrientationNotation, OrientationNotation.ANGLES)
        sequence = read_sequence(reader, "axes", "turning", EulerSequence(axes="ZYX"))
        angles, turns, middle = read_triple(reader), read_draw(reader, "turns"), read_draw(reader, "middle")
        asked = reader.choices("ask", OrientationNotation)
        if not asked:
            reader.fault("nothing_asked", "ask")
        return OrientationPart(
            kind=self.kind,
            points=points,
            sequence=sequence,
            angles=angles,
            turns=turns,
            middle=middle,
            given=given,
            ask=_without_repetition(asked),
            asked_sequence=read_sequence(reader, "asked_axes", "asked_turning", sequence),
            tolerance=reader.tolerance("tolerance", USUAL_TOLERANCE),
        )

    def warnings(self, part: OrientationPart, exercise: Exercise) -> Iterable[str]:
        """Return a code where a notation is asked in which the orientation is shown."""
        angles = part.given in (OrientationNotation.ANGLES, OrientationNotation.EVERY_TRIPLE)
        shown = OrientationNotation.ANGLES if angles else part.given
        same = shown in part.ask and not (angles and part.asked_sequence != part.sequence)
        return ("asked_as_shown",) if same else ()

    def start(self, robot: RobotFacts) -> Start:
        """Return an orientation in roll, pitch and yaw, of which the matrix is asked."""
        return {
            "angles": list(DEGREES[:3] if robot.degrees else RADIANS[:3]),
            "ask": [OrientationNotation.MATRIX.value],
        }

    def draw(self, part: OrientationPart, exercise: Exercise, picker: Picker) -> Triple:
        """Return the student's angles [rad]."""
        ways = (part.turns, part.middle or part.turns, part.turns)
        return drawn_triple(exercise, picker, part.angles, ways, self.kind)

    def task(self, part: OrientationPart, instance: Instance) -> PartTask:
        """Show the orientation and ask for the others."""
        unit = instance.exercise.angle_unit.sign
        return PartTask(
            message="task-orientation",
            values={
                "given": part.given.value,
                "axes": " ".join(part.sequence.axes),
                "turning": part.sequence.turning.value,
                "asked_axes": " ".join(part.asked_sequence.axes),
                "asked_turning": part.asked_sequence.turning.value,
                "ask": "every"
                if OrientationNotation.EVERY_TRIPLE in part.ask
                else "one"
                if OrientationNotation.ANGLES in part.ask
                else "none",
            },
            form=tuple(_fields(part, unit)),
            numbers=(_given(part, instance, unit),),
        )

    def read(self, raw: OrientationCells, reading: Reading) -> OrientationAnswer | None:
        """Return the notations in numbers."""
        part: Any = reading.instance.exercise.part(self.kind)
        return read_orientation(raw, part.ask, reading)

    def grade(self, part: OrientationPart, answer: OrientationAnswer, context: Context) -> PartReport:
        """Judge notation by notation; each counts the same."""
        built = Built(sequence=part.sequence, angles=context.instance.drawn[self.kind])
        facts: list[Fact] = []
        feedback: list[Feedback] = []
        total = 0.0
        for notation in part.ask:
            found = _judged(part, notation, answer, built)
            if found is None:
                facts.append(Fact(where=(_place(notation),), finding=Finding.MISSING))
                feedback.append(Feedback(code="orientation_missing", params={"notation": notation.value}))
                continue
            total += found.share
            finding = Finding.OK if found.right else Finding.WRONG
            facts.append(Fact(where=(_place(notation),), finding=finding))
            if not found.right:
                feedback.append(Feedback(code="orientation_wrong", params={"notation": notation.value}))
                feedback += [Feedback(code=f"rotation_{mistake.value}") for mistake in found.mistakes]
        score = total / len(part.ask)
        if score == 1.0:
            feedback.append(Feedback(code="orientation_right"))
        return judged(part, score, Credit.KEY, facts=facts, feedback=feedback)

    def right(self, part: OrientationPart, context: Context) -> OrientationCells:
        """Return every notation that is asked, rounded as on paper."""
        instance = context.instance
        rotation = part.sequence.matrix(instance.drawn[self.kind])
        return written_orientation(rotation, part.ask, part.asked_sequence, instance)

    def wrong(
        self, part: OrientationPart, context: Context, rng: Random
    ) -> Iterator[tuple[str, OrientationCells]]:
        """Yield one notation transposed, one with a component changed."""
        right = self.right(part, context)
        if right.matrix is not None:
            reflected = triple((row[0], row[1], -float(row[2])) for row in right.matrix)
            yield "rotation_right_handed", replace(right, matrix=reflected)
        if right.quaternion is not None:
            w, x, y, z = (float(cell) for cell in right.quaternion)
            yield "rotation_not_unit", replace(right, quaternion=(2 * w, 2 * x, 2 * y, 2 * z))
        if right.value is not None:
            yield "orientation_wrong", replace(right, value=float(right.value) + 17)
        if right.angles is not None and part.ask == (OrientationNotation.ANGLES,):
            first, middle, last = right.angles[0]
            yield "orientation_wrong", replace(right, angles=((float(first) + 17, middle, last),))


def _without_repetition(asked: Sequence[OrientationNotation]) -> tuple[OrientationNotation, ...]:
    """Return each notation once; one triple is among all of them."""
    both = OrientationNotation.EVERY_TRIPLE in asked
    return tuple(dict.fromkeys(way for way in asked if not (both and way is OrientationNotation.ANGLES)))


def _place(notation: OrientationNotation) -> str:
    """Return the field of the answer that holds a notation."""
    if notation is OrientationNotation.AXIS_ANGLE:
        return "axis"
    return "angles" if notation is OrientationNotation.EVERY_TRIPLE else notation.value


def _fields(part: OrientationPart, unit: str) -> Iterator[FormField]:
    angles = tuple(f"{name} [{unit}]" for name in ("α", "β", "γ"))
    for notation in part.ask:
        match notation:
            case OrientationNotation.MATRIX:
                yield FormField(name="matrix", shape=FieldShape.MATRIX, labels=("", "", ""), rows=3)
            case OrientationNotation.QUATERNION:
                yield choice_field("component_order", ComponentOrder)
                yield FormField(name="quaternion", shape=FieldShape.VECTOR, labels=("1", "2", "3", "4"))
            case OrientationNotation.AXIS_ANGLE:
                yield FormField(name="axis", shape=FieldShape.VECTOR, labels=("x", "y", "z"))
                yield FormField(name="angle", shape=FieldShape.CELL, labels=(f"θ [{unit}]",))
            case OrientationNotation.ANGLES:
                yield FormField(name="angles", shape=FieldShape.LIST, labels=angles, rows=1)
            case OrientationNotation.EVERY_TRIPLE:
                yield FormField(name="angles", shape=FieldShape.LIST, labels=angles, rows=2)
                yield FormField(name="middle", shape=FieldShape.CELL, labels=(angles[1],))
                yield choice_field("combination", Combination)
                yield FormField(name="value", shape=FieldShape.CELL, labels=(f"[{unit}]",))


def _given(part: OrientationPart, instance: Instance, unit: str) -> GivenNumbers:
    drawn: Triple = instance.drawn[part.kind]
    in_unit = instance.exercise.angle_unit.from_radians
    rotation = part.sequence.matrix(drawn)
    pose = as_transform(rotation)
    if part.given is OrientationNotation.MATRIX:
        rows: tuple[tuple[float, ...], ...] = tuple(map(rounded, rotation))
        return GivenNumbers(name="rotation", labels=(), rows=rows)
    if part.given is OrientationNotation.QUATERNION:
        rows = (rounded(quaternion_from_transform(pose)),)
        return GivenNumbers(name="quaternion", labels=("w", "x", "y", "z"), rows=rows)
    if part.given is OrientationNotation.AXIS_ANGLE:
        axis, angle = axis_angle_from_transform(pose)
        rows = (rounded((*axis, in_unit(angle))),)
        return GivenNumbers(name="axis_angle", labels=("x", "y", "z", f"θ [{unit}]"), rows=rows)
    rows = (rounded([in_unit(angle) for angle in drawn]),)
    labels = tuple(f"{name} ({axis}) [{unit}]" for name, axis in zip("αβγ", part.sequence.axes, strict=True))
    return GivenNumbers(name="angles", labels=labels, rows=rows)


def _judged(
    part: OrientationPart, notation: OrientationNotation, answer: OrientationAnswer, built: Built
) -> OrientationVerdict | None:
    """Return what is said of one notation; None if it was not handed in."""
    expected = part.sequence.matrix(built.angles)
    tolerance = part.tolerance
    match notation:
        case OrientationNotation.MATRIX if answer.matrix is not None:
            return judge_matrix(expected, answer.matrix, tolerance, built)
        case OrientationNotation.QUATERNION if answer.quaternion is not None:
            order = answer.component_order or ComponentOrder.SCALAR_FIRST
            return judge_quaternion(expected, answer.quaternion, order, tolerance, built)
        case OrientationNotation.AXIS_ANGLE if answer.axis is not None and answer.angle is not None:
            return judge_axis_angle(expected, answer.axis, answer.angle, tolerance, built)
        case OrientationNotation.ANGLES | OrientationNotation.EVERY_TRIPLE:
            return _judged_angles(part, expected, answer, notation is OrientationNotation.EVERY_TRIPLE)
    return None


def _judged_angles(
    part: OrientationPart, expected: Matrix3, answer: OrientationAnswer, every: bool
) -> OrientationVerdict | None:
    """Return what is said of triples, and of the relation of a family.

    A wrong relation beside right triples leaves half, as do wrong triples beside the right relation.
    """
    found = None
    if answer.angles is not None:
        found = judge_triples(
            expected, part.asked_sequence, answer.angles, every=every, tolerance=part.tolerance
        )
    if answer.family is None or not every:
        return found
    family = judge_family(expected, part.asked_sequence, answer.family, part.tolerance)
    if found is None:
        return family
    if family.right:
        holds = found.right or found.mistakes == (RotationMistake.FAMILY_MISSING,)
        return RIGHT if holds else replace(found, share=0.5)
    locked = RotationMistake.NOT_LOCKED not in family.mistakes
    return replace(family, share=max(family.share, found.share) if locked else 0.5 * found.share)


PART = OrientationPartType()
