"""POST /check-dynamics: equations of motion that somebody wrote."""

from dataclasses import replace
from itertools import chain
from typing import Annotated, Any

from pydantic import Field

from kinematics.answers.dynamics_answers import TOLERANCE, judge_dynamics
from kinematics.answers.dynamics_verdicts import DynamicsMistake, DynamicsQuestion, EquationsAnswer
from kinematics.answers.left_open import Rounded
from kinematics.cells import ReadTable
from kinematics.dynamics import rate_name
from kinematics.errors import Fault, JointValueError
from kinematics.expressions import Expression
from kinematics.symbolic import ProofStatus
from service.http.calls import CallRouter
from service.schemas.base import Share, Wire
from service.schemas.choices import forbidding, together
from service.schemas.kinematics.dynamics_request import WeighedRobot
from service.schemas.kinematics.robot_question import NO_ROBOT
from service.schemas.spoken import feedback_sentence
from service.schemas.tables import Cell, Units, units_of
from service.settings import Settings
from service.wire.kinematics.answer_functions import read_row, roundings_of
from service.wire.kinematics.dynamics import parameter_numbers, weighed

EquationRow = Annotated[list[Cell], Field(max_length=16)]
EquationRows = Annotated[list[EquationRow], Field(max_length=16)]


class CheckDynamicsRequest(WeighedRobot):
    """A robot with weights, and equations of motion that somebody wrote as functions of q and dq1 … dqn."""

    model_config = forbidding(*NO_ROBOT, together(without=["M", "C", "h", "g"]))

    M: EquationRows | None = Field(None, description="n×n expressions: the mass matrix")
    C: EquationRows | None = Field(None, description="n×n expressions: any C with the right C q̇")
    h: EquationRow | None = Field(None, description="C q̇; beside C, both are judged")
    g: EquationRow | None = Field(None, description="gravity terms")
    tolerance: Share = Field(TOLERANCE, description="of an entry that is not proved, as a share of its size")


class DynamicsMistakeModel(Wire):
    """A slip that explains a wrong answer."""

    code: DynamicsMistake
    message: str = Field(description="the same in the caller's language")


class CheckDynamicsAnswer(Units):
    """Whether equations of motion are those of the robot."""

    correct: bool = Field(description="all that was given is right, skew-symmetry aside")
    proof: ProofStatus = Field(
        description="proved: the same functions; undecided: equal where compared; refuted: some differ"
    )
    M: list[list[bool]] | None = Field(description="which entries of M are right; null if there was none")
    h: list[bool] | None = Field(description="which rows of C q̇ are right; null if there was neither C nor h")
    skew: bool | None = Field(description="whether Ṁ − 2C is skew-symmetric; null without C")
    g: list[bool] | None = Field(description="which entries of g are right; null if there was none")
    mistakes: list[DynamicsMistakeModel] = Field(description="the usual slips that explain a wrong answer")


router = CallRouter("kinematics")


@router.judge("/check-dynamics", "Are these M, C and g those of the robot?")
def check_dynamics(body: CheckDynamicsRequest, settings: Settings, language: str) -> CheckDynamicsAnswer:
    """Judge M and g entry by entry, and C by C q̇: every C with the right C q̇ is right.

    Exact entries are proved equal as functions, others are compared at many configurations. The answer says
    separately whether Ṁ − 2C is skew-symmetric. Names of lengths are in metres, as in `/dynamics`.
    """
    found = weighed(body, settings)
    question = DynamicsQuestion(
        table=found.metric.table,
        links=found.bodies.links,
        gravity=found.bodies.gravity,
        values=parameter_numbers(found, body.parameters),
    )
    answer = EquationsAnswer(
        mass=_matrix(body.M, found.read, question, "M"),
        coriolis=_matrix(body.C, found.read, question, "C"),
        velocity=None if body.h is None else _row(body.h, found.read, question, "h"),
        gravity=None if body.g is None else _row(body.g, found.read, question, "g"),
    )
    if body.M is body.C is body.h is body.g is None:
        raise JointValueError(Fault.at("motion_empty"))
    answer = replace(answer, rounded=_rounded(body, answer, found.read, question))
    verdict = judge_dynamics(question, answer, body.tolerance)
    return CheckDynamicsAnswer(
        **units_of(found.read),
        correct=verdict.right,
        proof=verdict.proof,
        M=None if verdict.mass is None else [list(row) for row in verdict.mass],
        h=None if verdict.velocity is None else list(verdict.velocity),
        skew=verdict.skew,
        g=None if verdict.gravity is None else list(verdict.gravity),
        mistakes=[
            DynamicsMistakeModel(code=mistake, message=feedback_sentence(f"motion_{mistake.value}", language))
            for mistake in verdict.mistakes
        ],
    )


def _matrix(
    rows: list[list[Any]] | None, read: ReadTable, question: DynamicsQuestion, name: str
) -> tuple[tuple[Expression, ...], ...] | None:
    if rows is None:
        return None
    expected = question.table.n_joints
    if len(rows) != expected:
        raise JointValueError(Fault.at("motion_row_count", name, expected=expected, given=len(rows)))
    return tuple(_row(row, read, question, name, i) for i, row in enumerate(rows))


def _row(
    cells: list[Any], read: ReadTable, question: DynamicsQuestion, *where: str | int
) -> tuple[Expression, ...]:
    return read_row(cells, question.table.n_joints, read, _known(question), where)


def _known(question: DynamicsQuestion) -> set[str]:
    return {*question.values, *_rates(question)}


def _rates(question: DynamicsQuestion) -> list[str]:
    return [rate_name(joint) for joint in range(1, question.table.n_joints + 1)]


def _rounded(
    body: CheckDynamicsRequest, answer: EquationsAnswer, read: ReadTable, question: DynamicsQuestion
) -> Rounded:
    """Return what entries with names are with each of their decimals moved by half a unit of its last."""
    typed = [*(body.M or ()), *(body.C or ()), *(row for row in (body.h, body.g) if row is not None)]
    meant = [*(answer.mass or ()), *(answer.coriolis or ())]
    meant += [row for row in (answer.velocity, answer.gravity) if row is not None]
    return roundings_of(
        chain.from_iterable(typed), chain.from_iterable(meant), read, _known(question), _rates(question)
    )
