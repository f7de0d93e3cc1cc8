"""Is a matrix a rotation, and if not, which property fails? Any property that fails is a right reason."""

from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum
from fractions import Fraction
from random import Random
from typing import ClassVar

from exercises.definition import Exercise, Part
from exercises.draws import Draw, Picker, read_draw
from exercises.grading import Feedback, HelpLevel
from exercises.instance import Instance
from exercises.parts.cells.number_cells import DECIMALS
from exercises.parts.context import Context
from exercises.parts.first_values import DEGREES, RADIANS, Start
from exercises.parts.protocol import PartType, Reading, RobotFacts
from exercises.parts.report import Credit, PartReport, fact, judged, told_from
from exercises.parts.rotations.drawn_orientations import drawn_triple, read_sequence, read_triple
from exercises.parts.task import GivenNumbers, PartTask, choice_field
from exercises.reading import Reader
from kinematics.rotations.matrices import Matrix3, matrix3
from kinematics.rotations.properties import RotationProperty, failed_properties
from kinematics.rotations.sequences import EulerSequence

TOLERANCE = 0.01
"""Of lengths and cosines of columns: four decimals stay far below it, every planted defect far above."""


class RotationClaim(StrEnum):
    """What a student says of a matrix: a rotation, or the property of rotations that fails."""

    ROTATION = "rotation"
    UNIT_COLUMNS = RotationProperty.UNIT_COLUMNS.value
    PERPENDICULAR_COLUMNS = RotationProperty.PERPENDICULAR_COLUMNS.value
    RIGHT_HANDED = RotationProperty.RIGHT_HANDED.value


@dataclass(frozen=True, kw_only=True, slots=True)
class RotationClaimCells:
    """What is said of the matrix.

    Attributes:
        claim: it is a rotation, or the property that fails: columns of length 1 (unit_columns), at right
            angles (perpendicular_columns), right-handed (right_handed).
    """

    claim: RotationClaim


@dataclass(frozen=True, kw_only=True, slots=True)
class RotationCheckPart(Part):
    """A matrix of which a student says whether it is a rotation.

    Attributes:
        sequence: of the angles that it is made from.
        angles: where no seed is given [the exercise's unit].
        turns: from where a student's own are drawn.
    """

    sequence: EulerSequence
    angles: tuple[Fraction, ...]
    turns: Draw | None


class RotationCheckType(PartType[RotationCheckPart, RotationClaimCells, RotationClaim]):
    """Rotation or not, and why not."""

    kind = "rotation_check"
    raw: ClassVar = RotationClaimCells
    meaning = "whether the matrix of the task is a rotation, or the property that fails"
    disclosures: ClassVar = told_from(
        HelpLevel.KIND, "claim_not_rotation", "claim_rotation", "claim_other_property"
    )

    def define(self, reader: Reader, points: Fraction, robot: RobotFacts) -> RotationCheckPart:
        """Return the part with the angles of its matrix."""
        return RotationCheckPart(
            kind=self.kind,
            points=points,
            sequence=read_sequence(reader, "axes", "turning", EulerSequence(axes="ZYX")),
            angles=read_triple(reader),
            turns=read_draw(reader, "turns"),
        )

    def start(self, robot: RobotFacts) -> Start:
        """Return the angles of its matrix."""
        return {"angles": list(DEGREES[:3] if robot.degrees else RADIANS[:3])}

    def draw(self, part: RotationCheckPart, exercise: Exercise, picker: Picker) -> Matrix3:
        """Return the student's matrix: a rotation, or one with a planted defect."""
        triple = drawn_triple(exercise, picker, part.angles, (part.turns,) * 3, "rotation_check")
        claim = picker.choice(tuple(RotationClaim)[::-1], "rotation_check claim")
        return planted(part.sequence.matrix(triple), claim, picker.choice((2, 0, 1), "rotation_check column"))

    def task(self, part: RotationCheckPart, instance: Instance) -> PartTask:
        """Show the matrix."""
        rows = tuple(tuple(row) for row in instance.drawn[self.kind])
        return PartTask(
            message="task-rotation-check",
            form=(choice_field("claim", RotationClaim, "matrix_claim"),),
            numbers=(GivenNumbers(name="matrix", labels=(), rows=rows),),
        )

    def read(self, raw: RotationClaimCells, reading: Reading) -> RotationClaim:
        """Return the claim."""
        return raw.claim

    def grade(self, part: RotationCheckPart, answer: RotationClaim, context: Context) -> PartReport:
        """Accept what is true of the matrix."""
        failed = {found.value for found in failed_properties(context.instance.drawn[self.kind], TOLERANCE)}
        right = answer.value in failed or (answer is RotationClaim.ROTATION and not failed)
        if right:
            code = "claim_right"
        elif not failed:
            code = "claim_rotation"
        else:
            code = "claim_not_rotation" if answer is RotationClaim.ROTATION else "claim_other_property"
        return judged(
            part, float(right), Credit.KEY, facts=(fact(right, "claim"),), feedback=(Feedback(code=code),)
        )

    def right(self, part: RotationCheckPart, context: Context) -> RotationClaimCells:
        """Return the first property that fails, or that none does."""
        failed = failed_properties(context.instance.drawn[self.kind], TOLERANCE)
        return RotationClaimCells(claim=RotationClaim(failed[0].value) if failed else RotationClaim.ROTATION)

    def wrong(
        self, part: RotationCheckPart, context: Context, rng: Random
    ) -> Iterator[tuple[str, RotationClaimCells]]:
        """Yield every claim that is not true."""
        failed = {found.value for found in failed_properties(context.instance.drawn[self.kind], TOLERANCE)}
        for claim in RotationClaim:
            if claim is RotationClaim.ROTATION and failed:
                yield "claim_not_rotation", RotationClaimCells(claim=claim)
            elif claim is not RotationClaim.ROTATION and claim.value not in failed:
                code = "claim_other_property" if failed else "claim_rotation"
                yield code, RotationClaimCells(claim=claim)


def planted(rotation: Matrix3, claim: RotationClaim, column: int) -> Matrix3:
    """Return a rotation with one property spoilt, rounded as it is shown; as it is for the claim `rotation`.

    No other property fails than that of the claim.
    """
    columns = [list(entries) for entries in zip(*rotation, strict=True)]
    chosen, next_one = columns[column], columns[(column + 1) % 3]
    match claim:
        case RotationClaim.UNIT_COLUMNS:
            columns[column] = [1.2 * value for value in chosen]
        case RotationClaim.PERPENDICULAR_COLUMNS:
            columns[column] = [0.8 * a + 0.6 * b for a, b in zip(chosen, next_one, strict=True)]
        case RotationClaim.RIGHT_HANDED:
            columns[column] = [-value for value in chosen]
        case RotationClaim.ROTATION:
            pass
    return matrix3([[round(value, DECIMALS) + 0.0 for value in row] for row in zip(*columns, strict=True)])


PART = RotationCheckType()
