"""What a Jacobian in numbers and one in closed form share: what is asked, typed, told and marked."""

from abc import abstractmethod
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from random import Random
from typing import Annotated, Any, ClassVar, TypeVar

import numpy as np

from exercises.definition import Exercise, Part
from exercises.grading import Feedback, Finding, HelpLevel
from exercises.parts.context import Context
from exercises.parts.first_values import joint_names
from exercises.parts.protocol import TABLE, Length, PartType, Reading
from exercises.parts.report import Credit, Disclosure, Fact, PartReport, fact, judged, share_earned, told_from
from exercises.parts.rotations.drawn_orientations import read_sequence
from exercises.parts.task import FieldShape, FormField, choice_field
from exercises.reading import KeyShape, Reader
from kinematics.answers.form_samples import COMPONENTS
from kinematics.answers.jacobian_verdicts import JacobianMistake, JacobianVerdict
from kinematics.answers.screw_answers import ScrewOrder
from kinematics.cells import Cell
from kinematics.errors import JointValueError
from kinematics.jacobian import JacobianFrame
from kinematics.rotations.sequences import EulerSequence
from kinematics.table import JointType

JointRow = Annotated[tuple[Cell, ...], Length(least=1, most=64)]
SixRows = Annotated[tuple[JointRow, ...], Length(least=6, most=6)]


OF_FORCES = (
    JacobianMistake.SIGN,
    JacobianMistake.OTHER_FRAME,
    JacobianMistake.ROWS_EXCHANGED,
    JacobianMistake.SPATIAL,
)
"""What wrong joint forces may look like."""
DISCLOSURES = {
    **told_from(HelpLevel.ROW, "jacobian_wrong", "forces_wrong"),
    **{
        f"jacobian_{mistake.value}": Disclosure(level=HelpLevel.REPAIR)
        for mistake in JacobianMistake
        if mistake is not JacobianMistake.SIGN
    },
    **told_from(HelpLevel.REPAIR, *(f"forces_{mistake.value}" for mistake in OF_FORCES)),
}
"""Help at which each word on a Jacobian, in numbers or in closed form, is said."""


class JacobianAsk(StrEnum):
    """What is asked."""

    JACOBIAN = "jacobian"
    FORCES = "forces"


@dataclass(frozen=True, kw_only=True, slots=True)
class JacobianCells:
    """A Jacobian and joint forces.

    Attributes:
        order: which rows stand first: linear_first (v, ω) or angular_first (ω, v); needed beside a Jacobian.
        jacobian: 6×n, row by row; per radian.
        forces: one for each joint: torque of a revolute one, force of a prismatic one.
    """

    order: ScrewOrder | None = None
    jacobian: SixRows | None = None
    forces: JointRow | None = None


@dataclass(frozen=True, kw_only=True, slots=True)
class JacobianTerms(Part):
    """A Jacobian, joint forces, or both.

    Attributes:
        frame: in whose axes.
        angles: whose rates the analytic Jacobian gives; None for the geometric one.
        tolerance: of an entry that is not proved; where it is a length, as a share of the robot's size.
    """

    frame: JacobianFrame
    angles: EulerSequence | None
    ask: tuple[JacobianAsk, ...]
    tolerance: float


@dataclass(frozen=True, slots=True)
class JacobianScore:
    """What a matrix or forces earn: their share, 0 … 1, what is wrong, and what is said of it."""

    share: float
    facts: tuple[Fact, ...] = ()
    feedback: tuple[Feedback, ...] = ()


def read_terms(reader: Reader, wrench: KeyShape) -> dict[str, Any]:
    """Return what both kinds of these parts say, by the fields of `JacobianTerms`; `wrench` is read by each.

    No axes of angles are named for a geometric Jacobian.
    """
    asked = reader.choices("ask", JacobianAsk, (JacobianAsk.JACOBIAN.value,))
    frame = reader.choice("frame", JacobianFrame, JacobianFrame.BASE)
    angles = None
    if reader.given("axes"):
        angles = read_sequence(reader, "axes", "turning", EulerSequence(axes="ZYX"))
    reader.note("wrench", wrench, COMPONENTS)
    tolerance = reader.tolerance("tolerance", 0.005)
    return {"ask": tuple(dict.fromkeys(asked)), "frame": frame, "angles": angles, "tolerance": tolerance}


def told_question(part: JacobianTerms, *, own: bool) -> dict[str, str]:
    """Return what the sentence of a task says: of the frame, the angles, and whose variables these are."""
    angles = part.angles
    told = {} if angles is None else {"axes": " ".join(angles.axes), "turning": angles.turning.value}
    return {
        **told,
        "frame": part.frame.value,
        "ask": "both" if len(part.ask) > 1 else part.ask[0].value,
        "variables": "own" if own else "given",
    }


def load_labels(exercise: Exercise) -> tuple[str, ...]:
    """Return what columns of force and moment are called: names and units, lengths as in the exercise."""
    arm = exercise.length_unit.value
    return tuple(f"{name} [{'N' if name.startswith('f') else f'N {arm}'}]" for name in COMPONENTS)


def answer_fields(ask: tuple[JacobianAsk, ...], exercise: Exercise) -> tuple[FormField, ...]:
    """Return the fields of an answer, a column for each joint variable; what holds a joint has a unit."""
    types = exercise.reference.table.joint_types
    names = joint_names(len(types))
    fields: list[FormField] = []
    if JacobianAsk.JACOBIAN in ask:
        fields.append(choice_field("order", ScrewOrder))
        fields.append(FormField(name="jacobian", shape=FieldShape.MATRIX, labels=names, rows=6))
    if JacobianAsk.FORCES in ask:
        units = {JointType.PRISMATIC: "N", JointType.REVOLUTE: f"N {exercise.length_unit.value}"}
        held = tuple(f"{name} [{units[kind]}]" for name, kind in zip(names, types, strict=True))
        fields.append(FormField(name="forces", shape=FieldShape.VECTOR, labels=held))
    return tuple(fields)


