"""POST /inverse-kinematics with "form": "symbolic" on the wire."""

from typing import Annotated, Any, Literal

from pydantic import ConfigDict, Discriminator, Field, Tag

from kinematics.inverse_forms import ConditionKind, InverseQuantity, InverseReach
from kinematics.printing import Notation
from kinematics.printing.formats import EquationFormat
from service.http.validation import CHOICE
from service.schemas.base import LONGEST_LIST, OneOf, Wire
from service.schemas.kinematics.inverse_kinematics import NumericInverseKinematicsRequest
from service.schemas.kinematics.robot_question import PlacedRobotQuestion
from service.schemas.kinematics.written_matrices import SomeParameters
from service.schemas.tables import Units


class SymbolicInverseRequest(PlacedRobotQuestion):
    """A robot whose inverse kinematics are wanted in closed form: no target."""

    form: Literal["symbolic"] = Field(description="the word symbolic: closed forms, and no target")
    parameters: SomeParameters = Field(default_factory=dict)
    formats: list[OneOf[EquationFormat]] = Field(
        default_factory=lambda: [EquationFormat.LATEX, EquationFormat.TEXT],
        min_length=1,
        max_length=LONGEST_LIST,
        description="how equations are written; latex and text if left out",
    )
    notation: OneOf[Notation] = Field(Notation.FULL, description="full: cos(q2 + q3); short: c23")


def _form(body: Any) -> str:
    form = body.get("form") if isinstance(body, dict) else getattr(body, "form", None)
    return CHOICE + ("symbolic" if form == "symbolic" else "numeric")


InverseQuestion = Annotated[
    Annotated[NumericInverseKinematicsRequest, Tag(CHOICE + "numeric")]
    | Annotated[SymbolicInverseRequest, Tag(CHOICE + "symbolic")],
    Discriminator(_form),
]


class WrittenValue(Wire):
    """A value in the formats that were asked for."""

    model_config = ConfigDict(populate_by_name=True)

    text: str | None = Field(None, description="as an infix expression")
    latex: str | None = Field(None, description="in LaTeX; of an equation the whole of it")
    json_: dict[str, Any] | None = Field(None, alias="json", description="as an expression tree")


class InverseConditionModel(WrittenValue):
    """What has to hold of a value."""

    kind: ConditionKind = Field(
        description="reachable: it is 0 or more, or the branch does not exist; determined: it is not 0, or "
        "the joint may be chosen (a singularity); fulfilled: it is 0, or no configuration reaches the target"
    )


class InverseDefinition(WrittenValue):
    """What is defined, and as what."""

    name: str = Field(description="what is defined")
    joint: int | None = Field(None, description="number of the joint whose variable it is")


class SingularCaseModel(Wire):
    """A case in which an equation does not determine its angle."""

    conditions: list[WrittenValue] = Field(description="what is 0 in this case")
    joint: int | None = Field(None, description="number of the joint that is at a singular value")
    at: WrittenValue | None = Field(None, description="this value")
    free: list[int] = Field(description="numbers of joints, one of which may be chosen")
    combination: WrittenValue | None = Field(
        None, description="the sum or difference of joint variables that is determined"
    )
    value: WrittenValue | None = Field(None, description="what the combination is, up to full turns")
    equations: list[InverseDefinition] = Field(
        description="with the first of `free` chosen, these replace the equations of the same names"
    )


class InverseEquation(InverseDefinition):
    """One equation: a joint variable, or an intermediate that later ones hold."""

    quantity: InverseQuantity | None = Field(None, description="what the intermediate is")
    meaning: WrittenValue | None = Field(
        None, description="the intermediate in the joint variables: a sum of angles, a cosine"
    )
    branch: str | None = Field(None, description="the sign that it introduces: another solution")
    conditions: list[InverseConditionModel] = Field(description="what has to hold")
    singular: list[SingularCaseModel] = Field(
        description="the cases in which a condition `determined` does not hold"
    )


class InverseTargetNames(Wire):
    """What the entries of the target are called in the equations.

    They are r11 … r33, p_x, p_y, p_z; with a base or a tool t11 … t33, t_x, t_y, t_z, as r11 … p_z are then
    the target seen from frame 0. A 0 is added to either where the robot has such a name.
    """

    reach: InverseReach = Field(description="pose; position: of the target only its position is used")
    rotation: list[list[str]] = Field(description="3×3")
    position: list[str] = Field(description="x, y, z")


class SymbolicInverseAnswer(Units):
    """Inverse kinematics in closed form, one joint after another.

    Angles stand in radians, and are right up to full turns.
    """

    variables: list[str] = Field(description="the joint variables as the table names them, in joint order")
    parameters: list[str] = Field(description="the parameters that are left")
    notation: str = Field(description="full or short")
    symbols: dict[str, str] | None = Field(None, description="what the short names stand for")
    target: InverseTargetNames
    branches: list[str] = Field(
        description="signs, each 1 or -1: every choice whose conditions hold is a solution, and every "
        "solution is one"
    )
    equations: list[InverseEquation] = Field(description="in the order in which they can be computed")
    conditions: list[InverseConditionModel] = Field(description="what the target has to fulfil")
    arguments: list[str] = Field(
        description="what functions take, in this order: the target's entries that are used, the signs, and "
        "the parameters"
    )
    code: dict[str, str] | None = Field(
        None, description="the source of a function that returns the joint variables, for each language"
    )
    misfit_code: dict[str, str] | None = Field(
        None,
        description="of an arm that cannot have every pose: the source of a function of the same arguments "
        "that returns the values of all conditions `fulfilled`; where one is farther from 0 than the target "
        "was rounded, the branch does not reach it",
    )