def is_well_shaped(kind: str, raw: JacobianCells, reading: Reading) -> bool:
    """Keep a fault for each row without an entry for every joint, and where nothing asked is there."""
    part, n = reading.instance.exercise.part(kind), len(reading.joint_types)
    assert isinstance(part, JacobianTerms)
    for i, row in enumerate(raw.jacobian or ()):
        reading.is_row_of(n, row, "jacobian", i)
    if raw.forces is not None:
        reading.is_row_of(n, raw.forces, "forces")
    if raw.jacobian is not None and raw.order is None:
        reading.fault("row_order_missing", "order")
    given = [what for what in JacobianAsk if getattr(raw, what.value) is not None]
    if not given:
        reading.fault("jacobian_empty")
    elif not set(given) & set(part.ask):
        reading.fault("part_not_asked", given[0].value, part=given[0].value, known=part.ask)
    return not reading.faults


Terms = TypeVar("Terms", bound=JacobianTerms)
Answer = TypeVar("Answer")
Scoring = Callable[[JacobianAsk], JacobianScore]


class JacobianType(PartType[Terms, JacobianCells, Answer]):
    """A kind of question about Jacobian and statics.

    Attributes:
        wrench: how a definition writes the wrench.
    """

    raw: ClassVar = JacobianCells
    follows_table = True
    disclosures: ClassVar = DISCLOSURES

    @abstractmethod
    def scoring(self, part: Terms, answer: Answer, context: Context) -> Scoring:
        """Return how an answer is scored that is about as many joints as there are."""

    @abstractmethod
    def opposite(self, forces: tuple[Cell, ...]) -> tuple[Cell, ...] | None:
        """Return joint forces of the other sign; None where they are too small for that to be wrong."""

    def grade(self, part: Terms, answer: Answer, context: Context) -> PartReport:
        """Judge column by column, and force by force; what is asked counts the same."""
        with_table = context.instance.exercise.part(TABLE) is not None
        n = context.reference.table.n_joints
        if with_table and (context.own is None or context.own.table.n_joints != n):
            return judged(part, 0.0, Credit.NONE, feedback=(Feedback(code="jacobian_needs_table"),))
        scoring = self.scoring(part, answer, context)
        scores = [scoring(question) for question in part.ask]
        score = sum(given.share for given in scores) / len(scores)
        feedback = [said for given in scores for said in given.feedback]
        credit = context.own_credit if with_table else Credit.KEY
        if score == 1.0:
            code = "jacobian_right" if credit is Credit.KEY else "jacobian_follows_table"
            feedback.append(Feedback(code=code))
        facts = [fact for given in scores for fact in given.facts]
        return judged(part, score, credit, facts=facts, feedback=feedback)

    def wrong(self, part: Terms, context: Context, rng: Random) -> Iterator[tuple[str, JacobianCells]]:
        """Yield the matrix with its halves exchanged but not so called, and forces of the wrong sign."""
        right = self.right(part, context)
        if right.jacobian is not None:
            yield "jacobian_wrong", replace(right, order=ScrewOrder.ANGULAR_FIRST)
        opposite = None if right.forces is None else self.opposite(right.forces)
        if opposite is not None:
            yield "forces_wrong", replace(right, forces=opposite)


def _missing(what: JacobianAsk) -> JacobianScore:
    """Return the score for what was asked and not handed in."""
    said = Feedback(code="jacobian_missing", params={"what": what.value})
    return JacobianScore(0.0, (Fact(where=(what.value,), finding=Finding.MISSING),), (said,))


def matrix_score(jacobian: Any, judge: Callable[[Any], JacobianVerdict]) -> JacobianScore:
    """Return the score for a matrix, or for none.

    Args:
        judge: finds what is right in it; raises JointValueError where the angles of the student's own arm
            have no rates.
    """
    if jacobian is None:
        return _missing(JacobianAsk.JACOBIAN)
    try:
        found = judge(jacobian)
    except JointValueError:
        return JacobianScore(0.0, (), (Feedback(code="jacobian_angles_locked"),))
    if found.right:
        return JacobianScore(1.0)
    wrong = np.argwhere(~found.entries).tolist()
    columns: dict[JacobianMistake, list[int]] = {}
    for mistake, joint in found.mistakes:
        columns.setdefault(mistake, []).extend([] if joint is None else [joint])
    mistakes = [
        Feedback(
            code=f"jacobian_{mistake.value}",
            params={"joint": next(iter(joints), 0), "joints": tuple(map(str, joints)), "count": len(joints)},
        )
        for mistake, joints in columns.items()
    ]
    return JacobianScore(
        min(found.share, 0.8),
        tuple(fact(False, "jacobian", r, c) for r, c in wrong),
        (Feedback(code="jacobian_wrong"), *mistakes),
    )


def forces_score(
    forces: Any, zeros: Any, judge: Callable[[Any], tuple[Sequence[bool], JacobianMistake | None]]
) -> JacobianScore:
    """Return the score for joint forces, or for none.

    What as many zeros have right earns nothing.
    """
    if forces is None:
        return _missing(JacobianAsk.FORCES)
    right, mistake = judge(forces)
    if all(right):
        return JacobianScore(1.0)
    told = [Feedback(code="forces_wrong")]
    if mistake is not None:
        told.append(Feedback(code=f"forces_{mistake.value}"))
    nothing, _ = judge(zeros)
    return JacobianScore(
        min(share_earned(right, nothing), 0.8),
        tuple(fact(False, "forces", i) for i, good in enumerate(right) if not good),
        tuple(told),
    )
